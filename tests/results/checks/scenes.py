"""Evidence for tests: that of a real run with some of it exchanged, and tables with single cells changed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import coursework
from coursework.motion.integration.motion import Motion
from coursework.results.checks.check import CHECKS, check_motion
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding
from coursework.variant.reading.reader import parse_variant

V31 = (Path(__file__).parents[3] / "variants" / "31.toml").read_text(encoding="utf-8")


def solve(text_or_name: str, scheme: str = "euler", **named: Any) -> Any:
    """Return a run with its checks, of a name of the catalogue or the text of a file; Euler's, also of a chain."""
    variant = parse_variant(text_or_name) if "\n" in text_or_name else coursework.load(text_or_name)
    return coursework.solve(variant, scheme, quantities=["table", "checks"], **named)


def evidence_of(run: Any, **changes: Any) -> Evidence:
    """Return the evidence of a run with some of it exchanged; facts about the exact motion are found anew."""
    return replace(run.results.evidence, **{"facts": {}, **changes})


def finding(code: str, evidence: Evidence) -> Finding:
    """Return what one check finds."""
    return next(found for found in check_motion(replace(evidence, rerun=None)) if found.code == code)


def verdicts(run: Any) -> dict[str, str]:
    """Return the verdict of every check of a run."""
    return {found.code: found.verdict for found in run.checks}


def found(run: Any, code: str) -> Finding:
    """Return one finding of a run."""
    return next(one for one in run.checks if one.code == code)


def spoil(motion: Motion, **cells: tuple[int, float]) -> Motion:
    """Return the motion with single cells changed: column = (row from 0, change)."""
    coordinates, velocities = motion.coordinates.copy(), motion.velocities.copy()
    for name, (row, change) in cells.items():
        is_coordinate = name in motion.coordinate_names
        rows, names = (coordinates, motion.coordinate_names) if is_coordinate else (velocities, motion.velocity_names)
        rows[row, names.index(name)] += change
    return replace(motion, coordinates=coordinates, velocities=velocities)


CODES = tuple(check.code for check in CHECKS)
