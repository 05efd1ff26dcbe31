"""Mechanisms at the edge of doubles: two driven cranks, a crank that reverses at its dead point, a rod as long as its crank.

Each has its true motion in fifty digits by mpmath.  Used by `more_edges.py`.
"""

from __future__ import annotations

import re
from random import Random

import mpmath as mp

from tests.hard.drives import ANSWERS, Law, four_bar, with_sides
from tests.hard.drives import drawn as drive
from tests.hard.edges import Columns, Edge, closing, dyad, of_four_bar, rate_of
from tests.hard.scenes import V31
from tests.mechanisms.library import mechanism

SCHEMES = ["exact", "exact", "euler", "rk4"]


def as_second(law: Law) -> tuple[dict[str, str], str]:
    """Return data and formula of a law under names that leave those of a first law free."""
    names = {name: f"{name}_2" for name in law.given}
    renamed = re.sub(r"\b[a-zA-Z]+\b", lambda one: names.get(one[0], one[0]), law.drive)
    return {names[name]: value for name, value in law.given.items()}, renamed


def two(random: Random) -> Edge:
    """Return a five-bar of two driven cranks, each with a law of its own."""
    kinds = ["pulse", "switch", "fold", "chirp", "step"]
    first, second = (drive(random.choice(kinds), random, 10 ** -random.uniform(0, 6)) for _ in range(2))
    a, e, long, other, d = random.choice([0.1, 0.2, 0.3]), random.choice([0.15, 0.25]), 0.8, 0.9, 1.0
    more, law = as_second(second)
    given = "".join(f'{name} = "{value}"\n' for name, value in (first.given | more).items())
    text = mechanism(
        "five-bar", ("[drive]", f"{given}[drive]"), ("[points]", f'scheme = "{random.choice(SCHEMES)}"\n[points]'),
        ('"30 deg"', '"0 rad"'), ('"120 deg"', '"1 rad"'), r1=f"{a} m", r4=f"{e} m", r2=f"{long} m", r3=f"{other} m", d=f"{d} m",
        n1=None, n4=None, w1=first.drive, w4=law, step=f"{random.choice([0.01, 0.002])} s", end="1 s", period=None,
        quantities='["table", "checks"]',
    )  # fmt: skip
    rate, turning = rate_of(first), rate_of(second)
    ra, re_, rb, rc, xo = (mp.mpf(x) for x in (a, e, long, other, d))

    def true(t: mp.mpf) -> Columns:
        q, p = first.angle(t), 1 + second.angle(t)
        left, right = ra * mp.expj(q), xo + re_ * mp.expj(p)
        u, v, _ = dyad(left, right, rb, rc, 1)
        wu, wv = closing(1j * rate(t) * ra * mp.expj(q), 1j * turning(t) * re_ * mp.expj(p), rb, rc, u, v)
        return {"phi1": q, "phi4": p, "phi2": u, "phi3": v, "w1": rate(t), "w4": turning(t), "w2": wu, "w3": wv}

    quickly = (*first.sudden, *second.sudden)
    most, wave = max(first.most, second.most), max(first.wave, second.wave)
    return Edge("two", f"{first.kind} and {second.kind}", text, true, about=quickly, most=most, wave=wave)


def rocking(random: Random) -> Edge:
    """Return a crank that swings to within 1e-1 to 1e-12 of its dead point and back, or just beyond; some hold still there."""
    a, d = mp.mpf(0.8), mp.mpf(1.0)
    b, c = mp.mpf(0.5), mp.mpf(random.choice([0.6, 0.7]))
    last = mp.acos((a**2 + d**2 - (b + c) ** 2) / (2 * a * d))  # there b and c are one line
    beyond, miss = random.random() < 0.25, 10 ** -random.uniform(1, 12)
    start, k = 1.0, float(f"{random.uniform(2, 9):.4g}")
    reach = float((last - start) * (1 + (miss if beyond else -miss)))
    law = Law(
        "swing", "a*k*sin(k*t)/2", {"a": f"{reach!r} rad", "k": f"{k!r} 1/s"}, lambda t: mp.mpf(reach) * (1 - mp.cos(k * t)) / 2
    )
    step = random.choice([0.01, 0.005, 0.002])
    text = four_bar(law, scheme=random.choice(SCHEMES), start=start, step=step, end=3.0)
    text = with_sides(text, (a, b, c, d))
    farthest = mp.mpf(start) + mp.mpf(reach)
    missed = (b + c - abs(d - a * mp.expj(farthest))) / b  # of the shortest link
    ends = float(mp.acos(1 - 2 * (last - start) / mp.mpf(reach)) / k) if missed < 0 else None
    true = of_four_bar((a, b, c, d), law, rate_of(law), mp.mpf(start))
    return Edge("rocking", f"missed by {float(missed):.1e}", text, true, float(missed), ends, most=abs(reach * k / 2))


