"""What a datum is for is told where its author does not say it, and only where the file leaves no doubt."""

import pytest

import coursework
from coursework.catalogue import names
from coursework.report.data_meanings import coordinate_meanings, meanings

SAID = {
    "v101": {"r1": "DA", "V1": "amplitude of VMy", "p": "angular frequency of the drive", "alpha": "phase of the drive",
             "beta": "direction of the guide through P"},
    "v108": {"R0": "radius of the fixed circle about O", "xO": "abscissa of O", "yO": "ordinate of O"},
    "watt": {"gamma": "angle between phi3 and DE", "r4": "AD", "yG": "ordinate of G", "w0": "constant w1"},
    "oscillating-cylinder": {"e": "distance of the guide from D", "d": "AD"},
    "prp": {"ri": "distance of the guide from Ki", "w0": "angular frequency of the drive", "swing": "amplitude of the arm"},
    "robot-arm": {"T": "time for one side"},
}  # fmt: skip


@pytest.mark.parametrize("name", SAID)
def test_what_the_data_are(name):
    found = meanings(coursework.solve(name, quantities=["table"]).scene.mechanism)
    assert {key: found[key] for key in SAID[name]} == SAID[name]


def test_a_product_of_two_data_is_the_amplitude_of_neither():
    """rr*w0*cos(w0*t + beta): neither a length nor an angular velocity is the size of a speed."""
    text = coursework.load("andrews").path.read_text(encoding="utf-8")
    variant = coursework.parse_variant(text.replace('{ value = "7 mm", means = "radius of the circle of F about O" }', '"7 mm"'))
    assert meanings(coursework.solve(variant, quantities=["table"]).scene.mechanism)["rr"] == ""


def test_a_slide_is_measured_between_points_or_along_its_guide():
    assert coordinate_meanings(coursework.solve("prp", quantities=["table"]).scene.mechanism) == {
        "psi": "", "si": "along the guide from Ki", "sj": "along the guide from Kj",
    }  # fmt: skip
    assert coordinate_meanings(coursework.solve("example-5", quantities=["table"]).scene.mechanism)["s2"] == "BD"


def test_no_datum_of_the_catalogue_is_without_a_meaning():
    found = {name: meanings(coursework.solve(name, quantities=["table"]).scene.mechanism) for name in names()}
    bare = [(name, key) for name, told in found.items() for key, meaning in told.items() if not meaning]
    assert bare == []
