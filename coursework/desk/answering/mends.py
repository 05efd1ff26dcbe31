"""A fault that says "Did you mean …?" -> the change of the text that does it.

Enters: a fault and the lines of the text.  Leaves: where to put what, or None.  Used by `typed.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from typing import Any

from coursework.words.errors import Fault
from coursework.words.sentence import Sentence

_ADVICE = "hint.closest"


def mend_of(fault: Fault, lines: Sequence[str]) -> dict[str, Any] | None:
    """Return `line`, `column`, `end_line`, `end_column` (from 1, the end excluded) and the `text` to stand there."""
    meant = next((str(hint.values["name"]) for hint in _sentences(fault.message) if hint.key == _ADVICE), None)
    if meant is None or not 1 <= fault.line <= len(lines):
        return None
    line, begin = lines[fault.line - 1], max(fault.column - 1, 0)
    found = [(line.find(word, begin), word) for word in _words(fault.message) if word != meant]
    placed = [(SequenceMatcher(None, word, meant).ratio(), -at, word) for at, word in found if at >= 0]
    if not placed:
        return None
    _, at, word = max(placed)
    return {
        "line": fault.line, "column": 1 - at, "end_line": fault.line, "end_column": 1 - at + len(word), "text": meant,
    }  # fmt: skip


def _sentences(message: Sentence) -> Iterator[Sentence]:
    for value in message.values.values():
        if isinstance(value, Sentence):
            yield value
            yield from _sentences(value)


def _words(message: Sentence) -> Iterator[str]:
    """Give what a fault speaks about, and the words of it: "3.37 rd" and "rd"."""
    for value in message.values.values():
        if isinstance(value, str) and not isinstance(value, Sentence):
            yield from dict.fromkeys(word for word in (value, *value.split()) if word)
