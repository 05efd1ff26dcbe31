"""Numbers -> text, in this one place: as many digits as deserved, never a residual rounded to 0.000.

Enters: floats in SI and their units.  Leaves: strings for a reader.  Used by the report only; templates never round.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from itertools import pairwise

from coursework.motion.integration.motion import Motion
from coursework.system.frozen import frozen

POINT = "."  # the decimal sign of formulas, CSV and most languages
MINUS = "−"
NOTHING = "–"  # no number: a check that was skipped, a method that failed
TIGHT = "\u00a0"  # a space that does not break, between a number and its unit
THIN = "\u202f"  # narrow, not breaking: between groups of three digits
TIMES = "·"
FIGURE, POINT_WIDE = "\u2007", "\u2008"  # spaces as wide as a digit, as a decimal sign

TABLE_DIGITS = 5  # significant digits of the largest entry of a column: what a coursework compares by hand
SMALLEST_DECIMAL = 1e-3  # below this a fixed number shows mostly zeros, so powers of ten take over
LARGEST_DECIMAL = 1e5
MOST_DECIMALS = 8
FEW_DIGITS = 3  # of a number beside others that are larger by powers of ten
SURE_DIGITS = 12  # that round-off leaves of a number
MORE_DECIMALS = 3  # of a time, beyond the first digit of the step: 1/120 s is 0.008333
ROUND_OFF = 1e-12  # of the largest entry of a column: below it stands what is left of a zero
NOISE = 1e-9  # of a difference of two rows: what a motion that returns leaves behind
_SUPERSCRIPTS = str.maketrans("0123456789-−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁻")


def superscript(text: str) -> str:
    """Return digits and signs raised: "-7" -> "⁻⁷"."""
    return text.translate(_SUPERSCRIPTS)


@frozen
class Numbers:
    """The writer of numbers of one language; `mark` is its decimal sign, `units` how it writes units, where otherwise."""

    mark: str = POINT
    units: Mapping[str, str] = field(default_factory=dict)

    def fixed(self, value: float, decimals: int, digits: int = FEW_DIGITS) -> str:
        """Return `value` with so many decimals; 0 is "0", what would round to 0.00 a power of ten of so many `digits`."""
        if value == 0 or not math.isfinite(value):
            return self._special(value)
        # Two numbers that differ by round-off alone are written alike, also where a half is to be rounded.
        text = f"{float(f'{value:.{SURE_DIGITS}g}'):.{decimals}f}"
        return self.power(value, digits) if not text.strip("-0.") else self._dress(text)

    def power(self, value: float, digits: int = FEW_DIGITS) -> str:
        """Return "1.23·10⁻⁷" with `digits` significant digits."""
        if value == 0 or not math.isfinite(value):
            return self._special(value)
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{self._dress(mantissa)}{TIMES}10{superscript(str(int(exponent)))}"

    def scalar(self, value: float | None, digits: int = 4) -> str:
        """Return one number on its own: `digits` significant, in powers of ten where small (3 digits) or large."""
        if value is None or math.isnan(value):
            return NOTHING
        if value == 0 or math.isinf(value):
            return self._special(value)
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
        if value == 0 or not SMALLEST_DECIMAL <= abs(value) < 10**digits:
            return self.scalar(value, digits)
        text = f"{value:.{digits}g}"
        return self._dress(text)

    def whole(self, value: int) -> str:
        """Return a count; from five digits on in groups of three."""
        text = f"{value:,}".replace(",", THIN) if abs(value) >= 10_000 else str(value)
        return self._dress(text)

    def signed(self, value: int) -> str:
        """Return a count with the sign of the language: -2 -> "−2"."""
        return self._dress(str(value))

    def without_noise(self, value: float, size: float) -> float:
        """Return a difference of numbers of a `size`, 0 where it is round-off."""
        return 0.0 if abs(value) < NOISE * max(abs(size), 1.0) else value

    def column(self, values: Iterable[float], size: float = 0.0) -> list[str]:
        """Return a column of a table, all entries with the same decimals (see `TABLE_DIGITS`), zero and its round-off too.

        Where most entries would show none of their digits so, all of them are rounded to three.

        `size`: how large the terms are that an entry is the sum of, or the entries of the other axis of its point, where
        they may be larger than every entry.
        """
        entries = [float(value) for value in values]
        noise = ROUND_OFF * max([size, *(abs(value) for value in entries if math.isfinite(value))])
        entries = [0.0 if abs(value) < noise else value for value in entries]
        decimals = deserved_decimals(entries)
        texts = [self.fixed(value, decimals) if value else self._dress(f"{0:.{decimals}f}") for value in entries]
        if 2 * sum(TIMES in text for text in texts) > sum(map(bool, entries)):
            return [self.scalar(value, FEW_DIGITS) for value in entries]
        return texts

    def times(self, values: Sequence[float]) -> list[str]:
        """Return times with the decimals they need (0.02 -> two), at most `MORE_DECIMALS` beyond the first of their step."""
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
        """Return a number that is formatted already with the signs of this language; powers of ten raised."""
        head, _, power = self._dress(text).partition("e")
        return f"{head}{TIMES}10{superscript(str(int(power.replace(MINUS, '-'))))}" if power else head

    def _dress(self, text: str) -> str:
        return text.replace("-", MINUS).replace(".", self.mark)

    def _special(self, value: float) -> str:
        return "0" if value == 0 else NOTHING if math.isnan(value) else "∞" if value > 0 else f"{MINUS}∞"


def aligned(texts: Sequence[str], mark: str) -> list[str]:
    """Return numbers of different decimals with spaces as wide as digits behind them: decimal sign below decimal sign.

    >>> [text.replace(FIGURE, "_").replace(POINT_WIDE, "|") for text in aligned(["0.953", "4.5", "13"], ".")]
    ['0.953', '4.5__', '13|___']
    """
    decimals = [len(text.partition(mark)[2]) if TIMES not in text else 0 for text in texts]
    most = max(decimals, default=0)
    return [
        text + (POINT_WIDE if most and not own else "") + FIGURE * (most - own) for text, own in zip(texts, decimals, strict=True)
    ]


def deserved_decimals(values: Iterable[float]) -> int:
    """Return the decimals that give the largest entry `TABLE_DIGITS` digits."""
    largest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
    if largest == 0:
        return 0
    exponent = int(f"{largest:.{TABLE_DIGITS - 1}e}".split("e")[1])
    return min(max(TABLE_DIGITS - 1 - exponent, 0), MOST_DECIMALS)


def first_of(motion: Motion, name: str) -> float:
    """Return a column's entry of row 1 (SI), 0 where it is round-off beside the others of its column."""
    column = motion.column(name)
    first = float(column[0])
    return 0.0 if abs(first) < ROUND_OFF * float(abs(column).max()) else first


def _needed_decimals(value: float) -> int:
    text = f"{value:.{MOST_DECIMALS}f}".rstrip("0")
    return len(text.partition(".")[2])


def unit_text(unit: str) -> str:
    """Return a unit as it is printed: "m/s^2" -> "m/s²", "N*m" -> "N·m"; a bare number has none."""
    return "" if unit in {"", "1"} else unit.replace("^2", "²").replace("*", "·").replace("deg", "°").replace("°/s", "deg/s")


def with_unit(number: str, unit: str) -> str:
    """Return "4.5 m/s" with a space that does not break; "30°" without one."""
    shown = unit_text(unit)
    if not shown or number == NOTHING:
        return number
    return number + shown if shown == "°" else f"{number}{TIGHT}{shown}"
