"""The names of cells in a workbook: `_r1` for a datum, `_phi1_0` for a start value, `step`.

Enters: a `Variant`.  Leaves: defined names by what they stand for.  Used inside `workbook/`.

A spreadsheet takes r1, V1 and C for cells and ignores case: so a datum begins with an underscore, and of two names that differ
only in case the later one begins with two.
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.equations.reduction.symbolic import break_of
from coursework.variant.record.variant import Variant

STEP = "step"


def start_of(coordinate: str) -> str:
    """Return the key of a coordinate's start value, from which its defined name is made."""
    return f"{coordinate}_0"


def break_times(variant: Variant) -> Iterator[tuple[str, int, float]]:
    """Yield, for every law with pieces, its name, the number of each piece that ends, and the time (s) when it ends."""
    for law in variant.laws:
        for place, (time, _) in enumerate(law.pieces[1:]):
            yield law.name, place, time


def defined_names(variant: Variant) -> dict[str, str]:
    """Return the defined name of each datum, each start value and each end of a piece, by key.

    >>> import coursework
    >>> names = defined_names(coursework.load("31"))
    >>> names["r1"], names["phi1_0"]
    ('_r1', '_phi1_0')
    """
    listed = [*variant.values, *(start_of(c.name) for c in variant.coordinates)]
    listed += [start_of(rate) for rate in (variant.motor.rates if variant.motor else ())]
    listed += [break_of(law, place) for law, place, _ in break_times(variant)]
    taken, found = set[str](), dict[str, str]()
    for name in listed:
        own = f"_{name}"
        while own.lower() in taken:
            own = f"_{own}"
        taken.add(own.lower())
        found[name] = own
    return found


def letters(column: int) -> str:
    """Return the letters of a column, counted from 0.

    >>> letters(0), letters(25), letters(26)
    ('A', 'Z', 'AA')
    """
    text, column = "", column + 1
    while column:
        column, rest = divmod(column - 1, 26)
        text = chr(65 + rest) + text
    return text
