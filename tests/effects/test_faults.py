"""Bad input of masses and forces: one sentence with the line and what to do."""

import re

import pytest

import coursework
from coursework.variant.formula.units import read_mass
from tests.effects.test_ways import UNNAMED
from tests.mechanisms.library import mechanism

CASES = [
    ("31-forces", 'inertia = "0.454 kg*m^2"', 'inertia = "-0.454 kg*m^2"', "V704", "a value that is not below zero"),
    ("31-forces", ', inertia = "0.454 kg*m^2"', "", "V725", "link 1 turns and has a mass, but no inertia"),
    ("31-forces", '"B + 0.305 @ phi3 + 0.076 @ (phi3 + pi/2)"', '"B + 0.3 @ phi2"', "V731", "does not stand still"),
    ("31-forces", ', centre = "B + 0.305 @ phi3 + 0.076 @ (phi3 + pi/2)"', "", "V724", "more than two points (M, B, C)"),
    ("31-forces", 'inertia = "0.992 kg*m^2"', 'inertia = "rod"', "V726", "link 3 is no rod"),
    ("31-forces", 'inertia = "0.454 kg*m^2"', 'inertia = "disc"', "V726", "link 1 is no disc"),
    ("example-2-forces", 'C = {', 'C = "1 kg"\n3 = {', "V734", "of link 3 is given twice, as C and as 3"),
    ("31-forces", 'step      = "0.02 s"', 'step = "0.02 s"\nscheme = "semi-implicit"', "V065", "time.scheme"),
    ("31-forces", "4 = { mass", "7 = { mass", "V723", 'there is no link "7"'),
    ("31-forces", '"6 kg"', '"6 m"', "V105", "masses.1.mass: a mass was expected: kg, g, t"),
    ("31-forces", '"6 kg"', '"6 Hz"', "V105", "masses.1.mass: a mass was expected: kg, g, t"),
    ("example-1-forces", "[given]", '[given]\nQ9 = "40 Nn"', "V109", "kg, g, t; N, kN; N*m, kN*m; "),
    ("31-forces", '"6 kg"', '"6 kgf"', "V701", "1 kgf = 9.80665 N"),
    ("31-forces", 'gravity = "9.81 m/s^2"', 'gravity = "9.81 m/s"', "V105", "an acceleration was expected"),
    ("31-forces", 'gravity = "9.81 m/s^2"', 'gravity = { on = "1", torque = "1 N*m" }', "V703", "gravity is one value"),
    ("31-forces", 'gravity = "9.81 m/s^2"', 'gravit = "9.81 m/s^2"', "V705", 'Did you mean "gravity"?'),
    ("example-2-forces", "[motor] ", '[friction]\nA = { radius = "2 mm" }\n\n[motor] ', "V709", "Add one to A"),
    ("example-2-motor", '1 = { torque = "M0 - k*w1" }', '1 = "M0 - k*w1"', "V713", 'Write 1 = { torque = "M0 - k*w1" }'),
    ("example-2-motor", '1 = { torque = "M0 - k*w1" }', '1 = ["M0"]', "V713", "a torque on link 1 was expected"),
    ("example-2-forces", '{ on = "1", unevenness = "1/30" }', '"5 kg*m^2"', "V716", "a flywheel is a table"),
    ("example-2-forces", '{ on = "1", unevenness = "1/30" }', '["1"]', "V716", "a flywheel is a table"),
    ("example-2-motor", 'rates = ["w1"]', 'rates = "w1"', "V015", "motor.rates: a list"),
    ("example-2-motor", 'rates = ["w1"]', 'rates = ["w1", "w1"]', "V717", "w1 stands twice"),
    ("example-2-motor", 'rates = ["w1"]', 'rates = ["w1", "w2"]', "V750", "the equations do not leave w1 and w2 free"),
    ("example-2-motor", '1 = { torque', '1 = { from = "9", torque', "V723", 'there is no link "9"'),
    ("example-2-motor", '1 = { torque', '1 = { from = "1", torque', "V719", "has that link on both sides"),
    ("example-1-forces", 'torque = "-60 N*m"', 'torque = "-60 J"', "V702", 'Write "-60 N*m"'),
    ("example-1-forces", 'on = "3", at = "C"', 'on = "1", at = "C"', "V732", "does not move with link 1"),
    ("example-1-forces", 'at = "C", ', "", "V708", "the force F1 has no point"),
    ("example-1-forces", ', torque = "-60 N*m"', "", "V707", "either a force or a torque"),
    ("example-1-forces", ', torque = "-60 N*m"', ', torque = "1 N*m", at = "C", force = "(1, 0)"', "V707", "leave one of"),

    ("example-1-forces", 'value = "-200 N"', 'value = "-200 kg"', "V205", "a mass"),
    ("andrews-forces", ', free = "77.85 mm"', "", "V706", "free is missing"),
    ("andrews-forces", 'spring = ["S", "K"]', 'spring = ["S", "Q"]', "V059", "Q"),
    ("andrews-forces", 'spring = ["S", "K"]', 'spring = ["K", "K"]', "V745", "Name two points"),
    ("example-1-forces", 'on = "3", at = "C"', 'on = "9", at = "C"', "V723", 'there is no link "9"'),
    ("example-1-forces", 'at = "C"', 'at = "Q"', "V053", "forces.F1.at"),
    ("31-forces", 'gravity = "9.81 m/s^2"', 'gravity = "-9.81 m/s^2"', "V704", "forces.gravity: a value that is not below zero"),
    ("31-forces", 'gravity = "9.81 m/s^2"', 'gravity = "9,81 m/s^2"', "V121", "decimals are written with a point"),
    ("andrews-forces", 'stiffness = "4530 N/m"', 'stiffness = "-4530 N/m"', "V704", "forces.k1.stiffness"),
    ("example-1-forces", 'torque = "-60 N*m"', 'torque = "-6 kgf*m"', "V701", 'Write "-58.8399 N*m"'),
    ("example-1-forces", 'inertia = "0.0533 kg*m^2"', 'inertia = "0.0533 kg*m"', "V105", "a moment of inertia was expected"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "old", "new", "code", "told"), CASES, ids=[case[3] + case[1][:12] for case in CASES])
