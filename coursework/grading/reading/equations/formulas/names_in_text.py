"""The names a student may write in an equation -> the declared name that each spelling means.

Enters: a `Variant`.  Leaves: `Spellings`.  Used by the readers of equations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from functools import lru_cache
from itertools import permutations

from coursework.grading.reading.table.headers import aliases
from coursework.grading.reading.unit_names import fold
from coursework.system.frozen import single
from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.record.variant import Variant

BUILT_IN = ("t", "pi")
_AXES = {"0": "x", "pi/2": "y"}
_ROW = re.compile(r"(.*\d|.*(?=_))_?[ijkn]")
_TURNING = re.compile(r"(?:theta|psi|alpha|beta|gamma|q|f|fi|th|ph)(\d+)")


@single
class Spellings:
    """The declared names (`known`), other spellings of them (`others`, folded), the rate of each coordinate, the names of `data`
    and of `angles`, data or not.

    `rates` also has angles of which the variant declares only the velocity: phi4 has the rate w4.  `own` are names that the text
    itself defines, with their formulas as far as known: a P of the student is not the datum p.  `functions` are those of the
    task that have one formula.
    """

    known: frozenset[str]
    others: dict[str, str]
    rates: dict[str, str]
    data: frozenset[str] = frozenset()
    own: Mapping[str, Formula | None] = field(default_factory=dict)
    angles: frozenset[str] = frozenset()
    functions: Mapping[str, Formula] = field(default_factory=dict)

    def canonical(self, name: str) -> str | None:
        """Return the declared name that a spelling means, None if it means none."""
        return _meant(self, name)

    def known_as(self, name: str) -> str | None:
        """Return the declared name that a word is letter by letter, Greek or not; None for any other spelling."""
        return plain if (plain := spell(name)) in self.known and not self.is_own(name) else None

    def written(self, plain: str) -> str | None:
        """Return the declared name that a spelling means as it stands, without an index of a row."""
        return plain if plain in self.known else self.others.get(plain_name(plain)) or self.others.get(_key(plain))

    def angle(self, name: str) -> str | None:
        """Return the coordinate (or other declared name) that a spelling means; also an angle with only its rate declared."""
        folded = spell(_key(name))
        turning = _TURNING.sub(r"phi\1", folded)  # another letter for an angle
        meant = self.canonical(name)
        return meant if meant or self.is_own(name) else next((one for one in (folded, turning) if one in self.rates), None)

    def is_own(self, name: str) -> bool:
        """Return whether the text itself defines a name."""
        return plain_name(name) in self.own and spell(name) not in self.known

    def with_own(self, own: Mapping[str, Formula | None]) -> Spellings:
        """Return the spellings in a text that defines these names: themselves where it defines none, so all that was looked up in
        other texts is known.
        """
        return self if own == self.own else replace(self, own=own)


@lru_cache(4096)  # several readers look at each line in turn, at the same few names in all of them
def _meant(spellings: Spellings, name: str) -> str | None:
    plain = spell(name)
    if spellings.is_own(name):
        return None
    if (meant := spellings.written(plain)) or not (row := _ROW.fullmatch(plain)):
        return meant
    meant = spellings.written(row[1])  # with an index of the row, w3_i or w_{3,i}; data do not depend on the row
    return None if meant in spellings.data else meant


def plain_name(name: str) -> str:
    """Return a name in the form in which meanings are looked up: Greek spelled out, no underscores or braces, case kept."""
    return re.sub("[_{}]", "", spell(name))


@lru_cache(512)  # the same few names occur in every line
def _key(name: str) -> str:
    return re.sub("[_']", "", fold(name))


def _speeds(variant: Variant) -> Iterator[tuple[str, str]]:
    """Yield (spelling, name) for speeds of points: V_C, or V_Cy if it is along y, and V_F of a pin F on a guide of the frame."""
    for one in (binding for binding in variant.bindings if binding.point and not binding.relative):
        along = spelled(one.along) if one.along else ""
        yield from ((_key(f"v{one.point}{axis}"), one.name) for axis in ("", _AXES.get(along, "")))
    rates = {entry.name: entry.rate for entry in variant.coordinates}
    fixed = {*BUILT_IN, *(entry.name for entry in variant.given)}
    for name, place in variant.points:
        fixed |= {name} if fixed.issuperset(place.names()) else set()
    for group in variant.groups:
        guided = [formula for guide in group.guides for formula in (guide.through, guide.angle, guide.offset)]
        is_rod = group.meets and group.guides and group.lengths  # a rod from a pin on a guide
        if is_rod and all(fixed.issuperset(formula.names()) for formula in guided):
            yield _key(f"v{group.meets}"), rates[group.coordinates[-1]]


@lru_cache(maxsize=16)
def spellings_of(variant: Variant, columns: tuple[tuple[str, str], ...]) -> Spellings:
    """Return the spellings of a variant's names; `columns` are the pairs (name, SI unit) of its table."""
    names = variant.names
    rates = {entry.name: entry.rate for entry in variant.coordinates}
    for name, unit in columns:
        angle = f"phi{name.removeprefix('w')}"
        if unit == "1/s" and name.startswith("w") and name not in rates.values() and angle not in names:
            rates[angle] = name
    speeds = [*_speeds(variant)]
    others = {key: name for key, name in speeds if len({one for same, one in speeds if same == key}) == 1}
    for link in (one for one in variant.links if one.rate):  # ω_AB of the link with the points A and B
        pairs = {_key(f"{symbol}{one}{other}") for symbol in ("w", "omega") for one, other in permutations(link.points, 2)}
        others |= {key: link.rate for key in pairs if link.rate and key not in others}
    along = [(_AXES.get(spelled(one.along)), one) for one in variant.bindings if one.along]
    for axis, one in along:
        if one.point and axis:
            rates.setdefault(_key(f"{axis}{one.point}"), one.name)  # dx_C/dt
            if [other for other, _ in along].count(axis) == 1:
                others.setdefault(f"v{axis}", one.name)  # of the only point that is asked for along this axis
    if point := variant.driven:
        others |= {_key(f"v{axis}{point}"): name for axis in "xy" if (name := f"V{point}{axis}") in names}
        rates |= {_key(f"{axis}{point}"): name for axis in "xy" if (name := f"V{point}{axis}") in names}  # ẋ_M, dx_M/dt
    others |= {key: found[0] for key, found in aliases(columns).items() if len(found) == 1 and found[0] in names}
    folded: dict[str, list[str]] = {}
    for name in names:
        folded.setdefault(_key(name), []).append(name)
    # A spelling that fits two declared names means neither, unless capitals decide: ω1 is not W1.
    others |= {
        key: found[0] for key, found in folded.items() if len(found) == 1 and (key not in others or key == plain_name(found[0]))
    }
    known = {key: name for key, name in others.items() if len(folded.get(key, ())) < 2}
    known |= {plain_name(name): name for name in sorted(names, reverse=True)}
    for short, word in (("lam", "lambda"), ("eps", "epsilon")):  # the tool's spelling of a letter, and its full name
        known |= {plain_name(name).replace(short, word): name for name in names if re.fullmatch(rf"{short}(?:_?\w|\d*)", name)}
    units = {entry.name: entry.unit for entry in variant.coordinates}
    for spelling, name in [*known.items()]:  # a rate by the name of its coordinate: w_theta
        for symbol in ("w", "omega", "om") if units.get(name) == "rad" else ("v",) if name in units else ():
            known.setdefault(symbol + spelling, rates[name])
    data = {entry.name: entry.si for entry in variant.given}
    angles = frozenset(name for name, unit in (data | units).items() if unit == "rad")
    functions = {law.name: law.formula for law in variant.functions if law.formula is not None}
    return Spellings(frozenset((*names, *BUILT_IN)), known, rates, frozenset(data), angles=angles, functions=functions)


def place_of_name(name: str, text: str) -> int:
    """Return the offset of a name or a side in a text that may write it in Greek letters, 0 if it does not stand there."""
    written = (word.start() for word in re.finditer(r"\w+", text) if spell(word[0]) == name)
    loosely = re.search(r"[\s*]*".join(map(re.escape, re.findall(r"\w+|[^\w\s*]", name))), text)  # a side, with or without *
    return next(written, loosely.start() if loosely else 0)
