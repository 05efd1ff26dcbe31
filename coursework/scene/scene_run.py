"""One run of one scene: what was asked for, computed when it is read, and whose work it is.

Enters: a `Scene` and the names asked for.  Leaves: `SceneRun`, from which pages and files are made.
Used by `live/`, `output/`, `report/` and `run.py`, which hands it to a person.
"""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from coursework.equations.algebra.symbolic_objects import sympy_version
from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.textbook.solution import ShownEquation, Solution, shown_equations
from coursework.motion.integration.motion import Motion, Stop
from coursework.motion.schemes import Scheme, scheme_named, title_of
from coursework.motion.settings import Settings
from coursework.scene.motion_results import MotionResults
from coursework.scene.quantities import ACCURACY, CHECKS, FORCES, GRAPH_CHECK, Quantity, all_needs, quantities_for
from coursework.scene.scene import Scene
from coursework.scene.shown import Columns, OwnFigure, OwnSection, OwnTable
from coursework.system.arrays import Array
from coursework.system.on_demand import Plan, make_plan
from coursework.system.version import VERSION
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.drawing.check_sheet.graph_check import GraphCheck
    from coursework.drawing.paper.record import Drawing
    from coursework.results.accuracy.record import AccuracyStudy
    from coursework.results.checks.close_to_motion.closeness import Distance
    from coursework.results.checks.result import Finding
    from coursework.results.kinematics.extra import ExtraTable

T = TypeVar("T")


