"""The page of a class counts as one counts by hand, and counts who needs a look."""

from __future__ import annotations

from typing import Any

import pytest

from coursework.grading.pages.class_facts import ClassFacts
from coursework.grading.pages.class_page import _tenths, class_page
from coursework.words.sentences import load_phrases


@pytest.mark.parametrize(("most", "scores", "counts"), [
    (60.0, [0, 5.9, 6, 29.9, 30, 53.9, 54, 59.9, 60], [2, 1, 0, 0, 1, 1, 0, 0, 1, 3]),
    (100.0, [100, 100, 99, 9.99, 10], [1, 1, 0, 0, 0, 0, 0, 0, 0, 3]), (0.5, [0.05, 0.26], [0, 1, 0, 0, 0, 1, 0, 0, 0, 0]),
    (0.0, [0.0], [1, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
])  # fmt: skip
def test_scores_lie_in_the_tenths_of_the_points(most: float, scores: list[float], counts: list[int]) -> None:
    tenths = _tenths(scores, most, load_phrases("en"))
    assert [count for _, count in tenths] == counts
    if most == 60:
        assert [label for label, _ in tenths][:2] == ["0–6", "6–12"] and tenths[-1][0] == "54–60"


def entry(who: str, sha256: str, code: str = "", status: str = "graded") -> dict[str, Any]:
    file = {"name": "table.csv", "kind": "table", "bytes": 9, "sha256": sha256}
    return {
        "id": who, "name": who.title(), "variant": "31", "status": status, "score": 1.0 if status == "graded" else None,
        "max": 100.0, "page": None, "table": {"score": None, "first_wrong": None}, "equations": None, "answers": None,
        "misconception": {"code": code} if code else None, "first_wrong": None, "files": [file],
    }  # fmt: skip


@pytest.mark.parametrize(("shared", "look"), [(2, 4), (7, 2)])  # a file of most of the class was handed out
def test_work_that_is_alike_needs_a_look(shared: int, look: int) -> None:
    facts = ClassFacts()
    for number in range(shared):
        facts.add(entry(f"same{number}", "one"))
    facts.add(entry("ned", "two", "variant_ada"))
    facts.add(entry("pat", "three", status="unreadable"))
    facts.add(entry("ada", "four"))
    page = class_page(facts, [], [], load_phrases("en"))
    assert f"{shared + 3} submissions, {look} need your attention</h1>" in page
    assert page.count('<a href="#alike">work alike</a>') == look - 1
    assert page.count('id="alike"') == 1


@pytest.mark.parametrize(("name", "scores", "look"), [
    ("e.txt", (40.0, 40.0), 0), ("e.txt", (40.0, 32.0), 2), ("e.docx", (40.0, 40.0), 2),
])  # fmt: skip
def test_what_is_simply_right_is_alike_by_nature(name: str, scores: tuple[float, float], look: int) -> None:
    """Both typed the equations as the sheet writes them; it counts once one lost points, or if the file has a time of its own."""
    facts = ClassFacts()
    for who, score in zip(("ada", "bert"), scores, strict=True):
        one = entry(who, "one") | {"equations": {"score": score, "max": 40.0}}
        one["files"] = [{"name": name, "kind": "equations", "kinds": ["equations"], "bytes": 9, "sha256": "one"}]
        facts.add(one)
    assert facts.same_files == [["ada", "bert"]]  # a fact all the same
    page = class_page(facts, [], [], load_phrases("en"))
    assert f"2 submissions, {look} {'needs' if look == 1 else 'need'} your attention</h1>" in page
    assert page.count('<a href="#alike">work alike</a>') == look


def test_one_row_is_said_once_and_a_reader_of_the_screen_hears_the_numbers_of_a_strip() -> None:
    facts = ClassFacts()
    for who, row in (("ada", 10), ("bob", 10), ("eva", 4), ("li", 4), ("pat", 4)):
        facts.add(entry(who, who) | {"first_wrong": {"row": row, "column": "phi1"}})
        page = class_page(facts, [], [], load_phrases("en"))
        if who == "bob":
            assert page.count(">10</text>") == 1  # not at both ends of the axis, too
            assert 'aria-label="Where tables go wrong first: 10"' in page
            assert '<table aria-label="Everyone">' in page and 'class="parts"' not in page  # all are marked: said above
    assert 'aria-label="Where tables go wrong first: 4 – 10; 4"' in page
