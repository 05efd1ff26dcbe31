"""Units of motion: lengths, angles, times, and their quotients.

Enters: nothing.  Leaves: `UNITS` and `KINDS`, and units as advice writes them.  Units that contain a mass are in `mass_units.py`.
Used by `units.py` and by all code that needs the list of units.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction

_CYRILLIC_WORD = re.compile("[А-Яа-я]+")
_TURN = Fraction(math.pi)  # the double nearest to pi, as in every later computation

# Unit -> its size in SI.  Sizes are exact, so that "953 mm" and "0.953 m" give the same double.
_LATIN = {
    "m": {"m": Fraction(1), "cm": Fraction(1, 100), "mm": Fraction(1, 1000),
          "in": Fraction(254, 10_000), "ft": Fraction(3048, 10_000)},
    "rad": {"rad": Fraction(1), "deg": _TURN / 180, "°": _TURN / 180, "grad": _TURN / 180},
    "s": {"s": Fraction(1), "ms": Fraction(1, 1000), "min": Fraction(60)},
    "turn": {"rev": 2 * _TURN, "r": 2 * _TURN, "U": 2 * _TURN},
}  # fmt: skip
_CYRILLIC = {
    "m": {"м": Fraction(1), "см": Fraction(1, 100), "мм": Fraction(1, 1000)},
    "rad": {"рад": Fraction(1), "град": _TURN / 180, "°": _TURN / 180},
    "s": {"с": Fraction(1), "мс": Fraction(1, 1000), "мин": Fraction(60), "хв": Fraction(60)},
    "turn": {"об": 2 * _TURN},
}


def _all_units() -> dict[str, tuple[Fraction, str]]:
    units = {"1": (Fraction(1), "1"), "rpm": (_TURN / 30, "1/s")}
    for script in (_LATIN, _CYRILLIC):
        times, turning = script["s"], {"1": Fraction(1)} | script["rad"] | script["turn"]
        for si in ("m", "rad", "s"):
            units |= {unit: (size, si) for unit, size in script[si].items()}
        for time, seconds in times.items():
            units |= {f"{unit}/{time}": (size / seconds, "m/s") for unit, size in script["m"].items()}
            units |= {f"{unit}/{time}^2": (size / seconds**2, "m/s^2") for unit, size in script["m"].items()}
            units |= {f"{unit}/{time}": (size / seconds, "1/s") for unit, size in turning.items()}
        second, _, *minutes = times
        units |= {f"{unit}/{second}^2": (size, "1/s^2") for unit, size in turning.items()}
        # Machines count turns per minute; 1/s on a task sheet is an angular velocity.
        units |= {f"1/{minute}": (_TURN / 30, "1/s") for minute in minutes}
    return units


UNITS = _all_units()
# A Cyrillic word -> the Latin one of the same size, for units in two scripts: m/с.
LATIN_OF = {
    word: next(latin for latin, its in _LATIN[si].items() if its == size)
    for si, words in _CYRILLIC.items() for word, size in words.items()
}  # fmt: skip
# SI unit -> (length, time) exponents, and the units that advice shows, the SI unit first.
KINDS: dict[str, tuple[tuple[int, int], str]] = {
    "m": ((1, 0), "m, cm, mm"),
    "rad": ((0, 0), "rad, deg"),
    "s": ((0, 1), "s, ms, min"),
    "1/s": ((0, -1), "rad/s, 1/s, deg/s, rpm"),
    "m/s": ((1, -1), "m/s, cm/s, mm/s"),
    "m/s^2": ((1, -2), "m/s^2, cm/s^2, mm/s^2"),
    "1/s^2": ((0, -2), "rad/s^2, 1/s^2, deg/s^2"),
    "1": ((0, 0), "1"),
}


def in_latin(unit: str) -> str:
    """Return a unit of a file in Latin letters, which the words of every language know.

    >>> in_latin("об/мин"), in_latin("кг*м^2"), in_latin("rad/s")
    ('rev/min', 'kg*m^2', 'rad/s')
    """
    known = LATIN_OF
    if not known.keys() >= {*_CYRILLIC_WORD.findall(unit)}:
        from coursework.variant.formula import mass_units

        known = known | mass_units.LATIN_OF
    return _CYRILLIC_WORD.sub(lambda word: known.get(word[0], word[0]), unit)


def advised_unit(si: str) -> str:
    """Return an SI unit in the form used in advice.

    >>> advised_unit("1/s"), advised_unit("m")
    ('rad/s', 'm')
    """
    return KINDS[si][1].partition(",")[0] if si in KINDS else si


def in_order(text: str, wanted: str) -> str:
    """Return how to write a value whose number is missing, in groups ("1 200 mm") or behind its unit ("mm 1200")."""
    groups = re.fullmatch(
        r"\s*([-+−]?\d{1,3}(?:[\s'’_]\d{3})+)\s*([^\W\d_].*?)?\s*|\s*([^\W\d_]+)\s*=?\s*([-+−]?[\d.]+)\s*", text
    )
    last = ((groups[2] or groups[3]) if groups else text.split()[-1] if text.split() else "") or ""
    fits = last in UNITS and wanted in {"", UNITS[last][1]}
    number = re.sub(r"[^-+−\d.]", "", groups[1] or groups[4]) if groups else "0.5"
    return f"{number} {last if fits else advised_unit(wanted) or 'm'}"