def test_fault(name, old, new, code, told):
    text = mechanism(name, (old, new))
    with pytest.raises(coursework.InputError) as caught:
        run = coursework.solve(coursework.parse_variant(text, "bad.toml"), quantities=["forces"])
        _ = run.results.forces
    message = str(caught.value)
    assert code in message and told in message, message
    own = new.split("\n")[1 if "\n" in new else 0]
    line = next(place for place, each in enumerate(text.splitlines(), start=1) if own in each) if new else None
    assert line is None or f"bad.toml:{line}" in message, message


JACK, LEVER = mechanism("jack", ("v = ", "w1 = "), V="0.02 1/s"), mechanism("slotted-lever-by-an-angle")
CRANK = """[[group]]
kind = "crank"
from = ["A"]
meets = "B"
lengths = ["r1"]
coordinates = ["phi1"]
"""
WEIGHED = '[masses]\n1 = { mass = "1 kg", inertia = "rod" }\n'


@pytest.mark.parametrize(("text", "told"), [
    (JACK.replace('"E"], rate = "w1"', '"E"]'), "V729 .* w1 is driven, and no link"),
    (LEVER.replace('["A", "D"]', '["A"]'), "V728 .*links.3: link 3 has no two points"),
    (mechanism("four-bar", (CRANK, ""), ('"(d, 0)"', '"(d, 0)"\nB = "r1 @ phi1"')), "V727 .*the joint of 0 – 1 has no point"),
])  # fmt: skip
def test_a_joint_or_a_drive_that_no_point_and_no_link_shows(text, told):
    with pytest.raises(coursework.InputError, match=told):
        _ = coursework.solve(coursework.parse_variant(text + WEIGHED), scheme="rk4").results.forces


def test_a_link_whose_length_follows_a_law_has_no_force_analysis():
    """What lengthens the crank works too: virtual power gave another M than the reactions, and blamed the rows for it."""
    masses = '[masses]\n1 = { mass = "2 kg", inertia = "0.02 kg*m^2", centre = "O" }\n\n[ask]'
    text = mechanism("variable-crank", ("[ask]", masses))
    line = next(place for place, each in enumerate(text.splitlines(), start=1) if each.startswith("1 = { mass"))
    with pytest.raises(coursework.InputError, match=f"V735 bad.toml:{line}  masses.1: point A does not stand still in .* link 1"):
        _ = coursework.solve(coursework.parse_variant(text, "bad.toml")).results.forces


