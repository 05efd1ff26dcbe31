"""A variant after reading: frozen records, SI numbers, checked formulas.

Leaves `reader.py`, its parts from `entries.py`; every floor above may read it.
"""

from __future__ import annotations

import pathlib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING

from coursework.system.frozen import caching
from coursework.variant.formula.tree import Formula
from coursework.variant.record.entries import (
    Binding,
    Constraint,
    Coordinate,
    Frame,
    Given,
    Group,
    Guide,
    Law,
    Link,
    Quote,
    Remark,
    Time,
    whole_steps,
)
from coursework.variant.record.other_values import Changes, Values, by_name
from coursework.variant.record.texts import Texts
from coursework.variant.toml.positions import KeyPath
from coursework.words.errors import InputError, visible
from coursework.words.html_table import html_table
from coursework.words.sentences import closest, say

if TYPE_CHECKING:
    from coursework.variant.record.forces import Forces, Motor

__all__ = [
    "MAX_NUMBERS", "MAX_ROWS", "MOST_PERIODS", "Binding", "Constraint", "Coordinate", "Frame", "Given", "Group", "Guide", "Law",
    "Link", "Quote", "Remark", "Time", "Variant", "whole_steps",
]  # fmt: skip

# The text between point and axis in the name of a column -> the unit of the column.
LEVELS = {"": "m", "v": "m/s", "a": "m/s²"}
# Nobody reads more rows than this; a step much smaller than the coursework needs is a slip.
MAX_ROWS = 200_000
MAX_NUMBERS = 4_000_000  # in a table: rows times columns
MOST_PERIODS = 10_000  # in one run


def no_column(name: object, known: tuple[str, ...]) -> InputError:
    """Return the error for a name that is not one of the columns `known`."""
    several = ", ".join(f'"{one}"' for one in name) if isinstance(name, (list, tuple)) else ""
    hint = say("hint.one_by_one", names=several) if several else closest(str(name), known)
    return InputError(say("fault.D028", name=name, hint=hint, known=known))


def changed(values: Mapping[str, str]) -> str:
    """Return " (alpha = 0.02 rad)" for values that differ from the file, "" if there are none."""
    return f" ({', '.join(f'{name} = {value}' for name, value in values.items())})" if values else ""


