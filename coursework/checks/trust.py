"""CONDITION and PEAK: how many digits the equations leave, and whether the step is short enough for the fastest link."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from coursework.checks.evidence import ONLY_SOME, Evidence
from coursework.checks.result import Check, Verdict
from coursework.march.integrate import TOO_LARGE, WIDEST_STEP
from coursework.reduction.magnitude import largest
from coursework.reduction.system import compile_system
from coursework.reduction.tidy import as_formula

Array = NDArray[np.float64]
# A double has sixteen digits; six of them are more than any table of the coursework shows.
DIGITS, FEWEST = 16.0, 6.0
# Ruiz' scaling has settled to a few percent after this many rounds, and the condition number wants no more.
_ROUNDS = 8


def condition(evidence: Evidence) -> Check:
    """The equations leave at least six of sixteen digits in every row: 16 - log10 of their condition number."""
    motion, variant = evidence.motion, evidence.variant
    if evidence.restricted:
        return Check("CONDITION", "Trustworthy digits", "SKIP", ONLY_SOME)
    used = [equation for equation in evidence.equations.equations if equation.name in evidence.used]
    if not used:
        return Check("CONDITION", "Trustworthy digits", "SKIP", "There is nothing to solve for.")
    system = compile_system(evidence.equations, used)
    matrix, _, _ = system.matrices(motion.t, motion.coordinates)
    sizes = np.max(np.abs(matrix), axis=0)
    for row, equation in enumerate(used):
        for name, coefficient in equation.coefficients.items():
            column = system.unknowns.index(name)
            sizes[row, column] = max(sizes[row, column], largest(as_formula(coefficient, evidence.equations.order), variant))
    numbers = np.linalg.cond(equilibrated(matrix, sizes))
    worst = int(np.argmax(numbers))
    digits = float(np.clip(DIGITS - np.log10(numbers[worst]), 0.0, DIGITS)) if np.isfinite(numbers[worst]) else 0.0
    verdict: Verdict = "PASS" if digits >= FEWEST else "FAIL"
    sentence = (
        f"The equations leave {digits:.1f} of 16 digits in row {worst + 1} (t = {motion.t[worst]:.6g} s), the worst one: "
        f"their condition number is {numbers[worst]:.3g} there, rows and columns equilibrated."
    )
    if verdict == "FAIL":
        sentence += " The mechanism is too close to a dead or change point for its velocities to mean much."
    rows = (("condition number, worst row", float(numbers[worst]), ""), ("condition number, first row", float(numbers[0]), ""))
    return Check("CONDITION", "Trustworthy digits", verdict, sentence, digits, FEWEST, "digits", rows)


def equilibrated(matrix: Array, sizes: Array) -> Array:
    """Return the matrices (r, n, n) with rows and columns scaled alike in all r of them.

    `sizes` (n, n): the largest values the entries can take, not those they have: a micrometre beside a metre (hard case H17)
    is no bad condition, and a row that vanishes (a dead point) is.  Source: D. Ruiz, RAL-TR-2001-034.
    """
    down, across = np.ones(sizes.shape[0]), np.ones(sizes.shape[1])
    for _ in range(_ROUNDS):
        scaled = sizes / down[:, None] / across
        down = down * np.sqrt(_or_one(np.max(scaled, axis=1)))
        across = across * np.sqrt(_or_one(np.max(scaled, axis=0)))
    return np.asarray(matrix / down[:, None] / across)


def _or_one(sizes: Array) -> Array:
    return np.where(sizes > 0, sizes, 1.0)


def peak(evidence: Evidence) -> Check:
    """No link turns by more than one radian in one step, also where it is fastest between two rows."""
    variant, step = evidence.variant, evidence.motion.step
    stop = evidence.motion.stop
    if (stop is not None and stop.kind != TOO_LARGE) or not evidence.fastest:
        return Check("PEAK", "Fastest link", "SKIP", "The motion stops, and near its end the velocities grow without bound.")
    turning = [
        (rate, when, coordinate)
        for (rate, when), coordinate in zip(evidence.fastest, variant.coordinates, strict=True)
        if coordinate.unit == "rad"
    ]
    if not turning:
        return Check("PEAK", "Fastest link", "SKIP", "No coordinate is an angle.")
    rate, when, coordinate = max(turning, key=lambda entry: entry[0])
    turned = rate * step
    sentence = (
        f"{coordinate.rate} is largest at t = {when:.6g} s: {rate:.4g} rad/s, {turned:.3g} rad of {coordinate.name} in one step"
    )
    if turned <= WIDEST_STEP:
        return Check("PEAK", "Fastest link", "PASS", f"{sentence}.", turned, WIDEST_STEP, "rad")
    sentence += f"; the rows step over that. Take a step of at most {WIDEST_STEP / rate:.2g} s."
    return Check("PEAK", "Fastest link", "FAIL", sentence, turned, WIDEST_STEP, "rad")
