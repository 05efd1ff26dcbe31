"""Everything that can be asked for, one record for each quantity.

Enters: the results of a motion.  Leaves: `QUANTITIES`, which table, page, plan, run.json and `--quantities` iterate over.
Used by `scene_run.py`, `api.py` and the command line.

To add one: write a function of a `MotionResults`, marked `@computed` with what it needs, and a record in `QUANTITIES`.
Heavy imports stand inside.  Intermediate steps that nobody may ask for are properties of `Scene` and `MotionResults`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.scene.motion_results import MotionResults, Named
from coursework.scene.scene import Scene
from coursework.scene.shown import Columns, OwnFigure, OwnSection, OwnTable
from coursework.system.on_demand import Computed, computed, needs_of
from coursework.variant.record.variant import Variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say

if TYPE_CHECKING:
    from coursework.drawing.check_sheet.graph_check import GraphCheck
    from coursework.drawing.paper.record import Drawing
    from coursework.drawing.plans.plans import Plans
    from coursework.effects.kinetostatics.analysis import ForceAnalysis
    from coursework.motion.geometry.closure import Closure
    from coursework.motion.integration.rates import Rates
    from coursework.results.accuracy.problem import Problem
    from coursework.results.accuracy.record import AccuracyStudy
    from coursework.results.kinematics.extra import ExtraTable

T = TypeVar("T")


@dataclass(frozen=True, slots=True)  # mypy takes a `Computed` for an attribute of another kind elsewhere
class Quantity(Generic[T]):
    """A quantity that can be asked for by name.

    `compute` carries the name, the needs and the function; `shows` is where a reader finds it.  `restrictable`: it can be
    computed for some columns alone; `usual`: it is computed if nothing is asked for; `order` is the highest derivative of the
    motion it shows, 2 for accelerations; `refuses` returns why a variant cannot have it, None if it can; `beside` maps another
    quantity to the record that replaces this one if both are asked for; `only_pages`: it is shown on pages only, in no other
    file.
    """

    compute: Computed[T]
    shows: Columns[T] | OwnTable[T] | OwnFigure[T] | OwnSection[T]
    restrictable: bool = False
    usual: bool = False
    order: int = 1
    refuses: Callable[[Variant], Sentence | None] = field(default=lambda variant: None)
    beside: Mapping[str, Quantity[Any]] = field(default_factory=dict)
    only_pages: bool = False

    @property
    def name(self) -> str:
        """Return the name to ask for."""
        return self.compute.name

    @property
    def about(self) -> str:
        """Return a description in one line."""
        return (self.compute.__doc__ or "").partition("\n")[0]

    @property
    def needs(self) -> tuple[str, ...]:
        """Return the names of what it is computed from."""
        return self.compute.needs


@computed("motion")
def table(results: MotionResults) -> Motion:
    """The results table: one row a step."""
    return results.motion


@computed("motion", "exact")
def plots(results: MotionResults) -> tuple[Motion, Motion]:
    """What the plots show: the rows, and the exact motion behind them."""
    return results.motion, results.scene.exact


@computed("exact", "exact_accelerations")
def analogs(results: MotionResults) -> ExtraTable:
    """Velocity and acceleration analogs of a crank-driven mechanism."""
    from coursework.results.kinematics.extra import analog_table

    scene = results.scene
    return analog_table(scene.variant, scene.exact, scene.exact_accelerations)


@computed("exact", "equations", "reduction", "rates", "search")
def invariants(results: MotionResults) -> ExtraTable:
    """The invariants a_k, b_k, c_k of the slider, or of the rocker where nothing slides."""
    from coursework.results.kinematics.accelerations import accelerations
    from coursework.results.kinematics.extra import invariant_table, stroke_way

    scene = results.scene
    way = stroke_way(scene.variant, scene.exact, scene.every_rate)
    second = accelerations(scene.equations, scene.reduction, way.motion, scene.search.passages)
    return invariant_table(scene.variant, way, second)


@computed("mechanism", "equations", "motion", "exact")
def graph_check(results: MotionResults) -> GraphCheck | None:
    """The check row drawn to scale: instantaneous centres and velocities beside the table."""
    from coursework.drawing.check_sheet.graph_check import check_graph

    return check_graph(results.scene.mechanism, results.scene.equations, results.motion, results.scene.exact)


@computed("motion")
def listing(results: MotionResults) -> Motion:
    """The coursework as a program of one's own, in Python; what its comments name stands in the block diagram."""
    return results.motion


