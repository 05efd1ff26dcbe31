"""The longest text in which programs are read for systems and vectors: the last character that it may have, and one more."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from coursework.grading.reading.equations.formulas.meanings import put_in
from coursework.grading.reading.equations.formulas.names_in_text import spellings_of
from coursework.grading.reading.equations.notation.latex_names import with_own_commands
from coursework.grading.reading.equations.systems.matrices import in_rows
from coursework.grading.reading.equations.systems.vectors import with_entries_named
from coursework.variant.formula.reader import parse
from coursework.variant.formula.tree import Formula
from tests.grading.scenes import expected


def entries_named(text: str) -> str:
    task = expected()
    return with_entries_named(text, task.variant, spellings_of(task.variant, task.grid.units))


READERS: dict[str, tuple[Callable[[str], str], str, str, int]] = {
    "a system": (in_rows, "A = [a, b; c, d]; k = [e; f];\nw1, w2 = np.linalg.solve(A, k)\n", "(a)*(w1)", 200_000),
    "a vector": (entries_named, "import numpy as np\n# y = [phi3, phi2, phi1]\nw4 = 2*np.cos(y[0])\n", "cos(phi3)", 200_000),
    "a vector of sines": (
        entries_named, "import numpy as np\n# y = [phi3, phi2, phi1]\ns = np.sin(y)\nw4 = 2*s[0]\n", "sin(y[0])", 200_000,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", READERS)
def test_a_text_is_read_up_to_its_longest_and_left_beyond(name: str) -> None:
    read, text, told, most = READERS[name]
    for length, is_read in ((most, True), (most + 1, False)):
        padded = text + " " * (length - len(text))
        assert (told in read(padded)) is is_read, length


def test_a_command_is_put_in_while_the_text_stays_short_enough() -> None:
    """Each use is counted with what it may grow by, the name itself left in: 8 characters for an omega of 7 with its sign."""
    head, body = r"\newcommand{\om}{\omega}", r"\omega"
    room = 200_000 - len(body)
    for length, is_read in ((room, True), (room + 1, False)):
        found = with_own_commands(head + r"\om" + " " * (length - len(r"\om")))
        assert (body in found.replace(head, "")) is is_read, length


def test_a_meaning_is_put_in_while_the_formula_stays_as_small_as_a_typed_one() -> None:
    """500 nodes: a sum of 125 parts has 249 of them, one of 126 has 251, and a sign is one more."""
    k, j = (parse("+".join(["w1"] * count)) for count in (125, 126))
    for meant, is_put_in in ((j, True), (Formula("neg", (j,)), False)):
        assert (put_in(parse("2*k + j"), {"k": k, "j": meant}) is not None) is is_put_in
