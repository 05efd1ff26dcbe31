"""Plots by matplotlib, judged by what they draw: labels, units, legend, data."""

import matplotlib as mpl
import numpy as np
import pytest

mpl.use("Agg")
import matplotlib.pyplot as plt

import coursework


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def test_one_column_with_the_motion_beside_it():
    run = coursework.solve("31")
    axes = run.plot("w3", exact=True)
    rows, motion = axes.lines
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("t, s", "ω₃, rad/s")
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["explicit Euler", "exact motion"]
    np.testing.assert_array_equal(rows.get_xydata(), np.column_stack([run.motion.t, run.motion.column("w3")]))
    assert len(motion.get_xdata()) == 8 * 24 + 1
    np.testing.assert_allclose(motion.get_ydata()[::8], run.exact.column("w3"), rtol=0, atol=1e-9)
    assert rows.get_marker() != motion.get_marker()  # told apart without colours


def test_names_of_one_unit_share_axes_and_others_have_their_own():
    run = coursework.solve("example-2")
    alone = run.plot(*run.variant.rates[:1])
    both = run.plot("t" if False else run.motion.names[0], *run.motion.velocity_names)
    assert alone.get_ylabel().endswith("rad/s")
    units = [axes.get_ylabel().rpartition(", ")[2] for axes in both]
    assert len(units) == len(set(units)) > 1
    assert set(units) == {run.variant.unit_of(name) for name in (run.motion.names[0], *run.motion.velocity_names)}


def test_accelerations_and_points_are_drawn_like_any_column():
    run = coursework.solve("31")
    axes = run.plot("dw3", "M.vy", exact=True)
    assert [one.get_ylabel() for one in axes] == ["dω₃/dt, rad/s²", "M.vy, m/s"]
    second, velocity = (one.lines[0].get_ydata() for one in axes)
    np.testing.assert_array_equal(second, run.results.accelerations[:, run.motion.velocity_names.index("w3")])
    np.testing.assert_allclose(velocity, 4.5 * np.sin(13.08 * run.motion.t + 4.35), rtol=0, atol=1e-9)  # the drive
    for name in ("dw9", "Q.x"):
        with pytest.raises(coursework.InputError, match=name):
            run.plot(name)


def test_own_axes_are_drawn_into():
    _, axes = plt.subplots()
    assert coursework.solve("31").plot(ax=axes) is axes
    assert [line.get_label() for line in axes.lines] == ["ω₁", "ω₂", "ω₃", "ω₄"]


def test_a_motion_that_stops_is_drawn_to_its_last_row():
    run = coursework.solve(coursework.load("31").with_data({"alpha": 0.02}))
    rows, motion = run.plot("w3", exact=True).lines
    assert len(rows.get_xdata()) == 6
    assert motion.get_xdata()[-1] == run.exact.t[-1]


def test_the_study_falls_with_the_order_of_each_scheme():
    study = coursework.solve("31", quantities=["accuracy"]).accuracy
    axes = study.plot()
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("evaluations", "largest error, rad")
    drawn = {line.get_label(): line.get_xydata() for line in axes.lines}
    assert set(drawn) == {row.method for row in study.rows if not row.failed}
    euler = drawn["explicit Euler"]
    slope = np.polyfit(*np.log(euler[euler[:, 1] < 0.05]).T, 1)[0]
    assert -1.1 < slope < -0.9


def test_the_study_of_accuracy_is_plotted_unasked_or_says_why_not():
    found = coursework.solve("31", quantities=["table"])
    assert len(found.accuracy.plot().lines) > 5
    stopped = coursework.solve(coursework.load("31").with_data({"alpha": 0.02}), quantities=["table"])
    for run in (stopped, coursework.solve("31", quantities=["phi3"])):
        with pytest.raises(coursework.InputError, match="D039 a study of accuracy needs the whole motion and all columns"):
            run.accuracy.plot()
    with pytest.raises(coursework.InputError, match='C001 "accelerations" needs every coordinate, not only what phi3 needs'):
        _ = run.points


def test_round_off_is_that_of_the_columns_asked_for_and_nothing_where_forces_move(monkeypatch):
    monkeypatch.setattr("coursework.results.accuracy.round_off.SUBSTEPS", (1, 4))
    found = coursework.solve("31", quantities=["phi3"])
    assert found.round_off["double"][24] == pytest.approx(abs(found.table["phi3"].iloc[-1] - found.exact.column("phi3")[-1]))
    with pytest.raises(coursework.InputError, match="D040 round-off is studied for motion that a drive gives"):
        _ = coursework.solve("falling-arm", scheme="euler", quantities=["table"]).round_off
