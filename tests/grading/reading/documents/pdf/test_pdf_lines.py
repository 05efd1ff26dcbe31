"""Letters of a page by where they stand: lines, words, indices and powers, rows of a table, fractions.  Letters are 10 points."""

from __future__ import annotations

import random

import pytest

from coursework.grading.reading.documents.pdf.pdf_lines import (
    Bar,
    Letter,
    PageLine,
    Word,
    lines_of,
    with_fractions,
)
from coursework.grading.reading.documents.pdf.pdf_tables import _cells, _first, _parted, _rows, tables_in


def letters(text: str, base: float, left: float = 0.0, size: float = 10.0) -> list[Letter]:
    """Return the letters of a text, half as wide as high; a blank is a gap as wide."""
    step = size / 2
    return [Letter(sign, left + at * step, left + (at + 1) * step, base, size) for at, sign in enumerate(text) if sign != " "]


def texts(given: list[Letter]) -> list[str]:
    random.Random(7).shuffle(given)
    return [line.text for line in lines_of(given)]


def row(*cells: str, at: tuple[float, ...] = (), size: float = 10.0) -> PageLine:
    """Return a line whose cells begin at 0, 100, 200 … or where `at` says."""
    starts = at or tuple(100.0 * place for place in range(len(cells)))
    return PageLine([Word(cell, left, left + 5.0 * len(cell)) for cell, left in zip(cells, starts, strict=True)], size)


def test_lines_are_read_from_above_and_from_the_left() -> None:
    assert texts([*letters("second line", 80.0), *letters("first", 100.0), *letters("and", 100.0, 40.0)]) == [
        "first   and",
        "second line",
    ]
    assert texts([Letter(" ", 0.0, 5.0, 100.0, 10.0)]) == []


@pytest.mark.parametrize(("lower", "found"), [(1.1, ["ab"]), (1.3, ["a", "b"]), (-1.1, ["ab"]), (-1.3, ["b", "a"])])
def test_letters_on_nearly_one_base_are_one_line(lower: float, found: list[str]) -> None:
    assert texts([*letters("a", 100.0), *letters("b", 100.0 - lower, 5.0)]) == found


@pytest.mark.parametrize(("gap", "found"), [(1.6, "ab"), (1.8, "a b"), (11.9, "a b"), (12.1, "a   b"), (-3.0, "ab")])
def test_a_gap_parts_words_and_a_wide_one_equations(gap: float, found: str) -> None:
    assert texts([*letters("a", 100.0), *letters("b", 100.0, 5.0 + gap)]) == [found]


@pytest.mark.parametrize(("size", "higher", "gap", "found"), [
    (7.0, 4.0, 0.0, ["x^2"]), (7.0, -2.0, 0.0, ["x2"]), (8.7, 4.0, 0.0, ["x^2"]), (8.9, 4.0, 0.0, ["2", "x"]),
    (7.0, 5.9, 0.0, ["x^2"]), (7.0, 6.1, 0.0, ["2", "x"]), (7.0, -5.9, 0.0, ["x2"]), (7.0, -6.1, 0.0, ["x", "2"]),
    (7.0, 4.0, 6.9, ["x 2"]), (7.0, 4.0, 7.1, ["2", "x"]), (7.0, 4.0, -4.9, ["x^2"]), (7.0, 4.0, -5.1, ["2", "x"]),
])  # fmt: skip
def test_a_smaller_letter_beside_another_is_its_power_or_index(size: float, higher: float, gap: float, found: list[str]) -> None:
    """Up to 0.6 of the size higher or lower, 0.88 of it high, from 0.5 before to 0.7 behind the letter's right edge."""
    assert texts([*letters("x", 100.0), *letters("2", 100.0 + higher, 5.0 + gap, size)]) == found


@pytest.mark.parametrize(("parts", "found"), [
    ([("w", 0, 10), ("1", -2, 7), ("r", 0, 10)], "w1 r"), ([("w", 0, 10), ("1", -2, 7), ("=", 0, 10)], "w1="),
    ([("x", 0, 10), ("2", 4, 7), ("y", 0, 10)], "x^2y"), ([("x", 0, 10), ("−1", 4, 7)], "x^−1"),
    ([("x", 0, 10), ("n", 4, 7)], "xn"),
    ([("x", 0, 10), ("12", 4, 7)], "x^12"), ([("x", 0, 10), ("2", -2, 7), ("3", 4, 7)], "x2^3"),
    ([("a", 0, 10), ("1", 0, 7)], "a1"),
    ([("x", 0, 10), ("−12345", 4, 7)], "x^−12345"), ([("x", 0, 10), ("abcdef", -2, 7)], "xabcdef"),
])  # fmt: skip
def test_names_with_indices_and_powers_are_words(parts: list[tuple[str, float, float]], found: str) -> None:
    left, given = 0.0, list[Letter]()
    for text, higher, size in parts:
        given += letters(text, 100.0 + higher, left, size)
        left = given[-1].right
    assert texts(given) == [found]


