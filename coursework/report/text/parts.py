"""What a page is built of: a few kinds of part, the same for HTML and PDF.

Used by `report/`.

Every number in them is already a string.  To add a kind: one record here, one macro of the same name in
`reports/parts.html.j2`, one function of the same name in `reports/report.typ`.
"""

from __future__ import annotations

from dataclasses import field, fields, is_dataclass, replace
from typing import Any

from coursework.report.text.readable import GRAPH, least_width
from coursework.report.text.text_runs import Run
from coursework.system.frozen import frozen

Runs = list[Run]
Cell = str | Runs


@frozen
class Paragraph:
    """Running text; `style` is "", "note" (small), or with a bold `lead` "callout" (framed) or "bar" (so under the title)."""

    text: Runs
    style: str = ""
    lead: str = ""
    kind: str = field(default="paragraph", init=False)


@frozen
class Bullets:
    """A list of sentences."""

    items: list[Runs]
    kind: str = field(default="bullets", init=False)


@frozen
class Code:
    """Lines of a program, as they are typed."""

    text: str
    kind: str = field(default="code", init=False)


@frozen
class Facts:
    """Pairs of a word and what holds, two columns."""

    items: list[tuple[str, Runs]]
    kind: str = field(default="facts", init=False)


@frozen
class TitleBlock:
    """Words with what stands behind them, side by side; where nothing does, a line to write on."""

    items: list[tuple[str, Runs]]
    kind: str = field(default="title_block", init=False)


@frozen
class Result:
    """The framed answer of the first page: a title, the verdict in few words (`lead`), sentences."""

    title: str
    lead: Runs
    items: list[Runs]
    kind: str = field(default="result", init=False)


@frozen
class Claims:
    """One line a check under one question: mark, verdict in a word, claim in plain words, a number and its limit.

    `heads` are the words above the columns; the first `strong` lines are set bold.
    """

    title: str
    heads: list[str]
    items: list[tuple[str, str, Runs, Cell, Cell]]
    strong: int = 0
    kind: str = field(default="claims", init=False)


@frozen
class Display:
    """One displayed equation: Typst `math`, plain `text`, its `name` at the margin, words `before` and `after`."""

    math: str
    text: str
    name: str = ""
    before: Runs = field(default_factory=list)
    after: Runs = field(default_factory=list)


@frozen
class Equations:
    """Displayed equations, one below the other.

    `compact`: the words before each stand at its side where there is room; `flow`: as many as fit share a line, the words
    before the first stand above, those after the last below.
    """

    items: list[Display]
    compact: bool = False
    flow: bool = False
    kind: str = field(default="equations", init=False)


@frozen
class Column:
    """The head of a column: words or a symbol, its unit; numbers stand at the right, words at the left."""

    head: Runs
    unit: str = ""
    words: bool = False


@frozen
class Table:
    """Rows of strings; `strong` rows (counted from 0) are set bold, after `rules` a thin line is drawn.

    `note` stands below; `whole` tables are kept on one page; `label` is "Table 1"; `id` is that of the element; `places`
    are the rows of the run (from 1) that the rows show, where they show some.
    """

    columns: list[Column]
    rows: list[list[Cell]]
    caption: Runs = field(default_factory=list)
    strong: list[int] = field(default_factory=list)
    rules: list[int] = field(default_factory=list)
    note: Runs = field(default_factory=list)
    whole: bool = True
    label: str = ""
    id: str = ""
    places: list[int] = field(default_factory=list)
    kind: str = field(default="table", init=False)


@frozen
class Figure:
    """A drawing: SVG, its size in mm, the words for those who cannot see it, a caption; `exact` = true to scale.

    `id` is that of the element on the page; `least` is the width (mm) below which a screen does not show it, so that its
    words can be read.
    """

    svg: str
    width: float
    height: float
    alt: str
    caption: Runs
    exact: bool = False
    label: str = ""
    id: str = ""
    least: float = field(init=False)
    kind: str = field(default="figure", init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "least", least_width(self.svg, self.width))


@frozen
class Panel:
    """One small graph: the column it shows, SVG, words for those who cannot see it."""

    name: str
    svg: str
    alt: str


@frozen
class Panels:
    """Small graphs of one size (mm), two beside each other, under one `legend` of (SVG, words) and above one caption.

    `least` is the width (mm) that each has on a screen, so that its words can be read, before two stand beside each other.
    """

    id: str
    width: float
    height: float
    legend: list[tuple[str, Runs]]
    items: list[Panel]
    caption: Runs
    label: str = ""
    least: float = field(init=False)
    kind: str = field(default="panels", init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "least", max(least_width(item.svg, self.width, GRAPH) for item in self.items))


@frozen
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


@frozen
class Checks:
    """The checks of one group; `title` is what they ask, `heads` are the words above the columns."""

    title: str
    heads: list[str]
    items: list[Judged]
    kind: str = field(default="checks", init=False)


Part = Paragraph | Bullets | Code | Facts | TitleBlock | Result | Claims | Equations | Table | Figure | Panels | Checks


@frozen
class Section:
    """One section of the report; `name` is that of the function that wrote it, `number` stands before the title."""

    name: str
    title: str
    parts: list[Part]
    number: str = ""

    def labelled(self, number: str) -> Section:
        """Return the section with its number."""
        return replace(self, number=number)

    def plain(self) -> dict[str, Any]:
        """Return the section as dicts, lists and strings; its runs are those of the section, not copies."""
        found: dict[str, Any] = _plain(self)
        return found


def _plain(value: Any) -> Any:
    if isinstance(value, str):
        return value
    if isinstance(value, list | tuple):
        return type(value)(map(_plain, value))
    return {one.name: _plain(getattr(value, one.name)) for one in fields(value)} if is_dataclass(value) else value
