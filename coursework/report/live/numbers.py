"""The numbers from which a page computes by itself: names, start, times, schemes, tables of laws.

Enters: a `SceneRun` and the `Functions` of its mechanism.  Leaves: plain data for JSON, SI throughout.
Used by the live page and by the test that runs every variant of the catalogue in a browser.
"""

from __future__ import annotations

from typing import Any

from coursework.equations.reduction.blocks import angles_in_determinants
from coursework.motion.geometry.drive import breaks
from coursework.motion.integration.integrate import WIDEST_STEP
from coursework.motion.schemes import DEFAULT_SCHEME, PRECISE, SCHEMES, Scheme, Sum
from coursework.report.live.functions import Functions
from coursework.scene.scene_run import SceneRun


def live_numbers(run: SceneRun, functions: Functions) -> dict[str, Any]:
    """Return the numbers of a run by key; `scheme` is the one its page begins with, `precise` the one of the true motion.

    `stop` is the time (s) at which the mechanism itself stops, None where it does not; `own`: the table of the page is made by a
    scheme and nothing else, as the page makes its tables.
    """
    scene, variant = run.scene, run.variant
    angles = angles_in_determinants(scene.reduction.blocks, scene.equations)
    return {
        "coordinates": [c.name for c in variant.coordinates],
        "velocities": [*variant.rates, *(name for name, _ in variant.unknowns)],
        "units": {name: variant.unit_of(name) for name in variant.columns},
        "shown": list(run.motion.names),
        "start": scene.start,
        "step": run.step,
        "end": variant.time.end,
        "rows": len(run.motion.t),
        "given": variant.values,
        "numbers": list(functions.numbers),
        "closed": functions.closed,
        "moved": list(functions.moved),
        "followed": list(functions.followed),
        "tables": functions.tables,
        "determinants": len(scene.reduction.blocks),
        "guarded": [place for place, c in enumerate(variant.coordinates) if c.name in angles],
        "widest": WIDEST_STEP,
        "breaks": list(breaks(variant)),
        "stop": None if scene.stop is None else scene.stop.time,
        "schemes": {scheme.name: _tableau(scheme) for scheme in SCHEMES.values()},
        "scheme": run.scheme if run.scheme in SCHEMES else DEFAULT_SCHEME.name,
        "own": run.scheme in SCHEMES and scene.correction is None,
        "precise": PRECISE.name,
    }


def _tableau(scheme: Scheme) -> dict[str, Any]:
    """Return a tableau with the common factor of each row taken out, fractions as pairs of whole numbers."""
    nodes = [[node.numerator, node.denominator] for node in scheme.nodes]
    return {"order": scheme.order, "nodes": nodes, "inner": [*map(_row, scheme.inner)], "outer": _row(scheme.outer)}


def _row(row: Sum) -> dict[str, Any]:
    return {"factor": [row.factor.numerator, row.factor.denominator], "terms": [*map(list, row.terms)]}
