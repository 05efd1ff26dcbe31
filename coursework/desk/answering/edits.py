"""Changes of single values in a text, as an editor takes them over: where each stands and what comes there.

Enters: a text, values by their path.  Leaves: edits (line and column from 1, the end excluded) of the text as it was.
Used by `controls.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.rewriting import place_of


def place(text: str, begin: int, end: int) -> dict[str, int]:
    """Return a part of a text by lines and columns."""
    (line, column), (end_line, end_column) = _at(text, begin), _at(text, end)
    return {"line": line, "column": column, "end_line": end_line, "end_column": end_column}


def value_place(text: str, path: KeyPath) -> dict[str, int] | None:
    """Return where a value stands, None where the file does not write it."""
    found = place_of(text, path)
    return None if found is None else place(text, *found)


def edits_of(text: str, values: Mapping[KeyPath, str]) -> list[dict[str, Any]]:
    """Return the edits that put values in the place of others; what the file does not write stays unwritten."""
    found = ((value_place(text, path), value) for path, value in values.items())
    return [{**where, "text": value} for where, value in found if where is not None]


def inserted(text: str, line: int, lines: Iterable[str]) -> list[dict[str, Any]]:
    """Return the edit that puts lines behind a line, the last one for a number beyond it."""
    own = text.split("\n")
    at, column = (line, len(own[line - 1]) + 1) if line < len(own) else (len(own), len(own[-1]) + 1)
    return [{"line": at, "column": column, "end_line": at, "end_column": column, "text": "\n" + "\n".join(lines)}]


def _at(text: str, place: int) -> tuple[int, int]:
    return text.count("\n", 0, place) + 1, place - (text.rfind("\n", 0, place) + 1) + 1
