"""The closed-form motion of a chain of groups: positions at all times, and the start values that a file leaves out.

Enters: the chain's formulas and times.  Leaves: coordinates (n, m); velocities follow from the reduction.
Raises `CannotAssemble` (groups) with the row at which a group cannot be assembled.
Used by `geometry/`, `exact_scene.py`, `way_to_motion.py`, `settings.py` and `model/`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from coursework.equations.algebra.expression import Expression
from coursework.equations.reduction.equations import VelocityEquations
from coursework.equations.reduction.symbolic import Symbols
from coursework.mechanism import groups
from coursework.mechanism.groups import Guide, Pair, group_kind
from coursework.mechanism.groups.assembly import HIDDEN
from coursework.mechanism.groups.kind import Known
from coursework.motion.geometry.drives.drive import integrals
from coursework.motion.geometry.time_derivatives import compile_rows
from coursework.system.angles import whole_turns
from coursework.system.arrays import Array, distinct
from coursework.variant.formula.tree import Formula, constant, spelled
from coursework.variant.judging.lengths import refused_length
from coursework.variant.record.roles import letters_of
from coursework.variant.record.variant import Coordinate, Group, Variant
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

# The largest turn of a crank (rad) between two positions, so that the angles of its followers keep the right whole turn.
_TURN = 1.0
_MOST_HALVINGS, _MOST_TIMES = 50, 2_000_000


def is_chain(variant: Variant) -> bool:
    """Return whether the groups give every coordinate that is not driven."""
    given = {name for group in variant.groups for name in group.coordinates}
    return bool(given) and all(c.name in given or c.rate in variant.known_rates for c in variant.coordinates)


def chain_positions(equations: VelocityEquations, times: Array, *, advises: bool = True) -> Array:
    """Return the coordinates (n, m) at `times` (s, growing from 0), with continuous angles, one group after the other.

    A coordinate that neither a drive nor a group gives keeps its start value: in a chain this is right at all times, else only at
    t = 0.  If a group cannot be assembled at the start and `advises` is true, the message names another mode of an earlier group
    that would help.
    """
    variant, rows = equations.variant, len(times)
    driven = [place for place, coordinate in enumerate(variant.coordinates) if coordinate.rate in variant.known_rates]
    times, kept, moved = _close_together(equations, [variant.coordinates[place] for place in driven], times)
    names = [c.name for c in variant.coordinates]
    q = np.tile([coordinate.start_or_guess or 0.0 for coordinate in variant.coordinates], (len(times), 1))

    def values(wanted: list[Expression]) -> Array:
        return compile_rows(equations, wanted, 0)(times, q)

    q[:, driven] += moved
    for number, group in enumerate(variant.groups, start=1):
        places = [names.index(name) for name in group.coordinates]
        if group_kind(group.kind).driven:
            continue
        try:
            found = dyad(equations.symbols, group, _mode(equations, group, q[:1]), values).coordinates
        except (groups.CannotAssemble, groups.AtDeadPoint) as error:
            named = ", ".join(map(spelled, group.start_points))
            reason = _in_letters_of(group, error.reason)
            if isinstance(error, groups.AtDeadPoint):  # at a dead point the position is not determined
                reason = say("group.dead.undecided", found=reason)
            elif 0 < error.shortage < HIDDEN:
                reason = joined([reason, say("group.nearly")])
            elif advises and error.row == 0 and (other := _other_mode(equations, number)):
                reason = joined([reason, other])
            known = {"kind": group.kind, "time": float(times[error.row]), "reason": reason}
            told = say("fault.V306", **known, letters=named) if named else say("fault.V305", **known)
            raise _fault(told, number, group, variant) from error
        except ValueError as error:
            raise _fault(refused_length(str(error)), number, group, variant) from error
        for column, place in enumerate(places):
            coordinate = variant.coordinates[place]
            angle = coordinate.unit == "rad"
            q[:, place] = _continued(found[:, column], coordinate.start_or_guess) if angle else found[:, column]
    return q if len(q) == rows else q[kept]


def _other_mode(equations: VelocityEquations, number: int) -> Sentence | None:
    """Return which earlier group, assembled in another mode, lets this one close at the start; None if there is none."""
    listed = equations.variant.groups
    for place, group in enumerate(listed[: number - 1]):
        for mode in group_kind(group.kind).modes if group.mode else ():
            tried = (*listed[:place], replace(group, mode=mode), *listed[place + 1 : number])
            with suppress(InputError):
                chain_positions(replace(equations, variant=replace(equations.variant, groups=tried)), np.zeros(1), advises=False)
                return say("group.other_mode", number=place + 1, mode=f"{mode:+d}")
    return None


def _close_together(equations: VelocityEquations, driven: Sequence[Coordinate], times: Array) -> tuple[Array, Array, Array]:
    """Return a refined list of times (s), the indices of the given `times` in it, and the moves of the driven coordinates (n, k).

    Between two of the refined times no driven angle turns by more than `_TURN`.  A group gives its angles only up to whole turns;
    so larger turns between two rows, as in a pulse, must be followed on the way.
    """
    rates, angles = [coordinate.rate for coordinate in driven], [coordinate.unit == "rad" for coordinate in driven]
    found, moved = times, integrals(equations, rates, times)
    for _ in range(_MOST_HALVINGS if any(angles) and len(times) > 1 else 0):
        wide = np.max(np.abs(np.diff(moved[:, angles], axis=0)), axis=1) > _TURN
        if not wide.any() or len(found) + wide.sum() > _MOST_TIMES:
            break
        found = distinct(found, (found[1:] + found[:-1])[wide] / 2)
        moved = integrals(equations, rates, found)
    return found, np.asarray(np.searchsorted(found, times)), moved


def _fault(told: Sentence, number: int, group: Group, variant: Variant) -> InputError:
    place = say("place.group_of", number=number, names=", ".join(group.coordinates))
    return InputError([Fault(told, variant.file, group.line, 0, place)])


def _in_letters_of(group: Group, reason: str) -> str:
    """Return why a group does not close, with the points of the file in place of the textbook's letters."""
    if not isinstance(reason, Sentence):
        return reason
    inner = {name: _in_letters_of(group, value) for name, value in reason.values.items() if isinstance(value, Sentence)}
    return say(reason.key, **{**reason.values, **inner, **letters_of(group_kind(group.kind).shape, group)})


