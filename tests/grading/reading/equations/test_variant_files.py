"""A variant file handed in: its equations are read, its data are compared, and what is no TOML is one line with its number."""

from __future__ import annotations

import pytest

from tests.grading.reading.test_read_submission import read, table
from tests.grading.scenes import expected
from tests.mechanisms.library import mechanism


def variant_file(**changes: tuple[str, str]) -> bytes:
    return mechanism(expected().variant.name, *changes.values()).encode()


def test_of_a_variant_file_only_the_equations_are_used() -> None:
    content = variant_file(
        data=('r1    = "0.953 m"', 'r1    = "1 m"'), keys=("[given]", "score = 100\n\n[rubric]\npoints = 9\n\n[given]")
    )
    contents = read(("31.toml", content), ("t.csv", table()))
    assert contents.equations is not None
    assert [line.fault for line in contents.equations] == [None] * 4
    assert not any(line.guessed or line.may_be_datum or line.repaired for line in contents.equations)
    assert contents.equations[0].line == content.decode()[: content.decode().index("VMy - 2*r3")].count("\n") + 1
    assert contents.review is None
    notes = {note.code: note.text for note in contents.notes}
    assert "r1" in notes["data_differ"]
    assert "score, rubric" in notes["ignored_file"] or "score and rubric" in notes["ignored_file"]
    other = read(("x.toml", (expected("v101").variant.path or __file__).read_bytes()))  # type: ignore[union-attr]
    assert other.review == "Variant v101 was submitted, but 31 is assigned."


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (b"format = 1\ntitle = \"x\n", 2), (b"format = 1\n[given\n", 2), ("format = 1\ntitle = 'Привіт'".encode("cp1251"), 2),
        (b"format = 1\nr1 = 1\nr1 = 2\n", 3), (b"format = 1\nx = " + b"1" * 10_000, 0),
        (b"format = 1\n" + b"a." * 9_000 + b"b = 1", 2),
        (b"format = 1\nx = " + b"[" * 9_000, 2),
    ],
)  # fmt: skip
def test_a_variant_file_that_is_no_toml_is_one_line_with_its_number(content: bytes, line: int) -> None:
    contents = read(("mine.toml", content))
    assert contents.equations is not None
    (only,) = contents.equations
    assert only.fault is not None
    assert only.fault.line == line
    assert only.relates
    assert only.text.encode()[:8] == content.decode("utf-8", "replace").split("\n")[max(line, 1) - 1].encode()[:8]


@pytest.mark.parametrize(
    ("was", "is_now", "told"),
    [
        ('equation = "VMy', 'equatoin = "VMy', 'Did you mean "equation"?'), ("w3*cos(phi3) -", "w3*cos(phi3 -", ")"),
        ("2*r3*w3*sin(phi3) -", "2*r3*w3*zeta(phi3) -", "zeta"),
    ],
)  # fmt: skip
def test_an_equation_of_a_variant_file_that_cannot_be_read_is_a_question_to_the_teacher(was: str, is_now: str, told: str) -> None:
    """It cost its points, and no sentence said why."""
    contents = read(("mine.toml", variant_file(slip=(was, is_now))))
    assert contents.equations is not None
    (unread,) = (line for line in contents.equations if line.tree is None)
    assert len(contents.equations) == 4
    assert unread.relates
    assert unread.fault is not None
    assert told in str(unread.fault.message)


@pytest.mark.parametrize(
    ("equation", "relates"), [("w3 = (2", False), ("w3 = (r1", True), ("w3 = 2 +* w1", True), ("2 = (", False)]
)
def test_an_unread_equation_asks_the_teacher_if_it_relates_two_names(equation: str, relates: bool) -> None:
    contents = read(("mine.toml", f'format = 1\nconstraint = [{{equation = "{equation}"}}]\n[given]\nr1 = 0.953\n'.encode()))
    assert [(line.tree, line.relates) for line in contents.equations or ()] == [(None, relates)]


@pytest.mark.parametrize("junk", ['constraint = [1, "a", {equation = 5}, {equation = "w3 = 0"}]', "constraint = {equation = 1}"])
@pytest.mark.parametrize("value", ["true", '"0.9 foo"', '"1e999 m"', "[0.953]", "{value = 0.953}"])
def test_keys_of_another_kind_are_no_equations_and_data_of_another_kind_differ(junk: str, value: str) -> None:
    contents = read(("mine.toml", f"format = 1\n{junk}\n[given]\nr1 = {value}\nr2 = 0.847\n[coordinates]\nphi1 = 3\n".encode()))
    assert [line.text for line in contents.equations or ()] == ["w3 = 0"] * ("w3" in junk)
    (differ,) = (note.text for note in contents.notes if note.code == "data_differ")
    assert "r1" in str(differ) and "r2" not in str(differ) and "phi1" not in str(differ)


@pytest.mark.parametrize("off", [0.0, 0.01])
def test_a_start_that_is_another_differs(off: float) -> None:
    """Of three: the first as it is or not, the second the task's, the third left out."""
    first, second, _ = (one.start for one in expected().variant.coordinates)
    assert first is not None
    starts = f'phi1 = {{start = "{first + off!r} rad"}}\nphi2 = {{start = {second!r}}}\nphi3 = {{rate = "w3"}}\n'
    contents = read(("mine.toml", f"format = 1\n[given]\nr2 = 0.847\n[coordinates]\n{starts}".encode()))
    told = [str(note.text) for note in contents.notes if note.code == "data_differ"]
    assert len(told) == (1 if off else 0)
    assert not off or ("phi1" in told[0] and "phi2" not in told[0] and "phi3" not in told[0])
