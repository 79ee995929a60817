"""Virtual presses: curves, and fields inside the particle."""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._cards import Record, tell, write
from ._errors import ConvergenceError, InvalidInput, IoError
from ._law import Law

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ZONES = ("elastic", "shear", "compaction", "tension")


class Curve:
    """Force over overlap, pressed or measured: the columns of a curve.csv as arrays, by their names: `curve.delta_bar`,
    `curve["force_N"]`; `branch` is an array of words. Lines before the header are `curve.notes`."""

    __slots__ = ("notes", "text", "_columns")

    def __init__(self, text: str) -> None:
        self.text = text
        """the file as it is"""
        self.notes = Record()
        """what the file says before its columns: radius_m, sigma_ref_Pa, material, ..."""
        lines = text.splitlines()
        while lines and lines[0].startswith("#"):
            key, _, value = lines.pop(0)[1:].partition("=")
            self.notes[key.strip()] = _number_or_text(value.strip())
        names = lines[0].split(",") if lines else []
        rows = [line.split(",") for line in lines[1:] if line]
        self._columns = {
            name: np.array([row[i] for row in rows]) if name in ("branch", "particle") else _numbers(rows, i)
            for i, name in enumerate(names)
        }

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, radius: float | None = None) -> Curve:
        """A curve.csv of a press, or columns delta_m,force_N; then the radius [m] is given here or in the file."""
        path = os.fspath(path)
        try:
            with open(path, encoding="utf-8") as file:
                text = file.read()
        except (OSError, UnicodeDecodeError) as error:
            raise InvalidInput(f"{path}: it cannot be read as text: {error}") from error
        curve = cls(_core.parse_curve(text, path, radius))
        return cls(text) if "experiment" in curve.notes and radius is None else curve

    def save(self, path: str | os.PathLike[str]) -> None:
        write(path, self.text)

    @property
    def columns(self) -> tuple[str, ...]:
        return tuple(self._columns)

    def __getitem__(self, name: str) -> Any:
        return self._columns[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._columns:
            raise AttributeError(f"the curve has no column {name!r}; it has {', '.join(self._columns)}")
        return self._columns[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def to_dict(self) -> dict[str, Any]:
        """Columns by name, as pandas.DataFrame takes them."""
        return dict(self._columns)

    @property
    def loading(self) -> dict[str, Any]:
        """The loading branch alone, columns by name."""
        mask = self._columns["branch"] == "loading"
        return {name: values[mask] for name, values in self._columns.items()}

    def fit(self, law: str = "pressed", **how: Any) -> Law:
        """A law fitted to this curve; see `platen.fit`."""
        from ._measured import fit

        return fit(self, law, **how)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Force over overlap; needs matplotlib."""
        from ._plot import plot_curve

        return plot_curve(self, ax, **style)

    def __repr__(self) -> str:
        of = f" of {self.notes['material']}" if self.notes.get("material") else ""
        return f"<Curve{of}: {len(self)} points, {', '.join(self._columns)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Curve, (self.text,)

    def _repr_html_(self) -> str:
        from ._svg import curve_html

        return curve_html(self)


class Press:
    """What a virtual press gave."""

    __slots__ = ("_pressed", "curve", "summary")

    def __init__(self, pressed: _core.Pressed) -> None:
        self._pressed = pressed
        self.curve = Curve(pressed.curve)
        self.summary = Record(json.loads(pressed.summary))
        """summary.json: input, end of loading, largest tension, counters, seconds"""

    @property
    def case(self) -> str:
        """The resolved case card: `platen.press(text)` presses it again."""
        return self._pressed.case

    @property
    def flags(self) -> list[str]:
        """Sentences about the press that its user must read."""
        return self._pressed.flags

    @property
    def error(self) -> Record | None:
        """Relative error of force and radius against the limit of fine meshes, where `estimate_error` asked for it."""
        pair = self._pressed.error
        return None if pair is None else Record(force=pair[0], radius=pair[1])

    @property
    def fields(self) -> list[Record]:
        """The mesh at each moment of `fields_at`, as arrays: nodes_m (where they are then), displacement_m (n, 2 or 3: r and
        z, or x, y, z), elements (corners of each), zone (index in platen.ZONES), stresses sigma_.._Pa (tension positive),
        p_Pa, q_Pa, rho_r, phi, plastic_hencky_strain_v, plastic_hencky_strain_q (one number for each element)."""
        return [Record({**field, "zone": field["zone"][:, 0]}) for field in self._pressed.fields()]

    def write_vtu(self, folder: str | os.PathLike[str]) -> list[str]:
        """The same fields as files of VTK, for ParaView and meshio; their paths."""
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise IoError(f"{os.fspath(folder)}: the folder cannot be made: {error.strerror}") from error
        paths = []
        for name, text in self._pressed.vtu_files():
            paths.append(os.path.join(os.fspath(folder), name))
            write(paths[-1], text)
        return paths

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Writes what `platen press` leaves in its folder: curve.csv, case.toml, summary.json, the pictures of the experiment
        (zones.svg, ...; charts need gnuplot) and the files of VTK, in the place of those of an earlier press."""
        self._pressed.save(os.fspath(folder))

    def as_measured(
        self,
        file: str | os.PathLike[str],
        *,
        particles: int = 1,
        noise: float = 0.01,
        gap: float = 20e-6,
        compliance: float = 0.0,
        seed: int = 1,
    ) -> str:
        """Writes what an instrument would have written of this simple press, with loops where branches unload, as `platen press
        --as-measured`; the path of the file, which `import_curve`, `fit` and `calibrate` read. `particles` each with a size and
        a gap of its own; `noise` of the force, over the largest; `gap` of the platens before contact [m]; `compliance` of the
        machine [m/N]; the same `seed`, the same file."""
        write(file, self._pressed.as_measured(particles, noise, gap, compliance, seed))
        return os.fspath(file)

    def fit(self, law: str = "pressed", *, variant: str = "published") -> Law:
        """The law of this curve: "pressed", "edmans-sinka", "wang", "agarwal" or "shahin"."""
        card, said = self._pressed.law(law, variant)
        tell(said)
        return Law(card, self.curve)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        return self.curve.plot(ax, **style)

    def __repr__(self) -> str:
        seconds = self.summary["statistics"]["total_s"] if "statistics" in self.summary else 0
        return f"<Press of {self.curve.notes.get('material')}: {len(self.curve)} steps in {seconds:.1f} s>"

    def _repr_html_(self) -> str:
        return self.curve._repr_html_()


def press(
    case: str | os.PathLike[str],
    *,
    progress: bool | Callable[[float, float, float], Any] = False,
    estimate_error: bool = False,
) -> Press:
    """Presses a case card, given by path or as text. See also `Material.press`."""
    text = os.fspath(case)
    file = "the case"
    if "\n" not in text:
        file = text
        try:
            with open(text, encoding="utf-8") as opened:
                text = opened.read()
        except OSError as error:
            raise InvalidInput(f"{file}: there is no such file") from error
    return press_case(text, file, progress, estimate_error)


def press_case(text: str, file: str, progress: bool | Callable[[float, float, float], Any], estimate_error: bool) -> Press:
    with bar_of("pressing", progress, lambda bar: bar) as callback:
        pressed = _core.press(text, file, callback, estimate_error)
    done = Press(pressed)
    if pressed.failure is not None:
        failed = ConvergenceError(f"{pressed.failure}; what was pressed until then is the attribute press of this error")
        failed.press = done
        raise failed
    tell(pressed.flags)
    return done


class Bar:
    """A bar on standard error, also in a notebook."""

    def __init__(self, label: str) -> None:
        self._label = label
        self._start = self._last = time.monotonic()
        self._drawn = False

    def __call__(self, fraction: float, delta_bar: float, force: float) -> None:
        self.draw(fraction, f"delta/R = {delta_bar:.3f}")

    def draw(self, fraction: float, note: str) -> None:
        now = time.monotonic()
        if fraction < 1 and now - self._last < 0.1:
            return
        self._last = now
        self._drawn = True
        filled = "=" * int(30 * min(fraction, 1))
        bar = f"\r{self._label} [{filled:<30}] {100 * fraction:3.0f} %  {note}  {now - self._start:.0f} s "
        sys.stderr.write(bar)
        sys.stderr.flush()

    def say(self, sentence: str) -> None:
        """A line, where nobody knows how much is left."""
        sys.stderr.write(f"{self._label}: {sentence}\n")
        sys.stderr.flush()

    def close(self) -> None:
        if self._drawn:
            sys.stderr.write("\n")


@contextmanager
def bar_of(label: str, progress: Any, on: Callable[[Bar], Any]) -> Iterator[Any]:
    """What long work calls: where `progress` is True what `on` makes of a bar, else the function that is given."""
    bar = Bar(label) if progress is True else None
    callback = on(bar) if bar else progress or None
    if callback is not None and not callable(callback):
        raise TypeError(f"progress is {type(progress).__name__}; it must be True or a function")
    try:
        yield callback
    finally:
        if bar:
            bar.close()


def _numbers(rows: list[list[str]], i: int) -> Any:
    return np.array([float(row[i]) if row[i] else np.nan for row in rows])


def _number_or_text(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
