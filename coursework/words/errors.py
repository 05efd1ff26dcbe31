"""The faults and exceptions that are reported to the user.

Enters: where a fault was found and what it is.  Leaves: one sentence per line, in file order.
Used by every floor above.

Each fault has a code, the same in every language: V a variant file, A ranges and rosters of individual variants, C the command
line, D data given from Python, G grading, W writing, E limits of time and memory, L words files.  Its sentence has the code as
its key in [fault] of `reports/words.<language>.toml`.  A value that can be used but looks like a slip (alpha = 249.2 rad, r1 =
"953 m" beside 0.847 m) is a remark: it is on the screen, on page 1 and under "remarks" in `run.json`, and changes no status.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from coursework.words.sentence import Sentence

MOST_SHOWN = 100  # most faults printed; with more, the user probably gave the wrong file


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault in one file: *where: what is wrong (what was found). What to do.*

    `message` has a key of [fault] in the words files: a letter for the kind of input and a number, the same in every language.
    """

    message: Sentence
    file: str = ""
    line: int = 0
    column: int = 0
    place: str = ""

    def __str__(self) -> str:
        return self.told()

    @property
    def code(self) -> str:
        """Return the code: a letter for the kind of input (a variant file, a roster …) and a number."""
        return self.message.key.split(".")[1]

    def told(self, written: Callable[[str], str] = str) -> str:
        """Return the line for the user; `written` translates sentences."""
        where = self.file + (f":{self.line}" if self.line else "")
        if self.column:
            where += f":{self.column}"
        said = self.said(written)
        return visible(f"{self.code} {where}  {said}" if where else f"{self.code} {said}")

    def said(self, written: Callable[[str], str] = str) -> str:
        """Return the place in the file and the sentence, without the line number, for a reader who sees the line itself."""
        place, said = written(self.place), written(self.message)
        return visible(f"{place}{'：' if said.endswith(('。', '？')) else ': '}{said}" if place else said)

    def plain(self) -> dict[str, Any]:
        """Return the fault for a JSON file: its code, place, values and sentence."""
        where = {"file": self.file, "line": self.line, "column": self.column, "place": str(self.place)}
        return {"code": self.code, **where, "values": self.message.plain(), "sentence": str(self.message)}


class CourseworkError(Exception):
    """An error that the user can correct, with its faults in file order; the command line then ends with status 2.

    >>> import coursework
    >>> text = coursework.load("31").path.read_text(encoding="utf-8")
    >>> try:
    ...     coursework.parse_variant(text.replace("0.953 m", "0.953 kg").replace("0.847 m", "-"))
    ... except coursework.CourseworkError as error:
    ...     [(fault.line, fault.code) for fault in error.faults]
    [(13, 'V105'), (14, 'V107')]
    """

    def __init__(self, faults: Iterable[Fault] | Sentence) -> None:
        listed = (Fault(faults),) if isinstance(faults, str) else tuple(dict.fromkeys(faults))  # each is told once
        self.faults: tuple[Fault, ...] = tuple(
            sorted(listed, key=lambda fault: (fault.file, fault.line or math.inf, fault.column))
        )
        super().__init__(self.faults)

    def __str__(self) -> str:
        return self.told()

    def told(self, written: Callable[[str], str] = str) -> str:
        """Return one line per fault; `written` translates sentences."""
        shown = [fault.told(written) for fault in self.faults[:MOST_SHOWN]]
        rest = len(self.faults) - MOST_SHOWN
        return "\n".join([*shown, *([f"… +{rest}"] if rest > 0 else [])])


class CourseworkWarning(UserWarning):
    """A warning for users of the Python library: a value that looks like a slip, or a motion that ends early.

    >>> import warnings
    >>> import coursework
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     run = coursework.solve(coursework.load("31").with_data({"r1": 950.0}))
    >>> told[0].category.__name__, run.remarks == (str(told[0].message),)
    ('CourseworkWarning', True)
    """


class InputError(CourseworkError, ValueError):
    """Raised if the input cannot be used; `faults` has every fault found.

    >>> import coursework
    >>> coursework.solve("31", step=-0.02)
    Traceback (most recent call last):
        ...
    coursework.words.errors.InputError: C008 the step must be a finite time greater than 0, found -0.02 s.
    """


class Unplaced(CourseworkError):
    """A fault of a law that is found where its file is not known, as variants that differ only in data share their laws."""


class OutputError(CourseworkError):
    """Raised if a result could not be written; no unfinished file is left.

    >>> import coursework
    >>> coursework.write_report(coursework.solve("31"), "report.docx")
    Traceback (most recent call last):
        ...
    coursework.words.errors.OutputError: W011 report.docx  the name of this file must end in .html or .pdf (found .docx).
    """


class NotToBeHad(OutputError):
    """Raised for a format that this run cannot have or whose package is missing; the other formats are written."""


def visible(text: str) -> str:
    """Return text with every unprintable character (colour codes, reversed writing …) written as its code."""
    return "".join(letter if letter.isprintable() else f"\\u{ord(letter):04x}" for letter in text)
