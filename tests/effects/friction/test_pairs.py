"""A block of 2 kg on a guide that bears it with 10 N, rubbing with 0.2 of that: what slides, what stands, what locks."""

import math
from dataclasses import replace

import numpy as np
import pytest

from coursework.effects.friction.held import Held
from coursework.effects.friction.rubbing import Pair, Rubbing, State

GUIDE = Pair("A", "guide", 0, couple=True)
# Free acceleration 3 m/s²; a newton of friction takes 1/2 m/s²; the guide's force does not follow friction.
BLOCK = State([3.0], [7.0], [10.0, 0.0], [[0.0, 0.0]], [[-0.5]], [(0.2, 0.0)], [1.0], [0.0], [[1.0]])


def rubbing(state=BLOCK, pairs=(GUIDE,), held=()):
    return Rubbing(tuple(pairs), lambda *given: state(*given) if callable(state) else state, held)


@pytest.mark.parametrize(("sign", "a"), [(1.0, 2.0), (-1.0, 4.0), (0.0, 3.0)])
def test_friction_of_two_newtons_is_against_what_slides(sign, a):
    assert rubbing().free(BLOCK, [sign]) == pytest.approx([a])
    assert rubbing(held=(sign,)).slope() == pytest.approx((a, 7.0))
    assert rubbing(replace(BLOCK, speeds=[sign])).slope() == pytest.approx((a, 7.0))


@pytest.mark.parametrize("size", [1.0, 1e-8, 1e8])
@pytest.mark.parametrize(("follows", "sign", "friction"), [
    (2.0, 1.0, 2 / 0.6), (2.0, -1.0, 2 / 1.4), (2.5, 1.0, 2 / 0.5), (5.0, 1.0, None), (6.0, 1.0, None), (-5.5, -1.0, None),
    (-2.0, 1.0, 2 / 1.4),
])  # fmt: skip
def test_a_force_that_grows_with_friction_settles_or_locks(follows, sign, friction, size):
    """N = 10 + k F and F = 0.2 N: F = 2/(1 - 0.2 k), and none where 0.2 k is 1 or more; a block of any weight does alike."""
    state = replace(BLOCK, reactions=[[follows, 0.0]], loose=[10.0 * size, 0.0], changes=[[-0.5 / size]])
    if friction is None:
        with pytest.raises(Held) as held:
            rubbing().free(state, [sign])
        assert (held.value.at, held.value.locked) == ("A", True)
    else:
        assert rubbing().free(state, [sign]) == pytest.approx([3 - sign * friction / 2], rel=1e-12)


@pytest.mark.parametrize(("kind", "couple", "loose", "length", "force"), [
    ("pin", False, [3.0, 4.0], 0.0, 5.0), ("pin", True, [3.0, -4.0], 9.0, 5.0), ("guide", True, [-10.0, 3.0], 0.5, 12.0),
    ("guide", True, [10.0, -3.0], 1.0, 10.0), ("guide", True, [10.0, 3.0], 0.0, 10.0), ("guide", False, [-10.0, 9.0], 0.5, 10.0),
    ("wheel", False, [-2.0, 9.0], 0.0, 2.0),
])  # fmt: skip
def test_a_pin_bears_both_parts_and_a_guide_its_force_or_a_couple_at_two_ends(kind, couple, loose, length, force):
    pair = Pair("B", kind, 1, couple)
    state = replace(BLOCK, loose=[99.0, *loose], reactions=[[0.0] * 3], factors=[(0.3, length)])
    assert rubbing(pairs=[pair]).free(state, [1.0]) == pytest.approx([3 - 0.5 * 0.3 * force])


def test_of_several_that_lock_the_one_that_bears_most_is_told():
    state = replace(
        BLOCK, loose=[10.0, 1.0], reactions=[[6.0, 6.0], [0.0, 0.0]], changes=[[-0.5], [-0.5]], factors=[(0.2, 0.0), (2.0, 0.0)],
    )  # fmt: skip
    with pytest.raises(Held) as held:
        rubbing(pairs=[Pair("A", "guide", 0, couple=False), Pair("B", "guide", 1, couple=False)]).free(state, [1.0, 1.0])
    assert held.value.at == "B"  # it bears as much as A makes of it, and rubs ten times more


