"""The same work as the programs of others write it: Word, OpenDocument, notebooks, Markdown, JSON, RTF, PDF.

Every function takes the heads, the rows as texts and the equations in LaTeX, and returns a file's bytes.
"""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import docx
import nbformat
import pandas as pd
import pypandoc
import typst
from docx.shared import Pt

Rows = Sequence[Sequence[str]]
Maker = Callable[[Sequence[str], Rows, Sequence[str]], bytes]


def markdown_table(heads: Sequence[str], rows: Rows) -> str:
    return "\n".join(["| " + " | ".join(row) + " |" for row in (heads, ["---"] * len(heads), *rows)])


def markdown(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    lines = [
        "# Курсова робота", "", "Дано: $r_1 = 0.953$ м, крок $h = 0.02$ с, отже t = 0.02 · k.", "",
        *(f"- для точки {k}: $$ {text} $$" if k % 2 else f"{k}) маємо ${text}$ ({k + 10})" for k, text in enumerate(equations)),
        "", markdown_table(heads, rows), "", "Висновок: рух можливий.",
    ]  # fmt: skip
    return "\n".join(lines).encode()


@cache
def _by_pandoc(text: str, kind: str) -> bytes:
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"out.{kind}"
        pypandoc.convert_text(text, kind, format="markdown", outputfile=str(path), extra_args=["--standalone"])
        return path.read_bytes()


def pandoc(kind: str) -> Maker:
    """Return what pandoc makes of a report: Word's own equations, MathML in OpenDocument, plain letters in RTF."""

    def made(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
        body = "\n\n".join(f"$${text}$$" for text in equations)
        return _by_pandoc(f"# Work\n\nHere *h* = 0.02 s.\n\n{body}\n\n{markdown_table(heads, rows)}\n\nThe end.\n", kind)

    return made


def word_merged(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    """Word: a title row over all columns, heads merged over two rows, subscripts as letters set lower, equations as text."""
    document = docx.Document()
    document.add_heading("Report", 1)
    document.add_paragraph("Step h = 0.02 s, r1 = 0.953 m.")
    for text in equations:
        document.add_paragraph(text)
    table = document.add_table(rows=3 + len(rows), cols=len(heads))
    table.cell(0, 0).merge(table.cell(0, len(heads) - 1)).text = "Table 1. Results"
    for place, head in enumerate(heads):
        cell = table.cell(1, place).merge(table.cell(2, place)) if place % 2 else table.cell(2, place)
        run = cell.paragraphs[0]
        stem = head.rstrip("0123456789")
        run.add_run(stem)
        below = run.add_run(head[len(stem) :])
        below.font.subscript, below.font.size = True, Pt(8)
    for row, texts in zip(table.rows[3:], rows, strict=True):
        for cell, text in zip(row.cells, texts, strict=True):
            cell.text = text
    return _saved(document)


def word_two_pages(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    """Word: the table broken by hand in two with the same heads, equations one in a cell with its number beside it."""
    document = docx.Document()
    numbered = document.add_table(rows=0, cols=2)
    for number, text in enumerate(equations, start=1):
        cells = numbered.add_row().cells
        cells[0].text, cells[1].text = text, f"({number})"
    middle = len(rows) // 2
    _add_tables(document, [heads, *rows[:middle]], [heads, *rows[middle:]])
    return _saved(document)


def word_tables(*tables: Rows) -> bytes:
    """Word: several tables, each with its heads."""
    document = docx.Document()
    _add_tables(document, *tables)
    return _saved(document)


def _add_tables(document: docx.document.Document, *tables: Rows) -> None:
    for rows in tables:
        document.add_paragraph("Continued")
        table = document.add_table(rows=0, cols=len(rows[0]))
        for texts in rows:
            for cell, text in zip(table.add_row().cells, texts, strict=True):
                cell.text = text


def _saved(document: docx.document.Document) -> bytes:
    file = io.BytesIO()
    document.save(file)
    return file.getvalue()


def frame(heads: Sequence[str], rows: Rows) -> pd.DataFrame:
    return pd.DataFrame([[float(text.replace(",", ".")) for text in row] for row in rows], columns=list(heads))


def notebook(show: Callable[[pd.DataFrame], list[nbformat.NotebookNode]]) -> Maker:
    def made(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
        table = frame(heads, rows)
        book = nbformat.v4.new_notebook()
        code = nbformat.v4.new_code_cell("w1 = 99.0\ntable = [[0, 1, 2, 3], [1, 2, 3, 4], [2, 3, 4, 5]]\nr3*w3 = 0")
        code.outputs = [nbformat.v4.new_output("stream", name="stdout", text=str(table.head(3) * 2))]
        text = "## Equations\n\n" + "\n\n".join(f"$$\\begin{{align}} {text} \\end{{align}}$$" for text in equations)
        last = nbformat.v4.new_code_cell("table")
        last.outputs = show(table)
        book.cells = [nbformat.v4.new_markdown_cell(text), code, last]
        return nbformat.writes(book).encode()

    return made


def page_output(table: pd.DataFrame) -> list[nbformat.NotebookNode]:
    data = {"text/html": table.to_html(), "text/plain": str(table)}
    return [nbformat.v4.new_output("execute_result", data=data)]


def indexed_output(table: pd.DataFrame) -> list[nbformat.NotebookNode]:
    """The time as the index of the frame: its name stands in a row of its own."""
    return page_output(table.set_index(table.columns[0]))


def printed_output(table: pd.DataFrame) -> list[nbformat.NotebookNode]:
    return [nbformat.v4.new_output("stream", name="stdout", text=table.to_string() + "\n")]


def wrapped_output(table: pd.DataFrame) -> list[nbformat.NotebookNode]:
    """Printed in pieces, since the columns do not fit on a line."""
    return [nbformat.v4.new_output("stream", name="stdout", text=table.to_string(line_width=60) + "\n")]


def json_of(orient: str) -> Maker:
    def made(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
        table = json.loads(frame(heads, rows).to_json(orient=orient, double_precision=15))  # type: ignore[call-overload]
        return json.dumps({"results": table, "equations": list(equations)}).encode()

    return made


def json_rows(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    return json.dumps([list(heads), *([float(text.replace(",", ".")) for text in row] for row in rows)]).encode()


def json_texts(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    """Columns by name whose numbers are texts with a decimal comma."""
    columns = {head: [row[place].replace(".", ",") for row in rows] for place, head in enumerate(heads)}
    return json.dumps(columns | {"equations": list(equations)}, ensure_ascii=False).encode()


def typst_pdf(stroke: str, height: str = "29.7cm") -> Maker:
    """Return what Typst prints; a low page breaks the table, with its heads again or without them."""

    def made(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
        cells = ",".join(f"[{text}]" for row in rows for text in row)
        repeat = str(stroke != "none").lower()
        head = ",".join(f"[{text}]" for text in heads)
        source = "\n".join(
            [
                f"#set page(width: 21cm, height: {height})", "= Report", "Step $h = 0.02$ s.",
                *(f"$ {_typst(text)} $" if "=" in text else text for text in equations),
                f"#table(columns: {len(heads)}, stroke: {stroke}, table.header(repeat: {repeat}, {head}), {cells})",
                "The end.",
            ]
        )  # fmt: skip
        return typst.compile(source.encode())

    return made


def _typst(latex: str) -> str:
    """Return simple LaTeX as Typst writes it."""
    for before, after in (
        ("\\frac{1}{2}", "1/2"),
        ("\\", " "),
        ("{", "("),
        ("}", ")"),
        ("varphi", "phi"),
        ("_(Mx)", '_"Mx"'),
        ("_(My)", '_"My"'),
    ):
        latex = latex.replace(before, after)
    return latex


def page(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    """A page with its table inside another, its formulas drawn with a label for who cannot see them."""
    cells = "".join(f"<tr>{''.join(f'<td><p>{text}</p></td>' for text in row)}</tr>\n" for row in (heads, *rows))
    drawn = "".join(f'<div class="f" role="math" aria-label="{text}"><svg><path d="M0 0"/></svg></div>' for text in equations)
    return f"<!doctype html><h1>Курсова: t = 0.02 k</h1>{drawn}<table><tr><td>1<table>{cells}</table></td></tr></table>".encode()


def latex(heads: Sequence[str], rows: Rows, equations: Sequence[str]) -> bytes:
    """A file of LaTeX with more signs of equality before its equations than are read."""
    told = "\n".join(f"Тут $x_{{{k}}} = {k}$ і $V_{{{k}}} = 0$." for k in range(60))
    shown = "\n".join(f"\\begin{{equation}}\\label{{e{k}}}\n{text}\n\\end{{equation}}" for k, text in enumerate(equations))
    lines = " \\\\ \\hline\n".join(" & ".join(row) for row in (heads, *rows))
    types = "@{}" + "|c" * len(heads) + "|p{2cm}@{}"
    table = f"\\begin{{longtable}}[h]{{{types}}}\n\\toprule\n{lines} \\\\\n\\end{{longtable}}"
    begin, end = "\\documentclass{article}\n\\def\\x{w_1 = 2}\n\\begin{document}", "\\end{document}"
    return "\n".join([begin, told, shown, table, end]).encode()


MAKERS: dict[str, tuple[str, Maker]] = {
    "markdown": ("report.md", markdown),
    "word by pandoc": ("report.docx", pandoc("docx")),
    "word, merged": ("report.docx", word_merged),
    "word, two pages": ("report.docx", word_two_pages),
    "opendocument": ("report.odt", pandoc("odt")),
    "rtf": ("report.rtf", pandoc("rtf")),
    "notebook, page": ("work.ipynb", notebook(page_output)),
    "notebook, index": ("work.ipynb", notebook(indexed_output)),
    "notebook, printed": ("work.ipynb", notebook(printed_output)),
    "notebook, wrapped": ("work.ipynb", notebook(wrapped_output)),
    "notebook of markdown": ("work.ipynb", pandoc("ipynb")),
    **{f"json, {orient}": ("data.json", json_of(orient)) for orient in ("columns", "records", "index", "split")},
    "json, texts": ("data.json", json_texts),
    "page": ("report.html", page),
    "latex": ("report.tex", latex),
    "pdf, ruled": ("report.pdf", typst_pdf("0.5pt")),
    "pdf, bare": ("report.pdf", typst_pdf("none")),
    "pdf, low pages": ("report.pdf", typst_pdf("0.5pt", "9cm")),
    "pdf, low bare pages": ("report.pdf", typst_pdf("none", "9cm")),
}
