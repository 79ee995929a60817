"""The contact benchmarks that DEM codes share: the eight impacts of Chung & Ooi, Granular Matter 13 (2011) 643, of the
materials with which YADE, Kratos and PySPH run them; an oblique impact at 76 degrees; spheres of sizes 1:50; impacts far
from the origin; and a plastic one that those suites lack, the restitution of Thornton & Ning. The references are closed
forms: Hertz's impact, and the impulse mu J_n of a sphere that slides as long as it touches. No impact adds kinetic energy,
and every sphere leaves."""
import math
import sys

from lammps import card, dump_rows, lammps

CONTACT = 4 / 5 * math.sqrt(math.pi) * math.gamma(0.4) / math.gamma(0.9)  # 2.943: duration of Hertz's impact, times V/gamma_max
worst = {}


class Sphere:
    """Flies along x; v = (v_x, v_y), spin about z."""

    def __init__(self, R, density, v, spin=0.0):
        self.R, self.density, self.v, self.spin = R, density, v, spin
        self.m = density * 4 / 3 * math.pi * R**3
        self.I = 0.4 * self.m * R * R


def hertz(V, m, R, E):
    """Largest force and duration of an elastic impact, and its largest overlap: m V^2/2 = 8/15 E sqrt(R) gamma^(5/2)."""
    gamma = (15 * m * V * V / (16 * E * math.sqrt(R))) ** 0.4
    return 4 / 3 * E * math.sqrt(R) * gamma**1.5, CONTACT * gamma / V, gamma


def check(what, value, reference, relative=0.01, scale=None):
    """`scale`: what the error is measured by, where the reference may be near zero."""
    error = abs(value - reference) / (scale or abs(reference))
    case = what.split(":")[0]
    worst[case] = max(worst.get(case, 0), error)
    if not error <= relative:
        sys.exit(f"{what}: {value!r} is not {reference!r} (relative {error:.2e})")


def impacts(name, law, contact, groups, duration, steps=1000, at=0.0, passes=1.6, room=1e-9):
    """Each group meets in a lane of its own: a sphere and the rigid plane below it at x = `at`, or two spheres. For each
    group the rows (v_x, v_y, spin, f_x) of its spheres, step by step, and the time step."""
    largest = max(s.R for group in groups for s in group)
    span, dt = 8 * largest, duration / steps
    wall = len(groups[0]) == 1
    atoms, speeds, number = "", "", 0
    for lane, group in enumerate(groups):
        gap = 0.3 * dt * sum(abs(s.v[0]) for s in group)  # first touch within a step
        for side, s in zip((1,) if wall else (-1, 1), group):
            number += 1
            x = at + side * (s.R + gap / len(group))
            atoms += f"{number} 1 {2 * s.R!r} {s.density!r} {x!r} {(lane + 0.5) * span!r} 0\n"
            speeds += f"{number} {s.v[0]!r} {s.v[1]!r} 0 0 0 {s.spin!r}\n"
    box = f"{at - span!r} {at + span!r} xlo xhi\n{-span!r} {(len(groups) + 1) * span!r} ylo yhi\n{-span!r} {span!r} zlo zhi\n"
    plane = f"fix wall all wall/platen {law} plane x lo {at!r} {contact}" if wall else ""
    folder, _ = lammps(name, f"""
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
read_data data
pair_style platen
pair_coeff 1 1 {law} {contact}
{plane}
neighbor {0.2 * min(s.R for group in groups for s in group)!r} bin
neigh_modify delay 0
timestep {dt!r}
fix move all nve/sphere
dump all all custom 1 all.txt id vx vy omegaz fx
dump_modify all sort id format float %.17g
run {math.ceil(passes * steps)}
""", files={"data": f"spheres\n\n{number} atoms\n1 atom types\n\n{box}\nAtoms\n\n{atoms}\nVelocities\n\n{speeds}"})
    frames, first, results = dump_rows(folder / "all.txt"), 0, []
    for group in groups:
        rows = [[row[1:] for row in frame[first:first + len(group)]] for frame in frames]
        first += len(group)
        energy = [sum(s.m * (vx * vx + vy * vy) / 2 + s.I * spin * spin / 2 for s, (vx, vy, spin, _) in zip(group, row))
                  for row in rows]
        if max(energy) > energy[0] * (1 + room):
            sys.exit(f"{name}: the kinetic energy is {max(energy) / energy[0]!r} of what was put in")
        if not any(row[0][3] for row in rows) or rows[-1][0][3]:
            sys.exit(f"{name}: sphere {first} never met, or sticks")
        results.append(rows)
    return results, dt


def elastic(name, rows, dt, F, t):
    forces = [abs(row[0][3]) for row in rows]
    check(f"{name}: force", max(forces), F)
    check(f"{name}: duration", sum(f > 0 for f in forces) * dt, t)


