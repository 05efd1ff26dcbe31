"""The limits of the search for singular positions, each on both sides."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.motion.singular import change_point, passing, walk
from coursework.motion.singular.event import GivenUp
from coursework.motion.singular.explain import _away, _tidied_rates
from coursework.motion.singular.peaks import Peaks, _highest
from coursework.motion.singular.search import Search, is_back
from coursework.motion.singular.walk import Walk


def coordinates(*units):
    """Return what stands for the equations of coordinates with these units."""
    named = [SimpleNamespace(name=f"q{place}", unit=unit, start_or_guess=None) for place, unit in enumerate(units)]
    return SimpleNamespace(variant=SimpleNamespace(coordinates=named, given=()))


@pytest.mark.parametrize(("off", "back"), [(0.9e-8, True), (1.2e-8, False)])
def test_what_is_back(off, back):
    flow = SimpleNamespace(equations=coordinates("rad", "m"), units=np.ones(2))
    assert is_back(flow, np.array([1 + 6 * math.pi + off, 2.0]), [1.0, 2.0]) is back
    assert is_back(flow, np.array([1.0, 2.0 - off]), [1.0, 2.0]) is back
    assert not is_back(flow, np.array([1.0, 2.0 + 2 * math.pi]), [1.0, 2.0])


def test_the_longest_step_is_told_to_half_a_percent():
    search = SimpleNamespace(way_within=lambda coordinate: lambda step: step)
    assert 0.995 * 0.4999 < Search.longest_step(search, 0, 0.4999, 1.0) <= 0.4999


@pytest.mark.parametrize(("least", "when"), [(1 - 0.9e-9, None), (1 - 1.2e-9, 0.3)])
def test_a_rate_that_hardly_changes_is_constant(least, when):
    assert Peaks([1.0], [least], [0.3], [()]).found(1.0, ()) == ((1.0, when),)


@pytest.mark.parametrize(("second", "sought"), [(0.96, [0, 1]), (0.94, [0])])
def test_rates_near_the_largest_are_sought_between_the_steps(second, sought, monkeypatch):
    looked = []
    monkeypatch.setattr(Peaks, "_inside", lambda self, coordinate, end: looked.append(coordinate) or [])
    Peaks([1.0, second], [0.0, 0.0], [0.1, 0.2], [(), ()]).found(1.0, [0, 1])
    assert looked == sought


@pytest.mark.parametrize(("top", "step"), [(0.0008, "after"), (-0.0008, "before")])
def test_a_peak_just_beside_a_step_of_the_walk_is_sought_on_its_side(top, step):
    before, after = SimpleNamespace(), SimpleNamespace(rate=lambda part, coordinate: (1 - (part - top) ** 2, part))
    found = Peaks([1 - top**2], [0.0], [0.0], [(before, after)])._rising(0)
    assert found == [{"before": before, "after": after}[step]]


def test_a_peak_is_found_to_a_ten_thousandth_of_its_step_in_21_looks():
    looked = []
    piece = SimpleNamespace(rate=lambda part, coordinate: looked.append(part) or (1 - (part - 0.3) ** 2, part))
    assert _highest(piece, 0, 1.0)[1] == pytest.approx(0.3, abs=1e-4)
    assert len(looked) == 21


@pytest.mark.parametrize(("errors", "tries"), [
    ((0.0, 0.0, 0.0), 1), ((0.9e-9, 1.9e-9, 0.9e-9), 1), ((1.2e-9, 0.0, 0.0), 2), ((0.0, 2.2e-9, 0.0), 2),
    ((0.0, 0.0, 1.2e-9), 2), ((-1.2e-9, 0.0, 0.0), 2), ((0.0, math.nan, 0.0), 2),
])  # fmt: skip
def test_a_step_of_the_walk_is_shortened_where_one_coordinate_or_the_time_is_off(errors, tries):
    """By more than the tolerance of 1 + |q|; the second step, a shorter one, has no error."""
    lengths = []

    def step(state, slope, length):
        lengths.append(length)
        return state + length * slope, [0.0] * 3 if len(lengths) > 1 else list(errors)

    clock = SimpleNamespace(slope=lambda state: np.ones(3), step=step)
    stand = SimpleNamespace(
        state=np.array([0.0, 1.0, 0.0]),
        tolerance=1e-9,
        end=1.0,
        cells=[0.0, 1.0],
        length=0.1,
        peaks=Peaks.of(2),
        flow=SimpleNamespace(units=np.ones(2)),
    )
    reach = Walk._step(stand, clock)[1]
    assert len(lengths) == tries
    assert reach == lengths[-1] <= lengths[0] == 0.1


@pytest.mark.parametrize(("slope", "looked_at"), [(0.9e-3, False), (1.2e-3, True)])
def test_a_determinant_that_hardly_grows_is_not_seen_to_change_its_sign(slope, looked_at, monkeypatch):
    assert bool(flanks_tried(slope, 1.0, monkeypatch)) is looked_at


@pytest.mark.parametrize(("end", "tries"), [(1.0, 5), (40.0, 2), (0.02, 8)])
def test_flanks_come_nearer_down_to_a_hundred_thousandth_of_the_run(end, tries, monkeypatch):
    tried = flanks_tried(2.0, end, monkeypatch)
    assert tried == pytest.approx([5e-3 / 4**further for further in range(tries)])
    assert tried[-1] > 1e-5 * end > tried[-1] / 4


def flanks_tried(slope, end, monkeypatch):
    tried = []
    middle = SimpleNamespace(velocities={})
    equations = SimpleNamespace(variant=SimpleNamespace(rates=()))
    system = SimpleNamespace(unknowns=("u",), known=())
    flow = SimpleNamespace(equations=equations, system=system, rates=(), scaled=lambda t, q: [slope * (t - 0.5)])
    event = SimpleNamespace(kind="change point", together=(0,), block=0, time=0.5, position=np.zeros(1))
    monkeypatch.setattr(passing, "_by_closure", lambda flow, event, end: event)
    monkeypatch.setattr(passing, "branches_at", lambda *_: ({"u": 1.0},))
    monkeypatch.setattr(passing, "_state", lambda *_: middle)
    monkeypatch.setattr(passing, "_flanked", lambda flow, middle, moving, way, flank, *_: tried.append(flank))
    assert passing.passage_at(flow, event, [], end, (0.0, end)) is None
    return tried


@pytest.mark.parametrize(("size", "singular"), [(0.9e-10, True), (-0.9e-10, True), (1.2e-10, False)])
def test_a_start_that_is_singular(size, singular):
    stand = SimpleNamespace(scaled=[1.0, size], state="start", _event=lambda state, block: (state, block))
    assert Walk.at_start(stand) == (("start", 1) if singular else None)


@pytest.mark.parametrize(("size", "stalled"), [(0.9e-10, True), (1.2e-10, False)])
def test_a_flow_that_stalls(size, stalled, monkeypatch):
    dead = SimpleNamespace(kind="dead point")
    stand = SimpleNamespace(flow=None, end=1.0, scaled=[size], tried=1e-10, state="here", _event=lambda state, block: dead)
    monkeypatch.setattr(walk, "ahead", lambda flow, state, block, end, within=None: state)
    assert Walk._at_rest(stand, 0) is (dead if stalled else None)


@pytest.mark.parametrize(("size", "together"), [(0.9e-6, (0, 1)), (1.2e-6, (1,))])
def test_determinants_that_vanish_together(size, together):
    flow = SimpleNamespace(scaled=lambda t, q: [size, 0.5], demand=lambda t, q, block: 0.0)
    event = Walk._named(SimpleNamespace(flow=flow, end=1.0), "dead point", 0.5, np.zeros(1), 1)
    assert event.together == together


@pytest.mark.parametrize("end", [0.02, 1.0, 40.0])
@pytest.mark.parametrize(("time", "told"), [(1.2e-13, 1.2e-13), (0.9e-13, 0.0)])
def test_a_start_that_is_singular_is_so_at_once(time, told, end):
    flow = SimpleNamespace(scaled=lambda t, q: [0.0], demand=lambda t, q, block: 0.0)
    assert Walk._named(SimpleNamespace(flow=flow, end=end), "dead point", time * end, np.zeros(1), 0).time == told * end


@pytest.mark.parametrize(("miss", "tolerance", "found"), [
    (0.9e-9, 1e-13, True), (1.2e-9, 1e-13, False), (0.9e-6, 1e-9, True), (1.2e-6, 1e-9, False),
])  # fmt: skip
def test_a_change_point_may_be_missed_by_so_much(miss, tolerance, found, monkeypatch):
    looked = []
    crossing = 0.5, np.zeros(1), miss
    monkeypatch.setattr(change_point, "nearest_change_point", lambda *values: looked.append(values[-1]) or crossing)
    flow = SimpleNamespace(slopes=lambda t, q, block: [1.0, 1.0])
    stand = SimpleNamespace(
        flow=flow, tolerance=tolerance, near=100 * tolerance**0.5, _determinants=lambda state: [0.0], _named=lambda kind, *_: kind
    )
    assert Walk._change_point(stand, np.zeros(2), 0) == ("change point" if found else None)
    assert looked == [max(0.01, 100 * tolerance**0.5)]


@pytest.mark.parametrize(("slide", "away"), [(1.2e4, ("q1",)), (0.9e4, ())])
def test_a_slide_that_has_left_every_guide(slide, away):
    assert _away({"q0": 1e9, "q1": slide}, coordinates("rad", "m")) == away


ENDED = RuntimeError("the walk has come so far")


def on_the_way(**more):
    """Return what stands for a walk to t = 1 s whose one step leads to `more["state"]`, where it ends."""
    steps = iter([(more.pop("after"), 0.1, 0.2), None])
    found = more.pop("event", None)
    stand = SimpleNamespace(
        scaled=[1.0], length=0.1, taken=0, end=1.0, way=[np.zeros(2)], near=0.0, slope=np.ones(2),
        flow=SimpleNamespace(clock=lambda block, side: None, units=np.ones(1)), _step=lambda clock: next(steps),
        _determinants=lambda state: [1.0], _inside=lambda *_: (found, 0.0), _pass=lambda *_: False,
        _arrive=lambda *_: stand.__dict__.update(arrived=True), _boundless=lambda state: ENDED, arrived=False,
    )  # fmt: skip
    stand.__dict__.update(more)
    return stand


@pytest.mark.parametrize(("since", "count", "stalls"), [(0.9e-11, 101, True), (1.2e-11, 101, False), (0.9e-11, 100, False)])
def test_time_that_stands_still_for_a_hundred_steps(since, count, stalls):
    stand = on_the_way(after=np.array([0.0, 0.5]), way=[np.array([0.0, 0.5 * (1 - since)])] * count)
    if stalls:
        with pytest.raises(RuntimeError, match="so far"):
            Walk._until(stand, 1.0)
    else:
        assert Walk._until(stand, 1.0) is None


@pytest.mark.parametrize(("size", "told"), [(1.2e-6, True), (0.9e-6, False)])
@pytest.mark.parametrize(("far", "boundless"), [(0.9e9, False), (1.2e9, True)])
def test_a_coordinate_that_has_no_end_is_told_where_no_determinant_vanishes(far, boundless, size, told):
    stand = on_the_way(after=np.array([far, 0.5]), _determinants=lambda state: [size])
    if boundless and told:
        with pytest.raises(RuntimeError, match="so far"):
            Walk._until(stand, 1.0)
    else:
        assert Walk._until(stand, 1.0) is None


@pytest.mark.parametrize(("time", "goal", "counts"), [
    (1 + 0.9e-9, 1.0, True), (1 + 1.2e-9, 1.0, False), (0.8 + 1e-12, 0.8, False), (0.8 - 1e-12, 0.8, True),
])  # fmt: skip
def test_an_event_counts_up_to_the_end(time, goal, counts):
    """Just behind the end of the run it is at the end; behind a break of the drive its formula is another."""
    event = SimpleNamespace(time=time)
    stand = on_the_way(after=np.array([0.0, 0.5]), event=event)
    assert Walk._until(stand, goal) is (event if counts else None)


@pytest.mark.parametrize(("before", "arrives"), [(0.9e-12, True), (1.2e-12, False)])
def test_just_before_a_break_of_the_drive_its_old_formula_is_left(before, arrives):
    stand = on_the_way(after=np.array([0.0, 0.8 - before]))
    Walk._until(stand, 0.8)
    assert stand.arrived is arrives


@pytest.mark.parametrize(("taken", "steps"), [(14_999, 1), (15_000, 0)])
def test_a_walk_is_given_up_after_so_many_steps(taken, steps):
    stand = on_the_way(after=np.array([0.0, 0.5]), taken=taken, state=np.zeros(2))
    with pytest.raises(GivenUp) as told:
        Walk._until(stand, 1.0)
    assert told.value.time == 0.5 * steps


@pytest.mark.parametrize(("sizes", "looked_into"), [((0.09, 0.5), True), ((0.5, 0.09), True), ((0.12, 0.12), False)])
def test_a_step_beside_a_small_determinant_is_looked_into(sizes, looked_into):
    looked = []
    stand = SimpleNamespace(scaled=[sizes[0]], _lowest=lambda *_: looked.append(1) or 0.0)
    assert Walk._inside(stand, None, 0.1, None, [sizes[1]], 0, False) == (None, 0.0)
    assert bool(looked) is looked_into


@pytest.mark.parametrize(("smallest", "told"), [
    (0.9e-12, ("event", 0.03)), (1.2e-12, ("change point", 0.0)), (0.9e-3, ("change point", 0.0)), (1.2e-3, (None, 0.0)),
])  # fmt: skip
def test_what_a_smallest_determinant_inside_a_step_is(smallest, told):
    stand = SimpleNamespace(
        scaled=[-0.05], near=1e-3, _lowest=lambda *_: 0.05, _reached=lambda clock, part: "bottom",
        _determinants=lambda state: [-smallest], _root=lambda *_: ("root", 0.03), _event=lambda state, block: "event",
        _change_point=lambda state, block: "change point",
    )  # fmt: skip
    assert Walk._inside(stand, None, 0.1, None, [-0.05], 0, False) == told


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "closes"), [(0.98e-5, True), (-0.98e-5, True), (1.02e-5, False), (-1.02e-5, False)])
def test_a_motion_opens_no_equation_faster_than_a_share_of_its_size(size, part, closes, monkeypatch):
    """Of u = 1 and u = 1 + 2 part, both multiplied by a size, the best u misses each by part."""
    matrix, right = np.array([[size], [size]]), size * np.array([1.0, 1.0 + 2 * part])
    monkeypatch.setattr(change_point, "compile_system", lambda *_: SimpleNamespace(matrix=lambda *_: (matrix, right, None)))
    flow = SimpleNamespace(
        equations=SimpleNamespace(equations=(), from_closure=("1",)), system=SimpleNamespace(unknowns=("u",)), unknown_units=1.0
    )
    found = change_point._by_positions(flow, 0.0, np.zeros(1))
    assert found == (({"u": pytest.approx(1.0 + part)},) if closes else ())


@pytest.mark.parametrize("size", [0.004, 250.0])
@pytest.mark.parametrize(("part", "told"), [(0.98e-9, 0.0), (-0.98e-9, 0.0), (1.02e-9, 1.02e-9), (-1.02e-9, -1.02e-9)])
def test_round_off_beside_the_fastest_is_not_told(size, part, told):
    assert _tidied_rates({"w1": -size, "w2": part * size}) == {"w1": -size, "w2": pytest.approx(told * size)}
