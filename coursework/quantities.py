"""Everything that can be computed for a scene, one function a quantity.

The name of a function is the quantity, its parameters are what it needs; `graph.py` computes only what is asked for and
its ancestors, each once.  The way to the motion is in `motions.py`; here is what is made of it.
To add one: write a function here and a line in `QUANTITIES`.  Heavy imports stand inside.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from coursework import motions
from coursework.geometry.closure import Closure
from coursework.integration.motion import Motion, Stop
from coursework.integration.rates import Rates
from coursework.reduction.blocks import Reduction
from coursework.reduction.equations import VelocityEquations
from coursework.reduction.solution import Solution
from coursework.reduction.solution import solutions as solve_blocks
from coursework.settings import Settings
from coursework.singular.scaled_flow import Flow
from coursework.variant.record import Variant

if TYPE_CHECKING:
    from coursework.checks.evidence import Evidence
    from coursework.checks.result import Check
    from coursework.kinematics.extra import ExtraTable
    from coursework.plans.graph_check import GraphCheck

Array = NDArray[np.float64]
Budget = tuple[tuple[str, str, float, float, float, float], ...]


def checks(
    variant: Variant, equations: VelocityEquations, motion: Motion, half: Motion | None, exact: Motion, wide: Array | None,
    closure: Closure | None, reduction: Reduction, flow: Flow,
) -> tuple[Check, ...]:  # fmt: skip
    """The checks of the page."""
    from coursework.checks.check import check_motion

    return check_motion(_evidence(variant, equations, motion, half, exact, wide, closure, reduction, flow))


def _evidence(
    variant: Variant, equations: VelocityEquations, motion: Motion, half: Motion | None, exact: Motion, wide: Array | None,
    closure: Closure | None, reduction: Reduction, flow: Flow,
) -> Evidence:  # fmt: skip
    from coursework.checks.evidence import Evidence, richardson
    from coursework.geometry.drive import fastest, is_sinusoidal

    known = exact if len(exact.t) == len(motion.t) else None
    return Evidence(
        variant, equations, motion, half, known, wide, closure, richardson(motion, half), reduction.used,
        fastest(equations), is_sinusoidal(equations), flow.fastest,
    )  # fmt: skip


def table(motion: Motion) -> Motion:
    """The results table: one row a step."""
    return motion


def solutions(equations: VelocityEquations, reduction: Reduction) -> tuple[Solution, ...]:
    """The velocities of every block as a textbook writes them."""
    return solve_blocks(equations, reduction)


def plots(motion: Motion, exact: Motion) -> tuple[Motion, Motion]:
    """What the plots show: the rows, and the exact motion behind them."""
    return motion, exact


def accelerations(equations: VelocityEquations, reduction: Reduction, motion: Motion) -> Array:
    """The accelerations of every row, from the differentiated equations."""
    from coursework.kinematics.accelerations import accelerations as compute

    return compute(equations, reduction, motion)


def points(equations: VelocityEquations, motion: Motion) -> tuple[tuple[str, ...], Array]:
    """Positions and velocities of the named points."""
    from coursework.kinematics.points import point_rows

    return point_rows(equations, motion)


def point_accelerations(equations: VelocityEquations, motion: Motion, accelerations: Array) -> tuple[tuple[str, ...], Array]:
    """Positions, velocities and accelerations of the named points."""
    from coursework.kinematics.points import point_rows

    return point_rows(equations, motion, accelerations)


def exact_accelerations(equations: VelocityEquations, reduction: Reduction, exact: Motion) -> Array:
    """The accelerations of the exact rows."""
    from coursework.kinematics.accelerations import accelerations as compute

    return compute(equations, reduction, exact)


def analogs(variant: Variant, exact: Motion, exact_accelerations: Array) -> ExtraTable:
    """Velocity and acceleration analogs of a crank-driven mechanism."""
    from coursework.kinematics.extra import analog_table

    return analog_table(variant, exact, exact_accelerations)


def invariants(variant: Variant, exact: Motion, exact_accelerations: Array) -> ExtraTable:
    """The invariants a_k, b_k, c_k of the slider."""
    from coursework.kinematics.extra import invariant_table

    return invariant_table(variant, exact, exact_accelerations)


def graph_check(equations: VelocityEquations, motion: Motion, exact: Motion) -> GraphCheck | None:
    """The check row drawn to scale: instantaneous centres and velocities beside the table."""
    from coursework.plans.graph_check import check_graph

    return check_graph(equations, motion, exact)


def accuracy(
    variant: Variant, rates: Rates, start: list[float], closure: Closure | None, exact: Motion, stop: Stop | None,
    settings: Settings, budget: Budget,
) -> Any:  # fmt: skip
    """What accuracy costs in evaluations: every scheme, projections, an adaptive pair, the exact closure (not timed)."""
    from coursework.accuracy.methods import Scene
    from coursework.accuracy.study import make_study

    if stop is not None or settings.columns:
        return None
    units = tuple(coordinate.unit for coordinate in variant.coordinates)
    scene = Scene(rates, start, variant.time.step, len(exact.t) - 1, closure, units)
    return make_study(scene, exact, budget, settings.scheme)


def budget(
    variant: Variant, equations: VelocityEquations, motion: Motion, half: Motion | None, exact: Motion, wide: Array | None,
    closure: Closure | None, reduction: Reduction, flow: Flow,
) -> Budget:  # fmt: skip
    """Last row minus first row of every coordinate: scheme error + period mismatch + round-off."""
    from coursework.checks.period import mismatch

    evidence = _evidence(variant, equations, motion, half, exact, wide, closure, reduction, flow)
    splits = mismatch(evidence) or ()
    return tuple((s.name, s.unit, s.total, s.scheme, s.period, s.roundoff) for s in splits if s.name in motion.coordinate_names)


QUANTITIES: dict[str, Any] = {
    rule.__name__: rule
    for rule in (
        motions.mechanism, motions.equations, motions.start, motions.closure, motions.reduction, motions.rates, motions.flow,
        motions.event, motions.stop, motions.phases, motions.motion, solutions, table, motions.half, motions.exact, motions.wide,
        checks, plots, accelerations, points, point_accelerations, exact_accelerations, analogs, invariants,
        budget, accuracy, graph_check,
    )
}  # fmt: skip
# What a file or a user may ask for by name; the others are steps on the way.
ASKABLE = ("table", "plots", "checks", "accelerations", "points", "analogs", "invariants", "accuracy", "graph_check")
DEFAULT = ("table", "plots", "checks")
# What can be had for some columns alone.
RESTRICTABLE = ("table", "plots")
