"""Equations as exports, keyboards, solvers and calculators leave them are right, and one wrong sign costs its equation alone."""

from __future__ import annotations

import io
import re

import docx
import nbformat
import pytest

from coursework.grading.reading.limits import EQUATION_CHARACTERS
from tests.grading.reading.documents.test_right_work import graded
from tests.grading.reading.equations.notation.exported import FORMS, PROGRAMS, RECORDS, SLIDER
from tests.grading.reading.equations.notation.notations import PLAIN
from tests.grading.reading.equations.notation.test_notations import marked
from tests.sample import diagonal, first

TEXTS = {"31": PLAIN["31"], "v102": PLAIN["v102"], "offset": SLIDER}


def turned(text):
    """The text with one sign turned, each in turn."""
    for found in re.finditer(r"(?<= )[-+](?= )", text):
        yield text[: found.start()] + {"-": "+", "+": "-"}[found[0]] + text[found.end() :]


@pytest.mark.parametrize("name", TEXTS)
@pytest.mark.parametrize("form", FORMS)
def test_right_equations_are_right_in_each_form(form, name):
    found = marked(FORMS[form](TEXTS[name]), name)
    told = [(mark.verdict, mark.line.text, mark.line.repaired) for mark in found.marks if mark.verdict != "right"]
    assert (found.share, told) == (1.0, [])


@pytest.mark.parametrize(("form", "name"), diagonal(3, FORMS, TEXTS))
def test_a_turned_sign_costs_its_equation_and_no_other(form, name):
    needed = len(TEXTS[name].split("\n"))
    for wrong in [*turned(TEXTS[name])][len(form) % 3 :: 3]:
        found = marked(FORMS[form](wrong), name)
        assert (found.independent, len(found.wrong), found.needed) == (needed - 1, 1, needed), wrong


def word(text):
    document = docx.Document()
    for paragraph in text.split("\n"):
        document.add_paragraph(paragraph)
    file = io.BytesIO()
    document.save(file)
    return file.getvalue()


def notebook(text):
    book = nbformat.v4.new_notebook()
    book.cells = [nbformat.v4.new_markdown_cell(f"# Work\n\n```\n{text}\n```"), nbformat.v4.new_code_cell("x = 1")]
    return nbformat.writes(book).encode()


FILES = {"work.txt": str.encode, "work.docx": word, "work.ipynb": notebook, "work.md": lambda t: f"# Work\n\n$x$\n\n{t}".encode()}


@pytest.mark.parametrize(("program", "name"), diagonal(2, PROGRAMS, FILES))
def test_a_program_is_its_equations_in_every_kind_of_file(program, name):
    text = PROGRAMS[program]
    right = graded({name: FILES[name](text)})
    assert right.part("equations")[0] == 40.0, right.reason
    at = text.upper().rindex("COS") if "COS" in text.upper() else 0
    wrong = graded({name: FILES[name](text[:at] + ("Sin" if text[at] == "C" else "sin") + text[at + 3 :])})
    assert wrong.part("equations")[0] == 30.0, wrong.reason


@pytest.mark.parametrize("records", RECORDS)
def test_the_equations_of_records_are_read(records):
    assert graded({"equations.json": RECORDS[records](PLAIN["31"]).encode()}).part("equations")[0] == 40.0
    wrong = next(turned(PLAIN["31"]))
    assert graded({"equations.json": RECORDS[records](wrong).encode()}).part("equations")[0] == 30.0


@pytest.mark.parametrize("kind", first(1, ["work.docx", "work.md", "work.ipynb"]))
def test_the_signs_of_other_keyboards_are_read_in_documents(kind):
    assert graded({kind: FILES[kind](FORMS["wide signs"](PLAIN["31"]))}).part("equations")[0] == 40.0


def test_the_items_of_a_list_in_a_document_are_no_equations():
    items = "\n".join(("- r3*w3*cos(phi3) is the speed of B about C", "- r1*w1*sin(phi1) + r2*w2*sin(phi2)"))
    found = graded({"work.docx": word(f"{PLAIN['31']}\n{items}")})
    assert found.part("equations")[0] == 40.0 and len(found.equations.marks) == 4


