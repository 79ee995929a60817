"""Contact laws of Platen in YADE: normal forces of spheres, with the memory of each contact.

Debian's YADE has no headers, so this is an engine in Python beside a law of YADE: `InteractionLoop` finds contacts and does
the friction, with any `Law2_ScGeom_*` that keeps a normal force and a stiffness kn, and this puts Platen's normal force in
the place of its own. kn becomes the secant stiffness, so that friction and the tangential stiffness follow, one step late.

    from platen_yade import PlatenForces
    forces = PlatenForces(platen.Law.load("law.toml"))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                        [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
        PyRunner(command="forces()", iterPeriod=1),
        NewtonIntegrator(damping=0.1),
    ]

What is no sphere is a rigid plane. A pair that parts keeps its memory; radii do not change. Contacts are made for each two
radii that meet: few sizes are quick, a continuous distribution is not. Of the material in YADE only the friction angle
counts.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import platen


class _Kind:
    """All contacts of two radii and laws: who they are, and what they remember."""

    def __init__(self, contact: platen.Contact) -> None:
        self.contact = contact
        self.state = contact.new_state(0)
        self.index: dict[tuple[int, int], int] = {}

    def rows(self, pairs: list[tuple[int, int]]) -> list[int]:
        """Where the pairs stand in the state; new ones are added."""
        before = len(self.index)
        rows = [self.index.setdefault(pair, len(self.index)) for pair in pairs]
        if len(self.index) > before:
            self.state = self.state.rebuilt([*range(before), *[-1] * (len(self.index) - before)])
        return rows


class PlatenForces:
    """The engine. `laws` is one law for all, or a law for each material id of YADE."""

    def __init__(self, laws: platen.Law | dict[int, platen.Law], omega: Any = None) -> None:
        if omega is None:
            from yade import O as omega
        self._O = omega
        self._laws = laws
        self._kinds: dict[tuple[Any, ...], _Kind] = {}
        self._kind_of: dict[tuple[int, int], _Kind] = {}

    def __call__(self) -> None:
        """Of one step, after `InteractionLoop`."""
        gathered: dict[_Kind, tuple[list[Any], list[tuple[int, int]]]] = {}
        for i in self._O.interactions:
            if not i.isReal:
                continue
            pair = (i.id1, i.id2)
            kind = self._kind_of.get(pair)
            if kind is None:
                kind = self._kind_of[pair] = self._kind(self._key(i))
            interactions, pairs = gathered.setdefault(kind, ([], []))
            interactions.append(i)
            pairs.append(pair)
        for kind, (interactions, pairs) in gathered.items():
            self._push(kind, interactions, pairs)

    def overlap_max(self) -> dict[tuple[int, int], float]:
        """Largest overlap of every pair so far [m]."""
        found = {}
        for kind in self._kinds.values():
            largest = kind.state.largest_overlap
            found.update({pair: float(largest[row]) for pair, row in kind.index.items()})
        return found

    def time_step(self, density: float, delta_bar: float = 0.1) -> float:
        """A tenth of the stability limit 2 sqrt(m/8k) of the smallest sphere, k its stiffness at unloading from that
        delta/R [s]."""
        radii = [body.shape.radius for body in self._O.bodies if body and hasattr(body.shape, "radius")]
        R = min(radii)
        k = 0.0
        for law in self._laws.values() if isinstance(self._laws, dict) else [self._laws]:
            contact = law.pair(radius=R)
            top = delta_bar / contact.delta_bar_per_overlap
            k = max(k, *np.asarray(contact([top, top * (1 - 1e-6)]).stiffness))
        return 0.1 * 2 * float(np.sqrt(density * 4 / 3 * np.pi * R**3 / (8 * k)))

    def _push(self, kind: _Kind, interactions: list[Any], pairs: list[tuple[int, int]]) -> None:
        geometry = [i.geom for i in interactions]
        overlap = np.array([g.penetrationDepth for g in geometry])
        rows = kind.rows(pairs)
        everyone = kind.state.overlap
        everyone[:] = np.minimum(everyone, 0)  # those that YADE does not list are apart
        everyone[rows] = overlap
        force = kind.contact.step(kind.state, everyone, only=["force"]).force[rows]
        add = self._O.forces.addF
        for i, g, (one, two), f, u in zip(interactions, geometry, pairs, force.tolist(), overlap.tolist()):
            physics = i.phys
            ours = f * g.normal
            more = ours - physics.normalForce
            add(one, -more)
            add(two, more)
            physics.normalForce = ours
            if u > 0 and f > 0:
                kn = physics.kn
                ratio = physics.ks / kn if kn > 0 else 0.0
                physics.kn = f / u
                physics.ks = ratio * f / u

    def _key(self, i: Any) -> tuple[Any, ...]:
        """Radii and laws of the two bodies; None for a plane."""
        sides = []
        for number in (i.id1, i.id2):
            body = self._O.bodies[number]
            radius = getattr(body.shape, "radius", None)
            sides.append(None if radius is None else (radius, body.mat.id if isinstance(self._laws, dict) else 0))
        return tuple(sides)

    def _kind(self, key: tuple[Any, ...]) -> _Kind:
        if key not in self._kinds:
            spheres = [(radius, self._laws[material] if isinstance(self._laws, dict) else self._laws)
                       for radius, material in (side for side in key if side is not None)]  # fmt: skip
            if len(spheres) == 2:
                (R1, one), (R2, two) = spheres
                contact = one.pair(radius=R1, partner=two, partner_radius=R2)
            else:
                (R, law), = spheres  # fmt: skip
                contact = law.on_plane(radius=R)
            self._kinds[key] = _Kind(contact)
        return self._kinds[key]
