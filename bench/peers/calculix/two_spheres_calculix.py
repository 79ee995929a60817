#!/usr/bin/env python3
"""Two plastic spheres pressed against each other in CalculiX: perfectly plastic, CAX4, without friction. Each is
half a sphere whose equator stays plane, as between two presses.

    two_spheres_calculix.py --sigma 1 5 --radius 1 2 --E 100 100 --until 0.4 --folder out

The first sphere's radius and yield stress are one. Prints the approach of the centres and the force, over the first
sphere's radius and pi R^2 sigma_y. Needs ccx (Debian: calculix-ccx).
"""
import argparse
import math
import os
import re
import subprocess

p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
p.add_argument("--sigma", type=float, nargs=2, default=[1, 1], help="yield stresses")
p.add_argument("--radius", type=float, nargs=2, default=[1, 1])
p.add_argument("--E", type=float, nargs=2, default=[100, 100])
p.add_argument("--nu", type=float, default=0.3)
p.add_argument("--columns", type=int, default=32, help="edges from the pole to 60 degrees")
p.add_argument("--grading", type=float, default=3, help="last of them over the first")
p.add_argument("--step", type=float, default=0.015, help="largest increment of the approach, of the approach so far")
p.add_argument("--step-most", type=float, default=0.002, help="and in first radii")
p.add_argument("--until", type=float, default=0.4)
p.add_argument("--stiffness", type=float, default=5e4, help="pressure per penetration")
p.add_argument("--slave", type=int, choices=[1, 2], default=1, help="the sphere that takes part as slave surface")
p.add_argument("--folder", default="out")
a = p.parse_args()
AT = [0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8]
at = [x for x in AT if x <= a.until + 1e-9]


def graded(n, ratio):  # n + 1 places, last step over first: ratio
    steps = [ratio ** (i / (n - 1)) for i in range(n)]
    places = [0.0]
    for s in steps: places.append(places[-1] + s / sum(steps))
    return places


