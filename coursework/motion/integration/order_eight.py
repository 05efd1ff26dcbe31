"""One step of the Dormand-Prince pair of order 8(5,3), for twelve digits, written out component by component.

Enters: a vector field that has time among its components.  Leaves: the state after a step and its estimated error.
Used by `singular`, which takes thousands of such steps: loops over lists or arrays would cost more than the field.
Source: E. Hairer, S. P. Nørsett, G. Wanner, "Solving Ordinary Differential Equations I", 1993, II.10 (DOP853).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from coursework.equations.codegen.programs import Bound, build
from coursework.motion.integration.adaptive import Field, listed, weighed
from coursework.system.arrays import Array

# For every slope of a step but the first: index of an earlier slope -> its weight.
_ROWS: tuple[dict[int, float], ...] = (
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
_RESULT = {0: 0.054293734116568765, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585, 8: 0.3111643669578199,
             9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.04471061572777259}  # fmt: skip
# Differences from the embedded results of order three and five.
_THIRD = {0: -0.18980075407240762, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585,
            8: -0.4226823213237919, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.02265179219836082}  # fmt: skip
_FIFTH = {0: 0.01312004499419488, 5: -1.2251564463762044, 6: -0.4957589496572502, 7: 1.6643771824549864,
            8: -0.35032884874997366, 9: 0.3341791187130175, 10: 0.08192320648511571, 11: -0.022355307863886294}  # fmt: skip
SLOPES = len(_ROWS)  # new slopes in each step: the first one is known


def dormand_prince_8(field: Field, state: Array, slope: Array, length: float) -> tuple[Array, list[float]]:
    """Return the state (m,) after a step of `length` and its estimated error (m numbers); `slope` is field(*state).

    >>> end, error = dormand_prince_8(lambda x, t: (x, 1.0), np.array([1.0, 0.0]), np.array([1.0, 1.0]), 0.1)
    >>> f"{end[0]:.12f}"
    '1.105170918076'
    """
    after, third, fifth = _written_out(len(state))(field, length, *state.tolist(), *slope.tolist())
    sizes = (math.hypot(b, 0.1 * a) for a, b in zip(third, fifth, strict=True))
    return np.array(after), [b * b / (size or 1.0) for b, size in zip(fifth, sizes, strict=True)]


@cache
def _written_out(size: int) -> Callable[..., tuple[list[float], list[float], list[float]]]:
    """Return a function of (field, length, *state, *slope): the state after a step, its differences from order three and five."""
    parts = range(size)
    lines = [f"def step(field, length, {listed('y', parts)}, {listed('k0_', parts)}):"]
    for stage, weights in enumerate(_ROWS, start=1):
        points = ", ".join(f"y{part} + length * ({weighed(weights, part)})" for part in parts)
        lines.append(f"    [{listed(f'k{stage}_', parts)}] = field({points})")
    after = ", ".join(f"y{part} + length * ({weighed(_RESULT, part)})" for part in parts)
    third, fifth = (", ".join(f"length * ({weighed(row, part)})" for part in parts) for row in (_THIRD, _FIFTH))
    return build("\n".join([*lines, f"    return [{after}], [{third}], [{fifth}]"]), "step", Bound((), {}, {}))
