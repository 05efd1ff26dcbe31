"""One graded submission -> the results file of an autograder.

Enters: a grade as grades.json writes it.  Leaves: `results.json` for Gradescope or PrairieLearn.  Used by the command.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursework.grading.marking.reasons.reasons import told
from coursework.grading.marking.rubric import PARTS, Rubric
from coursework.grading.platforms.autograder import Outcome, PartOutcome, gradescope, prairielearn, results_json
from coursework.system.files.whole_files import write_bytes
from coursework.words.sentences import Phrases, load_phrases

PLATFORMS = {"gradescope": gradescope, "prairielearn": prairielearn}


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
    write_bytes(path, results_json(PLATFORMS[platform](outcome, language)))


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
