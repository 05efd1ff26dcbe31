"""Directions, turning, forces and energies of one body by hand, as expressions and as numbers in rows: 3, 4 and 5 m."""

from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.effects.acting import ActingWriter
from coursework.effects.force_scheme import DISC, ROD, Direction, inertia_of
from coursework.effects.rows import PLACE, RATE, SECOND, Rows
from coursework.equations.algebra.expression import ZERO, number
from coursework.variant.formula.tree import named

PLACES = {"A": (1, 1), "B": (4, 5), "S": (1, 2), "P": (4, 6)}
RATES = {(3, 4): (-8, 6), (1, 2): (3, -1)}
SECONDS = {1: Fraction(1, 2), 2: -3, 3: 1, 4: 7}
SPAN = named("A"), named("B")


def of(*values):
    return tuple(number(value) for value in values)


class Written(ActingWriter):
    """What is known of the points as numbers, whose derivatives are looked up."""

    def vector(self, formula):
        return of(*PLACES[getattr(formula, "name", formula)])

    def scalar(self, formula):
        return ZERO if formula is None else number(formula)

    def rate(self, parts):
        return of(*RATES[tuple(part.value for part in parts)])

    def second(self, expression):
        return number(SECONDS[expression.value])

    def changed(self, rate):
        return number(9)


class Loaded(Written):
    """The same with a moment of inertia of 5 and one load: a force (2, 3) at P and a torque 7."""

    def inertia(self, body):
        return number(5)

    def loads(self, body):
        yield of(*PLACES["P"]), of(2, 3), number(7)


def written(kind=Written, springs=(), rate=Fraction(3, 2), **given):
    scheme = SimpleNamespace(
        bodies=[BODY], forces=SimpleNamespace(gravity=(1, -10), springs=springs), holder={"A": "1", "B": "2"}.get
    )
    symbols = SimpleNamespace(rate=lambda _: number(rate), partial=lambda part, _: number(part.value - 1))
    return kind(SimpleNamespace(symbols=symbols), scheme)


BODY = SimpleNamespace(name="1", rate="", span=SPAN, centre="S", mass=2)
SPRING = SimpleNamespace(ends=("A", "B"), stiffness=8, free=3, damping=2)
WAYS = [("along", (0.6, 0.8)), ("across", (-0.8, 0.6)), ("tangent", (0.8, -0.6))]


def numbers(parts):
    return [float(part.value) for part in parts]


@pytest.mark.parametrize(("kind", "way"), WAYS)
def test_a_direction_through_two_points(kind, way):
    one = SimpleNamespace(direction=Direction(kind, through=SPAN))
    assert numbers(written().along(one)) == pytest.approx(way)
    assert rows().along(one) == pytest.approx(np.full(2, complex(*way)))


@pytest.mark.parametrize(("kind", "way"), [("along", (1, 0)), ("across", (0, 1)), ("tangent", (0, -1))])
def test_a_direction_by_an_angle(kind, way):
    assert numbers(written().along(SimpleNamespace(direction=Direction(kind, angle=0)))) == list(way)
    angle = rows(values={("angle", False, PLACE): np.array([0.0, 0.5])})
    turned = np.exp(0.5j)
    assert angle.along(SimpleNamespace(direction=Direction(kind, "angle"))) == pytest.approx(
        complex(*way) * np.array([1, turned])
    )


def test_a_unit_couple_on_an_arm_is_a_force_across_it_and_axes_are_axes():
    one = SimpleNamespace(direction=Direction("slope", coordinate="q"), at=SPAN[1])
    assert numbers(written().along(one)) == pytest.approx([3 / 25, 4 / 25])
    assert rows(values={(SPAN[1], True, "q"): np.array([3 + 4j, 5.0])}).along(one) == pytest.approx([(3 + 4j) / 25, 0.2])
    for kind, way in (("x", 1.0), ("y", 1j)):
        assert rows().along(SimpleNamespace(direction=Direction(kind), at=None)).tolist() == [way, way]


