"""Laws and curves side by side."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from . import _core
from ._cards import Record, key_of, parameter_text, records, tell
from ._errors import InvalidInput
from ._law import Law
from ._material import Material
from ._press import Curve

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Item = Law | Curve | str | os.PathLike[str]
_COLUMNS = [("above_delta_bar", "f8"), ("to_delta_bar", "f8"), ("law", "U"), ("rank", "i8"), ("force", "f8"), ("radius", "f8"),
            ("stiffness", "f8"), ("lost_work", "f8"), ("in_range", "f8")]  # fmt: skip


class Comparison:
    """How far laws and curves are from a reference curve; printed as `platen compare` prints it."""

    __slots__ = ("delta_m", "radius", "reference", "table", "traces", "_words")

    def __init__(self, found: dict[str, Any]) -> None:
        self.table = records(found["rows"], _COLUMNS)
        """one row for each range of delta/R and each item: above_delta_bar, to_delta_bar, law, rank (1 is nearest by force; 0: it
        says nothing there), relative L2 deviations of force, radius and stiffness, lost_work (difference over the work spent),
        in_range (fraction inside the validity of the law)"""
        self.delta_m = found["delta_m"]
        """overlaps of the reference [m]"""
        self.reference = Record(found["reference"])
        """name, force_N, contact_radius_m at delta_m, lost_work_J"""
        self.traces = [Record(trace) for trace in found["traces"]]
        """the same of each item"""
        self.radius: float = found["radius_m"]
        """of the particle [m]"""
        self._words: str = found["words"]

    @property
    def ranking(self) -> list[str]:
        """Names in the last range, nearest first."""
        last = self.table[self.table["to_delta_bar"] == self.table["to_delta_bar"].max()]
        ranked = last[last["rank"] > 0]
        return [str(name) for name in ranked["law"][ranked["rank"].argsort()]]

    def plot(self, ax: Axes | None = None) -> Axes:
        """Force over delta/R of the loading; needs matplotlib."""
        from ._plot import plot_comparison

        return plot_comparison(self, ax)

    def __str__(self) -> str:
        return self._words

    def __repr__(self) -> str:
        return f"<Comparison with {self.reference['name']}: {', '.join(self.ranking)}>"

    def _repr_html_(self) -> str:
        from ._svg import table_html

        names = [name for name, _ in _COLUMNS]
        rows = [tuple(names)] + [tuple(_cell(value) for value in row) for row in self.table.tolist()]
        return table_html(f"beside {self.reference['name']}", rows)


def compare(
    reference: Curve | str | os.PathLike[str],
    laws: Item | Iterable[Item] | Mapping[str, Item],
    *,
    material: Material | str | None = None,
    ranges: Iterable[float] = (),
    radius: float | None = None,
    picture: str | os.PathLike[str] = "",
    title: str = "",
    **parameters: Any,
) -> Comparison:
    """How far laws, or other curves, are from a curve, on a rigid plane.

    `laws` is one, a list, or a dictionary of names: a `Law`, a `Curve`, the path of a card or of a curve (.csv), or the name of
    a law, also "LAW/VARIANT". What such a law needs it takes from its card, else from the curve, the `material` and
    `parameters` (keys of `platen.laws()`, in SI). `ranges` are ends of ranges of delta/R that are ranked one by one; `radius`
    [m] is that of measured curves. `picture` draws what `platen compare` draws, .svg or .png, under a `title`; it needs
    gnuplot."""
    text, label = _curve(reference, radius)
    items: list[tuple[str, Any]] = []
    for i, (name, item) in enumerate(_named(laws)):
        if isinstance(item, Law):
            items.append((name or _free(item.name, items), item._card))
        elif isinstance(item, Curve) or os.fspath(item).endswith(".csv"):
            curve, file = _curve(item, radius)
            items.append((name or (file if file != "the curve" else f"curve {i + 1}"), curve))
        else:
            items.append((name or os.fspath(item), _card(os.fspath(item))))
    if isinstance(material, str):
        material = Material.load(material)
    known = {p["key"] for entry in _core.laws() for p in entry["parameters"]}
    texts = {(key := key_of(keyword, known)): parameter_text(key, value) for keyword, value in parameters.items()}
    found = _core.compare(text, label, radius, items, material._card if material else None, texts,
                          [float(end) for end in ranges], os.fspath(picture), title)  # fmt: skip
    tell(found["warnings"])
    return Comparison(found)


def _named(laws: Any) -> list[tuple[str, Item]]:
    if isinstance(laws, Mapping):
        return [(str(name), item) for name, item in laws.items()]
    if isinstance(laws, (Law, Curve, str, os.PathLike)):
        return [("", laws)]
    return [("", item) for item in laws]


def _free(name: str, items: list[tuple[str, Any]]) -> str:
    taken = {other for other, _ in items}
    numbered = (f"{name} {i}" for i in range(2, len(items) + 3))
    return name if name not in taken else next(other for other in numbered if other not in taken)


def _card(what: str) -> _core.LawCard:
    name, slash, variant = what.partition("/")
    if slash and not os.path.exists(what) and not what.endswith(".toml"):
        return _core.LawCard.variant_of(name, variant)
    return _core.LawCard.find(what)


def _curve(curve: Any, radius: float | None) -> tuple[str, str]:
    if isinstance(curve, Curve):
        return curve.text, "the curve"
    if not isinstance(curve, (str, os.PathLike)):
        raise TypeError(f"{type(curve).__name__} is no curve; give a Curve, or the path of one")
    file = os.fspath(curve)
    if not file.endswith(".csv"):
        raise InvalidInput(f"{file} is no curve; compare needs one to compare with, a .csv")
    return Curve.load(file, radius=radius).text, file


def _cell(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
