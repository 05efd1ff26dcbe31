"""Which files of the catalogue the gate asks, where all of them take long; `--long` asks them all.

One of each kind: equations of a task sheet, a wide table, rolling circles, every kind of group, a chain of many, two drives,
a law from a table, moving guides.  A test that takes long is marked `long` as a whole only if at least two others run each line
of the package that it runs.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest

SAMPLE = (
    "31", "v107", "cardan", "example-1", "example-6", "jansen", "prp", "robot-arm", "variable-crank-table", "walschaerts",
)  # fmt: skip


_asked = {"long": True}


def ask_long(asked: bool) -> None:
    """Say, before any list is made, whether tests that take long are asked: what is not asked is not even made."""
    _asked["long"] = asked


def _made(things: Iterable[tuple[Any, bool]]) -> list[Any]:
    """Return things as the parameters of a test: those with True are marked `long`, or left out if they are not asked."""
    return [later(thing) if is_later else thing for thing, is_later in things if _asked["long"] or not is_later]


def later(thing: Any) -> Any:
    """Return a parameter of a test, or a tuple of them, that is marked `long`."""
    return pytest.param(*thing if isinstance(thing, tuple) else (thing,), marks=pytest.mark.long)


def sampled(names: Iterable[str]) -> list[Any]:
    """Return the parameters of a test of `names`: those beside `SAMPLE` are marked `long`."""
    return _made((name, name not in SAMPLE) for name in names)


def first(count: int, things: Iterable[Any]) -> list[Any]:
    """Return the parameters of a test of `things`: those behind the first `count` are marked `long`."""
    return _made((thing, place >= count) for place, thing in enumerate(things))


def diagonal(step: int, firsts: Iterable[Any], seconds: Iterable[Any]) -> list[Any]:
    """Return all pairs as the parameters of a test: each of both is asked, one pair of `step`, the others are marked `long`."""
    others = [*seconds]
    pairs = [(one, other, (row + column) % step) for row, one in enumerate(firsts) for column, other in enumerate(others)]
    return _made(((one, other), bool(away)) for one, other, away in pairs)


def sampled_pairs(names: Iterable[str], others: Iterable[str], kept: set[tuple[str, str]]) -> list[Any]:
    """Return all pairs as the parameters of a test: those that are not `kept` are marked `long`."""
    pairs = [(name, other) for name in names for other in others]
    return _made((pair, pair not in kept) for pair in pairs)
