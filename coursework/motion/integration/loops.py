"""Loops generated from a scheme's tableau and a right-hand side, without a function call in a step.

Enters: a `Scheme` and `Rates`.  Leaves: `loop` (the position after many steps, nothing watched) and `rows` (every row kept,
every determinant watched).  Used by the march, the exact motion and the accuracy study.

The loops' own names begin with _ but not with _s: names of a file never begin with _, names of stage i begin with _s{i}_.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache

from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import build, renamed, with_numbers
from coursework.equations.codegen.straight_line import Line
from coursework.motion.integration.rates import Rates
from coursework.motion.schemes import Scheme, Sum, share
from coursework.system.frozen import frozen

Loop = Callable[..., tuple[float, ...]]
_WRITTEN = re.compile(r"[\d.]+(?:e[+-]?\d+)?")


def generate_loop(scheme: Scheme, rates: Rates, *, numpy: bool = False) -> Loop:
    """Return `loop(begin, steps, h, *q)`: the position after `steps` steps of h (s) from `begin`, at t = begin + i*h.

    With `numpy` the loop computes in the number type of its arguments.  If the drive has breaks, the loop also takes `_latest`
    (s): no slope is evaluated later than that.
    """
    if (scheme, numpy) not in rates.loops:
        rates.loops[scheme, numpy] = build(_loop_source(scheme, _Shape.of(rates)), "loop", rates.body, numpy=numpy)
    return rates.loops[scheme, numpy]


@lru_cache(maxsize=256)
def _loop_source(scheme: Scheme, shape: _Shape) -> str:
    position = [private(name) for name in shape.coordinates]
    stages = _Stages(scheme, shape)
    lines = ["_t0 = _begin + _i*_h", *stages.lines(0), *stages.later("_latest" if shape.breaks else "")]
    moved = [stages.moved(scheme.outer, place) for place in range(len(position))]
    state = ", ".join(position)
    source = [
        f"def loop({shape.arguments('_begin', '_steps', '_h', *position)}{', _latest=1e999' if shape.breaks else ''}):",
        *(f"    {line}" for line in stages.shares()),
        "    for _i in range(_steps):",
        *(f"        {line}" for line in (*lines, f"{state}, = {', '.join(moved)},")),
        f"    return ({state},)",
    ]
    return "\n".join(source)


def generate_rows(scheme: Scheme, rates: Rates, guarded: Sequence[int], widest: float) -> Callable[..., None]:
    """Return `rows(first, last, h, latest, keep, *q)`, which marches from row `first` at q and passes each row to `keep`.

    A row is (*coordinates, *velocities, *determinants) at t = i*h.  The march ends before `last` if a determinant changes
    its sign, a guarded coordinate turns by more than `widest` (rad) in a step or a coordinate overflows; the caller must find
    out which.  `latest(t)` is the last time at which a step that ends at t may evaluate slopes (`Rates.may_look_until`).
    """
    return build(_rows_source(scheme, _Shape.of(rates), tuple(guarded), widest), "rows", rates.body)


@lru_cache(maxsize=256)
def _rows_source(scheme: Scheme, shape: _Shape, guarded: tuple[int, ...], widest: float) -> str:
    position = [private(name) for name in shape.coordinates]
    stages = _Stages(scheme, shape)
    own = stages.lines(0)
    determinants = [stages.name(0, f"_det{index}") for index in shape.blocks]
    row = [*position, *(stages.name(0, private(name)) for name in shape.velocities), *determinants]
    constant = {stages.name(0, name) for name in shape.constant}
    watched = [name for name in determinants if name not in constant]
    old = [f"_old{place}" for place in range(len(watched))]
    crossed = " or ".join(f"{a}*{b} <= 0.0 and {b} != 0.0" for a, b in zip(watched, old, strict=True))
    moved = [f"_moved{place}" for place in range(len(position))]
    turned = [f"-{widest!r} <= {moved[place]} - {position[place]} <= {widest!r}" for place in guarded]
    free = [name for place, name in enumerate(moved) if place not in guarded]
    body = [
        "_t0 = _i*_h",
        *own,
        *([f"if {crossed}: return", f"{', '.join(old)}, = {', '.join(watched)},"] if old else []),
        f"_keep(({', '.join(row)},))",
        "if _i == _last: return",
        *(["_latest_now = _latest((_i + 1)*_h)"] if shape.breaks else []),
        *stages.later("_latest_now" if shape.breaks else ""),
        *(f"{name} = {stages.moved(scheme.outer, place)}" for place, name in enumerate(moved)),
        *([f"if not ({' and '.join(turned)}): return"] if turned else []),
        # Infinity minus itself is nan: a sum shows whether any of its terms is not finite.
        *([f"_sum = {' + '.join(free)}", "if _sum - _sum != 0.0: return"] if free else []),
        f"{', '.join(position)}, = {', '.join(moved)},",
    ]
    source = [
        f"def rows({shape.arguments('_first', '_last', '_h', '_latest', '_keep', *position)}):",
        *(f"    {line}" for line in (*stages.shares(), *(f"{name} = 0.0" for name in old))),
        "    for _i in range(_first, _last + 1):",
        *(f"        {line}" for line in body),
    ]
    return "\n".join(source)


@frozen
class _Shape:
    """The parts of `Rates` that do not depend on data: one loop is written for all variants that share them."""

    coordinates: tuple[str, ...]
    velocities: tuple[str, ...]
    blocks: tuple[int, ...]
    lines: tuple[Line, ...]
    numbers: tuple[str, ...]
    breaks: bool

    @classmethod
    def of(cls, rates: Rates) -> _Shape:
        """Return the shape of some rates."""
        body = rates.body
        return cls(rates.coordinates, rates.velocities, rates.blocks, body.lines, tuple(body.numbers), bool(rates.breaks))

    @property
    def constant(self) -> set[str]:
        """Return the names to which a line assigns one of the numbers or a literal number."""
        set_to = ((line.targets[0], line.value.removeprefix("-")) for line in self.lines)
        return {name for name, value in set_to if value in self.numbers or _WRITTEN.fullmatch(value)}

    def arguments(self, *own: str) -> str:
        """Return the arguments of a loop: its own, then the numbers as default arguments that no caller passes."""
        return with_numbers(own, self.numbers)


class _Stages:
    """Writes the code for the stages of one step; the operations and their order are those of `Scheme.step`."""

    def __init__(self, scheme: Scheme, shape: _Shape) -> None:
        self.scheme, self.shape = scheme, shape
        self.position = [private(name) for name in shape.coordinates]
        self.targets = {name for line in shape.lines for name in line.targets}
        self.outputs = {f"_{private(name)}" for name in shape.velocities}

    def name(self, stage: int, name: str) -> str:
        """Return the name that a name of the program has in the given stage."""
        return f"_s{stage}_{name}" if name in self.targets else name

    def lines(self, stage: int) -> list[str]:
        """Return the program of one stage, at time _t{stage}, without the copies that `Rates.evaluate` returns."""
        named = [f"_q{stage}_{place}" for place in range(len(self.position))] if self.scheme.inner[stage].terms else self.position
        inside = {"t": f"_t{stage}", **dict(zip(self.position, named, strict=True))}
        inside |= {target: self.name(stage, target) for target in self.targets}
        lines = zip(self.shape.lines, renamed(self.shape.lines, inside), strict=True)
        return [moved.text for line, moved in lines if not self.outputs & set(line.targets)]

    def later(self, latest: str) -> list[str]:
        """Return time, position and program of every stage but the first; times are limited to `latest`, if it is given."""
        lines = []
        for stage in range(1, self.scheme.slopes):
            node = self.scheme.nodes[stage]
            lines.append(f"_t{stage} = _t0 + {_share(node)}" if node else f"_t{stage} = _t0")
            if latest:
                lines.append(f"if _t{stage} > {latest}: _t{stage} = {latest}")
            inner = self.scheme.inner[stage]
            if inner.terms:
                lines += [f"_q{stage}_{place} = {self.moved(inner, place)}" for place in range(len(self.position))]
            lines += self.lines(stage)
        return lines

    def moved(self, row: Sum, place: int) -> str:
        """Return the formula for the coordinate at index `place` after one row of the tableau."""
        rate = private(self.shape.velocities[place])
        slopes = [self.name(stage, rate) for stage in range(self.scheme.slopes)]
        return f"{self.position[place]} + {row.text(slopes, _share(row.factor))}"

    def shares(self) -> list[str]:
        """Return the lines that compute the scheme's fractions of h, once for all steps."""
        parts = {*self.scheme.nodes, *(row.factor for row in (*self.scheme.inner, self.scheme.outer))} - {0, 1}
        return [f"{_share(part)} = {share(part, '_h')}" for part in sorted(parts)]


def _share(part: Fraction | int) -> str:
    """Return the name of part*h."""
    return "_h" if part == 1 else f"_h{part.numerator}_{part.denominator}"