def test_an_index_goes_to_the_nearer_of_two_lines() -> None:
    assert texts([*letters("x", 100.0), *letters("2", 95.5, 5.0, 7.0), *letters("y", 90.5)]) == ["x2", "y"]
    assert texts([*letters("x", 100.0), *letters("2", 95.0, 5.0, 7.0), *letters("y", 90.5)]) == ["x", "y^2"]


@pytest.mark.parametrize(("cells", "is_numbers"), [
    (["1", "2"], True), (["1"], False), (["1", "2", "a", "b"], True), (["1", "2", "a", "b", "c"], False), (["a", "b"], False),
    (["1", "a"], False),
])  # fmt: skip
def test_a_row_of_numbers_has_two_and_hardly_anything_else(cells: list[str], is_numbers: bool) -> None:
    assert row(*cells).is_numbers is is_numbers


@pytest.mark.parametrize(("text", "first"), [("12", 12.0), ("0,05", 0.05), ("0.05", 0.05), ("t", 0.0), ("-1", 0.0), ("1e3", 0.0)])
def test_the_first_number_of_a_row(text: str, first: float) -> None:
    assert _first(row(text, "5")) == first


HEAD, WORDS = row("t", "w1"), row("and", "then", "so")


@pytest.mark.parametrize(("lines", "found"), [
    ([WORDS, HEAD, row("0", "5"), row("1", "6")], [(0, 4)]), ([HEAD, row("0", "5")], []), ([row("0", "5", "6")], [(0, 1)]),
    ([*[WORDS] * 5, HEAD, row("0", "5"), row("1", "6")], [(2, 6)]),  # four lines above may be heads
    ([row("0", "5"), row("1", "6"), WORDS, WORDS, row("2", "7")], [(0, 5)]),
    ([row("0", "5"), row("1", "6"), WORDS, WORDS, WORDS, row("2", "7"), row("3", "8")], [(0, 2), (2, 5)]),
    ([row("0", "5"), row("1", "6"), HEAD, row("0", "7"), row("1", "8")], [(0, 2), (2, 3)]),  # the time begins again
    ([row("0", "5"), row("1", "6"), HEAD, row("2", "7"), row("3", "8")], [(0, 5)]),
    ([row("0", "5"), row("1", "6"), HEAD, row("2", "7", "1"), row("3", "8", "1")], [(0, 2), (2, 3)]),  # wider from here on
    ([row("0", "5"), row("1", "6"), HEAD, row("2", "7", "1"), row("3", "8")], [(0, 5)]),
    ([row("0", "5"), row("1", "6"), row("0", "7"), row("1", "8")], [(0, 4)]), ([WORDS], []), ([], []),
])  # fmt: skip
def test_rows_of_numbers_belong_together_with_the_heads_above_them(lines: list[PageLine], found: list[tuple[int, int]]) -> None:
    assert [(start, len(rows)) for start, rows in tables_in(lines)] == found


def test_words_go_into_the_columns_that_they_stand_over() -> None:
    body = [row("0", "5.25", "6"), row("1", "5.75", "7")]
    assert _rows([row("t", "w1", "w2", at=(0.0, 104.0, 199.0)), *body]) == [
        ["t", "w1", "w2"],
        ["0", "5.25", "6"],
        ["1", "5.75", "7"],
    ]
    assert _rows([row("both of them", at=(90.0,)), *body])[0] == ["", "both of them", ""]
    assert _rows([row("over all", at=(100.0,)), row("x" * 25, at=(90.0,)), *body])[:2] == [
        ["", "over all", ""],
        ["", "x" * 25, "x" * 25],
    ]
    assert _rows([row("far", at=(60.0,)), *body])[0] == ["", "far", ""] and _rows([row("far", at=(40.0,)), *body])[0] == [
        "far",
        "",
        "",
    ]
    assert _rows([row("1", "5", at=(0.0, 200.0)), *body])[0] == ["1", "", "5"]  # a cell is missing


@pytest.mark.parametrize(("gap", "found"), [(6.1, ["a b"]), (6.3, ["a", "b"])])
def test_words_that_a_blank_parts_are_one_cell(gap: float, found: list[str]) -> None:
    line = row("a", "b", at=(0.0, 5.0 + gap))
    assert [cell.text for cell in _cells(line)] == found
    assert [(cell.left, cell.right) for cell in _cells(line)][-1][1] == 10.0 + gap
    assert [cell.text for cell in _cells(row("1", "2", at=(0.0, 6.0)))] == ["1", "2"]


SPANS = [(0.0, 20.0), (24.0, 60.0), (64.0, 90.0)]