def test_a_file_with_a_motor_may_name_the_scheme_of_motion_under_forces():
    text = mechanism("example-2-motor", ('step   = "0.01 s"', 'step = "0.01 s"\nscheme = "semi-implicit"'))
    assert coursework.parse_variant(text).time.scheme == "semi-implicit"


def test_forces_that_cannot_be_found_or_followed_are_refused():
    """Nothing is heavy; no link is named; a rod has an inertia and no rate; nothing says where the others are."""
    bare = mechanism("31", ("# --- texts of", '[masses]\n1 = { mass = "1 kg", inertia = "rod" }\n\n# --- texts of'))
    bare = bare.replace(bare[bare.index("[points]") : bare.index("[masses]")], "")
    moved = UNNAMED.replace('[drive]\nw1 = "w0"\n', "") + '[motor]\nrates = ["w1"]\n1 = { torque = "5 N*m" }\n'
    open_loop = moved.replace('inertia = "rod"', 'inertia = "point"')
    line = moved.splitlines().index('2 = { mass = "12 kg", inertia = "rod" }') + 1
    for text, told in (
        (mechanism("31"), "V721"), (bare, "V722"), (moved, f"V741 bad.toml:{line}  link 2"),
        (open_loop, "V742 .*s3 .*only 0 independent"),
    ):  # fmt: skip
        with pytest.raises(coursework.InputError, match=told):
            _ = coursework.solve(coursework.parse_variant(text, "bad.toml")).results.forces


LINKS = """
[links]
1 = { points = ["O", "P"], rate = "w1" }
2 = { points = ["P", "R"], rate = "w2" }
3 = { points = ["Q", "END"], rate = "w3" }
[frame]
hinges = ["O", "Q"]
[masses]
2 = { mass = "1 kg", inertia = "rod" }
[ask]"""


@pytest.mark.parametrize(("end", "is_loose"), [("S", True), ("R", False)])
def test_links_that_share_no_hinge_are_told_as_that_and_not_as_missing(end, is_loose):
    """Four links and three hinges: W = 3*3 - 2*3 = 3 freedoms, of which the crank drives one; the fourth hinge takes two."""
    text = mechanism("four-bar-by-its-points", ("[ask]", LINKS.replace("END", end)))
    run = coursework.solve(coursework.parse_variant(text, "bad.toml"))
    if is_loose:
        line = text.splitlines().index('1 = { points = ["O", "P"], rate = "w1" }') + 1
        told = (
            rf"V722 bad.toml:{line} .*leave 3 freedoms where 1 is driven.* R and S lie in one place, or almost, at the start: if"
        )
        with pytest.raises(coursework.InputError, match=told):
            _ = run.results.forces
    else:
        assert run.results.forces.rows.count


def test_a_joint_that_no_point_shows_is_not_looked_for_elsewhere():
    """A link that an equation keeps from turning has no drive; with its rate in [drive] a moment holds it."""
    held = '[coordinates]\nphi9 = { start = "0.3 rad", rate = "w9" }'
    links = LINKS.replace("[frame]", '9 = { points = ["R", "X"], rate = "w9" }\n[frame]').replace("END", "R")
    text = mechanism(
        "four-bar-by-its-points", ("[ask]", links), ("[coordinates]", held), ("[points]", '[points]\nX = "R + 0.1 @ phi9"')
    )
    loop = ("a*w1*SIN(phi1) + b*w2*SIN(phi2) = c*w3*SIN(phi3)".replace("SIN", name) for name in ("sin", "cos"))
    text += "".join(f'\n[[constraint]]\nequation = "{one}"' for one in ("w9 = 0", *loop))
    run = coursework.solve(coursework.parse_variant(text, "bad.toml"))
    with pytest.raises(coursework.InputError, match=r"V722 .*No two points of different links lie in one place at the start"):
        _ = run.results.forces


