"""The adapter for MFiX-DEM, compiled against a stub: forces of `platen eval` to 1e-9, its damping, and what it refuses.

mfix.py PLATEN LIBRARY FOLDER. Exit code 77: there is no Fortran compiler.
"""
import csv
import math
import pathlib
import shutil
import subprocess
import sys

platen, library, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
here = pathlib.Path(__file__).resolve().parent
root = here.parents[2]
compiler = next(filter(None, map(shutil.which, ("gfortran", "gfortran-12", "gfortran-13", "gfortran-14"))), None)
if not compiler:
    print("there is no gfortran: skipped")
    sys.exit(77)
out.mkdir(parents=True, exist_ok=True)
sources = [root / "include/platen_law.f90", here / "mfix/stub.f90", root / "plugins/mfix/platen_mfix.f90", here / "mfix/host.f90"]
subprocess.run([compiler, "-std=f2008", "-O1", "-g", "-fcheck=all", "-Wall", "-Wextra", "-Wno-compare-reals", "-Werror", "-J", out, *sources,
                library, "-lstdc++", "-lm", "-o", out / "host"], check=True)
card = root / "examples/lammps/mcc-ph-200.toml"
shutil.copy(card, out / "granule.toml")
(out / "metal.toml").write_text("""# by hand
platen = 1
law = 'agarwal'   # quoted the other way

[parameters]
E_Pa = 2.1e11
nu = 0.3 # steel
sigma_y_Pa = 3e8

[provenance]
material = "steel"
""")
lines = """
# phases     card            parameters

1 1          granule.toml
  1 2        'granule.toml'
3 1          granule.toml    'E2_Pa=2.1e11 nu2=0.3'   # card and radius_m: of phase 3
4 4          metal.toml
4 2          metal.toml      "sigma_y2_Pa=1e8 E2_Pa=7e10"
1 wall       granule.toml
2 wall       granule.toml    'radius2_m=inf E2_Pa=2.1e11 nu2=0.3'
"""
R = 1e-3


def steps(*ends):
    return [a + (b - a) * i / 50 for a, b in zip(ends, ends[1:]) for i in range(1, 51)]


def host(start, given, *arguments):
    """One run: output and what it said when it stopped."""
    text = start + "\n" + "".join(f"{x!r} {turn}\n" for x, turn in given)
    done = subprocess.run([out.resolve() / "host", *arguments], cwd=out, input=text, text=True, capture_output=True)
    return [tuple(map(float, line.split())) for line in done.stdout.splitlines()], done.stderr, done.returncode


def theirs(path, parameters):
    (out / "path.csv").write_text("overlap_m\n" + "".join(f"{x!r}\n" for x in path))
    done = subprocess.run([platen, "eval", *parameters, "--path", out / "path.csv"], check=True, text=True, stdout=subprocess.PIPE)
    return [(float(row["force_N"]), float(row["stiffness_N_per_m"])) for row in csv.DictReader(done.stdout.splitlines())]


def keys(*given):
    return [word for key in given for word in ("-p", key)]


def compare(name, start, radius, parameters):
    """Pressed, released, pressed farther and parted; then anew, when nothing is remembered."""
    (out / "platen.dat").write_text(lines)
    path = steps(0, 0.05 * radius, 0.04 * radius, 0.08 * radius, -0.01 * radius)
    again = steps(0, 0.06 * radius, 0.05 * radius)
    given = [(x, 1 if i % 7 == 3 else 0) for i, x in enumerate(path + again)]
    ours = []
    for half, files in ((given[:137], ("", "memory")), (given[137:], ("memory", "last"))):  # 137: while it is pressed again
        answer, said, code = host(start, half, *files)
        if code != 0:
            sys.exit(f"{name}: stopped: {said}")
        ours += answer
    law = theirs(path, parameters) + theirs(again, parameters)
    largest, stiffest = (max(column) for column in zip(*law))
    worst = max(abs(force - F) for (force, _), (F, _) in zip(ours, law)) / largest
    damping = [math.sqrt(5 / 6 * k / 1e5) if F > 0 else 0 for F, k in law]
    off = max(abs(c - d) for (_, c), d in zip(ours, damping)) / math.sqrt(stiffest / 1e5)
    kept = theirs(path + again, parameters)  # had it not forgotten
    differ = max(abs(F - G) for (F, _), (G, _) in zip(law, kept)) / largest
    print(f"{name}: largest force {largest:.4g} N, worst difference {worst:.1e} of it, of damping {off:.1e}")
    if len(ours) != len(law) or not worst < 1e-9 or not off < 1e-9 or not differ > 0.01:
        sys.exit(f"{name}: forces or damping are not those of platen eval")