@pytest.mark.parametrize(("words", "starts", "found"), [
    (["t", "w1", "w2"], (0.0, 24.0, 64.0), ["t", "w1", "w2"]),  # their left edges stand over those of the columns
    (["t", "w1", "w2"], (15.0, 50.0, 80.0), ["t", "w1", "w2"]), (["t", "w1", "w2"], (8.0, 38.0, 70.0), ["t", "w1", "w2"]),
    (["t", "x", "y"], (0.0, 24.0, 64.0), ["t", "x", "y"]), (["all", "of", "them"], (0.0, 24.0, 64.0), ["all of them"]),
    (["time", "w1", "w2"], (0.0, 24.0, 64.0), ["time", "w1", "w2"]),
    (["time", "w1", "speed"], (0.0, 24.0, 64.0), ["time w1 speed"]),
    (["t", "w1", "w2"], (8.0, 16.0, 70.0), ["t w1 w2"]), (["t", "w1", "w2"], (3.0, 16.0, 64.0), ["t", "w1", "w2"]),
    (["t", "w1", "w2"], (8.0, 18.0, 77.0), ["t w1 w2"]), (["t", "w1", "w2"], (8.0, 18.0, 70.0), ["t", "w1", "w2"]),
    (["t", "w2"], (0.0, 64.0), ["t w2"]), (["w1"], (30.0,), ["w1"]),
])  # fmt: skip
def test_heads_of_neighbouring_columns_are_parted_but_no_title(
    words: list[str], starts: tuple[float, ...], found: list[str]
) -> None:
    line = row(*words, at=starts)
    cell = Word(" ".join(words), line.words[0].left, line.words[-1].right)
    assert [part.text for part in _parted(cell, line, SPANS)] == found
    if len(found) > 1:
        assert [(part.left, part.right) for part in _parted(cell, line, SPANS)] == SPANS


BESIDE = letters("y=", 97.0)  # the bar of its fraction lies 3 points above its base line
BAR = Bar(12.0, 32.0, 100.0)


def fraction(*, above: float = 102.0, below: float = 90.0, bar: Bar = BAR, beside: list[Letter] = BESIDE) -> list[str]:
    return texts(with_fractions([*letters("a+b", above, 14.0), *letters("cd", below, 17.0), *beside], [bar]))


def test_what_stands_above_and_below_a_bar_is_a_fraction_where_the_equation_goes_on() -> None:
    assert [" ".join(text.split()) for text in fraction()] == ["y= ((a+b)/(cd))"]


@pytest.mark.parametrize(("changes", "is_whole"), [
    ({"above": 115.9}, True), ({"above": 116.1}, False), ({"below": 84.1}, True), ({"below": 83.9}, False),
    ({"above": 99.9}, False),
    ({"bar": Bar(12.0, 35.9, 100.0)}, True), ({"bar": Bar(12.0, 36.1, 100.0)}, False),  # 9 points longer than a+b
    ({"beside": letters("y=", 99.4)}, True), ({"beside": letters("y=", 99.6)}, False), ({"beside": letters("y=", 95.6)}, True),
    ({"beside": letters("y=", 95.4)}, False), ({"beside": letters("y=", 97.0, -12.9)}, True),
    ({"beside": letters("y=", 97.0, -13.1)}, False),
    ({"beside": letters("y=", 97.0, 46.9)}, True), ({"beside": letters("y=", 97.0, 47.1)}, False), ({"beside": []}, False),
    ({"bar": Bar(15.4, 32.0, 100.0)}, True), ({"bar": Bar(15.6, 32.0, 100.0)}, False), ({"bar": Bar(12.0, 27.6, 100.0)}, True),
    ({"bar": Bar(12.0, 27.4, 100.0)}, False),
])  # fmt: skip
def test_a_bar_is_that_of_a_fraction_inside_these_limits(changes: dict[str, object], is_whole: bool) -> None:
    found = fraction(**changes)  # type: ignore[arg-type]
    assert any("(a+b)/(cd)" in line for line in found) is is_whole, found


def test_a_fraction_inside_another_is_put_together_first() -> None:
    inner = [*letters("p", 119.0, 24.0, 7.0), *letters("q", 107.0, 24.0, 7.0), *letters("a+", 113.0, 12.0, 7.0)]
    found = with_fractions(
        [*inner, *letters("c", 90.0, 20.0), *letters("y=", 97.0, -2.0)], [Bar(10.0, 32.0, 100.0), Bar(23.0, 29.0, 115.0)]
    )
    assert [" ".join(line.split()) for line in texts(found)] == ["y= ((a+ ((p)/(q)))/(c))"]
    assert with_fractions(BESIDE, []) == BESIDE


def test_a_number_that_is_broken_at_the_end_of_its_cell_is_put_together() -> None:
    """Word breaks -16.6542 after its minus, and after as many digits as the column holds; a page's number below is no rest."""
    lines = [row("0.00", "5.5518", "-"), row("16.65", at=(200.0,)), row("42", at=(200.0,)), row("0.02", "5.3995", "14.112"),
             row("8", at=(200.0,)), row("0.04", "4.9981", "11.0328")]  # fmt: skip
    end = [row("0.06", "4.3916", "-"), row("7.9410", at=(200.0,)), row("3", at=(100.0,))]
    ((_, found),) = tables_in([*lines, *end])
    assert [cells[-1] for cells in found] == ["-16.6542", "14.1128", "11.0328", "-7.9410"]
    assert [cells[1] for cells in found] == ["5.5518", "5.3995", "4.9981", "4.3916"]
