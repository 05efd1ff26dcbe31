"""Velocity equations as students write them: right in any form, rounded, true on the closure only, or wrong, the slip named.

Enters: lines that were read, a `Key`.  Leaves: `EquationMarks`.  Used by `grade.py`.
A line is judged by numbers at eight positions off the closure, so that only a velocity equation can hold there; scaling,
order, sides and solved forms need no care.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from coursework.grading.marking.equations.edits import Edit, Values, applied, edits
from coursework.grading.marking.equations.numbers import NoValue, real, size_of, value_of
from coursework.grading.marking.equations.probe import Probe, exact_probe, kinds, random_probe
from coursework.grading.marking.key import Key
from coursework.grading.reading.student_work import EquationLine
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula, number, spelled
from coursework.words.errors import Fault

Verdict = Literal["right", "rounded", "closure", "wrong", "unreadable"]
# Residual over the sum of its terms: round-off; data printed with three or four digits; the exact motion's own accuracy.
RIGHT, ROUNDED, ON_CLOSURE = 1e-9, 2e-3, 1e-7
RANK = 1e-8
AFFINE = 1e-9
# Other velocities than the right ones, at which an equation that is affine in them foretells its own residual.
_STRETCHED, _MOVED = 1.7, 0.3
COUNTED = ("right", "rounded", "closure")


@dataclass(frozen=True, slots=True)
class Hint:
    """What would make a wrong line right: `text` is the line so mended; `others` single edits would do as well."""

    kind: Literal["sign", "function", "name", "factor", "repaired", "reader"]
    column: int
    text: str
    others: int = 0
    fault: Fault | None = None

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it; that of a line nobody could read has the code of the fault too."""
        told = {"kind": self.kind, "column": self.column, "text": self.text, "others": self.others}
        return told if self.fault is None else told | {"code": self.fault.code, "values": self.fault.message.plain()}


@dataclass(frozen=True, slots=True)
class EquationMark:
    """One line: its verdict, and a hint where there is one; `mended` is left - right after the edit, for a wrong line."""

    line: EquationLine
    verdict: Verdict
    hint: Hint | None = None

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        hint = self.hint.plain() if self.hint else None
        return {"line": self.line.line, "text": self.line.text, "verdict": self.verdict, "hint": hint}


@dataclass(frozen=True, slots=True)
class EquationMarks:
    """All lines; `independent` of `needed`; `dependent` line numbers that say nothing new; `share` of the points."""

    marks: tuple[EquationMark, ...]
    independent: int
    needed: int
    dependent: tuple[int, ...]

    @property
    def wrong(self) -> tuple[EquationMark, ...]:
        """Return the wrong lines."""
        return tuple(mark for mark in self.marks if mark.verdict == "wrong")

    @property
    def share(self) -> float:
        """Return independent / max(needed, independent + wrong): guessing every combination of signs does not pay."""
        return self.independent / max(self.needed, self.independent + len(self.wrong), 1)


