"""What a rectangle covers: against cases that are counted by hand, and against sampling along the lines."""

import numpy as np
import pytest

from coursework.drawing.paper.cover import Lines, shared, through

BOX = np.array([[1.0, 2.0]]), np.array([[4.0, 6.0]])


@pytest.mark.parametrize(
    ("a", "b", "length"),
    [
        (0 + 3j, 9 + 3j, 3.0),  # across
        (2 + 0j, 2 + 9j, 4.0),  # down
        (2 + 3j, 3 + 3j, 1.0),  # wholly within
        (0 + 1j, 6 + 7j, 3 * np.sqrt(2)),  # through a corner and out at a side
        (2 + 3j, 2 + 3j, 0.0),  # a point within
        (0 + 1j, 0 + 9j, None),  # beside it
        (5 + 0j, 9 + 9j, None),
        (0 + 9j, 9 + 9j, None),
        (0 + 5.5j, 2 + 9j, None),  # past a corner
    ],
)
def test_the_part_of_a_line_by_hand(a, b, length):
    crossed, covered, _ = Lines([(a, b)]).within(*BOX)
    assert (crossed[0], covered[0]) == pytest.approx((int(length is not None), length or 0.0))


@pytest.mark.parametrize(("free", "met"), [(0.4, 1), (0.2, 0)])
def test_about_some_lines_more_is_kept_free(free, met):
    plain, length, others = Lines([(2 + 3j, 3 + 3j), (0 + 6.3j, 9 + 6.3j)], 1, free).within(*BOX)
    assert (plain[0], length[0], others[0]) == (1, 1.0, met)


def test_many_lines_and_rectangles_against_sampling():
    random = np.random.default_rng(5)
    ends = random.uniform(0, 10, (40, 2, 2))
    low = random.uniform(0, 7, (16, 2))
    high = low + random.uniform(0.5, 3, (16, 2))
    crossed, covered, _ = Lines([(complex(*a), complex(*b)) for a, b in ends]).within(low, high)
    along = (np.arange(20_000) + 0.5) / 20_000
    samples = ends[:, 0, None] + along[:, None] * (ends[:, 1] - ends[:, 0])[:, None]
    for place in range(16):
        part = np.mean(np.all((samples > low[place]) & (samples < high[place]), axis=2), axis=1)
        assert covered[place] == pytest.approx(np.sum(part * np.hypot(*(ends[:, 1] - ends[:, 0]).T)), abs=0.02)
        assert abs(crossed[place] - np.count_nonzero(part)) <= 1  # a line may touch a corner between two samples


def test_shared_sides_by_hand():
    others = [(0.0, 0.0, 2.0, 3.0), (4.0, 2.0, 5.0, 6.0), (2.0, 3.0, 3.0, 4.0), (9.0, 3.0, 10.0, 4.0)]
    assert shared(*BOX, others).tolist() == [[[1.0, 1.0], [0.0, 4.0], [1.0, 1.0], [-5.0, 1.0]]]
    assert shared(*BOX, []).shape == (1, 0, 2)


def test_distances_of_a_rectangle_from_lines_by_hand() -> None:
    lines = Lines([(0 + 0j, 9 + 0j), (5 + 1j, 9 + 9j), (8 + 9j, 8 + 9j), (0 + 3j, 9 + 3j), (7 + 3j, 7 + 30j)])
    assert lines.apart(*BOX)[0] == pytest.approx([2.0, abs(complex(4, 2) - _foot(4 + 2j, 5 + 1j, 9 + 9j)), 5.0, 0.0, 3.0])


def _foot(at, a, b):
    """Return the point of a line that is nearest to another, by trial."""
    return min((a + (b - a) * k / 100_000 for k in range(100_001)), key=lambda place: abs(place - at))


def test_what_a_way_crosses_by_hand() -> None:
    lines = Lines([(0 + 5j, 9 + 5j), (0 + 7j, 2 + 7j), (5 + 0j, 5 + 9j)])
    begin, step = np.array([[3.0, 0.0], [1.0, 0.0]]), np.array([[0.0, 9.0], [8.0, 9.0]])
    assert lines.crossed(begin, step).tolist() == [1, 2]
    boxes = np.array([(2.0, 3.0, 4.0, 4.0), (6.0, 0.0, 9.0, 2.0)])
    assert through(begin, step, boxes).sum(axis=0).tolist() == [1, 1]
