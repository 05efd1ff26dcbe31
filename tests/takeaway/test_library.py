"""The library as a scientist expects it: truth values, texts of the command line, frames, pools, sentences for slips."""

import pickle
import warnings
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import coursework
from coursework import many
from coursework.api import step_choice
from coursework.procedures import CannotAssemble, Guide, Pair, crank, rrp, rrr

WRONG = [
    (lambda: coursework.solve("31", gain="x"), "gain: a number"),
    (lambda: coursework.solve("31", error=True), "error: a number"),
    (lambda: coursework.solve("31", quantities=[1]), "names of quantities"),
    (lambda: coursework.solve("31", quantities=["M.vx"]), "run.points"),
    (lambda: coursework.solve("31", step="20 kg"), "a step in seconds"),
    *(
        (lambda text=text: coursework.solve("31", step=text), "a step in seconds")
        for text in ("H/2", "x/2", "h/0", "h/-2", "0h/2")
    ),
    (lambda: coursework.solve("31", student=5), "student: a text"),
    (lambda: coursework.solve("31", scheme="RK4"), 'mean "rk4"'),
    (lambda: coursework.solve("31", precision="half"), "double or single"),
    (lambda: coursework.solve("31").of("accelerationz"), 'mean "accelerations"'),
    (lambda: coursework.solve("31").plot("w9"), "no column"),
    (lambda: coursework.solve("31").plot(["w3", "w2"]), 'one by one, not as a list: "w3", "w2".'),
    (lambda: coursework.solve("31").scene.march(0.01, "nope"), "no scheme"),
    (lambda: coursework.solve("31").exact.at(0.481), "outside the motion"),
    (lambda: coursework.solve("31").exact.at(-0.001), "outside the motion"),
    (lambda: coursework.solve("31").exact.at(0.48 * (1 + 1.1e-9)), "outside the motion"),
    (lambda: coursework.solve("31").exact.at("50 kg"), "the time must be a number of seconds"),
    (lambda: coursework.load("31").with_data({"R1": 1.0}), 'mean "r1"'),
    (lambda: coursework.load("31").unit_of("nope"), "no column"),
    (lambda: coursework.load("31").with_data({"r1": -0.953}), "above zero"),
    (lambda: coursework.parse_variant(coursework.load("31").path.read_text("utf-8").replace('"0.953', '"-0.953')), "above zero"),
    (lambda: coursework.solve("31", step=True), "a number of seconds"),
    (lambda: coursework.compile_model("31").bind({"r1": [0.9, 0.95]}), "2 sets"),
    (lambda: coursework.compile_model("31").rates(0, [1, 2]), "shapes"),
    (lambda: coursework.solve_many("31", {"r1": [-0.9]}), "above zero"),
    (lambda: coursework.solve_many("31", {}, quantities=["u"]), "no column"),
]


@pytest.mark.parametrize(("slip", "told"), WRONG, ids=[told for _, told in WRONG])
def test_a_slip_is_a_sentence(slip, told):
    with pytest.raises(coursework.InputError, match=told) as caught:
        slip()
    assert isinstance(caught.value, ValueError)


def test_a_time_with_a_unit_and_a_point_that_is_not_there():
    run = coursework.solve("31")
    assert run.exact.at(["50 ms", 0.05, "0.05"]).t.tolist() == [0.05] * 3
    for points in (run.points, run.exact.points):
        with pytest.raises(KeyError, match=r"no point 'Q'.* Points: .*B.*M"):
            points["Q"]
        with pytest.raises(KeyError, match="speed"):
            points["B", "speed", "x"]
        assert points["B"].velocity.shape[1] == 2


@pytest.mark.parametrize("take", [coursework.solve, coursework.feasible, coursework.compile_model, coursework.exact])
def test_one_way_of_taking_a_variant(take):
    for given in (31, "31", coursework.load("31").path, coursework.load(31)):
        take(given)
    for given in (None, 3.1, True, ["31"]):
        with pytest.raises(TypeError, match="a variant is given by"):
            take(given)


