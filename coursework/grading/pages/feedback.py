"""The page for a student: points and why, the table, the equations, the graphs, how the file was read.

Enters: a `Grade`, the words of a language.  Leaves: HTML without script, in which all text from the student is escaped.
Used by the children of a batch.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from itertools import groupby
from typing import Any

import numpy as np

from coursework.grading.marking.grade import Grade
from coursework.grading.marking.key.key import Key
from coursework.grading.marking.reasons.equations import why_of_line
from coursework.grading.marking.reasons.reasons import summary
from coursework.grading.marking.reasons.table import counts, shut
from coursework.grading.marking.table.cells import CARRIED, GIVEN, MISSING, WRONG, Cells
from coursework.grading.marking.table.ways import KEY
from coursework.grading.marking.table_marks import TableMarks
from coursework.grading.pages.curves import SIZE, panel
from coursework.grading.pages.shown_cells import shown_column
from coursework.grading.reading.student_work import Reading
from coursework.grading.reading.table.units import AS_READ
from coursework.report.text.symbols import symbol
from coursework.report.text.text_runs import runs, spelt
from coursework.words.sentences import Phrases, say
from coursework.words.stylesheets import fitted
from coursework.words.templates import clean, filled

# A longer table shows its first rows and those with wrong cells, so that a person can still read the page.
FIRST_ROWS, MOST_ROWS = 25, 60
LONGEST_TEXT = 300
_NEGATIVE = re.compile(r"(?<![\w.-])-(?=\d)")
# So many columns fit on a sheet of paper; more columns are split into tables one below the other.
MOST_COLUMNS = 10
LONGEST_CELL = 80
# The sign of each mark and the class of its cell; _SHUT is for a right cell that does not count.
_SHUT = ("○", "carried")
_SIGNS = {
    WRONG: ("✗", "wrong"), MISSING: ("–", ""), KEY: ("", ""), GIVEN: ("", ""),
    **dict.fromkeys(CARRIED, ("→", "carried")),
}  # fmt: skip
_VERDICT_SIGNS = {"right": "✓", "rounded": "✓", "closure": "✓", "half": "½", "wrong": "✗", "unreadable": "?", "blank": "–"}


def feedback_page(grade: Grade, student: str, name: str | None, final: Mapping[str, Any], words: Phrases) -> str:
    """Return the page of a grade; `final` is the grade as grades.json writes it after all decisions, with the reasons."""
    decided = {entry["check"] for entry in final.get("overrides", ())}
    open_parts = {"equations"} if grade.equations and grade.equations.unread and not decided & {"equations", "total"} else set()
    parts = [
        {
            "name": say(f"feedback.part.{part}"),
            "is_open": part in open_parts,
            "points": shown_points(None if part in open_parts else (final[part] or {}).get("score"), words),
            "most": shown_points(most, words),
        }
        for part in grade.parts
        if grade.rubric.weights[part]
        for _, most in [grade.part(part)]
    ]

    so_far = [say(f"feedback.part_{_state_of(part)}", **part) for part in parts]
    if late := final.get("late"):
        lost = typeset(shown_points(-late["lost"] or 0.0, words))
        parts.append({"name": say("feedback.part.late"), "points": lost, "most": ""})

    def lettered(text: str) -> str:
        """Return a sentence with the names of columns and data printed as in the report."""
        return spelt(typeset(words.written(text)), (*grade.key.names, *(given.name for given in grade.key.variant.given)))

    return _page(
        final,
        student,
        name,
        words,
        lettered,
        variant=grade.key.variant.in_language(words.language).title,
        parts=parts,
        so_far=so_far,
        summary=runs(
            words.said("join.sentences").join(lettered(sentence) for sentence in summary(grade)) if "total" not in decided else ""
        ),
        notes=[
            runs(lettered(clean(text, LONGEST_TEXT)))
            for text in (
                *(words.written(entry.text) for entry in grade.notes),
                *(entry["text"] for entry in final["notes"] if entry["code"] == "late"),
            )
            if all(text != entry["text"] for entry in final["reasons"])
        ],
        table=_table(grade, grade.table, words, is_explained=_tells_sum(final)) if grade.table else None,
        equations=_equations(grade, words),
        answers=_answers(grade, words),
    )


def _state_of(part: Mapping[str, Any]) -> str:
    """Return whether a part has points, waits for a person or was not handed in."""
    return "open" if part["is_open"] else "missing" if part["points"] == "–" else "points"


def _tells_sum(final: Mapping[str, Any]) -> bool:
    """Return whether the page tells how the points of the table came about; a decision of the instructor's stands for that."""
    return any(entry["part"] == "table" and entry["kind"] == "rule" for entry in final["reasons"])


