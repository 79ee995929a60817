"""Kratos DEM with Platen's law: two spheres that meet twice, beside the same steps in Python; granules in a square die, pressed.

examples.py    # in a folder of its own; platen, KratosMultiphysics and KratosDEMApplication installed
"""

import json
import pathlib
import sys
import time

import KratosMultiphysics as Kratos
import numpy as np
from KratosMultiphysics.DEMApplication.DEM_analysis_stage import DEMAnalysisStage
from platen_kratos import PlatenForces

import platen

R, density = 90e-6, 636.0
mass = density * 4 / 3 * np.pi * R**3
law = platen.Material.load("mcc-ph-200").predict()


def write_case(name, places, dt, end, own_law="DEM_D_void"):
    """Spheres of one material, with this law of Kratos."""
    relation = {"COEFFICIENT_OF_RESTITUTION": 1.0, "STATIC_FRICTION": 0.0, "DYNAMIC_FRICTION": 0.0, "FRICTION_DECAY": 500,
                "ROLLING_FRICTION": 0.0, "ROLLING_FRICTION_WITH_WALLS": 0.0,
                "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME": own_law}  # fmt: skip
    material = {"PARTICLE_DENSITY": density, "YOUNG_MODULUS": 4e8, "POISSON_RATIO": 0.15, "COMPUTE_WEAR": False}
    pathlib.Path("MaterialsDEM.json").write_text(json.dumps({
        "materials": [{"material_name": "granule", "material_id": 1, "Variables": material}],
        "material_relations": [{"material_names_list": ["granule"] * 2, "material_ids_list": [1, 1], "Variables": relation}],
        "material_assignation_table": [["SpheresPart.DEMParts_Body", "granule"]]}))  # fmt: skip
    numbers = range(1, len(places) + 1)
    blocks = {
        "Properties 0": "",
        "Nodes": "".join(f"{n} {x!r} {y!r} {z!r}\n" for n, (x, y, z) in zip(numbers, places)),
        "Elements SphericParticle3D": "".join(f"{n} 0 {n}\n" for n in numbers),
        "NodalData RADIUS": "".join(f"{n} 0 {R!r}\n" for n in numbers),
    }
    text = "".join(f"Begin {head}\n{body}End {head.split()[0]}\n" for head, body in blocks.items())
    listed = "".join(f"{n}\n" for n in numbers)
    text += f"Begin SubModelPart DEMParts_Body\nBegin SubModelPartNodes\n{listed}End SubModelPartNodes\n"
    text += f"Begin SubModelPartElements\n{listed}End SubModelPartElements\nEnd SubModelPart\n"
    pathlib.Path(f"{name}DEM.mdpa").write_text(text)
    for other in ("DEM_FEM_boundary", "DEM_Inlet", "DEM_Clusters"):
        pathlib.Path(f"{name}{other}.mdpa").write_text("Begin Properties 0\nEnd Properties\n")
    return Kratos.Parameters(json.dumps({
        "problem_name": name, "FinalTime": end, "MaxTimeStep": dt, "GravityZ": 0.0, "dem_inlet_option": False,
        "do_print_results_option": False, "TranslationalIntegrationScheme": "Symplectic_Euler", "GlobalDamping": 0.0,
        "solver_settings": {"RemoveBallsInitiallyTouchingWalls": False, "strategy": "sphere_strategy",
                            "material_import_settings": {"materials_filename": "MaterialsDEM.json"}}}))  # fmt: skip


class TwoSpheres(DEMAnalysisStage):
    """They meet, part, are thrown at each other again, faster."""

    def Initialize(self):
        super().Initialize()
        self.forces, self.rows = PlatenForces(self.spheres_model_part, law), []

    def InitializeSolutionStep(self):
        super().InitializeSolutionStep()
        one, two = self.spheres_model_part.Nodes
        if len(self.rows) in throws:
            one.SetSolutionStepValue(Kratos.VELOCITY_X, throws[len(self.rows)])
            two.SetSolutionStepValue(Kratos.VELOCITY_X, -throws[len(self.rows)])
        self.forces()
        self.rows.append((one.X, two.X, two.GetSolutionStepValue(Kratos.EXTERNAL_APPLIED_FORCE_X)))


