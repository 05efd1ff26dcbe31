"""A handout -> the task sheet for a student: what is given, what to do, what to hand in.

Enters: a `Handout`.  Leaves: plain data, the same for the screen (`reports/sheet.html.j2`) and paper (`reports/sheets.typ`).
Used by `assign.py`.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from coursework.assigning.handout import Handout
from coursework.assigning.page_words import Equation, Plain, datum, drives, lettered, symbol_runs, symbol_text, time_text
from coursework.assigning.senses import sense_rows
from coursework.grading.marking.decimals import SOLVED
from coursework.grading.marking.rubric import PARTS, Answer, Rubric
from coursework.report.formulas.svg import Drawn, draw
from coursework.report.graphs.figures import scale_on_paper
from coursework.report.text.parts import Runs, least_width
from coursework.report.text.symbols import GREEK, symbol
from coursework.report.text.words import Words
from coursework.variant.record.changes import followers
from coursework.variant.record.entries import guide_number
from coursework.variant.record.variant import Variant
from coursework.words.errors import OutputError
from coursework.words.stylesheets import fitted
from coursework.words.templates import clean, filled

LONGEST = 200
TYPED = "\ue002"  # put around a name that is shown as typed; it occurs in no other text


def sheet(handout: Handout, words: Words, deadline: str, rubric: Rubric) -> Plain:
    """Return the contents of a task sheet; the rubric says what the program marks and what a person looks at."""
    variant = handout.variant
    shown, told = drives(variant, words)
    return {
        "language": words.phrases.language,
        "labels": {"start": lettered(variant, words("sheet.start"))} | {key: words(f"sheet.{key}") for key in
                   ("kind", "student", "id", "deadline", "data", "drive", "do", "hand_in", "senses")},
        "title": clean(variant.in_language(words.phrases.language).title, LONGEST),
        "name": clean(handout.student.name, LONGEST),
        "id": clean(handout.student.id, LONGEST),
        "deadline": clean(deadline, LONGEST),
        "drawing": _drawing(handout, words),
        "data": data_rows(handout, words),
        "start": start_rows(handout, words),
        "drive": shown,
        "laws": [lettered(variant, text) for text in told],
        "senses": _senses(handout, words, rubric),
        "do": [lettered(variant, text) for text in _tasks(handout, words)],
        "hand_in": [_told(variant, text) for text in _parts(handout, words, rubric)],
        "files": [_told(variant, text) for text in _files(handout, words, rubric)],
        "digits": lettered(variant, _digits(handout, words)),
        "enlarge": words("title.enlarge"),
    }  # fmt: skip


def sheet_html(page: Plain) -> str:
    """Return a task sheet for the screen; it prints on A4 and loads nothing from elsewhere."""
    drawn = pictures(page["drive"])
    return fitted(filled("sheet.html.j2", page=page, pictures=drawn.pictures, glyphs=drawn.glyphs))


def pictures(equations: Iterable[Equation]) -> Drawn:
    """Return equations as SVG; empty if Typst is missing, and the page then shows their text."""
    try:
        return draw([one["math"] for one in equations])
    except OutputError:
        return Drawn({}, "")


def _drawing(handout: Handout, words: Words) -> Plain | None:
    drawing = handout.mechanism
    if drawing is None:
        return None
    caption = scale_on_paper(words, words.written(drawing.caption), partial(lettered, handout.variant))
    return {
        "svg": drawing.svg,
        "alt": words.written(drawing.alt),
        "caption": caption,
        "least": least_width(drawing.svg, drawing.width),
        "width": round(drawing.width, 4),
        "height": round(drawing.height, 4),
    }


def data_rows(handout: Handout, words: Words) -> list[list[object]]:
    """Return for each given datum its symbol, its value as written, and its meaning."""
    variant, meanings = handout.variant, handout.meanings
    return [
        [symbol_runs(variant, g.name), datum(g.text, g.unit or g.si, words), lettered(variant, words.written(meanings[g.name]))]
        for g in variant.given
    ]


def start_rows(handout: Handout, words: Words) -> list[list[object]]:
    """Return the start of each coordinate, as drawn or as the geometry determines it."""
    rows: list[list[object]] = []
    solved = followers(handout.variant)
    for place, coordinate in enumerate(handout.variant.coordinates):
        own = handout.individual.accepted.values.get(("coordinates", coordinate.name, "start"))
        fixed = coordinate.start is not None and coordinate.name not in solved
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


def _parts(handout: Handout, words: Words, rubric: Rubric) -> list[str]:
    """Return what to hand in: first what the program marks, then what a person looks at."""
    variant = handout.variant
    told = {
        "table": words("sheet.part.table", rows=variant.time.steps + 1),
        "equations": words("sheet.part.equations", count=len(variant.sought)),
    }
    if rubric.weights["equations"]:
        told["equations"] = words("sheet.part.wrong_lines", part=told["equations"])
    if rubric.answers:
        told["answers"] = words(
            "sheet.part.answers", listed=words("join.comma").join(_answer(handout, words, one) for one in rubric.answers)
        )
    person = [told[part] for part in PARTS if part in told and not rubric.weights[part]]
    if handout.check is not None:
        person.append(words("sheet.part.drawing", row=handout.check.row))
    marked = [told[part] for part in PARTS if part in told and rubric.weights[part]]
    return marked + [words("sheet.part.by_person", part=part) for part in person]


def _answer(handout: Handout, words: Words, answer: Answer) -> str:
    """Return one answer that the rubric asks for: its name as typed, the quantity and the row."""
    variant = handout.variant
    of = symbol_text(variant, answer.of) if answer.of in variant.columns else clean(answer.of)
    return words("sheet.part.answer", name=_typed(answer.name), of=of, row=answer.row or variant.time.row_of_check)


def _files(handout: Handout, words: Words, rubric: Rubric) -> list[str]:
    """Return which files can be read, and how equations may be written."""
    told = [words("sheet.files")]
    if rubric.weights["equations"]:
        variant, join = handout.variant, words("join.comma").join
        names = exemplary(variant)
        shown = join(symbol_text(variant, name) for name in names)
        told.append(words("sheet.notation", typed=join(map(_typed, names)), set=shown))
    return told


def exemplary(variant: Variant) -> tuple[str, ...]:
    """Return a coordinate and its rate as an example of how to write names: the pair with the most Greek letters."""
    pairs: list[tuple[str, ...]] = [(one.name, one.rate) for one in variant.coordinates] or [variant.sought[:1]]
    return max(pairs, key=lambda pair: sum(symbol(name).letter in GREEK.values() for name in pair))


def _typed(name: str) -> str:
    """Return a name marked for `_told` to be shown as typed."""
    return f"{TYPED}{clean(name, LONGEST)}{TYPED}"


def _told(variant: Variant, text: str) -> Runs:
    """Return a sentence as runs, with the names marked by `_typed` shown as typed."""
    parts = text.split(TYPED)
    return [run for place, part in enumerate(parts) for run in ([{"c": part}] if place % 2 else lettered(variant, part))]


def _digits(handout: Handout, words: Words) -> str:
    """Return how many decimals are asked for, and with how few a table is still marked."""
    asked, accepted = handout.least_decimals, handout.accepted_decimals
    units = dict.fromkeys(words.unit(handout.variant.unit_of(name)) for name in handout.variant.columns)
    told = [words("sheet.least", decimals=asked, units=words("join.comma").join(units))]
    told.append(words("sheet.accepted", decimals=accepted) if accepted < asked else words("sheet.fewer"))
    return words.sentences(told)


def _senses(handout: Handout, words: Words, rubric: Rubric) -> Plain:
    """Return the table of positive directions, without columns that are empty in all rows, and the notes below it."""
    rows = sense_rows(handout, words)
    heads = [words(key) for key in ("given.quantity", "sheet.sense.what", "sheet.sense.from", "sheet.sense.positive")]
    untold = lettered(handout.variant, words("sheet.sense.untold"))
    notes = _sense_notes(handout, words, rubric, any(row[-1] != untold for row in rows))
    kept = [place for place in range(len(heads)) if any(row[place] for row in rows)]
    return {
        "heads": [heads[place] for place in kept],
        "rows": [[row[place] for place in kept] for row in rows],
        "notes": [lettered(handout.variant, text) for text in notes],
    }


def _sense_notes(handout: Handout, words: Words, rubric: Rubric, told: bool) -> list[str]:
    """Return notes on the signs: how the axes lie and, if some sign is `told`, that clockwise angles are also accepted."""
    turning = told and any(handout.variant.unit_of(name) in {"rad", "rad/s"} for name in handout.variant.columns)
    arcs = handout.mechanism is not None and "data-angle" in handout.mechanism.svg
    return [
        words("sheet.sense.axes_arcs" if arcs else "sheet.sense.axes"),
        *([words("sheet.sense.other_sense")] if turning and rubric.clockwise == "accept" else []),
    ]
