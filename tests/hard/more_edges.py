"""More scenes at the edge of doubles: short runs, poles, motions that end, folds, starts that do not close.

Each has its true motion in fifty digits by mpmath, as those of `edges.py`; those of `more_mechanisms.py` stand beside them.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from random import Random

import mpmath as mp

from tests.hard.drives import KINDS, Law, four_bar, with_sides
from tests.hard.drives import drawn as drive
from tests.hard.edges import Columns, Edge, of_four_bar, rate_of
from tests.hard.more_mechanisms import SCHEMES, passed, rocking, rolling, two

SIDES = tuple(mp.mpf(float(one)) for one in ("0.4", "1.0", "0.7", "1.2"))


def short(random: Random) -> Edge:
    """Return a run of a few rows with a step from 1e-6 s on."""
    step, rows = float(f"{10 ** -random.uniform(2, 6):.2g}"), random.randint(5, 200)
    end = float(f"{step * rows:.12g}")
    kind, width = random.choice(KINDS), float(f"{end * 10 ** -random.uniform(0, 5):.3g}")
    law = drive(kind, random, width, end)
    text = four_bar(law, scheme=random.choice(SCHEMES), step=step, end=end)
    told = f"{kind} {width:.0e} of {end:.0e} s"
    true = of_four_bar(SIDES, law, rate_of(law), mp.mpf(0))
    return Edge("short", told, text, true, about=law.sudden, most=law.most, wave=law.wave)


def pole(random: Random) -> Edge:
    """Return a drive with a pole just outside the run, or inside it, on a row or between two."""
    size, base = float(f"{random.uniform(0.05, 0.3):.3g}"), float(f"{random.uniform(-2, 2):.3g}")
    is_inside, is_root = random.random() < 0.4, random.random() < 0.4
    at = round(random.uniform(0.1, 0.9), random.choice([2, 5])) if is_inside else 1 + 10 ** -random.uniform(1, 9)
    given = {"a": f"{size!r} rad/s", "b": f"{base!r} rad/s", "tm": f"{at!r} s", "T": "1 s"}
    a, b, m = mp.mpf(size), mp.mpf(base), mp.mpf(at)
    law = Law("pole", "b + a*T/(tm - t)", given, lambda t: b * t + a * mp.log(m / (m - t)), size / abs(at - 1))
    if is_root:
        root = lambda x: 2 * mp.sign(x) * mp.sqrt(abs(x))  # noqa: E731
        most = size / abs(at - 1) ** 0.5
        law = Law("pole", "b + a*sqrt(T/abs(tm - t))", given, lambda t: b * t + a * (root(m) - root(m - t)), most)
    true = of_four_bar(SIDES, law, rate_of(law), mp.mpf(0))
    text = four_bar(law, scheme=random.choice(SCHEMES), step=random.choice([0.01, 0.002]))
    told = f"{'root' if is_root else 'pole'} at {at!r}"
    return Edge("pole", told, text, true, about=(at,), most=law.most, until=at if is_inside else None)


# x' = k f(x) from x = 1: what f is, when it ends (s times k), x itself.
ENDS: tuple[tuple[str, mp.mpf, Callable[[mp.mpf], mp.mpf]], ...] = (
    ("x^2", mp.mpf(1), lambda s: 1 / (1 - s)),
    ("x^3", mp.mpf("0.5"), lambda s: 1 / mp.sqrt(1 - 2 * s)),
    ("exp(x)", mp.exp(-1), lambda s: -mp.log(mp.exp(-1) - s)),
    ("(1 + x^2)", mp.pi / 4, lambda s: mp.tan(s + mp.pi / 4)),
    ("tan(x)", -mp.log(mp.sin(1)), lambda s: mp.asin(mp.sin(1) * mp.exp(s))),
    ("1/(2 - x)", mp.mpf("0.5"), lambda s: 2 - mp.sqrt(1 - 2 * s)),
)


def endless(random: Random) -> Edge:
    """Return an equation whose motion ends, in a run that stops a little before that or goes on behind it."""
    rate, last, place = random.choice(ENDS)
    k = float(f"{10 ** random.uniform(-2, 2):.4g}")
    until = float(last / mp.mpf(k))
    end = until * (1 + random.choice([-1, -1, 1]) * 10 ** -random.uniform(0.5, 6))
    rows = random.choice([50, 200, 1000])
    step = float(f"{end / rows:.9g}")
    text = "\n".join(
        [
            "format = 1", "[given]", f'k = "{k!r} 1/s"', "[coordinates]", 'x = { start = "1 rad", rate = "w" }', "[time]",
            f'step = "{step!r} s"', f'end = "{step * rows!r} s"', f'scheme = "{random.choice(["euler", "rk4", "heun"])}"',
            "[[constraint]]", 'name = "1"', f'equation = "w = k*{rate}"', '[ask]\nquantities = ["table", "checks"]', "",
        ]
    )  # fmt: skip

    def true(t: mp.mpf) -> Columns:
        x = place(mp.mpf(k) * t)
        return {"x": x, "w": mp.diff(lambda s: place(mp.mpf(k) * s), t)}

    return Edge("endless", f"{rate}, run to {step * rows / until - 1:+.0e} of its end", text, true, until=until)


def folded(random: Random) -> Edge:
    """Return a crank whose drive is the larger of two, a saw, a sign, or an oscillation faster and faster towards the begin."""
    a, b = float(f"{random.uniform(0.5, 4):.3g}"), float(f"{random.uniform(-2, 2):.3g}")
    k, t0 = float(f"{random.uniform(2, 40):.4g}"), round(random.uniform(0.1, 0.9), random.choice([2, 5]))
    soon = 10 ** -random.uniform(0.5, 2.5)
    s, m, f, g, e = (mp.mpf(x) for x in (a, t0, k, b, float(f"{soon:.3g}")))
    given = {"a": f"{a!r} rad/s", "b": f"{b!r} rad/s", "k": f"{k!r} 1/s", "tm": f"{t0!r} s", "T": "1 s", "e": f"{float(e)!r} s"}
    turns = lambda x: x**2 / 2 if abs(x) <= mp.pi / 2 else None  # noqa: E731

    def saw(x: mp.mpf) -> mp.mpf:
        """The integral of atan(tan(x)) from 0."""
        return turns(x - mp.pi * mp.nint(x / mp.pi))

    def quick(t: mp.mpf) -> mp.mpf:
        """The integral of sin(T/(t + e))."""
        return sum(sign * (x * mp.sin(1 / x) - mp.ci(1 / x)) for sign, x in ((1, t + e), (-1, e)))

    laws = {
        "larger": ("(a*(t - tm)/T + b + abs(a*(t - tm)/T - b))/2", lambda t: _larger(s, g, m, t), 5.0 * a, 0.0),
        "saw": ("a*atan(tan(k*t))", lambda t: s / f * saw(f * t), 1.6 * a, 2 * k),
        "sign": ("b + a*abs(t - tm)/(t - tm)", lambda t: g * t + s * (abs(t - m) - m), a + abs(b), 0.0),
        "quick": ("a*sin(T/(t + e))", lambda t: s * quick(t), a, 1 / float(e) ** 2),
    }
    kind = random.choice(list(laws))
    formula, angle, most, wave = laws[kind]
    law = Law(kind, formula, {n: v for n, v in given.items() if _has(formula, n)}, angle, most, wave)
    text = four_bar(law, scheme=random.choice(SCHEMES), step=random.choice([0.01, 0.002, 0.0005]))
    jumps = kind == "sign"
    names = {"tan": mp.tan, "atan": mp.atan, "sin": mp.sin, "abs": abs} | {
        n: mp.mpf(float(v.split()[0])) for n, v in given.items()
    }
    code = compile(formula, "drive", "eval")
    true = of_four_bar(SIDES, law, lambda t: mp.mpf(eval(code, {}, names | {"t": t})), mp.mpf(0))
    return Edge("folded", f"{kind}", text, true, about=(t0,), most=most, wave=wave, until=t0 if jumps else None)


def _larger(s: mp.mpf, g: mp.mpf, m: mp.mpf, t: mp.mpf) -> mp.mpf:
    """Return the integral from 0 to t of the larger of s (t - m) and g."""
    bend = m + g / s
    low, high = min(max(bend, 0), t), t
    return g * low + (s * (high - m) ** 2 - s * (low - m) ** 2) / 2


def _has(formula: str, name: str) -> bool:
    return re.search(rf"\b{name}\b", formula) is not None


def opened(random: Random) -> Edge:
    """Return a four-bar whose links are too short, or too long to fold, by 1e-1 to 1e-12 at the start, or just are not."""
    miss, start = 10 ** -random.uniform(1, 12) * random.choice([1, 1, -1]), float(f"{random.uniform(0.2, 2.9):.4g}")
    a, d, b = 0.4, 1.2, float(f"{random.uniform(0.3, 0.5):.3g}")
    apart = abs(mp.mpf(d) - mp.mpf(a) * mp.expj(mp.mpf(start)))
    long = random.random() < 0.5
    c = float(apart + b + miss) if long else float(apart - b - miss)
    gap = float(mp.mpf(c) - mp.mpf(b) - apart if long else apart - mp.mpf(b) - mp.mpf(c))
    law = Law("steady", "n", {"n": "0.5 rad/s"}, lambda t: mp.mpf(0.5) * t, 0.5)
    text = four_bar(law, scheme="exact", start=start, end=0.1)
    text = with_sides(text, (a, b, c, d))
    cosine = (mp.mpf(a) ** 2 + mp.mpf(d) ** 2 - (mp.mpf(b) + c) ** 2) / (2 * mp.mpf(a) * d)
    ends = None if long or gap > 0 else float((mp.acos(cosine) - start) / 0.5)  # stretched, it soon is at its dead point
    return Edge("opened", f"open by {gap:.1e}", text, lambda t: {}, -gap / b, ends if ends and ends < 0.1 else None, gap=gap)


FAMILIES = (short, pole, endless, two, rocking, passed, folded, opened, rolling)


def drawn(seed: int) -> Edge:
    """Return the scene of a seed."""
    return FAMILIES[seed % len(FAMILIES)](Random(seed))
