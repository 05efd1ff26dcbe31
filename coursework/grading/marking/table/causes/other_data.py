"""What a wrong table may have been made with: other data, another table, or columns with another meaning.

Enters: a `TableUnderTest`, the rubric's confusions, tables of other variants.  Leaves: `Claim`s.
Used by `hypotheses.py`, and by `misconceptions.py` for what a file's own rules refuse.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain, combinations, cycle, islice, product

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.causes.shifted import in_order, put_back
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.ways import HALF, SLACK, StudentTable, as_printed, near
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags, shifted
from coursework.variant.formula.units import size_of
from coursework.variant.judging.lengths import is_refused
from coursework.variant.record.entries import Given

DATUM, DATA_ROUNDED = "datum_", "data_rounded"
FACTORS = (10.0, 0.1, 2.0, 0.5, -1.0, 0.0)
# Turns per second taken for radians per second, or centimetres or millimetres for metres, and the other way round.
_UNITS = {"1/s": (2 * np.pi, 0.5 / np.pi), "m": (100.0, 0.01, 1000.0, 0.001)}
_LIKE_KEY = 0.5  # columns are exchanged if, put back, this part of them agrees with the key, or if their start values do
_IN_PLACE = 0.9  # from this part of the angles, or of the velocities, on, they stand where they belong
_QUARTER = 0.003  # rad by which quarter turns may be off: π may have been taken as 3.14
_TURN = 2 * np.pi
SLIPPED, EACH_SLIPPED, COLUMN_SLIPPED = "point_slipped", "each_point_slipped", "column_slipped_"
OTHER_SIGN = "other sign"  # behind the value and unit of a datum that has it
# A datum is computed from the printed velocities by _ROUNDS Newton steps, with slopes over a relative difference.  A velocity
# counts if its slope is over _FELT of the largest; the value is another one if it differs by more than _ANOTHER of itself.
_ROUNDS, _DIFFERENCE, _FELT, _ANOTHER = 7, 1e-6, 1e-2, 1e-5
_SAME = 1e-9  # relative difference up to which two numbers are the same
# From this part of the velocities on that are the task's, the others are looked at alone too.
_PUT_RIGHT = 0.25
# Parts of the task's value at which the search begins: a frequency, or a length in a closed chain, leads astray from afar.
_BEGINS, _SETTLED = (1.0, 0.4, 2.5), 1e-4


def other_data(printed: TableUnderTest, confusions: Mapping[str, float]) -> Iterator[Claim]:
    """Yield claims of velocities with data scaled, negated, left out, confused, read off, exchanged or rounded together."""
    given = printed.key.variant.given
    tried: list[tuple[str, dict[str, float]]] = [
        (f"{DATUM}{datum.name}", {datum.name: factor * datum.value})
        for datum in given
        for factor in (*FACTORS, *_UNITS.get(datum.si, ()))
        if factor or _may_vanish(printed, datum)
    ]
    tried += [
        (f"swap_{first.name}_{second.name}", {first.name: second.value, second.name: first.value})
        for index, first in enumerate(given)
        for second in given[index + 1 :]
        if first.si == second.si and first.value != second.value
    ]
    tried += [(f"confusion_{name}", {name: value}) for name, value in confusions.items()]
    sets = printed.key.sets_at(printed.key.t, printed.q, [data for _, data in tried])
    by_code = {f"{DATUM}{datum.name}": datum for datum in given}
    for (code, data), found in zip(tried, sets, strict=True):
        shown = _shown(by_code[code], *data.values()) if code in by_code else ()
        if shown and [*data.values()] == [-by_code[code].value]:
            shown = (*shown, OTHER_SIGN)
        yield from printed.velocity_claim(code, partial(printed.key.velocities_at, data=data), found, shown)
    for datum, value in [(one, value) for one, read in _values_read_off(printed) for value in _as_typed(one, read)]:
        at = partial(printed.key.velocities_at, data={datum.name: value})
        for claim in printed.velocity_claim(f"{DATUM}{datum.name}", at, names=_shown(datum, value)):
            yield replace(claim, is_read_off=True)
    for data in _rounded(given):  # last: one datum that explains as much is told
        yield from printed.velocity_claim(DATA_ROUNDED, partial(printed.key.velocities_at, data=data))


def _as_typed(datum: Given, read: float) -> Iterator[float]:
    """Yield a value as computed from the table, and rounded as it may have been typed; an angle without whole turns first."""
    turned = read % _TURN if datum.si == "rad" and datum.value > 0 else read
    yield from dict.fromkeys((turned, float(f"{turned:.3g}"), read, float(f"{read:.3g}")))


def _rounded(given: Sequence[Given]) -> Iterator[dict[str, float]]:
    """Yield the values of data that change if all are rounded to so many digits, or decimals; one alone is another datum."""
    sizes = [size_of(datum.unit) or 1.0 for datum in given]
    found: list[dict[str, float]] = []
    for kind, half in product(("3g", "2g", "2f", "1f"), (1 + _SAME, 1 - _SAME)):  # 4.35 is 4.4 to people, 4.3 to programs
        shown = [float(f"{half * datum.value / size:.{kind}}") * size for datum, size in zip(given, sizes, strict=True)]
        pairs = zip(given, shown, strict=True)
        data = {datum.name: near for datum, near in pairs if abs(near - datum.value) > _ANOTHER * abs(datum.value)}
        if len(data) > 1 and all(data.values()) and data not in found:
            found.append(data)
            yield data


def _may_vanish(printed: TableUnderTest, datum: Given) -> bool:
    """Return whether the velocities can be computed with a datum of 0, without a division by zero."""
    try:
        printed.key.velocities_at(printed.key.t[:1], printed.key.table[:1, : printed.m], data={datum.name: 0.0})
    except ArithmeticError:
        return False
    return True


def _shown(datum: Given, value: float) -> tuple[str, ...]:
    """Return a value and its unit as a sentence tells them; empty for a number without a unit."""
    unit = datum.unit or datum.si
    return (f"{value / (size_of(datum.unit) or 1.0):.4g}", unit) if unit else ()


def may_be(key: Key, code: str, names: Sequence[str]) -> bool:
    """Return whether a cause may be one, with its `names`: a datum may not have a value and unit that a file may not have."""
    if not code.startswith(DATUM) or not names or (value := float(names[0])) > 0:
        return True
    return not is_refused(key.variant, code.removeprefix(DATUM), value * (size_of(names[1]) or 1.0))


def _values_read_off(printed: TableUnderTest) -> Iterator[tuple[Given, float]]:
    """Yield each datum with the median of the values that the printed velocities give for it, if that is not the task's.

    Where many velocities are the task's they may have been put right: then also with that of the others.
    """
    given = [datum for datum in printed.key.variant.given if datum.value]
    if not printed.closely or not len(given):
        return
    velocities, of_task = printed.student.values[:, printed.m :], printed.of_task[:, printed.m :]
    found = [_solved(printed, given, velocities, begin) for begin in _BEGINS]
    if of_task.mean() > _PUT_RIGHT:
        found.append(_solved(printed, given, np.where(of_task, np.nan, velocities)))
    told: set[tuple[str, str]] = set()
    for datum, value in zip(cycle(given), np.concatenate(found).tolist(), strict=False):
        shown = datum.name, f"{value:.6g}"
        if np.isfinite(value) and value * datum.value > 0 and abs(value / datum.value - 1) > _ANOTHER and shown not in told:
            told.add(shown)
            yield datum, value


def _solved(printed: TableUnderTest, given: Sequence[Given], velocities: Array, begin: float = 1.0) -> Array:
    """Return for each datum the value (k,) that velocities (n, r) give for it alone, NaN among them left out.

    The search begins at this part of the task's values; away from them NaN stands where it settles on nothing.
    """
    key, task = printed.key, np.array([datum.value for datum in given])
    found, step = begin * task, np.zeros(len(task))
    with np.errstate(all="ignore"):
        for _ in range(_ROUNDS):
            steps = _DIFFERENCE * np.abs(task)
            values = np.concatenate([found, found + steps])
            both = key.sets_at(key.t, printed.q, [{datum.name: value} for datum, value in zip([*given] * 2, values, strict=True)])
            made, beside = both[: len(given)], both[len(given) :]
            slopes = np.nan_to_num((beside - made) / steps[:, None, None], posinf=0.0, neginf=0.0)
            felt = np.abs(slopes) > _FELT * np.max(np.abs(slopes), axis=(1, 2), keepdims=True)
            moves = np.where(felt, (velocities - made) / slopes, np.nan).reshape(len(given), -1)
            step = np.clip(_medians(moves), -np.abs(task), np.abs(task))
            found = found + step
    return np.where((begin == 1.0) | (np.abs(step) < _SETTLED * np.abs(task)), found, np.nan)


def _medians(rows: Array) -> Array:
    """Return the median (k,) of the finite numbers in each row (k, n), 0 if there are none."""
    return np.array([np.median(row[np.isfinite(row)]) if np.isfinite(row).any() else 0.0 for row in rows])


def other_tables(printed: TableUnderTest, others: Mapping[str, Array]) -> Iterator[Claim]:
    """Yield claims that the table is the exact motion, that of another variant of the class, or that of another assembly."""
    units = np.nan_to_num(printed.student.units)
    key = printed.key
    exact = np.full_like(key.table, np.nan)
    exact[: len(key.exact)] = key.exact[: len(exact)]
    tolerance = as_printed(key, units)
    yield Claim("exact", exact, tolerance, is_whole=True, table=lambda: exact)
    for name, table in others.items():
        if table.shape == key.table.shape:
            yield _whole(f"variant_{name}", table, units)
    for table in key.branches:
        yield _whole("branch", table, units)


def _whole(code: str, table: Array, units: Array) -> Claim:
    """Return the claim that the whole table is another one, printed with `units` of the last places."""
    return Claim(code, table, HALF * units + SLACK * np.ptp(table, axis=0), is_whole=True, table=lambda: table)


def shifted_rows(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield the claim that rows stand twice or are left out, so that every row after them stands beside another time.

    If there are none, yield the claim that the rows of the task stand in another order, e.g. from the last to the first.  If the
    angles stand where they belong, another cause that explains as much is preferred: only the velocities are shifted.  If the
    velocities do, the claim names the coordinates: only these are.
    """
    turns = _taken_off(printed.student)  # which depend on the first row, also where that belongs to a later time
    whole = replace(printed.student, values=printed.student.values + _TURN * turns, turns=None)
    as_handed_in = [printed, *([TableUnderTest(printed.key, whole)] if turns.any() else [])]
    rules = (("rows_shifted", put_back), ("rows_order", in_order))
    found = ((code, student) for code, rule in rules for student in map(rule, as_handed_in) if student is not None)
    for code, student in islice(found, 1):
        in_place, still = (bool(part.mean() >= _IN_PLACE) for part in np.hsplit(printed.of_task, [printed.m]))
        names = tuple(printed.key.coordinates) if still and not in_place else ()
        yield replace(_as_euler(code, student, names), is_read_off=in_place)


