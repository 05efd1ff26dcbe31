"""Everything a user can be told.

Enters: where a fault was found and what it is.  Leaves: one sentence a line, in file order.
Used by every floor above; imports nothing of the project.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

MOST_SHOWN = 100  # faults written out; whoever has more has another file in mind


class CourseworkError(Exception):
    """Something the user can put right; the command line ends with status 2."""


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing wrong with one file: *where: what is wrong (what was found). What to do.*"""

    message: str
    file: str = ""
    line: int = 0
    column: int = 0
    place: str = ""

    def __str__(self) -> str:
        where = self.file + (f":{self.line}" if self.line else "")
        if self.column:
            where += f":{self.column}"
        return visible("  ".join(part for part in (where, f"{self.place}: {self.message}".lstrip(": ")) if part))


class InputError(CourseworkError):
    """The input cannot be used; carries every fault found, in file order."""

    def __init__(self, faults: Iterable[Fault] | str) -> None:
        listed = (Fault(faults),) if isinstance(faults, str) else tuple(faults)
        self.faults: tuple[Fault, ...] = tuple(sorted(listed, key=lambda fault: (fault.file, fault.line or 10**6, fault.column)))
        shown = [str(fault) for fault in self.faults[:MOST_SHOWN]]
        if len(self.faults) > MOST_SHOWN:
            shown.append(f"… and {len(self.faults) - MOST_SHOWN} faults more.")
        super().__init__("\n".join(shown))


class OutputError(CourseworkError):
    """A result could not be written; nothing half-written is left."""


def visible(text: str) -> str:
    """Return text with every letter that does not print (colour codes, reversed writing …) as its code."""
    return "".join(letter if letter.isprintable() else f"\\u{ord(letter):04x}" for letter in text)


def closest(word: str, known: Sequence[str], alike: float = 0.6) -> str:
    """Return ' Did you mean "…"?' with the closest known word, or an empty string; `alike` is 1 for the same word."""
    found = difflib.get_close_matches(word, list(known), n=1, cutoff=alike)
    return f' Did you mean "{found[0]}"?' if found else ""


def listing(words: Sequence[str], joint: str = "and") -> str:
    """Return "a, b and c"."""
    return f" {joint} ".join(part for part in (", ".join(words[:-1]), words[-1]) if part) if words else ""
