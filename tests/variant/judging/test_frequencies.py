"""A frequency with a unit is read in rad/s; a formula that turns it once more is remarked, in whatever notation."""

import json
import math

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.words.data_folders import folder

TEMPLATE = (folder("reports") / "new-variant.toml").read_text(encoding="utf-8").replace("NAME", "mine")


def remarks(factor, unit="rpm", number="60", period="2*pi/p", given=""):
    text = TEMPLATE.replace('VMy = "V*sin(p*t)"', f'VMy = "V*sin({factor}*t)"').replace('"60 rpm"', f'"{number} {unit}"')
    text = text.replace('period    = "2*pi/p"', f'period    = "{period}"').replace("[given]", f"[given]\n{given}", 1)
    return [one for one in coursework.parse_variant(text).plausibility if one.code == "RPM"]


TWICE = [
    "2*pi*p/60", "pi*p/30", "p*pi/30", "π·p/30", "2*p*pi/60", "(2*pi/60)*p", "2*pi*(p/60)", "p*(pi/30)", "pi/30*(p + p)",
    "0.1047*p", "0.10472*p", "0.105*p", "2*3.14*p/60", "p/9.55", "p/(30/pi)", "-2*pi*p/60",
]  # fmt: skip


@pytest.mark.parametrize("factor", TWICE)
def test_each_notation_of_the_textbooks_formula(factor):
    (remark,) = remarks(factor)
    assert "p = 60 rpm is already in rad/s" in str(remark.sentence)


@pytest.mark.parametrize("factor", ["p", "2*p", "p/2", "p/60", "pi*p", "0.1*p", "0.11*p", "(p + 3)"])
def test_other_factors_are_none(factor):
    assert remarks(factor) == []


@pytest.mark.parametrize(
    ("unit", "factor", "is_told"),
    [
        ("1/min", "2*pi*p/60", True), ("об/мин", "2*pi*p/60", True), ("rev/min", "pi*p/30", True), ("rev/s", "2*pi*p", True),
        ("rev/s", "6.283*p", True), ("об/с", "2*pi*p", True), ("deg/s", "p*pi/180", True), ("rad/s", "2*pi*p/60", True),
        ("rpm", "2*pi*p", True), ("об/мин", "6.28*p", True), ("1/s", "2*pi*p", False), ("rad/s", "p*pi/180", False),
    ],
)  # fmt: skip
def test_each_unit_has_its_factor(unit, factor, is_told):
    assert bool(remarks(factor, unit)) is is_told


def test_a_datum_may_be_the_factor_and_a_number_without_unit_needs_it():
    assert remarks("k*p", given='k = "0.1047"')
    text = TEMPLATE.replace('"60 rpm"', '"60"').replace("sin(p*t)", "sin(2*pi*p/60*t)")
    assert [one.code for one in coursework.parse_variant(text).plausibility if one.code == "RPM"] == []


def test_a_turn_that_lasts_60_by_n():
    (remark,) = remarks("p", period="60/p")
    assert "one turn lasts 2*pi/p" in str(remark.sentence)
    assert remarks("p", period="2*pi/p") == []


def test_just_within_and_just_beyond_the_digits_of_the_factor():
    size = math.pi / 30
    assert remarks(f"{size * 1.0049:.9f}*p")
    assert not remarks(f"{size * 1.0051:.9f}*p")


def test_a_crank_of_its_own_is_remarked_in_run_json(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "crank.toml").write_text(
        '[given]\nn = "60 rpm"\nr = "0.1 m"\n[drive]\nw1 = "2*pi*n/60"\n[coordinates]\nphi1 = { start = "0 deg", rate = "w1" }\n'
        '[unknowns]\nu = "m/s"\n[time]\nstep = "0.1 s"\nend = "1 s"\n[[constraint]]\nequation = "u = r*w1*cos(phi1)"\n',
        encoding="utf-8",
    )
    told = CliRunner().invoke(main, ["run", "crank", "--format", "csv"])
    assert told.exit_code == 0
    record = json.loads((tmp_path / "coursework-crank" / "run.json").read_text(encoding="utf-8"))
    (remark,) = record["remarks"]
    assert (remark["code"], remark["line"]) == ("RPM", 5)
    assert "n is already in rad/s" in remark["sentence"].replace("n = 60 rpm is", "n is")
    assert remark["sentence"] in told.stdout


def test_no_variant_of_the_catalogue_is_suspected():
    from coursework.variant.catalogue import names

    assert [name for name in names() if any(one.code == "RPM" for one in coursework.load(name).plausibility)] == []
