"""What a wrong table may have been made with: another rule for the step, or another rule for the velocities.

Enters: a `TableUnderTest`, the rubric's confusions, tables of other variants.  Leaves: `Claim`s, one for each hypothesis.
Used by `misconceptions.py`; hypotheses about other numbers stand in `other_data.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from coursework.grading.marking.equations.marks import EquationMarks
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim, Family, TableUnderTest
from coursework.grading.marking.table.causes.clockwise import turned_back
from coursework.grading.marking.table.causes.other_data import other_data, other_tables
from coursework.grading.marking.table.causes.other_drive import other_drive
from coursework.grading.marking.table.causes.own_equations import equation_claims
from coursework.grading.marking.table.causes.printed_otherwise import SIGN, other_columns, printed_otherwise, shifted_rows
from coursework.grading.marking.table.causes.step_lengths import DEGREE, WHOLE, parts_of_step, small_steps, steps_a_row, told_step
from coursework.grading.marking.table.starts import march
from coursework.grading.marking.table.ways import HALF
from coursework.motion.schemes import EULER, SCHEMES, Scheme
from coursework.system.arrays import Array, shifted

# Schemes that students take for Euler's; their names are the codes of the misconceptions.
SCHEMES_TRIED = ("heun", "midpoint", "ralston", "rk4")
ROUNDED_OMEGA, _ROUNDED_TO = "rounded_omega_", (1, 2, 3)
# With these causes only the velocities of a table are right.
OTHER_STEP, DEGREE_STEPS, STEPS_IN_DEGREES = "other_step", "degree_steps", "steps_in_degrees"
# An implicit step is iterated at most so often, until it changes by less than _STANDS (rad or m).
_REPEATED, _STANDS = 100, 1e-10
Velocities = Callable[[Array, Array], Array]
COSINE, PI_ROUNDED, RADIAN_MODE, NO_VELOCITIES = "cosine_", "pi_rounded", "radian_mode", "no_velocities"
MISREAD = ("sign_drive", "cosine_drive", "degree_mode", "degree_drive", "degree_geometry", RADIAN_MODE, PI_ROUNDED)


def claims(
    printed: TableUnderTest,
    confusions: Mapping[str, float],
    others: Mapping[str, Array],
    equations: EquationMarks | None = None,
) -> Iterator[Claim]:
    """Yield the claims of every hypothesis except Euler's rules themselves.

    `confusions` maps names of data to another value (from the rubric), `others` names of other variants to their tables
    (n, m + r); `equations` are those handed in.
    """
    if np.nanmax(np.abs(printed.student.values[:, printed.m :]), initial=-1.0) == 0.0:
        yield printed.claim(NO_VELOCITIES, None, (np.zeros_like(printed.w_units), HALF * printed.w_units))
        return
    back = turned_back(printed.key, printed.student)
    if back is not None:
        yield replace(printed.claim("clockwise"), student=back)
    if printed.closely:
        yield from shifted_rows(printed)
        yield from printed_otherwise(printed)
    families: list[Family] = [
        _schemes, _shifted_rows, _steps, partial(_velocities, apart=() if back is None else ("sign_drive",)),
        partial(other_data, confusions=confusions), partial(other_tables, others=others), other_columns, other_drive,
    ]  # fmt: skip
    if printed.closely:
        families.append(partial(equation_claims, marks=equations))
    for family in families:
        for claim in family(printed):
            yield replace(claim, family=family)


def _schemes(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield claims of steps by other schemes from the row's own angles, and of Euler's with the time or rates of another row."""
    h, m, velocities_at = printed.key.step, printed.m, printed.key.velocities_at

    def increments(t: Array, q: Array, w: Array, scheme: Scheme, ahead: float, clock: float) -> Array:
        def slopes(at: Array, moved: Array) -> Array:
            return velocities_at(t + clock * (at - t) + ahead, q + moved)[:, :m]

        return np.asarray(scheme.step(slopes, t, np.zeros_like(q), h))

    # In another scheme all stages may have used the time of the row: clock 0.
    tried = [(name, SCHEMES[name], 0.0, clock) for name in SCHEMES_TRIED for clock in (1.0, 0.0)]
    tried += [("step_ahead", EULER, h, 1.0), ("step_behind", EULER, -h, 1.0)]
    rules = [(code, partial(increments, scheme=one, ahead=ahead, clock=clock)) for code, one, ahead, clock in tried]
    for code, made in [*rules, ("in_place", partial(_one_by_one, printed.key))]:
        claim = printed.claim(code, printed.steps(*printed.with_spread(printed.stacked(partial(made, w=np.empty(0))))))
        yield replace(claim, table=printed.marched(velocities_at, made))
    rates, units = printed.w, printed.w_units[:, :m]
    following, units_after = shifted(rates, -1), np.nan_to_num(shifted(units, -1))
    trapezoid = printed.claim("trapezoid", printed.steps(h / 2 * (rates + following), h / 2 * (units + units_after)))
    backward = printed.claim("backward", printed.steps(h * following, h * units_after))
    for claim, new in ((trapezoid, 0.5), (backward, 1.0)):
        yield replace(claim, table=printed.marched(velocities_at, partial(_implicit, printed.key, new)))
    before, units_before = shifted(rates, 1), np.nan_to_num(shifted(units, 1))
    for code, weight in (("row_before", 1.0), ("two_rows", -0.5)):
        used = rates + weight * (before - rates)
        claim = printed.claim(code, printed.steps(h * used, h * (abs(1 - weight) * units + abs(weight) * units_before)))
        yield replace(claim, table=partial(_from_rows_before, printed.key, weight))
    order = printed.rates_used()
    if order != [*range(m)]:
        claim = printed.claim("other_rates", printed.steps(h * rates[:, order], h * units[:, order]))
        yield replace(claim, table=printed.marched(velocities_at, lambda t, q, w: h * w[:, order]))


