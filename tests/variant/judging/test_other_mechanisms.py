"""Faults as they are told of mechanisms that are not variant 31: their own points and places, advice that can be followed."""

from __future__ import annotations

import re

import pytest

import coursework
from tests.drawing.plans.moving_groups import HEAD, crank, dyad
from tests.mechanisms.library import mechanism

LEVER = HEAD.format(
    name="slotted lever", drive='w1 = "6"', step="0.01 s", end="0.1 s", hinges='["P", "Q"]', rails="",
    coordinates='phi1 = { start = "20 deg", rate = "w1" }\nphi3 = { rate = "w3", unit = "rad" }\n'
    's2 = { rate = "u2", unit = "m" }',
    points='P = "(0, 0)"\nQ = "(0, -0.25)"',
    groups=crank("P", "R", "0.1", "phi1") + dyad("RPR", '["R", "Q"]', '"T"', '["0.5"]', '["phi3", "s2"]'),
)  # fmt: skip
YOKE = HEAD.format(
    name="yoke", drive='w1 = "6"', step="0.01 s", end="0.1 s", hinges='["P"]', rails="",
    coordinates='phi1 = { start = "20 deg", rate = "w1" }\nsi = { rate = "ui", unit = "m" }\nsj = { rate = "uj", unit = "m" }',
    points='P = "(0, 0)"\nK = "(0, -0.2)"',
    groups=crank("P", "R", "0.1", "phi1")
    + dyad("RPP", '["R"]', '"T"', "", '["si", "sj"]', 'guide = { through = "K", angle = "0" }\n'),
)  # fmt: skip


def told(text: str) -> str:
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve(coursework.parse_variant(text), quantities=["table"]).columns()
    return str(caught.value)


def test_the_mechanisms_run_as_they_are() -> None:
    for text in (LEVER, YOKE):
        assert len(coursework.solve(coursework.parse_variant(text), quantities=["table"]).table)


def test_a_place_that_leaves_a_group_open_is_told_with_the_points_of_the_file() -> None:
    on_pivot = LEVER.replace('"(0, -0.25)"', '"(0, -0.1)"').replace("20 deg", "270 deg")
    assert "V306" in (found := told(on_pivot))
    assert "RPR (R, Q) cannot be assembled at t = 0 s: R lies on Q and the rod may point anywhere. Take other lengths" in found
    assert not re.search("positions_only|row 0|length above zero", found)
    along = YOKE.replace('meets = "T"', 'meets = "T"\nangle = "0"')
    assert "the slides are parallel; R and the line of T are 0.2342 m apart." in told(along)
    upon = along.replace('"(0, -0.2)"', '"(0, 0)"').replace("20 deg", "0 deg")
    assert "the slides are parallel, R and the line of T coincide and a block may be anywhere" in told(upon)


def test_of_a_written_equation_and_the_geometry_the_written_one_is_told() -> None:
    written = '\n[[constraint]]\nequation = "u2 = {sign}0.1*w1*sin(phi1 - phi3)"\n'
    assert len(coursework.solve(coursework.parse_variant(LEVER + written.format(sign="-")), quantities=["table"]).table)
    found = told(LEVER + written.format(sign=""))
    line = (LEVER + written).splitlines().index("[[constraint]]") + 2  # where the equation stands
    assert f"V302 variant:{line}  equation 1 contradicts the geometry of [points] and [[group]]" in found
    further = dyad("RPR", '["T", "S"]', '"U"', '["0.5"]', '["phi4", "s5"]') + "\n[frame]"
    more = LEVER.replace("[frame]", further, 1).replace('Q = "(0', 'S = "(0.4, 0.1)"\nQ = "(0')
    more = more.replace("[time]", 'phi4 = { rate = "w4", unit = "rad" }\ns5 = { rate = "u5", unit = "m" }\n[time]')
    assert "quation 1 contradicts" in told(more + written.format(sign=""))


@pytest.mark.parametrize(
    ("old", "new", "where"),
    [
        ('w1 = "6"', 'w1 = "6*k"', "in [given] or [drive]."),
        ('"(0, -0.25)"', '"Z + 1 @ 0"', "in [points], as what a group meets, in [given], [drive] or [coordinates]."),
        ('["R", "Q"]', '["Z", "Q"]', "in [points], or as what a group meets."),
    ],
)
def test_a_name_is_declared_where_it_can_stand(old: str, new: str, where: str) -> None:
    assert f"is not declared. Declare it once: {where}" in told(LEVER.replace(old, new))


@pytest.mark.parametrize(
    ("start", "advice"),
    [
        ("20,5 deg", 'with a point: "20.5 deg".'), ("twenty deg", 'its unit: "0.5 deg".'),
    ],
)  # fmt: skip
def test_a_value_is_advised_in_the_words_that_were_typed(start: str, advice: str) -> None:
    assert advice in told(LEVER.replace("20 deg", start))


@pytest.mark.parametrize(
    ("old", "new", "advice"),
    [('"20 deg"', '""', "0.5 rad"), ('"20 deg"', '"deg"', "0.5 deg"), ('"6"', '"n"\n[given]\nn = ""', "0.5 rad/s"),
     ('"6"', '"n"\n[given]\nn = "s"', "0.5 rad/s")],
)  # fmt: skip
def test_a_value_without_a_number_is_advised_by_what_it_measures(old: str, new: str, advice: str) -> None:
    assert f'Write the number, then its unit: "{advice}"' in told(YOKE.replace(old, new, 1))


def test_the_units_of_what_is_open_are_those_of_the_equations() -> None:
    gears = mechanism("two-gears", ('"0 rad", rate = "w2"', '"0.3 rad", rate = "w2"'))
    assert "residuals 1: 0.3 (rad)." in told(gears)