QUOTIENTS = (
    "w3 = VMy / (r3*(2*cos(phi3) + sin(phi3))) = V1*sin(p*t + alpha) / (r3*(2*cos(phi3) + sin(phi3)))",
    "w4 / w3 = 2*r3*(cos(phi3) - 2*sin(phi3)) / r3 = 2*cos(phi3) - 4*sin(phi3)",
    "w4 = w3 • 2*(cos(phi3) - 2*sin(phi3)) = 2*w3*cos(phi3) - 4*w3*sin(phi3)",
    "D = r3*(2*cos(phi3) + sin(phi3))\nw3 = VMy / D = V1*sin(p*t + alpha) / D",
)


@pytest.mark.parametrize("text", QUOTIENTS)
def test_a_quotient_or_product_in_a_chain_stays_one(text):
    found = marked(text)
    assert (found.independent, len(found.wrong)) == (1, 0), [(mark.verdict, mark.line.text) for mark in found.marks]


def test_a_link_may_be_named_by_its_points():
    text = re.sub(r"\bw([123])\b", lambda found: "ω_" + {"1": "DA", "2": "BA", "3": "BM"}[found[1]], PLAIN["v102"])
    assert marked(text, "v102").share == 1.0
    assert len(marked(text.replace("VMx + a", "VMx - a", 1), "v102").wrong) == 1


def test_the_lines_of_a_page_as_typed_stay_lines():
    grade = graded({"work.html": f"<html><body><pre>\n{PLAIN['v102']}\n</pre></body></html>".encode()}, "v102")
    assert grade.part("equations")[0] == 40.0


def test_formulas_with_a_sign_between_them_are_one():
    text = "\n".join(f"${line}$".replace(" - ", "$ -- $") for line in PLAIN["31"].replace("*", " ").split("\n"))
    for name in ("work.txt", "work.md"):
        assert graded({name: text.encode()}).part("equations")[0] == 40.0


def test_what_only_looks_like_an_end_of_line_is_none():
    """A Greek letter of LaTeX begins with an n, and what a program prints ends with one."""
    assert marked(r"\nu = 2" + "\n" + PLAIN["31"]).share == 1.0
    assert marked(PLAIN["31"] + '\nprintf("w1 = %f, w2 = %f\\n", w1, w2);').share == 1.0
    assert marked(r"V_{My} \neq 0" + "\n" + PLAIN["31"]).share == 1.0
    half = PLAIN["31"].replace("0.5*r3", r"\nicefrac{1}{2} r_3").replace("phi", r"\varphi_").replace("*", " ")
    assert marked(half.replace("VMy", "V_{My}")).share == 1.0
    assert marked(PLAIN["31"].replace("0.5*r3", r"\nicefrac{1}{2} r3")).share == 1.0


def test_what_is_proportional_in_julias_sign_is_no_equation():
    assert [mark.line.line for mark in marked("w3 ~ VMy\n" + PLAIN["31"]).marks] == [2, 3, 4, 5]


@pytest.mark.parametrize(("filled", "read"), [(EQUATION_CHARACTERS, True), (EQUATION_CHARACTERS + 1, False)])
def test_how_long_a_formula_may_be_typed(filled, read):
    line = r"V_{My} - 2 r_3 \omega_3 \cos\varphi_3 - r_3 \omega_3 \sin\varphi_3 = 0"
    blanks, rest = divmod(filled - len(line), 2)
    typed = line.replace(" = 0", "\\!" * blanks + " " * rest + " = 0")
    assert len(typed) == filled
    assert [mark.verdict for mark in marked(typed).marks] == (["right"] if read else ["unreadable"])


@pytest.mark.parametrize("word_", ["Vzb", "Speed"])
def test_a_word_before_a_minus_may_be_a_name_and_is_not_left_out_in_silence(word_):
    rest = "\n".join(PLAIN["31"].split("\n")[1:])
    found = marked(f"{word_} - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0\n{rest}")
    assert not found.wrong and found.unread is not None
    assert marked(f"Point C - VMy + 2*r3*w3*cos(phi3) + r3*w3*sin(phi3) = 0\n{rest}").share == 1.0


