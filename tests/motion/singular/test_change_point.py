"""What goes on from a change point, and where one is: the limits of both, each on both sides."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.singular.change_point import branches_at, nearest_change_point

ALL_SOLVED = SimpleNamespace(equations=(), from_closure=())


class Single:
    """A flow of one equation A u = b with one coordinate q, whose rate is u; A and b are functions of t and q."""

    def __init__(self, matrix, right):
        self.matrix, self.right, self.looks = matrix, right, 0
        self.places = [SimpleNamespace(unknowns=(0,))]
        self.rates, self.largest = [(False, 0)], [1.0]
        self.system = SimpleNamespace(unknowns=("u",), names=())
        self.equations, self.units, self.unknown_units = ALL_SOLVED, np.ones(1), np.ones(1)

    def part(self, t, q, block):
        self.looks += 1
        return np.array([[self.matrix(t, *q)]]), np.array([self.right(t, *q)]), np.zeros(1)

    def velocities(self, t, q, block, own):
        return own


@pytest.mark.parametrize(
    ("square", "slope", "constant", "count"),
    [
        (1.2e-6, 1.0, 0.1, 2), (0.9e-6, 1.0, 0.1, 1),  # one motion is beyond all bounds
        (0.0, 1.2e-6, 1.0, 1), (0.0, 0.9e-6, 1.0, 0),
        (1.0, 2.0, 1 + 0.9e-6, 1), (1.0, 2.0, 1 + 1.2e-6, None),  # the two are one, or none is
    ],
)  # fmt: skip
def test_how_many_motions_go_on_from_a_change_point(square, slope, constant, count):
    """Along u the second derivative of the closure is square u^2 + slope u + constant; its sign says nothing."""
    for sign in (1, -1):
        flow = Single(lambda t, q, sign=sign: 0.0 + sign * (square * q + slope * t), lambda t, q, sign=sign: -sign * constant * t)
        found = branches_at(flow, 0, 0.0, [0.0])
        assert found is count if count is None else len(found) == count
        for u in (one["u"] for one in found or ()):
            parts = square * u**2, slope * u, constant
            assert abs(sum(parts)) < 1e-3 * max(map(abs, parts))


@pytest.mark.parametrize(("fast", "end"), [(1e3, 1.0), (1e3, 100.0), (30.0, 1.0), (1e-3, 0.1), (1e-2, 50.0), (4e-7, 1e7)])
def test_velocities_far_from_those_looked_for_are_looked_for_again(fast, end):
    """sin(q) u = f^2 t goes on with u = f and -f.  At 1e3 rad/s differences over 1e-5 s were off, at 4e-7 both would be one."""
    flow = Single(lambda t, q: math.sin(q), lambda t, q: fast**2 * t)
    found = sorted(one["u"] for one in branches_at(flow, 0, 0.0, [0.0], end))
    assert found == pytest.approx([-fast, fast], rel=1e-7)


@pytest.mark.parametrize(("apart", "count"), [(1.2e-5, 1), (0.8e-5, 0), (0.0, 0)])
def test_sides_that_are_alike_whatever_the_velocity_tell_no_motion(apart, count):
    """t u = (1 - apart) q: the sides differ by that share of the larger for u = 1 and -1, and only u = 0 goes on."""
    flow = Single(lambda t, q: t, lambda t, q: (1 - apart) * q)
    assert len(branches_at(flow, 0, 0.0, [0.0])) == count


@pytest.mark.parametrize("begin", [0.7, 0.9, 0.99, 1.01, 1.3])
def test_a_change_point_is_where_two_curves_of_positions_cross(begin):
    """(q - 1)^2 = (t - 1)^2 crosses at 1, where p = q^2 is 1 too; the motion q = t goes through the point itself."""
    flow = SimpleNamespace(
        places=[SimpleNamespace(unknowns=(0, 1))], rates=[(False, 0), (False, 1)], units=np.ones(2), unknown_units=np.ones(2),
        part=lambda t, q, block: (
            np.array([[2 * (q[0] - 1), 0.0], [-2 * q[0], 1.0]]), np.array([2 * (t - 1), 0.0]), np.array([1.0, 2 * q[0]])
        ),
    )  # fmt: skip
    rates = np.array([1.0, 2 * begin])
    time, position, miss = nearest_change_point(flow, begin, np.array([begin, begin**2]), 0, rates, 1.0)
    assert [time, *position, miss] == pytest.approx([1.0, 1.0, 1.0, 0.0], abs=1e-9)


@pytest.mark.parametrize(("longest", "count"), [(1e6, 2), (4e7, 2), (5e7, 0), (1e9, 0)])
def test_motions_are_told_apart_where_differences_have_digits(longest, count):
    """u^2 = 1 of size 1 beside a length: differences over 1e-5 s have three digits while 1e3 eps / 1e-5 of it is below 1."""
    flow = SimpleNamespace(
        places=[SimpleNamespace(unknowns=(0, 1))], rates=[(False, 0), (False, 1)], system=SimpleNamespace(unknowns=("u", "v")),
        equations=ALL_SOLVED, part=lambda t, q, block: (np.array([[q[0], 0.0], [0.0, longest]]), np.array([t, 0.0]), np.zeros(2)),
        velocities=lambda t, q, block, own: own, units=np.ones(2), unknown_units=np.ones(2),
    )  # fmt: skip
    found = branches_at(flow, 0, 0.0, [0.0, 0.0])
    assert sorted(round(one["u"], 6) for one in found) == [-1.0, 1.0][:count]


@pytest.mark.parametrize("longest", [1.0, 1e3, 1e-3])
@pytest.mark.parametrize(("share", "count"), [(1.1e-6, 2), (0.9e-6, 0)])
def test_where_two_equations_are_lost_no_motion_is_told(longest, share, count):
    """u^2 = 1 beside v = 0 and w = 0, of which one counts for a millionth of the other."""
    flow = SimpleNamespace(
        places=[SimpleNamespace(unknowns=(0, 1, 2))], rates=[(False, 0), (False, 1), (False, 2)],
        system=SimpleNamespace(unknowns=("u", "v", "w")), equations=ALL_SOLVED, velocities=lambda t, q, block, own: own,
        part=lambda t, q, block: (longest * np.diag([q[0], share, 1.0]), longest * np.array([t, 0.0, 0.0]), np.zeros(3)),
        units=np.ones(3), unknown_units=np.ones(3),
    )  # fmt: skip
    assert len(branches_at(flow, 0, 0.0, [0.0, 0.0, 0.0])) == count


@pytest.mark.parametrize(("within", "given_up"), [(0.12, False), (0.08, True)])
def test_newton_that_goes_more_than_ten_times_as_far_as_is_asked_for_is_given_up(within, given_up):
    """The change point is 1 rad away, where three looks along the motion lead; Newton's first step takes ten."""
    flow = Single(lambda t, q: q - 1, lambda t, q: t)
    assert nearest_change_point(flow, 0.0, np.array([0.0]), 0, np.array([1.0]), within) is None
    assert (flow.looks == 1 + 3 + 10) is given_up


