"""A handout -> its key: the Euler table as CSV, and a page with equations, table and the construction in the check row.

Enters: a `Handout`; the template's equations, which all students share.  Leaves: CSV text and HTML.
Used by `assign.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.assigning.handout import Handout
from coursework.assigning.page_words import Equation, Plain, equation, lettered, symbol_runs
from coursework.assigning.sheet import LONGEST, data_rows, pictures, start_rows
from coursework.report.output.tables import timed_csv
from coursework.report.sections.construction import READING_HEADS, reading_row
from coursework.report.text.parts import least_width
from coursework.report.text.words import Words
from coursework.scene.scene import Scene
from coursework.variant.formula.tree import named
from coursework.words.stylesheets import fitted
from coursework.words.templates import clean, filled

COLUMN = 178  # mm between the margins of an upright page, sheet.css


def key_csv(handout: Handout) -> str:
    """Return the Euler table as CSV: header t and the columns; SI; the shortest text that reads back to the same number."""
    motion = handout.motion
    return timed_csv(motion.names, motion.t, motion.rows)


def key_equations(scene: Scene, words: Words) -> tuple[list[Equation], list[Equation]]:
    """Return the equations as written, and the velocities solved from them; both are the same for all students."""
    variant = scene.variant
    written = [equation(variant, one.left, one.right, words, one.name) for one in variant.constraints]
    solved = [equation(variant, named(name), formula, words) for block in scene.solutions for name, formula in block]
    return written, solved


def key_html(handout: Handout, equations: tuple[Sequence[Equation], Sequence[Equation]], words: Words) -> str:
    """Return the page with the key of one student."""
    variant = handout.variant
    written, solved = equations
    page: Plain = {
        "language": words.phrases.language,
        "labels": {key: lettered(variant, words(f"key.{key}")) for key in ("data", "start", "equations", "solved", "table")},
        "kind": words("key.kind"),
        "heads": [words("sheet.student"), words("sheet.id")],
        "title": clean(variant.in_language(words.phrases.language).title, LONGEST),
        "name": clean(handout.student.name, LONGEST),
        "id": clean(handout.student.id, LONGEST),
        "data": data_rows(handout, words),
        "start": start_rows(handout, words),
        "written": list(written),
        "solved": list(solved),
        "columns": [[symbol_runs(variant, name), words.unit(variant.unit_of(name))] for name in ("t", *variant.columns)],
        "rows": _rows(handout, words),
        "marked": variant.time.check_row or 0,
        "check": _check(handout, words),
        "enlarge": words("title.enlarge"),
    }
    drawn = pictures([*written, *solved])
    return fitted(filled("key.html.j2", page=page, pictures=drawn.pictures, glyphs=drawn.glyphs))


def _rows(handout: Handout, words: Words) -> list[tuple[str, ...]]:
    motion, numbers = handout.motion, words.numbers
    decimals = handout.least_decimals + 1
    columns = [[numbers.fixed(value, decimals) for value in column] for column in motion.rows.T.tolist()]
    return list(zip(numbers.times(motion.t.tolist()), *columns, strict=True))


def _check(handout: Handout, words: Words) -> Plain | None:
    check = handout.check
    if check is None:
        return None
    variant, numbers = handout.variant, words.numbers

    def rich(text: str) -> list[dict[str, str]]:
        return lettered(variant, clean(words.written(text)))

    heading = words("key.check", row=check.row, time=words.amount(numbers.plain(check.time), "s"))
    drawing = check.drawing(words.written)
    return {
        "heading": lettered(variant, heading),
        "svg": drawing.svg,
        "wide": drawing.width,
        "turned": drawing.width > COLUMN,
        "least": least_width(drawing.svg, drawing.width),
        "says": words("key.drawn"),
        "heads": [words(f"graph.{key}") for key in READING_HEADS],
        "rows": [reading_row(words, one, rich, rich) for one in check.readings],
        "note": lettered(variant, words("graph.table")),
        "notes": [rich(note) for note in check.notes],
    }
