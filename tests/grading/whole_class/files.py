"""The files that a table and equations are handed in as: what every program writes, documents, pages, scripts, archives.

Enters: heads, rows as texts, the equations in a notation and in LaTeX.  Leaves: files by name.
"""

from __future__ import annotations

import html
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tests.grading.reading.documents.papers import MAKERS, Rows
from tests.grading.reading.table.dialects import DIALECTS, archive

# Notations with signs of their own for the end of a line or a cell stand in plain files only.
WITH_LATEX = ("by pandoc", "opendocument", "rtf", "markdown", "pdf", "notebook")


@dataclass(frozen=True)
class Work:
    """What is written down: names of columns with their rows, equations line by line in a notation and in LaTeX."""

    names: Sequence[str]
    rows: Rows
    equations: str
    latex: Sequence[str]

    @property
    def heads(self) -> list[str]:
        return ["t", *self.names]


Maker = Callable[[Work], dict[str, bytes]]


def _dialect(name: str, ending: str) -> Maker:
    def made(work: Work) -> dict[str, bytes]:
        table = DIALECTS[name](work.names, [list(row) for row in work.rows], "rad")
        return {f"table.{ending}": table, "equations.txt": work.equations.encode()}

    return made


def _document(name: str) -> Maker:
    file, maker = MAKERS[name]
    with_latex = any(part in name for part in WITH_LATEX)

    def made(work: Work) -> dict[str, bytes]:
        return {file: maker(work.heads, work.rows, work.latex if with_latex else work.equations.split("\n"))}

    return made


def _page(work: Work) -> dict[str, bytes]:
    """What Moodle keeps of a text typed online: paragraphs, a table, indices set lower."""
    lines = "".join(f"<p>{html.escape(line)}</p>" for line in work.equations.split("\n"))
    rows = "".join("<tr>" + "".join(f"<td><p>{text}</p></td>" for text in row) + "</tr>" for row in [work.heads, *work.rows])
    return {"onlinetext.html": f"<p>My work</p>{lines}<table><tbody>{rows}</tbody></table><p>The end</p>".encode()}


def _zip(work: Work) -> dict[str, bytes]:
    return {"work.zip": archive({f"work/{name}": content for name, content in _dialect("excel_ru", "csv")(work).items()})}


def _script(work: Work) -> dict[str, bytes]:
    """A program beside what it printed."""
    lines = "\n".join(f"% row {k}\n{line};" for k, line in enumerate(work.equations.split("\n"), 1))
    return {"solve.m": f"clear; clc\nh = 0.02;\n{lines}\n".encode(), "output.dat": _printed(work)}


def _printed(work: Work) -> bytes:
    return "\n".join("  ".join(f"{text:>11}" for text in row) for row in [work.heads, *work.rows]).encode()


def _one_file(work: Work) -> dict[str, bytes]:
    """Equations above the table, in one text."""
    return {"work.txt": work.equations.encode() + b"\n\n" + _printed(work)}


_ENDINGS = {"xlsx_numbers": "xlsx", "xlsx_texts": "xlsx", "ods_numbers": "ods", "mathcad_prn": "prn", "own_program": "txt",
            "tab_separated": "tsv", "unicode_text": "txt", "maple_list": "txt", "blanks_and_commas": "dat"}  # fmt: skip
KINDS: dict[str, Maker] = {
    **{name: _dialect(name, _ENDINGS.get(name, "csv")) for name in DIALECTS},
    **{name: _document(name) for name in MAKERS},
    "page": _page, "zip": _zip, "script": _script, "one file": _one_file,
}  # fmt: skip
# Where the equations stand in a notation of their own and are read line by line.
FREE = tuple(kind for kind in KINDS if kind not in MAKERS and kind not in ("page", "script", "one file"))
CHEAP = tuple(kind for kind in KINDS if not any(part in kind for part in ("pdf", "pandoc", "opendocument", "rtf", "of markdown")))
