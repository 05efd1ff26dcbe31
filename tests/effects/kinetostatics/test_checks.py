"""The checks of forces on rows made by hand: a share on each side of its limit, the row and the column that are told."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.effects.kinetostatics import checks
from coursework.effects.kinetostatics.checks import _accuracy, _agreement, _balance, _condition, _contact, _friction
from coursework.effects.kinetostatics.kinetostatics import _across, solve
from tests.effects.massed import of_text
from tests.mechanisms.library import mechanism

NAN = math.nan


@pytest.mark.parametrize(("share", "verdict"), [(0.99e-10, "PASS"), (1.01e-10, "FAIL")])
def test_two_ways_agree_to_a_share_of_the_largest(share, verdict):
    """20 is the largest of all; the third row of the second column is off; what is not known in one way is not compared."""
    found = np.array([[1.0, 2.0], [NAN, 4.0], [5.0, 6.0]])
    other = found + np.array([[0.0, 0.0], [9.0, 0.0], [0.0, -20 * share]])
    told = _agreement(found, other, ("R01", "M"), 20.0, "GROUPS")
    assert (told.verdict, told.row, told.column, told.value) == (verdict, 3, "M", pytest.approx(share, rel=1e-3))
    assert told.limit == 1e-10
    for way, largest in ((None, 20.0), (found * NAN, 20.0), (found, 0.0)):
        assert _agreement(way, other, ("R01", "M"), largest, "GROUPS").verdict == "SKIP"


@pytest.mark.parametrize(("right", "found"), [(0.0, [3.0, NAN]), (1.0, [NAN, NAN])])
def test_a_row_in_which_forces_are_not_unique_leaves_the_others_their_digits(right, found):
    """0 x = 0 leaves x open, 0 x = 1 cannot be; the row beside it was told to have no digits either."""
    values, condition = solve(np.array([np.diag([1.0, 0.0]), np.diag([2.0, 4.0])]), np.array([[3.0, right], [4.0, 8.0]]))
    assert values[0] == pytest.approx(found, nan_ok=True) and values[1].tolist() == [2.0, 2.0]
    assert condition.tolist() == [math.inf, 2.0]


def moved(power, count=9, spoilt=None, pieces=()):
    """Return an analysis over which T grows by t^2/2 joules, so that t watts are needed, and `power` is given."""
    t = 0.1 * np.arange(count)
    energy = SimpleNamespace(
        kinetic=t**2 / 2, potential=2.0 * t, drive=t + 2.0 + power(t), loads=np.full(count, 3.0), friction=np.full(count, -1.0),
        dampers=np.full(count, -2.0),
    )  # fmt: skip
    if spoilt is not None:
        energy.drive[spoilt] = NAN
    variant = SimpleNamespace(laws=[SimpleNamespace(pieces=[(time, None) for time in pieces])])
    return SimpleNamespace(
        rows=SimpleNamespace(motion=SimpleNamespace(t=t)), energy=energy,
        equations=SimpleNamespace(variant=variant),
    )  # fmt: skip


def one(place, size):
    return lambda t: np.where(np.arange(len(t)) == place, size, 0.0)


def test_power_given_is_the_change_of_energy_to_a_thousandth_of_the_largest():
    """The largest is what changes in all at the end: 0.8 + 2 = 2.8 W."""
    for size, verdict in ((0.99e-3, "PASS"), (1.01e-3, "COARSE"), (-0.99e-3, "PASS"), (-1.01e-3, "COARSE")):
        told = _balance(moved(one(4, 2.8 * size)), None)
        assert (told.verdict, told.row, told.value) == (verdict, 5, pytest.approx(abs(size), rel=1e-6))
    assert (
        _balance(moved(one(1, 9.0)), None).verdict == "PASS" == _balance(moved(one(7, 0.1)), None).verdict
    )  # at the ends nothing is read
    assert [_balance(moved(one(4, 0.0), count), None).verdict for count in (4, 5)] == ["SKIP", "PASS"]
    assert _balance(moved(one(4, 0.0), spoilt=3), None).verdict == "PASS"  # a row without a drive says nothing of the others
    assert _balance(moved(one(4, 9.0), spoilt=4), None).verdict == "PASS"
    assert {_balance(moved(one(2, 0.0), 5, rows), None).verdict for rows in (2, slice(None))} == {"SKIP"}
    assert _balance(moved(one(4, 9.0)), moved(one(4, 0.0))).verdict == "PASS"  # the exact rows are looked at
    still = moved(lambda t: -t - 2.0)
    still.energy.kinetic, still.energy.potential = np.zeros(9), np.zeros(9)
    still.energy.loads = still.energy.friction = still.energy.dampers = np.zeros(9)
    assert _balance(still, None).verdict == "SKIP"


@pytest.mark.parametrize(("at", "place", "verdict"), [
    (0.4, 3, "PASS"), (0.4, 4, "PASS"), (0.4, 5, "PASS"), (0.4, 2, "COARSE"), (0.4, 6, "COARSE"), (0.39, 2, "PASS"),
    (0.39, 6, "COARSE"),
])  # fmt: skip
def test_across_a_change_of_formula_power_is_not_judged(at, place, verdict):
    """A row nearer to it than two steps has rows of both formulas among its five."""
    assert _balance(moved(one(place, 1.0), pieces=[0.0, at]), None).verdict == verdict
    assert _balance(moved(one(4, 1.0), count=6, pieces=[0.25]), None).verdict == "SKIP"


@pytest.mark.parametrize(("at", "heavy", "blows"), [
    ([2.0], True, [2.0]), ([3.0], True, []), ([2.5, 3.0, 1.0], True, [1.0, 2.5]), ([], True, []), ([2.0], False, []),
    ([2.2], True, []),
])  # fmt: skip
def test_a_jump_of_the_drive_between_the_ends_is_a_blow_to_masses(at, heavy, blows, monkeypatch):
    """In a run of 3 s the drive jumps by 1 wherever its formula changes but at 2.2 s; its largest value is 5."""
    monkeypatch.setattr(checks, "breaks", lambda _: sorted(at))
    level = lambda t: 5.0 - sum((t > one) * (1.0 if one != 2.2 else 1e-12) for one in at)  # noqa: E731
    monkeypatch.setattr(checks, "drive_values", lambda _, names, times: level(np.asarray(times, dtype=float))[:, None])
    variant = SimpleNamespace(drive=[SimpleNamespace(name="w")])
    forces = SimpleNamespace(masses=[1] if heavy else [])
    rows = SimpleNamespace(motion=SimpleNamespace(t=np.arange(4.0)), scheme=SimpleNamespace(forces=forces))
    assert checks._blows(SimpleNamespace(equations=SimpleNamespace(variant=variant), rows=rows)) == blows


def rolling(**columns):
    rows = np.column_stack(list(columns.values()))
    return SimpleNamespace(
        reactions=SimpleNamespace(names=tuple(columns), rows=rows), column=lambda name: np.array(columns[name], dtype=float)
    )


@pytest.mark.parametrize(("columns", "told"), [
    ({"N1": [10, 5], "T1": [-2, 2]}, ("pass", "N1", 0.4, 2, 0)), ({"N1": [10, -5], "T1": [1, 1]}, ("lifts", "N1", 0.2, 2, 1)),
    ({"N1": [10, 0.0], "T1": [1, 1]}, ("bare", "N1", None, 2, 1)), ({"N1": [10, 0.0], "T1": [1, 0]}, ("pass", "N1", 0.1, 1, 0)),
    ({"N1": [NAN, 5], "T1": [NAN, 1]}, ("pass", "N1", 0.2, 2, 0)), ({"N1": [NAN, NAN], "T1": [1, 1]}, "open"),
    ({"N1": [10, 5], "T1": [9, 1], "N2": [-1, 4], "T2": [0, 0]}, ("lifts", "N2", 0.0, 1, 1)),
    ({"N1": [10, 5], "T1": [1, 1], "N2": [4, 4], "T2": [1, 2]}, ("pass", "N2", 0.5, 2, 0)),
    ({"N1": [10, 5], "R01": [1, 1]}, "skip"), ({"R1": [10, 5], "T1": [1, 1]}, "skip"), ({"N1": [], "T1": []}, "skip"),
])  # fmt: skip
def test_of_several_contacts_the_one_that_lifts_is_told_else_the_one_that_rubs_most(columns, told):
    found = _contact(rolling(**columns), None)
    if isinstance(told, str):
        assert (found.verdict, found.sentence.key) == ("SKIP", f"check.CONTACT.{told}")
        return
    key, name, share, row, count = told
    values = found.sentence.values
    assert (found.sentence.key, found.column, found.value, found.row) == (
        f"check.CONTACT.{key}",
        name,
        share and pytest.approx(share),
        row,
    )
    assert (values["count"], values["least"], values["most"], values["number"]) == (
        count,
        np.nanmin(columns[name]),
        np.nanmax(columns[name]),
        np.isfinite(columns[name]).sum(),
    )


@pytest.mark.parametrize(("condition", "verdict", "digits", "row"), [
    ([10.0, 1e10], "PASS", 6.0, 2), ([1.3e10, 1.0], "COARSE", 5.8, 1), ([1e17], "COARSE", 0.0, 1),
    ([5.0, math.inf], "COARSE", 0.0, 2),
])  # fmt: skip
def test_six_digits_are_to_be_left(condition, verdict, digits, row):
    found = _condition(SimpleNamespace(reactions=SimpleNamespace(condition=np.array(condition))), None)
    assert (found.verdict, found.value, found.row) == (verdict, pytest.approx(digits), row)


def test_no_rows_and_reactions_that_are_not_unique_have_no_digits():
    reactions = SimpleNamespace(
        condition=np.array([NAN, NAN]),
        names=("R1", "R2", "M"),
        rows=np.array([[1.0, NAN, 3.0], [1.0, 2.0, 3.0]]),
        matrix=np.zeros((2, 2, 3)),
    )
    found = _condition(SimpleNamespace(reactions=reactions), None)
    assert (found.verdict, found.sentence.values) == ("SKIP", {"names": ("R2",), "number": 3, "count": 2})
    assert _condition(SimpleNamespace(reactions=SimpleNamespace(condition=np.zeros(0))), None).verdict == "SKIP"


def driven(largest=10.0, **columns):
    names = tuple(columns)
    return SimpleNamespace(
        drive_names=names, names=names, units=("N·m",) * len(names), reactions=SimpleNamespace(largest=largest),
        rows=SimpleNamespace(count=len(next(iter(columns.values()), []))),
        column=lambda name: np.array(columns[name], dtype=float),
    )  # fmt: skip


@pytest.mark.parametrize(("off", "verdict"), [(0.099, "PASS"), (0.101, "COARSE"), (-0.099, "PASS"), (-0.101, "COARSE")])
def test_a_drive_is_as_far_from_what_is_needed_as_the_largest_row_of_it_says(off, verdict):
    """A twentieth of 2 N m; of two drives the one that is further off in size; rows that the exact motion lacks are left out."""
    own, exact = driven(M1=[1.0, 1.0, 9.0], M2=[NAN, -2.0 + off, 9.0]), driven(M1=[1.01, 1.0], M2=[0.0, -2.0])
    found = _accuracy(own, exact)
    assert (found.verdict, found.column, found.row, found.value) == (verdict, "M2", 2, pytest.approx(abs(off) / 2))
    values = found.sentence.values
    assert (values["found"], values["true"], values["unit"]) == (pytest.approx(-2 + off), -2.0, "N·m")


def test_where_nothing_drives_or_nothing_is_known_no_drive_is_judged():
    own = driven(M=[1.0, 1.0])
    assert [_accuracy(own, exact).verdict for exact in (own, None, driven(0.0, M=[1.0, 1.0]))] == ["SKIP"] * 3
    assert _accuracy(driven(), driven(M=[1.0])).verdict == "SKIP"
    assert (
        _accuracy(own, driven(M=[0.9e-9, 0.0])).verdict == "SKIP" and _accuracy(own, driven(M=[1.1e-9, 0.0])).verdict == "COARSE"
    )


def rubbed(rows, condition=(1.0, 1.0, 1.0), power=(-1.0, -3.0, -2.0)):
    return SimpleNamespace(
        rows=SimpleNamespace(scheme=SimpleNamespace(forces=SimpleNamespace(friction=("pair",))), count=3),
        reactions=SimpleNamespace(rows=np.array(rows, dtype=float), condition=np.array(condition), friction=()),
        energy=SimpleNamespace(friction=np.array(power)),
    )  # fmt: skip


@pytest.mark.parametrize(("given", "verdict", "key", "row"), [
    (rubbed([[1, 2]] * 3), "PASS", "pass", 2), (rubbed([[1, 2], [NAN, NAN], [NAN, NAN]]), "FAIL", "locked", 2),
    (rubbed([[1, NAN]] * 3), "PASS", "pass", 2),
    (rubbed([[1, 2], [NAN, NAN], [1, 2]], condition=(1.0, NAN, 1.0)), "SKIP", "not_unique", None),
])  # fmt: skip
def test_friction_locks_where_no_force_settles(given, verdict, key, row):
    found = _friction(given, None)
    assert (found.verdict, found.sentence.key, found.row) == (verdict, f"check.FRICTION.{key}", row)
    if verdict == "PASS":
        assert (found.sentence.values["power"], found.sentence.values["row"]) == (3.0, 2)
    if verdict == "FAIL":
        assert (found.sentence.values["count"], found.sentence.values["number"], found.sentence.values["row"]) == (2, 3, 2)


def test_a_pair_that_stands_is_told_with_its_first_row(monkeypatch):
    monkeypatch.setattr("coursework.effects.friction.friction.standing", lambda found: np.array([False, True, True]))
    found = _friction(rubbed([[1, 2]] * 3), None)
    assert (found.sentence.key, found.sentence.values["count"], found.sentence.values["still"]) == ("check.FRICTION.still", 2, 2)


@pytest.mark.parametrize(("left", "largest", "spoilt", "verdict"), [
    (0.99e-9, 10.0, False, "PASS"), (1.01e-9, 10.0, False, "FAIL"), (0.0, 0.0, False, "SKIP"), (0.0, 10.0, True, "SKIP"),
])  # fmt: skip
def test_what_is_left_of_all_forces_is_a_share_of_the_largest_moments_over_the_length(
    monkeypatch, left, largest, spoilt, verdict
):
    """A mechanism 0.5 m long: half of a moment counts, in row 2."""
    monkeypatch.setattr(checks, "outer_sum", lambda own: np.array([[0.0, 0.0, 0.0], [left / 2, 0.0, -left / 2], [0.0, 0.0, 0.0]]))
    reactions = SimpleNamespace(rows=np.array([[NAN if spoilt else 1.0, 2.0]]), largest=largest)
    found = checks._sum(SimpleNamespace(reactions=reactions, rows=SimpleNamespace(length=0.5)), None)
    assert found.verdict == verdict
    if largest and not spoilt:
        assert (found.row, found.value) == (2, pytest.approx(left / largest))


@pytest.mark.parametrize(("after", "is_blow"), [("w0", False), ("w0 + 5*(t - 0.3)", False), ("1.00001*w0", True), ("0", True)])
def test_a_drive_that_jumps_is_told_as_a_blow_first_of_all(after, is_blow):
    """A crank that changes its speed at once needs more than any force; one that changes its acceleration does not."""
    pieces = f'{{ pieces = [["0 s", "w0"], ["0.3 s", "{after}"]] }}'
    run = coursework.solve(coursework.parse_variant(mechanism("example-1-forces", w1=pieces)))
    assert run.summary.startswith("At t = 0.3 s the drive jumps, and the velocities with it: a blow acts") == is_blow
    assert ("jumps" in run.summary) == is_blow


@pytest.mark.parametrize(("first", "second"), [("0", "w0*(t - 0.3)*a"), ("w0*(t - 0.3)*a", "0"), ("0", "w0*sin(t - 0.3)^2")])
def test_a_drive_that_starts_from_rest_or_comes_to_rest_evenly_is_no_blow(first, second):
    """Near the break the drive is as good as zero on both sides, so a change there is no share of what it is there."""
    pieces = f'{{ pieces = [["0 s", "{first}"], ["0.3 s", "{second}"]] }}'
    run = coursework.solve(
        coursework.parse_variant(mechanism("example-1-forces", w1=pieces).replace("[given]", '[given]\na = "2 1/s"'))
    )
    assert "jumps" not in run.summary and "blow" not in run.summary


@pytest.mark.parametrize("rows", [36, 360])
def test_power_is_not_read_across_a_row_on_which_the_drive_jumps(rows):
    """The row on the jump has the energy behind it: the five rows that end there would show a change that no power makes."""
    text = mechanism("example-1-forces", w1='{ pieces = [["0 s", "w0"], ["pi/w0", "w0/2"]] }')
    run = coursework.solve(coursework.parse_variant(text), step=2 * np.pi / 10 / rows)
    (power,) = [one for one in run.checks if one.code == "POWER"]
    assert power.value < 0.02 * (36 / rows) ** 4


def test_a_blow_is_told_where_too_few_rows_show_power():
    """Four rows, three thirds of the time: the crank changes its speed at the second one."""
    pieces = '{ pieces = [["0 s", "w0"], ["0.05 s", "w0/2"]] }'
    run = coursework.solve(coursework.parse_variant(mechanism("example-1-forces", w1=pieces)), step=0.05, end=0.15)
    assert {one.code: one.verdict for one in run.checks}["POWER"] == "SKIP"
    assert run.summary.startswith("At t = 0.05 s the drive jumps, and the velocities with it: a blow acts")


@pytest.mark.parametrize("degrees", range(0, 180, 15))
def test_a_force_of_which_one_component_is_known_is_told_along_it_upwards_or_to_the_right(degrees):
    along = np.array([[[math.cos(math.radians(degrees)), math.sin(math.radians(degrees))]]])
    for turned in (1, -1):
        value, angle = _across(turned * along, np.array([[5.0 * turned]]), np.array([True]), 0)
        assert (value[0], math.degrees(angle[0])) == pytest.approx((5.0, degrees))


def test_a_row_without_an_acceleration_does_not_hide_the_power_of_the_others():
    """The crank starts as the root of the time does: infinitely fast, so row 1 has no force, and all others have."""
    found = of_text(mechanism("example-1-forces", w1="w0*sqrt(t*w0)"))
    assert np.isnan(found.reactions.rows[0]).any() and np.isfinite(found.reactions.rows[1:]).all()
    (power,) = [one for one in checks.check_forces(found, found) if one.code == "POWER"]
    assert power.verdict in {"PASS", "COARSE"} and power.row > 3
