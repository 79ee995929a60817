"""What instruments measured: files read, laws fitted and calibrated."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from . import _core
from ._cards import Record, key_of, parameter_text, tell, write
from ._errors import InvalidInput
from ._law import Law
from ._press import Curve

Path = str | os.PathLike[str]


def _diameter(radius: float | None, diameter: float | None) -> float | None:
    if radius is not None and diameter is not None:
        raise InvalidInput("give radius or diameter, not both")
    value = diameter if radius is None else 2 * float(radius)
    if value is not None and not 0 < value < float("inf"):
        raise InvalidInput(f"the diameter {value} m must be a number > 0")
    return value


class Measurement:
    """A file of a testing machine, read: `curve` has the columns particle, diameter_m, time_s, travel_m, force_N,
    branch; `particles` says of each where its contact begins; `found` what was found in the file."""

    __slots__ = ("curve", "file", "found", "machine", "particles", "read_as")

    def __init__(self, read: dict[str, Any]) -> None:
        self.file: str = read["file"]
        self.read_as: str = read["read_as"]
        self.found: list[str] = read["found"]
        self.machine: str = read["machine"]
        self.particles = [Record(particle) for particle in read["particles"]]
        self.curve = Curve(read["text"])

    def save(self, path: Path) -> None:
        """As `platen import` writes it; `fit` and `calibrate` read it."""
        write(path, self.curve.text)

    def __repr__(self) -> str:
        return f"<Measurement {self.file}: {len(self.particles)} particles, {len(self.curve)} rows>"

    def __str__(self) -> str:
        lines = [f"{self.file}: {self.read_as}", *(f"  {sentence}" for sentence in self.found)]
        for p in self.particles:
            size = "diameter not in the file" if p.diameter_m is None else f"d = {1e3 * p.diameter_m:.4g} mm"
            broken = "; broken" if p.broken else ""
            lines.append(f"{p.name}: {size}, {p.rows} rows; {p.words}{broken}")
        return "\n".join(lines)


def import_curve(
    file: Path,
    *,
    force: str = "",
    displacement: str = "",
    displacement_is: str = "",
    radius: float | None = None,
    diameter: float | None = None,
    compliance: float | None = None,
    empty_machine: Path = "",
) -> Measurement:
    """Reads a file of an instrument, text in columns as it was exported.

    `force` and `displacement` name a column, "COLUMN" or "COLUMN:UNIT", where the words of the file do not tell it;
    `displacement_is` is "travel" (between the platens) or "contact" (of one platen); `radius` or `diameter` of the
    particle [m]; `compliance` of the machine [m/N], or a file measured with `empty_machine`."""
    read = _core.ReadOptions(force, displacement, displacement_is, _diameter(radius, diameter))
    return Measurement(_core.import_curve(os.fspath(file), read, compliance, os.fspath(empty_machine)))


def fit(
    curve: Curve | Path,
    law: str = "pressed",
    *,
    variant: str = "published",
    sigma_ref: float | None = None,
    E: float | None = None,
    nu: float | None = None,
    phi: float | None = None,
    sigma_c: float | None = None,
    inverse_m: float | None = None,
    radius: float | None = None,
    diameter: float | None = None,
    force: str = "",
    displacement: str = "",
    displacement_is: str = "",
    compliance: float | None = None,
    empty_machine: Path = "",
    despite_doubts: bool = False,
) -> Law:
    """A law fitted to a curve: "pressed", "edmans-sinka", "wang", "agarwal" or "shahin". The curve is a `Curve`, a
    curve.csv, or a file of an instrument (its keywords are those of `import_curve`).

    What a measured curve does not say of its material: reference stress `sigma_ref`, `E`, `sigma_c` [Pa], `nu`, `phi`
    [degrees], `inverse_m`. What cannot be believed of a measurement is refused, unless `despite_doubts`."""
    size = _diameter(radius, diameter)
    read = _core.ReadOptions(force, displacement, displacement_is, size)
    file, text = ("the curve", curve.text) if isinstance(curve, Curve) else (os.fspath(curve), "")
    card, said = _core.fit(file, text, read, compliance, os.fspath(empty_machine), law, variant, sigma_ref, E, nu, phi,
                           sigma_c, inverse_m, despite_doubts)  # fmt: skip
    tell(said)
    shown = curve if isinstance(curve, Curve) else None
    return Law(card, shown)


class Calibration(Record):
    """A law from measured particles: `law`, `parameters` and their `standard_errors`, `correlations`, `particles`, `R2`,
    `broken`, `remarks`, `doubts`; printed as `platen calibrate` prints it."""

    def __str__(self) -> str:
        return str(self["words"])

    def __repr__(self) -> str:
        found = ", ".join(f"{key} = {value:.4g}" for key, value in self["parameters"].items())
        return f"<Calibration {self['law'].name}: {found}; R2 {self['R2']:.4f}>"


def calibrate(
    files: Path | Sequence[Path],
    law: str,
    *,
    variant: str = "",
    radius: float | Sequence[float] | None = None,
    diameter: float | Sequence[float] | None = None,
    force: str = "",
    displacement: str = "",
    displacement_is: str = "",
    compliance: float | None = None,
    empty_machine: Path = "",
    despite_doubts: bool = False,
    **known: Any,
) -> Calibration:
    """A law from measured particles, contact point of each included; all particles of all files. `known` are parameters
    that the curves cannot show or that are known: `nu=0.3`, `E=...` [Pa]. Laws: `platen.CALIBRATED_LAWS`."""
    names = [os.fspath(files)] if isinstance(files, (str, os.PathLike)) else [os.fspath(file) for file in files]
    if not names:
        raise InvalidInput("there is no file to calibrate from")
    if radius is not None and diameter is not None:
        raise InvalidInput("give radius or diameter, not both")
    sizes: list[Any] = list(_each(diameter if radius is None else radius, len(names)))
    reads = [
        _core.ReadOptions(force, displacement, displacement_is,
                          _diameter(size, None) if radius is not None else _diameter(None, size))
        for size in sizes
    ]  # fmt: skip
    keys = [p["key"] for entry in _core.laws() if entry["name"] == law for p in entry["parameters"]]
    given = {(key := key_of(keyword, keys)): parameter_text(key, value) for keyword, value in known.items()}
    found = _core.calibrate(names, reads, compliance, os.fspath(empty_machine), law, variant, given, despite_doubts)
    found["law"] = Law(found.pop("card"))
    tell(f"doubted: {doubt}" for doubt in found["doubts"])
    return Calibration(found)


def _each(value: float | Sequence[float] | None, count: int) -> list[Any]:
    if value is None or isinstance(value, (int, float)):
        return [value] * count
    values = list(value)
    if len(values) != count:
        raise InvalidInput(f"{len(values)} sizes for {count} files; give one for all, or one for each")
    return values
