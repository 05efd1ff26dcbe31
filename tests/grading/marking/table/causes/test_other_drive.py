"""A drive by another law than the task's, printed as a column: all that follows from it is worth as much as with other data."""

import re
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.grading.marking.reasons.table import table_reasons
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.causes.claims import Claim, TableUnderTest
from coursework.grading.marking.table.causes.other_drive import other_drive
from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.machines import PULLED_BARS, SLIDER_CRANK, Machine
from tests.grading.marking.table.causes.test_clockwise import GEARED
from tests.grading.marking.table.desks import Desk, codes, with_a_steady_drive
from tests.grading.marking.table.test_cells import printed_exactly

LAWS = ["1.2*({})", "({})*(1 + 0.3*sin(5*t))", "({})**2", "({}) + 2*t", "0.7*({}) - 1"]


@pytest.fixture(scope="module", params=["slider", "steady", "geared"])
def desk(request):
    if request.param == "steady":
        return with_a_steady_drive()
    return Desk(parse_variant(SLIDER_CRANK if request.param == "slider" else GEARED, "own.toml", {}))


def with_law(desk, law):
    (name, own), *_ = desk.machine.laws.items()
    return Machine(desk.variant, drive={name: law.format(own)}).table()


@pytest.mark.long
@pytest.mark.parametrize("law", LAWS)
def test_it_is_told_and_worth_as_much_as_other_data(desk, law):
    found, marks = desk.marked(with_law(desk, law))
    told = codes(marks)
    assert told and (told[0] in {"other_drive", "other_step"} or told[0].startswith("datum_")), told
    assert found >= 23.5


@pytest.mark.long
def test_a_rate_of_the_drive_put_right_lowers_nothing(desk):
    table, right = with_law(desk, LAWS[1]), desk.machine.table()
    points, chance = desk.marked(table)[0], np.random.default_rng(2)
    place = desk.key.names.index(next(iter(desk.machine.laws)))
    for row in chance.permutation(len(table))[:6].tolist():
        table[row, place] = right[row, place]
        found = desk.marked(table)[0]
        assert found >= points - 1e-9
        points = found


@pytest.mark.long
def test_a_drive_that_is_right_is_not_suspected(desk):
    table = desk.machine.table()
    for place in range(desk.machine.m + 1, table.shape[1]):
        wrong = table.copy()
        wrong[:, place] *= 1.4
        assert "other_drive" not in codes(desk.marked(wrong)[1])


@pytest.mark.long
@pytest.mark.parametrize("digits", [2, 3])
def test_a_drive_rounded_in_another_way_is_not_suspected(desk, digits):
    """Rounded up throughout, so that each number may be off by a whole unit of its last place."""
    table = np.ceil(desk.machine.table() * 10**digits) / 10**digits
    assert "other_drive" not in codes(desk.marked(table, digits=digits)[1])


@pytest.mark.parametrize(("units", "suspected"), [(1.98, False), (-1.98, False), (2.02, True), (-2.02, True)])
def test_a_drive_is_suspected_beyond_two_units_of_its_last_place(units, suspected):
    desk = with_a_steady_drive()
    table = desk.machine.table()
    table[5, desk.key.names.index("w1")] += units * 1e-4
    assert bool([*other_drive(TableUnderTest(desk.key, printed_exactly(table)))]) is suspected


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "felt"), [(0.051, True), (-0.051, True), (0.049, False), (-0.049, False)])
def test_a_velocity_tells_the_drive_where_that_has_a_twentieth_of_its_most_in_it(size, part, felt):
    """In row 2 the drive was put right: only the other two velocities, 1.3 times the task's, can tell it."""
    driven = size * np.array([[1.0, 1.0, -1.0], [1.0, part, -part], [1.0, 0.5, 0.5]])
    own = 1.3 * driven
    own[1, 0] = driven[1, 0]
    key = SimpleNamespace(
        variant=SimpleNamespace(drive=[SimpleNamespace(name="w1")], known_rates=("w1",)), misread=lambda _: "opposite",
        velocities_at="task", velocities=("w1", "w2", "w3"),
    )  # fmt: skip
    printed = SimpleNamespace(
        key=key, closely=True, student=SimpleNamespace(values=own), m=0, q=None, w_units=np.full(own.shape, 1e-6 * size),
        stacked=lambda way: lambda _: driven if way == "task" else -driven,
        velocities=lambda found, tolerance: (found, tolerance),
        claim=lambda code, _, found: Claim(code, *found),
    )  # fmt: skip
    printed.with_spread = lambda at: (at(None), np.zeros(own.shape))
    (claim,) = other_drive(printed)
    assert claim.expected == pytest.approx(1.3 * driven if felt else np.where([[False], [True], [False]], driven, 1.3 * driven))


EXCHANGED = {"sin": "cos", "cos": "sin"}
FAULTS = {"cosine": lambda law: re.sub("sin|cos", lambda found: EXCHANGED[found[0]], law), "sign": "-({})".format}
SAID = {"cosine": "in {}, sine and cosine were exchanged.", "sign": "{} has the other sign."}


@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.parametrize("name", ["v107", pytest.param("v112", marks=pytest.mark.long), "pulled-bars"])
def test_a_slip_in_one_of_two_laws_is_told_with_its_name_and_costs_what_it_costs_in_both(name, fault):
    """Sine for cosine in one of them was not known and had nothing."""
    desk = Desk(coursework.load(name) if name.startswith("v") else parse_variant(PULLED_BARS, "own.toml", {}))
    assert codes(desk.marked(desk.machine.table())[1]) == ()
    for wrong, law in desk.machine.laws.items():
        found, marks = desk.marked(Machine(desk.variant, drive={wrong: FAULTS[fault](law)}).table(), digits=5)
        assert (codes(marks)[0], found) == (f"{fault}_{wrong}", pytest.approx(30, abs=0.5))
        told = [str(reason.text) for reason in table_reasons(desk.key, marks, Rubric(), found, 60.0)]
        assert any(text.endswith(SAID[fault].format(wrong)) for text in told)


def test_where_only_one_law_moves_the_drive_is_told():
    """In 31 the other law is 0."""
    desk = Desk(coursework.load("31"))
    for fault, wrong in FAULTS.items():
        drive = {"VMy": wrong(desk.machine.laws["VMy"])}
        assert codes(desk.marked(Machine(desk.variant, drive=drive).table())[1])[0] == f"{fault}_drive"
