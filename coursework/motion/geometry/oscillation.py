"""How fast a drive oscillates, the highest harmonic that a table of it must not miss, and when steady cranks are back.

Enters: the drives of a scene.  Leaves: a frequency (rad/s).  Used by `way_to_motion.py`, `search.py` and `swings.py`.
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from coursework.equations.algebra.calculus import derivative, expand, replaced
from coursework.equations.algebra.expression import Expression, number
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import TIME, local, symbol
from coursework.motion.geometry.drive import values_of_time
from coursework.system.arrays import Array

# A harmonic counts from this part of the power of the largest one on: of abs(sin) the first, of sin cubed the third.
_POWER = 0.05
# Frequencies whose quotients are fractions of whole numbers up to this have a common period.
_WHOLE = 40
# Samples of a common period for each of its highest base frequency: harmonics up to half as many are told apart.
_SAMPLES = 32
# Times of the run at which an argument that does not grow evenly is looked at.
_LOOKS = 257


def fastest(equations: VelocityEquations) -> float:
    """Return the largest frequency (rad/s) in the drives that carries more than 5 % of the power of the strongest, 0 without any.

    >>> import coursework
    >>> round(fastest(coursework.solve("31").scene.equations), 6)
    13.08
    """
    found = [0.0]
    for law in equations.variant.drive:
        whole = written_out(equations.symbols.definitions[symbol(law.name)], equations)
        pieces = whole.args[1::2] if whole.op == "piecewise" else [whole]
        found += [_highest(piece, equations) for piece in pieces]
    return max(found)


def turns_repeat(equations: VelocityEquations) -> float:
    """Return the time (s) after which drives that are all constant have turned their cranks whole turns, infinity without any.

    What then stands as it began moves on as it did: the mechanism knows of no time but its drives.
    """
    variant = equations.variant
    definitions = [written_out(equations.symbols.definitions[symbol(law.name)], equations) for law in variant.drive]
    angles = {coordinate.rate for coordinate in variant.coordinates if coordinate.unit == "rad"}
    if any(definition.has(TIME) for definition in definitions) or not {law.name for law in variant.drive} <= angles:
        return math.inf
    rates = np.abs([float(values[0]) for values in values_of_time(equations, definitions, np.zeros(1)).T])
    base = _common(rates[rates > 0]) if np.any(rates > 0) else 0.0
    return 2 * math.pi / base if base else math.inf


def written_out(expr: Expression, equations: VelocityEquations) -> Expression:
    """Return a drive with the other drives it is written with in their places."""
    definitions = equations.symbols.definitions
    while names := expr.free_symbols & definitions.keys():
        expr = replaced(expr, {name: definitions[name] for name in names})
    return expr


def _highest(expr: Expression, equations: VelocityEquations) -> float:
    """Return the highest harmonic of one formula, or the steepest slope of an argument that does not grow evenly."""
    waves, slopes, even, still = equations.once(("waves", expr), lambda: _waves(expr))
    if not waves:
        return 0.0
    looks = np.linspace(0.0, equations.variant.time.end, _LOOKS)
    steepest = np.array([float(np.max(np.abs(values))) for values in values_of_time(equations, slopes, looks).T])
    if not even or not np.all(np.isfinite(steepest)):
        return float(np.max(steepest[np.isfinite(steepest)], initial=0.0))
    base = _common(steepest)
    if not base:
        # Without a common period each term is looked at alone; a product of two waves has their sum in it.
        terms = expand(expr).terms
        return max(_highest(term, equations) for term in terms) if len(terms) > 1 else float(np.sum(steepest))
    # What stands outside the waves (a factor exp(-t)) is no oscillation: it is taken as it is in the middle of the run.
    middle = number(Fraction(equations.variant.time.end / 2))
    wave = expr if still is None else replaced(replaced(still, {TIME: middle}), {dummy: wave for wave, dummy in waves})
    count = _SAMPLES * round(float(np.max(steepest)) / base)
    values = values_of_time(equations, [wave], 2 * np.pi / base * np.arange(count) / count)[:, 0]
    power = np.abs(np.fft.rfft(values)[1:]) ** 2
    if not np.all(np.isfinite(power)) or not np.max(power) > (1e-12 * count) ** 2:
        return float(np.max(steepest))
    return base * float(1 + np.flatnonzero(power > _POWER * np.max(power))[-1])


def _waves(expr: Expression) -> tuple[list[tuple[Expression, Expression]], list[Expression], bool, Expression | None]:
    """Return the waves of one formula and symbols for them, the slopes of their arguments, and whether all are constant.

    Last the formula with its symbols, None where time stands in the waves alone.
    """
    found = sorted(part for part in expr.walk() if part.op in {"sin", "cos", "tan"} and part.has(TIME))
    waves = [(wave, local(f"_wave{place}")) for place, wave in enumerate(found)]
    slopes = [derivative(wave.args[0], TIME) for wave in found]
    still = replaced(expr, dict(waves))
    return waves, slopes, not any(slope.has(TIME) for slope in slopes), still if still.has(TIME) else None


def _common(frequencies: Array) -> float:
    """Return the frequency of which all are whole multiples, 0 where there is none worth the name."""
    slowest = float(np.min(frequencies))
    if not slowest > 0:
        return 0.0
    parts = [Fraction(float(value) / slowest).limit_denominator(_WHOLE) for value in frequencies]
    base = slowest / math.lcm(*(part.denominator for part in parts))
    even = all(abs(float(part) * slowest - value) <= 1e-9 * value for part, value in zip(parts, frequencies, strict=True))
    return base if even and float(np.max(frequencies)) / base <= _WHOLE**2 else 0.0
