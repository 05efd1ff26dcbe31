"""Of lines in trouble six are told one by one, of all others how many they are; why, in the language of who reads it."""

from types import SimpleNamespace

import pytest

from coursework.grading.marking.equations.marks import Hint
from coursework.grading.marking.reasons import equations
from coursework.variant.formula.reader import parse_equation
from coursework.variant.formula.tree import FormulaFault
from coursework.words.sentences import languages, load_phrases, say


@pytest.mark.parametrize(("wrong", "asked", "told"), [(2, 0, 2), (4, 2, 6), (5, 2, 6), (0, 9, 6)])
def test_six_lines_are_told_one_by_one(monkeypatch, wrong, asked, told):
    monkeypatch.setattr(equations, "_line", lambda mark: mark.name)
    # wrong, or right and worth nothing
    kinds = [("wrong", ""), ("right", "repeats"), ("wrong", "lacks"), ("rounded", "follows"), ("closure", "repeats")]
    lines = [SimpleNamespace(verdict=kind, lack=lack, name=f"{kind} {lack}") for kind, lack in kinds[:wrong]]
    others = [
        SimpleNamespace(verdict=kind, lack=lack, name=kind)
        for kind, lack in (("right", ""), ("closure", ""), ("unreadable", "x"))
    ]
    questions = [SimpleNamespace(name=f"asked {k}") for k in range(asked)]
    found = list(equations.equation_reasons(SimpleNamespace(marks=[*others, *lines], questions=questions), None, 40.0))
    named = [one.name for one in (*lines, *questions)][:told]
    more = [say("feedback.more_lines", number=wrong + asked - told)] if wrong + asked > told else []
    assert [one.text for one in found] == [*named, *more]
    assert {(one.part, one.kind) for one in found} == {("equations", "finding")}


@pytest.mark.parametrize("language", languages())
def test_our_reason_is_said_in_each_language_and_the_text_of_a_student_is_shown_clean_and_cut(language):
    with pytest.raises(FormulaFault) as refused:
        parse_equation("w1 = 2*(w2")
    why, phrases = refused.value.message, load_phrases(language)
    long = f"w\u202e2{'+w1' * 200}"  # with a sign that would turn the rest of the page around
    for hint, shown in ((Hint("reader", 11, why), phrases.written(why)), (Hint("repaired", 1, long), f"w2{'+w1' * 99}…")):
        mark = SimpleNamespace(
            verdict="unreadable", lack="", hint=hint, line=SimpleNamespace(line=3, where="", place="", relates=True)
        )
        told = phrases.written(equations.why_of_line(mark)), phrases.written(equations._line(mark))
        assert all(phrases.said(f"feedback.hint.{hint.kind}", text=shown, column=11) in one for one in told)
    assert (phrases.written(why) == str(why)) is (language == "en")
