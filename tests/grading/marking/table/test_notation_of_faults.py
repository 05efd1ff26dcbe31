"""The same fault costs the same in whichever unit, turned whichever way: what is unsaid is told by the whole table."""

import numpy as np
import pytest

from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import NEAR, codes, variants


def _faults(machine):
    """Give tables that are wrong in a way that has a name."""

    def heun(t, q):
        first = machine.velocities(t, q)[: machine.m]
        return machine.h / 2 * (first + machine.velocities(t + machine.h, q + machine.h * first)[: machine.m])

    yield machine.table(heun)
    start = machine.start.copy()
    start[-1] += 0.1
    yield machine.table(start=start)
    yield Machine(machine.variant, drive_sign=-1.0).table()
    exchanged = machine.table()
    exchanged[:, [0, 1]] = exchanged[:, [1, 0]]
    yield exchanged


def _columns(desk, unit):
    return [place for place, name in enumerate(desk.key.names) if desk.variant.unit_of(name) == unit]


@pytest.mark.long
@pytest.mark.parametrize(("angles", "speeds"), [(180 / np.pi, 180 / np.pi), (1.0, 30 / np.pi)], ids=["degrees", "rpm"])
def test_a_unit_that_no_head_says_costs_a_wrong_table_nothing(angles, speeds):
    desk = variants()[4]
    for table in _faults(desk.machine):
        plain, said = desk.marked(table, digits=5)
        printed = table.copy()
        printed[:, _columns(desk, "rad")] *= angles
        printed[:, _columns(desk, "rad/s")] *= speeds
        found, told = desk.marked(printed, digits=5)
        assert found == pytest.approx(plain, abs=NEAR)
        assert {*codes(said)} & {*codes(told)}


@pytest.mark.long
@pytest.mark.parametrize("mirrored", [False, True])
def test_a_wrong_table_counted_clockwise_earns_what_it_earns(mirrored):
    desk = variants()[4]
    for table in (Machine(desk.variant, data={"l": 1.26}).table(), next(_faults(desk.machine))):
        plain, _ = desk.marked(table, digits=5)
        printed = table.copy()
        printed[:, _columns(desk, "rad/s")] *= -1
        if mirrored:
            turning = _columns(desk, "rad")
            printed[:, turning] = 2 * table[0, turning] - table[:, turning]
        assert desk.marked(printed, digits=5)[0] == pytest.approx(plain, abs=NEAR)


def test_an_angle_from_another_axis_costs_the_same_in_degrees():
    desk = variants()[4]
    table = desk.machine.table()
    table[:, 0] += np.pi / 2
    radians, _ = desk.marked(table)
    table[:, _columns(desk, "rad")] *= 180 / np.pi
    assert desk.marked(table, digits=3)[0] == pytest.approx(radians, abs=0.01)


@pytest.mark.long
@pytest.mark.parametrize("is_put_right", [False, True])
def test_degrees_for_radians_cost_the_same_if_the_angles_are_printed_within_a_turn(is_put_right):
    """Sines of degrees have no period of a turn: the velocities are explained only by the angles that they were computed with."""
    desk = variants()[5]
    table = Machine(desk.variant, degrees=("drive", "geometry")).table()
    turning = _columns(desk, "rad")
    table[:, turning] = (table[:, turning] + np.pi) % (2 * np.pi) - np.pi
    if is_put_right:
        table[4, 0] = desk.key.table[4, 0]  # in the row before the angle leaves its turn
    found, told = desk.marked(table)
    assert found == pytest.approx(24, abs=0.3)
    assert codes(told)[0] == "degree_mode"


def test_ten_times_the_speed_of_a_drive_is_not_read_as_turns_per_minute():
    """With a small part that is not ten times as large the drive is nearer to 9.55 times the task's; its steps tell its unit."""
    desk = variants()[4]
    table = Machine(desk.variant, data={"w0": 10 * desk.variant.values["w0"]}).table()
    found, told = desk.marked(table)
    assert found == pytest.approx(57, abs=0.3)
    assert codes(told)[0] == "datum_w0"
    right = desk.machine.table()
    right[:, _columns(desk, "rad/s")] *= 30 / np.pi
    assert desk.marked(right)[0] == 60
