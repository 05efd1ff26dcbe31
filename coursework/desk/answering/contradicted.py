"""Written equations that the geometry contradicts: which term differs and how; other equations keep their verdicts.

Enters: a `Desk` and its faults.  Leaves: those faults, each at its term, and a verdict per equation.  Used by `bench.py` and, for
a file, by `commands/contradictions.py`.
The search is that of the grading, with the velocities that the geometry gives.  The right term is not revealed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.api import make_run
from coursework.desk.answering.derived import agreed_of, judged, lacking
from coursework.desk.answering.edits import line_and_column
from coursework.desk.answering.typed import Desk, faults_of
from coursework.desk.job import Answer, fault_entry, faulty
from coursework.equations.reduction.equations import differentiate
from coursework.grading.marking.equations.columns import column_as_handed_in
from coursework.grading.marking.equations.differing import difference_of
from coursework.grading.marking.equations.edits import Edit, applied
from coursework.grading.marking.equations.equations import RIGHT, Judge
from coursework.grading.marking.equations.linear import NOTHING, Linear, is_same, linear
from coursework.grading.marking.equations.numbers import value_of
from coursework.grading.marking.key.key import key_of
from coursework.mechanism.mechanism import build
from coursework.scene.quantities import TABLE
from coursework.variant.formula.tree import Formula
from coursework.variant.judging.dimension_words import text_of
from coursework.variant.record.entries import Constraint
from coursework.variant.record.other_values import Changes
from coursework.variant.record.variant import Variant
from coursework.variant.toml.rewriting import place_of
from coursework.words.errors import CourseworkError, Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

CONTRADICTS = "V302"
_OTHER_WAY = "fault.bound.other_way"
_LONGEST = 60  # characters of a term within a sentence
_MOST = 10  # wrong equations that are searched, each for a tenth of a second at most
Slip = tuple[Sentence, int]  # the sentence on a term that differs, and its column in the equation, 0 if it is missing there
Answering = Callable[[Desk], dict[str, Any] | Answer]


def naming_terms(kind: str, made: Answering) -> Answering:
    """Return a function that answers as `made` does, but names the differing term of equations that contradict the geometry.

    `kind` is that of the job.
    """

    def answer(desk: Desk) -> dict[str, Any] | Answer:
        try:
            return made(desk)
        except InputError as error:
            if any(fault.code != CONTRADICTS for fault in error.faults):
                raise
            return _contradicted(kind, error, desk)

    return answer


def with_terms(error: InputError, variant: Variant, text: str) -> InputError:
    """Return an error in which each equation that contradicts the geometry names the term of its `text` that differs, if any."""
    wrong = {str(fault.message.values["name"]): fault for fault in error.faults if fault.code == CONTRADICTS}
    if not wrong:
        return error
    slips = _slips(wrong, variant, text)[1]
    for name, fault in wrong.items():
        advice = say("fault.contradicts.slip", how=slips[name][0]) if name in slips else say("fault.contradicts.many")
        wrong[name] = replace(fault, message=say(fault.message.key, **{**fault.message.values, "advice": advice}))
    return InputError([wrong.get(str(fault.message.values.get("name")), fault) for fault in error.faults])


def _slips(wrong: Collection[str], variant: Variant, text: str) -> tuple[tuple[str, ...], dict[str, Slip]]:
    """Return the names of the equations that agree, and the slip of each of the `wrong` ones that has one."""
    agreed, slips = tuple[str, ...](), dict[str, Slip]()
    with suppress(CourseworkError):  # without the wrong equations the text may describe no mechanism
        right = _without(wrong, variant)
        agreed = agreed_of(make_run(right, quantities=[TABLE.name]))
        judge, written = Judge(key_of(right)), [one for one in variant.constraints if not one.is_closure]
        others = [linear(one.difference, judge.off_closure) for one in written if one.name in agreed and one.name not in wrong]
        searched = [one for one in written if one.name in wrong][:_MOST]
        slips = {one.name: slip for one in searched if (slip := _slip(one, judge, others, text))}
    return agreed, slips


def _contradicted(kind: str, error: InputError, desk: Desk) -> Answer:
    wrong = {str(fault.message.values["name"]): fault for fault in error.faults}
    agreed, slips = _slips(wrong, desk.variant, desk.text)
    entries = [
        _entry(fault, slips[name], desk) if name in slips else entry
        for (name, fault), entry in zip(wrong.items(), faults_of(error, desk), strict=False)
    ]
    told = {name: slips[name][0] if name in slips else "" for name in wrong}
    return faulty(kind, entries, equations=judged(desk, agreed, told))


def _without(names: Collection[str], variant: Variant) -> Variant:
    """Return the variant with the equations `names` replaced by those that follow from the geometry."""
    rest = replace(variant, constraints=tuple(one for one in variant.constraints if one.name not in names))
    found = differentiate(build(rest))
    more = tuple(Constraint(one.name, one.because, *one.shown(found.order)) for one in lacking(found))

    def reread(_: Variant, changes: Changes) -> Variant:
        return _without(names, again(variant, changes)) if again is not None else rest

    again = variant.reread  # of the text, in which the wrong equations stand: where a motion is computed for other data
    return replace(rest, constraints=(*rest.constraints, *more), reread=reread)


def _slip(one: Constraint, judge: Judge, others: Sequence[Linear], whole: str) -> Slip | None:
    """Return the one slip in an equation, or None; a change that would make it equal to one of the `others` does not count."""
    tree = one.difference
    text, probe = _text(one, whole)[1], judge.off_closure
    for edit in judge.slips(tree, text):
        mended = linear(applied(tree, edit), probe)
        # A replacement that is zero, such as a zero name or a factor sin(pi), means that the term does not belong there.
        is_nothing = edit.kind in {"name", "factor"} and np.all(np.abs(value_of(edit.replacement, probe.names)) < NOTHING)
        if mended.residual <= RIGHT and not is_nothing and not any(is_same(mended, other) for other in others):
            column = column_as_handed_in(text, text, edit.column, is_sign=True) if edit.kind == "sign" else edit.column
            return say(f"desk.slip.{edit.kind}", term=text_of(_edited(tree, edit), _LONGEST)), column
    differs = difference_of(tree, judge.key.variant, probe, others)
    return (say(f"desk.slip.{differs.kind}", term=text_of(differs.term, _LONGEST)), differs.column) if differs else None


def _edited(tree: Formula, edit: Edit) -> Formula:
    """Return the part of a formula to show for an edit: the edited name or call itself, else the term that it changes."""
    term = tree
    for place in edit.path:
        within, tree = tree.op, tree.args[place]
        # The minus of -R*w belongs to R as it is read, and to the term as it is seen.
        term = term if within in {"*", "/", "^"} or (within == "neg" and term.op in {"*", "/"}) else tree
    if edit.kind in {"function", "name"}:
        return tree
    if tree.op in {"+", "-"}:
        return tree.args[1]
    return term


def _entry(fault: Fault, slip: Slip, desk: Desk) -> dict[str, Any]:
    """Return a fault at the term that differs, or at the begin of the equation if a term is missing."""
    how, column = slip
    name, sections, about = (fault.message.values[name] for name in ("name", "sections", "about"))
    about = about if isinstance(about, Sentence) and about.key == _OTHER_WAY else ""
    sentence = desk.words.written(say("desk.equation_differs", name=name, sections=sections, how=how, about=about))
    own = next(one for one in desk.variant.constraints if one.name == name)
    begin, text = _text(own, desk.text)
    # The place of a missing term is the text between the quotes.
    line, place = line_and_column(desk.text, begin + column - 1) if text else (fault.line, 0)
    return fault_entry(fault.code, sentence, line, place)


def _text(one: Constraint, whole: str) -> tuple[int, str]:
    """Return the offset (from 0) and the text of an equation; (0, "") if it contains escapes."""
    begin, end = place_of(whole, one.path) or (0, 0)
    begin += whole.startswith("\n", begin)  # a line break after three quotes is not part of the value
    text = whole[begin:end]
    return (begin, text) if "\\" not in text else (0, "")
