"""The drawing of a moving mechanism in names of points, and expressions for the places of those points at any time.

Enters: a `Scene`.  Leaves: `Drawn`, plain lists for the page and expressions of places, which `functions.py` compiles; for a page
that does not compute them, the positions themselves, row by row.  Used by `page.py`.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import numpy as np

from coursework.drawing.outline.ground import Places, hinge_ground, inward, racks, rail_side
from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import all_rows, drawn_vectors, read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.motion.integration.motion import Motion
from coursework.report.live.spots import spots_of
from coursework.scene.scene import Scene
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen

_KINDS = ("points", "links", "slots", "blocks", "rails", "wheels", "tracks", "hinges", "racks", "shown_points", "rings", "spots")


@frozen
class Drawn:
    """A drawing: `data` is the outline by key, points by name; `places` are x and y of each point in their order (m)."""

    data: dict[str, Any]
    places: tuple[Any, ...]


def drawn_of(scene: Scene, label: Callable[[str], str]) -> Drawn:
    """Return the drawing, empty if the file places no points; `label` writes the name of a point."""
    outline = read_outline(scene.mechanism)
    if outline is None or not outline.shown:
        return Drawn({kind: [] for kind in _KINDS}, ())
    vectors = drawn_vectors(outline, scene.equations.symbols)
    kept = outline.plain()
    data = {kind: kept[kind] for kind in ("points", "slots", "blocks", "wheels")}
    data["links"] = [{"name": bar.link, "points": list(bar.corners), "rate": bar.rate} for bar in outline.bars]
    read = read_poses(outline, scene.equations)
    start = read(np.zeros(1), np.array([scene.start]))
    data |= _ground(outline, kept, start.pose(0))
    motions = (
        each for each in (scene.exact, scene.scheme_rows or scene.motion) if len(each.t) and all_rows(scene.equations, each)
    )
    poses = [read(each.t, each.coordinates) for each in motions] or [start]
    data["spots"] = spots_of(outline, poses, [label(name) for name in outline.shown])
    data |= {"shown_points": list(outline.shown), "rings": _rings(outline)}
    return Drawn(data, tuple(component for vector in vectors for component in vector))


def _ground(outline: Outline, kept: dict[str, Any], start: Places) -> dict[str, Any]:
    """Return hinges, rails and fixed circles with the side of their ground in the start position, as on paper; and the racks."""
    ways = [(name, hinge_ground(outline, start, name)) for name in outline.hinges]
    sides = [rail_side(outline, start, rail) for rail in outline.rails]
    solid = [inward(outline, start, track) for track in outline.tracks]
    gears = [(rack.rail, rack.contact, rack.side) for rack in racks(outline, start)]
    return {
        "hinges": [{"at": name, "ground": [int(way.real), int(way.imag)]} for name, way in ways],
        "rails": [rail | {"side": side} for rail, side in zip(kept["rails"], sides, strict=True)],
        "tracks": [track | {"inward": side} for track, side in zip(kept["tracks"], solid, strict=True)],
        "racks": [
            {"at": rail.rider, "base": rail.base, "toward": rail.toward, "riders": [contact], "side": side}
            for rail, contact, side in gears
        ],
    }


def _rings(outline: Outline) -> list[str]:
    """Return the points that are joints; other points only belong to a link."""
    members = [name for bar in outline.bars for name in bar.corners]
    joints = {*outline.hinges, *(block.at for block in outline.blocks), *(wheel.centre for wheel in outline.wheels)}
    contacts = {wheel.contact for wheel in outline.wheels}
    return [name for name in outline.names if (name in joints or members.count(name) > 1) and name not in contacts]


# A number takes at least two bytes, a digit and a comma.  Rows twice as far apart take about half the room: the stride is raised
# a little less than that suggests, so that it is not larger than needed.
_LEAST, _NEARLY = 2, 0.9
_DIGITS = 5  # significant digits of the mechanism's size: finer than the eye can see by a factor of 100


def frames_of(run: SceneRun, drawn: Drawn, room: int) -> dict[str, Any]:
    """Return the data of the page: `frames` holds every n-th row of the true motion and of the table in at most `room` bytes.

    Two rows are kept even if they need more.
    """
    scene = run.scene
    table = scene.scheme_rows or run.motion
    truth, rows = _places(run, drawn, scene.exact), _places(run, drawn, table)
    size = float(np.max(np.abs(truth), initial=0.0)) or 1.0
    decimals = _DIGITS - 1 - int(np.floor(np.log10(size)))
    stride = 1 + (truth.size + rows.size) * _LEAST // room
    while True:
        kept = [np.round(each[::stride], decimals).tolist() for each in (truth, rows)]
        frames = {"truth": kept[0], "rows": kept[1], "step": run.step * stride, "finest": 10.0**-decimals}
        needed = len(json.dumps(frames, separators=(",", ":")))
        if needed <= room or len(kept[0]) <= 2:
            break
        stride = max(stride + 1, int(_NEARLY * stride * needed / room))
    return {
        "frames": frames, "step": run.step, "scheme": table.scheme, "stop": None if scene.stop is None else scene.stop.time,
        "coordinates": list(table.coordinate_names), "velocities": list(table.velocity_names), "start": scene.start,
        "rows": len(run.motion.t), "given": run.variant.values, "end": run.variant.time.end,
    }  # fmt: skip


def _places(run: SceneRun, drawn: Drawn, motion: Motion) -> Any:
    """Return the places of all drawn points in the n rows of a motion, (n, 2 * number of points) in m."""
    places = compile_rows(run.scene.equations, drawn.places, 0)
    return places(motion.t, motion.coordinates) if drawn.places else np.zeros((len(motion.t), 0))
