"""Tables beside the results table: analogs and invariants of a crank-driven motion, ready for a page.

Enters: a motion with its accelerations.  Leaves: `ExtraTable`.  Computed on request only.
Used by `scene_run.py`, `quantities.py`, `tables.py` and `scene_run.py`.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.results.kinematics.analogs import acceleration_analog, velocity_analog
from coursework.results.kinematics.invariants import from_true
from coursework.system.arrays import Array
from coursework.variant.record.variant import Coordinate, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


@dataclass(frozen=True, slots=True)
class ExtraTable:
    """`rows` (n, len(names)) in `units`; the first column is t or the crank angle.

    `sizes` tells how large the terms are that a column is the sum of: beside them its round-off is none to print.
    """

    title: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: Array
    sizes: tuple[float, ...] = ()
    note: str = ""


def analog_table(variant: Variant, motion: Motion, second: Array) -> ExtraTable:
    """Return dq/dφ1 and d²q/dφ1² of every coordinate but the crank's; `second` (n, k) accelerations of the motion.

    Raises `InputError` where the mechanism has not exactly one driven coordinate, or the crank stands still.
    """
    crank = _crank(variant)
    omega, epsilon = _crank_motion(variant, crank, motion, second)
    names, units, columns, sizes = [crank.name], ["rad"], [motion.column(crank.name)], [0.0]
    for coordinate in variant.coordinates:
        if coordinate.name == crank.name:
            continue
        place = motion.velocity_names.index(coordinate.rate)
        first = velocity_analog(motion.velocities[:, place], omega)
        names += [f"d{coordinate.name}/d{crank.name}", f"d2{coordinate.name}/d{crank.name}2"]
        units += ["m/rad", "m/rad²"] if coordinate.unit == "m" else ["", "1/rad"]
        columns += [first, acceleration_analog(motion.velocities[:, place], second[:, place], omega, epsilon)]
        sizes += [0.0, float(np.abs(first).max(initial=0.0))]
    return ExtraTable(say("extra.analogs"), tuple(names), tuple(units), np.array(columns).T, tuple(sizes))


def invariant_table(variant: Variant, motion: Motion, second: Array) -> ExtraTable:
    """Return k, a_k, b_k, c_k of the slider over its longest one-way stretch of rows.

    The stroke S and the crank angle Φ are those of the stretch.  Raises `InputError` where there is no slider or crank.
    """
    crank = _crank(variant)
    sliders = [c for c in variant.coordinates if c.unit == "m" and c.rate not in variant.known_rates]
    if not sliders:
        raise _refused(variant, say("fault.V518"))
    slider = sliders[-1]
    rows = _longest_way(motion.column(slider.name))
    s, phi = motion.column(slider.name)[rows], motion.column(crank.name)[rows]
    omega, epsilon = (part[rows] for part in _crank_motion(variant, crank, motion, second))
    place = motion.velocity_names.index(slider.rate)
    way, turn = float(s[-1] - s[0]), float(phi[-1] - phi[0])
    if not (abs(way) > 0 and abs(turn) > 0):
        still = slider.name if abs(way) == 0 else crank.name
        raise _refused(variant, say("fault.V519", name=still))
    sign = np.sign(way)
    found = from_true(
        sign * (s - s[0]), sign * motion.velocities[rows, place], sign * second[rows, place],
        stroke=abs(way), angle=abs(turn), omega_1=omega, epsilon_1=epsilon,
    )  # fmt: skip
    k = (phi - phi[0]) / turn
    span = {"row": rows.start + 1, "last": rows.stop}
    title = say("extra.invariants", name=slider.name, **span, stroke=abs(way), angle=abs(turn))
    note = say("extra.invariants_note", crank=crank.name, name=slider.name)
    sizes = (0.0, 0.0, 0.0, float(np.abs(found.b).max()))
    columns = np.array([k, found.a, found.b, found.c]).T
    return ExtraTable(title, ("k", "a_k", "b_k", "c_k"), ("",) * 4, columns, sizes, note)


def _crank(variant: Variant) -> Coordinate:
    driven = [c for c in variant.coordinates if c.rate in variant.known_rates]
    if len(driven) != 1:
        raise _refused(
            variant,
            say("fault.V520", count=len(driven)),
        )
    return driven[0]


def _crank_motion(variant: Variant, crank: Coordinate, motion: Motion, second: Array) -> tuple[Array, Array]:
    place = motion.velocity_names.index(crank.rate)
    omega = motion.velocities[:, place]
    if not np.all(omega):
        row = int(np.argmin(np.abs(omega)))
        raise _refused(variant, say("fault.V521", row=row + 1, time=float(motion.t[row])))
    return omega, second[:, place]


def _refused(variant: Variant, message: Sentence) -> InputError:
    return InputError([Fault(message, variant.file, variant.nearest_line("ask", "quantities"))])


def _longest_way(values: Array) -> slice:
    """Return the longest stretch of rows over which the slider moves one way."""
    signs = np.sign(np.diff(values))
    edges = [0, *(np.flatnonzero(np.diff(signs)) + 1).tolist(), len(signs)]
    begin, end = max(itertools.pairwise(edges), key=lambda pair: pair[1] - pair[0])
    return slice(begin, end + 1)
