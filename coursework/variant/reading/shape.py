"""The check that a file has the shape of a variant, with faults in the words of the file.

Enters: a `Source`.  Leaves: `Shape`: the faults, and the file's records with a stand-in in the place of each fault, so that
the rest of the file is read at the same time.  Used by `reader.py` only.
"""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from coursework.system.frozen import frozen
from coursework.variant.reading import schema
from coursework.variant.reading.stand_ins import Entry, at, stand_in
from coursework.variant.reading.well_formed import Unfit, fitted
from coursework.variant.record.vocabulary import GROUP_KINDS
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, either, load_phrases, say


@frozen
class Shape:
    """The records of a file and its `faults`; `broken` are the paths with a fault.

    `hidden` are the kinds of names whose declarations a fault may have removed: an undeclared name of these is no new fault.
    """

    file: schema.VariantFile
    faults: list[Fault]
    hidden: frozenset[str]
    broken: frozenset[KeyPath]


def read_shape(source: Source) -> Shape:
    """Return the checked file.  Raises `InputError` only if no stand-in makes the rest readable."""
    try:
        return Shape(fitted(schema.VariantFile, source.data), [], frozenset(), frozenset())
    except Unfit:
        return _mended(source)


def _mended(source: Source) -> Shape:
    """Return a file of the wrong shape, with stand-ins; only for such a file pydantic is imported, to describe the faults."""
    from pydantic import ValidationError

    from coursework.variant.reading.models import model_of

    data = source.data
    if other := _of_another_file(data):
        told = say("fault.V020", listed=", ".join(key[:_LONGEST] for key in other))
        raise InputError([source.fault((other[0],), told, at_key=True)])
    faults: list[Fault] = []
    repaired: set[KeyPath] = set()
    hidden: set[str] = set()
    while True:
        try:
            model_of(schema.VariantFile).model_validate(data)
            return Shape(fitted(schema.VariantFile, data), faults, frozenset(hidden), frozenset(repaired))
        except ValidationError as error:
            found = _entries(error.errors(include_url=False), data)
            new = {path: entry for path, entry in found.items() if path not in repaired and not _is_misspelt(path, found)}
            faults += [_fault(path, entry, source) for path, entry in new.items()]
            if found.keys() <= repaired:
                raise InputError(faults) from error
            data = data if repaired else copy.deepcopy(data)
            hidden = hidden.union(*(_hides(path, entry) for path, entry in found.items()))
            repaired |= found.keys()
            for path, entry in found.items():
                stand_in(data, path, entry)


def _is_misspelt(path: KeyPath, found: Mapping[KeyPath, Entry]) -> bool:
    """Return whether what is missing at a path stands beside it, misspelt: then the unknown key is the one fault."""
    if path[0] == "given" and len(path) < 4 and found[path]["type"] != "extra_forbidden":
        return any(other[:2] == path[:2] and len(other) > 2 and found[other]["type"] == "extra_forbidden" for other in found)
    unknown = (other for other in found if other[:-1] == path[:-1] and found[other]["type"] == "extra_forbidden")
    return found[path]["type"] == "missing" and any(closest(str(other[-1]), [str(path[-1])]) for other in unknown)


def _of_another_file(data: dict[str, Any]) -> list[str]:
    """Return the sections that no variant has, if there are several and nothing describes a mechanism: ranges, a rubric."""
    known = schema.VariantFile.keys()
    strange = [key for key in data if key not in known]
    return [] if len(strange) < _STRANGE or not _OF_A_MECHANISM.isdisjoint(data) else strange[:_LISTED]


_STRANGE, _LISTED, _LONGEST = 2, 3, 50  # keys that make a file another one, those that are listed, characters of each
_OF_A_MECHANISM = {"coordinates", "constraint", "group", "drive", "unknowns"}


def _hides(path: KeyPath, entry: Entry) -> set[str]:
    """Return the kinds of names that may have been declared at the place of a fault."""
    section = str(path[0])
    if len(path) == 1:
        import difflib  # imported only for a mistake

        meant = difflib.get_close_matches(section, schema.VariantFile.keys(), n=1)
        return _DECLARED.get(meant[0], set()) if meant else set().union(*_DECLARED.values())
    if section == "coordinates" and entry["type"] != "extra_forbidden" and path[-1] not in {"start", "unit"}:
        return {"rate"}
    return {"point"} if section == "group" and (len(path) == 2 or path[2] == "meets") else set()


