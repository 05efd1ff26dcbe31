"""Several starts that one number explains: where the geometry gives some starts, one datum or one start changes the others.

Enters: a `Key`, a start.  Leaves: the name of the datum or coordinate.  Used by `starts.py`.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.grading.marking.key.key import Key
from coursework.motion.geometry.start import start_values
from coursework.system.arrays import Array
from coursework.variant.record.entries import Given
from coursework.words.errors import CourseworkError

_ROUNDS, _DIFFERENCE = 6, 1e-4  # Newton steps to a datum, and the part of it by which its slope is taken


def one_number(key: Key, start: Array, within: Array) -> str:
    """Return the coordinate or datum from another value of which the starts (m,) follow, up to `within`; "" if there is none.

    The rows follow from the start with the task's velocities: they must not depend on such a datum.
    """
    given = [place for place, one in enumerate(key.variant.coordinates) if one.start is not None]
    if len(given) == len(start):
        return ""
    other = np.flatnonzero(np.abs(start - key.table[0, : len(start)]) > within)
    changed = [place for place in given if place in other]
    if len(changed) == 1 and _is_near(_closed(key, {}, {changed[0]: float(start[changed[0]])}), start, within):
        return key.coordinates[changed[0]]
    if changed:
        return ""
    task = _closed(key, {}, {})
    for datum in _felt_by_none(key):
        value, at, slope = datum.value, task, 0.0
        for _ in range(_ROUNDS):
            beside = _closed(key, {datum.name: value * (1 + _DIFFERENCE)}, {})
            if at is None or beside is None or not (slope := float(np.sum((beside - at)[other] ** 2))):
                break
            value += value * _DIFFERENCE * float(np.dot((beside - at)[other], (start - at)[other])) / slope
            at = _closed(key, {datum.name: value}, {})
        if slope and _is_near(at, start, within):
            return datum.name
    return ""


def _felt_by_none(key: Key) -> list[Given]:
    """Return the data of which no velocity depends."""
    q = key.table[:, : len(key.coordinates)]
    given = key.variant.given
    task, *others = key.sets_at(key.t, q, [{}, *({one.name: one.value * (1 + _DIFFERENCE)} for one in given)])
    return [one for one, found in zip(given, others, strict=True) if np.array_equal(found, task, equal_nan=True)]


def _closed(key: Key, data: dict[str, float], starts: dict[int, float]) -> Array | None:
    """Return the closed starts (m,) with other data and other given starts, None if nothing closes."""
    variant = key.variant
    other = replace(
        variant,
        given=tuple(replace(one, value=data.get(one.name, one.value)) for one in variant.given),
        coordinates=tuple(replace(one, start=starts.get(place, one.start)) for place, one in enumerate(variant.coordinates)),
    )
    with suppress(CourseworkError, ArithmeticError, ValueError):
        return np.array(start_values(replace(key.model.equations, variant=other)))
    return None


def _is_near(made: Array | None, start: Array, within: Array) -> bool:
    return made is not None and bool(np.all(np.abs(made - start) <= within))
