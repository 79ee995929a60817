#!/bin/bash
# nfs.sh PROGRAM WORKER NFS_MOUNT MISFORTUNE: a study whose store lies on NFS: a server in user space and two clients on
# loopback, which believe names and attributes for a second. It is killed a hundred times at random moments on either client, then
# finished by both at once, of which one has a clock an hour ahead: the same tables as on a local disk, and no run twice.
set -u
. "$(dirname "$0")/study.sh"
platen=$(realpath "$1") worker=$(realpath "$2") mount=$(realpath "$3") misfortune=$(realpath "$4")
{ [ "$(id -u)" = 0 ] && [ -c /dev/fuse ] && command -v ganesha.nfsd && command -v rpcbind && command -v fusermount3; } >/dev/null ||
  { echo "skipped: an NFS server on loopback needs root, /dev/fuse, fuse3 and nfs-ganesha-vfs"; exit 77; }
folder=$(mktemp -d)
server='' failures=0 pids=()
fails() { failures=$((failures + 1)); echo "FAILED: $*"; }
leave() {
  cd /
  for client in one two; do fusermount3 -uz "$folder/$client" 2>/dev/null; done
  [ -z "$server" ] || kill "$server" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$folder"
}
trap leave EXIT
cd "$folder" || exit 1
mkdir export one two
port=$((20000 + RANDOM % 10000))
cat >server.conf <<T
NFS_CORE_PARAM { NFS_Protocols = 3; NFS_Port = $port; MNT_Port = $((port + 1)); Bind_addr = 127.0.0.1; Enable_NLM = false;
  Enable_RQUOTA = false; }
EXPORT { Export_Id = 1; Path = $folder/export; Pseudo = /store; Access_Type = RW; Squash = No_Root_Squash; Protocols = 3;
  Transports = TCP; SecType = sys; FSAL { Name = VFS; } }
T
pgrep -x rpcbind >/dev/null || rpcbind # the server tells it of itself
ganesha.nfsd -F -f server.conf -L server.log -p server.pid >/dev/null 2>&1 &
server=$!
for client in one two; do
  for _ in $(seq 100); do
    "$mount" "nfs://127.0.0.1$folder/export?version=3&nfsport=$port&mountport=$((port + 1))" $client >$client.log 2>&1 &
    sleep 0.3
    mountpoint -q $client && break
  done
  mountpoint -q $client || { echo "FAILED: no NFS: $(cat $client.log server.log)"; exit 1; }
done

study 10 6 1 >study.toml
exported() { "$platen" study export study.toml --store "$1" -o "$2.csv" --curves "$2-curves.csv" || fails "export of $1"; }
"$worker" study.toml whole 2 0 whole.log || exit 1
exported whole whole

kills=0 removed=0
for i in $(seq 100); do
  client=$([ $((i % 2)) = 0 ] && echo one || echo two)
  if [ "$(ls export/store/runs 2>/dev/null | wc -l)" -gt 40 ]; then # there must be work left at the next kill
    mapfile -t some < <(ls one/store/runs | shuf -n 40)
    rm -rf "${some[@]/#/one/store/runs/}"
    removed=$((removed + 40))
  fi
  setsid "$worker" study.toml $client/store 4 20 killed.log 20 2000 >/dev/null 2>&1 &
  victim=$!
  disown
  sleep "0.$(printf '%03d' $((100 + RANDOM % 800)))"
  kill -KILL -- "-$victim" 2>/dev/null && [ "$(ls export/store/runs 2>/dev/null | wc -l)" -lt 60 ] && kills=$((kills + 1))
  while kill -0 "$victim" 2>/dev/null; do sleep 0.001; done
done
[ $kills -gt 60 ] || fails "only $kills of 100 kills came before the end"
sleep 1.5
: >last.log
before=$(ls export/store/runs | wc -l)
"$worker" study.toml one/store 2 20 last.log 20 3000 &
pids=($!)
LD_PRELOAD=$misfortune MISFORTUNE_CLOCK=3600 "$worker" study.toml two/store 2 20 last.log 20 3000 &
pids[1]=$!
for pid in "${pids[@]}"; do wait "$pid" || fails "a killed study does not resume"; done
sleep 1.5
exported one/store killed
cmp <(untimed whole.csv) <(untimed killed.csv) && cmp whole-curves.csv killed-curves.csv || fails "the tables differ from undisturbed"
[ "$(ls export/store/runs | wc -l)" = 60 ] || fails "not 60 runs"
[ -z "$(ls export/store/claims)" ] || fails "claims were left behind: $(ls export/store/claims)"
[ -z "$(cut -d' ' -f1 last.log | sort | uniq -d)" ] || fails "pressed twice: $(cut -d' ' -f1 last.log | sort | uniq -d | wc -l) of $(wc -l <last.log)"
[ "$(wc -l <last.log)" -ge $((60 - before)) ] || fails "fewer presses than runs that were missing"
echo "store on NFS: $kills kills, $removed runs removed, $before of 60 there, $(wc -l <last.log) pressed at last, $failures failures"
exit $((failures > 0))
