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
