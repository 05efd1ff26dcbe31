"""Which files of the catalogue the gate asks, where all of them take long; `--long` asks them all.

One of each kind: equations of a task sheet, a wide table, rolling circles, every kind of group, a chain of many, two drives,
a law from a table, moving guides.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest

SAMPLE = (
    "31", "v107", "cardan", "example-1", "example-6", "jansen", "prp", "robot-arm", "variable-crank-table", "walschaerts",
)  # fmt: skip


def sampled(names: Iterable[str]) -> list[Any]:
    """Return the parameters of a test of `names`: those beside `SAMPLE` are marked `long`."""
    return [name if name in SAMPLE else pytest.param(name, marks=pytest.mark.long) for name in names]


def sampled_pairs(names: Iterable[str], others: Iterable[str], kept: set[tuple[str, str]]) -> list[Any]:
    """Return all pairs as the parameters of a test: those that are not `kept` are marked `long`."""
    pairs = [(name, other) for name in names for other in others]
    return [pair if pair in kept else pytest.param(*pair, marks=pytest.mark.long) for pair in pairs]