def test_the_cells_of_a_row_are_no_product():
    head = "\t".join(("w1", "w2", "w3", "=", "1", "r1*sin(phi1)", "r2*sin(phi2)", "r3*cos(phi3)", "0"))
    found = marked(head)
    assert [mark.verdict for mark in found.marks] == ["unreadable"] and found.unread is not None


REST = "w3 = VMy/(r3*(2*cos(phi3) + sin(phi3)))\nw4 = 2*w3*(cos(phi3) - 2*sin(phi3))\n"
CELLS = (("r1*sin(phi1)", "r2*sin(phi2)"), ("r1*cos(phi1)", "r2*cos(phi2)"))
SIDES = ("0.5*r3*w4 - r3*w3*cos(phi3)", "r3*w3*sin(phi3)")
(A, B), (C, D) = CELLS
E_, F = SIDES
SYSTEMS = {
    "Mathematica": f"A = {{{{{A}, {B}}}, {{{C}, {D}}}}};\nb = {{{E_}, {F}}};\n{{w1, w2}} = LinearSolve[A, b]",
    "Maple": f"A := Matrix([[{A}, {B}], [{C}, {D}]]);\nb := Vector([{E_}, {F}]);\nX := LinearAlgebra:-LinearSolve(A, b);\n"
    "w1 := X[1];\nw2 := X[2];",
    "Maxima": f"A: matrix([{A}, {B}], [{C}, {D}])$\nb: matrix([{E_}], [{F}])$\nx: invert(A) . b;\nw1: x[1,1];\nw2: x[2,1];",
    "SymPy": f"A = sp.Matrix([[{A}, {B}], [{C}, {D}]])\nb = sp.Matrix([{E_}, {F}])\nw = A.LUsolve(b)\nw1 = w[0]\nw2 = w[1]",
    "GeoGebra": f"A = {{{{{A}, {B}}}, {{{C}, {D}}}}}\nb = {{{{{E_}}}, {{{F}}}}}\nX = A^-1*b\n"
    "w1 = Element(X, 1, 1)\nw2 = Element(X, 2, 1)",
    "determinants": f"D = det([{A}, {B}; {C}, {D}]);\nw1 = det([{E_}, {B}; {F}, {D}])/D;\nw2 = det([{A}, {E_}; {C}, {F}])/D;",
    "of NumPy": f"d = np.linalg.det(np.array([[{A}, {B}], [{C}, {D}]]))\nw1 = np.linalg.det([[{E_}, {B}], [{F}, {D}]])/d\n"
    f"w2 = np.linalg.det([[{A}, {E_}], [{C}, {F}]])/d",
    "of LaTeX": f"\\[w1 = \\frac{{\\begin{{vmatrix}} {E_} & {B} \\\\ {F} & {D} \\end{{vmatrix}}}}"
    f"{{\\begin{{vmatrix}} {A} & {B} \\\\ {C} & {D} \\end{{vmatrix}}}}\\]\n"
    f"\\[w2 = \\left|\\begin{{array}}{{cc}} {A} & {E_} \\\\ {C} & {F} \\end{{array}}\\right|"
    f"/\\begin{{vmatrix}} {A} & {B} \\\\ {C} & {D} \\end{{vmatrix}}\\]",
}  # fmt: skip


@pytest.mark.parametrize("system", SYSTEMS)
def test_a_system_as_matrices_or_determinants_is_its_equations(system):
    found = marked(REST + SYSTEMS[system])
    assert (found.share, len(found.wrong)) == (1.0, 0), [(mark.verdict, mark.line.text) for mark in found.marks]
    assert marked(REST + SYSTEMS[system].replace("0.5*r3*w4 -", "0.5*r3*w4 +")).share < 1.0


def test_a_determinant_of_three_rows_has_its_signs():
    rows = "0, r3, 0; r3, 0, 0; 0, 0, w4"
    assert (
        marked(f"-r3*r3*w4 = 4*r3*r3*w3*sin(phi3) - 2*r3*r3*w3*cos(phi3)\ndet([{rows}]) = -r3*r3*w4").marks[0].verdict == "right"
    )
    assert marked(f"det([{rows}]) = 4*r3*r3*w3*sin(phi3) - 2*r3*r3*w3*cos(phi3)").share == 0.25
