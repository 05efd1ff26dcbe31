"""Which draws are accepted: against a closed form of variant 31, an integrator written by others, and limits from both sides."""

import math
import re
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import coursework
from coursework.assigning.accept import Acceptance
from coursework.assigning.judge import Verdict, _refused_at_sight, judge
from coursework.assigning.ranges import MEASURES, Limits, Lots
from coursework.assigning.variants import load_ranges
from tests.assigning import closed_form
from tests.assigning.test_draw import acceptance, model
from tests.grading.marking import students as by_hand

NAMES = ("r1", "r2", "r3", "V1", "p", "alpha", "phi1", "phi2", "phi3")
# Wider than the ranges of the catalogue, so that about a half of the draws stop.
WIDE = {
    "given": {
        "r1": {"from": "0.7 m", "to": "1.2 m", "step": "0.001 m"}, "r3": {"from": "0.3 m", "to": "0.5 m", "step": "0.001 m"},
        "V1": {"from": "3.9 m/s", "to": "5.5 m/s", "step": "0.1 m/s"},
        "alpha": {"from": "3.5 rad", "to": "5 rad", "step": "0.01 rad"},
    },
}  # fmt: skip


def numbers(values):
    """The nine numbers of a draw of variant 31, what is not drawn from the template."""
    own = {**model().variant.values, **{c.name: c.start for c in model().variant.coordinates}}
    return own | {path[1]: float(text.split()[0]) for path, text in values.items() if path[0] != "time"}


@pytest.mark.long
def test_accepted_mechanisms_move_by_the_closed_form():
    for one in acceptance().accepted([f"s{number}" for number in range(40)]):
        drawn = numbers(one.values)
        guide, reach = closed_form.margins(*(drawn[name] for name in NAMES))
        assert min(guide, reach) >= 0.2 * (1 - 2e-3)
        # Rows of an eighth of a step lie at most a few thousandths beside the smallest value itself.
        assert one.numbers["least_determinant"] == pytest.approx(min(guide, reach), abs=3e-3)


def test_feasible_is_what_the_closed_form_says_draw_by_draw():
    lots = Lots(model().variant, load_ranges(WIDE, model().variant), "1")
    draws = [lots.draw("", number) for number in range(80)]
    data = model().data({path[1]: [draw[path] for draw in draws] for path in draws[0]})
    verdicts = judge(model(), data, Limits())
    margins = [min(closed_form.margins(*(numbers(draw)[name] for name in NAMES))) for draw in draws]
    assert [verdict.refused != "motion" for verdict in verdicts] == [margin > 0 for margin in margins]
    assert 20 < sum(margin > 0 for margin in margins) < 70


def test_the_measures_are_those_of_an_integrator_of_others():
    for one in acceptance().accepted(["ada", "bert"]):
        drawn = numbers(one.values)
        data = {name: drawn[name] for name in NAMES[:6]}
        start = [drawn[name] for name in NAMES[6:]]

        def slopes(t, q, data=data):
            return by_hand.velocities(t, q, **data)[:3]

        euler = [np.array(start)]
        for k in range(24):
            euler.append(euler[-1] + 0.02 * slopes(0.02 * k, euler[-1]))
        times = 0.02 * np.arange(25)
        exact = solve_ivp(slopes, (0, 0.48), start, t_eval=times, rtol=1e-11, atol=1e-12).y.T
        fastest = max(np.max(np.abs(by_hand.velocities(t, q, **data))) for t, q in zip(times, euler, strict=True))
        here = [slopes(t, q) for t, q in zip(times[:-1], euler[:-1], strict=True)]
        ahead = [slopes(times[k + 1], euler[k] + 0.02 * here[k]) for k in range(24)]
        gap = np.max(np.abs(0.01 * (np.array(ahead) - np.array(here))))
        assert one.numbers["euler_error"] == pytest.approx(np.max(np.abs(np.array(euler) - exact)), rel=1e-6)
        assert one.numbers["largest_velocity"] == pytest.approx(fastest, rel=1e-9)
        assert one.numbers["one_step_gap"] == pytest.approx(gap, rel=1e-9)


def verdict_of(limits, **columns):
    return judge(model(), model().data(columns or {"p": [13.0]}), Limits(**limits))[0]


