"""Single values of a text replaced, and lines added: the new text, and the ranges that are new in it.

Enters: a text, values by their path.  Leaves: the new text, places in it (line and column from 1, the end excluded).
Used by `contradicted.py`, `controls.py`, `derived.py`, `drag.py` and `pieces.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import Any

from coursework.system.frozen import frozen
from coursework.variant.toml.positions import KeyPath, locate
from coursework.variant.toml.rewriting import place_of

Piece = tuple[int, int, str]  # begin and end of a part of a text (offsets from 0), and the text that replaces it
TABLES = ("group", "constraint")  # sections that may occur several times: added lines bring their own head


@frozen
class Additions:
    """Changes of a text: lines to add to `sections`, values as written to add to lists (`entries`), `values` to replace."""

    sections: dict[str, list[str]]
    entries: dict[KeyPath, list[str]] = field(default_factory=dict)
    values: dict[KeyPath, str] = field(default_factory=dict)


def value_place(text: str, path: KeyPath) -> dict[str, int] | None:
    r"""Return the place of a value in the text, None if the text does not write it.

    >>> value_place('[given]\nr = 2.5', ("given", "r")), value_place('[given]\nr = 2.5', ("given", "s"))
    ({'line': 2, 'column': 5, 'end_line': 2, 'end_column': 8}, None)
    """
    found = place_of(text, path)
    return None if found is None else _place(text, *found)


def with_values(text: str, values: Mapping[KeyPath, str]) -> dict[str, Any]:
    """Return the `text` with `values` in their places, and their `ranges`; values that the text does not write are left out."""
    found = ((place_of(text, path), value) for path, value in values.items())
    return changed(text, [(*place, value) for place, value in found if place is not None])


def with_lines(text: str, behind: int, lines: Iterable[str]) -> dict[str, Any]:
    """Return the `text` with `lines` added after line `behind` (from 1), and their `ranges`."""
    own = text.split("\n")[:behind]
    at = len("\n".join(own))
    return changed(text, [(at, at, "".join(f"\n{line}" for line in lines))])


def with_additions(text: str, more: Additions) -> dict[str, Any]:
    """Return the `text` with the changes `more`, and their `ranges`.

    A section that is missing is added at the end.
    """
    found = locate(text)
    last = {str(path[0]): 0 for path in found.keys}
    for path, (line, _) in (*found.keys.items(), *found.values.items()):
        last[str(path[0])] = max(last[str(path[0])], line)
    for path, (_, end) in found.spans.items():
        last[str(path[0])] = max(last[str(path[0])], text.count("\n", 0, end) + 1)
    pieces: list[Piece] = [(*place, value) for path, value in more.values.items() if (place := place_of(text, path))]
    sections = {section: [*lines] for section, lines in more.sections.items()}
    for path, values in more.entries.items():
        if path in found.spans and values:
            begin, end = found.spans[path]
            before = text[begin + 1 : end - 1].rstrip()
            gap = " " if before.startswith(" ") else ""  # before the end of the list, if its author left one after its beginning
            pieces.append((begin + 1 + len(before), end - 1, f"{', ' if before.strip() else ''}{', '.join(values)}{gap}"))
        elif values:
            sections.setdefault(str(path[0]), []).append(f"{path[1]} = [{', '.join(values)}]")
    ends = [*(len(line) for line in text.split("\n"))]
    for section, added in sections.items():
        if added:
            at = sum(ends[: last[section]]) + last[section] - 1 if section in last else len(text.rstrip("\n"))
            head = [] if section in last or section in TABLES else ["", f"[{section}]"]
            pieces.append((at, at, "".join(f"\n{line}" for line in (*head, *added))))
    return changed(text, pieces)


def changed(text: str, pieces: list[Piece]) -> dict[str, Any]:
    """Return the `text` with the `pieces` replaced, and the `ranges` of the new parts."""
    new, grown, spans = text, 0, []
    for begin, end, value in sorted(pieces):
        new = new[: begin + grown] + value + new[end + grown :]
        spans.append((begin + grown, begin + grown + len(value)))
        grown += len(value) - (end - begin)
    return {"text": new, "ranges": [_place(new, *span) for span in spans if span[0] < span[1]]}


def _place(text: str, begin: int, end: int) -> dict[str, int]:
    (line, column), (end_line, end_column) = line_and_column(text, begin), line_and_column(text, end)
    return {"line": line, "column": column, "end_line": end_line, "end_column": end_column}


def line_and_column(text: str, place: int) -> tuple[int, int]:
    """Return the line and column, from 1, of a place in a text."""
    return text.count("\n", 0, place) + 1, place - (text.rfind("\n", 0, place) + 1) + 1
