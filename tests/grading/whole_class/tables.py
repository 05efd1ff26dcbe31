"""Tables of any mechanism with a known fault, made by `Machine`, a program of its own; and where a table first contradicts itself.

Enters: a `Machine`, a seeded generator.  Leaves: tables (n, m + r) by the code of their misconception.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from coursework.variant.formula.tree import spelled
from tests.grading.marking.machines import Machine
from tests.grading.marking.test_equal_faults import sign_faults


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


def _signed(machine, place):
    def printed(t, q):
        w = machine.velocities(t, q)
        w[place] *= -1
        return w

    return printed


def faults(machine: Machine) -> Iterator[tuple[str, np.ndarray]]:
    """Give tables with one misconception each."""
    variant, h, m, right = machine.variant, machine.h, machine.m, machine.table()
    names = [*(c.name for c in variant.coordinates), *variant.columns[m:]]
    for code, step in (("heun", _heun), ("midpoint", _midpoint), ("rk4", _rk4), ("exact", _exact)):
        yield code, machine.table(lambda t, q, step=step: step(machine, t, q))
    yield "trapezoid", machine.table(_implicit(machine, 0.5))
    yield "backward", machine.table(_implicit(machine, 0.0))
    yield "time_ahead", machine.table(printed=lambda t, q: machine.velocities(t + h, q))
    yield "time_behind", machine.table(printed=lambda t, q: machine.velocities(t - h, q))
    late, early = right.copy(), right.copy()
    late[1:, m:], early[:-1, m:] = right[:-1, m:], right[1:, m:]
    yield from (("omega_late", late), ("omega_early", early))
    yield "rounded_omega_1", machine.table(lambda t, q: h * np.round(slopes(machine, t, q), 1))
    for part in (0.5, 2.0):
        yield "other_step", machine.table(lambda t, q, part=part: part * h * slopes(machine, t, q))
    for code, where in (("degree_mode", ("drive", "geometry")), ("degree_drive", ("drive",)), ("degree_geometry", ("geometry",))):
        yield code, Machine(variant, degrees=where).table()
    yield "sign_drive", Machine(variant, drive_sign=-1.0).table()
    sought = [place for place, name in enumerate(names[m:]) if name in variant.sought]
    for place in sought:
        yield f"sign_{names[m + place]}", machine.table(printed=_signed(machine, place))
    lengths = [given for given in variant.given if given.si == "m"]
    for given in lengths[:2]:
        yield f"datum_{given.name}", Machine(variant, data={given.name: 2 * given.value}).table()
    first, second = lengths[:2]
    swapped = {first.name: second.value, second.name: first.value}
    yield f"swap_{first.name}_{second.name}", Machine(variant, data=swapped).table()
    angles = [place for place, c in enumerate(variant.coordinates) if c.unit == "rad"]
    order = [*range(len(names))]
    order[angles[0]], order[angles[1]] = order[angles[1]], order[angles[0]]
    yield "swapped_columns", right[:, order]
    for place in angles[-2:]:
        moved = right.copy()
        moved[:, place] += np.pi / 2
        yield f"origin_{names[place]}", moved
    for place, c in enumerate(variant.coordinates):
        if c.rate not in variant.known_rates:
            start = machine.start.copy()
            start[place] += 0.1
            yield f"start_{c.name}", machine.table(start=start)
    yield "rows_shifted", np.vstack([right[:9], right[8:]])[: machine.rows]


def slips_of_equations(machine: Machine) -> Iterator[tuple[str, str, np.ndarray]]:
    """Give the name of an equation, its line with one sign turned, and the table that follows from it."""
    right = machine.table()
    for constraint in machine.variant.constraints:
        for text in sign_faults(constraint):
            if text.replace(" ", "") == f"{spelled(constraint.left)}-({spelled(constraint.right)})".replace(" ", ""):
                continue
            table = Machine(machine.variant, lines={constraint.name: text}).table()
            if np.isfinite(table).all() and np.abs(table).max() < 1e3 and not np.allclose(table, right):
                yield constraint.name, f"{text} = 0", table


def against_itself(machine: Machine, table: np.ndarray, unit: float) -> tuple[np.ndarray, np.ndarray]:
    """Return which cells of a printed table surely do not follow from others in it, and which surely do (n, m + r).

    A velocity follows from the row's own angles, a coordinate from the row before; the tolerances are those of printing, several
    times over for "surely not".
    """
    m, h, right = machine.m, machine.h, machine.table()
    spread = np.abs(right).max(axis=0)
    near = 2e-4 * spread + 2 * unit
    off = np.zeros_like(table)
    slack = np.zeros_like(table)
    for k, row in enumerate(table):
        expected = machine.velocities(k * h, row[:m])
        off[k, m:] = np.abs(row[m:] - expected)
        for place in range(m):
            moved = row[:m].copy()
            moved[place] += unit
            slack[k, m:] += np.abs(machine.velocities(k * h, moved) - expected)
        off[k, :m] = np.abs(row[:m] - (machine.start if not k else table[k - 1, :m] + h * table[k - 1, m : 2 * m]))
    tolerance = near + slack
    tolerance[:, :m] = 2 * unit + 3e-4 * h * np.abs(table[:, m : 2 * m]) + h * unit
    by_key = np.abs(table - right)
    least = np.minimum(off, by_key)
    return least > 6 * tolerance, least < 0.2 * tolerance
