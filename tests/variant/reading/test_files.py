"""Files that are read: the page's own file, every byte form an editor saves, and what becomes of them."""

from pathlib import Path

import numpy as np
import pytest

import coursework
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant
from coursework.variant.toml.positions import locate

REFERENCE = Path(__file__).parents[2] / "reference"
PAGE = REFERENCE / "format_page_31.toml"


@pytest.fixture(scope="module")
def page():
    return coursework.load(PAGE)


def test_the_file_of_the_format_page_loads(page):
    assert page.title == "Rolling wheel, right-angled link, crank and rod"
    assert page.values == {"r1": 0.953, "r2": 0.847, "r3": 0.457, "V1": 4.5, "p": 13.08, "alpha": 4.35}
    assert page.columns == ("phi1", "phi2", "phi3", "w1", "w2", "w3", "w4")
    assert [(c.name, c.start, c.rate, c.unit) for c in page.coordinates] == [
        ("phi1", 1.63, "w1", "rad"),
        ("phi2", 3.37, "w2", "rad"),
        ("phi3", 2.87, "w3", "rad"),
    ]
    assert page.unknowns == (("w4", "1/s"),)
    assert (page.time.step, page.time.end, page.time.check_row) == (0.02, 0.48, 4)
    assert page.time.period == 2 * np.pi / 13.08
    assert [c.name for c in page.constraints] == ["11", "12", "16", "18"]
    assert page.constraints[0].because == "C keeps its height: V_Cy = 0 along M-B-C"
    assert [name for name, _ in page.points] == ["D", "A", "B", "M", "C", "P"]
    assert [(link.name, link.rate) for link in page.links] == [("1", "w1"), ("2", "w2"), ("3", "w3"), ("4", "w4")]
    assert (page.links[3].wheel, page.links[3].contact) == ("C", "P")
    assert page.frame.hinges == ("D",)
    assert (page.driven, len(page.holds)) == ("M", 1)
    assert page.ask == ("table", "plots", "checks", "graph_check", "accuracy")


def test_the_page_and_the_catalogue_say_the_same_mechanism(page):
    ours = coursework.load("31")
    for part in ("given", "drive", "coordinates", "unknowns", "time", "points", "links", "frame", "driven", "holds"):
        assert getattr(page, part) == getattr(ours, part), part
    assert [(c.left, c.right) for c in page.constraints] == [(c.left, c.right) for c in ours.constraints]


def test_the_file_of_the_format_page_runs_with_what_it_asks_for(page):
    run = coursework.solve(page)
    assert len(run.table) == 25
    assert run.stop is None
    assert run.asked == page.ask


def as_saved_by(editor, text):
    return {
        "plain": text.encode(),
        "byte order mark": b"\xef\xbb\xbf" + text.encode(),
        "Windows line ends": text.replace("\n", "\r\n").encode(),
        "both": b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode(),
        "no last line end": text.rstrip("\n").encode(),
        "tabs": text.replace("    ", "\t").encode(),
    }[editor]


@pytest.mark.parametrize("editor", ["byte order mark", "Windows line ends", "both", "no last line end", "tabs"])
def test_every_editor_saves_the_same_variant(editor):
    text = PAGE.read_text(encoding="utf-8")
    assert parse_variant(as_saved_by(editor, text), "page") == parse_variant(as_saved_by("plain", text), "page")


def test_dotted_keys_inline_tables_and_long_texts_are_toml_too():
    text = PAGE.read_text(encoding="utf-8")
    start = text.index("[time]"), text.index("[[constraint]]")
    inline = 'time = { step = "0.02 s", end = "0.48 s", period = "2*pi/p", check_row = 4 }\n'
    changed = text[: start[0]] + text[start[1] :]
    changed = changed.replace("format = 1\n", "format = 1\n" + inline)
    changed = changed.replace(
        '"VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"', '"""VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0"""'
    )
    assert parse_variant(changed, "x").time == parse_variant(text, "x").time
    assert parse_variant(changed, "x").constraints[0].left == parse_variant(text, "x").constraints[0].left


def test_dots_and_brackets_inside_texts_are_no_nesting():
    text = PAGE.read_text(encoding="utf-8")
    wild = "a.b.c.d.e.f.g.h.i.j.k... " + "[" * 30 + "{" * 30
    changed = text.replace("format = 1\n", f'format = 1\nremarks = ["""\n{wild}\n"""]\n')
    assert parse_variant(changed).remarks == (f"{wild}\n",)


def test_numbers_may_stand_bare_in_si():
    text = PAGE.read_text(encoding="utf-8")
    changed = text.replace('"0.953 m"', "0.953").replace('"1.63 rad"', "1.63").replace('"0.02 s"', "0.02")
    changed = changed.replace('VMx = "0"', "VMx = 0")
    bare, written = parse_variant(changed), parse_variant(text)
    assert bare.values == written.values
    assert bare.coordinates[0].start == 1.63
    assert bare.coordinates[0].unit == "rad"
    assert bare.drive == written.drive


@pytest.mark.parametrize(
    ("written", "value"), [("10 rpm", np.pi / 3), ("10", 10.0), ("10 rad/s", 10.0), ("600 deg/s", 600 * np.pi / 180)]
)
def test_a_drive_may_be_a_value_with_its_unit(written, value):
    text = (Path(__file__).parents[1] / "bad" / "time-period.toml").read_text(encoding="utf-8")
    run = coursework.solve(
        parse_variant(text.replace('period = "0 s"\n', "").replace('w1 = "10"', f'w1 = "{written}"')), end=0.05
    )
    assert run.motion.column("w1")[0] == pytest.approx(value, rel=1e-15)
    assert not spelled(run.variant.drive[0].formula).endswith(".0")


def test_a_folder_a_missing_file_and_a_device_are_refused(tmp_path):
    """These have no text, so no line can be named: the file stands alone before the sentence."""
    with pytest.raises(coursework.InputError) as caught:
        coursework.load(tmp_path / "none.toml")
    assert [(fault.file, fault.line) for fault in caught.value.faults] == [(str(tmp_path / "none.toml"), 0)]
    with pytest.raises(coursework.InputError, match=r"this is a folder\. Name the file in it\."):
        coursework.load(tmp_path)
    with pytest.raises(coursework.InputError, match=r"there is no such file\. Check the name and the folder\."):
        coursework.load(tmp_path / "none.toml")
    with pytest.raises(coursework.InputError, match="this is not a file with text in it"):
        coursework.load("/dev/null")
    with pytest.raises(coursework.InputError, match="cannot be read"):
        coursework.load("a\0b.toml")


def test_positions_of_keys_and_values():
    found = locate(
        'a = "x" # remark\n"φ1" = 5\n[time]\nd.e = {f = 1, "g h" = [1, "two",\n  [3]]}\n'
        'long = """\n[not]\nb = 1\n"""\n[[constraint]]\nname = 1\n[constraint.sub]\nk = 2\n[[constraint]]\n'
    )
    assert found.values["a",] == (1, 5)
    assert found.keys["φ1",] == (2, 1)
    assert found.values["time", "d", "e", "f"] == (4, 12)
    assert found.values["time", "d", "e", "g h", 1] == (4, 27)
    assert found.values["time", "d", "e", "g h", 2, 0] == (5, 4)
    assert found.keys["constraint", 0] == (10, 3)
    assert found.values["constraint", 0, "sub", "k"] == (13, 5)
    assert found.keys["constraint", 1] == (14, 3)
    assert ("time", "b") not in found.keys
    assert found.find(("time", "d", "e", "nothing")) == (4, 7)
    assert found.find(("nothing",)) == (0, 0)
