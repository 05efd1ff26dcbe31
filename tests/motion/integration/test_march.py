"""The generated rows of a table are those of steps made one by one, to the last bit, and end for the same reason."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.integration.integrate import Correction, March, Row
from coursework.motion.integration.loops import generate_rows
from coursework.motion.schemes import SCHEMES, scheme_of
from coursework.variant.reading.reader import parse_variant
from tests.hard.scenes import V31_IMPOSSIBLE
from tests.solved import solved


def both(run, scheme, step, end, start=None, guarded=()):
    """Return the motion by generated rows and the one by single steps (a correction that corrects nothing)."""
    rates, start = run.scene.rates, start or run.scene.start
    made, nothing = March(rates, scheme_of(scheme), step, guarded=guarded), lambda times: (np.zeros((len(times), 0)),) * 2
    corrections = None, Correction(SimpleNamespace(targets=nothing, driven=()), 0)
    return [replace(made, correction=correction).until(start, end) for correction in corrections]


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("name", ["31", "v105", "example-1", "example-3", "jansen", "variable-crank-table"])
def test_every_row_is_the_same_to_the_last_bit(name, scheme):
    run = solved(name, quantities=["table"])
    rows, steps = both(run, scheme, run.step, run.end)
    for field in ("t", "coordinates", "velocities", "determinants"):
        assert np.array_equal(getattr(rows, field), getattr(steps, field))
    assert (rows.evaluations, rows.stop) == (steps.evaluations, steps.stop)
    assert rows.stop is None


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_step_up_to_a_break_of_the_drive_does_not_look_beyond_it(scheme):
    text = (coursework.load("31").path).read_text(encoding="utf-8")
    old = 'VMy = "V1*sin(p*t + alpha)"'
    assert old in text
    run = coursework.solve(
        parse_variant(text.replace(old, 'VMy = { pieces = [["0 s", "V1*sin(p*t + alpha)"], ["0.1 s", "0.2*V1"]] }')),
        quantities=["table"],
    )
    rows, steps = both(run, scheme, 0.02, 0.2)
    assert run.scene.rates.breaks == (0.1,)
    assert np.array_equal(rows.coordinates, steps.coordinates)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("step", [0.02, 0.01, 0.005, 0.0013])
def test_both_end_in_the_same_row_for_the_same_reason(scheme, step):
    """An impossible motion marched without knowing where it ends: a determinant changes its sign, or a link turns too far."""
    run = coursework.solve(parse_variant(V31_IMPOSSIBLE), quantities=["table"])
    rows, steps = both(run, scheme, step, 0.48, guarded=[0, 1, 2])
    assert rows.stop == steps.stop
    assert rows.stop is not None
    assert np.array_equal(rows.coordinates, steps.coordinates)
    assert len(rows.t) < 0.48 / step


@pytest.mark.parametrize(("guarded", "said"), [([0, 1, 2], "would turn phi3 by"), ([], None)])
def test_both_refuse_a_step_that_turns_a_link_too_far(guarded, said):
    rows, steps = both(coursework.solve("31", quantities=["table"]), "euler", 0.6, 0.6, guarded=guarded)
    assert rows.stop == steps.stop
    assert np.array_equal(rows.coordinates, steps.coordinates)
    assert said is None or said in rows.stop.cause


def test_a_determinant_that_is_a_number_is_not_watched():
    """Variant 31: the block of w4 is the radius, the two others change."""
    rates = coursework.solve("31", quantities=["table"]).scene.rates
    source = generate_rows(SCHEMES["euler"], rates, (), 1.0).__doc__
    assert len(rates.blocks) == 3
    assert source.count("_old") == 2 * 4  # set, multiplied, compared with nothing before, kept


def test_a_start_at_a_dead_point_leaves_no_row():
    run = coursework.solve("31", quantities=["table"])
    start = [1.0, 1.0, 2.87]
    rows, steps = both(run, "euler", 0.02, 0.48, start)
    assert len(rows.t) == len(steps.t) == 0
    assert rows.stop == steps.stop
    assert rows.stop.kind == "not finite"


def test_a_step_that_turns_too_far_is_told_with_the_row_it_leaves():
    rates = SimpleNamespace(coordinates=("phi",))
    stop = Row(4, 0.08, np.zeros(1)).too_wide(rates, 0, 1.7, 0.02)
    assert (stop.row, stop.time) == (4.0, 0.08)
    assert "At row 5 (t = 0.08 s) one step of 0.02 s would turn phi by 1.7 rad (97°)" in str(stop.cause)
    broken = Row(4, 0.08, np.zeros(1)).broken("its block is singular", 0.02)
    assert "At row 5 (t = 0.08 s) the velocities cannot be computed" in str(broken.cause)


@pytest.mark.parametrize(("scheme", "told"), [
    ("euler", "At row 7 (t = 0.9 s) the velocities cannot be computed: a formula has no value"),
    ("heun", "At row 6 (t = 0.75 s) the velocities cannot be computed: inside the next step a formula has no value"),
    ("midpoint", None),
])  # fmt: skip
def test_a_root_that_only_the_scheme_leaves_is_not_told_as_a_singular_block(scheme, told):
    """x = (1 - t)² m by an equation whose determinant is 1 s, and x > 0 to the end of the run at 0.9 s."""
    text = """format = 1
title = "x falls to zero"
given = { k = "1 m", c = "1 s" }
drive = { w = "0 1/s" }
coordinates = { x = { start = "1 m", rate = "v" }, phi = { start = "0 rad", rate = "w" } }
time = { step = "0.15 s", end = "0.9 s" }
constraint = [{ name = "1", because = "of a rope", equation = "c*v + 2*sqrt(k*x) = 0" }]
"""
    stop = coursework.solve(coursework.parse_variant(text), scheme=scheme, quantities=["table"]).stop
    assert stop is None if told is None else told in str(stop.cause)


@pytest.mark.parametrize(("old", "new", "told"), [
    ((1.0, -2.0), (1.5, 0.5), ("-2", "0.5")), ((1.0, 3.0), (0.0, 1.0), ("1", "0")), ((-1.0, 3.0), (0.25, 1.0), ("-1", "0.25")),
    ((0.0, 1.0), (1.0, 1.0), None), ((1.0, -1.0), (2.0, -3.0), None),
])  # fmt: skip
def test_a_determinant_that_has_changed_its_sign_is_told_with_both_values(old, new, told):
    """Of two blocks the first whose sign has changed; one that began at zero has not."""
    rates = SimpleNamespace(velocities=("w",), blocks=(0, 1), coordinates=("q",))
    march = SimpleNamespace(rates=rates, step=0.1, passages=())
    stop = March._crossed(march, (9.0, *old), (-9.0, *new), Row(3, 0.3, np.array([1.0])))
    assert stop is None if told is None else f"went from {told[0]} to {told[1]}." in str(stop.cause).replace("−", "-")
