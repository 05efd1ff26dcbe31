"""Laws of a crank with what happens in less than a step: pulses, poles, switches, folds, breaks; their integrals by mpmath.

`drawn(kind, random, width)` returns a law whose quick part is `width` s wide (a pulse, a switch) at a moment of its own, between
rows or on one; the turn that it makes there is of the order of 1 rad.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from random import Random

import mpmath as mp

from tests.mechanisms.library import changed, mechanism

END, STEP = 1.0, 0.01
ANSWERS = '[ask]\nquantities = ["table", "checks"]\n'


@dataclass(frozen=True)
class Law:
    """`drive` as a file writes it, with its `given`; `angle(t)` its integral from 0 in fifty digits; `most` |rate| (rad/s);
    `wave` its fastest oscillation (rad/s).
    """

    kind: str
    drive: str
    given: dict[str, str]
    angle: Callable[[mp.mpf], mp.mpf] = field(repr=False)
    most: float = 1.0
    wave: float = 0.0

    @property
    def sudden(self) -> tuple[float, ...]:
        """Return when something sudden happens (s)."""
        return tuple(float(value.split()[0]) for name, value in self.given.items() if name in {"tm", "tn"})


def moment(random: Random) -> float:
    """Return when it happens: between rows, on a row, near the begin or the end."""
    return random.choice([round(random.uniform(0.05, 0.95), 5), random.randint(5, 95) / 100, 0.50437, 0.013, 0.987])


def drawn(kind: str, random: Random, width: float, end: float = END) -> Law:
    """Return a law of a kind for a run that ends at `end` (s): the turn it makes is the same in a short one."""
    t0, size, base = moment(random), random.uniform(0.3, 2.0), round(random.uniform(-1, 1), 3)
    t0, base = (t0, base) if end == END else (float(f"{t0 * end:.9g}"), float(f"{base / end:.4g}"))
    high = float(f"{size / width:.4g}")
    a, b, m, w = mp.mpf(high), mp.mpf(base), mp.mpf(t0), mp.mpf(width)
    given = {"a": f"{high!r} rad/s", "b": f"{base!r} rad/s", "tm": f"{t0!r} s", "T": f"{width!r} s"}
    slow = round(random.uniform(0.5, 4), 3)
    slow = slow if end == END else float(f"{slow / end:.4g}")
    quiet = given | {"a": f"{slow!r} rad/s"}
    s = mp.mpf(slow)
    match kind:
        case "pulse":
            bell = lambda t: mp.sqrt(mp.pi) / 2 * w * (mp.erf((t - m) / w) + mp.erf(m / w))  # noqa: E731
            return Law(kind, "b + a*exp(-((t - tm)/T)^2)", given, lambda t: b * t + a * bell(t), high)
        case "lorentz":
            angle = lambda t: b * t + a * w * (mp.atan((t - m) / w) + mp.atan(m / w))  # noqa: E731
            return Law(kind, "b + a/(1 + ((t - tm)/T)^2)", given, angle, high)
        case "decay":
            return Law(kind, "b + a*exp(-t/T)", given, lambda t: b * t + a * w * (1 - mp.exp(-t / w)), high)
        case "switch":
            soft = lambda x: w * (mp.log1p(mp.exp(-abs(x) / w)) + max(x, 0) / w)  # noqa: E731
            return Law(kind, "b + a/(1 + exp(-(t - tm)/T))", quiet, lambda t: b * t + s * (soft(t - m) - soft(-m)), slow)
        case "step":
            ramp = lambda x: x * mp.atan(x / w) - w / 2 * mp.log(w * w + x * x)  # noqa: E731
            return Law(kind, "a*atan((t - tm)/T)", quiet, lambda t: s * (ramp(t - m) - ramp(-m)), 2 * slow)
        case "root":
            power = lambda x: mp.sign(x) * abs(x) ** mp.mpf(1.5) * 2 / 3  # noqa: E731
            law = quiet | {"T": "1 s"}
            return Law(kind, "a*sqrt(abs(t - tm)/T)", law, lambda t: s * (power(t - m) - power(-m)), slow)
        case "fold":
            pace = float(f"{random.uniform(3, 40) / end:.4g}")
            k, c = mp.mpf(pace), mp.mpf(base)
            whole = lambda x: 2 * mp.floor(x / mp.pi) + 1 - mp.cos(x - mp.pi * mp.floor(x / mp.pi))  # noqa: E731
            data = {"a": quiet["a"], "k": f"{pace!r} 1/s", "c": f"{base!r} rad"}
            return Law(kind, "a*abs(sin(k*t + c))", data, lambda t: s / k * (whole(k * t + c) - whole(c)), slow, 2 * pace)
        case "chirp":
            pace = float(f"{random.uniform(10, 150) / end**2:.4g}")
            k = mp.mpf(pace)
            data = {"a": quiet["a"], "k": f"{pace!r} 1/s^2"}
            angle = lambda t: s * mp.sqrt(mp.pi / 2 / k) * mp.fresnels(mp.sqrt(2 * k / mp.pi) * t)  # noqa: E731
            return Law(kind, "a*sin(k*t^2)", data, angle, slow, 2 * pace * end)
        case "pieces":
            later = mp.mpf(t0 + width)
            law = f'{{ pieces = [["0 s", "b"], ["{t0!r} s", "a"], ["{t0 + width!r} s", "b"]] }}'
            inside = lambda t: min(max(t - m, 0), later - m)  # noqa: E731
            return Law(kind, law, given, lambda t: b * t + (a - b) * inside(t), high)
        case "twins":  # two pulses, one the other turned round: their turns cancel
            bell = lambda t, at: mp.sqrt(mp.pi) / 2 * w * (mp.erf((t - at) / w) + mp.erf(at / w))  # noqa: E731
            second = round(t0 + random.choice([3, 30, 3000]) * width, 12)
            n = mp.mpf(second)
            return Law(
                kind, "b + a*exp(-((t - tm)/T)^2) - a*exp(-((t - tn)/T)^2)", given | {"tn": f"{second!r} s"},
                lambda t: b * t + a * (bell(t, m) - bell(t, n)), high,
            )  # fmt: skip
    raise ValueError(kind)


KINDS = ("pulse", "lorentz", "decay", "switch", "step", "root", "fold", "chirp", "pieces", "twins")


def four_bar(law: Law, *, step: float = STEP, end: float = END, scheme: str = "exact", start: float = 0.0) -> str:
    """Return a crank-rocker 0.4, 1.0, 0.7, 1.2 m whose crank turns by a law."""
    given = "".join(f'{name} = "{value}"\n' for name, value in law.given.items())
    text = mechanism(
        "four-bar", ("[drive]", f"{given}[drive]"), ('"0 deg"', f'"{start!r} rad"'),
        ("[points]", f'scheme = "{scheme}"\n[points]'), r1="0.4 m", r2="1.0 m", r3="0.7 m", d="1.2 m", n=None, w1=law.drive,
        step=f"{step!r} s", end=f"{end!r} s", period=None,
    )  # fmt: skip
    return text + ANSWERS


def with_sides(text: str, sides: Iterable[float]) -> str:
    """Return that crank-rocker with a crank, a coupler, a rocker and a frame of other lengths (m)."""
    return changed(text, **{name: f"{float(side)!r} m" for name, side in zip(("r1", "r2", "r3", "d"), sides, strict=True)})
