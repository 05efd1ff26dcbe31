"""Whether a file has the shape of a variant, and what has not, in words of the file.

Enters: a `Source`.  Leaves: `Shape`: the checked file with a stand-in in the place of each fault, so that the rest of it is
read in the same go, and the faults.  Used by `reader.py` only.
"""

from __future__ import annotations

import copy
import difflib
import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from coursework.errors import Fault, InputError, closest
from coursework.groups import GROUPS
from coursework.variant import schema
from coursework.variant.source import Source

Path = tuple[str | int, ...]
Entry = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Shape:
    """`sure` is False where a fault may have taken declarations with it: names not declared are then no further fault."""

    file: schema.VariantFile
    faults: list[Fault]
    sure: bool


def read_shape(source: Source) -> Shape:
    """Return the checked file.  Raises `InputError` only where no stand-in lets the rest be read."""
    data = copy.deepcopy(source.data)
    faults: list[Fault] = []
    repaired: set[Path] = set()
    while True:
        try:
            return Shape(schema.VariantFile.model_validate(data), faults, not any(map(_takes_names, repaired)))
        except ValidationError as error:
            found = _entries(error.errors(include_url=False), data)
            faults += [_fault(path, entry, source) for path, entry in found.items() if path not in repaired]
            if found.keys() <= repaired:
                raise InputError(faults) from error
            repaired |= found.keys()
            for path, entry in found.items():
                _repair(data, path, entry)


def _takes_names(path: Path) -> bool:
    if len(path) == 1:
        meant = difflib.get_close_matches(str(path[0]), schema.VariantFile.model_fields, n=1)
        return not meant or meant[0] not in _WITHOUT_NAMES
    coordinate = path[0] == "coordinates" and path[-1] not in {"start", "unit"}
    return coordinate or path[0] == "group" or path[-1] == "[key]"


_WITHOUT_NAMES = {
    "format", "title", "source", "teaches", "remarks", "quote", "time", "constraint", "links", "frame", "closure", "ask",
}  # fmt: skip


def _entries(errors: Iterable[Any], data: dict[str, Any]) -> dict[Path, Entry]:
    """Return one entry for each path of the file.

    pydantic puts names of types into a path and gives an entry for each type that a value might have had; the steps that
    the file does not have are left out, and of a table only the entries of the kind of table that was meant are kept.
    """
    grouped: dict[Path, list[tuple[str, Entry]]] = {}
    for entry in errors:
        path, kind = _path_in(data, entry["loc"], entry["type"])
        grouped.setdefault(path, []).append((kind, entry))
    tables = [path for path, entries in grouped.items() if {kind for kind, _ in entries} & {"Table", "Pieces"}]
    result: dict[Path, Entry] = {}
    for path, entries in grouped.items():
        if isinstance(_at(data, path), dict) and any(other[: len(path)] == path and other != path for other in tables):
            continue  # the table's own entries say more than "this is no text"
        meant = [e for kind, e in entries if kind not in {"Table", "Pieces"} or kind == _meant(data, path)]
        if meant:
            result[path] = {**meant[0], "types": [e["type"] for e in meant]}
    return result


def _path_in(data: Any, loc: Path, problem: str) -> tuple[Path, str]:
    """Return the part of pydantic's path that the file has, and the name of the kind of table in it."""
    path: Path = ()
    kind = ""
    for place, part in enumerate(loc):
        last = place == len(loc) - 1
        inside = part in data if isinstance(data, dict) else isinstance(data, list) and isinstance(part, int)
        if inside or (last and (problem == "missing" or part == "[key]")):
            path = (*path, part)
            data = None if last else data[part]
        elif part in {"Table", "Pieces"}:
            kind = str(part)
    return path, kind


def _at(data: Any, path: Path) -> Any:
    for part in path:
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            return None
    return data


def _meant(data: dict[str, Any], path: Path) -> str:
    """Return whether a law of several keys is meant for a table of numbers or for pieces."""
    owner = _at(data, path[:2])
    keys = set(owner) if isinstance(owner, dict) else set()
    return "Pieces" if "pieces" in keys or (path[0] == "drive" and not keys & {"table", "of", "method"}) else "Table"


def _fault(path: Path, entry: Entry, source: Source) -> Fault:
    key = str(path[-1]) if path else ""
    problem = entry["type"]
    if problem == "extra_forbidden":
        known = sorted(_known_keys(path[:-1], source.data))
        advice = closest(key, known) or f" Known keys: {', '.join(known)}."
        return source.fault(path, f'the key "{key}" is not known here.{advice}', at_key=True)
    if problem == "missing":
        what, example = (f"the section [{key}]", f"[{key}]") if len(path) == 1 else (f'the key "{key}"', key)
        return source.fault(path[:-1], f"{what} is missing. Write {_EXAMPLES.get(example, f'{key} = …')}.", at_key=True)
    if key == "[key]":
        name = str(path[-2]) if len(path) > 1 else ""
        return source.fault(path[:-2], f'"{name[:50]}" cannot be a name: 1 to 40 letters and digits were expected.', at_key=True)
    return source.fault(path, f"{_expected(path, entry)} was expected, found {_shown(entry.get('input'))}.{_closest(entry)}")


