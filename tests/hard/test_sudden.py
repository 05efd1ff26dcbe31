"""Drives that do something in less than a step: whoever looks at a motion sees it, or says that it does not.

The mechanism is a four-bar that no catalogue has; what its crank turns is known in closed form.
"""

import math

import numpy as np
import pytest

import coursework
from coursework.report.live.page import followed, live_part, sliders_of
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.variant.reading.reader import parse_variant
from tests.command import call
from tests.hard.drives import Law, four_bar
from tests.mechanisms.library import changed
from tests.results.checks.scenes import found

WIDTH, MIDDLE = 1e-4, 0.50437


def pulse(high=1e4, width=WIDTH, back=None):
    """Return a pulse between two rows of 0.01 s, and where `back` (s) is given its reverse at that time."""
    given = {"a": f"{high!r} rad/s", "b": "0.1 rad/s", "tm": f"{MIDDLE} s", "T": f"{width!r} s"}
    text = "b + a*exp(-((t - tm)/T)^2)" + (f" - a*exp(-((t - {back})/T)^2)" if back else "")
    return Law("pulse", text, given, lambda t: t)


def rocking(law, **times):
    """Return a four-bar whose crank only swings: it meets a dead point at phi1 = 2.006 rad."""
    return parse_variant(changed(four_bar(law, **times), r1="0.8 m"))


def test_many_sets_stop_where_one_alone_does():
    """Pushed and pulled back between two rows, the crank is beyond its dead point in between: every row alone looks well."""
    variant = rocking(pulse(2e4, back=0.5057))
    many = coursework.solve_many(variant, {"a": [2e4, 1.0]})
    alone = coursework.solve(variant)
    assert alone.stop.kind == "dead point"
    assert many.stops[0].time == alone.stop.time
    assert many.stops[1] is None
    assert coursework.feasible_many(variant, {"a": [2e4, 1.0]})[0].tolist() == [False, True]


@pytest.mark.parametrize("data", [{"T": [1e-4, 1e-2]}, {"tm": [0.2, MIDDLE]}, {"a": [1e4, 5e3, 1.0]}])
def test_many_sets_are_each_as_alone(data):
    variant = parse_variant(four_bar(pulse(), scheme="rk4"))
    many = coursework.solve_many(variant, data)
    for place in range(len(many.stops)):
        given = {name: column[place] for name, column in data.items()}
        alone = coursework.solve(variant.with_data(given), quantities=("table",))
        kept = many.table(place).to_numpy()
        assert np.allclose(kept, alone.motion.rows, rtol=0, atol=1e-12)


@pytest.mark.long
def test_the_step_found_by_itself_follows_the_pulse(tmp_path):
    (tmp_path / "one.toml").write_text(four_bar(pulse(), scheme="rk4", end=0.6), encoding="utf-8")
    wish = ["--step", "auto", "--error", "0.001", "--format", "csv"]
    done = call("run", tmp_path / "one.toml", *wish, "--out", tmp_path / "out")
    assert done.exit_code == 0, done.output
    last = (tmp_path / "out" / "table.csv").read_text(encoding="utf-8").splitlines()[-1].split(",")
    assert float(last[1]) == pytest.approx(0.06 + 1e4 * WIDTH * math.sqrt(math.pi), abs=1e-3)


@pytest.mark.parametrize(("times", "verdict"), [(1.0, "COARSE"), (100.0, "SKIP")])
@pytest.mark.parametrize("scheme", ["euler", "exact"])
def test_a_pulse_that_no_row_shows_is_told(times, verdict, scheme):
    """As wide as a step, every row is on it."""
    step = found(coursework.solve(parse_variant(four_bar(pulse(1e4 / times, times * WIDTH), scheme=scheme))), "STEP")
    assert step.verdict == verdict
    assert ("Between rows 51 and 52 the drive w1" in step.sentence) == (verdict == "COARSE")


@pytest.mark.parametrize(("width", "told"), [(0.05, False), (0.01, True)])
def test_a_cusp_is_told_where_the_rows_cut_it_off(width, told):
    """Between 0.50 s and 0.51 s the rows leave out 1 - exp(-0.005/T), more or less, of its height."""
    law = Law("cusp", "b + a*exp(-abs(t - 0.504)/T)", {"a": "1 1/s", "b": "1 rad/s", "T": f"{width} s"}, abs)
    step = found(coursework.solve(parse_variant(four_bar(law))), "STEP")
    assert ("Between rows 51 and 52" in step.sentence) == told


def test_folds_are_none_while_there_are_twenty_rows_a_period():
    law = Law("fold", "b + a*abs(sin(14*t + 0.3))", {"a": "1 1/s", "b": "1 rad/s"}, abs)
    assert found(coursework.solve(parse_variant(four_bar(law))), "STEP").verdict == "PASS"


@pytest.mark.parametrize(("times", "offered"), [(1.0, False), (300.0, True)])
def test_the_page_has_no_laboratory_that_would_miss_the_pulse(times, offered):
    run = coursework.solve(parse_variant(four_bar(pulse(1e4 / times, times * WIDTH), scheme="rk4")))
    part = live_part(PageContext(run, load_words("en")))
    assert part.laboratory == offered
    assert part.words["no_laboratory"].startswith("The laboratory is left out of this page: the drive") != offered


@pytest.mark.parametrize(("low", "follows"), [(0.02, True), (1e-4, False)])
def test_the_page_looks_at_what_a_reader_may_set(low, follows):
    run = coursework.solve(parse_variant(four_bar(pulse(33.0, 0.03), scheme="rk4")))
    sliders = sliders_of(run, str)
    assert followed(run, sliders | {"T": sliders["T"] | {"low": low}}, run.step / 16) == follows


def test_rows_that_cannot_be_followed_are_not_tried_again_closer(monkeypatch):
    """With an oscillation that is quickest at the begin each try took five seconds, and no next one was any nearer."""
    tried = []
    monkeypatch.setattr("coursework.results.checks.advice.finer", lambda *given: tried.append(given))
    step = found(coursework.solve(parse_variant(four_bar(pulse()))), "STEP")
    assert step.verdict == "COARSE"
    assert "Take --step" not in step.sentence
    assert len(tried) == 1
