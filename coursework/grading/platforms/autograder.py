"""One graded submission -> `results.json` for Gradescope or PrairieLearn.

Enters: a grade as grades.json writes it.  Leaves: the file.  Used by `commands/grade.py`, for `--results`.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

from coursework.grading.marking.reasons.reasons import told
from coursework.grading.marking.rubric import PARTS, Rubric
from coursework.grading.platforms.escapes import shown
from coursework.system.files.whole_files import write_bytes
from coursework.system.frozen import frozen
from coursework.words.sentences import ENGLISH, Phrases, load_phrases, say

_MOST_TEXT = 60_000  # characters of one output: both platforms accept a megabyte in all
_NOT_GRADABLE = {"unreadable", "missing"}
_METADATA, _MOST_METADATA = "submission_metadata.json", 4_000_000


@frozen
class PartOutcome:
    """One part of the rubric: its points (None if it could not be marked) and what the student reads about it."""

    name: str
    score: float | None
    max_score: float
    output: str


@frozen
class Outcome:
    """One submission: its state, points (None if it has no number) and parts; `problems` say what to hand in again."""

    status: str
    score: float | None
    max_score: float
    output: str
    parts: Sequence[PartOutcome]
    problems: Sequence[str] = ()


def gradescope(outcome: Outcome, language: str = ENGLISH) -> dict[str, Any]:
    """Return `results.json` of Gradescope: one test for each part; without a number the score is 0 and the text says so."""
    unmarked = outcome.score is None
    tests = [
        {
            "name": part.name,
            "score": 0.0 if unmarked else score,
            "max_score": total,
            "status": "passed" if not unmarked and score >= total else "failed",
            "output": _text(part.output),
        }
        for part, score, total in _parts(outcome)
    ]
    unsaid = [text for text in outcome.problems if text not in outcome.output]
    lines = [_not_marked(outcome, language), outcome.output, *unsaid] if unmarked else [outcome.output]
    return {
        "score": 0.0 if unmarked else round(outcome.score or 0.0, 2),
        "output": _text("\n".join(lines)),
        "output_format": "text",
        "tests": tests,
    }


def created_at(source: Path) -> str:
    """Return when Gradescope received a submission (ISO 8601), from the metadata file beside its folder; "" if unknown."""
    try:
        with (source.resolve().parent / _METADATA).open("rb") as file:
            text = json.loads(file.read(_MOST_METADATA)).get("created_at")
        datetime.fromisoformat(text)
    except (OSError, ValueError, TypeError, AttributeError, RecursionError):
        return ""
    return str(text)


def prairielearn(outcome: Outcome, language: str = ENGLISH) -> dict[str, Any]:
    """Return `results.json` of PrairieLearn: score from 0 to 1; an unreadable submission is not gradable and costs no attempt."""
    gradable = outcome.status not in _NOT_GRADABLE
    share = (outcome.score or 0.0) / outcome.max_score if outcome.max_score > 0 else 0.0
    message = "" if outcome.score is not None else _not_marked(outcome, language)
    return {
        "gradable": gradable,
        "score": min(max(round(share, 6), 0.0), 1.0),
        "message": _text(message),
        "output": _text(outcome.output),
        "tests": [
            {
                "name": part.name,
                "description": "",
                "points": 0.0 if outcome.score is None else score,
                "max_points": total,
                "message": "",
                "output": _text(part.output),
            }
            for part, score, total in _parts(outcome)
        ],
        "format_errors": [] if gradable else [_text(text) for text in (outcome.problems or (outcome.output,))],
    }


def results_json(results: dict[str, Any]) -> bytes:
    """Return the bytes of `results.json`."""
    return (json.dumps(results, ensure_ascii=False, indent=1, allow_nan=False) + "\n").encode("utf-8")


def _not_marked(outcome: Outcome, language: str) -> str:
    """Return what a state without a number means: unreadable or missing work is handed in again, other work is looked at."""
    status = outcome.status.replace("-", "_")
    if outcome.status in _NOT_GRADABLE:
        return load_phrases(language).said("platform.not_marked", status=say(f"feedback.state.{status}"))
    return load_phrases(language).said(f"feedback.status.{status}")


def _parts(outcome: Outcome) -> Iterator[tuple[PartOutcome, float, float]]:
    """Return the parts with their points and most points, which add up to those of the whole submission."""
    scores = _summing([part.score or 0.0 for part in outcome.parts], outcome.score or 0.0)
    return zip(outcome.parts, scores, _summing([part.max_score for part in outcome.parts], outcome.max_score), strict=True)


def _summing(values: Sequence[float], total: float) -> list[float]:
    """Return values rounded to two decimals that add up to `total`; the largest one takes the remainder of rounding."""
    rounded = [round(value, 2) for value in values]
    if rounded:
        largest = max(range(len(values)), key=lambda place: values[place])
        rounded[largest] = round(rounded[largest] + round(total, 2) - sum(rounded), 2)
    return rounded


def _text(text: str) -> str:
    plain = shown(text)
    return plain if len(plain) <= _MOST_TEXT else plain[: _MOST_TEXT - 1] + "…"


def autograder_results(grade: Mapping[str, Any], rubric: Rubric, platform: str, path: Path, language: str) -> None:
    """Write the results of one submission for a platform, in the given language; a part not handed in is a part too."""
    words = load_phrases(language)
    parts = [
        PartOutcome(part, found.get("score"), float(found.get("max") or rubric.most(part)), _told(grade, part, words))
        for part in PARTS
        if (found := grade[part] or {}).get("max") or found.get("score") or rubric.most(part)
    ]
    if late := grade.get("late"):
        parts.append(PartOutcome("late", -late["lost"], 0.0, told(grade, words, "late")))
    output = "\n".join([told(grade, words, "total"), *(entry["text"] for entry in grade["notes"])]).strip()
    problems = [text] if (text := told(grade, words, "")) else []
    outcome = Outcome(grade["status"], grade["score"], float(grade["max"]), output, parts, problems)
    write_bytes(path, results_json(_RESULTS[platform](outcome, language)))


def _told(grade: Mapping[str, Any], part: str, words: Phrases) -> str:
    """Return what a student reads about a part: why it has its points, then the verdict on each line or answer."""
    lines = [told(grade, words, part)]
    if part == "equations" and grade[part]:
        asked = {"unreadable": "asked"} if grade["status"] == "needs-review" else {}  # an unreadable line is a question then
        verdicts = [(item["line"], asked.get(item["verdict"], item["verdict"])) for item in grade[part]["items"]]
        lines += [f"{line}: {words.said(f'feedback.equation.{verdict}')}" for line, verdict in verdicts]
    if part == "answers" and grade[part]:
        lines += [f"{item['name']}: {words.said('feedback.answer.' + item['verdict'])}" for item in grade[part]["items"]]
    return "\n".join(line for line in lines if line)


_RESULTS = {"gradescope": gradescope, "prairielearn": prairielearn}
