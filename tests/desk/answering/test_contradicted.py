"""Beside an own equation that the geometry contradicts: which term differs, where it stands, never what would be right."""

from __future__ import annotations

import pytest

from coursework.desk.answering import contradicted
from coursework.desk.job import Policy
from coursework.grading.marking.equations.equations import Judge
from coursework.variant.formula.reader import parse
from coursework.variant.judging.dimension_words import text_of
from tests.desk.desks import TEXT, VARIANTS, desk

OWN = '\n[[constraint]]\nequation = "m*w1*sin(phi1) + j*wj*sin(phij) - b*wb*sin(phib) = 0"\n\n[links]'
TEXTS = {
    "31": TEXT,
    **{name: (VARIANTS / f"{name}.toml").read_text(encoding="utf-8") for name in ("v101", "v102")},
    "jansen": (VARIANTS / "jansen.toml").read_text(encoding="utf-8").replace("\n[links]", OWN, 1),
}


@pytest.fixture(scope="module")
def client(tmp_path_factory):
    with desk(
        tmp_path_factory.mktemp("own"), policy=Policy(equations=False)
    ) as opened:  # who may not have them written is told all the same
        yield opened


def asked(client, text: str, language: str = "en") -> dict:
    return client.post("/api/check", json={"text": text, "language": language}).json()


@pytest.mark.parametrize(
    ("name", "right", "wrong", "how", "at"),
    [
        ("31", "- r3*w3*sin(phi3) = 0", "+ r3*w3*sin(phi3) = 0", "the sign of r3*w3*sin(phi3) differs", "+ r3*w3*sin(phi3) = 0"),
        ("31", '"-0.5*r3*w4', '"0.5*r3*w4', "the sign of 0.5*r3*w4 differs", "0.5*r3*w4"),
        ("31", "2*r3*w3*cos", "2*r3*w3*sin", "sine and cosine are exchanged in sin(phi3)", "sin(phi3) - r3"),
        ("31", "r1*w1*sin(phi1)", "r2*w1*sin(phi1)", "another name belongs in the place of r2", "r2*w1"),
        ("31", "+ 0.5*r3*w4", "+ r3*w4", "the factor of r3*w4 differs", "r3*w4"),
        ("31", "r1*w1*sin", "0.95*w1*sin", "the factor of 0.95*w1*sin(phi1) differs", "0.95"),
        ("31", "- r1*w1*cos", "- 3*r1*w1*cos", "the factor of 3*r1*w1*cos(phi1) differs", "3*r1"),
        ("31", " + 0.5*r3*w4", "", "a term with w4 is missing", '"2*r3'),
        ("31", " - r3*w3*cos(phi3)", "", "a term with w3 is missing", '"2*r3'),
        ("31", "r1*w1*sin(phi1) =", "r1*w1*sin(phi1) + r1*w2 =", "r1*w2 is one term too many", "r1*w2"),
        ("31", "r1*w1*sin(phi1) =", "r1*w1*sin(phi1) + VMy =", "VMy is one term too many", "VMy = 0"),
        ("31", "r1*w1*sin(phi1)", "2*r1*w1*cos(phi1)", "one of the terms with w1 is missing or wrong", "w1*cos"),
        ("v101", "(a + c)*w3*sin(phi3))*cos", "(a - c)*w3*sin(phi3))*cos", "the sign of c differs", "- c)"),
        # beta is 45 deg, so that another sign would make the first equation of it once more
        ("v101", " + R*w4", "", "a term with w4 is missing", '"(VMx'),
        ("v102", '= u"', '= -u"', "the sign of u differs", "-u"),
        ("v102", "r1*w1*sin(phi1)", "r1*w1*sin(phi3)", "another name belongs in the place of phi3", "phi3) = 0"),
        ("jansen", "j*wj*sin", "j*wj*cos", "sine and cosine are exchanged in cos(phij)", "cos(phij)"),
        ("jansen", '"m*w1*sin(phi1) + ', '"', "a term with w1 is missing", '"j*wj'),
    ],
)
def test_the_term_that_differs_is_told_at_its_place_and_the_others_stay_right(client, name, right, wrong, how, at):
    assert not asked(client, TEXTS[name])["faults"]
    text = TEXTS[name].replace(right, wrong, 1)
    found = asked(client, text)
    (fault,) = found["faults"]
    assert (fault["code"], fault["mend"]) == ("V302", None)
    assert f": {how}." in fault["sentence"]
    assert text.split("\n")[fault["line"] - 1][fault["column"] - 1 :].startswith(at)
    told = {one["line"]: (one["right"], one["sentence"]) for one in found["equations"]}
    assert told.pop(fault["line"]) == (False, how)
    assert {right for right, _ in told.values()} <= {True}


@pytest.mark.parametrize(
    ("written", "line", "at"),
    [
        ('"-0.5*r3*ω4 + r3*ω3*cos(φ3) + r2·ω2·sin(φ1) + r1*ω1*sin(φ1) = 0"', 51, "φ1) + r1"),
        ('"""\n  -0.5*r3*w4 + r3*w3*cos(phi3)\n + r2*w2*sin(phi1) + r1*w1*sin(phi1) = 0"""', 53, "phi1) + r1"),
        (r'"-0.5*r3*w4 + r3*w3*cos(phi3) \u002b r2*w2*sin(phi1) + r1*w1*sin(phi1) = 0"', 51, "equation"),
    ],
)
def test_the_place_is_that_of_the_text_as_it_is_written(client, written, line, at):
    text = TEXT.replace('"-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0"', written)
    (fault,) = asked(client, text)["faults"]
    assert (fault["line"], text.split("\n")[line - 1][fault["column"] - 1 :].startswith(at)) == (line, True)
    assert "another name belongs in the place of phi1." in fault["sentence"]


def test_two_wrong_ones_are_told_each(client):
    text = TEXT.replace("VMy - 2*r3*w3*cos", "VMy + 2*r3*w3*cos").replace("r1*w1*cos(phi1)", "r1*w1*cos(phi2)")
    found = asked(client, text)
    assert [("sign of" in one["sentence"], "place of phi2" in one["sentence"]) for one in found["faults"]] == [
        (True, False), (False, True)
    ]  # fmt: skip
    assert [one["right"] for one in found["equations"]] == [False, True, True, False]


def test_what_no_single_term_explains_is_said_as_check_says_it(client):
    found = asked(client, TEXT.replace("r2*w2*sin(phi2) + r1*w1*sin(phi1)", "r1*w2*sin(phi1) + r2*w1*cos(phi3)"))
    assert "(signs, lengths or angles differ)" in found["faults"][0]["sentence"]
    assert [(one["right"], one["sentence"]) for one in found["equations"]][2] == (False, "")


def test_in_each_language_the_term_is_named_and_the_right_equation_is_not(client):
    right = "2*r3*w3*cos(phi3)"
    for language in ("en", "ru", "uk", "zh"):
        (fault,) = asked(client, TEXT.replace(right, "2*r3*w3*cos(phi2)", 1), language)["faults"]
        assert "phi2" in fault["sentence"]
        assert "phi3" not in fault["sentence"]


def test_nothing_is_searched_where_nothing_is_wrong(client, monkeypatch):
    monkeypatch.setattr(Judge, "slips", None)
    assert all(one["right"] for one in asked(client, TEXT)["equations"])


@pytest.mark.parametrize(("letters", "told"), [(60, "a" * 60), (61, "a" * 60 + "…")])
def test_a_term_is_shown_with_at_most_sixty_letters(letters, told):
    assert text_of(parse("a" * letters), contradicted._LONGEST) == told
