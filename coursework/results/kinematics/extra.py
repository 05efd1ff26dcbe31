"""Tables beside the table of results: analogs and invariants of a crank-driven motion, ready for a page.

Enters: a motion with its accelerations.  Leaves: `ExtraTable`.  Computed on request only.
Used by `scene_run.py`, `quantities.py` and `tables.py`.
"""

from __future__ import annotations

import numpy as np

from coursework.motion.integration.motion import Motion
from coursework.motion.integration.rates import Rates
from coursework.motion.integration.turning import stands
from coursework.results.kinematics.strokes import Way, longest_way, swings
from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Coordinate, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


@frozen
class ExtraTable:
    """A table with `rows` (n, len(names)) in `units`; the first column is t or the crank angle.

    `sizes` are the sizes of the terms that a column is a sum of: smaller than their round-off, a value is not printed.  With
    `blanks` a nan is intended and is left empty.
    """

    title: str
    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: Array
    sizes: tuple[float, ...] = ()
    note: str = ""
    blanks: bool = False


def analog_table(variant: Variant, motion: Motion, second: Array) -> ExtraTable:
    """Return dq/dφ1 and d²q/dφ1² of every coordinate but the crank's; `second` (n, k) are the accelerations of the motion.

    Raises `InputError` if there is not exactly one driven coordinate, or if the crank stands still.
    """
    from coursework.results.kinematics.analogs import acceleration_analog, velocity_analog

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


def stroke_way(variant: Variant, exact: Motion, rates: Rates) -> Way:
    """Return the way of the slider, or of the rocker if nothing slides, for which invariants are computed.

    Raises `InputError` if the mechanism has neither, or if there is not exactly one driven coordinate.
    """
    crank = _crank(variant)
    free = [coordinate for coordinate in variant.coordinates if coordinate.rate not in variant.known_rates]
    sliders = [coordinate for coordinate in free if coordinate.unit == "m"]
    moved = sliders or [coordinate for coordinate in free if swings(exact, coordinate)]
    if not moved:
        raise _refused(variant, say("fault.V518"))
    return longest_way(exact, rates, crank, moved[-1])


def invariant_table(variant: Variant, way: Way, second: Array) -> ExtraTable:
    """Return k, a_k, b_k, c_k over a way of `stroke_way`; `second` (n, k) are the accelerations of its rows.

    At the dead positions of a stroke b_k is set to 0.  Raises `InputError` if crank or slider stand still.
    """
    from coursework.results.kinematics.invariants import from_true

    crank, slider, motion = _crank(variant), way.slider, way.motion
    s, phi = motion.column(slider.name), motion.column(crank.name)
    length, turn = float(s[-1] - s[0]), float(phi[-1] - phi[0])
    if not (abs(length) > 0 and abs(turn) > 0):
        still = slider.name if abs(length) == 0 else crank.name
        raise _refused(variant, say("fault.V519", name=still))
    omega, epsilon = _crank_motion(variant, crank, motion, second)
    velocity, place = motion.column(slider.rate).copy(), motion.velocity_names.index(slider.rate)
    if way.is_stroke:
        velocity[[0, -1]] = 0.0  # velocity is zero at dead positions by definition
    sign, sense = np.sign(length), np.sign(turn)  # b_k and c_k are derivatives by k, which grows for either sense of the crank
    found = from_true(
        sign * (s - s[0]), sign * velocity, sign * second[:, place],
        stroke=abs(length), angle=abs(turn), omega_1=sense * omega, epsilon_1=sense * epsilon,
    )  # fmt: skip
    size = {"stroke": say("amount.exactly", value=abs(length), unit=slider.unit), "angle": abs(turn)}
    span = {"row": way.first, "last": way.last, "begin": float(motion.t[0]), "end": float(motion.t[-1])}
    title = say("extra.invariants" if way.is_stroke else "extra.invariants_rows", name=slider.name, **span, **size)
    note = say("extra.invariants_note", crank=crank.name, name=slider.name)
    sizes = (0.0, 0.0, 0.0, float(np.abs(found.b).max()))
    columns = np.array([(phi - phi[0]) / turn, found.a, found.b, found.c]).T + 0.0  # no -0
    return ExtraTable(title, ("k", "a_k", "b_k", "c_k"), ("",) * 4, columns, sizes, note)


def _crank(variant: Variant) -> Coordinate:
    driven = variant.driven_coordinates
    if len(driven) != 1:
        raise _refused(variant, say("fault.V520", count=len(driven)))
    return driven[0]


def _crank_motion(variant: Variant, crank: Coordinate, motion: Motion, second: Array) -> tuple[Array, Array]:
    place = motion.velocity_names.index(crank.rate)
    omega = motion.velocities[:, place]
    if np.any(resting := stands(omega)):
        raise _refused(variant, say("fault.V521", time=float(motion.t[int(np.argmax(resting))])))
    return omega, second[:, place]


def _refused(variant: Variant, message: Sentence) -> InputError:
    return InputError([Fault(message, variant.file, variant.nearest_line("ask", "quantities"))])
