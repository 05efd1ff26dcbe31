"""Where only the start is wrong it is told, not the equations; a wrong equation is told whatever the start."""

import math

import pytest

import coursework
from coursework.motion.geometry.closure import compile_closure
from coursework.motion.geometry.judging.open_loops import with_closed_loops
from tests.mechanisms.library import mechanism


def lever(start, turns):
    """Return a lever in whose slot the pin of a crank stands at atan2(d, r) when the crank lies on x, with a start (deg) of its
    own, and its rate by the cosine of the angle between crank and lever or by its sine.
    """
    return mechanism("slotted-lever", ("68.19859051363818", str(start)), ("r*w1*cos(phi1 - th)", f"r*w1*{turns}(phi1 - th)"))


@pytest.mark.parametrize(("start", "turns", "told"), [(60, "cos", "V310"), (60, "sin", "V302"), (68.19859051, "sin", "V302")])
def test_the_start_or_the_equation_is_told(start, turns, told):
    with pytest.raises(coursework.InputError) as caught:
        assert coursework.solve(coursework.parse_variant(lever(start, turns))).scene.closure
    assert [fault.code for fault in caught.value.faults] == [told]
    if told == "V310":
        off = math.hypot(0.1, 0.25) * math.sin(math.radians(60) - math.atan2(0.25, 0.1))
        assert f"{off:.6g} m. Correct the start; the nearest with zero is phi1 = 0 deg, th = 68.1985905 deg" in str(caught.value)


@pytest.mark.parametrize(("most", "start"), [(math.inf, 68.19859051), (2e-3, 68.19859051), (1e-4, 68.0)])
def test_a_loop_that_is_open_by_no_more_than_is_allowed_is_closed(most, start):
    """The pin is 0.9 mm beside the slot, 0.2 degrees of a lever 0.27 m long."""
    scene = coursework.solve(coursework.parse_variant(lever(68, "cos"))).scene
    near, left = with_closed_loops(compile_closure(scene.equations, [0.0, math.radians(68)]), most)
    assert near.start[1] == pytest.approx(math.radians(start), abs=1e-9)
    beside = math.hypot(0.1, 0.25) * math.sin(math.radians(0.19859051))
    assert abs(left[0]) == (pytest.approx(beside, rel=1e-6) if start > 68 else 0.0)  # what is kept is not open


def test_where_the_lengths_do_not_meet_the_start_is_told_and_no_link_is_called_bent():
    """A crank of 120 mm does not reach: the loop stays open by some centimetres, which is no fault of the links."""
    run = coursework.solve(coursework.parse_variant(mechanism("windshield-wiper", r1="120 mm")), quantities=["table", "checks"])
    start = next(finding for finding in run.checks if finding.code == "START")
    assert start.verdict == "FAIL" and "there is no closed position near it" in start.sentence


def test_a_likelier_slip_is_told_beside_the_start_that_would_close():
    """With 20 m for 2 m the start is wrong only because the length is."""
    with pytest.raises(coursework.InputError, match=r"V310 .* A likelier slip: L = 20 m beside 0.5 m: 20 cm\?"):
        assert coursework.solve(coursework.parse_variant(mechanism("scissor", L="20 m"))).scene.closure


SLOTTED = """[given]
a = "64 mm"
c = "150 mm"
L = "0.41 m"
[drive]
w = "96 rpm"
[coordinates]
q = { start = "40 deg", rate = "w" }
b = { start = "START deg", rate = "wb" }
[unknowns]
vr = { unit = "m/s", of = "P", along = "b", relative = "lever" }
vE = { unit = "m/s", of = "E", along = "90 deg" }
[time]
step = "5 ms"
end = "0.1 s"
[[constraint]]
name = "along"
equation = "a*w*sin(b - q) = vr"
[[constraint]]
name = "across"
equation = "a*w*cos(b - q) = wb*(a*cos(q)*cos(b) + (c + a*sin(q))*sin(b))"
[[constraint]]
name = "tip"
equation = "vE = L*wb*cos(b)"
[points]
O = "(0, 0)"
Q = "(0, -c)"
P = "O + a @ q"
E = "Q + L @ b"
[links]
crank = { points = ["O", "P"], rate = "w" }
lever = { points = ["Q", "E"], rate = "wb" }
[frame]
hinges = ["O", "Q"]
[closure]
holds = ["(P.y - Q.y)*cos(b) - (P.x - Q.x)*sin(b)"]
"""
CLOSED = "75.6138249601392"  # atan2(c + a sin 40 deg, a cos 40 deg)


@pytest.mark.parametrize(("start", "slip", "told"), [
    (CLOSED, ("", ""), []), ("76", ("", ""), [("V310", "")]),
    ("76", ("vE = L", "vE = -L"), [("V302", "tip")]), ("76", ("(c + a", "(c - a"), [("V302", "across")]),
    ("76", ("sin(b - q) = vr", "sin(q - b) = vr"), [("V302", "along")]),
])  # fmt: skip
def test_beside_a_wrong_equation_a_start_that_closes_nothing_makes_no_right_one_wrong(start, slip, told):
    """With its pin beside the slot, "along" contradicts the geometry too: the lever's velocity at the pin has a part along it."""
    text, found = SLOTTED.replace("START", start).replace(*slip), []
    try:
        assert coursework.solve(coursework.parse_variant(text)).scene.closure
    except coursework.InputError as error:
        found = [(one.code, str(one.message.values.get("name", ""))) for one in error.faults]
    assert found == told
