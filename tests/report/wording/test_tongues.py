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
from coursework.report.formulas.display import marked
from coursework.report.pages import build_model, render_html
from coursework.report.text.parts import Display
from coursework.variant.formula import mass_units, motion_units
from coursework.variant.record.variant import no_column
from coursework.words.sentences import load_phrases, say
from tests.mechanisms.library import mechanism
from tests.report.words_missing import languages, read
from tests.sample import diagonal
from tests.solved import solved

# A shaper of its own: crank, slotted lever hinged below it, no file of the catalogue.
SHAPER = mechanism(
    "shaper", ('"0 deg"', '"0.3 rad"'), ('s = { rate = "u"', 's3 = { rate = "u3"'), ('["phi3", "s"]', '["phi3", "s3"]'),
    n="12.5 rad/s", step="0.02 s", end="0.5 s", period=None, quantities=None,
)  # fmt: skip
CYRILLIC = ("ru", "uk")
# A number and a unit in Latin letters; "h" of a step, what is typed and what is code are no units.
_LATIN_UNIT = re.compile(r"\d[\u00a0 ](?:m|s|mm|rad|deg|rpm|m/s|rad/s|1/s|m/s²|rad/s²)(?![\w/=.])")
_WRONG = {
    "ru": (
        "из полюс ", "само движение", "точка смены", "привод", "проекция Ньютона", "решает округление", "доля схемы", "1/с",
        "истинн", "гармоники несут", "лишь грубо", "Звенья сходятся", "таблицы Эйлера", "вместе с периодом", "по подобию",
        "наименьшей длины", "чертежа. Его", "не близка к движению", "плеч (звено",
    ),
    "uk": (
        "із полюс ", "пришвидшен", "сам рух", "точка зміни", "привод", "проекці", "зі зустрінутих", "1/с", "істинн",
        "гармоніки несуть", "лише грубо", "Ланки сходяться", "таблиці Ейлера", "разом із періодом", "за подібністю",
        "найменшої довжини", "креслення. Його", "не близька до руху", "плечей (ланка", "у мить рядка", "слідує за", "в'яз",
        "в'яж",
    ),
    "zh": (
        "格式", "变体", "标度", "精确运动", "真实运动", "装配形式", "装配方式", "导轨", "滑道", "驱动", "阿苏尔杆组基本",
        "幻灯片", "科里奥利", "首行", "末行", "作图校核", "粗略的意义", "转得最快的角", "水平坐标", "主动点",
    ),
}  # fmt: skip


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


@pytest.mark.long
@pytest.mark.parametrize(("name", "language"), diagonal(2, ("31", "example-2", "example-4", "shaper"), CYRILLIC))
def test_no_unit_of_a_page_is_in_latin_letters(name: str, language: str) -> None:
    assert _LATIN_UNIT.findall(report(name, language)) == []


@pytest.mark.parametrize("language", CYRILLIC)
def test_every_unit_that_a_file_may_have_is_written_in_cyrillic(language: str) -> None:
    words = load_phrases(language)
    units = (*motion_units.UNITS, *mass_units.UNITS)
    assert [unit for unit in units if re.search("[A-Za-z]", words.unit(unit))] == []


@pytest.mark.long
@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
@pytest.mark.parametrize("name", ["31", "example-2", "example-4", "shaper"])
def test_no_page_says_what_no_professor_says(name: str, language: str) -> None:
    assert [wrong for wrong in _WRONG[language] if wrong in report(name, language)] == []


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_the_words_themselves_do_not_say_it_either(language: str) -> None:
    file_formats = {"fault.C015", "fault.W011", "new.format"}  # a format of a file is one
    said = {key: text for key, text in read(language).items() if key not in file_formats and not key.startswith("sheet.part")}
    found = {
        key: wrong for key, text in said.items() for wrong in _WRONG[language] if re.search(rf"{re.escape(wrong)}(?!ит|ят)", text)
    }
    assert found == {}


@pytest.mark.long
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
    assert "Таблица вычислена верно до остановки" in told and "alpha = 0,02 рад" in told and "STOP" not in told


@pytest.mark.parametrize(
    ("student", "missing"), [("王鑫淼", ""), ("𐘀𐘁 𐘂", "𐘀𐘁𐘂")], ids=["a name of GB 2312", "a name that no face here has"]
)
def test_a_letter_that_no_face_has_is_named(student: str, missing: str, tmp_path: Path) -> None:
    told = CliRunner().invoke(main, ["run", "31", "--student", student, "--format", "pdf", "--out", str(tmp_path)])
    record = json.loads((tmp_path / "run.json").read_text(encoding="utf-8"))
    assert record.get("unprinted", {}).get("letters", "") == missing
    assert (missing in told.stderr) and ("boxes" in told.stderr) == bool(missing)


@pytest.mark.parametrize(("language", "said"), [("ru", "пишите sin(…)"), ("uk", "пишіть sin(…)"), ("zh", "sin(…)")])
def test_a_function_in_cyrillic_letters_is_told_in_latin(language: str, said: str) -> None:
    with pytest.raises(coursework.InputError) as refused:
        coursework.parse_variant(SHAPER.replace('w1 = "n"', 'w1 = "n*син(t)"'))
    assert said in refused.value.told(load_phrases(language).written)


@pytest.mark.long
@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("ru", "проекции плеч звена 3 взаимно уничтожаются"), ("uk", "проєкції плечей ланки 3 взаємно знищуються"),
        ("ru", "Далеко от движения: φ1 в строке 20 отличается на 0,14 рад"),
        ("uk", "Далеко від руху: φ1 у рядку 20 відрізняється на 0,14 рад"),
        ("zh", "与机构的运动不接近：φ1 在第 20 行"),
        ("ru", "с прежним шагом (погрешность 0,005 %)"), ("uk", "з попереднім кроком (похибка 0,005 %)"), ("zh", "步长不变"),
        ("ru", "Вариант 31. Катящееся"), ("uk", "Варіант 31. Колесо"),
    ],
)  # fmt: skip
def test_cases_and_order_behind_a_gap_are_those_of_the_language(language: str, said: str) -> None:
    assert said in " ".join(report("31", language).split())


