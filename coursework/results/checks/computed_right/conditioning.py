"""CONDITION and PEAK: how many digits the equations leave, and whether the step is short enough for the fastest angle.

Enters: `Evidence`.  Leaves: a `Finding` each, and the condition of each row.  Used by `check.py`, `equations.py`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.magnitude import largest
from coursework.equations.reduction.system import compile_system
from coursework.equations.reduction.tidying.tidy import as_formula
from coursework.motion.integration.integrate import WIDEST_STEP
from coursework.results.checks.computed_right.divided import DIGITS, FEWEST, divisions
from coursework.results.checks.evidence import LIMIT, Evidence
from coursework.results.checks.result import Finding, floored, skipped
from coursework.system.arrays import Array
from coursework.variant.formula.tree import Formula
from coursework.words.sentences import joined, say

# Ruiz' scaling settles to a few percent after this many rounds, which is enough for a condition number.
_ROUNDS = 8
_ROUNDING = 1e-9
# Share of the largest length: a slide that is smaller in every row counts as zero.
_NONE = 1e-12
# Number of extra digits that lengths far apart must cost, beyond the equations, to be worth a sentence.
_TOLD_APART = 2.0


def condition(evidence: Evidence) -> Finding:
    """The equations leave at least six of sixteen digits in every row: 16 - log10 of their condition number."""
    return evidence.once("condition", lambda: _condition(evidence), of_rows=True)


def _condition(evidence: Evidence) -> Finding:
    if not any(equation.name in evidence.used for equation in evidence.equations.equations):
        return skipped(say("check.CONDITION.nothing"))
    found = _of_equations(evidence)
    divided = min(divisions(evidence), key=lambda one: one.digits, default=None)
    if divided is None:
        return found
    known = {"name": divided.equation, "by": divided.by, "row": divided.row, "time": divided.time}
    if divided.digits < FEWEST:
        told, unit = say("check.CONDITION.nothing_left", **known), say("unit.digits", number=divided.digits)
        return Finding("FAIL", told, divided.digits, FEWEST, unit, None, divided.row, headline=told)
    told = say("check.CONDITION.divided", after=divided.row + 1, **known)
    is_close = not divided.is_own and evidence.compared and np.max(np.abs(evidence.errors), initial=0.0) <= LIMIT
    return replace(found, sentence=joined([found.sentence, told]), headline="" if is_close else told)


def condition_numbers(evidence: Evidence) -> Array:
    """Return the condition number of the equations solved in each row (n,)."""
    return evidence.once("condition numbers", lambda: _condition_numbers(evidence), of_rows=True)


def _condition_numbers(evidence: Evidence) -> Array:
    motion, variant = evidence.motion, evidence.variant
    used = [equation for equation in evidence.equations.equations if equation.name in evidence.used]
    system = compile_system(evidence.equations, used)
    matrix, _, _ = system.matrices(motion.t, motion.coordinates)
    sizes = np.max(np.abs(matrix), axis=0)
    for row, equation in enumerate(used):
        for name, coefficient in equation.coefficients.items():
            column = system.unknowns.index(name)
            sizes[row, column] = max(sizes[row, column], largest(_formula(coefficient, evidence.equations), variant))
    numbers = np.asarray(np.linalg.cond(equilibrated(matrix, sizes)))
    for passage in evidence.passages:  # there the limit is known, and nothing is solved
        numbers[passage.is_at(motion.t)] = 1.0
    return numbers


def _of_equations(evidence: Evidence) -> Finding:
    motion, numbers = evidence.motion, condition_numbers(evidence)
    worst = int(np.argmax(numbers))
    largest_number, first_number = float(numbers[worst]), float(numbers[0])
    digits = float(np.clip(DIGITS - np.log10(numbers[worst]), 0.0, DIGITS)) if np.isfinite(numbers[worst]) else 0.0
    when = float(motion.t[worst])
    left = _of_positions(evidence)
    if left is not None and left[0] < min(digits, left[3]) - _TOLD_APART:
        return _far_apart(evidence, *left[:3])
    told = floored(digits, 1)  # rounded down: what is shown as 6.0 passes, what fails is shown as 5.9
    sentence = say("check.CONDITION.found", digits=told, row=worst + 1, time=when, number=largest_number)
    rows = (say("check.CONDITION.worst"), largest_number, ""), (say("check.CONDITION.first"), first_number, "")
    unit = say("unit.digits", number=digits)
    if digits >= FEWEST:
        return Finding("PASS", sentence, digits, FEWEST, unit, None, worst + 1, rows=rows)
    return Finding("FAIL", joined([sentence, say("check.CONDITION.close")]), digits, FEWEST, unit, None, worst + 1, rows=rows)


def _far_apart(evidence: Evidence, digits: float, row: int, name: str) -> Finding:
    when = float(evidence.motion.t[row])
    passes = digits >= FEWEST
    found = say("check.CONDITION.lengths", digits=floored(digits, 1), row=row + 1, name=name, time=when)
    found = joined([found, say("check.CONDITION.lengths_pass" if passes else "check.CONDITION.lengths_fail")])
    return Finding("PASS" if passes else "FAIL", found, digits, FEWEST, say("unit.digits", number=digits), name, row + 1)


def _of_positions(evidence: Evidence) -> tuple[float, int, str, float] | None:
    """Return the fewest digits that the position equations leave of a coordinate, its row (from 0) and name; None if unknown.

    With them go the digits that would be left there if all lengths were alike: a singular position leaves few of any lengths.
    Each equation is a sum of lengths, known to a rounding error of the largest; this error may turn a short link.
    """
    closure, motion = evidence.closure, evidence.motion
    if closure is None or len(closure.names) != len(closure.free) or not closure.free:
        return None
    named = {position.name: position.expression for position in evidence.equations.positions}
    terms = np.array([largest(_formula(named[name], evidence.equations), evidence.variant) for name in closure.names])
    _, jacobian = closure.residual(motion.t, motion.coordinates, closure.origin)
    whole = np.isfinite(jacobian).all(axis=(1, 2))
    for passage in evidence.passages:
        whole &= ~passage.is_at(motion.t)
    rows = np.flatnonzero(whole)
    try:
        open_by = np.maximum(terms, np.abs(closure.origin)) * 10.0**-DIGITS
        moved = np.abs(np.linalg.inv(jacobian[rows])) @ open_by
    except np.linalg.LinAlgError:
        return None
    if not len(rows):
        return None
    coordinates = [evidence.variant.coordinates[place] for place in closure.free]
    sizes = np.max(np.abs(motion.coordinates[:, closure.free]), axis=0)
    # A slide that is zero in every row, apart from round-off, has no digits to lose.
    sizes = np.where(
        [one.unit == "rad" for one in coordinates], 1.0, np.where(sizes > _NONE * closure.scale, sizes, closure.scale)
    )
    row, place = np.unravel_index(int(np.argmax(moved / sizes)), moved.shape)
    digits = -np.log10(max(float(moved[row, place] / sizes[place]), 10.0**-DIGITS))
    alike = np.linalg.svd(equilibrated(jacobian[rows], np.max(np.abs(jacobian[rows]), axis=0)), compute_uv=False)[row]
    lost = float(np.log10(max(alike[0], 1.0) / alike[-1]))  # a position at which every slope is small is singular, too
    return float(np.clip(digits, 0.0, DIGITS)), int(rows[row]), coordinates[place].name, DIGITS - lost


def _formula(coefficient: Expression, equations: VelocityEquations) -> Formula:
    return equations.once(("formula", coefficient), lambda: as_formula(coefficient, equations.order))


def equilibrated(matrix: Array, sizes: Array) -> Array:
    """Return the matrices (r, n, n) with rows and columns scaled by the same factors in all r of them.

    `sizes` (n, n) are the largest values the entries can take, not their actual values: a micrometre beside a metre (hard case
    H17) is no bad condition, but a vanishing row (a dead point) is.  Source: D. Ruiz, RAL-TR-2001-034.
    """
    down, across = np.ones(sizes.shape[0]), np.ones(sizes.shape[1])
    for _ in range(_ROUNDS):
        scaled = sizes / down[:, None] / across
        down = down * np.sqrt(_or_one(np.max(scaled, axis=1)))
        across = across * np.sqrt(_or_one(np.max(scaled, axis=0)))
    return np.asarray(matrix / down[:, None] / across)


def _or_one(sizes: Array) -> Array:
    return np.where(sizes > 0, sizes, 1.0)


def peak(evidence: Evidence) -> Finding:
    """No integrated angle moves more than one radian within any interval of one step, back and forth added up.

    A wheel whose angle is not integrated may turn faster: no row steps over anything because of it.
    """
    variant, step, search = evidence.variant, evidence.motion.step, evidence.search
    if search is not None and search.given_up is not None:
        return skipped(evidence.say("check.PEAK.given_up", time=search.given_up))
    turning = [place for place, coordinate in enumerate(variant.coordinates) if coordinate.unit == "rad"]
    if evidence.stop is not None or search is None or not (fastest := search.fastest(turning)):
        return skipped(evidence.say("check.PEAK.stopped"))
    if not turning:
        return skipped(evidence.say("check.PEAK.no_angle"))
    turned, place = max((search.way_within(place)(step), place) for place in turning)
    (rate, when), coordinate = fastest[place], variant.coordinates[place]
    moment, rate = _moment(evidence, coordinate.rate, rate, when)
    found = {"rate": coordinate.rate, "moment": moment, "value": rate, "turned": turned, "name": coordinate.name}
    if turned <= WIDEST_STEP * (1 + _ROUNDING):
        return Finding("PASS", evidence.say("check.PEAK.pass", **found), turned, WIDEST_STEP, "rad", coordinate.rate)
    most = 0.0 if evidence.is_trial else search.longest_step(place, WIDEST_STEP, step)
    return Finding("COARSE", evidence.say("check.PEAK.coarse", **found, step=most), turned, WIDEST_STEP, "rad", coordinate.rate)


def _moment(evidence: Evidence, name: str, size: float, when: float | None) -> tuple[str, float]:
    """Return what is said of a rate at its largest `size`, and its value.

    Its time says nothing where it is constant, for a while or throughout; a drive in pieces may turn it back at the same speed.
    """
    rates = evidence.motion.column(name) if name in evidence.motion.names else np.zeros(0)
    if when is not None:
        held = np.append(np.isclose(np.abs(rates), size, rtol=_ROUNDING, atol=0.0), False)
        first = int(np.argmax(held))
        last = first + int(np.argmin(held[first:]))
        if last - first < 2:  # one row is a moment
            return evidence.say("check.PEAK.moment", time=when), size
        return evidence.say("check.PEAK.held", first=first + 1, last=last), size
    least, most = np.min(rates, initial=0.0), np.max(rates, initial=0.0)
    if least < 0 < most:
        return evidence.say("check.PEAK.size"), size
    return evidence.say("check.PEAK.constant"), -size if least < 0 else size
