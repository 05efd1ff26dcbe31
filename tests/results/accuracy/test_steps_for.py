"""What equal accuracy costs is interpolated between the runs, and steps too coarse for an order are told."""

import math
from dataclasses import replace

import pytest

import coursework
from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE, SCHEMES, title_of
from coursework.report.output.tables import study_csv
from coursework.results.accuracy.methods import projected_title
from coursework.results.accuracy.record import AccuracyStudy, StudyRow
from coursework.results.accuracy.sentences import _clock, _round, _size, _steps_for, sentences_of, unsettled
from coursework.results.accuracy.trace import local_slopes, orders_of, slope
from coursework.words.sentences import say

BENT = "Steps are still too coarse for an order; local slopes:"
COUNTS = (24, 96, 1536, 24576, 98304)


def row(scheme, count, error, cost=1):
    return StudyRow(title_of(scheme), f"{count}", count * cost, error, error, None)


def study(best, constant=3.0, order=1.0):
    rows = [row(DEFAULT_SCHEME, count, constant / count**order) for count in COUNTS]
    return [*rows, row(PRECISE, 24, best, 4)]


@pytest.mark.parametrize("wanted", [25_000, 30_000, 61_000, 200, 1000])
def test_the_steps_are_those_at_which_the_error_is_reached(wanted):
    """The grid of fours has 98 304 behind 24 576: what lies between is told as it is, with the runs beside it."""
    rows = study(3.0 / wanted)
    told = next(one for one in sentences_of(rows, {}, {}, rows[0], 1e-15) if one.key.startswith("study.equal"))
    assert told.values["needed"].values["needed"] == f"{wanted:,}".replace(",", "\u202f")
    low, high = (int(told.values["needed"].values[name].replace("\u202f", "")) for name in ("low", "high"))
    assert low < wanted < high
    assert {low, high} <= {*COUNTS}


def test_beyond_the_finest_run_nothing_bounds_them():
    rows = study(3.0 / 410_000)
    told = next(one for one in sentences_of(rows, {}, {}, rows[0], 1e-15) if one.key.startswith("study.equal"))
    assert told.values["needed"] == "410\u202f000"


def test_steps_too_coarse_for_an_order_are_told():
    bent = [row(DEFAULT_SCHEME, count, error) for count, error in ((24, 0.09), (48, 0.08), (96, 0.02))]
    (told,) = unsettled(bent, 1e-15)
    assert "0.2, then 2.0" in str(told)
    assert local_slopes([24, 48, 96], [0.09, 0.08, 0.02], 1e-15)[1] == pytest.approx(2.0)
    assert unsettled(study(1e-5)[:5], 1e-15) == ()
    for apart, settled in ((0.48, True), (0.52, False)):
        just = [row(DEFAULT_SCHEME, count, 0.05 / count**power) for count, power in ((1, 1), (2, 1), (4, 1 + apart / 2))]
        assert (unsettled(just, 1e-15) == ()) == settled


def test_errors_that_do_not_fall_yet_have_no_order_and_no_better_scheme():
    """A pulse between all rows of all runs: every scheme steps over it, by the same 1.77 rad but for rounding."""
    missed = [row(DEFAULT_SCHEME, count, 1.77 + 1e-15 * count) for count in COUNTS] + [row(PRECISE, 24, 1.77, 4)]
    told = [str(one) for one in sentences_of(missed, {}, {}, missed[0], 1e-15)]
    assert "The same 24 steps of Runge-Kutta 4 are no better: 1.77 rad off." in told[1]
    assert not any("To be as good" in one or "times less" in one for one in told)
    assert str(unsettled(missed, 1e-15)[0]).endswith("too coarse for an order; local slopes: explicit Euler: none.")
    assert unsettled([row(DEFAULT_SCHEME, count, 1e-16) for count in COUNTS], 1e-15) == ()  # round-off is as good as it gets
    grown = [row(DEFAULT_SCHEME, count, 1e-12 * (3 if count == COUNTS[-1] else 1)) for count in COUNTS]
    assert unsettled(grown, 1e-13) == () and unsettled(grown, 1e-15) != ()  # 64 round-offs of a step, as many as there are steps
    assert str(unsettled(missed, 1e-15, broken=True)[0]).startswith("The drive changes its formula inside a step of every run")


def test_a_run_that_did_not_end_has_empty_cells():
    failed = StudyRow("explicit Euler", "24", 0, math.nan, math.nan, None, "did not finish")
    text = study_csv(AccuracyStudy((failed,), {}, None, 0.0, "", (), (), False))
    assert "nan" not in text
    assert text.splitlines()[1].startswith("explicit Euler,24,0,,")


def test_what_round_off_forbids_is_not_promised():
    """A trillion steps of 1e-16 each add up to 1e-10 at random: no Euler is good to 4e-12 in doubles."""
    rows = study(4e-12)
    told = [one.key for one in sentences_of(rows, {}, {}, rows[0], 1e-15)]
    assert "study.never" in told
    assert not any(key.startswith("study.equal") for key in told)


