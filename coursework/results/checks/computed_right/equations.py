"""INITIAL, RESIDUAL, AGREEMENT: the velocities satisfy every equation, and the equations agree with the geometry.

Enters: `Evidence`.  Leaves: a `Finding` each.  Used by `check.py` and `commands/check.py`.
Velocities solved from an equation satisfy it whatever its signs: only the geometry can judge the equation itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from coursework.equations.reduction.equations import VelocityEquations
from coursework.mechanism.proposal import loose_arms, proposals
from coursework.motion.geometry.closure import Closure
from coursework.motion.geometry.judging.misfits import misfits
from coursework.motion.geometry.judging.rigid import may_be_hinges
from coursework.motion.geometry.judging.turning import said_otherwise
from coursework.motion.integration.motion import Motion
from coursework.results.checks.computed_right.conditioning import condition_numbers
from coursework.results.checks.computed_right.divided import DIGITS, FEWEST
from coursework.results.checks.evidence import Evidence, worst
from coursework.results.checks.result import Finding, skipped
from coursework.system.arrays import Array
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say, say_count

# Relative to the sum of the absolute terms of the equation: some hundred roundings, far below any human slip.
LIMIT = 1e-11


def initial(evidence: Evidence) -> Finding:
    """The velocities of row 1 satisfy every equation, also those not used for solving."""
    names, relative = evidence.residuals
    place = int(np.argmax(relative[0]))
    value = float(relative[0, place])
    unit, limit = say("unit.relative"), LIMIT if value <= LIMIT else float(_limits(evidence)[0])
    if value <= limit:
        key = "pass" if value else "exact"
        told = joined([say(f"check.INITIAL.{key}", count=len(names), name=names[place]), _arithmetic(evidence)])
        return Finding("PASS", told, value, limit, unit, names[place], 1)
    return Finding("FAIL", say("check.INITIAL.fail", name=names[place]), value, limit, unit, names[place], 1)


def _limits(evidence: Evidence) -> Array:
    """Return for each row (n,) what an equation may be off by: `LIMIT`, or the round-off where equations nearly agree.

    Where so few digits are left that CONDITION fails, no more is allowed.
    """
    return np.asarray(np.clip(condition_numbers(evidence) * 10.0**-DIGITS, LIMIT, 10.0**-FEWEST))


def every_row(evidence: Evidence) -> Finding:
    """The velocities of every row satisfy every equation they were solved from."""
    names, relative = evidence.residuals
    places = [place for place, name in enumerate(names) if name in evidence.used]
    if not places:  # every coordinate has a drive, and there is no unknown velocity
        return skipped(say("check.CONDITION.nothing"))
    others = [place for place in range(len(names)) if place not in places]
    row, chosen = worst(relative[:, places])
    limit = LIMIT
    if not relative[row, places[chosen]] <= LIMIT:
        limits = _limits(evidence)
        row, chosen = worst(relative[:, places] / limits[:, None])
        limit = float(limits[row])
    value, name = float(relative[row, places[chosen]]), names[places[chosen]]
    # A redundant equation left out may hold on closed positions only and so show the scheme's drift: reported, not judged.
    unit = say("unit.relative")
    rows = tuple((say("check.RESIDUAL.unused", name=names[k]), float(np.max(relative[:, k])), unit) for k in others)
    if value <= limit:
        told = joined([say("check.RESIDUAL.pass", rows=len(relative)), _arithmetic(evidence)])
        return Finding("PASS", told, value, limit, unit, name, row + 1, rows=rows)
    sentence = say("check.RESIDUAL.fail", name=name, row=row + 1, time=float(evidence.motion.t[row]))
    return Finding("FAIL", sentence, value, limit, unit, name, row + 1, rows=rows)


def _written(evidence: Evidence) -> list[str]:
    return [equation.name for equation in evidence.equations.equations if equation.written is not None]


def _arithmetic(evidence: Evidence) -> str:
    """Return the sentence that a residual tests only the arithmetic, if the geometry confirms no written equation; else ""."""
    return "" if evidence.agreed or not _written(evidence) else say("check.AGREEMENT.arithmetic")


def agreement(evidence: Evidence) -> Finding:
    """The written equations say what the geometry of the file says; a file in which they do not is refused when it is read."""
    written = _written(evidence)
    if not written:
        return skipped(say("check.AGREEMENT.derived"))
    if not len(evidence.motion.t) and not evidence.agreed:  # a dead point at the start hides what the geometry gives
        return skipped(say("check.no_row"))
    if evidence.closure is not None and (doubt := open_to_doubt(evidence.closure)):
        return _doubted(evidence, Finding("SKIP", doubt[0], unjudged=doubt[1]))
    if not evidence.agreed:
        start = evidence.motion.coordinates[0].tolist()
        lacks = "no_closure" if evidence.variant.points else "no_geometry"
        ties = proposed_ties(evidence.equations, start)
        told = joined([say(f"check.AGREEMENT.{lacks}"), *ties])
        return _doubted(evidence, Finding("SKIP", told, headline=say("summary.no_geometry"), is_news=bool(ties)))
    whole = float(len(written))
    return Finding("PASS", say("check.AGREEMENT.pass", all=len(written)), whole, whole, say_count("unit.equations", len(written)))


def _doubted(evidence: Evidence, found: Finding) -> Finding:
    """Return the finding about equations that no position equation judges, with what does not fit the links first."""
    told = unlike_links(evidence.equations, evidence.motion)
    return replace(found, sentence=joined([told, found.sentence]), headline=told) if told is not None else found


def unlike_links(equations: VelocityEquations, motion: Motion) -> Sentence | None:
    """Return which equations do not fit the links in the rows of a motion, or else how these move otherwise."""
    if not len(motion.t):
        return None
    if unfit := misfits(equations, motion.t, motion.coordinates)[1]:
        return say_count("check.AGREEMENT.unfit", len(unfit), names=unfit)
    otherwise = said_otherwise(equations, motion.t, motion.coordinates)
    return joined(otherwise) if otherwise else None


def proposed_ties(equations: VelocityEquations, start: Sequence[float]) -> list[Sentence]:
    """Return what to write if points of two links are joined where they lie in one place at the start (m,).

    Also where points of one link keep the distance that they have there.
    """
    joints = [say("check.AGREEMENT.meet", one=one, other=other) for one, other in may_be_hinges(equations, start)]
    arms = loose_arms(equations.variant, start)
    if not arms:
        return joints
    pairs = joined([say("check.AGREEMENT.pair", one=arm.begin, other=arm.end, link=arm.link) for arm in arms], "join.comma")
    holds = ", ".join(f'"({arm.end} - {arm.begin} - {arm.length} @ {arm.angle}).{axis}"' for arm in arms for axis in "xy")
    lengths = tuple(dict.fromkeys(arm.length for arm in arms))
    return [*joints, say("check.AGREEMENT.apart", pairs=pairs, lengths=lengths, holds=holds)]


def open_to_doubt(closure: Closure) -> tuple[Sentence, Sentence] | None:
    """Return which written equations the geometry does not judge: a sentence with advice for the file, and a part of a sentence.

    None if the geometry judges all of them.
    """
    told = [say("check.AGREEMENT.zero", name=name, terms=terms) for name, terms in closure.unseen]
    beside = [say("summary.zero", name=name, terms=terms) for name, terms in closure.unseen]
    if not closure.unjudged:
        return (joined(told), joined(beside, "join.semicolon")) if told else None
    names = tuple(name for name, _ in closure.unjudged)
    lacking = tuple(dict.fromkeys(unknown for _, unknowns in closure.unjudged for unknown in unknowns))
    count = {"count": len(closure.agreed), "all": len(closure.agreed) + len(names)}
    key = f"check.AGREEMENT.{'some' if closure.agreed else 'none'}"
    found = say_count(key, len(names), names=names, unknowns=lacking, **count)
    advice = proposals(closure.equations.variant, lacking)
    rest = say_count("summary.not_judged", len(names), names=names, unknowns=lacking)
    return joined([found, *advice, *told]), joined([rest, *beside], "join.semicolon")
