"""The search itself: what a table is worth, beside which tables cells are looked for, which guesses are taken."""

from types import SimpleNamespace
from typing import ClassVar

import numpy as np
import pytest

from coursework.grading.marking.table.before import restored as search
from coursework.grading.marking.table.before.restored import _Looked
from tests.grading.marking.table.before.test_made import KEY, table

PRINTED = table([1, 2, 4], [2, 4, 8], [3, 6, 12], [4, 8, 16])


def flags(*places):
    found = np.zeros((4, 3), dtype=bool)
    for place in places:
        found[place] = True
    return found


def moved(**cells):
    """Return the printed table with other cells: c21 is row 2, column 1 (from 0)."""
    found = table(*PRINTED.values.tolist())
    for name, value in cells.items():
        found.values[int(name[1]), int(name[2])] = value
    return found


def held(*places, but=False):
    """Return ways by which these cells hold, or all but these."""
    return SimpleNamespace(holds=lambda values: flags(*places) != but)


class Fake(_Looked):
    """What is looked at, its worth given by the values of a cell: row by row."""

    worths: ClassVar = {}

    def worth(self, one, ways):
        assert ways in (("ways", id(one)), "own")
        return np.array(self.worths.get(tuple(map(tuple, one.values)), [0, 0, 0, 0]))

    def made_by(self, one):
        return "ways", id(one)


def looked(kind=_Looked, wrong=(), other=(), sure=(), told=(), own=None, printed=PRINTED):
    return kind(KEY, PRINTED, flags(*wrong), flags(*other), flags(*sure), own or held(), flags(*told), printed)


def test_a_table_is_worth_the_cells_that_it_makes_right_less_those_that_it_makes_wrong_and_those_that_it_costs():
    """From row 1 its velocities and the coordinate of row 2 are made; a told cell counts as a wrong one does.

    Each of the three counts four, so that one more for a velocity decides between equally many.
    """
    by = held((0, 1), (1, 0), (2, 1), (2, 2), (3, 0))
    assert looked(wrong=[(0, 1), (0, 2), (1, 0)]).worth(PRINTED, by).tolist() == [4 * 2 + 1, 0, 0, 0]
    assert looked(wrong=[(0, 1)], told=[(1, 0)]).worth(PRINTED, by).tolist() == [4 * 2 + 1, 0, 0, 0]
    assert looked(wrong=[(2, 1), (3, 0)], sure=[(2, 2), (3, 1), (3, 2)]).worth(PRINTED, by).tolist() == [
        0,
        0,
        4 * 2 + 1,
        -4 * 2 - 2,
    ]
    assert looked(wrong=[(2, 1), (3, 0)]).worth(moved(c20=9, c21=9, c11=7), by).tolist() == [0, -4, 4 + 1, 0]


def followed(monkeypatch, first, gains, later=None, others=(0, 0, 0, 0)):
    """Return what is followed where rows made anew give `first`, with those gains, then `later`; and which rows were free."""
    asked, answers = [], [first, later, later]
    monkeypatch.setattr(search, "as_it_was", lambda key, one, free, own: (asked.append(free[:, 0].tolist()), answers.pop(0))[1])
    fake = looked(Fake)
    fake.worths.clear()
    fake.worths[tuple(map(tuple, PRINTED.values))] = [1, 1, 1, 1]
    for one, worth in ((later, others), (first, gains)):
        if one is not None:
            fake.worths[tuple(map(tuple, one.values))] = worth
    found, ways = fake.followed(PRINTED, np.ones((4, 3), dtype=bool))
    assert ways == ("ways", id(found))
    return found, asked


def test_rows_are_made_anew_from_the_first_on_that_gains(monkeypatch):
    """Rows 2 and 3 are other; row 2 gains nothing beside the 1 that it was worth, so it was made later and stays."""
    every = [True] * 4
    both, last = moved(c10=7, c20=8), moved(c20=8)
    assert followed(monkeypatch, None, ()) == (PRINTED, [every])
    assert followed(monkeypatch, both, [1, 2, 2, 1], last) == (both, [every])
    but_one = [True, False, True, True]
    assert followed(monkeypatch, both, [1, 1, 2, 1], last, [1, 1, 2, 1]) == (last, [every, but_one])
    assert followed(monkeypatch, both, [1, 1, 2, 1], last, [1, 1, 1, 1]) == (both, [every, but_one])
    found, asked = followed(monkeypatch, both, [1, 0, 1, 1])
    assert found is PRINTED and asked == [every, [True, False, False, True]]


def bases(monkeypatch, above, last=PRINTED, **given):
    asked = []
    monkeypatch.setattr(search, "as_it_was", lambda key, one, free, own: (asked.append((one, free.tolist())), above)[1])
    told = flags(*given.get("told", ()))
    return [*looked(**given).bases(last, given.get("own") or held(), told)], asked


