"""What a datum is for is told where its author does not say it, and only where the file leaves no doubt."""

import pytest

import coursework
from coursework.report.wording.data_meanings import coordinate_meanings, drive_meanings, meanings
from coursework.variant.catalogue import names
from tests.mechanisms.library import mechanism
from tests.report.made import solved

SAID = {
    "v101": {"r1": "DA", "V1": "amplitude of VMy", "p": "angular frequency of the drive", "alpha": "phase of the drive",
             "beta": "direction of the guide through P"},
    "v108": {"R0": "radius of the fixed circle about O", "xO": "abscissa of O", "yO": "ordinate of O"},
    "watt": {"gamma": "angle from DC to DE", "r4": "AD", "yG": "ordinate of G", "w0": "constant w1"},
    "oscillating-cylinder": {"e": "distance of the guide from D", "d": "AD"},
    "prp": {"ri": "distance of the guide from Ki", "w0": "angular frequency of the drive", "swing": "amplitude of the arm"},
    "robot-arm": {"T": "time for one side"},
}  # fmt: skip


@pytest.mark.parametrize("name", SAID)
def test_what_the_data_are(name):
    found = meanings(solved(name, quantities=["table"]).scene.mechanism)
    assert {key: found[key] for key in SAID[name]} == SAID[name]


@pytest.mark.parametrize(("angle", "told"), [("phi3 - gamma", "angle from DE to DC"), ("gamma - phi3", "")])
def test_an_angle_is_counted_from_the_bar_that_it_is_added_to(angle, told):
    """E = D + r5 @ (phi3 - gamma): from DE a positive gamma leads to DC."""
    text = mechanism("watt", ("phi3 + gamma", angle))
    scene = coursework.solve(coursework.parse_variant(text), quantities=["table"]).scene
    assert str(meanings(scene.mechanism)["gamma"]) == told


def test_a_product_of_two_data_is_the_amplitude_of_neither():
    """rr*w0*cos(w0*t + beta): neither a length nor an angular velocity is the size of a speed."""
    text = coursework.load("andrews").path.read_text(encoding="utf-8")
    variant = coursework.parse_variant(text.replace('{ value = "7 mm", means = "radius of the circle of F about O" }', '"7 mm"'))
    assert meanings(coursework.solve(variant, quantities=["table"]).scene.mechanism)["rr"] == ""


def test_a_slide_is_measured_between_points_or_along_its_guide():
    assert coordinate_meanings(solved("prp", quantities=["table"]).scene.mechanism) == {
        "psi": "", "si": "along the guide from Ki", "sj": "along the guide from Kj",
    }  # fmt: skip
    assert coordinate_meanings(solved("example-5", quantities=["table"]).scene.mechanism)["s2"] == "BD"


def test_no_datum_of_the_catalogue_is_without_a_meaning():
    found = {name: meanings(solved(name, quantities=["table"]).scene.mechanism) for name in names()}
    bare = [(name, key) for name, told in found.items() for key, meaning in told.items() if not meaning]
    assert bare == []


