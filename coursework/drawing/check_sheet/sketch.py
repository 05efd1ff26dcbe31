"""One row of a motion -> what stands on the paper before anything is constructed.

Enters: a mechanism, its velocity equations and a row.  Leaves: `Sketch` with its `Pose`, points and vectors as complex numbers
x + iy in SI.  Used by the modules beside it.
The outline says by name what slides or rolls where: a point that merely happens to lie on a rail is no slider.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace

import numpy as np

from coursework.drawing.lettering.turns import clockwise_rates
from coursework.drawing.outline.ground import racks
from coursework.drawing.outline.outline import Bar, Outline
from coursework.drawing.outline.poses import Poses, read_poses
from coursework.drawing.plans.given import DrivenLengths, given_points
from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.mechanism import Mechanism
from coursework.motion.geometry.time_derivatives import jets
from coursework.motion.integration.motion import Motion
from coursework.system.angles import cross
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.words.sentences import say


@frozen
class Body:
    """A rigid link: its material points and the name of its rate; `guide` is the unit direction in which a slider translates.

    `has_namesake`: the velocity with the number of the link, ω₂ of link 2, is another one in the file.
    """

    name: str
    points: tuple[str, ...]
    rate: str | None = None
    guide: complex = 0j
    has_namesake: bool = False


@frozen
class Slide:
    """A point `rider` slides on a link in the unit direction `along`; the `block` there ("" for a bare pin) turns with the link.

    `speed` (m/s) is the sliding speed along the link if it is driven, else None.
    """

    rider: str
    link: str
    along: complex
    block: str = ""
    speed: float | None = None


@frozen
class Pose:
    """One position (m).

    `fixed` points are at rest (hinges of the frame, contacts that roll on it); `guided` points move along a unit direction.
    `velocities` (m/s) of driven points and `rates` (rad/s) of driven links are known.  `slides` are the guides that move:
    slots of levers, and sleeves in which a bar slides.
    """

    positions: Mapping[str, complex]
    bodies: tuple[Body, ...]
    fixed: frozenset[str]
    guided: Mapping[str, complex]
    velocities: Mapping[str, complex]
    rates: Mapping[str, float]
    slides: tuple[Slide, ...] = ()

    @property
    def driven_lengths(self) -> list[tuple[str, str]]:
        """Return link and rider of every slide that is driven."""
        return [(slide.link, slide.rider) for slide in self.slides if slide.speed is not None]

    @property
    def size(self) -> float:
        """Return the largest distance of two points of the links (m)."""
        points = {self.positions[name] for body in self.bodies for name in body.points}
        return max((abs(a - b) for a, b in itertools.combinations(points, 2)), default=0.0)


# Relative to the mechanism: a contact this near to a rail or circle at the start touches it; task sheets have rounded data.
INCIDENT = 1e-6
# Below this cosine between rail and axis, that component of a driven velocity does not give the speed along the rail.
STEEP = 1e-6
ROUND_OFF = 1e-12  # relative to the largest value of a law


@frozen
class Sketch:
    """The position: `pose` for the construction, and what only the drawing needs.

    `off_rails` and `off_tracks` are points that slide or roll on fixed guides, with their distance from these (m).
    `start` holds the positions of row 1; `wheels` maps link -> (centre, contact); `racks` maps link -> contact with its gear;
    `moving` are the points of links, without contacts, that are not at rest; `outline`, `poses` and `row` (from 0) are painted.
    Rates named in `clockwise` are counted clockwise by the file; those of `pose` are counter-clockwise like all of the drawing.
    """

    pose: Pose
    off_rails: tuple[tuple[str, float], ...]
    off_tracks: tuple[tuple[str, float], ...]
    hinges: tuple[str, ...]
    start: Mapping[str, complex]
    wheels: Mapping[str, tuple[str, str]]
    racks: Mapping[str, str]
    moving: tuple[str, ...]
    notes: tuple[str, ...]
    outline: Outline
    poses: Poses
    row: int
    clockwise: Collection[str] = ()

    def as_counted(self, body: Body, omega: float) -> float:
        """Return a counter-clockwise angular velocity of a link as the file counts it, or the reverse."""
        return -omega if body.rate in self.clockwise else omega


def read_sketch(
    mechanism: Mechanism, outline: Outline, equations: VelocityEquations, lengths: DrivenLengths
) -> Callable[[Motion, int], Sketch]:
    """Return `read(motion, row)` (row from 0), compiled once for all rows; `lengths` are the driven lengths."""
    variant, posed = equations.variant, read_poses(outline, equations)
    pushed = [name for name in given_points(outline, variant) if name not in outline.driven]
    places = dict(outline.points)  # of points without a name, too
    components = [part for name in pushed for part in equations.symbols.vector(places[name])]
    rates = jets(equations, components, 1)[1] if pushed else None

    def read(motion: Motion, row: int) -> Sketch:
        columns = rates(motion.t, motion.coordinates, motion.velocities).T if rates else np.zeros((0, 1))
        parts = [_seen(column, row) for column in columns]
        given = {name: complex(x, y) for name, x, y in zip(pushed, parts[::2], parts[1::2], strict=True)}
        poses = posed(motion.t, motion.coordinates)
        if variant.motor is not None:  # forces, not laws, say how fast a free rate is
            poses = replace(poses, drive={**poses.drive, **{rate: motion.column(rate) for rate in variant.motor.rates}})
        return _sketch(mechanism, outline, poses, row, given, lengths)

    return read


def _sketch(
    mechanism: Mechanism, outline: Outline, poses: Poses, row: int, given: Mapping[str, complex], lengths: DrivenLengths
) -> Sketch:  # fmt: skip
    variant = mechanism.variant
    start, here = ({name: at for name, at in poses.pose(k).items() if not name.startswith("~")} for k in (0, row))
    wheels = {wheel.link: (wheel.centre, wheel.contact) for wheel in outline.wheels}
    contacts = {contact for _, contact in wheels.values()}
    bodies = [body for bar in outline.bars if (body := _body(bar, wheels, variant.rates)).points]
    hinges = tuple(name for name in outline.hinges if any(name in body.points for body in bodies))
    rails = [(rail, complex(poses.along(rail.base, rail.toward)[row])) for rail in outline.rails]
    guided = {rail.rider: along for rail, along in rails if rail.rider and not rail.rolls}
    off_rails = tuple(
        (rail.rider, cross(along, complex(poses.at[rail.rider][row] - poses.at[rail.at][0])))
        for rail, along in rails
        if rail.rider
    )
    near = INCIDENT * Pose(start, tuple(bodies), frozenset(), {}, {}, {}).size
    off_tracks = tuple(_off_tracks(outline, poses, row, near))
    free = [(complex(poses.at[rail.at][0]), along) for rail, along in rails if not rail.rider]
    resting = {rail.rider for rail in outline.rails if rail.rolls} | {contact for contact, _ in off_tracks}
    resting |= {name for name in contacts for at, along in free if abs(cross(start[name] - at, along)) <= near}
    resting -= {contact for centre, contact in wheels.values() if centre in hinges}
    fixed = frozenset({*hinges, *resting})
    driven_racks = {rack.link: rack.contact for rack in racks(outline, poses.pose(0)) if rack.contact not in resting}
    moving = dict.fromkeys(name for body in bodies for name in body.points if name not in fixed | contacts)
    carried = {block.link for block in outline.blocks if block.open}  # blocks on moving links: they turn with these links
    bodies = [
        replace(body, guide=guided[body.points[0]]) if _is_slider(body, guided) and body.name not in carried else body
        for body in bodies
    ]
    bodies = [
        replace(body, points=(*body.points, driven_racks[body.name])) if body.name in driven_racks else body for body in bodies
    ]
    drive = {name: _seen(values, row) for name, values in poses.drive.items()}
    driven = {name: v for name in here if (v := _driven(name, drive, guided)) is not None and name not in fixed}
    driven.update(given)
    speeds = {slide: drive[rate] for slide, rate in lengths.items()}
    slides = tuple(_slides(outline, poses, row, speeds))
    gears = {contact: link for link, (_, contact) in wheels.items()}
    notes = (
        *(say("drawing.empty_rail", rail=k) for k, rail in enumerate(outline.rails, start=1) if variant.links and not rail.rider),
        *(say("drawing.drives", link=link, wheel=gears[at], contact=at) for link, at in driven_racks.items()),
    )
    clockwise = clockwise_rates(mechanism, here)
    rates = {rate: -drive[rate] if rate in clockwise else drive[rate] for rate in variant.known_rates}
    pose = Pose(here, tuple(bodies), fixed, guided, driven, rates, slides)
    return Sketch(
        pose, off_rails, off_tracks, hinges, start, wheels, driven_racks, tuple(moving), notes, outline, poses, row, clockwise
    )


def _body(bar: Bar, wheels: Mapping[str, tuple[str, str]], rates: Collection[str]) -> Body:
    """Return a bar as a rigid link with its named points; a wheel also has its contact."""
    points = dict.fromkeys(name for name in (*bar.corners, *wheels.get(bar.link, ())) if not name.startswith("~"))
    return Body(bar.link, tuple(points), bar.rate or None, has_namesake=not bar.rate and f"w{bar.link}" in rates)


def _slides(outline: Outline, poses: Poses, row: int, speeds: Mapping[tuple[str, str], float]) -> Iterator[Slide]:
    """Yield the slides on links that move, each with the block that turns with the link."""
    blocks = {(block.at, block.base, block.toward): block.link for block in outline.blocks if block.open}
    for slot in outline.slots:
        for rider in slot.riders:
            along = complex(poses.along(slot.base, slot.toward)[row])
            block = blocks.get((rider, slot.base, slot.toward), "")
            yield Slide(rider, slot.link, along, block, speeds.get((slot.link, rider)))


def _off_tracks(outline: Outline, poses: Poses, row: int, near: float) -> Iterator[tuple[str, float]]:
    """Yield the contacts that lie on a fixed circle in row 1, with their distance (m) from it in `row`."""
    for track in outline.tracks:
        for wheel in outline.wheels:
            first, off = (
                abs(complex(poses.at[wheel.contact][k] - poses.at[track.centre][k]))
                - abs(complex(poses.at[track.rim][k] - poses.at[track.centre][k]))
                for k in (0, row)
            )
            if abs(first) <= near:
                yield wheel.contact, off


def _seen(values: Array, row: int) -> float:
    """Return the value of a law in a row, 0 if it is only round-off, as when a drive reverses."""
    value = float(values[row])
    return value if abs(value) > ROUND_OFF * float(np.max(np.abs(values))) else 0.0


def _is_slider(body: Body, guided: Mapping[str, complex]) -> bool:
    """Return whether a link is a block or rack: it has one point, on a straight guide, and no rate because it does not turn."""
    return body.rate is None and len(body.points) == 1 and body.points[0] in guided


def _driven(name: str, drive: Mapping[str, float], guided: Mapping[str, complex]) -> complex | None:
    """Return the velocity that a drive gives to a point: both components, or one along its rail; None if there is none."""
    x, y = drive.get(f"V{name}x"), drive.get(f"V{name}y")
    if x is not None and y is not None:
        return complex(x, y)
    along = guided.get(name, 0j)
    if x is not None and abs(along.real) > STEEP:
        return along * (x / along.real)
    return along * (y / along.imag) if y is not None and abs(along.imag) > STEEP else None
