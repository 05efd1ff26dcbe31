"""The elements of a document as a reader gets them: names without prefixes, what is not wanted left out, and a limit of depth."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.xml_events import _MOST_NESTED, Enough, stream, whole
from coursework.grading.reading.limits import Refused

SPACE = 'xmlns:a="urn:a" '


class Told:
    """Writes down what it gets; has enough at an element called so."""

    def __init__(self) -> None:
        self.seen: list[str] = []

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        if name == "enough":
            raise Enough
        self.seen.append(name + "".join(f" {key}={value}" for key, value in attributes.items() if value != "urn:a"))

    def end(self, name: str) -> None:
        self.seen.append(f"/{name}")

    def text(self, text: str) -> None:
        self.seen.append(f"'{text}'")


@pytest.mark.parametrize(("text", "number"), [
    ("5", 5), ("0", 0), ("12345678", 12345678), ("123456789", 7), ("", 7), (None, 7), ("-1", 7), ("1.5", 7), ("٣", 7), ("²", 7),
])  # fmt: skip
def test_an_attribute_is_a_small_whole_number_or_another_one_counts(text: str | None, number: int) -> None:
    assert whole(text, 7) == number


@pytest.mark.parametrize(("wanted", "seen"), [
    (None, "x c=1 d=2|y e=3|/y|'t'|/x"), ({"x": True}, "x c=1 d=2|'t'|/x"), ({"x": False, "y": True}, "x|y e=3|/y|'t'|/x"),
    ({"z": True}, "'t'"),
])  # fmt: skip
def test_elements_that_are_wanted_without_prefixes(wanted: dict[str, bool] | None, seen: str) -> None:
    content = f'<a:x {SPACE}a:c="1" d="2"><y e="3"/>t</a:x>'.encode()
    for size in (1, 7, len(content)):  # whatever the pieces in which it comes
        told = Told()
        stream([content[at : at + size] for at in range(0, len(content), size)], told, wanted)
        assert "|".join(told.seen) == seen


def test_a_reader_that_has_enough_gets_no_more() -> None:
    told = Told()
    stream([b"<x><y/><enough/><y/><broken"], told)
    assert told.seen == ["x", "y", "/y"]


@pytest.mark.parametrize("more", [0, 1])
def test_a_document_is_read_to_a_depth(more: int) -> None:
    deep, told = _MOST_NESTED + more, Told()
    content = b"<x>" * deep + b"</x>" * deep
    if more:
        with pytest.raises(Refused):
            stream([content], told)
    else:
        stream([content], told)
        assert told.seen.count("/x") == deep


@pytest.mark.parametrize(
    "content", [b"<x><y></x>", b"<x>", b'<!DOCTYPE x [<!ENTITY e "e">]><x>&e;</x>', b"<!DOCTYPE x><x/>", b""]
)
def test_what_is_no_whole_document_or_defines_words_is_refused(content: bytes) -> None:
    with pytest.raises(Refused):
        stream([content], Told())
