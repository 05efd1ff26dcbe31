"""The table of masses and forces below the data: masses, weight, loads, springs, friction, flywheel, as in the file.

Enters: a `PageContext`, `Forces`.  Leaves: a table, or nothing if the file has no such entries.  Used by `statement.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from coursework.report.formulas.typst_math import text
from coursework.report.text.numbers import aligned
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Column, Part, Runs, Table
from coursework.variant.formula.tree import Formula, constant, spelled
from coursework.variant.record.forces import MEASURED, Forces
from coursework.words.templates import clean

_DECIMAL = re.compile(r"(?<=\d)\.(?=\d)")
_Entry = tuple[str, str, Formula | str, str]  # owner, meaning, value, unit in SI


def masses_and_loads(context: PageContext, forces: Forces) -> list[Part]:
    """Return the table of masses and loads, empty if there are none; the motor's torques stand with the free rates."""
    listed = [*_entries(context, forces)]
    if not listed:
        return []
    values = [_value(context, how_much) for _, _, how_much, _ in listed]
    numbers = iter(aligned([value for value in values if isinstance(value, str)], context.numbers.mark))
    rules = [place for place, (one, other) in enumerate(pairwise(listed)) if one[0] != other[0]]
    rows: list[list[Cell]] = [
        [
            context.lettered("" if place and place - 1 not in rules else of, data=False),  # only in the first row of an owner
            context.lettered(meaning, data=False),
            next(numbers) if isinstance(value, str) else value,
            context.unit(unit),
        ]
        for place, ((of, meaning, _, unit), value) in enumerate(zip(listed, values, strict=True))
    ]
    heads = [Column(context.say(f"acting.{key}"), words=key != "written") for key in ("of", "meaning", "written", "unit")]
    return [Table(heads, rows, context.say("acting.table"), rules=rules, id="acting")]


def _entries(context: PageContext, forces: Forces) -> Iterator[_Entry]:
    say = context.words
    points = {name for name, _ in context.run.scene.mechanism.points}
    for mass in forces.masses:
        of = say("acting.block" if mass.body in points else "acting.link", name=clean(mass.body))
        yield from _of(context, of, mass)
    for axis, part in zip("xy", forces.gravity or (), strict=False):
        if constant(part) != 0:
            yield say("acting.gravity"), say("acting.along", axis=context.lettering(axis)), part, "m/s^2"
    for load in forces.loads:
        yield from _of(context, say("acting.load", name=clean(load.name), link=clean(load.on)), load, at=load.at)
    for spring in forces.springs:
        first, second = map(clean, spring.ends)
        yield from _of(context, say("acting.spring", name=clean(spring.name), first=first, second=second), spring)
    for friction in forces.friction:
        yield from _of(context, say("acting.friction", point=clean(friction.at)), friction)
    if forces.flywheel is not None:
        yield from _of(context, say("acting.flywheel", link=clean(forces.flywheel.on)), forces.flywheel)


def _of(context: PageContext, of: str, record: object, at: Formula | None = None) -> Iterator[_Entry]:
    """Yield the entries of a record, key by key, for the owner `of`; a force names the point `at` which it acts."""
    for key, unit in MEASURED.items():
        value = getattr(record, key, None)
        if value is not None and key != "at":
            meaning = context.words(f"acting.{key}", at=clean(spelled(at)) if at is not None else "")
            yield of, meaning, value, "" if isinstance(value, str) else unit


def _value(context: PageContext, how_much: Formula | str) -> str | Runs:
    """Return a value as text if it is a number, or as runs if it is a formula or the word for a shape."""
    if isinstance(how_much, str):
        return context.say(f"acting.shape.{how_much}")
    number = constant(how_much)
    if number is not None:
        return context.numbers.plain(float(number))
    return context.lettered(_DECIMAL.sub(context.numbers.mark, text(how_much, context.rates)))
