"""A variant file -> `Variant`, or every fault of the file in one go.

Enters: a path, or text.  Leaves: a frozen `Variant`.  Raises `InputError`.
Used by `catalogue.py`, `assigning/variants.py`, `grading/batch/class_list.py` and `grading/batch/workshop.py`.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursework.variant.formula.alphabet import spell_path
from coursework.variant.formula.tree import Formula
from coursework.variant.formula.units import measured
from coursework.variant.judging.at_start import faults_at_start
from coursework.variant.judging.broken import Broken
from coursework.variant.judging.dimension_check import check_dimensions
from coursework.variant.judging.plausibility import remarks_on
from coursework.variant.judging.whole_file import faults_of_the_whole
from coursework.variant.reading import schema
from coursework.variant.reading.driven_rates import with_driven_rates
from coursework.variant.reading.implied_closure import with_implied_closure
from coursework.variant.reading.missing_points import told_once
from coursework.variant.reading.names import Names
from coursework.variant.reading.parts import Parts
from coursework.variant.reading.sections import (
    read_binding,
    read_frame,
    read_group,
    read_link,
    read_quote,
    read_time,
    read_unknown,
)
from coursework.variant.reading.shape import read_shape
from coursework.variant.record.changes import with_changes
from coursework.variant.record.texts import Texts
from coursework.variant.record.variant import (
    Constraint,
    Coordinate,
    Given,
    Group,
    Law,
    Variant,
)
from coursework.variant.record.vocabulary import FORCE_SECTIONS, GROUP_KINDS
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.source import Source, read_bytes, read_source
from coursework.words.errors import Fault, InputError
from coursework.words.scripts import unfolded
from coursework.words.sentences import closest, say

if TYPE_CHECKING:
    from coursework.variant.record.forces import Forces

# Finds faults that only a higher floor can see, for a file that has faults already.
Judge = Callable[[Variant], list[Fault]]


def read_variant(path: Path, judge: Judge | None = None) -> Variant:
    """Return the variant in a file.  Raises `InputError` with all faults, including those that `judge` finds."""
    return _build(read_source(read_bytes(path), str(path), path.parent), _named_after(path), path, judge)


def _named_after(path: Path) -> str:
    """Return the name of a file without its suffix; bytes that are not valid text are written as %FF."""
    return re.sub("[\\udc80-\\udcff]", lambda byte: f"%{ord(byte[0]) - 0xDC00:02X}", path.stem)


def parse_variant(
    content: str | bytes, file: str = "variant", tables: Mapping[str, bytes] | None = None, judge: Judge | None = None
) -> Variant:
    """Return the variant in a text; `tables` maps the names of table files to their contents.  Nothing is read from disk.

    Raises `InputError` with all faults, including those that `judge` finds.

    >>> import coursework
    >>> text = coursework.load("31").path.read_text(encoding="utf-8")
    >>> coursework.parse_variant(text.replace("0.953 m", "0.96 m")).values["r1"]
    0.96
    >>> coursework.parse_variant(text.replace("0.953 m", "0.953 kg"))
    Traceback (most recent call last):
        ...
    coursework.words.errors.InputError: V105 variant:13:9  given.r1: a length was expected: m, cm, mm (found "0.953 kg").
    """
    if not isinstance(content, (str, bytes)):
        raise TypeError(say("fault.D035", found=type(content).__name__))
    raw = content.encode("utf-8") if isinstance(content, str) else content
    return _build(read_source(raw, file, {} if tables is None else tables), file, None, judge)


def _build(source: Source, name: str, path: Path | None, judge: Judge | None = None) -> Variant:
    shape = read_shape(source)
    file = shape.file
    parts = Parts(source, Names.declared(file), shape.hidden)
    parts.broken |= shape.broken
    variant = _assemble(file, parts, name, path)
    dimensions = check_dimensions(Broken(parts.broken).without_doubtful(variant), source, parts.times)
    parts.tell_unread(dimensions.si_of)
    doubtful = parts.names.faults(source)
    parts.faults += shape.faults + doubtful
    slips = () if doubtful else dimensions.faults  # a name with two meanings has two dimensions
    if not doubtful:
        told, broken = {fault.line for fault in parts.faults}, Broken(parts.broken)
        driven = replace(variant, drive=with_driven_rates(variant).drive)
        found = faults_of_the_whole(driven, source, parts.times, broken)
        # A datum with a wrong unit spoils values at t = 0; but a fault in the line of the slip itself says more than the slip.
        found += [f for f in faults_at_start(variant, source, broken) if not slips or f.line in {slip.line for slip in slips}]
        parts.faults += [fault for fault in found if fault.line not in told]
    told = {fault.line for fault in parts.faults}
    parts.faults += [slip for slip in slips if slip.line not in told]
    if parts.faults:
        whole = not any(Broken(parts.broken).has(section) for section in ("coordinates", "unknowns", "ask"))
        raise InputError([*told_once(parts.faults, parts.names), *(judge(variant) if judge and whole else [])])
    variant = replace(variant, times=parts.times)
    remarks = remarks_on(variant, dimensions, source, parts.grads)
    variant = with_implied_closure(with_driven_rates(variant))
    return replace(variant, plausibility=remarks, reread=partial(with_changes, partial(_read_again, source, name, path)))


def _read_again(source: Source, name: str, path: Path | None, changes: Mapping[KeyPath, Any]) -> Variant:
    """Return the variant of a file with some values changed."""
    return _build(source.changed(changes), name, path)


def _assemble(file: schema.VariantFile, parts: Parts, name: str, path: Path | None) -> Variant:
    given = tuple(_given(key, value, parts) for key, value in file.given.items())
    parts.values = {entry.name: entry.value for entry in given}
    laws = tuple(_law("drive", key, value, parts) for key, value in file.drive.items())
    functions = tuple(_law("functions", key, value, parts) for key, value in file.functions.items())
    constraints = _named([_constraint(i, entry, parts) for i, entry in enumerate(file.constraint)])
    groups = tuple(read_group(i, entry, parts) for i, entry in enumerate(file.group))
    canonical = parts.names.canonical
    points = tuple((canonical(key), parts.formula(("points", key), text, "vector")) for key, text in file.points.items())
    holds = tuple(parts.formula(("closure", "holds", i), text, "scalar") for i, text in enumerate(file.closure.holds))
    used = [f for c in constraints for f in c.sides] + [f for _, f in points] + list(holds)
    angles = _angle_names(used, groups)
    coordinates = tuple(_coordinate(key, entry, parts, angles) for key, entry in file.coordinates.items())
    unknowns = tuple(read_unknown(key, entry, parts) for key, entry in file.unknowns.items())
    bindings = tuple(b for key, entry in file.unknowns.items() if (b := read_binding(key, entry, dict(unknowns), file, parts)))
    time = read_time(file.time, parts)
    columns = [name for c in coordinates for name in (c.name, c.rate)] + [name for name, _ in unknowns]
    forces = _forces(file, coordinates, parts)
    if forces is not None and forces.motor is not None:
        laws += forces.free
    return Variant(
        name, path, file.title or name, file.source, file.teaches, given, laws,
        coordinates, unknowns, functions, time, constraints, groups, points,
        tuple(read_link(key, entry, list(file.links), parts) for key, entry in file.links.items()), read_frame(file.frame, parts),
        parts.known_point(("closure", "driven"), file.closure.driven) if file.closure.driven is not None else None, holds,
        tuple(file.ask.quantities), tuple(map(unfolded, file.remarks)),
        tuple(read_quote(i, entry, columns, time, parts) for i, entry in enumerate(file.quote)), (), _lines(parts.source),
        texts={language: _texts(said, parts) for language, said in file.text.items()}, bindings=bindings,
        forces=forces,
    )  # fmt: skip


def _forces(file: schema.VariantFile, coordinates: tuple[Coordinate, ...], parts: Parts) -> Forces | None:
    """Return the forces of a file, None if it has no such section."""
    if FORCE_SECTIONS.isdisjoint(parts.source.data):
        return None
    from coursework.variant.reading.forces import read_forces

    return read_forces(file, coordinates, parts)


def _texts(said: schema.Texts, parts: Parts) -> Texts:
    means = {parts.names.canonical(name): text for name, text in said.means.items()}
    return Texts(said.title, said.source, said.teaches, tuple(map(unfolded, said.remarks)), said.because, means)


def _lines(source: Source) -> dict[KeyPath, int]:
    """Return the line of each key, with names in the tool's spelling."""
    return {spell_path(path): line for path, line in source.positions.lines.items()}


