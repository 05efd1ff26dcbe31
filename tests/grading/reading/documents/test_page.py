"""Tables and lines of a page of HTML and of a LaTeX file, with the places where they stand."""

from __future__ import annotations

import pytest

from coursework.grading.reading.documents.document import place_of
from coursework.grading.reading.documents.page import document_of_latex, document_of_page, with_formulas
from coursework.grading.reading.files.kinds import is_html
from coursework.grading.reading.limits import Room
from coursework.grading.reading.numbers import plain_text

ROWS = "w_1 & 5 \\\\\nw_2 & 7 \\\\\n"
LATEX = f"w_1 = V/r\n\\begin{{tabular}}{{lr}}\n{ROWS}\\end{{tabular}}\nw_2 = 2 w_1\n"


def cells(rows) -> list[list[str]]:
    return [[cell.text for cell in row] for row in rows]


@pytest.mark.parametrize(("before", "first"), [
    ("", 1), ("\n\n", 3), ("\\documentclass{article}\n\\newcommand{\\x}{x = 1}\n\\begin{document}\n", 4),
    ("\\documentclass{article}\\begin{document}", 1),
])  # fmt: skip
@pytest.mark.parametrize("end", ["", "\\end{document}\n"])
def test_a_latex_file_is_read_from_its_body_on_whether_it_has_a_preamble_or_not(before: str, first: int, end: str) -> None:
    document = document_of_latex(before + LATEX + end, "latex", Room(600, 40))
    assert [line.text for line in document.lines] == ["w_1 = V/r", "w_2 = 2 w_1"]
    assert [line.place for line in document.lines] == [place_of("line", line=first), place_of("line", line=first + 5)]
    (table,) = document.tables
    assert cells(table.rows) == [["w_1", "5"], ["w_2", "7"]]
    assert table.place == place_of("line", line=first + 1)


@pytest.mark.parametrize(("most_rows", "most_columns", "rows"), [
    (600, 40, [["t", "w", "w"], ["t", "1", "2"], ["0", "5", "7"]]), (2, 40, [["t", "w", "w"], ["t", "1", "2"]]),
    (600, 2, [["t", "w"], ["t", "1"], ["0", "5"]]),
])  # fmt: skip
def test_a_cell_of_a_page_stands_in_every_row_and_column_that_it_spans(
    most_rows: int, most_columns: int, rows: list[list[str]]
) -> None:
    page = (
        "<p>w1 = V/r</p><table><tr><td rowspan=2>t</td><td colspan=2>w</td></tr><tr><td>1</td><td>2</td></tr>"
        "<tr><td>0</td><td>5</td><td>7</td></tr></table><p>w2 = 2&middot;w1</p>"
    )
    document = document_of_page(page, "html", Room(most_rows, most_columns))
    (table,) = document.tables
    assert cells(table.rows) == rows
    assert [line.text.replace("·", "*") for line in document.lines] == ["w1 = V/r", "w2 = 2*w1"]


def test_a_number_with_its_power_of_ten_is_one_in_latex_too() -> None:
    (table,) = document_of_latex(
        r"\begin{tabular}{c}$5{,}25 \cdot 10^{-1}$ & $-1.5\times 10^{2}$\\\end{tabular}", "x", Room(9, 9)
    ).tables
    assert [plain_text(cell) for cell in cells(table.rows)[0]] == ["5,25e-1", "-1.5e2"]


@pytest.mark.parametrize(
    ("text", "is_page"),
    [('<meta charset="utf-8"><div>', True), ("<!-- saved --><table>", True), ("<3 w1", False),
     ('<?xml version="1.0"?><a>', False),
     ('\ufeff<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE html PUBLIC "-//W3C//DTD XHTML 1.1//EN" "x"><html>', True)],
)  # fmt: skip
def test_a_page_begins_with_any_of_its_signs(text: str, is_page: bool) -> None:
    assert is_html(text) == is_page


@pytest.mark.parametrize("row", ["<tr><td></td><td>2</td></tr>", "<tr><td><p></p></td><td><p>2</p></td></tr>"])
def test_a_row_that_begins_with_an_empty_cell_is_a_row_of_its_own(row: str) -> None:
    (table,) = document_of_page(f"<table><tr><td>a</td><td>b</td></tr>{row}{row}</table>", "html", Room(9, 9)).tables
    assert cells(table.rows) == [["a", "b"], ["", "2"], ["", "2"]]


def test_a_formula_that_a_script_draws_is_a_line() -> None:
    page = document_of_page(
        '<p>So</p><script type="math/tex; mode=display">w_1 = V/r</script><script>w2 = 1</script>', "x", Room(9, 9)
    )
    assert [line.text for line in page.lines if "=" in line.text] == ["w_1 = V/r"]


W3 = "<math><msub><mi>&omega;</mi><mn>3</mn></msub><mo>=</mo><mfrac><mi>a</mi><mn>2</mn></mfrac><mi>b</mi></math>"
KATEX = (
    '<span class="katex"><span class="katex-mathml"><math><semantics><mrow><mi>w</mi></mrow><annotation encoding="application/'
    'x-tex">w_3 = \\frac a2 &lt; b</annotation></semantics></math></span><span class="katex-html" aria-hidden="true"><span>w'
    "</span><span>3</span></span></span>"
)


@pytest.mark.parametrize(("page", "text"), [
    (f"<p>So {W3}</p>", "<p>So  ω_3 = ((a)/(2)) b </p>"),
    (f"{KATEX} then", '<span class="katex"><span class="katex-mathml"> w_3 = \\frac a2 &lt; b </span> then'),
    ("<m:math xmlns:m='x'><m:mi>a</m:mi><m:mo>&lt;</m:mo></m:math>", " a &lt; "),
    ("<math><mtable><mtr><mtd><mi>a</mi><mo>=</mo><mi>b</mi></mtd></mtr><mtr><mtd><mi>c</mi><mo>=</mo><mi>d</mi></mtd></mtr>"
     "</mtable></math>", " a = b<br>c = d "),
    *((page, page) for page in ("<math><mi>a</mi><mo>&amp;</mo>", "<math><mi>a</mb></math>", "<math>&nosuch;</math>", "<math")),
])  # fmt: skip
def test_the_formulas_of_a_page_are_text(page: str, text: str) -> None:
    assert with_formulas(page) == text
