"""--step auto: the smallest number of steps for a wish; single precision; refusals."""

from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.integration.extended_precision import march_in
from coursework.motion.schemes import SCHEMES
from coursework.results.accuracy import round_off, step_search
from coursework.results.accuracy import step_rules as ruling
from coursework.results.accuracy.round_off import RoundOffRow, round_off_curve
from coursework.results.accuracy.step_rules import StepRules, _pace, step_rules
from coursework.results.accuracy.step_search import choose_step
from coursework.words.data_folders import folder
from coursework.words.errors import InputError
from tests.hard.scenes import scene as lines_of


@pytest.fixture(scope="module")
def scene():
    return coursework.solve("31", quantities=["table"]).scene


@pytest.mark.parametrize(("scheme", "wish"), [("euler", 0.01), ("heun", 1e-4), ("rk4", 1e-6)])
def test_smallest_number_of_steps(scene, scheme, wish):
    """At the step found the exact motion confirms the error; with one step less it is larger."""
    choice = choose_step(scene.rates, scheme, scene.start, 0.02, 0.48, wish)

    def error(steps):
        run = coursework.solve("31", scheme, step=0.48 / steps, quantities=["table"])
        return np.max(np.abs(run.motion.coordinates - run.exact.coordinates))

    assert error(choice.need.steps) <= wish * 1.001
    assert error(choice.need.steps - 1) > wish * 0.999
    assert choice.step == 0.48 / choice.need.steps
    assert choice.need.evaluations == choice.need.steps * {"euler": 1, "heun": 2, "rk4": 4}[scheme]


def test_the_cheaper_alternatives_are_told(scene):
    choice = choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, 0.001)
    assert choice.others[0].evaluations < choice.need.evaluations / 20
    assert "Runge-Kutta 4 needs" in " ".join(choice.sentences)


def test_what_would_take_minutes_is_refused_with_the_time(scene):
    with pytest.raises(InputError, match=r"about .* steps .* finding .* about [\d.]+ (min|h); .*Runge-Kutta 4 needs \d+ steps"):
        choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, 1e-7)


@pytest.mark.parametrize("wish", [0.0, -1.0, float("nan"), float("inf"), 1e-14, 0.99e-10])
def test_wishes_below_round_off_are_refused(scene, wish):
    with pytest.raises(InputError, match="round-off decides"):
        choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, wish)


def test_adding_up_the_time_spoils_single_precision(scene):
    """With t += h the error in single precision is larger at 24 576 steps than at 6144; with t = i*h it goes on falling."""
    end = coursework.solve("31", quantities=["table"]).exact.coordinates[-1]

    def error(steps, running):
        rates, start = scene.rates, scene.start
        rows = march_in(np.float32, rates, "euler", start, 0.48 / steps, steps, every=steps, running_time=running)
        assert rows.dtype == np.float32
        return float(np.max(np.abs(rows[-1].astype(float) - end)))

    coarse, fine = (RoundOffRow(n, 0.0, error(n, False), error(n, True)) for n in (6144, 24576))
    assert fine.running > 1.5 * coarse.running
    assert fine.single < coarse.single / 2


def searched(monkeypatch, error, step, wish, most=1000, runs=lambda scheme, step: True):
    """Return the steps that a search of Euler tries where `error(steps)` is the error, and those it finds or why it does not."""
    tried = []
    monkeypatch.setattr(step_search, "SCHEMES", {"euler": SCHEMES["euler"]})
    monkeypatch.setattr(step_search, "MOST_STEPS", most)
    monkeypatch.setattr(step_search, "seconds", lambda *_, **__: 1.0)
    monkeypatch.setattr(step_search._Search, "measured", lambda _, steps: tried.append(steps) or error(steps))
    try:
        return tried, choose_step(None, "euler", (), step, 1.0, wish, runs=runs).need.steps
    except InputError as refused:
        return tried, str(refused)


@pytest.mark.parametrize(("wish", "most"), [(2.5e-6, 200_000), (1e-9, 16 * 24)])
def test_no_step_of_a_wish_is_tried_beyond_the_rows_of_a_table(monkeypatch, wish, most):
    """A wish that needs more rows than a table has is refused after some coarse trials, not after minutes.

    One that needs hardly more rows is looked at until that is sure, one that needs many more only coarsely.
    """
    tried, told = searched(monkeypatch, lambda steps: 0.6 / steps, 0.02 / 0.48, wish, most=step_search.MOST_STEPS)
    assert "a table has at most 200000 rows" in told
    assert max(tried) == most
    assert len(tried) < 100