@pytest.mark.parametrize(
    ("law", "told"),
    [
        ({"VMx": "V1*sin(2*pi*p*t)", "VMy": "0"}, {"V1": "amplitude of VMx", "p": "frequency of the drive"}),
        ({"VMx": "0", "VMy": "V1*cos(2*pi*t/T)"}, {"V1": "amplitude of VMy", "T": "period of the drive"}),
        (
            {"VMx": "V1*sin(p*t + alpha)*cos(beta)", "VMy": "V1*sin(p*t + alpha)*sin(beta)"},
            {
                "V1": "amplitude of VM",
                "p": "angular frequency of the drive",
                "alpha": "phase of the drive",
                "beta": "direction of VM",
            },
        ),
        ({"VMx": "V1*cos(beta)", "VMy": "V1*sin(beta)"}, {"V1": "constant VM", "beta": "direction of VM"}),
        ({"VMx": "-V1", "VMy": "0"}, {"V1": "constant −VMx"}),
        ({"VMx": '{ pieces = [["0 s", "0"], ["0.5 s", "-V1"]] }', "VMy": "0"}, {}),  # it is constant for a while only
        ({"VMx": "V1*sin(beta)", "VMy": "V1*cos(beta)"}, {}),  # beta may be anything here
    ],
)
def test_a_sine_without_time_is_no_wave(law: dict[str, str], told: dict[str, str]) -> None:
    drive = "\n".join(f"{name} = {formula}" if "[" in formula else f'{name} = "{formula}"' for name, formula in law.items())
    text = (
        'format = 1\n[given]\nV1 = "1 m/s"\np = "2 1/s"\nalpha = "1 rad"\nbeta = "1 rad"\nr = "1 m"\nT = "2 s"\n'
        f'[drive]\n{drive}\n[coordinates]\nphi = {{ start = "0 rad", rate = "w" }}\n'
        '[time]\nstep = "0.1 s"\nend = "1 s"\n[[constraint]]\nname = "1"\nequation = "r*w*cos(phi) = VMx"\n'
    )
    variant = coursework.parse_variant(text)
    assert dict(drive_meanings(variant)) == told


def test_points_named_by_words_are_told_apart():
    named = mechanism("four-bar", ('"B"', '"CrankPin"'), ("A = ", "Origin = "), ('"A"', '"Origin"'))
    found = meanings(coursework.solve(coursework.parse_variant(named), quantities=["table"]).scene.mechanism)
    assert (found["r1"], found["r2"], found["r3"]) == ("Origin–CrankPin", "CrankPin–C", "DC")


def test_a_point_may_be_placed_from_another():
    text = coursework.load("31").path.read_text(encoding="utf-8")
    moved = text.replace('D = "(0, 0)"', 'K = "(0, 0)"\nD = "K + (xD, yD)"').replace("[drive] ", "[drive] #")
    moved = moved.replace('alpha = "4.35 rad"', 'alpha = "4.35 rad"\nxD = "0 m"\nyD = "0.1 m"')
    told = meanings(coursework.solve(coursework.parse_variant(moved), quantities=["table"]).scene.mechanism)
    assert (told["xD"], told["yD"]) == ("abscissa of D from K", "ordinate of D from K")


@pytest.mark.parametrize(
    "loop", ["O + a @ phi1 + b @ phi2 = Q + c @ phi3", "b @ phi2 - c @ phi3 = Q - P", "P + b @ phi2 = Q + c @ phi3"]
)
@pytest.mark.parametrize("joint", ["P + b @ phi2", "O + a @ phi1 + b @ phi2", "Q + c @ phi3"])
def test_every_link_of_a_loop_is_told_however_the_loop_is_written(loop, joint):
    text = mechanism("four-bar-by-its-points", ('R = "P + b @ phi2"', f'R = "{joint}"'), ('S = "Q + c @ phi3"\n', ""))
    before, _, after = text.partition("[closure]")
    text = f'{before}[[constraint]]\nclosure = "{loop}"\n[ask]{after.partition("[ask]")[2]}'
    told = meanings(coursework.solve(coursework.parse_variant(text), quantities=["table"]).scene.mechanism)
    assert told == {"a": "OP", "b": "PR", "c": "QR", "d": "OQ"}


def test_a_datum_with_a_minus_before_it_is_a_distance_the_other_way():
    placed = 'D = "(d, 0)"', 'G = "(-g, -h)"\nD = "G + (-e, d)"'
    below = mechanism("four-bar", placed, ("[given]", '[given]\ng = "-3 cm"\nh = "1 cm"\ne = "-30 cm"'), d="3 cm")
    told = meanings(coursework.solve(coursework.parse_variant(below), quantities=["table"]).scene.mechanism)
    assert [told[name] for name in "ghed"] == [
        "distance of G to the left of the y axis", "distance of G below the x axis", "distance of D to the left of G",
        "ordinate of D from G",
    ]  # fmt: skip
