"""Pages, sheets and feedback in Russian, Ukrainian and Chinese: units in the reader's letters, the words of the field.

What was read wrong once (a letter of a unit, a case behind a gap, a word of another trade) stands on no page of the catalogue
and on none of a mechanism that is not in it.
"""

from __future__ import annotations

import html
import json
import re
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.report.pages import build_model, render_html
from coursework.words.sentences import load_phrases, say
from tests.report.words_missing import languages, read

# A shaper of its own: crank, slotted lever hinged below it, no file of the catalogue.
SHAPER = """
format = 1
title = "Shaper"
[given]
r1 = "0.10 m"
d = "0.25 m"
w = "12.5 rad/s"
[drive]
w1 = "w"
[coordinates]
phi1 = { start = "0.3 rad", rate = "w1" }
phi3 = { rate = "w3" }
s3 = { rate = "u3" }
[points]
O = "(0, d)"
D = "(0, 0)"
[[group]]
kind = "crank"
from = ["O"]
lengths = ["r1"]
coordinates = ["phi1"]
meets = "A"
[[group]]
kind = "RPR"
from = ["A", "D"]
coordinates = ["phi3", "s3"]
mode = "+1"
[time]
step = "0.02 s"
end = "0.5 s"
"""
CYRILLIC = ("ru", "uk")
# A number and a unit in Latin letters; "h" of a step, what is typed and what is code are no units.
_LATIN_UNIT = re.compile(r"\d[\u00a0 ](?:m|s|mm|rad|deg|rpm|m/s|rad/s|1/s|m/s²|rad/s²)(?![\w/=.])")
_WRONG = {
    "ru": ("из полюс ", "само движение", "точка смены", "привод", "проекция Ньютона", "решает округление", "доля схемы", "1/с"),
    "uk": ("із полюс ", "пришвидшен", "сам рух", "точка зміни", "привод", "проекці", "зі зустрінутих", "1/с"),
    "zh": (
        "格式",
        "变体",
        "标度",
        "精确运动",
        "真实运动",
        "装配形式",
        "装配方式",
        "导轨",
        "滑道",
        "驱动",
        "阿苏尔杆组基本",
        "幻灯片",
    ),
}


def text_of(page: str) -> str:
    """Return what a page says, its script and style left out."""
    bare = re.sub(r"(?s)<(script|style)\b.*?</\1>", "", page)
    return html.unescape(re.sub(r"<[^>]+>", "", re.sub(r"</t[dh]>|</p>|<br>", " ", bare)))


@cache
def report(name: str, language: str) -> str:
    """Return the report of a variant, or of the shaper, with plans and all that a page can hold."""
    chosen = coursework.parse_variant(SHAPER) if name == "shaper" else coursework.load(name)
    asked = ["table", "checks", "plots", "plans", "accelerations"]
    return text_of(render_html(build_model(coursework.solve(chosen, quantities=asked), language)))


@pytest.mark.parametrize("language", CYRILLIC)
@pytest.mark.parametrize("name", ["31", "example-2", "example-4", "shaper"])
def test_no_unit_of_a_page_is_in_latin_letters(name: str, language: str) -> None:
    assert _LATIN_UNIT.findall(report(name, language)) == []


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
@pytest.mark.parametrize("name", ["31", "example-2", "example-4", "shaper"])
def test_no_page_says_what_no_professor_says(name: str, language: str) -> None:
    assert [wrong for wrong in _WRONG[language] if wrong in report(name, language)] == []


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_the_words_themselves_do_not_say_it_either(language: str) -> None:
    file_formats = {"fault.C015", "fault.W011", "new.format"}  # a format of a file is one
    said = {key: text for key, text in read(language).items() if key not in file_formats and not key.startswith("sheet.part")}
    found = {key: wrong for key, text in said.items() for wrong in _WRONG[language] if re.search(rf"{wrong}(?!ит|ят)", text)}
    assert found == {}


