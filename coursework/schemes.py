"""The schemes, each as it stands in the lecture, with its order.

Enters: the slopes f(t, q), a time, a position, a step.  Leaves: the next position.
To add one: write the function, add a line to `SCHEMES`; order test, comparison chart and `--scheme` follow by themselves.
The functions use + and * only, so `loops.py` can write them out as one straight loop.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Slopes = Callable[[Any, Any], Any]
StepFunction = Callable[[Slopes, Any, Any, Any], Any]


def euler(f: Slopes, t: Any, q: Any, h: Any) -> Any:
    """Q + h f(t, q)."""
    return q + h * f(t, q)


def midpoint(f: Slopes, t: Any, q: Any, h: Any) -> Any:
    """Q + h f(t + h/2, q + h/2 f(t, q))."""
    return q + h * f(t + h / 2, q + h / 2 * f(t, q))


def heun(f: Slopes, t: Any, q: Any, h: Any) -> Any:
    """Q + h/2 (k1 + k2), k1 = f(t, q), k2 = f(t + h, q + h k1)."""
    k1 = f(t, q)
    k2 = f(t + h, q + h * k1)
    return q + h / 2 * (k1 + k2)


def rk4(f: Slopes, t: Any, q: Any, h: Any) -> Any:
    """Q + h/6 (k1 + 2 k2 + 2 k3 + k4), the classical scheme of Runge and Kutta."""
    k1 = f(t, q)
    k2 = f(t + h / 2, q + h / 2 * k1)
    k3 = f(t + h / 2, q + h / 2 * k2)
    k4 = f(t + h, q + h * k3)
    return q + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


@dataclass(frozen=True, slots=True)
class Scheme:
    """One function, its order of accuracy, its number of slopes a step, its name in words."""

    step: StepFunction
    order: int
    slopes: int
    title: str


SCHEMES: dict[str, Scheme] = {
    "euler": Scheme(euler, 1, 1, "explicit Euler"),
    "midpoint": Scheme(midpoint, 2, 2, "midpoint"),
    "heun": Scheme(heun, 2, 2, "Heun"),
    "rk4": Scheme(rk4, 4, 4, "Runge-Kutta 4"),
}
