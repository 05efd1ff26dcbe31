"""Draws data until each student has a mechanism that moves, keeps the limits and is about as difficult as the others'.

Enters: `Lots`, the template compiled once, students.  Leaves: `Accepted`, or counts of the reasons for which draws were refused.
Used by `variants.py`.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from typing import TypeVar

from coursework.assigning.judge import Verdict, judge
from coursework.assigning.ranges import PILOT, Lots, Path
from coursework.scene.model.data import read_data
from coursework.scene.model.model import Model
from coursework.system.frozen import frozen
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

T = TypeVar("T")
PILOTS = 25  # feasible draws whose medians are the centre of difficulty
# Draws that cannot move cost most.  The pilot stops if fewer than one in ONE_IN is feasible, checked after SURELY draws.
ONE_IN, SURELY, BATCH = 20, 100, 50
_TOGETHER = 256  # draws judged in one array
_AT_ONCE, _ALONE = 4, 64  # draws of one student judged together: within the class, and when few students are left
_IN_COMPANY = 32  # draws of each student before those without data are served one by one, so that a hopeless case ends soon


@frozen
class Accepted:
    """The data of one student: drawn `values` by their path in the file, the `attempt` (from 0), the measures of difficulty."""

    id: str
    values: Mapping[Path, str]
    attempt: int
    numbers: Mapping[str, float]

    @property
    def check_row(self) -> int | None:
        """Return the drawn row of the check (from 1), None if the template's row is kept."""
        text = self.values.get(("time", "check_row"))
        return None if text is None else int(text)


@frozen
class Centre:
    """The middle of the class: the median of each measure over the pilot draws; how many draws were feasible, and of how many."""

    numbers: Mapping[str, float]
    feasible: int
    drawn: int
    refused: Mapping[str, int] = field(default_factory=dict)


class Acceptance:
    """Draws and judges the data of one class; students may be served in any order and grouping."""

    def __init__(self, model: Model, lots: Lots) -> None:
        self.model, self.lots = model, lots
        self.ranges = lots.ranges
        self.centre = self._centre()

    def accepted(self, students: Iterable[str], done: Callable[[int], None] = lambda number: None) -> list[Accepted]:
        """Return the data of each student; `done` is called with how many more are ready.  Raises `InputError` with counts."""
        listed = [*students]
        found: dict[str, Accepted] = {}
        waiting, tries = [*dict.fromkeys(listed)], self.ranges.limits.tries
        refused: dict[str, Counter[str]] = {student: Counter() for student in waiting}
        for attempts in _parts(range(min(_IN_COMPANY, tries)), _AT_ONCE):
            for some in _parts(waiting, _TOGETHER // _AT_ONCE):
                done(self._tried(some, attempts, found, refused))
            waiting = [student for student in waiting if student not in found]
        for student in waiting:
            for attempts in _parts(range(_IN_COMPANY, tries), _ALONE):
                if self._tried([student], attempts, found, refused):
                    done(1)
                    break
            else:
                raise InputError(self._refusal("fault.A005", refused[student], student=student))
        return [found[student] for student in listed]

    def _tried(
        self, students: Sequence[str], attempts: Sequence[int], found: dict[str, Accepted], refused: Mapping[str, Counter[str]]
    ) -> int:
        """Try some attempts of some students, put what is accepted into `found`, count refusals; return how many were found."""
        before = len(found)
        lots = [(student, number) for student in students for number in attempts]
        for (student, number), (values, verdict) in zip(lots, self._judged(lots), strict=True):
            if student not in found:
                reason = verdict.refused or self._outside(verdict.numbers)
                if reason:
                    refused[student][reason] += 1
                else:
                    found[student] = Accepted(student, values, number, verdict.numbers)
        return len(found) - before

    def _judged(self, lots: Sequence[tuple[str, int]]) -> list[tuple[dict[Path, str], Verdict]]:
        draws = [self.lots.draw(student, number) for student, number in lots]
        columns = {path[1]: [draw[path] for draw in draws] for path in draws[0] if path[0] != "time"}
        return list(zip(draws, judge(self.model, read_data(self.model.variant, columns), self.ranges.limits), strict=True))

    def _outside(self, numbers: Mapping[str, float]) -> str:
        """Return the name of a measure that is outside its band, "" if none is."""
        for name in self.ranges.difficulty.numbers:
            low, high = self.band(name)
            if not low <= numbers[name] <= high:
                return f"band_{name}"
        return ""

    def band(self, name: str) -> tuple[float, float]:
        """Return the limits of a measure, which are the same for every student and any class."""
        low, high = self.ranges.difficulty.reach
        return low * self.centre.numbers[name], high * self.centre.numbers[name]

    def _centre(self) -> Centre:
        """Return the medians over the first feasible draws of the pilot stream, which belongs to no student."""
        kept: list[Verdict] = []
        refused: Counter[str] = Counter()
        drawn, least = 0, min(SURELY, self.ranges.limits.tries)
        while len(kept) < PILOTS:
            if drawn >= least and len(kept) * ONE_IN < drawn:
                [(most, _)] = refused.most_common(1)
                advice = say("assign.wider" if most == "same" else "assign.narrower")
                raise InputError(self._refusal("fault.A004", refused, feasible=len(kept), share=ONE_IN, advice=advice))
            lots = [(PILOT, drawn + number) for number in range(min(BATCH, least))]
            for _, verdict in self._judged(lots):
                drawn += 1
                if verdict.refused:
                    refused[verdict.refused] += 1
                else:
                    kept.append(verdict)
                if len(kept) == PILOTS:
                    break
        numbers = {name: statistics.median(one.numbers[name] for one in kept) for name in kept[0].numbers}
        return Centre(numbers, len(kept), drawn, dict(refused))

    def _refusal(self, key: str, refused: Counter[str], feasible: int = 0, **values: object) -> Sentence:
        """Return a sentence that the ranges leave too few mechanisms, with how many each reason refused."""
        counts = [say(f"assign.refused.{reason}", number=number) for reason, number in refused.most_common()]
        values |= {"number": feasible + sum(refused.values()), "feasible": feasible}
        return say(key, file=self.ranges.file, reasons=joined(counts, "join.numbers"), **values)


def _parts(listed: Sequence[T], size: int) -> Iterable[Sequence[T]]:
    return (listed[first : first + size] for first in range(0, len(listed), size))
