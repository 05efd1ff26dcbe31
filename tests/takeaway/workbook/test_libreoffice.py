"""LibreOffice itself recalculates every file of the catalogue with changed data; in the long set, for it takes minutes."""

import io
import shutil
import subprocess

import numpy as np
import openpyxl
import pytest

import coursework
from coursework.takeaway.workbook.book import workbook_of
from coursework.takeaway.workbook.names import defined_names, start_of
from coursework.words.errors import CourseworkError
from tests.takeaway.workbook.test_workbook import FILES, off, table

pytestmark = [
    pytest.mark.long,
    pytest.mark.skipif(shutil.which("soffice") is None, reason="LibreOffice is not installed"),
]


def changes(variant, run):
    """Another step; one datum that other starts follow from by a formula, or not at all; one given start value."""
    yield {"step": variant.time.step * 0.9}
    chain = bool(variant.groups)
    for kind, known in (
        ("given", variant.values),
        ("start", {c.name: c.start for c in variant.coordinates if c.start is not None}),
    ):
        for name, value in known.items():
            change = {name: value * 1.003 + (0.001 if kind == "start" else 0.0)}
            try:
                other = coursework.solve(variant.with_data(given=change), scheme="euler", quantities=["table"])
                start, rows = list(other.scene.start), len(other.motion.t)
            except CourseworkError:
                continue
            kept = list(run.scene.start)
            if kind == "start":
                kept[[c.name for c in variant.coordinates].index(name)] = change[name]
            if rows and (chain or np.allclose(start, kept, rtol=0, atol=1e-13)):
                yield change
                break


def test_every_file_recalculates_to_the_run_with_its_changes(tmp_path):
    made, cases = tmp_path / "made", []
    made.mkdir()
    for name in FILES:
        variant = coursework.load(name)
        run = coursework.solve(name, scheme="euler")
        content, cells = workbook_of(run, "en"), defined_names(variant)
        for number, change in enumerate(changes(variant, run)):
            book = openpyxl.load_workbook(io.BytesIO(content))
            for datum, value in change.items():
                defined = "step" if datum == "step" else cells.get(datum) or cells[start_of(datum)]
                sheet, _, cell = book.defined_names[defined].attr_text.partition("!")
                book[sheet][cell.replace("$", "")] = value
            file = made / f"{name}-{number}.xlsx"
            book.save(file)  # without cached numbers: what is read below was calculated
            cases.append((variant, change, file.name))
    command = ["soffice", "--headless", f"-env:UserInstallation={(tmp_path / 'profile').as_uri()}", "--convert-to", "xlsx"]
    subprocess.run([*command, "--outdir", tmp_path, *sorted(made.iterdir())], check=True, capture_output=True)
    assert len(cases) > 90
    for variant, change, file in cases:
        given = {name: value for name, value in change.items() if name != "step"}
        run = coursework.solve(variant.with_data(given=given, step=change.get("step")), scheme="euler", quantities=["table"])
        book = openpyxl.load_workbook(tmp_path / file, data_only=True)
        cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row]
        assert not [cell.coordinate for cell in cells if cell.data_type == "e"], file
        _, rows = table(run)
        found = [[book["Euler"].cell(2 + row, 1 + column).value for column in range(rows.shape[1])] for row in range(len(rows))]
        both = sum(row[0] is not None for row in found)
        assert both > 1 and off(np.array(found[:both], dtype=float), rows[:both]) < 1e-9, (file, change)
