"""Contact laws of Platen in Kratos DEM: normal forces of spheres of one size, with the memory of each contact.

The laws of Kratos are compiled into it, and Python cannot add one. So its own law is switched off in the materials file,
    "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME": "DEM_D_void"
and Platen's forces are given as EXTERNAL_APPLIED_FORCE before each step; Kratos integrates.

    class Stage(DEMAnalysisStage):
        def Initialize(self):
            super().Initialize()
            self.forces = PlatenForces(self.spheres_model_part, platen.Law.load("law.toml"), planes=[([0, 0, 0], [0, 0, 1])])
        def InitializeSolutionStep(self):
            super().InitializeSolutionStep()
            self.forces()

No friction. Walls are rigid planes, (a point, the normal towards the spheres); they may be moved between steps. A pair that
parts keeps its memory.
"""

from __future__ import annotations

from typing import Any

import KratosMultiphysics as Kratos
import numpy as np

import platen


class PlatenForces:
    def __init__(self, spheres: Any, law: platen.Law, planes: Any = (), skin: float = 0.2) -> None:
        """`spheres` is the model part, `planes` a list of (point, normal); `skin`, over the radius, is how far beyond contact
        pairs are listed: they are searched anew when something has moved half of it."""
        self.nodes = list(spheres.Nodes)
        radii = {round(node.GetSolutionStepValue(Kratos.RADIUS), 15) for node in self.nodes}
        if len(radii) != 1:
            raise platen.InvalidInput(f"the spheres have {len(radii)} radii; this engine is for one")
        self.radius = self.nodes[0].GetSolutionStepValue(Kratos.RADIUS)
        self.planes = [(np.array(point, dtype=float), np.array(normal, dtype=float)) for point, normal in planes]
        self.on_planes = [np.zeros(3) for _ in self.planes]
        """force on each plane [N]"""
        self._pair, self._plane = law.pair(radius=self.radius), law.on_plane(radius=self.radius)
        self._skin = skin * self.radius
        self._of_planes = [self._plane.new_state(len(self.nodes)) for _ in self.planes]
        self._state = self._pair.new_state(0)
        self._i = self._j = np.empty(0, dtype=int)
        self._where: Any = None  # when the pairs were listed

    def __call__(self) -> None:
        x = np.array([(node.X, node.Y, node.Z) for node in self.nodes])
        if self._where is None or np.max(np.abs(x - self._where)) > self._skin / 4:
            self._list_pairs(x)
        force = np.zeros_like(x)
        apart = x[self._j] - x[self._i]
        distance = np.sqrt(np.sum(apart**2, axis=1))
        size = self._pair.step(self._state, 2 * self.radius - distance, only=["force"]).force
        push = apart * (size / distance)[:, None]
        np.subtract.at(force, self._i, push)
        np.add.at(force, self._j, push)
        for k, (point, normal) in enumerate(self.planes):
            overlap = self.radius - (x - point) @ normal
            push = self._plane.step(self._of_planes[k], overlap, only=["force"]).force[:, None] * normal
            force += push
            self.on_planes[k] = -push.sum(axis=0)
        for node, (fx, fy, fz) in zip(self.nodes, force.tolist()):
            node.SetSolutionStepValue(Kratos.EXTERNAL_APPLIED_FORCE_X, fx)
            node.SetSolutionStepValue(Kratos.EXTERNAL_APPLIED_FORCE_Y, fy)
            node.SetSolutionStepValue(Kratos.EXTERNAL_APPLIED_FORCE_Z, fz)

    def contacts(self) -> int:
        return int(np.sum(self._state.overlap > 0))

    def _list_pairs(self, x: Any) -> None:
        """Pairs nearer than two radii and the skin, and those that ever touched, which keep their memory."""
        reach = 2 * self.radius + self._skin
        i, j = [], []
        for k in range(len(x) - 1):
            near = k + 1 + np.flatnonzero(np.sum((x[k + 1 :] - x[k]) ** 2, axis=1) < reach**2)
            i.append(np.full(len(near), k))
            j.append(near)
        met = self._state.largest_overlap > 0
        i, j = np.concatenate([self._i[met], *i]), np.concatenate([self._j[met], *j])
        _, first = np.unique(i * len(x) + j, return_index=True)
        i, j = i[first], j[first]
        before = {pair: row for row, pair in enumerate(zip(self._i.tolist(), self._j.tolist()))}
        origin = [before.get(pair, -1) for pair in zip(i.tolist(), j.tolist())]
        self._state = self._state.rebuilt(np.array(origin, dtype=int))
        self._i, self._j, self._where = i, j, x