def short_page(student: str, name: str | None, final: Mapping[str, Any], words: Phrases) -> str:
    """Return the page of a submission that could not be graded."""
    nothing = {"variant": "", "parts": [], "so_far": [], "summary": [], "notes": []}
    return _page(final, student, name, words, typeset, **nothing, table=None, equations=None, answers=None)


def _page(
    final: Mapping[str, Any], student: str, name: str | None, words: Phrases, lettered: Callable[[str], str], **content: Any
) -> str:
    reasons = final["reasons"]
    made = filled(
        "feedback.html.j2",
        say=words.said,
        language=words.language,
        student="" if name and student.startswith(name) else clean(student, LONGEST_TEXT),
        name=clean(name or student, LONGEST_TEXT),
        status=words.said(f"feedback.status.{final['status'].replace('-', '_')}"),
        state=[clean(entry["text"], 2 * LONGEST_TEXT) for entry in reasons if entry["kind"] == "state"],
        points=shown_points(final["score"], words),
        open=final["score"] is None,
        most=shown_points(final["max"], words),
        why=_why(reasons, lettered, words),
        counted=_tells_sum(final),
        **words.throughout(content),
    )
    return fitted(made)


def _why(reasons: Iterable[Mapping[str, str]], lettered: Callable[[str], str], words: Phrases) -> list[dict[str, Any]]:
    """Return why points are missing, part by part."""
    of_parts = [entry for entry in reasons if entry["kind"] != "state"]
    return [
        {
            "name": words.said(f"feedback.part.{part}"),
            "reasons": [
                {"kind": entry["kind"], "text": runs(lettered(entry["text"]) if part == "table" else entry["text"])}
                for entry in entries
            ],
        }
        for part, entries in groupby(of_parts, key=lambda entry: entry["part"])
    ]


def shown_points(value: float | None, words: Phrases) -> str:
    """Return points as a person writes them, "–" for None."""
    return "–" if value is None else words.number(round(value, 2), ".10g")


