"""Euler's tables of the mechanism in its other assemblies: the misconception "branch".

Enters: a `Variant` and the key's table.  Leaves: tables (n, m + r).  Used by `key.py`, once a variant, when a table needs
them.  In a chain of groups the modes are changed; with position equations, their other solutions at t = 0 are searched for.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import combinations, islice

import numpy as np

from coursework.api import make_run
from coursework.equations.reduction.equations import differentiate
from coursework.mechanism.mechanism import build
from coursework.motion.geometry.closed_start import closed_start
from coursework.motion.geometry.closure import Closure, compile_closure
from coursework.motion.geometry.start import start_values
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, Flags
from coursework.variant.record.variant import Variant
from coursework.words.errors import CourseworkError

MOST = 7  # assemblies: as many as three groups have besides the given one
_GUESSES, _SEED = 64, 31  # random positions from which Newton's method starts; the same ones on every machine
_SAME = 1e-6  # rad or m: positions nearer than this are the same
_TURN = 2 * np.pi


def other_assemblies(variant: Variant, key: Array) -> list[Array]:
    """Return the tables of the other assemblies; whole turns by which their angles differ from `key` (n, m + r) are taken off."""
    found = []
    for other in islice(_by_modes(variant) if variant.groups else _by_closures(variant), MOST):
        with suppress(CourseworkError):
            table = make_run(other, DEFAULT_SCHEME.name, quantities=["table"]).motion.rows.copy()
            if table.shape == key.shape:
                turning = [place for place, coordinate in enumerate(variant.coordinates) if coordinate.unit == "rad"]
                table[:, turning] -= whole_turns(np.median(table - key, axis=0)[turning])
                found.append(table)
    return found


def _by_modes(variant: Variant) -> Iterator[Variant]:
    """Yield the variant with the mode of one group changed, then of two, and so on."""
    turnable = [place for place, group in enumerate(variant.groups) if group.mode]
    for count in range(1, len(turnable) + 1):
        for chosen in combinations(turnable, count):
            groups = tuple(
                replace(group, mode=-group.mode) if place in chosen else group for place, group in enumerate(variant.groups)
            )
            free = {name for place in range(min(chosen), len(groups)) for name in groups[place].coordinates}
            coordinates = tuple(replace(c, start=None) if c.name in free else c for c in variant.coordinates)
            yield replace(variant, groups=groups, coordinates=coordinates)


def _by_closures(variant: Variant) -> Iterator[Variant]:
    """Yield the variant with each other start that its position equations allow."""
    with suppress(CourseworkError, ArithmeticError, ValueError):
        equations = differentiate(build(variant))
        closure = compile_closure(equations, start_values(equations))
        for start in _roots(closure, variant) if closure is not None and closure.complete else ():
            coordinates = (replace(c, start=float(q)) for c, q in zip(variant.coordinates, start, strict=True))
            yield replace(variant, coordinates=tuple(coordinates))


def _roots(closure: Closure, variant: Variant) -> Iterator[Array]:
    """Yield the positions (m,) at t = 0 that fulfil the same position equations as the start, without the start itself."""
    turning = np.array([coordinate.unit == "rad" for coordinate in variant.coordinates])
    sizes = np.where(turning, np.pi, closure.scale)[list(closure.free)]
    own = closed_start(closure)[1]
    known = [closure.start if own is None else own]
    chance = np.random.Generator(np.random.PCG64(_SEED))
    guesses = np.tile(closure.start, (_GUESSES, 1))
    guesses[:, list(closure.free)] = chance.uniform(-sizes, sizes, (_GUESSES, len(sizes)))
    for root in _closed(closure, guesses):
        root[turning] = (root[turning] + np.pi) % _TURN - np.pi
        if not any(_apart(root, other, turning) < _SAME for other in known):
            known.append(root)
            yield root


def _closed(closure: Closure, guesses: Array) -> list[Array]:
    """Return the positions (m,) to which guesses (n, m) lead, without those that lead to none."""
    try:
        found, is_closed = closure.newton_rows(np.zeros(len(guesses)), guesses, np.tile(closure.origin, (len(guesses), 1)))
        return [*found[is_closed]]
    except np.linalg.LinAlgError:  # one of them is singular on its way: it must not spoil the others
        roots = (closure.newton(0.0, guess, closure.origin) for guess in guesses)
        return [root for root in roots if root is not None and np.all(np.isfinite(root))]


def _apart(first: Array, second: Array, turning: Flags) -> float:
    """Return the largest difference of two positions; angles that differ by whole turns are equal."""
    difference = first - second
    difference[turning] = (difference[turning] + np.pi) % _TURN - np.pi
    return float(np.max(np.abs(difference)))