def _one_by_one(key: Key, t: Array, q: Array, w: Array) -> Array:
    """Return increments (n, m): a program that overwrites the coordinates moves each with those before it already moved."""
    moved = q.copy()
    for place in range(q.shape[1]):
        moved[:, place] += key.step * key.velocities_at(t, moved)[:, place]
    return moved - q


def _from_rows_before(key: Key, weight: float = 1.0) -> Array:
    """Return the table (n, m + r) whose steps use the velocities of the row before with this weight, and its own with the rest.

    The first step uses only the first row's velocities.
    """
    rates: list[Array] = []

    def increments(t: Array, q: Array, w: Array) -> Array:
        rates.append(w[:, : key.m])
        return key.step * (rates[-1] + weight * (rates[max(len(rates) - 2, 0)] - rates[-1]))

    return march(key, key.table[0, : key.m], key.velocities_at, increments)


def _of_rows_above(key: Key) -> Array:
    """Return the table (n, m + r) that, from row 2 on, prints the velocities of the row above and steps with them."""
    m, table = key.m, _from_rows_before(key)
    table[1:, m:] = table[:-1, m:].copy()
    return table


def _of_angles_above(key: Key) -> Array:
    """Return the table (n, m + r) whose velocities are computed with the row's time, but with the angles of the row above."""
    rows: list[Array] = []

    def velocities_at(t: Array, q: Array) -> Array:
        rows.append(q)
        return key.velocities_at(t, rows[max(len(rows) - 2, 0)])

    return march(key, key.table[0, : key.m], velocities_at)


def _implicit(key: Key, new: float, t: Array, q: Array, w: Array) -> Array:
    """Return increments (n, m) with the part `new` of the next row's velocities; NaN if the iteration does not converge."""
    h, m = key.step, q.shape[1]
    found = h * w[:, :m]
    for _ in range(_REPEATED):
        before = found
        found = h * ((1 - new) * w[:, :m] + new * key.velocities_at(t + h, q + before)[:, :m])
        if np.all(np.abs(found - before) < _STANDS):
            return found
    return np.full_like(q, np.nan)


