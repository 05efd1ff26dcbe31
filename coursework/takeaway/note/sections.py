"""The sections of a note in order: those of the page, and those that the student writes.

Enters: `Results` and a dialect.  Leaves: blocks of pandoc's tree.  Used by `writer.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, zip_longest

from coursework.report.output.results import Results
from coursework.report.pages.model import ReportModel
from coursework.report.sections.sections import APPENDIX
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Equations, Paragraph, Part, Section, Table, TitleBlock
from coursework.report.text.words import Words, load_words
from coursework.takeaway.note import tree
from coursework.takeaway.note.blocks import Blocks, kind_of
from coursework.takeaway.note.tree import Node

CONCLUSION, INTRODUCTION, LITERATURE = "conclusion", "introduction", "literature"
STRUCTURAL = (INTRODUCTION, CONCLUSION, LITERATURE)  # headings without a number, which the standards centre
PLACE = "\0"  # stands for the numbers in a sentence
Headings = Sequence[tuple[str, str]]  # id and text of each heading
DIGITS = 3  # of the largest error and of a sufficient step, as in the page's conclusion


def title_blocks(model: ReportModel, blocks: Blocks) -> list[Node]:
    """Return the blocks before the contents: the kind of work, its mechanism, its author."""
    found = [
        tree.styled("Subtitle", [tree.paragraph(tree.text(model.kind))]),
        tree.styled("Title", [tree.paragraph(tree.text(model.heading))]),
    ]
    parts = [part for section in model.sections for part in section.parts if isinstance(part, TitleBlock)]
    return found + [block for part in parts for block in blocks.of(part)]


def headings(model: ReportModel) -> Headings:
    """Return id and text of every heading, in order."""
    words = load_words(model.language)
    appendices = [writer.__name__ for writer, _ in APPENDIX]
    found = [(INTRODUCTION, words("note.introduction"))]
    found += [(one.name, _titled(one)) for one in model.sections if one.name not in (*appendices, CONCLUSION)]
    found += [(CONCLUSION, words("section.conclusion")), (LITERATURE, words("note.literature"))]
    return found + [(one.name, _titled(one)) for one in model.sections if one.name in appendices]


def _titled(section: Section) -> str:
    return f"{section.number} {section.title}".strip()


def section_blocks(results: Results, blocks: Blocks) -> Iterator[Node]:
    """Yield the blocks of all sections."""
    words = load_words(results.language)
    sections = {section.name: section for section in results.model.sections}
    for name, title in headings(results.model):
        yield tree.heading(1, name, tree.text(title))
        if name in STRUCTURAL:
            yield tree.styled("To Write", [tree.paragraph(tree.text(words(f"note.{name}_hint")))])
        if name == CONCLUSION:
            yield from _numbers(results, blocks)
            own = sections[name].parts if name in sections else []
            yield from _referred([part for part in own if isinstance(part, Table)], blocks, words)
        elif name in sections:
            yield from _referred([part for part in sections[name].parts if not isinstance(part, TitleBlock)], blocks, words)


def _referred(parts: Sequence[Part], blocks: Blocks, words: Words) -> Iterator[Node]:
    """Yield the blocks of parts; numbered ones are referred to first, neighbours of a kind in one sentence."""
    for kind, group in groupby(parts, kind_of):
        together = list(group)
        numbered = dict(map(blocks.numbered, together)) if kind else {}
        marks = {mark: number for mark, number in numbered.items() if mark not in blocks.led}
        if marks:
            blocks.led |= set(marks)
            before, behind = words(f"note.see.{kind}{'s' * (len(marks) > 1)}", number=PLACE).split(PLACE)
            comma = tree.text(", ")
            links = [node for mark, number in marks.items() for node in (*comma, blocks.dialect.reference(mark, number))]
            yield tree.styled("Lead", [tree.paragraph([*tree.text(before), *links[len(comma) :], *tree.text(behind)])])
        for part, follows in zip_longest(together, together[1:]):
            leads = isinstance(part, Paragraph) and isinstance(follows, Equations)
            yield from [tree.styled("Lead", blocks.of(part))] if leads else blocks.of(part)


def _numbers(results: Results, blocks: Blocks) -> Iterator[Node]:
    """Yield what the conclusion needs: largest error, sufficient step, references to tables (first and last row, extremes)."""
    context = PageContext(results.run, load_words(results.language))
    listed: list[list[Node]] = []
    checks = results.run.checks if "checks" in results.run.asked else ()
    for check in checks:
        if check.code == "ACCURACY" and check.value is not None and check.column:
            percent = context.words.amount(context.numbers.scalar(100 * check.value, DIGITS), "%")
            where = {"symbol": context.lettering(check.column), "row": check.row}
            listed.append(blocks.inlines(context.lettered(context.words("note.error", error=percent, **where))))
            if check.step:
                step = context.quantity(check.step, "s", DIGITS)
                listed.append(blocks.inlines(context.lettered(context.words("note.step", step=step))))
    for section in results.model.sections:
        for part in section.parts:
            if isinstance(part, Table) and part.id in ("first-last", "extremes") and part.label:
                mark, number = blocks.numbered(part)
                led = blocks.dialect.reference(mark, number)
                blocks.led.add(mark)
                label = part.label.partition(number)[0]
                listed.append([*tree.text(label), led, *tree.text(": "), *blocks.inlines(part.caption)])
    if listed:
        yield tree.bullets(listed)
