"""Studies: many presses by a design, kept in a folder, resumed, read as tables."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from . import _core
from ._cards import Record, structured, tell
from ._errors import InvalidInput
from ._press import Bar, Curve, bar_of

if TYPE_CHECKING:
    from ._pool import Refinement, Surrogate

Progress = bool | Callable[[int, int, int], Any]


class StudyStatus(Record):
    """What is in the store: runs (of the design), done, failed, left; claimed (being pressed by a worker somewhere); cpu_s and
    wall_s of the presses that are there; failures, the reason by key."""

    def __repr__(self) -> str:
        return "<StudyStatus: {runs} runs, {done} done, {failed} failed, {left} left>".format(**self)


class Study:
    """A study card and the store of its runs.

    >>> study = platen.Study.load("study.toml")
    >>> study.run(progress=True)
    >>> table = study.runs()                      # table["material.E_bar"], table["k"], ...
    """

    __slots__ = ("_study",)

    def __init__(self, study: _core.Study) -> None:
        self._study = study

    @classmethod
    def load(cls, card: str | os.PathLike[str], *, store: str | os.PathLike[str] = "") -> Study:
        """A study card by path. `store` is the folder of its runs; without it out/NAME. Nothing is written yet."""
        return cls(_core.Study.read(os.fspath(card), os.fspath(store)))

    @property
    def name(self) -> str:
        return self._study.name

    @property
    def store(self) -> str:
        """Folder of the runs."""
        return self._study.folder

    def __len__(self) -> int:
        """Runs of the design."""
        return len(self._study)

    def design(self) -> Any:
        """One row a run: its number, the level of each factor, derived quantities (lambda = E/((1 - nu^2) sigma_ref), ...)."""
        return structured(self._study.design())

    @property
    def spread(self) -> Record:
        """How the design fills its ranges, in the unit cube: min_distance, min_distance_within (of one category), maxpro (mean
        over pairs of the product of 1/difference^2, to the power of 1/factors; Joseph, Gul & Ba 2015, eq. 5)."""
        return Record(zip(("min_distance", "min_distance_within", "maxpro"), self._study.spread()))

    def beside(self, other: Study) -> Record:
        """How the runs of another study over the same factors fill the ranges of this one, as `spread`."""
        return Record(zip(("min_distance", "min_distance_within", "maxpro"), self._study.spread_beside(other._study)))

    def run(
        self, *, workers: int | None = None, progress: Progress = False, retry_failed: bool = False, old: str = ""
    ) -> StudyStatus:
        """Presses what is missing, in `workers` processes (without it one a processor), beside those of others on the same store.
        Ctrl-C ends it; what is finished stays, and the same call goes on. `progress=True` draws a bar; a
        function is called with the runs done, failed, and all. `retry_failed` presses failed runs again. Of runs that another
        engine pressed `old` says what becomes: "keep", or "recompute".

        ConvergenceError where every press failed; IoError where the store cannot be written."""
        with bar_of("study " + self.name, progress, counting) as callback:
            tally, said = self._study.run(processes(workers), callback, retry_failed, old)
        tell(said)
        return StudyStatus(tally)

    def status(self) -> StudyStatus:
        return StudyStatus(self._study.status())

    def runs(self, *, variant: str = "published") -> Any:
        """One row a run, in the order of the design: run, key, the factors, state ("done", "failed", "missing", "damaged"),
        parameters and errors of the laws that [fit] of the card names, cpu_s, wall_s; a number that is not there is not-a-number.
        A structured array: `table["k"]`, `pandas.DataFrame(table)`. Laws are fitted to the kept curves: no press."""
        columns, said = self._study.runs(variant)
        tell(said)
        return structured(columns)

    def curves(self, *, step: float = 0.01) -> Any:
        """The curves of all runs on a grid of `step` in delta/R: run (row of `runs()`, from 1), branch_id, branch, delta_bar,
        F_bar = F/(pi R^2 sigma_ref), a_bar = a/R, and those of walls (_x, _y). A structured array."""
        columns, said = self._study.curves(float(step))
        tell(said)
        return structured(columns)

    def export(
        self,
        runs: str | os.PathLike[str],
        *,
        curves: str | os.PathLike[str] = "",
        variant: str = "published",
        step: float = 0.01,
    ) -> None:
        """Writes the tables of `runs()` and `curves()` as CSV; both into one file where `runs` ends in .sqlite or .db."""
        tell(self._study.export(os.fspath(runs), os.fspath(curves), variant, float(step)))

    def curve(self, key: str) -> Curve:
        """The whole curve of one run; keys stand in `runs()`."""
        return Curve(self._study.curve(key))

    def merge(self, stores: Iterable[str | os.PathLike[str]], *, old: str = "") -> int:
        """Copies runs of other stores that are not here yet, or damaged; how many."""
        copied, left_out = self._study.merge([os.fspath(store) for store in stores], old)
        tell(f"{what}; the run was left out" for what in left_out)
        return copied

    def batch_script(self, *, tasks: int = 16, slurm: Iterable[str] = ()) -> str:
        """The batch script of a Slurm job array of so many tasks at most, each of which presses what is missing, with this
        Python. `slurm`: options of sbatch, "--time=4:00:00"."""
        return self._study.batch_script(_WORKER, int(tasks), list(slurm))

    def submit(self, *, tasks: int = 16, slurm: Iterable[str] = (), old: str = "") -> str:
        """Hands that script, which is kept as submit.sh in the store, to sbatch: what sbatch says, "Submitted batch job 12"; an
        empty text where nothing is left to press. Store, card and this Python must be in folders that all nodes see; `status`
        and `run` work beside the job. `old` as in `run`.

        IoError where sbatch does not take it, or is not there."""
        return self._study.submit(_WORKER, int(tasks), list(slurm), old)

    def refine(
        self,
        surrogate: Surrogate | str | os.PathLike[str],
        *,
        target: float = 0.01,
        most: int = 50,
        file: str | os.PathLike[str] = "",
    ) -> Refinement:
        """Which of its runs to press next: those of which a surrogate (or its file, or the folder of its pool) is least sure,
        until no curve is expected to be further off than `target`, `most` at most. They are written as a study, a card with its
        table beside it: `file`, else STUDY-refined.toml beside this one."""
        from ._pool import Refinement, Surrogate

        known = surrogate if isinstance(surrogate, Surrogate) else Surrogate.load(surrogate)
        return Refinement(_core.refine(self._study, known._surrogate, float(target), int(most), os.fspath(file)))

    def __repr__(self) -> str:
        return f"<Study {self.name}: {len(self)} runs, store {self.store}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _study, (self._study.file, self.store)


def _study(card: str, store: str) -> Study:
    return Study.load(card, store=store)


# A task of a job array: card and store follow.
_WORKER = [
    sys.executable,
    "-c",
    "import platen, sys; platen.Study.load(sys.argv[1], store=sys.argv[2]).run(workers=1)",
]


def processes(workers: int | None) -> int:
    """0: one a processor."""
    if workers is not None and int(workers) < 1:
        raise InvalidInput(f"workers = {workers}: it must be a whole number in [1, 1024]")
    return int(workers or 0)


def counting(bar: Bar) -> Callable[[int, int, int], Any]:
    def show(done: int, failed: int, runs: int) -> None:
        bar.draw((done + failed) / max(runs, 1), f"{done + failed} of {runs} runs, {failed} failed")

    return show
