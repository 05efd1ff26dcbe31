"""Random mechanisms with what is known about them without the package: reach, closed positions, drive integrated by hand.

A `Case` is the text of a variant and an independent judge of it.  Everything is decided by the seed.
"""

from __future__ import annotations

import cmath
import math
from random import Random

import numpy as np

from tests.hard.case import Case, Margin, Passing, Turning, crank_coordinate, data, dyad, length, turning
from tests.hard.scenes import scene

CRANK = '[[group]]\nkind = "crank"\nfrom = ["(0, 0)"]\nmeets = "A"\nlengths = ["a"]\ncoordinates = ["theta"]\n'


def four_bar(random: Random) -> Case:
    """Return a four-bar: as velocity equations, as a closure or as a chain; some cranks turn right round, some fold."""
    a, b, c, d = (length(random) for _ in range(4))
    kind = random.random()
    if kind < 0.5:
        a = round(random.uniform(0.05, 0.9) * min(b, c, d, max(0.01, b + c - d)), 3) + 0.001
    elif kind < 0.58:  # a parallelogram, a kite or a neutral four-bar
        b, c, d = random.choice([(d, a, d), (d, d, a), (b, c, round(b + c - a, 3))])
    start, mode = round(random.uniform(0, 6.28), 4), random.choice([1, -1])
    law = turning(random, start)
    form = random.choice(["equations", "closure", "groups"])
    found = dyad(d - a * cmath.exp(1j * start), b, c, mode)
    p, q = found or (random.uniform(0, 6), random.uniform(0, 6))
    form = "groups" if found is None and form == "equations" else form  # velocity equations alone do not see an open start

    def apart(t: np.ndarray) -> np.ndarray:
        return np.abs(d - a * np.exp(1j * law.angle(t)))

    def loops(t: np.ndarray, x: dict[str, np.ndarray]) -> np.ndarray:
        return (a * np.exp(1j * law.angle(t)) + b * np.exp(1j * x["p"]) - d - c * np.exp(1j * x["q"]))[:, None]

    more, equations, closures = "", [], []
    if form == "equations":
        equations = [
            "a*w1*sin(theta) + b*wp*sin(p) = c*wq*sin(q)", "a*w1*cos(theta) + b*wp*cos(p) - c*wq*cos(q) = 0",
        ]  # fmt: skip
    elif form == "closure":
        closures = ["a @ theta + b @ p = (d, 0) + c @ q"]
    else:
        ends = 'from = ["A", "(d, 0)"]\nmeets = "B"\nlengths = ["b", "c"]\ncoordinates = ["p", "q"]'
        more = f'{CRANK}[[group]]\nkind = "RRR"\n{ends}\nmode = "{mode:+d}"'
    starts = ('rate = "wp", unit = "rad"', 'rate = "wq", unit = "rad"')
    if form != "groups":
        starts = (f'start = "{p!r} rad", rate = "wp"', f'start = "{q!r} rad", rate = "wq"')
    step = law.end / random.randint(30, 50)
    text = scene(
        f"{crank_coordinate(start)}\np = {{ {starts[0]} }}\nq = {{ {starts[1]} }}", given=data(a=a, b=b, c=c, d=d),
        drive=f'w1 = "{law.formula}"', step=step, end=law.end, equations=equations, closures=closures, more=more,
    )  # fmt: skip
    margins: tuple[Margin, ...] = (lambda t: b + c - apart(t), lambda t: apart(t) - abs(b - c))
    passing = None
    if a == d and b == c:  # A reaches the other pivot and goes through it: nothing ends there
        passing, margins = kite(a, b, mode, law), margins[:1]
    return Case("four-bar", form, text, law.end, step, max(a, b, c, d), margins, loops, found is not None, passing=passing)


