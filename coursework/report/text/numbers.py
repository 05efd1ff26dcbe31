"""Numbers -> text, only here: as many digits as a number deserves, and never a residual rounded to 0.000.

Enters: floats in SI and their units.  Leaves: strings for a reader.  Used by the report only; templates never round.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from itertools import pairwise

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant

POINT = "."  # the decimal sign of formulas, CSV and most languages
MINUS = "−"
NOTHING = "–"  # stands for a missing number: a check that was skipped, a method that failed
TIGHT = "\u00a0"  # no-break space between a number and its unit
THIN = "\u202f"  # narrow no-break space between groups of three digits
TIMES = "·"
FIGURE, POINT_WIDE = "\u2007", "\u2008"  # spaces as wide as a digit, and as a decimal sign

TABLE_DIGITS = 5  # significant digits of the largest entry of a column, as compared by hand in a coursework
SMALLEST_DECIMAL = 1e-3  # a smaller number would show mostly zeros, so it is written with a power of ten
LARGEST_DECIMAL = 1e5
MOST_DECIMALS = 8
FEW_DIGITS = 3  # significant digits of a number beside others that are larger by powers of ten
SURE_DIGITS = 12  # significant digits of a number that round-off does not affect
MORE_DECIMALS = 3  # decimals of a time after the first digit of the step: 1/120 s is 0.008333
ROUND_OFF = 1e-12  # parts of the largest entry of a column: a smaller entry is a zero with round-off
NOISE = 1e-9  # relative: a smaller difference of two rows is round-off, as after a motion that returns to its start
_SUPERSCRIPTS = str.maketrans("0123456789-−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻")


def superscript(text: str) -> str:
    """Return digits and signs raised: "-7" -> "⁻⁷"."""
    return text.translate(_SUPERSCRIPTS)


@frozen
class Numbers:
    """The writer of numbers of one language; `mark` is its decimal sign, `units` are the units it writes differently."""

    mark: str = POINT
    units: Mapping[str, str] = field(default_factory=dict)

    def fixed(self, value: float, decimals: int, digits: int = FEW_DIGITS) -> str:
        """Return `value` with `decimals`; 0 is "0", and a value that would round to 0.00 is a power of ten with `digits`."""
        if value == 0 or not math.isfinite(value):
            return self._special(value)
        # Two numbers that differ only by round-off are written alike, also if a half has to be rounded.
        text = f"{float(f'{value:.{SURE_DIGITS}g}'):.{decimals}f}"
        return self.power(value, digits) if not text.strip("-0.") else self._dress(text)

    def power(self, value: float, digits: int = FEW_DIGITS) -> str:
        """Return "1.23·10⁻⁷" with `digits` significant digits."""
        if value == 0 or not math.isfinite(value):
            return self._special(value)
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{self._dress(mantissa)}{TIMES}10{superscript(str(int(exponent)))}"

    def scalar(self, value: float | None, digits: int = 4) -> str:
        """Return a single number with `digits` significant digits, but at most 3 if it is written with a power of ten."""
        if value is None:
            return NOTHING
        if not SMALLEST_DECIMAL <= abs(value) < LARGEST_DECIMAL:
            return self.power(value, min(digits, 3))
        exponent = int(f"{value:.{digits - 1}e}".split("e")[1])
        return self._dress(f"{value:.{max(digits - 1 - exponent, 0)}f}")

    def limit(self, value: float | None) -> str:
        """Return a chosen bound, without trailing zeros: "0.1", "1·10⁻¹²"."""
        text = self.scalar(value)
        head, times, power = text.partition(TIMES)
        head = head.rstrip("0").rstrip(self.mark) if self.mark in head else head
        return head + times + power

    def plain(self, value: float, digits: int = 6) -> str:
        """Return a datum without trailing zeros: 0.953 stays "0.953", 30 deg become "0.523599"."""
        if not SMALLEST_DECIMAL <= abs(value) < 10**digits:
            return self.scalar(value, digits)
        text = f"{value:.{digits}g}"
        return self._dress(text)

    def whole(self, value: int) -> str:
        """Return a count, in groups of three digits if it has five or more."""
        text = f"{value:,}".replace(",", THIN) if abs(value) >= 10_000 else str(value)
        return self._dress(text)

    def signed(self, value: int) -> str:
        """Return a count with the sign of the language: -2 -> "−2"."""
        return self._dress(str(value))

    def without_noise(self, value: float, size: float) -> float:
        """Return the difference `value` of two numbers of magnitude `size`, or 0 if it is only round-off."""
        return 0.0 if abs(value) < NOISE * max(abs(size), 1.0) else value

    def column(self, values: Iterable[float], size: float = 0.0, digits: int = TABLE_DIGITS) -> list[str]:
        """Return a column of a table with the same decimals in all entries, also in zeros; the largest has `digits`.

        If most entries would then show none of their digits, or the largest not all, each has three significant digits.

        `size` is the magnitude of the terms that an entry sums up, or of the other coordinate of its point, if that may exceed
        all entries: it decides which entries are round-off.
        """
        entries = [float(value) for value in values]
        noise = ROUND_OFF * max([size, *(abs(value) for value in entries if math.isfinite(value))])
        entries = [0.0 if abs(value) < noise else value for value in entries]
        decimals = deserved_decimals(entries, digits)
        if decimals > MOST_DECIMALS:
            return [self.scalar(value, FEW_DIGITS) for value in entries]
        texts = [self.fixed(value, decimals) if value else self._dress(f"{0:.{decimals}f}") for value in entries]
        if 2 * sum(TIMES in text for text in texts) > sum(map(bool, entries)):
            return [self.scalar(value, FEW_DIGITS) for value in entries]
        return texts

    def times(self, values: Sequence[float]) -> list[str]:
        """Return times with the decimals they need (0.02: two), at most `MORE_DECIMALS` after the first digit of their step."""
        decimals = max((_needed_decimals(value) for value in values), default=0)
        step = min((after - before for before, after in pairwise(values) if after > before), default=0.0)
        if step > 0:
            decimals = min(decimals, max(MORE_DECIMALS - math.floor(math.log10(step) + NOISE), 0))
        return [self._dress(f"{value:.{decimals}f}") for value in values]

    def duration(self, seconds: float) -> str:
        """Return a running time in s, ms or µs with three significant digits."""
        for factor, unit in ((1.0, "s"), (1e3, "ms"), (1e6, "µs")):
            if abs(seconds) * factor >= 1 or unit == "µs":
                return with_unit(self.scalar(seconds * factor, 3), self.units.get(unit, unit))
        raise AssertionError("the last unit takes every duration")

    def dressed(self, text: str) -> str:
        """Return an already formatted number with the signs of this language; an exponent becomes a raised power of ten."""
        head, _, power = self._dress(text).partition("e")
        return f"{head}{TIMES}10{superscript(str(int(power.replace(MINUS, '-'))))}" if power else head

    def _dress(self, text: str) -> str:
        return text.replace("-", MINUS).replace(".", self.mark)

    def _special(self, value: float) -> str:
        return "0" if value == 0 else NOTHING if math.isnan(value) else "∞" if value > 0 else f"{MINUS}∞"


def aligned(texts: Sequence[str], mark: str) -> list[str]:
    """Return numbers with different decimals padded by spaces as wide as digits, so that their decimal signs are aligned.

    >>> [text.replace(FIGURE, "_").replace(POINT_WIDE, "|") for text in aligned(["0.953", "4.5", "13"], ".")]
    ['0.953', '4.5__', '13|___']
    """
    decimals = [len(text.partition(mark)[2]) if TIMES not in text else 0 for text in texts]
    most = max(decimals, default=0)
    return [
        text + (POINT_WIDE if most and not own else "") + FIGURE * (most - own) for text, own in zip(texts, decimals, strict=True)
    ]


def deserved_decimals(values: Iterable[float], digits: int = TABLE_DIGITS) -> int:
    """Return the number of decimals with which the largest entry has `digits` digits."""
    largest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
    if largest == 0:
        return 0
    exponent = int(f"{largest:.{digits - 1}e}".split("e")[1])
    return max(digits - 1 - exponent, 0)


def said_step(step: float) -> float:
    """Return a step as it is said: as it is if it ends, such as 0.0125 s, else with four digits, such as 0.01667 s for 1/60 s."""
    short = float(f"{step:.6g}")
    return step if abs(short - step) <= NOISE * step else float(f"{step:.4g}")


def first_of(motion: Motion, name: str) -> float:
    """Return a column's entry in row 1 (SI), or 0 if it is only round-off compared with the largest entry of the column."""
    column = motion.column(name)
    first = float(column[0])
    return 0.0 if abs(first) < ROUND_OFF * float(abs(column).max()) else first


