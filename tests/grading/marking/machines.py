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
SLIDER_CRANK = b"""
format = 1
title = "Slider crank with a rod of its own"
source = "own"
teaches = "own"
[given]
r = "0.21 m"
l = "0.63 m"
e = "0.05 m"
w0 = "7 1/s"
eps = "1.5 1/s"
[drive]
w1 = "w0 + eps*sin(3*t)"
[coordinates]
phi1 = { start = "0.4 rad", rate = "w1" }
phi2 = { start = "-0.21 rad", rate = "w2" }
[unknowns]
u = "m/s"
[time]
step = "0.02 s"
end = "0.6 s"
[[constraint]]
name = "x"
because = "x"
equation = "-r*w1*sin(phi1) - l*w2*sin(phi2) = u"
[[constraint]]
name = "y"
because = "y"
equation = "r*w1*cos(phi1) + l*w2*cos(phi2) = 0"
"""
PULLED_BARS = b"""
format = 1
title = "Two bars pulled at their end and a follower"
source = "own"
teaches = "own"
[given]
a = "0.5 m"
b = "0.62 m"
d = "0.35 m"
k = "0.7 m"
V = "0.9 m/s"
p = "6 1/s"
beta = "0.7 rad"
[drive]
Vx = "V*cos(p*t + beta)"
Vy = "0.6*V*sin(p*t)"
[coordinates]
phi1 = { start = "0.9 rad", rate = "w1" }
phi2 = { start = "2.6 rad", rate = "w2" }
psi = { start = "1.2 rad", rate = "wp" }
[unknowns]
u = "m/s"
[time]
step = "0.025 s"
end = "0.75 s"
[[constraint]]
name = "A"
because = "x"
equation = "Vx + a*w1*sin(phi1) + b*w2*sin(phi2) = 0"
[[constraint]]
name = "B"
because = "y"
equation = "Vy - a*w1*cos(phi1) - b*w2*cos(phi2) = 0"
[[constraint]]
name = "C"
because = "x"
equation = "d*w1*sin(phi1) + k*wp*sin(psi) + u = 0"
[[constraint]]
name = "E"
because = "y"
equation = "d*w1*cos(phi1) + k*wp*cos(psi) = 0"
"""
