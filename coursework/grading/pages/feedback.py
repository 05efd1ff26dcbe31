"""The page a student gets: points, the first wrong cell, how the file was read, the table, the equations, the curves.

Enters: a `Grade`, the words of a language.  Leaves: HTML without script, all that came from the student escaped.
Used by the children of a batch.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from coursework.grading.marking.grade import Grade, TableMarks
from coursework.grading.marking.key import Key
from coursework.grading.marking.table.cells import CARRIED, GIVEN, KEY, MISSING, WRONG
from coursework.grading.pages.curves import panel
from coursework.report.text.symbols import symbol
from coursework.report.text.text_runs import spelt
from coursework.words.sentence import Sentence
from coursework.words.sentences import Phrases, joined, load_phrases, say, say_count
from coursework.words.templates import clean, filled

# Longer tables show their first rows and those with wrong cells: the page stays one that a person reads.
FIRST_ROWS, MOST_ROWS = 25, 60
LONGEST_TEXT = 300
_NEGATIVE = re.compile(r"(?<![\w.-])-(?=\d)")
LONGEST_CELL = 24
_RATES = {"1/s": "rad/s"}  # as the heads of the table say it
# The sign of a mark and the class of its cell.
_SIGNS = {
    WRONG: ("✗", "wrong"), MISSING: ("–", ""), KEY: ("", ""), GIVEN: ("", ""),
    **dict.fromkeys(CARRIED, ("→", "carried")),
}  # fmt: skip
_VERDICT_SIGNS = {"right": "✓", "rounded": "✓", "closure": "✓", "half": "½", "wrong": "✗", "unreadable": "?", "blank": "–"}


def feedback_page(grade: Grade, student: str, name: str | None, final: Mapping[str, Any], words: Phrases) -> str:
    """Return the page of a grade; `final` is the grade as grades.json says it after the instructor's decisions."""
    parts = [
        {
            "name": say(f"feedback.part.{part}"),
            "points": shown_points((final[part] or {}).get("score"), words),
            "most": shown_points(most, words),
        }
        for part in grade.parts
        if grade.rubric.weights[part]
        for _, most in [grade.part(part)]
    ]
    return _page(
        final,
        student,
        name,
        words,
        variant=grade.key.variant.in_language(words.language).title,
        parts=parts,
        verdict=grade.verdicts.sentence if grade.table or grade.equations else "",
        notes=[_lettered(grade.key, clean(words.written(entry.text), LONGEST_TEXT)) for entry in grade.notes],
        table=_table(grade, grade.table, words) if grade.table else None,
        equations=_equations(grade, final, words),
        answers=_answers(grade, words),
        misconception=_misconception(grade, words),
    )


def short_page(student: str, name: str | None, final: Mapping[str, Any], words: Phrases) -> str:
    """Return the page of a submission that nobody could look into."""
    nothing = {"variant": "", "parts": [], "verdict": "", "notes": []}
    return _page(final, student, name, words, **nothing, table=None, equations=None, answers=None, misconception=None)


def _page(final: Mapping[str, Any], student: str, name: str | None, words: Phrases, **content: Any) -> str:
    reason = final["reason"] if final["score"] is None else ""
    return filled(
        "feedback.html.j2",
        say=words.said,
        language=words.language,
        student="" if name and student.startswith(name) else clean(student, LONGEST_TEXT),
        name=clean(name or student, LONGEST_TEXT),
        status=words.said(f"feedback.status.{final['status'].replace('-', '_')}"),
        reason=clean(reason, 2 * LONGEST_TEXT),
        points=shown_points(final["score"], words),
        most=shown_points(final["max"], words),
        overrides=[_decision(entry, words) for entry in final.get("overrides", ())],
        **words.throughout(content),
    )


def _decision(entry: Mapping[str, Any], words: Phrases) -> dict[str, str]:
    part = entry["check"]
    return {
        "check": words.said(f"feedback.part.{part}"), "points": shown_points(entry["points"], words),
        "reason": clean(entry["reason"], LONGEST_TEXT),
    }  # fmt: skip


def shown_points(value: float | None, words: Phrases) -> str:
    """Return points as a person writes them, "–" for none."""
    return "–" if value is None else words.number(round(value, 2), ".10g")


def misconception_sentence(code: str) -> Sentence | str:
    """Return what a code means, with the name it carries (datum, velocity, variant) filled in."""
    for stem in ("rounded_omega", "confusion", "variant", "origin", "datum", "swap", "sign"):
        if code.startswith(f"{stem}_") and code != "sign_drive":
            name = clean(code.removeprefix(f"{stem}_").replace("_", ", " if stem == "swap" else "_"), LONGEST_TEXT)
            return say(f"feedback.misconception.{stem}", name=name)
    key = f"feedback.misconception.{code}"
    return say(key) if load_phrases().has(key) else code


def _symbol(name: str) -> str:
    return symbol(name).text


def _lettered(key: Key, text: str) -> str:
    """Return a sentence with the names of columns and data as the pages of the report print them."""
    return spelt(text, (*key.names, *(given.name for given in key.variant.given)))


