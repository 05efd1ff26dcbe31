"""One Newton over all rows finds the rows that following step by step finds, and leaves a row in doubt to it."""

from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.integration.following import NotReached, _Follower, follow_closure
from coursework.variant.catalogue import names
from coursework.variant.reading.reader import parse_variant
from tests.hard.scenes import V31_IMPOSSIBLE
from tests.sample import sampled
from tests.solved import solved


@pytest.fixture
def singles(monkeypatch):
    """Return the list of the intervals that were followed by themselves."""
    found, single = [], _Follower.single

    def noted(self, begin, end, *rest):
        found.append((begin, end))
        return single(self, begin, end, *rest)

    monkeypatch.setattr(_Follower, "single", noted)
    return found


@pytest.mark.parametrize(("off", "kept"), [(0.045, 3), (0.055, 1)])
def test_a_guess_that_is_far_off_leaves_its_row_in_doubt(off, kept):
    guess = np.zeros((3, 2))
    found = guess + np.array([[0, 0], [0, off], [0, 0]])
    stand = SimpleNamespace(
        closure=SimpleNamespace(newton_rows=lambda *_: (found, np.ones(3, dtype=bool))),
        rates=SimpleNamespace(table=lambda *_: (None, np.ones((3, 1)))), signs=np.ones(1),
    )  # fmt: skip
    assert len(_Follower.certain(stand, np.arange(3.0), guess, guess)) == kept


def test_where_newton_meets_a_singular_position_every_row_is_in_doubt():
    def failing(*_):
        raise np.linalg.LinAlgError

    stand = SimpleNamespace(closure=SimpleNamespace(newton_rows=failing))
    assert _Follower.certain(stand, np.arange(3.0), np.zeros((3, 2)), None).shape == (0, 2)


def test_an_interval_over_which_no_position_is_found_is_halved_with_the_targets_of_each_half():
    """At t the target is 10 t and the driven coordinate 100 t; a position is found over a quarter of the interval at most."""
    ends = []

    def newton(end, guess, target):
        ends.append(end)
        begin = guess[1]
        assert (guess[0], target.tolist()) == (pytest.approx(100 * end), [pytest.approx(10 * end)])
        return np.array([guess[0], guess[1]]) if end - begin <= 0.25 else None

    closure = SimpleNamespace(
        driven=(0,), newton=newton, targets=lambda times: (10 * times[:, None], 100 * times[:, None]),
    )  # fmt: skip
    rates = SimpleNamespace(velocities=(), evaluate=lambda t, *q: np.array([1.0]))
    stand = SimpleNamespace(
        closure=closure, rates=rates, signs=np.ones(1), parts=0, _predicted=lambda begin, length, q: np.array([-1.0, begin])
    )
    found = _Follower.single(stand, 2.0, 3.0, np.zeros(2), np.array([30.0]), np.array([300.0]))
    assert ends == [3.0, 2.5, 2.25, 2.5, 3.0, 2.75, 3.0]
    assert (found.tolist(), stand.parts) == ([300.0, 2.75], 7)


def step_by_step(closure, rates, times, monkeypatch):
    """Return the rows when every one of them is in doubt."""
    with monkeypatch.context() as changed:
        changed.setattr(_Follower, "certain", lambda _self, _times, guess, _targets: guess[:0])
        return follow_closure(closure, rates, times)


@pytest.mark.parametrize("name", sampled(name for name in names() if name != "falling-arm"))  # which closes no loop
def test_the_rows_are_those_found_step_by_step(name, monkeypatch):
    scene = solved(name).scene
    assert scene.closure.complete
    time = scene.variant.time
    for stride in (1, 3):
        times = np.arange(int(time.end / time.step / stride) + 1) * (time.step * stride)
        found = follow_closure(scene.closure, scene.rates, times)
        assert np.max(np.abs(found - step_by_step(scene.closure, scene.rates, times, monkeypatch))) < 1e-12


def test_no_row_of_many_is_followed_by_itself(singles):
    scene = coursework.solve("31").scene
    follow_closure(scene.closure, scene.rates, np.arange(5001) * 0.48 / 5000)
    assert singles == []


def test_a_guess_that_is_far_off_is_followed_in_parts(singles):
    """Half a turn of the drive a row: what one step of the scheme guesses is another position."""
    scene = coursework.solve("31").scene
    coarse, fine = np.arange(5) * 0.2, np.arange(401) * 0.002
    found = follow_closure(scene.closure, scene.rates, coarse)
    assert len(singles) > 0
    assert np.max(np.abs(found - follow_closure(scene.closure, scene.rates, fine)[::100])) < 1e-12


@pytest.mark.parametrize("step", [0.02, 0.01, 0.001])
def test_it_ends_in_the_row_before_a_dead_point(step):
    """t* = 0.116889254610302 s (reference): the row before it is reached, the row behind it is not."""
    scene = coursework.solve(parse_variant(V31_IMPOSSIBLE)).scene
    with pytest.raises(NotReached) as stopped:
        follow_closure(scene.closure, scene.rates, np.arange(int(0.2 / step)) * step)
    assert str(stopped.value).endswith(f" t = {step * (int(0.116889254610302 / step) + 1):.9g} s")


def test_rows_of_the_wrong_assembly_are_in_doubt(singles, monkeypatch):
    """A Newton that lands in the other assembly is noticed by the sign of the determinant."""
    scene = coursework.solve("31").scene
    closure, times = scene.closure, np.arange(25) * 0.02
    right = follow_closure(closure, scene.rates, times)
    newton_rows = type(closure).newton_rows

    def elsewhere(self, at, guess, targets):
        found, is_closed = newton_rows(self, at, guess, targets)
        # The mirror image of the dyad: its links change places about the line between their outer ends.
        found[7:, 0], found[7:, 1] = found[7:, 1] + np.pi, found[7:, 0] - np.pi
        return found, is_closed

    monkeypatch.setattr(type(closure), "newton_rows", elsewhere)
    found = follow_closure(closure, scene.rates, times)
    assert len(singles) > 0
    assert np.max(np.abs(found - right)) < 1e-12


@pytest.mark.parametrize("name", ["jansen", "whitworth", "watt"])
def test_a_whole_turn_at_once_is_followed_by_halves(name):
    """What one step guesses there is too far off: each half is followed by itself, and its halves where they are needed."""
    scene = coursework.solve(name, quantities=["table"]).scene
    period = scene.variant.time.period
    found = follow_closure(scene.closure, scene.rates, np.array([0.0, period]))
    fine = follow_closure(scene.closure, scene.rates, np.linspace(0.0, period, 61))
    assert np.max(np.abs(found - fine[[0, -1]])) < 1e-12
