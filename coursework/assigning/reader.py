"""A ranges file -> `Ranges` for one template, or all its faults with line and advice.

Enters: TOML (bytes, or its plain data) and the template.  Leaves: `Ranges`.  Raises `InputError`.
Used by `variants.py`.  Its keys are also in `variants/ranges/ranges.schema.json`, for editors.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any

from coursework.assigning.ranges import MEASURES, Difficulty, Limits, Range, Ranges
from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.units import Quantity, UnitFault, read_as
from coursework.variant.record.changes import determined
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath, Positions
from coursework.variant.toml.source import Source, read_source
from coursework.words.errors import Fault, InputError
from coursework.words.sentences import closest, say

SECTIONS = ("given", "start", "time", "limits", "difficulty")
LIMITS = ("least_determinant", "least_transmission", "largest_velocity", "least_rows_a_turn", "tries")
DIFFICULTY = ("band", "numbers")
RANGE = ("from", "to", "step", "choice")
_OF_VARIANTS = ("format", "coordinates", "drive")  # keys by which a variant is known that was named instead of ranges
MOST_TRIES, MOST_BAND, MOST_ROWS_A_TURN = 100_000, 10.0, 1e6


def read_ranges(content: bytes, file: str, template: Variant) -> Ranges:
    """Return the ranges in a file.  Raises `InputError` with every fault, in the order of the file."""
    return _Reader(read_source(content, file, {}), template).ranges()


def ranges_of(data: Mapping[str, Any], template: Variant) -> Ranges:
    """Return the ranges in plain data of the form of a ranges file.  Raises `InputError`."""
    return _Reader(Source("ranges", {}, dict(data), Positions()), template).ranges()


def ranges_file(path_or_name: str | Path, folder: Path) -> Path:
    """Return the path of a ranges file, given as a path or as the name of a catalogue template with ranges in `folder`."""
    path = Path(path_or_name)
    beside = folder / f"{path_or_name}.toml"
    if path.is_file() or path.suffix == ".toml":
        return path
    if not beside.is_file():
        known = sorted(file.stem for file in folder.glob("*.toml"))
        raise InputError(say("fault.A001", name=str(path_or_name), known=tuple(known)))
    return beside


class _Reader:
    """Reads one file and gathers its faults."""

    def __init__(self, source: Source, template: Variant) -> None:
        self.source, self.template = source, template
        self.faults: list[Fault] = []

    def ranges(self) -> Ranges:
        data = self.source.data
        if place := next((key for key in _OF_VARIANTS if key in data), ""):
            self._say((place,), "fault.A033", at_key=True, template=self.template.file)
            raise InputError(self.faults)
        self._known(data, SECTIONS, ())
        units = {given.name: given.si for given in self.template.given}
        starts = {c.name: c.unit for c in self.template.coordinates}
        found = [
            *self._section("given", units, "fault.A013", lambda name: ("given", name)),
            *self._section("start", starts, "fault.A014", lambda name: ("coordinates", name, "start")),
            *self._rows(),
        ]
        limits, difficulty = self._limits(), self._difficulty()
        if not self.faults and all(one.path[0] == "time" for one in found):
            self._say((), "fault.A031")
        if self.faults:
            raise InputError(self.faults)
        return Ranges(tuple(found), limits, difficulty, self.source.file)

    def _say(self, path: KeyPath, key: str, *, at_key: bool = False, **values: object) -> None:
        self.faults.append(self.source.fault(path, say(key, **values), at_key=at_key))

    def _known(self, section: Mapping[str, Any], known: Sequence[str], path: tuple[str, ...]) -> None:
        for key in section:
            if key not in known:
                advice = closest(key, known)
                self._say((*path, key), "fault.A011", at_key=True, name=key[:40], advice=advice, known=tuple(known))

    def _table(self, key: str) -> Mapping[str, Any]:
        section = self.source.data.get(key, {})
        if isinstance(section, dict):
            return section
        self._say((key,), "fault.A012", name=key)
        return {}

    def _section(self, key: str, units: Mapping[str, str], what: str, place: Any) -> list[Range]:
        found: dict[str, Range] = {}
        for written, value in self._table(key).items():
            name, path = spell(written), (key, written)
            if name not in units:
                advice = closest(name, list(units))
                self._say(path, what, at_key=True, name=written[:40], advice=advice, known=tuple(units))
            elif name in found:
                self._say(path, "fault.A015", at_key=True, name=written)
            elif key == "start" and name in determined(self.template):
                self._say(path, "fault.A016", at_key=True, name=written)
            elif (one := self._range(path, place(name), value, units[name])) is not None:
                found[name] = one
        return [*found.values()]

    def _rows(self) -> list[Range]:
        """Return the range of the check row, if there is one."""
        section = self._table("time")
        self._known(section, ("check_row",), ("time",))
        if "check_row" not in section:
            return []
        path = ("time", "check_row")
        one = self._range(path, path, section["check_row"], "1")
        if one is None:
            return []
        last = self.template.time.steps + 1
        wrong = [text for text in one.ends if not text.isdecimal() or not 1 <= int(text) <= last]
        if wrong or one.decimals:
            self._say(path, "fault.A028", last=last, found=(wrong or one.ends)[0])
            return []
        return [one]

    def _range(self, path: tuple[str, ...], place: tuple[str, ...], value: Any, si: str) -> Range | None:
        if not isinstance(value, dict):
            self._say(path, "fault.A017")
            return None
        before = len(self.faults)
        self._known(value, RANGE, path)
        if "choice" in value:
            if len(value) > 1:
                self._say(path, "fault.A018")
            listed = value["choice"]
            if not isinstance(listed, list) or not listed:
                self._say((*path, "choice"), "fault.A019")
                return None
            for index, entry in enumerate(listed):
                self._quantity((*path, "choice", index), entry, si)
            if len(self.faults) > before:
                return None
            return Range(place, choice=tuple(f"{entry}".strip() for entry in listed), count=len(listed))
        missing = [key for key in RANGE[:3] if key not in value]
        if missing:
            self._say(path, "fault.A020", missing=tuple(missing))
        found = [self._quantity((*path, key), value[key], si) for key in RANGE[:3] if key in value]
        amounts = [one for one in found if one is not None]
        if len(self.faults) > before:
            return None
        first, last, step = (Decimal(one.text.replace("−", "-")) for one in amounts)
        if len({one.unit for one in amounts}) > 1:
            self._say(path, "fault.A021")
        elif step <= 0:
            self._say((*path, "step"), "fault.A022", found=str(step))
        elif last < first:
            self._say((*path, "to"), "fault.A023", first=str(first), last=str(last))
        if len(self.faults) > before:
            return None
        decimals = max(_decimals(first), _decimals(step))
        whole = [int(amount.scaleb(decimals)) for amount in (first, step)]
        return Range(place, (), whole[0], whole[1], int((last - first) // step) + 1, decimals, amounts[0].unit)

    def _quantity(self, path: KeyPath, value: Any, si: str) -> Quantity | None:
        """Return one value of a datum, None if it has a fault."""
        if not isinstance(value, (str, int, float)):
            self._say(path, "fault.A024")
            return None
        try:
            return read_as(value, si)
        except UnitFault as error:
            self.faults.append(self.source.fault(path, error.message))
            return None

    def _limits(self) -> Limits:
        section = self._table("limits")
        self._known(section, LIMITS, ("limits",))
        return Limits(
            self._number("limits", "least_determinant", "1", 1.0),
            self._number("limits", "least_transmission", "rad", 1.5707963267948966),
            self._number("limits", "largest_velocity", "1/s", 1e12),
            self._number("limits", "least_rows_a_turn", "1", MOST_ROWS_A_TURN),
            self._tries(section),
        )

    def _tries(self, section: Mapping[str, Any]) -> int:
        tries = section.get("tries", Limits().tries)
        if isinstance(tries, int) and not isinstance(tries, bool) and 1 <= tries <= MOST_TRIES:
            return tries
        self._say(("limits", "tries"), "fault.A027", most=MOST_TRIES)
        return 1

    def _number(self, section: str, key: str, si: str, most: float) -> float | None:
        value = self._table(section).get(key) if isinstance(self.source.data.get(section), dict) else None
        if value is None:
            return None
        found = self._quantity((section, key), value, si)
        if found is None:
            return None
        if not 0.0 < found.value <= most:
            self._say((section, key), "fault.A026", least=0.0, most=most, found=str(value)[:40])
            return None
        return found.value

    def _difficulty(self) -> Difficulty:
        section = self._table("difficulty")
        self._known(section, DIFFICULTY, ("difficulty",))
        usual = Difficulty()
        band = self._number("difficulty", "band", "1", MOST_BAND)
        listed = section.get("numbers", list(usual.numbers))
        if not isinstance(listed, list):
            self._say(("difficulty", "numbers"), "fault.A029", known=tuple(MEASURES))
            return usual
        for index, name in enumerate(listed):
            if not isinstance(name, str) or name not in MEASURES:
                advice = closest(str(name), list(MEASURES))
                self._say(
                    ("difficulty", "numbers", index), "fault.A030", name=str(name)[:40], advice=advice, known=tuple(MEASURES)
                )
        return Difficulty(usual.band if band is None else band, tuple(dict.fromkeys(map(str, listed))))


def _decimals(value: Decimal) -> int:
    """Return the number of decimals with which a number is written."""
    exponent = value.as_tuple().exponent
    assert isinstance(exponent, int)
    return max(0, -exponent)
