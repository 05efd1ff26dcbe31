"""Markdown -> its tables of pipes or HTML, formulas and lines of text.

Enters: text.  Leaves: `Document`; `is_markdown` tells whether a text has a table of either kind or `$…$`.
Used by `read_document.py` and, for the cells of a notebook, by `notebook.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from coursework.grading.reading.documents.document import MOST_CELLS, Document, place_of
from coursework.grading.reading.documents.office.builder import add_lines
from coursework.grading.reading.documents.page import add_table, has_tables, pieces_of
from coursework.grading.reading.equations.notation.latex import ENVIRONMENT, LINE_END, matrices_in_one_piece, with_formulas_joined
from coursework.grading.reading.equations.notation.latex_names import with_own_commands
from coursework.grading.reading.equations.notation.signs import relates_two_sides
from coursework.grading.reading.equations.systems.parts import legend_of_cells
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.limits import CELL_CHARACTERS, LINE_CHARACTERS, Room
from coursework.words.sentence import Sentence

_RULE = re.compile(r"\|?:?-+:?(?:\|:?-+:?)*\|?")  # matched against a line without blanks
_DISPLAYED, _INLINE = re.compile(r"\$\$([^$]{1,4000})\$\$"), re.compile(r"(?<![\\$])\$([^$\n]{1,2000})\$")
_MARKUP = re.compile(r"^[ \t]*(?:(?:#{1,6}[ \t]+|>[ \t]?|[*+][ \t]+(?=\S))+)?(?:\*\*)?|\*\*[ \t]*$|`{1,3}\w{0,20}$|`")
# A dash before a formula is the mark of a list, and so is that of the other items; before a formula's text it may be a minus.
_ITEM, _LIST_OF_FORMULAS = re.compile(r"^([ \t]*)-[ \t]+", re.MULTILINE), re.compile(r"^[ \t]*-[ \t]+\$", re.MULTILINE)
_IN_TEX = re.compile(r"\\[(\[]([^$=]{1,300}=[^$]{1,600}?)\\[)\]]")  # \(a = b\)
_ESCAPED = re.compile(r"\\(?=[*_#|<>\[\]()+-])")
_CELL = re.compile(r"(?<!\\)\|")
_MOST_COLUMNS = 1000
_ROOM = Room(MOST_CELLS, _MOST_COLUMNS)  # of a table; the document limits its cells


def is_markdown(text: str) -> bool:
    """Return whether a text has a pipe table, a table of HTML or a formula between dollar signs."""
    has_formula = "$" in text and bool(_DISPLAYED.search(text) or _INLINE.search(text))
    return has_formula or has_tables(text) or ("|" in text and any("|" in line and _is_rule(line) for line in text.split("\n")))


def _is_rule(line: str) -> bool:
    """Return whether a line is the rule between the heads and the rows of a pipe table."""
    return "-" in line and len(line) <= LINE_CHARACTERS and bool(_RULE.fullmatch("".join(line.split())))


def document_of_markdown(text: str, kind: str) -> Document:
    """Return the tables, formulas and lines of a Markdown file; `kind` names its encoding."""
    document = Document(kind, is_whole=False)
    add_markdown(document, with_own_commands(text), lambda line: place_of("line", line=line))
    return document


def add_markdown(document: Document, text: str, place: Callable[[int], Sentence]) -> None:
    """Add the tables and lines of a Markdown text; `place` gives the description of a line by its number (from 1)."""
    for piece, is_table, before in pieces_of(text):
        if is_table:
            add_table(document, piece, _ROOM)
        else:
            _add_pipes(document, piece, lambda line, before=before: place(before + line))  # type: ignore[misc]


def _add_pipes(document: Document, text: str, place: Callable[[int], Sentence]) -> None:
    """Add the pipe tables and the lines of a text."""
    lines = [line[:LINE_CHARACTERS] for line in text.split("\n")]
    at = 0
    kept: list[str] = []
    while at < len(lines):
        if at + 1 < len(lines) and "|" in lines[at] and _is_rule(lines[at + 1]):
            end = at + 2
            while end < len(lines) and "|" in lines[end]:
                end += 1
            document.add_table(map(_cells, [lines[at], *lines[at + 2 : end]]), place(at + 1))
            kept += [
                line if relates_two_sides(line) else legend_of_cells([cell.text for cell in _cells(line)]) if row > 1 else ""
                for row, line in enumerate(lines[at:end])
            ]
            at = end
        else:
            kept.append(lines[at])
            at += 1
    _add_text(document, "\n".join(kept), place)


def _cells(line: str) -> list[Cell]:
    texts = _CELL.split(line.strip().removeprefix("|").removesuffix("|"), maxsplit=_MOST_COLUMNS)
    return [Cell(text.strip().strip("*`$").replace("\\|", "|")[:CELL_CHARACTERS]) for text in texts]


def _add_text(document: Document, text: str, place: Callable[[int], Sentence]) -> None:
    """Add the displayed formulas, which may extend over several lines, and the lines between them."""
    end, number = 0, 1
    for found in _DISPLAYED.finditer(text):
        _add_plain(document, text[end : found.start()], number, place)
        number += text.count("\n", end, found.start())
        add_lines(document, [(_rows(found[1]), True)], place(number))
        number += text.count("\n", found.start(), found.end())
        end = found.end()
    _add_plain(document, text[end:], number, place)


def _add_plain(document: Document, text: str, first: int, place: Callable[[int], Sentence]) -> None:
    if _LIST_OF_FORMULAS.search(text):
        text = _ITEM.sub(r"\1", text)
    is_code = False
    for number, line in enumerate(text.split("\n"), start=first):
        is_code ^= line.lstrip().startswith("```")
        if is_code or not ("\\" in line or "$" in line or relates_two_sides(line)):
            document.add_line(line, place(number))
            continue
        bare = with_formulas_joined(_IN_TEX.sub(r"$\1$", _MARKUP.sub("", line)))
        pieces: list[tuple[str, bool]] = []
        end = 0
        for found in _INLINE.finditer(bare):
            pieces += [(bare[end : found.start()], False), (_rows(found[1]), True)]
            end = found.end()
        pieces.append((bare[end:], False))
        add_lines(
            document, [(text if is_formula else _ESCAPED.sub("", text), is_formula) for text, is_formula in pieces], place(number)
        )


def _rows(formula: str) -> str:
    r"""Return a formula without its environment, with one line per row: only \\ ends a row, a line break does not."""
    formula = matrices_in_one_piece(formula)
    return LINE_END.sub("\n", ENVIRONMENT.sub(" ", formula.replace("\n", " "))).replace("&", " ")
