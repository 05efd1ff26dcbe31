"""A `Run` as the report reads it: only what was asked for is looked at, so nothing else is computed for a page.

Enters: `coursework.run.Run`.  Leaves: `Subject`, which keeps the protocol of `source.py`.
To show a further quantity as a table: one function here and one line in `EXTRAS`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from coursework.checks.result import Check
from coursework.formula import Formula
from coursework.motion import Motion, Stop
from coursework.report.source import AccuracyStudy, GraphCheck, Reduction
from coursework.report.words import Words
from coursework.schemes import SCHEMES
from coursework.variant.record import Variant

if TYPE_CHECKING:
    from coursework.run import Run


@dataclass(frozen=True, slots=True)
class ShownEquation:
    """A velocity equation and what became of it."""

    name: str
    because: str
    left: Formula
    right: Formula
    derived: bool
    used: bool


@dataclass(frozen=True, slots=True)
class Extra:
    """A table of a further quantity, `rows` (n, names) in SI."""

    title: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: Any


@dataclass(frozen=True, slots=True)
class Subject:
    """What a page speaks about; the attributes are those of `source.Run`."""

    variant: Variant
    motion: Motion
    equations: tuple[ShownEquation, ...]
    reduction: Reduction
    scheme: str
    scheme_title: str
    scheme_order: int
    step: float
    end: float
    asked: tuple[str, ...]
    exact: Motion | None = None
    checks: tuple[Check, ...] = ()
    stop: Stop | None = None
    extra_tables: dict[str, Extra] = field(default_factory=dict)
    accuracy: AccuracyStudy | None = None
    graph: GraphCheck | None = None
    versions: dict[str, str] = field(default_factory=dict)
    student: str | None = None
    group: str | None = None
    date: str | None = None
    project: int = 0
    gain: float = 0.0


def subject(run: Run, words: Words) -> Subject:
    """Return what the page of a run speaks about."""
    scheme = SCHEMES[run.settings.scheme]
    reduction = run.values["reduction"]
    return Subject(
        variant=run.variant,
        motion=run.motion,
        equations=tuple(
            ShownEquation(e.name, e.because, e.left, e.right, e.derived, e.name in reduction.used)
            for e in run.values["equations"].equations
        ),
        reduction=reduction,
        scheme=run.settings.scheme,
        scheme_title=scheme.title,
        scheme_order=scheme.order,
        step=run.motion.step,
        end=run.variant.time.end,
        asked=run.asked,
        exact=run.exact if "plots" in run.asked else None,
        checks=run.checks if "checks" in run.asked else (),
        stop=run.stop,
        extra_tables={name: table(run, words) for name, table in EXTRAS.items() if name in run.asked},
        accuracy=run.values["accuracy"] if "accuracy" in run.asked else None,
        graph=run.values["graph_check"] if "graph_check" in run.asked else None,
        versions=run.versions,
        student=run.student,
        group=run.group,
        date=run.date,
        project=run.settings.project,
        gain=run.settings.gain,
    )


def _accelerations(run: Run, words: Words) -> Extra:
    names = tuple(f"d{name}" for name in run.motion.velocity_names)
    units = tuple(f"{run.variant.unit_of(name)}^2" for name in run.motion.velocity_names)
    return Extra(words("extra.accelerations"), names, units, run.values["accelerations"])


def _points(run: Run, words: Words) -> Extra:
    names, rows = run.values["point_accelerations" if "accelerations" in run.asked else "points"]
    units = {"v": "m/s", "a": "m/s^2"}
    return Extra(words("extra.points"), names, tuple(units.get(name.split(".")[1][0], "m") for name in names), rows)


EXTRAS: dict[str, Callable[[Run, Words], Extra]] = {"accelerations": _accelerations, "points": _points}
