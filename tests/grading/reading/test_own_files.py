"""What the tool itself writes beside a table is no work of a student; a student's own JSON is."""

import json

import pytest
from click.testing import CliRunner

from coursework.commands.cli import main
from coursework.grading.reading.documents.document import Document, DocumentLine, place_of
from coursework.grading.reading.documents.read_document import lines_of_document
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.batch.classroom import EQUATIONS
from tests.grading.reading.table.misread import HEAD, ROWS
from tests.grading.scenes import expected


@pytest.fixture(scope="module", params=[("run", "run.json", "table.csv"), ("accuracy", "accuracy.json", "accuracy.csv")])
def written(request, tmp_path_factory):
    """The record of a run or a study, and the table beside it, as the command writes them."""
    command, record, table = request.param
    out = tmp_path_factory.mktemp("own")
    assert CliRunner().invoke(main, [command, "31", "--format", "csv", "--out", str(out)]).exit_code in (0, 1)
    return (out / record).read_bytes(), (out / table).read_bytes()


def read(**files):
    handed = tuple(submitted_file(name.replace("_", "."), content) for name, content in files.items())
    return read_submission(Submission("s", None, handed), expected("31"))


def test_the_record_of_a_run_is_passed_over(written):
    record, table = written
    alone, both = read(table_csv=table), read(run_json=record, table_csv=table)
    assert (both.table, both.equations, both.answers, both.notes) == (alone.table, None, alone.answers, alone.notes)
    assert [(entry.name, entry.kind) for entry in both.files] == [("run.json", "ignored"), ("table.csv", alone.files[0].kind)]
    only = read(run_json=record)
    assert (only.table, only.equations, only.answers, only.notes) == (None, None, (), ())


@pytest.mark.parametrize("more", [{}, {"variant": "31"}, {"variant": "31", "versions": {"python": "3.11"}, "stamp": "noon"}])
def test_a_student_s_own_json_is_read(more):
    own = {**more, "table": [HEAD, *ROWS], "equations": list(EQUATIONS)}
    found = read(own_json=json.dumps(own, indent=1).encode())
    assert found.table is not None and len(found.equations) == len(EQUATIONS)


def test_lines_within_a_line_do_not_move_the_places_of_what_stands_below():
    """The report of the tool as LaTeX, handed in, ended the marking: its equations lay behind the last line of the document."""
    texts = ["The largest residual = 0 is\nthat of equation 12\n= 0.", EQUATIONS[0]]
    lines = [DocumentLine(text, place_of("line", line=place)) for place, text in enumerate(texts, start=1)]
    found = lines_of_document(Document("tex", lines=lines), "report.tex", expected("31")).equations
    assert (found[-1].text, found[-1].place, found[-1].tree is None) == (texts[1], lines[1].place, False)