def shown_column(motion: Motion, name: str, variant: Variant) -> Array:
    """Return a column (SI) with zeros for what is round-off beside the largest entry in its unit: a rod that keeps its angle."""
    unit, column = variant.unit_of(name), motion.column(name)
    alike = (abs(motion.column(one)) for one in motion.names if variant.unit_of(one) == unit)
    largest = max((float(np.max(one[np.isfinite(one)], initial=0.0)) for one in alike), default=0.0)
    return np.where(abs(column) < ROUND_OFF * largest, 0.0, column)


def _needed_decimals(value: float) -> int:
    text = f"{value:.{MOST_DECIMALS}f}".rstrip("0")
    return len(text.partition(".")[2])


def unit_text(unit: str) -> str:
    """Return a unit as it is printed: "m/s^2" -> "m/s²", "N*m" -> "N·m"; "" for a dimensionless number."""
    return "" if unit in {"", "1"} else unit.replace("^2", "²").replace("*", "·").replace("deg", "°").replace("°/s", "deg/s")


def with_unit(number: str, unit: str) -> str:
    """Return "4.5 m/s" with a no-break space; "30°" without one."""
    shown = unit_text(unit)
    if not shown or number == NOTHING:
        return number
    return number + shown if shown == "°" else f"{number}{TIGHT}{shown}"
