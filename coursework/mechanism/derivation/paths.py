"""The paths between points whose velocity is known, and their projections: the equations (6) to (18) of the guide.

Enters: a `PointGraph`.  Leaves: `Path`, `Projection`.  Used by `derive.py`.
V_B = V_A + V_BA, where V_BA = (-w L sin f, w L cos f) turns with the segment from A to B, of length L at the angle f, and a
length that changes adds (u cos f, u sin f).
"""

from __future__ import annotations

from collections.abc import Iterator

from coursework.mechanism.derivation.segments import Angle, Known, PointGraph, Segment
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula

MOST_PATHS = 12
AXES = ("x", "y")


@frozen
class Path:
    """The way from a point with known velocity to another: V_end = V_start + the relative velocities of its segments."""

    segments: tuple[Segment, ...]

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points in order."""
        return (self.segments[0].start, *(segment.end for segment in self.segments))


@frozen
class Term:
    """One term of a projection: sign * length * rate * function(angle); `length` is None for a length that changes itself."""

    sign: int
    rate: str
    length: Formula | None
    function: str
    angle: Angle


@frozen
class Projection:
    """A vector equation along an axis: known part of the end = known part of the start + terms."""

    path: Path
    axis: str
    start: Formula
    end: Formula
    terms: tuple[Term, ...]


def paths_of(graph: PointGraph) -> tuple[Path, ...]:
    """Return the paths between known points, those from the first (the driven) before the rest, the nearest end first.

    A path goes through no other point whose velocity is wholly known: it would say nothing that its parts do not.
    """
    if not graph.known:
        return ()
    order = _nearest_first(graph)
    first, *rest = order
    pairs = [(first, end) for end in rest]
    pairs += [(rest[start], rest[end]) for end in range(len(rest) - 1, -1, -1) for start in range(end - 1, -1, -1)]
    found: list[Path] = []
    for start, end in pairs:
        found += [path for path in _between(graph, start, end) if any(True for _ in projections_of(graph, (path,)))]
        if len(found) >= MOST_PATHS:
            break
    return tuple(found[:MOST_PATHS])


def _nearest_first(graph: PointGraph) -> list[str]:
    """Return the known points as met from the first: along each branch, the branch with the nearest known point first."""
    start = graph.known[0].point
    ways = {known.point: min(_between(graph, start, known.point), key=lambda path: len(path.segments), default=None)
            for known in graph.known[1:]}  # fmt: skip
    nearest: dict[str, int] = {}
    for way in filter(None, ways.values()):
        for place, segment in enumerate(way.segments):
            nearest[segment.end] = min(nearest.get(segment.end, 99), len(way.segments) - place)
    reached = [name for name, way in ways.items() if way is not None]
    reached.sort(key=lambda name: [(nearest[one.end], one.end) for one in ways[name].segments])  # type: ignore[union-attr]
    return [start, *reached]


def _between(graph: PointGraph, start: str, end: str) -> list[Path]:
    """Return the simple paths from one point to another, shortest first."""
    neighbours: dict[str, list[Segment]] = {}
    for segment in graph.segments:
        neighbours.setdefault(segment.start, []).append(segment)
        neighbours.setdefault(segment.end, []).append(segment.reversed())
    found: list[Path] = []
    waiting: list[tuple[Segment, ...]] = [()]
    while waiting and len(found) < MOST_PATHS:
        way = waiting.pop(0)
        at = way[-1].end if way else start
        passed = {start, *(segment.end for segment in way)}
        if at == end and way:
            found.append(Path(way))
            continue
        if way and graph.of(at).is_whole:
            continue
        waiting += [(*way, segment) for segment in neighbours.get(at, ()) if segment.end not in passed]
        del waiting[1000:]
    return found


def projections_of(graph: PointGraph, paths: tuple[Path, ...]) -> Iterator[Projection]:
    """Yield the projections of each path on the axes along which both its ends are known."""
    for path in paths:
        start, end = graph.of(path.points[0]), graph.of(path.points[-1])
        for axis in AXES:
            if (projection := _projection(path, axis, start, end)) is not None:
                yield projection


def _projection(path: Path, axis: str, start: Known, end: Known) -> Projection | None:
    first, last = start.part(axis), end.part(axis)
    if first is None or last is None:
        return None
    terms: list[Term] = []
    for segment in path.segments:
        if segment.rate:
            sign, function = (-1, "sin") if axis == "x" else (1, "cos")
            terms.append(Term(sign, segment.rate, segment.length, function, segment.angle))
        if segment.slide:
            terms.append(Term(1, segment.slide, None, "cos" if axis == "x" else "sin", segment.angle))
    return Projection(path, axis, first, last, tuple(terms))