@pytest.mark.parametrize("language", CYRILLIC)
def test_a_task_sheet_its_key_and_the_class_page_have_units_in_cyrillic(language: str, tmp_path: Path) -> None:
    (tmp_path / "roster.csv").write_text("id,name,email\nada,Ада,\n", encoding="utf-8")
    out = tmp_path / "out"
    args = ["assign", str(tmp_path / "roster.csv"), "--template", "31", "--seed", "3", "--language", language, "--out", str(out)]
    assert CliRunner().invoke(main, args).exit_code == 0
    for page in ("sheets/ada.html", "key/ada.html", "class.html"):
        told = text_of((out / page).read_text(encoding="utf-8"))
        assert _LATIN_UNIT.findall(told) == [] and not re.search(r"\d\.\d", told), page
        assert "м" in told and "с⁻¹" in told


@pytest.mark.parametrize("language", languages())
def test_a_line_from_the_pole_has_the_pole_in_its_case(language: str) -> None:
    pole = load_phrases(language).written(say("plans.line.pole"))
    line = load_phrases(language).written(say("plans.line.across", start=say("plans.line.pole"), base="B", point="C"))
    assert {"ru": "из полюса ", "uk": "з полюса ", "zh": "由极点"}[language] in line and pole in line


@pytest.mark.parametrize(
    ("language", "number", "said"),
    [
        ("ru", 24.02, "24 строки"), ("ru", 25.0, "25 строк"), ("ru", 21.0, "21 строка"),
        ("uk", 24.02, "24 рядки"), ("uk", 25.0, "25 рядків"), ("uk", 24.5, "24,5 рядка"),
    ],
)  # fmt: skip
def test_a_noun_agrees_with_its_number_as_printed(language: str, number: float, said: str) -> None:
    from coursework.results.checks.result import beside

    shown = float(f"{number:.3g}")
    unit = beside(say("unit.rows", number=number), shown)
    assert load_phrases(language).written(say("screen.value_unit", value=shown, unit=unit)).strip() == said


@pytest.mark.parametrize(
    ("language", "fewer", "said"),
    [("ru", 80.4, "в 80 раз меньше"), ("ru", 2.5, "в 2,5 раза меньше"), ("ru", 3.0, "в 3 раза"), ("uk", 3.0, "у 3 рази")],
)
def test_a_ratio_agrees_with_the_word_for_times(language: str, fewer: float, said: str) -> None:
    told = say("steps.other", scheme="x", steps=10, evaluations=40, fewer=fewer)
    assert said in load_phrases(language).written(told)


def test_rows_up_to_a_stop_are_said_to_be_right_up_to_it(tmp_path: Path) -> None:
    args = ["run", "31", "--set", "alpha=0.02rad", "--language", "ru", "--format", "csv", "--out", str(tmp_path)]
    told = CliRunner().invoke(main, args).output
    assert "Строки до остановки вычислены верно" in told and "alpha = 0,02 рад" in told and "STOP" not in told


@pytest.mark.parametrize(
    ("student", "missing"), [("王鑫淼", ""), ("김철수", "김철수")], ids=["a name of GB 2312", "a name that no face here has"]
)
def test_a_letter_that_no_face_has_is_named(student: str, missing: str, tmp_path: Path) -> None:
    told = CliRunner().invoke(main, ["run", "31", "--student", student, "--format", "pdf", "--out", str(tmp_path)])
    record = json.loads((tmp_path / "run.json").read_text(encoding="utf-8"))
    assert record.get("unprinted", {}).get("letters", "") == missing
    assert (missing in told.stderr) and ("boxes" in told.stderr) == bool(missing)


@pytest.mark.parametrize(("language", "said"), [("ru", "пишите sin(…)"), ("uk", "пишіть sin(…)"), ("zh", "sin(…)")])
def test_a_function_in_cyrillic_letters_is_told_in_latin(language: str, said: str) -> None:
    with pytest.raises(coursework.InputError) as refused:
        coursework.parse_variant(SHAPER.replace('w1 = "w"', 'w1 = "w*син(t)"'))
    assert said in refused.value.told(load_phrases(language).written)