def test_what_is_no_text_and_no_run_is_told():
    with pytest.raises(TypeError, match="text or bytes"):
        coursework.parse_variant(None)
    with pytest.raises(coursework.OutputError, match="a run"):
        coursework.write_report(coursework.solve("31").table, "report.html")
    with pytest.raises(coursework.OutputError, match="a path"):
        coursework.write_report(coursework.solve("31"))


def test_an_impossible_motion_is_false_and_says_why():
    found = coursework.feasible(coursework.load("31").with_data({"alpha": 0.02}))
    possible, why = found
    assert not found
    assert (possible, why) == (False, found.why)
    assert coursework.feasible("31")


def test_slips_of_a_file_are_warned_of_and_stand_first_in_a_notebook():
    doubtful = coursework.load("31").with_data({"r1": 950.0})
    with pytest.warns(coursework.CourseworkWarning, match="950 mm"):
        run = coursework.solve(doubtful, quantities=["table"])
    page = run._repr_html_()
    assert page.index("950 mm") < page.index("<svg")
    assert "r₁ = 950" in page or "950 m" in page


def test_a_motion_that_stops_is_warned_of_where_a_bare_table_is_returned():
    stopping = coursework.load("31").with_data({"alpha": 0.02})
    with pytest.warns(coursework.CourseworkWarning, match="dead point"):
        assert len(coursework.exact(stopping)) == 6
    assert repr(coursework.solve(stopping)).startswith("<Run of 31 (alpha = 0.02 rad): euler, h = 0.02 s, stops at 0.1169 s")


def test_the_end_of_a_run_is_the_time_of_its_last_row():
    with pytest.warns(coursework.CourseworkWarning, match="last row"):
        run = coursework.solve("31", end=0.49)
    assert run.end == run.table.index[-1] == 0.48
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert coursework.solve("31", end="480 ms").remarks == ()


@pytest.mark.parametrize("text", ["20 ms", "0.02", "0.02 s", 0.02, "h/1", "h"])
def test_a_step_is_taken_as_the_command_line_takes_it(text):
    if text == "h":
        with pytest.raises(coursework.InputError):
            coursework.solve("31", step=text)
    else:
        assert coursework.solve("31", step=text).step == 0.02


def test_the_advice_runs():
    advice = coursework.solve("31").advice
    assert coursework.solve("31", step=advice.step).checks
    for better in (coursework.solve("31", step=advice.step), coursework.solve("31", scheme=advice.scheme)):
        assert "COARSE" not in {check.verdict for check in better.checks}
    assert coursework.solve("31", scheme="rk4").advice.step is None
    one = coursework.solve("31", step=0.02 / 12)  # coarse in one check alone
    assert one.advice.step == next(check.step for check in one.checks if check.verdict == "COARSE")


def test_a_step_for_an_error_keeps_it():
    run = coursework.solve("31", step="auto", error=0.01, quantities=["table"])
    off = np.abs(run.motion.coordinates - run.scene.exact.coordinates).max()
    assert 0.005 < off <= 0.01


def test_round_off_turns_up_in_single_precision():
    curve = coursework.solve("31", precision="single", end=0.06, quantities=["table"]).round_off
    assert list(curve.columns) == ["double", "single", "running"]
    assert list(curve.index[:3]) == [3, 12, 48]  # 0.06 s in steps of 0.02 s, and of a quarter of those
    assert curve["single"].iloc[-1] > 1.5 * curve["single"].min()
    assert curve["double"].is_monotonic_decreasing


