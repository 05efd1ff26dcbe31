"""Other data for a variant -> values as its file would write them, or one sentence about the mistake.

Enters: a variant; numbers in SI or texts with a unit.  Leaves: the variant of its file with these values, read anew, so that
nothing derived from the old data is left.  Used by `reader.py`; `model/` and `live/` ask which starts follow from other data.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.units import UnitFault, exact_size, read_as
from coursework.variant.record.held import closed_loops
from coursework.variant.record.other_values import Changes
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say


def with_changes(read: Callable[[Mapping[KeyPath, Any]], Variant], variant: Variant, changed: Changes) -> Variant:
    """Return the variant of its file with other values; `read` reads the file with the new value of each key.

    Raises `InputError` for an unknown name or an unsuitable unit, and for any fault of the changed file.
    """
    new = _new_values(variant, changed)
    changes = {**variant.changes, **new}
    fresh = read(changes)
    follow = follow_from(variant, new)
    pairs = zip(variant.coordinates, fresh.coordinates, strict=True)
    moved = (replace(now, start=None, start_guess=old.start_or_guess) if now.name in follow else now for old, now in pairs)
    own = None if "step" in changed.times else variant.time.own_step
    time = replace(fresh.time, own_step=own)
    own_lines = {fresh.line_of(*path) for path in changes}
    remarks = tuple(replace(one, line=0) if one.line in own_lines else one for one in fresh.plausibility)
    fresh = replace(fresh, coordinates=tuple(moved), time=time, plausibility=remarks)
    return replace(fresh, changes=changes, before=variant.before or variant)


def _new_values(variant: Variant, changed: Changes) -> dict[KeyPath, float | str]:
    """Return the new value of each key.  Raises `InputError` for all unknown names, or for an unsuitable unit."""
    changes: dict[KeyPath, float | str] = {}
    data = {one.name: (one.si, one.unit) for one in variant.given}
    places = {c.name: (c.unit, c.written) for c in variant.coordinates}
    starts = {key: value for key, value in changed.given.items() if spell(str(key)) in places}
    laws = [law.name for law in variant.drive]
    asked = (
        (changed.given, [*data, *places], "datum"),
        (changed.start, list(places), "coordinate"),
        (changed.drive, laws, "drive"),
    )
    unknown = [_unknown(variant, key, known, what) for keys, known, what in asked for key in keys if spell(str(key)) not in known]
    if unknown:
        raise InputError(unknown)
    for key, value in changed.given.items():
        if key not in starts:
            name = spell(str(key))
            changes["given", name] = _written(variant, name, value, *data[name])
    for key, value in {**starts, **changed.start}.items():
        name = spell(str(key))
        changes["coordinates", name, "start"] = _written(variant, name, value, *places[name])
    for key, value in changed.drive.items():
        changes["drive", spell(str(key))] = value
    for key, value in changed.times.items():
        is_time = isinstance(value, (int, float)) and key != "check_row"
        changes["time", key] = _written(variant, key, value, "s", "s") if is_time else value
    return changes


def follow_from(variant: Variant, changes: Iterable[KeyPath]) -> frozenset[str]:
    """Return the coordinates whose start follows from changed data by the geometry and is not itself changed."""
    named = {path[1] for path in changes if path[0] in {"given", "coordinates"}}
    formulas = [formula for _, formula in variant.points] + [f for law in variant.functions for f in law.formulas]
    formulas += [side for one in variant.constraints if one.is_closure for side in (one.left, one.right)]
    formulas += [*variant.holds, *(formula for group in variant.groups for formula in group.formulas)]
    if not named.intersection(name for formula in formulas for name in formula.names()):
        return frozenset(c.name for c in variant.coordinates if c.start_guess is not None) - named
    return followers(variant) - named


def followers(variant: Variant) -> frozenset[str]:
    """Return the coordinates whose start follows other data: those the geometry determines, and those of a loop in [closure]."""
    looped = variant.coordinates if any(closed_loops(variant)) else ()
    return determined(variant) | {c.name for c in looped if c.rate not in variant.known_rates}


def determined(variant: Variant) -> frozenset[str]:
    """Return the coordinates whose start the geometry determines; other start values would contradict it."""
    by_groups = {name for group in variant.groups for name in group.coordinates}
    closed = any(one.is_closure for one in variant.constraints)
    free = (c.name for c in variant.coordinates if c.rate not in variant.known_rates and (closed or c.name in by_groups))
    return frozenset(free)


def _unknown(variant: Variant, key: str, known: list[str], what: str) -> Fault:
    advice = closest(spell(str(key)), known) or say("hint.known", known=", ".join(known))
    return Fault(say("fault.D001", name=key, what=say(f"fault.datum.{what}"), hint=advice), place=variant.name)


def _fault(variant: Variant, name: str, message: Sentence) -> InputError:
    return InputError([Fault(message, place=say("place.datum", variant=variant.name, name=name))])


def _written(variant: Variant, name: str, value: Any, si: str, unit: str) -> float | str:
    """Return a value as the file writes it, in the author's unit if that gives exactly the same number."""
    if isinstance(value, str):
        try:
            read_value = read_as(value, si)
        except UnitFault as fault:
            raise _fault(variant, name, fault.message) from None
        return value if read_value.si or not unit else f"{value} {si}"
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise _fault(variant, name, say("fault.D002", found=repr(value))) from None
    if not math.isfinite(number):
        raise _fault(variant, name, say("fault.D003", found=number))
    if not unit:
        return f"{number!r}".removesuffix(".0")
    size = exact_size(unit)
    text = f"{float(Fraction(repr(number)) / size):.12g}"
    if float(Fraction(text) * size) == number:
        return f"{text} {unit}"
    return f"{number!r} {si}"