def passed(random: Random) -> Edge:
    """Return a slider-crank whose rod is longer than its crank by a part of 1e-1 to 1e-9: it comes to stand nearly across."""
    more, size = 10 ** -random.uniform(1, 9), 10 ** random.uniform(-3, 3)
    r = float(f"{size:.3g}")
    long = r * (1 + more)
    kind = random.choice(["steady", "pulse", "step", "fold"])
    n = mp.mpf(float(f"{random.uniform(1, 30):.4g}"))
    law = Law("steady", "n", {"n": f"{float(n)!r} rad/s"}, lambda t: n * t, float(n))
    if kind != "steady":
        law = drive(kind, random, 10 ** -random.uniform(0, 5))
    given = "".join(f'{name} = "{value}"\n' for name, value in law.given.items())
    step, scheme = random.choice([0.01, 0.002]), random.choice(SCHEMES)
    text = mechanism(
        "slider-crank", ("[drive]", f"{given}[drive]"), ('"0 deg"', '"0 rad"'), (', offset = "e"', ""),
        ("[points]", f'scheme = "{scheme}"\n[points]'), r=f"{r!r} m", l=f"{long!r} m", e=None, n=None, w1=law.drive,
        step=f"{step} s", end="1 s", period=None,
    )  # fmt: skip
    rate, (rr, ll) = rate_of(law), (mp.mpf(r), mp.mpf(long))

    def true(t: mp.mpf) -> Columns:
        th, w = law.angle(t), rate(t)
        high, over = rr * mp.sin(th), mp.sqrt(ll**2 - (rr * mp.sin(th)) ** 2)
        ps, wps = mp.atan2(-high, over), -rr * mp.cos(th) * w / over
        slide = -rr * mp.sin(th) * w - high / over * rr * mp.cos(th) * w
        return {"phi1": th, "phi2": ps, "s": rr * mp.cos(th) + over, "w1": w, "w2": wps, "u": slide}

    return Edge(
        "passed", f"rod longer by {more:.0e}, {kind}", text + ANSWERS, true, more, about=law.sudden, most=law.most, wave=law.wave
    )


def rolling(random: Random) -> Edge:
    """Return variant 31 with something sudden beside its sine: phi3 in closed form (numerics.md 1.1)."""
    kind = random.choice(["pulse", "lorentz", "decay", "switch", "step", "fold", "twins"])
    law = drive(kind, random, 10 ** -random.uniform(0, 7), 0.48)
    # m that it adds: the wheel has 0.11 m and more to spare, and others than a pulse turn by six radians.
    part = mp.mpf(float(f"{random.uniform(0.01, 0.04) / (4 if kind in {'lorentz', 'step'} else 1):.3g}"))
    names, added = as_second(law)
    given = "\n".join(f'{name} = "{value.replace("rad/s", "m/s")}"' for name, value in names.items())  # of a point
    text = V31.replace("[drive]", f'part_2 = "{float(part)!r}"\n{given}\n[drive]').split("[ask]")[0]
    text = text.replace('"V1*sin(p*t + alpha)"', f'"V1*sin(p*t + alpha) + part_2*({added})"').replace("period ", "# ")
    text = text.replace('end       = "0.48 s"', f'end = "0.48 s"\nscheme = "{random.choice(SCHEMES)}"')
    v, p, alpha, r3 = (mp.mpf(one) for one in (4.5, 13.08, 4.35, 0.457))
    begin = 2 * mp.sin(mp.mpf(2.87)) - mp.cos(mp.mpf(2.87))

    def true(t: mp.mpf) -> Columns:
        way = v / p * (mp.cos(alpha) - mp.cos(p * t + alpha)) + part * law.angle(t)
        return {"phi3": mp.pi + mp.atan(mp.mpf("0.5")) - mp.asin((begin + way / r3) / mp.sqrt(5))}

    return Edge("rolling", f"{kind} in 31", text, true, about=law.sudden)
