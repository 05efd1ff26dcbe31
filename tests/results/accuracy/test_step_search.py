"""--step auto: the smallest number of steps for a wish; single precision; refusals."""

import numpy as np
import pytest

import coursework
from coursework.motion.integration.extended_precision import march_in
from coursework.motion.schemes import SCHEMES
from coursework.results.accuracy import step_search
from coursework.results.accuracy.round_off import RoundOffRow, round_off_curve
from coursework.results.accuracy.step_rules import StepRules, step_rules
from coursework.results.accuracy.step_search import choose_step
from coursework.words.data_folders import folder
from coursework.words.errors import InputError


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


def test_the_cheaper_alternatives_are_told(scene):
    choice = choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, 0.001)
    assert choice.others[0].evaluations < choice.need.evaluations / 20
    assert "Runge-Kutta 4 needs" in " ".join(choice.sentences)


def test_what_would_take_minutes_is_refused_with_the_time(scene):
    with pytest.raises(InputError, match=r"about .* steps .* finding .* about [\d.]+ (min|h); .*Runge-Kutta 4 needs \d+ steps"):
        choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, 1e-7)


@pytest.mark.parametrize("wish", [0.0, -1.0, float("nan"), 1e-14])
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


def test_no_step_of_a_wish_is_tried_beyond_the_rows_of_a_table(scene, monkeypatch):
    """A wish that needs more rows than a table has is refused after some coarse trials, not after minutes."""
    tried = []
    rows = step_search._rows

    def counted(loop, rates, start, end, steps, inner):
        tried.append(steps)
        return rows(loop, rates, start, end, steps, inner)

    monkeypatch.setattr(step_search, "_rows", counted)
    for wish in (2.5e-6, 1e-9):
        with pytest.raises(InputError, match="a table has at most 200000 rows"):
            choose_step(scene.rates, "euler", scene.start, 0.02, 0.48, wish)
    assert max(tried) <= 200_000
    assert len(tried) < 100


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
