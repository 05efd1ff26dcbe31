"""Tables of a page: whose numbers are set alike, and what the table of a run is called."""

from __future__ import annotations

from itertools import product, zip_longest
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.report.text.numbers import shown_column
from coursework.report.text.tables import largest_of, pieces
from tests.report.made import solved

GRID = SimpleNamespace(
    names=("A.x", "A.y", "A.vx", "B.x", "w1"), units=("m", "m", "m/s", "m", "1/s"),
    rows=np.array([[0.1, -0.5, 7.0, 3.0, 9.0], [0.2, np.nan, -8.0, 2.0, 1.0]]),
)  # fmt: skip


@pytest.mark.parametrize(("index", "largest"), [(0, 3.0), (1, 3.0), (2, 8.0), (3, 3.0), (4, 0.0)])
def test_numbers_of_points_in_one_unit_are_round_off_beside_the_largest_of_them(index: int, largest: float) -> None:
    """A column of no point is set by itself."""
    assert largest_of(GRID, index) == largest


def test_a_column_is_round_off_beside_the_others_in_its_unit() -> None:
    """The coupler of a parallelogram keeps its angle: 1e-16 rad is 0, 1e-10 rad is an angle, and so is 1e-16 of another unit."""
    rows = {"phi1": np.array([2.6, 6.7]), "phi2": np.array([-1.7e-16, 2e-10]), "w2": np.array([3e-16, np.nan])}
    motion = SimpleNamespace(names=(*rows,), column=rows.__getitem__)
    variant = SimpleNamespace(unit_of=lambda name: "1/s" if name == "w2" else "rad")
    assert shown_column(motion, "phi2", variant).tolist() == [0.0, 2e-10]
    assert shown_column(motion, "w2", variant)[0] == 3e-16


@pytest.mark.parametrize(("scheme", "called"), [
    ("euler", "Positions and velocities by explicit Euler, "), ("exact", "Positions and velocities of the exact motion, "),
])  # fmt: skip
def test_a_table_is_called_after_the_scheme_that_made_it(real: ModuleType, scheme: str, called: str) -> None:
    run = solved("31", scheme=scheme) if scheme == "euler" else coursework.solve("31", scheme, quantities=["table", "checks"])
    captions = [real.text_of(part["caption"]) for part in real.parts(run, "results") if part["kind"] == "table"]
    assert any(caption.startswith(called) for caption in captions), captions


def test_a_run_that_stops_says_how_many_rows_of_how_many_it_has(real: ModuleType) -> None:
    """25 rows were asked for, 0.48 s by 0.02 s; the last before the stop at 0.1169 s is that of 0.10 s."""
    (bar,) = (part for part in real.parts(real.stopped(), "statement") if part.get("style") == "bar")
    assert "6 rows of 25." in real.text_of(bar["text"]).replace("\u00a0", " ")


def test_a_wide_table_is_cut_into_parts_about_equally_wide_and_never_within_a_point() -> None:
    """As wide as when all columns stood evenly in as few tables as hold them, or as the widest point; the next would not fit."""
    for alone, owned, most in product(range(1, 13), ("", "1", "3", "23", "3322", "1111111", "42"), (1, 3, 4, 10)):
        points = [[f"{point}.{column}" for column in range(int(count))] for point, count in enumerate(owned)]
        blocks = [[f"w{column}"] for column in range(alone)] + points
        names = [name for block in blocks for name in block]
        widest = max(-(-len(names) // -(-len(names) // most)), *map(len, blocks))
        parts = [names[begin:end] for begin, end in pieces(names, most)]
        assert [name for part in parts for name in part] == names
        begins = {block[0]: len(block) for block in blocks}
        for part, after in zip_longest(parts, parts[1:]):
            assert part[0] in begins and len(part) <= widest  # whole points
            assert after is None or len(part) + begins[after[0]] > widest
