"""Records as lines of JSON, and back: only data cross to another process, even if that process has read a hostile file.

Enters: records (frozen dataclasses) whose annotations give the types of their fields; or a line, and the type expected.
Leaves: lines; or a record of that type, and `ValueError` for any other line.  A line never chooses the type it becomes.
Used by `pool.py`, `pool_process.py` and `grading/batch/`.

Bytes travel as base64, a `Sentence` as its key and values; `Any`, and the items of lists, as JSON represents them.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from types import NoneType
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

Record = TypeVar("Record")


@frozen
class _Way:
    """How values of one type are converted to plain data (`there`) and how they are restored (`back`)."""

    there: Callable[[Any], Any]
    back: Callable[[Any], Any]


def plain_of(record: Any) -> Any:
    """Return a record as dicts, lists, texts and numbers."""
    kind: Any = type(record)
    return _way(kind).there(record)


def record_of(kind: type[Record], plain: Any) -> Record:
    """Return the record of type `kind` that `plain_of` made plain.  Raises `ValueError` if `plain` is no such record."""
    of: Any = kind
    try:
        record: Record = _way(of).back(plain)
    except (KeyError, TypeError, AttributeError) as error:  # for instance an incomplete sentence
        raise ValueError(str(error)) from None
    return record


def line_of(record: Any) -> bytes:
    """Return a record as one line of ASCII."""
    return json.dumps(plain_of(record), ensure_ascii=True, separators=(",", ":"), allow_nan=False).encode("ascii") + b"\n"


def read_line(kind: type[Record], line: bytes) -> Record:
    """Return the record of type `kind` in a line.  Raises `ValueError` if the line is incomplete or holds no such record."""
    try:
        return record_of(kind, json.loads(line, parse_constant=_no_number))
    except RecursionError:
        raise ValueError("too many brackets") from None


def _no_number(text: str) -> None:
    raise ValueError(f"{text} is no number")


@cache
def _way(kind: Any) -> _Way:
    if kind in _LEAVES:
        return _LEAVES[kind]
    if is_dataclass(kind):
        return _way_of_record(kind)
    parts = get_args(kind)
    if NoneType in parts:
        way = _way(next(part for part in parts if part is not NoneType))
        return _Way(lambda value: None if value is None else way.there(value), lambda p: None if p is None else way.back(p))
    if get_origin(kind) is tuple:
        way = _way(parts[0])
        return _Way(lambda value: list(map(way.there, value)), lambda plain: tuple(map(way.back, _checked(list, plain))))
    if get_origin(kind) in {dict, Mapping}:
        way = _way(parts[1])
        return _Way(
            lambda value: {name: way.there(part) for name, part in value.items()},
            lambda plain: {name: way.back(part) for name, part in _checked(dict, plain).items()},
        )
    return _Way(_same, _same)


def _way_of_record(kind: Any) -> _Way:
    hints = get_type_hints(kind)
    ways = {field.name: _way(hints[field.name]) for field in fields(kind) if field.init}

    def back(plain: Any) -> Any:
        if _checked(dict, plain).keys() != ways.keys():
            raise ValueError(f"not a {kind.__name__}")
        return kind(**{name: way.back(plain[name]) for name, way in ways.items()})

    return _Way(lambda record: {name: way.there(getattr(record, name)) for name, way in ways.items()}, back)


def _same(value: Any) -> Any:
    return value


def _checked(kind: Any, plain: Any) -> Any:
    if not isinstance(plain, kind):
        raise ValueError(f"{kind} was expected")
    return plain


def _said(value: Any) -> Any:
    """Return a value of a sentence as plain data."""
    if isinstance(value, Sentence):
        return {"key": value.key, "values": {name: _said(part) for name, part in value.values.items()}}
    return list(map(_said, value)) if isinstance(value, tuple) else value


def _heard(plain: Any) -> Any:
    """Return the value from which `_said` made `plain`."""
    if isinstance(plain, dict):
        return say(plain["key"], **{name: _heard(part) for name, part in plain["values"].items()})
    return tuple(map(_heard, plain)) if isinstance(plain, list) else plain


_LEAVES = {
    bytes: _Way(lambda value: base64.b64encode(value).decode("ascii"), lambda plain: base64.b64decode(_checked(str, plain))),
    Path: _Way(str, lambda plain: Path(_checked(str, plain))),
    Sentence: _Way(_said, _heard),
    str: _Way(_same, lambda plain: _checked(str, plain)),
    bool: _Way(_same, lambda plain: _checked(bool, plain)),
    int: _Way(_same, lambda plain: _checked(int, plain)),
    float: _Way(_same, lambda plain: _checked((int, float), plain)),
}