def kite(a: float, b: float, mode: int, law: Turning) -> Passing:
    """Return how the crank's end A of a kite (a = d, b = c) goes through the other pivot D at theta = 2 pi k.

    From A to D is d - a e^(i theta) = -2i a sin(theta/2) e^(i theta/2): the line AD turns half as fast as the crank, and its
    length changes its sign.  The joint stands on the perpendicular bisector, which goes on turning too: it stays on its side
    of e^(i theta/2), and so comes to the other side of the way from A to D.
    """

    def signed(t: np.ndarray) -> np.ndarray:
        return 2 * a * np.sin(law.angle(t) / 2)

    side = mode * np.sign(signed(np.array(0.0)))

    def link(t: np.ndarray) -> np.ndarray:
        half = signed(t) / 2
        return (half + 1j * side * np.sqrt(np.maximum(b * b - half**2, 0))) / b * -1j * np.exp(1j * law.angle(t) / 2)

    return Passing(signed, link)


def slider_crank(random: Random) -> Case:
    """Return a slider-crank with an offset guide at any angle: equations, closure or chain."""
    a, b = length(random), length(random)
    e = round(random.choice([0.0, 1.0]) * random.uniform(-0.8, 0.8) * b, 3)
    kind = random.random()
    if kind < 0.5:
        a = round(random.uniform(0.05, 0.95) * (b - abs(e)), 3) + 0.001
    elif kind < 0.55:
        a, e = b, 0.0
    g, start, mode = round(random.uniform(-3, 3), 3), round(random.uniform(0, 6.28), 4), random.choice([1, -1])
    law = turning(random, start)
    form = random.choice(["equations", "closure", "groups"])
    pin = a * cmath.exp(1j * start) * cmath.exp(-1j * g)  # seen along the guide
    closes = abs(pin.imag - e) < b
    form = "groups" if not closes and form == "equations" else form
    reach = mode * math.sqrt(b * b - (pin.imag - e) ** 2) if closes else 1.0
    s, p = pin.real + reach, math.atan2(e - pin.imag, reach) + g

    def beside(t: np.ndarray) -> np.ndarray:
        return np.abs(a * np.sin(law.angle(t) - g) - e)

    def loops(t: np.ndarray, x: dict[str, np.ndarray]) -> np.ndarray:
        slide = (x["s"] + 1j * e) * cmath.exp(1j * g)
        return (a * np.exp(1j * law.angle(t)) + b * np.exp(1j * x["p"]) - slide)[:, None]

    more, equations, closures = "", [], []
    if form == "equations":
        equations = ["-a*w1*sin(theta) - b*wp*sin(p) = u*cos(g)", "a*w1*cos(theta) + b*wp*cos(p) = u*sin(g)"]
    elif form == "closure":
        closures = ["a @ theta + b @ p = s @ g + e @ (g + pi/2)"] if e else ["a @ theta + b @ p = s @ g"]
    else:
        more = (
            f'{CRANK}[[group]]\nkind = "RRP"\nfrom = ["A"]\nmeets = "B"\n'
            'guide = { through = "(0, 0)", angle = "g", offset = "e" }\n'
            f'lengths = ["b"]\ncoordinates = ["p", "s"]\nmode = "{mode:+d}"'
        )
    starts = ('rate = "wp", unit = "rad"', 'rate = "u", unit = "m"')
    if form != "groups":
        starts = (f'start = "{p!r} rad", rate = "wp"', f'start = "{s!r} m", rate = "u"')
    step = law.end / random.randint(30, 50)
    text = scene(
        f"{crank_coordinate(start)}\np = {{ {starts[0]} }}\ns = {{ {starts[1]} }}",
        given=data(a=a, b=b, e=e) + f'\ng = "{g!r} rad"',
        drive=f'w1 = "{law.formula}"', step=step, end=law.end, equations=equations, closures=closures, more=more,
    )  # fmt: skip
    return Case("slider-crank", form, text, law.end, step, max(a, b), (lambda t: b - beside(t),), loops, closes)


