"""What the tests of the plug-in for LIGGGHTS share: one run, its numbers. Standard library alone."""
import csv
import os
import pathlib
import shutil
import subprocess
import sys

PLATEN, PLUGIN, OUT = (pathlib.Path(p).resolve() for p in sys.argv[1:4])
PROGRAM = shutil.which("liggghts")
if PROGRAM is None or not PLUGIN.exists():
    print("skipped: LIGGGHTS is not installed, or the plug-in is not built (-DPLATEN_LIGGGHTS=ON)")
    sys.exit(77)
OUT.mkdir(parents=True, exist_ok=True)

START = """
units si
atom_style granular
atom_modify map array
newton off
communicate single vel yes
boundary f f f
region box block -5e-3 5e-3 -5e-3 5e-3 -5e-3 5e-3 units box
create_box {types} box
neighbor 1e-3 bin
neigh_modify delay 0
"""


def card(law, parameters, name=None):
    path = OUT / f"{name or law}.toml"
    path.write_text(f'platen = 1\nlaw = "{law}"\n\n[parameters]\n{parameters}\n')
    return path


def liggghts(name, text, ranks=1, check=True, files=None):
    """Runs an input in a folder of its own; the folder and what LIGGGHTS printed."""
    folder = OUT / name
    folder.mkdir(exist_ok=True)
    for file, content in (files or {}).items():
        (folder / file).write_text(content)
    (folder / "in.liggghts").write_text(text)
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1")
    command = ["env", f"LD_PRELOAD={PLUGIN}", PROGRAM, "-in", "in.liggghts", "-log", "log.liggghts"]
    if ranks > 1:
        command = ["mpirun", "-n", str(ranks), *command]
    done = subprocess.run(command, cwd=folder, env=environment, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=250)
    if check and done.returncode != 0:
        sys.exit(f"{name}: LIGGGHTS ended with {done.returncode}\n{done.stdout[-3000:]}")
    return folder, done.stdout


def dump_rows(path):
    """Rows of numbers of all frames of a text dump, frame by frame."""
    frames, rows = [], None
    for line in path.read_text().splitlines():
        if line.startswith("ITEM:"):
            rows = None
            if line.startswith("ITEM: ATOMS"):
                rows = []
                frames.append(rows)
        elif rows is not None:
            rows.append([float(word) for word in line.split()])
    return frames


def evaluated(folder, law, overlaps, *options):
    """Forces of `platen eval` along these overlaps."""
    path = folder / "path.csv"
    path.write_text("overlap_m\n" + "".join(f"{x!r}\n" for x in overlaps))
    command = [PLATEN, "eval", law, *options, "--path", path]
    answer = subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout
    return [float(row["force_N"]) for row in csv.DictReader(answer.splitlines())]
