"""The sentences about two things of different dimensions, and about the datum that causes this.

Enters: a `Place`, its `Clash`.  Leaves: sentences.  Used by `dimension_check.py`, `plausibility.py` and `contradicted.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from coursework.system.frozen import frozen
from coursework.variant.dimensions.exponents import NUMBER, Dimension, dimension_of, unit_like, units_shown, what
from coursework.variant.dimensions.formulas import Clash, Term
from coursework.variant.formula.made import unsigned
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.record.places import Place
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

Solved = Callable[[Dimension], Dimension | None]
_MOST_LETTERS = 80


@frozen
class Blame:
    """A datum with a unit: its path, its number and unit as written; `must` is the dimension it would need."""

    path: KeyPath
    name: str
    text: str
    unit: str
    si: str
    must: Dimension | None = None

    @property
    def written(self) -> str:
        """Return the datum as the file writes it."""
        return f'{self.name} = "{f"{self.text} {self.unit}".strip()}"'

    @property
    def needed(self) -> Sentence:
        """Return the name of the dimension it needs."""
        assert self.must is not None
        return what(self.must, "quantity.rad")

    @property
    def advice(self) -> Sentence:
        """Return how to write it with that dimension."""
        assert self.must is not None
        unit = unit_like(self.unit, self.must)
        if unit == "rad" and self.text and self.unit not in {"", "1"} and abs(float(self.text.replace("−", "-"))) > math.tau:
            unit = "deg"  # nobody writes 25 rad
        if unit:
            return say("fault.measures.write", text=f"{self.text} {unit}".strip())
        return say("fault.measures.correct")


def contrast(place: Place, clash: Clash, solved: Solved) -> Sentence:
    """Return a sentence about the dimensions of the two sides of a clash."""
    first, second = _named(clash.first, solved), _named(clash.second, solved)
    tree = text_of(clash.first.tree)
    if clash.kind == "argument":
        which = "angle" if clash.first.tree.op == "@" else "argument"
        if first is None:
            return say(f"fault.measures.{which}_unknown", whole=tree)
        return say(f"fault.measures.{which}", whole=tree, first=first)
    if clash.first.tree.si and second is not None and clash.second.dimension is not None:
        units = units_shown(solved(clash.second.dimension) or NUMBER)
        return say("fault.measures.value", first=first, second=second, units=units)
    other = place.label if clash.kind == "place" else text_of(clash.second.tree)
    if first is None or second is None:
        return say("fault.measures.unlike", tree=tree, other=other)
    if clash.kind == "place":
        return say("fault.measures.two", tree=tree, first=first, other=other, second=second)
    return say("fault.measures.terms", tree=other, first=second, other=tree, second=first)


def disagreement_of(place: Place, clash: Clash) -> Sentence:
    """Return the remark on a formula with a clash in a file whose data have no units."""
    tree = text_of(clash.first.tree)
    if clash.kind == "place" and place.wanted is not None:
        return say("remark.disagreement_place", place=place.label, tree=tree, wanted=what(place.wanted))
    return say("remark.disagreement", place=place.label, first=tree, second=text_of(clash.second.tree))


def fault_of_terms(place: Place, clash: Clash, solved: Solved) -> Sentence:
    """Return the sentence for a clash without a datum to blame."""
    told = contrast(place, clash, solved)
    if clash.kind == "terms":
        return say("fault.V201", contrast=told)
    return say("fault.V202", contrast=told) if clash.first.tree.si else say("fault.V203", contrast=told)


def fault_of_either(blame: Blame, line: int, place: Place, clash: Clash, solved: Solved) -> Sentence:
    """Return the sentence for a clash in which the formula may be wrong as well as the datum."""
    told = contrast(place, clash, solved)
    return say("fault.V204", contrast=told, datum=blame.written, line=line, needed=blame.needed)


def fault_of_datum(blame: Blame, place: Place, clash: Clash, solved: Solved) -> Sentence:
    """Return the sentence that names the datum; `solved` gives dimensions when the datum may have any."""
    found = what(dimension_of(blame.si), "quantity.rad")
    reason = _reason(blame, place, clash, solved)
    return say(
        "fault.V205", datum=blame.written, found=found, reason=reason, name=blame.name, needed=blame.needed, advice=blame.advice
    )


def _reason(blame: Blame, place: Place, clash: Clash, solved: Solved) -> Sentence:
    if clash.kind == "argument":
        return say("fault.measures.takes_angle", whole=text_of(clash.first.tree))
    if clash.kind == "place":
        second = _named(clash.second, solved) or say("fault.measures.else")
        return say("fault.measures.is", label=place.label, tree=text_of(clash.first.tree), second=second)
    mine, other = clash.first, clash.second
    if blame.name not in mine.tree.names():
        mine, other = other, mine
    is_what = None if blame.name in other.tree.names() else _named(other, solved)
    known = {"label": place.label, "tree": text_of(mine.tree), "other": text_of(other.tree)}
    return say("fault.measures.beside_known", **known, what=is_what) if is_what else say("fault.measures.beside", **known)


def _named(term: Term, solved: Solved) -> Sentence | None:
    found = solved(term.dimension if term.dimension is not None else NUMBER)
    return None if found is None else what(found)


def text_of(tree: Formula, most: int = _MOST_LETTERS) -> str:
    """Return a term for a message: without its sign, shortened to `most` letters."""
    text = spelled(unsigned(tree))
    return text if len(text) <= most else f"{text[:most]}…"
