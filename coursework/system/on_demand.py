"""What is asked for -> what has to be computed, each once, in order; nothing else.

Enters: properties marked `@computed(needs)`, the names asked for.  Leaves: typed values kept by their owner, a `Plan`, counts.
Used by `scene.py`, `motion_results.py` and `quantities.py`; `run.py` reads the plan.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import field
from graphlib import TopologicalSorter
from typing import Any, Generic, Protocol, TypeVar, overload

import numpy as np

from coursework.system.frozen import changing, frozen
from coursework.words.errors import InputError, Unplaced
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

T = TypeVar("T")
UNDER_WAY: list[str] = []  # what this process is computing, the innermost last: for whoever must say where time went
Needs = Mapping[str, tuple[str, ...]]


@contextmanager
def under_way(name: str) -> Iterator[None]:
    """Mark what is being computed."""
    UNDER_WAY.append(name)
    try:
        yield
    finally:
        UNDER_WAY.pop()


@changing
class Ledger:
    """What was computed: `calls` and own `seconds` (without those of what it needed) of each quantity."""

    calls: dict[str, int] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)
    _within: list[float] = field(default_factory=list)

    def call(self, name: str, compute: Callable[[Any], T], owner: Any) -> T:
        """Return `compute(owner)`, counted and timed under `name`."""
        self._within.append(0.0)
        begun = time.perf_counter()
        try:
            # What is not finite is told with its place by whoever writes it; NumPy's warnings name a line of ours.
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
    """Whoever keeps computed values counts them in a ledger."""

    @property
    def ledger(self) -> Ledger: ...

    def charged(self, error: Exception) -> Exception | None:
        """Return what a user is told about an error of arithmetic or of a law, None where the tool itself is at fault."""


class Computed(Generic[T]):
    """A property computed when somebody looks at it for the first time; `needs` names those that it looks at itself."""

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
        """Return the value for its owner, who keeps it."""
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
    """Mark a method, or a function of an owner, as a property that is computed once and needs those named."""
    return lambda compute: Computed(compute, needs)


def needs_of(kind: type) -> dict[str, tuple[str, ...]]:
    """Return what every computed property of a class needs, those of the classes it extends first."""
    found = {name: one for base in reversed(kind.__mro__) for name, one in vars(base).items()}
    return {name: one.needs for name, one in found.items() if isinstance(one, Computed)}


@frozen
class Plan:
    """`order` of the quantities computed; `needed_by` the first that asks for each; `left_out` the rest, and what needs them."""

    order: tuple[str, ...]
    needed_by: Mapping[str, str]
    left_out: Mapping[str, tuple[str, ...]]

    def lines(self) -> list[Sentence]:
        """Return the plan for a reader."""
        ordered = ((name, self.needed_by[name]) for name in self.order)
        computed = [(name, say("plan.asked") if by == name else say("plan.needed", by=by)) for name, by in ordered]
        left = [
            (name, say("plan.only_for", users=users) if users else say("plan.not_asked")) for name, users in self.left_out.items()
        ]
        first, rest = ([say("plan.line", name=f"{name:<20}", why=why) for name, why in part] for part in (computed, left))
        return [say("plan.computed"), *first, say("plan.left_out"), *(rest or [say("plan.nothing")])]


def make_plan(needs: Needs, wanted: Iterable[str]) -> Plan:
    """Return what `wanted` needs, in order; names without an entry in `needs` are given.

    Raises `graphlib.CycleError` where quantities need each other in a circle.
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
