"""A neighbour's table earns what its cells earn; angles that alone stand one row late are told as such."""

import numpy as np
import pytest

from coursework.grading.marking.grade import Marker
from coursework.grading.marking.reasons.table import table_reasons
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table.causes.other_data import _whole
from coursework.words.sentences import load_phrases
from tests.grading.marking.machines import Machine
from tests.grading.marking.table.desks import codes, variants


def test_another_table_holds_up_to_half_a_last_place_and_a_little_of_its_range():
    """0.505 of a last place and 0.0002 of the range, which is what counts where there are many digits."""
    claim = _whole("variant_07", np.array([[1.0, 5.0], [3.0, 5.0]]), np.array([[0.01, 0.01], [1e-6, 1e-6]]))
    assert claim.tolerance == pytest.approx(np.array([[0.00545, 0.00505], [4.00505e-4, 5.05e-7]]))


@pytest.mark.long
@pytest.mark.parametrize(("mine", "other"), [(0, 1), (1, 0), (2, 3), (3, 2)])
@pytest.mark.parametrize("spoilt", [0, 6])
def test_a_neighbours_table_earns_nothing_through_data_that_are_nearly_the_neighbours(mine, other, spoilt):
    desk, neighbour = variants()[mine], variants()[other]
    table, chance = neighbour.machine.table(), np.random.default_rng(mine)
    for _ in range(spoilt):
        table[chance.integers(len(table)), chance.integers(table.shape[1])] += 0.4
    desk = type(desk)(desk.variant)
    desk.marker = Marker(desk.key, Rubric(), {"neighbour": neighbour.key.table})
    found, marks = desk.marked(table)
    assert marks.earned.rule == "cells" and found == pytest.approx(60 * marks.earned.of_cells, abs=0.01)
    assert marks.misconception.code == "variant_neighbour"


@pytest.mark.long
def test_other_data_count_beside_a_neighbour_whose_table_it_is_not():
    for mine, other in ((0, 1), (2, 3)):
        desk = type(variants()[mine])(variants()[mine].variant)
        table = Machine(desk.variant, data={desk.variant.given[0].name: 1.3 * desk.variant.given[0].value}).table()
        alone = desk.marked(table)[0]
        desk.marker = Marker(desk.key, Rubric(), {"neighbour": variants()[other].key.table})
        assert desk.marked(table)[0] == alone


def test_angles_one_row_late_are_told_without_the_velocities():
    said = []
    for desk in variants()[1::2]:
        table, m = desk.machine.table(), desk.machine.m
        table[1:, :m] = table[:-1, :m].copy()
        found, marks = desk.marked(table)
        assert codes(marks)[:1] == ("rows_shifted",) and found > 55
        said += [reason.text for reason in table_reasons(desk.key, marks, Rubric(), found, 60.0) if reason.kind == "cause"]
        whole = desk.machine.table()
        whole[5:] = whole[4:-1].copy()
        assert not desk.marked(whole)[1].misconception or not desk.marked(whole)[1].misconception.names
    phrases = load_phrases()
    assert said and all("the velocities do not" in phrases.written(sentence) for sentence in said)