@pytest.mark.parametrize(("best", "is_never"), [(3.2e-11, True), (3.5e-11, False)])
def test_round_off_of_many_steps_grows_as_the_root_of_their_number(best, is_never):
    """3/E steps of 2^-53 each: at E = 3.33e-11 they add up to the error itself."""
    rows = study(best)
    keys = [one.key.partition(".equal")[0] for one in sentences_of(rows, {}, {}, rows[0], 1e-15)]
    assert ("study.never" in keys) == is_never
    assert ("study" in keys) != is_never


@pytest.mark.parametrize(("part", "is_better"), [(0.94, True), (0.96, False)])
def test_a_scheme_that_takes_no_twentieth_off_the_error_is_no_better(part, is_better):
    rows = study(part * 3.0 / 24)
    keys = [one.key for one in sentences_of(rows, {}, {}, rows[0], 1e-15)]
    assert (keys[1].startswith("study.best"), keys[1] == "study.no_better") == (is_better, not is_better)
    assert any(key.startswith(("study.equal", "study.never")) for key in keys) == is_better


@pytest.mark.parametrize(("times", "told"), [(1.09, False), (1.11, True)])
def test_an_end_row_that_understates_the_error_by_a_tenth_is_told(times, told):
    usual, *others = study(1e-3)
    rows = [replace(usual, end_error=usual.max_error / times), *others]
    assert ("study.end_row" in [one.key for one in sentences_of(rows, {}, {}, rows[0], 1e-15)]) == told


@pytest.mark.parametrize(("floor", "told"), [(1e-2, True), (1.0, False)])
def test_of_errors_that_are_round_off_the_last_row_tells_nothing(floor, told):
    usual, *others = study(1e-3)
    rows = [replace(usual, end_error=usual.max_error / 17), *others]
    assert ("study.end_row" in [one.key for one in sentences_of(rows, {}, {}, rows[0], floor)]) == told


def test_a_length_in_the_last_row_is_not_compared_with_an_angle_in_another():
    usual, *others = study(1e-3)
    rows = [replace(usual, end_error=usual.max_error / 2, end_unit="m"), *others]
    assert "study.end_row" not in [one.key for one in sentences_of(rows, {}, {}, rows[0], 1e-15)]


@pytest.mark.parametrize(("error", "key"), [(7e-18, "study.projected_exactly"), (1e-9, "study.with_projection")])
def test_a_projection_that_leaves_round_off_is_told_so_and_no_number_of_times(error, key):
    projected = StudyRow(projected_title(1), "24", 48, error, error, None)
    rows = [*study(1e-3), projected]
    told = next(one for one in sentences_of(rows, {}, {}, rows[0], 1e-15) if "projec" in one.key)
    assert told.key == key


@pytest.mark.parametrize(("apart", "told"), [(0.49, False), (0.51, True)])
def test_an_order_at_the_end_that_is_half_an_order_higher_only_seems_so(apart, told):
    rows, title = study(1e-3), title_of(DEFAULT_SCHEME)
    found = sentences_of(rows, {title: 1.0}, {title: 1.0 + apart}, rows[0], 1e-15)
    assert ("study.end_order" in [one.key for one in found]) == told


def test_what_has_no_error_has_no_ratio():
    """A drive that stands still: nothing is better than nothing."""
    study = coursework.solve(coursework.load("31").with_data(given={"V1": 0.0}), quantities=("accuracy",)).accuracy
    assert {one.max_error for one in study.rows} == {0.0}
    assert not any("times less" in str(one) for one in study.sentences)
    rows = [row(DEFAULT_SCHEME, 24, 1e-3), row(PRECISE, 24, 0.0, 4)]
    assert "many times less" in str(sentences_of(rows, {}, {}, rows[0], 1e-15)[1])


@pytest.mark.parametrize(("least", "told"), [(0.99, True), (1.01, False)])
def test_an_order_is_told_where_it_is_more_than_the_least(least, told):
    assert (title_of(DEFAULT_SCHEME) in orders_of(study(1e-3), 1e-15, least)) == told


@pytest.mark.parametrize(
    ("errors", "order"), [((0.099, 0.0099), 1.0), ((0.101, 0.0101), None), ((1e-3, 1.1e-4), 0.96), ((1e-3, 0.95e-4), None)]
)
def test_errors_between_ten_times_round_off_and_a_tenth_have_an_order(errors, order):
    found = slope([1, 10], errors, 1e-5)
    assert found == (order if order is None else pytest.approx(order, abs=2e-3))


@pytest.mark.parametrize(("power", "two", "three"), [
    (1.48, False, True), (1.52, True, True), (2.48, True, True), (2.52, False, True), (3.48, False, True), (3.52, False, False),
])  # fmt: skip
def test_points_that_lie_on_a_line_by_luck_are_no_order(power, two, three):
    """A drive with a pulse: the finest runs of Ralston's scheme gave 3.9 and 3.6.  Its order is 2, and 3 in an integral."""
    scheme = SCHEMES["ralston"]
    rows = [row(scheme, count, error) for count, error in ((24, 0.5), (48, 0.3))]
    rows += [row(scheme, 96 * 2**times, 0.09 / 2 ** (power * times)) for times in range(3)]
    for count, is_order in ((4, two), (5, three)):
        found, told = orders_of(rows[:count], 1e-15, 0.5), [str(one) for one in unsettled(rows[:count], 1e-15)]
        assert found == ({title_of(scheme): pytest.approx(power)} if is_order else {})
        slopes = f"{power:.1f}, from two points alone." if count == 4 else f"{power:.1f}, then {power:.1f}."
        assert told == ([] if is_order else [f"{BENT} Ralston: {slopes}"])