def lag(V, slip, mu, nu, damping):
    """What a sliding contact has less than mu J_n, over mu m V. At first touch the viscous force c V ~ u^(1/4) is there before
    Mindlin's spring is wound: at constant velocities 8 G* sqrt(R) (2/3) u^(3/2) slip/V reaches mu (F + c V) at u, and what lacks
    until then is (2/5) (mu damping)^2 2 E* m V/(16/3 G* slip/V - 4/3 mu E*)."""
    G = (1 - nu) / (2 * (2 - nu))  # G*/E*
    return 0.8 * mu * damping**2 / (16 / 3 * G * slip / V - 4 / 3 * mu)


def slid(name, group, rows, J_n, mu, lacks=0.0):
    """Each surface's way along y at the contact, and the impulse mu J_n against it; of J_n the spring `lacks` a part."""
    sides = (-1,) if len(group) == 1 else (1, -1)  # of the contact, seen from the sphere
    slip = sum(side * (-1 if len(group) == 1 else 1) * (s.v[1] + side * s.R * s.spin) for side, s in zip(sides, group))
    J = -math.copysign(mu * J_n * (1 - lacks), slip)  # on the first sphere
    had = abs(rows[-1][0][1] - group[0].v[1]) * group[0].m / (mu * J_n)
    if not had <= 1.001:  # J_n is that of the velocity to 0.1 %
        sys.exit(f"{name}: friction had {had!r} of mu J_n")
    for s, side, sign, (_, v_y, spin, _) in zip(group, sides, (1, -1), rows[-1]):
        v_change, spin_change = sign * J / s.m, side * s.R * sign * J / s.I
        check(f"{name}: along the plane", v_y, s.v[1] + v_change, scale=max(abs(s.v[1]), abs(v_change)))
        check(f"{name}: spin", spin, s.spin + spin_change, scale=max(abs(s.spin), abs(spin_change)))


def material(name, E, nu):
    return card("hertz", name, f"E_Pa = {E!r}\nnu = {nu!r}"), E / (1 - nu * nu)


# 1: two spheres at 10 m/s each
for name, E, nu, density in (("glass", 4.8e10, 0.2, 2800.0), ("limestone", 2e10, 0.25, 2500.0)):
    law, flat = material(name, E, nu)
    pair = [Sphere(0.01, density, (v, 0.0)) for v in (10.0, -10.0)]
    F, t, _ = hertz(20, pair[0].m / 2, 0.005, flat / 2)
    (rows,), dt = impacts(f"1-{name}", law, "", [pair], t)
    elastic("1, two spheres", rows, dt, F, t)

# 2: a sphere and a rigid plane
for name, E, nu, density in (("aluminium", 7e10, 0.3, 2699.0), ("magnesium", 4e10, 0.35, 1800.0)):
    law, flat = material(name, E, nu)
    sphere = Sphere(0.1, density, (-0.2, 0.0))
    F, t, _ = hertz(0.2, sphere.m, 0.1, flat)
    (rows,), dt = impacts(f"2-{name}", law, "", [[sphere]], t)
    elastic("2, sphere and plane", rows, dt, F, t)

# 3: restitution
for name, E, nu, density in (("alumina", 3.8e11, 0.23, 4000.0), ("iron", 1e11, 0.25, 7000.0)):
    law, flat = material(name, E, nu)
    sphere = Sphere(0.0025, density, (-3.9, 0.0))
    _, t, _ = hertz(3.9, sphere.m, 0.0025, flat)
    for e in (0.2, 0.4, 0.6, 0.8, 1):
        (rows,), _ = impacts(f"3-{name}-{e}", law, f"damping {e}", [[sphere]], t, passes=4)
        check("3, restitution: velocity", rows[-1][0][0], 3.9 * e)

# 4: one speed, many angles; those of 35 degrees and more slide throughout: tan > 7/2 mu (1 + e)
for name, E, nu, density in (("alumina", 3.8e11, 0.23, 4000.0), ("aluminium-4", 7e10, 0.33, 2700.0)):
    law, flat = material(name, E, nu)
    angles = [math.radians(degrees) for degrees in (2, 5, 10, 15, 20, 25, 30, 35, 40, 50, 60, 70, 76, 80, 85)]
    spheres = [Sphere(0.0025, density, (-3.9 * math.cos(a), 3.9 * math.sin(a))) for a in angles]
    _, t, _ = hertz(3.9, spheres[0].m, 0.0025, flat)
    results, _ = impacts(f"4-{name}", law, "damping 0.98 friction 0.092", [[s] for s in spheres], t, passes=3.5)
    for a, s, rows in zip(angles, spheres, results):
        check("4, angles: normal velocity", rows[-1][0][0], -0.98 * s.v[0])
        if a > math.radians(34):
            slid("4, angles", [s], rows, 1.98 * -s.v[0] * s.m, 0.092)

# 5: one normal velocity, many tangential ones; 76 degrees among those that slide: tan > 7 mu
law, flat = material("steel", 2.08e11, 0.3)
tangents = [0.05, 0.2, 0.5, 1, 1.5, 2.2, math.tan(math.radians(76)), 6, 10]
spheres = [Sphere(1e-5, 7850.0, (-5.0, 5 * tangent)) for tangent in tangents]
_, t, _ = hertz(5, spheres[0].m, 1e-5, flat)
results, _ = impacts("5-steel", law, "friction 0.3", [[s] for s in spheres], t)
for tangent, s, rows in zip(tangents, spheres, results):
    check("5, tangential velocities: normal velocity", rows[-1][0][0], 5)
    if tangent > 2.1:
        slid("5, tangential velocities", [s], rows, 2 * 5 * s.m, 0.3)

