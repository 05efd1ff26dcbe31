"""Text such as "0.953 m" -> a number in SI and its kind, or a message about an unknown unit.

Enters: a value with its unit.  Leaves: `Quantity` (SI value, unit as written, SI unit).
Used where a variant file is read and where numbers are written for a reader.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Mapping
from fractions import Fraction
from functools import lru_cache, partial

from coursework.system.frozen import frozen
from coursework.variant.formula.alphabet import foreign_letter, in_one_alphabet
from coursework.variant.formula.motion_units import KINDS, LATIN_OF, UNITS, in_order
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say

MAX_NUMBER = 1e12  # in SI, far beyond any number on a task sheet
VALUE = re.compile(
    r"\s*(?P<number>[-+−]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s*"
    r"(?P<unit>[^\d\s].*?|1\s*/\s*[^\W\d_].*?)?\s*$"
)
_WORDED = re.compile(r"(?:[^\W\d_]+(?:/[^\W\d_]+(?:\^2)?)?|1/[^\W\d_]+(?:\^2)?|°(?:/[^\W\d_]+(?:\^2)?)?)\Z")
_PER = re.compile(r"(?:([^\W\d_]+|°)[·⋅*]?)?(s|с|min|мин)\^[-−]([12])\Z")
_NO_CARET = re.compile(r"(?<=[^\W\d_])2(?!\w)")
_SIGNS = str.maketrans({"º": "°", "˚": "°", "²": "^2", "⁻": "^-", "¹": "1"})
_LOOK_ALIKE = str.maketrans("acop", "асор")
_WORD = re.compile(r"[^\W\d_]+")
_HERTZ = {"hz", "гц", "khz", "кгц"}


class UnitFault(ValueError):
    """A value with a unit could not be read.

    `advised` makes the message from the SI unit that is needed, for a place where this becomes known later; None if the message
    does not depend on it.
    """

    def __init__(self, message: Sentence, advised: Callable[[str], Sentence] | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.advised = advised


@frozen
class Quantity:
    """A number in SI; `text` and `unit` as the author wrote them (`unit` "" for a bare number), `si` the SI unit ("" if bare)."""

    value: float
    unit: str
    si: str
    text: str

    @property
    def quarters(self) -> Fraction | None:
        """Return an angle in degrees as a whole number of right angles; None for any other quantity."""
        if self.si != "rad" or UNITS[self.unit][0] == 1:
            return None
        right = Fraction(self.text.replace("−", "-")) / 90
        return right if right.denominator == 1 else None


def read(text: str | int | float, wanted: str = "") -> Quantity:
    """Read "value unit" or a bare number.

    `wanted` is the SI unit that the place requires, "" for any; it only guides the advice.
    Raises `UnitFault` with advice.

    >>> read("120 об/мин").si
    '1/s'
    """
    if isinstance(text, bool):
        raise UnitFault(say("fault.V134", text=str(text).lower()))
    if wanted and wanted not in KINDS:
        return read_mass(text, wanted)
    if isinstance(text, (int, float)):
        value = _finite(text, text)
        return Quantity(value, "", "", f"{text}")
    match = VALUE.match(text)
    unit = plain_unit(match["unit"] or "") if match else ""
    if not match or (unit and unit not in UNITS):
        raise UnitFault(unknown(text, unit, wanted), partial(unknown, text, unit))
    return quantity(match["number"], UNITS[unit] if unit else (Fraction(1), ""), unit, text)


def read_mass(text: str | int | float, wanted: str = "") -> Quantity:
    """Read "value unit" or a bare number as `read` does, also with units that contain a mass.  Raises `UnitFault` with advice.

    >>> read_mass("2.5 kN").value, read_mass("0.833 kg·m²").si
    (2500.0, 'kg*m^2')
    """
    from coursework.variant.formula.mass_units import KINDS as OF_MASS
    from coursework.variant.formula.mass_units import REFUSED
    from coursework.variant.formula.mass_units import UNITS as WITH_MASS

    match = VALUE.match(text) if isinstance(text, str) else None
    unit = plain_mass_unit(match["unit"]) if match and match["unit"] else ""
    if match and unit in REFUSED:
        factor, meant = REFUSED[unit]
        advised = f"{float(Fraction(match['number'].replace('−', '-')) * factor):.9g} {meant}"
        raise UnitFault(say("fault.V701", unit=unit, factor=f"{float(factor):.9g} {meant}", advised=advised))
    if match and unit in WITH_MASS:
        if WITH_MASS[unit][1] == "J" and wanted == "N*m":
            raise UnitFault(say("fault.V702", found=str(text)[:40], advised=f"{match['number']} N*m"))
        return quantity(match["number"], WITH_MASS[unit], unit, str(text))
    if match and unit and unit not in UNITS and wanted in {"", *OF_MASS}:
        told = partial(unknown, str(text), unit, of_mass=True)
        raise UnitFault(told(wanted), told)
    return read(text, "" if wanted in OF_MASS else wanted)


def plain_mass_unit(unit: str) -> str:
    """Return a unit in the spelling of the tables, if it is one of theirs: "N·m" and "Nm" become N*m."""
    from coursework.variant.formula import mass_units

    plain = plain_unit(unit).replace("·", "*").replace("⋅", "*").replace("×", "*")
    return mass_units.WITHOUT_SIGN.get(plain) or _in_one_script(plain, mass_units.UNITS, mass_units.LATIN_OF)


def is_mass_quantity(text: str) -> bool:
    """Return whether `text` looks like "value unit"; units with a mass in them, and their products, are allowed."""
    from coursework.variant.formula.mass_units import PARTS

    match = VALUE.match(text)
    unit = plain_mass_unit(match["unit"] or "") if match else "?"
    return is_quantity(text) or PARTS.issuperset(part.removesuffix("^2") for part in re.split("[*/]", unit))


def quantity(written: str, size: tuple[Fraction, str], unit: str, text: str) -> Quantity:
    """Return the quantity of a number as written; `size` is its unit as (factor, SI unit).  Raises `UnitFault`."""
    (factor, si), number = size, written.replace("−", "-")
    value = _finite(float(number), text)
    if value == 0 and re.search("[1-9]", re.split("[eE]", number)[0]):
        raise UnitFault(say("fault.V135", text=text[:40]))
    return Quantity(_finite(float(Fraction(number) * factor), text), unit, si, written)


@lru_cache(maxsize=1000)
def plain_unit(unit: str) -> str:
    """Return a unit in the spelling of `UNITS`: powers with ^2, divisions with a slash ("м·с⁻²" becomes м/с^2)."""
    plain = "".join(unit.split()).translate(_SIGNS).replace("**", "^").replace("^-^", "^-")
    if plain not in UNITS:
        plain = _NO_CARET.sub("^2", plain)  # m/s2, kg*m2
    if plain not in UNITS and not re.search("[A-Za-z]", cyrillic := plain.translate(_LOOK_ALIKE)):
        plain = cyrillic  # a second in Latin letters on a Cyrillic keyboard: 1/c
    if per := _PER.match(plain):
        plain = f"{per[1] or 1}/{per[2]}{'^2' if per[3] == '2' else ''}"
    return _in_one_script(plain, UNITS, LATIN_OF)


def _in_one_script(unit: str, known: Collection[str], latin_of: Mapping[str, str]) -> str:
    """Return a unit with each word in Latin letters if that is one of the `known`: "m/с" and "сm/s" become m/s and cm/s."""

    def latin(found: re.Match[str]) -> str:
        word = found[0]
        if forms := in_one_alphabet(word):
            parts = {part for one in known for part in _WORD.findall(one)}
            meant = {latin_of.get(form, form) for form in forms if form in parts}
            return meant.pop() if len(meant) == 1 else word
        return latin_of.get(word, latin_of.get(word.translate(_LOOK_ALIKE), word))

    return unit if unit in known or (plain := _WORD.sub(latin, unit)) not in known else plain


def is_quantity(text: str) -> bool:
    """Return whether `text` looks like "value unit" rather than a formula."""
    match = VALUE.match(text)
    if match is None:
        return False
    unit = plain_unit(match["unit"] or "")
    return not unit or unit in UNITS or (_WORDED.match(unit) is not None and not unit.startswith(("π", "pi")))


def size_of(unit: str) -> float:
    """Return the size of a unit in SI, 0 for an unknown unit."""
    return float(UNITS[unit][0]) if unit in UNITS else 0.0


def exact_size(unit: str) -> Fraction:
    """Return the exact size of a unit in SI, units with a mass included; 1 for an unknown unit."""
    if unit in UNITS or not unit:
        return UNITS[unit][0] if unit else Fraction(1)
    from coursework.variant.formula import mass_units

    return mass_units.UNITS[unit][0] if unit in mass_units.UNITS else Fraction(1)


def kind_of(si: str) -> tuple[tuple[int, int, int], str]:
    """Return the exponents of length, time and mass of an SI unit, and the units that advice shows."""
    if si in KINDS:
        (length, time), listed = KINDS[si]
        return (length, time, 0), listed
    from coursework.variant.formula import mass_units

    return mass_units.KINDS[si]


def measures(quantity: Quantity, si: str) -> bool:
    """Return whether a quantity is allowed where `si` is required: same kind or bare number, or any if `si` is ""."""
    return not quantity.si or not si or kind_of(quantity.si)[0] == kind_of(si)[0]


def read_as(text: str | int | float, si: str) -> Quantity:
    """Read a quantity of the same kind as `si`, as `read` does.  Raises `UnitFault` with advice."""
    found = read(text, si)
    if not measures(found, si):
        raise UnitFault(unlike(si, text))
    return found


def measured(si: str) -> Sentence:
    """Return the name of the quantity that has an SI unit: a length, an angle."""
    return say(f"quantity.{si}")


def unlike(si: str, found: object) -> Sentence:
    """Return the message about a value that is not of the same kind as `si`."""
    return say("fault.V105", what=measured(si), units=kind_of(si)[1], found=str(found))


def unknown(text: str, unit: str, wanted: str = "", *, of_mass: bool = False) -> Sentence:
    """Return the message about "value unit" with an unknown unit.

    It offers only units of the kind `wanted` (an SI unit, "" for any), and only with a slash if the unit has one.  With
    `of_mass`, units that contain a mass are offered too, because the file may have them.
    """
    found = text[:40]
    if re.match(r"\s*[-+−]?\d+,\d", text):
        return say("fault.V106", found=found, advised=found.replace(",", ".", 1).strip())
    if not unit or not re.search(r"[^\W\d_]|°", unit):
        return say("fault.V107", found=found, advised=in_order(text, wanted))
    if unit.lower() in _HERTZ and wanted in {"", "1/s"}:
        return say("fault.V108", found=found)
    meant = _nearest(unit, (wanted,) if wanted else tuple(KINDS))
    if wanted and not meant:
        return unlike(wanted, found)
    from coursework.variant.formula import mass_units

    if not (meant or of_mass) and plain_mass_unit(unit) in mass_units.UNITS:
        meant = say("hint.mass", unit=unit, known=known_units())
    return say("fault.V109", found=found, hint=meant or say("hint.units", known=known_units(of_mass=of_mass)))


def unknown_unit(unit: str, wanted: str = "") -> Sentence:
    """Return the message about an unknown unit alone, in [unknowns]; `wanted` as in `unknown`."""
    if unit.lower() in _HERTZ:
        return say("fault.V110", found=unit[:40])
    advice = _nearest(unit, (wanted,) if wanted else ("1/s", "m/s"))
    advice = advice or say("hint.units", known=KINDS[wanted][1] if wanted else known_units())
    return say("fault.V111", found=unit[:40], hint=advice)


def known_units(*, of_mass: bool = False) -> str:
    """Return the units that advice shows, grouped by kind; with `of_mass`, also those that contain a mass."""
    listed = [shown for _, shown in KINDS.values() if shown != "1"]
    if of_mass:
        from coursework.variant.formula import mass_units

        listed += [shown for _, shown in mass_units.KINDS.values()]
    return "; ".join(listed)


@lru_cache(maxsize=1000)
def _nearest(unit: str, wanted: tuple[str, ...]) -> str:
    # "km" is not a misspelt "m": only a word that is nearly a unit is taken for it.
    if unit and f"1{unit}" in UNITS:
        return say("hint.closest", name=f"1{unit}")
    if unit.partition("/")[0] in {"o", "о"}:  # a turn in some language; it looks like a degree but is 360 times larger
        return ""
    mixed = next(filter(in_one_alphabet, _WORD.findall(unit)), "")
    if strange := foreign_letter(mixed):
        return say("hint.alphabets", word=mixed, letter=strange[1])
    candidates = [known for known, (_, si) in UNITS.items() if ("/" in known) == ("/" in unit) and si in wanted]
    return closest(unit[:40], candidates, 0.7)


def _finite(value: float, text: str | int | float) -> float:
    # Compared before conversion to float: a TOML integer may have thousands of digits.
    if value != value or abs(value) > MAX_NUMBER:
        raise UnitFault(say("fault.V136", shown=shown(text)))
    return float(value)


def shown(value: str | int | float) -> str:
    """Return a value for a message, shortened; for a very long whole number only the number of its digits."""
    if isinstance(value, int) and abs(value) >= 10**40:
        return say("fault.part.digits", number=int(value.bit_length() * math.log10(2)) + 1)
    return f'"{f"{value}"[:40]}"'
