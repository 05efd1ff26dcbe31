"""A table that is right but for how it was printed: rows elsewhere, columns exchanged, turned round or ten times too large.

Enters: a `TableUnderTest`.  Leaves: `Claim`s about the table in which the cause is undone.
Used by `hypotheses.py`, `whole.py`, and for the codes by `earning.py` and `grade.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain, combinations, islice

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.causes.shifted import in_order, put_back
from coursework.grading.marking.table.cells import alike
from coursework.grading.marking.table.points import RUN
from coursework.grading.marking.table.ways import StudentTable, as_printed, near
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags, shifted

_LIKE_KEY = 0.5  # a column was printed otherwise if, put back, this part of it agrees with the key, or if the start values do
_IN_PLACE = 0.9  # from this part of the angles, or of the velocities, on, they stand where they belong
_QUARTER = 0.003  # rad by which quarter turns may be off: π may have been taken as 3.14
_TURN = 2 * np.pi
SLIPPED, EACH_SLIPPED, COLUMN_SLIPPED = "point_slipped", "each_point_slipped", "column_slipped_"
SIGN, SWAPPED_COLUMNS, ROW_BELOW = "sign_", "swapped_columns", "row_below_"


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
    one velocity has the other sign or stands a row too early, although what was made from it is right.

    The starts tell it of several columns, RUN of its cells of one, and no cell put right takes that back: half of the column
    must be right one way or the other.
    """
    student, m, names = printed.student, printed.m, printed.key.names
    there = student.values + _TURN * np.hstack([_taken_off(student)[:, :m], np.zeros((len(student.values), len(names) - m))])
    off = [place for place in range(len(names)) if (~printed.of_task[:, place]).sum() >= RUN]
    sets: list[tuple[str, Sequence[int]]] = [(SLIPPED, range(m)), (EACH_SLIPPED, range(len(names)))]
    sets += [(f"{COLUMN_SLIPPED}{names[place]}", [place]) for place in off]
    tried = [(code, places, there[:, places] / by, student.units[:, places] / by) for by in (10, 0.1) for code, places in sets]
    rates, above = [place for place in off if place >= m], (shifted(there, 1), shifted(student.units, 1))
    tried += [(f"{SIGN}{names[place]}", [place], -there[:, [place]], student.units[:, [place]]) for place in rates]
    tried += [(f"{ROW_BELOW}{names[place]}", [place], above[0][:, [place]], above[1][:, [place]]) for place in rates]
    for code, places, numbers, last in tried:
        values, units = student.values.copy(), student.units.copy()
        values[:, places], units[:, places] = numbers, last
        right = alike(printed.key, replace(student, values=values, units=units), printed.key.table)
        stood = printed.of_task[:, places]
        is_one = (right[:, places] & ~stood).sum() >= RUN and (right[:, places] | stood).mean() > _LIKE_KEY
        if right[0, :m].all() if len(places) > 1 else is_one:
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
            allowed = _QUARTER + np.nanmax(student.units[:, place])
            if not (quarters or sign < 0) or np.nanmedian(np.abs(shifts - quarters * np.pi / 2)) > allowed:
                continue
            values = student.values.copy()
            values[:, place] = sign * (values[:, place] - quarters * np.pi / 2)
            code, rate = f"origin_{key.names[place]}", key.names.index(key.variant.coordinates[place].rate)
            yield _as_euler(code, _kept(printed, printed.of_task, replace(student, values=values)))
            at_start = np.abs(2 * key.table[0, place] - quarters * np.pi / 2) <= allowed
            if sign < 0 and not (quarters and at_start):  # its velocity, too; mirrored at its start it is a sign in an equation
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
        back = near(values, key.table, tolerance[:, order]) & ~as_it_is[:, order]
        close = back | as_it_is[:, order]
        is_like = second < m and key.variant.unit_of(key.names[first]) == key.variant.unit_of(key.names[second])
        begins = is_like and close[0, pair].all() and not as_it_is[0, pair].all()
        if begins or (back[:, pair].sum() >= RUN and close[:, pair].mean() > max(_LIKE_KEY, as_it_is[:, pair].mean())):
            names = tuple(key.names[place] for place in pair)
            undone = _kept(printed, as_it_is[:, order], StudentTable(values, student.units[:, order]))
            yield _as_euler(SWAPPED_COLUMNS, undone, names)


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
