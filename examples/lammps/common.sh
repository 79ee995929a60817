# What the examples share: `lammps INPUT ...` runs LAMMPS in $out, `picture NAME COMMANDS` draws with gnuplot.
plugin=$(dirname "$platen")/../lammps/platen.lmp
command -v lmp >/dev/null && [ -f "$plugin" ] || { echo "skipped: LAMMPS or the plug-in is missing (./run lammps)"; exit 77; }
mkdir -p "$out"
cd "$out"

lammps() { # INPUT [-var NAME VALUE]...
  OMP_NUM_THREADS=1 lmp -in "$here/$1" -log log.lammps -var plugin "$plugin" "${@:2}" >screen.txt 2>&1 ||
    { tail -5 screen.txt >&2; return 1; }
  grep '^WARNING.*validity' screen.txt | sed 's/ (.*//' || true
}

picture() { # NAME COMMANDS [SIZE]
  gnuplot <<TEXT
set terminal svg size ${3:-800,500} font 'sans,14' background rgb 'white'
set output '$1.svg'
set grid lc rgb '#dddddd'
$2
TEXT
}
