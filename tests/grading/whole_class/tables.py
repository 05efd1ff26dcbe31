"""Tables of any mechanism with a known fault, made by `Machine`, a program of its own; where a table contradicts itself.

Enters: a `Machine`, a seeded generator.  Leaves: tables (n, m + r) by the code of their misconception.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import sign_faults

Make = Callable[[], np.ndarray]


def slopes(machine, t, q):
    return machine.velocities(t, q)[: machine.m]


def _heun(machine, t, q):
    h, first = machine.h, slopes(machine, t, q)
    return h / 2 * (first + slopes(machine, t + h, q + h * first))


def _midpoint(machine, t, q):
    h = machine.h
    return h * slopes(machine, t + h / 2, q + h / 2 * slopes(machine, t, q))


def _rk4(machine, t, q, h=0.0):
    h = h or machine.h
    k1 = slopes(machine, t, q)
    k2 = slopes(machine, t + h / 2, q + h / 2 * k1)
    k3 = slopes(machine, t + h / 2, q + h / 2 * k2)
    return h / 6 * (k1 + 2 * k2 + 2 * k3 + slopes(machine, t + h, q + h * k3))


def _exact(machine, t, q):
    part, moved = machine.h / 50, q
    for k in range(50):
        moved = moved + _rk4(machine, t + k * part, moved, part) if k else q + _rk4(machine, t, q, part)
    return moved - q


def _implicit(machine, old):
    """A step with the velocities of the new row, `old` of it with those of the row before, by repetition until it stands."""

    def increment(t, q):
        h, first = machine.h, slopes(machine, t, q)
        moved = q + h * first
        for _ in range(80):
            moved = q + h * (old * first + (1 - old) * slopes(machine, t + h, moved))
        return moved - q

    return increment


def _of_both_rows(machine, old):
    """The table of implicit steps, NaN where one has no solution."""
    table, m = machine.table(_implicit(machine, old)), machine.m
    steps = machine.h * (old * table[:-1, m : 2 * m] + (1 - old) * table[1:, m : 2 * m])
    return table if np.allclose(np.diff(table[:, :m], axis=0), steps, atol=1e-7) else np.full_like(table, np.nan)


def from_rows_before(machine):
    """The table whose steps use the velocities of the row before the one that they start from."""
    rates = []

    def increment(t, q):
        rates.append(slopes(machine, t, q))
        return machine.h * rates[max(len(rates) - 2, 0)]

    return machine.table(increment)


def _signed(machine, place):
    def printed(t, q):
        w = machine.velocities(t, q)
        w[place] *= -1
        return w

    return printed


def _of_the_row_above(machine, place):
    above = []

    def printed(t, q):
        w = machine.velocities(t, q)
        above.append(w[place])
        w[place] = above[max(len(above) - 2, 0)]
        return w

    return printed


def faults(machine: Machine) -> Iterator[tuple[str, Make]]:
    """Give what makes tables with one misconception each."""
    variant, h, m = machine.variant, machine.h, machine.m
    names = [*(c.name for c in variant.coordinates), *variant.columns[m:]]
    for code, step in (("heun", _heun), ("midpoint", _midpoint), ("rk4", _rk4), ("exact", _exact)):
        yield code, lambda step=step: machine.table(lambda t, q: step(machine, t, q))
    yield "trapezoid", lambda: _of_both_rows(machine, 0.5)
    yield "backward", lambda: _of_both_rows(machine, 0.0)
    yield "row_before", lambda: from_rows_before(machine)
    yield "time_ahead", lambda: machine.table(printed=lambda t, q: machine.velocities(t + h, q))
    yield "time_behind", lambda: machine.table(printed=lambda t, q: machine.velocities(t - h, q))
    yield "step_ahead", lambda: machine.table(lambda t, q: h * slopes(machine, t + h, q))
    yield "step_behind", lambda: machine.table(lambda t, q: h * slopes(machine, t - h, q))
    yield "omega_late", lambda: _moved_velocities(machine, 1)
    yield "omega_early", lambda: _moved_velocities(machine, -1)
    yield "rounded_omega_1", lambda: machine.table(lambda t, q: h * np.round(slopes(machine, t, q), 1))
    for part in (0.5, 2.0):
        yield "other_step", lambda part=part: machine.table(lambda t, q: part * h * slopes(machine, t, q))
    for code, where in (("degree_mode", ("drive", "geometry")), ("degree_drive", ("drive",)), ("degree_geometry", ("geometry",))):
        yield code, Machine(variant, degrees=where).table
    yield "sign_drive", Machine(variant, drive_sign=-1.0).table
    for place in (place for place, name in enumerate(names[m:]) if name in variant.sought):
        yield f"sign_{names[m + place]}", lambda place=place: machine.table(printed=_signed(machine, place))
        yield f"row_above_{names[m + place]}", lambda place=place: machine.table(printed=_of_the_row_above(machine, place))
    lengths = [given for given in variant.given if given.si == "m"]
    for given in lengths[:2]:
        yield f"datum_{given.name}", Machine(variant, data={given.name: 2 * given.value}).table
    first, second = lengths[:2]
    swapped = {first.name: second.value, second.name: first.value}
    yield f"swap_{first.name}_{second.name}", Machine(variant, data=swapped).table
    angles = [place for place, c in enumerate(variant.coordinates) if c.unit == "rad"]
    order = [*range(len(names))]
    order[angles[0]], order[angles[1]] = order[angles[1]], order[angles[0]]
    yield "swapped_columns", lambda: machine.table()[:, order]
    for place in angles[-2:]:
        yield f"origin_{names[place]}", lambda place=place: machine.table() + np.pi / 2 * (np.arange(len(names)) == place)
    for place, c in enumerate(variant.coordinates):
        if c.rate not in variant.known_rates:
            yield f"start_{c.name}", lambda place=place: machine.table(start=machine.start + 0.1 * (np.arange(m) == place))
    yield "rows_shifted", lambda: np.vstack([machine.table()[:9], machine.table()[8:]])[: machine.rows]


def _moved_velocities(machine: Machine, by: int) -> np.ndarray:
    right, m = machine.table(), machine.m
    moved = right.copy()
    moved[max(by, 0) : len(right) + min(by, 0), m:] = right[max(-by, 0) : len(right) - max(by, 0), m:]
    return moved


def slips_of_equations(machine: Machine) -> Iterator[tuple[str, str, Make]]:
    """Give the name of an equation, its line with one sign turned, and what makes the table that follows from it."""
    for constraint in machine.variant.constraints:
        for text in sign_faults(constraint):
            yield constraint.name, f"{text} = 0", Machine(machine.variant, lines={constraint.name: text}).table


def is_a_table(table: np.ndarray, machine: Machine) -> bool:
    """Return whether a fault makes a table that a person would hand in, and another than the right one."""
    return bool(np.isfinite(table).all()) and np.abs(table).max() < 1e3 and not np.allclose(table, machine.table(), atol=1e-4)


def against_itself(machine: Machine, table: np.ndarray, unit: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return which cells of a printed table surely do not follow from others in it, and which surely do (n, m + r).

    A velocity follows from the row's own angles, or fulfils an equation with the other velocities of the row; a coordinate
    follows from the row before, by the velocity that stands there or that belongs there; either is right where the key says so.
    The tolerances are those of printing with `unit` (m + r) of the last places, several times over for "surely not".
    """
    m, h, right = machine.m, machine.h, machine.table()
    off, tolerance = np.abs(table - right), 2e-4 * np.ptp(right, axis=0) + 2 * unit
    surely = off < 0.2 * tolerance
    not_so = off > 6 * tolerance
    before = doubt = np.zeros(0)
    for k, row in enumerate(table):
        q, w = row[:m], row[m:]
        made = machine.velocities(k * h, q)
        slack = sum(np.abs(machine.velocities(k * h, q + unit[:m] * (np.arange(m) == place)) - made) for place in range(m))
        near = tolerance[m:] + slack
        surely[k, m:] |= np.abs(w - made) < 0.2 * near
        held = machine.fulfilled(k * h, q, w, unit[m:] + 2e-4 * np.abs(w))
        not_so[k, m:] &= (np.abs(w - made) > 6 * near) & ~held
        if k:
            steps = [table[k - 1, :m] + h * rates[:m] for rates in (table[k - 1, m:], before)]
            slip = np.min([np.abs(q - step) for step in steps], axis=0)
            near = 2 * unit[:m] + 3e-4 * h * np.abs(table[k - 1, m : 2 * m]) + h * (unit[m : 2 * m] + doubt[:m])
            surely[k, :m] |= slip < 0.2 * near
            not_so[k, :m] &= slip > 6 * near
        before, doubt = made, slack
    return not_so, surely
