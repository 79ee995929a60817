"""What platen raises. The sentences are those of the command `platen`."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """Anything that platen gives up on."""


class InvalidInput(Error, ValueError):
    """Something that was given is not admissible; the sentence says what, and what is allowed. Where runs of a pool came out
    different, `check` is what was found."""

    check: Any = None


class ConvergenceError(Error, ArithmeticError):
    """A solution was not found. Where a press stopped early, `press` is what it has up to there; where the way of a material
    point did, `points`."""

    press: Any = None
    points: Any = None


class IoError(Error, OSError):
    """A file could not be read or written."""


class Warning(UserWarning):
    """What has to be read beside a result."""
