"""Where the rows end is said as what it is: nothing beyond a dead point, but a block that sticks only waits."""

from __future__ import annotations

from types import ModuleType

import coursework
from tests.effects.test_rubbing import BLOCK
from tests.solved import solved


def test_a_block_held_by_friction_is_not_said_to_have_no_motion_beyond(real: ModuleType) -> None:
    """And rows are counted so that one row is no "1 rows"."""
    run = coursework.solve(coursework.parse_variant(BLOCK), scheme="exact", quantities=["table"])
    held = real.text_of(real.parts(run, "dead_point"))
    assert "keeps the rows up to row 164." in held and "The rows up to row 164 stand;" in held
    assert "nothing beyond" not in held
    dead = coursework.load("31").with_data(given={"alpha": 0.02})
    run = coursework.solve(dead, quantities=["table"])
    assert "nothing beyond it would be a motion" in real.text_of(real.parts(run, "dead_point"))


def test_moments_are_taken_about_the_pin_where_it_has_no_letter(real: ModuleType) -> None:
    """The ram's pin is no joint with a name: "Moments about , link 4"."""
    page = real.text_of(real.parts(solved("whitworth-forces", quantities=["table", "forces"]), "forces"))
    assert "Moments about the pin of link 4: what is known gives" in page and "about ," not in page
