"""Drives that do in less than a row what no row shows: their tables are marked as any other, a right one is worth all points."""

import math
from random import Random

import mpmath as mp
import pytest

from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.table.desks import Desk, codes
from tests.hard.drives import drawn, four_bar
from tests.hard.edges import as_equations, of_four_bar, rate_of


def desk_of(kind, width):
    law = drawn(kind, Random(3), width)
    sides = tuple(mp.mpf(float(one)) for one in ("0.4", "1.0", "0.7", "1.2"))
    start = of_four_bar(sides, law, rate_of(law), mp.mpf(0))(mp.mpf(0))
    desk = Desk(parse_variant(as_equations(four_bar(law, scheme="euler"), start), "sudden.toml", {}))
    desk.machine.data.update(exp=lambda x: math.exp(min(x, 700)), abs=abs, atan=math.atan)
    return desk


@pytest.mark.parametrize(
    ("kind", "width"), [("pulse", 1e-4), ("lorentz", 1e-4), ("decay", 0.3), ("switch", 1e-4), ("fold", 1.0), ("twins", 1e-4)]
)
def test_a_right_table_is_worth_all_and_faults_are_named(kind, width):
    """A pulse stands on a row: its 9289 rad/s there must not make 0.2 rad/s and -0.2 rad/s the same in the others."""
    desk = desk_of(kind, width)
    right = desk.machine.table()
    assert desk.marked(right, digits=6)[0] == 60
    turned = right.copy()
    turned[:, desk.heads("w3")] *= -1
    points, table = desk.marked(turned, digits=6)
    assert points == 57  # as a column ten times too large
    assert "sign_w3" in codes(table)
    points, table = desk.marked(desk.key.exact, digits=6)
    assert points < 57
    assert "exact" in codes(table)