@pytest.mark.long
def test_single_precision_has_a_best_step(scene):
    """The V: round-off takes back what ever smaller steps gain, also with t = i*h, and the curve goes on until it shows."""
    rows = 3
    end = coursework.solve("31", quantities=["table"]).exact.coordinates[rows]
    curve = list(round_off_curve(scene.rates, "euler", scene.start, 0.02, rows, end))
    best = min(range(len(curve)), key=lambda place: curve[place].single)
    assert 0 < best < len(curve) - 1
    assert curve[-1].double < curve[best].double
    assert curve[-1].single > 10 * curve[best].single


def test_the_rules_of_a_table_are_kept(scene):
    """A large wish: without rules a few steps do, with them 20 rows a period stand; every scheme advised is tried."""
    rules = step_rules(scene.equations, scene.search)
    assert rules == StepRules(20, 1)
    tried = []
    runs = lambda scheme, step: tried.append((scheme, step)) or scene.rerun(scheme, step) is not None  # noqa: E731
    bare = choose_step(scene.rates, "rk4", scene.start, 0.02, 0.48, 0.5)
    ruled = choose_step(scene.rates, "rk4", scene.start, 0.02, 0.48, 0.5, rules, runs)
    assert bare.need.steps < 20
    assert (ruled.need.steps, ruled.need.ruled) == (20, True)
    assert "but not for the table" in " ".join(ruled.sentences)
    assert {(name, 0.48 / 20) for name in ("rk4",)} <= set(tried)
    euler = choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, 0.01, rules, runs)
    assert not euler.need.ruled and "but not for the table" not in " ".join(euler.sentences)
    assert all(other.steps >= 20 for other in euler.others)


def test_what_does_not_run_is_not_advised(scene):
    """A scheme whose table stops is taken with more steps; one that never runs is not advised at all."""
    runs = lambda scheme, step: scheme != "heun" and (scheme != "rk4" or step < 0.48 / 30)  # noqa: E731
    choice = choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, 0.01, StepRules(20), runs)
    assert {SCHEMES[name].title for name in ("rk4", "midpoint")} <= {other.title for other in choice.others}
    assert SCHEMES["heun"].title not in {other.title for other in choice.others}
    assert next(other.steps for other in choice.others if other.title == SCHEMES["rk4"].title) > 30


@pytest.mark.long
@pytest.mark.parametrize("name", ["31", "robot-arm", "example-1", "jansen", "engine-start", "stephenson"])
def test_what_auto_advises_passes_step_and_peak(name):
    """Run with the step advised, STEP and PEAK pass, and the motion reaches its end."""
    found = coursework.solve(name, "rk4", quantities=["table"])
    scene = found.scene
    choice = choose_step(
        scene.rates, "rk4", scene.begin, found.step, found.end, 1.0, step_rules(scene.equations, scene.search),
        lambda scheme, step: scene.rerun(scheme, step) is not None,
    )  # fmt: skip
    run = coursework.solve(name, "rk4", choice.step, quantities=["table", "checks"])
    assert run.stop is None
    verdicts = {check.code: check.verdict for check in run.checks}
    assert {verdicts["STEP"], verdicts["PEAK"]} <= {"PASS", "SKIP"}


def test_a_step_of_the_file_that_is_too_large_does_not_keep_auto_from_a_smaller_one(tmp_path, monkeypatch):
    from tests.commands.test_cli import call

    monkeypatch.chdir(tmp_path)
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8").replace('step      = "0.02 s"', 'step = "0.23 s"')
    text = text.replace("check_row = 4", "check_row = 1")
    (tmp_path / "wide.toml").write_text(text, encoding="utf-8")
    assert coursework.solve("wide").stop is not None
    result = call(
        "run", "wide", "--scheme", "rk4", "--step", "auto", "--error", "0.01", "--format", "csv", "--quantities", "table"
    )
    assert result.exit_code == 0, result.output
    assert "Runge-Kutta 4 needs 20 steps" in result.stdout


