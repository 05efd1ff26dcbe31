"""What a random mechanism is: its text, what is known of it without the package, and the parts it is drawn from."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

import numpy as np

Margin = Callable[[np.ndarray], np.ndarray]
# (times, coordinates by name) -> how far the loops are open, complex, (n, loops)
Loops = Callable[[np.ndarray, dict[str, np.ndarray]], np.ndarray]


@dataclass(frozen=True)
class Passing:
    """A length that runs through zero with its sign while one motion only goes on, in closed form.

    `signed(t)` (m): the determinant changes its sign where this does, and nowhere else.  `link(t)`: the link at the angle p, as
    a complex number of length 1.
    """

    signed: Margin
    link: Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Case:
    """`text` of the variant; `margins` in m: each must stay positive; `loops` must stay zero; `size` the largest length.

    `passing`: what is known of a motion that goes on through a singular position; None where no determinant changes its sign.
    """

    family: str
    form: str
    text: str
    end: float
    step: float
    size: float
    margins: tuple[Margin, ...]
    loops: Loops
    closes: bool = True
    notes: dict[str, float] = field(default_factory=dict)
    passing: Passing | None = None


@dataclass(frozen=True)
class Turning:
    """A crank's law: `formula` of its rate, `angle(t)` its integral, both from the same random numbers."""

    formula: str
    angle: Callable[[np.ndarray], np.ndarray]
    end: float


def turning(random: Random, start: float) -> Turning:
    """Return a steady, a swinging or an uneven crank."""
    kind = random.choice(["steady", "steady", "swinging", "uneven"])
    speed = random.choice([-1, 1]) * round(random.uniform(0.5, 8), 3)
    if kind == "steady":
        return Turning(f"{speed!r}", lambda t: start + speed * t, random.uniform(1.5, 6.5) / abs(speed))
    p, phase = round(random.uniform(1, 6), 3), round(random.uniform(0, 6.28), 3)
    end = random.uniform(0.5, 1.1) * 2 * math.pi / p

    def swung(t: np.ndarray) -> np.ndarray:
        return (math.cos(phase) - np.cos(p * t + phase)) / p

    if kind == "swinging":
        return Turning(f"{speed!r}*sin({p!r}*t + {phase!r})", lambda t: start + speed * swung(t), end)
    extra = round(speed * random.uniform(0.1, 0.9), 4)
    return Turning(f"{speed!r} + {extra!r}*sin({p!r}*t + {phase!r})", lambda t: start + speed * t + extra * swung(t), end)


def length(random: Random) -> float:
    """Return a length between 0.1 m and 3 m, small and large ones equally often."""
    return round(math.exp(random.uniform(math.log(0.1), math.log(3))), 3)


def data(**values: float) -> str:
    """Return the lines of [given], in m."""
    return "\n".join(f'{name} = "{value!r} m"' for name, value in values.items())


def crank_coordinate(start: float) -> str:
    return f'theta = {{ start = "{start!r} rad", rate = "w1" }}'


def dyad(v: complex, b: float, c: float, mode: int) -> tuple[float, float] | None:
    """Return the angles of b from the origin and of c from the point v where both meet, None out of reach."""
    apart = abs(v)
    along = (b * b - c * c + apart * apart) / (2 * apart)
    if not abs(along) < b:
        return None
    tip = complex(along, mode * math.sqrt(b * b - along * along)) * v / apart
    return cmath.phase(tip), cmath.phase(tip - v)
