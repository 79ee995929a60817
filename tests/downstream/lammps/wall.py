"""A plane pressed at a velocity into one sphere and back: the same numbers as `platen eval --against plane`. A Hertzian
sphere bounces with the restitution that damping asks for."""
import csv
import math
import subprocess

from lammps import OUT, PLATEN, card, lammps, near, start

BOX = start("-5e-3 5e-3 " * 3)
ONE = """
create_atoms 1 single 0 0 0
set group all diameter 2e-3
set group all density 1500
"""
CARD, HERTZ = card("edmans-sinka"), card("hertz")
folder, _ = lammps("press", BOX + ONE + f"""
pair_style platen
pair_coeff 1 1 {CARD}
timestep 1e-4
variable v equal -0.05*cos(2*PI*step/200)
fix wall all wall/platen {CARD} plane z hi 1.001e-3 velocity v_v
fix out all print 1 "$(f_wall[4]:%.17g) $(f_wall[3]:%.17g)" file wall.txt screen no
run 110
""")
rows = [[float(w) for w in line.split()] for line in (folder / "wall.txt").read_text().splitlines()[1:]]
rows = [(1e-3 - z, F) for z, F in rows if z < 1e-3]
assert len(rows) > 80 and any(b[0] < a[0] for a, b in zip(rows, rows[1:])), "the wall did not press and return"
path = OUT / "path.csv"
path.write_text("overlap_m\n" + "".join(f"{o!r}\n" for o, _ in rows))
text = subprocess.run([PLATEN, "eval", CARD, "-p", "radius_m=1e-3", "--against", "plane", "--path", path], check=True,
                      text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
for (overlap, F), other in zip(rows, csv.DictReader(text.splitlines())):
    near(f"force at {overlap}", F, float(other["force_N"]), 1e-10, 1e-10)

for e in (0.9, 0.5):
    folder, _ = lammps(f"bounce-{e}", BOX + ONE + f"""
pair_style platen
pair_coeff 1 1 {HERTZ}
velocity all set 0 0 -1
timestep 2e-8
fix move all nve/sphere
fix wall all wall/platen {HERTZ} plane z lo -1.00001e-3 damping {e}
fix out all print 5000 "$(vcm(all,z):%.17g)" file v.txt screen no
run 10000
""")
    near(f"restitution {e}", float((folder / "v.txt").read_text().split()[-1]), e, 1e-3)
