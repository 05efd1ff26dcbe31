"""Which column of a file is which column of the task: by its head, else by its position if no head contradicts.

Enters: a `Layout`, the columns of the task.  Leaves: `Places`.  Raises `Refused` if the columns cannot be told.
Used by `table.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal

from coursework.grading.reading.expected import Grid
from coursework.grading.reading.files.separators import is_progression
from coursework.grading.reading.limits import doubtful, unreadable
from coursework.grading.reading.numbers import differ
from coursework.grading.reading.table.headers import INDEX, PRINTED, TIME, Head, may_be
from coursework.grading.reading.table.layout import Layout, numbers_in
from coursework.grading.reading.unit_names import fold
from coursework.system.frozen import frozen
from coursework.words.sentence import Sentence

_NEAR = 0.1  # of a step: how far from the task's time a column without a head may be and still be the time
_FAR = 12  # times the step of the task: a student's own step is never this long


@frozen
class Place:
    """The index of a column of the task in the file (from 0), and how it was found."""

    at: int
    by: Literal["header", "position"]


@frozen
class Places:
    """The columns found, by name; `repeated` are the names of those that the file has twice with equal numbers.

    `asked` is the question to a person if heads do not say which column of the task they are: these columns were taken in order,
    and only their numbers can confirm that.
    """

    places: dict[str, Place]
    repeated: tuple[str, ...]
    asked: Sentence | None = None


def find_columns(layout: Layout, grid: Grid) -> Places:
    """Return the place of each column of the task.

    Raises `Refused` if columns cannot be told apart or contradict each other.
    """
    names = grid.names
    filled = [at for at in range(len(layout.heads)) if any(row[at].stands_for_number for row in layout.body)]
    places, repeated = _by_head(layout, filled, dict(grid.units))
    free = [at for at in _left(filled, places) if at not in repeated]
    _add_time(layout, places, free, len(names), grid.step)
    # A time column that counts rows (0, 1, 2 …) has no times: a step of 1 s is too long if the task's is below 1/12 s.
    if TIME in places and INDEX not in places and grid.step * _FAR < 1.0 and _counts(numbers_in(layout, places[TIME].at)):
        places[INDEX] = places.pop(TIME)
    rest = _left(free, places)
    places |= _by_words(layout, rest, places)
    known, asked = [name for name in names if name in places], None
    rest = _left(rest, places)
    if not known and rest:
        lacking = grid.given if len(rest) == len(names) - len(grid.given) else ()
        places |= _in_order(layout, rest, [name for name in names if name not in lacking])
    else:
        places |= _lost_letters(layout, rest, [name for name in names if name not in places])
        in_order, asked = _unread(layout, grid, places, rest)
        places |= in_order
    if not any(name in places for name in names):
        raise unreadable("no_columns", columns=len(rest), names=tuple(names))
    return Places(places, tuple(sorted({layout.heads[at].candidates[0] for at in repeated})), asked)


def _left(among: Sequence[int], places: dict[str, Place]) -> list[int]:
    """Return those of some columns of the file that are not yet in `places`."""
    taken = {place.at for place in places.values()}
    return [at for at in among if at not in taken]


def _in_turn(columns: Sequence[int], names: Sequence[str]) -> dict[str, Place]:
    """Return columns of the file by position: each name has the column of its turn."""
    return {name: Place(at, "position") for at, name in zip(columns, names, strict=True)}


def _by_words(layout: Layout, rest: list[int], places: dict[str, Place]) -> dict[str, Place]:
    """Return the columns that heads describe in words, if only one head describes the column."""
    told = [(name, at) for at in rest for name in layout.heads[at].told if name not in places]
    names = [name for name, _ in told]
    return {name: Place(at, "header") for name, at in told if names.count(name) == 1}


def _unread(layout: Layout, grid: Grid, places: dict[str, Place], rest: list[int]) -> tuple[dict[str, Place], Sentence | None]:
    """Return the missing columns, assigned in order to as many unread ones, and the question to a person about their heads.

    Raises `Refused` if more columns are unread than missing, or if a column with a head of the task has text instead of numbers.
    """
    unread = _left(rest, places)
    for at, head in enumerate(layout.heads):
        cells = [row[at].text for row in layout.body if row[at].flag == "text" and any(map(str.isdigit, row[at].text))]
        if head.is_certain and head.candidates[0] in grid.names and head.candidates[0] not in places and cells:
            raise doubtful("unread_column", name=head.candidates[0], text=cells[0][:40])
    lacking = {name: unit for name, unit in grid.units if name not in places and name not in grid.given}
    heads = [layout.heads[at] for at in unread]
    if not (len(heads) >= len(lacking) > 1 or (len(heads) == len(lacking) == 1 and may_be(heads[0], *lacking.values()))):
        return {}, None
    texts = tuple(head.text or f"({at + 1})" for at, head in zip(unread, heads, strict=True))
    question = doubtful("unread_heads", heads=texts, names=tuple(lacking))
    if len(heads) > len(lacking):
        raise question
    return _in_turn(unread, [*lacking]), question.trouble.text


def _by_head(layout: Layout, filled: list[int], units: dict[str, str]) -> tuple[dict[str, Place], set[int]]:
    """Return the columns that heads name, and the indices of repeated ones that are left out.

    If two heads name a column and the numbers agree, the finer or else the first one counts.  If they differ, the head with the
    exact name counts.  Raises `Refused` if the exact names do not decide.
    """
    places: dict[str, Place] = {}
    repeated: set[int] = set()
    for at in filled:
        head = layout.heads[at]
        if not head.is_certain:
            continue
        name = head.candidates[0]
        first = places.setdefault(name, Place(at, "header"))
        if first.at != at:
            known = PRINTED.get(units.get(name, ""), {})
            factors = [known.get(layout.heads[place].unit, 1.0) for place in (first.at, at)]
            if name not in {TIME, INDEX} and any(differ(row[first.at], row[at], *factors) for row in layout.body):
                named = [_is_named(layout.heads[place].text, name) for place in (first.at, at)]
                if named[0] == named[1]:
                    raise doubtful("two_columns", name=name, first=first.at + 1, second=at + 1)
                places[name] = first if named[0] else Place(at, "header")  # the other head only may have meant this column
                continue
            if factors[0] != factors[1] and _last_place(layout, at) * factors[1] < _last_place(layout, first.at) * factors[0]:
                places[name], at = Place(at, "header"), first.at
            repeated.add(at)
    return places, repeated


def _is_named(text: str, name: str) -> bool:
    """Return whether a head begins with the exact name of a column, in any alphabet.

    >>> _is_named("s, m", "s"), _is_named("φ_2", "phi2"), _is_named("x", "s"), _is_named("s2", "s")
    (True, True, False, False)
    """
    return re.match(rf"\W*{re.escape(fold(name))}(?!\w)", fold(text).replace("_", "")) is not None


def _last_place(layout: Layout, at: int) -> float:
    return min((row[at].last_place for row in layout.body if row[at].is_number), default=1.0)


def _add_time(layout: Layout, places: dict[str, Place], free: list[int], columns: int, step: float) -> None:
    """Add the time, and the row numbers before it, to `places` if the first free columns are theirs but have no heads."""
    if TIME in places or not free or (layout.has_heads and layout.heads[free[0]].text):
        return
    spare = len(free) - columns if places.keys() <= {INDEX} else 1
    first = numbers_in(layout, free[0])
    if INDEX not in places and spare >= 2 and _counts(first) and _rises(layout, free[1]):
        places[INDEX] = Place(free[0], "position")
        places[TIME] = Place(free[1], "position")
    elif _is_on_grid(first, step) or ((spare >= 1 or _is_time(first, step)) and _rises(layout, free[0])):
        # 1, 2, 3 … before the columns of the task are row numbers.
        places[INDEX if _counts(first) and INDEX not in places else TIME] = Place(free[0], "position")


def _is_time(values: list[float], step: float) -> bool:
    """Return whether the numbers are times from 0 in steps of about `step`."""
    ordered = sorted(values)
    return len(ordered) > 2 and ordered[0] == 0 and abs(ordered[-1] / (len(ordered) - 1) / step - 1) < 0.05


def _is_on_grid(values: list[float], step: float) -> bool:
    """Return whether the numbers are times of the task from 0 on, each after the other; rows may be left out or stand twice."""
    rows = [value / step for value in values]
    return (
        len(rows) > 2 and rows == sorted(rows) and rows[0] == 0 < rows[-1] and all(abs(row - round(row)) < _NEAR for row in rows)
    )


def _counts(values: list[float]) -> bool:
    """Return whether the numbers are 0, 1, 2 … or 1, 2, 3 … in any order."""
    ordered = sorted(values)
    return len(ordered) > 2 and ordered[0] in {0.0, 1.0} and ordered == [ordered[0] + k for k in range(len(ordered))]


def _rises(layout: Layout, at: int) -> bool:
    cells = [row[at] for row in layout.body if row[at].is_number]
    unit = max((cell.last_place for cell in cells), default=0.0)
    return 2 * len(cells) >= len(layout.body) and is_progression(sorted(cell.value for cell in cells), min(unit, 1.0) / 2)


def _in_order(layout: Layout, rest: list[int], names: Sequence[str]) -> dict[str, Place]:
    """Return all columns by position.  Raises `Refused` if their number is wrong or a head contradicts."""
    heads = [layout.heads[at] for at in rest]
    if len(rest) != len(names):
        raise unreadable("count_columns", found=len(rest), needed=len(names), names=tuple(names))
    if any(head.candidates and name not in head.candidates for head, name in zip(heads, names, strict=True)):
        raise unreadable("heads_disagree", names=tuple(names))
    return _in_turn(rest, names)


def _lost_letters(layout: Layout, rest: list[int], names: list[str]) -> dict[str, Place]:
    """Return columns with ambiguous heads, or without heads, by their order if as many names are left; others stay unread."""
    open_heads: list[tuple[int, Head]] = [(at, layout.heads[at]) for at in rest if layout.heads[at].candidates]
    unnamed = [at for at in rest if not layout.heads[at].text]
    if unnamed and not open_heads and len(unnamed) == len(names):
        return _in_turn(unnamed, names)
    found: dict[str, Place] = {}
    for group in {head.candidates for _, head in open_heads}:
        members = [at for at, head in open_heads if head.candidates == group]
        left = [name for name in group if name in names]
        if len(members) == len(left):
            found |= _in_turn(members, left)
    return found
