"""`--format dxf`: read back by ezdxf, whose audit finds nothing; millimetres are those of the sheet."""

import io
import math
from pathlib import Path

import ezdxf
import pytest

from coursework.takeaway.figures.drafting import LAYERS, Draft
from coursework.takeaway.figures.shapes import Pen, Words
from coursework.variant.catalogue import names
from tests.command import call
from tests.sample import sampled_pairs
from tests.solved import solved
from tests.takeaway.taken import taken

CATALOGUE = Path(__file__).parents[3] / "variants"


def document(content: bytes):
    return ezdxf.read(io.StringIO(content.decode()))


@pytest.mark.parametrize(("name", "suffix"), sampled_pairs(names(), ["dxf"], {("31", "dxf"), ("v107", "dxf"), ("cardan", "dxf")}))
def test_every_drawing_passes_the_audit_on_its_layers(name, suffix):
    files = taken(name, suffix)
    assert {"dxf/mechanism.dxf"} <= set(files)
    for content in files.values():
        read = document(content)
        audit = read.audit()
        assert not audit.errors and not audit.fixes
        assert {entity.dxf.layer for entity in read.modelspace()} <= {*LAYERS}


def test_links_have_the_lengths_of_the_file_at_the_scale_of_the_sheet():
    read = document(taken("31", "dxf")["dxf/graph-check.dxf"])
    values = {datum.name: datum.value for datum in solved("31").variant.given}
    links = [(line.dxf.start - line.dxf.end).magnitude for line in read.query('LINE[layer=="links" & lineweight==80]')]
    for length in (values["r1"], values["r2"], 2 * values["r3"], values["r3"]):  # 1:10
        assert any(math.isclose(one, 100 * length, abs_tol=0.2) for one in links), length
    (wheel,) = read.query('CIRCLE[layer=="links"]')
    assert wheel.dxf.radius == pytest.approx(100 * values["r3"] / 2, abs=0.05)
    assert read.units == ezdxf.units.MM


def test_arrows_are_leaders_and_hatching_is_a_hatch():
    space = document(taken("31", "dxf")["dxf/graph-check.dxf"]).modelspace()
    arrows = {tuple(round(part, 1) for part in one.vertices[0][:2]) for one in space.query('LEADER[layer=="velocities"]')}
    tips = [text for text in space.query("MTEXT") if "m/s" in text.text and text.text.startswith("\\f")]
    assert len(arrows) >= 2 and len(tips) == 4  # two of the four speeds are too short for an arrow
    assert {hatch.dxf.pattern_name for hatch in space.query('HATCH[layer=="ground"]')} == {"GROUND"}
    hatch = space.query('HATCH[layer=="ground"]').first
    assert hatch.pattern.lines[0].angle % 180 == pytest.approx(45)  # as the sheet leans, y up
    said = {one.plain_text() for one in space.query("MTEXT")}
    assert "scale 1:10" in said and any("4.10 m/s" in one for one in said)


def test_twelve_positions_are_drawn_without_being_asked_for():
    assert set(taken("31", "dxf")) == {f"dxf/{one}.dxf" for one in ("mechanism", "positions", "graph-check")}
    assert len(document(taken("31", "dxf")["dxf/positions.dxf"]).query('CIRCLE[layer=="links"]')) == 12


def test_what_it_declares_stands_in_one_order_in_every_process():
    declared = [one.dxf.name for one in document(taken("31", "dxf")["dxf/mechanism.dxf"]).classes.classes.values()]
    ours = [name for name in declared if name in ("ACDBPLACEHOLDER", "DICTIONARYVAR", "MATERIAL", "WIPEOUT", "WIPEOUTVARIABLES")]
    assert ours == sorted(ours) and len(ours) > 3


def test_words_of_a_file_are_no_commands():
    draft = Draft(10.0, 10.0)
    draft.draw(Words(1 + 1j, (("\\P{x}^J%%u;\x07\n₁₂", 3.2, 0.0),), 3.2, False, False, Pen(0.0, (), {})))
    (text,) = draft.space
    assert text.plain_text(fast=False).replace(" ", "") == "\\P{x}^J%%u;^12"
    assert "\x07" not in text.text


@pytest.mark.usefixtures("folder")
def test_what_cannot_be_drawn_or_has_no_package_is_told_and_the_rest_written(folder, monkeypatch):
    text = (CATALOGUE / "31.toml").read_text(encoding="utf-8").partition("[points]")[0]
    (folder / "bare.toml").write_text(f'{text}[ask]\nquantities = ["table"]\n', encoding="utf-8")
    called = call("run", "bare.toml", "--format", "csv,dxf,figures", "--out", "bare")
    assert (called.exit_code, "W041" in called.stderr, "W042" in called.stderr) == (2, True, True), called.output
    assert sorted(path.name for path in (folder / "bare").iterdir()) == ["run.json", "table.csv"]
    monkeypatch.setattr("coursework.system.extras.find_spec", lambda name: None)
    called = call("run", "31", "--quantities", "table", "--format", "csv,dxf", "--out", "taken")
    assert called.exit_code == 2 and (folder / "taken/table.csv").is_file()
    assert "-m pip install" in called.stderr and "[dxf]" in called.stderr