BARS = """
[links]
1 = { points = ["O", "E"], rate = "w1" }
2 = { points = ["Q", "U"], rate = "w2" }
[frame]
hinges = ["O", "Q"]
[masses]
2 = { mass = "1 kg", inertia = "0.01 kg*m^2" }
[ask]"""
WHEELS = BARS.replace('1 = { points = ["O", "E"],', '1 = { wheel = "O", contact = "P", points = ["E"],').replace(
    '2 = { points = ["Q", "U"],', '2 = { wheel = "Q", contact = "P", points = ["U"],'
)  # fmt: skip


@pytest.mark.parametrize(
    ("law", "told"),
    [
        ('equation = "20*w1 = -50*w2"', "Equation pair makes links 1 and 2 turn together: if they are gears"),
        ('closure = "2*p1 + 5*p2 = 0"', "Equation pair makes links 1 and 2 turn together: if they are gears"),
        # w2 is found by another equation of the same; the one that is held has no name
        (
            'equation = "w2*(2 + cos(p1)) = -0.4*w1*(2 + cos(p1))"\n[closure]\nholds = ["2*p1 + 5*p2"]',
            "Equation 2*p1 + 5*p2 makes links 1 and 2 turn together: if they are gears",
        ),
        ('equation = "w1*(2 + cos(p1)) = -5*w2"', None),  # no gears: the ratio changes
        ('equation = "2*w1 + k*t = -5*w2"', None),
    ],
)
def test_gears_that_are_equations_alone_are_told_how_to_carry_forces(law, told):
    """An equation has no place at which a tooth could push; two wheels with one contact have the radii of [points]."""
    text = (
        'format = 1\n[given]\nk = "1 rad/s^2"\n[drive]\nw1 = "3"\n[coordinates]\np1 = { start = "0 rad", rate = "w1" }\n'
        'p2 = { start = "0 rad", rate = "w2" }\n[time]\nstep = "0.05 s"\nend = "0.5 s"\n[[constraint]]\nname = "pair"\n'
        f'{law}\n[points]\nO = "(0, 0)"\nP = "(0.2, 0)"\nQ = "(0.7, 0)"\nE = "0.1 @ p1"\nU = "Q + 0.3 @ p2"{BARS}\n'
        'quantities = ["table", "forces"]\n'
    )
    with pytest.raises(coursework.InputError, match="V722") as caught:
        _ = coursework.solve(coursework.parse_variant(text, "bad.toml")).results.forces
    assert ("turn together" in str(caught.value)) == bool(told)
    assert (told or "A hinge is counted") in str(caught.value)
    if told:
        forces = coursework.solve(coursework.parse_variant(text.replace(BARS, WHEELS), "bad.toml")).results.forces
        assert {"T12", "M"} <= set(forces.names)


def test_units():
    texts = ("2 t", "250 g", "1.5 kN", "12 N·m", "10 g*cm^2", "2 N/mm", "3 кг", "5 Н*м", "5 N·м", "3 кg", "2 kН*м")
    assert [read_mass(text).value for text in texts] == [2000.0, 0.25, 1500.0, 12.0, 1e-6, 2000.0, 3.0, 5.0, 5.0, 3.0, 2000.0]
    assert read_mass("0.5 m").si == "m"


@pytest.mark.parametrize("unit", ["N*m*s^2", "kN·mm·с²"])
def test_a_torque_quadratic_in_the_rate_has_a_unit(unit):
    assert (read_mass(f"2 {unit}").value, read_mass(f"2 {unit}").si) == (2.0, "kg*m^2")


@pytest.mark.parametrize(("unit", "value"), [("kg/m", 2.0), ("N·s²/m²", 2.0), ("N*s^2/cm^2", 2e4), ("g/cm", 0.2)])
def test_a_resistance_quadratic_in_the_speed_has_a_unit(unit, value):
    """N = kg m/s^2, so N s^2/m^2 is kg/m."""
    assert (read_mass(f"2 {unit}").value, read_mass(f"2 {unit}").si) == (pytest.approx(value), "kg/m")


