"""Faults of a frame saw and of a quick return: each is told once, at its line, and is gone when the advice is followed."""

from __future__ import annotations

import pytest

import coursework
from coursework.commands.contradictions import terms_named
from tests.mechanisms.library import mechanism

ONE_AXIS = mechanism("crank-driven-along-one-axis")
SAW = """
format = 1
title = "Frame saw"
[given]
l = "12 cm"
L = "45 cm"
n = "90 rpm"
[drive]
om = "n"
[coordinates]
q = { start = "25 deg", rate = "om" }
s = { start = "-6.8764 deg", rate = "ws" }
[unknowns]
vB = { unit = "m/s", of = "B", along = "0 deg" }
[time]
step = "0.01 s"
end = "0.6 s"
period = "2*pi/n"
[[constraint]]
name = "x"
equation = "-l*om*sin(q) - L*ws*sin(s) = vB"
[[constraint]]
name = "y"
equation = "l*om*cos(q) + L*ws*cos(s) = 0"
[points]
O = "(0, 0)"
A = "O + l @ q"
B = "A + L @ s"
[links]
1 = { points = ["O", "A"], rate = "om" }
2 = { points = ["A", "B"], rate = "ws" }
[frame]
hinges = ["O"]
rails = [ { through = "B", angle = "0" } ]
[closure]
holds = ["B.y"]
"""
RETURN = """
format = 1
[given]
a = "0.11 m"
b = "0.24 m"
n = "7 rad/s"
[drive]
wk = "n"
[coordinates]
k = { start = "20 deg", rate = "wk" }
z = { rate = "wz" }
x = { rate = "vx" }
[time]
step = "pi/(18*n)"
end = "2*pi/n"
[points]
O = "(0, 0)"
Q = "(0, -b)"
[[group]]
kind = "crank"
from = ["O"]
meets = "A"
lengths = ["a"]
coordinates = ["k"]
[[group]]
kind = "RPR"
from = ["A", "Q"]
coordinates = ["z", "x"]
mode = "+1"
"""
FORCES = """
[masses]
1 = { mass = "2 kg", inertia = "rod" }
2 = { mass = "1.5 kg", inertia = "rod" }
[forces]
gravity = "9.81 m/s^2"
"""
PLAIN = SAW.replace('{ unit = "m/s", of = "B", along = "0 deg" }', '"m/s"')
SINGLE = SAW.replace('[[constraint]]\nname = "x"', '[constraint]\nname = "x"')
MOTOR = SAW.replace('[drive]\nom = "n"\n', "") + FORCES + '[motor]\nrates = ["om"]\n1 = { torque = "3 N*m" }\n'