def quarter_disc(columns):
    """Nodes and quadrilaterals of the unit quarter disc, pole at (0, 1), and the sides that lie on the circle."""
    split = math.radians(60)
    arc = lambda t: (math.sin(t), math.cos(t))
    line = lambda p, q: lambda t: ((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1])
    O, A, B, C, D, E, P = (0, 0), (0, .45), (.36, .3), (.45, 0), arc(split), (1, 0), (0, 1)
    s1, s2, sr = graded(columns, a.grading), graded(max(12, columns // 4), 1), graded(columns // 2, 0.18)
    patches = [(line(O, C), line(A, B), line(O, A), line(C, B), s1, s2),
               (line(A, B), lambda u: arc(split * u), line(A, P), line(B, D), s1, sr),
               (line(B, C), lambda u: arc(split + (math.pi / 2 - split) * u), line(B, D), line(C, E), s2, sr)]
    nodes, index, cells, outside = [], {}, [], []

    def node(bottom, top, left, right, u, v):  # transfinite
        x = [(1 - v) * bottom(u)[k] + v * top(u)[k] + (1 - u) * left(v)[k] + u * right(v)[k]
             - (1 - u) * (1 - v) * bottom(0)[k] - u * (1 - v) * bottom(1)[k]
             - (1 - u) * v * top(0)[k] - u * v * top(1)[k] for k in (0, 1)]
        key = (round(x[0], 9) + 0.0, round(x[1], 9) + 0.0)
        if key not in index:
            index[key] = len(nodes)
            nodes.append(key)
        return index[key]

    for number, (*sides, us, vs) in enumerate(patches):
        for i in range(len(us) - 1):
            for j in range(len(vs) - 1):
                q = [node(*sides, us[i + k], vs[j + l]) for k, l in ((0, 0), (1, 0), (1, 1), (0, 1))]
                x = [nodes[n] for n in q]
                if (x[1][0] - x[0][0]) * (x[3][1] - x[0][1]) < (x[1][1] - x[0][1]) * (x[3][0] - x[0][0]):
                    q.reverse()
                cells.append(q)
                for s in range(4):
                    if number and all(abs(math.hypot(*nodes[q[k]]) - 1) < 1e-7 for k in (s, (s + 1) % 4)):
                        outside.append((len(cells), s + 1))
    return nodes, cells, outside


nodes, cells, outside = quarter_disc(a.columns)
N, M = len(nodes), len(cells)
deck = ""
for side in (0, 1):
    R = a.radius[side]
    # A master that begins at the axis is an edge there, with which CalculiX finds no contact: it begins beside it.
    hole = 0 if side + 1 == a.slave else 1e-3 * R
    place = (lambda x, y: (R * x + hole * (x < 1e-9), R * y)) if side == 0 else \
        (lambda x, y: (R * x + hole * (x < 1e-9), a.radius[0] + R - R * y))
    deck += f"*NODE, NSET=ALL\n" + "".join("{}, {:.12g}, {:.12g}\n".format(side * N + k + 1, *place(*x)) for k, x in enumerate(nodes))
    deck += f"*ELEMENT, TYPE=CAX4, ELSET=SPHERE{side + 1}\n"
    for k, q in enumerate(cells):
        q = q if side == 0 else [q[0], q[3], q[2], q[1]]  # mirrored: the other way round
        deck += f"{side * M + k + 1}, " + ", ".join(str(side * N + n + 1) for n in q) + "\n"
    for name, k in (("AXIS", 0), ("EQUATOR", 1)):
        deck += f"*NSET, NSET={name}{side + 1}\n" + "".join(f"{side * N + n + 1},\n" for n, x in enumerate(nodes) if abs(x[k]) < 1e-8)
    deck += f"*SURFACE, NAME=OUTSIDE{side + 1}, TYPE=ELEMENT\n"
    deck += "".join(f"{side * M + e}, S{s if side == 0 else 5 - s}\n" for e, s in outside)
    deck += f"*MATERIAL, NAME=M{side + 1}\n*ELASTIC\n{a.E[side]}, {a.nu}\n*PLASTIC\n{a.sigma[side]}, 0.\n"
for side in (1, 2): deck += f"*SOLID SECTION, ELSET=SPHERE{side}, MATERIAL=M{side}\n"
deck += f"*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{a.stiffness}\n"
deck += f"*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\nOUTSIDE{a.slave}, OUTSIDE{3 - a.slave}\n"
deck += "*BOUNDARY\nAXIS1, 1, 1\nAXIS2, 1, 1\nEQUATOR2, 2, 2\n"
for begin, end in zip([0] + at, at): # the return mapping errs with the increment, so that grows with the approach
    most = min(a.step * (begin or 2 * end), a.step_most) / (end - begin)
    deck += f"*STEP, NLGEOM, INC=100000\n*STATIC\n{most / 5:.6g}, 1., 1e-7, {most:.6g}\n*BOUNDARY\nEQUATOR1, 2, 2, {end}\n"
    deck += "*NODE PRINT, NSET=EQUATOR1, TOTALS=ONLY, FREQUENCY=100000\nRF\n*END STEP\n"
os.makedirs(a.folder, exist_ok=True)
with open(f"{a.folder}/press.inp", "w") as file: file.write(deck)
print(f"# {2 * M} CAX4, sigma_y {a.sigma}, radius {a.radius}, E {a.E}, steps {a.step}", flush=True)
subprocess.run("OMP_NUM_THREADS=1 ccx -i press > ccx.log 2>&1 < /dev/null", shell=True, cwd=a.folder)
print("gamma,F_bar")
with open(f"{a.folder}/press.dat") as file: text = file.read()
for end, force in zip(at, re.findall(r"total force.*and time\s+\S+\s+\S+\s+(\S+)", text)):
    # CalculiX makes a sector of 2 degrees.
    print(f"{end:.5f},{180 * float(force) / math.pi:.6f}")
