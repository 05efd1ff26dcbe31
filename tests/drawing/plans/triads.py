"""Mechanisms with groups of class III that are in no catalogue, each with its motion solved in the test: a link on three legs.

`places(name, t)` solves the contours by Newton and returns places (m) of points, angles (rad) of links as "ω₂"; what moves them
is told by numeric derivatives (mpmath), no velocity equation of the package.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath as mp

from coursework import solve
from coursework.run import Run
from coursework.variant.reading.reader import parse_variant
from tests.triangles import e

Numbers = list[Any]


@dataclass(frozen=True)
class Triad:
    """`text` has a gap for the start of each coordinate that is sought; `contours(q, t)` are complex, nought where it closes."""

    text: str
    guess: tuple[float, ...]
    contours: Callable[[Numbers, Any], tuple[Any, ...]]
    points: Callable[[Numbers, Any], dict[str, Any]]


num = mp.mpf
GROUND, PIVOT, START = mp.mpc("0.5", "-0.2"), mp.mpc("-0.1", "-0.3"), mp.mpc("0.1", "-0.25")


def file(
    drive: str, coordinates: str, points: str, links: str, frame: str, closures: tuple[str, ...], step: str = "0.01 s"
) -> str:
    held = "".join(f'[[constraint]]\nclosure = "{closure}"\n' for closure in closures)
    return (
        f'format = 1\ntitle = "a link on three legs"\n[drive]\n{drive}\n[coordinates]\n{coordinates}\n'
        f'[time]\nstep = "{step}"\nend = "0.2 s"\ncheck_row = 4\nscheme = "exact"\n'
        f"[points]\n{points}\n[links]\n{links}\n[frame]\n{frame}\n{held}"
    )


CRANK = 'A = "(0, 0)"\nB = "A + 0.08 @ phi1"\nC = "A + 0.12 @ (phi1 + 1.8)"\n'
FIRST = 'phi1 = { start = "30 deg", rate = "w1" }\n'


def unknown(*names: str) -> str:
    """Return coordinates with gaps for their starts: a name with its rate and its unit."""
    return "".join(f'{name} = {{{{ start = "{{}} {unit}", rate = "{rate}" }}}}\n' for name, rate, unit in map(str.split, names))


def crank(t: Any) -> tuple[Any, Any]:
    angle = mp.radians(30) + 6 * t
    return num("0.08") * e(angle), num("0.12") * e(angle + num("1.8"))


def ternary(x: Any, angle: Any) -> tuple[Any, Any]:
    return x + num("0.25") * e(angle + 1), x + num("0.3") * e(angle)


def braced(text: str) -> str:
    return text.replace("{", "{{").replace("}", "}}")


TERNARY = ("X + 0.25 @ (phi4 + 1) = Y", "X + 0.3 @ phi4 = Z")

# Legs 2 and 3 hang on two points of the crank, leg 5 on the frame.
BARS = Triad(
    file(
        'w1 = "6"', braced(FIRST) + unknown("phi2 w2 rad", "phi3 w3 rad", "phi4 w4 rad", "phi5 w5 rad"),
        braced(CRANK + 'G = "(0.5, -0.2)"\nX = "B + 0.3 @ phi2"\nY = "C + 0.35 @ phi3"\nZ = "G + 0.4 @ phi5"'),
        braced('1 = { points = ["A", "B", "C"], rate = "w1" }\n2 = { points = ["B", "X"], rate = "w2" }\n'
               '3 = { points = ["C", "Y"], rate = "w3" }\n4 = { points = ["X", "Y", "Z"], rate = "w4" }\n'
               '5 = { points = ["G", "Z"], rate = "w5" }'),
        'hinges = ["A", "G"]', TERNARY,
    ),
    (-0.30, 0.27, 0.98, 1.51),
    lambda q, t: (
        ternary(crank(t)[0] + num("0.3") * e(q[0]), q[2])[0] - crank(t)[1] - num("0.35") * e(q[1]),
        ternary(crank(t)[0] + num("0.3") * e(q[0]), q[2])[1] - GROUND - num("0.4") * e(q[3]),
    ),
    lambda q, t: {
        "B": crank(t)[0], "C": crank(t)[1], "X": crank(t)[0] + num("0.3") * e(q[0]), "Y": crank(t)[1] + num("0.35") * e(q[1]),
        "Z": GROUND + num("0.4") * e(q[3]), "ω₂": q[0], "ω₃": q[1], "ω₄": q[2], "ω₅": q[3],
    },
)  # fmt: skip

# The pin X of the ternary link runs in a guide of the frame; legs 2 and 3 hang on the crank.
GUIDE = Triad(
    file(
        'w1 = "6"', braced(FIRST) + unknown("sx ux m", "phi2 w2 rad", "phi3 w3 rad", "phi4 w4 rad"),
        braced(CRANK + 'K = "(0.1, -0.25)"\nX = "K + sx @ 0.3"\nY = "B + 0.35 @ phi2"\nZ = "C + 0.5 @ phi3"'),
        braced('1 = { points = ["A", "B", "C"], rate = "w1" }\n2 = { points = ["B", "Y"], rate = "w2" }\n'
               '3 = { points = ["C", "Z"], rate = "w3" }\n4 = { points = ["X", "Y", "Z"], rate = "w4" }'),
        braced('hinges = ["A"]\nrails = [ { through = "X", angle = "0.3" } ]'), TERNARY,
    ),
    (0.2, -0.2, -0.1, 0.9),
    lambda q, t: (
        ternary(START + q[0] * e(num("0.3")), q[3])[0] - crank(t)[0] - num("0.35") * e(q[1]),
        ternary(START + q[0] * e(num("0.3")), q[3])[1] - crank(t)[1] - num("0.5") * e(q[2]),
    ),
    lambda q, t: {
        "B": crank(t)[0], "C": crank(t)[1], "X": START + q[0] * e(num("0.3")),
        "Y": crank(t)[0] + num("0.35") * e(q[1]), "Z": crank(t)[1] + num("0.5") * e(q[2]), "ω₂": q[1], "ω₃": q[2], "ω₄": q[3],
    },
)  # fmt: skip


def second(t: Any) -> Any:
    return mp.radians(20) - 3 * t


# Two drives: the pin X of the ternary link slides along a second crank, leg 2 hangs on the first, leg 5 on the frame.
SLOT = Triad(
    file(
        'w1 = "6"\nw6 = "-3"',
        braced(FIRST + 'phi6 = { start = "20 deg", rate = "w6" }\n')
        + unknown("sx ux m", "phi2 w2 rad", "phi4 w4 rad", "phi5 w5 rad"),
        braced('A = "(0, 0)"\nB = "A + 0.08 @ phi1"\nG = "(0.5, -0.2)"\nH = "(-0.1, -0.3)"\nL = "H + 0.3 @ phi6"\n'
               'X = "H + sx @ phi6"\nY = "B + 0.35 @ phi2"\nZ = "G + 0.4 @ phi5"'),
        braced('1 = { points = ["A", "B"], rate = "w1" }\n2 = { points = ["B", "Y"], rate = "w2" }\n'
               '4 = { points = ["X", "Y", "Z"], rate = "w4" }\n5 = { points = ["G", "Z"], rate = "w5" }\n'
               '6 = { points = ["H", "L"], rate = "w6" }\n7 = { points = ["X"], slides = "6", rate = "w6" }'),
        'hinges = ["A", "G", "H"]', TERNARY,
    ),
    (0.15, -0.88, -0.93, 3.95),
    lambda q, t: (
        ternary(PIVOT + q[0] * e(second(t)), q[2])[0] - crank(t)[0] - num("0.35") * e(q[1]),
        ternary(PIVOT + q[0] * e(second(t)), q[2])[1] - GROUND - num("0.4") * e(q[3]),
    ),
    lambda q, t: {
        "B": crank(t)[0], "L": PIVOT + num("0.3") * e(second(t)), "X": PIVOT + q[0] * e(second(t)),
        "Y": crank(t)[0] + num("0.35") * e(q[1]), "Z": GROUND + num("0.4") * e(q[3]),
        "ω₂": q[1], "ω₄": q[2], "ω₅": q[3],
    },
)  # fmt: skip

# The ternary link is a bar through a sleeve that swivels at N; legs 2 and 3 hang on the crank.
SLEEVE = Triad(
    file(
        'w1 = "6"', braced(FIRST) + unknown("s us m", "phi2 w2 rad", "phi3 w3 rad", "phi4 w4 rad"),
        braced(CRANK + 'N = "(0.45, 0.35)"\nX = "B + 0.3 @ phi2"\nY = "C + 0.45 @ phi3"'),
        braced('1 = { points = ["A", "B", "C"], rate = "w1" }\n2 = { points = ["B", "X"], rate = "w2" }\n'
               '3 = { points = ["C", "Y"], rate = "w3" }\n4 = { points = ["X", "Y"], rate = "w4" }\n'
               '5 = { points = ["N"], slides = "4", rate = "w4" }'),
        'hinges = ["A", "N"]', ("X + 0.25 @ phi4 = Y", "X + s @ phi4 = N"),
    ),
    (0.5, -0.1, 0.35, 1.2),
    lambda q, t: (
        crank(t)[0] + num("0.3") * e(q[1]) + num("0.25") * e(q[3]) - crank(t)[1] - num("0.45") * e(q[2]),
        crank(t)[0] + num("0.3") * e(q[1]) + q[0] * e(q[3]) - mp.mpc("0.45", "0.35"),
    ),
    lambda q, t: {
        "B": crank(t)[0], "C": crank(t)[1], "X": crank(t)[0] + num("0.3") * e(q[1]), "Y": crank(t)[1] + num("0.45") * e(q[2]),
        "ω₂": q[1], "ω₃": q[2], "ω₄": q[3],
    },
)  # fmt: skip

TRIADS = {"bars": BARS, "guide": GUIDE, "slot": SLOT, "sleeve": SLEEVE}


def solution(name: str, t: Any, guess: Numbers) -> Numbers:
    def left(*q: Any) -> list[Any]:
        return [part for gap in TRIADS[name].contours([*q], t) for part in (gap.real, gap.imag)]

    return [*mp.findroot(left, guess)]


def places(name: str, t: Any) -> dict[str, Any]:
    """The points and coordinates at a time, solved once for every precision in which they are asked for."""
    return _places(name, mp.mpf(t), mp.mp.prec)


@cache
def _places(name: str, t: Any, _precision: int) -> dict[str, Any]:
    """Return places and angles at a time (s)."""
    return TRIADS[name].points(solution(name, t, _followed(name, round(float(t), 6))), t)


@cache
def _followed(name: str, t: float) -> Numbers:
    """Return the coordinates at about a time (s), followed from the start in small steps; times beside it begin from them."""
    q: Numbers = [*TRIADS[name].guess]
    for k in range(5):
        q = solution(name, mp.mpf(t) * k / 4, q)
    return q


@cache
def derivative(name: str, quantity: str, t: float, order: int = 1) -> complex:
    """Return a velocity or acceleration by a derivative of the solved motion."""
    return complex(mp.diff(lambda time: places(name, time)[quantity], mp.mpf(t), order))


def text_of(name: str) -> str:
    start = solution(name, mp.mpf(0), [*TRIADS[name].guess])
    return TRIADS[name].text.format(*(mp.nstr(value, 17) for value in start))


@cache
def run_of(name: str) -> Run:
    return solve(parse_variant(text_of(name)), quantities=["graph_check", "plans"])
