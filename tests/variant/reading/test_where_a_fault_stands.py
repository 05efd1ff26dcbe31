"""Each fault stands at what is wrong: its line, and the column of the value or of the name inside it."""

from __future__ import annotations

import pytest

import coursework
from tests.mechanisms.library import mechanism

AT = "¦"  # before the character at which the fault is told
CHAIN = mechanism("example-1").partition("# --- texts")[0]  # by a drive
FORCED = mechanism("slider-crank-under-a-force")  # by a motor
FOUR_BAR = mechanism("four-bar")


def told(text: str) -> list[tuple[str, int, int]]:
    """Return code, line and column of each fault of a text."""
    try:
        coursework.parse_variant(text)
    except coursework.CourseworkError as error:
        return [(fault.code, fault.line, fault.column) for fault in error.faults]
    return []


def place(text: str) -> tuple[int, int]:
    before = text[: text.index(AT)]
    return before.count("\n") + 1, len(before) - before.rfind("\n")


def test_the_texts_that_are_changed_have_no_fault() -> None:
    assert [told(text) for text in (CHAIN, FORCED, FOUR_BAR)] == [[], [], []]


@pytest.mark.parametrize(("code", "old", "new"), [
    ("V105", 'r1 = "0.4 m"', 'r1 = ¦"0.4 kgg"'),
    ("V105", 'w1 = "w0"', 'w1 = { pieces = [["0 s", "w0"], [¦"0.1 kgg", "w0"]] }'),
    ("V053", 'w1 = "w0"', 'w1 = { pieces = [["0 s", "w0"], ["0.1 s", "2*¦w9"]] }'),
    ("V053", 'w1 = "w0"', 'w1 = """2*¦w9"""'), ("V053", 'w1 = "w0"', "w1 = '''2*¦w9'''"), ("V053", 'w1 = "w0"', "w1 = '¦w9'"),
    ("V068", 'w1 = "w0"', 'w1 = { pieces = [[¦"0.01 s", "w0"], ["0.1 s", "w0"]] }'),
    ("V074", 'w1 = "w0"', 'w1 = { pieces = [["0 s", "w0"], ["0.1 s", "w0"], ¦["0.1 s", "w0"]] }'),
    ("V063", 'step   = "2*pi/(36*w0)"', 'step = ¦"0 s"'),
    ("V071", 'end    = "2*pi/w0"', 'end = ¦"0.01 s"'),
    ("V077", "[points]", "check_row = ¦38\n[points]"),
    ("V064", 'period = "2*pi/w0"', 'period = ¦"0 s"'),
    ("V065", "[points]", 'scheme = ¦"eulr"\n[points]'),
    ("V066", "[ask]", '[[quote]]\nrow = ¦38\ncolumn = "w2"\nvalue = "1.5"\n[ask]'),
    ("V067", "[ask]", '[[quote]]\nrow = 37\ncolumn = ¦"w7"\nvalue = "1.5"\n[ask]'),
    ("V065", "[ask]", '[[quote]]\nrow = 37\ncolumn = "w2"\nvalue = "1.5"\nscheme = ¦"eulr"\n[ask]'),
    ("V157", 'from        = ["B", "D"]', 'from = ["B", ¦"B"]'),
    ("V053", 'from        = ["B", "D"]', 'from = ["B", "¦E"]'),
    ("V053", 'lengths     = ["r2", "r3"]', 'lengths = ["r2", "¦r9"]'),
    ("V080", 'coordinates = ["theta2", "theta3"]', 'coordinates = ["theta2", ¦"theta9"]'),
    ("V163", 'w2" }\n3 = {', 'w2" }\n0 = ¦{'),
    ("V157", 'points = ["D", "C"]', 'points = ["D", ¦"D"]'),
    ("V078", 'points = ["D", "C"], rate = "w3"', 'points = ["D", "C"], rate = ¦"w9"'),
    ("V079", 'points = ["D", "C"], rate = "w3"', 'points = ["D", "C"], rate = "w3", slides = ¦"3"'),
    ("V079", 'points = ["D", "C"], rate = "w3"', 'points = ["D", "C"], rate = "w3", slides = ¦"4"'),
    ("V157", 'hinges = ["A", "D"]', 'hinges = ["A", ¦"A"]'),
    ("V105", "[ask]", 'rails = [{ through = "A", angle = "0" }, { through = "D", angle = ¦"0 kgg" }]\n[ask]'),
    ("V053", "[ask]", 'rails = [{ through = "A", angle = "0" }, { through = "¦E", angle = "0" }]\n[ask]'),
])  # fmt: skip
def test_in_a_chain(code: str, old: str, new: str) -> None:
    assert old in CHAIN
    text = CHAIN.replace(old, new, 1)
    assert told(text.replace(AT, "")) == [(code, *place(text))]


