"""What a walk along the true motion meets: a dead point, a change point, or a place beyond which it cannot be followed.

Enters: numbers from `walk.py`.  Leaves: `Event`, `NotFollowed`, `GivenUp`.  Used by the rooms of `singular` and by the scene.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.system.arrays import Array
from coursework.system.frozen import frozen
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


@frozen
class Event:
    """A dead or change point, where the determinant of block number `block` vanishes.

    `kind` says which it is; `time` (s) and `position` where it is; `demanded` is the part of b outside the range of A.
    `together` are all blocks that are singular there; `block` is the first of them.
    """

    kind: str
    block: int
    time: float
    position: Array
    demanded: float
    together: tuple[int, ...] = ()


class GivenUp(Exception):
    """The motion takes more steps than are followed: it is known up to `time` (s)."""

    def __init__(self, time: float) -> None:
        super().__init__(f"followed up to t = {time:.9g} s")
        self.time = time


class NotFollowed(InputError):
    """The motion cannot be followed beyond `time` (s), for a reason other than the mechanism.

    `ahead` holds states (position in rad and m, then time in s) a little further on, where a formula may have no value.
    """

    def __init__(self, message: Sentence, time: float, ahead: Sequence[Sequence[float]] = ()) -> None:
        super().__init__(message)
        self.time, self.ahead = time, ahead


def without_value(time: float, reason: Sentence, ahead: Sequence[Sequence[float]] = ()) -> NotFollowed:
    """Return the error for a formula that has no value at `time` (s)."""
    return NotFollowed(say("fault.V512", time=time, reason=reason), time, ahead)
