"""What a variant is once it has been read: frozen records, SI numbers, checked formulas.

Leaves `reader.py`; every floor above may read it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from coursework.formula.tree import Formula

# More rows than this nobody reads; a step much smaller than the coursework needs is a slip of the pen.
MAX_ROWS = 200_000


@dataclass(frozen=True, slots=True)
class Given:
    """One datum of the task sheet: `value` in SI (`si` its unit), `text` and `unit` as written."""

    name: str
    value: float
    si: str
    text: str
    unit: str


@dataclass(frozen=True, slots=True)
class Law:
    """A known function: a formula, pieces (from time, s; formula), or a table of (argument, value) and the `file` it is in."""

    name: str
    formula: Formula | None = None
    pieces: tuple[tuple[float, Formula], ...] = ()
    table: tuple[tuple[float, float], ...] = ()
    of: str = ""
    method: str = ""
    file: str = ""

    @property
    def formulas(self) -> tuple[Formula, ...]:
        """Return every formula the law is written with."""
        return (*(piece for _, piece in self.pieces), *((self.formula,) if self.formula else ()))


@dataclass(frozen=True, slots=True)
class Coordinate:
    """An integrated coordinate: `start` in rad or m (None where a chain of groups gives it), its rate's name."""

    name: str
    rate: str
    start: float | None
    unit: str
    text: str = ""
    written: str = ""


@dataclass(frozen=True, slots=True)
class Time:
    """Step h, end and period in s; `check_row` counts from 1."""

    step: float
    end: float
    period: float | None
    check_row: int | None

    @property
    def steps(self) -> int:
        """Return the number of whole steps that fit."""
        return whole_steps(self.step, self.end)


def whole_steps(step: float, end: float) -> int:
    """Return how many steps reach `end`; a quotient within 1e-9 of a whole number counts as that number."""
    return int(end / step * (1 + 1e-12) + 1e-9)


@dataclass(frozen=True, slots=True)
class Constraint:
    """`left = right`, a velocity equation or (is_closure) an equation of positions; `place` finds its line."""

    name: str
    because: str
    left: Formula
    right: Formula
    is_closure: bool = False
    line: int = 0


@dataclass(frozen=True, slots=True)
class Guide:
    """A straight guide: point, angle (rad), offset of the pin (m)."""

    through: Formula
    angle: Formula
    offset: Formula


@dataclass(frozen=True, slots=True)
class Group:
    """An Assur group or crank of a chain; `mode` is +1, -1, or 0 where the file leaves it to the start values."""

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


@dataclass(frozen=True, slots=True)
class Link:
    """A rigid body; a wheel has a centre and a contact point; `slides` is the link along which it slides."""

    name: str
    points: tuple[str, ...]
    rate: str | None
    wheel: str | None
    contact: str | None
    slides: str | None = None


@dataclass(frozen=True, slots=True)
class Frame:
    """The fixed link: hinges, rails (point, angle), fixed circles (centre, radius)."""

    hinges: tuple[str, ...] = ()
    rails: tuple[tuple[Formula, Formula], ...] = ()
    circles: tuple[tuple[Formula, Formula], ...] = ()


@dataclass(frozen=True, slots=True)
class Variant:
    """One variant of the coursework, complete."""

    name: str
    path: Path | None
    title: str
    source: str
    teaches: str
    given: tuple[Given, ...]
    drive: tuple[Law, ...]
    coordinates: tuple[Coordinate, ...]
    unknowns: tuple[tuple[str, str], ...]
    functions: tuple[Law, ...]
    time: Time
    constraints: tuple[Constraint, ...]
    groups: tuple[Group, ...]
    points: tuple[tuple[str, Formula], ...]
    links: tuple[Link, ...]
    frame: Frame
    driven: str | None
    holds: tuple[Formula, ...]
    ask: tuple[str, ...]
    remarks: tuple[str, ...] = ()
    lines: Mapping[tuple[str | int, ...], int] = field(default_factory=dict, repr=False, compare=False)

    @property
    def values(self) -> dict[str, float]:
        """Return the given data by name, SI."""
        return {given.name: given.value for given in self.given}

    @property
    def names(self) -> tuple[str, ...]:
        """Return t and every scalar name that the file declares, each once."""
        laws = (law.name for law in (*self.drive, *self.functions))
        return tuple(dict.fromkeys(["t", *self.values, *laws, *self.columns]))

    @property
    def rates(self) -> tuple[str, ...]:
        """Return the names of the rates, in the order of the coordinates."""
        return tuple(coordinate.rate for coordinate in self.coordinates)

    @property
    def known_rates(self) -> tuple[str, ...]:
        """Return the rates that stand in [drive]."""
        laws = {law.name for law in self.drive}
        return tuple(rate for rate in self.rates if rate in laws)

    @property
    def sought(self) -> tuple[str, ...]:
        """Return the unknown velocities: rates not driven, then [unknowns]."""
        known = set(self.known_rates)
        return (*(rate for rate in self.rates if rate not in known), *(name for name, _ in self.unknowns))

    @property
    def columns(self) -> tuple[str, ...]:
        """Return the table's columns after t."""
        return (*(c.name for c in self.coordinates), *self.rates, *(name for name, _ in self.unknowns))

    def line_of(self, *path: str | int) -> int:
        """Return the line of the file that a key stands in, 0 where that is not known."""
        return self.lines.get(path, 0)

    def unit_of(self, column: str) -> str:
        """Return the SI unit of a column of the table (angles "rad", rates "rad/s")."""
        for coordinate in self.coordinates:
            if column == coordinate.name:
                return coordinate.unit
            if column == coordinate.rate:
                return "rad/s" if coordinate.unit == "rad" else "m/s"
        return dict(self.unknowns).get(column, "s" if column == "t" else "").replace("1/s", "rad/s")

    def timed(self, step: float | None = None, end: float | None = None) -> Variant:
        """Return the variant with another step or end (s)."""
        return replace(self, time=replace(self.time, step=step or self.time.step, end=end or self.time.end))
