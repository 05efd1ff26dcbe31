"""What a wrong table may have been made with: a rule for the step, a rule for the velocities, or another table altogether.

Enters: a `Key`, the student's table, the rubric's confusions, tables of other variants.  Leaves: `Claim`s, one a hypothesis:
what it says about each cell, and how exactly the printed digits let it speak.  Used by `misconceptions.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from coursework.grading.marking.cells import HALF, LEAST, SLACK, Student, velocity_tolerance
from coursework.grading.marking.key import Key, sensitivity

Array = NDArray[np.float64]
FACTORS = (10.0, 0.1, 2.0, 0.5, -1.0)
STEPS = (0.1, 0.5, 2.0, 10.0)
ROUNDED_TO = (1, 2, 3)
# A hypothesis is worth a closer look where this part of the velocities lies within this many of Euler's tolerances.
_NEARLY, _NEAR = 0.85, 60.0


@dataclass(frozen=True)
class Claim:
    """What a hypothesis says: `expected` (n, m + r), NaN where it is silent; `tolerance` alike.

    `euler` names what it leaves to Euler's rules: "steps", "velocities", "all" or nothing.  `student` is the table it speaks
    about where it is not the one handed in (columns put back, origins taken off).
    """

    code: str
    expected: Array
    tolerance: Array
    euler: str = ""
    student: Student | None = None


@dataclass(frozen=True)
class Printed:
    """A student's table seen by hypotheses: angles, velocities and their digits by themselves."""

    key: Key
    student: Student

    @property
    def m(self) -> int:
        """Return the number of coordinates."""
        return len(self.key.coordinates)

    @property
    def q(self) -> Array:
        """Return the printed coordinates (n, m)."""
        return self.student.values[:, : self.m]

    @property
    def w(self) -> Array:
        """Return the printed rates of the coordinates (n, m)."""
        return self.student.values[:, self.m : 2 * self.m]

    @cached_property
    def q_units(self) -> Array:
        """Return the digits of the coordinates, 0 where missing."""
        return np.nan_to_num(self.student.units[:, : self.m])

    @cached_property
    def w_units(self) -> Array:
        """Return the digits of all velocities (n, r), 0 where missing."""
        return np.nan_to_num(self.student.units[:, self.m :])

    def whole(self, q: Array | None = None, w: Array | None = None) -> Array:
        """Return a table (n, m + r) of some columns, NaN elsewhere."""
        blank = np.full(self.student.values.shape, np.nan)
        if q is not None:
            blank[:, : self.m] = q
        if w is not None:
            blank[:, self.m :] = w
        return blank

    def shifted(self, rows: Array, by: int) -> Array:
        """Return rows moved down by `by` (up where negative), NaN where nothing comes in."""
        moved = np.full_like(rows, np.nan)
        if by > 0:
            moved[by:] = rows[:-by]
        else:
            moved[:by] = rows[-by:]
        return moved

    def steps(self, increments: Array, spread: Array) -> tuple[Array, Array]:
        """Return coordinates (n, m) made from each row before by `increments` (n, m) in rad or m, and their tolerance."""
        h = self.key.step
        expected = self.shifted(self.q + increments, 1)
        size = np.maximum(np.abs(self.w), LEAST * self.key.ranges[self.m : 2 * self.m])
        slack = SLACK * h * np.nan_to_num(size)
        tolerance = HALF * self.q_units + self.shifted(HALF * self.q_units + HALF * spread + slack, 1)
        return expected, tolerance

    def velocities(self, found: Array, spread: Array) -> tuple[Array, Array]:
        """Return velocities (n, r) and their tolerance."""
        return found, velocity_tolerance(self.key, self.w_units, found, spread)

    def slopes(self, data: Mapping[str, float] | None = None, t: Array | None = None) -> Callable[[Array], Array]:
        """Return f(t, q) with other data; the rows' own times where `t` is None."""
        return self.stacked(lambda times, q: self.key.velocities_at(times, q, data or {}), t)

    def stacked(self, function: Callable[[Array, Array], Array], t: Array | None = None) -> Callable[[Array], Array]:
        """Return a function of stacked copies of the rows, as sensitivities need it."""
        times = self.key.t if t is None else t
        return lambda q: function(np.tile(times, len(q) // len(times)), q)

    @cached_property
    def true_velocities(self) -> tuple[Array, Array]:
        """Return the velocities of the printed row's time and angles."""
        at = self.slopes()
        return self.velocities(at(self.q), sensitivity(at, self.q, self.q_units))

    def nearly(self, found: Array) -> bool:
        """Return whether velocities (n, r) come anywhere near those printed; what does not is not looked at closer."""
        tolerance = _NEAR * self.true_velocities[1]
        there = np.isfinite(found) & np.isfinite(self.student.values[:, self.m :])
        with np.errstate(invalid="ignore"):
            close = np.abs(self.student.values[:, self.m :] - found) <= tolerance
        return bool(there.any()) and float(close[there].mean()) >= _NEARLY

    def velocity_claim(self, code: str, at: Callable[[Array], Array], found: Array | None = None) -> Iterator[Claim]:
        """Yield the claim that the velocities are `at` the printed angles, where they are nearly so."""
        found = at(self.q) if found is None else found
        if self.nearly(found):
            yield self.claim(code, None, self.velocities(found, sensitivity(at, self.q, self.q_units)))

    def claim(self, code: str, step: tuple[Array, Array] | None = None, velocities: tuple[Array, Array] | None = None) -> Claim:
        """Return a claim; what a hypothesis does not change is left to Euler."""
        left = "steps" if step is None else "velocities" if velocities is None else ""
        q, q_tolerance = step or (None, None)
        w, w_tolerance = velocities or (None, None)
        return Claim(code, self.whole(q, w), self.whole(q_tolerance, w_tolerance), left)


def claims(printed: Printed, confusions: Mapping[str, float], others: Mapping[str, Array]) -> Iterator[Claim]:
    """Yield every hypothesis but Euler's own.

    `confusions` gives data by name with another value (rubric); `others` tables (n, m + r) of other variants by name.
    """
    yield from _schemes(printed)
    yield from _shifted_rows(printed)
    yield from _steps(printed)
    yield from _velocities(printed)
    yield from _data(printed, confusions)
    yield from _tables(printed, others)
    yield from _transformed(printed)


def _schemes(printed: Printed) -> Iterator[Claim]:
    """Steps of other schemes, each a function of the row's own angles."""
    h, m, t = printed.key.step, printed.m, printed.key.t

    def slopes(q: Array, ahead: float) -> Array:
        copies = len(q) // len(t)
        return printed.key.velocities_at(np.tile(t + ahead, copies), q, {})[:, :m]

    def heun(q: Array) -> Array:
        first = slopes(q, 0.0)
        return h / 2 * (first + slopes(q + h * first, h))

    def midpoint(q: Array) -> Array:
        return h * slopes(q + h / 2 * slopes(q, 0.0), h / 2)

    def rk4(q: Array) -> Array:
        first = slopes(q, 0.0)
        second = slopes(q + h / 2 * first, h / 2)
        third = slopes(q + h / 2 * second, h / 2)
        return h / 6 * (first + 2 * second + 2 * third + slopes(q + h * third, h))

    for increments in (heun, midpoint, rk4):
        spread = sensitivity(increments, printed.q, printed.q_units)
        yield printed.claim(increments.__name__, printed.steps(increments(printed.q), spread))
    rates, units = printed.w, printed.w_units[:, :m]
    following, units_after = printed.shifted(rates, -1), np.nan_to_num(printed.shifted(units, -1))
    yield printed.claim("trapezoid", printed.steps(h / 2 * (rates + following), h / 2 * (units + units_after)))
    yield printed.claim("backward", printed.steps(h * following, h * units_after))


def _shifted_rows(printed: Printed) -> Iterator[Claim]:
    """Velocities of another time, or printed a row too late or too early."""
    h, m = printed.key.step, printed.m
    for code, ahead in (("time_ahead", h), ("time_behind", -h)):
        yield from printed.velocity_claim(code, printed.slopes(t=printed.key.t + ahead))
    found, tolerance = printed.true_velocities
    for code, by in (("omega_late", 1), ("omega_early", -1)):
        used = printed.shifted(printed.w, -by)
        units = np.nan_to_num(printed.shifted(printed.w_units[:, :m], -by))
        yield printed.claim(
            code, printed.steps(h * used, h * units), (printed.shifted(found, by), printed.shifted(tolerance, by))
        )


def _steps(printed: Printed) -> Iterator[Claim]:
    """Steps with rounded velocities, or of another length."""
    h, m = printed.key.step, printed.m
    units = printed.w_units[:, :m]
    for decimals in ROUNDED_TO:
        if np.nanmax(np.where(units > 0, units, np.nan), initial=0.0) < 10.0**-decimals * 0.99:
            rounded = np.round(printed.w, decimals)
            yield printed.claim(f"rounded_omega_{decimals}", printed.steps(h * rounded, np.zeros_like(units)))
    for part in STEPS:
        step = printed.steps(part * h * printed.w, part * h * units)
        yield printed.claim("other_step", step)
        at = printed.slopes(t=printed.key.t * part)
        if printed.nearly(found := at(printed.q)):
            spread = sensitivity(at, printed.q, printed.q_units)
            yield printed.claim("other_step", step, printed.velocities(found, spread))


def _velocities(printed: Printed) -> Iterator[Claim]:
    """Velocities of moved angles, of one wrong sign, of a drive with the other sign, of degrees taken for radians."""
    key, h, m = printed.key, printed.key.step, printed.m
    solved: list[int] = []
    moved = printed.true_velocities[0].copy()
    units = np.hstack([printed.q_units, printed.w_units])
    spread = np.zeros_like(moved)
    for index, block in enumerate(key.blocks):
        places = [key.velocities.index(name) for name in block]
        if index and solved:

            def at(cells: Array, index: int = index, done: tuple[int, ...] = tuple(solved)) -> Array:
                q = cells[:, :m].copy()
                q[:, done] += h * cells[:, [m + place for place in done]]
                return key.block_at(index, np.tile(key.t, len(cells) // len(key.t)), q, cells[:, m:])

            moved[:, places] = at(printed.student.values)
            spread[:, places] = sensitivity(at, printed.student.values, units)
        solved += [place for place in places if place < m]
    if len(key.blocks) > 1:
        yield printed.claim("new_phi", None, printed.velocities(moved, spread))
    found, tolerance = printed.true_velocities
    for place, name in enumerate(key.velocities):
        turned = found.copy()
        turned[:, place] *= -1
        yield printed.claim(f"sign_{name}", None, (turned, tolerance))
    for code in ("sign_drive", "degree_mode"):
        if rewritten := key.rewritten(code):
            yield from printed.velocity_claim(code, printed.stacked(rewritten))


def _data(printed: Printed, confusions: Mapping[str, float]) -> Iterator[Claim]:
    """Velocities with a datum ten times, twice, turned round; with two data exchanged; with a value that was declared."""
    given = printed.key.variant.given
    tried: list[tuple[str, dict[str, float]]] = [
        (f"datum_{datum.name}", {datum.name: factor * datum.value}) for datum in given for factor in FACTORS
    ]
    tried += [
        (f"swap_{first.name}_{second.name}", {first.name: second.value, second.name: first.value})
        for index, first in enumerate(given)
        for second in given[index + 1 :]
        if first.si == second.si and first.value != second.value
    ]
    tried += [(f"confusion_{name}", {name: value}) for name, value in confusions.items()]
    sets = printed.key.sets_at(printed.key.t, printed.q, [data for _, data in tried])
    for (code, data), found in zip(tried, sets, strict=True):
        yield from printed.velocity_claim(code, printed.slopes(data), found)


def _tables(printed: Printed, others: Mapping[str, Array]) -> Iterator[Claim]:
    """The exact motion, or the table of another variant of the class."""
    units = np.nan_to_num(printed.student.units)
    key = printed.key
    exact = np.full_like(key.table, np.nan)
    exact[: len(key.exact)] = key.exact[: len(exact)]
    tolerance = HALF * units + SLACK * key.ranges
    yield Claim("exact", exact, tolerance)
    for name, table in others.items():
        if table.shape == key.table.shape:
            yield Claim(f"variant_{name}", table, HALF * units + SLACK * np.ptp(table, axis=0))
    for table in key.branches.values():
        if table.shape == key.table.shape:
            yield Claim("branch", table, HALF * units + SLACK * np.ptp(table, axis=0))


def _transformed(printed: Printed) -> Iterator[Claim]:
    """Two columns of one kind exchanged; an angle counted from another axis or the other way round."""
    key, student, m = printed.key, printed.student, printed.m
    tolerance = HALF * np.nan_to_num(student.units) + SLACK * key.ranges
    width = len(key.names)
    unit = [key.variant.unit_of(name) for name in key.names]
    for first in range(width):
        for second in range(first + 1, width):
            if unit[first] != unit[second] or (first < m) != (second < m):
                continue
            order = list(range(width))
            order[first], order[second] = second, first
            values = student.values[:, order]
            with np.errstate(invalid="ignore"):
                close = np.abs(values - key.table) <= tolerance[:, order]
            if close[:, [first, second]].mean() > _LIKE_KEY:
                put_back = Student(values, student.units[:, order])
                yield _as_euler("swapped_columns", put_back)
    for place in range(m):
        if key.variant.coordinates[place].unit != "rad":
            continue
        for sign in (1.0, -1.0):
            shift = np.nanmedian(student.values[:, place] - sign * key.table[:, place])
            quarters = np.round(shift / (np.pi / 2)) if np.isfinite(shift) else 0.0
            if not quarters or abs(shift - quarters * np.pi / 2) > 0.02:
                continue
            values = student.values.copy()
            values[:, place] = sign * (values[:, place] - quarters * np.pi / 2)
            yield _as_euler(f"origin_{key.names[place]}", replace(student, values=values))


_LIKE_KEY = 0.8


def _as_euler(code: str, student: Student) -> Claim:
    """Return the claim that a table put right is Euler's."""
    blank = np.full(student.values.shape, np.nan)
    return Claim(code, blank, blank, "all", student)
