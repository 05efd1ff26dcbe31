"""From the quantities asked for to those that must be computed: each one once, in order, and no others.

Enters: properties marked `@computed(needs)`, the names asked for.  Leaves: typed values kept by their owner, a `Plan`, counts.
Used by `scene.py`, `motion_results.py` and `quantities.py`; `run.py` reads the plan.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field
from graphlib import TopologicalSorter
from typing import Any, ClassVar, Generic, Protocol, TypeVar, overload

import numpy as np

from coursework.system.frozen import changing, frozen
from coursework.words.errors import InputError, Unplaced
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

T = TypeVar("T")
UNDER_WAY: list[str] = []  # names of the quantities this process is computing, innermost last; read to say where the time went


@contextmanager
def under_way(name: str) -> Iterator[None]:
    """Mark the quantity `name` as being computed."""
    UNDER_WAY.append(name)
    try:
        yield
    finally:
        UNDER_WAY.pop()


@changing
class Ledger:
    """Counts the computations: `calls` of each quantity, and its own `seconds`, without those of the quantities it needed."""

    calls: dict[str, int] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)
    _within: list[float] = field(default_factory=list)

    def call(self, name: str, compute: Callable[[Any], T], owner: Any) -> T:
        """Return `compute(owner)`, counted and timed under `name`."""
        self._within.append(0.0)
        begun = time.perf_counter()
        try:
            # Values that are not finite are reported, with their place, when written; NumPy's warnings would name our code.
            with under_way(name), np.errstate(all="ignore"):
                value = compute(owner)
        finally:
            spent = time.perf_counter() - begun
            inner = self._within.pop()
            if self._within:
                self._within[-1] += spent
        self.calls[name] = self.calls.get(name, 0) + 1
        self.seconds[name] = self.seconds.get(name, 0.0) + spent - inner
        return value


class Owner(Protocol):
    """An object that keeps computed values and counts them in a ledger."""

    @property
    def ledger(self) -> Ledger: ...

    def charged(self, error: Exception) -> Exception | None:
        """Return the error to show the user for an error of arithmetic or of a law, None if the tool itself is at fault."""


class Travelling:
    """An owner whose computed numbers and words, named in `PLAIN`, travel to another process; programs are made again there."""

    PLAIN: ClassVar[frozenset[str]]

    def __getstate__(self) -> dict[str, Any]:
        """Return what travels."""
        return {name: value for name, value in vars(self).items() if name in self.PLAIN}


class Computed(Generic[T]):
    """A property computed when it is first read; `needs` names the other properties that its computation reads."""

    def __init__(self, compute: Callable[[Any], T], needs: tuple[str, ...]) -> None:
        self.compute, self.needs, self.name = compute, needs, compute.__name__
        self.__doc__ = compute.__doc__

    @overload
    def __get__(self, owner: None, kind: type) -> Computed[T]: ...
    @overload
    def __get__(self, owner: Owner, kind: type) -> T: ...
    def __get__(self, owner: Owner | None, kind: type) -> Computed[T] | T:
        return self if owner is None else self.of(owner)

    def of(self, owner: Owner) -> T:
        """Return the value for `owner`, computed at the first call and then kept by the owner."""
        kept: dict[str, T] = vars(owner)
        if self.name not in kept:
            try:
                kept[self.name] = owner.ledger.call(self.name, self.compute, owner)
            except InputError:
                raise
            except (ArithmeticError, ValueError, Unplaced) as error:
                if (told := owner.charged(error)) is None:
                    raise
                raise told from error
        return kept[self.name]


def computed(*needs: str) -> Callable[[Callable[[Any], T]], Computed[T]]:
    """Mark a method, or a function of an owner, as a property that is computed once and reads the properties `needs`."""
    return lambda compute: Computed(compute, needs)


def needs_of(kind: type) -> dict[str, tuple[str, ...]]:
    """Return the needs of every computed property of a class, beginning with those of its base classes."""
    found = {name: one for base in reversed(kind.__mro__) for name, one in vars(base).items()}
    return {name: one.needs for name, one in found.items() if isinstance(one, Computed)}


@frozen
class Plan:
    """What is computed: the quantities in `order`, the first user of each (`needed_by`), those `left_out` with their users."""

    order: tuple[str, ...]
    needed_by: Mapping[str, str]
    left_out: Mapping[str, tuple[str, ...]]

    def lines(self) -> list[Sentence]:
        """Return the plan as lines for a reader."""
        ordered = ((name, self.needed_by[name]) for name in self.order)
        computed = [(name, say("plan.asked") if by == name else say("plan.needed", by=by)) for name, by in ordered]
        left = [
            (name, say("plan.only_for", users=users) if users else say("plan.not_asked")) for name, users in self.left_out.items()
        ]
        first, rest = ([say("plan.line", name=f"{name:<20}", why=why) for name, why in part] for part in (computed, left))
        return [say("plan.computed"), *first, say("plan.left_out"), *(rest or [say("plan.nothing")])]


def make_plan(needs: Mapping[str, tuple[str, ...]], wanted: Iterable[str]) -> Plan:
    """Return the plan that computes `wanted`; needed names that are no key of `needs` count as given.

    Raises `graphlib.CycleError` if quantities need each other in a circle.
    """
    needed_by = {name: name for name in wanted}
    for name in (waiting := list(needed_by)):
        for needed in needs[name]:
            if needed in needs and needed not in needed_by:
                needed_by[needed] = name
                waiting.append(needed)
    order = tuple(TopologicalSorter({name: [n for n in needs[name] if n in needs] for name in needed_by}).static_order())
    users = {name: tuple(user for user, needed in needs.items() if name in needed) for name in needs}
    return Plan(order, needed_by, {name: users[name] for name in needs if name not in needed_by})
