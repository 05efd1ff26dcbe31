"""Embedded pairs that choose their own step: Dormand and Prince 5(4), and 8(5,3) where twelve digits are wanted.

Enters: a vector field.  Leaves: one accepted step at a time.  Used by `singular` and the accuracy study.
Source: J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math. 6 (1980);
E. Hairer, S. P. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I", 1993, II.10 (DOP853).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Field = Callable[[float, Array], Array]

_NODES = (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0)
_ROWS = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
_ERROR = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)
_WEIGHTS = [np.array(row) for row in _ROWS]
_DIFFERENCE = np.array(_ERROR)
SLOPES = 6  # new slopes a step: the last one is the first of the next step


@dataclass(frozen=True, slots=True)
class Step:
    """`state` after the step, its estimated `error` (same shape), the slope there."""

    state: Array
    error: Array
    slope: Array


def dormand_prince(field: Field, at: float, state: Array, slope: Array, length: float) -> Step:
    """Return one step of the pair from `state` with known `slope` = field(at, state)."""
    slopes = np.empty((len(_NODES), len(state)))
    slopes[0] = slope
    point = state
    for index in range(1, len(_NODES)):
        point = state + length * (_WEIGHTS[index] @ slopes[:index])
        slopes[index] = field(at + _NODES[index] * length, point)
    return Step(point, length * (_DIFFERENCE @ slopes), slopes[-1])


# The pair of order eight, place: weight in each row.
_NODES_8 = (0.0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 1 / 3, 0.25, 4 / 13,
            127 / 195, 0.6, 6 / 7, 1.0)  # fmt: skip
_ROWS_8: tuple[dict[int, float], ...] = (
    {},
    {0: 0.05260015195876773},
    {0: 0.0197250569845379, 1: 0.0591751709536137},
    {0: 0.02958758547680685, 2: 0.08876275643042054},
    {0: 0.2413651341592667, 2: -0.8845494793282861, 3: 0.924834003261792},
    {0: 1 / 27, 3: 0.17082860872947386, 4: 0.12546768756682242},
    {0: 0.037109375, 3: 0.17025221101954405, 4: 0.06021653898045596, 5: -0.017578125},
    {0: 0.03709200011850479, 3: 0.17038392571223998, 4: 0.10726203044637328, 5: -0.015319437748624402,
     6: 0.008273789163814023},
    {0: 0.6241109587160757, 3: -3.3608926294469414, 4: -0.868219346841726, 5: 27.59209969944671, 6: 20.154067550477894,
     7: -43.48988418106996},
    {0: 0.47766253643826434, 3: -2.4881146199716677, 4: -0.590290826836843, 5: 21.230051448181193, 6: 15.279233632882423,
     7: -33.28821096898486, 8: -0.020331201708508627},
    {0: -0.9371424300859873, 3: 5.186372428844064, 4: 1.0914373489967295, 5: -8.149787010746927, 6: -18.52006565999696,
     7: 22.739487099350505, 8: 2.4936055526796523, 9: -3.0467644718982196},
    {0: 2.273310147516538, 3: -10.53449546673725, 4: -2.0008720582248625, 5: -17.9589318631188, 6: 27.94888452941996,
     7: -2.8589982771350235, 8: -8.87285693353063, 9: 12.360567175794303, 10: 0.6433927460157636},
)  # fmt: skip
_RESULT_8 = {0: 0.054293734116568765, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585, 8: 0.3111643669578199,
             9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.04471061572777259}  # fmt: skip
# Differences from results of order three and five.
_THIRD_8 = {0: -0.18980075407240762, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585,
            8: -0.4226823213237919, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.02265179219836082}  # fmt: skip
_FIFTH_8 = {0: 0.01312004499419488, 5: -1.2251564463762044, 6: -0.4957589496572502, 7: 1.6643771824549864,
            8: -0.35032884874997366, 9: 0.3341791187130175, 10: 0.08192320648511571, 11: -0.022355307863886294}  # fmt: skip


def _filled(weights: dict[int, float], count: int) -> Array:
    return np.array([weights.get(place, 0.0) for place in range(count)])


_WEIGHTS_8 = [_filled(row, place) for place, row in enumerate(_ROWS_8)]
_ENDS_8 = np.array([_filled(row, len(_NODES_8)) for row in (_RESULT_8, _THIRD_8, _FIFTH_8)])


def dormand_prince_8(field: Field, at: float, state: Array, slope: Array, length: float) -> Step:
    """Return one step of the pair of order eight from `state` with known `slope`; the last slope is none after the step."""
    slopes = np.empty((len(_NODES_8), len(state)))
    slopes[0] = slope
    for index in range(1, len(_NODES_8)):
        slopes[index] = field(at + _NODES_8[index] * length, state + length * (_WEIGHTS_8[index] @ slopes[:index]))
    moved, third, fifth = length * (_ENDS_8 @ slopes)
    size = np.hypot(fifth, 0.1 * third)
    return Step(state + moved, np.abs(fifth) * np.abs(fifth) / np.where(size > 0, size, 1.0), slopes[-1])


def next_length(length: float, ratio: float, order: int = 5) -> float:
    """Return the next step length from the ratio error/tolerance of the last one, for a pair of `order`."""
    return float(length * min(4.0, max(0.2, 0.85 * max(ratio, 1e-10) ** (-1 / order))))


def integrate_adaptive(field: Field, state: Array, times: Array, tolerance: float) -> tuple[Array, int]:
    """Return the states at `times` (n, m) and the number of slopes; every row is hit by a step, not interpolated."""
    slope = field(float(times[0]), state)
    count = 1
    at, length = float(times[0]), float(times[-1] - times[0]) / 100
    rows = [state]
    for goal in times[1:]:
        while at < goal:
            last = at + length >= goal * (1 - 1e-14)
            taken = float(goal) - at if last else length
            step = dormand_prince(field, at, state, slope, taken)
            count += SLOPES
            ratio = float(np.max(np.abs(step.error) / (tolerance * (1.0 + np.abs(state)))))
            if ratio <= 1.0:
                at, state, slope = (float(goal) if last else at + taken), step.state, step.slope
            if not last or ratio > 1.0:
                length = next_length(taken, ratio)
        rows.append(state)
    return np.array(rows), count
