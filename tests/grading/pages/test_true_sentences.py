"""Every sentence of a class with a known truth: counts are those of the files, what is named was changed, no one else is."""

from __future__ import annotations

import html
import json
import re

import numpy as np
import pytest

from coursework.grading.marking.reasons.reason import misconception_sentence
from tests.grading.batch.classroom import EQUATIONS, NAMES
from tests.grading.marking import students
from tests.grading.pages.dead_words import every_key, unsaid
from tests.grading.pages.seen import Seen, plain, seen_of
from tests.grading.pages.truths import RIGHT, ROWS, Case, cases

PARTS = {"table": 60.0, "equations": 40.0}
COUNTS = re.compile(
    r"Of (\d+) cells that count, wrong: (\d+); missing or with too few digits: (\d+); "
    r"not the key’s, .*?: (\d+); as in the key: (\d+)\."
)
ALONE = re.compile(r"One by one, the cells would earn ([\d.]+) points\.")
SUM = re.compile(r"(Table|Equations): ([\d.]+) of ([\d.]+) points")
FACTORS = re.compile(r"\(([\d.]+) · ([\d.]+) ([·/]) ([\d.]+)\)")
START = re.compile(r"Start values in row 1 that are not those of the task: (\d+)\.")
SHUT = re.compile(r"(?:but do not count).*?: (\d+)\.")


@pytest.fixture(scope="module")
def handed_in() -> dict[str, Case]:
    return cases()


@pytest.fixture(scope="module")
def seen_and_said(handed_in, tmp_path_factory) -> tuple[dict[str, Seen], set[str]]:
    """What each student was told, and the keys of all sentences that were said for it."""
    with every_key() as said:
        return seen_of(handed_in, tmp_path_factory.mktemp("truth")), said


@pytest.fixture(scope="module")
def seen(seen_and_said) -> dict[str, Seen]:
    return seen_and_said[0]


def test_every_state_below_full_points_says_why_in_every_place(seen):
    for student, told in seen.items():
        assert len(told.raw.encode()) <= 40_000, student
        if told.row["points"] == "100.00":
            assert told.row["sentence"] == told.comment == "", student
            continue
        assert told.row["sentence"], student
        assert told.comment == told.row["sentence"], student
        for sentence in re.split(r"(?<=[.:”]) (?=[A-Z])", told.row["sentence"]):
            assert plain(html.escape(sentence)).strip(" ’'") in told.page.replace(" .", "."), (student, sentence)
        for part, most in PARTS.items():
            if told.row[part] and float(told.row[part]) < most and told.row["status"].startswith("graded"):
                assert f"{part.title()}: {float(told.row[part]):g} of {most:g} points" in told.row["sentence"], student
        texts = json.loads(told.platform)
        said = " ".join([texts["output"], *(test["output"] for test in texts["tests"])])
        assert all(word in said for word in told.row["sentence"].split()), student


def test_a_confusion_is_told_in_the_words_of_the_rubric(seen):
    assert "r1 was taken with a value other than the task’s: AB for DA. " in seen["confused"].row["sentence"]


def test_counts_are_those_of_the_files(seen, handed_in):
    start = {(0, column) for column in range(3)}
    counted = 0
    for student, (_, truth) in handed_in.items():
        for cells, wrong, missing, carried, right in COUNTS.findall(seen[student].row["sentence"]):
            counted += 1
            starts = sum(map(int, START.findall(seen[student].row["sentence"])))
            assert int(cells) == ROWS * 7 - 3 == sum(map(int, (wrong, missing, carried, right)))
            if truth.wrong is not None and truth.counted:
                assert int(wrong) == len(truth.wrong - start), student
                assert starts == len(truth.wrong & start), student
            if truth.counted:
                assert int(missing) == len(truth.absent - start), student
    assert counted > 10  # tables of another step or scheme earn a share, and tell one sum
    assert not COUNTS.search(seen["right"].row["sentence"])
    assert not COUNTS.search(seen["start"].row["sentence"])  # its points do not come from the cells