@pytest.mark.parametrize(("wish", "is_searched"), [(1.01e-10, True), (0.99e-10, False)])
def test_the_smallest_wish(monkeypatch, wish, is_searched):
    assert bool(searched(monkeypatch, lambda steps: wish / 2, 0.1, wish)[0]) == is_searched


@pytest.mark.parametrize(("fewest", "found"), [(10, 10), (11, 11), (12, 14), (14, 14), (15, 19), (20, 27)])
def test_where_a_run_stops_a_tenth_more_steps_are_tried_then_two_tenths(monkeypatch, fewest, found):
    """10, 11 = 10 + 1, 14 = 11 + 2.2, 19 = 14 + 4.2, 27 = 19 + 7.6 steps."""
    runs = lambda scheme, step: 1 / step > fewest - 0.5  # noqa: E731
    assert searched(monkeypatch, lambda steps: 10 / steps, 0.1, 1.0, runs=runs)[1] == found


@pytest.mark.parametrize(("first", "looked"), [(10, [10, 160]), (11, [11, 176])])
def test_coarse_steps_that_foretell_too_many_are_followed_by_one_look_at_sixteen_times_as_many(monkeypatch, first, looked):
    tried, found = searched(monkeypatch, lambda steps: 1.0, 1 / first, 1e-3, most=500)
    assert tried[:2] == looked and "a table has at most" in str(found)


@pytest.mark.parametrize(
    ("scheme", "steps", "parts"), [("euler", 999, 4), ("euler", 1000, 1), ("heun", 1000, 1), ("rk4", 999, 4), ("rk4", 1000, 4)]
)
def test_from_a_thousand_steps_on_the_reference_of_a_lower_order_has_the_same_steps(monkeypatch, scheme, steps, parts):
    asked = []
    monkeypatch.setattr(step_search._Search, "rows", lambda *given: asked.append(given[-1]) or np.zeros(1))
    monkeypatch.setattr(step_search, "resolution", lambda *_: SimpleNamespace(shorter=lambda step: (np.array([]),)))
    rates = SimpleNamespace(equations=None)
    step_search._Search(SCHEMES[scheme], rates, (), 0.1, 1.0, 1.0, StepRules(), lambda *_: True).measured(steps)
    assert asked == [1, parts]


@pytest.mark.parametrize(
    ("times", "pace"),
    [((1 / 1000,), 1000), ((1 / 1001,), 1), ((1 / 32, 1 / 27), 864), ((1 / 32, 1 / 37), 1), ((0.5, 1.0), 2), ((1.0,), 1)],
)
def test_breaks_stand_in_rows_where_a_thousand_parts_of_the_run_can(times, pace):
    assert _pace(times, 1.0) == pace


@pytest.mark.parametrize(("rows", "last"), [(24, 24 * 16384), (25, 25 * 4096)])
def test_the_curve_of_single_precision_ends_before_four_hundred_thousand_steps(monkeypatch, rows, last):
    assert curve_of(monkeypatch, [1.0] * 8, rows)[-1].steps == last


@pytest.mark.parametrize(("risen", "rows"), [(0.39, 8), (0.41, 3)])
def test_it_ends_where_both_errors_are_four_times_their_least(monkeypatch, risen, rows):
    assert len(curve_of(monkeypatch, [1.0, 0.1, risen, *[0.1] * 5], 1)) == rows
    assert len(curve_of(monkeypatch, [1.0, 0.1, risen, *[0.1] * 5], 1, running=[0.1] * 8)) == 8


def curve_of(monkeypatch, errors, rows, running=None):
    """Return the curve where single precision has these errors, row by row."""
    left = [one for pair in zip(errors, running or errors, strict=True) for one in pair]
    monkeypatch.setattr(round_off, "generate_loop", lambda *_: lambda *_: [0.0])
    monkeypatch.setattr(round_off, "march_in", lambda *_, **__: np.array([[left.pop(0)]]))
    return list(round_off_curve(None, "euler", [0.0], 0.1, rows, np.zeros(1)))


