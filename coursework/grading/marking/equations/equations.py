"""Velocity equations as students write them: right in any form, rounded, true only on the closure, or wrong, with the slip named.

Enters: lines that were read, a `Key`.  Leaves: `EquationMarks`.  Used by `grade.py`.
A line is judged by its residual at eight positions off the closure, where only a velocity equation can hold; scaling,
order, sides and solved forms need no care.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain

import numpy as np

from coursework.grading.marking.equations.columns import column_in_source, has_sign
from coursework.grading.marking.equations.doubts import asked, question_of, speed_given_by
from coursework.grading.marking.equations.edits import Edit, Values, applied, edits, term_of, unlikeliness, written
from coursework.grading.marking.equations.lacks import lack_of, law_of
from coursework.grading.marking.equations.linear import (
    Linear,
    differing,
    is_fulfilled,
    is_one_slip,
    linear,
    rank,
    says_more,
    usual_size,
)
from coursework.grading.marking.equations.marks import COUNTED, JUDGED, EquationMark, EquationMarks, Hint, Verdict
from coursework.grading.marking.equations.meant_together import as_lists_or_minus, as_others_of_their_kind
from coursework.grading.marking.equations.numbers import NoValue
from coursework.grading.marking.equations.other_forms import with_other_sign, without_ratios
from coursework.grading.marking.equations.own_numbers import own_numbers
from coursework.grading.marking.equations.probe import Probe, exact_probe, kinds, random_probe
from coursework.grading.marking.key.key import Key
from coursework.grading.reading.student_work import EquationLine, EquationReading
from coursework.variant.formula.tree import Formula, constant, spelled
from coursework.words.sentences import say

# Residual over the sum of the terms: for round-off; for data printed with three or four digits; for the exact motion's accuracy.
RIGHT, ROUNDED, ON_CLOSURE = 1e-9, 2e-3, 1e-7


@dataclass(frozen=True)
class Judge:
    """Marks the equations of one variant; holds the points at which they are tried."""

    key: Key

    @cached_property
    def off_closure(self) -> Probe:
        """Return the random points off the closure."""
        return random_probe(self.key)

    @cached_property
    def on_closure(self) -> Probe:
        """Return points of the exact motion."""
        return exact_probe(self.key)

    @cached_property
    def kinds(self) -> dict[str, str]:
        """Return the kind of each name; names of one kind may be mistaken for each other."""
        return kinds(self.key.variant)

    def mark(self, lines: Sequence[EquationLine], *, turning: bool = False, is_told: bool = False) -> EquationMarks:
        """Return the marks of all lines; with `turning`, angular velocities may count clockwise in all of them.

        That is guessed from the lines, unless it `is_told` by a table: what is one linear speed's wrong sign is then none.
        """
        lists = as_lists_or_minus(lines, lambda line: self._mark(line).verdict in COUNTED)
        found = (self._marked(meant, turning, is_told) for meant in lists)
        return max(found, key=lambda marks: sum(mark.verdict in COUNTED for mark in marks.marks))

    def _marked(self, lines: Sequence[EquationLine], turning: bool, is_told: bool) -> EquationMarks:
        alone = tuple(map(self._mark, lines))
        meant = as_others_of_their_kind(lines, [(mark.line, mark.verdict in COUNTED) for mark in alone])
        found = tuple(mark if one is line else self._mark(one) for one, line, mark in zip(meant, lines, alone, strict=True))
        back = self._turned_back(found, is_told) if turning else None
        senses = [self._summed(found), *([self._summed(back, turned=True)] if back else [])]
        return max(senses, key=lambda marks: (marks.share, sum(mark.verdict in COUNTED for mark in marks.marks)))

    def _summed(self, found: Sequence[EquationMark], *, turned: bool = False) -> EquationMarks:
        variant = self.key.variant
        marks = tuple(mark for mark in found if mark.verdict in COUNTED or not mark.line.may_be_datum)
        counted = [mark for mark in marks if mark.verdict in COUNTED]
        independent, dependent = self._independent(counted)
        marks = tuple(self._with_lack(mark, counted, any(mark is other for other in dependent)) for mark in marks)
        speeds = {speed_given_by(mark.line) for mark in marks if independent < len(variant.sought)} - {""}
        marks = tuple(self._asked(mark, speeds) for mark in marks)
        if independent == len(variant.sought):  # all equations are there: other lines are none, but a drive is told
            marks = tuple(m for m in marks if m.verdict != "wrong" or self._names_any(m) or law_of(m.line.difference, variant))
            marks = tuple(mark for mark in marks if not mark.line.passed_over)
        wrong = [mark for mark in marks if mark.verdict == "wrong" and self._names_any(mark)]
        different = differing(_trees(wrong), self.off_closure)
        if different == len(wrong) == 2 and is_one_slip(_trees(wrong), _trees(counted), variant, self.off_closure):
            marks = tuple(replace(mark, lack=say("feedback.lack.one_slip")) if mark is wrong[1] else mark for mark in marks)
            independent, different = max(independent, len(variant.sought) - 1), 1
        if different:  # what is missing is wrong
            marks = tuple(mark for mark in marks if not (mark.line.passed_over and mark.line.is_partial))
        elif independent < len(variant.sought):  # another side of a chain may be the equation that is missing
            chains = (mark.line for mark in counted if mark.line.is_partial)
            marks += tuple(self._mark(asked(line, say("fault.G073", text=line.repaired))) for line in chains)
        return EquationMarks(marks, independent, len(variant.sought), different, turned=turned)

    def _asked(self, mark: EquationMark, speeds: Collection[str]) -> EquationMark:
        """Return the mark of a wrong line that may have been misread as that of a question; any other mark as it is."""
        if mark.verdict != "wrong" or not self._names_any(mark):
            return mark
        question = question_of(mark.line, self.key.variant, self._tells, speeds, is_named=mark.hint is not None)
        return self._mark(question) if question else mark

    def _names_any(self, mark: EquationMark) -> bool:
        """Return whether a line names a sought velocity; one that does not, as T = 2*pi/p, is none of the equations needed."""
        return not {*self.key.variant.sought}.isdisjoint(mark.line.difference.names())

    def _turned_back(self, marks: Sequence[EquationMark], is_told: bool) -> tuple[EquationMark, ...] | None:
        """Return the marks with the sign of all angular velocities turned, None if that corrects no line.

        Nor if the sign of one linear speed corrects the same lines: the file gives its positive direction.
        """
        angular = frozenset(name for name in self.key.velocities if self.key.variant.unit_of(name) == "rad/s")
        both = [(mark, self._mark(with_other_sign(mark.line, angular)) if mark.verdict in JUDGED else mark) for mark in marks]
        back = [before.line for before, after in both if before.verdict == "wrong" and after.verdict in COUNTED]
        speeds = {*self.key.variant.sought} - angular if not is_told else set[str]()
        if not back or any(all(self._mark(with_other_sign(line, {name})).verdict in COUNTED for line in back) for name in speeds):
            return None
        return tuple(before if before.verdict == "wrong" == after.verdict else after for before, after in both)

    def _with_lack(self, mark: EquationMark, counted: Sequence[EquationMark], is_dependent: bool) -> EquationMark:
        """Return the mark with what the line lacks, if it is right and adds nothing, or is wrong by no single slip."""
        if mark.verdict == "unreadable" or (mark.hint if mark.verdict == "wrong" else not is_dependent):
            return mark
        others = [(other.line.where, other.line.difference) for other in counted if other is not mark]
        return replace(mark, lack=lack_of(mark.line.difference, mark.verdict, others, self.key.variant, self.off_closure))

    def _independent(self, counted: Sequence[EquationMark]) -> tuple[int, list[EquationMark]]:
        """Return how many lines are independent, and the lines that follow from those before them.

        If a line is true only on the closure, all must be independent there too; near-copies of rounded lines count once.
        """
        probes = [self.off_closure]
        if any(mark.verdict == "closure" for mark in counted):
            probes.append(self.on_closure)
        taken: list[list[Linear]] = [[] for _ in probes]
        dependent: list[EquationMark] = []
        for mark in sorted(counted, key=lambda mark: mark.verdict == "rounded"):
            lines = [linear(mark.line.difference, probe) for probe in probes]
            more = all(rank([*before, line]) > len(before) for before, line in zip(taken, lines, strict=True))
            if more and mark.verdict == "rounded":
                more = says_more(lines[0], taken[0], ROUNDED)
            if more:
                for before, line in zip(taken, lines, strict=True):
                    before.append(line)
            else:
                dependent.append(mark)
        return len(taken[0]), dependent

    def _mark(self, line: EquationLine) -> EquationMark:
        """Return the mark of a line in the first of its readings that is right; if none is, in the first one."""
        line = without_ratios(line, self.key.variant.sought)
        if line.others and (line.tree is None or not self._tells(line.tree)):
            right = (
                line.read_as(other, others=(), guessed=True)
                for other in line.others
                if not other.asks and self._tells(other.tree)
            )
            line = next(right, line)
        if line.tree is None:
            fault = line.fault  # that of a whole file or key has no column
            reader = Hint("reader", fault.column or 1, fault.message, fault=fault) if fault else Hint("reader", 1, "")
            return EquationMark(line, "unreadable", reader)
        verdict = self._verdict(line.tree)
        if verdict == "wrong":
            meant = (line, *(line.read_as(other) for other in line.others if not other.asks))
            told = chain(map(self._with_own_number, meant), map(self._with_slip, meant))
            return next(filter(None, told), EquationMark(line, verdict))
        repaired = Hint("repaired", 1, line.repaired) if line.repaired else None
        return self._wrong_side(line) or EquationMark(line, verdict, repaired)

    def _wrong_side(self, line: EquationLine) -> EquationMark | None:
        """Return the mark of a side that makes a chain wrong, as 2*v = v = r*w is; numbers are values in some row."""
        probes = (self.off_closure, self.on_closure) if line.sides else ()
        for one in line.sides:
            tree = one.tree
            if not {*map(constant, tree.args)} <= {None, 0} or any(is_fulfilled(tree, probe, ROUNDED) for probe in probes):
                continue
            if {*self.key.variant.sought}.isdisjoint(tree.names()):  # of the known velocities
                tree = Formula("-", (line.difference.args[0], tree.args[0]))
                one = EquationReading(tree, " = ".join(map(spelled, tree.args)))
            mark = self._mark(line.read_as(one, others=()))
            of_data = {*one.tree.args[0].names()} <= {*self.key.variant.values, "pi"}
            if mark.verdict == "wrong" and (mark.hint or not of_data):  # data may be in other units, w1 = pi*n/30 = …
                return mark
        return None

    def _with_own_number(self, line: EquationLine) -> EquationMark | None:
        """Return the mark of a line as right if only a number or a law of the drive in it is not the task's, else None."""
        for own in own_numbers(line.difference, self.key, self.off_closure, ROUNDED):
            if self._tells(own.tree):
                told = Hint("datum", 1, own.written, term=own.meant) if own.meant else None
                return EquationMark(replace(line, tree=own.tree, others=()), self._verdict(own.tree) if told else "rounded", told)
        return None

    def _tells(self, tree: Formula) -> bool:
        """Return whether an equation is right and depends on the velocities."""
        return self._verdict(tree) in COUNTED and bool(np.any(linear(tree, self.off_closure).directions))

    def _verdict(self, tree: Formula) -> Verdict:
        try:
            off = linear(tree, self.off_closure)
            if not off.is_affine:
                return "wrong"
            if off.residual <= RIGHT:
                return "right"
            if off.is_near(ROUNDED) and any(node.op == "number" for node in tree.walk()):
                return "rounded"
            return "closure" if linear(tree, self.on_closure).residual_of_scale <= ON_CLOSURE else "wrong"
        except NoValue:
            return "wrong"

    def _with_slip(self, line: EquationLine) -> EquationMark | None:
        """Return the mark of a wrong line with the likeliest single edit that makes it right as a hint, None if none does.

        Its line is the one of the file in which that stands.
        """
        tree, read = line.difference, line.repaired or line.text
        if not (found := self.slips(tree, read)):
            return None
        best, source = found[0], line.source or line.text
        place = column_in_source(source, line.text, read, best.column, is_sign=best.kind == "sign")
        before = source[: place - 1].split("\n")
        text, term = written(applied(tree, best)), spelled(term_of(tree, best))
        hint = Hint(best.kind, len(before[-1]) + 1, text, len(found) - 1, term=term)
        return EquationMark(replace(line, line=line.line + len(before) - 1), "wrong", hint)

    def slips(self, tree: Formula, read: str) -> list[Edit]:
        """Return all single edits that make a wrong line right, the likeliest first; `read` is the text of the line as read."""
        try:
            values = Values(tree, self.off_closure.names)
            scale = usual_size(tree, self.off_closure)
        except NoValue:
            return []
        found: list[Edit] = []
        for edit in edits(tree, self.kinds, self.key.variant.values):
            after = values.after(edit)
            if after is None or np.iscomplexobj(after) or not np.all(np.abs(after) <= ROUNDED * scale):
                continue
            mended = applied(tree, edit)
            if self._verdict(mended) in {"right", "rounded"} and np.any(linear(mended, self.off_closure).directions):
                found.append(edit)

        def rank(edit: Edit) -> tuple[int, ...]:
            return unlikeliness(tree, edit, is_new_sign=edit.kind == "sign" and not has_sign(read, edit.column))

        return sorted(found, key=rank)


def _trees(marks: Sequence[EquationMark]) -> list[Formula]:
    return [mark.line.difference for mark in marks]