def test_newton_is_given_up_after_twelve_steps():
    """Towards a double zero it halves its way only."""
    flow = Single(lambda t, q: (q - 1) ** 2, lambda t, q: t)
    assert nearest_change_point(flow, 0.0, np.array([0.0]), 0, np.array([1.0]), 10.0) is None
    assert flow.looks == 1 + 3 + 12 * 5 * 2


PARALLEL = """[given]
a = "A m"
d = "D m"
[drive]
w = "2"
[coordinates]
p = { start = "90 deg", rate = "w" }
x = { start = "D m", rate = "u" }
y = { start = "A m", rate = "v" }
[time]
step = "10 ms"
end = "1 s"
[[constraint]]
equation = "(x - a*cos(p))*(u + a*w*sin(p)) + (y - a*sin(p))*(v - a*w*cos(p)) = 0"
[[constraint]]
equation = "(x - d)*u + y*v = 0"
[closure]
holds = ["(x - a*cos(p))^2 + (y - a*sin(p))^2", "(x - d)^2 + y^2"]
"""


@pytest.mark.parametrize("size", [1e-7, 3e6, 1e9])
def test_two_motions_meet_in_micrometres_as_in_kilometres(size):
    """The pin of a parallelogram at p = 180 deg: v = -a w as its links stay parallel, or v = a w (d-a)/(d+a)."""
    text = PARALLEL.replace("A m", f"{0.2 * size!r} m").replace("D m", f"{0.5 * size!r} m")
    stop = coursework.solve(coursework.parse_variant(text), "exact").stop
    assert stop.time == pytest.approx(math.pi / 4, abs=1e-14) and stop.kind == "change point"
    assert sorted(one["v"] / size for one in stop.branches) == pytest.approx([-0.4, 0.4 * 0.3 / 0.7], rel=1e-9)
    assert max(abs(one["u"]) for one in stop.branches) <= 1e-9 * size
