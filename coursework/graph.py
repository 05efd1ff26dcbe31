"""What is asked for -> what has to be computed, each once, in order; nothing else.

Enters: functions whose name is the quantity and whose parameters are what it needs.  Leaves: a `Plan`, then values.
The idea is Hamilton's (function name = quantity); here without the library.
"""

from __future__ import annotations

import inspect
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from coursework.errors import CourseworkError, closest, listing

Rules = Mapping[str, Callable[..., Any]]


class UnknownQuantity(CourseworkError):
    """A quantity was asked for that the tool does not have."""


@dataclass(frozen=True, slots=True)
class Plan:
    """`order` of the quantities computed; `needed_by` the first that asks for each; `left_out` the rest, and what needs them."""

    order: tuple[str, ...]
    needed_by: Mapping[str, str]
    left_out: Mapping[str, tuple[str, ...]]

    def lines(self) -> list[str]:
        """Return the plan for a reader."""
        computed = [f"  {name:<16} {'asked for' if by == name else f'needed by {by}'}" for name, by in self.needed_by.items()]
        left = [
            f"  {name:<16} " + (f"only for {listing(users)}, not asked for" if users else "not asked for")
            for name, users in self.left_out.items()
        ]
        return ["Computed, in this order:", *computed, "Left out:", *(left or ["  nothing"])]


@cache
def needs(rule: Callable[..., Any]) -> tuple[str, ...]:
    """Return the quantities a rule takes."""
    return tuple(inspect.signature(rule).parameters)


def make_plan(rules: Rules, wanted: Iterable[str], given: Iterable[str]) -> Plan:
    """Return what `wanted` needs beyond `given`, in order.  Raises `UnknownQuantity`; a circle is a fault of the rules."""
    known = set(given)
    needed_by: dict[str, str] = {}

    def visit(name: str, by: str, path: tuple[str, ...]) -> None:
        if name in known or name in needed_by:
            return
        if name in path:
            raise RuntimeError(f"quantities need each other in a circle: {' needs '.join((*path, name))}")
        if name not in rules:
            raise UnknownQuantity(f'There is no quantity "{name}".{closest(name, list(rules))} Known: {", ".join(rules)}.')
        for needed in needs(rules[name]):
            visit(needed, name, (*path, name))
        needed_by[name] = by

    for name in wanted:
        visit(name, name, ())
    users = {name: tuple(user for user, rule in rules.items() if name in needs(rule)) for name in rules}
    return Plan(tuple(needed_by), needed_by, {name: users[name] for name in rules if name not in needed_by})


@dataclass(slots=True)
class Values:
    """Computes quantities on demand and keeps them; `calls` and `seconds` per rule say what it cost."""

    rules: Rules
    values: dict[str, Any]
    calls: dict[str, int] = field(default_factory=dict)
    seconds: dict[str, float] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Any:
        """Return a quantity, computing it and its ancestors where needed."""
        if name in self.values:
            return self.values[name]
        for step in make_plan(self.rules, [name], self.values).order:
            rule = self.rules[step]
            arguments = [self.values[needed] for needed in needs(rule)]
            begun = time.perf_counter()
            self.values[step] = rule(*arguments)
            self.seconds[step] = time.perf_counter() - begun
            self.calls[step] = self.calls.get(step, 0) + 1
        return self.values[name]
