"""Which of four encodings a text without a mark has is told by its letters alone, whatever names stand in it."""

from __future__ import annotations

import pytest

from coursework.grading.reading.files.encoding import decode

TEXTS = {
    "cp1252": [
        "Müller, Übung 3;Läufer;1,5 m²", "Straße;10° ± 2", "Ölmühle;1;2", "élève: Zoé à Orléans;1", "7 × 3 · 2 µm",
    ],
    "cp1251": ["Петров;1,5;№ 3", "Їжак;Ґава;є", "w – «Ёж»", "5° – 7 ± 1", "Ася;ёлка;Іван"],
    "cp866": ["Петров;1,5", "привод кривошипа;1", "Иванов Пётр;№ 2"],
    "gb18030": ["张三;作业;1.5", "连杆;曲柄"],
}  # fmt: skip


@pytest.mark.parametrize(("encoding", "text"), [(encoding, text) for encoding, texts in TEXTS.items() for text in texts])
def test_the_letters_tell_the_encoding(encoding: str, text: str) -> None:
    found = decode(text.encode(encoding))
    assert (found.text, found.encoding, found.had_nuls) == (text, encoding, False)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
def test_a_mark_or_every_second_byte_tells_unicode(encoding: str) -> None:
    assert decode("t;phi1;w1\r\n0;1,5;2\r".encode(encoding)).text == "t;phi1;w1\n0;1,5;2\n"


def test_bytes_of_zero_are_left_out_and_told() -> None:
    found = decode(b"t;w\x001\n0;1\n")
    assert (found.text, found.had_nuls) == ("t;w1\n0;1\n", True)


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
@pytest.mark.parametrize(("text", "is_wide"), [
    ("t;угол\n0;1,5\n0,1;1,7", True), ("t;w1", True), ("t;w", False), ("abcdefgжшию", True), ("abcdefжшию", False),
])  # fmt: skip
def test_without_a_mark_most_of_every_second_byte_of_at_least_eight_are_zero(encoding: str, text: str, is_wide: bool) -> None:
    """Of ten letters six are too few; three letters are six bytes."""
    assert ((found := decode(text.encode(encoding))).encoding == encoding) is is_wide
    assert (found.text, found.had_nuls) == (text, False) or not is_wide


@pytest.mark.parametrize("content", [b"t\0;\0w\x001\0;", b"t\0;\0w\x001\0\0\0;\0", b"\0t\0;\0w\x001\0\0"])
def test_an_odd_number_of_bytes_or_zeros_at_both_places_are_no_unicode(content: bytes) -> None:
    found = decode(content)
    assert (found.text.replace(";", ""), found.encoding, found.had_nuls) == ("tw1", "utf-8", True)


@pytest.mark.parametrize("text", ["啊阿埃", "座做作", "α。β", "一；二"])
def test_the_first_and_the_last_of_the_usual_chinese_characters_are_known(text: str) -> None:
    assert decode(text.encode("gb18030")).text == text