def test_cells_right_from_own_numbers_are_those_off_the_key(seen):
    """Counted here: what is neither the key's to the last printed place nor wrong."""
    slack = 0.505e-4 + 2e-4 * np.ptp(RIGHT, axis=0)
    for student, table in (("slip", students.slip(10, 1, 1.05)), ("m-sign-w1", students.signed(0))):
        off = np.abs(np.round(table, 4) - RIGHT) > slack
        _, wrong, _, carried, _ = map(int, COUNTS.search(seen[student].row["sentence"]).groups())
        assert wrong + carried == int(off[1:].sum() + off[0, 3:].sum()), student


def test_sums_give_the_points_and_name_every_cell_that_does_not_count(seen):
    sums = 0
    for student, told in seen.items():
        text = told.row["sentence"]
        for part, points, most in SUM.findall(text):
            sums += 1
            assert float(points) == float(told.row[part.lower()]), student
            first, second, sign, third = FACTORS.search(text[text.index(f"{part}: {points} of") :]).groups()
            value = float(first) * float(second) * (float(third) if sign == "·" else 1 / float(third))
            assert float(first) == float(most)
            assert value == pytest.approx(float(points), abs=0.0051), student
        if found := re.search(r"of the (\d+) cells ([\d.]+) count", text):
            _, wrong, missing, *_ = map(int, COUNTS.search(text).groups())
            shut = sum(map(int, SHUT.findall(text)))
            start = sum(map(int, START.findall(text)))
            assert max(int(found[1]) - wrong - missing - shut - start, 0) == int(found[2]), student
    assert sums > 30


def test_what_the_cells_would_earn_one_by_one_is_less_and_stands_alone(seen):
    """Where another rule earns more, three counts of one table could not be reconciled: one sum is told, and what it beats."""
    told = {student: one.row["sentence"] for student, one in seen.items() if ALONE.search(one.row["sentence"])}
    for student, text in told.items():
        assert float(SUM.search(text)[2]) > float(ALONE.search(text)[1]), student
        assert not re.search("Of [0-9]+ cells that count|but do not count|by themselves", text), student
    assert len(told) >= 3 and "start" in told


def test_what_is_named_was_changed(seen, handed_in):
    for student, (_, truth) in handed_in.items():
        told = seen[student].row
        cell = re.match(r"row (\d+) (\w+)", told["first_wrong"])
        named = re.search(r"Row (\d+): .*?\b(phi\d|w\d)\b", told["sentence"])
        if truth.wrong:
            place = (int(cell[1]) - 1, NAMES.index(cell[2]))
            assert place in truth.wrong, student
            assert place[0] == min(row for row, _ in truth.wrong), student
        elif truth.wrong is not None:
            assert not told["first_wrong"], student
        marked = re.search(r'<tr><th scope="row">(\d+)<td>(?:(?!<tr>).)*? id="first"', seen[student].raw, re.DOTALL)
        assert (marked and marked[1]) == (cell and cell[1]), student  # the cell that "show it" leads to
        if cell:
            assert f"Row {cell[1]}: " in told["sentence"]
            assert cell[2] in told["sentence"]
            assert named, student
        for sentence in truth.said:
            assert sentence in told["sentence"] or sentence in seen[student].page, (student, sentence)
        if truth.code:
            assert told["misconception"] == truth.code or truth.code in seen[student].page or told["misconception"], student
    assert "columns phi1 and phi2 were exchanged." in seen["m-swapped-columns"].row["sentence"]


