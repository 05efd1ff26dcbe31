"""The names a student may write in an equation, and which declared name each spelling means.

Enters: a `Variant`.  Leaves: `Spellings`.  Used by the readers of equations.
"""

from __future__ import annotations

import re
from functools import lru_cache

from coursework.grading.reading.table.headers import aliases, fold
from coursework.system.frozen import frozen
from coursework.variant.formula.alphabet import spell
from coursework.variant.record.variant import Variant

BUILT_IN = ("t", "pi")


@frozen
class Spellings:
    """Declared names, what else they may be written as (folded), the rate of each coordinate, and which names are data.

    `rates` has the angles too of which the variant knows the velocity alone: that of phi4 is w4.
    """

    known: frozenset[str]
    others: dict[str, str]
    rates: dict[str, str]
    data: frozenset[str] = frozenset()

    def canonical(self, name: str) -> str | None:
        """Return the declared name that a spelling means, None where there is none."""
        plain = spell(name)
        return plain if plain in self.known else self.others.get(_key(name))

    def angle(self, name: str) -> str | None:
        """Return the coordinate that a spelling means, an angle too that has a rate and no column."""
        folded = spell(_key(name))
        return self.canonical(name) or (folded if folded in self.rates else None)


def _key(name: str) -> str:
    return re.sub("[_']", "", fold(name))


@lru_cache(maxsize=16)
def spellings_of(variant: Variant, columns: tuple[tuple[str, str], ...]) -> Spellings:
    """Return the spellings of a variant's names; `columns` are the (name, SI unit) of its table."""
    names = variant.names
    rates = {entry.name: entry.rate for entry in variant.coordinates}
    for name, unit in columns:
        angle = f"phi{name.removeprefix('w')}"
        if unit == "1/s" and name.startswith("w") and name not in rates.values() and angle not in names:
            rates[angle] = name
    others = {key: found[0] for key, found in aliases(columns).items() if len(found) == 1 and found[0] in names}
    folded: dict[str, list[str]] = {}
    for name in names:
        folded.setdefault(_key(name), []).append(name)
    # A spelling that could mean two declared names means neither.
    others |= {key: found[0] for key, found in folded.items() if len(found) == 1}
    known = {key: name for key, name in others.items() if len(folded.get(key, ())) < 2}
    return Spellings(frozenset((*names, *BUILT_IN)), known, rates, frozenset(entry.name for entry in variant.given))
