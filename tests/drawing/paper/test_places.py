"""A mechanism read back from its drawing: each part where the table and the scale of the caption say, each on its own ground."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from typing import NamedTuple
from xml.etree import ElementTree

import numpy as np
import pytest

from coursework.drawing.outline.outline import Outline
from coursework.drawing.outline.tracing import read_outline
from coursework.mechanism.mechanism import build
from coursework.variant.catalogue import names
from tests.drawing import measured
from tests.sample import sampled
from tests.solved import solved

NEAR = 0.02  # mm: places are written to a thousandth, steps of a path too


class Drawn(NamedTuple):
    """A drawing with the places of points on it (mm, y down) row by row, by the table and the scale told; it shows one row."""

    svg: str
    outline: Outline
    ways: dict[str, np.ndarray]
    row: int

    def at(self, name: str) -> complex:
        return complex(self.ways[name][self.row])

    def paths(self, look: str) -> list[list[complex]]:
        """Return the corners of the paths that look so."""
        found = [node.attrib for node in ElementTree.fromstring(self.svg).iter(f"{measured.SVG}path")]
        return [measured.points(one["d"]) for one in found if look in " ".join(f"{key}={told}" for key, told in one.items())]


@cache
def drawn(name: str) -> Drawn:
    run = solved(name, quantities=["table", "points"])
    drawing = run.mechanism()
    assert drawing is not None
    outline = read_outline(build(run.variant))
    assert outline is not None
    told = re.search(r"in row (\d+).* scale (\d[\d.]*):(\d+(?:\.\d+)?)", drawing.caption)
    assert told is not None
    row, mm, table = int(told[1]) - 1, 1000 * float(told[2]) / float(told[3]), run.table
    ways = {
        head[:-2]: mm * (table[head] - 1j * table[f"{head[:-2]}.y"]).to_numpy()
        for head in table.columns
        if head.endswith(".x") and f"{head[:-2]}.y" in table
    }
    link = next(line for line in measured.lines(drawing.svg, "data-from") if line.says["data-from"] in ways)
    moved = link.a - complex(ways[link.says["data-from"]][row])
    return Drawn(drawing.svg, outline, {point: way + moved for point, way in ways.items()}, row)


@pytest.mark.parametrize("name", sampled(names()))
def test_links_joints_and_wheels_are_where_the_table_has_them_at_the_scale_that_is_told(name: str) -> None:
    it = drawn(name)
    sides = [line for line in measured.lines(it.svg, "data-link") if "data-from" in line.says]
    assert sides
    for line in sides:
        assert abs(line.a - it.at(line.says["data-from"])) < NEAR and abs(line.b - it.at(line.says["data-to"])) < NEAR
    joints = []
    for node in ElementTree.fromstring(it.svg).iter(f"{measured.SVG}circle"):
        middle, radius = complex(float(node.get("cx", "")), float(node.get("cy", ""))), float(node.get("r", ""))
        joints += [middle] if radius < 1.5 else []
        if link := node.get("data-link"):
            assert [abs(middle - it.at(one.centre)) < NEAR and abs(radius - abs(it.at(one.contact) - middle)) < NEAR
                    for one in it.outline.wheels if one.link == link].count(True) == 1  # fmt: skip
    assert all(min(abs(joint - it.at(point)) for joint in joints) < NEAR for point in it.outline.shown if point in it.ways)


@pytest.mark.parametrize("name", sampled(names()))
def test_a_hinge_stands_on_hatched_ground_that_no_link_hides(name: str) -> None:
    """A triangle 5 mm high and 5.8 mm wide, its tip in the joint; straight down, unless a link goes there."""
    it = drawn(name)
    triangles = [path for path in it.paths("fill=white") if len(path) == 3]

    def nearest(place: complex) -> str:
        return min(it.outline.hinges, key=lambda hinge: abs(it.at(hinge) - place))

    tips = {nearest(path[0]): path for path in triangles}
    assert set(tips) == set(it.outline.hinges)
    grounds = [line for line in measured.lines(it.svg, "x1") if abs(abs(line.b - line.a) - 9.2) < NEAR]
    strokes = [stroke for path in it.paths("stroke-width=0.15") for stroke in zip(path[::2], path[1::2], strict=False)]
    for hinge, (tip, left, right) in tips.items():
        assert abs(tip - it.at(hinge)) < NEAR
        down = (left + right) / 2 - tip
        assert abs(abs(down) - 5.0) < NEAR and abs((left - right) / down - 1.16j * np.sign(((left - right) / down).imag)) < NEAR
        arms = [line.b - line.a if abs(line.a - tip) < NEAR else line.a - line.b
                for line in measured.lines(it.svg, "data-from") if min(abs(line.a - tip), abs(line.b - tip)) < NEAR]  # fmt: skip
        is_hidden = any(arm.imag / abs(arm) > 0.75 for arm in arms)
        assert (abs(down - 5j) < NEAR) is not is_hidden
        (ground,) = (line for line in grounds if abs((line.a + line.b) / 2 - tip - down) < NEAR)
        assert abs(((ground.b - ground.a) / down).real) < NEAR
        beyond = [end - begin for begin, end in strokes
                  if abs((begin - tip) / down - 1) < 0.95 and abs(((begin - tip) / down).real - 1) < NEAR]  # fmt: skip
        assert len(beyond) == 6 and all(((way / down).real > 0) for way in beyond)


@pytest.mark.parametrize("name", sampled(names()))
def test_a_block_lies_in_its_joint_along_its_guide_whose_rail_reaches_beyond_its_travel(name: str) -> None:
    """A block is 8.4 mm long and 4.8 mm high; a rail goes on for at least 5 mm behind the farthest places of its rider."""
    it = drawn(name)
    boxes = [path for path in it.paths("fill=white") if len(path) == 4]
    sides = [[round(abs(b - a), 1) for a, b in pairwise(path)] for path in boxes]
    middles = [sum(path) / 4 for path, side in zip(boxes, sides, strict=True) if side in ([8.4, 4.8, 8.4], [4.8, 8.4, 4.8])]
    for block in it.outline.blocks:
        assert min(abs(it.at(block.at) - middle) for middle in middles) < NEAR
    rails = measured.lines(it.svg, "data-rail")
    for rider in {rail.rider for rail in it.outline.rails if rail.rider in it.ways and not rail.rolls}:
        way = it.ways[rider]
        reach = []
        for line in rails:
            along = (line.b - line.a) / abs(line.b - line.a)
            off = (way - line.a) / along
            reach.append(min(off.real.min(), abs(line.b - line.a) - off.real.max()) if abs(off[it.row].imag) < 2.5 else -np.inf)
        assert max(reach) > 4.9


def test_the_radius_of_a_ring_is_dimensioned_from_its_middle_to_its_rim() -> None:
    """The line begins 1.8 mm from the middle, off its joint, and the head of its arrow, 1.8 mm long, ends at the rim."""
    it = drawn("cardan")
    middle = it.at("O")
    (ring,) = (path for path in it.paths("stroke-width=0.35") if len(path) > 30)
    radius = abs(ring[0] - middle)
    assert max(abs(abs(place - middle) - radius) for place in ring) < 0.1
    (tip,) = (path[0] for path in it.paths("data-dimension") if abs(abs(path[0] - middle) - radius) < 0.1)
    (line,) = (line for line in measured.lines(it.svg, "data-dimension") if abs(line.b - tip) < 2.0)
    out = (tip - middle) / radius
    assert abs(line.a - middle - 1.8 * out) < NEAR and abs(line.b - tip) <= 1.8 + NEAR
