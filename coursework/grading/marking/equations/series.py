"""Lines that a program has one after the other, F(1) = …, F(2) = …: where some are right as what is to vanish, all are meant so.

Enters: marks of lines, as each was read by itself.  Leaves: lines to be read so.  Used by `equations.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Protocol

from coursework.grading.reading.student_work import EquationLine, EquationReading

_STEM = re.compile(r"\s*([^\d=]{1,20})\d{1,2}\s*+[)\]]?\s*+(?:\([\w\s,]*\))?\s*(?::?=|<-)")


class Marked(Protocol):
    """A line with its verdict."""

    @property
    def line(self) -> EquationLine: ...

    @property
    def verdict(self) -> str: ...


def as_others_of_their_kind(
    lines: Sequence[EquationLine], marks: Sequence[Marked], right: Sequence[str]
) -> Iterator[EquationLine]:
    """Give each line, one that is not right as what is to vanish where lines of its kind are `right` so."""
    vanishing = {
        stem
        for line, mark in zip(lines, marks, strict=True)
        if (stem := _stem(line)) and mark.verdict in right and mark.line.guessed and _vanishes(mark.line.repaired)
    }
    for line, mark in zip(lines, marks, strict=True):
        meant = [other for other in line.others if _vanishes(other.text) and _stem(line) in vanishing]
        yield _meant(line, meant[0]) if meant and mark.verdict not in right else line


def _stem(line: EquationLine) -> str:
    found = _STEM.match(line.text)
    return found[1].strip() if found else ""


def _vanishes(text: str) -> bool:
    return text.endswith("= 0")


def _meant(line: EquationLine, reading: EquationReading) -> EquationLine:
    return replace(line, tree=reading.tree, repaired=reading.text, others=(), fault=None, guessed=True)
