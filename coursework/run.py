"""One run of one variant: what was asked for, computed when it is looked at.

Enters: a `Variant` and settings, from `api.py`.  Leaves: `Run`, which table, report and command line read.
"""

from __future__ import annotations

import platform
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from coursework.codegen.programs import SYMPY_VERSION
from coursework.errors import visible
from coursework.formula.tree import Formula
from coursework.graph import Plan, Values, make_plan
from coursework.integration.motion import Motion, Stop
from coursework.quantities import QUANTITIES
from coursework.reduction.blocks import Reduction
from coursework.reduction.solution import Solution
from coursework.schemes import SCHEMES, Scheme
from coursework.sentences import say, title_of
from coursework.settings import Settings
from coursework.variant.record import Variant

if TYPE_CHECKING:
    import pandas as pd

    from coursework.accuracy.record import AccuracyStudy
    from coursework.checks.result import Check
    from coursework.kinematics.extra import ExtraTable
    from coursework.plans.graph_check import GraphCheck


@dataclass(frozen=True, slots=True)
class ShownEquation:
    """A velocity equation as a page shows it; `derived` from positions; not `used`: redundant, kept as a check."""

    name: str
    because: str
    left: Formula
    right: Formula
    derived: bool
    used: bool


@dataclass(frozen=True, slots=True, repr=False)
class Run:
    """A run: `variant` (with the step and end used), `settings`, `asked` quantities, and `values` computed on demand.

    `table` is a pandas frame (index t); `checks` the judged facts; `stop` why the motion ended early, or None.
    """

    variant: Variant
    settings: Settings
    asked: tuple[str, ...]
    values: Values
    student: str | None = None
    group: str | None = None
    date: str | None = None

    @property
    def motion(self) -> Motion:
        """Return the rows of the scheme."""
        motion: Motion = self.values["motion"]
        return motion

    @property
    def exact(self) -> Motion:
        """Return the motion without the scheme's error, on the same rows."""
        exact: Motion = self.values["exact"]
        return exact

    @property
    def checks(self) -> tuple[Check, ...]:
        """Return the checks."""
        checks: tuple[Check, ...] = self.values["checks"]
        return checks

    @property
    def stop(self) -> Stop | None:
        """Return why the motion ended before its time."""
        return self.motion.stop

    @property
    def phases(self) -> str:
        """Return with which phases of the drive a motion that stops would be possible, "" where nothing can be said."""
        phases: str = self.values["phases"]
        return phases

    @property
    def passed(self) -> bool:
        """Return whether the motion reached its end and no computed check failed."""
        judged = self.checks if "checks" in self.asked else ()
        return self.stop is None and all(check.verdict in {"PASS", "SKIP"} for check in judged)

    @property
    def table(self) -> pd.DataFrame:
        """Return the results table: index t (s), columns as in the file, then accelerations and points if asked for."""
        import pandas as pd

        names, rows = self.columns()
        return pd.DataFrame(rows, index=pd.Index(self.motion.t, name="t"), columns=list(names))

    def columns(self) -> tuple[tuple[str, ...], np.ndarray[Any, np.dtype[np.float64]]]:
        """Return names and rows of the table after t, accelerations and points included where asked for."""
        return gather(self.motion, self.asked, self.values)

    @property
    def equations(self) -> tuple[ShownEquation, ...]:
        """Return the velocity equations as a page shows them."""
        used, equations = self.reduction.used, self.values["equations"]
        sides = [equation.shown(equations.order) for equation in equations.equations]
        return tuple(
            ShownEquation(e.name, e.because, left, right, e.written is None, e.name in used)
            for e, (left, right) in zip(equations.equations, sides, strict=True)
        )

    @property
    def reduction(self) -> Reduction:
        """Return the blocks in the order of solution."""
        reduction: Reduction = self.values["reduction"]
        return reduction

    @property
    def partials(self) -> dict[str, tuple[str, str]]:
        """Return the names given to derivatives of drives and functions: name -> (what, by what)."""
        partials: dict[str, tuple[str, str]] = self.values["equations"].symbols.partials
        return partials

    @property
    def solutions(self) -> tuple[Solution, ...]:
        """Return for every block the velocities as formulas, nothing where it is solved numerically."""
        found: tuple[Solution, ...] = self.values["solutions"]
        return found

    @property
    def scheme(self) -> str:
        """Return the name of the scheme."""
        return self.settings.scheme

    @property
    def scheme_title(self) -> str:
        """Return the scheme's name in words."""
        return title_of(self.tableau)

    @property
    def tableau(self) -> Scheme:
        """Return the scheme itself."""
        return SCHEMES[self.settings.scheme]

    @property
    def step(self) -> float:
        """Return the step (s)."""
        return self.variant.time.step

    @property
    def end(self) -> float:
        """Return the end of the run (s)."""
        return self.variant.time.end

    @property
    def extra_tables(self) -> dict[str, ExtraTable]:
        """Return the tables asked for beside the results table."""
        from coursework.kinematics.extra import ExtraTable

        tables: dict[str, ExtraTable] = {}
        motion = self.motion
        if len(motion.t) < 2:
            return tables  # a motion that stops at once has nothing to tabulate beside its one row
        if "accelerations" in self.asked:
            names = tuple(f"d{name}" for name in motion.velocity_names)
            units = tuple(f"{self.variant.unit_of(name)}²".replace("/s²", "/s²") for name in motion.velocity_names)
            rows = np.column_stack([motion.t, self.values["accelerations"]])
            tables["accelerations"] = ExtraTable(say("extra.accelerations"), ("t", *names), ("s", *units), rows)
        if "points" in self.asked:
            names, found = _moving(*self.values["point_accelerations" if "accelerations" in self.asked else "points"])
            units = tuple({"v": "m/s", "a": "m/s²"}.get(name.partition(".")[2][0], "m") for name in names)
            if names:
                tables["points"] = ExtraTable(
                    say("extra.points"), ("t", *names), ("s", *units), np.column_stack([motion.t, found])
                )
        for name in ("analogs", "invariants"):
            if name in self.asked:
                tables[name] = self.values[name]
        return tables

    @property
    def accuracy(self) -> AccuracyStudy | None:
        """Return the study of accuracy against cost, None where it was not asked for."""
        study: AccuracyStudy | None = self.values["accuracy"] if "accuracy" in self.asked else None
        return study

    @property
    def graph(self) -> GraphCheck | None:
        """Return the graph-analytical check, None where it was not asked for or the motion stops before its row."""
        check: GraphCheck | None = self.values["graph_check"] if "graph_check" in self.asked else None
        return check

    @property
    def plan(self) -> Plan:
        """Return what is computed for the asked quantities and what is left out."""
        return self.plan_with()

    def plan_with(self, *more: str) -> Plan:
        """Return the plan where the pages show `more` besides what was asked for."""
        plan = make_plan(QUANTITIES, [*wanted(self.asked), *more], ("variant", "settings"))
        return replace(plan, needed_by={**plan.needed_by, **dict.fromkeys(more, "the pages")})

    def blocks_evaluated(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Return the blocks of velocities that each row needs, and those that nothing asked for needs, by their unknowns."""
        needed = self.values["rates"].blocks
        named = [", ".join(block.unknowns) for block in self.reduction.blocks]
        left = tuple(f"({name})" for place, name in enumerate(named) if place not in needed)
        return tuple(f"({named[place]})" for place in needed), left

    @property
    def versions(self) -> dict[str, str]:
        """Return the versions that made the numbers."""
        import coursework

        return {
            "coursework": coursework.__version__, "python": platform.python_version(),
            "numpy": np.__version__, "sympy": SYMPY_VERSION,
        }  # fmt: skip

    def __repr__(self) -> str:
        asked = ", ".join((*self.asked, *self.settings.columns))
        return (
            f"<Run of {visible(self.variant.name)}: {self.scheme}, h = {self.step:g} s, 0 to {self.end:g} s, asked for {asked}>"
        )

    def _repr_html_(self) -> str:
        import coursework  # pages are made floors above this one, by the function that the package offers for it

        return coursework.notebook_html(self)


def _moving(names: tuple[str, ...], rows: Any) -> tuple[tuple[str, ...], Any]:
    """Return the columns of the points that move: a page of zeros for a fixed pivot helps nobody."""
    speeds = {name.partition(".")[0] for name, column in zip(names, rows.T, strict=True) if ".v" in name and np.any(column)}
    kept = [place for place, name in enumerate(names) if name.partition(".")[0] in speeds]
    return tuple(names[place] for place in kept), rows[:, kept]


def wanted(asked: Iterable[str]) -> tuple[str, ...]:
    """Return the quantities to compute for what is asked: points bring their accelerations where both are asked for."""
    names = tuple(dict.fromkeys(asked))
    if {"points", "accelerations"} <= set(names):
        names = tuple("point_accelerations" if name == "points" else name for name in names)
    return names


def gather(motion: Motion, asked: Iterable[str], values: Mapping[str, Any] | Values) -> tuple[tuple[str, ...], Any]:
    """Return the columns of a motion, with those of the accelerations and points where asked for."""
    names, rows = motion.names, [motion.rows]
    if "accelerations" in asked:
        names += tuple(f"d{name}" for name in motion.velocity_names)
        rows.append(values["accelerations"])
    if "points" in asked:
        more, found = values["point_accelerations" if "accelerations" in asked else "points"]
        names += more
        rows.append(found)
    return names, np.hstack(rows)
