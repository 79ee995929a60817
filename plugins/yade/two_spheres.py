"""Two spheres of YADE pressed together, parted and pressed again by Platen's law, beside `platen eval`: forces to 1e-9.

yade -n -x two_spheres.py   # PLATEN_PROGRAM: the program platen; platen and this folder on PYTHONPATH
"""

import csv
import os
import subprocess
import sys
import time

import numpy as np
from platen_yade import PlatenForces
from yade import utils
from yade.wrapper import *

import platen

R, travel, steps = 0.5e-3, 8e-5, 400
law = platen.Material.load("mcc-ph-200").predict()
law.save("law.toml")
O.bodies.append([utils.sphere((0, 0, 0), R, fixed=True), utils.sphere((0, 0, 2 * R), R, fixed=True)])
forces = PlatenForces(law, O)
rows = []


def move():
    """In, half out, in again and farther, out."""
    way = np.interp(O.iter, [0, steps, 1.5 * steps, 2.7 * steps, 4 * steps], [0, travel, 0.9 * travel, 1.2 * travel, -1e-6])
    O.bodies[1].state.pos = (0, 0, 2 * R - way)


def note():
    i = next((i for i in O.interactions if i.isReal), None)
    if i is not None:
        rows.append((i.geom.penetrationDepth, O.forces.f(1)[2], -O.forces.f(0)[2]))


O.engines = [
    PyRunner(command="move()", iterPeriod=1),
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
    PyRunner(command="forces()", iterPeriod=1),
    PyRunner(command="note()", iterPeriod=1),
    NewtonIntegrator(),
]
O.dt = 1e-6
start = time.perf_counter()
O.run(4 * steps, True)
took = time.perf_counter() - start

overlap, up, down = np.array(rows).T
with open("path.csv", "w") as file:
    file.write("overlap_m\n" + "\n".join(repr(float(x)) for x in overlap) + "\n")
program = os.environ.get("PLATEN_PROGRAM", "platen")
command = [program, "eval", "law.toml", "-p", f"radius_m={R}", "--path", "path.csv"]
answer = subprocess.run(command, capture_output=True, text=True, check=True)
force = np.array([float(row["force_N"]) for row in csv.DictReader(answer.stdout.splitlines())])
scale = force.max()
print(f"{len(rows)} steps, largest force {scale:.6g} N, {1e6 * took / (4 * steps):.0f} us a step")
worst = max(np.abs(up - force).max(), np.abs(down - force).max()) / scale
print(f"worst difference from platen eval: {worst:.2g} of the largest force")
sys.exit(0 if worst < 1e-9 and len(rows) > 3 * steps else 1)