r = 0.4 * R
steel = ("E2_Pa=2.1e11", "nu2=0.3")
metal = ["agarwal", *keys("E_Pa=2.1e11", "nu=0.3", "sigma_y_Pa=3e8")]
compare("two spheres", f"1 {R} 1 {R}", R, [card, *keys(f"radius_m={R}")])
compare("unlike radii", f"1 {R} 2 {r}", r, [card, *keys(f"radius_m={R}", f"radius2_m={r}")])
compare("two materials", f"1 {R} 3 {r}", r, [card, *keys(f"radius_m={r}", f"radius2_m={R}", *steel)])
compare("the same, the other first", f"3 {r} 1 {R}", r, [card, *keys(f"radius_m={r}", f"radius2_m={R}", *steel)])
compare("a metal", f"4 {R} 4 {R}", R, [*metal, *keys(f"radius_m={R}")])
compare("two metals", f"2 {r} 4 {R}", r, [*metal, *keys(f"radius_m={R}", f"radius2_m={r}", "sigma_y2_Pa=1e8", "E2_Pa=7e10")])
compare("a rigid wall", f"1 {R} 0 0", R, [card, "--against", "plane", *keys(f"radius_m={R}")])
compare("a wall that gives", f"2 {r} 0 0", r, [card, *keys(f"radius_m={r}", "radius2_m=inf", *steel)])


def refused(what, sentence, dat, start=f"1 {R} 1 {R}", arguments=()):
    (out / "platen.dat").unlink(missing_ok=True)
    if dat is not None:
        (out / "platen.dat").write_text(dat)
    _, said, code = host(start, [(1e-5, 0)], *arguments)
    if code == 0 or sentence not in said.splitlines():
        sys.exit(f"{what}: ended with {code} and said\n{said}instead of\n{sentence}")


(out / "soft.toml").write_text('law = "edmans-sinka"\n[parameters]\nsigma_ref_Pa = 8.61e6\nnu = 0.1472\nk = 4.2\ndelta_t = 0.09\na = 3.5\n')
(out / "case.toml").write_text('experiment = "sphere"\n')
(out / "nameless.toml").write_text("[parameters]\nE_Pa = 1e9\n")
(out / "open.toml").write_text('law = "edmans-sinka"\n[parameters]\nalpha = [1,\n 2]\n')
(out / "cut").write_bytes((out / "last").read_bytes()[:-1])
(out / "other").write_bytes(b"\x07" + (out / "last").read_bytes()[1:])
refused("no input", "platen: platen.dat is not there", None)
refused("no card", "platen: cannot read the law card gone.toml", "1 1 gone.toml\n")
refused("a parameter is missing", "platen: soft.toml: edmans-sinka: E_Pa is missing (Young's modulus)", "1 1 soft.toml\n")
refused("a wrong value", "platen: granule.toml: edmans-sinka: nu = 0.5 is not in [0, 0.5)", "1 1 granule.toml nu2=0.5\n")
refused("a parameter is given twice", "platen: granule.toml: 'nu' is given twice", "1 1 granule.toml nu=0.2\n")
refused("not a law card", "platen: case.toml: 'experiment = \"sphere\"' is not of a law card", "1 1 case.toml\n")
refused("no law", "platen: nameless.toml: law is missing", "1 1 nameless.toml\n")
refused("a list over two lines", "platen: open.toml: the list alpha must end on its line", "1 1 open.toml\n")
form = "is not: phase, phase or wall, card, parameters"
for line in ("11 1 granule.toml", "1 0 granule.toml", "1 -1 granule.toml", "x 1 granule.toml", "1 walls granule.toml", "1 1", "1"):
    refused("an unknown phase", f"platen: platen.dat: '{line}' {form}", line + "\n")
refused("a phase without a line", "platen: platen.dat has no line for phase 5", lines, f"5 {R} 5 {R}")
refused("a pair without a line", "platen: platen.dat has no line for phases (0: walls) 1 4", lines, f"1 {R} 4 {R}")
refused("a wall without a line", "platen: platen.dat has no line for phases (0: walls) 4 0", lines, f"4 {R} 0 0")
refused("two lines", "platen: platen.dat has two lines for phases (0: walls) 2 1", lines + "2 1 granule.toml\n")
refused("two radii", "platen: particles of more than one radius are of phase 1", lines, f"1 {R} 1 {r}")
refused("two processes", "platen: one process, UNITS SI and DES_COLL_MODEL LSD are needed", lines, arguments=("", "", "2"))
for file, sentence in (("gone", "no memory of contacts of this version is in gone"), ("other", "no memory of contacts of this version is in other"),
                       ("cut", "the memory of contacts is cut off in cut")):
    refused("a restart", "platen: " + sentence, lines, arguments=(file,))
