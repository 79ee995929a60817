"""What instruments measured: files read, laws fitted and calibrated."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from . import _core
from ._cards import Record, key_of, parameter_text, records, tell, write
from ._contact import floats
from ._errors import InvalidInput
from ._law import Law
from ._material import Material
from ._press import Curve, bar_of
from ._study import processes

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
    picture: Path = "",
) -> Measurement:
    """Reads a file of an instrument, text in columns as it was exported.

    `force` and `displacement` name a column, "COLUMN" or "COLUMN:UNIT", where the words of the file do not tell it;
    `displacement_is` is "travel" (between the platens) or "contact" (of one platen); `radius` or `diameter` of the
    particle [m]; `compliance` of the machine [m/N], or a file measured with `empty_machine`. `picture` draws what
    was measured, found in it and left corrected, .svg or .png; it needs gnuplot."""
    read = _core.ReadOptions(force, displacement, displacement_is, _diameter(radius, diameter))
    return Measurement(_core.import_curve(os.fspath(file), read, compliance, os.fspath(empty_machine), os.fspath(picture)))


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
    picture: Path = "",
) -> Law:
    """A law fitted to a curve: "pressed", "edmans-sinka", "wang", "agarwal" or "shahin". The curve is a `Curve`, a
    curve.csv, or a file of an instrument (its keywords are those of `import_curve`).

    What a measured curve does not say of its material: reference stress `sigma_ref`, `E`, `sigma_c` [Pa], `nu`, `phi`
    [degrees], `inverse_m`. What cannot be believed of a measurement is refused, unless `despite_doubts`. `picture`
    draws curve, law and residual, .svg or .png, of "edmans-sinka" and "wang"; it needs gnuplot."""
    size = _diameter(radius, diameter)
    read = _core.ReadOptions(force, displacement, displacement_is, size)
    file, text = ("the curve", curve.text) if isinstance(curve, Curve) else (os.fspath(curve), "")
    card, said = _core.fit(file, text, read, compliance, os.fspath(empty_machine), law, variant, sigma_ref, E, nu, phi,
                           sigma_c, inverse_m, despite_doubts, os.fspath(picture))  # fmt: skip
    tell(said)
    shown = curve if isinstance(curve, Curve) else None
    return Law(card, shown)


class Calibration(Record):
    """A law, or a material, from measured particles: `law` (of a material: the one that it would have), `material`, `parameters`,
    their `standard_errors` and, without what is not known of the law, `standard_errors_of_noise`, `correlations`, `profiles`
    (low and high end of the interval of 95 %, None where it is open; value, deviance), `particles`, `R2`, `delta_bar_max`,
    `broken`, `remarks`, `doubts`, `told`, `told_forces`, `confined`; printed as `platen calibrate` prints it."""

    def __str__(self) -> str:
        return str(self["words"])

    def __repr__(self) -> str:
        found = ", ".join(f"{key} = {value:.4g}" for key, value in self["parameters"].items())
        of = self["law"].name if self["material"] is None else self["material"].model
        return f"<Calibration {of}: {found}; R2 {self['R2']:.4f}>"


def calibrate(
    files: Path | Sequence[Path],
    law: str = "",
    *,
    material: Path = "",
    free: Sequence[str] = (),
    variant: str = "",
    radius: float | Sequence[float] | None = None,
    diameter: float | Sequence[float] | None = None,
    force: str = "",
    displacement: str = "",
    displacement_is: str = "",
    compliance: float | None = None,
    empty_machine: Path = "",
    despite_doubts: bool = False,
    by_presses: bool = False,
    store: Path = "out/calibration",
    workers: int | None = None,
    progress: bool | Callable[[str], Any] = False,
    profiles: bool | Path = False,
    confined: bool | Path = False,
    asked: Mapping[str, Any] | None = None,
    picture: Path = "",
    **known: Any,
) -> Calibration:
    """A law from measured particles, contact point of each included; all particles of all files. `known` are parameters
    that the curves cannot show or that are known: `nu=0.3`, `E=...` [Pa]. Laws: `platen.CALIBRATED_LAWS`.

    Or a `material` instead: "elastic", "von-mises", "vmdc", or the card of a similar one, by path or name; `free` are its keys
    that are looked for, by default strength and E. Its curves are those of the catalogue's pools or, `by_presses`, of a few
    presses, minutes, kept in `store`, in `workers` processes; `progress` is called with a sentence each.

    `profiles`: the likelihood of every parameter, drawn where it is the path of a picture. `confined`, of the laws "agarwal" and
    "shahin": what the particle would do in a die and from all sides, with bands, written where it is a path, .svg, .png or .csv.
    `asked`: for a driver of its own, a list of values for each free parameter; `told` is then a structured array, a row a set:
    its parameters, deviance, R2, relative_l2, and `told_forces` the forces of each set and particle [N]. `picture` draws what
    was measured, cut, corrected and fitted. Pictures need gnuplot."""
    names = [os.fspath(files)] if isinstance(files, (str, os.PathLike)) else [os.fspath(file) for file in files]
    if not names:
        raise InvalidInput("there is no file to calibrate from")
    if radius is not None and diameter is not None:
        raise InvalidInput("give radius or diameter, not both")
    wish = _wish(law, os.fspath(material), known)
    if (free or by_presses) and not wish.material:
        raise InvalidInput(f"{'free' if free else 'by_presses'} is for a material")
    if variant and wish.material:
        raise InvalidInput("variant is for a law")
    wish.variant, wish.free, wish.by_presses = variant, [_free_key(key) for key in free], by_presses
    wish.store, wish.workers, wish.despite_doubts = os.fspath(store), processes(workers), despite_doubts
    wish.profiles, wish.confined = profiles is not False, confined is not False
    wish.profiles_picture, wish.confined_file, wish.picture = _path(profiles), _path(confined), os.fspath(picture)
    wish.asked = {_free_key(key): floats(values, key).reshape(-1).tolist() for key, values in (asked or {}).items()}
    sizes: list[Any] = list(_each(diameter if radius is None else radius, len(names)))
    reads = [
        _core.ReadOptions(force, displacement, displacement_is,
                          _diameter(size, None) if radius is not None else _diameter(None, size))
        for size in sizes
    ]  # fmt: skip
    with bar_of("calibrating", progress, lambda bar: bar.say) as callback:
        found = _core.calibrate(names, reads, compliance, os.fspath(empty_machine), wish, callback)
    return _calibration(found)


def _wish(law: str, material: str, known: dict[str, Any]) -> _core.Wish:
    """A law or a material; as in the command `law` may name a model of material."""
    if law and material:
        raise InvalidInput(f"law {law!r} and material {material!r}: give one of the two")
    if law in _core.material_models:
        law, material = "", law
    if not law and not material:
        raise InvalidInput("law is required, or material")
    wish = _core.Wish()
    wish.law, wish.material = law, material
    keys = [p["key"] for entry in _core.laws() if entry["name"] == law for p in entry["parameters"]] or _core.material_parameters
    wish.given = {(key := key_of(keyword, keys)): parameter_text(key, value) for keyword, value in known.items()}
    return wish


def _calibration(found: dict[str, Any]) -> Calibration:
    found["law"] = Law(found.pop("card"))
    if found["material"] is not None:
        found["material"] = Material(found["material"])
    found["particles"] = [Record(particle) for particle in found["particles"]]
    found["profiles"] = {key: Record(profile) for key, profile in found["profiles"].items()}
    found["confined"] = [Record(curve) for curve in found["confined"]]
    told = found.pop("told")
    names = [*found.pop("free"), "deviance", "R2", "relative_l2"]
    found["told"] = records([(*values, *rest) for values, *rest, _ in told], [(name, "f8") for name in names])
    found["told_forces"] = [forces for *_, forces in told]
    tell(f"doubted: {doubt}" for doubt in found["doubts"])
    return Calibration(found)


def _free_key(keyword: str) -> str:
    return key_of(keyword, _core.material_parameters)


def _path(value: Any) -> str:
    return "" if isinstance(value, bool) else os.fspath(value)


def _each(value: float | Sequence[float] | None, count: int) -> list[Any]:
    if value is None or isinstance(value, (int, float)):
        return [value] * count
    values = list(value)
    if len(values) != count:
        raise InvalidInput(f"{len(values)} sizes for {count} files; give one for all, or one for each")
    return values
