"""The words that a text may contain, each with one line of meaning: sections and keys, units, functions, quantities;
and the texts to start from: the catalogue with its pictures.

Enters: a `Desk`, for its language.  Leaves: plain data.  Used by `bench.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from coursework.api import solve
from coursework.desk.answering.pictures import picture
from coursework.desk.answering.typed import Desk
from coursework.desk.job import OK, Answer, plain
from coursework.mechanism.structure import read_structure
from coursework.motion.schemes import SCHEMES, title_of
from coursework.scene.quantities import known_quantities
from coursework.variant.catalogue import entries, load
from coursework.variant.formula.motion_units import UNITS
from coursework.variant.formula.tree import FUNCTIONS
from coursework.variant.reading.models import json_schema
from coursework.variant.record.roles import title
from coursework.variant.record.vocabulary import EXACT, GROUP_SHAPES
from coursework.words.data_folders import folder
from coursework.words.sentences import say

_LISTED = "$defs"
_LINES = {  # example lines of sections in which the author chooses the names
    "given": ['r1 = "0.5 m"'],
    "drive": ['VMx = "0"', 'w1 = "n1"'],
    "coordinates": ['phi1 = { start = "0 rad", rate = "w1" }', 'x1 = { start = "0 m", rate = "u1", unit = "m" }'],
    "unknowns": ['w4 = "1/s"', 'u = { unit = "m/s", of = "B", along = "0 deg" }'],
    "points": ['A = "(0, 0)"', 'B = "A + r1 @ phi1"'],
    "links": ['1 = { points = ["A", "B"], rate = "w1" }', '4 = { wheel = "C", contact = "P", rate = "w4" }'],
}


def keys(desk: Desk) -> dict[str, Any]:
    """Return the words that a text may contain, with their meanings in the language of the desk."""
    schema = json_schema()
    written = desk.words.written
    sections = [_section(name, entry, schema[_LISTED], desk) for name, entry in schema["properties"].items()]
    quantities = {name: _heading(name, desk) for name in known_quantities()}
    schemes = {scheme.name: written(title_of(scheme)) for scheme in SCHEMES.values()} | {EXACT: written(say("exact.title"))}
    kinds = {name: written(title(shape, shape.named())) for name, shape in GROUP_SHAPES.items()}
    return {
        "sections": sections, "functions": list(FUNCTIONS), "units": [unit for unit in UNITS if unit.isascii()],
        "quantities": _pairs(quantities), "schemes": _pairs(schemes), "kinds": _pairs(kinds),
    }  # fmt: skip


def _section(name: str, entry: dict[str, Any], models: dict[str, Any], desk: Desk) -> dict[str, Any]:
    """Return a section with its keys; "many": it is written [[name]]; "named": the author chooses the names in it."""
    found = dict.fromkeys(key for model in _models(entry, models) for key in models[model]["properties"])
    inner = {key: desk.words.template(f"desk.key.{name}_{key}") for key in found if desk.words.has(f"desk.key.{name}_{key}")}
    inner |= {key: desk.words.template(f"desk.key.{key}") for key in found if key not in inner}
    return {
        "name": name, "means": desk.words.template(f"desk.key.{name}"), "many": entry.get("type") == "array" and bool(found),
        "named": "additionalProperties" in entry, "keys": _pairs(inner), "lines": _LINES.get(name, []),
    }  # fmt: skip


def _models(entry: Any, models: dict[str, Any]) -> Iterator[str]:
    """Yield the names of the models that an entry of the schema refers to, including models inside them."""
    if isinstance(entry, dict) and "$ref" in entry:
        name = str(entry["$ref"]).rpartition("/")[2]
        yield name
        yield from _models(models[name]["properties"], models)
    elif isinstance(entry, (dict, list)):
        for part in entry.values() if isinstance(entry, dict) else entry:
            yield from _models(part, models)


def _heading(quantity: str, desk: Desk) -> str:
    key = f"section.{quantity}"
    return desk.words.template(key) if desk.words.has(key) else desk.words.template("section.results")


def _pairs(named: dict[str, str]) -> list[dict[str, str]]:
    return [{"name": name, "means": means} for name, means in named.items()]


def catalogue(desk: Desk) -> Answer:
    """Return the variants of the catalogue: name, title, what each teaches, number of links, groups, picture."""
    return plain(OK, [
        {"name": one.name, "title": one.title, "teaches": one.teaches, **_drawn(one.name)} for one in entries(desk.language)
    ])  # fmt: skip


def _drawn(name: str) -> dict[str, Any]:
    scene = solve(load(folder("variants") / f"{name}.toml")).scene
    structure = read_structure(scene.mechanism)
    groups = [one.kind or one.group_class for one in structure.groups] if structure else []
    groups = groups or [one.kind for one in scene.variant.groups]
    return {"links": len(structure.links) + 1 if structure else 0, "groups": groups, "svg": picture(scene)}