@pytest.mark.parametrize(("language", "start", "hint"), [
    ("en", "The mechanism at the start. Links: 1 DA, 2 AB, 3 MBC", "one by one, not as a list:"),
    ("ru", "Механизм в начальном положении. Звенья: 1 DA, 2 AB, 3 MBC и 4 CP.", "по одному, не списком:"),
    ("uk", "Механізм у початковому положенні. Ланки: 1 DA, 2 AB, 3 MBC", "по одному, не списком:"),
    ("zh", "机构初始位置图。构件：1 DA、2 AB、3 MBC", "请逐个给出，不要用列表："),
])  # fmt: skip
def test_who_does_not_see_the_drawing_is_told_its_links_and_who_gives_a_list_what_to_give(
    language: str, start: str, hint: str
) -> None:
    assert start in load_phrases(language).written(solved("31").mechanism().alt)
    told = no_column(["w3", "w2"], ("w2", "w3")).told(load_phrases(language).written)
    assert f'{hint}{"" if language == "zh" else " "}"w3", "w2"' in told


@pytest.mark.parametrize("language", ["en", "ru", "uk", "zh"])
def test_what_the_harmonics_carry_is_one_figure_wherever_it_is_said(language: str) -> None:
    page = report("31", language).replace("\u00a0", " ")
    spaced = {"en": "99.6 %", "ru": "99,6 %", "uk": "99,6 %", "zh": "99.6%"}[language]
    assert page.count(spaced) >= 2  # in the list of checks and in its sentence


@pytest.mark.long
@pytest.mark.parametrize("language", CYRILLIC)
@pytest.mark.parametrize("name", ["example-4", "shaper"])
def test_every_decimal_of_a_row_worked_through_has_a_comma(name: str, language: str) -> None:
    chosen = coursework.parse_variant(SHAPER) if name == "shaper" else coursework.load(name)
    asked = ["table", "accelerations", "points", "analogs"]
    page = render_html(build_model(coursework.solve(chosen, quantities=asked), language))
    spoken = [html.unescape(label) for label in re.findall(r'aria-label="([^"]*)"', page)]
    assert any("²" in label and "," in label for label in spoken)
    assert [label for label in spoken if re.search(r"\d\.\d", label)] == []


def test_a_point_within_a_longer_number_is_no_decimal_sign() -> None:
    shown = marked(Display("a = 2.5^(2) b", "a = 2.5² b, 1.2.3, 0.5"), ",")
    assert shown.text == "a = 2,5² b, 1.2.3, 0,5" and '"2,5"^(2)' in shown.math


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_a_run_names_no_code_and_says_which_equation(language: str, tmp_path: Path) -> None:
    args = ["run", "31", "--language", language, "--format", "csv", "--verbose", "--out", str(tmp_path)]
    told = CliRunner().invoke(main, args).stdout
    assert not re.search(r"\b(DRIFT|STOP|PASS|COARSE|ACCURACY)\b", told)
    assert {"ru": "уравнение 12, строка 1", "uk": "рівняння 12, рядок 1", "zh": "方程 12，第 1 行"}[language] in told
    assert {"ru": "(не менее 6)", "uk": "(не менше 6)", "zh": "（至少 6）"}[language] in told
    assert " （" not in told


@pytest.mark.parametrize(
    ("language", "said"),
    [("ru", "кулиса направлена от C к ползуну"), ("uk", "куліса спрямована від C до повзуна"), ("zh", "导杆由 C 指向滑块")],
)
def test_a_new_shaper_is_explained_in_the_words_of_its_structure(
    language: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    args = ["new", "mine", "--groups", "crank,RPR,RRP", "--language", language]
    assert CliRunner().invoke(main, args).exit_code == 0
    written = (tmp_path / "mine.toml").read_text(encoding="utf-8")
    assert said in written and not re.search("камня|каменя|摆杆", written)


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_a_column_in_degrees_is_told_with_their_sign(language: str, tmp_path: Path) -> None:
    run = coursework.solve("31")
    names = ["t", *run.table.columns]
    turned = [[t, *(row[:3] * 57.29577951308232), *row[3:]] for t, row in zip(run.table.index, run.table.to_numpy(), strict=True)]
    lines = [",".join(names), *(",".join(f"{value:.6f}" for value in row) for row in turned)]
    (tmp_path / "table.csv").write_text("\n".join(lines), encoding="utf-8")
    args = ["precheck", str(tmp_path / "table.csv"), "--variant", "31", "--language", language]
    told = CliRunner().invoke(main, args).stdout
    assert "°" in told and "deg" not in told


def test_a_page_of_forces_has_no_english_head_no_point_for_a_comma_and_no_name_that_begins_a_sentence_small() -> None:
    run = solved("example-2-motor")
    page = text_of(render_html(build_model(run, "ru"))).replace("\u00a0", " ").replace("\u202f", " ")
    assert "энергия" in page and "energy" not in page.replace("energy.csv", "")
    assert "B + 0,4" in page and "0.4" not in page
    assert "Явная схема Эйлера, шагов: 200" in page


def test_a_scheme_in_brackets_is_written_small() -> None:
    run = solved("31", scheme="heun", quantities=["table", "plots", "checks"])
    assert "Порядок метода (метод Хойна) — 2" in text_of(render_html(build_model(run, "ru"))).replace("\u00a0", " ")
