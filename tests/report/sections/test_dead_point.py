"""Where the rows end is said as what it is: nothing beyond a dead point, but a block that sticks only waits."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType

import pytest

import coursework
from tests.effects.test_rubbing import BLOCK
from tests.mechanisms.library import mechanism

# Crank and rod of one length: Euler's slider passes its pivot from row 26 to 27, where the mechanism itself goes on.
EQUAL = mechanism("equal-crank-and-rod")


def test_rows_lost_before_the_dead_point_are_not_said_to_be_none_of_the_motion(real: ModuleType) -> None:
    """Rows 27 to 89 would be motion; nor do the rows end at the time of the dead point."""
    run = coursework.solve(coursework.parse_variant(EQUAL), scheme="euler", quantities=["table", "checks"])
    assert run.stop is not None and run.stop.row > len(run.motion.t) + 1
    page = real.text_of(real.parts(run, "dead_point"))
    assert f"keeps the rows up to row {len(run.motion.t)}." in page and "nothing beyond" not in page
    told = next(one.sentence for one in run.checks if one.code == "PERIOD-POSITION")
    assert told.startswith(f"The rows end at t = {run.motion.t[-1]:g} s,")


@pytest.mark.long
def test_a_block_held_by_friction_is_not_said_to_have_no_motion_beyond(real: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """And rows are counted so that one row is no "1 rows"."""
    run = coursework.solve(coursework.parse_variant(BLOCK), scheme="exact", quantities=["table"])
    held = real.text_of(real.parts(run, "dead_point"))
    assert "keeps the rows up to row 164." in held and "The rows up to row 164 are valid;" in held
    assert "nothing beyond" not in held
    monkeypatch.setitem(vars(run.motion), "stop", replace(run.stop, kind="sensitive"))  # nor one that forgets its start
    assert "nothing beyond" not in real.text_of(real.parts(run, "dead_point"))
    dead = coursework.load("31").with_data(given={"alpha": 0.02})
    run = coursework.solve(dead, quantities=["table"])
    assert "nothing beyond it would be a motion" in real.text_of(real.parts(run, "dead_point"))
