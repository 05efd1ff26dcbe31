"""A fault of a file -> a stand-in in its place, so that the rest can be read at the same time.

Enters: the data of a file, the path of a fault and pydantic's description of it.  Leaves: the changed data.
Used by `shape.py`; `sections.py` uses the name of an unreadable coordinate.
"""

from __future__ import annotations

from typing import Any

from coursework.variant.record.vocabulary import GROUP_KINDS
from coursework.variant.toml.positions import KeyPath

Entry = dict[str, Any]
NAMELESS = "?"  # stands for an unreadable coordinate of a group
_STAND_INS = {"given": 1, "drive": "0", "functions": "1", "unknowns": "1", "points": "(0, 0)"}


def stand_in(data: dict[str, Any], path: KeyPath, entry: Entry) -> None:
    """Put a stand-in in the place of a fault, or remove the faulty entry."""
    if path[-1] == "[key]":
        path = path[:-1]
    section, *inner = path
    owner = at(data, path[:1] if inner else ())
    if entry["type"] == "extra_forbidden":
        owner, key = at(data, path[:-1]), path[-1]
        if isinstance(owner, dict):
            owner.pop(key, None)
    elif section == "unknowns" and len(inner) > 1 and inner[1] != "unit" and isinstance(owner, dict):
        owner[inner[0]].pop(inner[1], None)
    elif section in _STAND_INS and inner and isinstance(owner, dict):
        owner[inner[0]] = _STAND_INS[section]
    elif section == "coordinates":
        _repair_coordinates(data, inner)
    elif section == "time":
        _repair_time(data, inner)
    elif section == "group" and len(inner) > 1 and isinstance(group := at(data, path[:2]), dict):
        _repair_group(group, str(inner[1]), entry)
    elif section == "constraint" and inner and isinstance(owner, list):
        owner[int(inner[0])] = {"equation": "0 = 0"}
    elif section in {"frame", "closure", "ask", "links"} and isinstance(owner, dict):
        owner.pop(inner[0] if inner else section, None)
    else:
        data.pop(str(section), None)


def _repair_coordinates(data: dict[str, Any], inner: list[str | int]) -> None:
    if not inner:
        data["coordinates"] = {"coordinate": {"rate": "its_rate"}}
        return
    coordinate = data["coordinates"][inner[0]]
    if isinstance(coordinate, dict) and len(inner) > 1 and inner[1] in {"start", "unit"}:
        coordinate.pop(inner[1], None)
    else:
        data["coordinates"][inner[0]] = {"rate": f"rate_of_{inner[0]}"[:40]}


def _repair_group(group: dict[str, Any], key: str, entry: Entry) -> None:
    if key == "kind":
        import difflib  # imported only for a mistake

        alike = difflib.get_close_matches(str(entry.get("input")), GROUP_KINDS, n=1)
        group[key] = alike[0] if alike else next(iter(GROUP_KINDS))
    elif key == "coordinates":
        group[key] = [NAMELESS]
    else:
        group.pop(key, None)


def _repair_time(data: dict[str, Any], inner: list[str | int]) -> None:
    time = data.get("time")
    if not inner or not isinstance(time, dict):
        data["time"] = {"step": 1, "end": 1}
    elif inner[0] in {"step", "end"}:
        other = time.get("end" if inner[0] == "step" else "step")
        time[inner[0]] = other if isinstance(other, (str, int, float)) and not isinstance(other, bool) else 1
    else:
        time.pop(inner[0], None)


def at(data: Any, path: KeyPath) -> Any:
    for part in path:
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            return None
    return data
