"""Text such as "0.953 m" -> a number in SI and its kind.

Enters: a value with its unit.  Leaves: `Quantity` (SI value, unit as written, SI unit).
Used where a variant file is read and where numbers are written for a reader.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction

from coursework.errors import closest

_TURN = Fraction(math.pi)  # the double nearest to pi, as every later computation uses it

# unit -> (factor to SI, SI unit); factors are exact so that "953 mm" and "0.953 m" give the same double
UNITS: dict[str, tuple[Fraction, str]] = {
    "m": (Fraction(1), "m"), "cm": (Fraction(1, 100), "m"), "mm": (Fraction(1, 1000), "m"),
    "rad": (Fraction(1), "rad"), "deg": (_TURN / 180, "rad"), "°": (_TURN / 180, "rad"),
    "s": (Fraction(1), "s"), "ms": (Fraction(1, 1000), "s"),
    "1/s": (Fraction(1), "1/s"), "rad/s": (Fraction(1), "1/s"), "deg/s": (_TURN / 180, "1/s"), "rpm": (_TURN / 30, "1/s"),
    "m/s": (Fraction(1), "m/s"), "cm/s": (Fraction(1, 100), "m/s"), "mm/s": (Fraction(1, 1000), "m/s"),
    "m/s^2": (Fraction(1), "m/s^2"), "1/s^2": (Fraction(1), "1/s^2"), "rad/s^2": (Fraction(1), "1/s^2"),
    "1": (Fraction(1), "1"),
}  # fmt: skip

MAX_NUMBER = 1e12  # far beyond anything a task sheet says in SI
_VALUE = re.compile(
    r"\s*(?P<number>[-+−]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s*(?P<unit>[^\d\s].*?|1/s(?:\^2)?)?\s*$"
)


class UnitFault(ValueError):
    """A value with a unit could not be read."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number in SI; `unit` as the author wrote it ("" for a bare number), `si` the SI unit ("" if bare)."""

    value: float
    unit: str
    si: str
    text: str


def read(text: str | int | float) -> Quantity:
    """Read "value unit" or a bare number.  Raises `UnitFault` with advice."""
    if isinstance(text, bool):
        raise UnitFault(f"a value with a unit was expected, found {str(text).lower()}.")
    if isinstance(text, (int, float)):
        return Quantity(_finite(text, str(text)), "", "", f"{text}")
    match = _VALUE.match(text)
    unit = (match["unit"] or "").replace(" ", "").replace("**", "^").replace("²", "^2") if match else ""
    if not match or (unit and unit not in UNITS):
        raise UnitFault(f'a value with a unit was expected, found "{text[:40]}".{_advice(text, unit)}')
    factor, si = UNITS[unit] if unit else (Fraction(1), "")
    number = match["number"].replace("−", "-")
    value = _finite(float(number), text)
    if value == 0 and re.search("[1-9]", re.split("[eE]", number)[0]):
        raise UnitFault(f'the number "{text[:40]}" is too small to be told from 0.')
    return Quantity(float(Fraction(number) * factor), unit, si, match["number"])


def is_quantity(text: str) -> bool:
    """Return whether `text` looks like "value unit" and not like a formula."""
    match = _VALUE.match(text)
    unit = (match["unit"] or "") if match else "no"
    return match is not None and (not unit or unit in UNITS or re.fullmatch(r"[^\W\d_]+(?:/[^\W\d_]+)?|°", unit) is not None)


def _advice(text: str, unit: str) -> str:
    if re.match(r"\s*[-+−]?\d+,\d", text):
        return " Decimals are written with a point: 0.5."
    if unit:
        # "km" is not "m" written wrongly: only a word that is nearly a unit is taken for it.
        return closest(unit, list(UNITS), 0.7) or f" Known units: {', '.join(UNITS)}."
    return ' Write the number, then its unit: "0.5 m".'


def _finite(value: float, text: str) -> float:
    # Compared before it becomes a double: a TOML integer may have thousands of digits.
    if value != value or abs(value) > MAX_NUMBER:
        raise UnitFault(f'a finite number of at most 1e12 was expected, found "{text[:40]}".')
    return float(value)
