"""`coursework precheck`: how a file is understood and where it contradicts itself, and no number of the key."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import coursework
from coursework.commands.cli import main
from coursework.words.data_folders import folder
from tests.grading.batch.classroom import EQUATIONS, csv
from tests.grading.marking import students
from tests.mechanisms.library import mechanism


def precheck(place: Path, table: bytes | None, equations: str = "\n".join(EQUATIONS), *options: str) -> Result:
    paths = []
    for name, content in (("table.csv", table), ("equations.txt", equations.encode())):
        if content:
            (place / name).write_bytes(content)
            paths.append(str(place / name))
    return CliRunner().invoke(main, ["precheck", *paths, *(options or ("--variant", "31"))])


def test_a_right_submission_is_understood(tmp_path: Path) -> None:
    found = precheck(tmp_path, csv(students.table()))
    assert found.exit_code == 0, found.output
    assert "cells separated by “;”, decimal mark “,”.\n" in found.output
    assert re.search(r"w4 +column 8, identified by its header", found.output)
    assert "Rows: 25 of 25. At least 3 decimals are asked for." in found.output
    assert "Equations: 4 lines, 0 that cannot be read." in found.output


def test_cells_with_residuals_are_read_as_they_are_marked(tmp_path: Path) -> None:
    """Each was told to be the value of w1, which makes a right equation false."""
    cells = "\n".join(f"={line.removesuffix(' = 0')}" for line in EQUATIONS)
    found = precheck(tmp_path, csv(students.table()), cells)
    assert found.exit_code == 0, found.output
    assert "Equations: 4 lines, 0 that cannot be read." in found.output
    assert len(re.findall(r"line \d is read as 0 = ", found.output)) == 4


def test_a_dash_that_is_left_out_is_told(tmp_path: Path) -> None:
    """A sign seemed lost where dashes stand before all lines; where the dash is read as a minus nothing is said."""
    told = "A dash before a line counts as a minus or as the mark of a list"
    lines = "\n".join(f"- {line}" for line in EQUATIONS)
    assert told in precheck(tmp_path, csv(students.table()), lines).output
    assert told not in precheck(tmp_path, csv(students.table())).output
    assert told not in precheck(tmp_path, None, "-r3*w3*sin(phi3) = VMy - r3*w4").output


def test_a_table_that_lies_on_its_side_is_said_to_have_been_turned(tmp_path: Path) -> None:
    cells = [line.split(";") for line in csv(students.table()).decode().splitlines()]
    found = precheck(tmp_path, "\n".join(";".join(column) for column in zip(*cells, strict=True)).encode())
    assert "cells separated by “;”, decimal mark “,”, transposed.\n" in found.output
    assert "Rows: 25 of 25." in found.output


def test_the_first_contradiction_is_told_with_the_students_own_numbers_alone(tmp_path: Path) -> None:
    table = students.table()
    table[7:, 1] += 0.2
    found = precheck(tmp_path, csv(table))
    assert found.exit_code == 0  # every part can be marked
    assert "Row 8: phi2 does not follow from your own row 7 and its w2" in found.output
    printed = {text.replace(",", ".") for text in re.findall(r"-?\d+,\d+", csv(table).decode())}
    row = next(line for line in found.output.splitlines() if "Row 8" in line)
    before, speed = table[6, 1], table[6, 4]  # phi2 stands second, w2 behind three angles and w1
    numbers = [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", row.partition("its w2:")[2])]
    assert numbers == pytest.approx([before, 0.02, speed, before + 0.02 * speed, table[7, 1]], abs=1e-4)
    assert {f"{numbers[place]:.4f}" for place in (0, 2, 4)} <= printed


@pytest.mark.parametrize("lacks", ["nothing", "the angles", "one angle", "digits"])
def test_steps_are_said_to_follow_only_where_all_can_be_judged(tmp_path: Path, lacks: str) -> None:
    content = csv(students.table(), 1 if lacks == "digits" else 4)
    gone = {"the angles": (1, 2, 3), "one angle": (2,)}.get(lacks, ())
    kept = [[cell for place, cell in enumerate(line.split(b";")) if place not in gone] for line in content.split(b"\n")]
    found = precheck(tmp_path, b"\n".join(map(b";".join, kept)))
    assert "Rows: 25 of 25." in found.output
    assert ("Every step of the angles follows from your own row before." in found.output) == (lacks == "nothing")


def test_wrong_velocities_are_not_betrayed(tmp_path: Path) -> None:
    """A table that follows from itself is told so, whatever the key says."""
    table = students.table(printed=lambda t, q: students.velocities(t, q, r1=1.1))
    found = precheck(tmp_path, csv(table))
    assert found.exit_code == 0
    assert found.output == precheck(tmp_path, csv(students.table())).output


def test_turning_counted_clockwise_is_said_and_contradicts_nothing(tmp_path: Path) -> None:
    table = students.table()
    table[:, 3:] *= -1
    found = precheck(tmp_path, csv(table))
    assert found.exit_code == 0
    assert "Rotation is counted clockwise throughout" in found.output
    assert "does not follow" not in found.output
    table[7:, 1] += 0.2
    assert "Row 8: phi2 does not follow" in precheck(tmp_path, csv(table)).output


@pytest.mark.parametrize(
    ("table", "equations", "told"),
    [
        (csv(students.table()[:20]), "", "Rows: 20 of 25"), (csv(students.table(), 1), "", "few decimals to be marked"),
        (b"%PDF-1.7", "", "Table: not read. The file is really PDF"), (None, EQUATIONS[0], "Table: not read."),
        (csv(students.table()), "r1*wq = 0", 'symbol "wq" is not declared'),
        (csv(students.table()).replace(b";w4", b";V_M"), "", "without numbers in the file: w4"),
        (csv(students.table()).replace(b";w4", b";total"), "", "The columns headed total may be w4"),
        (csv(students.table()).replace(b";3,3700", b";"), "", "can be read: 1; the first is phi2 in row 1."),
        (csv(students.table()).replace(b";3,37", b";<3,37"), "", "the first is phi2 in row 1: “<3,37"),
        (csv(students.table()), "", "Equations: none handed in."),
    ],
)  # fmt: skip
def test_what_could_not_be_marked_is_told(tmp_path: Path, table: bytes | None, equations: str, told: str) -> None:
    found = precheck(tmp_path, table, equations)
    assert found.exit_code == 1, found.output
    assert told in found.output


@pytest.mark.parametrize("prose", [
    "The ratio of lengths = 2 was taken from the sheet.", "hence the result = good", "Отношение длин = 2 взято из листа.",
    "长度之比 = 2 取自任务书", "Note: step = 0.02 as the sheet says; r1 is a length",
])  # fmt: skip
def test_a_sentence_with_a_sign_of_equality_is_no_equation_that_could_not_be_read(tmp_path: Path, prose: str) -> None:
    found = precheck(tmp_path, csv(students.table()), "\n".join([*EQUATIONS, prose]))
    assert found.exit_code == 0, found.output


@pytest.mark.parametrize("line", ["r1*wq = 0", "r1*omega*sine(alpha1) + foo = 0", "r2*w2*sin(phi2 + r1 is wrong = 0"])
def test_an_equation_that_cannot_be_read_is_no_sentence(tmp_path: Path, line: str) -> None:
    assert precheck(tmp_path, csv(students.table()), "\n".join([*EQUATIONS, line])).exit_code == 1


def test_equations_of_motion_are_not_asked_for(tmp_path: Path) -> None:
    """A person marks them."""
    run = coursework.solve("falling-arm", scheme="euler")
    table = run.table.to_csv().encode()
    found = precheck(tmp_path, table, "", "--variant", "falling-arm")
    assert "Equations: none handed in." in found.output
    assert found.exit_code == 0, found.output


def test_forms_that_were_mended_are_shown(tmp_path: Path) -> None:
    found = precheck(tmp_path, csv(students.table()), "2r3·ω3·sin φ3 − r3ω3cos φ3 + 0,5r3w4 = 0")
    assert found.exit_code == 0
    line = next(line for line in found.output.splitlines() if "0.5 * r3 * w4" in line)
    assert "sin(phi3)" in line


def test_a_variant_that_stops_at_once_is_at_fault_and_not_the_column_of_times(tmp_path: Path) -> None:
    """At tan(phi3) = -2 the first block is singular."""
    dead = (folder("variants") / "31.toml").read_text(encoding="utf-8").replace("2.87 rad", "2.034443935795703 rad")
    (tmp_path / "dead.toml").write_text(dead, encoding="utf-8")
    found = precheck(tmp_path, csv(students.table()), "", "--variant", str(tmp_path / "dead.toml"))
    assert (found.exit_code, found.output.count("G006"), found.output.count("Check the column")) == (2, 1, 0)


def test_the_variant_is_asked_for(tmp_path: Path) -> None:
    found = precheck(tmp_path, csv(students.table()), "", "--language", "en")
    assert found.exit_code == 2
    assert "--variant" in found.stderr


FOUR_BAR = mechanism(
    "four-bar", ('"0 deg"', '"60 deg"'), ("phi2", "phij"), ('"w2"', '"wj"'), ("phi3", "theta_3"), ('"w3"', '"w_3"'), r2="0.3 m",
    d="0.3 m", n="20 rpm", end="0.5 s", period=None,
)  # fmt: skip


def test_a_person_reads_letters_as_pages_set_them_and_a_program_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """On a terminal φ₁, ω₃; behind a pipe, as README's first example has it, the names of the file."""
    (tmp_path / "own.toml").write_text(FOUR_BAR, encoding="utf-8")
    result = CliRunner().invoke(main, ["run", str(tmp_path / "own.toml"), "--scheme", "euler", "--format", "csv",
                                       "--out", str(tmp_path / "out")])  # fmt: skip
    assert result.exit_code in (0, 1), result.output
    lines = [line.split(",") for line in (tmp_path / "out" / "table.csv").read_text(encoding="utf-8").splitlines()]
    lines[5][3] = str(float(lines[5][3]) + 0.2)
    table = "\n".join(",".join(line[:5] + line[6:]) for line in lines).encode()  # wj is not handed in
    options = ("--variant", str(tmp_path / "own.toml"))
    piped = precheck(tmp_path, table, "", *options).output
    monkeypatch.setattr("coursework.commands.line.screen.is_terminal", lambda: True)
    shown = precheck(tmp_path, table, "", *options).output
    assert "theta_3  column" in piped
    assert re.search(r"\n  θ₃ {7}column", shown)
    assert "Row 5: theta_3 does not follow from your own row 4 and its w_3" in piped
    assert "Row 5: θ₃ does not follow from your own row 4 and its ω₃" in shown
    assert ("without numbers in the file: wj." in piped, "without numbers in the file: ω_j." in shown) == (True, True)
    assert ("phij" in piped, "φ_j" in shown, "phij" in shown) == (True, True, False)
