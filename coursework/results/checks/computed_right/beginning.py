"""STOP and START: the motion reaches its end; the start values close the mechanism.

Enters: `Evidence`.  Leaves: a `Finding` each.  Used by `check.py` and `commands/check.py`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.motion.geometry.closed_start import closed_start, typed_start
from coursework.motion.geometry.closure import Closure
from coursework.motion.geometry.gaps import gaps
from coursework.motion.geometry.judging.rigid import bent_by_start
from coursework.motion.integration.integrate import TOO_LARGE
from coursework.results.checks.evidence import Evidence
from coursework.results.checks.result import Finding, skipped
from coursework.system.arrays import Array
from coursework.variant.formula.tree import on_axes, signed, spelled
from coursework.variant.formula.units import size_of
from coursework.variant.record.entries import last_place
from coursework.variant.record.variant import Coordinate
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

_MOST_KEPT = 3  # number of sums that a sentence lists
_DIGITS = 12  # digits of a closed start: as many as anyone copies
START_LIMIT = 1e-6  # share of the largest length: start values with five digits pass


def stopped(evidence: Evidence) -> Finding:
    """The mechanism can make the whole motion, and the scheme does not step out of it."""
    stop = evidence.motion.stop
    search = evidence.search
    given_up = search.given_up if search is not None and not search.goes_round else None
    if stop is None and given_up is not None:
        told = say("check.STOP.given_up", rows=len(evidence.motion.t), time=given_up)
        return replace(skipped(told), headline=told)
    if stop is None and evidence.variant.motor is None and not (evidence.restricted or _moves(evidence)):
        told = say("check.STOP.still", rows=len(evidence.motion.t))
        return replace(skipped(told), headline=told)
    if stop is None:
        return Finding("PASS", say("check.STOP.pass", rows=len(evidence.motion.t)))
    row = int(stop.row) + 1
    # A dead or change point belongs to the mechanism; a step too large to the scheme: a smaller one gives all rows.
    own = stop.kind == TOO_LARGE and evidence.stop is None
    return Finding("COARSE" if own else "FAIL", stop.sentence, stop.time, evidence.variant.time.end, "s", None, row)


def _moves(evidence: Evidence) -> bool:
    """Return whether a velocity is not zero in some row, or something has moved between two rows, in a pulse that none shows."""
    if np.any(evidence.motion.velocities):
        return True
    rows = [motion for motion in (evidence.motion, evidence.exact) if len(motion.t)]
    return any(
        np.any(np.ptp(each.coordinates, axis=0) > [evidence.least(name) for name in each.coordinate_names]) for each in rows
    )


def start(evidence: Evidence) -> Finding:
    """The start values close the mechanism; where they do not, the nearest closed start is printed."""
    return start_of(evidence.closure)


def start_of(given: Closure | None) -> Finding:
    """Return the finding of START for a closure, before any row of a table."""
    closure = _with_loops(given) if given is not None else None
    if given is None or closure is None:
        told = _kept(given) or say("check.START.skip")
        return Finding("SKIP", told, unjudged=say("summary.start"), headline=_beside_datum(given))
    _, closed = closed_start(closure)
    residual = _gaps(closure)
    worst = int(np.argmax(np.abs(residual)))
    value, name = float(np.abs(residual[worst])), closure.names[worst]
    limit = START_LIMIT * closure.scale
    if value <= limit:
        kept = _kept(given)
        told = say("check.START.pass_kept", kept=kept) if kept is not None else say("check.START.pass")
        return Finding("PASS", told, value, limit, "m", name, 1, headline=_beside_datum(given))
    # A length that should be zero, but is kept as the start has it, may be what no position fits.
    sentence = joined([say("check.START.none", value=value), *([kept] if (kept := _kept(closure)) else [])])
    if closed is not None:
        key = "check.START.nearest_held" if abs(given.origin[worst]) > limit else "check.START.nearest"
        sentence = say(key, value=value, start=typed_start(closure.equations.variant, closed, _DIGITS))
    allowed = _rounding(closure, worst)
    if value <= allowed:
        told = joined([sentence, say("check.START.rounded", allowed=allowed)])
        return Finding("COARSE", told, value, limit, "m", name, 1)
    return Finding("FAIL", sentence, value, limit, "m", name, 1)


def _rounding(closure: Closure, worst: int) -> float:
    """Return how far (m) the rounding of the start values alone may open an equation: each by half of its last decimal.

    What is driven, and a value without decimals, is what the author meant.
    """
    variant = closure.equations.variant
    halves = [0.0 if c.rate in variant.known_rates else _half_a_decimal(c) for c in variant.coordinates]
    q = closure.start + np.vstack([np.zeros(len(halves)), np.diag(halves)])
    open_by = gaps(closure, np.zeros(len(q)), q, np.tile(closure.origin, (len(q), 1)))[:, worst]
    return float(np.abs(open_by[1:] - open_by[0]).sum())


def _half_a_decimal(coordinate: Coordinate) -> float:
    """Return half of the last decimal (rad or m) of a start value as it is typed, 0 if it has none."""
    return 0.5 * last_place(coordinate.text) * (size_of(coordinate.written) or 1.0) if "." in coordinate.text else 0.0


def _kept(closure: Closure | None) -> Sentence | None:
    """Return which lengths written as sums keep a value that only the start gives; None if all are zero.

    A sum of angles, such as that of two gears, keeps any value.
    """
    kept = _lengths(closure)
    return say("check.START.kept", values=_listed(kept)) if kept else None


def _lengths(closure: Closure | None) -> list[tuple[str, float]]:
    """Return the lengths written as sums that keep a value which only the start gives, each with this value (m)."""
    if closure is None:
        return []
    rows, limit = zip(closure.equations.positions, closure.origin.tolist(), strict=True), START_LIMIT * closure.scale
    return [(one.told, value) for one, value in rows if one.written and one.unit != "rad" and abs(value) > limit]


def _listed(kept: list[tuple[str, float]]) -> Sentence:
    listed = [say("check.START.value", name=name, value=value) for name, value in kept[:_MOST_KEPT]]
    return joined([*listed, *(["…"] if len(kept) > _MOST_KEPT else [])], "join.numbers")


def _beside_datum(closure: Closure | None) -> Sentence | str:
    """Return what to say first if a datum is a term of such a sum, as in "B.y - e": the datum most likely gives its value."""
    if closure is None:
        return ""
    variant = closure.equations.variant
    data = {*variant.values}
    beside = {
        spelled(plain)
        for plain in map(on_axes, variant.holds)
        if any(term.names() and data.issuperset(term.names()) for term, _ in signed(plain))
    }
    kept = [one for one in _lengths(closure) if one[0] in beside]
    return say("summary.start_offset", values=_listed(kept)) if kept else ""


def _with_loops(closure: Closure) -> Closure | None:
    """Return the closure with its closed loops of [closure] held at zero, not at the start; None if nothing has to be zero.

    x - r*cos(phi), which says nothing by itself, is a link too if A(x, y) would not keep its distance else.
    """
    zero = [one.closes for one in closure.equations.positions]
    if not any(zero) or not _is_open(closure.at_zero(zero)):
        bent = bent_by_start(closure.equations, closure)
        zero = [one or place in bent for place, one in enumerate(zero)]
    return closure.at_zero(zero) if any(zero) else None


def _gaps(closure: Closure) -> Array:
    """Return how far the equations (k,) are open at the start, in m or rad."""
    return gaps(closure, np.zeros(1), closure.start[None], closure.origin[None]).ravel()


def _is_open(closure: Closure) -> bool:
    return bool(np.max(np.abs(_gaps(closure))) > START_LIMIT * closure.scale)
