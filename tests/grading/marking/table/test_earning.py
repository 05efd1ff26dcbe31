"""What a cell is worth by each explanation of a table, by the rubric that is used if none is written.

0.95 for a start or a number copied wrongly, 0.6 for two, 0.7 for other steps or another rule, 0.5 for a single slip, 0.4 for a
wrong method.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import coursework
from coursework.grading.marking.rubric import Rubric
from coursework.grading.marking.table import earning
from coursework.grading.marking.table.causes.misconceptions import Found
from coursework.grading.marking.table.earning import _by_explanation, _is_row, best_rule
from coursework.grading.marking.table.explained import Fit
from coursework.grading.marking.table.ways import StudentTable

KEY: Any = SimpleNamespace(variant=coursework.load("31"))  # in which r1 is 0.953 m and V1 is 4.5 m/s
POINTS: Any = SimpleNamespace(share=0.1, shut={})


def fit_of(text: str) -> Fit:
    """Return a fit: code, share, names; "~" before the code if Euler's rules explain as much, "=" if it is so in print only."""
    code, share, *names = text.split()
    return Fit(code.lstrip("~="), float(share), tuple(names), beyond_euler=code[0] != "~", in_print=code[0] == "=")


@pytest.mark.parametrize(("fits", "worth"), [
    ("equation_16 0.9", [0.5]), ("sign_drive 0.9", [0.5]), ("rows_shifted 0.9", [1.0]), ("other_step 0.9", [0.7]),
    ("anything 0.9", [0.4]),
    ("~equation_16 0.9", []), ("~anything 0.9", [0.4]), ("~other_step 0.9", []), ("own_equations 0.9 2", [0.5]),
    # another rule of steps: from 80 % of the table, where it is worth a wrong method, to 93 %
    ("heun 0.8", [0.4]), ("heun 0.865", [0.55]), ("heun 0.93", [0.7]), ("row_before 0.95", [0.7]), ("~heun 0.95", [0.4]),
    # a datum copied wrongly, if no slip explains as much or its digits are nearly right; with the other sign it is a slip
    ("datum_r1 0.93 0.9 m", [0.95]), ("datum_r1 0.865 0.9 m", [0.675]), ("datum_r1 0.95 -0.953 m", [0.5]),
    ("datum_r1 0.95 90 cm", [0.95]),
    ("datum_r1 0.95 0.9 m; equation_16 0.95", [0.4, 0.5]), ("datum_r1 0.96 0.9 m; equation_16 0.95", [0.95, 0.5]),
    ("datum_r1 0.95 0.906 m; equation_16 0.96", [0.95, 0.5]), ("datum_r1 0.95 0.905 m; equation_16 0.96", [0.4, 0.5]),
    ("datum_r1 0.96 -0.9 m; datum_V1 0.95 4 m/s", [0.5, 0.4]), ("data_rounded 0.95; equation_16 0.96", [0.95, 0.5]),
    ("swap_r1_r2 0.95", [0.6]), ("swap_r1_r2 0.8", [0.4]), ("~datum_r1 0.95 0.9 m", [0.4]),
    # another's work earns nothing, nor does what explains less of it
    ("variant_07 0.95", []), ("variant_07 0.95; equation_16 0.94", []), ("variant_07 0.95; equation_16 0.95", [0.5]),
    ("variant_07 0.95; datum_r1 0.95 0.9 m", [0.4]), ("variant_07 0.95; datum_r1 0.96 0.9 m", [0.95]),
    # coarser work and another origin count if they explain nearly all and no slip more
    ("rounded_omega_2 0.93", [0.98]), ("rounded_omega_2 0.92", []), ("pi_rounded 0.95; equation_16 0.96", [0.5]),
    ("pi_rounded 0.956; equation_16 0.96", [0.98, 0.5]), ("origin_phi1 0.95", [0.95]), ("origin_phi1 0.9", []),
    ("origin_phi1 0.95; datum_r1 0.99 0.9 m", [0.95, 0.95]),  # a number read off the table is no slip
    # starts in degrees, and what is so in print only
    ("radian_mode 0.9", [0.4]), ("radian_mode 0.9 phi1", [0.95]), ("radian_mode 0.9 phi1 phi2", [0.6]),
    ("=swapped_columns 0.95", [0.95]), ("=swapped_columns 0.8", [0.4]), ("swapped_columns 0.95", [0.4]), ("sign_w3 0.95", [0.5]),
    ("=sign_w3 0.95", [0.95]), ("=sign_w3 0.8", [0.5]),
    # what is so in print only, if no slip explains more: from half a per cent of the table to 5 % it becomes a slip
    ("=sign_w3 0.94; equation_16 0.945", [0.95, 0.5]), ("=sign_w3 0.94; equation_16 0.9675", [0.725, 0.5]),
    ("=sign_w3 0.94; equation_16 0.99", [0.5, 0.5]), ("=sign_w3 0.94; datum_V1 0.99 4 m/s", [0.95, 0.95]),
])  # fmt: skip
def test_the_worth_of_a_cell_by_each_explanation(fits: str, worth: list[float]) -> None:
    found = [*_by_explanation(KEY, Rubric(), POINTS, [*map(fit_of, fits.split("; "))])]
    assert [one.worth for one in found] == pytest.approx(worth)
    assert [one.share for one in found] == pytest.approx([one.worth * one.explained for one in found])


