"""A loose heap that collides with friction and damping: the same from a restart and on two ranks."""
from lammps import card, dump_rows, lammps, near, start

CARD = card("edmans-sinka")
BOX = start("-6e-3 6e-3 -6e-3 6e-3 -6e-3 6e-3", "p p p")
FORCES = f"""
pair_style platen
pair_coeff * * {CARD} damping 0.8 friction 0.3
timestep 1e-6
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
fix move all nve/sphere
"""
MAKE = BOX + """
lattice sc 1.98e-3
create_atoms 1 box
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


whole, _ = lammps("whole", MAKE + FORCES + WRITE + "run 200\nwrite_restart half.restart\nrun 200\n")
halves, _ = lammps("halves", f"newton off\nread_restart {whole}/half.restart\ncomm_modify vel yes\n"
                   + FORCES + WRITE + "run 200\n")
ranks, _ = lammps("ranks", f"newton off\nread_restart {whole}/half.restart\ncomm_modify vel yes\n" + FORCES + WRITE
                  + "run 200\n", ranks=2)
start_rows = dump_rows(whole / "last.txt")[0]
moved = max(abs(a[1] - b[1]) for a, b in zip(start_rows, last(whole)))
spin = max(abs(row[4]) for row in last(whole))
assert moved > 1e-4 and spin > 10, f"nothing happened: moved {moved}, spin {spin}"
same("restart", last(whole), last(halves), 1e-9)
same("two ranks", last(whole), last(ranks), 1e-9)