@pytest.mark.parametrize(
    ("file", "right", "wrong", "code", "advice", "mended"),
    [
        (SAW, 'L = "45 cm"', 'L = "45 cm";', "V009", "after the closing quotation mark only a remark may stand", None),
        (SAW, '"Frame saw"', '"Frame "saw""', "V009", "inside a text use ' in place of \"", "\"Frame 'saw'\""),
        (SAW, 'L = "45 cm"', "L' = \"45 cm\"", "V009", "letters, digits, _ and - only", None),
        (SAW, '"ws" }\n[unknowns]', '"ws", }\n[unknowns]', "V009", "take out the comma before }", None),
        (SAW, '{ start = "25 deg"', '{\n start = "25 deg"', "V009", "a table in braces must be on one line", None),
        (SAW, '["B.y"]', '["B.y"\n\n# what is asked', "V009", 'is missing (found "holds = ["B.y"")', None),
        (SAW, '[[constraint]]\nname = "x"', '[constraint]\nname = "x"', "V009", "write [[constraint]], in double brackets", None),
        (SINGLE, '[[constraint]]\nname = "y"', '[constraint]\nname = "y"', "V009", "write [[constraint]], in double", SINGLE),
        (SAW, "[coordinates]", "[coordinate]", "V011", 'Did you mean "coordinates"?', None),
        (SAW, '25 deg", rate', '25 deg", Rate', "V011", 'Did you mean "rate"?', None),
        (SAW, 'equation = "l*om', 'eqation = "l*om', "V011", 'Did you mean "equation"?', None),
        (SAW, "[drive]", 'e.1 = "3 cm"\n[drive]', "V011", 'If "." belongs to a name, leave it out: e1.', 'e1 = "3 cm"\n[drive]'),
        (SAW, "[drive]", 'e = { valeu = "3 cm" }\n[drive]', "V011", 'Did you mean "value"?', 'e = { value = "3 cm" }\n[drive]'),
        (SAW, '"90 rpm"', '"3*pi 1/s"', "V162", 'Write "9.42477796076938 1/s".', '"9.42477796076938 1/s"'),
        (SAW, '"90 rpm"', '"3*pi"', "V162", 'Write "9.42477796076938 rad/s".', '"9.42477796076938 rad/s"'),
        (SAW, '"45 cm"', '"1 200 mm"', "V107", 'then its unit: "1200 mm".', '"1200 mm"'),
        (SAW, '"45 cm"', '"cm 45"', "V107", 'then its unit: "45 cm".', '"45 cm"'),
        (SAW, '"25 deg"', '"25 m"', "V205", 'Write "25 deg".', '"25 deg"'),
        (SAW, '"0.6 s"', '"T"', "V053", "Declare it once: in [given].", '"T"\n#'),
        (SAW, '"0.6 s"', '"2*pi/om"', "V052", "only given data can.", '"2*pi/n"'),
        (SAW, 'unit = "m/s", of', "of", "V013", 'Write unit = "m/s".', None),
        (SAW, 'unit = "m/s", of', 'unit = "rad/s", of', "V152", "its unit is m/s", None),
        (PLAIN, '"m/s"', '""', "V111", 'found "". Known units: m/s,', None),
        (SAW, '["B.y"]', '["B.y = 0"]', "V146", "where two sides are to stay equal, one minus the other.", None),
        (SAW, 'hinges = ["O"]', 'hinges = ["\N{CYRILLIC CAPITAL LETTER O}"]', "V059", 'looks like the Latin "O"', None),
        (SAW, "[closure]", '[closure]\ndriven = "A"', "V048", "Where om is what is driven, leave driven out.", None),
        (ONE_AXIS, "[ask]", '[closure]\ndriven = "M"\n[ask]', "V048", "VMx alone then drives it.", None),
        (SAW, '"(0, 0)"', '"0, 0"', "V145", "a place is written in parentheses: (x, y).", None),
        (RETURN, 'meets = "A"\n', "", "V053", "Declare it once: in [points], or as what a group meets.", None),
        (RETURN, '["z", "x"]', '["z"]', "V343", "RPR takes 2 coordinates (found 1).", None),
        (RETURN, '["z", "x"]', '["k", "x"]', "V348", "k is already in group 1.", None),
        (RETURN, 'wk = "n"', 'k = "n*t"', "V161", "Write the derivative of the law there, wk = …", None),
        (SAW + FORCES, '"rod" }\n2', '"bar" }\n2', "V751", 'Write "rod", "disc", "point" or a value', None),
        (MOTOR, '1 = { torque = "3 N*m" }', 'torque = "3 N*m"', "V713", 'Write 1 = { torque = "M0 - k*w1" }.', None),
        (MOTOR, 'rates = ["om"]\n', "", "V710", 'Add rates = ["om"] to [motor].', None),
    ],
)  # fmt: skip
def test_one_fault_is_told_and_its_advice_mends_it(
    file: str, right: str, wrong: str, code: str, advice: str, mended: str | None
) -> None:
    assert file.count(right) == 1
    text = file.replace(right, wrong)
    with pytest.raises(coursework.InputError) as caught:
        coursework.parse_variant(text)
    (fault,) = caught.value.faults
    assert (fault.code, advice in str(fault.message)) == (code, True), str(fault)
    begins = text[: text.index(wrong)].count("\n") + 1
    assert begins <= fault.line <= begins + wrong.count("\n") or code in {"V011", "V053", "V161", "V343", "V710"}
    if mended == '"T"\n#':
        coursework.parse_variant(text.replace("[drive]", 'T = "0.6 s"\n[drive]'))
    elif mended != SINGLE:
        coursework.parse_variant(file if mended is None else text.replace(wrong, mended))


def test_a_datum_that_is_a_formula_goes_to_functions_whatever_unit_follows_it() -> None:
    for found in ("0.25*l m", "0.25*l"):
        with pytest.raises(coursework.InputError, match=r'V164 .* Write e = "0.25\*l" in \[functions\]'):
            coursework.parse_variant(SAW.replace("[drive]", f'e = "{found}"\n[drive]'))
    coursework.parse_variant(SAW.replace("[points]", '[functions]\ne = "0.25*l"\n[points]'))


def test_the_unit_of_a_square_is_read_without_its_sign() -> None:
    plain, with_sign = (coursework.parse_variant(SAW + FORCES.replace("m/s^2", unit)) for unit in ("m/s2", "m/s^2"))
    assert plain.forces == with_sign.forces
    with pytest.raises(coursework.InputError, match="V120"):  # no unit is called m2
        coursework.parse_variant(SAW.replace('"(0, 0)"', '"(2 m2, 0)"'))


def test_a_spring_between_points_whose_angles_differ_is_not_idle() -> None:
    """With the angles s = q + 1, the distance of B from O would be the same everywhere."""
    spring = SAW + FORCES + 'sp = { spring = ["O", "B"], stiffness = "5 N/mm", free = "30 cm" }\n'
    assert not [one for one in coursework.parse_variant(spring).plausibility if one.code == "IDLE"]
    (idle,) = coursework.parse_variant(spring.replace('["O", "B"]', '["O", "A"]')).plausibility
    assert (idle.code, "O and A keep their distance" in str(idle.sentence)) == ("IDLE", True)


