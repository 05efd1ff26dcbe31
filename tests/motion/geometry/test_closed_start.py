"""The nearest closed position of a start: Newton's, unless that runs more than a radian or a metre away."""

from types import SimpleNamespace

import numpy as np
import pytest

from coursework.api import make_run
from coursework.motion.geometry import closed_start as module
from coursework.motion.geometry import closure as closure_module
from coursework.motion.geometry.closure import Closure
from coursework.variant.reading.reader import parse_variant
from coursework.words.errors import InputError
from tests.mechanisms.library import mechanism


@pytest.mark.parametrize(("far", "found"), [(0.99, 0.99), (-1.01, 0.5), (1.01, 0.5), (None, 0.5)])
def test_a_root_that_is_far_away_is_sought_downhill(monkeypatch, far, found):
    guesses = {0.0: far, 0.25: 0.5}
    closure = SimpleNamespace(
        start=np.zeros(1), origin=None, scale=1.0, residual=lambda *_: (np.zeros(1), None),
        newton=lambda t, q, origin: None if guesses[q[0]] is None else np.array([guesses[q[0]]]),
    )  # fmt: skip
    monkeypatch.setattr(module, "_downhill", lambda _: np.array([0.25]))
    monkeypatch.setattr(module, "_without_turns", lambda _, q: q)
    assert module.closed_start(closure)[1].tolist() == [found]


@pytest.mark.parametrize("scale", [0.02, 50.0])
@pytest.mark.parametrize(("share", "closed"), [(0.98, True), (-0.98, True), (1.02, False), (-1.02, False)])
def test_a_position_is_closed_within_a_share_of_the_size_of_the_mechanism(scale, share, closed):
    off = np.array([0.0, share * closure_module.CLOSED * scale, scale])
    closure = SimpleNamespace(origin=None, scale=scale, residual=lambda *_: (off, None))
    assert module._is_closed(closure, np.zeros(3), [0, 1]) is closed


@pytest.mark.parametrize(("units", "counts", "found"), [
    ("rad rad m", False, [0.5, 1.0, 14.0]), ("rad rad m", True, [0.5, 1.0 + 2 * np.pi, 14.0]),
    ("m rad m", False, [-12.0, 1.0, 14.0]),
])  # fmt: skip
def test_whole_turns_are_taken_off_angles_where_the_closure_does_not_count_them(units, counts, found):
    """Where it does, as with a rope that winds up, it is open without the turn; a length has no turns."""
    coordinates = [SimpleNamespace(unit=unit) for unit in units.split()]
    q = np.array([0.5 - 4 * np.pi if units.startswith("rad") else -12.0, 1.0 + 2 * np.pi, 14.0])
    closure = SimpleNamespace(
        start=np.array([0.0, 0.5, 0.0]), free=(0, 1, 2), origin=None, scale=2.0,
        equations=SimpleNamespace(variant=SimpleNamespace(coordinates=coordinates)),
        residual=lambda t, nearer, origin: (np.array([0.0, float(counts) * abs(nearer[1] - q[1])]), None),
    )  # fmt: skip
    assert module._without_turns(closure, q).tolist() == pytest.approx(found)
    assert q[1] == 1.0 + 2 * np.pi


def test_without_a_closed_position_the_start_alone_is_looked_at(monkeypatch):
    """Newton finds none with the drive moved on, or only up to a row."""
    times = np.linspace(0.0, 0.02, 5)
    monkeypatch.setattr(closure_module, "CONFIGURATIONS", 5)

    def looked(closed):
        def rows(times, guess, kept):
            if closed is None:
                raise np.linalg.LinAlgError
            return guess + 1.0, np.array(closed)

        closure = SimpleNamespace(
            equations=SimpleNamespace(variant=SimpleNamespace(time=SimpleNamespace(end=1.0))), start=np.array([0.25, 0.5]),
            driven=(1,), targets=lambda times: (None, 10 * times[:, None]), newton_rows=rows, _moved=lambda times: times > 0,
        )  # fmt: skip
        return [part.tolist() for part in Closure.configurations.func(closure)]

    for closed in (None, [False, True, True, True, True]):
        assert looked(closed) == [[0.0], [[0.25, 0.5]]]
    assert looked([True, True, False, True, True]) == [times[:2].tolist(), [[1.25, 1.0], [1.25, pytest.approx(1.05)]]]
    assert looked([True] * 5)[0] == times.tolist()


@pytest.mark.parametrize(("lengths", "scale"), [((), 1.0), ((0.0,), 1.0), ((-2.0, 0.5), 2.0), ((0.3,), 0.3)])
def test_a_residual_is_measured_against_the_largest_length_of_the_data(lengths, scale):
    given = [SimpleNamespace(value=9.0, si="rad/s"), *(SimpleNamespace(value=value, si="m") for value in lengths)]
    closure = SimpleNamespace(equations=SimpleNamespace(variant=SimpleNamespace(given=given)))
    assert Closure.scale.fget(closure) == scale


@pytest.mark.parametrize(("right", "slip", "code", "told"), [
    ("0.5720474966558032 rad", "32.775907 rad", "V313", "phi2 = 32.775907 rad is 5.22 turns; 32.775907 deg?"),
    ("0.3 m", "300 m", "V312", "b = 300 m beside 0.28 m: 300 mm?"),
    ("0.5720474966558032 rad", "0.9 rad", "V313", ""),
])  # fmt: skip
def test_a_start_that_a_slip_of_the_pen_opens_is_refused_with_the_slip(right: str, slip: str, code: str, told: str) -> None:
    """The nearest closed start may be another assembly; the slip put right closes this one."""
    with pytest.raises(InputError) as caught:
        _ = make_run(parse_variant(mechanism("four-bar-loop", (right, slip)))).scene.closure
    (fault,) = caught.value.faults
    assert fault.code == code
    assert str(fault.message).partition(" A likelier slip: ")[2] == told


def test_a_root_without_a_value_on_the_way_to_a_closed_start_is_no_fault_of_the_tool():
    """Newton's first step from 1 leads to -1, where the closure has no value; the equation that disagrees is told."""
    text = (
        '[drive]\nv = "0"\n[coordinates]\na = { start = "1 m", rate = "v" }\nx = { start = "1 m", rate = "u" }\n'
        '[time]\nstep = "0.1 s"\nend = "1 s"\n[[constraint]]\nequation = "u = v"\n[closure]\nholds = ["sqrt(x) - a/4"]'
    )
    found, _ = module.closed_start(make_run(parse_variant(text, "mine")).scene.closure.at_zero([True]))
    assert found.tolist() == [0.75]
