"""Decisions of the instructor that replace marks: read from a file, put into the grades after marking on every run.

Enters: `overrides.csv` (id,check,points,reason and further columns), grades.  Leaves: `Override`s by id, changed grades.
Raises `InputError` for a decision that makes no sense: nothing is graded by half-understood decisions.
Used by `grading/batch/` and `commands/`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import asdict
from typing import Any

from coursework.grading.marking.grade import GRADED
from coursework.grading.marking.late import OF_FILE, UNKNOWN
from coursework.grading.marking.reasons.reasons import after_decision, decided, lost_by_time
from coursework.grading.marking.rubric import PARTS, Rubric, rounded_points
from coursework.grading.platforms.cells_of_csv import read_cells
from coursework.grading.platforms.names import same_key
from coursework.grading.reading.numbers import filled_in
from coursework.grading.reading.submission import note
from coursework.system.frozen import frozen
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

COLUMNS = ("id", "check", "points", "reason")
FURTHER = ("say", "appeal", "by", "at", "marker")  # may be absent; `say` is a sentence to the student
CHECKS = (*PARTS, "total")
_SHARE = re.compile(r"([^%％]*?)\s*[%％]")


@frozen
class Override:
    """A decision of the instructor: `points` for a part ("table", "equations", "answers") or for the "total".

    `say` is the sentence to the student, who then is not told the `reason`; None: the file has no such column, and the student
    reads the reason.  `appeal`, `by`, `at` and `marker` are kept as they stand.
    """

    check: str
    points: float
    reason: str
    say: str | None = None
    appeal: str = ""
    by: str = ""
    at: str = ""
    marker: str = ""

    @property
    def told(self) -> str:
        """Return what the student reads about the decision, besides the points."""
        return self.reason if self.say is None else self.say

    def plain(self) -> dict[str, Any]:
        """Return the record as grades.json writes it, without further columns that are empty."""
        return {key: value for key, value in asdict(self).items() if value or key not in FURTHER}


def read_overrides(
    content: bytes, file: str, known: Collection[str], rubric: Rubric, folders: Mapping[str, str] | None = None
) -> dict[str, tuple[Override, ...]]:
    """Return the decisions of each student in `known`, by id; `folders` are ids by the name of a student's folder, which will do.

    Raises `InputError` with every fault.
    """
    cells = read_cells(content, file)
    if missing := [name for name in COLUMNS[:3] if name not in cells.columns]:
        raise InputError([Fault(say("fault.G028", missing=missing[0], columns=",".join(COLUMNS)), file, 1)])
    ids = {same_key(name): student for name, student in [*(folders or {}).items(), *zip(known, known, strict=True)]}
    found: dict[str, list[Override]] = {}
    faults: list[Fault] = []
    for record, values in cells.named((*COLUMNS, *FURTHER)):
        if not any(values.values()):
            continue
        line = cells.records[record][0].line
        if any(cell.value.strip() for cell in cells.records[record][len(cells.titles) :]):
            faults.append(Fault(say("fault.G046", count=len(cells.titles)), file, line))
            continue
        student = ids.get(same_key(values["id"]))
        if student is None:
            hint = closest(values["id"], list(known))
            faults.append(Fault(say("fault.G029", id=values["id"][:80], hint=hint), file, line))
            continue
        check = values["check"].casefold()
        if check not in CHECKS:
            hint = closest(check, CHECKS) or say("hint.known", known=", ".join(CHECKS))
            faults.append(Fault(say("fault.G030", check=values["check"][:80], hint=hint), file, line))
            continue
        most = rubric.points if check == "total" else rubric.most(check)
        points = _points(values["points"], most)
        if points is None:
            faults.append(Fault(say("fault.G031", most=most, points=values["points"][:80]), file, line))
            continue
        further = {key: values[key] for key in FURTHER if key in cells.columns}
        found.setdefault(student, []).append(Override(check, points, values["reason"], **further))
    if faults:
        raise InputError(faults)
    return {student: tuple(listed) for student, listed in found.items()}


def _points(text: str, most: float) -> float | None:
    """Return the points in a cell, written as points or as a percentage of `most`; None if they are not from 0 to `most`."""
    share = _SHARE.fullmatch(text)
    number = filled_in(share[1] if share else text, "," if "," in text else ".")
    if not number.is_number or not 0 <= number.value <= (100 if share else most):
        return None
    return rounded_points(most * float(number.value) / 100) if share else float(number.value)


def overridden(grade: Mapping[str, Any], overrides: Iterable[Override], rubric: Rubric, handed_in: str = "") -> dict[str, Any]:
    """Return a grade with the decisions put in, and with what it loses for being late unless the total was decided.

    A decision about the total gives a number to a grade without one; so do decisions about all parts that had no points.
    """
    overrides = tuple(overrides)
    changed = {**grade, "overrides": [override.plain() for override in overrides]}
    counted = [part for part in PARTS if rubric.weights[part]]
    had_all = _have_points(changed, counted)
    for override in overrides:
        most = rubric.points if override.check == "total" else rubric.most(override.check)
        said = decided(override.check, float(override.points), rounded_points(most), override.told)
        changed["reasons"] = after_decision(changed.get("reasons", []), said)
        if override.check == "total":
            changed["score"], changed["proposed"] = rounded_points(override.points), None
            if changed["status"] not in GRADED:
                changed["status"] = "graded-with-notes"
            continue
        part = override.check
        changed[part] = {**(changed[part] or _unmarked(part, rubric)), "score": rounded_points(override.points)}
        if changed["status"] not in GRADED and not had_all and _have_points(changed, counted):
            changed["status"], changed["proposed"] = "graded-with-notes", None
        parts = [changed[part] for part in PARTS if changed[part]]
        number = "score" if changed["status"] in GRADED else "proposed"
        changed[number] = rounded_points(sum(part.get("score") or 0.0 for part in parts))
    if changed["score"] is not None:
        changed["reasons"] = [entry for entry in changed.get("reasons", []) if entry["kind"] != "state"]
    return _after_deadline(changed, rubric, handed_in)


def _after_deadline(grade: dict[str, Any], rubric: Rubric, handed_in: str) -> dict[str, Any]:
    """Return a grade less the points lost for being late; a decision about the total is final and loses none."""
    changed = {**grade, "late": None}
    if rubric.late is None or not changed["files"]:
        return changed
    if handed_in == UNKNOWN:
        changed["notes"] = [*changed["notes"], note("late", "late_unknown").plain()]
    if handed_in.startswith(OF_FILE):
        time = f"{rubric.late.time(handed_in):%Y-%m-%d %H:%M}"
        changed["notes"] = [*changed["notes"], note("late", "late_by_file", time=time).plain()]
    if (found := rubric.late.share(handed_in)) is None:
        return changed
    minutes, share = found
    number = "score" if changed["score"] is not None else "proposed"
    earned = changed[number] or 0.0
    is_decided = any(entry["check"] == "total" for entry in changed["overrides"])
    lost = 0.0 if is_decided else min(earned, rounded_points(share * rubric.points))
    changed["late"] = {"minutes": minutes, "lost": lost}
    said = lost_by_time(minutes, lost, changed["max"])
    changed["notes"] = [*changed["notes"], {"code": "late", "text": said.text}]
    if lost:
        changed[number] = rounded_points(earned - lost)
        changed["reasons"] = [*changed["reasons"], said.plain()]
    return changed


def _unmarked(part: str, rubric: Rubric) -> dict[str, Any]:
    """Return a part that was not marked, with the keys that it has in grades.json."""
    counts = {"independent": 0, "needed": 0} if part == "equations" else {}
    return {"score": None, "max": rounded_points(rubric.most(part)), **counts, "items": []}


def _have_points(grade: Mapping[str, Any], parts: Iterable[str]) -> bool:
    return all(grade[part] and grade[part].get("score") is not None for part in parts)
