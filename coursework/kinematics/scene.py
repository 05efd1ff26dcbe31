"""One row of a motion -> what stands on the paper before anything is constructed.

Enters: velocity equations (for the formulas of points, rails and drives) and a row.  Leaves: `Sketch`.
Used by the graph-analytical check only.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from coursework.equations import VelocityEquations
from coursework.jets import compile_rows
from coursework.kinematics.instant_centres import Body, Scene, cross
from coursework.motion import Motion
from coursework.symbolic import symbol
from coursework.variant.record import Link, Variant

# A point lies on a line or circle where the file puts it there; the start row is exact, so round-off is all it may miss by.
INCIDENT = 1e-9
# Below this cosine a single component of a driven velocity says nothing about the speed along a rail.
STEEP = 1e-6


@dataclass(frozen=True, slots=True)
class Rail:
    """A straight guide through `at` (m) along the unit vector `along`; `point` slides or rolls on it, `off` m beside it."""

    at: complex
    along: complex
    point: str
    rolls: bool
    off: float


@dataclass(frozen=True, slots=True)
class Sketch:
    """The position: `scene` for the construction, and what only the drawing needs.

    `wheels` link -> (centre, contact); `circles` (centre, radius) of the frame; `start` the positions of row 1; `racks` link ->
    contact; `moving` points of links that are not at rest.
    """

    scene: Scene
    rails: tuple[Rail, ...]
    circles: tuple[tuple[complex, float], ...]
    hinges: tuple[str, ...]
    links: tuple[Link, ...]
    wheels: Mapping[str, tuple[str, str]]
    racks: Mapping[str, str]
    start: Mapping[str, complex]
    moving: tuple[str, ...]
    notes: tuple[str, ...]


def read_scene(equations: VelocityEquations) -> Callable[[Motion, int], Sketch]:
    """Return `read(motion, row)` (row from 0), compiled once for every row."""
    variant, symbols = equations.variant, equations.symbols
    wanted: dict[str, Any] = {}

    def pair(key: str, vector: Any) -> None:
        wanted[f"{key}.x"], wanted[f"{key}.y"] = vector

    for name in symbols.vectors:
        pair(f"point {name}", symbols.vectors[name])
    for index, (through, angle) in enumerate(variant.frame.rails):
        pair(f"rail {index}", symbols.vector(through))
        wanted[f"angle {index}"] = symbols.scalar(angle)
    for index, (centre, radius) in enumerate(variant.frame.circles):
        pair(f"circle {index}", symbols.vector(centre))
        wanted[f"radius {index}"] = symbols.scalar(radius)
    for law in variant.drive:
        wanted[f"drive {law.name}"] = symbol(law.name)
    rows = compile_rows(equations, list(wanted.values()), 0)

    def read(motion: Motion, row: int) -> Sketch:
        at = [0, row]
        values = rows(motion.t[at], motion.coordinates[at])
        first, here = (dict(zip(wanted, map(float, line), strict=True)) for line in values)
        return _sketch(variant, tuple(symbols.vectors), first, here)

    return read


def _pair(values: Mapping[str, float], key: str) -> complex:
    return complex(values[f"{key}.x"], values[f"{key}.y"])


def _sketch(variant: Variant, names: tuple[str, ...], first: Mapping[str, float], here: Mapping[str, float]) -> Sketch:
    positions = {name: _pair(here, f"point {name}") for name in names}
    start = {name: _pair(first, f"point {name}") for name in names}
    bodies = [_body(link) for link in variant.links]
    contacts = {link.contact for link in variant.links if link.contact}
    rails, notes = _rails(variant, bodies, contacts, first, here)
    guided = {rail.point: rail.along for rail in rails if rail.point and not rail.rolls}
    bodies = [replace(b, guide=guided[b.points[0]]) if _is_slider(b, guided) else b for b in bodies]
    circles = tuple((_pair(here, f"circle {i}"), here[f"radius {i}"]) for i in range(len(variant.frame.circles)))
    size = Scene(start, tuple(bodies), frozenset(), {}, {}, {}).size
    resting = {link.contact for link in variant.links if link.contact and _rests(link, variant, rails, first, start, size)}
    racks: dict[str, str] = {}
    for link in variant.links:
        if link.contact and link.contact not in resting:
            touching = [b for b in bodies if b.guide and abs(cross(start[link.contact] - start[b.points[0]], b.guide)) <= INCIDENT * size]
            if len(touching) == 1:
                racks[touching[0].name] = link.contact
                notes.append(f"Link {touching[0].name} touches wheel {link.name} at {link.contact}: both have one velocity there.")
    bodies = [replace(b, points=(*b.points, racks[b.name])) if b.name in racks else b for b in bodies]
    fixed = frozenset(variant.frame.hinges) | {name for name in resting if name}
    drive = {law.name: here[f"drive {law.name}"] for law in variant.drive}
    driven = {name: v for name in names if (v := _driven(name, drive, guided)) is not None and name not in fixed}
    rates = {rate: drive[rate] for rate in variant.known_rates}
    scene = Scene(positions, tuple(bodies), fixed, guided, driven, rates)
    moving = dict.fromkeys(p for link in variant.links for p in (*link.points, *((link.wheel,) if link.wheel else ())))
    return Sketch(
        scene, rails, circles, tuple(dict.fromkeys(variant.frame.hinges)), variant.links,
        {link.name: (link.wheel, link.contact) for link in variant.links if link.wheel and link.contact},
        racks, start, tuple(name for name in moving if name not in fixed), tuple(notes),
    )  # fmt: skip


def _body(link: Link) -> Body:
    points = dict.fromkeys(name for name in (*link.points, link.wheel, link.contact) if name)
    return Body(link.name, tuple(points), link.rate)


def _is_slider(body: Body, guided: Mapping[str, complex]) -> bool:
    """Return whether a link is a block or rack: one point, in a straight guide, and no rate because it does not turn."""
    return body.rate is None and len(body.points) == 1 and body.points[0] in guided


def _rails(
    variant: Variant, bodies: list[Body], contacts: set[str], first: Mapping[str, float], here: Mapping[str, float]
) -> tuple[tuple[Rail, ...], list[str]]:  # fmt: skip
    """Return the rails; what slides or rolls on one is the point it is said to go `through`."""
    known = {name for body in bodies for name in body.points}
    rails, notes = [], []
    for index, (through, _) in enumerate(variant.frame.rails):
        angle = here[f"angle {index}"]
        along = _unit(angle)
        at, begin = _pair(here, f"rail {index}"), _pair(first, f"rail {index}")
        point = through.name if through.op == "name" and through.name in known else ""
        if not point:
            notes.append(
                f"Rail {index + 1} goes through no point of a link, so the drawing does not know what slides on it. "
                "Name that point in `through`."
            )
        rails.append(Rail(at, along, point, point in contacts, cross(along, at - begin) if point else 0.0))
    return tuple(rails), notes


def _unit(angle: float) -> complex:
    import cmath

    return cmath.rect(1.0, angle)


def _rests(
    link: Link, variant: Variant, rails: tuple[Rail, ...], first: Mapping[str, float], start: Mapping[str, complex], size: float
) -> bool:  # fmt: skip
    """Return whether the contact of a wheel lies on a rail or circle of the frame, where it is momentarily at rest."""
    assert link.contact is not None
    if link.wheel in variant.frame.hinges:
        return False
    at, near = start[link.contact], INCIDENT * size
    for index, rail in enumerate(rails):
        on_it = abs(cross(at - _pair(first, f"rail {index}"), rail.along)) <= near
        if rail.point == link.contact or (not rail.point and on_it):
            return True
    return any(
        abs(abs(at - _pair(first, f"circle {index}")) - abs(first[f"radius {index}"])) <= near
        for index in range(len(variant.frame.circles))
    )


def _driven(name: str, drive: Mapping[str, float], guided: Mapping[str, complex]) -> complex | None:
    """Return the velocity a drive gives to a point: both components, or one along its rail."""
    x, y = drive.get(f"V{name}x"), drive.get(f"V{name}y")
    if x is not None and y is not None:
        return complex(x, y)
    along = guided.get(name, 0j)
    if x is not None and abs(along.real) > STEEP:
        return along * (x / along.real)
    return along * (y / along.imag) if y is not None and abs(along.imag) > STEEP else None


