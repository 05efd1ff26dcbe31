"""A variant file -> `Variant`, or every fault of the file in one go.

Enters: a path, or text.  Leaves: a frozen `Variant`.  Raises `InputError`.
"""

from __future__ import annotations

import copy
import itertools
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from coursework.errors import Fault, InputError, closest
from coursework.formula import Formula, number
from coursework.variant import schema
from coursework.variant.names import Names
from coursework.variant.parts import Parts
from coursework.variant.record import Constraint, Coordinate, Frame, Given, Group, Guide, Law, Link, Time, Variant
from coursework.variant.record import whole_steps as _whole_steps
from coursework.variant.source import Source, read_bytes, read_source
from coursework.variant.tables import read_table

MAX_ROWS = 200_000


def read_variant(path: Path) -> Variant:
    """Return the variant in a file.  Raises `InputError` with all faults."""
    return _build(read_source(read_bytes(path), str(path), path.parent), path.stem, path)


def parse_variant(content: str | bytes, file: str = "variant") -> Variant:
    """Return the variant in a text (no tables beside it can be read)."""
    raw = content.encode("utf-8") if isinstance(content, str) else content
    return _build(read_source(raw, file, None), file, None)


def _build(source: Source, name: str, path: Path | None) -> Variant:
    file, unknown = _validate(source)
    parts = Parts(source, Names.declared(file))
    parts.faults += unknown + parts.names.faults(source)
    variant = _assemble(file, parts, name, path)
    if not parts.faults:
        parts.faults += _rules(file, variant, source)
    if parts.faults:
        raise InputError(parts.faults)
    return variant


def _validate(source: Source) -> tuple[schema.VariantFile, list[Fault]]:
    """Return the checked file and a fault for each unknown key; any other fault of shape ends the reading."""
    data = copy.deepcopy(source.data)
    unknown: list[Fault] = []
    while True:
        try:
            return schema.VariantFile.model_validate(data), unknown
        except ValidationError as error:
            extra = [entry for entry in error.errors(include_url=False) if entry["type"] == "extra_forbidden"]
            unknown += _schema_faults(extra, source)
            if len(extra) < error.error_count() or not extra:
                rest = [entry for entry in error.errors(include_url=False) if entry not in extra]
                raise InputError(unknown + _schema_faults(rest, source)) from error
            for entry in extra:
                owner: Any = data
                for part in _file_path(entry["loc"])[:-1]:
                    owner = owner[part]
                del owner[_file_path(entry["loc"])[-1]]


def _assemble(file: schema.VariantFile, parts: Parts, name: str, path: Path | None) -> Variant:
    given = tuple(_given(key, value, parts) for key, value in file.given.items())
    parts.values = {entry.name: entry.value for entry in given}
    laws = tuple(_law("drive", key, value, parts) for key, value in file.drive.items())
    functions = tuple(_law("functions", key, value, parts) for key, value in file.functions.items())
    constraints = tuple(_constraint(i, entry, parts) for i, entry in enumerate(file.constraint))
    groups = tuple(_group(i, entry, parts) for i, entry in enumerate(file.group))
    points = tuple(
        (parts.names.canonical(key), parts.formula(("points", key), text, "vector")) for key, text in file.points.items()
    )
    holds = tuple(parts.formula(("closure", "holds"), text, "scalar") for text in file.closure.holds)
    used = [f for c in constraints for f in (c.left, c.right)] + [f for _, f in points] + list(holds)
    angles = _angle_names(used, groups)
    return Variant(
        name, path, file.title or name, file.source, file.teaches, given, laws,
        tuple(_coordinate(key, entry, parts, angles) for key, entry in file.coordinates.items()),
        tuple((parts.names.canonical(key), parts.unit(("unknowns", key), unit)) for key, unit in file.unknowns.items()),
        functions, _time(file.time, parts), constraints, groups, points,
        tuple(_link(key, entry, parts) for key, entry in file.links.items()), _frame(file.frame, parts),
        file.closure.driven, holds, tuple(file.ask.quantities), tuple(file.remarks),
    )  # fmt: skip


def _given(key: str, value: Any, parts: Parts) -> Given:
    read = parts.quantity(("given", key), value)
    return Given(parts.names.canonical(key), read.value, read.si, read.text, read.unit)


def _law(section: str, key: str, value: Any, parts: Parts) -> Law:
    scope = "time" if section == "drive" else "motion"
    name = parts.names.canonical(key)
    path = (section, key)
    if isinstance(value, schema.Pieces):
        pieces = tuple((parts.number(path, at, "s"), parts.formula(path, str(text), "scalar", scope)) for at, text in value.pieces)
        if any(later <= earlier for (earlier, _), (later, _) in itertools.pairwise(pieces)):
            parts.say(path, "the times of the pieces must grow.")
        return Law(name, pieces=pieces)
    if isinstance(value, schema.Table):
        table = read_table(value.table, parts.source, path, parts.faults)
        if value.of not in parts.names.kinds:
            parts.say(path, f'"{value.of}" is not a coordinate of this file.{closest(value.of, list(parts.names.kinds))}')
        return Law(name, table=table, of=parts.names.canonical(value.of), method=value.method)
    return Law(name, parts.formula(path, value, "scalar", scope))


