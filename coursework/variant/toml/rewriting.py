"""The text of a variant file with other values; comments, order and spelling stay as its author wrote them.

Enters: a text that has been read as a variant, and values by their path.  Leaves: the new text.
Used by `variant_text.py`, by individual variants and by the desk.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any

from coursework.variant.formula.alphabet import spell_path
from coursework.variant.toml.positions import KeyPath, Positions, locate
from coursework.words.errors import InputError
from coursework.words.sentences import say

# Sections about the file's own numbers; in a copy with other numbers they would be false.
SAID_OF_NUMBERS = ("remarks", "quote")
_REMARK = re.compile(r"[ \t]*#[^\n]*")
_SCHEMA_LINE = re.compile(r"\A#:schema[^\n]*\n\s*")


def rewritten(text: str, changes: Mapping[KeyPath, Any], drop: Iterable[str] = ()) -> str:
    """Return the text with changed values; a key that the file does not have is added to its section.

    `drop` names top-level sections and keys to leave out.  The line that names a schema is removed, because a copy is in another
    folder.  Raises `InputError` for a section that the file does not have in this form.
    """
    plain = text.replace("\r\n", "\n").removeprefix("\ufeff")
    found = _located(plain)
    pieces = [_replacement(plain, found, path, value) for path, value in changes.items()]
    pieces += [piece for name in drop for piece in _removals(plain, found, name)]
    for begin, end, new in sorted(pieces, reverse=True):
        plain = plain[:begin] + new + plain[end:]
    return _SCHEMA_LINE.sub("", plain)


def place_of(text: str, path: KeyPath) -> tuple[int, int] | None:
    r"""Return start and end (offsets) of the text of a value, inside its quotes; None if it has no place in the text.

    >>> text = '[given]\nr1 = "0.953 m"'
    >>> text[slice(*place_of(text, ("given", "r1")))]
    '0.953 m'
    """
    found = _located(text)
    own = _own(text, found, path)
    if own is None or own not in found.spans:
        return None
    begin, end = found.spans[own]
    quotes = next((mark for mark in ('"""', "'''", '"', "'") if text.startswith(mark, begin)), "")
    return begin + len(quotes), end - len(quotes)


@lru_cache(maxsize=8)  # a class has one template, and as many copies as students
def _located(text: str) -> Positions:
    return locate(text)


@lru_cache(maxsize=8)
def _line_starts(text: str) -> tuple[int, ...]:
    return (0, *(match.end() for match in re.finditer("\n", text)))


def _replacement(text: str, found: Positions, path: KeyPath, value: Any) -> tuple[int, int, str]:
    """Return the start and end of the text to replace, and the new text."""
    written = json.dumps(value, ensure_ascii=False)
    own = _own(text, found, path)
    if own is not None:
        begin, end = found.spans[own]
        remark = _REMARK.match(text, end) if path[0] == "time" else None  # it describes the old number
        return begin, remark.end() if remark else end, written
    section, key = path[:-1], path[-1]
    table = _spelt(found.spans, section)
    if table is not None and text[found.spans[table][0]] == "{":
        at = found.spans[table][0] + 1
        return at, at, f" {key} = {written},"
    header = _spelt(found.keys, section)
    if header is not None:
        at = _line_end(text, _offset(text, *found.keys[header]))
        return at, at, f"\n{key} = {written}"
    name = ".".join(str(part) for part in section)
    raise InputError(say("fault.V049", name=name, key=str(key)))


def _own(text: str, found: Positions, path: KeyPath) -> KeyPath | None:
    """Return the path of a value as the file spells it; for a datum with a meaning, the path of its value alone."""
    own = _spelt(found.spans, path)
    return (*own, "value") if own is not None and path[0] == "given" and text[found.spans[own][0]] == "{" else own


def _removals(text: str, found: Positions, name: str) -> Iterable[tuple[int, int, str]]:
    """Yield the parts of the text that contain a key or the sections of a name, as whole lines."""
    headers = sorted({_offset(text, *place) for path, place in found.keys.items() if path and _is_header(text, found, path)})
    for path, place in found.keys.items():
        if path[0] != name or len(path) > 2:
            continue
        begin = text.rfind("\n", 0, _offset(text, *place)) + 1
        if path in found.spans and len(path) == 1:
            yield begin, min(len(text), _line_end(text, found.spans[path][1]) + 1), ""
        elif _is_header(text, found, path):
            following = [at for at in headers if at > _offset(text, *place)]
            end = text.rfind("\n", 0, following[0]) + 1 if following else len(text)
            yield begin, end, ""


def _is_header(text: str, found: Positions, path: KeyPath) -> bool:
    """Return whether a key is in square brackets at the head of a section."""
    at = _offset(text, *found.keys[path])
    return path not in found.spans and text[text.rfind("\n", 0, at) + 1 : at].strip() in {"[", "[["}


def _spelt(paths: Iterable[KeyPath], wanted: KeyPath) -> KeyPath | None:
    """Return a path as the file spells it, None if it has no such path."""
    plain = spell_path(wanted)
    return next((path for path in paths if len(path) == len(plain) and spell_path(path) == plain), None)


def _offset(text: str, line: int, column: int) -> int:
    return _line_starts(text)[line - 1] + column - 1


def _line_end(text: str, at: int) -> int:
    end = text.find("\n", at)
    return end if end >= 0 else len(text)