@pytest.mark.parametrize(
    ("rate", "shown_from", "fewest"),
    [(1.0, 0, 20), (1 + 0.9e-9, 0, 20), (1 + 1.1e-9, 0, 21), (1.0, 21, 25), (1.0, 26, 32), (1.0, 33, 40), (1.0, 41, 50)],
)
def test_rows_are_made_finer_by_a_quarter_until_they_show_every_pulse(monkeypatch, rate, shown_from, fewest):
    """A drive of one turn a second, for a second, whose pulse shows from so many rows on."""
    monkeypatch.setattr(ruling, "drive_frequency", lambda _: 2 * np.pi * rate)
    monkeypatch.setattr(ruling, "turning_cranks", lambda _: {})
    monkeypatch.setattr(ruling, "breaks", lambda _: ())
    monkeypatch.setattr(ruling, "between_rows", lambda _, step: None if round(1 / step) >= shown_from else "pulse")
    variant = SimpleNamespace(coordinates=(), time=SimpleNamespace(end=1.0))
    found = step_rules(SimpleNamespace(variant=variant), SimpleNamespace(fastest=lambda _: None))
    assert found == StepRules(fewest, 1)


@pytest.mark.parametrize(
    ("thousand", "told"), [(0.1, "about 80 s;"), (0.3, "about 4.0 min;"), (6.7, "about 89.3 min;"), (6.8, "about 1.5 h;")]
)
def test_the_time_that_a_search_would_take_is_that_of_eight_trials(scene, monkeypatch, thousand, told):
    """Eight runs of a hundred thousand steps take 800 times what a thousand steps take."""
    monkeypatch.setattr(step_search, "seconds", lambda _run, **_: thousand)
    rates, start = scene.rates, tuple(scene.start)
    search = step_search._Search(SCHEMES["euler"], rates, start, 0.02, 0.48, 1e-7, None, lambda *_: True)
    assert told in str(search.refused(100_000)).replace("\u00a0", " ").replace("\u202f", " ")


def heun_of_a_reversal(steps):
    """Return the largest error of y' (2 + cos y) = 4, from 0.513 s on -4, by Heun's scheme written out: 2 y + sin y is known."""
    y, worst, step = 0.0, 0.0, 1.0 / steps
    for row in range(steps):
        rate = 4.0 if row < round(0.513 * steps) else -4.0
        slope = rate / (2 + np.cos(y))
        y += step / 2 * (slope + rate / (2 + np.cos(y + step * slope)))
        t = (row + 1) * step
        wanted, true = 4 * min(t, 0.513) - 4 * max(t - 0.513, 0.0), y
        for _ in range(8):
            true -= (2 * true + np.sin(true) - wanted) / (2 + np.cos(true))
        worst = max(worst, abs(y - true))
    return worst


@pytest.mark.parametrize(("share", "steps"), [(1.01, 1000), (0.99, 2000)])
def test_where_a_row_stands_at_a_break_a_scheme_needs_no_more_steps_than_without_one(share, steps):
    """With other steps the error is of first order, and a hundred thousand were asked for."""
    text = lines_of(
        'x = { start = "0 rad", rate = "w" }\ny = { start = "0 rad", rate = "u" }', given='n = "4 rad/s"',
        drive='w = { pieces = [["0 s", "n"], ["0.513 s", "-n"]] }', equations=["u*(2 + cos(y)) = w"],
    )  # fmt: skip
    wish = share * heun_of_a_reversal(1000)
    found = coursework.solve(coursework.parse_variant(text), "heun", step="auto", error=wish, quantities=["table"])
    assert len(found.table) == steps + 1


@pytest.mark.parametrize(("wish", "steps"), [(0.01, 34), (0.001, 332)])
def test_a_step_is_found_also_where_coarse_ones_leave_a_root_without_a_value(wish, steps):
    """x = (1 - t/2)² m: Euler by hand errs by 0.0099 m in 34 steps and by 0.0102 m in 33; with 6 its x falls below zero."""
    text = """format = 1
title = "x falls to zero"
given = { k = "1 m", c = "1 s" }
drive = { w = "0 1/s" }
coordinates = { x = { start = "1 m", rate = "v" }, phi = { start = "0 rad", rate = "w" } }
time = { step = "0.3 s", end = "1.8 s" }
constraint = [{ name = "1", because = "of a rope", equation = "c*v + sqrt(k*x) = 0" }]
"""
    assert coursework.solve(coursework.parse_variant(text), step="auto", error=wish).variant.time.steps == steps
