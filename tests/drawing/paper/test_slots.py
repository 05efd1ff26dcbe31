"""The line of a slot, the hatching of ground and the corner of a bent link as they are drawn: where, how far, to which side."""

from __future__ import annotations

import cmath
import math
import re
from types import SimpleNamespace
from typing import Any

import pytest

from coursework.drawing.paper.painter import Painter
from coursework.drawing.paper.sheet import Sheet


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize(("beside", "corners", "along"), [
    (0.0, "", (-60, 170)), (2.2e-8, "", (-60, 170)), (-2.2e-8, "", (-60, 170)),
    (2.4e-8, "", (-60, 50, 50, 50, 170)), (-2.4e-8, "", (-60, 50, 50, 50, 170)),
    (0.0, "B", (-60, 70)), (0.0, "BC", (-60, 70)), (0.0, "C", (-60, 170)), (0.0, "D", (40, 170)),
])  # fmt: skip
def test_a_slot_is_one_line_if_it_runs_through_its_point_at_any_size(
    size: float, beside: float, corners: str, along: tuple[float, ...]
) -> None:
    """The rider goes from 1 to 2 sizes to each side, its slot 10 sizes on unless the link ends there: 23 sizes, 10 mm each."""
    place = {"A": 0j, "B": 2 * size + 0j, "C": 1.9 * size + 0j, "D": -1 * size + 0j}
    one: Any = SimpleNamespace(
        poses=SimpleNamespace(line=lambda _: (beside * size, -size, 2 * size), along=lambda *_: [1 + 0j]), row=0, place=place,
        outline=SimpleNamespace(bars=(SimpleNamespace(link="1", corners=("A", *corners)),)), mm=1 / size,
        put=lambda where: 50 + 10 * where / size,
    )  # fmt: skip
    line = Painter.slot_line(one, SimpleNamespace(link="1", at="A", base="A", toward="B"))  # type: ignore[arg-type]
    assert [end.real for end in line] == pytest.approx(along)


@pytest.mark.parametrize("length", [0.5, 1.6, 2.3, 2.5, 16.0, 20.0])
@pytest.mark.parametrize("way", [1 + 0j, -1j, 0.6 + 0.8j])
def test_hatching_stands_on_its_line_at_even_gaps_and_leans_to_its_side(way: complex, length: float) -> None:
    """A stroke every 1.6 mm, the first half a gap from the end, as far along as across: 1.3 mm backwards, 1.3 to the side."""
    for side in (1j, -1j, 3j):
        sheet = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0))
        begin = 40 + 30j
        sheet.hatch(begin, begin + way * length, side * way)
        feet = [((p - begin) / way, (q - p) / way) for p, q in sheet.segments]
        assert len(feet) == max(1, round(length / 1.6))
        gap = length / len(feet)
        for place, (foot, stroke) in enumerate(feet):
            assert foot == pytest.approx((place + 0.5) * gap)
            assert stroke == pytest.approx(1.3 * (-1 + side / abs(side)))
        drawn = [float(one) for one in re.findall(r"-?\d*\.?\d+", re.findall(r' d="m([^"]*)"', sheet.items[-1])[0])]
        assert complex(*drawn[:2]) == pytest.approx(begin + way * gap / 2, abs=0.01)
        assert complex(*drawn[2:4]) == pytest.approx(1.3 * (side / abs(side) - 1) * way, abs=0.01)


def test_hatching_leaves_out_what_would_leave_the_field() -> None:
    sheet = Sheet(100.0, 80.0, (0.0, 0.0, 41.0, 80.0))
    sheet.hatch(39 + 30j, 55 + 30j, 1j)
    assert [p.real for p, _ in sheet.segments] == pytest.approx([39.8, 41.4])  # a stroke that only leans into it is kept


@pytest.mark.parametrize(("bend", "is_filled"), [(0, False), (2.8, False), (-2.9, True), (20, True), (90, True), (177.2, False)])
@pytest.mark.parametrize("first", [3 + 4j, 20 + 0j])
def test_a_link_is_filled_where_it_is_bent(first: complex, bend: float, is_filled: bool) -> None:
    """More than 0.05 = sin 2.87 degrees from straight it is bent; 5 mm of each arm are filled, of a shorter one all, 3 mm."""
    sheet, at, ways = Sheet(100.0, 80.0, (0.0, 0.0, 100.0, 80.0)), 50 + 40j, (-first, first * cmath.exp(1j * math.radians(bend)))
    places = {"A": at + ways[0], "B": at, "C": at + 3 * ways[1] / abs(first)}
    Painter.corner(SimpleNamespace(at=places, sheet=sheet), "A", "B", "C")  # type: ignore[arg-type]
    assert bool(sheet.items) is is_filled
    corner, *tips = dict.fromkeys(end for line in sheet.segments for end in line) if is_filled else (at,)
    assert corner == at
    assert tips == pytest.approx([at + 5 * ways[0] / abs(first), at + 3 * ways[1] / abs(first)][: 2 * is_filled])
