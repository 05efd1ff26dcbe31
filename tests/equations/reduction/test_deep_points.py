"""Points in points: a hundred levels are differentiated twice, one more is refused with its place."""

import mpmath as mp
import numpy as np
import pytest

import coursework
from coursework import InputError
from coursework.equations.reduction.symbolic import MOST_LEVELS
from coursework.variant.formula.tree import spelled
from coursework.variant.reading.reader import parse_variant

TEXT = """[points]
P = "({first}, 0)"
Q = "({second}, 0)"
[drive]
U = "1"
[coordinates]
f = {{ start = "0.3", rate = "w0" }}
g = {{ start = "0.29", rate = "w1" }}
[time]
step = "0.01 s"
end = "0.1 s"
[[constraint]]
equation = "w1 = U"
[[constraint]]
equation = "w0 = U"
"""


def nested(inner: str, levels: int) -> str:
    return "sin(" * levels + inner + ")" * levels


def variant(levels: int):
    """Return a mechanism with a point whose place has so many levels: the symbol itself is one."""
    return parse_variant(TEXT.format(first=nested("f", 50), second=nested("P.x", levels - 51)), "deep.toml")


@pytest.mark.long
def test_a_hundred_levels_are_differentiated_twice():
    run = coursework.solve(variant(MOST_LEVELS), quantities=["table", "points", "accelerations"])
    names, columns = run.columns()
    place = columns[:, names.index("Q.ax")]
    f = np.array([mp.diff(lambda t: iterated(0.3 + t), t, 2) for t in run.motion.t], dtype=float)
    assert place == pytest.approx(f, rel=1e-8)


def iterated(value):
    for _ in range(MOST_LEVELS - 1):
        value = mp.sin(value)
    return value


def test_one_level_more_is_refused_with_its_place():
    with pytest.raises(InputError, match=r"V141 deep\.toml:3 .*points\.Q.*more than 100 levels deep"):
        _ = coursework.solve(variant(MOST_LEVELS + 1)).equations
    text = TEXT.format(first=nested("f", 50), second=nested("P.x", MOST_LEVELS - 51)) + '[closure]\nholds = ["g",\n"sin(Q.x)"]\n'
    with pytest.raises(InputError, match=r"V141 deep\.toml:18 .*closure\.holds\.2.*more than 100 levels deep"):
        _ = coursework.solve(parse_variant(text, "deep.toml")).equations


def test_a_power_of_a_long_sum_is_shown_as_it_is():
    """(d0 + … + d24 + f)^8 multiplied out has more than ten million terms."""
    names = [f"d{place}" for place in range(25)]
    text = TEXT.format(first="0", second=f"({' + '.join(names)} + f)^8*g").replace("w1 = U", "w1 + Q.x = U")
    text = text.replace('equation = "w1 + Q.x = U"', 'closure = "Q.x = 0"').replace('"0.29"', '"0"')
    given = "[given]\n" + "".join(f'{name} = "0.01"\n' for name in names)
    run = coursework.solve(parse_variant(given + text, "wide.toml"), quantities=["table"])
    shown = [spelled(one.left) for one in run.equations]
    assert any(")^8" in left and len(left) < 1000 for left in shown), shown
