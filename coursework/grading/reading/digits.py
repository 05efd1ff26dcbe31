"""How many digits a column was printed with: the unit of the last place of each of its cells.

Enters: the cells of a column.  Leaves: decimals and one unit a cell, both in the unit of the file.
Used by `columns.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from coursework.grading.reading.numbers import Printed

FINEST = 1e-9  # a spreadsheet stores more digits than any coursework can mean
_FIXED = 0.55  # least share of cells with the greatest number of decimals
_SIGNIFICANT = 0.60  # least share of cells with the same number of significant digits


def last_places(cells: Sequence[Printed]) -> tuple[int, list[float]]:
    """Return the decimals of a column and the unit of each cell's last place, at least 1e-9.

    A fixed number of decimals counts for every cell; a fixed number of significant digits gives each cell its own last place
    (with the zeros that a program dropped); where zeros were dropped from fixed decimals, the longest cell tells.
    """
    numbers = [cell for cell in cells if cell.is_number]
    if not numbers:
        return 0, [1.0] * len(cells)
    decimals = Counter(-cell.place for cell in numbers)
    most = max(decimals)
    if _is_significant(numbers, most) or (decimals[most] < _FIXED * len(numbers) and _same_digits(numbers)):
        usual = max(decimals, key=lambda count: (decimals[count], count))
        digits = Counter(cell.digits for cell in numbers if cell.value).most_common(1)[0][0]
        full = 0 if _keeps_zeros(numbers) else digits
        return max(usual, 0), [_unit(_own_decimals(cell, full) if cell.is_number else usual) for cell in cells]
    return max(most, 0), [_unit(most)] * len(cells)


def _unit(decimals: int) -> float:
    return max(FINEST, float(f"1e{-min(decimals, 300)}"))


def _own_decimals(cell: Printed, full: int) -> int:
    """Return the decimals of a cell; one with fewer than `full` significant digits lost zeros at its end."""
    return -cell.place + (max(full - cell.digits, 0) if cell.value else 0)


def _keeps_zeros(numbers: list[Printed]) -> bool:
    """Return whether some number was printed with a zero at its end."""
    return any(-300 < cell.place < 0 and round(cell.value * 10.0**-cell.place) % 10 == 0 for cell in numbers if cell.value)


def _same_digits(numbers: list[Printed]) -> bool:
    """Return whether most cells have the same number of significant digits while their decimals differ."""
    counts = Counter(cell.digits for cell in numbers if cell.value)
    return bool(counts) and max(counts.values()) >= _SIGNIFICANT * counts.total() and len({cell.place for cell in numbers}) > 1


def _is_significant(numbers: list[Printed], most: int) -> bool:
    """Return whether cells with fewer decimals have exactly the digits of the others, so that no zero was dropped.

    Most numbers below 1 have the same decimals in a column of significant digits too; a longer cell would be a fixed column's.
    """
    nonzero = [cell for cell in numbers if cell.value]
    if not nonzero or not _same_digits(nonzero):
        return False
    usual = Counter(cell.digits for cell in nonzero).most_common(1)[0][0]
    shorter = [cell for cell in nonzero if -cell.place < most]
    longer = sum(cell.digits > usual for cell in nonzero)
    return longer == 0 and sum(cell.digits == usual for cell in shorter) >= _SIGNIFICANT * len(shorter) > 0