POSITION = 'equation = "l*sin(q) + L*sin(s) = 0"'
VELOCITY = 'equation = "l*om*cos(q) + L*ws*cos(s) = 0"'


def refused(text: str) -> list[str]:
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve(coursework.parse_variant(text), quantities=["table"]).columns()
    return [str(fault) for fault in caught.value.faults]


def test_an_equation_of_positions_is_told_as_that_and_runs_as_a_closure() -> None:
    (told,) = refused(SAW.replace(VELOCITY, POSITION))
    assert "V405 variant:24  equation y contains no velocity. Write its derivative, or closure =" in told
    closed = SAW.replace(VELOCITY, POSITION.replace("equation", "closure")).replace("-6.8764", "-6.4709")
    assert len(coursework.solve(coursework.parse_variant(closed), quantities=["table"]).table) == 61


def test_a_drive_that_moves_nothing_is_told_at_its_line_before_what_follows_from_it() -> None:
    (told,) = refused(SAW.replace('om = "n"', 'omega = "n"'))
    assert "V404 variant:9  3 unknown velocities (om, ws, vB) and 2 independent equations of 2. Nothing is moved by omega" in told
    assert "degree of freedom" not in told  # one is driven, if omega is written as om


def test_a_velocity_in_no_equation_is_given_one_or_left_out() -> None:
    (told,) = refused(SAW.replace("[unknowns]", '[unknowns]\nvC = "m/s"'))
    assert told.endswith("Missing: something for vC. vC appears in no equation: write one with it, or leave it out.")


def test_an_equation_that_repeats_another_is_told_at_its_line() -> None:
    (told,) = refused(SAW.replace(VELOCITY, 'equation = "2*vB = -2*l*om*sin(q) - 2*L*ws*sin(s)"'))
    assert told.startswith("V404 variant:24  2 unknown velocities")


@pytest.mark.parametrize(
    ("argument", "code", "advice"),
    [
        ("om", "V203", "the argument of cos(om) is an angular velocity"),
        ("ws", "V402", '"cos(ws)". cos takes an angle or a number.'),
    ],
)
def test_a_velocity_in_the_place_of_an_angle_is_told_as_that(argument: str, code: str, advice: str) -> None:
    (told,) = refused(SAW.replace("om*cos(q)", f"om*cos({argument})"))
    assert (told[:4], advice in told) == (code, True), told


def test_a_term_is_named_without_the_sign_at_its_begin() -> None:
    variant = coursework.parse_variant(SAW.replace("l*om*cos(q) +", "-l*om*cos(q) +"))
    with pytest.raises(coursework.InputError, match=r"the sign of l\*om\*cos\(q\) differs"), terms_named(variant):
        coursework.solve(variant, quantities=["table"]).columns()


def test_a_tabulated_drive_without_its_argument_is_of_time() -> None:
    law = {"law.csv": "".join(f"{place * 0.1:.1f},9\n" for place in range(8)).encode()}
    text = SAW.replace('om = "n"', 'om = { table = "law.csv" }')
    with pytest.raises(coursework.InputError, match=r'V013 variant:9:1 .* the key "of" is missing. Write of = "t"\.$'):
        coursework.parse_variant(text, tables=law)
    coursework.parse_variant(text.replace('"law.csv"', '"law.csv", of = "t"'), tables=law)


def test_a_missing_guide_is_told_with_the_line_to_copy() -> None:
    slider = RETURN.replace('kind = "RPR"\nfrom = ["A", "Q"]', 'kind = "RRP"\nfrom = ["A"]\nlengths = ["b"]')
    (told,) = refused(slider)
    assert 'Write guide = { through = "O", angle = "0 deg" }, with your own' in told
    line = told.partition(" Write ")[2].partition(", with")[0]
    coursework.parse_variant(
        slider.replace('lengths = ["b"]', f'lengths = ["b"]\n{line}').replace('{ rate = "vx"', '{ unit = "m", rate = "vx"')
    )


@pytest.mark.parametrize("name", ["y", "5"])
def test_an_equation_called_by_a_letter_is_told_as_written_where_it_drifts(name: str) -> None:
    closed = SAW.replace(VELOCITY, POSITION.replace("equation", "closure")).replace("-6.8764", "-6.4709")
    run = coursework.solve(coursework.parse_variant(closed.replace('name = "y"', f'name = "{name}"')))
    (drift,) = [check for check in run.checks if check.code == "DRIFT"]
    assert str(drift.sentence).startswith("l*sin(q) + L*sin(s) is 0.0105 m off in row 30") is (name == "y")


def test_laws_in_a_circle_are_told_once_at_the_first() -> None:
    (told,) = refused(SAW.replace("[points]", '[functions]\nf = "g + l"\ng = "f - l"\n[points]'))
    assert told == "V057 variant:26:5  functions.f: no law can depend on itself: f → g → f."
