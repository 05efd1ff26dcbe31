"""Whether [links] and [frame] agree with the points of a file: links keep their shape, hinges rest, guides lie along the motion.

Enters: velocity equations and their closure.  Leaves: hinges with two names.  Raises `InputError` naming each link, rail, circle.
Used by `unseen_signs.py`, `beginning.py`, `equations.py` and `commands/mobility.py`.
A guide across the motion of its slider changes no column of the table, but drawings, plans and forces depend on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from coursework.equations.reduction.equations import VelocityEquations, differentiate
from coursework.equations.reduction.system import compile_values
from coursework.mechanism.mechanism import build
from coursework.motion.geometry.closed_start import OPEN, closed_start
from coursework.motion.geometry.closure import Closure, compile_closure
from coursework.motion.geometry.judging.agreement import agrees
from coursework.motion.geometry.judging.open_loops import where_judged
from coursework.motion.geometry.judging.rails import off_rail
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import evaluate
from coursework.variant.reading.implied_closure import with_implied_closure
from coursework.variant.record.entries import Link, reached
from coursework.variant.record.held import is_arm, largest_length
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

Track = NDArray[np.complex128]

_TOLERANCE = 1e-6  # share of the largest length, or of a distance moved: far above round-off, far below a difference of data
_ROUND_OFF = 1e-9  # share of the largest length


def require_rigid(equations: VelocityEquations, closure: Closure) -> bool:
    """Return whether links keep their shape, growing arms apart; with other data or another start they may not.

    A rail is not judged by a point that [closure] leaves free.  Raises `InputError` if links or the frame contradict the points.
    """
    variant = equations.variant
    if _contradictory(closure) or not (
        variant.links or variant.frame.rails or any(_may_move(name, variant) for name in variant.frame.hinges)
    ):
        return False
    faults = _faults(equations, closure)
    if faults:
        # Residuals of the start are kept and may change distances: a fault counts only if it remains once the start closes.
        near = where_judged(closure)
        if near is not None and _faults(equations, near):
            raise InputError(faults)
    return not faults


def _contradictory(closure: Closure) -> bool:
    """Return whether more is held than can be, so that the positions found satisfy none of it: reported elsewhere."""
    if len(closure.names) <= len(closure.free):
        return False
    times, positions = closure.configurations
    return bool(np.max(np.abs(closure.residual(times, positions, closure.targets(times)[0])[0])) > _ROUND_OFF * closure.scale)


def require_hinges_at_rest(equations: VelocityEquations, closure: Closure) -> None:
    """Raise `InputError` naming a hinge that the written equations move, if they agree with what is held without it.

    Only where [closure] says nothing: there [frame] says what is held, and one wrong hinge keeps others from being held.
    """
    variant = equations.variant
    if {("closure", "holds"), ("closure", "driven")} & variant.lines.keys() or not variant.holds:
        return
    for hinge in (name for name in variant.frame.hinges if _may_move(name, variant)):
        frame = replace(variant.frame, hinges=tuple(name for name in variant.frame.hinges if name != hinge))
        with suppress(InputError):
            bare = with_implied_closure(replace(variant, driven=None, also_driven=(), holds=(), frame=frame))
            others = differentiate(build(bare))
            near = compile_closure(others, closure.start.tolist())
            if near is not None and agrees(others, near):
                seen = _seen(replace(others, variant=replace(bare, frame=variant.frame)), near)
                if faults := [*seen.of_hinges()]:
                    break
    else:
        return
    raise InputError(faults)


def bent_by_start(equations: VelocityEquations, closure: Closure) -> set[int]:
    """Return which held quantities have to be zero: with the value of the start, a link or the frame changes its shape."""
    if not equations.variant.links or len(closure.names) > len(closure.free) or not _faults(equations, closure):
        return set()
    sums = [one.target == "start" and bool(one.written) for one in equations.positions]

    def bends(kept: int | None) -> bool:
        near = closure.at_zero([held and place != kept for place, held in enumerate(sums)])
        start = closed_start(near)[1]
        return start is None or bool(_faults(equations, replace(near, start=start, asked={})))

    return set() if bends(None) else {place for place, held in enumerate(sums) if held and bends(place)}


def _may_move(point: str, variant: Variant) -> bool:
    """Return whether a point depends on more than data, or is defined by a group."""
    places = dict(variant.points)
    return point not in places or not {*reached([point], places)} <= {point, *places, *variant.values, "pi"}


def hinges_with_two_names(equations: VelocityEquations, closure: Closure) -> tuple[tuple[str, str], ...]:
    """Return pairs of points of two links that coincide throughout: a joint that is not counted, because they share no name."""
    seen = _seen(equations, closure)
    near = _of_two_links(equations.variant, seen.tracks)
    return tuple(pair for pair in near if np.max(seen.apart(*pair)) <= OPEN * closure.scale and seen.keeps(*pair))


def may_be_hinges(equations: VelocityEquations, start: Sequence[float]) -> tuple[tuple[str, str], ...]:
    """Return pairs of points of two links that lie in one place, or almost, at the start (m,)."""
    vectors, near = equations.symbols.vectors, OPEN * largest_length(equations.variant)
    found = compile_values(equations, [part for vector in vectors.values() for part in vector])[0](0.0, *start)
    places = {name: complex(found[2 * place], found[2 * place + 1]) for place, name in enumerate(vectors)}
    return tuple(pair for pair in _of_two_links(equations.variant, places) if abs(places[pair[0]] - places[pair[1]]) <= near)


def _of_two_links(variant: Variant, points: Iterable[str]) -> list[tuple[str, str]]:
    """Return the pairs of points of links that no link has both of."""
    links = [{*link.held} for link in variant.links]
    pairs = [pair for pair in combinations(points, 2) if all(any(name in of for of in links) for name in pair)]
    return [pair for pair in pairs if not any({*pair} <= of for of in links)]


def _faults(equations: VelocityEquations, closure: Closure) -> list[Fault]:
    seen = _seen(equations, closure)
    return [*seen.of_links(), *seen.of_wheels(), *seen.of_hinges(), *seen.of_rails(), *seen.of_circles()]


def _seen(equations: VelocityEquations, closure: Closure) -> _Seen:
    variant, vectors = equations.variant, equations.symbols.vectors
    times, positions = closure.configurations
    found = compile_values(equations, [part for vector in vectors.values() for part in vector])[1](times, *positions.T)
    parts = np.array([np.broadcast_to(np.asarray(part, dtype=float), times.shape) for part in found])
    tracks = {name: parts[2 * place] + 1j * parts[2 * place + 1] for place, name in enumerate(vectors)}
    growing = [positions[:, place] for place, one in enumerate(variant.coordinates) if one.unit == "m"]
    free = closure.loose if variant.frame.rails or len(closure.names) < len(closure.free) else frozenset()
    loose = frozenset(name for name in tracks if free and free & reached([name], dict(variant.points)))
    return _Seen(variant, times, tracks, growing, closure.scale, loose)


@frozen
class _Seen:
    """Positions of the points of a variant at some `times` (c,).

    `tracks` holds x + iy (c,) of each point, `growing` the values (c,) of each coordinate that is a length; `scale` is the
    largest length (m), `loose` the points that nothing determines.
    """

    variant: Variant
    times: Array
    tracks: dict[str, Track]
    growing: list[Array]
    scale: float
    loose: frozenset[str]

    def of_links(self) -> Iterator[Fault]:
        """Yield a fault for each link that has two points of varying distance or that leaves the bar it slides on."""
        bars = {link.name: link.points for link in self.variant.links}
        for link in self.variant.links:
            points = [*link.points, *([link.wheel] if link.wheel else [])]
            # Where a loop has no position equation, its written equations close it, and the positions here know nothing of it.
            pairs = [pair for pair in combinations(points, 2) if not (self.keeps(*pair) or self.loose.intersection(pair))]
            pairs = [pair for pair in pairs if not (self._grows(*pair) and self._straight(points, *pair))]
            if pairs:
                widest = max(pairs, key=lambda pair: np.ptp(self.apart(*pair)))
                yield self._fault(("links", link.name), self._not_rigid(link, *widest))
                continue
            along = [pair for pair in combinations(bars.get(link.slides or "", ()), 2) if not self.loose.intersection(pair)]
            offs = [[self._off(point, *pair) for pair in along if point not in self.loose] for point in points]
            lost = next((place for place, off in enumerate(offs) if off and not any(map(self._keeps, off))), None)
            if lost is not None:
                known = {"link": link.name, "point": points[lost], "bar": link.slides, **self._between(offs[lost][0])}
                yield self._fault(("links", link.name), say("fault.V315", **known))

    def of_wheels(self) -> Iterator[Fault]:
        """Yield a fault for each wheel whose contact lies in its centre at some time."""
        for link in self.variant.links:
            if link.wheel and link.contact and self.apart(link.wheel, link.contact).min() <= _TOLERANCE * self.scale:
                yield self._fault(("links", link.name), say("fault.V325", link=link.name, centre=link.wheel, at=link.contact))

    def of_hinges(self) -> Iterator[Fault]:
        """Yield a fault for each hinge of the frame that moves."""
        for place, name in enumerate(self.variant.frame.hinges):
            away = np.abs(self.tracks[name] - self.tracks[name][0])
            if not self._keeps(away) and name not in self.loose:
                known = {"point": name, "away": float(np.max(away)), "time": float(self.times[int(np.argmax(away))])}
                yield self._fault(("frame", "hinges", place), say("fault.V319", **known))

    def of_rails(self) -> Iterator[Fault]:
        """Yield a fault for each rail not along the path of its point, or not touched sideways by its wheel."""
        wheels = {link.contact: link for link in self.variant.links if link.wheel}
        for place, (through, angle) in enumerate(self.variant.frame.rails):
            if through.op != "name" or through.name in self.loose:
                continue
            track, along = self.tracks[through.name], np.exp(1j * evaluate(angle, self.variant.values))
            way = track - track[0]
            farthest = way[int(np.argmax(np.abs(way)))]
            if self._leaves(way, along):
                is_curved = self._leaves(way, farthest / abs(farthest))
                yield self._fault(("frame", "rails", place), off_rail(through.name, along, farthest, is_curved))
            elif wheel := wheels.get(through.name):
                yield from self._touched(wheel, np.full_like(track, 1j * along))

    def of_circles(self) -> Iterator[Fault]:
        """Yield a fault for the circle nearest to each wheel that touches neither a circle nor a rail nor another link."""
        links, frame = self.variant.links, self.variant.frame
        others = {through.name for through, _ in frame.rails if through.op == "name"}
        contacts = [link.contact for link in links if link.contact]
        others |= {name for link in links for name in link.points} | {name for name in contacts if contacts.count(name) > 1}
        circles = [
            (place, centre.name, evaluate(size, self.variant.values))
            for place, (centre, size) in enumerate(frame.circles)
            if centre.op == "name"
        ]
        for wheel in (link for link in links if circles and link.wheel and link.contact and link.contact not in others):
            contact = wheel.contact or ""
            away = [float(self.apart(contact, name)[0]) for _, name, _ in circles]
            near = min(range(len(circles)), key=lambda at: abs(away[at] - circles[at][2]))
            place, centre, radius = circles[near]
            if abs(away[near] - radius) > _TOLERANCE * self.scale:
                known = {"centre": centre, "radius": radius, "contact": contact, "away": away[near]}
                yield self._fault(("frame", "circles", place), say("fault.V317", **known))
            else:
                yield from self._touched(wheel, self.tracks[contact] - self.tracks[centre])

    def _touched(self, wheel: Link, across: Track) -> Iterator[Fault]:
        """Yield a fault if a wheel's radius to the contact does not lie along `across` (c,), the normal of what it touches."""
        contact, centre = wheel.contact or "", wheel.wheel or ""
        arm = self.tracks[contact] - self.tracks[centre]
        if self._leaves(arm, across / np.abs(across)):
            yield self._fault(("links", wheel.name), say("fault.V318", link=wheel.name, centre=centre, contact=contact))

    def _not_rigid(self, link: Link, one: str, other: str) -> Sentence:
        """Return that two points of a link change their distance, and which points each of them keeps its distance to."""
        near = {point: tuple(name for name in self.tracks if name != point and self.keeps(point, name)) for point in (one, other)}
        kept = [say("fault.V314.keeps", point=point, others=others) for point, others in near.items() if others]
        known = {"link": link.name, "one": one, "other": other, **self._between(self.apart(one, other))}
        return say("fault.V314.kept", **known, kept=joined(kept)) if kept else say("fault.V314.alone", **known)

    def _between(self, sizes: Array) -> dict[str, float]:
        """Return the first of some lengths (c,), the one that differs from it most, and the time of that one; round-off is 0."""
        sizes = np.where(np.abs(sizes) > _ROUND_OFF * self.scale, sizes, 0.0)
        place = int(np.argmax(np.abs(sizes - sizes[0])))
        side = -1.0 if sizes[place] < 0 else 1.0  # of the bar: a distance is told
        return {"first": side * float(sizes[0]) + 0.0, "last": side * float(sizes[place]), "time": float(self.times[place])}

    def apart(self, one: str, other: str) -> Array:
        """Return the distance between two points (c,)."""
        return np.abs(self.tracks[one] - self.tracks[other])

    def keeps(self, one: str, other: str) -> bool:
        """Return whether two points keep their distance."""
        return self._keeps(self.apart(one, other))

    def _off(self, point: str, one: str, other: str) -> Array:
        """Return the signed distance (c,) of a point from the line through two others; nan where these coincide."""
        bar = self.tracks[other] - self.tracks[one]
        with np.errstate(invalid="ignore"):
            return np.asarray(((self.tracks[point] - self.tracks[one]) * bar.conj()).imag / np.abs(bar))

    def _keeps(self, sizes: Array) -> bool:
        return bool(np.ptp(sizes) <= _TOLERANCE * self.scale)

    def _leaves(self, way: Track, along: Track | complex) -> bool:
        """Return whether a path (c,) leaves the line in the direction of the unit vectors `along`."""
        beside = np.max(np.abs((way * np.conj(along)).imag), initial=0.0)
        return bool(beside > _TOLERANCE * np.max(np.abs(way), initial=0.0) + _ROUND_OFF * self.scale)

    def _straight(self, points: Sequence[str], one: str, other: str) -> bool:
        """Return whether all points of a link stay as far from the line through two of them: an arm grows only lengthwise."""
        offs = [self._off(point, one, other) for point in points if point not in (one, other)]
        return all(self._keeps(off[np.isfinite(off)]) for off in offs)

    def _grows(self, one: str, other: str) -> bool:
        """Return whether two points are the ends of a growing arm: one vector in [points], or as long as a coordinate."""
        apart = self.apart(one, other)
        least = _TOLERANCE * np.ptp(apart) + _ROUND_OFF * self.scale
        if any(np.ptp(apart + sign * length) <= least for length in self.growing for sign in (-1, 1)):
            return True
        placed, pairs = dict(self.variant.points), ((one, other), (other, one))
        return any(is_arm(placed[end], base, placed[base]) for end, base in pairs if {end, base} <= {*placed})

    def _fault(self, path: Sequence[str | int], told: Sentence) -> Fault:
        return Fault(told, self.variant.file, self.variant.nearest_line(*path))