def _given(key: str, entry: Any, parts: Parts) -> Given:
    value, means = (entry.value, entry.means) if isinstance(entry, schema.Datum) else (entry, "")
    read = parts.quantity(("given", key), value)
    return Given(parts.names.canonical(key), read.value, read.si, read.text, read.unit, means)


def _law(section: str, key: str, value: Any, parts: Parts) -> Law:
    scope = "time" if section == "drive" else "motion"
    name = parts.names.canonical(key)
    path = (section, key)
    if isinstance(value, schema.Pieces):
        places = [(*path, "pieces", place) for place in range(len(value.pieces))]
        pieces = tuple(
            (parts.number((*place, 0), at, "s"), _formula((*place, 1), text, parts, scope))
            for place, (at, text) in zip(places, value.pieces, strict=True)
        )
        if pieces and pieces[0][0] != 0:
            parts.say((*places[0], 0), say("fault.V068", pieces=value.pieces[0][0]))
        for place, ((earlier, _), (later, _)) in zip(places[1:], itertools.pairwise(pieces), strict=True):
            if later <= earlier:
                parts.say(place, say("fault.V074", later=later, earlier=earlier))
        return Law(name, pieces=pieces)
    if isinstance(value, schema.Table):
        from coursework.variant.reading.tables import read_table

        table = read_table(value.table, parts.source, (*path, "table"), parts.faults)
        of = parts.names.canonical(value.of)
        known = [known for known, kind in parts.names.kinds.items() if kind == "coordinate"]
        if section == "drive" and of != "t":
            parts.say((*path, "of"), say("fault.V069", of=value.of))
        elif of not in {"t", *known}:
            parts.undeclared((*path, "of"), {"coordinate"}, say("fault.V075", of=value.of, hint=closest(of, known)))
        return Law(name, table=table, of=of, method=value.method, file=value.table)
    return Law(name, _formula(path, value, parts, scope))


