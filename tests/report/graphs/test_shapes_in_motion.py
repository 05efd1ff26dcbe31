"""Every line of the moving picture lies where the pose of its frame says: links, slides, blocks, wheels, the ground."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.poses import Poses, read_poses
from coursework.drawing.outline.tracing import read_outline
from coursework.report.graphs.moving_picture import Shape, draw_ground
from tests.drawing.outline.test_mechanism import run_of

SIZE, FRAME = 0.5, 2
BLOCK, BESIDE, STROKE = 0.03 * SIZE, 0.018 * SIZE, 0.016 * SIZE  # m: half a block along and across its guide, a stroke of ground
Lines = list[Any]


def drawn(name: str) -> tuple[Outline, Poses, Lines, Lines]:
    """Return what is drawn of a mechanism in one frame, its still and its moving lines as complex numbers (m)."""
    run = run_of(name)
    outline = read_outline(run.scene.mechanism)
    assert outline is not None
    poses = read_poses(outline, run.scene.equations)(run.exact.t, run.exact.coordinates)
    field = Figure().add_subplot()
    draw_ground(field, outline, (poses, poses), SIZE)
    count = len(field.lines)
    Shape(field, outline, poses, SIZE).show(FRAME, dashed=False)
    lines = [np.asarray(line.get_xdata()) + 1j * np.asarray(line.get_ydata()) for line in field.lines]
    return outline, poses, lines[:count], lines[count:]


@pytest.mark.parametrize("name", ["31", "v107", "cardan", "example-1", "epicyclic", "walschaerts"])
def test_what_moves_is_drawn_where_it_is(name: str) -> None:
    outline, poses, _, moving = drawn(name)
    pose, left = poses.pose(FRAME), iter(moving)
    for bar in outline.bars:
        assert next(left).tolist() == [pose[corner] for corner in bar.corners]
    for slot in outline.slots:
        begin, end = next(left)
        for rider in slot.riders:  # they slide between the ends, on the line
            share = (pose[rider] - begin) / (end - begin)
            assert -1e-6 < share.real < 1 + 1e-6 and abs(share.imag) < 1e-6
    blocks = list(left)[: len(outline.blocks) + len(outline.wheels)]
    for block, line in zip(outline.blocks, blocks, strict=False):
        way = pose[block.toward] - pose[block.base]
        corners = (line[~np.isnan(line)] - pose[block.at]) * way.conjugate() / abs(way)
        assert sorted({(round(at.real, 9), round(at.imag, 9)) for at in corners.tolist()}) == [
            (along, across) for along in (-BLOCK, BLOCK) for across in (-BESIDE, BESIDE)
        ]
        sides = [abs(b - a) for a, b in pairwise(line) if not np.isnan(b - a)]
        assert sides.count(pytest.approx(2 * BLOCK)) == 2 and len(sides) == (
            2 if block.open else 4
        )  # a sleeve is open at its ends
    for wheel, line in zip(outline.wheels, blocks[len(outline.blocks) :], strict=True):
        assert np.abs(line - pose[wheel.centre]) == pytest.approx(abs(pose[wheel.contact] - pose[wheel.centre]))
        assert line[0] == pytest.approx(line[-1]) and len(line) > 40


@pytest.mark.parametrize(("name", "solid"), [("cardan", "outside"), ("epicyclic", "outside"), ("v108", "inside")])
def test_a_fixed_circle_is_hatched_where_no_wheel_rolls(name: str, solid: str) -> None:
    outline, poses, still, _ = drawn(name)
    start = poses.pose(0)
    assert outline.tracks
    for track in outline.tracks:
        radius = abs(start[track.rim] - start[track.centre])
        rings = [line for line in still if len(line) > 40 and np.allclose(np.abs(line - start[track.centre]), radius)]
        strokes = [line for line in still if len(line) == 2 and abs(abs(line[0] - start[track.centre]) - radius) < 1e-9]
        assert len(rings) == 1 and len(strokes) > 8
        assert [abs(b - a) for a, b in strokes] == pytest.approx([STROKE * abs(1 + 0.7j)] * len(strokes))
        beyond = {abs(end - start[track.centre]) > radius for _, end in strokes}
        assert beyond == {solid == "outside"}
        gaps = np.diff(np.sort(np.angle([begin - start[track.centre] for begin, _ in strokes])))
        assert gaps * radius == pytest.approx(np.full(len(gaps), 0.022 * SIZE), rel=0.1)  # all around, evenly


@pytest.mark.parametrize("name", ["31", "v107", "example-1"])
def test_a_rail_is_as_long_as_its_slider_goes_and_hatched_on_one_side(name: str) -> None:
    outline, poses, still, _ = drawn(name)
    for rail in (rail for rail in outline.rails if rail.rider and not rail.rolls):
        way = poses.at[rail.toward][0] - poses.at[rail.base][0]
        way /= abs(way)
        places = (poses.at[rail.rider] - poses.at[rail.rider][0]) * way.conjugate()
        beside = [(line - poses.at[rail.rider][0]) * way.conjugate() for line in still if len(line) == 2]
        rails = [line for line in beside if abs(abs(line[0].imag) - BESIDE) < 1e-9 and abs(line[0].imag - line[1].imag) < 1e-9]
        assert len(rails) == 1
        (begin, end) = rails[0]
        assert (begin.real, end.real) == pytest.approx((places.real.min() - 0.08 * SIZE, places.real.max() + 0.08 * SIZE))
        strokes = [line for line in beside if line is not rails[0] and abs(line[0].imag - begin.imag) < 1e-9]
        assert len(strokes) == pytest.approx((end.real - begin.real) / (0.022 * SIZE), abs=1.0)
        assert all(abs(line[1].imag) > abs(begin.imag) for line in strokes)  # away from the slider
        assert all(begin.real < line[0].real < end.real for line in strokes)
        assert [abs(b - a) for a, b in strokes] == pytest.approx([STROKE * abs(1 + 0.7j)] * len(strokes))


@pytest.mark.parametrize("name", ["example-1", "v112", "whitworth"])
def test_a_pivot_is_a_triangle_on_a_longer_line_that_is_hatched_beyond(name: str) -> None:
    outline, poses, still, _ = drawn(name)
    for hinge in outline.hinges:
        at = poses.pose(0)[hinge]
        (triangle,) = (line for line in still if len(line) == 4 and np.allclose(line[[0, -1]], at))
        down = (triangle[1] + triangle[2]) / 2 - at
        assert abs(down) == pytest.approx(0.035 * SIZE)
        assert (triangle[1] - triangle[2]) / down == pytest.approx(1.2j)
        base = [(line - at) / down for line in still if len(line) == 2 and abs((line[0] - at) / down - (1 + 0.9j)) < 1e-9]
        assert [line[1] for line in base if abs(line[1].imag + 0.9) < 1e-9] == [pytest.approx(1 - 0.9j)]
        feet = [(line - at) / down for line in still if len(line) == 2 and abs(((line[0] - at) / down).real - 1) < 1e-9]
        strokes = [line for line in feet if line[1].real > 1 + 1e-9 and abs(line[0]) < 3]
        assert len(strokes) == 4 and all(-0.9 < line[0].imag <= 0.9 + 1e-9 for line in strokes)
        assert [abs(b - a) * abs(down) for a, b in strokes] == pytest.approx([STROKE * abs(1 - 0.7j)] * 4)


def test_a_rack_reaches_over_all_its_gear_touches() -> None:
    outline, poses, _, moving = drawn("v112")
    pose, rack = poses.pose(FRAME), max((line for line in moving if len(line) == 5), key=lambda line: abs(line[1] - line[0]))
    along = (rack[1] - rack[0]) / abs(rack[1] - rack[0])
    (gear,) = outline.wheels
    seen = [(at - rack[0]) / along for at in (pose[gear.contact], pose[gear.centre])]
    assert abs(seen[0].imag) < 1e-9 and BLOCK - 1e-9 < seen[0].real < abs(rack[1] - rack[0]) - BLOCK + 1e-9
    deep = [(at - rack[0]) / along for at in rack[2:4]]
    assert [at.real for at in deep] == pytest.approx([abs(rack[1] - rack[0]), 0.0], abs=1e-9)
    assert {round(abs(at.imag), 9) for at in deep} == {round(BESIDE, 9)} and deep[0].imag * seen[1].imag < 0  # away from the gear
