"""What the panel says of the longest arrow holds of the whole motion: "Largest now" stands beside it and is another number."""

import pytest

from coursework.words.sentences import load_phrases


@pytest.mark.parametrize(("language", "whole"), [
    ("en", "of the whole motion"), ("ru", "за всё движение"), ("uk", "за весь рух"), ("zh", "整个运动"),
])  # fmt: skip
@pytest.mark.parametrize("key", ["live.arrows", "live.force_scale"])
def test_the_longest_arrow_is_that_of_the_whole_motion(language: str, whole: str, key: str) -> None:
    phrases = load_phrases(language)
    assert whole in phrases.template(key)
    assert whole not in phrases.template("live.force_largest")
