"""A text that is too long keeps as many characters as it may have, the last of them an ellipsis."""

import pytest

from coursework.words.templates import clean

TEXT = "φ" + "a φ" * 40 + "."


@pytest.mark.parametrize("longest", [len(TEXT) + 1, len(TEXT)])
def test_what_fits_is_left_as_it_is(longest):
    assert clean(TEXT, longest).replace("\u200b", "") == TEXT


@pytest.mark.parametrize("longest", [len(TEXT) - 1, 40, 3, 2])
def test_what_is_longer_ends_in_an_ellipsis_and_fills_its_place(longest):
    kept = clean(TEXT, longest)
    assert kept.endswith("…")
    assert kept == TEXT[: longest - 1].rstrip() + "…"


def test_no_space_stands_before_the_ellipsis():
    assert clean("φ φ φ φ", 5) == "φ φ…"


@pytest.mark.parametrize("count", range(14, 26))
def test_a_short_word_of_plain_letters_that_is_cut_says_so_too(count: int) -> None:
    """Such a word needs nothing else done to it; one of 17 to 23 letters lost its end unseen in a cell of 16."""
    assert clean("x" * count, 16) == ("x" * count if count <= 16 else "x" * 15 + "…")