def _continued(angles: Array, start: float | None) -> Array:
    """Return the angles without jumps, the first one in the turn of `start`."""
    smooth = np.unwrap(angles)
    if start is not None and len(smooth):
        smooth = smooth + whole_turns(start - smooth[0])
    return np.asarray(smooth)


def _mode(equations: VelocityEquations, group: Group, q: Array) -> int:
    """Return the assembly mode: the one written, else the one nearest to the start values, which a file without it has."""
    kind = group_kind(group.kind)
    if group.mode or not kind.modes:
        return group.mode
    chosen = [c for name in group.coordinates for c in equations.variant.coordinates if c.name == name]
    starts = np.array([c.start_or_guess for c in chosen], dtype=float)

    def values(wanted: list[Expression]) -> Array:
        return compile_rows(equations, wanted, 0)(np.zeros(1), q)

    def distance(mode: int) -> float:
        gaps = dyad(equations.symbols, group, mode, values).coordinates[0] - starts
        return float(np.max(np.abs(np.where([c.unit == "rad" for c in chosen], gaps - whole_turns(gaps), gaps))))

    return min((1, -1), key=distance)


def dyad(symbols: Symbols, group: Group, mode: int, values: Callable[[list[Expression]], Array]) -> groups.GroupMotion:
    """Return the positions of one dyad, row by row; `values` evaluates k expressions to numbers (n, k).

    Raises `CannotAssemble` with the first row at which the dyad cannot be assembled.
    """

    def pair(formula: Formula) -> Pair:
        return Pair(values(list(symbols.vector(formula))), None, None)

    def scalar(formula: Formula) -> Array:
        if (value := constant(formula)) is not None:
            return np.array([float(value)])
        return np.asarray(values([symbols.scalar(formula)])[:, 0])

    known = Known(
        [pair(formula) for formula in group.start_points],
        [scalar(formula) for formula in group.lengths],
        [Guide(pair(g.through), scalar(g.angle), offset=scalar(g.offset)) for g in group.guides],
        scalar(group.offset),
        scalar(group.angle) if group.angle else None,
    )
    solve = group_kind(group.kind).solve
    assert solve is not None
    return solve(known, mode)
