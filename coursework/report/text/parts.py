"""The parts of a page: a few kinds, the same for HTML and PDF.

Used by `report/`.

Every number in them is already a string.  To add a kind: one record here, one macro of the same name in
`reports/parts.html.j2`, one function of the same name in `reports/report.typ`.
"""

from __future__ import annotations

import math
import re
from dataclasses import field, fields, is_dataclass, replace
from typing import Any

from coursework.report.text.text_runs import Run
from coursework.system.frozen import frozen

Runs = list[Run]
Cell = str | Runs


@frozen
class Paragraph:
    """Running text; `style` is "", "note" (small), or, framed and with a bold `lead`, "callout" or "bar" (under the title)."""

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
    """Lines of a program, unchanged."""

    text: str
    kind: str = field(default="code", init=False)


@frozen
class Facts:
    """Pairs of a word and its content, in two columns."""

    items: list[tuple[str, Runs]]
    kind: str = field(default="facts", init=False)


@frozen
class TitleBlock:
    """Pairs of a word and its content, side by side; an empty content is a line to write on."""

    items: list[tuple[str, Runs]]
    kind: str = field(default="title_block", init=False)


@frozen
class Result:
    """The framed answer on the first page: a title, the verdict in a few words (`lead`), sentences."""

    title: str
    lead: Runs
    items: list[Runs]
    kind: str = field(default="result", init=False)


@frozen
class Claims:
    """One line per check under one question: mark, verdict in a word, claim in plain words, a number and its limit.

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

    `compact`: the words before an equation stand beside it if there is room; `flow`: as many equations as fit share a line,
    with the words before the first above them and the words after the last below.
    """

    items: list[Display]
    compact: bool = False
    flow: bool = False
    kind: str = field(default="equations", init=False)


@frozen
class Column:
    """The head of a column: words or a symbol, and the unit; the column is aligned left if it holds `words`, else right."""

    head: Runs
    unit: str = ""
    words: bool = False


@frozen
class Table:
    """Rows of strings; `strong` rows (from 0) are set bold, and a thin line follows each row in `rules`.

    `note` stands below; `whole` tables are kept on one page; `label` is "Table 1"; `id` is that of the element; `places`
    are the rows of the run (from 1) that the rows show, empty if they show none.
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
    """A drawing: SVG, its size in mm, a text for those who cannot see it (`alt`), a caption; `exact` = true to scale.

    `id` is that of the element on the page; `least` is the smallest width (mm) on a screen at which its words can be read.
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
    """One small graph: the column it shows, SVG, a text for those who cannot see it (`alt`)."""

    name: str
    svg: str
    alt: str


@frozen
class Panels:
    """Small graphs of one size (mm), two side by side, with a common `legend` of (SVG, words) above and a caption below.

    `least` is the smallest width (mm) of each on a screen at which its words can be read; only wider ones stand side by side.
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
    """One check: a mark and a word for the verdict, the finding in a sentence, value and limit, further lines under `heads`.

    `unit` is only given if it is too long to stand after the number.
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
    """The checks of one group; `title` is the question they answer, `heads` are the words above the columns."""

    title: str
    heads: list[str]
    items: list[Judged]
    kind: str = field(default="checks", init=False)


Part = Paragraph | Bullets | Code | Facts | TitleBlock | Result | Claims | Equations | Table | Figure | Panels | Checks


@frozen
class Section:
    """One section of the report; `name` is that of the function that writes it, `number` stands before the title."""

    name: str
    title: str
    parts: list[Part]
    number: str = ""

    def labelled(self, number: str) -> Section:
        """Return the section with its number."""
        return replace(self, number=number)

    def plain(self) -> dict[str, Any]:
        """Return the section as dicts, lists and strings."""
        found: dict[str, Any] = _plain(self)
        return found


def _plain(value: Any) -> Any:
    if isinstance(value, str):
        return value
    if isinstance(value, list | tuple):
        return type(value)(map(_plain, value))
    return {one.name: _plain(getattr(value, one.name)) for one in fields(value)} if is_dataclass(value) else value


DRAWING, GRAPH = 11.0, 12.0  # px, the least height of letters
INDEX = 0.7  # parts of that height which suffice for a subscript
PIXELS = 96 / 25.4  # per mm, as browsers count
_SIZE, _LOWERED = re.compile(r'font-size="([\d.]+)"'), re.compile(r'<tspan dy="[\d.]+" ')


def least_width(svg: str, width: float, word: float = DRAWING) -> float:
    """Return the width (mm, rounded up to 0.1 mm) at which the smallest letters are `word` px high, or 70 % in a subscript.

    `width` (mm) is that of the picture at its own size; the result is 0 if it has no words.

    >>> least_width('<svg><text font-size="3.2">A<tspan dy="0.8" font-size="2.3">1</tspan></text></svg>', 100.0)
    91.0
    """
    parts = (
        (INDEX if _LOWERED.fullmatch(svg, svg.rfind("<", 0, size.start()), size.start()) else 1.0)
        * word
        / (PIXELS * float(size[1]))
        for size in _SIZE.finditer(svg)
    )
    return math.ceil(10 * width * max(parts, default=0.0)) / 10
