"""[masses], [forces], [friction] and [motor] of a file -> `Forces`; imported only for a file with one of these sections.

Enters: checked sections.  Leaves: `Forces`; the faults are collected by `Parts`.  Used by `reader.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress

from coursework.variant.formula.tree import Formula, FormulaFault, evaluate
from coursework.variant.reading import schema
from coursework.variant.reading.parts import ZERO, Parts
from coursework.variant.reading.shape import of_motor
from coursework.variant.record.forces import GRAVITY, MEASURED, SHAPES, Flywheel, Forces, Friction, Load, Mass, Motor, Spring
from coursework.variant.record.no_value import known_value
from coursework.variant.record.variant import Coordinate
from coursework.variant.toml.positions import KeyPath
from coursework.words.sentences import closest, say, say_count

_FRAME = "0"
_OF_MOTOR = ("rates", "start", "flywheel")


def read_forces(file: schema.VariantFile, coordinates: Sequence[Coordinate], parts: Parts) -> Forces:
    """Return the masses and forces of a file."""
    gravity = file.forces.get(GRAVITY)
    loads = {key: entry for key, entry in file.forces.items() if key != GRAVITY}
    if isinstance(gravity, schema.Load):
        parts.say(("forces", GRAVITY), say("fault.V703"))
        gravity = None
    read: list[Load | Spring] = [one for key, entry in loads.items() for one in _load(key, entry, parts)]
    flywheel = file.motor.get("flywheel")
    return Forces(
        tuple(_mass(key, entry, parts) for key, entry in file.masses.items()),
        _gravity(gravity, parts) if gravity is not None else None,
        tuple(one for one in read if isinstance(one, Load)), tuple(one for one in read if isinstance(one, Spring)),
        tuple(_friction(key, entry, parts) for key, entry in file.friction.items()), _motor(file, coordinates, parts),
        _flywheel(flywheel, parts) if flywheel is not None else None,
    )  # fmt: skip


def _mass(key: str, entry: schema.Mass | str | float, parts: Parts) -> Mass:
    path: KeyPath = ("masses", key)
    if not isinstance(entry, schema.Mass):
        return Mass(_body(key, parts), _value(path, entry, "kg", parts, True), None, None)
    shape = str(entry.inertia).strip() if entry.inertia is not None else ""
    inertia: Formula | str | None = shape if shape in SHAPES else None
    if shape.isalpha() and inertia is None and parts.names.canonical(shape) not in parts.names.kinds:
        parts.say((*path, "inertia"), say("fault.V751", found=shape[:40]))
    elif entry.inertia is not None and inertia is None:
        inertia = _value((*path, "inertia"), entry.inertia, "kg*m^2", parts, True)
    centre = parts.formula((*path, "centre"), entry.centre, "vector") if entry.centre is not None else None
    return Mass(_body(key, parts), _value((*path, "mass"), entry.mass, "kg", parts, True), inertia, centre)


def _body(key: str, parts: Parts) -> str:
    name = parts.names.canonical(key)
    return name if parts.names.kinds.get(name) == "point" else key


def _value(path: KeyPath, value: str | int | float, si: str, parts: Parts, least: bool = False) -> Formula:
    """Return a formula of data in the SI unit `si`; with `least`, keep a fault if its value is negative."""
    tree = parts.scalar(path, value, "force", si)
    if least and parts.sound and (known_value(tree, parts.values) or 0.0) < 0:  # without a value yet: checked elsewhere
        parts.say(path, say("fault.V704", found=str(value)))
    return tree


def _values(
    path: KeyPath, entry: schema.Section, keys: Iterable[str], parts: Parts, least: bool = False
) -> dict[str, Formula | None]:
    """Return the formulas of some keys of an entry, None for a key that the entry does not have."""
    said = {key: getattr(entry, key) for key in keys}
    return {
        key: None if value is None else _value((*path, key), value, MEASURED[key], parts, least) for key, value in said.items()
    }


def _gravity(value: str | int | float, parts: Parts) -> tuple[Formula, Formula]:
    path: KeyPath = ("forces", GRAVITY)
    if isinstance(value, str) and "," in value:
        tree = parts.formula(path, value, "vector", "force")
        x, y = tree.args if tree.op == "pair" else (Formula("part", (tree,), axis) for axis in "xy")
        return x, y
    return ZERO, Formula("neg", (_value(path, value, "m/s^2", parts, True),))


def _load(key: str, entry: schema.Load | str | float, parts: Parts) -> Iterator[Load | Spring]:
    path: KeyPath = ("forces", key)
    if not isinstance(entry, schema.Load):
        parts.say(path, say("fault.V705", name=key, hint=closest(key, [GRAVITY])))
        return
    ends = entry.spring or entry.damper
    if ends:
        kind = "spring" if entry.spring else "damper"
        both = parts.known_point((*path, kind, 0), ends[0]), parts.known_point((*path, kind, 1), ends[1])
        if both[0] == both[1]:
            parts.say(path, say("fault.V745", name=key, point=ends[0]))
        missing = [name for name in (("stiffness", "free") if entry.spring else ("damping",)) if getattr(entry, name) is None]
        if missing:
            parts.say(path, say("fault.V706", name=key, missing=missing[0]))
        yield Spring(key, both, **_values(path, entry, ("stiffness", "free", "damping"), parts, True))
        return
    if entry.on is None or (entry.force is None) == (entry.torque is None):
        parts.say(path, say("fault.V707", name=key))
        return
    if entry.force is not None and entry.at is None:
        parts.say(path, say("fault.V708", name=key))
        return
    at = parts.formula((*path, "at"), entry.at, "vector", "geometry") if entry.at is not None else None
    torque = _values(path, entry, ["torque"], parts)["torque"]
    force = parts.formula((*path, "force"), str(entry.force), "vector", "force") if entry.force is not None else None
    yield Load(key, _body(str(entry.on), parts), at, force, torque)


def _friction(key: str, entry: schema.FrictionEntry, parts: Parts) -> Friction:
    path: KeyPath = ("friction", key)
    point = parts.known_point(path, key)
    found = _values(path, entry, ("coefficient", "radius", "length", "arm"), parts, True)
    if entry.coefficient is None and entry.arm is None:
        parts.say(path, say("fault.V709", name=key))
    return Friction(point, **found)


def _motor(file: schema.VariantFile, coordinates: Sequence[Coordinate], parts: Parts) -> Motor | None:
    rates = file.motor.get("rates")
    if rates is None:
        for key in file.motor:
            if key != "flywheel":
                parts.say(("motor", key), say("fault.V710", rate=coordinates[0].rate if coordinates else "w1"))
        return None
    units = {coordinate.rate: coordinate.unit for coordinate in coordinates}
    found = _free(rates, list(units), parts)
    if file.drive:
        parts.say(("motor",), say("fault.V711"))
    start: dict[str, float] = {}
    begins = file.motor.get("start", {})
    for name, value in begins.items() if isinstance(begins, dict) else ():
        rate = parts.names.canonical(name)
        if rate not in found:
            parts.say(("motor", "start", name), say_count("fault.V712", len(found), name=name, known=", ".join(found)))
        else:
            tree = _value(("motor", "start", name), value, "m/s" if units[rate] == "m" else "1/s", parts)
            with suppress(KeyError, FormulaFault):
                start[rate] = evaluate(tree, parts.values) if parts.sound else 0.0
    torques = []
    for key, entry in file.motor.items():
        if key in _OF_MOTOR:
            continue
        if not isinstance(entry, schema.MotorEntry):
            parts.say(("motor", key), of_motor(key, file.links))
            continue
        torque = _value(("motor", key, "torque"), entry.torque, "N*m", parts)
        source = _FRAME if entry.source is None else _body(str(entry.source), parts)
        torques.append(Load(key, _body(key, parts), None, None, torque, source))
    return Motor(found, tuple(start.items()), tuple(torques))


def _free(rates: object, known: list[str], parts: Parts) -> tuple[str, ...]:
    listed: Sequence[object] = rates if isinstance(rates, list) else ()
    found = []
    for place, rate in enumerate(listed):
        name = parts.names.canonical(str(rate))
        if name in found:
            parts.say(("motor", "rates", place), say("fault.V717", name=name))
        elif name in known:
            found.append(name)
        else:
            parts.say(("motor", "rates", place), say("fault.V714", name=str(rate), hint=closest(str(rate), known)))
    if not 1 <= len(listed) <= 2:
        parts.say(("motor", "rates"), say("fault.V715", number=len(listed)))
    return tuple(found)


def _flywheel(entry: object, parts: Parts) -> Flywheel | None:
    path: KeyPath = ("motor", "flywheel")
    if not isinstance(entry, schema.Flywheel):
        parts.say(path, of_motor("flywheel", ()))
        return None
    return Flywheel(_body(str(entry.on), parts), **_values(path, entry, ("inertia", "unevenness"), parts, True))
