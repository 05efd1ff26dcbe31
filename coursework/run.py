"""One run of one variant: what was asked for, computed when it is looked at.

Enters: a `Variant` and settings, from `api.py`.  Leaves: `Run`, which table, report and command line read.
Used by `api.py`, `commands/`, `live/`, `output/` and `report/`.
"""

from __future__ import annotations

import platform
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from coursework import asked
from coursework.equations.codegen.programs import SYMPY_VERSION
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.solution import ShownEquation, Solution, shown_equations
from coursework.motion.integration.motion import Motion, Stop
from coursework.motion.schemes import SCHEMES, Scheme, title_of
from coursework.motion.settings import Settings
from coursework.motion_results import MotionResults
from coursework.quantities import (
    ACCURACY,
    CHECKS,
    GRAPH_CHECK,
    Listing,
    Quantity,
    all_needs,
    quantities_for,
)
from coursework.scene import Scene
from coursework.system.on_demand import Plan, make_plan
from coursework.variant.record.variant import Variant
from coursework.words.errors import visible
from coursework.words.sentences import say

if TYPE_CHECKING:
    import pandas as pd

    from coursework.drawing.paper.record import Drawing
    from coursework.drawing.plans.graph_check import GraphCheck
    from coursework.results.accuracy.record import AccuracyStudy
    from coursework.results.checks.close_to_motion.closeness import Lesson
    from coursework.results.checks.result import Finding
    from coursework.results.kinematics.extra import ExtraTable

T = TypeVar("T")


