"""Contact laws: cards that say force, contact radius and unloading of a particle."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._cards import Record, key_of, parameter_text, write
from ._contact import Contact, floats
from ._errors import InvalidInput, IoError

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from ._press import Curve


class LawError(Record):
    """How far a law is from the curve that it was made from: [error] of its card."""

    @property
    def l2(self) -> float | None:
        """Relative L2 of the force over the loading; of a predicted law what is expected. None: not known."""
        value: float | None = self.get("relative_l2")
        return value


class Validity:
    """How far a law holds."""

    __slots__ = ("delta_bar", "words")

    def __init__(self, delta_bar: tuple[float, float] | None, words: str) -> None:
        self.delta_bar = delta_bar
        """smallest and largest delta/R; None: the card does not say"""
        self.words = words
        """what the law says of itself"""

    def __repr__(self) -> str:
        return f"<Validity delta/R {self.delta_bar}; {self.words}>"


class Law:
    """The law of a material: its parameters, how far it holds, and its error. It has no radius: `pair` and `on_plane` put
    particles in contact.

    >>> law = platen.Law.load("law.toml")
    >>> contact = law.pair(radius=0.5e-3)
    """

    __slots__ = ("_card", "curve", "near", "prediction")

    def __init__(
        self,
        card: _core.LawCard,
        curve: Curve | None = None,
        near: list[str] | None = None,
        prediction: Record | None = None,
    ) -> None:
        self._card = card
        self.curve = curve
        """the curve that it was fitted to, where it was made in this session"""
        self.near = near or []
        """of a predicted law: the materials that say most about it"""
        self.prediction = prediction
        """of a predicted law: pool, verdict, reasons, expected_error, and over delta_bar the curve F_bar with band_90, half the 90 %
        band of its logarithm, and a_bar; alpha and beta at unload_delta_bar; of rock F_y_over_F, a, b, m, n"""

    @classmethod
    def load(cls, what: str | os.PathLike[str]) -> Law:
        """A law card by path, or one of the catalogue by name."""
        return cls(_core.LawCard.find(os.fspath(what)))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the law card, which `platen` and the plug-in for LAMMPS read."""
        write(path, self.text)
        self._card.file = os.fspath(path)

    @property
    def name(self) -> str:
        """Which law: "pressed", "hertz", ..."""
        return self._card.law

    @property
    def variant(self) -> str:
        """Form of the law; empty: its default."""
        return self._card.variant

    @property
    def text(self) -> str:
        """The card as it stands in a file."""
        return self._card.text()

    @property
    def parameters(self) -> Record:
        """Numbers, lists and words under the keys of the card."""
        return Record({key: _value(text) for key, text in self._card.parameters.items()})

    @property
    def error(self) -> LawError:
        return LawError(self._card.errors)

    @property
    def valid(self) -> Validity:
        words = next(law["validity"] for law in _core.laws() if law["name"] == self.name)
        return Validity(self._card.delta_bar, words)

    @property
    def provenance(self) -> Record:
        """Where the law is from: [provenance] of its card."""
        return Record(self._card.provenance)

    def pair(self, radius: float, partner: Law | None = None, partner_radius: float | None = None) -> Contact:
        """Two spheres in contact, radii in m. Without `partner` the second is of the same material, without
        `partner_radius` as large; inf is a plane of that material."""
        arguments = {"radius": radius, "partner": partner, "partner_radius": partner_radius}
        one = _radius(radius, "radius")
        two = None if partner_radius is None else _radius(partner_radius, "partner_radius")
        if partner is not None and not isinstance(partner, Law):
            raise TypeError(f"partner is {type(partner).__name__}; it must be a Law")
        if partner is None or partner == self:
            core = _core.Contact.like_pair(self._card, one, two)
        else:
            core = _core.Contact.unlike_pair(self._card, one, partner._card, one if two is None else two)
        return Contact(core, (self, "pair", arguments))

    def on_plane(self, radius: float) -> Contact:
        """A sphere on a rigid plane, radius in m; the overlap is then the approach of its centre."""
        core = _core.Contact.on_plane(self._card, _radius(radius, "radius"))
        return Contact(core, (self, "on_plane", {"radius": radius}))

    def initial_yield(self, radius: float, *, against: str = "sphere", **partner: Any) -> Record:
        """Where a geomaterial (law "wang") starts to yield, two spheres of this radius [m] or, `against="plane"`, one on a rigid
        plane, as `platen laws wang -p`: F_y_N, force on the axis; gamma_y_m, approach of the centres; depth_over_a, depth of
        first yield over the contact radius; p0_Pa, peak pressure; F_y_edge_N, where the edge of the contact yields. `partner`
        says what is other of the second body: radius2, E2 [Pa], nu2."""
        more = {"radius_m": parameter_text("radius", _radius(radius, "radius"))}
        for keyword, value in partner.items():
            key = key_of(keyword, ("radius2_m", "E2_Pa", "nu2"))
            more[key] = parameter_text(key, value)
        if against not in ("sphere", "plane"):
            raise InvalidInput(f"against = {against!r} is neither sphere nor plane")
        if against == "plane":
            more["against"] = "plane"
        return Record(_core.initial_yield(self._card, more))

    def to_lammps(
        self,
        *others: Law,
        radius: float | Sequence[float],
        density: float | Sequence[float],
        delta_bar: float | None = None,
    ) -> str:
        """Input lines for `pair_style platen` with a stable time step. The laws must have been saved: LAMMPS reads the
        files. `others` are those of particle types 2, 3, ...; `radius` is that of the smallest particle of a type [m] and
        `density` its density [kg/m^3]: one number for all types, or one a type. `delta_bar` is the largest delta/R that
        will be reached; without it, as far as the laws hold."""
        laws = (self, *others)
        for law in laws:
            if not law._card.file:
                raise InvalidInput("this law is in no file yet, and LAMMPS reads it from one; law.save(path) writes it")
        return _core.lammps_lines(
            [law._card for law in laws],
            _each(radius, len(laws), "radius"),
            _each(density, len(laws), "density"),
            0.0 if delta_bar is None else float(delta_bar),
        )

    def to_dem_engine(self, folder: str | os.PathLike[str], *, restitution: float = 1.0, friction: float = 0.0) -> None:
        """Writes functions.cu, model.cu and platen_model.py: a force model with its memory, as source text for DEM-Engine.
        `restitution` of an elastic contact, in (0, 1], by viscous damping; `friction` is Coulomb's coefficient."""
        texts = _core.engine_model(self._card, float(restitution), float(friction))
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise IoError(f"{os.fspath(folder)}: the folder cannot be made: {error.strerror}") from error
        for name, text in zip(("functions.cu", "model.cu", "platen_model.py"), texts):
            write(os.path.join(os.fspath(folder), name), text)

    def to_parameters(self, *, radius: float, delta_bar: float = 0.0) -> Record:
        """The nearest laws of two numbers, as `platen export parameters`, for codes that take no more: two spheres of this
        radius [m], pressed to `delta_bar` (without it, as far as the card holds). `hertz`: E_Pa, nu, force_relative_l2;
        `springs`: k_1_N_per_m, k_2_N_per_m, force_relative_l2; `restitution`, sqrt(work given back/work spent) from there;
        `restitutions`, the same at other delta/R."""
        found = _core.two_parameters(self._card, _radius(radius, "radius"), float(delta_bar))
        return Record({key: Record(value) if isinstance(value, dict) else value for key, value in found.items()})

    def to_table(self, overlap: npt.ArrayLike, *, radius: float) -> str:
        """Force, stiffness, contact radius and unloading over `overlap` [m] of two spheres of this radius [m], as `platen export
        table`: for codes that take tables."""
        return _core.law_table(self._card, _radius(radius, "radius"), floats(overlap, "overlap").tolist())

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Force over overlap of one sphere on a plane without units, unloading and the fitted curve beside; needs
        matplotlib."""
        from ._plot import plot_law

        return plot_law(self, ax, **style)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self._card.identity == other._card.identity

    def __hash__(self) -> int:
        return hash(self._card.identity)

    def __reduce__(self) -> tuple[Any, ...]:
        return _law, (self.text, self._card.file, self.curve, self.near, self.prediction)

    def __repr__(self) -> str:
        return f"<Law {self._title()}>"

    def __str__(self) -> str:
        lines = [f"law {self._title()}"]
        for key, value in self.parameters.items():
            lines.append(f"  {key:<18} {_short(value)}")
        return "\n".join(lines)

    def _title(self) -> str:
        title = self.name + (f" ({self.variant})" if self.variant else "")
        if material := self.provenance.get("material"):
            title += f" of {material}"
        if self.error.l2 is not None:
            title += f", error {100 * self.error.l2:.2g} %"
        if self._card.delta_bar:
            title += ", for delta/R {:.4g} to {:.4g}".format(*self._card.delta_bar)
        return title

    def _repr_html_(self) -> str:
        from ._svg import law_html

        return law_html(self)


def _law(text: str, file: str, curve: Curve | None, near: list[str], prediction: Record | None = None) -> Law:
    card = _core.LawCard.parse(text, file or "a pickled law")
    card.file = file
    return Law(card, curve, near, prediction)


def law(name: str, variant: str = "", **parameters: Any) -> Law:
    """A law with parameters of one's own, in SI units: `platen.law("hertz", E=70e9, nu=0.3)`. Keys are those of
    `platen.laws()`; their units may be left out. Without parameters of its own it must be a card or a law that needs none.
    """
    known: list[dict[str, Any]] = next((entry["parameters"] for entry in _core.laws() if entry["name"] == name), [])
    keys = [parameter["key"] for parameter in known]
    texts = {}
    for keyword, value in parameters.items():
        key = key_of(keyword, keys)
        if key in texts:
            raise InvalidInput(f"{key} is given twice")
        texts[key] = parameter_text(key, value)
    return Law(_core.LawCard.make(name, variant, texts))


class LawInfo(Record):
    """What a law says about itself: name, title, source, validity, variants, parameters."""

    def __repr__(self) -> str:
        return f"<LawInfo {self['name']}: {self['title']}>"

    def __str__(self) -> str:
        lines = [f"{self['name']}: {self['title']}", f"  source    {self['source']}", f"  valid     {self['validity']}"]
        lines.append(f"  variants  {', '.join(self['variants'])}")
        for p in self["parameters"]:
            optional = "" if p["required"] else " (optional)"
            lines.append(f"  {p['key']:<17} {p.get('range', p.get('values', '')):<14} {p['meaning']}{optional}")
        return "\n".join(lines)


def laws() -> dict[str, LawInfo]:
    """Every law by its name, with source, validity and parameters."""
    return {entry["name"]: LawInfo(entry) for entry in _core.laws()}


def _radius(value: Any, name: str) -> float:
    if isinstance(value, (bool, str)) or not np.isscalar(value):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    number = float(value)  # type: ignore[arg-type]
    if not number > 0:
        raise InvalidInput(f"{name} = {number} must be above 0")
    return number


def _each(value: Any, count: int, name: str) -> list[float]:
    values = list(value) if isinstance(value, (list, tuple, np.ndarray)) else [value] * count
    if len(values) != count:
        raise InvalidInput(f"{name} has {len(values)} numbers; {count} types need one for all, or {count}")
    return [_radius(one, name) for one in values]


def _value(text: str) -> Any:
    parts = text.split(",")
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        return text
    return numbers[0] if len(numbers) == 1 else np.array(numbers)


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"{len(value)} numbers, {value[0]:.4g} to {value[-1]:.4g}" if len(value) > 4 else np.array2string(value)
    return f"{value:.6g}" if isinstance(value, float) else str(value)