def _constraint(index: int, entry: schema.Constraint, parts: Parts) -> Constraint:
    key = "closure" if entry.closure is not None else "equation"
    path = ("constraint", index, key)
    text = entry.closure if entry.closure is not None else entry.equation
    if text is None or (entry.closure is not None and entry.equation is not None):
        parts.say(("constraint", index), "a constraint has exactly one of `equation` and `closure`.")
        text = "0 = 0"
    left, right = parts.equation(path, text, closure=entry.closure is not None)
    name = str(entry.name) or str(index + 1)
    return Constraint(name, entry.because, left, right, entry.closure is not None, parts.source.positions.find(path)[0])


def _group(index: int, entry: schema.Group, parts: Parts) -> Group:
    path = ("group", index)

    def scalar(key: str, value: Any) -> Formula:
        return parts.scalar((*path, key), value)

    listed = ([entry.guide] if entry.guide else []) + list(entry.guides)
    guides = tuple(
        Guide(parts.formula((*path, "guide"), g.through, "vector"), scalar("guide", g.angle), scalar("guide", g.offset))
        for g in listed
    )
    for coordinate in entry.coordinates:
        if parts.names.kinds.get(parts.names.canonical(coordinate)) != "coordinate":
            known = [name for name, kind in parts.names.kinds.items() if kind == "coordinate"]
            parts.say((*path, "coordinates"), f'"{coordinate}" is not in [coordinates].{closest(coordinate, known)}')
    return Group(
        entry.kind,
        tuple(parts.formula((*path, "from"), text, "vector") for text in entry.start_points),
        entry.meets,
        tuple(scalar("lengths", value) for value in entry.lengths),
        tuple(parts.names.canonical(coordinate) for coordinate in entry.coordinates),
        int(entry.mode or 1),
        guides,
        scalar("offset", entry.offset if entry.offset is not None else 0),
        scalar("angle", entry.angle) if entry.angle is not None else None,
        parts.source.positions.find(path)[0],
    )


def _coordinate(key: str, entry: schema.Coordinate, parts: Parts, angles: set[str]) -> Coordinate:
    name = parts.names.canonical(key)
    path = ("coordinates", key, "start")
    rate = parts.names.canonical(entry.rate)
    guessed = "rad" if name in angles else "m"
    if entry.start is None:
        return Coordinate(name, rate, None, entry.unit or guessed)
    read = parts.quantity(path, entry.start)
    if read.si not in {"", "rad", "m", "1"}:
        parts.say(path, f'a coordinate starts at an angle (rad, deg) or a length (m), found "{entry.start}".')
    unit = entry.unit or (read.si if read.si in {"rad", "m"} else guessed)
    return Coordinate(name, rate, read.value, unit, read.text, read.unit or unit)


def _time(entry: schema.Time, parts: Parts) -> Time:
    step = parts.number(("time", "step"), entry.step, "s")
    end = parts.number(("time", "end"), entry.end, "s")
    period = None if entry.period is None else parts.number(("time", "period"), entry.period, "s")
    if not step > 0:
        parts.say(("time", "step"), f"the step must be greater than 0, found {step:g} s.")
    elif not end >= step * (1 - 1e-9):
        parts.say(("time", "end"), f"the end ({end:g} s) must be at least one step ({step:g} s).")
    elif end / step > MAX_ROWS:
        parts.say(("time", "end"), f"{end / step:.3g} rows are asked for; at most {MAX_ROWS} are computed. Take a larger step.")
    elif entry.check_row is not None and entry.check_row > _whole_steps(step, end) + 1:
        parts.say(("time", "check_row"), f"row {entry.check_row} is beyond the last row, {_whole_steps(step, end) + 1}.")
    if period is not None and not period > 0:
        parts.say(("time", "period"), f"the period must be greater than 0, found {period:g} s.")
    return Time(step, end, period, entry.check_row)


def _link(key: str, entry: schema.Link, parts: Parts) -> Link:
    named = (*entry.points, *(point for point in (entry.wheel, entry.contact) if point))
    for point in named:
        parts.known_point(("links", key), point)
    if entry.rate and parts.names.canonical(entry.rate) not in parts.names.velocities:
        parts.say(("links", key, "rate"), f'"{entry.rate}" is no velocity.{closest(entry.rate, parts.names.velocities)}')
    rate = parts.names.canonical(entry.rate) if entry.rate else None
    return Link(key, tuple(entry.points), rate, entry.wheel, entry.contact)


