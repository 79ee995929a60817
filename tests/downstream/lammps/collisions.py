"""10,000 random collisions without friction and damping, at the time step of `platen export lammps`: energy is not
created. What a collision loses or gains beside the work of the law comes from the step that first touches, is of either
sign, and falls with the square of the time step."""
import math
import random
import subprocess
import sys

from lammps import PLATEN, card, dump_rows, lammps

R, DENSITY, DELTA_BAR = 1e-3, 1500.0, 0.1
MASS = DENSITY * 4 / 3 * math.pi * R**3


def platen(*words):
    return subprocess.run([PLATEN, *words], check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout


def collisions(law, count, part):
    """Energy that each collision gained, and the kinetic energy it began with [J]."""
    law_card = card(law)
    stated = float(platen("export", "lammps", law_card, "--radius", f"{R}", "--density", f"{DENSITY}", "--delta-bar",
                          f"{DELTA_BAR}").split("timestep")[-1])
    overlap = 2 * R * DELTA_BAR
    table = platen("eval", law_card, "-p", f"radius_m={R}", "--overlap", f"0:{overlap}:2001").splitlines()[1:]
    work = sum(float(line.split(",")[1]) for line in table) * overlap / 2000
    fastest = math.sqrt(4 * work / MASS)  # reaches that overlap
    random.seed(1)
    uniform = random.uniform
    side, cell = math.ceil(count ** (1 / 3)), 8 * R
    places, speeds, before = [], [], []
    for pair in range(count):
        centre = [(k + 0.5) * cell for k in (pair % side, pair // side % side, pair // side**2)]
        z, angle = uniform(-1, 1), uniform(0, 2 * math.pi)
        n = [math.sqrt(1 - z * z) * math.cos(angle), math.sqrt(1 - z * z) * math.sin(angle), z]
        v = fastest * uniform(0.1, 1)
        gap = v * stated * random.random()  # each first touches elsewhere in a step
        slip = [v * uniform(-0.1, 0.1) for _ in range(3)]
        w = [slip[k] - v * n[k] for k in range(3)]
        for sign in (0.5, -0.5):
            places.append([centre[k] + sign * n[k] * (2 * R + gap) for k in range(3)])
            speeds.append([sign * w[k] for k in range(3)])
        before.append(MASS / 4 * sum(x * x for x in w))
    every = round(2 / part)
    steps = 150 * every
    folder, _ = lammps(f"collisions-{law}-{part}", f"""
units si
atom_style sphere
newton off
read_data data
pair_style platen
pair_coeff * * {law_card}
timestep {stated * part!r}
neighbor 2e-4 bin
neigh_modify every 1 delay 0 check yes
fix move all nve/sphere
compute pairs all property/local patom1
compute contacts all pair/local dist p2 p5
dump contacts all local {every} contacts.txt c_pairs c_contacts[2] c_contacts[3]
dump_modify contacts format line "%.0f %.17g %.17g"
dump last all custom {steps} last.txt id vx vy vz
dump_modify last sort id format float %.17g
run {steps}
""", files={"data": "two of each\n\n" + f"{2 * count} atoms\n1 atom types\n\n"
            + "".join(f"0 {side * cell} {a}lo {a}hi\n" for a in "xyz") + "\nAtoms\n\n"
            + "".join(f"{i + 1} 1 {2 * R} {DENSITY} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(places))
            + "\nVelocities\n\n"
            + "".join(f"{i + 1} {x!r} {y!r} {z!r} 0 0 0\n" for i, (x, y, z) in enumerate(speeds))})
    lost = {}  # to plastic work, of the law
    frames = dump_rows(folder / "contacts.txt")
    for frame in frames:
        for atom, force, work in frame:
            lost[int(atom - 1) // 2] = work
    assert len(lost) == count, f"{law}: {count - len(lost)} pairs never met"
    assert not any(force for _, force, _ in frames[-1]), f"{law}: not all collisions are over"
    last = dump_rows(folder / "last.txt")[-1]
    after = [MASS / 4 * sum((last[2 * p][k] - last[2 * p + 1][k]) ** 2 for k in (1, 2, 3)) for p in range(count)]
    return [after[p] + lost[p] - before[p] for p in range(count)], before


def rms(gained, before):
    return math.sqrt(sum((g / b) ** 2 for g, b in zip(gained, before)) / len(before))


for law in ("hertz", "edmans-sinka", "agarwal"):
    gained, before = collisions(law, 10000, 1)
    total = sum(gained) / sum(before)
    print(f"{law}: all gain {total:.1e} of the kinetic energy, one at most {max(g / b for g, b in zip(gained, before)):.1e}")
    if not -1e-5 < total < 1e-6:
        sys.exit(f"{law}: the collisions gain {total:.2e} of the kinetic energy")
    whole, half = rms(gained, before), rms(*collisions(law, 2000, 0.5))
    print(f"{law}: root mean square {whole:.1e}; {whole / half:.2f} times smaller at half the time step")
    if not 3.5 < whole / half < 6.5:  # 4; Hertz's contact, smoother at its start, 2^2.5 = 5.7
        sys.exit(f"{law}: half the time step makes the error {whole / half:.2f} times smaller")