_EXAMPLES = {
    "[time]": '[time] with step = "0.02 s" and end = "0.48 s"',
    "[coordinates]": '[coordinates] with a line phi1 = { start = "0 rad", rate = "w1" } for each',
    "rate": 'rate = "w1", the name of the velocity', "step": 'step = "0.02 s"', "end": 'end = "0.48 s"',
    "pieces": 'pieces = [["0 s", "0"], ["0.1 s", "V"]]', "table": 'table = "r.csv"', "of": 'of = "phi1"',
    "kind": f'kind = "{GROUPS[-1].name}"', "coordinates": 'coordinates = ["phi2", "phi3"]', "through": 'through = "P"',
    "row": "row = 7", "column": 'column = "w5"', "value": 'value = "-3.18045"',
    "angle": 'angle = "0 rad"', "center": 'center = "O"', "radius": 'radius = "R"',
}  # fmt: skip
_KINDS = {
    "string_type": "a text in quotation marks", "int_type": "a whole number", "float_type": "a number",
    "list_type": "a list [ … ]", "dict_type": "a section of lines key = value", "model_type": "a table { key = value }",
    "int_from_float": "a whole number",
}  # fmt: skip


def _expected(path: Path, entry: Entry) -> str:
    context = entry.get("ctx") or {}
    problem = entry["type"]
    if problem == "literal_error":
        return re.sub(r"'([^']*)'", r'"\1"', str(context["expected"]))
    if "string_too_long" in entry["types"]:
        return f"a text of at most {context.get('max_length')} letters"
    if "pieces" in path[2:] and len(path) == 4:
        return 'a pair ["0.1 s", "formula"]'
    if problem in {"too_long", "too_short", "string_too_short"}:
        bound = f"at most {context['max_length']}" if problem == "too_long" else f"at least {context['min_length']}"
        lines = len(path) == 1 and isinstance(entry.get("input"), dict)
        return f"{bound.replace('1', 'one')} line" if lines else f"a {'text' if problem[:6] == 'string' else 'list'} of {bound}"
    if path in {("constraint",), ("group",)}:
        return f"a section in double brackets, [[{path[0]}]],"
    if problem == "greater_than_equal":
        return f"a whole number of at least {context['ge']}"
    if path[0] in {"drive", "functions"} and len(path) == 2:
        return 'a formula in quotation marks, { pieces = … } or { table = "r.csv", of = "phi1" }'
    if {"string_type", "float_type"} <= set(entry["types"]):
        return '"value unit", such as "0.953 m", or a number'
    if len(path) == 1 and problem == "model_type":
        return _KINDS["dict_type"]
    return _KINDS.get(problem, "another value")


def _shown(value: Any) -> str:
    """Return a value as the file writes it, shortened."""
    if isinstance(value, dict):
        return "a table { … }" if value else "nothing"
    try:
        text = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError):
        text = str(value)
    return text if len(text) <= 60 else f"{text[:60]}…"


def _closest(entry: Entry) -> str:
    expected = re.findall(r"'([^']+)'", str((entry.get("ctx") or {}).get("expected", "")))
    value = entry.get("input")
    return closest(value, expected) if isinstance(value, str) else ""


def _repair(data: dict[str, Any], path: Path, entry: Entry) -> None:
    """Put a stand-in in the place of a fault, or take it out."""
    if path[-1] == "[key]":
        path = path[:-1]
    section, *inner = path
    depth = 1 if len(inner) < 1 else 2
    owner = _at(data, path[: depth - 1])
    if entry["type"] == "extra_forbidden":
        owner, key = _at(data, path[:-1]), path[-1]
        if isinstance(owner, dict):
            owner.pop(key, None)
    elif section in _STAND_INS and depth == 2 and isinstance(owner, dict):
        owner[inner[0]] = _STAND_INS[section]
    elif section == "coordinates":
        _repair_coordinates(data, inner)
    elif section == "time":
        _repair_time(data, inner)
    elif section == "constraint" and depth == 2 and isinstance(owner, list):
        owner[int(inner[0])] = {"equation": "0 = 0"}
    elif section in {"frame", "closure", "ask", "links"} and isinstance(owner, dict):
        owner.pop(inner[0] if inner else section, None)
    else:
        data.pop(str(section), None)


_STAND_INS = {"given": 1, "drive": "0", "functions": "1", "unknowns": "1", "points": "(0, 0)"}


def _repair_coordinates(data: dict[str, Any], inner: list[str | int]) -> None:
    if not inner:
        data["coordinates"] = {"coordinate": {"rate": "its_rate"}}
        return
    coordinate = data["coordinates"][inner[0]]
    if isinstance(coordinate, dict) and len(inner) > 1 and inner[1] in {"start", "unit"}:
        coordinate.pop(inner[1], None)
    else:
        data["coordinates"][inner[0]] = {"rate": f"rate_of_{inner[0]}"[:40]}


def _repair_time(data: dict[str, Any], inner: list[str | int]) -> None:
    time = data.get("time")
    if not inner or not isinstance(time, dict):
        data["time"] = {"step": 1, "end": 1}
    elif inner[0] in {"step", "end"}:
        other = time.get("end" if inner[0] == "step" else "step")
        time[inner[0]] = other if isinstance(other, (str, int, float)) and not isinstance(other, bool) else 1
    else:
        time.pop(inner[0], None)


def _known_keys(path: Path, data: dict[str, Any]) -> set[str]:
    """Return the keys that may stand in the table at `path`."""
    if len(path) == 2 and path[0] in {"drive", "functions"}:
        model: Any = {"Table": schema.Table, "Pieces": schema.Pieces}[_meant(data, path)]
    else:
        model = schema.VariantFile
        for place, part in enumerate(path):
            if not (isinstance(part, int) or (place == 1 and path[0] in {"coordinates", "links"})):
                model = _MODELS.get(part, model)
    return {field.alias or name for name, field in model.model_fields.items()}


_MODELS: dict[str | int, Any] = {
    "time": schema.Time, "constraint": schema.Constraint, "group": schema.Group, "links": schema.Link,
    "frame": schema.Frame, "closure": schema.Closure, "ask": schema.Ask, "coordinates": schema.Coordinate,
    "guide": schema.Guide, "guides": schema.Guide, "rails": schema.Rail, "circles": schema.Circle,
}  # fmt: skip
