"""The section on forces names what its moments are taken about."""

from __future__ import annotations

from types import ModuleType

from tests.solved import solved


def test_moments_are_taken_about_the_pin_where_it_has_no_letter(real: ModuleType) -> None:
    """The ram's pin is no joint with a name: "Moments about , link 4"."""
    page = real.text_of(real.parts(solved("whitworth-forces", quantities=["table", "forces"]), "forces"))
    assert "Moments about the pin of link 4: what is known gives" in page and "about ," not in page
