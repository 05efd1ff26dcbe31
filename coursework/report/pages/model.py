"""The report model: the whole content of a page in order, with every number already formatted.

Enters: a `SceneRun`.  Leaves: `ReportModel`; the templates see only its plain form (dicts, lists, strings).
Used by `report/output/results.py`, `html.py`, `notebook.py` and `pdf.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from coursework.report.formulas.display import marked
from coursework.report.live.page import LivePart, live_part
from coursework.report.sections.sections import all_sections
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Equations, Figure, Panels, Part, Runs, Section, Table
from coursework.report.text.text_runs import LONGEST_NAME
from coursework.report.text.words import Words, load_words
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.words.templates import clean

LONGEST_RUNNING = (70, 36)  # characters of title and of name above the later pages; together they fit one line


@frozen
class ReportModel:
    """One report: its language, titles, and sections in order.

    `running` is the head of the later pages, `footer` the foot of all pages.  `screen` are words of the screen: `contents`, the
    heading of the list of sections; `skip`, the link past it; `copy` and `copied`, on the buttons of formulas; `enlarge`, at a
    small drawing on a phone.  `live` is the moving part, for a screen only; `scripts` is whether the page may contain scripts.
    """

    language: str
    kind: str
    heading: str
    author: str
    running: str
    footer: str
    screen: dict[str, str]
    sections: tuple[Section, ...]
    live: LivePart | None
    scripts: bool
    title_language: str  # language of the title; "" if the file writes it in an unknown one

    def plain(self) -> dict[str, Any]:
        """Return the model as dicts, lists and strings, as templates, JSON and golden files need it."""
        names = ("language", "kind", "heading", "author", "running", "footer")
        found = {name: getattr(self, name) for name in names} | self.screen
        found["sections"] = [section.plain() for section in self.sections]
        return found if self.title_language == self.language else found | {"title_language": self.title_language}


def _shortened(text: str, longest: int) -> str:
    """Return a text of at most `longest` characters, cut at the end of a word."""
    text = clean(text)
    return text if len(text) <= longest else text[: longest - 1].rsplit(" ", 1)[0].rstrip(" ,:;") + "…"


def build_model(
    run: SceneRun, language: str = "en", stamp: str = "", *, live: bool = False, later: tuple[str, ...] = ()
) -> ReportModel:
    """Return the report of a run, with the sections that were asked for and have content.

    `stamp` names the run in the footer, so that pages of different runs can be told apart; `live` adds the moving part and
    scripts; of the sections `later` only the heading is written.  Raises `InputError` if there is no such language.
    """
    words = load_words(language)
    context = PageContext(run, words, later)
    heading = heading_of(context)
    author = clean(run.student or "", LONGEST_NAME)
    title, name = LONGEST_RUNNING
    running = [_shortened(heading, title), _shortened(author, name)] if author else [_shortened(heading, title + name)]
    return ReportModel(
        language=language,
        kind=words("title.kind" if run.variant.forces is None else "title.kind_forces"),
        heading=heading,
        title_language="" if context.is_foreign(context.variant.title) else language,
        author=author,
        running=" – ".join(running),
        footer=words("title.footer", version=run.versions["coursework"], stamp=stamp) if stamp else "",
        screen={name: words(f"title.{name}") for name in ("contents", "skip", "copy", "copied", "enlarge")},
        sections=tuple(_numbered(all_sections(context), words)),
        live=live_part(context) if live else None,
        scripts=live,
    )


def _ended(caption: Runs, stop: str) -> Runs:
    """Return a caption that ends with `stop`, the language's full stop or nothing."""
    *first, last = caption
    return [*first, {**last, "t": last["t"].rstrip(" .。") + stop}] if "t" in last else caption


def heading_of(context: PageContext) -> str:
    """Return the heading of a page: name and title of the variant, or only the name if the title adds nothing."""
    name, title = (clean(text, LONGEST_NAME) for text in (context.run.variant.name, context.variant.title))
    if context.is_about_accuracy:
        return context.words("accuracy.heading" if context.run.scene.follows_laws else "accuracy.energy_heading", name=name)
    if title in ("", name):
        return context.words("title.heading_plain", name=name)
    key = "title.heading" if name.isdigit() else "title.heading_named"  # only digits are the number of a task
    return context.words(key, name=name, title=title).rstrip(": ")


def _numbered(sections: Iterable[Section], words: Words) -> Iterator[Section]:
    """Yield the sections with their captioned tables and figures numbered, and with the language's decimal sign in formulas."""
    counts = {"table": 0, "figure": 0}
    mark = words("decimal")

    def labelled(part: Part) -> Part:
        if isinstance(part, Equations):
            return replace(part, items=[marked(one, mark) for one in part.items])
        if isinstance(part, Table | Figure | Panels) and part.caption:
            kind = "table" if isinstance(part, Table) else "figure"
            counts[kind] += 1
            return replace(
                part, label=words(f"label.{kind}", number=counts[kind]), caption=_ended(part.caption, words("label.stop"))
            )
        return part

    for section in sections:
        yield replace(section, parts=[labelled(part) for part in section.parts])
