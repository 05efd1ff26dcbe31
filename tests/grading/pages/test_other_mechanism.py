"""A mechanism of nobody's catalogue, and equations in a document: the same sentences, true there too."""

from __future__ import annotations

import re

import numpy as np
import pytest

from coursework.grading.batch.work import Setup, Task, VariantSource
from coursework.grading.batch.workshop import Workshop
from coursework.grading.marking.reasons.reasons import told
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.system.processes.plain_lines import plain_of
from coursework.words.sentences import load_phrases
from tests.grading.batch.classroom import EQUATIONS
from tests.grading.pages.truths import VARIANT, files
from tests.mechanisms.library import mechanism

# A crank a turns a rod b whose end B slides along x: x = a cos q + b cos s, a sin q + b sin s = 0.
SLIDER = mechanism("slider-crank-in-other-letters")
A, B, N, H, ROWS = 0.21, 0.74, 2.5, 0.02, 16


def table() -> np.ndarray:
    q, rows = np.array([0.4, -0.110749, 0.928881]), []
    for _ in range(ROWS):
        v = -A * N * np.cos(q[0]) / (B * np.cos(q[1]))
        rows.append([*q, N, v, -A * N * np.sin(q[0]) - B * v * np.sin(q[1])])
        q = q + H * np.array(rows[-1][3:6])
    return np.array(rows)


def csv(rows: np.ndarray) -> bytes:
    head = "t;q;s;x, mm;u;v;y, mm/s"
    scaled = rows * [1, 1, 1000, 1, 1, 1000]
    body = [f"{k * H:.2f};" + ";".join(f"{value:.4f}" for value in row) for k, row in enumerate(scaled)]
    return "\n".join([head, *body]).encode()


def marked(source: VariantSource, **handed: bytes) -> tuple[dict, str, str]:
    submission = Submission("lee", None, tuple(submitted_file(name.replace("_", "."), text) for name, text in handed.items()))
    outcome = Workshop(Setup()).answer(plain_of(Task(submission, source)))
    return outcome.grade, told(outcome.grade, load_phrases()), outcome.page


@pytest.fixture(scope="module")
def slider() -> VariantSource:
    return VariantSource("slider", SLIDER.encode())


def test_a_slider_in_millimetres_is_told_in_millimetres(slider):
    rows = table()
    rows[6, 2] += 0.004
    grade, said, _ = marked(
        slider, table_csv=csv(rows), equations_txt=b"a*u*cos(q) + b*v*cos(s) = 0\ny + a*u*sin(q) = b*v*sin(s)\n"
    )
    assert grade["first_wrong"]["row"] == 7
    stands, wanted = 1000 * rows[6, 2], 1000 * (rows[5, 2] + H * rows[5, 5])
    first = re.search(r"Row 7: .* = ([\d.]+) mm for x; ([\d.]+) mm stands there \(tolerance ([\d.]+) mm\)", said)
    assert float(first[2]) == pytest.approx(stands, abs=6e-5)
    assert float(first[1]) == pytest.approx(wanted, abs=float(first[3]))
    assert "Line 2 of the equations is not right." in said
    assert "A different sign of b*v*sin(s) would" in said
    assert "Equations: 20 of 40 points (40 · 1 / 2)" in said
    assert grade["table"]["score"] == round(60 * (ROWS * 6 - 3 - 1) / (ROWS * 6 - 3), 2)


def test_a_right_slider_is_told_nothing_wrong(slider):
    right = b"a*u*cos(q) + b*v*cos(s) = 0\ny = -a*u*sin(q) - b*v*sin(s)\n"
    grade, said, page = marked(slider, table_csv=csv(table()), equations_txt=right)
    assert (grade["score"], said) == (100, "")
    assert f"All {2 * (ROWS - 1) + ROWS - 1} steps of the coordinates follow" in page
    # Each velocity on the curve of its own, to a hundredth of a pixel; of one the fourth decimal is more than that.
    assert (page.count('class="exact'), page.count('class="exact dotted"')) == (3, 2)


def test_the_term_with_the_other_sign_is_named_in_a_document():
    """Its column was that of the line as extracted, which is none of the file's and none of the page's."""
    line = EQUATIONS[3].replace("- r1", "+ r1")
    lines = [*EQUATIONS[:3], line]
    document = "\n\n".join(["# Work", *(f"${text}$" for text in lines)]).encode()
    _, said, page = marked(VariantSource("31", VARIANT.read_bytes()), work_md=document, table_csv=files()["table.csv"])
    assert "An equation in the document is not right (line 9). A different sign of r1*w1*cos(phi1) would" in said
    assert f"<code>{line}</code>" in page
