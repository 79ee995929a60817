"""The papers' figures and tables beside ours."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from . import _core
from ._cards import records, tell
from ._pool import Words
from ._press import Bar, bar_of
from ._study import processes

Progress = bool | Callable[[float, str], Any]


class Reproduction(Words):
    """A page of papers: page (path of its index.html); papers, a structured array (paper, rows, reproduced, differing,
    not_comparable, with_number); rows, one a figure or table (paper, id, name, subject, verdict, sentence)."""

    def __repr__(self) -> str:
        return f"<Reproduction: {int(self['papers']['rows'].sum())} rows, {self['page']}>"


def reproduce(
    paper: str = "all",
    *,
    folder: str | os.PathLike[str] = "out/papers",
    fresh: bool = False,
    workers: int | None = 1,
    previous: str | os.PathLike[str] = "",
    progress: Progress = False,
) -> Reproduction:
    """Sets what a paper prints beside what we say, "edmans-sinka", "wang", "shahin" or "all", and writes it as a page into
    `folder`. `fresh` presses everything again, in `workers` processes, hours, resumed where it stopped. What changed against
    `previous`, numbers.csv of an earlier page (without it the one in the folder, else the catalogue's), is marked. The function
    `progress` is called with the share that is done and what is going on. Charts need gnuplot.

    It reads pools and presses of the whole catalogue, which the wheel does not carry: PLATEN_CATALOGUE names its folder.
    InvalidInput says what is missing."""
    with bar_of("reproducing " + paper, progress, _on) as callback:
        found = _core.reproduce(paper, os.fspath(folder), fresh, processes(workers), os.fspath(previous), callback)
    tell(found.pop("said"))
    found["papers"] = records(found["papers"], [("paper", "U"), *((name, "i8") for name in _COUNTS)])
    found["rows"] = records(found["rows"], [(name, "U") for name in ("paper", "id", "name", "subject", "verdict", "sentence")])
    return Reproduction(found)


_COUNTS = ("rows", "reproduced", "differing", "not_comparable", "with_number")


def _on(bar: Bar) -> Callable[[float, str], Any]:
    return bar.draw