def _frame(entry: schema.Frame, parts: Parts) -> Frame:
    for point in entry.hinges:
        parts.known_point(("frame", "hinges"), point)
    rails = tuple(
        (parts.formula(("frame", "rails"), r.through, "vector"), parts.scalar(("frame", "rails"), r.angle)) for r in entry.rails
    )
    circles = tuple(
        (parts.formula(("frame", "circles"), c.center, "vector"), parts.scalar(("frame", "circles"), c.radius))
        for c in entry.circles
    )
    return Frame(tuple(entry.hinges), rails, circles)


def _angle_names(formulas: Iterable[Formula], groups: tuple[Group, ...]) -> set[str]:
    """Return the names that stand inside a trigonometric function or behind @: their bare numbers are radians."""
    angles: set[str] = set()
    for tree in (node for formula in formulas for node in formula.walk()):
        if tree.op == "call" and tree.name in {"sin", "cos", "tan"}:
            angles.update(tree.args[0].names())
        elif tree.op == "@":
            angles.update(tree.args[1].names())
    for group in groups:
        first = {"crank": 1, "RRR": 2, "RRP": 1, "RPR": 1}.get(group.kind, 0)
        angles.update(group.coordinates[:first])
    return angles


def _rules(file: schema.VariantFile, variant: Variant, source: Source) -> list[Fault]:
    """What only the whole file can show."""
    faults = []
    if not variant.constraints and not variant.groups and not (variant.driven or variant.holds):
        faults.append(source.fault((), "no constraint is given: write [[constraint]] or [[group]] sections."))
    in_groups = {name for group in variant.groups for name in group.coordinates}
    for coordinate in variant.coordinates:
        if coordinate.start is None and coordinate.name not in in_groups:
            faults.append(source.fault(("coordinates", coordinate.name), "the value at t = 0 is missing: start = …"))
    if variant.driven:
        if variant.driven not in dict(variant.points) and variant.driven not in {g.meets for g in variant.groups}:
            message = f'the driven point "{variant.driven}" is not in [points].{closest(variant.driven, list(file.points))}'
            faults.append(source.fault(("closure", "driven"), message))
        for part in "xy":
            if f"V{variant.driven}{part}" not in {law.name for law in variant.drive}:
                message = f"the driven point {variant.driven} needs V{variant.driven}{part} in [drive]."
                faults.append(source.fault(("closure", "driven"), message))
    zero = {entry.name for entry in variant.given if entry.value == 0 and entry.si == "m"}
    for name, point in variant.points:
        for node in point.walk():
            if node.op == "@" and (set(node.args[0].names()) & zero or node.args[0] == number(0)):
                culprit = ", ".join(sorted(set(node.args[0].names()) & zero)) or "0"
                message = (
                    f"the link of length {culprit} has zero length, so its angular velocity means nothing. "
                    "Remove the link and let its two joints be one."
                )
                faults.append(source.fault(("points", name), message))
    return faults


def _file_path(loc: tuple[str | int, ...]) -> tuple[str | int, ...]:
    """Return the path of the file's own keys: pydantic adds the name of the union's member."""
    return tuple(part for part in loc if part not in _UNION_MEMBERS and "constrained" not in str(part))


def _schema_faults(entries: Sequence[Any], source: Source) -> list[Fault]:
    faults: dict[tuple[Any, ...], Fault] = {}
    for entry in entries:
        path = _file_path(entry["loc"])
        faults.setdefault(path, _schema_fault(entry, path, source))
    return list(faults.values())


def _schema_fault(entry: Any, path: tuple[str | int, ...], source: Source) -> Fault:
    key = str(path[-1]) if path else ""
    if entry["type"] == "extra_forbidden":
        parent = source.data
        for part in path[:-1]:
            parent = parent[part]  # type: ignore[index]  # the path leads through tables and lists alike
        known = sorted(_known_keys(path[:-1]))
        return source.fault(path, f'the key "{key}" is not known here.{closest(key, known)} Known keys: {", ".join(known)}.')
    if entry["type"] == "missing":
        what = "section" if len(path) == 1 else "key"
        return source.fault(path[:-1], f'the {what} "{key}" is missing.')
    found = repr(entry.get("input"))[:60]
    return source.fault(path, f"{entry['msg'][:1].lower()}{entry['msg'][1:]} (found {found}).")


def _known_keys(path: tuple[str | int, ...]) -> set[str]:
    model: Any = schema.VariantFile
    for part in path:
        if isinstance(part, int) or part not in getattr(model, "model_fields", {}):
            continue
        model = _MODELS_BY_KEY.get(part, model)
    return {field.alias or name for name, field in model.model_fields.items()}


_MODELS_BY_KEY: dict[str | int, Any] = {
    "time": schema.Time, "constraint": schema.Constraint, "group": schema.Group, "links": schema.Link,
    "frame": schema.Frame, "closure": schema.Closure, "ask": schema.Ask, "coordinates": schema.Coordinate,
    "guide": schema.Guide, "guides": schema.Guide, "rails": schema.Rail, "circles": schema.Circle,
}  # fmt: skip
_UNION_MEMBERS = {"Pieces", "Table", "str", "int", "float"}