def test_between_rows_the_exact_motion_is_that_of_a_finer_table():
    run, finer = coursework.solve("31", quantities=["table"]), coursework.solve("31", step=0.005, quantities=["table"])
    times = [0.31, 0.005, 0.48, 0.1]
    found = run.exact.at(times)
    rows = [round(time / 0.005) for time in times]
    assert found.t.tolist() == times
    np.testing.assert_allclose(found.coordinates, finer.exact.coordinates[rows], rtol=0, atol=1e-11)
    np.testing.assert_allclose(found.points["B"].position, finer.exact.points["B"].position.iloc[rows], rtol=0, atol=1e-11)
    assert run.exact.at(0.1).column("w3").shape == (1,)
    assert run.exact.at(0.48 * (1 + 0.9e-9)).rows.tolist() == run.exact.at(0.48).rows.tolist()  # that row, but for round-off


def test_points_are_frames_by_point_and_quantity():
    """The accelerations against differences of the velocities of a finer exact motion."""
    run = coursework.solve("31", step=0.001, quantities=["table"])
    frame = run.exact.points
    velocity, acceleration = frame["B"].velocity.to_numpy(), frame["B"].acceleration.to_numpy()
    assert frame.columns.names == ["point", "quantity", "axis"]
    assert acceleration.shape == (len(run.table), 2)
    middle = (velocity[2:] - velocity[:-2]) / 0.002
    assert np.abs(middle - acceleration[1:-1]).max() < 1e-3 * np.abs(acceleration).max()


def test_many_sets_are_a_sequence_of_tables_with_their_data():
    solved = coursework.solve_many("31", {"p": [12.0, 13.08, 14.0]}, quantities=["w3", "phi1"])
    assert len(solved) == 3
    assert [list(table.columns) for table in solved] == [["w3", "phi1"]] * 3
    assert solved[1]["w3"].tolist() == coursework.solve("31").table["w3"].tolist()
    assert solved.data["p"].tolist() == [12.0, 13.08, 14.0]
    assert solved.to_frame().loc[(1, 0.06), "w3"] == solved[1].loc[0.06, "w3"]
    series = pd.Series({"p": 12.0})
    assert coursework.solve_many("31", series).values.shape == (1, 25, 7)
    changed = coursework.load("31").with_data(series, start=pd.Series({"phi1": 1.6}))
    assert changed.set_values == {"p": "12 1/s", "phi1": "1.6 rad"}
    with pytest.raises(coursework.InputError, match="found list"):
        coursework.load("31").with_data([12.0])


def test_what_takes_much_lies_in_a_file_and_is_the_same(monkeypatch):
    data = {"p": np.linspace(12.0, 13.0, 5)}
    kept = coursework.solve_many("31", data)
    monkeypatch.setattr(many, "MOST_KEPT", 5 * 25 * 7 * 8 - 1)
    filed = coursework.solve_many("31", data)
    assert isinstance(filed.values, np.memmap)
    assert not isinstance(kept.values, np.memmap)
    assert np.array_equal(kept.values, filed.values)


@pytest.mark.parametrize("looked_at", [False, True])
def test_a_run_travels_with_what_was_computed(looked_at):
    run = coursework.solve("31", quantities=["table", "checks", "accuracy", "graph_check", "plans"])
    if looked_at:
        run.compute()
    sent = pickle.loads(pickle.dumps(run))
    assert ("motion" in vars(sent.scene)) == looked_at
    assert sent == run
    pd.testing.assert_frame_equal(sent.table, run.table)
    assert [check.sentence for check in sent.checks] == [check.sentence for check in run.checks]
    assert sent.scene.ledger.calls.get("motion") == 1


def test_runs_and_motions_are_equal_by_what_they_were_made_of():
    first, second = coursework.solve("31"), coursework.solve("31")
    assert first == second
    assert hash(first) == hash(second)
    assert first.motion == second.motion
    assert first != coursework.solve("31", step=0.01)
    assert first.motion != coursework.solve("31", step=0.01).motion
    with pytest.raises(AttributeError, match="cannot assign to field 'x'"):
        first.x = 1


