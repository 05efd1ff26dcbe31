"""What a line lacks that earns nothing although it has no slip of the pen: it names no velocity, or repeats other lines.

Enters: marked lines, a `Probe`.  Leaves: a `Sentence` for each line.  Used by `equations.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from coursework.grading.marking.equations.edits import places
from coursework.grading.marking.equations.linear import linear, rank
from coursework.grading.marking.equations.numbers import NoValue, real, value_of
from coursework.grading.marking.equations.probe import Probe
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

ON_CLOSURE = "closure"
_SAME = 1e-9
Other = tuple[Sentence, Formula]  # the place of a line, and its left - right


def lack_of(tree: Formula, verdict: str, others: Sequence[Other], variant: Variant, probe: Probe) -> Sentence | str:
    """Return what a line (`left - right`) lacks, "" if that cannot be told; `others` are the other lines that count."""
    named = {node.name for node in tree.walk() if node.op == "name"}
    driven = {"t", *variant.known_rates, *(law.name for law in variant.drive)}
    try:
        line = linear(tree, probe)
        if not named & {*variant.sought}:
            if verdict == "right" and not named & driven:
                return say("feedback.lack.any_motion")
            if verdict == "wrong" and (law := law_of(tree, variant)):
                return say("feedback.lack.drive", law=law)
            still = named & {one.name for one in variant.coordinates} and not named & driven - {"t"}
            key = "position" if still or verdict == ON_CLOSURE else "no_velocity"
            return say(f"feedback.lack.{key}", names=tuple(variant.sought))
        if not line.is_affine:
            return say("feedback.lack.not_linear")
        if not np.any(line.directions):
            return say("feedback.lack.any_motion")
        if verdict == "wrong":
            return _lacks_term(tree, variant, probe)
        known = [(where, linear(other, probe)) for where, other in others]
        same = [where for where, other in known if np.any(other.directions) and rank([line, other]) < 2]
    except NoValue:
        return ""
    return say("feedback.lack.repeats", place=same[0]) if same else say("feedback.lack.follows")


def law_of(tree: Formula, variant: Variant) -> str:
    """Return the law of the task for what a line gives as a function of time, "" if it gives no velocity that is driven."""
    named = {*tree.names()}
    rest = {"t", *(one.name for one in variant.given)}
    laws = [law for law in variant.drive if law.formula is not None and law.name in named and named <= {law.name, *rest}]
    return f"{laws[0].name} = {spelled(laws[0].formula)}" if laws and laws[0].formula is not None else ""


def _lacks_term(tree: Formula, variant: Variant, probe: Probe) -> Sentence | str:
    """Return the term of an equation of the task that a line leaves out, "" if no single term corrects the line."""
    left = real(value_of(tree, probe.names), probe.count)
    terms = (
        node for equation in variant.constraints for path, node, is_term, _ in places(equation.difference) if is_term and path
    )
    for node in terms:
        term = real(value_of(node, probe.names), probe.count)
        for sign, off in (("-", left - term), ("+", left + term)):
            is_short = np.max(np.abs(off)) <= _SAME * np.max(np.abs(term))
            if is_short and np.any(linear(Formula(sign, (tree, node)), probe).directions):
                return say("feedback.lack.term", term=spelled(node))
    return ""