# Section -> the kinds of names declared in it.
_DECLARED: dict[str, set[str]] = {
    "given": {"given"}, "drive": {"drive"}, "coordinates": {"coordinate", "rate"}, "unknowns": {"unknown"},
    "functions": {"function"}, "points": {"point"}, "group": {"point"},
}  # fmt: skip


def _entries(errors: Iterable[Any], data: dict[str, Any]) -> dict[KeyPath, Entry]:
    """Return one entry for each faulty path of the file.

    pydantic adds names of types to a path, and gives an entry for each type that a value could have.  Here the steps that the
    file does not have are dropped, and for a table only the entries of the intended kind of table are kept.
    """
    grouped: dict[KeyPath, list[tuple[str, Entry]]] = {}
    for entry in errors:
        path, kind = _path_in(data, entry["loc"], entry["type"])
        grouped.setdefault(path, []).append((kind, entry))
    tables = [path for path, entries in grouped.items() if {kind for kind, _ in entries} & _TABLES]
    result: dict[KeyPath, Entry] = {}
    for path, entries in grouped.items():
        if isinstance(at(data, path), dict) and any(other[: len(path)] == path and other != path for other in tables):
            continue  # the entries inside the table say more than "this is no text"
        meant = [e for kind, e in entries if kind not in {"Table", "Pieces"} or kind == _meant(data, path)]
        if meant:
            result[path] = {**meant[0], "types": [e["type"] for e in meant]}
    return result


def _path_in(data: Any, loc: KeyPath, problem: str) -> tuple[KeyPath, str]:
    """Return the part of pydantic's path that exists in the file, and the kind of table named in the path."""
    path: KeyPath = ()
    kind = ""
    for place, part in enumerate(loc):
        last = place == len(loc) - 1
        inside = part in data if isinstance(data, dict) else isinstance(data, list) and isinstance(part, int)
        if inside or (last and (problem == "missing" or part == "[key]")):
            path = (*path, part)
            data = None if last else data[part]
        elif part in _TABLES:
            kind = str(part)
    return path, kind


_TABLES = {"Table", "Pieces", "Unknown", "Mass", "Load", "MotorEntry", "Flywheel"}  # tables that may be texts too


def _meant(data: dict[str, Any], path: KeyPath) -> str:
    """Return whether a law given by several keys is meant as a table of numbers or as pieces."""
    owner = at(data, path[:2])
    keys = set(owner) if isinstance(owner, dict) else set()
    return "Pieces" if "pieces" in keys or (path[0] == "drive" and not keys & {"table", "of", "method"}) else "Table"


def _fault(path: KeyPath, entry: Entry, source: Source) -> Fault:
    key = str(path[-1]) if path else ""
    problem = entry["type"]
    if problem == "extra_forbidden":
        known = sorted(_keys_of(path[:-1], source.data))
        advice = closest(key, known) or say("hint.known", known=", ".join(known))
        line, above = (source.positions.find(place, key=True)[0] for place in (path, path[:-1]))
        if path[0] == "given" and len(path) > 2 and line != above:  # r.1 = … is a key of a table r that no line begins
            advice = say("hint.no_point", name="".join(map(str, path[1:])))
        return source.fault(path, say("fault.V011", name=key, hint=advice), at_key=True)
    if problem == "missing":
        if len(path) == 1:
            told = say("fault.V012", name=key, example=_example(key, f"[{key}]"))
        else:
            example = 'of = "t"' if (path[0], key) == ("drive", "of") else _EXAMPLES.get(key, f"{key} = …")
            told = say("fault.V013", name=key, example=_example(key, example))
        return source.fault(path[:-1], told, at_key=True)
    if key == "[key]":
        name = str(path[-2]) if len(path) > 1 else ""
        return source.fault(path[:-2], say("fault.V014", name=name[:50]), at_key=True)
    if path[0] == "motor" and len(path) == 2 and key not in {"rates", "start"}:
        return source.fault(path, of_motor(key, source.data.get("links", ())))
    shown = _shown(entry.get("input"))
    return source.fault(path, say("fault.V015", what=_expected(path, entry), found=shown, hint=_closest(entry)))


def of_motor(key: str, links: Iterable[str]) -> Sentence:
    """Return how to write the flywheel or a torque of [motor], which stands under the name of its link."""
    name = key if key.isdecimal() or key in links else next(iter(links), "1")
    return say("fault.V716") if key == "flywheel" else say("fault.V713", name=name)


def _example(key: str, plain: str) -> str:
    """Return how to write a key, from the words file if it has an example."""
    described = f"fault.example.{'section_' if plain.startswith('[') else ''}{key}"
    return say(described) if load_phrases().has(described) else plain


