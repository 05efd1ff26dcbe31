"""The reader of data sets for one template: a user's columns of numbers become SI, or one sentence says what is wrong.

Enters: a variant; a mapping or a pandas frame of given names and start coordinates.  Leaves: frozen `Data`.
Used by `model.py` and by whoever solves many sets.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from coursework.system.arrays import Array
from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.units import MAX_NUMBER, UnitFault, read_as
from coursework.variant.record.other_values import not_by_name
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say


@dataclass(frozen=True, slots=True, eq=False)
class Data:
    """`count` data sets: `given` data by name, (count,) each; `start` coordinates (count, m), nan if a chain gives them.

    All values are in SI (rad, m, s); `changed` are the names that the user gave; the other values are those of the file.

    >>> import coursework
    >>> data = coursework.compile_model("31").data({"r1": ["953 mm", "0.9 m"], "phi1": 1.63})
    >>> data.count, data.given["r1"].tolist(), data.start.shape, data.changed
    (2, [0.953, 0.9], (2, 3), ('r1', 'phi1'))
    """

    count: int
    given: Mapping[str, Array]
    start: Array
    changed: tuple[str, ...]

    def part(self, rows: slice | list[int]) -> Data:
        """Return some of the sets."""
        start = self.start[rows]
        return Data(len(start), {name: column[rows] for name, column in self.given.items()}, start, self.changed)

    def with_each(self, changes: Sequence[Mapping[str, float]]) -> Data:
        """Return a single set once for each of several `changes`, values in SI by name that replace those of the set.

        >>> import coursework
        >>> coursework.compile_model("31").data().with_each([{}, {"r1": 0.9}]).given["r1"].tolist()
        [0.953, 0.9]
        """
        given = {name: np.repeat(column, len(changes)) for name, column in self.given.items()}
        for place, changed in enumerate(changes):
            for name, value in changed.items():
                given[name][place] = value
        return Data(len(changes), given, np.repeat(self.start, len(changes), axis=0), tuple(given))

    def of(self, index: int, variant: Variant) -> tuple[dict[str, float | str], dict[str, float | str]]:
        """Return the changed data and start values of one set, as `Variant.with_data` takes them."""
        given: dict[str, float | str] = {name: float(self.given[name][index]) for name in self.changed if name in self.given}
        starts = zip(variant.coordinates, self.start[index].tolist(), strict=True)
        return given, {c.name: value for c, value in starts if c.name in self.changed}


def read_data(variant: Variant, columns: Mapping[str, Any] | Any = None) -> Data:
    """Return the data sets from columns; a single number applies to all sets, and missing columns keep the values of the file.

    Raises `InputError` for a name that the template does not have, for different lengths, and for anything but finite numbers of
    the right unit.
    """
    columns = {} if columns is None else columns
    if not hasattr(columns, "keys"):
        raise _fault(variant, not_by_name(columns))
    places = {c.name: place for place, c in enumerate(variant.coordinates)}
    units = {given.name: given.si for given in variant.given} | {c.name: c.unit for c in variant.coordinates}
    found: dict[str, Array] = {}
    for key in columns.keys():  # noqa: SIM118  iterating a pandas Series gives its values
        name = spell(key) if isinstance(key, str) else key
        if name not in units:
            hint = closest(str(key), list(units)) or say("hint.known", known=", ".join(units))
            raise _fault(variant, say("fault.D011", name=str(key), hint=hint))
        if name in found:
            raise _fault(variant, say("fault.D012", name=name))
        found[name] = _column(variant, name, columns[key], units[name])
    lengths = {name: len(column) for name, column in found.items() if column.ndim}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise _fault(variant, say("fault.D013", found=told))
    count = next(iter(lengths.values()), 1)
    every = {name: np.full(count, value) for name, value in variant.values.items()}
    start = np.tile([np.nan if c.start_or_guess is None else c.start_or_guess for c in variant.coordinates], (count, 1))
    for name, column in found.items():
        if name in places:
            start[:, places[name]] = column
        else:
            every[name] = np.broadcast_to(column, (count,))
    return Data(count, every, start.reshape(count, len(places)), tuple(found))


def _column(variant: Variant, name: str, values: Any, si: str) -> Array:
    """Return one column, or one number for all sets, in SI."""
    try:
        column = np.asarray(values)
    except ValueError:
        column = np.empty((0, 0))
    if column.ndim > 1:
        raise _fault(variant, say("fault.D014", shape=str(column.shape)), name)
    if column.dtype.kind in "iuf":
        numbers: Array = column.astype(float)
    else:
        numbers = np.array([_number(variant, name, value, si, place) for place, value in enumerate(column.reshape(-1).tolist())])
        numbers = numbers.reshape(column.shape)
    wrong = ~(np.abs(numbers) <= MAX_NUMBER)
    if np.any(wrong):
        place = int(np.argmax(wrong))
        found = float(numbers.flat[place])
        raise _fault(variant, say("fault.D015", found=found), say("place.set", name=name, number=place + 1))
    return numbers


def _number(variant: Variant, name: str, value: Any, si: str, place: int) -> float:
    """Return the SI value of a number or a text such as "953 mm"."""
    where = say("place.set", name=name, number=place + 1)
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise _fault(variant, say("fault.D016", found=repr(value)), where)
    try:
        return read_as(value, si).value
    except UnitFault as fault:
        raise _fault(variant, fault.message, where) from None


def _fault(variant: Variant, message: Sentence, place: str = "") -> InputError:
    place = say("place.set_of", variant=variant.name, place=place) if place else say("place.sets", variant=variant.name)
    return InputError([Fault(message, place=place)])
