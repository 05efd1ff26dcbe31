"""The names a student may write in an equation, and which declared name each spelling means.

Enters: a `Variant`.  Leaves: `Spellings`.  Used by the readers of equations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from coursework.grading.reading.table.headers import aliases
from coursework.grading.reading.unit_names import fold
from coursework.system.frozen import frozen
from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.tree import spelled
from coursework.variant.record.variant import Variant

BUILT_IN = ("t", "pi")
_AXES = {"0": "x", "pi/2": "y"}
_ROW = re.compile(r"(.*\d|.*(?=_))_?[ijkn]")
_TURNING = re.compile(r"(?:theta|psi|alpha|beta|gamma|q)(\d+)")


@frozen
class Spellings:
    """Declared names, what else they may be written as (folded), the rate of each coordinate, and which names are data.

    `rates` has the angles too of which the variant knows the velocity alone: that of phi4 is w4.  `own` are names that the text
    itself defines: a P of the student's own is not the datum p.
    """

    known: frozenset[str]
    others: dict[str, str]
    rates: dict[str, str]
    data: frozenset[str] = frozenset()
    own: frozenset[str] = frozenset()

    def canonical(self, name: str) -> str | None:
        """Return the declared name that a spelling means, None where there is none."""
        plain = spell(name)
        if _bare(name) in self.own and plain not in self.known:
            return None
        if (meant := self._written(plain)) or not (row := _ROW.fullmatch(plain)):
            return meant
        meant = self._written(row[1])  # in some row, as w3_i or w_{3,i}: a datum has no rows
        return None if meant in self.data else meant

    def _written(self, plain: str) -> str | None:
        return plain if plain in self.known else self.others.get(_bare(plain)) or self.others.get(_key(plain))

    def angle(self, name: str) -> str | None:
        """Return the coordinate that a spelling means, an angle too that has a rate and no column."""
        folded = spell(_key(name))
        turning = _TURNING.sub(r"phi\1", folded)  # by another letter, where the variant calls nothing so
        return self.canonical(name) or next((one for one in (folded, turning) if one in self.rates), None)


def _bare(name: str) -> str:
    return re.sub("[_{}]", "", spell(name))


@lru_cache(512)  # the same few names stand in every line
def _key(name: str) -> str:
    return re.sub("[_']", "", fold(name))


def _speeds(variant: Variant) -> Iterator[tuple[str, str]]:
    """Give how speeds of points may be called: V_C, V_Cy where it is that along y; V_F of a pin on a guide of the frame."""
    for one in (binding for binding in variant.bindings if binding.point and not binding.relative):
        along = spelled(one.along) if one.along else ""
        yield from ((_key(f"v{one.point}{axis}"), one.name) for axis in ("", _AXES.get(along, "")))
    rates = {entry.name: entry.rate for entry in variant.coordinates}
    fixed = {*BUILT_IN, *(entry.name for entry in variant.given)}
    for name, place in variant.points:
        fixed |= {name} if fixed.issuperset(place.names()) else set()
    for group in variant.groups:
        guided = [formula for guide in group.guides for formula in (guide.through, guide.angle, guide.offset)]
        is_rod = group.meets and group.guides and group.lengths  # from a pin on a guide
        if is_rod and all(fixed.issuperset(formula.names()) for formula in guided):
            yield _key(f"v{group.meets}"), rates[group.coordinates[-1]]


@lru_cache(maxsize=16)
def spellings_of(variant: Variant, columns: tuple[tuple[str, str], ...]) -> Spellings:
    """Return the spellings of a variant's names; `columns` are the (name, SI unit) of its table."""
    names = variant.names
    rates = {entry.name: entry.rate for entry in variant.coordinates}
    for name, unit in columns:
        angle = f"phi{name.removeprefix('w')}"
        if unit == "1/s" and name.startswith("w") and name not in rates.values() and angle not in names:
            rates[angle] = name
    speeds = [*_speeds(variant)]
    others = {key: name for key, name in speeds if len({one for same, one in speeds if same == key}) == 1}
    others |= {key: found[0] for key, found in aliases(columns).items() if len(found) == 1 and found[0] in names}
    folded: dict[str, list[str]] = {}
    for name in names:
        folded.setdefault(_key(name), []).append(name)
    # A spelling that could mean two declared names means neither, unless letters tell by their size: ω1 is no W1.
    others |= {
        key: found[0] for key, found in folded.items() if len(found) == 1 and (key not in others or key == _bare(found[0]))
    }
    known = {key: name for key, name in others.items() if len(folded.get(key, ())) < 2}
    known |= {_bare(name): name for name in sorted(names, reverse=True)}
    units = {entry.name: entry.unit for entry in variant.coordinates}
    for spelling, name in [*known.items()]:  # a rate by the name of its coordinate: w_theta
        for symbol in ("w", "omega", "om") if units.get(name) == "rad" else ("v",) if name in units else ():
            known.setdefault(symbol + spelling, rates[name])
    return Spellings(frozenset((*names, *BUILT_IN)), known, rates, frozenset(entry.name for entry in variant.given))
