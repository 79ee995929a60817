"""Adapters that are compiled against a stub of a code that cannot be had here: forces of `platen eval` to 1e-9,
and of Hertz's contact the restitution that was asked for to 1e-3, without a force that pulls.

adapters.py PLATEN COMPILER FOLDER edem|mercurydpm
"""
import csv
import pathlib
import subprocess
import sys

platen, compiler, out, code = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), sys.argv[4]
here = pathlib.Path(__file__).resolve().parent
root = here.parents[2]
card = root / "examples/lammps/mcc-ph-200.toml"
out.mkdir(parents=True, exist_ok=True)


def compiled(law, program):
    subprocess.run([platen, "export", "dem-engine", law, "-o", out], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([compiler, "-std=c++17", "-O2", "-Wall", "-Wextra", "-Wno-unused-parameter", "-I", out, "-I", here / code / "stub",
                    "-I", root / "plugins" / code, here / code / "host.cpp", "-o", out / program], check=True)


(out / "hertz.toml").write_text('platen = 1\nlaw = "hertz"\n[parameters]\nE_Pa = 1e8\nnu = 0.3\n')
compiled(out / "hertz.toml", "bounce")
e = float(subprocess.run([out / "bounce", "bounce"], check=True, text=True, stdout=subprocess.PIPE).stdout)
print(f"{code}: restitution {e:.5f}")
if not abs(e - 0.5) < 0.5e-3:
    sys.exit(f"{code}: the restitution is not 0.5")

compiled(card, code)
R = 1e-3
ends = [0, 0.05 * R, 0.04 * R, 0.08 * R, -0.01 * R]
overlaps = [a + (b - a) * i / 50 for a, b in zip(ends, ends[1:]) for i in range(1, 51)]
(out / "path.csv").write_text("overlap_m\n" + "".join(f"{x!r}\n" for x in overlaps))
for name, R2, options in (("two spheres", R, []), ("a sphere on a wall", 1e300, ["--against", "plane"])):
    given = "".join(f"{R!r} {R2!r} {x!r}\n" for x in overlaps)
    answer = subprocess.run([out / code], input=given, check=True, text=True, stdout=subprocess.PIPE).stdout
    forces = [float(line) for line in answer.splitlines()]
    done = subprocess.run([platen, "eval", card, "-p", f"radius_m={R!r}", *options, "--path", out / "path.csv"], check=True, text=True,
                          stdout=subprocess.PIPE)
    theirs = [float(row["force_N"]) for row in csv.DictReader(done.stdout.splitlines())]
    worst = max(abs(a - b) for a, b in zip(forces, theirs)) / max(theirs)
    print(f"{code}, {name}: largest force {max(theirs):.4g} N, worst difference {worst:.1e} of it")
    if len(forces) != len(theirs) or not worst < 1e-9:
        sys.exit(f"{code}, {name}: the forces are not those of platen eval")