def test_the_first_row_and_the_last_are_measured():
    """Within four steps variant 31 only slows down, and Euler's error only grows."""
    short, data = coursework.compile_model(coursework.load("31").with_data(end="0.08 s")), {"p": 13.0}
    rows, times = [np.array([one.start for one in short.variant.coordinates])], 0.02 * np.arange(5)
    for t in times[:-1]:
        rows.append(rows[-1] + 0.02 * np.array(by_hand.velocities(t, rows[-1], **data)[:3]))
    speeds = [np.max(np.abs(by_hand.velocities(t, row, **data))) for t, row in zip(times, rows, strict=True)]
    exact = solve_ivp(lambda t, q: by_hand.velocities(t, q, **data)[:3], (0, 0.08), rows[0], t_eval=times, rtol=1e-11, atol=1e-12)
    errors = np.max(np.abs(np.array(rows) - exact.y.T), axis=1)
    assert speeds == sorted(speeds, reverse=True) and errors.tolist() == sorted(errors)
    (verdict,) = judge(short, short.data({"p": [13.0]}), Limits())
    assert verdict.numbers["largest_velocity"] == pytest.approx(speeds[0], rel=1e-9)
    assert verdict.numbers["euler_error"] == pytest.approx(errors[-1], rel=1e-6)


def test_a_motion_without_a_period_is_measured_up_to_its_last_row():
    """The other way up, the guide of variant 31 comes nearer to its dead point all the time."""
    text = re.sub("(?m)^(period|check_row).*\n", "", coursework.load("31").path.read_text(encoding="utf-8"))
    short, data = coursework.compile_model(coursework.parse_variant(text).with_data(end="0.04 s")), {"p": 13.0, "alpha": 1.0}
    start = [one.start for one in short.variant.coordinates]
    exact = solve_ivp(lambda t, q: by_hand.velocities(t, q, **data)[:3], (0, 0.04), start, rtol=1e-11, atol=1e-12).y
    guide = np.abs(np.cos(exact[2] - closed_form.DELTA)) * math.sqrt(5) / 3
    (verdict,) = judge(short, short.data({name: [value] for name, value in data.items()}), Limits())
    assert np.all(np.diff(guide) < 0) and verdict.numbers["least_determinant"] == pytest.approx(guide[-1], rel=1e-9)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("key", ["least_determinant", "least_transmission", "largest_velocity", "least_rows_a_turn"])
def test_a_limit_holds_just_inside_and_refuses_just_outside(key, side):
    found = verdict_of({}).numbers
    at = {
        "least_determinant": found["least_determinant"],
        "least_transmission": math.asin(found["least_determinant"]),
        "largest_velocity": found["largest_velocity"],
        "least_rows_a_turn": 2 * math.pi / (found["largest_velocity"] * 0.02),
    }[key]
    upper = key == "largest_velocity"
    limit = at * (1 + side * 1e-9)
    assert verdict_of({key: limit}).refused == ("" if (side > 0) == upper else key)


def test_the_template_itself_is_given_to_nobody():
    assert verdict_of({}, p=["13.08 1/s"], phi1=["1.63 rad"]).refused == "same"
    assert verdict_of({}, p=["13.08 1/s"], phi1=["1.64 rad"]).refused == ""


def test_a_table_that_steps_over_a_dead_point_is_refused():
    """Four rows a turn and a mechanism that only just goes round: the motion is possible, and Euler's table is not."""
    coarse = coursework.compile_model(coursework.load("31").with_data(step="0.12 s"))
    sets = coarse.data({"r3": [0.3017, 0.303, 0.31, 0.33]})
    verdicts = judge(coarse, sets, Limits())
    stops = coursework.solve_many(coarse, sets).stops
    assert (
        [verdict.refused for verdict in verdicts]
        == ["" if stop is None else "stepped_over" for stop in stops]
        == ["stepped_over", "stepped_over", "", ""]
    )


def test_the_band_is_held_around_the_median_of_the_pilot_stream():
    usual = acceptance()
    streams = {student: [usual.lots.draw(student, attempt) for attempt in range(40)] for student in ("", "s1", "s2", "s3")}
    draws = [draw for stream in streams.values() for draw in stream]
    data = model().data({path[1]: [draw[path] for draw in draws] for path in draws[0] if path[0] != "time"})
    verdicts = judge(model(), data, usual.ranges.limits)
    pilot = [place for place in range(40) if not verdicts[place].refused][:25]
    assert (usual.centre.feasible, usual.centre.drawn) == (25, pilot[-1] + 1)
    for name in ("euler_error", "least_determinant", "largest_velocity", "one_step_gap"):
        assert usual.centre.numbers[name] == pytest.approx(
            np.median([verdicts[place].numbers[name] for place in pilot]), rel=1e-12
        )
    for number, accepted in enumerate(usual.accepted(["s1", "s2", "s3"]), start=1):
        of_student = verdicts[40 * number : 40 * (number + 1)]
        inside = [not one.refused and all(abs(math.log(one.numbers[name] / usual.centre.numbers[name])) <= math.log(1.3) / 2
                                          for name in usual.ranges.difficulty.numbers) for one in of_student]  # fmt: skip
        assert accepted.attempt == inside.index(True)
        assert accepted.values == streams[accepted.id][accepted.attempt]


