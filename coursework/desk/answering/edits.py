"""Single values of a text replaced, and lines added: the new text, and what in it is new.

Enters: a text, values by their path.  Leaves: the text, places in it (line and column from 1, the end excluded).
Used by `contradicted.py`, `controls.py`, `derived.py`, `drag.py`, `pieces.py` and `point_pieces.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import Any

from coursework.system.frozen import frozen
from coursework.variant.toml.positions import KeyPath, locate
from coursework.variant.toml.rewriting import place_of

Piece = tuple[int, int, str]  # where a part of a text begins and ends (letters from 0), and what comes there
TABLES = ("group", "constraint")  # sections that there may be several of: what is added brings its own head


@frozen
class Additions:
    """What a text gets: lines at the end of `sections`, values as written at the end of lists (`entries`), other `values`."""

    sections: dict[str, list[str]]
    entries: dict[KeyPath, list[str]] = field(default_factory=dict)
    values: dict[KeyPath, str] = field(default_factory=dict)


def value_place(text: str, path: KeyPath) -> dict[str, int] | None:
    r"""Return where a value stands, None where the file does not write it.

    >>> value_place('[given]\nr = 2.5', ("given", "r")), value_place('[given]\nr = 2.5', ("given", "s"))
    ({'line': 2, 'column': 5, 'end_line': 2, 'end_column': 8}, None)
    """
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


def with_additions(text: str, more: Additions) -> dict[str, Any]:
    """Return the `text` with lines and values at the ends of its sections and lists, and their `ranges`.

    A section that is missing comes last.
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
            pieces.append(
                (begin + 1 + len(before), end - 1, f"{', ' if before.strip() else ''}{', '.join(values)}{_gap(before)}")
            )
        elif values:
            sections.setdefault(str(path[0]), []).append(f"{path[1]} = [{', '.join(values)}]")
    ends = [*(len(line) for line in text.split("\n"))]
    for section, added in sections.items():
        if added:
            at = sum(ends[: last[section]]) + last[section] - 1 if section in last else len(text.rstrip("\n"))
            head = [] if section in last or section in TABLES else ["", f"[{section}]"]
            pieces.append((at, at, "".join(f"\n{line}" for line in (*head, *added))))
    return changed(text, pieces)


def _gap(before: str) -> str:
    """Return what stands before the end of a list whose author left a space after its beginning."""
    return " " if before.startswith(" ") else ""


def changed(text: str, pieces: list[Piece]) -> dict[str, Any]:
    """Return the `text` with its pieces changed, and the `ranges` of what is new."""
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
