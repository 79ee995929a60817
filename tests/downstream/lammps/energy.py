"""A bed that is compacted and sheared between two rough walls: what the walls put in is kinetic energy, work of the law on
the contacts, or friction; from a restart at any step come the same bits; memory stays where it is.

energy.py PROGRAM PLUGIN OUT [STEPS]: the walls are the slower, the more steps there are."""
import math
import random
import sys

from lammps import PLUGIN, card, dump_rows, lammps, near, start

STEPS = int(sys.argv[4]) if len(sys.argv) > 4 else 30000
R, N = 1e-3, 5  # N x N x N spheres; in each wall 2 N x 2 N, so close that none gets through
PITCH = 2.02 * R
ENERGY = (PLUGIN / "platen.lmp").read_text().replace("platen.so", "energy.so").replace("platen_load", "energy_load")
half, top = N * PITCH / 2, (N + 1) * PITCH
COMPACT = STEPS // 10
STEP = 2e-6
SPEED = 0.25 * top / (COMPACT * STEP)  # of the upper wall: a quarter of the height down in a tenth of the run, then across
random.seed(1)
BOX = start(f"{-half!r} {half!r} {-half!r} {half!r} {-2 * R!r} {top + 2 * R!r}", "p p f", types=2)


def atoms():
    yield from ((2, x, y, z) for z in (0, top) for x in places(2 * N) for y in places(2 * N))
    for k in range(1, N + 1):
        for x in places():
            for y in places():
                yield 1, *(at + random.uniform(-4e-3, 4e-3) * R for at in (x, y, k * PITCH))


def places(count=N):
    return [(2 * (i + 0.5) / count - 1) * half for i in range(count)]


MAKE = BOX + "".join(f"create_atoms {kind} single {x!r} {y!r} {z!r}\n" for kind, x, y, z in atoms()) + f"""
set group all diameter {2 * R!r}
set group all density 1500
"""
FORCES = f"""
pair_style platen
pair_coeff * * {card('edmans-sinka')} friction 0.3
timestep {STEP!r}
atom_modify sort 0 0
neighbor {0.1 * R!r} bin
neigh_modify delay 0 every 1 check yes exclude type 2 2
group walls type 2
region above block INF INF INF INF {top / 2!r} INF
group bed type 1
fix move bed nve/sphere
"""
SHEAR = "fix down lower move linear 0 0 0\nfix up upper move linear {} 0 {}\n"
WALLS = """
group above region above
group upper intersect above walls
group lower subtract walls upper
"""
SAID = f"""
{ENERGY}
fix E walls platen/energy
thermo_style custom step f_E[1] f_E[2] f_E[3] f_E[4] f_E[5] f_E[6]
thermo_modify format float %.15g norm no lost error
thermo {STEPS // 20}
"""


def rows_of(said):
    for line in said.splitlines():
        words = line.split()
        if len(words) == 7 and all(word[0].isdigit() or word[0] == "-" for word in words):
            yield [float(word) for word in words]


def balance(name, text):
    """Work put in, of the law, of friction, kinetic energy; largest error over the work that was put in."""
    folder, said = lammps(name, text, timeout=None)
    rows = list(rows_of(said))
    off = max(abs(kinetic + law + friction - put_in) for _, put_in, law, friction, kinetic, _, _ in rows)
    _, put_in, law, friction, kinetic, contacts, pages = rows[-1]
    print(f"{name}: {STEPS} steps, {contacts:.0f} contacts; of {put_in:.3e} J {kinetic / put_in:.1e} kinetic, "
          f"{law / put_in:.3f} law, {friction / put_in:.3f} friction; off by {off / put_in:.1e}; "
          f"memory {rows[len(rows) // 4][6] * 4:.0f} kB, at the end {pages * 4:.0f} kB")
    assert contacts > 3 * N**3 and friction > 0.1 * put_in, "the bed is not dense, or does not slide"
    near(f"{name}: energy", off / put_in, 0, 0, 2e-5 if STEPS < 300000 else 1e-6)
    near(f"{name}: memory", pages, rows[len(rows) // 4][6], 0.02)
    return folder


down, across = SHEAR.format(0, -SPEED), SHEAR.format(SPEED, 0)
balance("sheared", MAKE + FORCES + WALLS + SAID + down + f"run {COMPACT}\nunfix up\nunfix down\n" + across
        + f"run {STEPS - COMPACT}\n")

# The same bits from a restart file of any step.
END, EVERY = 3 * COMPACT // 2, COMPACT // 4 - 13
WRITE = f"dump last all custom {END} last.txt id x y z vx vy vz omegax omegay omegaz\ndump_modify last sort id format float %.17g\n"
whole, _ = lammps("whole", MAKE + FORCES + WALLS + down + WRITE + f"restart {EVERY} state.*\nrun {END}\n")
for step in range(EVERY, END, EVERY):
    again, _ = lammps(f"from-{step}", f"newton off\nread_restart {whole}/state.{step}\ncomm_modify vel yes\n" + FORCES + WALLS
                      + down + WRITE + f"restart {EVERY} state.*\nrun {END - step}\n")
    if dump_rows(whole / "last.txt")[-1] != dump_rows(again / "last.txt")[-1]:
        sys.exit(f"restarted from step {step}: not the same bits")
print(f"restarted from {len(range(EVERY, END, EVERY))} steps: the same bits")
