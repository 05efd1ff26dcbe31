"""What stands beside the data of a run: what was set other than in the file, and what looks like a slip of the pen.

Enters: a `PageContext`.  Leaves: `Paragraph`s.  Used by `statement.py` and `report/pages/notebook.py`.
"""

from __future__ import annotations

import re

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Paragraph, Part
from coursework.report.text.text_runs import LONGEST_NAME, runs
from coursework.variant.record.entries import guide_number
from coursework.words.templates import clean

MOST_REMARKS = 12  # on the first page, on which the results begin
_QUANTITY = re.compile(r"([+-]?\d*\.?\d+(?:[eE][+-]?\d+)?) ([\w/^]+)")


def remarks(context: PageContext) -> list[Part]:
    """What is set, and what looks like a slip."""
    return [*_set(context), *_plausibility(context)]


def _set(context: PageContext) -> list[Part]:
    """Return what the command line has set, other than in the file."""
    values = context.run.variant.set_values
    if not values:
        return []
    pairs = [_set_value(context, name, text) for name, text in values.items()]
    return [Paragraph(context.lettered(context.words("given.set", listed=context.words.listing(pairs))))]


def _set_value(context: PageContext, name: str, text: str) -> str:
    """Return a value as it was set, its unit in the language of the page; a law of the drive has no unit behind it."""
    if name == "check_row" and (guide := guide_number(int(text))) >= 1:
        return context.words("remark.set_row", name=name, row=text, guide=guide)
    if found := _QUANTITY.fullmatch(text):
        return f"{name} = {context.with_unit(as_written(context, found[1]), found[2])}"
    return f"{name} = {as_written(context, text)}"


def as_written(context: PageContext, text: str) -> str:
    """Return a number as the file writes it, with the signs of the language."""
    return clean(text, LONGEST_NAME).replace("-", "−").replace(".", context.numbers.mark)


def _plausibility(context: PageContext) -> list[Part]:
    say, plausibility = context.words, context.run.variant.plausibility
    told = [(remark.line, context.told(remark.sentence)) for remark in plausibility[:MOST_REMARKS]]
    notes = [say("remark.line", line=line, sentence=sentence) for line, sentence in told]
    if len(plausibility) > MOST_REMARKS:
        notes.append(say("remark.more", number=len(plausibility) - MOST_REMARKS))
    return [Paragraph(runs(note), style="note") for note in notes]
