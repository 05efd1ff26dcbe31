"""What a workbook and a note cost beyond a warm page, against the libraries that write them at work on next to nothing.

On a calm core a workbook of 31 takes 16 ms and that of andrews 90, where 150 are allowed, a note 0.4 s, where 1.5 are.
"""

import time
from io import BytesIO

import pytest
import xlsxwriter

from coursework.report.output.formats import formats_for
from coursework.takeaway.note.pandoc import called
from tests.benchmarks.test_whole_process import spent as of_children
from tests.benchmarks.timer import ratio
from tests.takeaway.taken import results_of

WORKBOOK = {"31": 1.0, "andrews": 2.7}  # 0.66 and 1.9 on a calm machine
NOTE = {"31": 12.0}  # 9.0; 6.9 of jansen
ROWS, COLUMNS = 100, 10


def bare_book():
    """A workbook of a thousand formulas with their values, by XlsxWriter alone."""
    file = xlsxwriter.Workbook(BytesIO(), {"in_memory": True})
    sheet = file.add_worksheet()
    for row in range(ROWS):
        for column in range(COLUMNS):
            sheet.write_formula(row, column, f"=_r1*SIN(_p*A{row + 1}+_alpha)", None, 0.1 * row)
    file.close()


def bare_note():
    """The two calls of pandoc that a note makes, with one formula in all."""
    called(["-f", "typst", "-t", "json"], b"$ x $")
    called(["-f", "markdown", "-t", "docx", "-o", "-"], b"$x$")


def in_all():
    """Processor time of this process and of the programs that it has called."""
    return time.process_time() + of_children()


def cost(name, suffix, most=0.0):
    """Return the cost of a format, its page made, against the bare library."""
    write, results = formats_for("run")[suffix].write, results_of(name)
    bare = bare_book if suffix == "xlsx" else bare_note
    return ratio(lambda: list(write(results)), bare, most=most, repeats=3, clock=in_all)


@pytest.mark.parametrize(("name", "most"), WORKBOOK.items())
def test_a_workbook_against_a_thousand_bare_formulas(name, most):
    assert cost(name, "xlsx", most) <= most


@pytest.mark.parametrize(("name", "most"), NOTE.items())
def test_a_note_against_pandoc_with_one_formula(name, most):
    assert cost(name, "docx", most) <= most
