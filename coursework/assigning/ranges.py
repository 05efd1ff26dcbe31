"""What the data of a class may be: ranges, limits, and how equal in difficulty the drawn mechanisms must be; the draws.

Enters: nothing.  Leaves: the frozen records `Ranges`, `Range`, `Limits`, `Difficulty`; `Lots`, which draws.
Used by every part of this room; made by `reader.py`.

A ranges file (seven templates have theirs in `variants/ranges/`, each with the measured share of draws that can move):

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

A draw is the SHA-256 of seed, template, ranges and student: a further student changes no other student's data.  It is accepted if
the whole motion is possible, Euler's table steps over no event, the limits hold and the mechanism is as difficult as the others.
If the ranges leave too few mechanisms, they are refused, with a count of each reason.
"""

from __future__ import annotations

import hashlib
import json
import math
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant

Path = tuple[str, ...]
# The measures of a drawn mechanism, each with the unit in which it is told.
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

    `path` is its place in the file.  Either `choice` lists the values, or they are first, first + step, … in units of
    10^-decimals of `unit`, so that every value has exactly the digits of its range.
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
        """Return values between which all lie: the first and the last, or all that are listed."""
        return self.choice or (self.text(0), self.text(self.count - 1))

    def text(self, place: int) -> str:
        """Return the value at a place (from 0).

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
    """What every drawn mechanism must fulfil; a limit is None if nothing is asked.

    `least_determinant` is scaled, over the whole motion; `least_transmission` (rad) is the angle whose sine it is;
    `largest_velocity` (rad/s) is the one in the Euler table; `least_rows_a_turn` counts the rows of a turn at that velocity;
    `tries` is the number of draws for each student.
    """

    least_determinant: float | None = None
    least_transmission: float | None = None
    largest_velocity: float | None = None
    least_rows_a_turn: float | None = None
    tries: int = 2000


@frozen
class Difficulty:
    """Each of `numbers` must be within ±`band` (as a part of it) of the median of the class, whatever the class is."""

    band: float = 0.30
    numbers: tuple[str, ...] = USUAL

    @property
    def reach(self) -> tuple[float, float]:
        """Return the limits of a measure, as parts of its median over the pilot draws.

        The class is unknown when a student's data are drawn, and its median may lie anywhere between the limits.  So the upper
        limit is 1 + band times the lower one: no student is then farther than the band from any such median.
        """
        root = math.sqrt(1 + self.band)
        return 1 / root, root


@frozen
class Ranges:
    """The contents of one ranges file; `file` is its name in messages."""

    ranges: tuple[Range, ...]
    limits: Limits = field(default_factory=Limits)
    difficulty: Difficulty = field(default_factory=Difficulty)
    file: str = ""

    @property
    def digest(self) -> str:
        """Return the ranges of the data, sorted by name, as a text on which the draws depend.

        Limits and band are left out: they decide which draw is taken, not what is drawn, so wider ones change few students' data.
        """
        listed = [[*one.path, *(one.choice or (one.first, one.step, one.count, one.decimals, one.unit))] for one in self.ranges]
        return json.dumps(sorted(listed, key=lambda entry: [str(part) for part in entry]), ensure_ascii=False)


PILOT = ""  # the id of the draws that set the centre of difficulty; no student has an empty id


@dataclass(frozen=True, eq=False)
class Lots:
    """The random draws of one class."""

    template: Variant = field(repr=False)
    ranges: Ranges
    seed: str

    def draw(self, student: str, attempt: int) -> dict[Path, str]:
        """Return the drawn value of each datum as a variant file writes it, by its path in the file."""
        normal = unicodedata.normalize("NFC", student)
        drawn = {}
        for one in self.ranges.ranges:
            lot = json.dumps([normal, attempt, one.name], ensure_ascii=False).encode("utf-8", "surrogatepass")
            state = self._begun.copy()
            state.update(lot)
            # 256 bits are so many more than the values that none of them is noticeably likelier.
            drawn[one.path] = one.text(int.from_bytes(state.digest(), "big") % one.count)
        return drawn

    @cached_property
    def _begun(self) -> hashlib._Hash:
        """Return the hash of all data that are the same for all students."""
        variant = self.template
        data = [
            [[given.name, given.text, given.unit] for given in variant.given],
            [[c.name, c.text, c.written] for c in variant.coordinates],
            [variant.time.step, variant.time.end, variant.time.period],
        ]
        shared = json.dumps([self.seed, data, self.ranges.digest], ensure_ascii=False)
        return hashlib.sha256(shared.encode("utf-8", "surrogatepass"))
