"""Bounds of a law of t on whole stretches of time: of its real values, and of its values on a disc in the complex plane.

Enters: the laws of a variant, stretches of time.  Leaves: `Enclosure`; an unknown bound is infinite.
Used by `quadrature.py`.  Sample points can miss a pulse of a microsecond between them; enclosures of adjoining stretches
cannot.  Source: R. E. Moore, Interval Analysis (1966); discs: I. Gargantini, P. Henrici, Numer. Math. 18 (1971) 305.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from coursework.equations.codegen.tabulated import TableLaw
from coursework.system.arrays import Array, Flags
from coursework.system.frozen import caching, single
from coursework.variant.formula.made import product_of
from coursework.variant.formula.tree import Formula, factors
from coursework.variant.record.variant import Law

# Radius of the disc about a stretch, in half lengths of the stretch.
REACH = 3.0
# Error of the twelve-point Gauss rule as a share of a disc's radius: where it exceeds the range of values, the values say more.
_TOLD = 1e-18
_LEAST = float(np.finfo(float).tiny)  # smallest `rest` of a law bounded by its values alone, so that it is not taken for 0


@single
class Enclosure:
    """Bounds of a law on n stretches of time, each an array (n,).

    The real values lie between `low` and `high`.  The law is the sum of an analytic part, whose values on the complex disc lie
    within `radius` of `middle`, and of a real part of size at most `rest`.  If the data are columns (sets, 1), all arrays are
    (sets, n).
    """

    low: Array
    high: Array
    middle: Array
    radius: Array
    rest: Array | float = 0.0

    @property
    def size(self) -> Array:
        """Return the largest possible |value| (n,)."""
        return np.maximum(np.abs(self.low), np.abs(self.high))

    @property
    def disc(self) -> Array:
        """Return the radius of the values of the whole law on the disc; infinite where there is a `rest`."""
        return np.where(np.asarray(self.rest) > 0, np.inf, self.radius)

    @property
    def parted(self) -> Enclosure:
        """Return the enclosure with the whole law moved into `rest` where the disc bounds it less tightly than the values do."""
        is_value = (self.low <= self.middle) & (self.middle <= self.high)
        middle = np.where(is_value, self.middle, (self.low + self.high) / 2)
        around = np.maximum(np.maximum(self.high - middle, middle - self.low), _LEAST)
        by_disc = _TOLD * self.radius <= around
        return Enclosure(
            self.low, self.high, np.where(by_disc, self.middle, middle), np.where(by_disc, self.radius, 0.0),
            np.where(by_disc, self.rest, around),
        )  # fmt: skip


def _checked(low: Array, high: Array, middle: Array, radius: Array, rest: Array | float = 0.0) -> Enclosure:
    """Return an enclosure in which nan (from 0·∞ or overflow) is replaced by the widest bounds."""
    lost = np.isnan(low) | np.isnan(high)
    apart = ~np.isfinite(middle) | np.isnan(radius)
    return Enclosure(
        np.where(lost, -np.inf, low), np.where(lost, np.inf, high), np.where(apart, 0.0, middle), np.where(apart, np.inf, radius),
        np.where(np.isnan(rest), np.inf, rest),
    )  # fmt: skip


def _constant(value: float | Array, count: int) -> Enclosure:
    values = np.asarray(value) if np.ndim(value) else np.full(count, value)
    return Enclosure(values, values, values, np.zeros_like(values))


def _plus(a: Enclosure, b: Enclosure) -> Enclosure:
    a, b = a.parted, b.parted
    return _checked(a.low + b.low, a.high + b.high, a.middle + b.middle, a.radius + b.radius, a.rest + b.rest)


def _minus(a: Enclosure) -> Enclosure:
    return Enclosure(-a.high, -a.low, -a.middle, a.radius, a.rest)


def _times(a: Enclosure, b: Enclosure) -> Enclosure:
    a, b = a.parted, b.parted
    ends = np.stack([a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high])
    ends[np.isnan(ends)] = 0.0  # 0·∞ is a bound, not a value
    radius = np.abs(a.middle) * b.radius + np.abs(b.middle) * a.radius + a.radius * b.radius
    rest = np.where(a.rest > 0, a.rest * b.size, 0.0) + np.where(b.rest > 0, (a.size + a.rest) * b.rest, 0.0)
    return _checked(ends.min(axis=0), ends.max(axis=0), a.middle * b.middle, radius, rest)


def _inverse(a: Enclosure) -> Enclosure:
    crosses = (a.low < 0) & (a.high > 0)
    size = np.abs(a.middle)
    radius = np.where(size > a.disc, a.disc / (size * (size - a.disc)), np.inf)
    low, high = np.where(crosses | (a.high == 0), -np.inf, 1 / a.high), np.where(crosses | (a.low == 0), np.inf, 1 / a.low)
    return _checked(low, high, 1 / a.middle, radius)


def _monotone(
    a: Enclosure, function: Callable[[Array], Array], slope: Callable[[Enclosure], Array], domain: tuple[float, float]
) -> Enclosure:
    """Return the enclosure of an increasing `function` of `a`, whose argument is clipped to `domain`.

    `slope` bounds its derivative on the disc; it is infinite where the function is not analytic.
    """
    low, high = function(np.clip(a.low, *domain)), function(np.clip(a.high, *domain))
    return _checked(low, high, function(np.clip(a.middle, *domain)), a.disc * slope(a))


def _exponential(a: Enclosure) -> Enclosure:
    middle = np.exp(a.middle)
    # Far from a pulse both factors over- or underflow, though their product is nearly zero.
    radius = np.where(a.disc < 1, middle * np.expm1(a.disc), np.exp(a.middle + a.disc) - middle)
    return _checked(np.exp(a.low), np.exp(a.high), middle, radius)


def _logarithm(a: Enclosure) -> Enclosure:
    room = a.middle - a.disc
    return _monotone(a, np.log, lambda a: np.where(room > 0, 1 / room, np.inf), (0.0, np.inf))


def _sine(a: Enclosure, phase: float = 0.0) -> Enclosure:
    low, high, middle = a.low + phase, a.high + phase, a.middle + phase
    ends = np.sin(low), np.sin(high)
    unknown = ~np.isfinite(low) | ~np.isfinite(high)

    def holds(place: float) -> Flags:
        turns = 2 * np.pi
        return np.asarray(unknown | (np.floor((high - place) / turns) >= np.ceil((low - place) / turns)))

    radius = np.abs(np.sin(middle)) * (np.cosh(a.disc) - 1) + np.abs(np.cos(middle)) * np.sinh(a.disc)
    return _checked(
        np.where(holds(-np.pi / 2), -1.0, np.minimum(*ends)), np.where(holds(np.pi / 2), 1.0, np.maximum(*ends)),
        np.sin(middle), radius,
    )  # fmt: skip


def _power(a: Enclosure, exponent: float) -> Enclosure:
    if exponent < 0:
        return _inverse(_power(a, -exponent))
    if exponent != int(exponent):
        room = a.middle - a.disc
        size = np.where(exponent < 1, room, a.middle + a.disc)
        return _monotone(
            a, lambda x: x**exponent, lambda a: np.where(room > 0, exponent * size ** (exponent - 1), np.inf), (0.0, np.inf)
        )
    ends = np.stack([a.low**exponent, a.high**exponent])
    low = np.where((a.low < 0) & (a.high > 0) & (exponent % 2 == 0), 0.0, ends.min(axis=0))
    radius = (np.abs(a.middle) + a.disc) ** exponent - np.abs(a.middle) ** exponent
    return _checked(low, ends.max(axis=0), a.middle**exponent, radius)


def _absolute(a: Enclosure) -> Enclosure:
    crosses = (a.low < 0) & (a.high > 0)
    low = np.where(crosses, 0.0, np.minimum(np.abs(a.low), np.abs(a.high)))
    return _checked(low, a.size, np.abs(a.middle), np.where(np.abs(a.middle) > a.disc, a.disc, np.inf))


def _sign(a: Enclosure) -> Enclosure:
    low, high = np.where(a.low < 0, -1.0, 1.0), np.where(a.high > 0, 1.0, -1.0)
    return Enclosure(low, high, np.sign(a.middle), np.where(np.abs(a.middle) > a.disc, 0.0, np.inf))


def _arcsine(a: Enclosure) -> Enclosure:
    room = (1 - a.middle - a.disc) * (1 + a.middle - a.disc)
    inside = np.abs(a.middle) + a.disc < 1
    return _monotone(a, np.arcsin, lambda a: np.where(inside, 1 / np.sqrt(np.where(inside, room, 1.0)), np.inf), (-1.0, 1.0))


def _arctangent(a: Enclosure) -> Enclosure:
    room = np.hypot(1.0, a.middle) - a.disc
    return _monotone(a, np.arctan, lambda a: np.where(room > 0, 1 / room**2, np.inf), (-np.inf, np.inf))


def _angle(y: Enclosure, x: Enclosure) -> Enclosure:
    """Return the enclosure of atan2(y, x), which jumps where y is zero and x negative."""
    corners = np.stack([np.arctan2(v, u) for v in (y.low, y.high) for u in (x.low, x.high)])
    jumps = (x.low <= 0) & (y.low <= 0) & (y.high >= 0)
    right, aside = x.middle > x.disc, np.abs(y.middle) > y.disc
    radius = np.where(right, _arctangent(_times(y, _inverse(x))).radius, _arctangent(_times(x, _inverse(y))).radius)
    return _checked(
        np.where(jumps, -np.pi, corners.min(axis=0)), np.where(jumps, np.pi, corners.max(axis=0)),
        np.arctan2(y.middle, x.middle), np.where(right | aside, radius, np.inf),
    )  # fmt: skip


_CALLS: Mapping[str, Callable[[Enclosure], Enclosure]] = {
    "sin": _sine, "cos": lambda a: _sine(a, np.pi / 2), "exp": _exponential, "log": _logarithm,
    "tan": lambda a: _times(_sine(a), _inverse(_sine(a, np.pi / 2))), "sqrt": lambda a: _power(a, 0.5),
    "abs": _absolute, "asin": _arcsine, "atan": _arctangent,
    "acos": lambda a: _plus(_constant(np.pi / 2, len(a.low)), _minus(_arcsine(a))),
}  # fmt: skip


@caching
class Laws:
    """The drives and functions of one variant, on stretches of time without a break or a table node inside.

    `values` are the data: numbers, or columns (sets, 1) of them.
    """

    values: Mapping[str, float | Array]
    laws: Mapping[str, Law]
    tables: Mapping[str, TableLaw]

    def over(self, name: str, begin: Array, end: Array) -> Enclosure:
        """Return the enclosure of the named law on n stretches from `begin` to `end` (n,), in s."""
        with np.errstate(all="ignore"):
            return self._law(self.laws[name], begin, end)

    def _law(self, law: Law, begin: Array, end: Array) -> Enclosure:
        if law.table:
            return self._table(self.tables[law.name], begin, end)
        if not law.pieces:
            assert law.formula is not None
            return self._formula(law.formula, begin, end)
        chosen = np.searchsorted([later for later, _ in law.pieces[1:]], (begin + end) / 2, side="right")
        sets = max((np.size(value) for value in self.values.values() if np.ndim(value)), default=0)
        columns = np.empty((5, *([sets] if sets else []), len(begin)))
        for place in np.unique(chosen).tolist():
            at = chosen == place
            found = self._formula(law.pieces[place][1], begin[at], end[at])
            for column, one in zip(columns, (found.low, found.high, found.middle, found.radius, found.rest), strict=True):
                column[..., at] = one
        return Enclosure(*columns)

    def _table(self, table: TableLaw, begin: Array, end: Array) -> Enclosure:
        first, last = (begin - table.first) / table.step, (end - table.first) / table.step
        interval = np.clip(np.floor((first + last) / 2).astype(int), 0, table.intervals - 1)
        u, total = _time(first - interval, last - interval), _constant(0.0, len(begin))
        for column in table.pieces[0][interval].T[::-1]:
            total = _plus(_times(total, u), _constant(column, len(begin)))
        return total

    def _formula(self, tree: Formula, begin: Array, end: Array) -> Enclosure:
        if tree.op == "number":
            return _constant(float(tree.value), len(begin))
        if tree.op == "name":
            return self._name(tree.name, begin, end)
        args = [self._formula(arg, begin, end) for arg in tree.args]
        match tree.op:
            case "neg":
                return _minus(args[0])
            case "+":
                return _plus(*args)
            case "-":
                return _plus(args[0], _minus(args[1]))
            case "*":
                return _power(args[0], 2.0) if tree.args[0] == tree.args[1] else _times(*args)
            case "/":
                return self._quotient(tree, args, begin, end)
            case "^":
                return _power(args[0], float(args[1].middle.flat[0]))  # a constant, which the reader asks for
        return _angle(*args) if tree.name == "atan2" else _CALLS[tree.name](args[0])

    def _quotient(self, tree: Formula, args: list[Enclosure], begin: Array, end: Array) -> Enclosure:
        """Return the enclosure of a quotient; u/abs(u), which writes a sign, lies between -1 and 1 even where u is zero."""
        above, below = list(factors(tree.args[0])), tree.args[1]
        if below.op == "call" and below.name == "abs" and (below.args[0], 1) in above:
            above.remove((below.args[0], 1))
            rest = self._formula(product_of([factor for factor, _ in above]), begin, end)
            return _times(rest, _sign(self._formula(below.args[0], begin, end)))
        return _times(args[0], _inverse(args[1]))

    def _name(self, name: str, begin: Array, end: Array) -> Enclosure:
        if name == "t":
            return _time(begin, end)
        if name in self.laws:
            return self._law(self.laws[name], begin, end)
        return _constant(float(np.pi) if name == "pi" else self.values[name], len(begin))


def _time(begin: Array, end: Array) -> Enclosure:
    return Enclosure(begin, end, (begin + end) / 2, REACH * (end - begin) / 2)
