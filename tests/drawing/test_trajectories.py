"""Twelve positions, trajectories and hodographs: what is drawn lies where the exact motion has it; no word on a word."""

from __future__ import annotations

import re
from functools import cache
from types import SimpleNamespace
from xml.etree import ElementTree

import numpy as np
import pytest

from coursework import solve
from coursework.drawing import trajectories
from coursework.drawing.outline.poses import read_poses
from coursework.drawing.paper.record import Drawing
from coursework.run import Run
from coursework.scene.way_to_motion import PLACES
from coursework.variant.catalogue import names
from tests.drawing import measured
from tests.sample import sampled
from tests.solved import solved


@cache
def run_of(name: str) -> Run:
    return solved(name, quantities=["table", "trajectories", "hodographs"])


def drawings_of(name: str) -> dict[str, Drawing]:
    return {drawing.id: drawing for group in run_of(name).figures().values() for drawing in group}


def path(svg: str, key: str, value: str) -> np.ndarray:
    """Return the points of a curve (mm, y down)."""
    found = [node for node in ElementTree.fromstring(svg).iter() if node.get(key) == value]
    assert len(found) == 1
    return np.array(measured.points(found[0].get("d", "")))


@pytest.mark.long
@pytest.mark.parametrize("name", sampled(names()))
def test_no_word_lies_on_another(name: str) -> None:
    drawings = drawings_of(name)
    assert "positions" in drawings
    assert any(key.startswith("hodograph-") for key in drawings)
    for drawing in drawings.values():
        assert measured.overlaps(drawing.svg) == [], drawing.id
        assert measured.beyond(drawing.svg) == [], drawing.id
        assert drawing.width <= 170
        assert drawing.height <= 100


def test_the_trajectory_of_a_crank_pin_is_its_circle() -> None:
    """Example 2: crank of 0.4 m about A = (0, 0), connecting rod of 1.2 m; C keeps to the line of A."""
    drawing = drawings_of("example-2")["positions"]
    scale = float(re.search(r"scale 1:(\d+)", drawing.caption)[1])  # type: ignore[index]
    pin, slider = (path(drawing.svg, "data-trajectory", name) for name in "BC")
    centre = (pin[0] + pin[60]) / 2  # half a turn apart
    assert np.abs(pin - centre) == pytest.approx(400 / scale, abs=0.05)
    assert slider.imag == pytest.approx(centre.imag, abs=0.05)
    assert np.ptp(slider.real) == pytest.approx(800 / scale, abs=0.05)
    said = {word.text for word in measured.words(drawing.svg)}
    assert {str(place) for place in range(2, 13)} <= said
    apart = float(re.search(r"positions ([\d.]+) s apart", drawing.caption)[1])  # type: ignore[index]
    assert 12 * apart == pytest.approx(run_of("example-2").variant.time.period, rel=1e-3)


def test_the_hodograph_of_a_crank_pin_is_a_circle_and_its_rows_lie_on_it() -> None:
    """Example 4: V_B = 10 rad/s · 0.4 m = 4 m/s at every row, at right angles to the crank."""
    drawing = drawings_of("example-4")["hodograph-B"]
    speed = float(re.search(r"1 mm is ([\d.]+) m/s", drawing.caption)[1])  # type: ignore[index]
    curve = path(drawing.svg, "data-hodograph", "B")
    middle = (curve[0] + curve[60]) / 2
    assert np.abs(curve - middle) == pytest.approx(4 / speed, abs=0.05)
    (first,) = measured.lines(drawing.svg, "data-velocity")
    assert first.a == pytest.approx(middle, abs=0.05)
    assert (first.b - first.a).real == pytest.approx(0, abs=0.05)
    assert (curve[0] - middle) / (first.b - first.a) == pytest.approx(1 + 2.6 / abs(first.b - first.a), abs=0.01)  # with its head
    tips = [complex(*map(float, place.split())) for place in measured.names(drawing.svg, "data-tip")]
    assert len(tips) in {36, 37}
    assert np.abs(np.array(tips) - middle) == pytest.approx(4 / speed, abs=0.05)


def test_only_a_drawing_with_a_scale_to_measure_by_keeps_its_size_on_paper() -> None:
    assert [drawing.exact for drawing in drawings_of("example-4").values()] == [False] * len(drawings_of("example-4"))


def test_what_is_not_asked_for_is_not_drawn() -> None:
    run = solve("31", quantities=["table"])
    assert run.figures() == {}
    assert "one_period" not in run.scene.ledger.calls


def test_a_motion_that_stops_is_followed_as_far_as_it_goes() -> None:
    from coursework import load

    run = solve(load("31").with_data(given={"alpha": 0.02}), quantities=["trajectories"])
    ((drawing,),) = run.figures().values()
    assert run.scene.one_period.t == pytest.approx(run.exact.t[-1] * np.linspace(0, 1, 12 * PLACES + 1))
    assert measured.overlaps(drawing.svg) == []


@pytest.mark.parametrize("fastest", [0.004, 250.0])
@pytest.mark.parametrize(("count", "off", "even", "pace"), [(13, 0.98e-9, True, 1), (14, 1.02e-9, False, 2), (27, 0.0, True, 5)])
def test_up_to_13_rows_are_numbered_and_a_velocity_that_changes_by_round_off_is_even(fastest, count, off, even, pace):
    rows = fastest * np.exp(1j * np.arange(count) / 5)
    rows[3] *= 1 - off
    found = trajectories._hodograph("B", rows, rows, np.arange(float(count)))
    assert (found.caption.key == "drawing.hodograph.even") is even
    words = {word.text for word in measured.words(found.svg)}
    assert {word for word in words if word.isdecimal()} == {str(row) for row in range(1, count + 1, pace)}


@pytest.mark.parametrize("fastest", [0.004, 250.0])
def test_a_point_at_rest_but_for_round_off_has_no_hodograph(fastest, monkeypatch):
    outline = SimpleNamespace(names=("A", "B", "C", "P"), wheels=[SimpleNamespace(contact="P")])
    moving = {
        name: fastest * part * np.exp(1j * np.arange(3)) for name, part in (("A", 0.98e-9), ("B", 1.02e-9), ("C", 1), ("P", 1))
    }
    monkeypatch.setattr(trajectories, "read_outline", lambda _: outline)
    monkeypatch.setattr(trajectories, "_velocities", lambda *_: moving)
    motion = SimpleNamespace(t=np.arange(3.0))
    assert [one.id for one in trajectories.draw_hodographs(None, None, motion, motion)] == ["hodograph-B", "hodograph-C"]


@pytest.mark.parametrize("scale", [0.01, 100.0])
@pytest.mark.parametrize(("part", "moves"), [(0.98e-9, False), (1.02e-9, True)])
def test_a_point_at_rest_but_for_round_off_has_no_trajectory(scale, part, moves, monkeypatch):
    """Example 2 in another size, with a slider that moves by a share of the largest distance of two points at the start."""
    scene = run_of("example-2").scene

    def poses_of(*given):
        def read(*rows):
            poses = read_poses(*given)(*rows)
            poses.at.update({name: scale * places for name, places in poses.at.items()})
            here = [places[0] for places in poses.at.values()]
            largest = max(abs(one - other) for one in here for other in here)
            poses.at["C"] = poses.at["C"][0] + part * largest * np.linspace(0, 1, len(rows[0]))
            return poses

        return read

    monkeypatch.setattr(trajectories, "read_poses", poses_of)
    drawn = trajectories.draw_positions(scene.mechanism, scene.equations, scene.one_period)
    assert measured.names(drawn.svg, "data-trajectory") == ({"B", "C"} if moves else {"B"})