class Die(DEMAnalysisStage):
    """Six planes, the upper one comes down to a packing of 75 %."""

    def Initialize(self):
        super().Initialize()
        x, y, z = np.eye(3)
        sides = [([0, 0, 0], x), ([side, 0, 0], -x), ([0, 0, 0], y), ([0, side, 0], -y), ([0, 0, 0], z), ([0, 0, side], -z)]
        self.forces, self.curve = PlatenForces(self.spheres_model_part, law, planes=sides), []
        self.steps = 0

    def InitializeSolutionStep(self):
        super().InitializeSolutionStep()
        self.bed = [(node.X, node.Y, node.Z) for node in self.spheres_model_part.Nodes]
        upper = self.forces.planes[5][0]
        upper[2] -= speed * dt
        self.forces()
        self.steps += 1
        if self.steps % 10 == 0:
            self.curve.append((solid / (side**2 * upper[2]), self.forces.on_planes[5][2] / side**2))


class AtRest(DEMAnalysisStage):
    """The pressed bed once more, for what a step costs; with Platen's law where that of Kratos is off."""

    def Initialize(self):
        super().Initialize()
        self.forces, self.times = PlatenForces(self.spheres_model_part, law), []

    def InitializeSolutionStep(self):
        super().InitializeSolutionStep()
        if self.platen:
            self.forces()
        self.times.append(time.perf_counter())


dt, throws = 2e-8, {0: 0.5, 4000: 2.0}
stage = TwoSpheres(Kratos.Model(), write_case("two", [(-1.01 * R, 0.0, 0.0), (1.01 * R, 0.0, 0.0)], dt, 8000 * dt))
stage.Run()
rows = np.array(stage.rows)
contact, own = law.pair(radius=R), []
state, x, v = contact.new_state(1), np.array([-1.01 * R, 1.01 * R]), np.zeros(2)
for k in range(len(rows)):
    if k in throws:
        v = np.array([throws[k], -throws[k]])
    force = contact.step(state, [2 * R - (x[1] - x[0])]).force[0]
    own.append((*x, force))
    v = v + dt * np.array([-force, force]) / mass
    x = x + dt * v
worst = np.max(np.abs(rows - own) / np.max(np.abs(own), axis=0))
print(f"two spheres: {len(rows)} steps, largest force {rows[:, 2].max():.4g} N, worst difference {worst:.1e}")

per_side, speed = 4, 5.0
side, solid = 2.1 * per_side * R, per_side**3 * 4 / 3 * np.pi * R**3
random = np.random.default_rng(1)
places = [tuple((np.array(at) + 0.5) * 2.1 * R + random.uniform(-0.04 * R, 0.04 * R, 3)) for at in np.ndindex(*(per_side,) * 3)]
travel = side - solid / (0.75 * side**2)
start = time.perf_counter()
die = Die(Kratos.Model(), write_case("die", [tuple(map(float, place)) for place in places], dt, travel / speed))
die.Run()
packing, pressure = np.array(die.curve).T
contacts = die.forces.contacts()
print(f"die: {per_side**3} granules, {10 * len(packing)} steps in {time.perf_counter() - start:.0f} s; "
      f"{pressure[-1] / 1e6:.2f} MPa at packing {packing[-1]:.3f}, {contacts} contacts between granules")  # fmt: skip

for name, own_law in (("platen", "DEM_D_void"), ("Kratos's Hertz", "DEM_D_Hertz_viscous_Coulomb")):
    rest = AtRest(Kratos.Model(), write_case("rest", die.bed, dt, 200 * dt, own_law))
    rest.platen = own_law == "DEM_D_void"
    rest.Run()
    print(f"{name}: {1e6 * float(np.median(np.diff(rest.times))) / contacts:.2f} us a contact and step")
quarter = len(pressure) // 4
sys.exit(0 if worst < 1e-9 and pressure[-quarter:].mean() > 2 * pressure[:quarter].mean() and 2e6 < pressure[-1] < 8e6 else 1)
