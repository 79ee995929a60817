"""Keywords of Python as keys of cards: `E` is the card's `E_Pa`, in SI units as all numbers here."""

from __future__ import annotations

import json
import os
import sys
import warnings
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ._errors import IoError, Warning

_UNITS = ("_Pa", "_m", "_deg", "_N", "_N_per_m", "_kg_per_m3")


def key_of(keyword: str, known: Iterable[str]) -> str:
    """The card's key that a keyword stands for; an unknown keyword is handed on, to be refused by name."""
    known = set(known)
    if keyword not in known:
        for unit in _UNITS:
            if keyword + unit in known:
                return keyword + unit
    return keyword


def toml_value(value: Any) -> str:
    """A value as it stands in a card."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {toml_value(item)}" for key, item in value.items()) + " }"
    if isinstance(value, Iterable):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    raise TypeError(f"{value!r} is {type(value).__name__}; a card holds numbers, texts and lists")


def toml_lines(values: Mapping[str, Any]) -> str:
    return "".join(f"{key} = {toml_value(value)}\n" for key, value in values.items() if value is not None)


def parameter_text(key: str, value: Any) -> str:
    """A law's parameter as `platen eval -p` takes it."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{key} = {value!r} is bool; it must be a number, a list of numbers or a text")
    if isinstance(value, (int, float, np.integer, np.floating)):
        return repr(float(value))
    if isinstance(value, Iterable):
        return ",".join(parameter_text(key, item) for item in value)
    raise TypeError(f"{key} = {value!r} is {type(value).__name__}; it must be a number, a list of numbers or a text")


def tell(said: Iterable[str]) -> None:
    """What has to be read beside a result, as warnings at the caller of platen."""
    depth = 2
    while depth < 10 and sys._getframe(depth).f_globals.get("__name__", "").startswith("platen."):
        depth += 1
    for sentence in said:
        warnings.warn(sentence.removeprefix("note: ").removeprefix("warning: "), Warning, stacklevel=depth + 1)


def write(path: str | os.PathLike[str], text: str) -> None:
    """Writes a file whole or not at all."""
    path = os.fspath(path)
    temporary = f"{path}.{os.getpid()}.tmp"
    try:
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(temporary, path)
    except OSError as error:
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise IoError(f"{path} cannot be written: {error.strerror}") from error


def structured(columns: Iterable[tuple[str, Any]]) -> Any:
    """Columns as one structured array; words as text of the length that they need."""
    arrays = [(name, np.asarray(values, dtype=str) if isinstance(values, list) else values) for name, values in columns]
    table = np.empty(len(arrays[0][1]), dtype=[(name, values.dtype) for name, values in arrays])
    for name, values in arrays:
        table[name] = values
    return table


def records(rows: list[tuple[Any, ...]], columns: list[tuple[str, str]]) -> Any:
    """Rows as a structured array."""
    return structured((name, [row[i] for row in rows] if kind == "U" else np.array([row[i] for row in rows], dtype=kind))
                      for i, (name, kind) in enumerate(columns))  # fmt: skip


class Record(dict):  # type: ignore[type-arg]
    """A section of a card, or a result, whose keys are attributes too."""

    def __getattr__(self, name: str) -> Any:
        if name not in self:
            raise AttributeError(f"there is no {name!r} here; there are {', '.join(map(str, self))}")
        return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]
