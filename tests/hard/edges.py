"""Scenes drawn at random at the edge of what doubles can tell, each with its true motion in fifty digits by mpmath.

Families: what happens in less than a row; passing near a dead point and just not reaching it; lengths far apart; many turns;
velocity equations near dependence.  `drawn(seed)` returns one scene; its `true(t)` knows nothing of the package.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

import mpmath as mp

from tests.hard.drives import ANSWERS, KINDS, Law, four_bar, with_sides
from tests.hard.drives import drawn as drive
from tests.mechanisms.library import mechanism

Columns = dict[str, mp.mpf]
# What README says holds, by the first word of its rows: a width (s), a distance (of the shortest link), turns, a ratio.
HOLDS = {"a": 1e-7, "passing": 1e-8, "turns": 1e5, "lengths": 1e9}


@dataclass(frozen=True)
class Edge:
    """`text` of a variant; `true(t)` all its columns; `apart`: by how much (relative) it misses a dead point, beyond it below 0;
    `ends` (s) when it then stops; `digits` that the data leave of sixteen; `about` the times (s) at which something happens.

    What a refusal may say: the crank's fastest rate `most` and oscillation `wave` (rad/s); `until` when (s) there is no motion
    any more; `gap`, by how much (m) the links are too short or too long at the start; `part` of an equation the others lack.
    """

    family: str
    told: str
    text: str
    true: Callable[[mp.mpf], Columns]
    apart: float = 1.0
    ends: float | None = None
    digits: float = 16.0
    about: tuple[float, ...] = ()
    most: float = 0.0
    wave: float = 0.0
    until: float | None = None
    gap: float = 0.0
    part: float | None = None


def dyad(b: mp.mpc, c: mp.mpc, long: mp.mpf, other: mp.mpf, mode: int) -> tuple[mp.mpf, mp.mpf, mp.mpc]:
    """Return the angles of `long` from b and of `other` from c, and where they meet."""
    way = c - b
    apart = abs(way)
    along = (long**2 - other**2 + apart**2) / (2 * apart)
    meet = b + mp.mpc(along, mode * mp.sqrt(long**2 - along**2)) * way / apart
    return mp.arg(meet - b), mp.arg(meet - c), meet


def closing(v: mp.mpc, w: mp.mpc, long: mp.mpf, other: mp.mpf, p: mp.mpf, q: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """Return the rates of two links at angles p and q whose feet move with v and w, so that their ends stay together."""
    gap, cross = w - v, mp.sin(q - p)
    return (gap * mp.expj(-q)).real / (long * cross) * 1, (gap * mp.expj(-p)).real / (other * cross) * 1


def of_four_bar(
    lengths: tuple[mp.mpf, ...], law: Law, rate: Callable[[mp.mpf], mp.mpf], start: mp.mpf
) -> Callable[[mp.mpf], Columns]:
    a, b, c, d = lengths

    def true(t: mp.mpf) -> Columns:
        angle = start + law.angle(t)
        arm = a * mp.expj(angle)
        p, q, _ = dyad(arm, mp.mpc(d), b, c, 1)
        w = rate(t)
        wp, wq = closing(1j * w * arm, mp.mpc(0), b, c, p, q)
        return {"phi1": angle, "phi2": p, "phi3": q, "w1": w, "w2": wp, "w3": wq}

    return true


def rate_of(law: Law) -> Callable[[mp.mpf], mp.mpf]:
    """Return the drive itself, read from its text by Python."""
    names = {"exp": mp.exp, "abs": abs, "sqrt": mp.sqrt, "atan": mp.atan, "sin": mp.sin, "pi": mp.pi}
    data = {name: mp.mpf(float(value.split()[0])) for name, value in law.given.items()}
    if law.kind == "pieces":
        first, width = data["tm"], data["T"]
        later = mp.mpf(float(first) + float(width))
        return lambda t: data["a"] if first <= t < later else data["b"]
    code = compile(law.drive.replace("^", "**"), "drive", "eval")
    return lambda t: mp.mpf(eval(code, {}, names | data | {"t": t}))


def quick(random: Random) -> Edge:
    """Return a four-bar whose crank makes a turn in far less than a row; as groups or as velocity equations."""
    kind, width = random.choice(KINDS), 10 ** -random.uniform(0, 7)
    law = drive(kind, random, float(f"{width:.3g}"))
    scheme, step = random.choice(["exact", "exact", "euler", "rk4"]), random.choice([0.01, 0.01, 0.002, 0.0005])
    text = four_bar(law, scheme=scheme, step=step)
    sides = tuple(mp.mpf(float(one)) for one in ("0.4", "1.0", "0.7", "1.2"))
    true = of_four_bar(sides, law, rate_of(law), mp.mpf(0))
    if random.random() < 0.3:  # nothing but velocity equations: no closed form helps
        text = as_equations(text.replace('scheme = "exact"', 'scheme = "rk4"'), true(mp.mpf(0)))
    return Edge("quick", f"{kind} {width:.0e}", text, true, about=law.sudden, most=law.most, wave=law.wave)


def as_equations(text: str, start: Columns) -> str:
    """Return a four-bar with its groups replaced by two velocity equations and start values."""
    text = text.split("[points]")[0]
    for name, rate in (("phi2", "w2"), ("phi3", "w3")):
        text = text.replace(
            f'{name} = {{ rate = "{rate}", unit', f'{name} = {{ start = "{float(start[name])!r} rad", rate = "{rate}", unit'
        )
    return text + ANSWERS + "".join(
        f'[[constraint]]\nname = "{name}"\nequation = "r1*w1*{of}(phi1) + r2*w2*{of}(phi2) - r3*w3*{of}(phi3) = 0"\n'
        for name, of in (("1", "sin"), ("2", "cos"))
    )  # fmt: skip


def dead(random: Random) -> Edge:
    """Return a slider that drives a crank to within 1e-1 to 1e-12 of its dead point, several times, or just beyond it."""
    size = 10 ** random.uniform(-3, 3)
    r, long = float(f"{0.1 * size:.3g}"), float(f"{random.uniform(0.2, 0.4) * size:.3g}")
    a = float(f"{0.05 * size:.3g}")
    miss, p = 10 ** -random.uniform(1, 12), float(f"{random.uniform(3, 9):.4g}")
    beyond = random.random() < 0.25
    x = float(mp.mpf(r) + long - 2 * mp.mpf(a) + (miss if beyond else -miss) * r)
    x, end = max(x, 1.02 * abs(long - r)), float(f"{random.uniform(1.2, 3.5) * 6.2831853 / p:.4g}")
    missed = (mp.mpf(r) + long - mp.mpf(x) - 2 * mp.mpf(a)) / r
    step = float(f"{end / random.choice([100, 300, 1000]):.6g}")
    end = step * round(end / step)

    def true(t: mp.mpf) -> Columns:
        at, v = mp.mpf(x) + a * (1 - mp.cos(p * t)), mp.mpf(a) * p * mp.sin(p * t)
        th, ps, _ = dyad(mp.mpc(0), mp.mpc(at), mp.mpf(r), mp.mpf(long), 1)
        w2, w3 = closing(mp.mpc(0), mp.mpc(v), mp.mpf(r), mp.mpf(long), th, ps)
        return {"x": at, "th": th, "ps": ps, "v": v, "w2": w2, "w3": w3}

    ends = None
    if missed < 0:
        ends = float(mp.acos(1 - (mp.mpf(r) + long - mp.mpf(x)) / a) / p)
    scheme = random.choice(["exact", "euler", "rk4"])
    text = mechanism(
        "driven-slider", ('"0.25 m"', f'"{x!r} m"'), ("[points]", f'scheme = "{scheme}"\n[points]'), r=f"{r!r} m",
        l=f"{long!r} m", a=f"{a!r} m", p=f"{p!r} 1/s", step=f"{step!r} s", end=f"{end!r} s",
    )  # fmt: skip
    return Edge("dead", f"missed by {float(missed):.1e}", text + ANSWERS, true, float(missed), ends)


def far(random: Random) -> Edge:
    """Return a crank-rocker two of whose links are up to 1e12 times as long as the others."""
    ratio, unit = 10 ** random.uniform(0, 12), 10 ** random.uniform(-6, 0)
    small = float(f"{unit:.3g}")
    rocker, base = float(f"{unit * random.uniform(1.8, 2.2):.4g}"), float(f"{unit * ratio * 3:.4g}")
    order = random.choice([(small, base, rocker, base), (small, rocker, base, base)])
    law = Law("steady", "n", {"n": "7.3 rad/s"}, lambda t: mp.mpf(7.3) * t)
    text = with_sides(four_bar(law, scheme=random.choice(["exact", "euler", "rk4"]), start=1.0, end=0.5), order)
    true = of_four_bar(tuple(mp.mpf(one) for one in order), law, lambda t: mp.mpf(7.3), mp.mpf(1))
    return Edge("far", f"lengths {ratio:.0e} apart", text, true, digits=16 - float(mp.log10(ratio)))


def turns(random: Random) -> Edge:
    """Return a crank-rocker that turns 1 to 1e5 times, steadily or with two frequencies, in up to 10 000 rows."""
    count = 10 ** random.uniform(0, 5)
    end, rows = 100.0, random.choice([1000, 4000, 10_000])
    speed = float(f"{6.283185307 * count / end:.5g}")
    slow, other = float(f"{random.uniform(0.1, 3):.3g}"), float(f"{random.uniform(0.1, 3):.3g}")
    steady = random.random() < 0.5
    given = {"n": f"{speed!r} rad/s", "k": f"{slow!r} 1/s", "m": f"{other!r} 1/s"}
    n, k, m = mp.mpf(speed), mp.mpf(slow), mp.mpf(other)
    law = Law("steady", "n", {"n": given["n"]}, lambda t: n * t)
    rate: Callable[[mp.mpf], mp.mpf] = lambda t: n  # noqa: E731
    if not steady:
        law = Law(
            "two",
            "n + 0.3*n*sin(k*t) + 0.2*n*cos(m*t)",
            given,
            lambda t: n * (t + 0.3 * (1 - mp.cos(k * t)) / k + mp.mpf(0.2) * mp.sin(m * t) / m),
        )
        rate = lambda t: n * (1 + mp.mpf(0.3) * mp.sin(k * t) + mp.mpf(0.2) * mp.cos(m * t))  # noqa: E731
    text = four_bar(law, scheme=random.choice(["exact", "euler", "rk4"]), end=end, step=end / rows)
    true = of_four_bar(tuple(mp.mpf(float(one)) for one in ("0.4", "1.0", "0.7", "1.2")), law, rate, mp.mpf(0))
    if random.random() < 0.3:
        text = as_equations(text.replace('scheme = "exact"', 'scheme = "rk4"'), true(mp.mpf(0)))
    return Edge("turns", f"{count:.0f} turns, {'steady' if steady else 'two frequencies'}", text, true, most=1.5 * speed)


def dependent(random: Random) -> Edge:
    """Return k velocity equations of constant numbers whose last one is nearly, or wholly, a sum of the others; or Hilbert's."""
    k = random.randint(2, 6)
    nearly = random.choice([0.0, *(10.0 ** -random.uniform(1, 17) for _ in range(7))])
    matrix = [[float(f"{random.uniform(-2, 2):.3g}") for _ in range(k)] for _ in range(k)]
    if random.random() < 0.3:
        k = random.randint(4, 12)
        matrix = [[float(f"{1 / (i + j + 1):.17g}") for j in range(k)] for i in range(k)]
    else:
        matrix[-1] = [sum(row[j] for row in matrix[:-1]) for j in range(k)]
        matrix[-1][0] += nearly
    right = [float(f"{random.uniform(-1, 1):.3g}") for _ in range(k)]
    exact = mp.matrix([[mp.mpf(one) for one in row] for row in matrix])
    try:
        inverse = exact**-1
        rates = inverse * mp.matrix(right)
        number = mp.mnorm(exact, 1) * mp.mnorm(inverse, 1)
    except ZeroDivisionError:
        rates, number = mp.matrix([mp.nan] * k), mp.mpf(10) ** 40
    lines = ["format = 1", "[given]", 'one = "1 rad/s"', "[coordinates]"]
    lines += [f'x{i} = {{ start = "0.5 rad", rate = "u{i}", unit = "rad" }}' for i in range(k)]
    lines += ["[time]", 'step = "0.01 s"', 'end = "0.5 s"', 'scheme = "rk4"']
    for i, row in enumerate(matrix):
        terms = " + ".join(f"({one!r})*u{j}" for j, one in enumerate(row))
        lines += ["[[constraint]]", f'name = "{i}"', f'equation = "{terms} = ({right[i]!r})*one"']
    lines += ["[ask]", 'quantities = ["table", "checks"]', ""]

    def true(t: mp.mpf) -> Columns:
        return {f"x{i}": mp.mpf(0.5) + rates[i] * t for i in range(k)} | {f"u{i}": rates[i] for i in range(k)}

    told, lost = f"{k} equations, condition {mp.nstr(number, 2)}", float(mp.log10(number))
    return Edge(
        "dependent", told, "\n".join(lines), true, digits=16 - lost, part=float(1 / number), most=float(max(map(abs, rates)))
    )


FAMILIES = (quick, dead, far, turns, dependent)


def drawn(seed: int) -> Edge:
    """Return the scene of a seed."""
    return FAMILIES[seed % len(FAMILIES)](Random(seed))