@dataclass(frozen=True, slots=True, repr=False)
class SceneRun:
    """`scene` (variant, settings and the way to the motion), and the names `asked` for, computed when they are read.

    `checks` are the judged facts; `stop` is why the motion ended early, or None; `of(QUANTITY)` is anything that can be asked
    for.  `timed` replaces the study of accuracy by one with seconds.
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
        """Return the results of the rows."""
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
        """Return the findings of all checks, with those of forces if forces are asked for."""
        return self.results.checks + (self.results.force_checks if self.asks(FORCES) else ())

    @property
    def summary(self) -> str:
        """Return the findings in two or three sentences, "" if no checks were asked for."""
        return self._summed(lambda finding: finding.code)

    @property
    def named_summary(self) -> str:
        """Return the same with the names of checks in place of their codes."""
        return self._summed(lambda finding: finding.title)

    def _summed(self, named: Callable[[Finding], str]) -> str:
        from coursework.results.checks.summary import summary

        return summary(self.checks, is_motion=self.tableau is None, named=named) if self.asks(CHECKS) else ""

    @property
    def stop(self) -> Stop | None:
        """Return why the motion ended before its time."""
        return self.motion.stop

    def status(self, strict: bool = False) -> int:
        """Return the exit status: 3 if the tool could not judge, 1 for a stop or a FAIL (`strict`: also for a COARSE), else 0."""
        verdicts = {check.verdict for check in self.checks} if self.asks(CHECKS) else set()
        if "ERROR" in verdicts:
            return 3
        return int(self.stop is not None or "FAIL" in verdicts or (strict and "COARSE" in verdicts))

    def columns(self) -> tuple[tuple[str, ...], Array]:
        """Return names and rows of the table after t, with accelerations and points if they were asked for."""
        return self.columns_of(self.results)

    def columns_of(self, results: MotionResults) -> tuple[tuple[str, ...], Array]:
        """Return the same columns for any motion of the scene."""
        names, rows = results.motion.names, [results.motion.rows]
        for *_, table in self._beside(results):
            names += table.names
            rows.append(table.rows)
        return names, np.hstack(rows)

    def _beside(self, results: MotionResults) -> Iterator[tuple[str, Columns[Any], ExtraTable]]:
        """Yield name, record and columns of each quantity asked for that is shown as columns beside those of the table."""
        for name, quantity in quantities_for(self.asked).items():  # points with accelerations have another record
            if isinstance(quantity.shows, Columns):
                yield name, quantity.shows, quantity.shows.of(results, quantity.compute.of(results))

    def _shown(self, *ways: type[Any]) -> Iterator[tuple[Quantity[Any], Any]]:
        """Yield each quantity asked for that is shown in one of the given ways, and how it is shown."""
        asked = quantities_for(self.asked).values()
        return ((one, one.shows) for one in asked if isinstance(one.shows, ways))

    @property
    def units(self) -> dict[str, str]:
        """Return the unit of each column of the results table, including t and the columns beside it."""
        return self.units_of(self.results)

    def units_of(self, results: MotionResults) -> dict[str, str]:
        """Return the units of the same columns for any motion of the scene."""
        units = {name: self.variant.unit_of(name) for name in ("t", *results.motion.names)}
        for *_, table in self._beside(results):
            units |= dict(zip(table.names, table.units, strict=True))
        return units

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
        """Return the derivatives of drives and functions that occur in the solutions: name -> (of what, by what)."""
        shown = dict.fromkeys(name for solution in self.solutions for _, formula in solution for name in formula.names())
        return self.scene.equations.symbols.derivatives_among(shown)

    @property
    def solutions(self) -> tuple[Solution, ...]:
        """Return the velocities of every block as formulas, empty for a block that is solved numerically."""
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
        """Return the scheme itself, None if the table is the exact motion."""
        return scheme_named(self.settings.scheme)

    @property
    def distance_to_exact(self) -> Distance | None:
        """Return how far the coursework's scheme is from an exact table, None if the table was made by a scheme."""
        from coursework.results.checks.close_to_motion.closeness import distance

        return distance(self.results.by_scheme.evidence) if self.scene.scheme_rows is not None else None

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
        tables: dict[str, ExtraTable] = {}
        t = self.motion.t
        if len(t) < 2:
            return tables  # a motion that stops at once has nothing to tabulate besides its only row
        for name, shows, table in self._beside(self.results):
            printed = shows.on_page(table)
            if printed.names:
                rows = np.column_stack([t, printed.rows])
                beside = replace(printed, names=("t", *printed.names), units=("s", *printed.units), rows=rows)
                tables[name] = replace(beside, sizes=(0.0, *printed.sizes)) if printed.sizes else beside
        return tables | self.own_tables

    @property
    def own_tables(self) -> dict[str, ExtraTable]:
        """Return the tables asked for that have their own rows."""
        return {one.name: shows.of(self.results, self.of(one)) for one, shows in self._shown(OwnTable)}

    @property
    def section_tables(self) -> dict[str, ExtraTable]:
        """Return the tables of quantities with a section of their own, by the names of their files."""
        own = self._shown(OwnSection)
        return {one.name: shows.table(self.results, self.of(one)) for one, shows in own if shows.table is not None}

    @property
    def lines_of_drawings(self) -> list[Iterable[tuple[object, ...]]]:
        """Return the lines of `polygons.csv` of each quantity asked for that is drawn to scale."""
        own = self._shown(OwnFigure, OwnSection)
        return [shows.lines(self.of(one)) for one, shows in own if shows.lines is not None]

    def mechanism(self) -> Drawing | None:
        """Return the mechanism with names, lengths, angles and drive, None if the file places no points.

        It is drawn at the start; if links lie on one line there, in the row in which least coincides: a row of the exact motion
        if something asked for needs that motion, else of the table.
        """
        from coursework.drawing.figures import draw_start

        def clear() -> Motion:
            return self.exact if "exact" in self.plan_with().order else self.motion

        return draw_start(self.scene.mechanism, self.scene.equations, self.motion, self.scene.start, clear)

    def at_stop(self) -> Drawing | None:
        """Return the mechanism in the position in which its motion ends, None if it does not end or the position is unknown."""
        from coursework.drawing.figures import draw_stop

        if self.stop is None:
            return None
        return draw_stop(self.scene.mechanism, self.scene.equations, self.motion, self.stop)

    def figures(self, written: Callable[[str], str] = str) -> dict[str, tuple[Drawing, ...]]:
        """Return the drawings asked for that have no section of their own; `written` puts their words into a language."""
        return {one.name: shows.of(self.results, self.of(one), written) for one, shows in self._shown(OwnFigure)}

    @property
    def study(self) -> AccuracyStudy | None:
        """Return the study of accuracy against cost, also if it was not asked for; None if it would compare nothing."""
        return self.of(ACCURACY) if self.timed is None else self.timed

    @property
    def graph_check(self) -> GraphCheck | None:
        """Return the graph-analytical check, None if it was not asked for or if the motion stops before its row."""
        return self.of(GRAPH_CHECK) if self.asks(GRAPH_CHECK) else None

    @property
    def is_checked_by_drawing(self) -> bool:
        """Return whether there is a graph-analytical check, and something can be read off its drawing."""
        return self.graph_check is not None and not self.graph_check.unread

    def plan_with(self, *more: str, pages: bool = True) -> Plan:
        """Return the plan with `more` besides what was asked for; without `pages`, leave out what only pages show."""
        asked = [one.name for one in quantities_for(self.asked).values() if pages or not one.only_pages]
        plan = make_plan(all_needs(type(self.scene)), [*asked, *more])
        return replace(plan, needed_by={**plan.needed_by, **{name: say("plan.pages") for name in more if name not in asked}})

    @property
    def versions(self) -> dict[str, str]:
        """Return the versions that made the numbers; that of SymPy only if it is installed."""
        made = {"coursework": VERSION, "python": platform.python_version(), "numpy": np.__version__, "sympy": sympy_version()}
        return {name: version for name, version in made.items() if version}