@computed("motion")
def flowchart(results: MotionResults) -> Motion:
    """The block diagram of that program."""
    return results.motion


def problem_of(variant: Variant, rates: Rates, start: list[float], exact: Motion, closure: Closure | None) -> Problem:
    """Return the problem of an accuracy study, with as many rows as the exact motion."""
    from coursework.results.accuracy.problem import Problem

    units = tuple(coordinate.unit for coordinate in variant.coordinates)
    return Problem(rates, start, variant.time.step, len(exact.t) - 1, closure, units)


@computed("stop", "rates", "start", "exact", "closure", "motion", "search")
def accuracy(results: MotionResults) -> AccuracyStudy | None:
    """What accuracy costs in evaluations: every scheme, projections, an adaptive pair, the exact closure (not timed)."""
    from coursework.results.accuracy.study import make_study

    scene = results.scene
    if not scene.follows_laws:
        from coursework.scene.motor_scene import MotorScene

        assert isinstance(scene, MotorScene)
        return None if scene.stop is not None else scene.energy_study()
    if scene.stop is not None or scene.settings.columns or scene.search.passages:
        return None  # through a singular position the error of a scheme does not depend on its step alone
    problem = problem_of(scene.variant, scene.rates, scene.start, scene.exact, scene.closure)
    results = results.by_scheme
    settings = scene.settings
    return make_study(problem, scene.exact, results.motion.scheme, project=settings.project, gain=settings.gain)


@computed("mechanism", "equations", "one_period")
def trajectories(results: MotionResults) -> tuple[Drawing, ...]:
    """Twelve positions over a period with the trajectories of the points."""
    from coursework.drawing.trajectories import draw_positions

    scene = results.scene
    found = draw_positions(scene.mechanism, scene.equations, scene.one_period)
    return (found,) if found else ()


@computed("mechanism", "equations", "one_period", "exact")
def hodographs(results: MotionResults) -> tuple[Drawing, ...]:
    """The hodograph of every point that moves."""
    from coursework.drawing.trajectories import draw_hodographs

    scene = results.scene
    return draw_hodographs(scene.mechanism, scene.equations, scene.one_period, scene.exact)


@computed("mechanism", "equations", "motion", "accelerations", "exact", "exact_accelerations")
def plans(results: MotionResults) -> Plans:
    """Plans of velocities and accelerations of every row, one row on paper."""
    from coursework.drawing.plans.plans import make_plans

    scene = results.scene
    table, exact = (results.motion, results.accelerations), (scene.exact, scene.exact_accelerations)
    return make_plans(scene.mechanism, scene.equations, table, exact)


def _acceleration_columns(results: MotionResults, rows: Any) -> ExtraTable:
    from coursework.results.kinematics.extra import ExtraTable

    names, unit_of = results.motion.velocity_names, results.scene.variant.unit_of
    units = tuple(unit_of(f"d{name}") for name in names)
    turning = np.abs(results.motion.velocities[:, [unit_of(name) == "rad/s" for name in names]]).max(initial=0.0)
    # The size of an acceleration is that of the velocity times the rotation of the links; where terms cancel, round-off remains.
    sizes = tuple(np.abs(results.motion.velocities).max(axis=0, initial=0.0) * turning)
    return ExtraTable(say("extra.accelerations"), tuple(f"d{name}" for name in names), units, rows, sizes)


def _point_columns(results: MotionResults, named: Named) -> ExtraTable:
    from coursework.results.kinematics.extra import ExtraTable

    names, rows = named
    units = tuple(map(results.scene.variant.unit_of, names))
    return ExtraTable(say("extra.points"), names, units, rows)


def _moving(table: ExtraTable) -> ExtraTable:
    """Return the columns of the points that move: nobody needs a page of zeros for a fixed pivot."""
    points = [name.partition(".")[0] for name in table.names]
    columns = zip(points, table.names, table.rows.T, strict=True)
    moving = {point for point, name, column in columns if ".v" in name and np.any(column)}
    kept = [index for index, point in enumerate(points) if point in moving]
    names, units = (tuple(texts[index] for index in kept) for texts in (table.names, table.units))
    return replace(table, names=names, units=units, rows=table.rows[:, kept])


def _refuse_no_points(variant: Variant) -> Sentence | None:
    if variant.points or any(group.meets for group in variant.groups):
        return None
    return say("fault.V501")


def _refuse_no_sheet(variant: Variant) -> Sentence | None:
    from coursework.drawing.check_sheet.lacking import lacking

    return lacking(variant)


