"""Six mechanisms that are in no file of the catalogue, as a student writes them: `new --groups`, own data, own equations.

`CLOSED[name](t)` returns angles as the vector along their link and slides as lengths (m), from the triangles alone.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp

from tests.triangles import e, meeting

GROUPS = {
    "rocker": "crank,RRR,RRR", "inclined": "crank,RRP", "lever": "crank,RPR", "oblique": "crank,RPP", "slots": "crank,crank,PRP",
    "lift": "crank,crank,RRR,RRP",
}  # fmt: skip
DATA: dict[str, dict[str, str]] = {
    "rocker": {"n1": "90 rpm", "r1": "0.12 m", "r2": "0.35 m", "r3": "0.28 m", "r4": "0.30 m", "r5": "0.26 m", "xC": "0.30 m",
               "yC": "-0.12 m", "xE": "0.62 m", "yE": "-0.10 m"},
    "inclined": {"n1": "150 rpm", "gamma3": "35 deg", "xC": "0.05 m", "yC": "0.02 m"},
    "lever": {"n1": "45 rpm", "r1": "0.11 m", "r2": "0.45 m", "xC": "-0.10 m", "yC": "-0.26 m"},
    "oblique": {"n1": "100 rpm", "r1": "0.09 m", "gamma3": "25 deg", "xC": "0.02 m", "yC": "-0.1 m"},
    "slots": {"n1": "40 rpm", "swing1": "0.5 rad", "n2": "40 rpm", "r1": "0.15 m", "r2": "0.12 m", "gamma4": "-90 deg",
              "delta4": "90 deg", "xC": "0.40 m", "yC": "0.04 m"},
    "lift": {"n1": "60 rpm", "n2": "120 rpm", "r1": "0.10 m", "r2": "0.07 m", "r3": "0.36 m", "r4": "0.33 m", "r5": "0.40 m",
             "gamma6": "80 deg", "xC": "0.42 m", "yC": "0.03 m", "xF": "0.18 m", "yF": "0.30 m"},
}  # fmt: skip
CHANGED: dict[str, tuple[tuple[str, str], ...]] = {
    "rocker": (),
    "inclined": (('lengths     = ["r1"]', 'lengths = ["0.08"]'), ('lengths     = ["r2"]', 'lengths = ["0.27"]'),
                 ('offset = "0"', 'offset = "0.03"')),
    "lever": (('offset      = "0"', 'offset = "k"'), ('r1 = "', 'k = "0.05 m"\nr1 = "')),
    "oblique": (('angle       = "90 deg"', 'angle = "70 deg"'), ('offset = "0"', 'offset = "0.01"')),
    "slots": (('w2 = "n2"', 'w2 = "-0.4*n2*sin(n2*t)"'),
              ('through = "E", angle = "gamma4"', 'through = "D", angle = "phi2 + gamma4"'),
              ('rails  = [ { through = "E", angle = "gamma4" } ]', "")),
    "lift": (),
}  # fmt: skip
EQUATIONS = {
    "rocker": ("-r1*w1*sin(phi1) - r2*w2*sin(phi2) + r3*w3*sin(phi3) = 0",
               "r1*w1*cos(phi1) + r2*w2*cos(phi2) - r3*w3*cos(phi3) = 0",
               "-r3*w3*sin(phi3) - r4*w4*sin(phi4) + r5*w5*sin(phi5) = 0",
               "r3*w3*cos(phi3) + r4*w4*cos(phi4) - r5*w5*cos(phi5) = 0"),
    "inclined": ("u3*cos(gamma3) = -0.08*w1*sin(phi1) - 0.27*w2*sin(phi2)",
                 "u3*sin(gamma3) = 0.08*w1*cos(phi1) + 0.27*w2*cos(phi2)"),
    "lever": ("u3*cos(phi2) - s3*w2*sin(phi2) - k*w2*cos(phi2) = -r1*w1*sin(phi1)",
              "u3*sin(phi2) + s3*w2*cos(phi2) - k*w2*sin(phi2) = r1*w1*cos(phi1)"),
    "oblique": ("u3*cos(gamma3) + u2*cos(gamma3 + 7*pi/18) = -r1*w1*sin(phi1)",
                "u3*sin(gamma3) + u2*sin(gamma3 + 7*pi/18) = r1*w1*cos(phi1)"),
    "slots": ("-r2*w2*sin(phi2) + u3*cos(phi2 + gamma4) - s3*w2*sin(phi2 + gamma4)"
              " = -r1*w1*sin(phi1) + u4*cos(phi1 + delta4) - s4*w1*sin(phi1 + delta4)",
              "r2*w2*cos(phi2) + u3*sin(phi2 + gamma4) + s3*w2*cos(phi2 + gamma4)"
              " = r1*w1*cos(phi1) + u4*sin(phi1 + delta4) + s4*w1*cos(phi1 + delta4)"),
    "lift": ("-r1*w1*sin(phi1) - r3*w3*sin(phi3) + r2*w2*sin(phi2) + r4*w4*sin(phi4) = 0",
             "r1*w1*cos(phi1) + r3*w3*cos(phi3) - r2*w2*cos(phi2) - r4*w4*cos(phi4) = 0",
             "-r1*w1*sin(phi1) - r3*w3*sin(phi3) - r5*w5*sin(phi5) = u6*cos(gamma6)",
             "r1*w1*cos(phi1) + r3*w3*cos(phi3) + r5*w5*cos(phi5) = u6*sin(gamma6)"),
}  # fmt: skip


def edited(name: str, template: str) -> str:
    """Return what the student makes of the file that `new --groups` writes."""
    text = template
    for datum, value in DATA[name].items():
        text, count = re.subn(rf'(?m)^{datum} = "[^"]*"', f'{datum} = "{value}"', text)
        assert count == 1, datum
    for old, new in CHANGED[name]:
        assert old in text, old
        text = text.replace(old, new, 1)
    for number, equation in enumerate(EQUATIONS[name], start=1):
        text = text.replace("[points]", f'[[constraint]]\nname = "{number}"\nequation = "{equation}"\n\n[points]', 1)
    return text


def turned(equation: str) -> list[str]:
    """Return an equation with each of its signs turned, one at a time; the zero at its end has none."""
    found = []
    for match in re.finditer(r"(?:^|(?<=[ (]))(?:([+-]) ?)?(?=[a-z0-9])", equation):
        if equation[match.start() :] in {"0", "- 0"} or equation[match.start() - 1 : match.start()] == "(":
            continue
        sign = "+ " if match[1] == "-" and match.start() else "" if match[1] == "-" else "- "
        if match[1] is None and equation[match.start() - 2 : match.start()] in {"+ ", "- "}:
            continue
        found.append(equation[: match.start()] + sign + equation[match.end() :])
    return found


def ways(gap: Any, one: Any, other: Any) -> tuple[Any, Any]:
    """Return p, q of gap = p one + q other, both of length 1."""
    sine = (mp.conj(one) * other).imag
    return (mp.conj(gap) * other).imag / sine, (mp.conj(one) * gap).imag / sine


def on_guide(b: Any, rod: Any, place: Any, way: Any) -> tuple[Any, Any]:
    """Return the point of a guide a rod away from b, and how far that is from its place; the farther one."""
    gap = (b - place) * mp.conj(way)
    slide = gap.real + mp.sqrt(rod**2 - gap.imag**2)
    return place + way * slide, slide


def m(number: str) -> Any:
    return mp.mpf(number)


def rocker(t: Any) -> dict[str, Any]:
    b, c, g = m("0.12") * e(mp.pi / 6 + 3 * mp.pi * t), mp.mpc("0.30", "-0.12"), mp.mpc("0.62", "-0.10")
    d = meeting(b, c, m("0.35"), m("0.28"))
    f = meeting(d, g, m("0.30"), m("0.26"))
    return {"phi2": d - b, "phi3": d - c, "phi4": f - d, "phi5": f - g}


def inclined(t: Any) -> dict[str, Any]:
    b, way = m("0.08") * e(mp.pi / 6 + 5 * mp.pi * t), e(mp.radians(35))
    d, slide = on_guide(b, m("0.27"), mp.mpc("0.05", "0.02") + 1j * way * m("0.03"), way)
    return {"phi2": d - b, "s3": slide}


def lever(t: Any) -> dict[str, Any]:
    gap = m("0.11") * e(mp.pi / 6 + mp.mpf(3) / 2 * mp.pi * t) - mp.mpc("-0.10", "-0.26")
    slide = mp.sqrt(abs(gap) ** 2 - m("0.05") ** 2)
    return {"phi2": gap / mp.mpc(slide, "0.05"), "s3": slide}


def oblique(t: Any) -> dict[str, Any]:
    way = e(mp.radians(25))
    gap = m("0.09") * e(mp.pi / 6 + mp.mpf(10) / 3 * mp.pi * t) - mp.mpc("0.02", "-0.1") - 1j * way * m("0.01")
    guide, slide = ways(gap, way, way * e(mp.radians(70)))
    return {"s2": slide, "s3": guide}


def slots(t: Any) -> dict[str, Any]:
    turn = mp.mpf(4) / 3 * mp.pi * t
    one, other = e(mp.pi / 6 + mp.sin(turn) / 2), e(2 * mp.pi / 3 + m("0.4") * (mp.cos(turn) - 1))
    first, second = ways(m("0.15") * one - mp.mpc("0.40", "0.04") - m("0.12") * other, -1j * other, 1j * one)
    return {"s3": first, "s4": -second}


def lift(t: Any) -> dict[str, Any]:
    b, d = m("0.10") * e(mp.pi / 6 + 2 * mp.pi * t), mp.mpc("0.42", "0.03") + m("0.07") * e(2 * mp.pi / 3 + 4 * mp.pi * t)
    p = meeting(b, d, m("0.36"), m("0.33"))
    g, slide = on_guide(p, m("0.40"), mp.mpc("0.18", "0.30"), e(mp.radians(80)))
    return {"phi3": p - b, "phi4": p - d, "phi5": g - p, "s6": slide}


CLOSED: Mapping[str, Callable[[Any], dict[str, Any]]] = {
    "rocker": rocker, "inclined": inclined, "lever": lever, "oblique": oblique, "slots": slots, "lift": lift,
}  # fmt: skip