_EXAMPLES = {
    "step": 'step = "0.02 s"', "end": 'end = "0.48 s"',
    "pieces": 'pieces = [["0 s", "0"], ["0.1 s", "V"]]', "table": 'table = "r.csv"', "of": 'of = "phi1"',
    "kind": f'kind = "{[*GROUP_KINDS][-1]}"', "coordinates": 'coordinates = ["phi2", "phi3"]', "through": 'through = "P"',
    "unit": 'unit = "m/s"', "row": "row = 7", "column": 'column = "w5"', "value": 'value = "-3.18045"',
    "mass": 'mass = "10 kg"', "torque": 'torque = "60 N*m"', "on": 'on = "1"',
    "angle": 'angle = "0 rad"', "center": 'center = "O"', "radius": 'radius = "R"',
}  # fmt: skip
# pydantic's type of error -> the last part of the key for what was expected.
_KINDS = {
    "string_type": "text", "int_type": "whole", "int_from_float": "whole", "float_type": "number",
    "list_type": "list", "dict_type": "section", "model_type": "table",
}  # fmt: skip


def _expected(path: KeyPath, entry: Entry) -> str:
    context = entry.get("ctx") or {}
    problem = entry["type"]
    if problem == "literal_error":
        return either(re.split(", | or ", str(context["expected"]).replace("'", '"')))
    if "string_too_long" in entry["types"]:
        return _wanted("text_at_most", number=context.get("max_length"))
    if "pieces" in path[2:] and len(path) == 4:
        return _wanted("pair")
    if problem in {"too_long", "too_short", "string_too_short"}:
        lines = len(path) == 1 and isinstance(entry.get("input"), dict)
        what = "lines" if lines else "text" if problem == "string_too_short" else "list"
        bound = "at_most" if problem == "too_long" else "at_least"
        return _wanted(f"{what}_{bound}", number=context["max_length" if problem == "too_long" else "min_length"])
    if path in {("constraint",), ("group",)}:
        return _wanted("sections", name=path[0])
    if problem == "greater_than_equal":
        return _wanted("whole_at_least", number=context["ge"])
    if path[0] in {"drive", "functions"} and len(path) == 2:
        return _wanted("law")
    if {"string_type", "float_type"} <= set(entry["types"]):
        return _wanted("quantity")
    if len(path) == 1 and problem == "model_type":
        return _wanted("section")
    if problem == "model_type":
        return _wanted("table_of", keys=", ".join(f"{key} = …" for key in _keys_of(path, {})))
    return _wanted(_KINDS.get(problem, "other"))


def _wanted(kind: str, **values: object) -> Sentence:
    return say(f"fault.wanted.{kind}", **values)


def _shown(value: Any) -> str:
    """Return a value as the file writes it, shortened."""
    if isinstance(value, dict):
        return say("fault.part.table") if value else say("fault.part.nothing")
    try:
        text = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError):
        text = str(value)
    return text if len(text) <= 60 else f"{text[:60]}…"


def _closest(entry: Entry) -> str:
    expected = re.findall(r"'([^']+)'", str((entry.get("ctx") or {}).get("expected", "")))
    value = entry.get("input")
    return closest(value, expected) if isinstance(value, str) else ""


def _keys_of(path: KeyPath, data: dict[str, Any]) -> list[str]:
    """Return the keys allowed in the table at `path`, in the order of the schema."""
    if len(path) == 2 and path[0] in {"drive", "functions"}:
        model: Any = {"Table": schema.Table, "Pieces": schema.Pieces}[_meant(data, path)]
    else:
        model = schema.VariantFile
        for place, part in enumerate(path):
            if not (isinstance(part, int) or (place == 1 and path[0] in _NAMED)):
                model = _MODELS.get(part, model)
    return [*model.keys()]


_NAMED = {"given", "coordinates", "links", "text", "unknowns", "masses", "forces", "friction", "motor"}  # tables under any name
_MODELS: dict[str | int, Any] = {
    "text": schema.Texts, "given": schema.Datum, "time": schema.Time,
    "constraint": schema.Constraint, "group": schema.Group, "links": schema.Link,
    "unknowns": schema.Unknown, "frame": schema.Frame, "closure": schema.Closure, "ask": schema.Ask,
    "coordinates": schema.Coordinate, "guide": schema.Guide, "guides": schema.Guide, "rails": schema.Rail,
    "circles": schema.Circle, "masses": schema.Mass, "forces": schema.Load, "friction": schema.FrictionEntry,
    "motor": schema.MotorEntry, "flywheel": schema.Flywheel,
}  # fmt: skip