@cache
def sixty():
    return acceptance().accepted([f"s{number}" for number in range(60)])


@pytest.mark.long
@pytest.mark.parametrize("size", [2, 3, 5, 30])
def test_nobody_is_farther_than_the_band_from_the_median_of_any_class(size):
    """Of 60 students the worst class of each size is taken: the easiest with the one hardest, and the other way round."""
    everybody = sixty()
    for name in acceptance().ranges.difficulty.numbers:
        values = sorted(one.numbers[name] for one in everybody)
        for group in (values[: size - 1] + values[-1:], values[:1] + values[1 - size :], values):
            assert 0.7 <= min(group) / np.median(group) <= max(group) / np.median(group) <= 1.3


@pytest.mark.parametrize(("feasible", "ends"), [(5, True), (4, False)])
def test_the_pilot_stops_where_fewer_than_one_draw_in_twenty_is_possible(monkeypatch, feasible, ends):
    """Of the first hundred draws so many are possible, after them all: five are enough, four are not."""
    numbers = dict.fromkeys(MEASURES, 1.0)
    drawn = []

    def judged(model, data, limits):
        places = range(len(drawn), len(drawn) + data.count)
        drawn.extend(places)
        return [
            Verdict("" if place >= 100 or (place % 20 == 0 and place // 20 < feasible) else "motion", numbers) for place in places
        ]

    monkeypatch.setattr("coursework.assigning.accept.judge", judged)
    if ends:
        assert Acceptance(model(), acceptance().lots).centre.drawn == 120
    else:
        with pytest.raises(
            coursework.InputError, match=r"of 100 draws 96 could not go .* and 4 can be given out\. At least one in 20"
        ):
            Acceptance(model(), acceptance().lots)


def test_ranges_that_leave_too_few_are_refused_with_reasons():
    never = {"given": {"alpha": {"from": "0 rad", "to": "0.05 rad", "step": "0.01 rad"}}, "limits": {"tries": 10}}
    with pytest.raises(coursework.InputError, match=r"of 10 draws 10 could not go .* or milder limits\."):
        coursework.draw("31", never, 1, "ada")
    r1, V1 = {"from": "0.94 m", "to": "0.96 m", "step": "0.001 m"}, {"from": "4.3 m/s", "to": "4.7 m/s", "step": "0.01 m/s"}
    strict = {"given": {"r1": r1, "V1": V1}, "limits": {"tries": 3}, "difficulty": {"band": 0.000001}}
    with pytest.raises(coursework.InputError, match=r"none of 3 draws for student ada is accepted: .*band of "):
        coursework.draw("31", strict, 1, "ada")
    same = {"given": {"p": {"choice": ["13.08 1/s"]}}, "limits": {"tries": 4}}
    with pytest.raises(coursework.InputError, match=r"of 4 draws 4 had the template’s own data, .* Take wider ranges: they"):
        coursework.draw("31", same, 1, "ada")


def test_data_that_move_the_times_of_the_rows_have_rows_of_their_own():
    ranges = {"given": {"w0": {"choice": ["8 rad/s", "9 rad/s"]}, "r5": {"from": "1.1 m", "to": "1.3 m", "step": "0.01 m"}}}
    variants = coursework.draw_many("homework", ranges, 5, ["ada", "bert", "carl", "dora"])
    assert {variant.values["w0"] for variant in variants} == {8.0, 9.0}
    for variant in variants:
        assert variant.time.step == pytest.approx(2 * math.pi / 36 / variant.values["w0"], rel=1e-15)
        assert variant.time.scheme == "euler"  # so that a run writes the table that is marked


@pytest.mark.parametrize("step", [0.004, 30.0])
@pytest.mark.parametrize(("rows", "refused"), [
    (1 - 0.98e-9, ""), (1 - 1.02e-9, "refused"), (200_000, ""), (200_000.001, "refused"),
    (math.nan, "refused"), (math.inf, "refused"),
])  # fmt: skip
def test_a_table_has_a_row_after_the_first_and_200_000_at_most(step, rows, refused):
    template, variant = (SimpleNamespace(coordinates=(), values={"p": value}) for value in (1.0, 2.0))
    variant.time = SimpleNamespace(step=step, end=rows * step)
    data = SimpleNamespace(changed=("p",), given=("p",), start=np.zeros((1, 0)))
    assert _refused_at_sight(template, data, 0, variant) == Verdict(refused)