def test_a_body_turns_with_its_rate_or_as_the_line_between_its_ends():
    """(3, 4) moves by (-8, 6) m/s: 2 rad/s; with (1, 7) m/s^2 across it is (21 - 4)/25 rad/s^2."""
    assert numbers(written().turned(BODY)) == pytest.approx([2.0, 17 / 25])
    assert written().turned(SimpleNamespace(rate="", span=None)) == (ZERO, ZERO)
    assert written().turned(SimpleNamespace(rate="", span=(SPAN[0], SPAN[0]))) == (ZERO, ZERO)
    omega, epsilon = written().turned(SimpleNamespace(rate="w", span=SPAN))
    assert (omega.name, epsilon) == ("v_w", number(9))
    found = rows()
    assert [found.omega(BODY)[0], found.epsilon(BODY)[0]] == pytest.approx([2.0, 17 / 25])
    assert found.velocity(BODY, np.array([4 + 6j, 1 + 2j])) == pytest.approx([3 - 1j + 2j * (3 + 4j), 3 - 1j])
    assert found.turned_by(BODY, "q") == pytest.approx([0.2, -0.12]) and found.turned_by(BODY, "p").tolist() == [0.0, 0.0]
    still = rows(bodies=[SimpleNamespace(name="1", rate="", span=None), SimpleNamespace(name="2", rate="w", span=SPAN)])
    assert [still.omega(one).tolist() for one in still.scheme.bodies] == [[0.0, 0.0], [4.0, 5.0]]


def test_forces_and_moment_of_inertia_weight_and_a_load():
    """2 kg with (1/2, -3) m/s^2 in a field (1, -10): (1, -14) N; a load (2, 3) N, (3, 4) m from it; -5*17/25 + 7 + 9 - 8 N m."""
    assert numbers(written(Loaded).wrench(BODY)) == pytest.approx([1, 2, 3, -11, 8 - 3.4])
    kinetic, potential = written(Loaded, [SPRING]).energies()
    assert numbers((kinetic, potential)) == pytest.approx([10 + 10, 38 + 16])


def test_a_spring_pulls_its_ends_together_and_its_damper_holds_them():
    """8 N/m stretched by 2 m and 2 N s/m at 1.5 m/s: 19 N, of which 3/5 and 4/5 along x and y."""
    assert numbers(written().pull(SPRING)) == pytest.approx([5, 19])
    assert numbers(written().pull(SimpleNamespace(ends=("A", "B"), stiffness=None, free=None, damping=2))) == pytest.approx(
        [5, 3]
    )
    for body, at, sign in (("1", "A", 1), ("2", "B", -1)):
        ((where, force, torque),) = written(springs=[SPRING]).pulls(SimpleNamespace(name=body))
        assert (where, torque) == (of(*PLACES[at]), ZERO) and numbers(force) == pytest.approx([sign * 19 * 0.6, sign * 19 * 0.8])


@pytest.mark.parametrize(
    ("inertia", "on", "found"), [(ROD, "1", 2 * 25 / 12 + 3), (DISC, "2", 2 * 25 / 2), (11, "1", 14), (11, "2", 11)]
)
def test_a_moment_of_inertia_and_the_flywheel_on_its_body(inertia, on, found):
    scheme = SimpleNamespace(forces=SimpleNamespace(flywheel=SimpleNamespace(on=on, inertia=3)), body_named=lambda name: name)
    body = SimpleNamespace(inertia=inertia, mass=2, span=SPAN, name="1")
    assert inertia_of(scheme, body, float, lambda first, last: 25.0) == pytest.approx(found)
    scheme.forces.flywheel = None
    assert inertia_of(scheme, body, float, lambda first, last: 25.0) == pytest.approx(found - 3 * (on == "1"))


def rows(values=(), bodies=(BODY,)):
    both = lambda value: np.array([value, value])  # noqa: E731
    known = {(point, True, level): both(complex(*place)) for point, level, place in (
        (SPAN[0], PLACE, (1, 1)), (SPAN[1], PLACE, (4, 5)), (SPAN[0], RATE, (1, 1)), (SPAN[1], RATE, (-7, 7)),
        (SPAN[0], SECOND, (2, 0)),
        (SPAN[1], SECOND, (3, 7)), ("S", PLACE, (1, 2)), ("S", RATE, (3, -1)),
    )}  # fmt: skip
    unknowns = [SimpleNamespace(at=SPAN[0]), SimpleNamespace(at=None), SimpleNamespace(at=SPAN[1])]
    turning = {"w": (np.array([4.0, 5.0]), np.zeros(2))}
    return Rows(
        SimpleNamespace(t=np.arange(2.0)), SimpleNamespace(bodies=[*bodies], unknowns=unknowns), {**known, **dict(values)},
        turning,
        {}, {("1", "q"): np.array([-0.8 + 0.6j, 0.6 - 0.2j])},
    )  # fmt: skip


def test_the_length_of_a_mechanism_is_the_farthest_joint_from_the_first():
    found = rows()
    assert found.length == pytest.approx(5.0) and found.scalar(None).tolist() == [0.0, 0.0]
    assert rows(values={(SPAN[1], True, PLACE): np.full(2, 1 + 1j)}).length == 1.0
