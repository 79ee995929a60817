"""What the tests of the plug-in share: cards, one run of LAMMPS, its numbers. Standard library alone."""
import json
import os
import pathlib
import shutil
import subprocess
import sys

PLATEN, PLUGIN, OUT = (pathlib.Path(p).resolve() for p in sys.argv[1:4])
LMP = shutil.which(os.environ.get("PLATEN_LMP", "lmp"))  # another LAMMPS, with the plug-in built for it
if LMP is None or not (PLUGIN / "platen.so").exists():
    print("skipped: LAMMPS is not installed, or the plug-in is not built (./run lammps)")
    sys.exit(77)
OUT.mkdir(parents=True, exist_ok=True)

CARDS = {
    "edmans-sinka": "sigma_ref_Pa = 1e6\nE_Pa = 1e8\nnu = 0.3\nk = 6.4\ndelta_t = 0.12\na = 2.4",
    "agarwal": "E_Pa = 5e8\nnu = 0.3\nsigma_y_Pa = 1e6",
    "hertz": "E_Pa = 1e8\nnu = 0.3",
    "mdr": "E_Pa = 5e8\nnu = 0.3\nsigma_y_Pa = 1e7",
    "luding": "k_1_N_per_m = 1e4\nk_2_N_per_m = 5e4\nphi_f = 0.1",
    "thornton-ning": "E_Pa = 5e8\nnu = 0.3\np_y_Pa = 3e6",
    "similarity": "E_Pa = 5e8\nnu = 0.3\nkappa_Pa = 1e6\ninverse_m = 0.3",
    "wang": "E_Pa = 1e10\nnu = 0.15\nphi_deg = 25\nsigma_c_Pa = 15e6",
    "shahin": "E_Pa = 5e8\nnu = 0.3\nkappa_Pa = 1e6\ninverse_m = 0.3",
    "kogut-etsion": "E_Pa = 5e8\nnu = 0.3\nsigma_y_Pa = 1e7",
    "etsion-unloading": "E_Pa = 5e8\nnu = 0.3\nsigma_y_Pa = 1e7",
    "jackson-green": "E_Pa = 5e8\nnu = 0.3\nsigma_y_Pa = 1e6",
    "eepa": "E_Pa = 5e8\nnu = 0.3\nlambda_p = 0.6",
    "pressed": "E_Pa = 2e9\nnu = 0.3\nsigma_ref_Pa = 1e7\n"
               "delta_bar = [1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.2, 0.35, 0.5]\n"
               "F_bar = [6e-5, 1.6e-3, 0.035, 0.22, 0.48, 1.1, 2.2, 4]\n"
               "a_bar = [0.009, 0.03, 0.13, 0.32, 0.46, 0.66, 0.85, 1]",
}
listed = json.loads(subprocess.run([PLATEN, "laws", "--json"], check=True, stdout=subprocess.PIPE).stdout)
assert {law["name"] for law in listed} == set(CARDS), "a law has no card here"


def card(law, name=None, parameters=None, extra=""):
    path = OUT / f"{name or law}.toml"
    path.write_text(f'platen = 1\nlaw = "{law}"\n\n[parameters]\n{parameters or CARDS[law]}\n{extra}')
    return path


def lammps(name, text, ranks=1, check=True, files=None, timeout=250):
    """Runs an input in its own folder; the folder and what LAMMPS printed."""
    folder = OUT / name
    folder.mkdir(exist_ok=True)
    for file, content in (files or {}).items():
        (folder / file).write_text(content)
    (folder / "in.lmp").write_text(f"include {PLUGIN}/platen.lmp\n{text}")
    command = [LMP, "-in", "in.lmp", "-log", "log.lammps"]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1")
    if ranks > 1:
        command = [os.environ.get("PLATEN_MPIRUN", "mpirun"), "-n", str(ranks), *command]
    done = subprocess.run(command, cwd=folder, env=environment, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=timeout)
    if check and done.returncode != 0:
        sys.exit(f"{name}: LAMMPS ended with {done.returncode}\n{done.stdout[-3000:]}")
    return folder, done.stdout


def dump_rows(path):
    """Rows of numbers of all frames of a text dump, frame by frame."""
    frames, rows = [], None
    for line in path.read_text().splitlines():
        if line.startswith("ITEM:"):
            rows = None
            if line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES")):
                rows = []
                frames.append(rows)
        elif rows is not None:
            rows.append([float(word) for word in line.split()])
    return frames


def near(what, value, reference, relative, absolute=0.0):
    error = abs(value - reference)
    if not error <= relative * abs(reference) + absolute:
        sys.exit(f"{what}: {value!r} is not {reference!r} (relative {relative}, absolute {absolute})")
    return error / abs(reference) if reference else 0.0


SPHERES = """
units {units}
atom_style sphere
newton off
comm_modify vel yes
region box block {box}
boundary {boundary}
create_box {types} box
"""


def start(box="-1 1 -1 1 -1 1", boundary="f f f", types=1, units="si"):
    return SPHERES.format(box=box, boundary=boundary, types=types, units=units)
