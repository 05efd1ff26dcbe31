"""Single values of a text replaced, and lines added: the new text, and what in it is new.

Enters: a text, values by their path.  Leaves: the text, places in it (line and column from 1, the end excluded).
Used by `controls.py`, `derived.py`, `drag.py` and `pieces.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.rewriting import place_of

Piece = tuple[int, int, str]  # where a part of a text begins and ends (letters from 0), and what comes there


def value_place(text: str, path: KeyPath) -> dict[str, int] | None:
    """Return where a value stands, None where the file does not write it."""
    found = place_of(text, path)
    return None if found is None else _place(text, *found)


def with_values(text: str, values: Mapping[KeyPath, str]) -> dict[str, Any]:
    """Return the `text` with other values in their places, and their `ranges`; what the file does not write stays unwritten."""
    found = ((place_of(text, path), value) for path, value in values.items())
    return changed(text, [(*place, value) for place, value in found if place is not None])


def with_lines(text: str, behind: int, lines: Iterable[str]) -> dict[str, Any]:
    """Return the `text` with lines behind one of it (from 1), and their `ranges`."""
    own = text.split("\n")[:behind]
    at = len("\n".join(own))
    return changed(text, [(at, at, "".join(f"\n{line}" for line in lines))])


def changed(text: str, pieces: list[Piece]) -> dict[str, Any]:
    """Return the `text` with its pieces changed, and the `ranges` of what is new."""
    new, grown, spans = text, 0, []
    for begin, end, value in sorted(pieces):
        new = new[: begin + grown] + value + new[end + grown :]
        spans.append((begin + grown, begin + grown + len(value)))
        grown += len(value) - (end - begin)
    return {"text": new, "ranges": [_place(new, *span) for span in spans if span[0] < span[1]]}


def _place(text: str, begin: int, end: int) -> dict[str, int]:
    (line, column), (end_line, end_column) = _at(text, begin), _at(text, end)
    return {"line": line, "column": column, "end_line": end_line, "end_column": end_column}


def _at(text: str, place: int) -> tuple[int, int]:
    return text.count("\n", 0, place) + 1, place - (text.rfind("\n", 0, place) + 1) + 1
