"""The marks of equations: each line with its verdict, how many are independent, and which are questions to a person.

Enters: nothing.  Leaves: `Hint`, `EquationMark`, `EquationMarks`.
Used by `equations.py`, `grade.py`, `verdicts.py`, `questions.py`, `misconceptions.py`, `hypotheses.py`, `own_equations.py` and
the reasons for points in `table.py` and `equations.py`.
"""

from __future__ import annotations

from typing import Any, Literal

from coursework.grading.reading.student_work import EquationLine
from coursework.grading.reading.submission import Note, note
from coursework.system.frozen import frozen
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined

Verdict = Literal["right", "rounded", "closure", "wrong", "unreadable"]
COUNTED = ("right", "rounded", "closure")
JUDGED = (*COUNTED, "wrong")


@frozen
class Hint:
    """What would make a wrong line right: `text` is the corrected line; `others` counts further single edits that also do.

    `column` is that of the line as handed in, which a document or a cell may show otherwise; `term` is what stands there.
    """

    kind: Literal["sign", "function", "name", "factor", "datum", "repaired", "reader"]
    column: int
    text: str
    others: int = 0
    fault: Fault | None = None
    term: str = ""

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it; for a line that could not be read, with the code of the fault."""
        told = {"kind": self.kind, "column": self.column, "text": self.text, "others": self.others}
        return told if self.fault is None else told | {"code": self.fault.code, "values": self.fault.message.plain()}


@frozen
class EquationMark:
    """One line: its verdict, a hint if there is one, and what it lacks if it earns nothing and no slip is found."""

    line: EquationLine
    verdict: Verdict
    hint: Hint | None = None
    lack: Sentence | str = ""

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it."""
        hint = self.hint.plain() if self.hint else None
        return {"line": self.line.line, "place": self.line.where, "text": self.line.text, "verdict": self.verdict, "hint": hint}


@frozen
class EquationMarks:
    """The marks of all lines: `independent` of `needed` equations; `different` counts the wrong lines.

    The same wrong line written twice is one fault. `turned` says that lines were marked with the opposite sign of all angular
    velocities, because they hold so.
    """

    marks: tuple[EquationMark, ...]
    independent: int
    needed: int
    different: int
    turned: bool = False

    @property
    def wrong(self) -> tuple[EquationMark, ...]:
        """Return the wrong lines."""
        return tuple(mark for mark in self.marks if mark.verdict == "wrong")

    @property
    def questions(self) -> tuple[EquationMark, ...]:
        """Return the lines that could not be read and may earn points: all of them if none could; empty if none is missing."""
        unread = [mark for mark in self.marks if mark.verdict == "unreadable" and self.independent < self.needed]
        return tuple(mark for mark in unread if mark.line.relates or (len(unread) == len(self.marks) and not mark.line.is_prose))

    @property
    def unread(self) -> EquationMark | None:
        """Return the first line in `questions`, None if there is none."""
        return next(iter(self.questions), None)

    @property
    def notes(self) -> tuple[Note, ...]:
        """Return notes for a person: how many lines were completed in order to read them, which numbers are not the task's."""
        guessed = sum(mark.line.guessed and mark.verdict != "unreadable" for mark in self.marks)
        own = {(mark.hint.text, mark.hint.term) for mark in self.marks if mark.hint and mark.hint.kind == "datum"}
        rounded = [str(mark.line.line) for mark in self.marks if mark.verdict == "rounded"]
        return (
            *([note("repaired", number=guessed)] if guessed else []),
            *(note("data_differ", "own_number", written=written, meant=meant) for written, meant in sorted(own)),
            *([note("rounded", lines=joined(rounded, "join.comma"))] if rounded else []),
        )

    @property
    def share(self) -> float:
        """Return independent / max(needed, independent + different): to guess every combination of signs does not pay."""
        return self.independent / max(self.needed, self.independent + self.different, 1)
