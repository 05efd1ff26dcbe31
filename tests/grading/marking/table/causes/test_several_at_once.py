"""Causes that change several data or columns at once: rounded data, links numbered from the other end, an angle turned round."""

import pytest

import coursework
from coursework.grading.marking.reasons.table import table_reasons
from coursework.grading.marking.rubric import Rubric
from coursework.variant.reading.reader import parse_variant
from tests.grading.marking.machines import SLIDER_CRANK, Machine
from tests.grading.marking.table.desks import Desk, codes, of_each, variants


@pytest.mark.parametrize(("name", "digits"), [("v102", 3), pytest.param("31", 2, marks=pytest.mark.long)])
def test_data_rounded_all_together_cost_what_one_of_them_copied_wrongly_does(name, digits):
    """They earned 1 to 20 of 60 points, one of them 57."""
    desk = Desk(coursework.load(name))
    rounded = {name: float(f"{value:.{digits}g}") for name, value in desk.variant.values.items()}
    found, table = desk.marked(Machine(desk.variant, data=rounded).table())
    assert (found, codes(table)) == (57.0, ("data_rounded",))
    told = [str(reason.text) for reason in table_reasons(desk.key, table, Rubric(), found, 60.0)]
    assert any("the data were rounded" in text for text in told)
    one, table = desk.marked(Machine(desk.variant, data={"p": rounded["p"]}).table())
    assert (one, codes(table)) == (57.0, ("datum_p",))


def test_links_numbered_from_the_other_end_are_columns_exchanged_in_pairs():
    """They earned 24 of 60 points in a slider crank, 36 in another mechanism: as much as one pair, which is told as before."""
    desk = Desk(parse_variant(SLIDER_CRANK, "own.toml", {}))
    found, marks = desk.marked(desk.machine.table()[:, [1, 0, 3, 2, 4]])
    assert (found, marks.misconception.names) == (57.0, ("phi1", "phi2", "w1", "w2"))
    found, marks = desk.marked(desk.machine.table()[:, [1, 0, 2, 3, 4]])
    assert (found, codes(marks), marks.misconception.names) == (57.0, ("swapped_columns",), ("phi1", "phi2"))


@of_each
def test_an_angle_counted_the_other_way_round_costs_the_same_whatever_its_start(numbers):
    """Alone it earned 51 or 57 points, with its velocity 30 to 37."""
    for desk in (variants()[number] for number in numbers):
        for turned in ([0], [0, desk.machine.m]):
            table = desk.machine.table()
            table[:, turned] *= -1
            found, marks = desk.marked(table)
            assert found == 57.0 and f"origin_{desk.key.names[0]}" in codes(marks)
