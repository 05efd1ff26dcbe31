"""Velocities without a coordinate, as the geometry gives them: unknowns bound in [unknowns], and rates of links.

Enters: a `Mechanism` and its symbols.  Leaves: for each such velocity a `Bound`, linear in the unknown velocities.
Used by `equations.py`.  They check the written equations, and replace them if none is written.

The position of a point B gives its velocity V_B; relative to link 3 it is V_B - (V_K + w3 x KB), with K a point of that link.
The points give the rate of a link with two points: w AB^2 = AB x (V_B - V_A).  The contact of a rolling wheel moves like the
body it touches, and a sleeve turns with its bar.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from coursework.equations.algebra.expression import MINUS, ONE, ZERO, Expression
from coursework.equations.algebra.functions import cosine, sine
from coursework.equations.reduction.symbolic import TIME, Symbols, Vector, placed, symbol
from coursework.mechanism.joints import chain_of_groups, link_names, rack_of
from coursework.mechanism.mechanism import Mechanism
from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula, named
from coursework.variant.record.variant import Binding, Link, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import say


@frozen
class Speed:
    """A velocity in the form `sum coefficients[u] u + rest`, where u are the unknown velocities."""

    coefficients: Mapping[str, Expression]
    rest: Expression

    def plus(self, other: Speed, factor: Expression = ONE) -> Speed:
        """Return self + factor * other."""
        total = dict(self.coefficients)
        for name, slope in other.coefficients.items():
            total[name] = total.get(name, ZERO) + factor * slope
        return Speed({name: slope for name, slope in total.items() if slope is not ZERO}, self.rest + factor * other.rest)


STILL = Speed({}, ZERO)


@frozen
class Bound:
    """The equation `is_zero` = 0 for the velocity `name`; `link` is the link whose rate it is, "" for a line of [unknowns]."""

    name: str
    is_zero: Speed
    link: str = ""


@frozen
class Turn:
    """A `link` turns at `found` according to its points or contact, and at `named` (its `rate`) according to the file.

    Both must agree if the points belong to one body, that is, if `grows`, proportional to the growth of their distance, is zero.
    """

    link: str
    rate: str
    found: Speed
    named: Speed
    grows: Speed


@frozen
class _Body:
    """A link that a binding names: its rate, one of its own points, and its entry in [links] if it has one."""

    rate: str | None
    point: Formula | None
    link: Link | None = None


class Geometry:
    """Velocities of the points and links of one mechanism."""

    def __init__(self, mechanism: Mechanism, symbols: Symbols) -> None:
        self.variant: Variant = mechanism.variant
        self._symbols = symbols
        self._bodies = _bodies(mechanism)

    def bound(self) -> tuple[Bound, ...]:
        """Return the equations of the bound [unknowns].  Raises `InputError` for a link whose rate cannot be found."""
        found = []
        for binding in self.variant.bindings:
            with placed(self.variant, f"unknowns.{binding.name}", self._line(binding)):
                found.append(Bound(binding.name, self._speed(binding).plus(_of(binding.name), MINUS)))
        return tuple(found)

    def rates_of_links(self, known: set[str]) -> tuple[Bound, ...]:
        """Return the sought rates of links that are not among the `known` velocities but follow from points.

        A rate has a further equation for each further contact: a planet touches the sun and the ring.
        """
        found: dict[str, Bound] = {}
        links = [(name, body.link, body.rate) for name, body in self._bodies.items() if body.link is not None]
        sought = [(name, link, rate) for name, link, rate in links if rate in self.variant.sought and rate not in known]
        touched: set[str | None] = set()
        for name, link, rate in sought:
            if rate not in found and (speed := self._from_points(link, _of(rate))) is not None:
                found[rate] = Bound(rate, speed, name)
                touched.add(link.contact)
        for name, link, rate in sought:
            if link.contact and link.contact not in touched and (speed := self._from_points(link, _of(rate))) is not None:
                found[f"{rate} {link.contact}"] = Bound(f"{rate} {link.contact}", speed, name)
                touched.add(link.contact)
        return tuple(found.values())

    def _line(self, binding: Binding) -> int:
        return self.variant.nearest_line("unknowns", binding.name)

    def _speed(self, binding: Binding) -> Speed:
        """Return the velocity that a binding refers to."""
        if binding.link:
            rate = self._rate(binding.link, binding)
            return rate.plus(self._rate(binding.relative, binding), MINUS) if binding.relative else rate
        assert binding.along is not None
        angle = self._symbols.scalar(binding.along)
        point = self._symbols.vectors[binding.point]
        moved = self._moved(point)
        if binding.relative:
            moved = _minus(moved, self._material(binding.relative, point, binding))
        return STILL.plus(moved[0], cosine(angle)).plus(moved[1], sine(angle))

    def _moved(self, point: Vector) -> tuple[Speed, Speed]:
        """Return the velocity of a point, from its position."""
        x, y = (rate_of(part, self.variant, self._symbols) for part in point)
        return x, y

    def _material(self, link: str, at: Vector, binding: Binding) -> tuple[Speed, Speed]:
        """Return the velocity of the point of a link that is at the position `at`."""
        body = self._body(link, binding)
        if body.point is None:
            raise self._nothing(link, binding)
        own = self._symbols.vector(body.point)
        return _turned(self._moved(own), self._rate(link, binding), (at[0] - own[0], at[1] - own[1]))

    def _rate(self, link: str, binding: Binding) -> Speed:
        body = self._body(link, binding)
        if body.rate is not None and body.rate != binding.name:
            return speed_of(body.rate, self.variant.sought)
        # For a link without its own rate r: r AB^2 = ..., solved for r, which occurs nowhere else.
        found = self._from_points(body.link, _of(_HELD)) if body.link is not None else None
        if found is None:
            raise self._nothing(link, binding)
        return _solved(found)

    def turns(self) -> tuple[Turn, ...]:
        """Return how fast links turn according to points, contact or bar, unless this is obviously their rate."""
        links = [(name, body.link) for name, body in self._bodies.items() if body.link is not None and body.link.rate]
        rates = [link.rate for _, link in links]
        own = {coordinate.rate: symbol(coordinate.name) for coordinate in self.variant.coordinates}
        found = []
        for name, link in links:
            rate = link.rate or ""
            if rate in own:
                if not link.wheel and not link.slides and self._plainly_turned(link, own[rate]):
                    continue
            elif not link.points and rates.count(rate) == 1:
                continue  # a wheel alone: its rate follows only from its rolling
            named = speed_of(rate, self.variant.sought)
            found += [Turn(name, rate, _solved(zero), named, grows) for zero, grows in self._told(link, _of(_HELD))]
        return tuple(found)

    def _plainly_turned(self, link: Link, angle: Expression) -> bool:
        """Return whether the angle of a link turns each of its arms, and no other coordinate moves one."""
        others = [TIME, *(symbol(coordinate.name) for coordinate in self.variant.coordinates)]
        for point in link.points[1:]:
            x, y = (b - a for a, b in zip(*(self._symbols.vectors[name] for name in (link.points[0], point)), strict=True))
            for name in others:
                turned = (-y, x) if name == angle else (ZERO, ZERO)
                if (self._symbols.partial(x, name), self._symbols.partial(y, name)) != turned:
                    return False
        return True

    def _from_points(self, link: Link, rate: Speed) -> Speed | None:
        """Return an expression that is zero for the `rate` of a link, None if its points do not determine it."""
        return next((zero for zero, _ in self._told(link, rate)), None)

    def _told(self, link: Link, rate: Speed) -> Iterator[tuple[Speed, Speed]]:
        """Yield expressions that are zero for the `rate` of a link, each with one that is zero if the arm used does not grow."""
        vectors = self._symbols.vectors
        if link.wheel and link.contact:
            touched = self._touched(link, vectors[link.contact])
            centre = vectors[link.wheel]
            arm = vectors[link.contact][0] - centre[0], vectors[link.contact][1] - centre[1]
            if touched is not None and arm != (ZERO, ZERO):
                slip = _minus(_turned(self._moved(centre), rate, arm), touched)
                yield STILL.plus(slip[0], -arm[1]).plus(slip[1], arm[0]), STILL
        points = [*link.points, *([link.wheel] if link.wheel else [])]
        for other in points[1:]:
            arm = vectors[other][0] - vectors[points[0]][0], vectors[other][1] - vectors[points[0]][1]
            if arm != (ZERO, ZERO):
                gap = _minus(self._moved(vectors[other]), self._moved(vectors[points[0]]))
                zero = STILL.plus(gap[1], arm[0]).plus(gap[0], -arm[1]).plus(rate, -(arm[0] ** 2 + arm[1] ** 2))
                yield zero, STILL.plus(gap[0], arm[0]).plus(gap[1], arm[1])
        bar = self._bodies.get(link.slides or "")
        if bar is not None and bar.rate is not None:
            along = speed_of(bar.rate, self.variant.sought)
            if along != rate:
                yield rate.plus(along, MINUS), STILL

    def _touched(self, wheel: Link, contact: Vector) -> tuple[Speed, Speed] | None:
        """Return the velocity, at the contact, of the body that a wheel touches; None if the file does not say which body."""
        for body in self._bodies.values():
            other = body.link
            if other is None or other == wheel or wheel.contact not in {*other.points, other.contact}:
                continue
            if (
                body.rate is None
                or (own := next((p for p in (other.wheel, *other.points) if p and p != wheel.contact), None)) is None
            ):
                return None
            at = self._symbols.vectors[own]
            rate = speed_of(body.rate, self.variant.sought)
            return _turned(self._moved(at), rate, (contact[0] - at[0], contact[1] - at[1]))
        if (rack := rack_of(wheel, self.variant)) is not None:
            return self._moved(self._symbols.vectors[rack])
        frame, rails = self.variant.frame, {through.name for through, _ in self.variant.frame.rails}
        others = [link for link in self.variant.links if link.contact and link.contact not in rails]
        # A contact on no rail is on a circle of the frame, if there is a circle for each such wheel.
        return (STILL, STILL) if wheel.contact in rails or 0 < len(others) <= len(frame.circles) else None

    def _body(self, name: str, binding: Binding) -> _Body:
        if name not in self._bodies:
            raise self._nothing(name, binding)
        return self._bodies[name]

    def _nothing(self, link: str, binding: Binding) -> InputError:
        told = say("fault.V155", link=link, known=tuple(self._bodies))
        return InputError([Fault(told, self.variant.file, self._line(binding), 0, f"unknowns.{binding.name}")])


_HELD = "_rate"  # stands for a rate without a name in the file


def _bodies(mechanism: Mechanism) -> dict[str, _Body]:
    """Return the links by name: those of [links], or else those of the chain of groups, numbered by their rates."""
    variant = mechanism.variant
    if variant.links:
        own = {link.name: next(iter(link.held), None) for link in variant.links}
        return {link.name: _Body(link.rate, named(point) if (point := own[link.name]) else None, link) for link in variant.links}
    if not variant.groups:
        return {}
    chain = chain_of_groups(variant, dict(mechanism.points))
    coordinates = {c.name: c for c in variant.coordinates}
    found = {}
    for body, name in link_names(chain, variant).items():
        moves = coordinates[chain.coordinates[body]]
        pins = (joint.where for joint in chain.joints if joint.pins and body in joint.bodies)
        if moves.unit == "rad":  # a block turns with its guide, which is a separate link
            found[name] = _Body(moves.rate, next((pin for pin in pins if pin is not None), None))
    return found


def _of(name: str) -> Speed:
    return Speed({name: ONE}, ZERO)


def _solved(zero: Speed) -> Speed:
    """Return the rate that `_HELD` stands for, from an expression linear in it that is zero."""
    others = Speed({name: part for name, part in zero.coefficients.items() if name != _HELD}, zero.rest)
    return STILL.plus(others, -1 / zero.coefficients[_HELD])


def speed_of(name: str, sought: Collection[str]) -> Speed:
    """Return the velocity `name`: an unknown one if it is `sought`, else a known one."""
    return _of(name) if name in sought else Speed({}, symbol(name))


def rate_of(expression: Expression, variant: Variant, symbols: Symbols) -> Speed:
    """Return the time derivative of an expression of the positions."""
    speed = Speed({}, symbols.partial(expression, TIME))
    for coordinate in variant.coordinates:
        slope = symbols.partial(expression, symbol(coordinate.name))
        if slope is not ZERO:
            speed = speed.plus(speed_of(coordinate.rate, variant.sought), slope)
    return speed


def _minus(one: tuple[Speed, Speed], other: tuple[Speed, Speed]) -> tuple[Speed, Speed]:
    return one[0].plus(other[0], MINUS), one[1].plus(other[1], MINUS)


def _turned(start: tuple[Speed, Speed], rate: Speed, arm: Vector) -> tuple[Speed, Speed]:
    """Return the velocity of the end of a turning `arm`, from the velocity of its start."""
    return start[0].plus(rate, -arm[1]), start[1].plus(rate, arm[0])
