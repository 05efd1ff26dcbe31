"""The velocity equations that follow from the geometry of a text, written into it with reasons; verdicts on written ones.

Enters: a `Desk`.  Leaves: the text with them; a verdict per equation.  Used by `bench.py`, `contradicted.py`, `variant_page.py`.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any

import numpy as np

from coursework.desk.answering.edits import with_lines
from coursework.desk.answering.typed import Desk
from coursework.desk.job import FORBIDDEN, Answer, told
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations, differentiate
from coursework.equations.reduction.independent import DEPENDENT
from coursework.equations.reduction.system import compile_system
from coursework.mechanism.mechanism import build
from coursework.motion.geometry.judging.agreement import confirmed
from coursework.motion.geometry.start import start_values
from coursework.run import Run
from coursework.variant.formula.reader import MAX_NODES as MOST_PARTS
from coursework.variant.formula.tree import spelled
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

ROWS, SPREAD = 4, 0.1  # number of positions near the start at which equations are compared, and their distance (rad, m)
_GEOMETRY = re.compile(r"^(?:#[^\n]*\n+)?\[(?:points|links|frame|closure|ask)\]", re.M)


def equations(desk: Desk) -> dict[str, Any] | Answer:
    """Return the text with the equations that the written ones lack; it is unchanged if they lack none."""
    if not desk.setup.policy.equations:
        return told(FORBIDDEN, desk.language, "desk.not_offered")
    lines = lacking_lines(desk)
    return {**with_lines(desk.text, _line(desk), lines), "number": lines.count("[[constraint]]")}


def lacking_lines(desk: Desk) -> list[str]:
    """Return the equations that the written ones lack, as lines of a text."""
    found = differentiate(build(desk.variant))
    kept = [one for one in lacking(found) if _parts(one, found) <= MOST_PARTS]
    taken = {constraint.name for constraint in desk.variant.constraints}
    names = (str(number) for number in range(1, 1000) if str(number) not in taken)
    return [line for name, one in zip(names, kept, strict=False) for line in _written(name, one, found, desk)]


def lacking(found: VelocityEquations) -> Iterator[VelocityEquation]:
    """Yield the derived equations that are independent of the written ones and of those yielded before."""
    own = {constraint.name for constraint in found.variant.constraints}
    written = [one for one in found.equations if one.name in own]
    derived = [one for one in (*found.equations, *found.from_closure, *found.bound) if one.name not in own]
    if found.variant.groups or not derived:
        return  # a chain of groups needs no written equations
    start = np.array(start_values(found))
    about = start + SPREAD * np.sin(np.arange(ROWS * len(start)).reshape(ROWS, len(start)))
    matrices, *_ = compile_system(found, [*written, *derived]).matrices(np.zeros(ROWS), about)
    kept = list(range(len(written)))
    for place, one in enumerate(derived, start=len(written)):
        if _rank(matrices[:, [*kept, place]]) > _rank(matrices[:, kept]):
            kept.append(place)
            yield one


def _parts(one: VelocityEquation, found: VelocityEquations) -> int:
    return sum(1 for side in one.shown(found.order) for _ in side.walk())


def _rank(matrices: Any) -> int:
    return int(np.linalg.matrix_rank(matrices, tol=DEPENDENT * np.abs(matrices).max(initial=0.0)).max())


def _written(name: str, one: VelocityEquation, found: VelocityEquations, desk: Desk) -> list[str]:
    left, right = one.shown(found.order)
    because = json.dumps(desk.words.written(one.because), ensure_ascii=False)
    return [
        "",
        "[[constraint]]",
        f'name     = "{name}"',
        f"because  = {because}",
        f'equation = "{spelled(left)} = {spelled(right)}"',
    ]


def _line(desk: Desk) -> int:
    """Return the line after which equations are added: the end of the last one written, else the line before the geometry."""
    if desk.variant.constraints:
        last = max(constraint.line for constraint in desk.variant.constraints)
        following = desk.text.split("\n")[last:]
        return last + next((place for place, line in enumerate(following) if not line.strip()), len(following))
    geometry = _GEOMETRY.search(desk.text)
    return max(1, desk.text.count("\n", 0, geometry.start()) - 1) if geometry else desk.text.count("\n") + 1


def agreed_of(run: Run) -> tuple[str, ...]:
    """Return the names of the equations that the geometry confirms."""
    return confirmed(run.scene.equations, run.scene.closure, run.scene.start)


def judged(desk: Desk, agreed: Collection[str], wrong: Mapping[str, Sentence | str]) -> list[dict[str, Any]]:
    """Return the verdict beside each written equation: confirmed (in `agreed`), not judged, or `wrong` with its sentence."""
    found = []
    for one in desk.variant.constraints:
        if one.is_closure:
            continue
        right = False if one.name in wrong else one.name in agreed or None
        sentence = wrong[one.name] if right is False else say("desk.equation_right" if right else "desk.equation_open")
        found.append({"name": one.name, "line": one.line, "right": right, "sentence": desk.words.written(sentence)})
    return found
