"""What a sheet says of signs, of decimals and of what is marked: for mechanisms that are in no catalogue.

A shaper of groups with a slide in a sloping guide, a gear train, and a five-bar with a relative angle and one counted clockwise.
"""

import cmath
import html
import math
import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

import coursework
from coursework.assigning.senses import QUARTERS, _arms, _way
from coursework.assigning.sheet import exemplary
from coursework.report.text.words import load_words
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import signed
from tests.command import call
from tests.grading.marking.machines import PULLED_BARS

OWN = Path(__file__).parent / "own"
RANGES = {
    "shaper": '[given]\nr = { choice = ["0.09 m", "0.11 m"] }\n',
    "gears": '[given]\ne = { choice = ["0.04 m", "0.045 m"] }\n[difficulty]\nband = 9\n',
    "fivebar": '[given]\nq = { choice = ["2.1 rad/s", "1.9 rad/s"] }\n[difficulty]\nband = 9\n',
}


def assigned(folder, name, *more):
    (folder / "ranges.toml").write_text(RANGES[name], encoding="utf-8")
    (folder / "roster.csv").write_text("id,name,email\nada,Ada,a@x\n", encoding="utf-8")
    result = call("assign", folder / "roster.csv", "--template", OWN / f"{name}.toml", "--ranges", folder / "ranges.toml",
                  "--seed", "1", "--out", folder / "out", *more)  # fmt: skip
    assert result.exit_code == 0, result.output
    return (folder / "out" / "sheets" / "ada.html").read_text(encoding="utf-8")


def text_of(piece):
    return re.sub("[\u00a0\u202f\u2009]", " ", html.unescape(re.sub(r"<[^>]*>", "", piece)))


def rows_of(page):
    table = re.search(r'<table class="senses"[^>]*>.*?</table>', page, re.S)[0]
    return [[text_of(cell) for cell in re.findall(r"<td>(.*?)</td>", row)] for row in re.findall(r"<tr>(.*?)</tr>", table)[1:]]


def test_a_chain_with_slides(tmp_path):
    page = assigned(tmp_path, "shaper")
    turning = ["the x axis", "counter-clockwise"]
    assert rows_of(page) == [
        ["φ1, ω1", "angle of OA, its rate", *turning],
        ["φ3, ω3", "angle of PB, its rate", *turning],
        ["s, v", "distance along its line, its rate", "P (0, −d)", "at φ3 to the x axis"],
        ["φ4, ω4", "angle of BE, its rate", *turning],
        ["sE, vE", "distance along its line, its rate", "K (0, 0.2)", "at β to the x axis"],
    ]
    starts = [text_of(row) for row in re.findall(r"<tr>(.*?)</tr>", page, re.S)]
    assert {"φ1= 30°", "φ3= 1.268060 rad"} <= set(starts)  # the one as it is given, the other as the geometry makes it
    assert set(re.findall(r'data-angle="(\w+)"', page)) >= {"phi1", "phi3", "phi4"}
    assert "x points to the right, y upwards; the thin arcs in the drawing show the angles." in text_of(page)
    assert "the 4 velocity equations, one per line" in text_of(page)  # of w3, v, w4, vE: the rubric marks them for chains too


def test_a_gear_train_with_a_slider(tmp_path):
    rows = rows_of(assigned(tmp_path, "gears"))
    assert [row[1] for row in rows] == [f"angle of {line}, its rate" for line in ("AD", "BE", "ES")] + ["velocity of S"]
    assert rows[3] == ["u", "velocity of S", "", "upwards"]


