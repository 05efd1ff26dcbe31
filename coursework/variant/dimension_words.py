"""What is said about two things that cannot measure the same, and about the datum that makes it so.

Enters: a `Place`, its `Clash`.  Leaves: sentences.  Used by `dimension_check.py` only.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from coursework.dimensions.exponents import NUMBER, Dimension, dimension_of, unit_like, units_shown, what
from coursework.dimensions.formulas import Clash, Term
from coursework.formula.tree import Formula, spelled
from coursework.variant.places import Path, Place

Solved = Callable[[Dimension], Dimension | None]
_MOST_LETTERS = 80


@dataclass(frozen=True, slots=True)
class Blame:
    """A datum with a unit: where it stands, its number and unit as written; `must` is what it would have to measure."""

    path: Path
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
    def needed(self) -> str:
        """Return what it must be, and how that is written."""
        assert self.must is not None
        unit = unit_like(self.unit, self.must)
        advice = f'Write "{f"{self.text} {unit}".strip()}".' if unit else "Correct its unit, or the formula."
        return f"{self.name} must be {what(self.must, 'an angle')}. {advice}"

    def conditional(self, line: int) -> str:
        """Return the sentence that follows after the terms, where the formula is as likely to be wrong."""
        assert self.must is not None
        return f"If the formula is right, {self.written} (line {line}) must be {what(self.must, 'an angle')}."


def contrast(place: Place, clash: Clash, solved: Solved) -> str:
    """Return what the two sides of a clash are."""
    first, second = _named(clash.first, solved), _named(clash.second, solved)
    if clash.kind == "argument":
        which = "angle behind @" if clash.first.tree.op == "@" else "argument"
        whole = text_of(clash.first.tree)
        if first is None:
            return f"the {which} of {whole} cannot be an angle or a number."
        return f"the {which} of {whole} is {first}; an angle or a number was expected."
    tree = text_of(clash.first.tree)
    if clash.first.tree.si and second is not None and clash.second.dimension is not None:
        return f"{second} was expected: {units_shown(solved(clash.second.dimension) or NUMBER)} (found {first})."
    if first is None or second is None:
        return f"{tree} cannot measure the same as {place.label if clash.kind == 'place' else text_of(clash.second.tree)}."
    if clash.kind == "place":
        return f"{tree} is {first}; {place.label} is {second}."
    return f"{text_of(clash.second.tree)} is {second}, {tree} is {first}."


def advice(clash: Clash) -> str:
    """Return what to do where no datum is to blame; a value of the wrong kind needs no further word."""
    if clash.kind == "terms":
        return "Terms that are added or set equal must measure the same."
    return "" if clash.first.tree.si else "Is a factor missing, or is there one too many?"


def datum_named(blame: Blame, place: Place, clash: Clash, solved: Solved) -> str:
    """Return the sentence that names the datum; `solved` tells what things measure once the datum is free."""
    found = what(dimension_of(blame.si), "an angle")
    return f"{blame.written} is {found}; {_reason(blame, place, clash, solved)}, so {blame.needed}"


def _reason(blame: Blame, place: Place, clash: Clash, solved: Solved) -> str:
    if clash.kind == "argument":
        return f"{text_of(clash.first.tree)} takes an angle"
    if clash.kind == "place":
        return f"{place.label} = {text_of(clash.first.tree)} is {_named(clash.second, solved) or 'something else'}"
    mine, other = clash.first, clash.second
    if blame.name not in mine.tree.names():
        mine, other = other, mine
    is_what = None if blame.name in other.tree.names() else _named(other, solved)
    beside = f"{text_of(other.tree)}, {is_what}" if is_what else text_of(other.tree)
    return f"in {place.label} {text_of(mine.tree)} stands beside {beside}"


def _named(term: Term, solved: Solved) -> str | None:
    found = solved(term.dimension if term.dimension is not None else NUMBER)
    return None if found is None else what(found)


def text_of(tree: Formula) -> str:
    """Return a term as messages show it: without its sign, shortened."""
    text = spelled(_unsigned(tree))
    return text if len(text) <= _MOST_LETTERS else f"{text[:_MOST_LETTERS]}…"


def _unsigned(tree: Formula) -> Formula:
    if tree.op == "neg":
        return _unsigned(tree.args[0])
    if tree.op in {"*", "/", "@"}:
        return replace(tree, args=(_unsigned(tree.args[0]), *tree.args[1:]))
    return tree
