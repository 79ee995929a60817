"""Two bodies in contact, for one way or for many contacts at once."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._errors import InvalidInput

if TYPE_CHECKING:  # neither dataclasses nor numpy.typing are loaded: they would take half as long as numpy
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]

BRANCHES = ("separated", "loading", "unloading", "reloading")
QUANTITIES = ("force", "stiffness", "contact_radius", "mean_pressure", "dissipated_work", "branch", "in_range")
_TYPES = {"branch": np.uint8, "in_range": np.bool_}


def floats(values: Any, name: str) -> Floats:
    """Any numbers as an array that the compiled part can read: it is copied where it has gaps or another type."""
    array = np.asarray(values)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be numbers, not {array.dtype}")
    if array.ndim > 1:
        raise InvalidInput(f"{name} must be a number or a list of them, not an array of shape {array.shape}")
    return np.asarray(array, dtype=np.float64, order="C")


class Response:
    """What contacts answer, an array each (numbers for one overlap). What was not asked for is `None`.

    overlap: approach of the two centres, on a plane of the centre [m]; force, compression positive [N]; stiffness,
    dF/d overlap [N/m]; contact_radius [m]; mean_pressure [Pa]; dissipated_work, which unloading from the largest overlap so
    far does not return [J]; branch, index in platen.BRANCHES; in_range, whether the law was made for the largest overlap so
    far."""

    __slots__ = ("overlap", *QUANTITIES)

    def __init__(
        self,
        overlap: Floats,
        force: Floats,
        stiffness: Floats | None = None,
        contact_radius: Floats | None = None,
        mean_pressure: Floats | None = None,
        dissipated_work: Floats | None = None,
        branch: npt.NDArray[np.uint8] | None = None,
        in_range: npt.NDArray[np.bool_] | None = None,
    ) -> None:
        self.overlap = overlap
        self.force = force
        self.stiffness = stiffness
        self.contact_radius = contact_radius
        self.mean_pressure = mean_pressure
        self.dissipated_work = dissipated_work
        self.branch = branch
        self.in_range = in_range

    def __len__(self) -> int:
        return int(np.size(self.overlap))

    def __repr__(self) -> str:
        given = ", ".join(name for name in QUANTITIES if getattr(self, name) is not None)
        return f"<Response of {len(self)} overlaps: {given}>"


class State:
    """What many contacts of one pair remember: the last and the largest overlap of each. A state belongs to the
    contact that made it; indices reorder it, as a neighbour list does."""

    __slots__ = ("_memory",)

    def __init__(self, memory: _core.Memory) -> None:
        self._memory = memory

    def __len__(self) -> int:
        return len(self._memory)

    @property
    def overlap(self) -> Floats:
        """Last overlap of each contact [m], a copy."""
        into = np.empty(len(self))
        self._memory.read_overlap(into)
        return into

    @property
    def largest_overlap(self) -> Floats:
        """Largest overlap of each contact so far [m], a copy."""
        into = np.empty(len(self))
        self._memory.read_largest_overlap(into)
        return into

    def __getitem__(self, index: Any) -> State:
        """A state of the contacts that a slice, a mask or indices name."""
        chosen = np.atleast_1d(np.arange(len(self), dtype=np.int64)[index])
        return State(self._memory.take(chosen))

    def rebuilt(self, origin: npt.ArrayLike) -> State:
        """A state of other contacts: `origin` says which of these each was, -1 for one that never touched."""
        array = np.asarray(origin)
        if array.dtype.kind not in "iu" or array.ndim != 1:
            raise TypeError("origin must be a list of whole numbers")
        return State(self._memory.take(np.ascontiguousarray(array, dtype=np.int64)))

    def copy(self) -> State:
        return self[:]

    def __repr__(self) -> str:
        return f"<State of {len(self)} contacts>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _state, (self._memory.key, self.overlap, self.largest_overlap)


def _state(key: str, overlap: Floats, largest: Floats) -> State:
    return State(_core.Memory.from_arrays(key, overlap, largest))


class Contact:
    """Two bodies in contact; made by `Law.pair` and `Law.on_plane`."""

    __slots__ = ("_core", "_made")

    def __init__(self, core: _core.Contact, made: tuple[Any, ...]) -> None:
        self._core = core
        self._made = made

    @property
    def valid_overlap(self) -> float:
        """Largest overlap for which the cards hold [m]; infinite where they do not say."""
        return self._core.limit

    @property
    def delta_bar_per_overlap(self) -> float:
        """delta/R of an overlap, over that overlap [1/m]."""
        return self._core.delta_bar_per_overlap

    def __call__(self, overlap: npt.ArrayLike, *, exact: bool = False) -> Response:
        """One contact, from its first touch along a way of overlaps [m]; the memory is carried along, as in
        `platen eval`. `exact`: by the formulas of the law instead of the table that contact loops run, 1e-4 from them."""
        array = floats(overlap, "overlap")
        arrays = _empty(array.size, QUANTITIES)
        self._core.follow(np.atleast_1d(array), **arrays, exact=exact)
        if array.ndim == 0:
            arrays = {name: values[0] for name, values in arrays.items()}
        return Response(array, **arrays)

    def new_state(self, count: int) -> State:
        """Memory of `count` contacts that never touched."""
        count = int(count)
        if count < 0:
            raise InvalidInput(f"a state of {count} contacts: the count must not be below 0")
        return State(self._core.new_memory(count))

    def step(
        self,
        state: State,
        overlap: npt.ArrayLike,
        *,
        only: Iterable[str] = QUANTITIES,
        out: Response | None = None,
    ) -> Response:
        """One step of many contacts at once: overlap of each [m] in, response out, `state` moved on. Below 0 they are
        apart. `only` names the quantities to compute, force is always one; `out` is a response whose arrays are
        written again, which saves their allocation. The lock of the interpreter is not held meanwhile."""
        array = np.atleast_1d(floats(overlap, "overlap"))
        if not isinstance(state, State):
            raise TypeError(f"state is {type(state).__name__}; contact.new_state(count) makes one")
        if out is None:
            arrays = _empty(array.size, {"force", *only})
        else:
            arrays = {name: values for name in QUANTITIES if (values := getattr(out, name)) is not None}
        self._core.step(state._memory, array, **arrays)
        if out is None:
            return Response(array, **arrays)
        out.overlap = array
        return out

    def __repr__(self) -> str:
        return f"<Contact {self._core.words}>"

    def __reduce__(self) -> tuple[Any, ...]:
        law, method, arguments = self._made
        return _remade, (law, method, arguments)


def _remade(law: Any, method: str, arguments: dict[str, Any]) -> Contact:
    contact: Contact = getattr(law, method)(**arguments)
    return contact


def _empty(count: int, names: Iterable[str]) -> dict[str, Any]:
    names = set(names)
    if unknown := names.difference(QUANTITIES):
        raise InvalidInput(f"there is no quantity {sorted(unknown)[0]!r}; there are {', '.join(QUANTITIES)}")
    return {name: np.empty(count, dtype=_TYPES.get(name, np.float64)) for name in QUANTITIES if name in names}
