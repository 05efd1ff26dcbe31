"""What a table misses after a period, split into its causes; and drives and motions that are not back, of numbers by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.results.checks.close_to_motion import period, several_periods
from coursework.results.checks.close_to_motion.period import _drive_strayed, _multiple, _not_back, mismatch


def evidence(**changes):
    """Return a table whose angle is off by 0.02 rad after two turns: 0.015 are the exact motion's and 0.001 round-off."""
    end = 0.1 + 4 * math.pi + 0.02
    motion = SimpleNamespace(
        rows=np.array([[0.1, 5.0], [3.0, 6.0], [end, 5.3]]), names=("q", "w"), coordinate_names=("q",), stop=None
    )
    exact = {"q": np.array([0.2, 0.0, 0.2 + 4 * math.pi + 0.015]), "w": np.array([5.0, 9.0, 5.1])}
    given = {
        "period_row": 2, "motion": motion, "exact": SimpleNamespace(column=exact.__getitem__), "compared": 3,
        "unit": {"q": "rad", "w": "rad/s"}.get, "extended_precision": np.array([[0.1], [3.0], [end - 0.001]]), **changes,
    }  # fmt: skip
    return SimpleNamespace(**given)


@pytest.mark.parametrize(("extended", "roundoff"), [(True, 0.001), (False, 0.0)])
def test_what_is_missed_after_a_period_has_three_causes(extended, roundoff):
    q, w = mismatch(evidence() if extended else evidence(extended_precision=None))
    assert (q.name, q.unit, q.turns, w.turns) == ("q", "rad", 2, 0)
    assert (q.first, q.last, q.total, q.period, q.roundoff) == pytest.approx((0.1, 0.12, 0.02, 0.015, roundoff), abs=1e-12)
    assert q.scheme == pytest.approx(0.005 - roundoff, abs=1e-12)
    assert (w.first, w.last, w.total, w.period, w.roundoff, w.scheme) == pytest.approx((5.0, 5.3, 0.3, 0.1, 0.0, 0.2))


@pytest.mark.parametrize(("changes", "is_split"), [
    ({}, True), ({"period_row": None}, False), ({"compared": 2}, False),
    ({"motion": SimpleNamespace(**{**vars(evidence().motion), "stop": "dead"})}, False),
])  # fmt: skip
def test_a_run_that_has_not_the_row_of_its_period_is_not_split(changes, is_split):
    assert (mismatch(evidence(**changes)) is not None) is is_split


@pytest.mark.parametrize(("share", "is_told"), [(0.0299, False), (0.0301, True)])
@pytest.mark.parametrize(("name", "unit"), [("u", "m/s"), ("w", "rad/s"), ("h", "")])
def test_a_column_is_not_back_beyond_three_hundredths_of_its_scale(share, is_told, name, unit, monkeypatch):
    monkeypatch.setattr(period, "followed", lambda _: ("u",))
    told = []
    given = SimpleNamespace(
        variant=SimpleNamespace(columns=("w", "u")),
        unit={"w": "rad/s"}.get,
        period=2.0,
        say=lambda key, **values: told.append(values) or key,
    )
    found = _not_back(given, name, share, 1.0, 1.5)
    assert (found is not None) is is_told
    if found is not None:
        assert (found.verdict, found.value, found.column, found.first, found.last) == ("FAIL", share, name, 1.0, 1.5)
        assert (told[0]["unit"], told[0]["name"], told[0]["first"], told[0]["last"], told[0]["period"]) == (
            unit,
            name,
            1.0,
            1.5,
            2.0,
        )


@pytest.mark.parametrize(("last", "told"), [((1.0, 5.0), ("g", 2 / 3)), ((9.0, 3.2), ("f", 9 / 8)), ((np.nan, 3.0), None)])
def test_of_several_laws_the_one_that_is_farthest_from_its_start_is_told(last, told, monkeypatch):
    """f goes from 0 to 8, g from 3 to 6, e stands; h is a table, which is not asked."""
    laws = [SimpleNamespace(name=name, table=name == "h") for name in "fghe"]
    values = np.array([[0.0, 3.0, 7.0], [8.0, 6.0, 7.0], [*last, 99.0]])
    asked = []
    monkeypatch.setattr(period, "drive_values", lambda _, names, times: asked.append((names, times.tolist())) or values)
    monkeypatch.setattr(period, "_not_back", lambda _, *found: found)
    given = SimpleNamespace(
        variant=SimpleNamespace(drive=laws), equations=None, exact=SimpleNamespace(t=np.array([0.0, 1.0])), period=5.0
    )
    found = _drive_strayed(given)
    assert asked == [(["f", "g", "e"], [0.0, 1.0, 5.0])]
    assert found == (told and (told[0], pytest.approx(told[1]), {"f": 0.0, "g": 3.0}[told[0]], last["fg".index(told[0])]))


