"""Errors in assembling a group, and the sentences that report them.

Enters: margins, lengths and modes, as the groups compute them.  Leaves: nothing, or an error with its rows.
Used by every group and by `kinematics`; knows numpy only.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coursework.system.arrays import Array, Complex, Flags
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say, say_count

# A constant length, or (value, rate, second rate) of one that varies in time; each one number, or one per row.
Length: TypeAlias = ArrayLike | tuple[ArrayLike, ArrayLike, ArrayLike]

# The few sums between the data and a margin have a rounding error below 8 units in the last place; a larger
# shortage means that the mechanism really cannot be assembled (hard case H05).
ULPS = 8.0

# m: differences that four decimals do not show.
HIDDEN = 1e-4

# The letters of a group's points in sentences, used where a file gives no names.
TEXTBOOK = {letter: letter for letter in "BCD"}


class _InRows(InputError):
    """An error in some `rows` (from 0), the first of which is `row`; `reason` is the sentence without the row."""

    def __init__(self, sentence: str, rows: tuple[int, ...], *more: Any) -> None:
        super().__init__((Fault(say("fault.D031", sentence=sentence)),))
        self.args = (sentence, rows, *more)  # all of them, so that the error can be pickled for a process pool
        self.rows, self.row, self.reason = rows, rows[0], more[-1] or sentence

    def __str__(self) -> str:
        return str(self.args[0])


class CannotAssemble(_InRows):
    """The links of a group do not meet.

    `row` is the first failing row and `rows` are all of them, counted from 0; `shortage` (m) says by how much a
    length is too short or too long in that first row; `reason` is the sentence without the row.

    >>> from coursework.procedures import CannotAssemble, Pair, rrr
    >>> try:
    ...     rrr(Pair([0.0, 0.0]), Pair([[0.5, 0.0], [0.8, 0.0]]), lengths=(0.4, 0.3), mode=1)
    ... except CannotAssemble as error:
    ...     error.rows, round(error.shortage, 9)
    ((1,), 0.1)
    """

    def __init__(self, sentence: str, rows: tuple[int, ...] = (0,), shortage: float = 0.0, reason: str = "") -> None:
        super().__init__(sentence, rows, shortage, reason)
        self.shortage = shortage


class AtDeadPoint(_InRows):
    """The determinant is zero and velocities are not defined; `row` is the first row, `rows` are all (from 0), `reason` says why.

    >>> from coursework.procedures import AtDeadPoint, Pair, rrr
    >>> try:
    ...     rrr(Pair([0.0, 0.0]), Pair([[0.5, 0.0], [0.75, 0.0]]), lengths=(0.5, 0.25), mode=1)
    ... except AtDeadPoint as error:
    ...     error.rows
    (1,)
    """

    def __init__(self, sentence: str, rows: tuple[int, ...] = (0,), reason: str = "") -> None:
        super().__init__(sentence, rows, reason)


def tolerance(*data: NDArray[np.inexact]) -> Array:
    """Return (n,) m: how far from zero a margin may be because of rounding alone.

    `data` are the vectors and lengths (m) from which the margin was computed; the result is `ULPS` units in the last
    place of the largest of them in each row.  Below it the sign of a margin means nothing, and the row counts as exactly
    at the limit, so that the result is the same in metres and in millimetres.
    """
    scale = np.abs(data[0])
    for part in data[1:]:
        scale = np.maximum(scale, np.abs(part))
    return np.asarray(ULPS * np.spacing(scale))


def rows_where(failing: Flags, n: int) -> tuple[int, ...]:
    """Return the indices of the failing rows out of `n`; a single flag applies to every row."""
    return tuple(int(row) for row in np.flatnonzero(np.broadcast_to(failing, (n,))))


def at(value: ArrayLike, row: int) -> float:
    """Return the entry of `value`, one number or one per row, that belongs to `row`."""
    entries = np.atleast_1d(np.asarray(value, dtype=np.float64))
    return float(entries[row if len(entries) > 1 else 0])


def metres(value: float, beside: float = 1.0) -> Sentence:
    """Return a length (m) for a sentence, in full if it is to be told from one that differs by a tiny `beside` (m).

    A small length is never rounded to zero.
    """
    if abs(beside) < HIDDEN:
        return say("group.exact", metres=value)
    return say("group.metres" if abs(value) >= 0.001 or value == 0.0 else "group.small", metres=value)


def refuse(group: str, rows: tuple[int, ...], reason: Sentence, shortage: float) -> CannotAssemble:
    """Return the error for a group that does not close; `reason` describes the first failing row."""
    told = say("group.refused", group=group, row=rows[0], reason=reason)
    if more := len(rows) - 1:
        told = joined([told, say_count("group.more", more)])
    return CannotAssemble(told, rows, shortage, reason)


def dead(group: str, rows: tuple[int, ...], found: Sentence, *, placed: bool = True) -> AtDeadPoint:
    """Return the error for a dead point; `placed` says whether at least the positions are defined there."""
    tail = say("group.dead.placed") if placed else say("group.dead.nowhere")
    return AtDeadPoint(say("group.dead.point", group=group, row=rows[0], found=found, tail=tail), rows, found)


def require_crossing(group: str, sine: Array, turned: Array, gap: Array, data: tuple[Complex, Complex], lines: str) -> None:
    """Raise unless two slides cross in every row, which gives one position and one velocity.

    `sine` (n,) is that of the angle between them, `turned` (rad) the larger angle from which it was computed; `gap` (m) is
    the distance between the lines that `lines` names, computed from `data`.  Raises `CannotAssemble` if parallel lines are
    apart, else `AtDeadPoint` if they coincide.
    """
    parallel = np.abs(sine) <= ULPS * np.spacing(np.maximum(turned, 1.0))
    if not parallel.any():
        return
    n = np.broadcast(parallel, gap).size
    apart = parallel & (np.abs(gap) > tolerance(*data))
    if apart.any():
        rows = rows_where(apart, n)
        short = at(np.abs(gap), rows[0])
        raise refuse(group, rows, say("group.parallel", lines=say(lines, **TEXTBOOK), apart=metres(short)), short)
    raise dead(group, rows_where(parallel, n), say("group.coincide", lines=say(lines, **TEXTBOOK)), placed=False)


def require_mode(group: str, mode: int, modes: Mapping[int, str]) -> None:
    """Raise `ValueError` unless `mode` is one of `modes` (number -> key of its meaning)."""
    if not np.isscalar(mode) or mode not in modes:
        known = ", ".join(f"{number:+d} ({say(meaning, **TEXTBOOK)})" for number, meaning in modes.items())
        raise ValueError(say("group.no_mode", group=group, mode=repr(mode), known=known))


def numbers(what: str, value: ArrayLike, *, positive: bool = False) -> Array:
    """Return `value` as a new array (n,) or (1,).  Raises `ValueError` for entries that are not finite numbers."""
    try:
        raw = np.array(value, ndmin=1)
    except ValueError:  # rows of different lengths
        raise ValueError(f"{what}: one number, or one number a row, was expected, found {value!r}.") from None
    if raw.dtype.kind not in "iuf":  # text that looks like a number is refused too: nobody has parsed it yet
        entries = list(value) if isinstance(value, (list, tuple)) else raw.tolist()
        row = next((row for row, entry in enumerate(entries) if not isinstance(entry, (int, float))), 0)
        place = f" at row {row}" if len(entries) > 1 else ""
        raise ValueError(f"{what}: a number was expected, found {entries[row]!r}{place}.")
    array = raw.astype(np.float64)
    if array.ndim > 1:
        raise ValueError(f"{what}: one number, or one number a row, was expected, found shape {array.shape}.")
    wrong = ~np.isfinite(array) | (array <= 0.0) if positive else ~np.isfinite(array)
    if wrong.any():
        row = int(np.argmax(wrong))
        key = ("group.positive" if positive else "group.finite") + (".row" if len(array) > 1 else ".alone")
        found = float(array[row])
        raise ValueError(say(key, what=what, found=say("group.exact", metres=found) if positive else f"{found:g}", row=row))
    return array


def length(what: str, given: Length) -> tuple[Array, Array | None, Array | None]:
    """Return value (m), rate (m/s), second rate (m/s^2) of a length; both rates are None if it is constant.

    A varying length is a *tuple* of three; the rows of a constant length come as a list or an array.
    """
    if isinstance(given, tuple):
        if len(given) != 3:
            raise ValueError(f"{what}: a varying length is (value, rate, second rate), found {len(given)} entries.")
        value = numbers(what, given[0], positive=True)
        rate, second = numbers(f"{what}, rate", given[1]), numbers(f"{what}, second rate", given[2])
        sizes = {len(part) for part in (value, rate, second)} - {1}
        if len(sizes) > 1:
            raise ValueError(f"{what}: value, rate and second rate have different numbers of rows, {sorted(sizes)}.")
        whole = np.ones(max(sizes, default=1))  # so that each array alone tells how many rows there are
        return value * whole, rate * whole, second * whole
    return numbers(what, given, positive=True), None, None