@dataclass(frozen=True)
class Judge:
    """What equations of one variant are tried against."""

    key: Key

    @cached_property
    def off_closure(self) -> Probe:
        """Return the random points."""
        return random_probe(self.key)

    @cached_property
    def on_closure(self) -> Probe:
        """Return rows of the exact motion."""
        return exact_probe(self.key)

    @cached_property
    def kinds(self) -> dict[str, str]:
        """Return which names may stand for each other."""
        return kinds(self.key.variant)

    def mark(self, lines: Sequence[EquationLine]) -> EquationMarks:
        """Return the marks of all lines."""
        marks = tuple(self._mark(line) for line in lines)
        counted = [mark for mark in marks if mark.verdict in COUNTED]
        rows = [self.coefficients(difference(mark.line)) for mark in counted]
        rank = self._rank(rows)
        return EquationMarks(marks, rank, len(self.key.variant.sought), self._dependent(counted, rows, rank))

    def _dependent(self, counted: Sequence[EquationMark], rows: Sequence[Array], rank: int) -> tuple[int, ...]:
        """Return the lines that follow from those before them."""
        if rank == len(rows):
            return ()
        ranks = [self._rank(rows[:count]) for count in range(len(rows) + 1)]
        return tuple(mark.line.line for place, mark in enumerate(counted) if ranks[place + 1] == ranks[place])

    @cached_property
    def _tried(self) -> dict[str, Any]:
        """Return the names at the random points, once with each set of velocities that tells the coefficients apart."""
        probe = self.off_closure
        k = len(probe.sought)
        sets = [np.zeros_like(probe.velocities), *(np.tile(row, (probe.count, 1)) for row in np.eye(k)), self._elsewhere]
        copies = {name: np.tile(value, len(sets)) if np.ndim(value) else value for name, value in probe.names.items()}
        return copies | dict(zip(probe.sought, np.vstack(sets).T, strict=True))

    @cached_property
    def _elsewhere(self) -> Array:
        return _STRETCHED * self.off_closure.velocities + _MOVED

    def coefficients(self, tree: Formula) -> Array:
        """Return A (points, k) of `tree = A u + rest`; NaN where it is not affine in u.  Raises `NoValue`."""
        count, k = self.off_closure.velocities.shape
        with np.errstate(all="ignore"):
            found = real(value_of(tree, self._tried), count * (k + 2)).reshape(k + 2, count)
            rest, slopes = found[0], (found[1:-1] - found[0]).T
            terms = slopes * self._elsewhere
            size = np.abs(rest) + np.sum(np.abs(terms), axis=1)
            affine = np.all(np.abs(found[-1] - rest - np.sum(terms, axis=1)) <= AFFINE * size)
        return slopes if affine else np.full_like(slopes, np.nan)

    def _rank(self, rows: Sequence[Array]) -> int:
        """Return the least rank over the points of the coefficient rows, each scaled to one."""
        if not rows:
            return 0
        stacked = np.stack(rows, axis=1)
        sizes = np.max(np.abs(stacked), axis=2, keepdims=True)
        scaled = stacked / np.where(sizes > 0, sizes, 1.0)
        return int(np.min(np.linalg.matrix_rank(scaled, tol=RANK)))

    def _mark(self, line: EquationLine) -> EquationMark:
        if line.left is None or line.right is None:
            column = line.fault.column if line.fault else 1
            message = line.fault.message if line.fault else ""
            return EquationMark(line, "unreadable", Hint("reader", column, message, fault=line.fault))
        tree = difference(line)
        verdict = self._verdict(tree)
        if verdict == "wrong":
            return EquationMark(line, verdict, self._slip(tree, line))
        repaired = Hint("repaired", 1, line.repaired) if line.repaired else None
        return EquationMark(line, verdict, repaired)

    def _verdict(self, tree: Formula) -> Verdict:
        try:
            if np.isnan(self.coefficients(tree)).any():
                return "wrong"
            off = self._relative(tree, self.off_closure)
            if off <= RIGHT:
                return "right"
            if off <= ROUNDED:
                return "rounded"
            return "closure" if self._relative(tree, self.on_closure) <= ON_CLOSURE else "wrong"
        except NoValue:
            return "wrong"

    def _relative(self, tree: Formula, probe: Probe) -> float:
        """Return the largest residual over the points, as a part of the sum of the sizes of its terms."""
        value = np.abs(real(value_of(tree, probe.names), probe.count))
        size = real(size_of(tree, probe.names), probe.count)
        relative = np.where(size > 0, value / np.where(size > 0, size, 1.0), 0.0)
        return float(np.max(np.where(np.isfinite(relative), relative, np.inf)))

    def _slip(self, tree: Formula, line: EquationLine) -> Hint | None:
        """Return the single edit that makes a line right, the first in the text, with how many others do as well."""
        try:
            values = Values(tree, self.off_closure.names)
        except NoValue:
            return None
        scale = float(np.median(real(size_of(tree, self.off_closure.names), self.off_closure.count))) or 1.0
        found: list[Edit] = []
        for edit in edits(tree, self.kinds):
            after = values.after(edit)
            if after is None or np.iscomplexobj(after) or not np.all(np.abs(after) <= ROUNDED * scale):
                continue
            mended = applied(tree, edit)
            if self._verdict(mended) in {"right", "rounded"} and np.any(np.abs(self.coefficients(mended)) > 0):
                found.append(edit)
        if not found:
            return None
        best = min(found, key=lambda edit: (_PREFERRED.index(edit.kind), edit.column))
        return Hint(best.kind, best.column, _written(applied(tree, best)), len(found) - 1)


_PREFERRED = ("sign", "function", "name", "factor")


def difference(line: EquationLine) -> Formula:
    """Return left - right."""
    assert line.left is not None
    assert line.right is not None
    return Formula("-", (line.left, line.right))


def _written(tree: Formula) -> str:
    """Return `left - right` as an equation again."""
    if tree.op == "-" and len(tree.args) == 2:
        return f"{spelled(tree.args[0])} = {spelled(tree.args[1])}"
    return f"{spelled(tree)} = {spelled(number(0))}"
