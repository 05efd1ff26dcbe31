"""What one student sets on the command line: read, refused with advice, and told wherever the run is told."""

import json
import re

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.variant.catalogue import names
from coursework.variant.reading.reader import parse_variant
from coursework.variant.reading.set_values import with_set
from coursework.variant.toml.rewriting import SAID_OF_NUMBERS, rewritten
from coursework.words.data_folders import folder

V31 = coursework.load("31")


def test_data_starts_drives_and_times_are_set():
    found = with_set(V31, ["r1=0.91m", "φ1 = 95 deg", "VMx=0.1*sin(p*t)", "end=0.4 s", "N=3"])
    assert found.values["r1"] == 0.91
    assert found.coordinates[0].start == pytest.approx(95 * 3.141592653589793 / 180)
    assert found.time.end == 0.4
    assert found.time.check_row == 5  # t = (N+1) h, and row 1 is t = 0
    assert found.set_values == {
        "r1": "0.91 m", "phi1": "95 deg", "VMx": "0.1*sin(p*t)", "end": "0.4 s", "check_row": "5",
    }  # fmt: skip
    assert with_set(V31, []) is V31
    assert with_set(V31, [], 25).time.check_row == 25


@pytest.mark.parametrize(
    ("texts", "row", "told"),
    [
        (["r1"], None, 'a name and its value were expected, found "r1"'),
        (["=3"], None, "a name and its value were expected"),
        (["alpa=3"], None, '"alpa" cannot be set. Did you mean "alpha"?'),
        (["r1=1 m", "r1=2 m"], None, "r1 is set twice"),
        (["N=3"], 5, "check_row is set twice"),
        (["N=-1"], None, 'a whole number of at least 1 was expected, found "-1"'),
        (["check_row=26"], None, "row 26 is beyond the last row, 25"),
        ([], 26, "row 26 is beyond the last row, 25"),
        (["N=24"], None, "row 26 is beyond the last row, 25"),
        (["r1=9 rad"], None, 'a length was expected: m, cm, mm (found "9 rad")'),
    ],
)
def test_what_cannot_be_set_is_told(texts, row, told):
    with pytest.raises(coursework.InputError, match=re.escape(told)):
        with_set(V31, texts, row)


def test_a_datum_of_the_name_n_is_that_datum():
    text = (
        (folder("variants") / "31.toml")
        .read_text(encoding="utf-8")
        .replace("r1 ", "N ")
        .replace("r1*", "N*")
        .replace("r1 @", "N @")
    )
    assert with_set(parse_variant(text), ["N=0.9 m"]).values["N"] == 0.9


