"""The paths between points of known velocity, and their projections: the equations (6) to (18) of the guide.

Enters: a `PointGraph`.  Leaves: `Path`, `Projection`.  Used by `derive.py`.
V_B = V_A + V_BA.  For a segment AB of length L at the angle f, V_BA = (-w L sin f, w L cos f), where w is the rate of the
segment; a length that changes at the rate u adds (u cos f, u sin f).
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
    """The way from one point of known velocity to another: V_end = V_start + the relative velocities of its segments."""

    segments: tuple[Segment, ...]

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points along the path, in order."""
        return (self.segments[0].start, *(segment.end for segment in self.segments))


@frozen
class Term:
    """One term of a projection: sign * length * rate * function(angle); `length` is None if `rate` is that of a length."""

    sign: int
    rate: str
    length: Formula | None
    function: str
    angle: Angle


@frozen
class Projection:
    """A vector equation along one axis: known component of the end = known component of the start + terms."""

    path: Path
    axis: str
    start: Formula
    end: Formula
    terms: tuple[Term, ...]


def paths_of(graph: PointGraph) -> tuple[Path, ...]:
    """Return at most `MOST_PATHS` paths between known points: first those from the driven (first) point, nearest end first.

    A path passes through no other point whose whole velocity is known: it would add nothing to its two parts.
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
    """Return the known points as reached from the first one, branch by branch, the branch with the nearest known point first."""
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
    """Yield the projections of each path onto the axes along which the velocities of both its ends are known."""
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
        sign, function = (-1, "sin") if axis == "x" else (1, "cos")
        terms += [Term(sign * sense, rate, segment.length, function, segment.angle) for rate, sense in segment.turning]
        if segment.slide:
            terms.append(Term(1, segment.slide, None, "cos" if axis == "x" else "sin", segment.angle))
    return Projection(path, axis, first, last, tuple(terms))
