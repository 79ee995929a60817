"""The force model that `platen export dem-engine` writes, compiled for a processor: forces of `platen eval` to 1e-9, and of
Hertz's contact the restitution that was asked for to 1e-3, without a force that pulls.

text.py PLATEN COMPILER FOLDER
"""
import csv
import pathlib
import re
import subprocess
import sys

platen, compiler, out = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
here = pathlib.Path(__file__).resolve().parent
out.mkdir(parents=True, exist_ok=True)
cards = {
    "pressed": here.parents[2] / "examples/lammps/mcc-ph-200.toml",
    "hertz": "E_Pa = 1e8\nnu = 0.3",
    "mdr": "E_Pa = 5e8\nnu = 0.3\nsigma_y_Pa = 1e7",
    "eepa": "E_Pa = 5e8\nnu = 0.3\nlambda_p = 0.6",
    "thornton-ning": "E_Pa = 5e8\nnu = 0.3\np_y_Pa = 3e6",
    "luding": "k_1_N_per_m = 1e4\nk_2_N_per_m = 5e4\nphi_f = 0.1",
}
R = 1e-3


def way(top):
    """In, half out, in farther, out and apart."""
    ends = [0, top, 0.8 * top, 1.3 * top, -0.1 * top]
    return [a + (b - a) * i / 50 for a, b in zip(ends, ends[1:]) for i in range(1, 51)]


def evaluated(card, overlaps, *options):
    (out / "path.csv").write_text("overlap_m\n" + "".join(f"{x!r}\n" for x in overlaps))
    done = subprocess.run([platen, "eval", card, *options, "--path", out / "path.csv"], check=True, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL)
    return [float(row["force_N"]) for row in csv.DictReader(done.stdout.splitlines())]


def compiled(card, folder, *options):
    subprocess.run([platen, "export", "dem-engine", card, *options, "-o", folder], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([compiler, "-std=c++17", "-O2", "-Wall", "-I", folder, here / "host.cpp", "-o", folder / "host"], check=True)


for law, card in cards.items():
    if isinstance(card, str):
        text, card = card, out / f"{law}.toml"
        card.write_text(f'platen = 1\nlaw = "{law}"\n[parameters]\n{text}\n')
    folder = out / law
    compiled(card, folder)
    promised = float(re.search(r"force within ([0-9.e-]+) %", (folder / "functions.cu").read_text()).group(1)) / 100
    for name, R2, options, within in (
        ("equal", R, ["-p", f"radius_m={R!r}"], 1e-9),
        ("plane", 1e15, ["-p", f"radius_m={R!r}", "--against", "plane"], 1e-9),
        ("unlike", 0.6 * R, ["-p", f"radius_m={R!r}", "-p", f"radius2_m={0.6 * R!r}"], 1.5 * promised + 1e-9),
    ):
        overlaps = way(0.05 * R)
        given = "".join(f"{R!r} {R2!r} {x!r}\n" for x in overlaps)
        answer = subprocess.run([folder / "host"], input=given, check=True, text=True, stdout=subprocess.PIPE).stdout
        rows = [[float(word) for word in line.split()] for line in answer.splitlines()]
        theirs = evaluated(card, overlaps, *options)
        scale = max(theirs)
        exact = max(abs(row[0] - F) for row, F in zip(rows, theirs)) / scale
        as_engine = max(abs(row[1] - F) for row, F in zip(rows, theirs)) / scale
        print(f"{law}, {name}: largest force {scale:.4g} N, in double within {exact:.1e} of it, as the engine adds it {as_engine:.1e}")
        if len(rows) != len(overlaps) or not (exact < within and as_engine < within + 1e-6):
            sys.exit(f"{law}, {name}: the forces are not those of platen eval")

compiled(out / "hertz.toml", out / "damped", "--restitution", "0.5")
e = float(subprocess.run([out / "damped/host", "bounce"], check=True, text=True, stdout=subprocess.PIPE).stdout)
print(f"restitution {e:.5f}")
if not abs(e - 0.5) < 0.5e-3:
    sys.exit("the restitution is not 0.5")