@caching
class Variant:
    """One variant of the coursework, complete.

    >>> import coursework
    >>> variant = coursework.load("31")
    >>> variant.values["r1"], variant.time.end, variant.columns, variant.unit_of("w3")  # m, s
    (0.953, 0.48, ('phi1', 'phi2', 'phi3', 'w1', 'w2', 'w3', 'w4'), 'rad/s')
    """

    name: str
    path: pathlib.Path | None
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
    quotes: tuple[Quote, ...] = ()
    plausibility: tuple[Remark, ...] = ()
    lines: Mapping[KeyPath, int] = field(default_factory=dict, repr=False, compare=False)
    times: Mapping[KeyPath, Formula] = field(default_factory=dict, repr=False, compare=False)  # times given as formulas
    reread: Callable[[Variant, Changes], Variant] | None = field(default=None, repr=False, compare=False)
    changes: Mapping[KeyPath, float | str] = field(default_factory=dict, repr=False, compare=False)
    before: Variant | None = field(default=None, repr=False, compare=False)  # whose start its `start_guess` are
    texts: Mapping[str, Texts] = field(default_factory=dict, repr=False, compare=False)
    bindings: tuple[Binding, ...] = ()
    also_driven: tuple[str, ...] = ()  # points that follow laws beside `driven`
    forces: Forces | None = field(default=None, repr=False)

    @property
    def values(self) -> dict[str, float]:
        """Return the given data by name, in SI."""
        return {given.name: given.value for given in self.given}

    @property
    def names(self) -> tuple[str, ...]:
        """Return t and every scalar name that the file declares, each once."""
        return tuple(dict.fromkeys(["t", *self.values, *(law.name for law in self.laws), *self.columns]))

    @property
    def laws(self) -> tuple[Law, ...]:
        """Return the laws of [drive], then those of [functions]."""
        return (*self.drive, *self.functions)

    def path_of(self, law: str) -> tuple[str, str]:
        """Return the path of a law in the file: its section, [drive] or [functions], and its name."""
        return "drive" if any(one.name == law for one in self.drive) else "functions", law

    @cached_property
    def rates(self) -> tuple[str, ...]:
        """Return the names of the rates, in the order of the coordinates."""
        return tuple(coordinate.rate for coordinate in self.coordinates)

    @cached_property
    def known_rates(self) -> tuple[str, ...]:
        """Return the rates that are in [drive]."""
        laws = {law.name for law in self.drive}
        return tuple(rate for rate in self.rates if rate in laws)

    @cached_property
    def given_rates(self) -> tuple[str, ...]:
        """Return the rates that follow a given law: those in [drive], but none that forces move."""
        free = self.motor.rates if self.motor is not None else ()
        return tuple(rate for rate in self.known_rates if rate not in free)

    @property
    def given_coordinates(self) -> frozenset[str]:
        """Return the coordinates whose rate follows a given law, so that their position is known at any time."""
        return frozenset(one.name for one in self.coordinates if one.rate in self.given_rates)

    @property
    def motor(self) -> Motor | None:
        """Return the motor if forces move the mechanism, None if laws drive it."""
        return self.forces.motor if self.forces is not None else None

    @property
    def driven_coordinates(self) -> tuple[Coordinate, ...]:
        """Return the coordinates whose rate is in [drive]."""
        return tuple(coordinate for coordinate in self.coordinates if coordinate.rate in self.known_rates)

    @property
    def sought(self) -> tuple[str, ...]:
        """Return the unknown velocities: rates not driven, then [unknowns]."""
        return (*(rate for rate in self.rates if rate not in self.known_rates), *(name for name, _ in self.unknowns))

    @cached_property
    def columns(self) -> tuple[str, ...]:
        """Return the columns of the table after t."""
        return (*(c.name for c in self.coordinates), *self.rates, *(name for name, _ in self.unknowns))

    def formulas(self) -> Iterator[tuple[KeyPath, Formula]]:
        """Yield the formulas of points, constraints, held expressions and directions, each with its path; laws are excluded."""
        for name, formula in self.points:
            yield ("points", name), formula
        for constraint in self.constraints:
            for side in constraint.sides:
                yield constraint.path, side
        for index, formula in enumerate(self.holds):
            yield ("closure", "holds", index), formula
        for binding in self.bindings:
            if binding.along is not None:
                yield ("unknowns", binding.name, "along"), binding.along

    def formulas_of_laws(self) -> Iterator[tuple[KeyPath, Formula]]:
        """Yield the formulas of the laws, those of their pieces too, each with its path."""
        for law in self.laws:
            path = self.path_of(law.name)
            if law.formula:
                yield path, law.formula
            yield from (((*path, "pieces", place, 1), formula) for place, (_, formula) in enumerate(law.pieces))

    @property
    def set_values(self) -> dict[str, str]:
        """Return the values that differ from the file, as texts by name, without a step or end set for one run."""
        named = {path: path[1] for path in self.changes if not isinstance(self.changes[path], float)}
        return {str(name): str(self.changes[path]) for path, name in named.items()}

    @property
    def file(self) -> str:
        """Return the name of the file in messages: its path, or the name of a variant without a file."""
        return str(self.path or self.name)

    def line_of(self, *path: str | int) -> int:
        """Return the line of a key in the file, 0 if it is not known."""
        return self.lines.get(path, 0)

    def nearest_line(self, *path: str | int) -> int:
        """Return the line of a key, or of the nearest enclosing section; 1 if the file has neither."""
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 1)

    def unit_of(self, column: str) -> str:
        """Return the SI unit of a column: angles "rad", rates "rad/s", accelerations (dw1), points (A.x, A.vx, A.ax).

        Raises `InputError` for a name that no table has.

        >>> import coursework
        >>> [coursework.load("31").unit_of(name) for name in ("w3", "dw3", "M.y", "M.ay")]
        ['rad/s', 'rad/s²', 'm', 'm/s²']
        """
        if column not in self._units:
            raise no_column(column, tuple(name for name in self._units if "." not in name))
        return self._units[column]

    @property
    def velocities(self) -> tuple[str, ...]:
        """Return the rates, then [unknowns]."""
        return self.columns[len(self.coordinates) :]

    @cached_property
    def _units(self) -> dict[str, str]:
        velocities = {c.rate: "rad/s" if c.unit == "rad" else "m/s" for c in self.coordinates}
        velocities |= {name: unit.replace("1/s", "rad/s") for name, unit in self.unknowns}
        named = dict.fromkeys([name for name, _ in self.points] + [group.meets for group in self.groups if group.meets])
        points = {f"{name}.{key}{axis}": unit for name in named for key, unit in LEVELS.items() for axis in "xy"}
        return (
            {"t": "s"} | {c.name: c.unit for c in self.coordinates} | velocities
            | {f"d{name}": unit.replace("/s", "/s²") for name, unit in velocities.items()} | points
        )  # fmt: skip

    def __repr__(self) -> str:
        size = f"{len(self.coordinates)} coordinates, {len(self.sought)} unknown velocities, {self.time.steps + 1} rows"
        return f"<Variant {visible(self.name)}{changed(self.set_values)}: {visible(self.title)}; {size}>"

    def _repr_html_(self) -> str:
        rows = [(one.name, one.means, f"{one.value:g}", one.si) for one in self.given]
        return html_table(f"{self.name}: {self.title}", ("", "", "", ""), rows)

    def with_values(self, values: Mapping[str, float]) -> Variant:
        """Return the variant with other values (SI) of some data; nothing is read anew or follows, unlike `with_data`."""
        return replace(self, given=tuple(replace(one, value=values.get(one.name, one.value)) for one in self.given))

    def in_language(self, language: str) -> Variant:
        """Return the variant with its texts in a language, as far as its file has them."""
        texts = self.texts.get(language)
        if texts is None:
            return self
        return replace(
            self,
            title=texts.title or self.title,
            source=texts.source or self.source,
            teaches=texts.teaches or self.teaches,
            remarks=texts.remarks or self.remarks,
            given=tuple(replace(one, means=texts.means.get(one.name, one.means)) for one in self.given),
            constraints=tuple(replace(one, because=texts.because.get(one.name, one.because)) for one in self.constraints),
        )

    def timed(self, step: float | None = None, end: float | None = None) -> Variant:
        """Return the variant with another step or end (s)."""
        now = self.time
        time = replace(now, step=step or now.step, end=end or now.end, own_step=now.own_step or now.step)
        others = [key for key in ("step", "end") if getattr(time, key) != getattr(self.time, key)]
        kept = tuple(one for one in self.plausibility if one.code != "END" or not others)  # it is about the file's own step
        changes: dict[KeyPath, float | str] = {**self.changes, **{("time", key): getattr(time, key) for key in others}}
        return replace(self, time=time, plausibility=kept, changes=changes)

    def with_data(
        self, given: Values | None = None, start: Values | None = None, drive: Values | None = None, *,
        step: float | str | None = None, end: float | str | None = None, period: float | str | None = None,
        check_row: int | None = None,
    ) -> Variant:  # fmt: skip
        """Return the variant of its file with other data: period, texts, start, remarks and faults are determined anew.

        `given` may hold both data and start values by name, as in `solve_many`; `start` holds start values only.
        Numbers are in SI; texts have a unit or are formulas ("2*pi/p"); `check_row` counts from 1.
        If the geometry determines start values, those of coordinates not named in `start` follow: the closed position nearest to
        the old one is taken.  Raises `InputError` for any fault of the changed file.

        >>> import coursework
        >>> round(coursework.load("31").with_data(given={"p": 10}).time.period, 4)
        0.6283
        """
        if self.reread is None:
            raise InputError(say("fault.D004", name=self.name))
        asked = {"step": step, "end": end, "period": period, "check_row": check_row}
        times = {key: value for key, value in asked.items() if value is not None}
        return self.reread(self, Changes(by_name(given), by_name(start), by_name(drive), times))
