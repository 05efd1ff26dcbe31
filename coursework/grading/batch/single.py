"""One graded submission -> the results file of an autograder.

Enters: a grade as grades.json says it.  Leaves: `results.json` for Gradescope or PrairieLearn.  Used by the command.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursework.grading.marking.rubric import PARTS
from coursework.grading.platforms.autograder import Outcome, PartOutcome, gradescope, prairielearn, results_json
from coursework.system.whole_files import write_bytes
from coursework.words.sentences import Phrases, load_phrases

PLATFORMS = {"gradescope": gradescope, "prairielearn": prairielearn}


def autograder_results(grade: Mapping[str, Any], platform: str, path: Path, language: str) -> None:
    """Write the results of one submission for a platform, in a language."""
    words = load_phrases(language)
    parts = [
        PartOutcome(part, found.get("score"), float(found.get("max") or 0.0), _told(grade, part, words))
        for part in PARTS
        if (found := grade[part]) and (found.get("max") or found.get("score"))
    ]
    notes = "\n".join(entry["text"] for entry in grade["notes"])
    problems = [grade["reason"]] if grade["reason"] else []
    outcome = Outcome(grade["status"], grade["score"], float(grade["max"]), notes, parts, problems)
    write_bytes(path, results_json(PLATFORMS[platform](outcome, language)))


def _told(grade: Mapping[str, Any], part: str, words: Phrases) -> str:
    """Return what a student reads about a part."""
    if part == "table":
        return grade["first_wrong"]["sentence"] if grade["first_wrong"] else ""
    if part == "equations":
        return "\n".join(
            f"{item['line']}: {words.said('feedback.equation.' + item['verdict'])}" for item in grade["equations"]["items"]
        )
    return "\n".join(f"{item['name']}: {words.said('feedback.answer.' + item['verdict'])}" for item in grade["answers"]["items"])