def printed_otherwise(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield the claims that the coordinates, all columns, or one of them, were printed ten times too large or too small, or that
    one velocity stands a row too early.

    The starts tell it of several columns, most of its cells of one.
    """
    student, m, names = printed.student, printed.m, printed.key.names
    there = student.values + _TURN * np.hstack([_taken_off(student)[:, :m], np.zeros((len(student.values), len(names) - m))])
    off = [place for place in range(len(names)) if printed.of_task[:, place].mean() <= _LIKE_KEY]
    sets: list[tuple[str, Sequence[int]]] = [(SLIPPED, range(m)), (EACH_SLIPPED, range(len(names)))]
    sets += [(f"{COLUMN_SLIPPED}{names[place]}", [place]) for place in off]
    tried = [(code, places, there[:, places] / by, student.units[:, places] / by) for by in (10, 0.1) for code, places in sets]
    above = shifted(there, 1), shifted(student.units, 1)
    tried += [(f"row_below_{names[place]}", [place], above[0][:, [place]], above[1][:, [place]]) for place in off if place >= m]
    for code, places, numbers, last in tried:
        values, units = student.values.copy(), student.units.copy()
        values[:, places], units[:, places] = numbers, last
        right = alike(printed.key, replace(student, values=values, units=units), printed.key.table)
        if right[0, :m].all() if len(places) > 1 else right[:, places].mean() > _LIKE_KEY:
            yield _as_euler(code, _kept(printed, printed.of_task, StudentTable(values, units)))


def other_columns(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield claims that two columns are exchanged, or that an angle is counted from another axis or in the other direction."""
    yield from _exchanged(printed)
    key, student, m = printed.key, printed.student, printed.m
    for place in range(m):
        if key.variant.coordinates[place].unit != "rad" or not np.isfinite(student.values[:, place]).any():
            continue
        for sign in (1.0, -1.0):
            shifts = student.values[:, place] - sign * key.table[:, place]
            shift = np.nanmedian(shifts)
            quarters = np.round(shift / (np.pi / 2)) if np.isfinite(shift) else 0.0
            # The middle of a column that runs the other way may be a quarter turn by chance: its cells must be.
            off = np.nanmedian(np.abs(shifts - quarters * np.pi / 2)) - np.nanmax(student.units[:, place])
            if not (quarters or sign < 0) or off > _QUARTER:
                continue
            values = student.values.copy()
            values[:, place] = sign * (values[:, place] - quarters * np.pi / 2)
            code, rate = f"origin_{key.names[place]}", key.names.index(key.variant.coordinates[place].rate)
            yield _as_euler(code, _kept(printed, printed.of_task, replace(student, values=values)))
            if sign < 0:  # its velocity, too
                turned = np.where(np.arange(len(key.names)) == rate, -values, values)
                yield _as_euler(code, _kept(printed, printed.of_task, replace(student, values=turned)))


def _exchanged(printed: TableUnderTest) -> Iterator[Claim]:
    """Yield claims that two columns are exchanged, or two coordinates together with their velocities, as links numbered from the
    other end are; whole turns are taken off after they are exchanged back.
    """
    key, student, m = printed.key, printed.student, printed.m
    turns, tolerance, as_it_is = _taken_off(student), as_printed(key, np.nan_to_num(student.units)), printed.of_task
    rates = [key.names.index(one.rate) for one in key.variant.coordinates]
    links = ((first, second, rates[first], rates[second]) for first, second in combinations(range(m), 2))
    for first, second, *beside in chain(combinations(range(len(key.names)), 2), links):
        pair, order = [first, second, *beside], list(range(len(key.names)))
        for one, other in zip(pair[::2], pair[1::2], strict=True):
            order[one], order[other] = other, one
        values = (student.values + _TURN * turns)[:, order]
        for place in pair:
            values[:, place] -= _turns(key, place, values[:, place])
        for place in set(range(len(key.names))) - {*pair}:
            values[:, place] = student.values[:, place]
        close = near(values, key.table, tolerance[:, order]) | as_it_is[:, order]
        is_like = second < m and key.variant.unit_of(key.names[first]) == key.variant.unit_of(key.names[second])
        begins = is_like and close[0, pair].all() and not as_it_is[0, pair].all()
        if begins or close[:, pair].mean() > max(_LIKE_KEY, as_it_is[:, pair].mean()):
            names = tuple(key.names[place] for place in pair)
            undone = _kept(printed, as_it_is[:, order], StudentTable(values, student.units[:, order]))
            yield _as_euler("swapped_columns", undone, names)


def _taken_off(student: StudentTable) -> Array:
    """Return the whole turns (n, m + r) that the reader took off."""
    return np.zeros(student.values.shape) if student.turns is None else student.turns


def _turns(key: Key, place: int, values: Array) -> float:
    """Return the whole turns (rad) by which a column's first value differs from the key's, 0 if it is no angle."""
    off = (values - key.table[:, place])[np.isfinite(values)]
    if key.variant.unit_of(key.names[place]) != "rad" or not len(off):
        return 0.0
    return float(whole_turns(off[0]))


def _as_euler(code: str, student: StudentTable, names: tuple[str, ...] = ()) -> Claim:
    """Return the claim that the table `student`, in which the cause is undone, follows Euler's rules."""
    blank = np.full(student.values.shape, np.nan)
    return Claim(code, blank, blank, student, is_whole=True, names=names)


def _kept(printed: TableUnderTest, stands: Flags, undone: StudentTable) -> StudentTable:
    """Return the table in which a cause is `undone`, with cells that stand right, (n, m + r), as the task has them.

    They were put right in the table handed in.
    """
    put = stands & ~alike(printed.key, undone, printed.key.table)
    return replace(undone, values=np.where(put, printed.key.table, undone.values))
