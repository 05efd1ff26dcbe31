"""The precision with which a column was printed: the unit of the last place of each of its cells.

Enters: the cells of a column.  Leaves: decimals and one unit per cell, both in the unit of the file.
Used by `table.py`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from coursework.grading.reading.numbers import PrintedNumber

FINEST = 1e-9  # a spreadsheet stores more digits than any coursework can mean
_FIXED = 0.55  # least share of cells with the greatest number of decimals
_DOUBLE = 15  # significant digits that a double always keeps
_SIGNIFICANT = 0.60  # least share of cells with the same number of significant digits


def last_places(cells: Sequence[PrintedNumber]) -> tuple[int, list[float]]:
    """Return the number of decimals of a column and the unit of each cell's last place, at least 1e-9.

    With fixed decimals, all cells have the same unit.  With a fixed number of significant digits, each cell has its own unit
    (counting zeros that a program dropped).  If zeros were dropped from fixed decimals, the cell with most decimals decides.
    """
    numbers = [cell for cell in cells if cell.is_number]
    if not numbers:
        return 0, [1.0] * len(cells)
    decimals = Counter(-cell.place for cell in numbers)
    most = max(decimals)
    digits = _significant_digits(numbers)
    if digits and (_is_significant(numbers, most, digits) or decimals[most] < _FIXED * len(numbers)):
        usual = max(decimals, key=lambda count: (decimals[count], count))
        full = 0 if digits < _DOUBLE and _keeps_zeros(numbers) else digits  # 4.0 beside 4.014999999999999 is a whole number
        # A cell with fewer significant digits than `full` has lost zeros at its end.
        decimals_of = [max(full - cell.digits, 0) - cell.place if cell.value and cell.is_number else usual for cell in cells]
        return max(usual, 0), list(map(_unit, decimals_of))
    return max(most, 0), [_unit(most)] * len(cells)


def _unit(decimals: int) -> float:
    return max(FINEST, float(f"1e{-min(decimals, 300)}"))


def _keeps_zeros(numbers: list[PrintedNumber]) -> bool:
    """Return whether a number was printed with a zero at its end; numbers with more digits than a double keeps do not count."""
    told = [cell for cell in numbers if cell.value and cell.digits <= _DOUBLE]
    return any(-300 < cell.place < 0 and round(float(f"{cell.value:.15g}") * 10.0**-cell.place) % 10 == 0 for cell in told)


def _significant_digits(numbers: list[PrintedNumber]) -> int:
    """Return the number of significant digits that most cells have although their decimals differ, 0 if there is none.

    A whole number may have more digits, as it cannot be printed with fewer.
    """
    nonzero = [cell for cell in numbers if cell.value]
    has_powers = any(cell.place > 0 for cell in nonzero)  # 1.2e+03 has only the digits it shows
    counts = Counter(cell.digits for cell in nonzero if has_powers or cell.place < 0)
    if not counts or len({cell.place for cell in numbers}) == 1:
        return 0
    digits = counts.most_common(1)[0][0]
    return digits if sum(_fits(cell, digits) for cell in nonzero) >= _SIGNIFICANT * len(nonzero) else 0


def _fits(cell: PrintedNumber, digits: int) -> bool:
    return cell.digits == digits or (cell.place == 0 and cell.digits > digits > 1)


def _is_significant(numbers: list[PrintedNumber], most: int, digits: int) -> bool:
    """Return whether the cells with fewer decimals have as many digits as the others, so that no zero was dropped.

    Most numbers below 1 have equal decimals even in a column of significant digits; one longer cell shows fixed decimals.
    """
    nonzero = [cell for cell in numbers if cell.value]
    shorter = [cell for cell in nonzero if -cell.place < most]
    longer = any(cell.digits > digits and not _fits(cell, digits) for cell in nonzero)
    return not longer and sum(_fits(cell, digits) for cell in shorter) >= _SIGNIFICANT * len(shorter) > 0
