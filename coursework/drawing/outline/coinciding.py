"""Finds the position of a mechanism in which its links, guides and pivots cover one another least.

Enters: an `Outline` and its `Poses`.  Leaves: whether links lie on one line; the row in which they coincide least.
Used by `drawing/figures.py`.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import Poses
from coursework.system.arrays import Array, Complex
from coursework.system.frozen import frozen

MOST = 180  # most rows that are compared
PAPER = 100.0  # mm: assumed size of the mechanism on paper
# Two links with a common joint are seen apart from these sines on: folded on each other from 15 degrees, stretched from 5.
FOLDED, STRETCHED = 0.26, 0.087
OPEN = 0.87  # the same when the clearest row is sought: up to this angle, 60 degrees, a row still becomes clearer
NEAR, FAR = 3.0, 9.0  # mm: parts farther apart are seen apart; the same when the clearest row is sought
ALIKE = 0.5  # share from which two links lie on one line: at half of these angles, or 1.5 mm beside each other
ASIDE = 0.4  # weight of guides and pivots, which may lie below a link
PARTS = (np.arange(12) + 0.5) / 12
Rows = NDArray[np.intp]
EQUAL = 1e-6  # rows whose totals differ by less are equally good: the first is taken


@frozen
class _Part:
    """A straight part of a `link` ("" for a guide) in every row, with the points of the outline that lie on it."""

    link: str
    begin: Complex
    end: Complex
    on: frozenset[str]


def coincides(outline: Outline, poses: Poses) -> bool:
    """Return whether links lie on one line in the first row."""
    shares = _shares(outline, poses, np.arange(1), (FOLDED, STRETCHED, NEAR))
    return any(share[0] > ALIKE for share in shares)


def clearest(outline: Outline, poses: Poses) -> int:
    """Return the row (from 0) in which links, guides and pivots coincide least."""
    rows = np.arange(0, len(poses.t), max(1, -(-len(poses.t) // MOST)))
    total: Array = np.sum(_shares(outline, poses, rows, (OPEN, OPEN, FAR)), axis=0)
    return int(rows[int(np.argmin(np.round(total / EQUAL)))])


def _shares(outline: Outline, poses: Poses, rows: Rows, limits: tuple[float, float, float]) -> list[Array]:
    """Return, for every pair that could coincide, how far it does in each row, 0 to 1.

    `limits` are the sines for folded and stretched links, and the distance (mm) from which they are seen apart.
    """
    places = np.stack([poses.at[name][rows] for name in outline.shown])
    size = np.hypot(np.ptp(places.real, axis=0), np.ptp(places.imag, axis=0))
    scale = PAPER / np.where(size > 0, size, 1.0)
    parts = _parts(outline, poses, rows)
    pairs = [(a, b) for a, b in itertools.combinations(parts, 2) if a.link != b.link]
    shares = [_together(a, b, scale, limits) * (1.0 if a.link and b.link else ASIDE) for a, b in pairs]
    pivots = [(name, part) for name in outline.hinges for part in parts if name not in part.on and part.link]
    return shares + [ASIDE * _close(part, poses.at[name][rows][:, None], scale, limits[2])[:, 0] for name, part in pivots]


def _parts(outline: Outline, poses: Poses, rows: Rows) -> list[_Part]:
    """Return the straight parts of links, and the guides of the frame."""
    at = {name: places[rows] for name, places in poses.at.items()}
    found = [
        _Part(bar.link, at[a], at[b], frozenset((a, b)) | _riders(outline, bar.link))
        for bar in outline.bars
        for a, b in itertools.pairwise(bar.corners)
    ]
    for slot in outline.slots:
        along = poses.along(slot.base, slot.toward)[rows]
        for rider in slot.riders:
            foot = at[slot.at] + 1j * along * ((at[rider] - at[slot.at]) * along.conjugate()).imag
            found.append(_Part(slot.link, foot, at[rider], frozenset((slot.at, *slot.riders))))
    for rail in outline.rails:
        if rail.rider and not rail.rolls:
            start, way, low, high = poses.travel(rail)
            ends = [np.full(len(rows), start + way * reach) for reach in (low, high)]
            found.append(_Part("", ends[0], ends[1], frozenset((rail.rider,))))
    return found


def _riders(outline: Outline, link: str) -> frozenset[str]:
    return frozenset(rider for slot in outline.slots if slot.link == link for rider in slot.riders)


def _together(a: _Part, b: _Part, scale: Array, limits: tuple[float, float, float]) -> Array:
    """Return how far two parts lie on one line in every row, 0 to 1: by the angle at their joint, else by their distance."""
    ways = [part.end - part.begin for part in (a, b)]
    lengths = [np.abs(way) for way in ways]
    if a.on & b.on:
        product = lengths[0] * lengths[1]
        sine = np.abs((ways[0].conjugate() * ways[1]).imag) / np.where(product > 0, product, 1.0)
        middles = [(part.begin + part.end) / 2 for part in (a, b)]
        is_folded = np.abs(middles[0] - middles[1]) < 0.49 * (lengths[0] + lengths[1])
        by_angle = 1 - sine / np.where(is_folded, limits[0], limits[1])
        by_gap = np.where(is_folded, 1 - sine * np.minimum(*lengths) * scale / (1.5 * limits[2]), 0.0)
        return np.where(product > 0, np.maximum(0.0, np.maximum(by_angle, by_gap)), 0.0)
    first_is_short = lengths[0].mean() <= lengths[1].mean()
    short, long = (a, b) if first_is_short else (b, a)
    samples = short.begin[:, None] + (short.end - short.begin)[:, None] * PARTS
    return np.asarray(_close(long, samples, scale, limits[2]).mean(axis=1))


def _close(part: _Part, places: Complex, scale: Array, far: float) -> Array:
    """Return how near places (rows, n) are to a part: from 1 on it to 0 at `far` mm."""
    way = (part.end - part.begin)[:, None]
    square = np.abs(way) ** 2
    along = ((places - part.begin[:, None]) * way.conjugate()).real / np.where(square > 0, square, 1.0)
    gap = np.abs(places - part.begin[:, None] - np.clip(along, 0.0, 1.0) * way) * scale[:, None]
    return np.maximum(0.0, 1 - gap / far)
