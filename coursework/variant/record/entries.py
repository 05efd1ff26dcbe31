"""The contents of the sections of a variant file after reading: frozen records, SI numbers, checked formulas.

Leaves `reader.py` inside a `Variant`.  Used by `variant.py`, through which every floor above reads them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, KeysView, Mapping
from dataclasses import replace

from coursework.system.frozen import frozen
from coursework.variant.formula.tree import Formula
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


def last_place(number: str) -> float:
    """Return the place value of the last digit of a printed number: 0.01 for "1.25", 100 for "3e2"."""
    digits, _, exponent = number.lower().partition("e")
    return math.pow(10.0, max(-300.0, min(float(exponent or 0) - len(digits.partition(".")[2]), 300.0)))


def reached(names: Iterable[str], points: Mapping[str, Formula]) -> KeysView[str]:
    """Return names, and all names from which the points among them are built, in the order met, starting from the last name."""
    found: dict[str, None] = {}
    waiting = [*names]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = None
            waiting += points[name].names() if name in points else ()
    return found.keys()


@frozen
class Given:
    """One datum of the task sheet: `value` in SI (unit `si`), `text` and `unit` as written, and what the file says it `means`."""

    name: str
    value: float
    si: str
    text: str
    unit: str
    means: str = ""

    @property
    def shown_si(self) -> str:
        """Return the SI unit beside which `value` is shown: rad/s of a speed of turning given in rpm, 1/s as it is given."""
        return "rad/s" if self.si == "1/s" and self.unit not in {"", "1/s", "1/с"} else self.si


@frozen
class Law:
    """A known function: a formula, pieces (start in s, formula), or a table of (argument, value) from a `file`.

    The table is a function `of` a coordinate or t, interpolated by `method`.
    """

    name: str
    formula: Formula | None = None
    pieces: tuple[tuple[float, Formula], ...] = ()
    table: tuple[tuple[float, float], ...] = ()
    of: str = ""
    method: str = ""
    file: str = ""

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """Return every formula of the law."""
        return (*(piece for _, piece in self.pieces), *((self.formula,) if self.formula else ()))

    def rewritten(self, change: Callable[[Formula], Formula]) -> Law:
        """Return the law with every formula changed."""
        pieces = tuple((begin, change(piece)) for begin, piece in self.pieces)
        return replace(self, formula=change(self.formula) if self.formula else None, pieces=pieces)


@frozen
class Coordinate:
    """An integrated coordinate: its `start` in rad or m, and the name of its rate.

    `start` is None if a chain of groups gives it, or if changed data have moved it: then it is the closed position nearest to
    `start_guess` (rad, m).  `text` and `written` are number and unit as in the file; if not `unit_was_given`, the unit was
    inferred from its use.
    """

    name: str
    rate: str
    start: float | None
    unit: str
    text: str = ""
    written: str = ""
    start_guess: float | None = None
    unit_was_given: bool = True
    start_has_no_unit: bool = False

    @property
    def start_or_guess(self) -> float | None:
        """Return the value at t = 0, or a value near it (rad, m); None if only a chain determines it."""
        return self.start_guess if self.start is None else self.start


@frozen
class Binding:
    """Which velocity of the geometry an unknown is: that of a `point` `along` a direction (rad), or the rate of a `link`.

    `relative` is the link relative to which it is measured, "" for the frame.
    """

    name: str
    point: str = ""
    link: str = ""
    along: Formula | None = None
    relative: str = ""


_SAME_TIME = 1e-6  # parts of a step

# The guide of 1995 numbers the rows of the check by N, with t = (N + 1) h; row 1 of a table is t = 0.  Its sheets use N = 2.
ROWS_BEFORE_N = 2
USUAL_ROW = 2 + ROWS_BEFORE_N


def guide_number(row: int) -> int:
    """Return N of the guide for a row of the table: t = (N+1) h."""
    return row - ROWS_BEFORE_N


@frozen
class Time:
    """Step h, end and period in s; `check_row` counts from 1; `own_step` is the step of the file if `step` is another one.

    `scheme` is the name of the scheme that the file asks for, "" if it does not ask for one.
    """

    step: float
    end: float
    period: float | None
    check_row: int | None
    own_step: float | None = None
    scheme: str = ""

    @property
    def row_of_check(self) -> int:
        """Return the row (from 1) that is checked by construction, the usual one if the file names none."""
        return self.check_row or USUAL_ROW

    @property
    def steps(self) -> int:
        """Return the number of whole steps up to `end`."""
        return whole_steps(self.step, self.end)

    @property
    def last(self) -> float:
        """Return the time of the last row asked for (s); it is before `end` where the step does not lead there."""
        last = self.steps * self.step
        return self.end if abs(last - self.end) < _SAME_TIME * self.step else float(f"{last:.12g}")

    @property
    def whole(self) -> float:
        """Return how long a motion must be possible (s): the longer of the table and a period."""
        return max(self.end, self.period or 0.0)


def whole_steps(step: float, end: float) -> int:
    """Return how many whole steps fit into `end`; a quotient within 1e-9 of a whole number counts as that number."""
    return int(end / step * (1 + 1e-12) + 1e-9)


@frozen
class Constraint:
    """`left = right`: a velocity equation or, with `is_closure`, an equation of positions.

    `line` is its line in the file, `place` its number there, from 0.
    """

    name: str
    because: str
    left: Formula
    right: Formula
    is_closure: bool = False
    line: int = 0
    place: int = 0

    @property
    def sides(self) -> tuple[Formula, Formula]:
        """Return left and right."""
        return self.left, self.right

    @property
    def difference(self) -> Formula:
        """Return left - right."""
        return Formula("-", self.sides)

    @property
    def path(self) -> tuple[str, int, str]:
        """Return the path of the equation in the file."""
        return "constraint", self.place, "closure" if self.is_closure else "equation"


@frozen
class Guide:
    """A straight guide: a point on it, its angle (rad), the offset of the pin (m)."""

    through: Formula
    angle: Formula
    offset: Formula


@frozen
class Group:
    """An Assur group or crank of a chain.

    `kind` is a name of `GROUP_KINDS`; `mode` is +1, -1, or 0 if the file leaves it to the start values.
    """

    kind: str
    start_points: tuple[Formula, ...]
    meets: str | None
    lengths: tuple[Formula, ...]
    coordinates: tuple[str, ...]
    mode: int
    guides: tuple[Guide, ...]
    offset: Formula
    angle: Formula | None
    line: int = 0

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """Return every formula that places the group."""
        guides = (formula for guide in self.guides for formula in (guide.through, guide.angle, guide.offset))
        return (*self.start_points, *self.lengths, *guides, self.offset, *((self.angle,) if self.angle else ()))


@frozen
class Link:
    """A rigid body; a wheel has a centre and a contact point; `slides` is the link along which it slides."""

    name: str
    points: tuple[str, ...]
    rate: str | None
    wheel: str | None
    contact: str | None
    slides: str | None = None

    @property
    def held(self) -> tuple[str, ...]:
        """Return the points that it holds, each once: its own, and the centre of a wheel."""
        return tuple(dict.fromkeys((*self.points, *([self.wheel] if self.wheel else ()))))


@frozen
class Frame:
    """The fixed link: hinges, rails (point, angle), fixed circles (centre, radius)."""

    hinges: tuple[str, ...] = ()
    rails: tuple[tuple[Formula, Formula], ...] = ()
    circles: tuple[tuple[Formula, Formula], ...] = ()


@frozen
class Remark:
    """A probable slip that changes no status: a stable code, the line (0 for a value that was set), a sentence.

    Codes: ANGLE, LENGTH, NO-UNIT, NUMBER, TIME-AS-ANGLE, GRAD, RPM, LINKS, IDLE, UNUSED, GUIDE, CONTACT, PIVOT, GRAVITY.
    """

    code: str
    line: int
    sentence: str

    @property
    def told(self) -> Sentence:
        """Return the sentence with what it is a remark on."""
        return say("remark.line" if self.line else "remark.value_set", line=self.line, sentence=self.sentence)


@frozen
class Quote:
    """A number that a remark quotes: `value` as printed, `column` and `row` (from 1); `scheme` "" means that of the file."""

    row: int
    column: str
    value: str
    scheme: str = ""