# 6: a spinning sphere and a plane; 7: two spheres that spin alike; 8: one of five times the radius, a thousandfold density.
spins = [0.175, 1, 3, 5, 9, 22]
for name, E, nu, density in (("aluminium-6", 7e10, 0.33, 2700.0), ("nylon", 2.5e9, 0.4, 1000.0)):
    law, flat = material(name, E, nu)
    one = lambda v, spin: Sphere(0.1, density, (v, 0.0), spin)
    cases = {"6, spin on a plane": [[one(-0.2, spin)] for spin in spins],
             "7, two spinning spheres": [[one(0.2, spin), one(-0.2, spin)] for spin in spins],
             "8, spheres of two sizes": [[one(0.2, spin), Sphere(0.5, 1000 * density, (0.0, 0.0))] for spin in spins]}
    for case, groups in cases.items():
        mass = 1 / sum(1 / s.m for s in groups[0])
        V = sum(abs(s.v[0]) for s in groups[0])
        R = 1 / sum(1 / s.R for s in groups[0])
        _, t, _ = hertz(V, mass, R, flat / len(groups[0]))
        for e, damping in ((1, 0), (0.5, 0.46605)):  # Thornton, Cummins & Cleary, Powder Technology 233 (2013) 30, Table 2
            results, _ = impacts(f"{case[0]}-{name}-{e}", law, f"damping {e} friction 0.4", groups, t, passes=3)
            for spin, group, rows in zip(spins, groups, results):
                J_n = (1 + e) * V * mass
                check(f"{case}, e = {e}: normal velocity", rows[-1][0][0] - group[0].v[0],
                      math.copysign(J_n / group[0].m, -group[0].v[0]))
                if 0.1 * spin > 3.5 * 0.4 * (1 + e) * 0.2:  # slides throughout
                    slid(f"{case}, e = {e}", group, rows, J_n, 0.4, lag(0.2, 0.1 * spin, 0.4, nu, damping) / (1 + e))

# sizes 1:50
law, flat = material("ratio", 7e10, 0.33)
group = [Sphere(1e-3, 2700.0, (1.0, 0.0)), Sphere(5e-2, 2700.0, (0.0, 0.0))]
mass, R = 1 / sum(1 / s.m for s in group), 1 / sum(1 / s.R for s in group)
F, t, _ = hertz(1, mass, R, flat / 2)
(rows,), dt = impacts("ratio", law, "", [group], t)
elastic("sizes 1 to 50", rows, dt, F, t)
for s, sign, row in zip(group, (-1, 1), rows[-1]):
    check("sizes 1 to 50: velocity", row[0], s.v[0] + sign * 2 * mass / s.m)

# far from the origin, and slow: overlaps down to 3e-8 R, at 1e5 R, where each of a thousand steps rounds the place at random
law, flat = material("far", 2.08e11, 0.3)
for v in (5.0, 1e-2, 1e-6):
    sphere = Sphere(1e-5, 7850.0, (-v, 0.0))
    _, t, gamma = hertz(v, sphere.m, 1e-5, flat)
    (rows,), _ = impacts(f"far-{v}", law, "", [[sphere]], t, at=1.0, room=4 * sys.float_info.epsilon * math.sqrt(1000) / gamma)
    check("far from the origin: velocity", rows[-1][0][0], v)

# plastic: the restitution of Thornton & Ning, Powder Technology 99 (1998) 154, over V/V_y, V_y what just yields
E, nu, p_y, R, density = 2e11, 0.3, 1.6e9, 1e-3, 7800.0
flat = E / (1 - nu * nu)
law = card("thornton-ning", "plastic", f"E_Pa = {E!r}\nnu = {nu!r}\np_y_Pa = {p_y!r}")
m = Sphere(R, density, (0, 0)).m
V_y = math.sqrt(16 / 15 * flat * math.sqrt(R) * ((math.pi * p_y / (2 * flat)) ** 2 * R) ** 2.5 / m)
for times in (2, 5, 15):
    y = 1 / times  # V_y/V
    e = math.sqrt(6 * math.sqrt(3) / 5 * (1 - y * y / 6)) * (y / (y + 2 * math.sqrt(6 / 5 - y * y / 5))) ** 0.25
    sphere = Sphere(R, density, (-times * V_y, 0.0))
    _, t, _ = hertz(times * V_y, m, R, flat)
    (rows,), _ = impacts(f"plastic-{times}", law, "", [[sphere]], t, steps=4000, passes=2)
    check("Thornton & Ning: restitution", rows[-1][0][0] / (times * V_y), e, 1e-4)

for case, error in worst.items():
    print(f"{case}: at most {100 * error:.2g} % off")
