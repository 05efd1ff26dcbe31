"""Exponents of length, time and mass as unknowns: linear forms, exact elimination with fractions, names of dimensions.

Enters: linear forms that must vanish.  Leaves: whether they can vanish, and the value of each unknown.
Used by `formulas.py` and where a variant file is read.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from fractions import Fraction

from coursework.variant.formula.motion_units import KINDS, UNITS, advised_unit
from coursework.variant.formula.units import kind_of, measured
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

# A dimension is a sum of terms: exponent times key.  The keys LENGTH, TIME and MASS are known, every other key is an unknown
# dimension (a name of the file, or a number counted from 0).  {} is an angle or a plain number; {"phi": 1, TIME: -1} is the
# unknown dimension of phi, divided by time.
Exponent = int | Fraction
Dimension = Mapping[Hashable, Exponent]
LENGTH, TIME, MASS = -1, -2, -3
_KNOWN = {LENGTH, TIME, MASS}
NUMBER: Dimension = {}


def dimension_of(si: str) -> Dimension:
    """Return the dimension of an SI unit."""
    return {key: exponent for key, exponent in zip((LENGTH, TIME, MASS), kind_of(si)[0], strict=True) if exponent}


def added(first: Dimension, second: Dimension, times: Exponent = 1) -> Dimension:
    """Return the dimension of first * second^times."""
    if not second:
        return first
    total = dict(first)
    for key, exponent in second.items():
        total[key] = total.get(key, 0) + times * exponent
        if not total[key]:
            del total[key]
    return total


class System:
    """Equations between dimensions, solved one by one as they are added."""

    def __init__(self) -> None:
        self.solved: dict[Hashable, Dimension] = {}

    def reduced(self, dimension: Dimension) -> Dimension:
        """Return a dimension with every unknown replaced that has been solved so far."""
        while (known := next((key for key in dimension if key in self.solved), None)) is not None:
            others = {key: exponent for key, exponent in dimension.items() if key != known}
            dimension = added(others, self.solved[known], dimension[known])
        return dimension

    def equal(self, first: Dimension, second: Dimension) -> bool:
        """Require two dimensions to be equal; if they cannot be, add no equation and return False."""
        if first == second:
            return True
        rest = self.reduced(added(first, second, -1))
        unknown = next((key for key in rest if key not in _KNOWN), None)
        if unknown is None:
            return not rest
        factor = rest[unknown]
        self.solved[unknown] = {key: _quotient(-e, factor) for key, e in rest.items() if key != unknown}
        return True


def _quotient(above: Exponent, below: Exponent) -> Exponent:
    if below in {1, -1}:
        return above * below
    value = Fraction(above) / below
    return value.numerator if value.denominator == 1 else value


def is_known(dimension: Dimension) -> bool:
    """Return whether a reduced dimension contains no unknown."""
    return dimension.keys() <= _KNOWN


def si_unit(dimension: Dimension) -> str:
    """Return the SI unit of a known dimension, "" if the tool has no unit for it; angles are "rad"."""
    length, time, mass = (dimension.get(key, 0) for key in (LENGTH, TIME, MASS))
    plain = "" if mass else next((si for si, (its, _) in KINDS.items() if its == (length, time)), "")
    if plain or not mass:
        return plain
    from coursework.variant.formula.mass_units import KINDS as OF_MASS

    return next((si for si, (its, _) in OF_MASS.items() if its == (length, time, mass)), "")


def what(dimension: Dimension, number: str = "quantity.angle_or_number") -> Sentence:
    """Return the name of a known dimension; `number` is the key of the words for a dimensionless one."""
    if not dimension:
        return say(number)
    si = si_unit(dimension)
    return measured(si) if si else say("quantity.other", unit=symbols(dimension))


def units_shown(dimension: Dimension) -> str:
    """Return the units that advice shows for a known dimension, or else its SI symbols."""
    si = si_unit(dimension)
    return kind_of(si)[1] if si else symbols(dimension)


def unit_like(unit: str, dimension: Dimension) -> str:
    """Return the unit of a known dimension that is closest to `unit` of another one: m/s for m, mm for mm/s; "" if none.

    >>> unit_like("mm", dimension_of("m/s"))
    'mm/s'
    """
    si = si_unit(dimension)
    if not si:
        return ""
    above, _, below = unit.partition("/")
    cyrillic = any("а" <= letter <= "я" for letter in unit)
    second = "с" if cyrillic else "s"
    tried = [above, f"{above}/{below.removesuffix('^2')}", f"{above}/{below}", f"{above}/{second}", f"{above}/{second}^2"]
    fitting = [other for other in tried if other in UNITS and UNITS[other][1] == si]
    usual = advised_unit(si)
    return fitting[0] if fitting else _in_cyrillic(usual) if cyrillic else usual


def _in_cyrillic(unit: str) -> str:
    for latin, other in (("rad", "рад"), ("m", "м"), ("s", "с")):
        unit = unit.replace(latin, other)
    return unit


def symbols(dimension: Dimension) -> str:
    """Return a known dimension in kg, m and s, such as m^2/s."""
    powers = [(symbol, dimension.get(key, 0)) for symbol, key in (("kg", MASS), ("m", LENGTH), ("s", TIME))]
    above = "·".join(_power(symbol, exponent) for symbol, exponent in powers if exponent > 0) or "1"
    below = [_power(symbol, -exponent) for symbol, exponent in powers if exponent < 0]
    return f"{above}/({'·'.join(below)})" if len(below) > 1 else "/".join([above, *below])


def _power(symbol: str, exponent: Exponent) -> str:
    if exponent == 1:
        return symbol
    return f"{symbol}^{exponent}" if isinstance(exponent, int) else f"{symbol}^({exponent})"
