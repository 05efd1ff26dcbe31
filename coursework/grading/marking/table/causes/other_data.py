"""What a wrong table may have been made with: other data, or another table.

Enters: a `TableUnderTest`, the rubric's confusions, tables of other variants.  Leaves: `Claim`s.
Used by `hypotheses.py`, and by `misconceptions.py` for what a file's own rules refuse.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations, cycle, product

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.ways import HALF, SLACK, as_printed
from coursework.system.arrays import Array
from coursework.variant.formula.units import size_of
from coursework.variant.judging.lengths import is_refused
from coursework.variant.record.entries import Given

DATUM, DATA_ROUNDED = "datum_", "data_rounded"
FACTORS = (10.0, 0.1, 2.0, 0.5, -1.0, 0.0)
# Turns per second taken for radians per second, or centimetres or millimetres for metres, and the other way round.
_UNITS = {"1/s": (2 * np.pi, 0.5 / np.pi), "m": (100.0, 0.01, 1000.0, 0.001)}
_TURN = 2 * np.pi
OTHER_SIGN = "other sign"  # behind the value and unit of a datum that has it
# A datum is computed from the printed velocities by _ROUNDS Newton steps, with slopes over a relative difference.  A velocity
# counts if its slope is over _FELT of the largest; the value is another one if it differs by more than _ANOTHER of itself.
_ROUNDS, _DIFFERENCE, _FELT, _ANOTHER = 7, 1e-6, 1e-2, 1e-5
_SAME = 1e-9  # relative difference up to which two numbers are the same
# From this part of the velocities on that are the task's, they are looked at too.
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
        for first, second in combinations(given, 2)
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

    Velocities that are the task's say nothing: they may have been put right, and each would draw the value to the task's. Where
    they are many, a value is read off all of them too.
    """
    given = [datum for datum in printed.key.variant.given if datum.value]
    if not printed.closely or not len(given):
        return
    velocities, of_task = printed.student.values[:, printed.m :], printed.of_task[:, printed.m :]
    searches = [(np.where(of_task, np.nan, velocities), begin) for begin in _BEGINS]
    if of_task.mean() > _PUT_RIGHT:
        searches.append((velocities, 1.0))
    told: set[tuple[str, str]] = set()
    for datum, value in zip(cycle(given), _solved(printed, given, searches).tolist(), strict=False):
        shown = datum.name, f"{value:.6g}"
        if np.isfinite(value) and value * datum.value > 0 and abs(value / datum.value - 1) > _ANOTHER and shown not in told:
            told.add(shown)
            yield datum, value


def _solved(printed: TableUnderTest, given: Sequence[Given], searches: Sequence[tuple[Array, float]]) -> Array:
    """Return for each search and datum the value (s * k,) that velocities (n, r) give for it alone, NaN among them left out.

    Each search begins at a part of the task's values; away from them NaN stands where it settles on nothing.
    """
    key, task = printed.key, np.tile([datum.value for datum in given], len(searches))
    begin, velocities = (np.repeat([search[at] for search in searches], len(given), axis=0) for at in (1, 0))
    found, steps, names = begin * task, _DIFFERENCE * np.abs(task), [datum.name for datum in given] * (2 * len(searches))
    step = np.zeros(len(task))
    with np.errstate(all="ignore"):
        for _ in range(_ROUNDS):
            values = np.concatenate([found, found + steps])
            made, beside = np.split(key.sets_at(key.t, printed.q, [{one: at} for one, at in zip(names, values, strict=True)]), 2)
            slopes = np.nan_to_num((beside - made) / steps[:, None, None], posinf=0.0, neginf=0.0)
            felt = np.abs(slopes) > _FELT * np.max(np.abs(slopes), axis=(1, 2), keepdims=True)
            moves = np.where(felt, (velocities - made) / slopes, np.nan).reshape(len(task), -1)
            step = np.clip(_medians(moves), -np.abs(task), np.abs(task))
            found = found + step
    return np.where((begin == 1.0) | (np.abs(step) < _SETTLED * np.abs(task)), found, np.nan)


def _medians(rows: Array) -> Array:
    """Return the median (k,) of the finite numbers in each row (k, n), NaN if there are none."""
    ordered = np.sort(np.where(np.isfinite(rows), rows, np.inf), axis=1)
    count, every = np.isfinite(rows).sum(axis=1), np.arange(len(rows))
    return np.where(count > 0, (ordered[every, (count - 1) // 2] + ordered[every, count // 2]) / 2, np.nan)


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
