"""A scheme and a right-hand side -> one generated loop without a function call a step.

Enters: a scheme of `schemes.py` and a `Program`.  Leaves: `loop(begin, steps, h, *q)` -> position.
The scheme is run once on names instead of numbers; what it writes down is the body of the loop.  Used where many steps are
wanted and the motion is known to be possible (accuracy study, reference): it watches no determinant.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from coursework.codegen.names import private
from coursework.codegen.programs import build
from coursework.integration.rates import Rates
from coursework.schemes import StepFunction

Loop = Callable[..., tuple[float, ...]]


def generate_loop(step: StepFunction, rates: Rates) -> Loop:
    """Return `loop(begin, steps, h, *q)`: the position `steps` steps of h (s) after `begin`, at t = begin + i*h.

    Its own names begin with _, as no private name does: a coordinate may be called h.
    """
    recorder = _Recorder(rates)
    position = _Vector(recorder, [private(name) for name in rates.coordinates])
    result = step(recorder.slopes, _Scalar(recorder, "t"), position, _Scalar(recorder, "_h"))
    state = ", ".join(position.names)
    comma = "," if len(position.names) == 1 else ""
    lines = [
        f"def loop(_begin, _steps, _h, {state}):",
        "    for _i in range(_steps):",
        "        t = _begin + _i*_h",
        *(f"        {line}" for line in recorder.lines),
        f"        {state}{comma} = {', '.join(result.names)}{comma}",
        f"    return ({state},)",
    ]
    return build("\n".join(lines), "loop", rates.body)


class _Recorder:
    """Collects the lines; gives each evaluation of the slopes names of its own."""

    def __init__(self, rates: Rates) -> None:
        self.rates = rates
        self.lines: list[str] = []
        self.count = 0

    def fresh(self, text: str) -> str:
        self.count += 1
        self.lines.append(f"_v{self.count} = {text}")
        return f"_v{self.count}"

    def slopes(self, t: _Scalar, q: _Vector) -> _Vector:
        # A position is read many times inside, so it gets names; a sum that is read once stays an expression.
        q = _Vector(self, [name if name.isidentifier() else self.fresh(name) for name in q.names])
        self.count += 1
        inside = {"t": t.name, **dict(zip(map(private, self.rates.coordinates), q.names, strict=True))}
        skipped = {f"_{private(name)}" for name in self.rates.velocities}
        inside |= {name: f"_{self.count}_{name}" for line in self.rates.body.lines for name in line.targets}
        self.lines += [line.text for line in self.rates.body.renamed(inside) if not skipped & set(line.targets)]
        return _Vector(self, [inside.get(rate, rate) for rate in map(private, self.rates.velocities[: len(q.names)])])


@dataclass(frozen=True)
class _Scalar:
    recorder: _Recorder
    name: str

    def __add__(self, other: _Scalar | float) -> _Scalar:
        return _Scalar(self.recorder, self.recorder.fresh(f"{self.name} + {_text(other)}"))

    def __truediv__(self, other: float) -> _Scalar:
        return _Scalar(self.recorder, self.recorder.fresh(f"{self.name}/{_text(other)}"))

    def __mul__(self, other: Any) -> Any:
        return other.scaled(self.name) if isinstance(other, _Vector) else NotImplemented


@dataclass(frozen=True)
class _Vector:
    recorder: _Recorder
    names: list[str]

    def __add__(self, other: _Vector) -> _Vector:
        pairs = zip(self.names, other.names, strict=True)
        return _Vector(self.recorder, [f"({a} + {b})" for a, b in pairs])

    def scaled(self, factor: str) -> _Vector:
        return _Vector(self.recorder, [f"{factor}*{name}" for name in self.names])

    def __rmul__(self, factor: float) -> _Vector:
        return self.scaled(_text(factor))


def _text(value: _Scalar | float) -> str:
    return value.name if isinstance(value, _Scalar) else repr(value)
