"""What a page is built of: a few kinds of part, the same for HTML and PDF.

Every number in them is already a string.  To add a kind: one record here, one macro of the same name in
`reports/report.html.j2`, one function of the same name in `reports/report.typ`.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any

from coursework.report.text_runs import Run

Runs = list[Run]
Cell = str | Runs


@dataclass(frozen=True, slots=True)
class Paragraph:
    """Running text; `style` is "", "note" (small) or "callout" (framed, with a bold `lead`)."""

    text: Runs
    style: str = ""
    lead: str = ""
    kind: str = field(default="paragraph", init=False)


@dataclass(frozen=True, slots=True)
class Bullets:
    """A list of sentences."""

    items: list[Runs]
    kind: str = field(default="bullets", init=False)


@dataclass(frozen=True, slots=True)
class Facts:
    """Pairs of a word and what holds, two columns."""

    items: list[tuple[str, Runs]]
    kind: str = field(default="facts", init=False)


@dataclass(frozen=True, slots=True)
class Display:
    """One displayed equation: Typst `math`, plain `text`, its `name` at the margin, words `before` and `after`."""

    math: str
    text: str
    name: str = ""
    before: Runs = field(default_factory=list)
    after: Runs = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Equations:
    """Displayed equations, one below the other."""

    items: list[Display]
    kind: str = field(default="equations", init=False)


@dataclass(frozen=True, slots=True)
class Column:
    """The head of a column: words or a symbol, its unit; numbers stand at the right, words at the left."""

    head: Runs
    unit: str = ""
    words: bool = False


@dataclass(frozen=True, slots=True)
class Table:
    """Rows of strings; `strong` rows (counted from 0) are set bold, after `rules` a thin line is drawn.

    `note` stands below; `whole` tables are kept on one page; `label` is "Table 1".
    """

    columns: list[Column]
    rows: list[list[Cell]]
    caption: Runs = field(default_factory=list)
    strong: list[int] = field(default_factory=list)
    rules: list[int] = field(default_factory=list)
    note: Runs = field(default_factory=list)
    whole: bool = True
    label: str = ""
    kind: str = field(default="table", init=False)


@dataclass(frozen=True, slots=True)
class Figure:
    """A drawing: SVG, its size in mm, words for those who cannot see it, a caption; `exact` = true to scale; `id` for links."""

    svg: str
    width: float
    height: float
    alt: str
    caption: Runs
    exact: bool = False
    label: str = ""
    id: str = ""
    kind: str = field(default="figure", init=False)


@dataclass(frozen=True, slots=True)
class Judged:
    """One check: a mark and a word for the verdict, what was found, value and limit, further lines under `heads`.

    `unit` is one too long to stand behind the number.
    """

    mark: str
    verdict: str
    code: str
    title: Runs
    sentence: Runs
    value: Cell
    limit: Cell
    unit: str
    heads: list[str]
    lines: list[list[Cell]]


@dataclass(frozen=True, slots=True)
class Checks:
    """The checks of one group; `title` is what they ask, `heads` are the words above the columns."""

    title: str
    heads: list[str]
    items: list[Judged]
    kind: str = field(default="checks", init=False)


Part = Paragraph | Bullets | Facts | Equations | Table | Figure | Checks


@dataclass(frozen=True, slots=True)
class Section:
    """One section of the report; `name` is that of the function that wrote it."""

    name: str
    title: str
    parts: list[Part]
    number: str = ""

    def plain(self) -> dict[str, Any]:
        """Return the section as dicts, lists and strings."""
        return asdict(self)
