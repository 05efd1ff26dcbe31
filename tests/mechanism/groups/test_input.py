"""Wrong input to the groups: every sentence, and that what comes out is whole, finite and read-only."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from coursework.mechanism.groups import Guide, Pair, crank, prp, rpp, rpr, rrp, rrr

ORIGIN = Pair((0.0, 0.0))
X_AXIS = Guide(ORIGIN, 0.0)


def row_of_pins(*places: float) -> Pair:
    return Pair(np.array([(place, 0.0) for place in places]))


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (
            lambda: rrr(ORIGIN, ORIGIN, lengths=(1.0, 1.0), mode=0),
            "RRR: assembly mode 0 does not exist. Modes: +1 (C to the left",
        ),
        (
            lambda: rrp(ORIGIN, X_AXIS, length=1.0, mode=2),
            "RRP: assembly mode 2 does not exist. Modes: +1 (the larger s), -1",
        ),
        (lambda: rrr(ORIGIN, ORIGIN, lengths=(1.0, 1.0), mode=[1]), "RRR: assembly mode [1] does not exist."),  # type: ignore[arg-type]
        (
            lambda: rrp(ORIGIN, [0, 1], length=1.0, mode=1),  # type: ignore[arg-type]
            "RRP, guide: a Guide(through, angle) was expected, found [0, 1].",
        ),
        (
            lambda: rpp(ORIGIN, row_of_pins(1.0), slide_angle=1.0),  # type: ignore[arg-type]
            "RPP, guide: a Guide(through, angle) was expected, found Pair(",
        ),
        (lambda: prp(X_AXIS, 0.3), "PRP, guide j: a Guide(through, angle) was expected, found 0.3."),  # type: ignore[arg-type]
        (
            lambda: rrr(ORIGIN, ORIGIN, lengths=(0.4,), mode=1),  # type: ignore[arg-type]
            "RRR: two lengths were expected, of the link from B and of the link from D, found (0.4,).",
        ),
        (lambda: rrr(ORIGIN, ORIGIN, lengths=0.4, mode=1), "RRR: two lengths were expected"),  # type: ignore[arg-type]
        (lambda: rpr(ORIGIN, ORIGIN, mode=-2), "RPR: assembly mode -2 does not exist."),
        (
            lambda: rrr(ORIGIN, ORIGIN, lengths=(-1.0, 1.0), mode=1),
            "RRR, the link from B: a finite length above zero was expected, found -1 m.",
        ),
        (
            lambda: rrr(ORIGIN, ORIGIN, lengths=(1.0, [1.0, 0.0]), mode=1),
            "RRR, the link from D: a finite length above zero was expected, found 0 m at row 1.",
        ),
        (
            lambda: rrp(ORIGIN, X_AXIS, length=np.inf, mode=1),
            "RRP, the rod: a finite length above zero was expected",
        ),
        (
            lambda: rpr(ORIGIN, ORIGIN, end_length=np.nan),
            "RPR, the rod to its end: a finite length above zero was expected",
        ),
        (lambda: rpr(ORIGIN, ORIGIN, offset=np.nan), "RPR, the offset: a finite number was expected, found nan."),
        (lambda: rpp(ORIGIN, X_AXIS, slide_angle=np.inf), "RPP, the slide angle: a finite number was expected"),
        (
            lambda: crank(ORIGIN, length=0.0, angle=0.0, rate=1.0),
            "crank, its length: a finite length above zero was",
        ),
        (
            lambda: crank(ORIGIN, length=(1.0, 2.0), angle=0.0, rate=1.0),
            "crank, its length: a varying length is (value, rate, second rate), found 2 entries.",
        ),
        (
            lambda: crank(ORIGIN, length=(1.0, [1.0, 2.0], [1.0, 2.0, 3.0]), angle=0.0, rate=1.0),
            "crank, its length: value, rate and second rate have different numbers of rows, [2, 3].",
        ),
        (
            lambda: crank(ORIGIN, length="1 m", angle=0.0, rate=1.0),
            "crank, its length: a number was expected, found '1 m'.",
        ),
        (
            lambda: crank(ORIGIN, length=1.0, angle=[0.0, None], rate=1.0),  # type: ignore[arg-type]
            "crank, angle: a number was expected, found None at row 1.",
        ),
        (
            lambda: crank(ORIGIN, length=1.0, angle=[[0.0]], rate=1.0),
            "crank, angle: one number, or one number a row, was",
        ),
        (
            lambda: crank(ORIGIN, length=1.0, angle=[[0.0], [1.0, 2.0]], rate=1.0),
            "crank, angle: one number, or one number",
        ),
        (
            lambda: rrr(row_of_pins(1.0, 2.0), row_of_pins(1.0, 2.0, 3.0), lengths=(1.0, 1.0), mode=1),
            "RRR: the same number of rows was expected everywhere, found B 2, D 3.",
        ),
        (lambda: Pair((0.0, np.nan)), "position: finite numbers were expected, found [0.0, nan] at row 0."),
        (
            lambda: Pair((0.0, 1.0, 2.0)),
            "position: (x, y) or rows of it, shape (n, 2), were expected, found shape (3,).",
        ),
        (
            lambda: Pair([(0.0, 1.0), (2.0,)]),
            "position: rows of (x, y) were expected, found [(0.0, 1.0), (2.0,)].",
        ),
        (lambda: Pair(("a", 1.0)), "position: numbers were expected, found ('a', 1.0)."),
        (
            lambda: Pair([(0.0, 0.0)] * 2, [(0.0, 0.0)] * 3),
            "pair: the same number of rows was expected everywhere",
        ),
        (
            lambda: Guide(ORIGIN, [0.0, 1.0], [0.0, 1.0, 2.0]),
            "guide: the same number of rows was expected everywhere",
        ),
    ],
)
def test_wrong_input_is_named(call: Callable[[], object], sentence: str) -> None:
    with pytest.raises(ValueError, match=r"\.$") as caught:
        call()
    assert str(caught.value).startswith(sentence)


def test_velocities_of_a_pair_must_be_known() -> None:
    first = rrr(ORIGIN, Pair((1.0, 0.0)), lengths=(1.0, 1.0), mode=1, positions_only=True)
    second = rrr(first.meets, Pair((1.5, 0.0)), lengths=(1.0, 1.0), mode=1, positions_only=True)
    assert second.coordinates.shape == (1, 2)
    with pytest.raises(ValueError, match="RRR, pair B: velocity and acceleration are not known; the group before"):
        rrr(first.meets, Pair((1.5, 0.0)), lengths=(1.0, 1.0), mode=1)


@pytest.mark.filterwarnings("ignore:overflow", "ignore:invalid")
def test_numbers_too_large_do_not_leave_as_infinity() -> None:
    with pytest.raises(ValueError, match="RRR: the numbers at row 0 are too large to compute with"):
        rrr(ORIGIN, Pair((1.0, 0.0), (1e200, 0.0)), lengths=(1.0, 1.0), mode=1)
    fast = np.array([[0.0, 0.0], [1.0, 0.0], [1e200, 0.0]])
    with pytest.raises(ValueError, match="at row 2 are"):
        rrr(ORIGIN, Pair((1.0, 0.0), fast), lengths=(1.0, 1.0), mode=1)


def test_one_row_of_a_pair_goes_with_many_of_a_guide() -> None:
    guide = Guide(ORIGIN, 0.0, rate=np.array([0.0, 1.0, 2.0]))
    solved = rrp(Pair((0.0, 0.3)), guide, length=0.5, mode=-1)
    assert solved.rates is not None
    assert solved.coordinates.shape == solved.rates.shape == solved.meets.position.shape == (3, 2)
    assert solved.determinant.shape == (3,)
    assert solved.coordinates[:, 1] == pytest.approx([-0.4] * 3)
    assert solved.rates[:, 0] == pytest.approx(solved.rates[1, 0] * np.arange(3.0))


def test_no_rows_in_no_rows_out() -> None:
    pin = crank(ORIGIN, length=0.4, angle=np.zeros(0), rate=10.0).meets
    assert rrr(pin, Pair((1.2, 0.0)), lengths=(1.0, 0.7), mode=1).coordinates.shape == (0, 2)


def test_records_are_read_only_and_keep_their_own_numbers() -> None:
    place = np.array([[1.0, 0.0]])
    pair = Pair(place)
    place[0, 0] = 9.0
    assert pair.position[0, 0] == 1.0
    solved = rrr(ORIGIN, pair, lengths=(1.0, 1.0), mode=1)
    for array in (pair.position, solved.coordinates, solved.determinant, solved.meets.position, X_AXIS.angle):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0