@pytest.mark.parametrize(("a", "sign"), [(3.0, 1.0), (1.01, 1.0), (0.99, None), (-0.99, None), (-1.01, -1.0), (0.0, 0.0)])
def test_what_stands_begins_to_slide_where_forces_are_more_than_friction(a, sign):
    """Friction takes up to 1 m/s²."""
    state = replace(BLOCK, a=[a], speeds=[0.0])
    if sign is None:
        with pytest.raises(Held) as held:
            rubbing(state).signs()
        assert (held.value.at, held.value.locked) == ("A", False)
    else:
        assert rubbing(state).signs() == (sign,)


def test_what_moves_goes_on_and_what_is_said_to_stand_is_asked():
    assert rubbing(replace(BLOCK, a=[-9.0])).signs() == (1.0,) and rubbing(replace(BLOCK, speeds=[-1.0])).signs() == (-1.0,)
    assert rubbing(replace(BLOCK, a=[-9.0])).signs(still=[True]) == (-1.0,)
    alike = replace(BLOCK, a=[3.0], speeds=[0.0], turning=[-2.0], changes=[[0.0]], by_free=[[2 / 3]])
    assert rubbing(alike).signs() == (0.0,)  # both links turn it alike: it does not slide
    assert rubbing(replace(alike, turning=[-1.9])).signs() == (1.0,)


def test_signs_are_kept_whatever_is_asked_of_states_near():
    found = rubbing(replace(BLOCK, speeds=[-0.5]), held=(1.0,))
    with found.sliding_as(0.0):
        assert found.held == (-1.0,)
    assert found.held == (1.0,)


def test_what_friction_adds_row_by_row():
    """Speeds -2, 0 (of a largest of 2), where it sets off, 2 and one in which it locks; then one at rest that is held."""

    def state(t, v):
        return replace(BLOCK, speeds=[v], reactions=[[6.0 if t > 2 else 0.0, 0.0]])

    t, v = np.array([0.0, 1.0, 2.0, 3.0]), np.array([-2.0, 1e-14, 2.0, 2.0])
    assert rubbing(state).taken(1, t, v)[0] == pytest.approx([1.0, -1.0, -1.0, math.nan], nan_ok=True)
    assert rubbing(state).taken(1, t[:2], np.array([-2.0, 0.1]))[0] == pytest.approx([1.0, -1.0])
    weak = rubbing(lambda t, v: replace(BLOCK, a=[0.5], speeds=[v], turning=[0.5]))
    assert weak.taken(1, t[:2], np.array([2.0, 0.0]))[0] == pytest.approx([-1.0, -0.5])


def test_a_step_ends_where_the_block_turns_round_and_goes_on_the_other_way():
    """Up a slope with 1 m/s against 3 + 1 m/s²: it stands after 0.25 s, 0.125 m on, then slides back with 2 m/s²."""

    def state(t, q, v):
        return replace(BLOCK, a=[-3.0], speeds=[v])

    block = Rubbing((GUIDE,), state)
    where = lambda q, v, t: (t, q, v)  # noqa: E731

    def moving(q, v, t):
        return [v, block.slope(t, q, v)[0], 1.0]

    begin = np.array([0.0, 1.0, 0.0])
    block.begin(moving, where, begin)
    assert block.held == (1.0,)
    after = np.array([1.0 - 2.0, 1.0 - 4.0, 1.0])  # a second on, with the friction of sliding up
    taken, end = block.turned(moving, where, (begin, np.array([1.0, -4.0, 1.0])), 1.0, after)
    assert (taken, *end) == pytest.approx((0.25, 0.125, 0.0, 0.25), abs=1e-9)
    assert block.held == (-1.0,) and moving(*end)[1] == pytest.approx(-2.0)
    short = np.array([0.08, 0.6, 0.1])
    block.held = (1.0,)
    assert block.turned(moving, where, (begin, np.array([1.0, -4.0, 1.0])), 0.1, short) == (0.1, short)


@pytest.mark.parametrize("size", [1e-6, 1e6])
@pytest.mark.parametrize(("part", "sign"), [(0.98e-12, 0.0), (-0.98e-12, 0.0), (1.02e-12, 1.0), (-1.02e-12, -1.0)])
def test_bodies_that_begin_to_turn_alike_do_not_slide_at_any_size(part, sign, size):
    """One turns by the drive, the other with the free acceleration, and their difference is a part of either."""
    state = replace(BLOCK, speeds=[0.0], turning=[size], by_free=[[-1.0 + part]])
    assert rubbing(state)._beginning(state, [size], [True]) == [sign]
