"""Remarks on the data of a run: values that were set other than in the file, and values that look like a slip.

Enters: a `PageContext`.  Leaves: `Paragraph`s.  Used by `statement.py` and `report/pages/notebook.py`.
"""

from __future__ import annotations

import re

from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Paragraph, Part
from coursework.report.text.text_runs import LONGEST_NAME, runs
from coursework.variant.record.entries import guide_number
from coursework.words.templates import clean

MOST_REMARKS = 12  # more would take the room of the results, which begin on the same page
_QUANTITY = r"([+-]?\d*\.?\d+(?:[eE][+-]?\d+)?) ([\w/^]+)"


def remarks(context: PageContext) -> list[Part]:
    """Return the remarks on values that were set, and on values that look like a slip."""
    return [*_set(context), *_plausibility(context)]


def _set(context: PageContext) -> list[Part]:
    """Return the values that were set, on the command line for example, other than in the file."""
    values = context.run.variant.set_values
    if not values:
        return []
    pairs = [_set_value(context, name, text) for name, text in values.items()]
    told = [context.words("given.set", listed=context.words.listing(pairs))]
    if anew := context.run.scene.closed_anew:
        told.append(context.told(anew))
    if context.variant.remarks:
        told.append(context.words("check.QUOTE.set"))
    return [Paragraph(context.lettered(context.words.sentences(told)))]


def _set_value(context: PageContext, name: str, text: str) -> str:
    """Return "name = value" as it was set, with the unit in the language of the page; a law of the drive has no unit."""
    if name == "check_row" and (guide := guide_number(int(text))) >= 1:
        return context.words("remark.set_row", name=name, row=text, guide=guide)
    if found := re.fullmatch(_QUANTITY, text):
        return f"{name} = {context.with_unit(as_written(context, found[1]), found[2])}"
    return f"{name} = {as_written(context, text)}"


def as_written(context: PageContext, text: str) -> str:
    """Return a number as the file writes it, but with the minus and decimal sign of the page."""
    return clean(text, LONGEST_NAME).replace("-", "−").replace(".", context.numbers.mark)


def _plausibility(context: PageContext) -> list[Part]:
    say, plausibility = context.words, context.run.variant.plausibility
    notes = [context.told(remark.told) for remark in plausibility[:MOST_REMARKS]]
    if len(plausibility) > MOST_REMARKS:
        notes.append(say("remark.more", number=len(plausibility) - MOST_REMARKS))
    return [Paragraph(runs(note), style="note") for note in notes]
