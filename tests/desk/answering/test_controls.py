"""What a slider of the desk covers: half of a number to half more of it, a turn about an angle, in steps that its digits have."""

from types import SimpleNamespace

import pytest

from coursework.desk.answering.controls import Written, _control


def control(text, unit, si, path=("given", "r")):
    desk = SimpleNamespace(text=f'[given]\nr = "{text} {unit}"\n', variant=SimpleNamespace(line_of=lambda *place: len(place)))
    return _control(desk, Written(path, text, unit, si))


@pytest.mark.parametrize(("text", "unit", "si", "low", "high", "step"), [
    ("0.5", "m", "m", 0.25, 0.75, 0.01), ("0", "m", "m", -1.0, 1.0, 0.01), ("-2", "m", "m", -3.0, -1.0, 0.01),
    ("40", "m", "m", 20.0, 60.0, 0.1),
    ("400", "mm", "m", 200.0, 600.0, 1.0), ("250.125", "mm", "m", 125.062, 375.188, 0.001),
    ("90", "deg", "rad", -90.0, 270.0, 1.0),
    ("1.5", "rad", "rad", -1.7, 4.7, 0.1), ("0", "rad", "rad", -3.2, 3.2, 0.1), ("50", "m", "m", 25.0, 75.0, 1.0),
    ("49", "m", "m", 24.5, 73.5, 0.1),
    ("7.5", "1/s", "1/s", 3.7, 11.3, 0.1),
])  # fmt: skip
def test_a_slider_goes_outward_to_whole_steps(text, unit, si, low, high, step):
    found = control(text, unit, si)
    assert (found["low"], found["high"], found["step"]) == (low, high, pytest.approx(step))
    assert (found["value"], found["text"], found["name"], found["kind"]) == (float(text), f"{text} {unit}", "r", "given")


def test_a_start_and_a_minus_sign_of_print():
    found = control("−2", "", "", ("coordinates", "phi1", "start"))
    assert (found["kind"], found["name"], found["value"], found["text"], found["line"]) == ("start", "phi1", -2.0, "−2", 2)
