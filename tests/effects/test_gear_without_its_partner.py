"""A wheel for whose contact no partner is listed: reactions and virtual power differ, and the page says at which line why."""

import numpy as np

import coursework
from tests.mechanisms.library import mechanism

OWN = '2 = { wheel = "Q"'
CRANK, GEAR = '1 = { points = ["O", "A"], rate', '1 = { wheel = "O", contact = "P", points = ["A"], rate'


def of(text):
    run = coursework.solve(coursework.parse_variant(text), "exact")
    return run, next(one for one in run.checks if one.code == "VIRTUAL-POWER")


def test_the_line_of_the_wheel_is_told_and_its_partner_mends_it():
    """Twice as slow, 5 N m on the second gear are 2.5 on the first; the crank of 1 kg hangs at half of 100 mm."""
    text = mechanism("gear-without-its-partner")
    _, found = of(text)
    line = text[: text.index(OWN)].count("\n") + 1
    assert found.verdict == "FAIL" and f"Line {line} of the file lists a wheel that touches nothing" in found.sentence
    run, found = of(text.replace(CRANK, GEAR))
    assert found.verdict == "PASS" and "touches nothing" not in found.sentence
    expected = 2.5 + 9.81 * 0.05 * np.cos(run.table["f"])
    assert np.allclose(run.results.forces.column("M"), expected, rtol=0, atol=1e-9)
