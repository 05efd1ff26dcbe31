"""Mechanisms that are in no catalogue, each with its motion in closed form: what slides on links that move themselves.

`CLOSED[name](t)` returns places (m) as complex numbers, angles (rad) and slidings (m) of the same names as the check's rows.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import mpmath as mp

from coursework import solve
from coursework.run import Run
from coursework.variant.reading.reader import parse_variant
from tests.triangles import e, meeting

HEAD = """
format = 1
title = "{name}"
[drive]
{drive}
[coordinates]
{coordinates}
[time]
step = "{step}"
end = "{end}"
check_row = 4
[points]
{points}
{groups}
[frame]
hinges = {hinges}
{rails}
"""


def group(kind: str, **keys: str) -> str:
    return f'[[group]]\nkind = "{kind}"\n' + "".join(f"{key} = {value}\n" for key, value in keys.items() if value)


def crank(start: str, end: str, length: str, angle: str) -> str:
    return group("crank", **{"from": f'["{start}"]'}, meets=f'"{end}"', lengths=f'["{length}"]', coordinates=f'["{angle}"]')


def dyad(kind: str, outer: str, meets: str, lengths: str, coordinates: str, more: str = "") -> str:
    found = group(kind, **{"from": outer}, meets=meets, lengths=lengths, coordinates=coordinates)
    return found + ("" if kind in {"RPP", "PRP"} else 'mode = "+1"\n') + more


TWO_CRANKS = 'phia = { start = "40 deg", rate = "w1" }\nphib = { start = "100 deg", rate = "w2" }\n'
SLIDINGS = 'si = { rate = "ui", unit = "m" }\nsj = { rate = "uj", unit = "m" }'
TEXTS = {
    "shaper": HEAD.format(
        name="slotted lever of a shaper", drive='w1 = "4*pi"', step="0.0125 s", end="0.5 s", hinges='["A", "D"]', rails="",
        coordinates='phi1 = { start = "20 deg", rate = "w1" }\nphi3 = { rate = "w3", unit = "rad" }\n'
        's2 = { rate = "u2", unit = "m" }\nphi4 = { rate = "w4", unit = "rad" }\ns5 = { rate = "u5", unit = "m" }',
        points='A = "(0, 0)"\nD = "(0, -0.25)"\nK = "(0, 0.23)"',
        groups=crank("A", "B", "0.1", "phi1") + dyad("RPR", '["B", "D"]', '"E"', '["0.5"]', '["phi3", "s2"]')
        + dyad("RRP", '["E"]', '"F"', '["0.3"]', '["phi4", "s5"]', 'guide = { through = "K", angle = "0" }\n'),
    ),
    "six-bar": HEAD.format(
        name="four-bar whose coupler slides through a pivot", drive='w1 = "10"', step="0.0175 s", end="0.6 s",
        hinges='["A", "D", "G"]', rails="",
        coordinates='phi1 = { start = "70 deg", rate = "w1" }\nphi2 = { rate = "w2", unit = "rad" }\n'
        'phi3 = { rate = "w3", unit = "rad" }\nphi5 = { rate = "w5", unit = "rad" }\ns6 = { rate = "u6", unit = "m" }',
        points='A = "(0, 0)"\nD = "(0.32, 0)"\nG = "(0.15, 0.6)"\nQ = "B + 0.12 @ phi2"',
        groups=crank("A", "B", "0.1", "phi1") + dyad("RRR", '["B", "D"]', '"C"', '["0.3", "0.22"]', '["phi2", "phi3"]')
        + dyad("RPR", '["G", "Q"]', '"E"', '["0.7"]', '["phi5", "s6"]'),
    ),
    "pin": HEAD.format(
        name="pin in the slots of two cranks", drive='w1 = "8"\nw2 = "-4"', step="0.01 s", end="0.1 s", hinges='["A", "E"]',
        rails="", coordinates=TWO_CRANKS + SLIDINGS, points='A = "(0, 0)"\nE = "(0.9, 0)"',
        groups=crank("A", "K", "0.2", "phia") + crank("E", "N", "0.15", "phib")
        + dyad("PRP", "", '"C"', "", '["si", "sj"]', 'guides = [ { through = "K", angle = "phia", offset = "0.05" }, '
               '{ through = "N", angle = "phib + 1.2" } ]\n'),
    ),
    "block": HEAD.format(
        name="two slides, the second on a crank", drive='w1 = "8"\nw2 = "-4"', step="0.01 s", end="0.1 s", hinges='["A", "E"]',
        rails="", coordinates=TWO_CRANKS + SLIDINGS, points='A = "(0, 0)"\nE = "(0.5, 0)"',
        groups=crank("A", "K", "0.2", "phia") + crank("E", "N", "0.3", "phib")
        + dyad("RPP", '["K"]', '"F"', "", '["si", "sj"]', 'guide = { through = "N", angle = "phib + 0.7" }\nangle = "1.2"\n'),
    ),
    "pushed": HEAD.format(
        name="slider driven along its guide", drive='u1 = "0.3*cos(5*t)"', step="0.02 s", end="0.4 s", hinges='["D"]',
        rails='rails = [ { through = "B", angle = "0.2" } ]',
        coordinates='s1 = { start = "0.1 m", rate = "u1" }\nphi2 = { rate = "w2", unit = "rad" }\n'
        'phi3 = { rate = "w3", unit = "rad" }',
        points='K = "(0, 0)"\nB = "K + s1 @ 0.2"\nD = "(0.5, -0.1)"',
        groups=dyad("RRR", '["B", "D"]', '"C"', '["0.4", "0.3"]', '["phi2", "phi3"]'),
    ),
}  # fmt: skip


@cache
def run_of(name: str) -> Run:
    return solve(parse_variant(TEXTS[name]), quantities=["graph_check", "plans"])


def ways(gap: Any, one: Any, other: Any) -> tuple[Any, Any]:
    """Return p, q of gap = p e(one) + q e(other)."""
    sine = mp.sin(other - one)
    return (gap * mp.conj(e(other))).imag / -sine, (gap * mp.conj(e(one))).imag / sine


def shaper(t: Any) -> dict[str, Any]:
    b, d = e(mp.radians(20) + 4 * mp.pi * t) / 10, mp.mpc(0, -0.25)
    lever = mp.arg(b - d)
    end = d + e(lever) / 2
    f = mp.mpc(end.real + mp.sqrt(mp.mpf("0.09") - (mp.mpf("0.23") - end.imag) ** 2), 0.23)
    return {"B": b, "E": end, "F": f, "ω₃": lever, "ω₄": mp.arg(f - end), "V_BB′": abs(b - d), "B′": ("D", d, lever, b)}


def six_bar(t: Any) -> dict[str, Any]:
    b, g = e(mp.radians(70) + 10 * t) / 10, mp.mpc("0.15", "0.6")
    c = meeting(b, mp.mpf("0.32"), mp.mpf("0.3"), mp.mpf("0.22"))
    q = b + mp.mpf("0.12") * e(mp.arg(c - b))
    bar = mp.arg(g - q)
    found = {"B": b, "C": c, "Q": q, "E": q + mp.mpf("0.7") * e(bar)}
    return found | {"ω₂": mp.arg(c - b), "ω₃": mp.arg(c - mp.mpf("0.32")), "ω₅": bar, "G′": ("Q", q, bar, g)}


def cranks(t: Any, base: str, arm: str) -> tuple[Any, Any, Any, Any]:
    a, b = mp.radians(40) + 8 * t, mp.radians(100) - 4 * t
    return a, b, e(a) / 5, mp.mpf(base) + mp.mpf(arm) * e(b)


def pin(t: Any) -> dict[str, Any]:
    a, b, k, n = cranks(t, "0.9", "0.15")
    first, second = ways(n - k - mp.mpc(0, "0.05") * e(a), a, b + mp.mpf("1.2"))
    return {"K": k, "N": n, "C": n - second * e(b + mp.mpf("1.2")), "V_CC′": first, "V_CC′′": second}


def block(t: Any) -> dict[str, Any]:
    _, b, k, n = cranks(t, "0.5", "0.3")
    guide = b + mp.mpf("0.7")
    first, second = ways(k - n, guide, guide + mp.mpf("1.2"))
    f = n + first * e(guide)
    return {"K": k, "N": n, "F": f, "V_KK′": second, "K′": ("F", f, guide, k)}


def pushed(t: Any) -> dict[str, Any]:
    b, d = (mp.mpf("0.1") + mp.mpf("0.06") * mp.sin(5 * t)) * e(mp.mpf("0.2")), mp.mpc("0.5", "-0.1")
    c = meeting(b, d, mp.mpf("0.4"), mp.mpf("0.3"))
    return {"B": b, "C": c, "ω₂": mp.arg(c - b), "ω₃": mp.arg(c - d)}


CLOSED: dict[str, Callable[[Any], dict[str, Any]]] = {
    "shaper": shaper, "six-bar": six_bar, "pin": pin, "block": block, "pushed": pushed,
}  # fmt: skip


def velocity(name: str, quantity: str, t: float) -> complex:
    """Return the velocity of a quantity by a derivative of the closed form; of "B′" that of the point of a link under B."""
    here = CLOSED[name](mp.mpf(t))[quantity]
    if not isinstance(here, tuple):
        return complex(mp.diff(lambda time: CLOSED[name](time)[quantity], mp.mpf(t)))
    _, base, angle, rider = here
    arm = (rider - base) / e(angle)  # stays, though the rider goes on
    return complex(mp.diff(lambda time: CLOSED[name](time)[quantity][1] + arm * e(CLOSED[name](time)[quantity][2]), mp.mpf(t)))


def acceleration(name: str, quantity: str, t: float) -> complex:
    """Return the acceleration of a point of the file."""
    return complex(mp.diff(lambda time: CLOSED[name](time)[quantity], mp.mpf(t), 2))