def test_a_run_tells_what_is_set(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    few = ["run", "31", "--quantities", "table", "--out", "o", "--format"]
    result = CliRunner().invoke(main, [*few, "csv,html", "--set", "p=12", "--check-row", "6"])
    assert result.exit_code == 0, result.output
    assert "Changed from the file: p = 12 1/s and check_row = 6 (N = 4)" in result.output
    assert json.loads((tmp_path / "o" / "run.json").read_text(encoding="utf-8"))["set"] == {"p": "12 1/s", "check_row": "6"}
    page = (tmp_path / "o" / "report.html").read_text(encoding="utf-8")
    assert "Changed from the file" in page and re.search("check_row = 6.{1,40}N.{1,20}4", page)
    for row, told in ((3, "check_row = 3 (N = 1)"), (2, "check_row = 2")):  # the guide counts from 1
        call = CliRunner().invoke(main, [*few, "csv,html", "--check-row", str(row)])
        page = re.sub(r"<[^>]*>|\s|&nbsp;", "", (tmp_path / "o" / "report.html").read_text(encoding="utf-8"))
        assert f"Changed from the file: {told}" in call.output
        assert (told.replace(" ", "") in page, "check_row=2(N=0)" in page) == (True, False)
    assert CliRunner().invoke(main, [*few, "csv", "--step", "0.01", "--out", "u"]).exit_code == 0
    assert json.loads((tmp_path / "u" / "run.json").read_text(encoding="utf-8"))["set"] == {}


def test_several_variants_are_set_alike(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, ["run", "31", "v101", "--set", "V1=3.9 m/s", "--format", "csv", "--out", "all"])
    assert result.exit_code == 0, result.output
    for name in ("31", "v101"):
        assert json.loads((tmp_path / "all" / name / "run.json").read_text(encoding="utf-8"))["set"] == {"V1": "3.9 m/s"}


def test_a_copy_has_what_is_set_and_nothing_untrue(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, ["new", "mine", "--from", "31", "--set", "r1=0.91m", "--set", "N=3"])
    assert result.exit_code == 0, result.output
    text = (tmp_path / "mine.toml").read_text(encoding="utf-8")
    assert 'r1    = "0.91 m"              # DA\n' in text
    assert "check_row = 5\n" in text
    assert "alpha = 4.35 rad and 0.02" not in text
    mine, set_here = coursework.load(tmp_path / "mine.toml"), with_set(V31, ["r1=0.91m", "N=3"])
    assert (mine.values, mine.time) == (set_here.values, set_here.time)
    assert CliRunner().invoke(main, ["new", "other", "--set", "r1=0.91m"]).exit_code == 2
    plain = CliRunner().invoke(main, ["new", "plain", "--from", "31"])
    assert plain.exit_code == 0
    assert coursework.load(tmp_path / "plain.toml").remarks == V31.remarks


def test_a_start_that_follows_is_written_closed(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(main, ["new", "pp", "--from", "pantograph", "--set", "phi1=2.2 rad"]).exit_code == 0
    copied, moved = coursework.load(tmp_path / "pp.toml"), with_set(coursework.load("pantograph"), ["phi1=2.2 rad"])
    run, other = coursework.solve(copied, quantities=["table"]), coursework.solve(moved, quantities=["table"])
    assert run.table.iloc[0].tolist() == pytest.approx(other.table.iloc[0].tolist(), abs=1e-8)


@pytest.mark.parametrize("name", names())
def test_a_file_rewritten_differs_in_nothing_else(name):
    """Every variant of the catalogue, its check row set and its own words left out: read by the standard reader."""
    import tomllib

    text = (folder("variants") / f"{name}.toml").read_text(encoding="utf-8")
    wanted = tomllib.loads(text)
    for key in SAID_OF_NUMBERS:
        wanted.pop(key, None)
    wanted["time"]["check_row"] = 1
    coordinate = next(iter(wanted["coordinates"]))
    wanted["coordinates"][coordinate]["start"] = "0.5 rad"
    changes = {("time", "check_row"): 1, ("coordinates", coordinate, "start"): "0.5 rad"}
    assert tomllib.loads(rewritten(text, changes, SAID_OF_NUMBERS)) == wanted


def test_a_file_without_the_section_is_refused():
    text = (folder("variants") / "31.toml").read_text(encoding="utf-8")
    dotted = text.replace("[time]\n", "").replace('step      = "0.02 s"', 'time.step = "0.02 s"')
    with pytest.raises(coursework.InputError, match=r"the file has no section \[time\] to write scheme into"):
        rewritten(dotted, {("time", "scheme"): "euler"})
    inline = 'time = { step = "1 s", end = "2 s" }\n'
    assert rewritten(inline, {("time", "scheme"): "euler"}) == 'time = { scheme = "euler", step = "1 s", end = "2 s" }\n'
    assert rewritten(f'remarks = [\n  "a",\n]\n{inline}quote = "b"', {}, SAID_OF_NUMBERS) == inline, "no empty line is left"


def test_starts_that_a_start_has_moved_are_told(tmp_path):
    """phi1 = 165 deg instead of 2.87 rad moves the three other starts of V105; without it nothing is said."""
    said = {}
    for language, degrees in (("en", "165"), ("ru", "165"), ("en", None)):
        words = ["run", "v105", "--format", "html", "--out", str(tmp_path), "--language", language]
        called = CliRunner().invoke(main, [*words, *(["--set", f"phi1={degrees}deg"] if degrees else [])])
        said[language, degrees] = called.output, re.sub("<[^>]*>", "", (tmp_path / "report.html").read_text(encoding="utf-8"))
    screen, page = said["en", "165"]
    start = coursework.solve(coursework.load("v105").with_data({"phi1": "165 deg"}), quantities=["table"]).scene.start
    assert f"The other starts were closed anew: phi2 from 1.2 to {start[1]:.6g} rad, phi3 from 5.57 to " in re.sub(
        r"\s+", " ", screen
    )
    assert f"The other starts were closed anew: φ2 from 1.2 to {start[1]:.6g} rad, φ3 from 5.57 to " in page
    assert "φ2 было 1,2, стало 1,2012 рад" in said["ru", "165"][1]
    assert all("closed anew" not in text for text in said["en", None])


@pytest.mark.parametrize(("text", "most"), [("{}=1", 40), ("{}", 60)])
def test_what_nobody_can_set_is_quoted_as_far_as_a_line_has_room(text: str, most: int) -> None:
    for length in (most, most + 1):
        with pytest.raises(coursework.InputError) as caught:
            with_set(coursework.load("31"), (text.format("x" * length),), None)
        assert max(map(len, re.findall("x+", str(caught.value)))) == most