def _table(grade: Grade, marked: TableMarks, words: Phrases, *, is_explained: bool) -> dict[str, Any]:
    key, cells = grade.key, marked.cells
    reading = marked.table.reading
    wrong_rows = np.flatnonzero(cells.wrong.any(axis=1)).tolist()
    chosen = sorted({*range(min(FIRST_ROWS, len(key.table))), *wrong_rows[: MOST_ROWS - FIRST_ROWS]})
    if len(key.table) <= MOST_ROWS:
        chosen = list(range(len(key.table)))
    columns = [marked.table.column(name) for name in key.names]
    heads = [[symbol(name).run] for name in key.names]
    units = [
        words.unit(AS_READ.get(column.unit, column.unit) if column else key.variant.unit_of(name))
        for name, column in zip(key.names, columns, strict=True)
    ]
    digits = max(len(f"{t:.6g}".partition(".")[2]) for t in key.t.tolist())
    times = [words.number(t, f".{digits}f") for t in key.t.tolist()]
    decimal = words.template("decimal")
    shown = [shown_column([column.texts[row] for row in chosen], decimal) if column else [""] * len(chosen) for column in columns]
    uncounted = np.zeros_like(cells.wrong)
    if is_explained and shut(marked) and marked.points.uncounted is not None:  # a sign with a reason above
        uncounted = marked.points.uncounted
    first = next((place for place in np.argwhere(cells.wrong).tolist() if place[0] in chosen), None)
    blocks = []
    told = np.array([place for place, name in enumerate(key.names) if columns[place] or name not in key.given])
    for places in np.array_split(told, -(-len(told) // MOST_COLUMNS) or 1):
        rows = []
        for at, row in enumerate(chosen):
            entries = []
            for place in places.tolist():
                text, column = shown[place][at], columns[place]
                is_first = [row, place] == first
                # Six digits show what is wrong with a cell; the first wrong cell has its whole text as title.
                whole = clean(column.texts[row], LONGEST_CELL) if column and is_first else ""
                sign, mark = _SHUT if uncounted[row, place] else _SIGNS[cells.marks[row, place]]
                title = whole if not _is_alike(text, whole) else ""
                entries.append((text, title, sign, mark, is_first))
            rows.append({"number": row + 1, "t": times[row], "cells": entries})
        blocks.append({"heads": [(heads[place], units[place]) for place in places.tolist()], "rows": rows})
    return {
        "counts": asdict(counts(key, marked)), "shut": bool(uncounted.any()), "blocks": blocks, "first": first is not None,
        "rounded": any(
            not _is_alike(text, column.texts[row].strip())
            for column, texts in zip(columns, shown, strict=True)
            if column
            for row, text in zip(chosen, texts, strict=True)
        ),
        "file": clean(reading.file, LONGEST_TEXT), "reading": reading, "read": _columns_read(reading, words),
        "present": sum(marked.table.rows_present), "needed": len(key.table),
        "second": words.unit("s"),
        "left_out": len(key.table) - len(chosen), "left_out_wrong": len({*wrong_rows} - {*chosen}),
        "panels": _panels(key, cells, words), "box": f"0 0 {SIZE[0]:g} {SIZE[1]:g}", "least": key.least_decimals,
    }  # fmt: skip


def _is_alike(shown: str, text: str) -> bool:
    """Return whether a cell is shown with all that was handed in, whatever the minus and decimal signs of the page are.

    >>> _is_alike("−0.5", "-0,5"), _is_alike("12.1800", "12,180000000000012")
    (True, False)
    """
    return shown.rstrip().replace(",", ".") == text.replace("-", "−").replace(",", ".")


def _panels(key: Key, cells: Cells, words: Phrases) -> list[str]:
    """Return a graph of each velocity: the student's cells beside the key."""
    student, wrong = cells.student.values, cells.wrong
    return [
        panel(
            symbol(name), words.unit(key.variant.unit_of(name)), key.t, key.table[:, at], student[:, at], wrong[:, at], words
        )
        for at, name in enumerate(key.velocities, start=key.m)
    ]  # fmt: skip


def _columns_read(reading: Reading, words: Phrases) -> list[dict[str, Any]]:
    """Return where each column was found in the file, by what, and in which unit."""
    return [
        {
            "name": [symbol(name).run],
            "at": entry["at"],
            "by": say(f"feedback.by.{entry['by']}"),
            "unit": words.unit(AS_READ.get(entry["unit"], entry["unit"])),
        }
        for name, entry in reading.columns.items()
    ]


def typeset(text: str) -> str:
    """Return a sentence with a minus sign instead of a hyphen before a number.

    >>> typeset("1.5 + 0.02·(-1.92); x-2 and 1e-5 stay")
    '1.5 + 0.02·(−1.92); x-2 and 1e-5 stay'
    """
    return _NEGATIVE.sub("−", text)


def _equations(grade: Grade, words: Phrases) -> dict[str, Any] | None:
    if grade.equations is None:
        return None
    marks = grade.equations
    items = [
        {
            "line": mark.line.line, "place": clean(words.written(mark.line.place), LONGEST_TEXT) if mark.line.place else "",
            "text": clean(mark.line.text, LONGEST_TEXT), "sign": _VERDICT_SIGNS[mark.verdict],
            "why": why_of_line(mark, asked=marks.unread is not None),
        }
        for mark in marks.marks
    ]  # fmt: skip
    key = "feedback.earned.unread" if marks.unread else "feedback.independent"
    return {"items": items, "count": say(key, independent=marks.independent, needed=marks.needed)}


def _answers(grade: Grade, words: Phrases) -> list[dict[str, Any]] | None:
    if grade.answers is None:
        return None
    return [
        {
            "name": clean(mark.name, LONGEST_TEXT), "found": "–" if mark.found is None else words.number(mark.found, ".4g"),
            "sign": _VERDICT_SIGNS[mark.verdict],
            "verdict": say(f"forces.slip.{mark.slip}" if mark.slip else f"feedback.answer.{mark.verdict}"),
        }
        for mark in grade.answers.marks
    ]  # fmt: skip