@pytest.mark.parametrize(("at_best", "share", "looks"), [
    ("heun 1.0", 0.69, True), ("heun 1.0", 0.7, False), ("heun 0.86", 0.46, True), ("heun 0.86", 0.47, False),
    ("anything 0.9; datum_r1 1.0 0.9 m", 0.94, True), ("anything 0.9; datum_r1 1.0 0.9 m", 0.95, False),
])  # fmt: skip
def test_a_closer_look_is_taken_only_if_a_cause_can_earn_more(
    at_best: str, share: float, looks: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A cause that explains all of a table earns its worth, 0.7 for another rule; the cells may have earned that already."""
    monkeypatch.setattr(earning, "stands_still", lambda key, cells: False)
    looked: list[str] = []

    def closer_look() -> tuple[Fit, ...]:
        looked.append(at_best)
        return tuple(map(fit_of, at_best.split("; ")))

    points: Any = SimpleNamespace(share=share, shut={})
    found = Found(at_best=tuple(map(fit_of, at_best.split("; "))), closer_look=closer_look)
    earned = best_rule(KEY, Rubric(), KEY, points, found, {})
    assert bool(looked) is looks and (earned.rule == "cells") is not looks


def test_a_cause_may_be_worth_more_as_a_wrong_method_than_a_wrong_start(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(earning, "stands_still", lambda key, cells: False)
    fits = (Fit("swapped_columns", 0.95, (), beyond_euler=False, in_print=True),)
    found = Found(at_best=fits, closer_look=lambda: fits)
    assert best_rule(KEY, Rubric(start_floor=0.0), KEY, POINTS, found, {}).share == pytest.approx(0.4 * 0.95)


@pytest.mark.parametrize(("row", "others", "agrees"), [
    ((1.25, 3.5), (1.25, 3.5), True), ((1.25, 3.5), (1.2501, 3.4999), True), ((1.25, 3.5), (1.25, 3.6), False),
    ((np.nan, 3.5), (9.0, 3.5), True), ((np.nan, 3.5), (1.25, 3.6), False),
])  # fmt: skip
def test_a_start_is_another_s_if_the_first_row_agrees_as_far_as_it_is_printed(
    row: tuple[float, ...], others: tuple[float, ...], agrees: bool
) -> None:
    """Whatever stands below it, and only of a table of the same size."""
    student: Any = StudentTable(np.array([row, (7.0, 7.0)]), np.full((2, 2), 1e-3))
    table = np.array([others, (8.0, 8.0)])
    key: Any = SimpleNamespace(table=table, ranges=np.ones(2), usual_ranges=np.ones(2))
    cells: Any = SimpleNamespace(student=student)
    assert _is_row(key, cells, table) is agrees
    assert not _is_row(key, cells, np.array([others]))