@pytest.mark.parametrize(
    ("law", "unit", "advised"),
    [
        ("-b*u3*abs(u3)", "kg/m", ""),
        ("-b*u3", "kg/m", "N*s/m"),
        ("-b*u3*abs(u3)", "N*s/m", "kg/m"),
        ("-b*u3*abs(u3)", "N*s^3/m", "N*s^2/m^2"),
    ],
)
def test_a_resistance_of_another_power_of_the_speed_is_refused(law, unit, advised):
    text = mechanism("example-2-motor", ("(-c*u3, 0)", f"({law}, 0)"), ("[given]", f'[given]\nb = "3 {unit}"'))
    if advised:
        with pytest.raises(coursework.InputError, match=re.escape(advised)):
            coursework.parse_variant(text)
    else:
        assert coursework.parse_variant(text).given[0].si == unit


def test_a_file_without_forces_knows_no_units_of_mass():
    with pytest.raises(coursework.InputError, match="V105"):
        coursework.parse_variant(mechanism("31", ('"0.953 m"', '"0.953 kg"')))


def test_a_mass_may_be_a_datum_and_is_set():
    text = mechanism("example-1-forces", ('mass = "4 kg"', 'mass = "m1"'), ("[given]\n", '[given]\nm1 = "4000 g"\n'))
    variant = coursework.parse_variant(text)
    assert variant.values["m1"] == 4.0
    assert variant.with_data(given={"m1": "5 kg"}).values["m1"] == 5.0
    assert variant.with_data(given={"m1": 6.0}).values["m1"] == 6.0


@pytest.mark.parametrize("scheme", ["euler", "exact"])
@pytest.mark.parametrize(("name", "code"), [("example-1-forces", "V322"), ("example-2-motor", "V522")])
def test_a_load_table_that_ends_early_is_told_with_its_line(name, code, scheme):
    force = {"example-1-forces": "(F0, 0)", "example-2-motor": "(-c*u3, 0)"}[name]
    law = '\n[functions]\nP = { of = "t", table = "load.csv" }\n\n[time]'
    text = mechanism(name, ("\n[time]", law), (f'force = "{force}"', 'force = "(P, 0)"'))
    table = b"t,P\n" + b"\n".join(b"%.2f,%d" % (0.05 * k, 10 * k) for k in range(8)) + b"\n"
    with pytest.raises(coursework.InputError, match=f"{code} bad.toml:.*Add nodes, or end the"):
        variant = coursework.parse_variant(text.encode(), "bad.toml", {"load.csv": table})
        _ = coursework.solve(variant, scheme=scheme).motion


def test_forces_that_hold_a_mechanism_where_it_stands_are_told():
    weightless = mechanism("falling-arm", ('gravity = "9.81 m/s^2"', ""))
    run = coursework.solve(coursework.parse_variant(weightless), scheme="euler")
    told = {one.code: str(one.sentence) for one in run.results.checks}
    assert "it does not start" in told["ENERGY"]


def test_a_rate_that_neither_a_motor_frees_nor_anything_ties_is_named():
    with pytest.raises(coursework.InputError) as caught:
        coursework.parse_variant(mechanism("falling-arm", ('rates = ["w1", "w2"]', 'rates = ["w1"]')), "bad.toml")
    told = str(caught.value)
    assert told.startswith("V746 bad.toml:") and "motor.rates: nothing ties w2 to w1" in told


def test_a_crank_that_a_motor_does_not_free_is_to_be_freed():
    with pytest.raises(coursework.InputError, match=r'V747 .*group 1: nothing turns its crank.*Add "w1" to rates in'):
        coursework.parse_variant(mechanism("example-2-motor", ('rates = ["w1"]', 'rates = ["w2"]')))


@pytest.mark.parametrize(("kind", "more"), [("spring", 'stiffness = "50 N/m", free = "1 m"'), ("damper", 'damping = "3 N*s/m"')])
@pytest.mark.parametrize("place", [0, 1])
def test_an_end_that_is_no_point_is_told_at_its_own_place(kind, more, place):
    ends = ['"A"', '"A"']
    ends[place] = '"Z"'
    text = mechanism(
        "falling-arm", ("[forces]", f"[forces]\nk1 = {{ {kind} = [{','.join(ends)}], {more} }}".replace(",", ",\n", 1))
    )
    line = next(number for number, one in enumerate(text.splitlines(), 1) if '"Z"' in one)
    with pytest.raises(coursework.InputError, match=rf"V059 bad.toml:{line}:\d+ .*k1\.{kind}\.{place + 1}:"):
        coursework.parse_variant(text, "bad.toml")