def _misconception(grade: Grade, words: Phrases) -> dict[str, Any] | None:
    """Return what was looked for and found, None where a table gave no reason to look."""
    if grade.table is None or grade.table.hidden is None:
        return None
    named = grade.table.misconception

    def told(code: str) -> str:
        return _lettered(grade.key, words.written(misconception_sentence(code)))

    return {
        "told": told(named.code) if named else "",
        "share": str(int(100 * named.share + 1e-9)) if named else "",  # 100 only where it is all of the table
        "ties": [told(code) for code in named.ties] if named else [],
        "hidden": [told(code) for code in grade.table.hidden],
    }


def _table(grade: Grade, marked: TableMarks, words: Phrases) -> dict[str, Any]:
    key, cells = grade.key, marked.cells
    reading = marked.table.reading
    wrong_rows = np.flatnonzero(cells.wrong.any(axis=1)).tolist()
    chosen = sorted({*range(min(FIRST_ROWS, len(key.table))), *wrong_rows[: MOST_ROWS - FIRST_ROWS]})
    if len(key.table) <= MOST_ROWS:
        chosen = list(range(len(key.table)))
    columns = [marked.table.column(name) for name in key.names]
    digits = max(len(f"{t:.6g}".partition(".")[2]) for t in key.t.tolist())
    times = [words.number(t, f".{digits}f") for t in key.t.tolist()]
    rows = []
    for row in chosen:
        entries = [
            (clean(column.texts[row], LONGEST_CELL) if column else "", *_SIGNS[mark])
            for column, mark in zip(columns, cells.marks[row].tolist(), strict=True)
        ]
        rows.append({"number": row + 1, "t": times[row], "cells": entries})
    m = len(key.coordinates)
    panels = [
        panel(
            _symbol(name), words.unit(key.variant.unit_of(name)), key.t,
            key.table[:, m + place], cells.student.values[:, m + place],
            cells.wrong[:, m + place], words,
        )
        for place, name in enumerate(key.velocities)
    ]  # fmt: skip
    read = [
        {
            "name": _symbol(name),
            "at": entry["at"],
            "by": say(f"feedback.by.{entry['by']}"),
            "unit": words.unit(_RATES.get(entry["unit"], entry["unit"])),
        }
        for name, entry in reading.columns.items()
    ]
    return {
        "first": _lettered(key, typeset(words.written(marked.first.sentence))) if marked.first else "",
        "counts": {
            "wrong": int(cells.wrong.sum()), "missing": int(cells.missing.sum()), "carried": int(cells.carried.sum()),
            "cells": marked.points.cells,
        },
        "file": clean(reading.file, LONGEST_TEXT), "reading": reading, "read": read,
        "names": [_symbol(name) for name in key.names],
        "second": words.unit("s"),
        "units": [words.unit(key.variant.unit_of(name)) for name in key.names], "rows": rows,
        "left_out": len(key.table) - len(chosen), "end": words.number(key.t[-1], ".6g"),
        "panels": panels, "least": key.least_decimals,
    }  # fmt: skip


def typeset(text: str) -> str:
    """Return a sentence with a minus where a hyphen stands before a number.

    >>> typeset("1.5 + 0.02·(-1.92); x-2 and 1e-5 stay")
    '1.5 + 0.02·(−1.92); x-2 and 1e-5 stay'
    """
    return _NEGATIVE.sub("−", text)


def _equations(grade: Grade, final: Mapping[str, Any], words: Phrases) -> dict[str, Any] | None:
    if grade.equations is None:
        return None
    items = []
    for mark in grade.equations.marks:
        hint = ""
        if mark.hint:
            text = clean(words.written(mark.hint.text), LONGEST_TEXT)
            hint = say(f"feedback.hint.{mark.hint.kind}", text=text, column=mark.hint.column, others=mark.hint.others)
        items.append(
            {
                "line": mark.line.line, "text": clean(mark.line.text, LONGEST_TEXT), "sign": _VERDICT_SIGNS[mark.verdict],
                "verdict": say(f"feedback.equation.{mark.verdict}"), "hint": hint,
            }
        )  # fmt: skip
    marks = grade.equations
    dependent = _dependent(marks.dependent)
    count = say("feedback.independent", independent=marks.independent, needed=marks.needed)
    if grade.waits and final["score"] is None:
        count = say("feedback.waits")
    return {"items": items, "count": count, "dependent": dependent}


def _dependent(lines: Sequence[int]) -> str:
    return say_count("feedback.dependent", len(lines), lines=joined(map(str, lines), "join.comma")) if lines else ""


def _answers(grade: Grade, words: Phrases) -> list[dict[str, Any]] | None:
    if grade.answers is None:
        return None
    return [
        {
            "name": clean(mark.name, LONGEST_TEXT), "found": "–" if mark.found is None else words.number(mark.found, ".4g"),
            "sign": _VERDICT_SIGNS[mark.verdict], "verdict": say(f"feedback.answer.{mark.verdict}"),
        }
        for mark in grade.answers.marks
    ]  # fmt: skip
