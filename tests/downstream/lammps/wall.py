"""A plane pressed at a velocity into one sphere and back: the same numbers as `platen eval --against plane`. A Hertzian
sphere bounces with the restitution that damping asks for. A plane under a force comes to rest where Hertz's force is that
force. A cylinder presses as a plane does."""
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

E, nu, R, F = 1e8, 0.3, 1e-3, 0.5  # of HERTZ
folder, _ = lammps("force", BOX + ONE + f"""
pair_style platen
pair_coeff 1 1 {HERTZ}
timestep 2e-7
fix hold all setforce 0 0 0
fix wall all wall/platen {HERTZ} plane z hi 1e-3 force -{F} mass 1e-5 damping 0.3
fix out all print 20000 "$(f_wall[3]:%.17g) $(f_wall[4]:%.17g)" file rest.txt screen no
run 20000
""")
force, z = (float(w) for w in (folder / "rest.txt").read_text().split("\n")[-2].split())
near("force on the plane", force, F, 1e-6)
delta = (0.75 * F * (1 - nu**2) / E / math.sqrt(R)) ** (2 / 3)
near("overlap under it", R - z, delta, 1e-6)

folder, _ = lammps("cylinder", BOX + f"""
create_atoms 1 single 3e-3 0 0
create_atoms 1 single 0 -2.99e-3 2e-3
set group all diameter 2e-3
set group all density 1500
pair_style platen
pair_coeff 1 1 {HERTZ}
fix wall all wall/platen {HERTZ} cylinder z 3.98e-3
fix out all print 1 "$(f_wall[1]:%.17g) $(f_wall[2]:%.17g) $(f_wall[3]:%.17g)" file cylinder.txt screen no
run 0
""")
force = [float(w) for w in (folder / "cylinder.txt").read_text().split("\n")[-2].split()]
for k, delta, sign in ((0, 2e-5, 1), (1, 1e-5, -1)):
    near(f"force on the cylinder {k}", force[k], sign * 4 / 3 * E / (1 - nu**2) * math.sqrt(R) * delta**1.5, 1e-4)
