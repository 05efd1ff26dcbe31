"""Turns the parts of a page into parts of a note.

Enters: parts of a `ReportModel`.  Leaves: blocks of pandoc's tree.  Used by `sections.py`.
Every number stands as on the page.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import singledispatchmethod

from coursework.report.text import parts
from coursework.takeaway.figures.drawings import Picture
from coursework.takeaway.note import tree
from coursework.takeaway.note.dialects import Dialect
from coursework.takeaway.note.formulas import WIDE, letters_wide
from coursework.takeaway.note.styles import MANY, REACH
from coursework.takeaway.note.tree import Node
from coursework.words.scripts import wide_letters

BLANK = "_" * 24  # a line to write on
LEGEND = (10.0, 3.0)  # mm
GAP = 1.0  # mm beside a graph: programs break a line that graphs fill completely
_NAMED = re.compile(r"\(([^()\s]{1,12})\)")
_NUMBER = re.compile(r"\d+")


@dataclass
class Blocks:
    """Makes blocks of parts; it has the format, LaTeX of the formulas, names of the pictures, and the text width (mm)."""

    dialect: Dialect
    latex: dict[str, str]
    place_of: Callable[[str], str]
    width: float
    named: set[str] = field(default_factory=set)  # numbers of the formulas of the page
    marks: dict[str, str] = field(default_factory=dict)  # marks of formulas by number, and of parts by label
    led: set[str] = field(default_factory=set)  # marks of drawings and tables already referred to in the text

    # sentences

    def inlines(self, runs: parts.Runs) -> list[Node]:
        """Return runs of text as inline nodes; the number of a formula becomes a reference to it."""
        return [node for run in runs for node in self._run(run)]

    def cell(self, content: parts.Cell) -> list[Node]:
        """Return the content of a cell."""
        return tree.text(content) if isinstance(content, str) else self.inlines(content)

    def _run(self, run: dict[str, str]) -> list[Node]:
        if "v" in run:
            return self.dialect.letter(run["v"], run["s"])
        if "p" in run:
            return [tree.raised(run["p"])]
        said = run.get("t") or run.get("c") or run.get("o") or ""
        return list(self._linked(said))

    def _linked(self, said: str) -> Iterator[Node]:
        end = 0
        for found in _NAMED.finditer(said):
            if found[1] not in self.named:
                continue
            yield from tree.text(said[end : found.start()])
            yield self.dialect.reference(self.mark_of(found[1]), found[0])
            end = found.end()
        yield from tree.text(said[end:])

    def mark_of(self, name: str) -> str:
        """Return the mark of the formula with a number."""
        return f"eq_{sorted(self.named).index(name) + 1}"

    def numbered(self, part: parts.Part) -> tuple[str, str]:
        """Return the mark of a drawing or a table, and its number."""
        assert isinstance(part, (parts.Figure, parts.Panels, parts.Table))
        number = _NUMBER.findall(part.label)[0]
        return f"{kind_of(part)}_{number}", number

    # parts

    @singledispatchmethod
    def of(self, part: parts.Part) -> list[Node]:
        """Return the blocks of a part."""
        raise TypeError(type(part).__name__)

    @of.register
    def _(self, part: parts.Paragraph) -> list[Node]:
        lead = [tree.strong(tree.text(part.lead)), {"t": "Space"}] if part.lead else []
        block = tree.paragraph([*lead, *self.inlines(part.text)])
        return [tree.styled("Remark", [block])] if part.style == "note" else [block]

    @of.register
    def _(self, part: parts.Code) -> list[Node]:
        return [tree.code(part.text)]

    @of.register
    def _(self, part: parts.Bullets) -> list[Node]:
        return [tree.bullets([self.inlines(item) for item in part.items])]

    @of.register
    def _(self, part: parts.Facts) -> list[Node]:
        return [tree.paragraph([tree.strong(tree.text(f"{word}: ")), *self.inlines(said)]) for word, said in part.items]

    @of.register
    def _(self, part: parts.TitleBlock) -> list[Node]:
        rows = [tree.paragraph([*tree.text(f"{word}: "), *(self.inlines(said) or tree.text(BLANK))]) for word, said in part.items]
        return [tree.styled("Author", rows)]

    @of.register
    def _(self, part: parts.Result) -> list[Node]:
        head = tree.paragraph([tree.strong([*tree.text(f"{part.title}: "), *self.inlines(part.lead)])])
        return [head, *(tree.paragraph(self.inlines(item)) for item in part.items)]

    @of.register
    def _(self, part: parts.Claims) -> list[Node]:
        rows = [
            [tree.text(f"{mark} {verdict}"), self.inlines(claim), self.cell(number), self.cell(limit)]
            for mark, verdict, claim, number, limit in part.items
        ]
        return self._judged(part.title, part.heads, rows)

    @of.register
    def _(self, part: parts.Checks) -> list[Node]:
        rows = []
        for item in part.items:
            said = [tree.strong(self.inlines(item.title)), *tree.text(f" {item.code}"), BREAK, *self.inlines(item.sentence)]
            for line in ([item.heads] if item.heads else []) + list(item.lines):
                said += [BREAK, *(node for cell in line for node in (*self.cell(cell), *tree.text("  ")))]
            value = [*self.cell(item.value), *(tree.text(f" {item.unit}") if item.unit else [])]
            rows.append([tree.text(f"{item.mark} {item.verdict}"), said, value, self.cell(item.limit)])
        return self._judged(part.title, part.heads, rows)

    def _judged(self, title: str, heads: Sequence[str], rows: list[list[list[Node]]]) -> list[Node]:
        made = tree.table([tree.text(head) for head in heads], rows, [True, True, False, False], WIDTHS)
        return [tree.styled("Table Title", [tree.paragraph([tree.strong(tree.text(title))])]), made]

    @of.register
    def _(self, part: parts.Equations) -> list[Node]:
        return [block for item in part.items for block in self._display(item)]

    def _display(self, item: parts.Display) -> Iterator[Node]:
        if item.before:
            yield tree.styled("Lead", [tree.paragraph(self.inlines(item.before))])  # on the page of what it leads to
        latex = self.latex[item.math]
        if item.name:
            first = item.name in self.named and item.name not in self.marks
            mark = self.marks.setdefault(item.name, self.mark_of(item.name)) if first else ""
            yield self.dialect.numbered(latex, item.name, mark)
        else:
            style = "Equation Small" if letters_wide(latex) > WIDE else "Equation"
            yield tree.styled(style, [tree.paragraph([tree.math(latex, displayed=True)])])
        if item.after:
            yield tree.paragraph(self.inlines(item.after))

    @of.register
    def _(self, part: parts.Table) -> list[Node]:
        heads = [[*self.inlines(one.head), *(tree.text(f" {one.unit}") if one.unit else [])] for one in part.columns]
        rows = [
            [[tree.strong(self.cell(cell))] if number in part.strong else self.cell(cell) for cell in row]
            for number, row in enumerate(part.rows)
        ]
        blocks = self._caption("table", part.label, part.caption)
        widths = _widths(part, self.width) if self.dialect.needs_widths else ()
        blocks.append(tree.table(heads, rows, [one.words for one in part.columns], widths))
        return [*blocks, *([tree.styled("Remark", [tree.paragraph(self.inlines(part.note))])] if part.note else [])]

    @of.register
    def _(self, part: parts.Figure) -> list[Node]:
        fits = 1.0 if part.exact else min(1.0, self.width / part.width)  # a picture true to scale is turned instead of shrunk
        picture = self.dialect.picture(self.place_of(part.svg), part.alt, (part.width * fits, part.height * fits))
        style = "Figure" if part.width * fits <= self.width else "Wide Figure"
        shown = [tree.styled(style, [tree.paragraph([picture])]), *self._caption("figure", part.label, part.caption)]
        return self.dialect.turned(shown) if part.width * fits > self.width + REACH else shown

    @of.register
    def _(self, part: parts.Panels) -> list[Node]:
        legend: list[Node] = []
        for svg, words in part.legend:
            legend += [
                self.dialect.picture(self.place_of(svg), "–", LEGEND),
                *tree.text("  "),
                *self.inlines(words),
                *tree.text("    "),
            ]
        abreast = max(1, int(self.width // part.width))
        fits = min(1.0, (self.width - 2 * GAP * abreast) / (abreast * part.width))
        size = (part.width * fits, part.height * fits)
        pictures = [self.dialect.picture(self.place_of(item.svg), item.alt, size) for item in part.items]
        rows = [tree.paragraph(pictures[first : first + abreast]) for first in range(0, len(pictures), abreast)]
        return [tree.styled("Figure", [tree.paragraph(legend), *rows]), *self._caption("figure", part.label, part.caption)]

    def _caption(self, kind: str, label: str, caption: parts.Runs) -> list[Node]:
        if not caption:
            return []
        found = _NUMBER.search(label)
        if found is None:
            return [tree.paragraph(self.inlines(caption))]
        mark = f"{kind}_{found[0]}"
        self.marks[label] = mark
        behind = label[found.end() :] + ("" if label.endswith("\u3000") else " ")
        return self.dialect.caption(kind, (label[: found.start()], found[0], behind), mark, self.inlines(caption))


def kind_of(part: parts.Part) -> str:
    """Return "figure" or "table" for a part with a number, "" for any other."""
    if not isinstance(part, (parts.Figure, parts.Panels, parts.Table)) or not part.caption or not _NUMBER.search(part.label):
        return ""
    return "table" if isinstance(part, parts.Table) else "figure"


def _widths(part: parts.Table, width: float) -> list[float]:
    """Return the widths of columns as parts of the text `width` (mm): by the longest cell; if there are many, in proportion."""
    heads = [
        1 + max(map(_letters, f"{_said(one.head)} {one.unit}".split()), default=0) for one in part.columns
    ]  # heads are bold, and broken at spaces
    letters = [max([head, *(_letters(_said(row[place])) for row in part.rows)]) for place, head in enumerate(heads)]
    many = len(letters) > MANY
    room, letter = SMALL if many else USUAL
    found = [room + letter * longest for longest in letters]
    found = [min(wide, MOST * width) if one.words else wide for one, wide in zip(part.columns, found, strict=True)]
    # Words may go on below, numbers may not: where there is too little room, columns of words have less, down to a half.
    words = sum(wide for one, wide in zip(part.columns, found, strict=True) if one.words)
    kept = 1 - min(max(sum(found) - width, 0.0) / words, 0.5) if words else 1.0
    found = [wide * kept if one.words else wide for one, wide in zip(part.columns, found, strict=True)]
    return [wide / (sum(found) if many else max(sum(found), width)) for wide in found]


def _said(cell: parts.Cell) -> str:
    return cell if isinstance(cell, str) else "".join(said for run in cell for key, said in run.items() if key != "lang")


def _letters(text: str) -> int:
    """Return the width of a text in letters as wide as a digit; a Chinese letter counts twice."""
    return len(text) + wide_letters(text)


BREAK: Node = {"t": "LineBreak"}
USUAL, SMALL = (5.0, 1.75), (3.0, 1.36)  # mm: room in a cell and width of a letter, in usual and in small tables
MOST = 0.5  # most of the text width for a column of words
WIDTHS = (0.14, 0.56, 0.16, 0.14)  # parts of the text width: verdict, claim, number, limit


def pictures(shown: Iterable[parts.Part], known: dict[str, Picture]) -> dict[str, Picture]:
    """Return the pictures of parts by SVG: the drawings of the page, and the symbols of its legends."""
    found = {one.svg: one for one in known.values()}
    for part in shown:
        if isinstance(part, parts.Panels):
            for svg, words in part.legend:
                said = "".join(run.get("t") or run.get("v") or run.get("c") or "" for run in words)
                found.setdefault(svg, Picture(f"legend-{len(found)}", svg, *LEGEND, said))
    return found