def driven_chain(random: Random) -> Case:
    """Return a chain like variant 31: M is driven, C moves along a line, B hangs on a crank and a rod (D-A-B)."""
    r1, r2, r, c = (length(random) for _ in range(4))  # DA, AB, BM, BC
    beta, delta = round(random.choice([0.0, 0.0, 1.0]) * random.uniform(-1.5, 1.5), 3), round(random.uniform(0.3, 3.1), 3)
    v, w, p = (round(random.uniform(0.5, 6), 3) for _ in range(3))
    v, w = random.choice([(v, 0.0), (v, w), (0.1 * v, 0.0), (0.1 * v, 0.1 * w)])
    phase, phi1, phi2, phi3 = (round(random.uniform(0, 6.28), 3) for _ in range(4))
    end = random.uniform(0.4, 1.1) * 2 * math.pi / p
    step = end / random.randint(30, 50)
    form = random.choice(["equations", "equations and closure", "closure"])
    at_b = r1 * cmath.exp(1j * phi1) + r2 * cmath.exp(1j * phi2)
    at_m = at_b + r * cmath.exp(1j * phi3)
    across = cmath.exp(-1j * beta)  # turns the line of C to the x-axis
    arm = c * cmath.exp(1j * delta) - r  # from M to C for phi3 = 0
    held = ((at_b + c * cmath.exp(1j * (phi3 + delta))) * across).imag

    def point(t: np.ndarray) -> np.ndarray:
        swung = (math.cos(phase) - np.cos(p * t + phase)) / p
        turned = (np.sin(p * t + phase) - math.sin(phase)) / p
        return at_m + 1j * v * swung + w * turned

    def lever(t: np.ndarray) -> np.ndarray:
        return abs(arm) - np.abs(held - (point(t) * across).imag)

    bent = math.cos(phi3 + cmath.phase(arm) - beta) > 0

    def hinge(t: np.ndarray) -> np.ndarray:
        sine = np.clip((held - (point(t) * across).imag) / abs(arm), -1, 1)
        turn = np.arcsin(sine) if bent else math.pi - np.arcsin(sine)
        return point(t) - r * np.exp(1j * (turn + beta - cmath.phase(arm)))

    def loops(t: np.ndarray, x: dict[str, np.ndarray]) -> np.ndarray:
        b = r1 * np.exp(1j * x["phi1"]) + r2 * np.exp(1j * x["phi2"])
        at_c = (b + c * np.exp(1j * (x["phi3"] + delta))) * across
        return np.array([b + r * np.exp(1j * x["phi3"]) - point(t), 1j * (at_c.imag - held)]).T

    vx, vy = "VMx + r*w3*sin(phi3) - c*w3*sin(phi3 + delta)", "VMy - r*w3*cos(phi3) + c*w3*cos(phi3 + delta)"
    equations = [
        f"-({vx})*sin(beta) + ({vy})*cos(beta) = 0",
        f"({vx})*cos(beta) + ({vy})*sin(beta) = u",
        "VMx + r*w3*sin(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0",
        "VMy - r*w3*cos(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0",
    ]
    geometry = (
        '[points]\nD = "(0, 0)"\nA = "D + r1 @ phi1"\nB = "A + r2 @ phi2"\nM = "B + r @ phi3"\nC = "B + c @ (phi3 + delta)"\n'
        '[closure]\ndriven = "M"\nholds = ["-C.x*sin(beta) + C.y*cos(beta)"]'
    )
    text = scene(
        "\n".join(f'phi{i} = {{ start = "{x!r} rad", rate = "w{i}" }}' for i, x in enumerate((phi1, phi2, phi3), start=1)),
        given=data(r1=r1, r2=r2, r=r, c=c) + f'\nbeta = "{beta!r} rad"\ndelta = "{delta!r} rad"',
        drive=f'VMx = "{w!r}*cos({p!r}*t + {phase!r})"\nVMy = "{v!r}*sin({p!r}*t + {phase!r})"',
        unknowns="" if form == "closure" else 'u = "m/s"', step=step, end=end,
        equations=[] if form == "closure" else equations, more="" if form == "equations" else geometry,
    )  # fmt: skip
    reach = (lambda t: r1 + r2 - np.abs(hinge(t)), lambda t: np.abs(hinge(t)) - abs(r1 - r2))
    return Case("driven chain", form, text, end, step, max(r1, r2, r, c), (lever, *reach), loops)