def test_lines_and_signs_are_those_that_were_changed(seen, handed_in):
    for student, (files, truth) in handed_in.items():
        told = seen[student].row["sentence"]
        for key, lines in (("is not right", truth.lines), ("earns nothing", truth.idle), ("could not be read", truth.unread)):
            found = re.findall(rf"Line (\d+) of the equations {key}", told)
            assert tuple(map(int, found)) == lines, (student, key)
        if truth.sign:
            line, column = truth.sign
            handed_in_line = files["equations.txt"].decode().split("\n")[line - 1]
            behind = re.split(r" [-+=] ", handed_in_line[column:].strip())[0].replace(" ", "")
            term = re.search(rf"Line {line} of the equations is not right. A different sign of (.+?) would make it right", told)
            assert term and ("\\" in behind or term[1] == behind), student  # of LaTeX as it was read
            assert handed_in_line[column - 1] in "+-"


def test_steps_said_to_follow_euler_do(seen, handed_in):
    """Counted here from the printed numbers: a step is the angle before and the step times the velocity before."""
    said = re.compile(r"All (\d+) steps|Of (\d+) steps of the coordinates (\d+) follow")
    for student, (files, _) in handed_in.items():
        if (
            student.startswith(("degrees", "long", "no-column"))
            or "table.csv" not in files
            or not (found := said.search(seen[student].page))
        ):
            continue
        rows = [line.replace(",", ".").split(";") for line in files["table.csv"].decode().splitlines()[1:]]
        table = np.full((ROWS, 6), np.nan)
        for row in rows:
            table[round(float(row[0]) / students.H)] = [cell or "nan" for cell in row[1:7]]
        decimals = len(rows[1][1].partition(".")[2])
        speeds = np.maximum(np.abs(table[:-1, 3:6]), 0.05 * np.ptp(RIGHT[:, 3:6], axis=0))
        allowed = 0.505 * (2 + students.H) * 10.0**-decimals + 2e-4 * students.H * speeds
        follow = np.abs(table[1:, :3] - table[:-1, :3] - students.H * table[:-1, 3:6]) <= allowed + 1e-12
        steps, held = int(found[1] or found[2]), int(found[1] or found[3])
        told = np.isfinite(table[1:, :3] + table[:-1, :3] + table[:-1, 3:6])
        assert (held, steps) == (int(follow.sum()), int(told.sum())), student


def test_nobody_else_is_named(seen):
    everybody = [*(f"id-{student}" for student in seen), *(told.row["name"] for told in seen.values())]
    named = "|".join(map(re.escape, [*everybody, "zz-other", "Zed", "Zzyzx", "s02"]))
    anybody = re.compile(rf"(?<![\w-])(?:{named})(?![\w-])")  # all looked for at once: a page is read through once
    assert anybody.findall(f"Dear {everybody[-1]}, {everybody[0]} and s02.") == [everybody[-1], everybody[0], "s02"]
    for student, told in seen.items():
        for place in (told.raw, told.row["sentence"], told.comment, told.platform):
            assert {*anybody.findall(place)} <= {f"id-{student}", told.row["name"]}, student
    assert "the table belongs to another variant of the class" in seen["another"].page
    assert seen["another"].row["misconception"] == "variant_s02"


def test_what_was_never_said_truly_is_gone(seen):
    for student, told in seen.items():
        for phrase in ("too many to be slips", "slips of the pen", "rows of the task.", "do not follow Euler", "too few to show"):
            assert phrase not in told.page, (student, phrase)
        assert ("No usual cause" in told.page) == (student in {"forty", "zeros", "repeated"}), student
    assert "are not marked yet" in seen["unread"].page
    assert "of the 4 needed" not in seen["unread"].page
    assert "4: Could not be read for certain; your instructor will look at it." in seen["unread"].platform, (
        "a question, on a platform too"
    )
    assert EQUATIONS[0] in seen["unread"].page


def test_every_sentence_about_grades_is_said_in_some_case(seen_and_said, tmp_path):
    """What nobody can be told is not kept; what the class above was told is not asked a second time."""
    assert unsaid(seen_and_said[1], tmp_path) == []


def test_a_student_is_never_told_whose_table_it_is():
    assert "s02" in misconception_sentence("variant_s02")
    assert "s02" not in misconception_sentence("variant_s02", for_student=True)
    assert "l_1, l_2" in misconception_sentence("swap_l_1_l_2")
