#!/usr/bin/env python3
"""The simple press in CalculiX with elements of second order and reduced integration (CAX8R), which do not lock
where flow is isochoric, or with CAX8 or CAX4, on one mesh.

    press_calculix.py --element CAX8R --E 100 --step 0.001 --until 0.3 --folder out

Radius and yield stress (Hollomon: kappa) are one. Needs ccx (Debian: calculix-ccx) and numpy.
"""
import argparse
import math
import os
import re
import subprocess

import numpy as np

p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
p.add_argument("--element", default="CAX8R", choices=["CAX4", "CAX8", "CAX8R"])
p.add_argument("--E", type=float, default=100)
p.add_argument("--nu", type=float, default=0.3)
p.add_argument("--n", type=float, default=0, help="Hollomon exponent 1/m; 0: perfectly plastic")
p.add_argument("--columns", type=int, default=44, help="edges of CAX8 from the pole to 60 degrees (CAX4: twice as many)")
p.add_argument("--step", type=float, default=0.001)
p.add_argument("--until", type=float, default=0.3)
p.add_argument("--stiffness", type=float, default=5e4)
p.add_argument("--at", default="0.02,0.03,0.05,0.1,0.15,0.2,0.25,0.3,0.35,0.4,0.45,0.5")
p.add_argument("--folder", default="out")
a = p.parse_args()
at = [float(x) for x in a.at.split(",") if float(x) <= a.until + 1e-9]
second = a.element != "CAX4"
# ---- mesh on a lattice of corners, midsides (and middles, not used by CAX8) ------------------------------
n1, n2, m = a.columns, max(6, a.columns // 4), a.columns // 2
A, B, C, O = np.array([0, .45]), np.array([.36, .3]), np.array([.45, 0]), np.array([0, 0])
split = math.radians(60)


def graded(n, ratio):                             # 2 n + 1 places, last step over first: ratio
    steps = np.repeat(ratio ** (np.arange(n) / max(n - 1, 1)), 2)
    return np.concatenate([[0], np.cumsum(steps)]) / steps.sum()


s1, s2, sr = graded(n1, 3.0), graded(n2, 1.0), graded(m, 0.18)
arc = lambda t: np.array([math.sin(t), math.cos(t)])
line = lambda p0, p1: (lambda t: (1 - t) * p0 + t * p1)


def patch(bottom, top, left, right, us, vs):      # transfinite; bottom(u), top(u), left(v), right(v)
    X = np.zeros((len(us), len(vs), 2))
    for i, u in enumerate(us):
        for j, v in enumerate(vs):
            X[i, j] = ((1 - v) * bottom(u) + v * top(u) + (1 - u) * left(v) + u * right(v)
                       - (1 - u) * (1 - v) * bottom(0) - u * (1 - v) * bottom(1) - (1 - u) * v * top(0) - u * v * top(1))
    return X


D, E_, P = arc(split), np.array([1, 0]), np.array([0, 1])
patches = [
    patch(line(O, C), line(A, B), line(O, A), line(C, B), s1, s2),
    patch(line(A, B), lambda u: arc(split * u), line(A, P), line(B, D), s1, sr),
    patch(line(B, C), lambda u: arc(split + (math.pi / 2 - split) * u), line(B, D), line(C, E_), s2, sr),
]
nodes, index = [], {}


def node(x):
    key = (round(x[0], 9), round(x[1], 9))
    if key not in index:
        index[key] = len(nodes) + 1
        nodes.append((abs(x[0]) if abs(x[0]) < 1e-9 else x[0], 0.0 if abs(x[1]) < 1e-9 else x[1]))
    return index[key]


cells, outside = [], []
for number, X in enumerate(patches):
    h = 2 if second else 1
    for i in range(0, X.shape[0] - 1, h):
        for j in range(0, X.shape[1] - 1, h):
            places = [(i, j), (i + h, j), (i + h, j + h), (i, j + h)]
            if second: places += [(i + 1, j), (i + 2, j + 1), (i + 1, j + 2), (i, j + 1)]
            q = [X[k] for k in places]
            if (q[1][0] - q[0][0]) * (q[3][1] - q[0][1]) - (q[1][1] - q[0][1]) * (q[3][0] - q[0][0]) < 0:
                order = [0, 3, 2, 1] + ([7, 6, 5, 4] if second else [])
                q = [q[k] for k in order]
                top = 2                           # sides: (0,3) (3,2) (2,1) (1,0)
            else: top = 3
            cells.append([node(x) for x in q])
            if number and j + h == X.shape[1] - 1:
                ids = cells[-1]
                side = next(s for s in range(4) if all(abs(np.hypot(*nodes[ids[k] - 1]) - 1) < 1e-6 for k in (s, (s + 1) % 4)))
                outside.append((len(cells), side + 1))
N = len(nodes)
xy = np.array(nodes)
ids = np.arange(1, N + 1)
axis, equator = ids[xy[:, 0] < 1e-9], ids[xy[:, 1] < 1e-9]
surface = ids[abs(np.hypot(*xy.T) - 1) < 1e-6]
surface = surface[np.argsort(np.arctan2(*xy[surface - 1].T))]
# ---- deck ------------------------------------------------------------------------------------------------
lists = lambda v: "".join(f"{k},\n" for k in v)
d = "*NODE, NSET=ALL\n" + "".join(f"{k + 1}, {x:.12g}, {y:.12g}\n" for k, (x, y) in enumerate(nodes))
d += "*NODE, NSET=PLANE\n" + "".join(f"{N + 1 + k}, {x}, {y}\n" for k, (x, y) in enumerate([(1e-3, 1), (2, 1), (2, 1.2), (1e-3, 1.2)]))
d += f"*ELEMENT, TYPE={a.element}, ELSET=SPHERE\n" + "".join(f"{k + 1}, " + ", ".join(map(str, c)) + "\n" for k, c in enumerate(cells))
d += f"*ELEMENT, TYPE=CAX4, ELSET=TOOL\n{len(cells) + 1}, {N + 1}, {N + 2}, {N + 3}, {N + 4}\n"
for name, v in (("AXIS", axis), ("EQUATOR", equator), ("SURF", surface)): d += f"*NSET, NSET={name}\n" + lists(v)
d += "*SURFACE, NAME=OUTSIDE, TYPE=ELEMENT\n" + "".join(f"{e}, S{s}\n" for e, s in outside)
d += f"*SURFACE, NAME=FLAT, TYPE=ELEMENT\n{len(cells) + 1}, S1\n"
d += f"*MATERIAL, NAME=PLASTIC\n*ELASTIC\n{a.E}, {a.nu}\n*PLASTIC\n"
if a.n:
    ey = (1 / a.E) ** (1 / (1 - a.n))
    strains = [ey] + [e for e in np.geomspace(1e-5, 10, 100) if e > 1.05 * ey]
    d += "".join(f"{e ** a.n:.12g}, {max(0, e - e ** a.n / a.E):.12g}\n" for e in strains)
else: d += "1., 0.\n"
d += f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{1000 * a.E}, 0.3\n*SOLID SECTION, ELSET=SPHERE, MATERIAL=PLASTIC\n*SOLID SECTION, ELSET=TOOL, MATERIAL=STEEL\n"
d += f"*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{a.stiffness}\n"
d += "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\nOUTSIDE, FLAT\n"
d += "*BOUNDARY\nAXIS, 1, 1\nPLANE, 1, 2\n*TIME POINTS, NAME=COMPARED\n" + "".join(f"{x / at[-1]:.10g},\n" for x in at)
d += f"*STEP, NLGEOM, INC=100000\n*STATIC\n{a.step / at[-1] / 5:.6g}, 1., 1e-7, {a.step / at[-1]:.6g}\n*BOUNDARY\nEQUATOR, 2, 2, {at[-1]}\n"
d += "*NODE PRINT, NSET=EQUATOR, TOTALS=ONLY, TIME POINTS=COMPARED\nRF\n*NODE PRINT, NSET=SURF, TIME POINTS=COMPARED\nU\n*END STEP\n"
os.makedirs(a.folder, exist_ok=True)
open(f"{a.folder}/press.inp", "w").write(d)
print(f"{len(cells)} {a.element}, {N} nodes", flush=True)
subprocess.run("OMP_NUM_THREADS=1 ccx -i press > ccx.log 2>&1 < /dev/null", shell=True, cwd=a.folder)
# ---- results ---------------------------------------------------------------------------------------------
print("delta_bar,F_bar,a_bar")
text = open(f"{a.folder}/press.dat").read()
for part in re.split(r"\n(?= total force)", "\n" + text)[1:]:
    numbers = [float(x) for x in re.findall(r"[-+]\d?\.\d+E[-+]\d+|\d\.\d+E[-+]\d+", part.split("displacements")[0])]
    delta, F = numbers[0] * at[-1], 180 * numbers[2] / math.pi
    u = {int(l.split()[0]): [float(x) for x in l.split()[1:3]] for l in part.split("displacements")[1].splitlines()[1:] if len(l.split()) == 4}
    r = np.array([xy[k - 1][0] + u[k][0] for k in surface])
    g = np.array([xy[k - 1][1] + u[k][1] - 1 for k in surface])
    touching = np.where(g > 0)[0]
    radius = 0
    if len(touching):
        i = touching[-1]
        radius = r[i] + (r[i + 1] - r[i]) * g[i] / (g[i] - g[i + 1])
    print(f"{delta:.5f},{F:.6f},{radius:.5f}", flush=True)
