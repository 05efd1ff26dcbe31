"""The instructor's rubric: what each part is worth, how mildly it is marked, which answers are asked for.

Enters: the text of a TOML file, or nothing.  Leaves: `Rubric`.  Raises `InputError` for unknown keys and impossible values.
Used by the commands, before anything is graded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, replace
from datetime import datetime
from decimal import ROUND_HALF_UP, Decimal
from typing import Any

from coursework.grading.marking.late import Late, span
from coursework.system.frozen import frozen
from coursework.variant.formula.units import UnitFault, read
from coursework.variant.record.variant import Variant
from coursework.variant.toml.source import Source, read_source
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

KEYS = ("points", "missing_part", "parts", "table", "answers", "conventions", "confusion", "late")
PARTS = ("table", "equations", "answers")
CONVENTIONS = ("accept", "misconception")
FLOORS = ("carried", "start_floor", "start_floor_several", "misconception_floor", "own_equations_floor", "steps_floor")
_LATE = {"lost_per_day": 0.1, "at_most": 1.0}
READING_TOLERANCE = 0.05  # of the largest value of its kind in the row: as well as a drawing can be read


@frozen
class Answer:
    """One measured answer: quantity `of` in `row` (from 1; None for the variant's check row), with its relative tolerance."""

    name: str
    of: str
    row: int | None
    tolerance: float = READING_TOLERANCE


@frozen
class Confusion:
    """A datum that is often taken with another value, and the reason."""

    datum: str
    value: str
    because: str = ""


@frozen
class Rubric:
    """`points` for the whole; `weights` of the parts; floors and `carried` (the worth of a carried cell) are shares of 1.

    `clockwise` says how work is taken in which angles count clockwise: one of `CONVENTIONS`. `forces` names the columns
    of forces that a table must have besides the others. `line_of` finds the line of a place in the file.
    """

    points: float = 100.0
    missing_part: str = "review"
    weights: Mapping[str, float] = field(default_factory=lambda: {"table": 60.0, "equations": 40.0, "answers": 0.0})
    carried: float = 1.0
    start_floor: float = 0.95
    start_floor_several: float = 0.6
    misconception_floor: float = 0.4
    own_equations_floor: float = 0.5
    steps_floor: float = 0.7
    answers: tuple[Answer, ...] = ()
    confusions: tuple[Confusion, ...] = ()
    clockwise: str = "accept"
    late: Late | None = None
    forces: tuple[str, ...] = ()
    line_of: Callable[[str], int] = field(default=lambda place: 0, compare=False)

    @property
    def is_scaled(self) -> bool:
        """Return whether the weights of the parts are scaled to `points` because their sum differs from it."""
        return abs(sum(self.weights.values()) - self.points) > 1e-9 * self.points

    def most(self, part: str) -> float:
        """Return the most points that a part can earn."""
        total = sum(self.weights.values())
        return self.points * self.weights[part] / total

    def confused(self, variant: Variant) -> dict[str, float]:
        """Return the wrong values (SI) by datum, for those confusions whose datum the variant has."""
        units = {given.name: given.si for given in variant.given}
        return {entry.datum: read(entry.value, units[entry.datum]).value for entry in self.confusions if entry.datum in units}

    def plain(self) -> dict[str, Any]:
        """Return the rubric as it was used, for grades.json."""
        return {
            "points": self.points, "missing_part": self.missing_part, "parts": dict(self.weights),
            "table": {name: getattr(self, name) for name in FLOORS} | ({"forces": list(self.forces)} if self.forces else {}),
            "answers": {entry.name: {"of": entry.of, "row": entry.row, "tolerance": entry.tolerance} for entry in self.answers},
            "conventions": {"clockwise": self.clockwise},
            "confusion": [{"datum": c.datum, "value": c.value, "because": c.because} for c in self.confusions],
            **({"late": self.late.plain()} if self.late else {}),
        }  # fmt: skip


def read_rubric(text: str, name: str = "rubric.toml") -> Rubric:
    """Return the rubric that a file's text describes.  Raises `InputError` with every fault."""
    source = read_source(text.encode("utf-8"), name, {})
    return _Reader(source).rubric(source.data)


class _Reader:
    """Reads the sections of one file and gathers its faults."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.faults: list[Fault] = []

    def rubric(self, found: Mapping[str, Any]) -> Rubric:
        """Return the rubric.  Raises `InputError` with every fault."""
        self._refuse_unknown(found, KEYS, "")
        parts = self._section(found, "parts", PARTS)
        table = self._section(found, "table", (*FLOORS, "forces"))
        conventions = self._section(found, "conventions", ("clockwise",))
        default = Rubric()
        weights = {part: self._number(parts, part, default.weights[part], "parts.", most=1e6) for part in PARTS}
        points = self._number(found, "points", default.points, most=1e6)
        if not sum(weights.values()) or not points:
            self._fault("parts" if points else "points", "fault.G034")
        missing = found.get("missing_part", default.missing_part)
        if missing not in ("review", "zero"):
            self._fault("missing_part", "fault.G035", missing=missing)
        clockwise = conventions.get("clockwise", default.clockwise)
        if clockwise not in CONVENTIONS:
            self._fault("conventions.clockwise", "fault.G089", clockwise=clockwise)
        answers = tuple(self._answers(found.get("answers", {})))
        confusions = tuple(self._confusions(found.get("confusion", [])))
        floors = {key: self._number(table, key, getattr(default, key), "table.") for key in FLOORS}
        if not floors["misconception_floor"] and "steps_floor" not in table:
            floors["steps_floor"] = 0.0  # who gives nothing for another rule means other steps, too
        forces = table.get("forces", [])
        asked = tuple(map(str, forces if isinstance(forces, list) else [forces]))
        late = self._late(found) if "late" in found else None
        if weights["answers"] and not found.get("answers"):
            self._fault("parts.answers", "fault.G036")
        if self.faults:
            raise InputError(self.faults)
        return Rubric(
            points, missing, weights, **floors, answers=answers, confusions=confusions, clockwise=clockwise, late=late,
            forces=asked, line_of=self._line_of,
        )  # fmt: skip

    def _line_of(self, place: str) -> int:
        path = tuple(int(part) - 1 if part.isdecimal() else part for part in place.split(".") if part)
        return self.source.positions.find(path, key=True)[0]

    def _fault(self, place: str, key: str, **values: object) -> None:
        line = self._line_of(f"{place}.{values.get('key_', '')}")
        self.faults.append(Fault(say(key, **values), self.source.file, line, place=place))

    def _refuse_unknown(self, section: Mapping[str, Any], known: tuple[str, ...], place: str) -> None:
        for key in section:
            if key not in known:
                self._fault(place, "fault.G042", key_=key, hint=closest(key, known), known=tuple(known))

    def _section(self, found: Mapping[str, Any], key: str, known: tuple[str, ...]) -> Mapping[str, Any]:
        section = found.get(key, {})
        if not isinstance(section, dict):
            self._fault(key, "fault.G037", key_=key, section=section)
            return {}
        self._refuse_unknown(section, known, key)
        return section

    def _number(self, section: Mapping[str, Any], key: str, default: float, within: str = "", most: float = 1.0) -> float:
        value = section.get(key, default)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value <= most:
            self._fault(f"{within}{key}", "fault.G038", most=most, value=value)
            return default
        return float(value)

    def _answers(self, section: Any) -> Iterator[Answer]:
        if not isinstance(section, dict):
            self._fault("answers", "fault.G039", section=section)
            return
        for key, entry in section.items():
            place = f"answers.{key}"
            if not isinstance(entry, dict) or not isinstance(entry.get("of"), str):
                self._fault(place, "fault.G043", key_=key, entry=entry)
                continue
            self._refuse_unknown(entry, ("of", "row", "tolerance"), place)
            row = entry.get("row")
            if row is not None and (isinstance(row, bool) or not isinstance(row, int) or row < 1):
                self._fault(f"{place}.row", "fault.G044", row=row)
                continue
            yield Answer(key, entry["of"], row, self._number(entry, "tolerance", READING_TOLERANCE, f"{place}."))

    def _late(self, found: Mapping[str, Any]) -> Late | None:
        section = self._section(found, "late", ("deadline", "grace", "lost_per_day", "at_most"))
        if section is not found["late"]:  # no section, which is told
            return None
        deadline, grace = section.get("deadline"), section.get("grace", "0 min")
        try:
            deadline = datetime.fromisoformat(deadline) if isinstance(deadline, str) else deadline
        except ValueError:
            deadline = None
        if not isinstance(deadline, datetime) or deadline.tzinfo is None:
            self._fault("late.deadline", "fault.G081", deadline=section.get("deadline", ""))
            return None
        if not isinstance(grace, str) or span(grace) is None:
            self._fault("late.grace", "fault.G082", grace=grace)
            return None
        shares = {key: self._number(section, key, default, "late.") for key, default in _LATE.items()}
        return Late(deadline, grace, **shares)

    def _confusions(self, entries: Any) -> Iterator[Confusion]:
        for index, entry in enumerate(entries if isinstance(entries, list) else [entries], start=1):
            place = f"confusion.{index}"
            if not isinstance(entry, dict) or not isinstance(entry.get("datum"), str) or not isinstance(entry.get("value"), str):
                self._fault(place, "fault.G045")
                continue
            self._refuse_unknown(entry, ("datum", "value", "because"), place)
            yield Confusion(entry["datum"], entry["value"], str(entry.get("because", "")))


def _forces(variant: Variant) -> tuple[str, ...]:
    """Return the names of the forces that can be asked for; empty if the variant has no forces."""
    if variant.forces is None:
        return ()
    from coursework.grading.marking.key.forces import force_names

    return force_names(variant)


def check_rubric(rubric: Rubric, variant: Variant, name: str = "rubric.toml") -> None:
    """Raise `InputError` if the rubric asks for something that the variant does not have."""
    faults = []
    points = [point for point, _ in variant.points]
    known = [*variant.columns, *(f"v_{point}" for point in points)]
    of_forces = _forces(variant)
    asked = [(force, "table.forces", of_forces) for force in rubric.forces]
    asked += [(answer.of, f"answers.{answer.name}.of", (*known, *of_forces)) for answer in rubric.answers]
    for of, place, allowed in asked:
        if of not in allowed:
            told = say("fault.G040", of=of, hint=closest(of, allowed), known=", ".join(allowed))
            faults.append(Fault(told, name, rubric.line_of(place), place=place))
    for answer in rubric.answers:
        if answer.row is not None and answer.row > variant.time.steps + 1:
            told, place = say("fault.G041", number=variant.time.steps + 1, row=answer.row), f"answers.{answer.name}.row"
            faults.append(Fault(told, name, rubric.line_of(place), place=place))
    for number, entry in enumerate(rubric.confusions, start=1):
        try:
            replace(rubric, confusions=(entry,)).confused(variant)
        except UnitFault as error:
            faults.append(Fault(error.message, name, rubric.line_of(f"confusion.{number}"), place=f"confusion.{entry.datum}"))
    if faults:
        raise InputError(faults)


def rounded_points(value: float) -> float:
    """Return points rounded to two decimals, halves up."""
    return float(Decimal(repr(value)).quantize(Decimal("0.01"), ROUND_HALF_UP))
