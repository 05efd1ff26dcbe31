"""What can be started from: the catalogue with its pictures.

Enters: a `Desk`.  Leaves: plain data.  Used by `bench.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.api import solve
from coursework.desk.answering.pictures import picture
from coursework.desk.answering.typed import Desk
from coursework.desk.job import OK, Answer, plain
from coursework.mechanism.structure import read_structure
from coursework.variant.catalogue import entries, load
from coursework.words.data_folders import folder


def catalogue(desk: Desk) -> Answer:
    """Return name, title, what each variant teaches, its links and groups, and its picture."""
    return plain(OK, [
        {"name": one.name, "title": one.title, "teaches": one.teaches, **_drawn(one.name)} for one in entries(desk.language)
    ])  # fmt: skip


def _drawn(name: str) -> dict[str, Any]:
    scene = solve(load(folder("variants") / f"{name}.toml")).scene
    structure = read_structure(scene.mechanism)
    groups = [one.kind or one.group_class for one in structure.groups] if structure else []
    groups = groups or [one.kind for one in scene.variant.groups]
    return {"links": len(structure.links) + 1 if structure else 0, "groups": groups, "svg": picture(scene)}
