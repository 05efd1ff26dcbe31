"""What is drawn of a moving mechanism, in names of points, and where those points are at any time.

Enters: a `Scene`.  Leaves: `Drawn`, plain lists for the page and the expressions of the places, which `functions.py` lowers.
Used by `page.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from coursework.drawing.outline import Outline
from coursework.drawing.tracing import read_outline
from coursework.scene import Scene


@dataclass(frozen=True, slots=True)
class Drawn:
    """`data`: the outline by key, points by name; `places`: x and y of each point in their order (SymPy, m)."""

    data: dict[str, Any]
    places: tuple[Any, ...]


def drawn_of(scene: Scene) -> Drawn:
    """Return what is drawn; nothing where a file places no points."""
    outline = read_outline(scene.mechanism)
    if outline is None:
        kinds = ("points", "links", "slots", "blocks", "rails", "wheels", "tracks", "hinges", "shown_points", "rings")
        return Drawn({kind: [] for kind in kinds}, ())
    symbols = scene.equations.symbols
    vectors = [symbols.vectors.get(name) or symbols.vector(formula) for name, formula in outline.points]
    kept = outline.plain()
    data = {kind: kept[kind] for kind in ("points", "slots", "blocks", "rails", "wheels", "tracks", "hinges")}
    data["links"] = [{"name": bar.link, "points": list(bar.corners), "rate": bar.rate} for bar in outline.bars]
    data |= {"shown_points": list(outline.shown), "rings": _rings(outline)}
    return Drawn(data, tuple(component for vector in vectors for component in vector))


def _rings(outline: Outline) -> list[str]:
    """Return the points that are joints; the others are mere points of a link."""
    members = [name for bar in outline.bars for name in bar.corners]
    joints = {*outline.hinges, *(block.at for block in outline.blocks), *(wheel.centre for wheel in outline.wheels)}
    contacts = {wheel.contact for wheel in outline.wheels}
    return [name for name in outline.names if (name in joints or members.count(name) > 1) and name not in contacts]