@dataclass(frozen=True, slots=True, repr=False)
class Run:
    """A run: `scene` (variant, settings and the way to the motion), the names `asked` for, computed when looked at.

    `table` is a pandas frame (index t); `checks` the judged facts; `stop` why the motion ended early, or None; `of(QUANTITY)`
    anything that can be asked for.  `timed` replaces the study of accuracy by one with seconds.

    >>> import coursework
    >>> run = coursework.solve("31", scheme="rk4", quantities=["table", "checks"])
    >>> run.table.shape, run.stop, run.passed
    ((25, 7), None, True)
    """

    scene: Scene
    asked: tuple[str, ...]
    student: str | None = None
    group: str | None = None
    date: str | None = None
    timed: AccuracyStudy | None = None
    blank: bool = False
    teacher: str | None = None
    institution: str | None = None

    @property
    def variant(self) -> Variant:
        """Return the variant, with the step and end used."""
        return self.scene.variant

    @property
    def settings(self) -> Settings:
        """Return the scheme and its corrections."""
        return self.scene.settings

    @property
    def results(self) -> MotionResults:
        """Return what follows from the rows."""
        return self.scene.results

    def asks(self, quantity: Quantity[Any]) -> bool:
        """Return whether a quantity was asked for."""
        return quantity.name in self.asked

    def of(self, quantity: Quantity[T]) -> T:
        """Return a quantity of the rows."""
        return quantity.compute.of(self.results)

    @property
    def motion(self) -> Motion:
        """Return the rows of the scheme."""
        return self.scene.motion

    @property
    def exact(self) -> Motion:
        """Return the motion without the scheme's error, on the same rows."""
        return self.scene.exact

    @property
    def checks(self) -> tuple[Finding, ...]:
        """Return what each check has found."""
        return self.results.checks

    @property
    def summary(self) -> str:
        """Return the findings in two or three sentences, "" where no checks were asked for."""
        from coursework.results.checks.summary import summary

        return summary(self.checks, is_motion=self.tableau is None) if self.asks(CHECKS) else ""

    @property
    def stop(self) -> Stop | None:
        """Return why the motion ended before its time."""
        return self.motion.stop

    @property
    def phases(self) -> str:
        """Return with which phases of the drive a motion that stops would be possible, "" where nothing can be said."""
        return self.scene.phases

    @property
    def passed(self) -> bool:
        """Return whether the motion reached its end and no check failed; COARSE is no failure."""
        return self.status() == 0

    def status(self, strict: bool = False) -> int:
        """Return the exit status: 3 where the tool could not judge, 1 for a stop or a FAIL (`strict`: a COARSE too), else 0."""
        verdicts = {check.verdict for check in self.checks} if self.asks(CHECKS) else set()
        if "ERROR" in verdicts:
            return 3
        return int(self.stop is not None or "FAIL" in verdicts or (strict and "COARSE" in verdicts))

    @property
    def table(self) -> pd.DataFrame:
        """Return the results table: index t (s), columns as in the file, then accelerations and points if asked for."""
        import pandas as pd

        names, rows = self.columns()
        return pd.DataFrame(rows, index=pd.Index(self.motion.t, name="t"), columns=list(names))

    def columns(self) -> tuple[tuple[str, ...], np.ndarray[Any, np.dtype[np.float64]]]:
        """Return names and rows of the table after t, accelerations and points included where asked for."""
        return asked.gather(self.results, self.asked)

    @property
    def equations(self) -> tuple[ShownEquation, ...]:
        """Return the velocity equations as a page shows them."""
        return shown_equations(self.scene.equations, self.reduction)

    @property
    def reduction(self) -> Reduction:
        """Return the blocks in the order of solution."""
        return self.scene.reduction

    @property
    def partials(self) -> dict[str, tuple[str, str]]:
        """Return the derivatives of drives and functions that the solutions name: name -> (of what, by what)."""
        shown = dict.fromkeys(name for solution in self.solutions for _, formula in solution for name in formula.names())
        return self.scene.equations.symbols.derivatives_among(shown)

    @property
    def solutions(self) -> tuple[Solution, ...]:
        """Return for every block the velocities as formulas, nothing where it is solved numerically."""
        return self.scene.solutions

    @property
    def scheme(self) -> str:
        """Return the name of the scheme."""
        return self.settings.scheme

    @property
    def scheme_title(self) -> str:
        """Return the scheme's name in words."""
        return title_of(self.tableau) if self.tableau else say("exact.title")

    @property
    def tableau(self) -> Scheme | None:
        """Return the scheme itself, None where the table is the exact motion."""
        return SCHEMES.get(self.settings.scheme)

    @property
    def lesson(self) -> Lesson | None:
        """Return how far the coursework's scheme is from a table that is exact, None where a scheme has made the table."""
        from coursework.results.checks.close_to_motion.closeness import lesson

        return lesson(self.scene.by_scheme.evidence) if self.scene.lesson is not None else None

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
        """Return the tables asked for beside the results table, as a page prints them."""
        return asked.page_tables(self.results, self.asked)

    @property
    def own_tables(self) -> dict[str, ExtraTable]:
        """Return the tables asked for whose rows are not those of the results table."""
        return asked.own_tables(self.results, self.asked)

    @property
    def listings(self) -> tuple[Listing, ...]:
        """Return the files in which drawings that were asked for keep their numbers."""
        return asked.listings(self.results, self.asked)

    def mechanism(self) -> Drawing | None:
        """Return the mechanism in its start position with names, lengths and drive, None where the file places no points."""
        from coursework.drawing.figures import draw_start

        return draw_start(self.scene.mechanism, self.scene.equations, self.motion, self.scene.start)

    def at_stop(self) -> Drawing | None:
        """Return the mechanism in the position in which its motion ends, None where it does not end or that is not known."""
        from coursework.drawing.figures import draw_stop

        if self.stop is None:
            return None
        return draw_stop(self.scene.mechanism, self.scene.equations, self.motion, self.stop)

    def figures(self, written: Callable[[str], str] = str) -> dict[str, tuple[Drawing, ...]]:
        """Return the drawings asked for that have no section of their own, their words put into a language by `written`."""
        return asked.figures(self.results, self.asked, written)

    @property
    def accuracy(self) -> AccuracyStudy | None:
        """Return the study of accuracy against cost, None where it was not asked for."""
        if self.timed is not None:
            return self.timed
        return self.of(ACCURACY) if self.asks(ACCURACY) else None

    @property
    def graph(self) -> GraphCheck | None:
        """Return the graph-analytical check, None where it was not asked for or the motion stops before its row."""
        return self.of(GRAPH_CHECK) if self.asks(GRAPH_CHECK) else None

    @property
    def plan(self) -> Plan:
        """Return what is computed for the asked quantities and what is left out."""
        return self.plan_with()

    def plan_with(self, *more: str) -> Plan:
        """Return the plan where the pages show `more` besides what was asked for."""
        plan = make_plan(
            all_needs(type(self.scene)), [*(quantity.name for quantity in quantities_for(self.asked).values()), *more]
        )
        return replace(plan, needed_by={**plan.needed_by, **dict.fromkeys(more, say("plan.pages"))})

    def blocks_evaluated(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Return the blocks of velocities that each row needs, and those that nothing asked for needs, by their unknowns."""
        needed = self.scene.rates.blocks
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
        names = ", ".join((*self.asked, *self.settings.columns))
        return (
            f"<Run of {visible(self.variant.name)}: {self.scheme}, h = {self.step:g} s, 0 to {self.end:g} s, asked for {names}>"
        )

    def _repr_html_(self) -> str:
        import coursework  # pages are made floors above this one, by the function that the package offers for it

        return coursework.notebook_html(self)
