"""What a document costs against a csv with the same work beside its equations: reading and marking, processor time."""

from functools import partial

import pytest

from tests.benchmarks.timer import ratio
from tests.grading.batch.classroom import EQUATIONS, csv
from tests.grading.marking import students
from tests.grading.reading.documents.papers import MAKERS
from tests.grading.reading.documents.test_right_work import LATEX, PLAIN, graded, rows

MOST = 2.0  # 0.99 (JSON) to 1.4 (Word) of a quiet machine
KINDS = ("word by pandoc", "notebook, page", "opendocument", "markdown", "json, records")


@pytest.mark.parametrize("kind", KINDS)
def test_a_document_costs_at_most_two_tables(kind):
    name, made = MAKERS[kind]
    document = {name: made(PLAIN, rows(students.table()), LATEX)}
    plain = {"table.csv": csv(students.table()), "equations.txt": "\n".join(EQUATIONS).encode()}
    assert ratio(partial(graded, document), partial(graded, plain), most=MOST, repeats=3) <= MOST
