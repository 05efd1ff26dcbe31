"""What a mechanism looks like, in names of points only: bars, blocks, sleeves, slots, rails, wheels, hinges.

Enters: nothing; `tracing.py` fills these records from a mechanism.  Leaves: `Outline` and its parts; besides it a drawing or
an animation needs only the positions of its `points`.  A direction is always that from one point to another.
Used by `tracing.py`, `painter.py`, `poses.py`, `drawing/figures.py` and `plans/`.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula


@frozen
class Bar:
    """A link drawn through points, rigid at its corners; `rate` is the name of its angular velocity."""

    link: str
    corners: tuple[str, ...]
    rate: str = ""


@frozen
class Slot:
    """The straight part of a link on which `riders` slide: a line at some distance from `at`, parallel to `base` - `toward`."""

    link: str
    at: str
    base: str
    toward: str
    riders: tuple[str, ...]


@frozen
class Block:
    """A slider at a point, along `base` - `toward`; if `open`, it is a sleeve through which a bar goes."""

    link: str
    at: str
    base: str
    toward: str
    open: bool = False


@frozen
class Rail:
    """A fixed guide, the line through the first position of `at` along `base` - `toward`; `rolls` if a wheel runs on it.

    `rider` is the point that slides or rolls on it, "" if the file names none.
    """

    at: str
    base: str
    toward: str
    rider: str = ""
    rolls: bool = False


@frozen
class Wheel:
    """A wheel of a link about `centre` through `contact`."""

    link: str
    centre: str
    contact: str


@frozen
class Track:
    """A fixed circle about `centre` through `rim`, on which a wheel rolls."""

    centre: str
    rim: str


@frozen
class Outline:
    """All that is drawn of a mechanism.

    `points` are (name, formula), each after those that it needs; a name that begins with "~" is no point of the file.
    `driven` are the points with a given velocity, `cranks` (rate, hinge) the links with a given rate.
    """

    points: tuple[tuple[str, Formula], ...]
    bars: tuple[Bar, ...]
    slots: tuple[Slot, ...]
    blocks: tuple[Block, ...]
    rails: tuple[Rail, ...]
    wheels: tuple[Wheel, ...]
    tracks: tuple[Track, ...]
    hinges: tuple[str, ...]
    driven: tuple[str, ...]
    cranks: tuple[tuple[str, str], ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Return the points of the file that are part of something drawn, in the order of the file."""
        used = {name for bar in self.bars for name in bar.corners} | {*self.hinges, *self.driven}
        used |= {block.at for block in self.blocks} | {name for wheel in self.wheels for name in (wheel.centre, wheel.contact)}
        return tuple(name for name, _ in self.points if name in used and not name.startswith("~"))

    @property
    def links(self) -> tuple[str, ...]:
        """Return the links with their points, as they are told to whom the drawing does not show them: "3 MBC", "4 CP"."""
        found: dict[str, dict[str, None]] = {}
        parts = [(bar.link, bar.corners) for bar in self.bars] + [(one.link, (one.centre, one.contact)) for one in self.wheels]
        for link, names in (*parts, *((block.link, (block.at,)) for block in self.blocks)):
            found.setdefault(link, {}).update(dict.fromkeys(name for name in names if name in self.names))
        return tuple(f"{link} {''.join(names)}" for link, names in found.items() if link and names)

    @property
    def shown(self) -> tuple[str, ...]:
        """Return the points whose names are written: those of `names`, and the centres of fixed circles."""
        middles = (track.centre for track in self.tracks if not track.centre.startswith("~"))
        return tuple(dict.fromkeys((*self.names, *middles)))

    @property
    def circles(self) -> list[tuple[str, str]]:
        """Return the centre of each wheel and each fixed circle, and a point of its rim."""
        return [(one.centre, one.contact) for one in self.wheels] + [(one.centre, one.rim) for one in self.tracks]

    def plain(self) -> dict[str, Any]:
        """Return the outline as dicts, lists and strings, without the formulas."""
        kept = asdict(self)
        return kept | {"points": [name for name, _ in self.points]}
