"""Tables of any variant with written equations, made by a program of its own: solved and stepped here, faults and all.

Nothing of the marks is used: formulas are read as Python, velocities solved with numpy, rows made by Euler's rule.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from coursework.variant.formula.tree import spelled
from tests.mechanisms.library import mechanism

DEGREE = math.pi / 180


def _python(formula):
    return re.sub(r"\^", "**", spelled(formula))


@dataclass
class Machine:
    """A variant; `lines`, its equations left - right, `drive`, its laws, and `data`, its numbers, are what a fault changes."""

    variant: object
    lines: dict[str, str] = field(default_factory=dict)
    data: dict[str, float] = field(default_factory=dict)
    drive: dict[str, str] = field(default_factory=dict)
    drive_sign: float = 1.0
    degrees: tuple[str, ...] = ()  # "drive", "geometry": a calculator set to degrees; "radians": degrees put into radians

    @property
    def h(self):
        return self.variant.time.step

    @cached_property
    def m(self):
        return len(self.variant.coordinates)

    @cached_property
    def rows(self):
        return round(self.variant.time.end / self.h) + 1

    @cached_property
    def start(self):
        return np.array([c.start for c in self.variant.coordinates])

    @property
    def laws(self):
        return {law.name: _python(law.formula) for law in self.variant.drive}

    @cached_property
    def _programs(self):
        lines = {c.name: f"{_python(c.left)} - ({_python(c.right)})" for c in self.variant.constraints} | self.lines
        drive = self.laws | self.drive
        return {name: compile(text, name, "eval") for name, text in lines.items()}, {
            name: compile(text, name, "eval") for name, text in drive.items()
        }

    def velocities(self, t, q):
        lines, drive = self._programs
        names = {"t": t, "pi": math.pi, "sqrt": math.sqrt} | self.variant.values | self.data
        names |= dict(zip((c.name for c in self.variant.coordinates), q, strict=True))
        for name, law in drive.items():
            names[name] = self.drive_sign * eval(law, {}, names | _turning("drive" in self.degrees))
        names |= _turning("geometry" in self.degrees, "radians" in self.degrees)
        sought = self.variant.sought
        zero = dict.fromkeys(sought, 0.0)
        rest = np.array([eval(line, {}, names | zero) for line in lines.values()])
        matrix = np.array([[eval(line, {}, names | zero | {w: 1.0}) for w in sought] for line in lines.values()]) - rest[:, None]
        solved = dict(zip(sought, np.linalg.lstsq(matrix, -rest, rcond=None)[0], strict=True))
        return np.array([solved[name] if name in solved else names[name] for name in self.variant.columns[self.m :]])

    def fulfilled(self, t, q, w, doubt):
        """Which velocities (r,) stand in an equation that they fulfil together, up to several times the `doubt` (r,) of each."""
        lines, drive = self._programs
        names = {"t": t, "pi": math.pi, "sqrt": math.sqrt} | self.variant.values | self.data | _turning(False)
        names |= dict(zip((c.name for c in self.variant.coordinates), q, strict=True))
        names |= {name: eval(law, {}, names) for name, law in drive.items()}
        columns = self.variant.columns[self.m :]
        rates, held = dict(zip(columns, w, strict=True)), np.zeros(len(columns), dtype=bool)
        for line in lines.values():
            here = eval(line, {}, names | rates)
            sizes = np.array([eval(line, {}, names | rates | {name: rates[name] + 1.0}) - here for name in columns])
            held |= (np.abs(sizes) > 0) & (abs(here) < 6 * np.abs(sizes) @ doubt)
        return held

    def table(self, increment=None, start=None, step=None, rows=None, slip=None, printed=None):
        """Euler's table; `increment(t, q)` another step, `slip` (row, column, change) a cell that all after it is made from."""
        h = step or self.h
        q = np.array(self.start if start is None else start, dtype=float)
        made = []
        for k in range(rows or self.rows):
            w = (printed or self.velocities)(k * h, q)
            if slip and slip[0] == k:
                row = np.concatenate([q, w])
                row[slip[1]] += slip[2]
                q, w = row[: self.m], row[self.m :]
                if slip[1] < self.m:
                    w = self.velocities(k * h, q)
            made.append(np.concatenate([q, w]))
            q = q + (h * w[: self.m] if increment is None else increment(k * h, q))
        return np.array(made)


def _turning(in_degrees, of_degrees=False):
    unit = DEGREE if in_degrees else 1 / DEGREE if of_degrees else 1.0
    return {"sin": lambda x: math.sin(unit * x), "cos": lambda x: math.cos(unit * x), "tan": lambda x: math.tan(unit * x)}


# Two mechanisms that are in no file.
SLIDER_CRANK = mechanism("slider-crank-equations").encode()
PULLED_BARS = mechanism("pulled-bars").encode()
