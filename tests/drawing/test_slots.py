"""The line of a slot as it is drawn: through its point or beside it, and how far it reaches."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from coursework.drawing.paper.painter import Painter


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