def five_bar(random: Random) -> Case:
    """Return a five-bar like V105: the common hinge M is driven round an ellipse, two dyads follow it."""
    lengths = [length(random) for _ in range(4)]
    angles = [round(random.uniform(0, 6.28), 3) for _ in range(4)]
    v, w, p = (round(random.uniform(0.3, 5) * random.choice([0.1, 1]), 3) for _ in range(3))
    p = max(p, 0.5)
    phase = round(random.uniform(0, 6.28), 3)
    end = random.uniform(0.4, 1.1) * 2 * math.pi / p
    step = end / random.randint(30, 50)
    form = random.choice(["equations", "equations and closure", "closure"])
    r1, r2, r3, r4 = lengths
    arms = [size * cmath.exp(1j * angle) for size, angle in zip(lengths, angles, strict=True)]
    at_m = arms[0] + arms[1]
    at_o = at_m - arms[2] - arms[3]  # O-E-M

    def point(t: np.ndarray) -> np.ndarray:
        return at_m + v * (math.cos(phase) - np.cos(p * t + phase)) / p + 1j * w * (np.sin(p * t + phase) - math.sin(phase)) / p

    def loops(t: np.ndarray, x: dict[str, np.ndarray]) -> np.ndarray:
        e = [size * np.exp(1j * x[f"phi{i}"]) for i, size in enumerate(lengths, start=1)]
        return np.array([e[0] + e[1] - point(t), at_o + e[2] + e[3] - point(t)]).T

    equations = [
        "VMx + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0", "VMy - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0",
        "VMx + r3*w3*sin(phi3) + r4*w4*sin(phi4) = 0", "VMy - r3*w3*cos(phi3) - r4*w4*cos(phi4) = 0",
    ]  # fmt: skip
    geometry = (
        '[points]\nD = "(0, 0)"\nO = "(xO, yO)"\nA = "D + r1 @ phi1"\nM = "A + r2 @ phi2"\nE = "O + r4 @ phi4"\n[closure]\n'
        'driven = "M"\nholds = ["(M - E - r3 @ phi3).x", "(M - E - r3 @ phi3).y"]'
    )
    text = scene(
        "\n".join(f'phi{i} = {{ start = "{x!r} rad", rate = "w{i}" }}' for i, x in enumerate(angles, start=1)),
        given=data(r1=r1, r2=r2, r3=r3, r4=r4) + f'\nxO = "{at_o.real!r} m"\nyO = "{at_o.imag!r} m"',
        drive=f'VMx = "{v!r}*sin({p!r}*t + {phase!r})"\nVMy = "{w!r}*cos({p!r}*t + {phase!r})"', step=step, end=end,
        equations=[] if form == "closure" else equations, more="" if form == "equations" else geometry,
    )  # fmt: skip
    margins = tuple(
        margin
        for one, other, base in ((r1, r2, 0j), (r4, r3, at_o))
        for margin in (
            lambda t, s=one + other, o=base: s - np.abs(point(t) - o),
            lambda t, s=one - other, o=base: np.abs(point(t) - o) - abs(s),
        )
    )
    return Case("five-bar", form, text, end, step, max(lengths), margins, loops)


FAMILIES = (four_bar, slider_crank, driven_chain, five_bar)


def random_case(seed: int) -> Case:
    """Return the case of a seed; of three starts that do not close two are thrown away."""
    random = Random(seed)
    case = FAMILIES[seed % len(FAMILIES)](random)
    while not case.closes and random.random() < 0.67:
        case = FAMILIES[seed % len(FAMILIES)](random)
    return case
