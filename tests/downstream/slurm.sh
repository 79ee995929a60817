#!/bin/bash
# slurm.sh PROGRAM: a study submitted to a Slurm of one node that this script starts on the loopback device, as root and
# without systemd, from Debian's packages (group "cluster" of packages.txt). Where it cannot be started the test is
# skipped with a message, but the batch script is looked at all the same.
set -u
platen=$(realpath "$1")
export OPENBLAS_NUM_THREADS=1
folder=$(mktemp -d)
failures=0
fails() { failures=$((failures + 1)); echo "FAILED: $*"; }

stop() {
  local name file process
  for name in slurmd slurmctld munged; do
    file=$folder/run/$name.pid
    [ -s "$file" ] && process=$(cat "$file") && kill -TERM "$process" 2>/dev/null || continue
    waits 100 gone "$process" || kill -KILL "$process"
  done
}
trap 'stop; rm -rf "$folder"' EXIT
gone() { ! kill -0 "$1" 2>/dev/null; }
waits() { # TENTHS COMMAND...: until it succeeds
  local tenths=$1 i
  shift
  for ((i = 0; i < tenths; i++)); do "$@" >/dev/null 2>&1 && return; sleep 0.1; done
  return 1
}
free_port() { # FROM
  local port=$1
  while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
  echo "$port"
}
skip() { echo "slurm: skipped, $*"; [ $failures -eq 0 ] && exit 77; exit 1; }

cd "$folder" || exit 1
mkdir "the study" # the quotes of the batch script must hold
cat >"the study/study.toml" <<'T'
platen = 1
name = "on a cluster"
[case]
platen = 1
experiment = "simple"
material = "base-case"
radius_m = 1e-3
[case.path]
delta_bar_max = 0.01
[case.mesh]
elements = 64
[design]
kind = "factorial"
[factors]
"material.E_bar" = { values = [50, 100, 150, 200, 250, 300] }
[fit]
laws = ["edmans-sinka"]
T
study="the study/study.toml"
"$platen" study submit "$study" --store store --tasks 3 --slurm=--time=5 --dry-run >script || fails "--dry-run"
for line in '#SBATCH --array=1-3' '#SBATCH --time=5' "study run '$folder/$study' --store '$folder/store' --workers 1"; do
  grep -qF -- "$line" script || fails "the batch script has no line $line: $(cat script)"
done
[ -e store ] && fails "--dry-run wrote something"
"$platen" study submit "$study" --store "half%A" --dry-run | grep -qF "half%%A/slurm-%A_%a.log" || fails "a % in the path is a pattern"
bash -n script || fails "the batch script is none"

for program in munged munge slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || skip "there is no $program here"
done
[ "$(id -u)" -eq 0 ] || skip "only root can start a Slurm of its own"
PATH=$PATH:/usr/sbin
mkdir -p state spool log run munge
chmod 755 . munge
chmod 700 state
(umask 077; dd if=/dev/urandom of=munge/key bs=128 count=1 status=none)
host=$(hostname -s)
control=$(free_port 26817)
cat >slurm.conf <<X
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$control
SlurmdPort=$(free_port $((control + 1)))
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
SlurmdParameters=config_overrides
KillWait=2
NodeName=one NodeHostname=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=one Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
X
# slurmd looks for a cgroup mount, though nothing here uses one; named v1 it does not look
printf 'CgroupPlugin=cgroup/v1\nCgroupAutomount=no\nConstrainCores=no\nConstrainRAMSpace=no\n' >cgroup.conf
export SLURM_CONF=$folder/slurm.conf
munged --force --num-threads=2 --key-file=munge/key --socket="$folder/munge/socket" --pid-file="$folder/run/munged.pid" \
  --log-file="$folder/log/munged.log" --seed-file="$folder/munge/seed" || skip "munged does not start"
waits 50 munge -n -S "$folder/munge/socket" || skip "munged does not answer"
slurmctld -i -f "$SLURM_CONF" 2>/dev/null || skip "slurmctld does not start: $(tail -3 log/slurmctld.log)"
waits 100 scontrol ping || skip "slurmctld does not answer: $(tail -3 log/slurmctld.log)"
slurmd -N one -f "$SLURM_CONF" || skip "slurmd does not start: $(tail -3 log/slurmd.log)"
is_idle() { [ "$(sinfo -h -o %T)" = idle ]; }
waits 150 is_idle || skip "the node does not come up: $(tail -3 log/slurmd.log)"

no_job() { [ -z "$(squeue -h)" ]; }
"$platen" study submit "$study" --store store --tasks 3 --slurm=--time=5 >answer 2>&1 && grep -q 'Submitted batch job' answer ||
  fails "submit: $(cat answer)"
waits 1200 no_job || fails "the job does not end: $(squeue) $(cat store/slurm-*.log)"
"$platen" study status "$study" --store store | grep -q '^6 runs: 6 done' || fails "not all runs are done: $(cat store/slurm-*.log)"
[ "$(ls store/slurm-*.log | wc -l)" = 3 ] || fails "there were not three tasks: $(ls store)"
"$platen" study export "$study" --store store -o cluster.csv
"$platen" study run "$study" --store alone --workers 2 >/dev/null 2>&1
"$platen" study export "$study" --store alone -o alone.csv
cmp <(sed 's/,[^,]*,[^,]*$//' alone.csv) <(sed 's/,[^,]*,[^,]*$//' cluster.csv) || fails "the cluster gives something else"
"$platen" study submit "$study" --store store | grep -q 'nothing is left' || fails "a finished study was submitted"

# --- a task that Slurm kills is taken over by a later array ---
rm -r store/runs/*
sed -i 's/elements = 64/elements = 1000/' "$study"
"$platen" study submit "$study" --store store --tasks 2 >answer 2>&1
working() { [ -n "$(ls store/claims)" ]; }
waits 300 working || fails "no task began"
scancel "$(grep -o '[0-9]*$' answer)"
waits 300 no_job || fails "the job cannot be cancelled"
sed -i 's/elements = 1000/elements = 64/' "$study"
"$platen" study submit "$study" --store store --tasks 2 >/dev/null
waits 1200 no_job || fails "the second job does not end"
"$platen" study status "$study" --store store | grep -q '^6 runs: 6 done' || fails "a cancelled job cannot be gone on with"
[ $failures -eq 0 ] && echo "slurm: all well"
exit $((failures > 0))
