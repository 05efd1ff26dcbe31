"""A fault that says "Did you mean …?", which section is missing, or how to write a line -> the change that mends it.

Enters: a fault and the lines of the text.  Leaves: the place and the new text, or None.  Used by `typed.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from typing import Any

from coursework.variant.toml.faulty import QUOTES
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence

_ADVICE, _COMMA = "hint.closest", "V106"
_MISSING, _NOTHING_WRITTEN, _TOO_FEW, _POINT = "V012", "V072", "V404", "V165"
_BEGUN = {  # the begin of each section that no file can do without
    "coordinates": '[coordinates]\nphi1 = { start = "0 rad", rate = "w1" }',
    "time": '[time]\nstep = "0.02 s"\nend  = "0.48 s"',
    # the first data on a task sheet
    "given": '[given]\nr1 = "0.5 m"\nV1 = "1 m/s"\np  = "10 1/s"\n\n[drive]\nVMx = "0"\nVMy = "V1*sin(p*t)"',
    "constraint": '[[constraint]]\nbecause  = ""\nequation = ""',
}
_UNQUOTED = re.compile(r"""^(\s*(?:[\w-]+|"[^"]*")\s*=\s*)([^\s"'\[{#](?:[^"'\[\]{}#]*[^\s"'\[\]{}#])?)""")
_NUMBER = re.compile(r"[-+]?[\d.]+")
_ONE_SIGN = {  # by code of a fault in a formula: the sign at its column, and the sign to be written there
    "V116": (re.compile(""), ")"),
    "V120": (re.compile(""), "*"),
    "V121": (re.compile(r"(?<=\d),(?=\d)"), "."),
    "V144": (re.compile(r"\)"), ""),
}


Mend = dict[str, Any]


def mends_of(faults: Sequence[Fault], lines: Sequence[str]) -> list[Mend | None]:
    """Return the mend of each fault, or None: `line`, `column`, `end_line`, `end_column` (from 1, end excluded), new `text`.

    A missing section is not added if another fault says that it is only misspelled in the text.
    """
    meant = [_meant(fault) for fault in faults]
    return [_mend(fault, name, lines, meant) for fault, name in zip(faults, meant, strict=True)]


def _mend(fault: Fault, name: str | None, lines: Sequence[str], meant: Sequence[str | None]) -> Mend | None:
    if fault.code in (_MISSING, _NOTHING_WRITTEN, _TOO_FEW):
        return _beginning(fault, lines, meant)
    if fault.code == _POINT:
        return _among_points(str(fault.message.values["line"]), lines)
    if not 1 <= fault.line <= len(lines):
        return None
    line = lines[fault.line - 1]
    return _one_sign(fault, line) or _rewritten(fault, line) or _respelled(fault, name, line)


def _meant(fault: Fault) -> str | None:
    return next((str(hint.values["name"]) for hint in _sentences(fault.message) if hint.key == _ADVICE), None)


def _beginning(fault: Fault, lines: Sequence[str], meant: Sequence[str | None]) -> Mend | None:
    name = str(fault.message.values["name"]) if fault.code == _MISSING else "constraint"
    if name in meant or name not in _BEGUN:
        return None
    first = "" if any(lines) or name != "coordinates" else f"{_BEGUN['given']}\n\n"
    return appended(first + _BEGUN[name], lines)


def appended(text: str, lines: Sequence[str]) -> Mend:
    """Return the mend that adds a section at the end."""
    gap = "" if not any(lines) else "\n" if not lines[-1] else "\n\n"
    return _put(len(lines), len(lines[-1]), len(lines[-1]), f"{gap}{text}\n")


def _among_points(text: str, lines: Sequence[str]) -> Mend:
    """Return the mend that adds a line to [points], below its head, or this section at the end."""
    for number, line in enumerate(lines, start=1):
        if line.startswith("[points]"):
            return _put(number, len(line), len(line), f"\n{text}")
    return appended(f"[points]\n{text}", lines)


def _put(line: int, begin: int, end: int, text: str) -> Mend:
    return {"line": line, "column": begin + 1, "end_line": line, "end_column": end + 1, "text": text}


def _one_sign(fault: Fault, line: str) -> Mend | None:
    """Return the mend of a formula in which one sign is missing, superfluous or wrong."""
    wrong, right = _ONE_SIGN.get(fault.code, (None, ""))
    found = wrong.match(line, fault.column - 1) if wrong is not None else None
    return None if found is None else _put(fault.line, *found.span(), right)


def _rewritten(fault: Fault, line: str) -> Mend | None:
    """Return the mend of a line whose fault says how a part of it has to be written."""
    found = _spelling(fault, line)
    if found is None or found[0] not in line:
        return None
    begin = line.index(found[0])
    return _put(fault.line, begin, begin + len(found[0]), found[1])


def _spelling(fault: Fault, line: str) -> tuple[str, str] | None:
    """Return the part of a line that has to be written otherwise, and its new spelling; None if the fault does not say that."""
    advice = {one.key.removeprefix("fault.toml."): one.values for one in _sentences(fault.message)}
    if fault.code == _COMMA:
        return str(fault.message.values["found"]), str(fault.message.values["advised"])
    if "straight" in advice:
        return line, QUOTES.sub('"', line)
    if "greek" in advice:
        key = str(advice["greek"]["key"])
        return key, f'"{key}"'
    bare = _UNQUOTED.match(line)
    if bare is None or not {"unit", "point", "after", "value"} & set(advice):
        return None
    value = bare[2].replace(",", ".", 1) if "point" in advice else bare[2]
    return bare[2], value if _NUMBER.fullmatch(value) else f'"{value}"'


def _respelled(fault: Fault, meant: str | None, line: str) -> Mend | None:
    if meant is None:
        return None
    begin = max(fault.column - 1, 0)
    found = [(line.find(word, begin), word) for word in _words(fault.message) if word != meant]
    placed = [(SequenceMatcher(None, word, meant).ratio(), -at, word) for at, word in found if at >= 0]
    if not placed:
        return None
    _, at, word = max(placed)
    return _put(fault.line, -at, len(word) - at, meant)


def _sentences(message: Sentence) -> Iterator[Sentence]:
    for value in message.values.values():
        if isinstance(value, Sentence):
            yield value
            yield from _sentences(value)


def _words(message: Sentence) -> Iterator[str]:
    """Yield the texts that a fault quotes, and the words in them: "3.37 rd", "3.37" and "rd"."""
    for value in message.values.values():
        if isinstance(value, str) and not isinstance(value, Sentence):
            yield from dict.fromkeys(word for word in (value, *value.split()) if word)