def test_cells_are_looked_for_beside_the_table_as_found_as_printed_and_without_misprints(monkeypatch):
    above, found = moved(c10=2.5), moved(c00=5)
    wrong = [(1, 0), (1, 1), (1, 2)]
    assert bases(monkeypatch, above, wrong=wrong) == ([PRINTED, above], [(PRINTED, flags((1, 0)).tolist())])
    assert bases(monkeypatch, None, wrong=wrong)[0] == [PRINTED]
    assert bases(monkeypatch, above, last=found, wrong=wrong)[0] == [found, PRINTED, above]  # (1, 0) is made from row 1
    assert bases(monkeypatch, above, last=moved(c30=5), wrong=wrong)[0][1:] == [above]
    assert bases(monkeypatch, above, wrong=wrong, told=[(1, 0)]) == ([PRINTED], [])
    assert bases(monkeypatch, above, wrong=[(1, 0), (1, 1)]) == ([PRINTED], [])  # one cell is no several
    assert bases(monkeypatch, above, wrong=wrong, own=held((1, 1))) == ([PRINTED], [])
    assert bases(monkeypatch, above, wrong=[(1, 1), (1, 2)]) == ([PRINTED], [])
    half = [*wrong, (0, 0), (0, 1), (0, 2)]
    assert bases(monkeypatch, above, wrong=half)[1] == [(PRINTED, flags((0, 0), (1, 0)).tolist())]
    assert bases(monkeypatch, above, wrong=[*half, (2, 0), (2, 1), (2, 2)]) == ([PRINTED], [])


def guessed(monkeypatch, made, worths, told=()):
    """Return the table that is taken of guesses, and what is told then; each is looked at beside the table as it was found."""
    asked = []

    def guesses(key, was, own, left, other, untold):
        asked.append((left.tolist(), untold.tolist()))
        yield from made

    monkeypatch.setattr(search, "guesses", guesses)
    monkeypatch.setattr(search, "as_it_was", lambda *_: None)
    wrong, other = [(1, 1), (1, 2), (2, 1), (2, 2)], [(1, 0), (2, 0), (3, 0)]
    fake = looked(Fake, wrong=wrong, other=other, own=held((2, 2)), told=told)
    fake.worths.clear()
    fake.worths.update({tuple(map(tuple, one.values)): worth for one, worth in worths})
    monkeypatch.setattr(Fake, "made_by", lambda self, one: "own")
    was, now = fake.guessed(PRINTED, held((2, 2)), flags(*told))
    return was.values[:, 0].tolist(), {tuple(place) for place in np.argwhere(now).tolist()}, asked


@pytest.fixture
def own(monkeypatch):
    monkeypatch.setattr(Fake, "worth", lambda self, one, ways: np.array(self.worths.get(tuple(map(tuple, one.values)), [0] * 4)))


def test_a_guess_is_taken_in_the_rows_where_more_is_right_and_each_row_takes_its_best(monkeypatch, own):
    """One more for each of the two velocities is no cell more: a gain of 3 is the least that comes first."""
    one, two, joined = moved(c10=7, c20=8), moved(c10=5, c20=9), moved(c10=7, c20=9)
    worths = [(one, [0, 6, 3, 0]), (two, [0, 6, 9, 0]), (joined, [0, 6, 9, 0])]
    found = guessed(monkeypatch, [one, two], worths)
    assert found[:2] == ([1, 7, 9, 4], {(1, 0), (2, 0)})
    assert found[2] == [(flags((1, 1), (1, 2), (2, 1)).tolist(), flags((1, 0), (2, 0), (3, 0)).tolist())]
    assert guessed(monkeypatch, [one], [(one, [0, 0, 0, 0])])[:2] == ([1, 2, 3, 4], set())
    far = moved(c30=7)  # nothing wrong is made from row 4
    assert guessed(monkeypatch, [far, one], [(far, [0, 0, 0, 9]), (one, [0, 6, 0, 0]), (moved(c10=7), [0, 6, 0, 0])])[:2] == (
        [1, 7, 3, 4], {(1, 0)},
    )  # fmt: skip
    worse = [(PRINTED, [0, -3, 0, 0]), (one, [0, -1, 0, 0])]
    assert guessed(monkeypatch, [one], worse)[0] == [1, 2, 3, 4]  # what is worth less than nothing is no reason
    assert guessed(monkeypatch, [one], [(one, [0, 6, 3, 0])], told=[(1, 0)])[2][0][1] == flags((2, 0), (3, 0)).tolist()


@pytest.mark.parametrize(
    ("worth", "taken"), [([0, 6, 0, 0], [1, 7, 8, 4]), ([0, 6, -3, 0], [1, 7, 8, 4]), ([0, 6, -6, 0], [1, 2, 3, 4])]
)
def test_a_row_that_gains_only_beside_the_other_is_taken_with_it_if_both_gain_together(monkeypatch, own, worth, taken):
    both = moved(c10=7, c20=8)
    assert guessed(monkeypatch, [both], [(both, worth)])[0] == taken


@pytest.mark.parametrize(("first", "then", "taken"), [(2, 0, 7), (2, 2, 7), (2, 3, 5), (3, 4, 7), (0, 0, 2)])
def test_a_velocity_explained_by_a_slip_is_taken_only_where_nothing_explains_a_cell_more(monkeypatch, own, first, then, taken):
    one, other = moved(c10=7), moved(c10=5)
    worths = [(one, [0, first, 0, 0]), (other, [0, then, 0, 0])]
    assert guessed(monkeypatch, [one, other], worths)[0] == [1, taken, 3, 4]
