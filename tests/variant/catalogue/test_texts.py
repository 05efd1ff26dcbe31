"""A file of the catalogue speaks the languages of the pages: all that its author says in English is said in each of them."""

import pytest

import coursework
from coursework.variant.catalogue import names
from coursework.variant.record.variant import Variant

LANGUAGES = ("ru", "uk", "zh")


def said(variant: Variant) -> dict[str, str]:
    """Return every text of a variant by what it is about."""
    return {
        "title": variant.title,
        "source": variant.source,
        "teaches": variant.teaches,
        **{f"remark {place}": remark for place, remark in enumerate(variant.remarks)},
        **{f"given {one.name}": one.means for one in variant.given if one.means},
        **{f"constraint {one.name}": one.because for one in variant.constraints if one.because},
    }


def is_a_label(text: str) -> bool:
    """Return whether a meaning is made of names of points, as P4F is: it is the same in every language."""
    return text.isalnum() and text.isupper()


@pytest.mark.long
@pytest.mark.parametrize("name", names())
@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_is_left_in_english(name: str, language: str) -> None:
    variant = coursework.load(name)
    english, own = said(variant), said(variant.in_language(language))
    assert own.keys() == english.keys()
    assert [about for about, text in own.items() if text == english[about] and not is_a_label(text)] == []


@pytest.mark.parametrize("name", names())
def test_texts_name_what_the_file_has(name: str) -> None:
    variant = coursework.load(name)
    data, constraints = {one.name for one in variant.given}, {one.name for one in variant.constraints}
    for language in LANGUAGES:
        texts = variant.texts[language]
        assert set(texts.means) <= data
        assert set(texts.because) <= constraints
        assert len(texts.remarks) == len(variant.remarks)
