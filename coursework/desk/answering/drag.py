"""A joint dragged: the start values, or the lengths, with which it comes as near as possible to the pointer.

Enters: a `Desk`, a joint, a place (m).  Leaves: the text with new values, and the place that the joint reaches.
By damped least squares; values that geometry determines follow, so that a closed chain stays closed.  Used by `bench.py`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np

from coursework.desk.answering.controls import Written, written_numbers
from coursework.desk.answering.edits import with_values
from coursework.desk.answering.typed import Desk
from coursework.drawing.outline.poses import read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.motion.settings import Settings
from coursework.scene.scene import Scene
from coursework.system.arrays import Array, Complex
from coursework.variant.record.changes import determined, follow_from, followers
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MOST_STEPS, CLOSE = 12, 1e-4  # number of corrections; parts of the mechanism's size, a smaller distance is not seen
NUDGE, WIDEST = 1e-5, 0.6  # rad or m: step of a difference quotient, and largest correction
FINE, CLOSING = 1e-3, 1e-6  # rad or m: start values are written at least so finely; those that close a loop
JUMP = 1.0  # rad: an angle that follows turns less from one start that closes to the next
_HARDER, _EASIER, _STUCK = 10.0, 0.2, 1e3
At = Callable[[Array], complex]


def drag(desk: Desk) -> dict[str, Any]:
    """Return `text` and `ranges`, the place `reached`, whether that is `near`, and a `sentence` if the joint did not move."""
    variant, joint, place = desk.variant, str(desk.body["joint"]), complex(*desk.body["place"])
    lengths = desk.body.get("free") is True
    before = _places(variant)
    if joint not in before:
        return _unmoved(desk, say("desk.no_joint", joint=joint))
    moving = _movable(variant, lengths)
    begin = np.array([_value(one) for one in moving])
    closed = [(begin, Scene(variant, Settings()).start)]  # starts that close, found on the way

    def nearby(values: Array) -> Sequence[float]:
        return min(closed, key=lambda one: float(np.max(np.abs(one[0] - values), initial=0.0)))[1]

    def at(values: Array) -> complex:
        last = nearby(values)
        scene = Scene(_sketched(variant, moving, values, last), Settings())
        angles = [
            abs(now - old) for one, now, old in zip(variant.coordinates, scene.start, last, strict=True) if one.unit == "rad"
        ]
        if max(angles, default=0.0) > JUMP:
            raise ArithmeticError  # another way to assemble the links, or the same a turn later
        closed.append((values, scene.start))
        return _places_of(scene)[joint]

    def written_at(values: Array) -> complex:
        return _places(_guessed(_moved(variant, moving, values), nearby(values)))[joint]

    size = max(abs(a - b) for a in before.values() for b in before.values()) or 1.0
    nearest = _nearest(at, begin, place, size)
    if nearest is None:
        return _unmoved(desk, say("desk.joint_of_data" if not lengths else "desk.joint_fixed", joint=joint))
    found = _closing(written_at, begin, nearest, moving)
    after = _guessed(_moved(variant, moving, found), nearby(found))
    reached = _places(after)[joint]
    near, written = abs(reached - place) < size / 100, _written(variant, after, moving, found)
    why = None if near or written else say("desk.joint_rounded") if lengths else say("desk.joint_closed", joint=joint)
    return {
        **with_values(desk.text, written), "reached": [reached.real, reached.imag], "near": near,
        "sentence": why and desk.words.written(why),
    }  # fmt: skip


def _movable(variant: Variant, lengths: bool) -> list[Written]:
    """Return the lengths, or the start values that nothing else gives: where no drive turns a loop, the first of its freedoms."""
    numbers = written_numbers(variant)
    if lengths:
        return [one for one in numbers if one.path[0] == "given" and one.si == "m"]
    starts = [one for one in numbers if one.path[0] != "given" and one.name not in determined(variant)]
    return [one for one in starts if one.name not in followers(variant)] or starts[: max(1, len(starts) - len(variant.holds))]


def _value(one: Written) -> float:
    return float(one.text.replace("−", "-")) * one.size


def _moved(variant: Variant, moving: Sequence[Written], values: Array) -> Variant:
    """Return the variant with other values (SI); start values that its geometry determines follow.  Raises `InputError`."""
    changed = {one.name: value for one, value in zip(moving, values.tolist(), strict=True)}
    return variant.with_data(given=changed) if moving and moving[0].path[0] == "given" else variant.with_data(start=changed)


def _guessed(variant: Variant, guess: Sequence[float]) -> Variant:
    """Return the variant with other guesses for the start values that follow."""
    pairs = zip(variant.coordinates, guess, strict=True)
    return replace(variant, coordinates=tuple(replace(one, start_guess=g) if one.start is None else one for one, g in pairs))


def _sketched(variant: Variant, moving: Sequence[Written], values: Array, guess: Sequence[float]) -> Variant:
    """Return a variant as `_moved` does, but faster, as only its points are needed.  Raises `ArithmeticError`."""
    now = {one.name: value for one, value in zip(moving, values.tolist(), strict=True)}
    if any(now.get(one.name, 1.0) <= 0 < one.value for one in variant.given):
        raise ArithmeticError  # a length would not be positive
    follow = follow_from(variant, [one.path for one in moving])
    starts = tuple(
        replace(one, start=None, start_guess=one.start_or_guess) if one.name in follow
        else replace(one, start=now.get(one.name, one.start)) for one in variant.coordinates
    )  # fmt: skip
    return _guessed(replace(variant.with_values(now), coordinates=starts, before=variant.before or variant), guess)


def _places(variant: Variant) -> dict[str, complex]:
    """Return the places of the points at the start (m).  Raises `InputError` if the mechanism does not close."""
    return _places_of(Scene(variant, Settings()))


def _places_of(scene: Scene) -> dict[str, complex]:
    outline = read_outline(scene.mechanism)
    poses = read_poses(outline, scene.equations)(np.zeros(1), np.array([scene.start])) if outline else None
    return poses.pose(0) if poses else {}


def _nearest(at: At, begin: Array, place: complex, size: float) -> Array | None:
    """Return values, starting from `begin`, that bring the point `at` nearest to `place`; None if no value moves it."""
    values, point, damping = begin, at(begin), 1e-3
    slopes = _slopes(at, begin, point)
    if not np.any(np.abs(slopes) > CLOSE):
        return None
    for _ in range(MOST_STEPS):
        if abs(point - place) < CLOSE * size or damping > _STUCK:
            break
        rows = np.array([slopes.real, slopes.imag])
        away = np.array([(place - point).real, (place - point).imag])
        scale = float(np.max(np.sum(rows * rows, axis=0)))
        step = np.linalg.solve(rows.T @ rows + damping * scale * np.eye(len(values)), rows.T @ away)
        step *= min(1.0, WIDEST / float(np.max(np.abs(step), initial=1e-300)))
        tried = _tried(at, values + step)
        if tried is None or abs(tried - place) >= abs(point - place):
            damping *= _HARDER
            continue
        values, point, damping = values + step, tried, damping * _EASIER
        slopes = _slopes(at, values, point)
    return values


def _closing(at: At, begin: Array, nearest: Array, moving: Sequence[Written]) -> Array:
    """Return the values rounded as the file writes them, moved back towards `begin` until the mechanism closes with them."""
    for share in (1.0, 0.98, 0.95, 0.9, 0.8, 0.5):
        values = (begin + share * (nearest - begin)).tolist()
        found = np.array([round(v / one.size, _decimals(one)) * one.size for one, v in zip(moving, values, strict=True)])
        if _tried(at, found) is not None:
            return found
    return begin


def _decimals(one: Written, fine: float = FINE) -> int:
    return one.digits if one.path[0] == "given" else max(one.digits, math.ceil(-math.log10(fine / one.size)))


def _slopes(at: At, values: Array, point: complex) -> Complex:
    nudged = [_tried(at, values + NUDGE * axis) for axis in np.eye(len(values))]
    return np.array([0.0 if one is None else (one - point) / NUDGE for one in nudged], dtype=complex)


def _tried(at: At, values: Array) -> complex | None:
    """Return the place of a point with other values, None if the mechanism does not close with them."""
    with suppress(InputError, ArithmeticError):
        return point if cmath.isfinite(point := at(values)) else None
    return None


def _written(variant: Variant, after: Variant, moving: Sequence[Written], values: Array) -> dict[KeyPath, str]:
    """Return the new texts of values that moved, and of start values that follow from them, with the decimals of the file."""
    starts = dict(zip((one.name for one in after.coordinates), Scene(after, Settings()).start, strict=True))
    now = {one.name: value for one, value in zip(moving, values.tolist(), strict=True)}
    follow = follow_from(variant, [one.path for one in moving]) - determined(variant)
    found: dict[KeyPath, str] = {}
    for one in written_numbers(variant):
        is_start = one.path[0] != "given"
        value = now.get(one.name, starts[one.name] if is_start and one.name in starts else _value(one))
        decimals = _decimals(one, CLOSING if one.name in follow else FINE)
        if abs(value - _value(one)) > 0.5 * one.size * 10.0**-decimals:
            found[one.path] = one.spelled(value, decimals)
    return found if any(one.path in found for one in moving) else {}  # what only follows has not moved, but more digits


def _unmoved(desk: Desk, why: Sentence) -> dict[str, Any]:
    return desk.unchanged(why) | {"reached": None, "near": False}
