"""Formats are records: one added in a test is offered, written and listed wherever a format is."""

import csv
import io
import json
import re
from functools import partial
from pathlib import Path

import pytest

import coursework
from coursework.report.output import formats
from coursework.report.output.formats import FORMATS, Format
from coursework.report.output.tables import STUDY_HEAD
from coursework.results.accuracy.timing import seconds
from coursework.words.errors import OutputError
from tests.command import call

pytestmark = pytest.mark.usefixtures("folder")
README = Path(__file__).parents[3] / "README.md"


def _dummy(results):
    yield f"{results.stem}.dummy", f"{results.run.variant.title} {results.stamp}".encode()


DUMMY = Format("dummy", _dummy, ("run", "accuracy", "write_report"))


@pytest.fixture
def dummy(monkeypatch):
    monkeypatch.setattr(formats, "FORMATS", (*FORMATS, DUMMY))


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    """What `accuracy` said, and the folder where it wrote in two formats, of which one is new.

    Each trial is timed once: how long it takes is nobody's claim here.
    """
    folder = tmp_path_factory.mktemp("study")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(formats, "FORMATS", (*FORMATS, DUMMY))
        patch.setattr("coursework.results.accuracy.study.seconds", partial(seconds, repeats=1, shortest=0.0))
        return call("accuracy", "31", "--format", "csv,dummy", "--out", folder), folder


@pytest.mark.usefixtures("dummy")
def test_a_new_format_is_offered_and_written_everywhere(folder, study):
    for command in ("run", "accuracy"):
        assert "html,pdf,csv" in (told := call(command, "--help").stdout) and "dummy" in told
    assert call("run", "31", "--quantities", "table", "--format", "dummy").exit_code == 0
    record = json.loads((folder / "coursework-31/run.json").read_text(encoding="utf-8"))
    assert list(record["files"]) == ["report.dummy"]
    assert (folder / "coursework-31/report.dummy").read_text(encoding="utf-8").endswith(record["stamp"])
    result, beside = study
    assert result.stdout.endswith("accuracy.csv, accuracy.dummy, accuracy.json\n")
    assert (beside / "accuracy.dummy").is_file()
    coursework.write_report(coursework.solve("31", quantities=["table"]), folder / "page.dummy")
    assert (folder / "page.dummy").is_file()
    assert re.search(r"Formats: html, pdf, csv, .*dummy\.", call("run", "31", "--format", "rtf").stderr)
    with pytest.raises(OutputError, match=r"end in \.html, \.pdf or \.dummy"):
        coursework.write_report(coursework.solve("31"), "a.docx")


def test_without_the_option_every_format_is_written_that_need_not_be_asked_for(folder):
    assert call("run", "31", "--quantities", "table").exit_code == 0
    names = {path.suffix.removeprefix(".") for path in (folder / "coursework-31").iterdir()}
    assert names == {*(each.suffix for each in FORMATS if not each.asked), "json"}


def test_the_readme_names_every_format():
    text = README.read_text(encoding="utf-8")
    for each in FORMATS:
        assert re.search(rf"\b{each.suffix}\b", text), each.suffix


def test_a_study_as_csv_holds_every_method(study):
    result, beside = study
    assert result.exit_code == 0, result.output
    head, *rows = csv.reader(io.StringIO((beside / "accuracy.csv").read_text(encoding="utf-8")))
    assert tuple(head) == STUDY_HEAD
    assert {"explicit Euler", "Heun", "Runge-Kutta 4"} <= {row[0] for row in rows}
    own = next(row for row in rows if row[:2] == ["explicit Euler", "24"])
    assert float(own[3]) == pytest.approx(0.152, rel=1e-2)  # README, "What accuracy costs"
    assert own[4] == "rad"
    assert all(float(row[7]) > 0 for row in rows if not row[8])


def test_a_format_that_is_not_offered_is_refused_before_anything_is_measured(folder, monkeypatch):
    monkeypatch.setattr("coursework.commands.accuracy.variant_of", None)
    result = call("accuracy", "31", "--format", "docx")
    assert result.exit_code == 2
    assert result.stderr == 'C015 "docx" is not a format here. Formats: html, pdf, csv.\n'
    assert list(folder.iterdir()) == []
