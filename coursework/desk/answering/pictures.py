"""A mechanism as a small animated picture: its bars, wheels, pivots and guides, in the text colour of the page around it.

Enters: a `Scene`.  Leaves: SVG, whose animation waits until it is started.  Used by `completion.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import Poses, read_poses, unit_vectors
from coursework.drawing.outline.tracing import read_outline
from coursework.scene.scene import Scene
from coursework.system.arrays import Complex

SIZE, ROOM = 100.0, 9.0  # units of the picture: side of the square, and margin that stays free
JOINT, BLOCK = 1.8, 1.7
FRAMES, SECONDS = 24, 4
_HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" fill="none" stroke="currentColor" '
    'stroke-width="1.6" stroke-linecap="round" stroke-linejoin="round">'
)


def picture(scene: Scene) -> str:
    """Return the picture, "" if the file places no points."""
    outline = read_outline(scene.mechanism)
    if outline is None or not outline.names:
        return ""
    motion = scene.exact
    t, rows = np.zeros(1), np.array([scene.start])
    if len(motion.t) > 1:
        at = np.linspace(0, len(motion.t) - 1, min(FRAMES, len(motion.t))).round().astype(int)
        t, rows = motion.t[at], motion.coordinates[at]
    poses = read_poses(outline, scene.equations)(t, rows)
    return "".join(_Picture(outline, poses).parts())


class _Picture:
    """The picture of an outline, with its places frame by frame."""

    def __init__(self, outline: Outline, poses: Poses) -> None:
        radii = {wheel.centre: float(abs(poses.at[wheel.contact][0] - poses.at[wheel.centre][0])) for wheel in outline.wheels}
        self.outline, self.radii, self.lines = outline, radii, [*map(poses.slot_ends, outline.slots)]
        ends = [place for line in self.lines for place in line]
        sides = [poses.at[name] + side * radii.get(name, 0.0) for name in outline.names for side in (-1 - 1j, 1 + 1j)]
        shown = np.array([*sides, *ends])
        low, high = complex(shown.real.min(), shown.imag.min()), complex(shown.real.max(), shown.imag.max())
        self.middle, span = (low + high) / 2, high - low
        self.scale = (SIZE - 2 * ROOM) / (max(span.real, span.imag) or 1.0)
        self.at = {name: self.put(places) for name, places in poses.at.items()}

    def put(self, places: Complex) -> Complex:
        """Return places given in m in units of the picture, whose middle is that of the mechanism."""
        return np.asarray(((places - self.middle) * self.scale).conjugate() + (1 + 1j) * SIZE / 2)

    def parts(self) -> Iterator[str]:
        """Yield the elements of the SVG, from its opening to its closing tag."""
        outline = self.outline
        yield _HEAD
        for rail in outline.rails:
            along = unit_vectors(self.at[rail.toward] - self.at[rail.base])[0]
            way = np.real((self.at[rail.rider or rail.at] - self.at[rail.at][0]) / along)
            ends = [complex(self.at[rail.at][0] + along * end) for end in (way.min() - ROOM / 2, way.max() + ROOM / 2)]
            yield f'<path stroke-width="0.8" stroke-dasharray="3 1.5" d="{_way(ends)}"/>'
        for line in self.lines:
            yield self._path([*map(self.put, line)])
        for bar in outline.bars:
            yield self._path([self.at[name] for name in bar.corners], closed=len(bar.corners) > 2)
        for wheel in outline.wheels:
            yield self._circle(wheel.centre, self.radii[wheel.centre] * self.scale, "")
            yield self._path([self.at[wheel.centre], self.at[wheel.contact]])
        for block in outline.blocks:
            along = BLOCK * unit_vectors(self.at[block.toward] - self.at[block.base])
            yield self._path([self.at[block.at] + along * corner for corner in (2 + 1j, 2 - 1j, -2 - 1j, -2 + 1j)], closed=True)
        for name in dict.fromkeys([*(name for bar in outline.bars for name in bar.corners), *outline.hinges]):
            yield self._circle(name, JOINT, ' fill="currentColor"' if name in outline.hinges else ' fill="Canvas"')
        for name in outline.hinges:
            yield f'<path d="M{self.at[name][0].real:.1f} {self.at[name][0].imag:.1f}l-3.5 6h7z" stroke-width="0.8"/>'
        yield "</svg>"

    def _path(self, places: Sequence[Complex], *, closed: bool = False) -> str:
        frames = [_way([complex(place[row]) for place in places]) + "z" * closed for row in range(len(places[0]))]
        return f'<path d="{frames[0]}">{_moving("d", frames)}</path>'

    def _circle(self, name: str, radius: float, fill: str) -> str:
        x, y = ([f"{value:.1f}" for value in part] for part in (self.at[name].real, self.at[name].imag))
        return f'<circle cx="{x[0]}" cy="{y[0]}" r="{radius:.1f}"{fill}>{_moving("cx", x)}{_moving("cy", y)}</circle>'


def _way(places: list[complex]) -> str:
    return "M" + "L".join(f"{place.real:.1f} {place.imag:.1f}" for place in places)


def _moving(attribute: str, frames: list[str]) -> str:
    if len(set(frames)) < 2:
        return ""
    return f'<animate attributeName="{attribute}" values="{";".join(frames)}" dur="{SECONDS}s" repeatCount="indefinite"/>'
