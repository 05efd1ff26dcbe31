"""What programs and derivations write round right equations: places derived, quotients drawn, entries of vectors."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np
import pytest

from coursework.grading.marking.equations.linear import linear
from coursework.grading.marking.equations.probe import Probe
from coursework.grading.reading.documents.notebook import document_of_notebook
from coursework.grading.reading.documents.read_document import tables_of_document
from coursework.grading.reading.equations.formulas.equations import names_for, read_line
from coursework.grading.reading.equations.formulas.labels import without_words
from coursework.grading.reading.equations.systems.complex_lines import real_and_imaginary
from coursework.grading.reading.equations.systems.components import with_entries_apart
from coursework.grading.reading.equations.systems.drawn import in_one_line
from coursework.grading.reading.equations.systems.negated import with_a_name
from coursework.grading.reading.equations.text.remarks import without_constants
from coursework.grading.reading.equations.text.text_lines import text_lines
from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from coursework.variant.formula.reader import parse_equation
from coursework.variant.formula.tree import Formula
from tests.grading.reading.equations.notation.test_notations import PLAIN, marked
from tests.grading.scenes import expected

if TYPE_CHECKING:
    from collections.abc import Callable

DERIVED = """{xB} = 2*r3*w3*sin(phi3)
{yB} = VMy - 2*r3*w3*cos(phi3)
{xC} = {xB} - r3*w3*cos(phi3)
{yC} = {yB} - r3*w3*sin(phi3) = 0
{xC} = -0.5*r3*w4
{xB} = -r1*w1*sin(phi1) - r2*w2*sin(phi2)
{yB} = r1*w1*cos(phi1) + r2*w2*cos(phi2)"""
PLACES = ["{0}{1}'", "{0}_{1}’", "d{0}_{1}/dt", "{0}\u0307_{1}", r"\dot{{{0}}}_{1}", r"\dot {0}_{{{1}}}"]
ENTRIES = """vB = np.array([-r1*w1*sin(phi1) - r2*w2*sin(phi2), r1*w1*cos(phi1) + r2*w2*cos(phi2)])
2*r3*w3*sin(phi3) = vB[0]
VMy - 2*r3*w3*cos(phi3) = vB[1]"""
CHAIN = "v_Bx = 2*r3*w3*sin(phi3) = -r1*w1*sin(phi1) - r2*w2*sin(phi2)\nv_Bx - r3*w3*cos(phi3) + 0.5*r3*w4 = 0"


@pytest.mark.parametrize("place", PLACES)
def test_the_derivative_of_a_place_is_the_velocity_of_the_point(place: str) -> None:
    text = DERIVED.format(**{axis + point: place.format(axis, point) for axis in "xy" for point in "BC"})
    assert marked(text).independent == 4


@pytest.mark.parametrize(("text", "sign"), [(CHAIN, "- r2"), (ENTRIES, "+ r2")])
def test_a_name_of_two_formulas_or_an_entry_stands_for_what_it_was_given(text: str, sign: str) -> None:
    other = sign.translate(str.maketrans("+-", "-+"))
    assert [marked(one).independent for one in (text, text.replace(sign, other))] == [2, 1]


def test_what_is_true_of_anything_costs_nothing() -> None:
    assert not marked(f"{PLAIN}\nw3 = VMy*w3/VMy").different


@pytest.mark.parametrize(
    ("way", "text", "read"),
    [
        (in_one_line, "      a*b\nw3 = -----\n       c", "\nw3 = ((a*b)/(c))\n"),
        (in_one_line, "      a     b\nw3 = --- + ---\n      c     d", "\nw3 = ((a)/(c)) + ((b)/(d))\n"),
        (in_one_line, "      a     b\nw3 = ---\n      c     d", "\nw3 = ((a     b)/(c     d))\n"),
        (in_one_line, "      a     b\nw3 = --- + ---\n      c", None),
        (in_one_line, "x = a\nw3 = -----\n       c", None),
        (in_one_line, "S.w2\n\nans =\n\n-a/b", "\n\n\n\nw2 = -a/b"),
        (in_one_line, "In [5]: sol[w3]\nOut[5]: a*b", "\nw3 = a*b"),
        (in_one_line, "pretty(w3)\n   a\n - ---\n   b", "\n\nw3 =  - ((a)/(b))\n"),
        (in_one_line, "disp(w3)\nx = 1", None),
        (with_a_name, "b = [c; d]\nx = linsolve(A, b); //", "bminus = [-(c); -(d)]\nx = linsolve(A, bminus); //"),
        (with_a_name, "b = [c; d]\nx = linsolve(A, b);  % A*x = b", None),
        (with_entries_apart, "om = [a*b, c]\\[d; e];\nw1 = om(1)", None),
        (with_entries_apart, "v = [a*b; c];\nw = A\\v; u = v(2);", "v = [a*b; c];\nw = A\\v; u = vy;\nvy = c"),
        (with_entries_apart, "v = [a*b; c];\nu = v(3);", None),
        (with_entries_apart, "A = [0, 0; 0, 0];\nA(1,1) = a;\nD = A(1,1)*A(2,2)", None),
        (without_constants, "y = a*sin(b) = const, so", "y = a*sin(b)"),
        (without_constants, "y = a*sin(b) = c, so", None),
    ],
)  # fmt: skip
def test_what_is_drawn_or_shown_stands_in_one_line(way: Callable[[str], str], text: str, read: str | None) -> None:
    assert way(text) == (text if read is None else read)


def test_a_stroke_is_the_derivative_that_the_text_says_it_is() -> None:
    lines = text_lines("With ' = d/dphi1:\nphi3' = r1*phi2'", names_for(expected()))
    assert [line for _, line in lines] == ["With :", "dphi3/dphi1 = r1*dphi2/dphi1"]


def test_letters_beside_a_word_or_a_name_are_no_factors() -> None:
    assert without_words("La componente è u = 2", {"u"}.__contains__) == "u = 2"
    assert real_and_imaginary("a e^{i phi1} = v + iV_y") == ["a (cos(phi1)) = v", "a (sin(phi1)) = 1 V_y"]


@pytest.mark.parametrize(("text", "relates"), [("w3 = -------", True), ("w3 = --", False)])
def test_a_quotient_that_cannot_be_put_together_is_asked_about(text: str, relates: bool) -> None:
    assert read_line(text, "", 1, names_for(expected())).relates is relates


def test_where_a_velocity_vanishes_its_round_off_is_measured_by_its_usual_size() -> None:
    probe = Probe({"a": np.array([0.0, 1.0]), "u": np.array([1e-17, 1.0])}, ("u",), np.array([[1e-17], [1.0]]))
    found = linear(Formula("-", parse_equation("u = a")), probe)
    assert found.residual == 1
    assert found.residual_of_scale < 1e-16


def test_the_code_of_a_notebook_gives_equations_where_nothing_else_does_and_never_a_table() -> None:
    cells = [{"cell_type": "code", "source": f"{PLAIN}\n0 1 2 3", "outputs": []}]
    document = document_of_notebook(json.dumps({"cells": cells, "nbformat": 4}), "utf-8")
    assert document.is_code
    assert len(document.lines) == 5
    assert tables_of_document(document, "", expected().grid) == ([], None)
    cells.append({"cell_type": "markdown", "source": "w3 = sin(phi3)", "outputs": []})
    assert not document_of_notebook(json.dumps({"cells": cells, "nbformat": 4}), "utf-8").is_code


@pytest.mark.parametrize("first", ["<p>$$w3 = VMy$$</p>", '<math display="block"><mi>a</mi><mo>=</mo><mi>b</mi></math>'])
def test_each_formula_of_a_page_is_a_line(first: str) -> None:
    page = f'<html><body>{first}<math display="block"><mi>w3</mi><mo>=</mo><mi>VMy</mi></math><pre>w2 = VMy</pre></body></html>'
    work = read_submission(Submission("s", None, (submitted_file("w.html", page.encode()),)), expected())
    assert [line.text for line in work.equations or ()][-2:] == ["w3 = VMy", "w2 = VMy"]