def _force_lines(found: ForceAnalysis) -> Iterable[tuple[object, ...]]:
    from coursework.drawing.force_plans.force_plans import make_force_plans

    return make_force_plans(found, 0).rows()


def _refuse_no_forces(variant: Variant) -> Sentence | None:
    return say("fault.V733") if variant.forces is None else None


def _refuse_no_motor(variant: Variant) -> Sentence | None:
    return say("fault.V743") if variant.motor is None else None


_POINT_COLUMNS = Columns(_point_columns, _moving)
TABLE = Quantity(table, OwnSection(), restrictable=True, usual=True)
PLOTS = Quantity(plots, OwnSection(), restrictable=True, usual=True, only_pages=True)
CHECKS = Quantity(MotionResults.checks, OwnSection(), usual=True)
ACCELERATIONS = Quantity(MotionResults.accelerations, Columns(_acceleration_columns), order=2)
POINT_ACCELERATIONS = Quantity(MotionResults.point_accelerations, _POINT_COLUMNS, order=2)
POINTS = Quantity(
    MotionResults.points, _POINT_COLUMNS, refuses=_refuse_no_points, beside={ACCELERATIONS.name: POINT_ACCELERATIONS}
)
ANALOGS = Quantity(analogs, OwnTable(lambda _, rows: rows), order=2)
INVARIANTS = Quantity(invariants, OwnTable(lambda _, rows: rows), order=2)
ACCURACY = Quantity(accuracy, OwnSection(), only_pages=True)
GRAPH_CHECK = Quantity(graph_check, OwnSection(), refuses=_refuse_no_sheet)
_SYMBOLS_ONLY = OwnFigure(lambda _, drawn, written: drawn)  # which every language writes alike
TRAJECTORIES = Quantity(trajectories, _SYMBOLS_ONLY, refuses=_refuse_no_points, only_pages=True)
_BY_PLANS = OwnFigure[Any](lambda _, found, written: found.drawings(written), lambda found: found.rows())
PLANS = Quantity(plans, _BY_PLANS, order=2, refuses=_refuse_no_points)
FORCES = Quantity(
    MotionResults.forces, OwnSection(lambda _, found: found.as_table(), _force_lines), order=2, refuses=_refuse_no_forces
)
DYNAMICS = Quantity(MotionResults.dynamics, OwnSection(lambda _, found: found), order=2, refuses=_refuse_no_motor)
ENERGY = Quantity(
    MotionResults.energy, OwnSection(lambda results, found: found.as_table(results.motion.t)), order=2, refuses=_refuse_no_forces
)
LISTING = Quantity(listing, OwnSection(), only_pages=True)
FLOWCHART = Quantity(flowchart, OwnSection(), only_pages=True)
HODOGRAPHS = Quantity(hodographs, _SYMBOLS_ONLY, refuses=_refuse_no_points, only_pages=True)

QUANTITIES: tuple[Quantity[Any], ...] = (
    TABLE, PLOTS, CHECKS, ACCELERATIONS, POINTS, ANALOGS, INVARIANTS, ACCURACY, GRAPH_CHECK, PLANS, TRAJECTORIES, HODOGRAPHS,
    FORCES, ENERGY, DYNAMICS, LISTING, FLOWCHART,
)  # fmt: skip


def known_quantities() -> dict[str, Quantity[Any]]:
    """Return the records by the name to ask for."""
    return {quantity.name: quantity for quantity in QUANTITIES}


def no_quantity(name: str, columns: Iterable[str] = ()) -> Sentence:
    """Return the sentence that there is no quantity with this name, and which there are, with the columns of a table."""
    known, columns = list(known_quantities()), list(columns)
    return say("fault.C002", name=name, hint=closest(name, [*known, *columns]), known=", ".join([*known, *columns]))


def quantities_for(asked: tuple[str, ...]) -> dict[str, Quantity[Any]]:
    """Return the records to compute for the names asked for, in the order of `QUANTITIES`."""
    chosen = (quantity for quantity in QUANTITIES if quantity.name in asked)
    return {one.name: next((other for name, other in one.beside.items() if name in asked), one) for one in chosen}


def all_needs(scene: type[Scene] = Scene) -> dict[str, tuple[str, ...]]:
    """Return the needs of every quantity for a kind of scene: first intermediate steps, then what can be asked for."""
    return {**needs_of(scene), **needs_of(MotionResults), **{name: one.needs for name, one in known_quantities().items()}}