def test_a_relative_angle_and_one_counted_clockwise(tmp_path):
    """The lines are true: at the start each has the angle that the sheet prints, from the axis and in the sense it names."""
    rows = rows_of(assigned(tmp_path, "fivebar"))
    assert [row[2:] for row in rows] == [
        ["the x axis", "counter-clockwise"], ["the direction at φ1 to the x axis", "counter-clockwise"],
        ["the x axis", "counter-clockwise"], ["the negative x axis", "clockwise"],
    ]  # fmt: skip
    variant = coursework.load(tmp_path / "out" / "ada.toml")
    data, (phi1, gamma, phi3, phi4) = variant.values, (c.start for c in variant.coordinates)
    place = {"A": 0, "B": data["a"] * cmath.exp(1j * phi1), "E": data["e"], "D": data["e"] - data["d"] * cmath.exp(-1j * phi4)}
    place["C"] = place["F"] = place["D"] + data["c"] * cmath.exp(1j * phi3)
    axes, senses = (0.0, phi1, 0.0, math.pi), (1, 1, 1, -1)
    for row, angle, axis, sense in zip(rows, (phi1, gamma, phi3, phi4), axes, senses, strict=True):
        begin, end = re.search(r"angle of (\w)(\w)", row[1]).groups()
        turned = sense * (cmath.phase(place[end] - place[begin]) - axis) - angle
        assert math.remainder(turned, math.tau) == pytest.approx(0, abs=1e-9)


@pytest.mark.long
def test_turning_counted_clockwise_is_promised_only_where_the_rubric_accepts_it(tmp_path):
    promise = "If you count all rotation the other way round, you are marked as if the signs were those above"
    (tmp_path / "rubric.toml").write_text('[conventions]\nclockwise = "misconception"\n', encoding="utf-8")
    assert promise in text_of(assigned(tmp_path, "fivebar"))
    strict = tmp_path / "strict"
    strict.mkdir()
    assert promise not in text_of(assigned(strict, "fivebar", "--rubric", tmp_path / "rubric.toml"))


def test_what_an_unbound_unknown_is_cannot_be_told(tmp_path):
    text = (OWN / "gears.toml").read_text(encoding="utf-8").replace('{ unit = "m/s", of = "S", along = "90 deg" }', '"m/s"')
    (tmp_path / "bare.toml").write_text(text, encoding="utf-8")
    (tmp_path / "ranges.toml").write_text(RANGES["gears"], encoding="utf-8")
    (tmp_path / "roster.csv").write_text("id\na\n", encoding="utf-8")
    result = call("assign", tmp_path / "roster.csv", "--template", tmp_path / "bare.toml", "--ranges", tmp_path / "ranges.toml",
                  "--seed", "1", "--out", tmp_path / "out")  # fmt: skip
    assert result.exit_code == 0, result.output
    page = (tmp_path / "out" / "sheets" / "a.html").read_text(encoding="utf-8")
    assert rows_of(page)[-1] == ["u", "unknown of the equations", "", "ask your teacher"]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        (
            "ru",
            [
                "угол поворота OA и угловая скорость",
                "оси x",
                "против часовой стрелки",
                "под углом β к оси x",
                "docx",
                "K (0; 0,2)",
            ],
        ),
        ("uk", ["кут повороту OA і кутова швидкість", "осі x", "проти годинникової стрілки", "під кутом β до осі x", "docx"]),
        ("zh", ["OA 的方向角及其角速度", "x 轴", "逆时针", "与 x 轴成 β", "docx", "照片"]),
    ],
)
def test_in_every_language(tmp_path, language, said):
    page = text_of(assigned(tmp_path, "shaper", "--language", language))
    for one in said:
        assert one in page, one


def test_the_sheet_says_which_files_and_decimals(tmp_path):
    page = text_of(assigned(tmp_path, "fivebar"))
    for kind in ("CSV", "xlsx", "ods", "docx", "odt", "ipynb", "md", "JSON", "RTF", "PDF", "text"):
        assert kind in page, kind
    assert "typed as in a program (phi1, w1) or with Greek letters (φ1, ω1)" in page
    line = (tmp_path / "out" / "roster.csv").read_text(encoding="utf-8-sig").splitlines()[1].split(",")
    assert f"at least {line[4]} decimals" in page
    fewer = "with fewer, every number that cannot show how it was made counts as not handed in."  # one of a velocity may
    assert f"{line[5]} decimals are still marked, with a note; {fewer}" in page
    assert int(line[5]) < int(line[4])


def test_names_are_shown_by_those_with_greek_letters():
    variant = coursework.load("v107")
    assert exemplary(variant) == ("phi2", "w2")
    assert exemplary(replace(variant, coordinates=variant.coordinates[::-1])) == ("phi3", "w3")  # s, u has none


