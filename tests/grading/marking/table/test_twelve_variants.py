"""The same fault costs the same over twelve variants of a template: in an equation in every notation, in every kind of table."""

from collections import defaultdict
from functools import cache

import numpy as np
import pytest

import coursework
from coursework.grading.marking.equations.equations import Judge
from coursework.grading.reading.equations.lines import read_lines
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import NEAR, Desk, close, sign_faults
from tests.grading.reading.equations.notation.notations import NOTATIONS, PLAIN, slips

OF_EQUATIONS = 40
# Templates whose data can be drawn, how many variants, every which slip of their equations.
MANY = [
    pytest.param("31", 2, 40),
    *(pytest.param(name, 12, 1, marks=pytest.mark.long) for name in ("31", "v102", "v107")),
]
BLOWN_UP = 1e3


@cache
def desk_of(template, number):
    return Desk(coursework.draw(template, template, "twelve", f"student{number}"))


def desks(template, count):
    return [desk_of(template, number) for number in range(count)]


@pytest.mark.long
@pytest.mark.parametrize(("template", "count", "every"), MANY)
def test_a_slip_in_an_equation_costs_the_same_in_every_notation(template, count, every):
    judges = [(Judge(desk.key), desk.expected) for desk in desks(template, count)]
    for turn, wrong in enumerate([*slips(PLAIN[template])][::every]):
        points = {}
        for place, (notation, form) in enumerate(NOTATIONS.items()):
            judge, expected = judges[(place + turn) % count]
            found = judge.mark(read_lines(form(wrong), "equations.txt", expected).equations)
            points[notation] = OF_EQUATIONS * found.share
        assert max(points.values()) - min(points.values()) <= NEAR, (wrong, points)


def faulty(desk):
    """Give tables by their fault: another start, degrees, schemes, steps, a sign of the drive, of a term, a slip in a row."""
    machine, m, h = desk.machine, desk.machine.m, desk.machine.h

    def at(t, q):
        return machine.velocities(t, q)[:m]

    for place in range(m):
        start = machine.start.copy()
        start[place] += 0.1
        yield f"start {place}", machine.table(start=start)
    for where in (("drive",), ("geometry",), ("drive", "geometry")):
        yield f"degrees in {where}", Machine(desk.variant, degrees=where).table()
    yield "heun", machine.table(lambda t, q: h / 2 * (at(t, q) + at(t + h, q + h * at(t, q))))
    yield "midpoint", machine.table(lambda t, q: h * at(t + h / 2, q + h / 2 * at(t, q)))
    yield "half the step", machine.table(step=h / 2, rows=2 * machine.rows - 1)[::2]
    yield "twice the step", machine.table(lambda t, q: 2 * h * at(t, q))
    yield "sign of the drive", Machine(desk.variant, drive_sign=-1.0).table()
    for given in desk.variant.given:
        yield f"{given.name} twice", Machine(desk.variant, data={given.name: 2 * given.value}).table()
    for row in (3, machine.rows // 2, machine.rows - 4):
        for place in range(len(desk.key.names)):
            yield f"slip {place}", machine.table(slip=(row, place, 0.15))
    for constraint in desk.variant.constraints:
        for number, text in enumerate(sign_faults(constraint)):
            yield f"sign {number} of {constraint.name}", Machine(desk.variant, lines={constraint.name: text}).table()


@pytest.mark.long
def test_a_column_that_is_wrong_throughout_costs_the_same_however_near_the_others_stay():
    """A bar twice as long halves its own rate; the others stay the task's to the last digit in a few rows, or in nearly all."""
    tables = [(desk, Machine(desk.variant, data={"r2": 2 * desk.variant.values["r2"]}).table()) for desk in desks("31", 2)]
    close([desk.marked(table)[0] for desk, table in tables])


@pytest.mark.long
@pytest.mark.parametrize("template", ["31", "v102"])
def test_a_fault_of_a_table_costs_the_same_in_twelve_variants(template):
    points = defaultdict(list)
    for desk in desks(template, 12):
        right = desk.machine.table()
        for fault, table in faulty(desk):
            if np.isfinite(table).all() and np.abs(table).max() < BLOWN_UP and not np.allclose(table, right):
                points[fault].append(desk.marked(table)[0])
    for fault, found in points.items():
        assert len(found) > 1, fault
        close(found)
