"""What the data of a class may be: ranges, limits, and how equally hard the drawn mechanisms must be.

Enters: nothing.  Leaves: the frozen records `Ranges`, `Range`, `Limits`, `Difficulty`.
Used by every part of this room; made by `reader.py`.

A ranges file; seven templates have theirs in `variants/ranges/`, with the measured share of draws that can move:

    [given]
    r1    = { from = "0.82 m", to = "1.08 m", step = "0.001 m" }   # any of these, printed with these digits
    p     = { choice = ["12.5 1/s", "13.08 1/s"] }
    [start]                                # coordinates that the geometry leaves free
    phi1  = { from = "1.5 rad", to = "1.76 rad", step = "0.01 rad" }
    [time]
    check_row = { from = 3, to = 9, step = 1 }
    [limits]                               # all optional
    least_determinant  = 0.2               # scaled, over the whole motion
    least_transmission = "12 deg"          # the same as an angle
    largest_velocity   = "30 1/s"          # in the Euler table
    least_rows_a_turn  = 10                # that a turn at the largest velocity would have
    tries = 2000                           # draws a student
    [difficulty]
    band    = 0.30                         # each number within ±30 % of the median of the class, whoever is in it
    numbers = ["euler_error", "least_determinant", "largest_velocity"]     # also one_step_gap

A draw is SHA-256 of seed, template, ranges and student: a student who comes later changes nobody else's data.  It is taken where
the whole motion is possible, Euler's table steps over nothing, the limits hold and the mechanism is as hard as the others; ranges
that leave too few are refused with the reasons counted.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import field

from coursework.system.frozen import frozen

Path = tuple[str, ...]
# What a drawn mechanism is measured by, with the unit it is told in.
MEASURES: Mapping[str, str] = {
    "euler_error": "rad",
    "least_determinant": "",
    "largest_velocity": "rad/s",
    "one_step_gap": "rad",
}
USUAL = ("euler_error", "least_determinant", "largest_velocity")


@frozen
class Range:
    """The `count` values that one datum may take; each is a text as a variant file writes it.

    `path` is where the file has it.  Either `choice` lists the values, or they are first, first + step, … in units of
    10^-decimals of `unit`, so that every value has the digits of its range and no other.
    """

    path: Path
    choice: tuple[str, ...] = ()
    first: int = 0
    step: int = 1
    count: int = 1
    decimals: int = 0
    unit: str = ""

    @property
    def name(self) -> str:
        """Return the name of the datum."""
        return self.path[1]

    @property
    def ends(self) -> tuple[str, ...]:
        """Return the values between which all lie: the first and the last, each one that is listed."""
        return self.choice or (self.text(0), self.text(self.count - 1))

    def text(self, place: int) -> str:
        """Return one value (place from 0).

        >>> Range(("given", "r1"), first=820, step=1, count=261, decimals=3, unit="m").text(7)
        '0.827 m'
        """
        if self.choice:
            return self.choice[place]
        whole = self.first + place * self.step
        digits = f"{abs(whole):0{self.decimals + 1}d}"
        number = f"{digits[: -self.decimals]}.{digits[-self.decimals :]}" if self.decimals else digits
        return f"{'-' if whole < 0 else ''}{number} {self.unit}".rstrip()


@frozen
class Limits:
    """What every drawn mechanism must keep; None where nothing is asked.

    `least_determinant` scaled, over the whole motion; `least_transmission` (rad) the angle whose sine that is;
    `largest_velocity` (rad/s) in the Euler table; `least_rows_a_turn` rows that a turn at that velocity would have; `tries`
    draws a student.
    """

    least_determinant: float | None = None
    least_transmission: float | None = None
    largest_velocity: float | None = None
    least_rows_a_turn: float | None = None
    tries: int = 2000


@frozen
class Difficulty:
    """Each of `numbers` lies within ±`band` (a part of it) of the median of the class, whoever the class consists of."""

    band: float = 0.30
    numbers: tuple[str, ...] = USUAL

    @property
    def reach(self) -> tuple[float, float]:
        """Return the limits of a number, as parts of its median over the pilot stream.

        The class is not known when a student's data are drawn, and its median may lie anywhere between the limits.  The upper
        one is therefore 1 + band times the lower one: then nobody is farther than the band from any such median.
        """
        root = math.sqrt(1 + self.band)
        return 1 / root, root


@frozen
class Ranges:
    """One ranges file; `file` is what messages call it."""

    ranges: tuple[Range, ...]
    limits: Limits = field(default_factory=Limits)
    difficulty: Difficulty = field(default_factory=Difficulty)
    file: str = ""

    @property
    def digest(self) -> str:
        """Return what a draw depends on, as text: the ranges of the data in the order of their names.

        Limits and band decide which draw is taken, not what is drawn: widened, they leave most students their data.
        """
        listed = [[*one.path, *(one.choice or (one.first, one.step, one.count, one.decimals, one.unit))] for one in self.ranges]
        return json.dumps(sorted(listed, key=lambda entry: [str(part) for part in entry]), ensure_ascii=False)