def test_what_a_person_holds_tells_itself_in_a_line():
    run = coursework.solve("31", quantities=["table", "checks", "accuracy", "graph_check"])
    model = coursework.compile_model("31")
    things = [
        run, run.variant, run.scene, run.results, run.motion, run.exact, run.checks, run.accuracy, run.graph_check, model,
        coursework.solve_many("31", {"p": [12.0]}),
    ]  # fmt: skip
    for thing in things:
        told = repr(thing)
        assert told[0] + told[-1] == "<>"
        assert len(told) < 200, told
    for thing in (run.variant, run.checks, run.accuracy, things[-1]):
        assert "<t" in thing._repr_html_()
    assert "<svg" in run.accuracy._repr_html_()


def test_what_may_be_negative_and_all_faults_at_once():
    assert coursework.load("oscillating-cylinder").with_data({"e": -0.015}).values["e"] == -0.015
    with pytest.raises(coursework.InputError) as caught:
        coursework.load("31").with_data({"phi9": 1.0, "r9": 2.0})
    assert [fault.code for fault in caught.value.faults] == ["D001", "D001"]
    assert [coursework.load("31").unit_of(name) for name in ("dw1", "A.vx", "t")] == ["rad/s²", "m/s", "s"]


def test_data_and_start_values_share_one_name_space():
    variant = coursework.load("31").with_data({"phi1": "95 deg", "r1": "0.95 m"})
    assert variant.coordinates[0].start == pytest.approx(np.deg2rad(95), abs=1e-12)
    assert variant.values["r1"] == 0.95


def test_a_table_says_times_as_they_are_written_and_units():
    table = coursework.solve("31", step="10 ms").table
    assert table.loc[0.35].notna().all()
    assert table.attrs["units"] == dict.fromkeys(("phi1", "phi2", "phi3"), "rad") | {"t": "s"} | {
        f"w{place}": "rad/s" for place in range(1, 5)
    }
    assert (table.attrs["variant"], table.attrs["scheme"]) == ("31", "euler")


def test_a_group_hangs_on_a_group_or_on_a_place():
    turning = crank([0.0, 0.0], length=0.1, angle=[0.3, 0.9], rate=10.0)
    rod = rrp(turning, Guide([0.0, 0.05], angle=0.0), length=0.4, mode=1)
    same = rrp(turning.meets, Guide(Pair([0.0, 0.05]), angle=0.0), length=0.4, mode=1)
    assert rod.accelerations.tolist() == same.accelerations.tolist()
    with pytest.raises(CannotAssemble) as caught:
        rrr([0.0, 0.0], [1.0, 0.0], lengths=(0.4, 0.3), mode=1)
    assert isinstance(caught.value, coursework.CourseworkError)
    assert isinstance(caught.value, ValueError)
    assert pickle.loads(pickle.dumps(caught.value)).rows == caught.value.rows == (0,)
    assert "0.3" in str(caught.value)


def test_everything_named_is_there_and_nothing_else(tmp_path):
    assert {"SCHEMES", "procedures", "names"} <= set(dir(coursework))
    assert coursework.procedures.crank is crank
    assert next(iter(coursework.SCHEMES)) == "euler"
    assert coursework.solve("31").of("accelerations").shape == (25, 4)
    with pytest.raises(AttributeError, match="slove"):
        coursework.slove  # noqa: B018
    text = (Path(coursework.__file__)).read_text(encoding="utf-8")
    assert "if not TYPE_CHECKING:" in text


@pytest.mark.parametrize("asked", [lambda run: step_choice(run, 1e-3), lambda run: run.round_off])
def test_what_needs_the_whole_motion_is_refused_for_one_that_stops(asked):
    run = coursework.solve(coursework.load("31").with_data(given={"alpha": 0.02}), quantities=["table"])
    with pytest.raises(
        coursework.InputError, match=r"D037 the motion stops before its end, .*: 2\*cos\(phi3\) \+ sin\(phi3\) = 0"
    ):
        asked(run)
