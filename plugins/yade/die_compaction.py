"""Granules in a square die of YADE, pressed by a punch to a packing of 80 % by Platen's law: pressure over packing, and what
a step costs beside YADE's own Hertz-Mindlin law in the same bed.

yade -n -x die_compaction.py [PER_SIDE]   # platen and this folder on PYTHONPATH; PER_SIDE^3 granules, 4 by default
"""

import sys
import time

import numpy as np
from platen_yade import PlatenForces
from yade import utils
from yade.wrapper import *

import platen

per_side = int(sys.argv[-1]) if sys.argv[-1].isdigit() else 4
R, density, speed, mu, last = 90e-6, 636.0, 5.0, 0.2, 0.8
count, side = per_side**3, 2.1 * per_side * R
solid = count * 4 / 3 * np.pi * R**3
law = platen.Material.load("mcc-ph-200").predict()

O.materials.append(FrictMat(density=density, young=4e8, poisson=0.15, frictionAngle=np.arctan(mu)))
random = np.random.default_rng(1)
for place in np.ndindex(per_side, per_side, per_side):
    at = (np.array(place) + 0.5) * 2.1 * R + random.uniform(-0.04 * R, 0.04 * R, 3)
    O.bodies.append(utils.sphere(tuple(at), R))
walls = [O.bodies.append(utils.wall(where, axis=axis, sense=0)) for axis in (0, 1) for where in (0, side)]
lower = O.bodies.append(utils.wall(0, axis=2, sense=0))
upper = O.bodies.append(utils.wall(side, axis=2, sense=0))
O.bodies[upper].state.vel = (0, 0, -speed)

forces = PlatenForces(law, O)
curve = []


def note():
    height = O.bodies[upper].state.pos[2]
    curve.append((solid / (side**2 * height), O.forces.f(upper)[2] / side**2, -O.forces.f(lower)[2] / side**2))
    if curve[-1][0] >= last:
        O.pause()


def loop(physics, law2):
    return InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [physics], [law2])


def engines(*laws):
    collider = InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=0.1 * R)
    return [ForceResetter(), collider, *laws, NewtonIntegrator(damping=0.1)]


O.engines = engines(loop(Ip2_FrictMat_FrictMat_FrictPhys(), Law2_ScGeom_FrictPhys_CundallStrack()),
                    PyRunner(command="forces()", iterPeriod=1), PyRunner(command="note()", iterPeriod=20))  # fmt: skip
O.dt = forces.time_step(density, delta_bar=0.1)
start = time.perf_counter()
O.run(1_000_000, True)
packing, top, bottom = np.array(curve).T
contacts = sum(i.isReal for i in O.interactions)
print(f"{count} granules, {O.iter} steps in {time.perf_counter() - start:.0f} s; at packing {packing[-1]:.3f} "
      f"{top[-1] / 1e6:.2f} MPa on the punch, {bottom[-1] / 1e6:.2f} MPa below, {contacts} contacts")  # fmt: skip
np.savetxt("compaction.txt", np.array(curve), header="packing pressure_upper_Pa pressure_lower_Pa")

# what a step of this bed costs, at rest
O.bodies[upper].state.vel = (0, 0, 0)
O.dt *= 1e-6
costs = {}
own = [loop(Ip2_FrictMat_FrictMat_MindlinPhys(), Law2_ScGeom_MindlinPhys_Mindlin())]
for name, made in (("platen", O.engines[2:4]), ("YADE's Hertz-Mindlin", own)):
    O.interactions.clear()
    O.engines = engines(*made)
    O.run(5, True)
    start = time.perf_counter()
    O.run(200, True)
    costs[name] = (time.perf_counter() - start) / 200 / contacts
    print(f"{name}: {1e6 * costs[name]:.2f} us a contact and step")
quarter = len(curve) // 4
good = top[-quarter:].mean() > 2 * top[:quarter].mean() and 4e6 < top[-1] < 8e6 and 0.6 < bottom[-1] / top[-1] <= 1.05
sys.exit(0 if good else 1)