@pytest.mark.parametrize(("last", "order"), [(1e-4, 1.0), (1e-5, None), (0.9e-3, None)])
def test_slopes_that_disagree_are_no_order(last, order):
    assert slope([1, 10, 100], (1e-2, 1e-3, last), 1e-15) == (order and pytest.approx(order))


@pytest.mark.parametrize(
    ("seconds", "told"),
    [(12.0, "12 s"), (1.0, "1 s"), (0.99, "990 ms"), (1e-3, "1 ms"), (0.99e-3, "990 µs"), (1e-6, "1 µs"), (9e-9, "9 ns")],
)
def test_times_are_told_in_the_largest_unit_that_they_reach(seconds, told):
    assert str(_clock(seconds)).replace("\u202f", " ").replace("\xa0", " ") == told


def test_what_is_gained_and_what_it_costs_is_told_in_numbers():
    """Euler takes 2 us a step; 24 steps of Runge-Kutta 4 take 150 us and err by 3/410 000; closed positions take 600 us."""
    usual = [replace(row(DEFAULT_SCHEME, count, 3.0 / count), seconds=2e-6 * count) for count in COUNTS]
    best = replace(row(PRECISE, 24, 3.0 / 410_000, 4), seconds=150e-6)
    closed = StudyRow(say("study.closed"), "24", 480, 1e-12, 1e-12, 600e-6)
    projected = StudyRow(projected_title(1), "24", 48, 0.0125, 0.0125, None)
    found = sentences_of([*usual, best, closed, projected], {}, {}, usual[0], 1e-15)
    told = {one.key: one.values for one in found}
    assert [*told] == [
        "study.own.timed", "study.best.timed", "study.equal.timed", "study.with_projection", "study.by_closure.timed",
    ]  # fmt: skip
    assert str(told["study.own.timed"]["time"]) == str(_clock(48e-6))
    gained = told["study.best.timed"]
    assert (gained["less"], gained["more"], gained["longer"]) == ("17\u202f000", 4.0, pytest.approx(150 / 48))
    equal = told["study.equal.timed"]
    assert (equal["needed"], equal["more"], str(equal["time"])) == ("410\u202f000", "4\u202f300", str(_clock(0.82)))
    assert equal["longer"] == "5\u202f500"
    assert told["study.with_projection"]["less"] == "10"
    cost = told["study.by_closure.timed"]
    assert (cost["evaluations"], str(cost["more"]), cost["longer"]) == (480, str(_round(5.0)), 4.0)


@pytest.mark.parametrize(("value", "told"), [
    (9.96, say("amount.bare", value=9.96)), (12.4, "12"), (12.6, "13"), (99.0, "99"), (104.0, "100"), (106.0, "110"),
    (12_345.0, "12\u202f000"),
    (0.0, say("amount.many")), (-1.0, say("amount.many")), (math.inf, say("amount.many")), (math.nan, say("amount.many")),
])  # fmt: skip
def test_a_ratio_has_two_digits(value, told):
    assert _round(value) == told


@pytest.mark.parametrize(("value", "unit", "key"), [
    (0.9e-3, "rad", "three"), (1.1e-3, "rad", "angle"), (1.73, "rad", "angle"), (1.74, "rad", "three"), (0.5, "m", "three"),
])  # fmt: skip
def test_an_angle_from_a_thousandth_to_a_hundred_degrees_is_told_in_degrees_too(value, unit, key):
    found = _size(value, unit)
    assert found.key == f"amount.{key}"
    assert key != "angle" or found.values["degrees"] == pytest.approx(value * 180 / math.pi)


@pytest.mark.parametrize(("errors", "error", "steps"), [
    ((0.4, 0.1), 0.2, (10 * 4**0.5, (10, 40))), ((0.4, 0.1), 0.1, (40.0, (10, 40))), ((0.4, 0.1), 0.05, (80.0, None)),
    ((0.4, 0.1), 0.4, (10.0, None)), ((0.4, 0.1), 9.0, (10.0, None)), ((0.4, 0.0), 0.2, (40.0, None)), ((0.1, 0.4), 0.0, None),
    ((0.0, 0.0), 0.0, (10.0, None)),
])  # fmt: skip
def test_steps_for_an_error_lie_between_two_runs_or_behind_the_finest(errors, error, steps):
    found = _steps_for([row(DEFAULT_SCHEME, count, one) for count, one in zip((10, 40), errors, strict=True)], error)
    assert (found is None) if steps is None else (found[0] == pytest.approx(steps[0]) and found[1] == steps[1])
