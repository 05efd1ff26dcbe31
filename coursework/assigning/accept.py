"""Draws until each student has a mechanism that moves, keeps the limits and is as hard as those of the others.

Enters: `Lots`, the template compiled once, students.  Leaves: `Accepted`, or the counts of what was refused and why.
Used by `variants.py`.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from coursework.assigning.draw import PILOT, Lots
from coursework.assigning.judge import Verdict, judge
from coursework.assigning.ranges import Path
from coursework.errors import Fault, InputError
from coursework.model.data import read_data
from coursework.model.model import Model
from coursework.sentences import Sentence, joined, say

PILOTS = 25  # feasible draws whose median is the centre of difficulty
_TOGETHER = 256  # draws that are judged in one array
_AT_ONCE = 2  # draws of one student that are judged together


@dataclass(frozen=True, slots=True)
class Accepted:
    """What one student is given: the drawn `values` by their path in the file, the `attempt` (from 0), and how hard it is."""

    id: str
    values: Mapping[Path, str]
    attempt: int
    numbers: Mapping[str, float]

    @property
    def check_row(self) -> int | None:
        """Return the drawn row of the check (from 1), None where it is the template's."""
        text = self.values.get(("time", "check_row"))
        return None if text is None else int(text)


@dataclass(frozen=True, slots=True)
class Centre:
    """The middle of the class: the median of each measure over the pilot stream, and the share of draws that were feasible."""

    numbers: Mapping[str, float]
    feasible: int
    drawn: int
    refused: Mapping[str, int] = field(default_factory=dict)


class Acceptance:
    """One class: draws and judges; students may be asked for in any order and any company."""

    def __init__(self, model: Model, lots: Lots) -> None:
        self.model, self.lots = model, lots
        self.ranges = lots.ranges
        self.centre = self._centre()

    def accepted(self, students: Iterable[str], done: Callable[[int], None] = lambda number: None) -> list[Accepted]:
        """Return what each student is given; `done` is told how many more are ready.  Raises `InputError` with counts."""
        listed = [*students]
        found: dict[str, Accepted] = {}
        refused: dict[str, Counter[str]] = {student: Counter() for student in listed}
        waiting, attempt = [*dict.fromkeys(listed)], 0
        while waiting and attempt < self.ranges.limits.tries:
            attempts = range(attempt, min(attempt + _AT_ONCE, self.ranges.limits.tries))
            for some in _parts(waiting, _TOGETHER // _AT_ONCE):
                lots = [(student, number) for student in some for number in attempts]
                for (student, number), (values, verdict) in zip(lots, self._judged(lots), strict=True):
                    if student in found:
                        continue
                    reason = verdict.refused or self._outside(verdict.numbers)
                    if reason:
                        refused[student][reason] += 1
                    else:
                        found[student] = Accepted(student, values, number, verdict.numbers)
                done(sum(student in found for student in some))
            waiting = [student for student in waiting if student not in found]
            attempt = attempts.stop
        if waiting:
            raise InputError([Fault(self._too_few(student, refused[student])) for student in waiting[:3]])
        return [found[student] for student in listed]

    def _judged(self, lots: Sequence[tuple[str, int]]) -> list[tuple[dict[Path, str], Verdict]]:
        draws = [self.lots.draw(student, number) for student, number in lots]
        columns = {path[1]: [draw[path] for draw in draws] for path in draws[0] if path[0] != "time"}
        return list(zip(draws, judge(self.model, read_data(self.model.variant, columns), self.ranges.limits), strict=True))

    def _outside(self, numbers: Mapping[str, float]) -> str:
        """Return the measure that lies outside the band, "" where none does."""
        band = self.ranges.difficulty.band
        for name in self.ranges.difficulty.numbers:
            centre = self.centre.numbers[name]
            if not abs(numbers[name] - centre) <= band * abs(centre):
                return f"band_{name}"
        return ""

    def _centre(self) -> Centre:
        """Return the middle of the first feasible draws of a stream that no student has."""
        kept: list[Verdict] = []
        refused: Counter[str] = Counter()
        drawn, since = 0, 0
        while len(kept) < PILOTS and since < self.ranges.limits.tries:
            lots = [(PILOT, drawn + number) for number in range(2 * PILOTS)]
            for _, verdict in self._judged(lots):
                drawn, since = drawn + 1, since + 1
                if verdict.refused:
                    refused[verdict.refused] += 1
                else:
                    kept.append(verdict)
                    since = 0
                if len(kept) == PILOTS or since == self.ranges.limits.tries:
                    break
        if len(kept) < PILOTS:
            raise InputError(self._too_few("", refused))
        numbers = {name: statistics.median(one.numbers[name] for one in kept) for name in kept[0].numbers}
        return Centre(numbers, len(kept), drawn, dict(refused))

    def _too_few(self, student: str, refused: Counter[str]) -> Sentence:
        """Return why the ranges leave too few mechanisms, and what refused how many."""
        counts = [say(f"assign.refused.{reason}", number=number) for reason, number in refused.most_common()]
        key = "fault.A005" if student else "fault.A004"
        values = {"file": self.ranges.file, "number": sum(refused.values()), "reasons": joined(counts, "assign.refused.join")}
        return say(key, student=student, **values)


def _parts(listed: Sequence[str], size: int) -> Iterable[Sequence[str]]:
    return (listed[first : first + size] for first in range(0, len(listed), size))
