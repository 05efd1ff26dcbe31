"""The phases of the drive with which the whole motion would be possible.

Enters: a scene whose motion stops.  Leaves: a sentence, empty if the drive has no phase among the data.
It is only for the reader of a stop: some fifty searches with a coarser tolerance than the search for the stop itself.
Used by `way_to_motion.py`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

from coursework.equations.reduction.blocks import Reduction
from coursework.equations.reduction.equations import VelocityEquations
from coursework.motion.geometry.drives.drive import breaks
from coursework.motion.singular.scaled_flow import compile_flow
from coursework.motion.singular.search import search_event
from coursework.variant.formula.tree import terms
from coursework.variant.record.variant import Variant
from coursework.words.sentences import joined, say

# With a coarser tolerance, a motion that passes close to a dead point would be taken for one that meets it.
TOLERANCE = 1e-9
_SAMPLES = 24
_HALVINGS = 12


def phase_sentence(equations: VelocityEquations, reduction: Reduction, start: list[float]) -> str:
    """Return e.g. "The whole motion is possible for 1.5929 < alpha < 4.6903 (rad, modulo 2π)."; empty without a phase."""
    variant = equations.variant
    name = _phase_of(variant)
    if not name:
        return ""

    def possible(value: float) -> bool:
        flow = compile_flow(replace(equations, variant=variant.with_values({name: value})), reduction, start)
        return search_event(flow, start, variant.time.end, tolerance=TOLERANCE, breaks=breaks(variant)).event is None

    now = next(g.value for g in variant.given if g.name == name)
    intervals = _intervals(possible, now)
    if not intervals:
        return say("phase.none", name=name)
    ranges = joined([say("phase.range", low=low, name=name, high=high) for low, high in intervals], "join.or")
    return say("phase.possible", ranges=ranges, name=name, now=now)


def _phase_of(variant: Variant) -> str:
    """Return the given angle that is added to the argument of a sine or cosine of time in the drive; empty if there is none."""
    angles = {g.name for g in variant.given if g.si in {"rad", ""}}
    nodes = [node for law in variant.drive for formula in law.formulas for node in formula.walk()]
    waves = [node for node in nodes if node.op == "call" and node.name in {"sin", "cos"} and "t" in node.names()]
    names = (part.name for wave in waves for part in terms(wave.args[0]) if part.op == "name")
    return next((name for name in names if name in angles), "")


def _intervals(possible: Callable[[float], bool], stops: float) -> list[tuple[float, float]]:
    """Return the ranges of what is possible; the phase at which the motion `stops` may be all between two samples that is not."""
    turn = 2 * math.pi
    stops %= turn
    values = sorted({stops, *(turn * (i + 0.5) / _SAMPLES for i in range(_SAMPLES))})
    verdicts = [value != stops and possible(value) for value in values]
    edges = []
    for i, verdict in enumerate(verdicts):
        if verdict != verdicts[i - 1]:
            bad, good = values[i - 1] - (turn if i == 0 else 0.0), values[i]
            if not verdict:
                bad, good = good, bad
            for _ in range(_HALVINGS):
                middle = (bad + good) / 2
                bad, good = (bad, middle) if possible(middle) else (middle, good)
            edges.append((good, verdict))
    lows = [edge for edge, rising in edges if rising]
    highs = [edge for edge, rising in edges if not rising]
    return [(low, min((high if high > low else high + turn) for high in highs)) for low in lows]
