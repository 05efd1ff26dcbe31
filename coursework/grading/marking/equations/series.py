"""Lines in a series, F(1) = …, F(2) = …, or cells =…, =…: if some are right when the right side is set to 0, all are read so.

Enters: marks of lines, each read by itself.  Leaves: the lines as they are to be read.  Used by `equations.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Protocol

from coursework.grading.reading.equations.labels import without_labels
from coursework.grading.reading.student_work import EquationLine, EquationReading

_STEM = re.compile(r"\s*([^\d=]{1,20})\d{1,2}\s*+[)\]]?\s*+(?:\([\w\s,]*\))?\s*(?::?=|<-)")

_UNNAMED = "="


class Marked(Protocol):
    """A line with its verdict."""

    @property
    def line(self) -> EquationLine: ...

    @property
    def verdict(self) -> str: ...


def as_others_of_their_kind(
    lines: Sequence[EquationLine], marks: Sequence[Marked], right: Sequence[str]
) -> Iterator[EquationLine]:
    """Yield each line; one that is not right is read as "… = 0" if lines of its series are `right` in that reading."""
    vanishing = {
        stem
        for line, mark in zip(lines, marks, strict=True)
        if (stem := _stem(line)) and mark.verdict in right and mark.line.guessed and _vanishes(mark.line.repaired)
    }
    for line, mark in zip(lines, marks, strict=True):
        is_open = _stem(line) in vanishing and not _vanishes(line.repaired)
        meant = [other for other in line.others if is_open and _vanishes(other.text)]
        yield _meant(line, meant[0]) if meant and mark.verdict not in right else line


def _stem(line: EquationLine) -> str:
    found = _STEM.match(line.text)
    if without_labels(line.text).lstrip().startswith(_UNNAMED):
        return _UNNAMED
    return found[1].strip() if found else ""


def _vanishes(text: str) -> bool:
    return text.endswith("= 0") or text.startswith("0 = ")


def _meant(line: EquationLine, reading: EquationReading) -> EquationLine:
    return replace(line, tree=reading.tree, repaired=reading.text, others=(), fault=None, guessed=True)
