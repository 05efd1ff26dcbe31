"""A submission crosses to another process as JSON and comes back the same, sentences included."""

from __future__ import annotations

import coursework
from coursework.grading.reading.expected import grid_of
from coursework.grading.reading.submission import Submission, note, submitted_file
from coursework.system.processes.plain_lines import line_of, read_line


def test_a_submission_survives_json() -> None:
    files = (submitted_file("table.csv", b"t;phi1\r\n\xff\x00"), submitted_file("скан.pdf", b"%PDF-1.4"))
    notes = (note("attachment", name="скан.pdf", why=""),)
    handed = Submission("Ім'я ‮_12", None, files, notes)
    copied = read_line(Submission, line_of(handed))
    assert copied == handed
    assert copied.notes[0].text.key == "reading.note.attachment"
    assert copied.files[0].size == 10


def test_the_grid_has_the_columns_and_units_of_the_variant() -> None:
    run = coursework.solve("v107", "euler", quantities=["table"])
    names, rows = run.columns()
    grid = grid_of(run.variant, dict(zip(names, (tuple(row) for row in rows.T.tolist()), strict=True)))
    assert grid.rows == 25
    assert [(column.name, column.unit) for column in grid.columns] == [
        ("phi2", "rad"), ("phi3", "rad"), ("s", "m"), ("w2", "1/s"), ("w3", "1/s"), ("u", "m/s"), ("w1", "1/s"),
    ]  # fmt: skip
    assert grid.columns[0].values[0] == run.variant.coordinates[0].start