def _formula(path: KeyPath, value: str | int | float, parts: Parts, scope: str) -> Formula:
    """Return the formula of a law; a value with a unit, such as "10 rpm", is a formula too."""
    text = str(value)
    with_unit = parts.is_quantity(text) and any(letter.isalpha() or letter == "°" for letter in text)
    return parts.scalar(path, text, scope) if with_unit else parts.formula(path, text, "scalar", scope)


def _constraint(index: int, entry: schema.Constraint, parts: Parts) -> Constraint:
    key = "closure" if entry.closure is not None else "equation"
    path = ("constraint", index, key)
    text = entry.closure if entry.closure is not None else entry.equation
    if text is None or (entry.closure is not None and entry.equation is not None):
        wrong = "fault.V055" if text is not None else "fault.V056"
        if text is not None or not any(path[:2] == ("constraint", index) for path in parts.broken):  # a misspelt key is told
            parts.say(("constraint", index), say(wrong))
        text = "0 = 0"
    left, right = parts.equation(path, text, closure=entry.closure is not None)
    name = str(entry.name)[:40] or str(index + 1)
    return Constraint(name, entry.because, left, right, entry.closure is not None, parts.source.positions.find(path)[0], index)


def _named(constraints: list[Constraint]) -> tuple[Constraint, ...]:
    """Return the constraints with unique names: a second 11 becomes 11', or 11'' where the file itself calls one 11'."""
    named: dict[str, Constraint] = {}
    own = {constraint.name for constraint in constraints}
    for constraint in constraints:
        name = constraint.name
        while name in named or (name in own and name != constraint.name):
            name += "'"
        named[name] = replace(constraint, name=name)
    return tuple(named.values())


def _coordinate(key: str, entry: schema.Coordinate, parts: Parts, angles: set[str]) -> Coordinate:
    name = parts.names.canonical(key)
    path = ("coordinates", key, "start")
    rate = parts.names.canonical(entry.rate)
    guessed = "rad" if name in angles else "m"
    if entry.start is None:
        return Coordinate(name, rate, None, entry.unit or guessed, unit_was_given=entry.unit is not None)
    read = parts.quantity(path, entry.start, entry.unit or "")
    found = {"1": "rad"}.get(read.si, read.si)
    if found not in {"", "rad", "m"}:
        parts.say(path, say("fault.V062", start=entry.start))
    elif entry.unit and found not in {"", entry.unit}:
        parts.say(path, say("fault.V070", measured=measured(entry.unit), unit=entry.unit, start=entry.start))
    unit = entry.unit or (found if found in {"rad", "m"} else guessed)
    given = entry.unit is not None or found in {"rad", "m"}
    return Coordinate(
        name, rate, read.value, unit, read.text, read.unit or unit, unit_was_given=given, start_has_no_unit=not read.unit
    )


def _angle_names(formulas: Iterable[Formula], groups: tuple[Group, ...]) -> set[str]:
    """Return the names that occur inside a trigonometric function or after @: their bare numbers are radians."""
    angles: set[str] = set()
    for tree in (node for formula in formulas for node in formula.walk()):
        if tree.op == "call" and tree.name in {"sin", "cos", "tan"}:
            angles.update(tree.args[0].names())
        elif tree.op == "@":
            angles.update(tree.args[1].names())
    for group in groups:
        angles.update(group.coordinates[: GROUP_KINDS[group.kind]])
    return angles
