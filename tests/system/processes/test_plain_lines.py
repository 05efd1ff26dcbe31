"""A record crosses as plain data and comes back the same; what is no such record is refused, whatever it says."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from coursework.system.processes.plain_lines import line_of, plain_of, read_line
from coursework.words.sentence import Sentence
from coursework.words.sentences import say


@dataclass(frozen=True, slots=True)
class Part:
    content: bytes
    size: int = field(init=False, default=0)


@dataclass(frozen=True, slots=True)
class Whole:
    name: str
    number: float
    parts: tuple[Part, ...]
    named: Mapping[str, bytes]
    place: Path | None
    told: Sentence | None
    anything: dict[str, Any]
    right: bool = True


WHOLE = Whole(
    "Ім'я\ud800", 0.1, (Part(b"\xff\x00"), Part(b"")), {"a": b"1"}, Path("o"),
    say("reading.review.resubmitted", names=("a", say("feedback.part.table"))), {"x": [1, 2.5, None]},
)  # fmt: skip


def test_a_record_comes_back_the_same():
    line = line_of(WHOLE)
    assert line.isascii()
    assert line.count(b"\n") == 1
    back = read_line(Whole, line)
    assert back == WHOLE
    assert back.told.values == WHOLE.told.values
    assert isinstance(back.told.values["names"][1], Sentence)
    assert plain_of(WHOLE)["parts"] == [{"content": "/wA="}, {"content": ""}]


@pytest.mark.parametrize(
    "line",
    [
        b"", b"{", b"[]", b"null", b"7", b'{"content": "AA=="', b'{"content": 7}', b'{"content": ["AA=="]}', b'{"content": "A"}',
        b"{}", b'{"content": "AA==", "size": 1}', b'{"content": "AA==", "more": NaN}', b"[" * 100_000,
    ],
)  # fmt: skip
def test_anything_else_is_refused(line):
    with pytest.raises(ValueError):
        read_line(Part, line)


@pytest.mark.parametrize("number", [float("nan"), float("inf")])
def test_what_is_no_number_does_not_cross(number):
    with pytest.raises(ValueError, match="not JSON compliant"):
        line_of({"x": number})
    with pytest.raises(ValueError, match="is no number"):
        read_line(dict, str(number).replace("nan", "NaN").replace("inf", "Infinity").encode())


@pytest.mark.parametrize(
    "half", ['{"key": "none"}', '{"values": {}}', '{"key": "no.such", "values": {}}', '{"key": [], "values": 7}']
)
def test_half_a_sentence_is_refused(half):
    line = line_of(WHOLE).replace(line_of(WHOLE.told).strip(), half.encode())
    assert half.encode() in line
    with pytest.raises(ValueError):
        read_line(Whole, line)
