"""Data pools, and what is made of them: surrogates, methods side by side, what to press next, what matters."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from typing import Any

from . import _core
from ._cards import Record, records, write
from ._errors import InvalidInput
from ._press import bar_of
from ._study import Progress, Study, counting, processes

Path = str | os.PathLike[str]


class Pool:
    """A data pool: a folder with a study and what it gave, study.toml, runs.csv and curves.csv, as `Study.export` writes them.

    >>> pool = platen.Pool("catalogue/pools/von-mises")
    >>> surrogate = pool.surrogate()
    >>> print(surrogate)
    """

    __slots__ = ("folder",)

    def __init__(self, folder: Path) -> None:
        self.folder = os.fspath(folder)
        if not os.path.isfile(os.path.join(self.folder, "study.toml")):
            raise InvalidInput(f"{self.folder}: it is no pool; there is no study.toml in it")

    @property
    def study(self) -> Study:
        """The study that was pressed."""
        return Study.load(os.path.join(self.folder, "study.toml"))

    def check(
        self,
        *,
        share: float = 0.05,
        seed: int = 1,
        cheapest: bool = False,
        until: float = 0.0,
        workers: int | None = None,
        progress: Progress = False,
    ) -> PoolCheck:
        """Presses some of its runs again and compares: a `share` of all at random, `seed` says which; or the `cheapest` two, of
        the softer and of the stiffer half the run that took least time. `until` ends a press at this delta/R, without
        unloading (not local, triaxial). `workers`, `progress` and Ctrl-C as in `Study.run`.

        InvalidInput where runs differ by more than the tolerance; its attribute `check` is what was found."""
        with bar_of("pool", progress, counting) as callback:
            found = _core.check(self.folder, float(share), int(seed), cheapest, float(until), processes(workers), callback)
        refusal = found.pop("refusal")
        check = PoolCheck(found)
        if refusal:
            different = InvalidInput(refusal)
            different.check = check
            raise different
        return check

    def surrogate(self, *, others: Iterable[Path] = (), coarse: Path = "") -> Surrogate:
        """Interpolates it, for `predict`. `others`: folders of pools of other materials that were pressed alike; `coarse`: of the
        same study, and more of it, on fewer elements; `predict` presses on as many first. A pool of rock is taken alone."""
        made = _core.Surrogate.make(self.folder, [os.fspath(pool) for pool in others], os.fspath(coarse))
        return Surrogate(made)

    def methods(self, *, others: Iterable[Path] = (), surrogate: Surrogate | Path | None = None) -> Methods:
        """Ways to predict its materials, side by side, each material from the others. `surrogate`: that of these pools; without
        it one is made anew."""
        if surrogate is not None and not isinstance(surrogate, Surrogate):
            surrogate = Surrogate.load(surrogate)
        made = None if surrogate is None else surrogate._surrogate
        return Methods(*_core.methods(self.folder, [os.fspath(pool) for pool in others], made))

    def __repr__(self) -> str:
        return f"<Pool {self.folder}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pool) and os.path.abspath(self.folder) == os.path.abspath(other.folder)

    def __hash__(self) -> int:
        return hash(os.path.abspath(self.folder))

    def __reduce__(self) -> tuple[Any, ...]:
        return Pool, (self.folder,)


class Words(Record):
    """A result that is printed as the command prints it."""

    def __str__(self) -> str:
        return str(self["words"])


class PoolCheck(Words):
    """Runs of a pool, pressed again: table (run, from 1; same; difference, the largest of any column at any row over the largest
    value of that column; reason, why there is none), engine that pressed the pool, tolerance."""

    def __init__(self, found: dict[str, Any]) -> None:
        columns = [("run", "i8"), ("same", "?"), ("difference", "f8"), ("reason", "U")]
        rows = found.get("rows")
        super().__init__({key: value for key, value in found.items() if key != "rows"})
        if rows is not None:
            self["table"] = records(rows, columns)

    def __repr__(self) -> str:
        return f"<PoolCheck: {int(self['table']['same'].sum())} of {len(self['table'])} runs are as before>"


class Surrogate:
    """What a pool says of materials between those that were pressed; printed as `platen study surrogate` prints it."""

    __slots__ = ("_file", "_surrogate")

    def __init__(self, surrogate: _core.Surrogate, file: str = "") -> None:
        self._surrogate = surrogate
        self._file = file

    @classmethod
    def load(cls, what: Path) -> Surrogate:
        """By its file, surrogate.txt or, of rock, grains.csv; or by the folder of its pool."""
        return cls(_core.Surrogate.read(os.fspath(what)), os.fspath(what))

    def save(self, file: Path) -> None:
        """Writes the file. `predict` reads those of the catalogue: surrogate.txt, of rock grains.csv, in the folder of a pool."""
        write(file, self.text)
        self._file = os.fspath(file)

    @property
    def text(self) -> str:
        """The file as it is."""
        return self._surrogate.text()

    @property
    def pool(self) -> str:
        """Name of the pool that it is made of."""
        return str(self._surrogate.about()["pool"])

    @property
    def model(self) -> str:
        """Constitutive model of its materials."""
        return str(self._surrogate.about()["model"])

    @property
    def materials(self) -> int:
        """How many it is made of."""
        return int(self._surrogate.about()["materials"])

    @property
    def ranges(self) -> dict[str, tuple[float, float]]:
        """Smallest and largest value of each number of the materials; of rock empty."""
        return dict(self._surrogate.about()["ranges"])

    @property
    def left_out(self) -> Record:
        """Relative errors of its materials, each predicted without itself: force and radius (relative L2 over the loading), work
        given back and residual overlap in unloading, each with median, p95 and worst; coverage of the 90 % band; of rock the
        coefficients a, b, m, n, force and work."""
        return _nested(self._surrogate.about()["left_out"])

    @property
    def guided(self) -> Record | None:
        """The same, each with a press on few elements first; None where it wants none."""
        errors = self._surrogate.about()["guided"]
        return None if errors is None else _nested(errors)

    def beside(self, pool: Pool | Path) -> Beside:
        """How well it says what a pool that it is not made of pressed."""
        return Beside(*self._surrogate.beside(pool.folder if isinstance(pool, Pool) else os.fspath(pool)))

    def __str__(self) -> str:
        return self._surrogate.words(self._file or "in no file yet")

    def __repr__(self) -> str:
        return f"<Surrogate of pool {self.pool}: {self.materials} materials, {self.model}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _surrogate, (self.text, self._file, self._surrogate.of_rock)


def _surrogate(text: str, file: str, of_rock: bool) -> Surrogate:
    return Surrogate(_core.Surrogate.parse(text, file or "a pickled surrogate", of_rock), file)


class Table:
    """A structured array that is printed as the command prints it: `table` and its words."""

    __slots__ = ("table", "_words")
    _columns: list[tuple[str, str]] = []

    def __init__(self, rows: Any, words: str) -> None:
        self.table = rows if hasattr(rows, "dtype") else records(rows, self._columns)
        self._words = words

    def __len__(self) -> int:
        return len(self.table)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.table)

    def __getitem__(self, name: Any) -> Any:
        return self.table[name]

    def __str__(self) -> str:
        return self._words

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self)} rows, {', '.join(self.table.dtype.names)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table, self._words)


class Beside(Table):
    """A surrogate beside the materials of another pool: run, material, force and radius (relative L2 errors), expected (error
    that the surrogate expects), locks (whether it says so)."""

    __slots__ = ()
    _columns = [("run", "i8"), ("material", "U"), ("force", "f8"), ("radius", "f8"), ("expected", "f8"), ("locks", "?")]


class Methods(Table):
    """Ways to predict, one a row: of ("loading", "unloading", of rock "both"), method, materials that it could predict, median,
    p95 and worst of the relative errors of force, work given back and residual overlap; not-a-number where it says nothing of
    them."""

    __slots__ = ()
    _columns = [("of", "U"), ("method", "U"), ("materials", "i8")] + [
        (f"{error}_{quantile}", "f8") for error in ("force", "work", "residual") for quantile in ("median", "p95", "worst")
    ]


class Refinement(Words):
    """What to press next: runs of the study (from 1) in the order in which they were chosen; expected, the error of the least
    certain candidate before each and after all; candidates, how many there were; card and table, the study that was written,
    empty where there is nothing to press."""

    @property
    def study(self) -> Study | None:
        """The study to run."""
        return Study.load(self["card"]) if self["card"] else None

    def __repr__(self) -> str:
        before, after = self["expected"][0], self["expected"][-1]
        return f"<Refinement: {len(self['runs'])} presses, {100 * before:.2g} % expected before, {100 * after:.2g} % after>"


class Sensitivity(Words):
    """Which number of a material matters: pool, outputs (force at delta/R 0.1, 0.3, 0.5; work put in, work given back), deviation
    of each over its mean, numbers (key, low, high, and of each output the Sobol index alone and total), held (numbers that the
    pool does not vary)."""

    @property
    def table(self) -> Any:
        """One row a number and output: number, low, high, output, alone, total. A structured array."""
        rows = [(n["key"], n["low"], n["high"], output, n["alone"][k], n["total"][k])
                for n in self["numbers"] for k, output in enumerate(self["outputs"])]  # fmt: skip
        return records(rows, [("number", "U"), ("low", "f8"), ("high", "f8"), ("output", "U"), ("alone", "f8"), ("total", "f8")])

    def __repr__(self) -> str:
        return f"<Sensitivity through pool {self['pool']}: {len(self['numbers'])} numbers, {len(self['outputs'])} outputs>"


def _nested(errors: dict[str, Any]) -> Record:
    return Record({key: Record(value) if isinstance(value, dict) else value for key, value in errors.items()})
