"""What stays on one line of the screen: found in every language, never longer than a line, and nothing of the text lost."""

from __future__ import annotations

import pytest

from coursework.words import line_ends
from coursework.words.line_ends import KEPT, LONGEST, line_groups, marked


def kept(sentence: str) -> list[str]:
    return [piece.split(KEPT[1])[0] for piece in marked(sentence).split(KEPT[0])[1:]]


@pytest.mark.parametrize(
    ("sentence", "together"),
    [
        ("an error of 70 % (row 20)", ["70 %", "row 20"]),
        ("an error of 70\u202f% (row\u200920)", ["70\u202f%", "row\u200920"]),
        ("h = 0.02 s, steps: 24", ["h = 0.02 s,", "steps: 24"]),
        ("with h = {h} s in row {row}", ["h = {h} s", "row {row}"]),
        ("the speed V/ω₀ and −2 φ1", ["V/ω₀", "−2 φ1"]),
        ("ошибка 21 % в строке 4, 2,5 рад/с", ["21 %", "строке 4,", "2,5 рад/с"]),
        ("步长 h = 0.02 s，误差 21 %", ["h = 0.02 s", "21 %"]),
        ("(14) = (12) + (16); (15) = (11) + (18)", ["(14) = (12) + (16);", "(15) = (11) + (18)"]),
        ("row i + 1 belongs to t = i · h with", ["i + 1", "t = i · h"]),
        ("within round-off by Runge-Kutta 4.", ["round-off", "Runge-Kutta 4"]),
        ("为四阶龙格-库塔法 24 步的 2.8 倍", ["格-库"]),
        ("a = b = c", ["a = b = c"]),
        ("speed_of_the_block = twice_its_part = 4", ["speed_of_the_block =", "twice_its_part ="]),
        ("in pv o′·0,05 (м/с)/мм и", ["(м/с)/мм"]),
        ("F = D + (62.5, 70) mm, at 4.9·10−4 m", ["F = D + (62.5, 70) mm", "4.9·10−4 m"]),
        ("Δ = −r sin(φ2 − φ3) is zero", ["Δ = −r sin(φ2 − φ3)"]),
        ("of these forces, 1 mm = 0.2 N. Thick", ["1 mm = 0.2 N."]),
        ("1 мм = 2 Н и ещё", ["1 мм = 2 Н"]),
        ("In 24 steps and 3 seconds, as said: well", []),
    ],
)
def test_what_belongs_together(sentence: str, together: list[str]) -> None:
    assert kept(sentence) == together


def test_what_is_longer_than_a_line_may_break() -> None:
    short, long = (f"{'a' * size}/{'b' * (LONGEST // 2)}" for size in (LONGEST // 2 - 1, LONGEST // 2))
    assert kept(short) == [short]
    assert kept(long) == []


@pytest.mark.long
def test_runs_lose_nothing_and_a_symbol_stays_with_its_quotient() -> None:
    runs = [{"t": "where V/"}, {"v": "ω", "s": "0"}, {"t": " is 5 m", "lang": ""}, {"t": " long"}]
    groups = line_groups(runs)
    texts = [(group.kept, "".join(run.get(key, "") for run in group.runs for key in "tvs")) for group in groups]
    assert texts == [(False, "where "), (True, "V/ω0"), (False, " is "), (True, "5 m"), (False, " long")]
    assert [run for group in groups for run in group.runs if "lang" in run] == [
        {"t": " is ", "lang": ""}, {"t": "5 m", "lang": ""}
    ]  # fmt: skip


@pytest.mark.parametrize(("last", "kept"), [(10, (0, 30)), (11, (0, 20))])
def test_pieces_that_overlap_are_one_of_thirty_characters_at_most(
    last: int, kept: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(line_ends, "_TOGETHER", (("x", "x+y+"), ("y", "y+z+")))
    assert line_ends._together("x" * 10 + "y" * 10 + "z" * last + " 1 + 2") == (kept,)


@pytest.mark.parametrize(("size", "kept"), [(30, ((0, 30),)), (31, ())])
def test_a_piece_has_thirty_characters_at_most(
    size: int, kept: tuple[tuple[int, int], ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(line_ends, "_TOGETHER", (("w", "w+"),))
    assert line_ends._together("w" * size + " 1 + 2") == kept
