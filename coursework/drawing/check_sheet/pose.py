"""One position of a mechanism with its known velocities, before anything is constructed.

Enters: numbers from `sketch.py`.  Leaves: `Pose`, points and vectors as complex numbers x + iy in SI.
Used by `instant_centres.py`, `by_plan.py`, `sketch.py`, `graph_words.py` and `graph_check.py`.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping

from coursework.system.frozen import frozen


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
