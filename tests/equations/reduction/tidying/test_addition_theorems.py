"""Two products of sines and cosines become one function of a sum or difference, whichever of them stands first."""

import math

import pytest

from coursework.equations.algebra.calculus import replaced
from coursework.equations.algebra.expression import number, value
from coursework.equations.algebra.functions import cosine, sine
from coursework.equations.reduction.symbolic import local
from coursework.equations.reduction.tidying.addition_theorems import pair_angles

X, Y, R = map(local, ("x", "y", "r"))
AT = {X: number(3) / 10, Y: number(7) / 10, R: number(5) / 2}


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize(("kinds", "signs", "total"), [
    ("cc ss", (1, -1), math.cos(1.0)), ("cc ss", (-1, 1), -math.cos(1.0)), ("cc ss", (1, 1), math.cos(0.4)),
    ("cc ss", (-1, -1), -math.cos(0.4)), ("sc cs", (1, 1), math.sin(1.0)), ("sc cs", (-1, -1), -math.sin(1.0)),
    ("sc cs", (1, -1), -math.sin(0.4)), ("sc cs", (-1, 1), math.sin(0.4)), ("cc sc", (1, 1), None), ("cc ss", (1, 2), None),
])  # fmt: skip
def test_two_products_are_one_function(kinds, signs, total, turned):
    """At x = 0.3, y = 0.7, r = 2.5."""
    made = {"c": cosine, "s": sine}
    terms = [sign * R * made[one](X) * made[other](Y) for sign, (one, other) in zip(signs, kinds.split(), strict=True)]
    joined = pair_angles(terms[::-1] if turned else terms, lambda atom: (int(atom.has(Y)),))
    if total is None:
        assert {*joined} == {*terms}
    else:
        (one,) = joined
        assert value(replaced(one, AT)) == pytest.approx(2.5 * total)