def test_what_the_rubric_does_not_mark_a_person_does(tmp_path):
    page = text_of(assigned(tmp_path, "fivebar"))
    assert "the 2 velocity equations, one per line; each line more that is wrong costs points" in page
    assert "a person marks it" not in page  # nothing is drawn, and both parts are marked
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(
        '[parts]\ntable = 60\nequations = 0\nanswers = 5\n[answers]\nwAB = { of = "w3", row = 4 }\n', encoding="utf-8"
    )
    page = text_of(assigned(tmp_path, "fivebar", "--rubric", rubric))
    assert "the 2 velocity equations, one per line; a person marks it" in page
    assert "your answers, one per line, as name = number unit: wAB (ω3 in row 4)" in page
    assert "as in Excel" not in page  # nobody is told how to write equations for a program that does not read them
    rubric.write_text('[answers]\nwAB = { of = "w33" }\n', encoding="utf-8")
    told = call("assign", tmp_path / "roster.csv", "--template", OWN / "fivebar.toml", "--ranges", tmp_path / "ranges.toml",
                "--seed", "1", "--out", tmp_path / "other", "--rubric", rubric)  # fmt: skip
    assert told.exit_code == 2
    assert "w33" in told.output
    assert not (tmp_path / "other").exists()


def test_a_sheet_of_equations_alone_says_nothing_of_signs_above(tmp_path):
    """No geometry, so from where an angle is counted nobody can say: no empty column, no signs "those above"."""
    (tmp_path / "own.toml").write_bytes(PULLED_BARS.strip())
    (tmp_path / "ranges.toml").write_text('[given]\nV = { choice = ["0.85 m/s", "0.95 m/s"] }\n[difficulty]\nband = 9\n')
    (tmp_path / "roster.csv").write_text("id,name,email\nada,Ada,a@x\n")
    result = call("assign", tmp_path / "roster.csv", "--template", tmp_path / "own.toml", "--ranges", tmp_path / "ranges.toml",
                  "--seed", "1", "--out", tmp_path / "out")  # fmt: skip
    assert result.exit_code == 0, result.output
    page = (tmp_path / "out" / "sheets" / "ada.html").read_text(encoding="utf-8")
    assert rows_of(page)[0] == ["φ1, ω1", "angle, its rate", "ask your teacher"]
    assert "measured from" not in page
    assert "those above" not in page


@pytest.mark.parametrize(("angle", "way"), [
    ("0", "right"), ("pi/2", "up"), ("pi", "left"), ("-pi/2", "down"), ("3*pi/2", "down"), ("2*pi", "right"), ("5*pi/2", "up"),
    ("pi/6", "30°"), ("-pi/4", "-45°"), ("pi/2 + 2e-9", "90°"), ("pi/2 + 5e-10", "up"), ("beta", "β"),
])  # fmt: skip
def test_a_direction_is_that_of_an_axis_or_at_an_angle(angle, way):
    variant, words = coursework.load("31"), load_words("en")
    told = _way(variant, tuple(signed(parse(angle))), words, "sheet.sense")
    key = ("sheet.sense.at", {"angle": way}) if way not in QUARTERS else (f"sheet.sense.{way}", {})
    assert told.replace("−", "-") == words(key[0], **key[1]).replace("−", "-")


@pytest.mark.parametrize(("place", "base", "way"), [
    ("K + s @ beta", "K", "β"), ("K - s @ 0", "K", "left"), ("K + (s, 0)", "K", "right"), ("K + (0, s)", "K", "up"),
    ("K - (s, 0)", "K", "left"), ("K - (0, s)", "K", "down"), ("(s, 1)", "", "right"), ("(0, s)", "", "up"),
])  # fmt: skip
def test_a_length_is_laid_off_from_a_point_in_a_direction(place, base, way):
    """As the point is written: along an angle, or along an axis, and the other way behind a minus."""
    mechanism = SimpleNamespace(points=[("K", parse("(1, 2)", vectors=True)), ("S", parse(place, vectors=True))], constraints=[])
    variant, words = coursework.load("31"), load_words("en")
    ((found, parts),) = _arms(mechanism, "s")
    told = _way(variant, parts, words, "sheet.sense")
    key = ("sheet.sense.at", {"angle": way}) if way not in QUARTERS else (f"sheet.sense.{way}", {})
    assert (found, told) == (base, words(key[0], **key[1]))