@pytest.mark.parametrize(("code", "old", "new"), [
    ("V751", 'inertia = "0.0533 kg*m^2"', 'inertia = ¦"rodd"'),
    ("V704", 'inertia = "0.0533 kg*m^2"', 'inertia = ¦"-0.0533 kg*m^2"'),
    ("V704", 'mass = "12 kg"', 'mass = ¦"-12 kg"'),
    ("V704", 'C = { mass = "20 kg" }', 'C = ¦"-20 kg"'),
    ("V050", 'centre = "B + 0.4 @ theta2"', 'centre = ¦"0.4"'),
    ("V703", "[forces]", '[forces]\ngravity = ¦{ on = "C", at = "C", force = "(-F, 0)" }'),
    ("V704", "[forces]", '[forces]\ngravity = ¦"-9.81 m/s^2"'),
    ("V705", "[forces]", '[forces]\ngravty = ¦"9.81 m/s^2"'),
    ("V707", 'F1 = { on = "C", at = "C", force', 'F1 = ¦{ at = "C", force'),
    ("V707", 'force = "(-F, 0)" }', 'force = "(-F, 0)" }\nF2 = ¦{ on = "C" }'),
    ("V708", 'force = "(-F, 0)" }', 'force = "(-F, 0)" }\nF2 = ¦{ on = "C", force = "(-F, 0)" }'),
    ("V745", "[motor]", 'S = ¦{ spring = ["A", "A"], stiffness = "1 N/m", free = "1 m" }\n[motor]'),
    ("V706", "[motor]", 'S = ¦{ spring = ["A", "C"], stiffness = "1 N/m" }\n[motor]'),
    ("V706", "[motor]", 'S = ¦{ damper = ["A", "C"] }\n[motor]'),
    ("V704", "[motor]", 'S = { spring = ["A", "C"], stiffness = ¦"-1 N/m", free = "1 m" }\n[motor]'),
    ("V709", "[motor]", '[friction]\nC = ¦{ radius = "1 cm" }\n[motor]'),
    ("V704", "[motor]", '[friction]\nC = { coefficient = ¦"-0.1" }\n[motor]'),
    ("V717", 'rates = ["w1"]', 'rates = ["w1", ¦"w1"]'),
    ("V714", 'rates = ["w1"]', 'rates = ["w1", ¦"w9"]'),
    ("V715", 'rates = ["w1"]', 'rates = ¦["w1", "w2", "u3"]'),
    ("V712", 'rates = ["w1"]', 'rates = ["w1"]\nstart = { w2 = ¦"1 rad/s" }'),
])  # fmt: skip
def test_among_forces(code: str, old: str, new: str) -> None:
    assert old in FORCED
    text = FORCED.replace(old, new, 1)
    assert told(text.replace(AT, "")) == [(code, *place(text))]


@pytest.mark.parametrize(("code", "entry"), [
    ("V150", '¦{ unit = "m/s", along = "0 deg" }'), ("V154", '¦{ unit = "m/s", of = "C" }'),
    ("V151", '{ unit = "m/s", of = "C", along = "0 deg", relative = ¦"9" }'), ("V151", '{ unit = "1/s", of = ¦"link 9" }'),
    ("V152", '{ unit = ¦"1/s", of = "C", along = "0 deg" }'), ("V152", '{ unit = ¦"m/s", of = "link 2" }'),
    ("V153", '{ unit = "1/s", of = "link 2", along = ¦"0 deg" }'), ("V059", '{ unit = "m/s", of = ¦"Q", along = "0 deg" }'),
])  # fmt: skip
def test_of_an_unknown_that_is_a_velocity_of_the_geometry(code: str, entry: str) -> None:
    text = mechanism("v110", ('{ unit = "m/s", of = "C", along = "0 deg" }', entry))
    assert told(text.replace(AT, "")) == [(code, *place(text))]
