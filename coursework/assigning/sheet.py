"""A handout -> the task sheet that a student gets: what is given, what to do, what to hand in.

Enters: a `Handout`.  Leaves: plain data, the same for the screen (`reports/sheet.html.j2`) and paper (`reports/sheets.typ`).
Used by `assign.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.assigning.handout import Handout, guide_number
from coursework.assigning.page_words import Plain, datum, drives, lettered, mathematics, symbol_runs, symbol_text, time_text
from coursework.report.formulas.svg import Drawn, draw
from coursework.report.pages.pdf import Paper, pdf_of
from coursework.report.text.words import Words
from coursework.words.errors import OutputError
from coursework.words.templates import clean, filled

LONGEST = 200
SOLVED = 2  # decimals of a start that the geometry gives, beyond those that the table needs


def sheet(handout: Handout, words: Words, deadline: str = "") -> Plain:
    """Return all that a task sheet says."""
    variant = handout.variant
    shown, told = drives(variant, words)
    return {
        "language": words.phrases.language,
        "labels": {"start": lettered(variant, words("sheet.start"))} | {key: words(f"sheet.{key}") for key in
                   ("kind", "student", "id", "deadline", "data", "drive", "do", "hand_in")},
        "lead": words("sheet.digits") + words("join.sentences"),
        "title": clean(variant.in_language(words.phrases.language).title, LONGEST),
        "name": clean(handout.student.name, LONGEST),
        "id": clean(handout.student.id, LONGEST),
        "deadline": clean(deadline, LONGEST),
        "drawing": _drawing(handout, words),
        "data": data_rows(handout, words),
        "start": start_rows(handout, words),
        "drive": shown,
        "laws": [lettered(variant, text) for text in told],
        "do": [lettered(variant, text) for text in _tasks(handout, words)],
        "hand_in": [lettered(variant, text) for text in _parts(handout, words)],
        "digits": lettered(variant, words("sheet.least", decimals=handout.least_decimals)),
    }  # fmt: skip


def sheet_html(page: Plain) -> str:
    """Return a task sheet for the screen, which prints on A4 and fetches nothing."""
    drawn = pictures(mathematics(page["drive"]))
    return filled("sheet.html.j2", page=page, pictures=drawn.pictures, glyphs=drawn.glyphs)


def sheets_pdf(pages: Sequence[Plain]) -> Paper:
    """Return one PDF with every sheet, each beginning on a page of its own.  Raises `OutputError`."""
    return pdf_of("sheets.typ", list(pages))


def pictures(sources: Sequence[str]) -> Drawn:
    """Return equations as SVG; none where Typst is missing, and the text form stands in their place."""
    try:
        return draw(sources)
    except OutputError:
        return Drawn({}, "")


def _drawing(handout: Handout, words: Words) -> Plain | None:
    drawing = handout.mechanism
    if drawing is None:
        return None
    caption = lettered(handout.variant, words.written(drawing.caption))
    size = {"width": round(drawing.width, 4), "height": round(drawing.height, 4)}
    return {"svg": drawing.svg, "alt": words.written(drawing.alt), "caption": caption, **size}


def data_rows(handout: Handout, words: Words) -> list[list[object]]:
    """Return each given datum: its symbol, its value as written, what it means."""
    variant, meanings = handout.variant, handout.meanings
    return [
        [symbol_runs(variant, g.name), datum(g.text, g.unit or g.si, words), lettered(variant, words.written(meanings[g.name]))]
        for g in variant.given
    ]


def start_rows(handout: Handout, words: Words) -> list[list[object]]:
    """Return the start of each coordinate: as drawn, or as the geometry gives it."""
    rows: list[list[object]] = []
    for place, coordinate in enumerate(handout.variant.coordinates):
        own = handout.individual.accepted.values.get(("coordinates", coordinate.name, "start"))
        fixed = coordinate.start is not None and coordinate.name not in handout.solved
        if own is not None or fixed:
            text = datum(coordinate.text, coordinate.written or coordinate.unit, words)
        else:
            value = words.numbers.fixed(handout.start[place], handout.least_decimals + SOLVED)
            text = words.amount(value, coordinate.unit)
        rows.append([symbol_runs(handout.variant, coordinate.name), text, []])
    return rows


def _tasks(handout: Handout, words: Words) -> list[str]:
    variant, time, numbers = handout.variant, handout.variant.time, words.numbers
    sought = words.listing([symbol_text(variant, name) for name in variant.sought])
    columns = words("join.comma").join(symbol_text(variant, name) for name in variant.columns)
    step, end = (time_text(variant, key, words) for key in ("step", "end"))
    tasks = [
        words("sheet.task.equations" if variant.constraints else "sheet.task.groups", sought=sought),
        words("sheet.task.table", step=step, end=end, rows=time.steps + 1, columns=columns),
    ]
    if handout.check is not None:
        row = handout.check.row
        when = words.amount(numbers.plain(handout.check.time), "s")
        key = "sheet.task.check" if guide_number(row) >= 1 else "sheet.task.check_early"
        tasks.append(words(key, row=row, time=when, number=guide_number(row)))
    return tasks


def _parts(handout: Handout, words: Words) -> list[str]:
    parts = [words("sheet.part.table", rows=handout.variant.time.steps + 1, decimals=handout.least_decimals)]
    if handout.variant.constraints:
        parts.append(words("sheet.part.equations", count=len(handout.variant.constraints)))
    if handout.check is not None:
        parts.append(words("sheet.part.drawing", row=handout.check.row))
    return parts