def _shifted_rows(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield claims of velocities at another time or with other angles, or printed a row too late or too early."""
    h, m = printed.key.step, printed.m
    times = [("time_ahead", 1.0, h), ("time_behind", 1.0, -h), ("time_in_rows", 1 / h, 0.0), ("time_in_rows", 1 / h, 1.0)]
    for code, part, ahead in (*times, ("time_still", 0.0, 0.0), ("time_still", 0.0, 1.0)):  # p where p*t was meant
        yield from printed.velocity_claim(code, partial(_of_times, printed.key, part, ahead))
    start = printed.key.table[:1, :m]
    yield from printed.velocity_claim("first_angles", lambda t, q: printed.key.velocities_at(t, np.repeat(start, len(q), axis=0)))
    found, tolerance = printed.true_velocities
    above = shifted(printed.q, 1)
    above[0] = printed.q[0]
    claim = printed.claim("angles_above", None, (printed.key.velocities_at(printed.key.t, above), shifted(tolerance, 1)))
    yield replace(claim, table=partial(_of_angles_above, printed.key))
    made = partial(_of_rows_above, printed.key)
    for code, by, used, table in (("rows_above", 1, 0, made), ("omega_late", 1, 1, None), ("omega_early", -1, -1, None)):
        rates, units = shifted(printed.w, -used), np.nan_to_num(shifted(printed.w_units[:, :m], -used))
        claim = printed.claim(code, printed.steps(h * rates, h * units), (shifted(found, by), shifted(tolerance, by)))
        yield replace(claim, table=table)


def _steps(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield claims of steps with rounded velocities, with rad/s added to degrees, or of another length."""
    h, m = printed.key.step, printed.m
    units = printed.w_units[:, :m]
    for decimals in _ROUNDED_TO:
        if np.nanmax(np.where(units > 0, units, np.nan), initial=0.0) < 10.0**-decimals * 0.99:
            claim = printed.claim(
                f"{ROUNDED_OMEGA}{decimals}", printed.steps(h * np.round(printed.w, decimals), np.zeros_like(units))
            )
            yield replace(claim, table=printed.marched(printed.key.velocities_at, partial(_rounded, h, decimals)))
    lacking = _of_degrees(printed.key)
    for code, each in ((DEGREE_STEPS, lacking), (STEPS_IN_DEGREES, 1 / lacking)):
        if (each != 1).any():
            claim = printed.claim(code, printed.steps(h * each * printed.w, h * each * units))
            yield replace(claim, table=printed.marched(printed.key.velocities_at, partial(_longer, h * each)))
    for part in parts_of_step(printed):
        step = printed.steps(part * h * printed.w, part * h * units)
        longer = partial(_longer, part * h)
        claims = [printed.claim(OTHER_STEP, step)]
        made: list[Velocities] = [printed.key.velocities_at, partial(_of_times, printed.key, part, 0.0)]
        at = printed.stacked(made[1])
        if printed.nearly(at(printed.q)):
            claims.append(printed.claim("other_step", step, printed.velocities(*printed.with_spread(at))))
        claims = [
            replace(claim, table=printed.marched(velocities_at, longer), velocities_at=velocities_at)
            for claim, velocities_at in zip(claims, made, strict=False)
        ]
        if (times := round(1 / part)) > 1 and abs(times * part - 1) < WHOLE:
            claims.append(_in_small_steps(printed, times))
        yield from (replace(claim, part=part, names=(told_step(part * h),)) for claim in claims)
    if times := steps_a_row(printed):
        yield replace(_in_small_steps(printed, times), part=1 / times, names=(told_step(h / times),), is_read_off=True)


def _in_small_steps(printed: TableUnderTest, times: int) -> Claim:
    """Return the claim that each row was made in several Euler steps."""
    several = partial(small_steps, printed.key, times)
    at_once = printed.stacked(several)
    claim = printed.claim(OTHER_STEP, printed.steps(*printed.with_spread(at_once)))
    return replace(claim, table=printed.marched(printed.key.velocities_at, several))


def _of_degrees(key: Key) -> Array:
    """Return the part (m,) of each coordinate's step that is made if velocities in rad/s are added to angles in degrees."""
    return np.array([DEGREE if one.unit == "rad" else 1.0 for one in key.variant.coordinates])


def _of_times(key: Key, part: float, ahead: float, t: Array, q: Array) -> Array:
    """Return the velocities (n, r) at the times `part` * t + `ahead` (s)."""
    return key.velocities_at(np.asarray(part * t + ahead), q)


def _longer(step: float | Array, t: Array, q: Array, w: Array) -> Array:
    """Return the increments (n, m) of Euler steps of the length `step`, s."""
    return step * w[:, : q.shape[1]]


def _rounded(h: float, decimals: int, t: Array, q: Array, w: Array) -> Array:
    """Return the increments (n, m) of steps with velocities rounded to so many decimals."""
    return h * np.round(w[:, : q.shape[1]], decimals)


def _velocities(printed: TableUnderTest, apart: tuple[str, ...]) -> Iterator[Claim]:
    """Yield claims: angles moved before later blocks, misread formulas (not `apart`), a velocity with wrong sign or row."""
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

            moved[:, places], spread[:, places] = printed.with_spread(at, printed.student.values, units)
        solved += [place for place in places if place < m]
    if len(key.blocks) > 1:
        yield printed.claim("new_phi", None, printed.velocities(moved, spread))
    found, tolerance = printed.true_velocities
    for code in (*MISREAD, *(f"{fault}{law.name}" for fault in (SIGN, COSINE) for law in key.variant.drive)):
        if code not in apart and (velocities := key.misread(code)):
            yield from printed.velocity_claim(code, velocities)
            if (handed_in := printed.with_turns) is not None:  # a whole turn is none in degrees
                yield from printed.velocity_claim(code, velocities, q=handed_in)
            if code == RADIAN_MODE and printed.nearly(printed.stacked(velocities)(printed.q)):
                # Students who take degrees for radians also add rad/s to them: only the starts are not those of the task.
                misread, spread = printed.with_spread(printed.stacked(velocities))
                angles = tuple(one.name for one in key.variant.coordinates if one.unit == "rad")
                each = h * _of_degrees(key)
                steps = printed.steps(each * printed.w, each * printed.w_units[:, :m])
                claim = printed.claim(code, steps, printed.velocities(misread, spread), angles)
                yield replace(claim, table=printed.marched(velocities, partial(_longer, each)))
    for place, name in enumerate(key.velocities):
        alone = np.where(np.arange(m + len(key.velocities)) == m + place, 1.0, np.nan)
        claim = printed.claim(f"{SIGN}{name}", None, (-found * alone[m:], tolerance))
        yield replace(claim, table=partial(np.multiply, key.table, np.where(np.isnan(alone), 1.0, -1.0)))
        yield printed.claim(f"row_above_{name}", None, (shifted(found, 1) * alone[m:], shifted(tolerance, 1)))
