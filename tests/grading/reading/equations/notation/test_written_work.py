"""Equations in prose, numbered, over several lines, of mechanisms in no catalogue: right or a question, no slip ever right."""

import re
from functools import cache

import pytest

from tests.grading.reading.equations.notation.notations import PLAIN
from tests.grading.reading.equations.notation.test_notations import marked
from tests.grading.reading.equations.notation.written_work import FORMS
from tests.sample import first

OWN = ("geared", "offset")
# Where a dash stands before each line, turning the second of two signs is turning both.
DASHES = {form for form in FORMS if re.search(r"[-–—] ?\{e\}$", form)}


def turned(text):
    """The text with one sign turned, each in turn."""
    for found in re.finditer(r"(?<= )[-+](?= )", text):
        yield text[: found.start()] + {"-": "+", "+": "-"}[found[0]] + text[found.end() :]


@cache
def right(form, name):
    """The marks of right equations in a form."""
    return marked(FORMS[form](PLAIN[name]), name)


@pytest.mark.parametrize("part", first(1, range(3)))
@pytest.mark.parametrize(("place", "form"), [*enumerate(FORMS)])
def test_right_equations_are_right_or_a_question(place, form, part):
    for name in (*OWN, list(PLAIN)[len(form) % 3])[(place + part) % 3 :: 3]:
        found = right(form, name)
        told = [(mark.verdict, mark.line.text, mark.line.repaired) for mark in found.marks if mark.verdict != "right"]
        assert not found.wrong, told
        assert found.share == 1.0 or found.unread is not None, told


def test_hardly_any_form_is_a_question():
    tried = [(form, OWN[place % 3]) for place, form in enumerate(FORMS) if place % 3 < len(OWN)]  # as above
    asked = [each for each in tried if right(*each).share < 1.0]
    assert len(asked) <= 0.02 * len(tried), asked


@pytest.mark.parametrize("part", first(1, range(4)))
@pytest.mark.parametrize(("place", "form"), [*enumerate(FORMS)])
def test_a_turned_sign_is_never_right(place, form, part):
    """Each form in one of the mechanisms, by turns, and with `--long` in both."""
    name = OWN[(place + part) % 2]
    signs = [*turned(PLAIN[name])]
    wrong = signs[(len(form) + part // 2) % len(signs)]
    if not (form in DASHES and re.search(r"^\S+ - \S+ = 0$", wrong, re.MULTILINE)):
        assert marked(FORMS[form](wrong), name).share < 1.0, wrong


@pytest.mark.parametrize(
    "form", ["Am Punkt C gilt: {e}", "对点C有：{e}", "Для точки C имеем {e} (12)", "(3) Somit ist {e}", "{k}.) {e}", "–"]
)
def test_a_hint_points_at_the_sign_as_handed_in(form):
    for name in OWN:
        lines = PLAIN[name].split("\n")
        line = lines[-1]
        at = line.rindex(" + ") + 1 if " + " in line else line.rindex(" - ") + 1
        wrong = "\n".join([*lines[:-1], f"{line[:at]}{'-' if line[at] == '+' else '+'}{line[at + 1 :]}"])
        mark = marked(FORMS[form](wrong), name).marks[-1]
        assert (mark.verdict, mark.hint.kind) == ("wrong", "sign")
        shift = mark.line.text.index(line[0])
        assert mark.hint.column == shift + at + 1, (mark.line.text, mark.hint)
        assert mark.line.text[mark.hint.column - 1] in "+-–"
