"""A fault that leaves the mechanism nearly at rest costs the same in few digits, where some coordinates seem to stand still."""

import pytest

from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.causes.test_clockwise import Desk

# The tip of an arm of two links is moved along an inclined rail; the drive begins at rest.
ARM = b"""
format = 1
title = "Arm on a rail"
source = "own"
[given]
L1 = "0.55 m"
L2 = "0.48 m"
lam = "0.35 rad"
A = "0.8 m/s"
k = "6.3 1/s"
[drive]
vP = "A*sin(k*t)"
[coordinates]
s = { start = "0.0 m", rate = "vP" }
q1 = { start = "0.25 rad", rate = "w1" }
q2 = { start = "1.95 rad", rate = "w2" }
[time]
step = "0.025 s"
end = "0.75 s"
[[constraint]]
name = "1"
because = "along"
equation = "L1*w1*sin(q1) + L2*w2*sin(q2) = -vP*cos(lam)"
[[constraint]]
name = "2"
because = "across"
equation = "L1*w1*cos(q1) + L2*w2*cos(q2) = vP*sin(lam)"
"""


@pytest.fixture(scope="module")
def desk():
    return Desk(parse_variant(ARM, "own.toml", {}))


def test_the_same_fault_costs_the_same_in_all_digits(desk):
    table = Machine(desk.variant, degrees=("drive",)).table()
    grades = [desk.graded(table, digits=digits) for digits in (4, 8)]
    assert [grade.table.misconception.code for grade in grades] == ["degree_drive"] * 2
    assert grades[0].table.share == pytest.approx(grades[1].table.share, abs=0.005)


def test_nothing_is_earned_by_a_table_that_stands_still(desk):
    table = desk.right.copy()
    table[:, : desk.machine.m] = table[0, : desk.machine.m]
    table[:, desk.machine.m :] = 0.0
    assert all(desk.graded(table, digits=digits).table.share <= 0.2 for digits in (2, 4))