@pytest.mark.parametrize(("end", "number"), [(4.0, 3), (1.49, 3), (1.48, 0), (0.1, 0)])
def test_after_the_first_multiple_at_which_every_column_is_back_it_is_back(end, number, monkeypatch):
    """With a period of 1 s q is back after 3, 6 … and w after any: a run is followed to twice its end and a hundredth more."""
    monkeypatch.setattr(period, "after", lambda _, time: None if time == 2.0 else time)
    monkeypatch.setattr(period, "missed", lambda _, row, name: 0.9e-4 if name == "w" or row % 3 == 0 else 1.1e-4)
    given = SimpleNamespace(motion=SimpleNamespace(t=np.array([0.0, end])), period=1.0, names=("q", "w"))
    assert _multiple(given) == number


def wheels(gain, late=1.0, second=None, run=100.0, slide=0.0, crank=2 * math.pi, drives=True):
    """Return a crank q, a wheel p that gains so many turns in one of the crank, and a slide s; a period of 2 s is stated.

    After it the crank has turned `late` times round; the wheel's second period may gain something else.
    """
    names, units = ("q", "p", "s", "w", "v", "u"), dict(zip("qpswvu", ("rad", "rad", "m", "rad/s", "rad/s", "m/s"), strict=True))
    start = np.array([0.3, 0.2, 0.5, 9.0, 4.0, 0.0])

    def row(time):
        turns = late * time / 2
        wheel = gain * turns if second is None or turns <= 1.001 * late else gain * late + second * (turns - late)
        return start + np.array([crank * turns, 2 * math.pi * wheel, slide * turns, 0.0, 0.0, 0.0])

    exact = SimpleNamespace(
        rows=np.array([start]), coordinate_names=names[:3], names=names, column=lambda name: start[[names.index(name)]]
    )
    coordinates = [SimpleNamespace(name=name, unit=units[name], rate=rate) for name, rate in zip("qps", "wvu", strict=True)]
    variant = SimpleNamespace(driven_coordinates=coordinates[:1] if drives else [], known_rates=("w",), coordinates=coordinates)
    return SimpleNamespace(
        exact=exact, variant=variant, period=2.0, scale=dict.fromkeys(names, 1.0), unit=units.get, names=names, row=row,
        motion=SimpleNamespace(t=np.array([0.0, run])), least=lambda name: 1e-10,
    )  # fmt: skip


@pytest.mark.parametrize(("given", "back"), [
    ({"gain": 0.5}, (2, 4.0)), ({"gain": 1 / 3}, (3, 6.0)), ({"gain": -0.4}, (5, 10.0)), ({"gain": 1.0}, None),
    ({"gain": 2.0}, None),
    ({"gain": 1 / 99}, (99, 198.0)), ({"gain": 2**-0.5}, (None, math.inf)), ({"gain": 0.5, "late": 1.004}, (2, 4 / 1.004)),
    ({"gain": 0.5, "late": 1.02}, None), ({"gain": 0.5, "second": 0.52}, None), ({"gain": 0.5, "slide": 0.1}, None),
    ({"gain": 0.5, "drives": False}, None), ({"gain": 0.5, "crank": 0.0}, (2, 4.0)),
])  # fmt: skip
def test_a_wheel_that_is_not_back_with_its_crank_is_back_later(given, back, monkeypatch):
    """At 1/3 of a turn a period it is back after three; its crank's own turn, not the digits of the stated period, counts."""
    monkeypatch.setattr(several_periods, "after", lambda evidence, time: evidence.row(time))
    found = several_periods._later(wheels(**given))
    assert (found and (found.periods, found.time)) == (back and (back[0], pytest.approx(back[1])))


def test_what_hangs_on_a_wheel_or_does_not_keep_its_speed_is_no_wheel(monkeypatch):
    """A wheel whose speed is not back, or whose turns differ from period to period, says nothing of when the mechanism is."""
    monkeypatch.setattr(several_periods, "after", lambda evidence, time: evidence.row(time) + np.array([0, 0, 0, 0, 0.031, 0]))
    assert several_periods._later(wheels(0.5)) is None
    monkeypatch.setattr(several_periods, "after", lambda evidence, time: evidence.row(time) + np.array([0, 0, 0, 0, 0.029, 0]))
    assert several_periods._later(wheels(0.5)).periods == 2


@pytest.mark.parametrize(("run", "is_back"), [(2.0, False), (1.99, True)])
def test_behind_twice_the_run_whole_turns_are_enough(run, is_back, monkeypatch):
    monkeypatch.setattr(several_periods, "after", lambda evidence, time: evidence.row(time) + 0.1)
    assert several_periods._is_back(wheels(0.5, run=run), 4.0) is is_back


@pytest.mark.parametrize(("size", "share"), [(0.9e-10, 0.0), (-1.1e-10, 0.55e-10), (-3.0, 1.5)])
def test_what_is_missed_by_round_off_is_not_missed(size, share):
    assert several_periods.share_of(size, 2.0, 1e-10) == pytest.approx(share)


def test_whole_turns_of_an_angle_are_taken_off_and_those_of_a_length_are_not():
    row = np.array([0.4 + 6 * math.pi, 0.2, 0.5 + 2 * math.pi, 9.0, 4.0, 0.0])
    assert several_periods.ends(wheels(0.5), row, "q") == pytest.approx((0.3, 0.4))
    assert several_periods.ends(wheels(0.5), row, "s") == pytest.approx((0.5, 0.5 + 2 * math.pi))
