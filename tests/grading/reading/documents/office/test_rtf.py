r"""What control words of RTF make of a text: letters of code pages, what is passed over, indices, cells that go on."""

from __future__ import annotations

from contextlib import nullcontext

import pytest

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.office import rtf
from coursework.grading.reading.documents.office.rtf import document_of_rtf, is_rtf
from coursework.grading.reading.limits import Refused, Room


def read(text: str, head: str = r"\rtf1\ansi\ansicpg1251") -> Document:
    return document_of_rtf(f"{{{head}{text}}}".encode("latin-1"), Room(20, 10))


def lines(text: str, head: str = r"\rtf1\ansi\ansicpg1251") -> list[str]:
    return [line.text for line in read(text, head).lines]


@pytest.mark.parametrize(("text", "found"), [
    (r"a\par b", ["a", "b"]), (r"a\line b\softline c", ["a", "b", "c"]), ("a\\\nb", ["a", "b"]), ("a\r\nb", ["ab"]),
    (r"a\tab b", ["a\tb"]),
    (r"a\~b\_c", ["a b-c"]), (r"\{a\\b\}", [r"{a\b}"]), (r"a\emdash b\bullet c\lquote d", ["a-b*c'd"]), (r"{a{b}c}", ["abc"]),
    ("}a", ["a"]),
    # letters of the code page, of a font's own, by number
    (r"\'e0\'e1 x", ["аб x"]), ("\xe0\xe1", ["аб"]), (r"\u1072\'e0b", ["аb"]), (r"\u1072?b", ["аb"]), (r"\uc0\u1072 b", ["аb"]),
    (r"\uc2\u1072??b", ["аb"]), (r"\uc2\u1072?\'e0b", ["аb"]), (r"\u-3999?", ["α"]), (r"{\uc3\u1072}bcd", ["аbcd"]),
    (r"\uc-1\u1072?", ["а?"]), (r"\u1072", ["а"]),
    # what is passed over
    (r"{\*\unknown x}a", ["a"]), (r"{\fonttbl x}a", ["a"]), (r"{\pict x{y}z}a", ["a"]), (r"{a\pict b}", ["ab"]),
    (r"{\*\moMathPara a}", ["a"]),
    (r"{\v x}a{\v0 b}", ["ab"]), (r"a\v b", ["a"]), (r"a\bin3 xyzb", ["ab"]), (r"a\bin0 xb", ["axb"]),
    (r"{\footnote x}a{\deleted y}", ["a"]),
    # set higher and lower
    (r"x{\super 2}+w{\sub 1}r", ["x^2+w1 r"]), (r"x\super 2\nosupersub y", ["x^2y"]), (r"x\super 2\plain y", ["x^2y"]),
    (r"x\super2\super0 y", ["xy"]),
    (r"\super0 2", ["2"]),
])  # fmt: skip
def test_a_text_as_it_is_read(text: str, found: list[str]) -> None:
    assert lines(text) == found


@pytest.mark.parametrize(("head", "text", "found"), [
    (r"\rtf1", r"\'e9", ["é"]), (r"\rtf1\ansicpg65001", r"\'d0\'b0", ["а"]), (r"\rtf1\ansicpg936", r"\'b0\'a1", ["啊"]),
    (r"\rtf1\ansicpg9999", r"\'e9", ["é"]), (r"\rtf1\ansicpg1252", r"\'81", ["\ufffd"]),
    (r"\rtf1{\fonttbl{\f0\fcharset204 A;}{\f1\fnil\fcharset2 S;}{\f2\fcharset161 G;}}", r"\f0\'e0\f2\'e1", ["аα"]),
    (r"\rtf1{\fonttbl{\f0\fcharset204 A;}{\f1\fnil\fcharset2 S;}}", r"{\f1 w\'77}\f0 w", ["ωωw"]),
    (r"\rtf1{\fonttbl{\f0\fcharset204 A;}{\f1\fcharset161 G;}}", r"\f1\'e1{\f\'e0}\'e1\plain\'e1", ["αаαα"]),
    (r"\rtf1{\fonttbl{\f3\fcharset99 A;}}", r"\f3\'e9\f9\'e8", ["éè"]),
])  # fmt: skip
def test_letters_are_of_the_code_page_of_the_file_or_the_font(head: str, text: str, found: list[str]) -> None:
    assert lines(text, head) == found


def rows(text: str) -> list[list[list[str]]]:
    return [[[cell.text for cell in row] for row in table.rows] for table in read(text).tables]


DEFINED = r"\trowd\cellx1\cellx2\cellx3"


@pytest.mark.parametrize(("text", "found"), [
    (r"\trowd\intbl a\cell b\cell\row\intbl c\cell d\cell\row\pard e\par", [[["a", "b"], ["c", "d"]]]),
    (rf"{DEFINED}\intbl a\cell b\cell c\cell\row\trowd\clvmrg\cellx1\cellx2\clmrg\cellx3\intbl\cell d\cell\cell\row",
     [[["a", "b", "c"], ["a", "d", "d"]]]),
    (rf"{DEFINED}\intbl a\cell b\cell c\cell\row\trowd\cellx1\clmrg\clvmrg\cellx2\intbl d\cell\cell e\cell\row",
     [[["a", "b", "c"], ["d", "d", "e"]]]),
    (r"\intbl a\cell b\cell\row\pard so\par\intbl c\cell d\cell\row", [[["a", "b"]], [["c", "d"]]]),
    (r"u = w\trowd\pard\intbl 1\cell 2\cell\row", [[["1", "2"]]]),  # the line before is no part of the first cell
    (r"\intbl a\par\itap2 1\nestcell 2\nestcell\nestrow\itap1 b\cell c\cell\row", [[["1", "2"]], [["a b", "c"]]]),
    (r"\row\intbl a\cell b\cell", [[["a", "b", ""]]]),
])  # fmt: skip
def test_cells_stand_beside_each_other_and_go_on_from_the_left_or_from_above(text: str, found: list[list[list[str]]]) -> None:
    assert rows(text) == found


def test_an_equation_of_word_is_a_line_of_its_own() -> None:
    number = r"{\mr w}"
    (line,) = read(rf"{{\*\moMath {{\msSub{{\me {number}}}{{\msub {{\mr 1}}}}}}{{\mr =2}}}}").lines
    assert (line.text, line.is_formula) == ("w_1 =2", True)
    assert lines(r"so {\*\moMath {\mr a}{\line}{\mr =2}} it is")[0] == "a =2"


def test_bounds_and_what_is_rtf() -> None:
    assert is_rtf(b"{\\rtf1 a") and not is_rtf(b" {\\rtf1") and not is_rtf(b"{\\html")
    assert lines("{" * 9_990 + "a") == ["a"]
    with pytest.raises(Refused):
        read("{" * 10_001)
    with pytest.raises(Refused):
        read(r"\b" * 500_001)


@pytest.mark.parametrize(("most", "deepest", "is_read"), [(6, 3, True), (5, 3, False), (6, 2, False)])
def test_a_text_has_as_many_tokens_and_groups_as_are_allowed(
    most: int, deepest: int, is_read: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two braces that open, a word, a text and two braces that close."""
    monkeypatch.setattr(rtf, "_MOST_TOKENS", most)
    monkeypatch.setattr(rtf, "_DEEPEST", deepest)
    with nullcontext() if is_read else pytest.raises(Refused):
        document_of_rtf(b"{{\\b a}}", Room(20, 10))
