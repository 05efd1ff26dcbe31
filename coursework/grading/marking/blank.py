"""Entries of grades.json for what is not there: a submission that could not be graded, a table that was not handed in.

Enters: a state, the rubric.  Leaves: plain data.  Used by `grade.py` and `work.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.grading.marking.rubric import Rubric, rounded_points


def blank_grade(status: str, reason: str, rubric: Rubric) -> dict[str, Any]:
    """Return the entry of grades.json for a submission that could not be graded."""
    return {
        "status": status, "score": None, "max": rubric.points, "proposed": None, "reason": reason, "files": [], "reading": None,
        "table": empty_table(rounded_points(rubric.most("table"))),
        "first_wrong": None, "equations": None, "answers": None, "misconception": None,
        "verdicts": {"equations": "none", "integration": "unknown", "arithmetic": "unknown"}, "notes": [],
    }  # fmt: skip


def empty_table(most: float) -> dict[str, Any]:
    """Return the entry of grades.json for a table that is not there."""
    return {
        "state": "missing", "score": None, "max": most, "rows": 0, "rows_needed": 0, "first_wrong": None, "wrong_cells": 0,
        "missing_cells": 0, "carried_cells": 0, "decimals": {}, "least_decimals": None, "computed_to": None,
    }  # fmt: skip
