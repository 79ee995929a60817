"""A loose heap between a fixed and a moving wall that collides with friction and damping: the same from a restart and on
two ranks. Torques and forces keep the angular momentum."""
import math

from lammps import card, dump_rows, lammps, near, start

CARD = card("edmans-sinka")
BOX = start("-5.94e-3 5.94e-3 -5.94e-3 5.94e-3 -8e-3 8e-3", "p p f")
FORCES = f"""
pair_style platen
pair_coeff * * {CARD} damping 0.8 friction 0.3
timestep 1e-6
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
fix move all nve/sphere
fix bottom all wall/platen {CARD} plane z lo -6.9e-3 damping 0.8 friction 0.3
fix top all wall/platen {CARD} plane z hi 6.9e-3 velocity -1 friction 0.3
"""
MAKE = BOX + """
lattice sc 1.98e-3
region fill block -6e-3 5.93e-3 -6e-3 5.93e-3 -6e-3 6e-3 units box
create_atoms 1 region fill
set group all diameter 2e-3
set group all density 1500
variable vx atom 2*sin(1e4*x+3e4*y+7e4*z+0)
variable vy atom 2*sin(5e4*x+1e4*y+3e4*z+1)
variable vz atom 2*sin(3e4*x+7e4*y+1e4*z+2)
velocity all set v_vx v_vy v_vz
"""
WRITE = """
dump last all custom 400 last.txt id x y z omegax omegay omegaz
dump_modify last sort id format float %.17g
"""


def last(folder):
    return dump_rows(folder / "last.txt")[-1]


def same(what, a, b, relative):
    assert len(a) == len(b) > 100, f"{what}: {len(a)} and {len(b)} particles"
    largest = [max(abs(row[k]) for row in a) for k in range(7)]
    worst = 0.0
    for one, two in zip(a, b):
        for k in range(7):
            near(f"{what}, particle {one[0]:.0f}, column {k}", two[k], one[k], 0, relative * largest[k])
            worst = max(worst, abs(one[k] - two[k]) / largest[k])
    print(f"{what}: {worst:.1e} of the largest value")


# `write_restart` after a run that did not just rebuild its lists loses contacts across a periodic face, in LAMMPS's own
# styles as well; `restart N` and `run 0` before it do not
whole, _ = lammps("whole", MAKE + FORCES + WRITE + "run 200\nrun 0\nwrite_restart half.restart\nrun 200\n")
halves, _ = lammps("halves", f"newton off\nread_restart {whole}/half.restart\ncomm_modify vel yes\n"
                   + FORCES + WRITE + "run 200\n")
ranks, _ = lammps("ranks", f"newton off\nread_restart {whole}/half.restart\ncomm_modify vel yes\n" + FORCES + WRITE
                  + "run 200\n", ranks=2)
start_rows = dump_rows(whole / "last.txt")[0]
moved = max(abs(a[1] - b[1]) for a, b in zip(start_rows, last(whole)))
spin = max(abs(row[4]) for row in last(whole))
assert moved > 1e-4 and spin > 10, f"nothing happened: moved {moved}, spin {spin}"
same("restart", last(whole), last(halves), 1e-12)
same("two ranks", last(whole), last(ranks), 1e-12)

# two spheres of two sizes meet off-centre with friction: what spins is what no longer orbits
R = (1e-3, 0.6e-3)
folder, _ = lammps("spin", start("-5e-3 5e-3 " * 3) + f"""
create_atoms 1 single 0 0 0
create_atoms 1 single 1.2e-3 1.1e-3 0
set atom 1 diameter {2 * R[0]}
set atom 2 diameter {2 * R[1]}
set group all density 1500
velocity all set 0 0 0
set atom 2 vx -5 vy 0 vz 1
pair_style platen
pair_coeff 1 1 {CARD} damping 0.8 friction 0.3
timestep 1e-7
fix move all nve/sphere
dump state all custom 1000 state.txt id x y z vx vy vz omegax omegay omegaz mass
dump_modify state sort id format float %.17g
run 4000
""")


def angular_momentum(frame):
    total = [0.0] * 3
    for (_, *x_v_w, mass), radius in zip(frame, R):
        x, v, w = x_v_w[:3], x_v_w[3:6], x_v_w[6:]
        orbit = (x[1] * v[2] - x[2] * v[1], x[2] * v[0] - x[0] * v[2], x[0] * v[1] - x[1] * v[0])
        for k in range(3):
            total[k] += mass * (orbit[k] + 0.4 * radius**2 * w[k])
    return total


frames = dump_rows(folder / "state.txt")
begin, end = angular_momentum(frames[0]), angular_momentum(frames[-1])
assert max(abs(w) for w in frames[-1][0][7:10]) > 100, "nothing spins"
for k in range(3):
    near(f"angular momentum {k}", end[k], begin[k], 0, 1e-12 * math.hypot(*begin))
