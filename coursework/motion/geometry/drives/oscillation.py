"""How fast a drive oscillates, the highest harmonic that a table must resolve, and when cranks of constant speed are back.

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
from coursework.motion.geometry.drives.drive import values_of_time
from coursework.system.arrays import Array
from coursework.variant.record.entries import Law

# A harmonic counts if it has at least this share of the strongest one's power: the first of abs(sin), the third of sin cubed.
_POWER = 0.05
# Frequencies have a common period if their ratios are fractions of whole numbers up to this.
_WHOLE = 40
# Samples of a common period for each multiple of the base frequency in the fastest wave; harmonics up to half as many show.
_SAMPLES = 32
# Number of times in the run at which the slope of an argument is evaluated.
_LOOKS = 257


def fastest(equations: VelocityEquations) -> float:
    """Return the highest frequency (rad/s) in the drives that has over 5 % of the strongest one's power; 0 without any.

    >>> import coursework
    >>> round(fastest(coursework.solve("31").scene.equations), 6)
    13.08
    """
    found = [0.0]
    for law in equations.variant.drive:
        whole = written_out(law, equations)
        pieces = whole.args[1::2] if whole.op == "piecewise" else [whole]
        found += [_highest(piece, equations) for piece in pieces]
    return max(found)


def turns_repeat(equations: VelocityEquations) -> float:
    """Return the time (s) after which constant drives have turned their cranks by whole turns; infinity if there is no such time.

    A mechanism that is then back in its start position repeats its motion, because only the drives depend on time.
    """
    variant = equations.variant
    definitions = [written_out(law, equations) for law in variant.drive]
    angles = {coordinate.rate for coordinate in variant.coordinates if coordinate.unit == "rad"}
    if any(definition.has(TIME) for definition in definitions) or not {law.name for law in variant.drive} <= angles:
        return math.inf
    rates = np.abs([float(values[0]) for values in values_of_time(equations, definitions, np.zeros(1)).T])
    base = _common(rates[rates > 0]) if np.any(rates > 0) else 0.0
    return 2 * math.pi / base if base else math.inf


def written_out(law: Law, equations: VelocityEquations) -> Expression:
    """Return the formula of a drive with the other drives in it replaced by their formulas."""
    definitions = equations.symbols.definitions
    expr = definitions[symbol(law.name)]
    while names := expr.free_symbols & definitions.keys():
        expr = replaced(expr, {name: definitions[name] for name in names})
    return expr


def _highest(expr: Expression, equations: VelocityEquations) -> float:
    """Return the highest harmonic of one formula, or the steepest slope of an argument that is not linear in time."""
    waves, slopes, even, still = equations.once(("waves", expr), lambda: _waves(expr))
    if not waves:
        return 0.0
    looks = np.linspace(0.0, equations.variant.time.end, _LOOKS)
    steepest = np.array([float(np.max(np.abs(values))) for values in values_of_time(equations, slopes, looks).T])
    if not even or not np.all(np.isfinite(steepest)):
        return float(np.max(steepest[np.isfinite(steepest)], initial=0.0))
    base = _common(steepest)
    if not base:
        # Without a common period each term is examined alone; a product of two waves contains the sum of their frequencies.
        terms = expand(expr).terms
        return max(_highest(term, equations) for term in terms) if len(terms) > 1 else float(np.sum(steepest))
    if len(waves) == 1 and waves[0][0].op != "tan" and [part for part in expr.factors if part.has(TIME)] == [waves[0][0]]:
        return base  # a single wave, as most drives are: sampling it would only load NumPy's transforms
    # A factor outside the waves, such as exp(-t), is no oscillation: it is frozen at the middle of the run.
    middle = number(Fraction(equations.variant.time.end / 2))
    wave = expr if still is None else replaced(replaced(still, {TIME: middle}), {dummy: wave for wave, dummy in waves})
    count = _SAMPLES * round(float(np.max(steepest)) / base)
    values = values_of_time(equations, [wave], 2 * np.pi / base * np.arange(count) / count)[:, 0]
    power = np.abs(np.fft.rfft(values)[1:]) ** 2
    if not np.all(np.isfinite(power)) or not np.max(power) > (1e-12 * count) ** 2:
        return float(np.max(steepest))
    return base * float(1 + np.flatnonzero(power > _POWER * np.max(power))[-1])


def _waves(expr: Expression) -> tuple[list[tuple[Expression, Expression]], list[Expression], bool, Expression | None]:
    """Return the waves of one formula with a symbol for each, the slopes of their arguments, and whether all slopes are constant.

    The last value is the formula written with these symbols; None if time occurs only inside the waves.
    """
    found = sorted(part for part in expr.walk() if part.op in {"sin", "cos", "tan"} and part.has(TIME))
    waves = [(wave, local(f"_wave{place}")) for place, wave in enumerate(found)]
    slopes = [derivative(wave.args[0], TIME) for wave in found]
    still = replaced(expr, dict(waves))
    return waves, slopes, not any(slope.has(TIME) for slope in slopes), still if still.has(TIME) else None


def _common(frequencies: Array) -> float:
    """Return the frequency of which all given ones are whole multiples; 0 if there is none of useful size."""
    slowest = float(np.min(frequencies))
    if not slowest > 0:
        return 0.0
    parts = [Fraction(float(value) / slowest).limit_denominator(_WHOLE) for value in frequencies]
    base = slowest / math.lcm(*(part.denominator for part in parts))
    even = all(abs(float(part) * slowest - value) <= 1e-9 * value for part, value in zip(parts, frequencies, strict=True))
    return base if even and float(np.max(frequencies)) / base <= _WHOLE**2 else 0.0
