"""A quantity is one record: added to `QUANTITIES` it is asked for, planned, counted and shown; nowhere else is it named."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.drawing.paper.record import Drawing
from coursework.report.pages import build_model
from coursework.report.sections import sections
from coursework.report.sections.sections import APPENDIX, FIRST, LAST, PAPER
from coursework.report.text.parts import Paragraph
from coursework.results.kinematics.extra import ExtraTable
from coursework.scene import quantities
from coursework.scene.quantities import QUANTITIES, Columns, OwnFigure, OwnSection, OwnTable, Quantity
from coursework.system.on_demand import computed
from coursework.variant.record.variant import Variant
from coursework.words.data_folders import folder
from coursework.words.sentences import say
from tests.sources import PACKAGE, files, strings

SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50"><path d="M0 0L9 9"/></svg>'


@computed("motion", "accelerations")
def power(results):
    """A quantity of tomorrow, one number a row."""
    return np.sum(results.motion.velocities * results.accelerations, axis=1)[:, None]


def as_table(_, rows):
    return ExtraTable("Power of the links.", ("power",), ("W",), rows)


SHOWN = {
    "columns": Columns(as_table),
    "table": OwnTable(lambda _, rows: ExtraTable("Power of the links.", ("n", "power"), ("", "W"), np.hstack([rows, rows])[:7])),
    "figure": OwnFigure(
        lambda _, rows, written: (Drawing("power", SVG, 40.0, 30.0, written("Power of the links."), "Power over time."),)
    ),
}


@pytest.fixture(params=SHOWN)
def dummy(request, monkeypatch):
    record = Quantity(power, SHOWN[request.param], refuses=lambda variant: None if variant.name == "31" else say("fault.V501"))
    monkeypatch.setattr(quantities, "QUANTITIES", (*QUANTITIES, record))
    return request.param


def test_a_record_alone_is_found_everywhere(dummy, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    told = CliRunner().invoke(main, ["run", "31", "--quantities", "table,power", "--format", "csv,html", "--out", "out"])
    assert told.exit_code == 0, told.output
    said = json.loads(Path("out/run.json").read_text(encoding="utf-8"))
    assert said["quantities"] == ["table", "power"]
    about = "A quantity of tomorrow, one number a row."
    assert said["contents"][-1] == {"name": "power", "about": about, "shown": dummy, "needs": ["motion", "accelerations"]}
    assert (said["columns"]["w3"], said["columns"].get("power")) == ("rad/s", "W" if dummy == "columns" else None)
    own = Path("out/power.csv")
    assert own.exists() == (dummy == "table")
    with (own if dummy == "table" else Path("out/table.csv")).open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    assert (rows[0][-1] == "power", len(rows)) == {"table": (True, 8), "columns": (True, 26), "figure": (False, 26)}[dummy]
    page = Path("out/report.html").read_text(encoding="utf-8")
    assert ("Power of the links" in page, "Power over time" in page) == (True, dummy == "figure")
    plan = CliRunner().invoke(main, ["run", "31", "--plan", "--quantities", "power"]).output.splitlines()
    assert {"  power                asked for", "  accelerations        needed by power"} <= set(plan)
    left = CliRunner().invoke(main, ["run", "31", "--plan", "--quantities", "table"]).output.splitlines()
    assert "  power                not asked for" in left
    unknown = CliRunner().invoke(main, ["run", "31", "--quantities", "powr"]).output
    assert 'Did you mean "power"?' in unknown
    assert f"{QUANTITIES[-1].name}, power, phi1," in unknown


def test_a_record_says_which_variants_cannot_have_it(dummy):
    with pytest.raises(coursework.InputError, match="the file names none"):
        coursework.solve("example-2", quantities=["power"])
    with pytest.raises(coursework.InputError, match='"power" needs every coordinate'):
        coursework.solve("31", quantities=["power", "phi3"])


def test_it_is_counted_and_costs_nothing_unasked(dummy):
    bare, asked = (coursework.solve("31", quantities=["table", *more]) for more in ([], ["power"]))
    for run in (bare, asked):
        run.columns()
        build_model(run)
    assert "power" not in bare.scene.ledger.calls
    added = {"power": 1, "accelerations": 1}
    assert asked.scene.ledger.calls == bare.scene.ledger.calls | added
    assert list(asked.table.columns)[-1:] == (["power"] if dummy == "columns" else ["w4"])


def test_a_table_of_any_motion_has_the_columns_of_the_record(monkeypatch):
    monkeypatch.setattr(quantities, "QUANTITIES", (*QUANTITIES, Quantity(power, SHOWN["columns"])))
    assert list(coursework.exact("31", quantities=["table", "power"]).columns)[-1] == "power"


def power_of_links(context):
    """A section of tomorrow."""
    return [Paragraph(context.rich(f"{np.max(context.run.of(quantities.QUANTITIES[-1])):.3f} W"))]


def test_a_quantity_with_a_section_of_its_own(tmp_path, monkeypatch):
    record = Quantity(power, OwnSection())
    monkeypatch.setattr(quantities, "QUANTITIES", (*QUANTITIES, record))
    monkeypatch.setattr(sections, "PAPER", (*PAPER, (power_of_links, record)))
    monkeypatch.chdir(tmp_path)
    words = (folder("reports") / "words.en.toml").read_text(encoding="utf-8")
    Path("own").mkdir()
    titled = words.replace("[section]\n", '[section]\npower_of_links = "Power of the links"\n')
    Path("own/words.en.toml").write_text(titled, encoding="utf-8")
    for asked in ("table", "table,power"):
        line = ["run", "31", "--quantities", asked, "--format", "csv,html", "--out", "out", "--templates", "own"]
        told = CliRunner().invoke(main, line)
        assert told.exit_code == 0, told.output
        page = Path("out/report.html").read_text(encoding="utf-8")
        assert ("Power of the links" in page, 'id="power_of_links"' in page) == (("power" in asked),) * 2
    said = json.loads(Path("out/run.json").read_text(encoding="utf-8"))
    assert (said["contents"][-1]["name"], said["contents"][-1]["shown"]) == ("power", "section")
    assert "power" not in said["columns"]


def test_every_record_is_shown_somewhere():
    written = {quantity.name for _, quantity in (*FIRST, *PAPER, *LAST, *APPENDIX) if quantity is not None}
    assert written == {one.name for one in QUANTITIES if isinstance(one.shows, OwnSection)}
    assert all(one.compute.__doc__ for one in QUANTITIES)


# What is shown by its record alone; "points" is a section of a file too, and read by that name.
BY_RECORD = [
    one.name for one in QUANTITIES if not isinstance(one.shows, OwnSection) and one.name not in Variant.__dataclass_fields__
]


@pytest.mark.parametrize("name", BY_RECORD)
def test_no_other_file_names_a_quantity(name):
    naming = {path.relative_to(PACKAGE).as_posix() for path in files() if name in strings(path)}
    assert naming <= {"scene/quantities.py", "scene/motion_results.py"}


def test_a_run_without_pages_makes_only_what_files_of_numbers_or_the_record_hold():
    """Graphs, drawings and listings are on pages alone; the cost of accuracy has a command of its own."""
    everything = [one.name for one in QUANTITIES]
    drawn = {"plots", "accuracy", "trajectories", "hodographs", "listing", "flowchart"}
    assert {one.name for one in QUANTITIES if one.only_pages} == drawn and drawn < set(everything)
