"""Every sentence of a page is in the words file: a made-up language shows what is not, and no sentence is kept for nothing."""

from __future__ import annotations

import ast
import copy
import pickle
import re
from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.report.pages import build_model, render_html
from coursework.report.pages.model import heading_of
from coursework.report.text import words
from coursework.report.text.parts import Paragraph
from coursework.scene.scene_run import SceneRun
from coursework.variant.reading.reader import parse_variant
from coursework.variant.reading.set_values import with_set
from coursework.words.custom_templates import templates_of
from coursework.words.scripts import unfolded
from coursework.words.sentence import Sentence
from coursework.words.sentences import PLURALS, Phrases, joined, load_phrases, say, say_count
from tests.report import words_missing
from tests.report.real import text_of
from tests.report.text.test_sentences_of_a_page import keys
from tests.sample import first
from tests.solved import solved
from tests.sources import files, nodes

ROOT = Path(__file__).parents[3]
# Sections of the words file that the rooms below the report speak by keys that stand in their source.
FINDINGS = {
    "join", "amount", "unit", "check", "event", "phase", "determinant", "equation", "exact", "scheme", "study", "drawing",
    "extra", "reading", "remark", "advice", "summary", "ended", "gate",
    "platform", "marking", "feedback", "grading", "class", "fault",
}  # fmt: skip
V31 = (ROOT / "variants" / "31.toml").read_text(encoding="utf-8")
ALL = ["table", "plots", "checks", "graph_check", "accelerations", "points", "accuracy"]


def shouted(entry: Any) -> Any:
    """Return words in capitals, with their gaps and single italic letters as they are, and a decimal comma."""
    if isinstance(entry, dict):
        return {key: "," if key == "decimal" else value if key == "plural" else shouted(value) for key, value in entry.items()}
    return "".join(part if part[:1] in "{*" else part.upper() for part in re.split(r"(\{[^}]*\}|\*\w\*)", entry) if part)


SHOUTED = Phrases("xx", shouted(copy.deepcopy(dict(load_phrases().entries))))


@pytest.fixture
def language(monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setattr(words, "load_phrases", lambda language: SHOUTED if language == "xx" else load_phrases(language))
    return "xx"


def scenes() -> dict[str, tuple[str, dict[str, Any]]]:
    """Return variant files, and how they are run."""
    dead = V31.replace('"4.35 rad"', '"0.02 rad"')
    twice = 'equation = "VMx - r3*w4 + 2*r3*w3*cos(phi3) - 4*r3*w3*sin(phi3) = 0"'
    redundant = f'{V31}\n[[constraint]]\nname = "twice"\nbecause = ""\n{twice}\n'
    names = ("example-1", "example-4", "v105", "variable-crank", "prp")
    read = {name: (ROOT / "variants" / f"{name}.toml").read_text(encoding="utf-8") for name in names}
    return {
        "31": (V31, {"quantities": ALL}),
        "31 projected": (V31, {"project": 2, "quantities": ALL}),
        "31 dead": (dead, {}),
        "remarks": (V31.replace('"4.35 rad"', "10.6331853072").replace('"1.63 rad"', "1.63"), {"quantities": ["table"]}),
        "31 coarse": (V31, {"step": 0.1, "end": 0.5}),
        "31 long": (V31, {"end": 4.8, "quantities": ["table", "checks"]}),
        "redundant": (redundant, {}),
        "v105": (read["v105"], {"quantities": ALL}),
        "chain": (read["example-1"], {"quantities": ["table", "plots", "checks", "accelerations", "points", "analogs"]}),
        "slotted lever": (read["example-4"], {}),
        "two guides": (read["prp"], {}),
        "crank of variable length": (read["variable-crank"], {"quantities": ["table", "checks", "invariants"]}),
    }  # fmt: skip


def said(run: SceneRun, language: str) -> list[str]:
    """Return every text of a page, drawings included."""
    found = []
    for section in build_model(run, language).plain()["sections"]:
        found.append(section["title"])
        for part in section["parts"]:
            drawing = part.pop("svg", "")
            part.pop("columns", None)  # symbols beside each other are no sentence
            found += re.findall(r">([^<>]+)</t(?:ext|span)>", drawing)
            found.append(text_of(part))
    return found


@pytest.mark.parametrize("name", scenes())
def test_no_sentence_of_a_page_stands_in_python(name: str, language: str) -> None:
    """Three small words in a row on a page that shouts are a sentence nobody could translate, unless the file says them."""
    text, options = scenes()[name]
    run = coursework.solve(parse_variant(text), **options)
    own = " ".join(text.split())
    symbols = {*run.variant.names, "sin", "cos", "thin", "quad"}
    for found in said(run, language):
        for sentence in re.findall(r"(?:\b[a-z]{2,}\b[ ,]+){2,}[a-z]{2,}", found):
            assert sentence in own or symbols & set(re.findall(r"\w+", sentence)), f"{sentence!r} in {found[:200]!r}"


def test_numbers_inside_a_finding_have_the_decimal_sign_of_the_language(language: str) -> None:
    page = (ROOT / "tests" / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
    run = coursework.solve(parse_variant(page.replace('"4.35 rad"', '"0.02 rad"')), quantities=["table", "checks"])
    told = " ".join(said(run, language))
    assert "AT T = 0,116889 S" in told
    assert "0.116889" not in told


def test_a_finding_is_english_text_for_whoever_just_prints_it() -> None:
    found = say("event.with", values=(say("event.length", name="s", value=0.5), "x", say("event.length", name="p", value=1.25)))
    assert found == ", with s = 0.5 m, x and p = 1.25 m"
    assert SHOUTED.written(found) == ", WITH s = 0,5 M, x AND p = 1,25 M"
    assert SHOUTED.written("any other text") == "any other text"
    both = joined([found, "", say("event.smaller_step")])
    assert both == f"{found} Take a smaller step."
    for copied in (pickle.loads(pickle.dumps(both)), copy.deepcopy(both)):
        assert isinstance(copied, Sentence)
        assert SHOUTED.written(copied) == SHOUTED.written(both)


def test_chinese_sets_a_space_beside_latin_letters_only() -> None:
    """What a gap brings decides; the spaces inside it, of a name or a path, are the user's own."""
    chinese = load_phrases("zh")
    line = say("determinant.one_line", first=say("determinant.link", name="1"), second="各构件")
    assert chinese.written(line) == "构件 1 与各构件位于一条直线上（拉直共线或重叠共线）"
    assert chinese.written(say("determinant.vertical", link="AB")) == "AB 竖直"
    assert chinese.listing(["中点法", "（甲）", "四阶龙格-库塔法"]) == "中点法、（甲）和四阶龙格-库塔法"
    assert chinese.listing(["x", "y", "z"]) == "x、y 和 z"
    assert "我的 作业/31" in chinese.written(say("screen.written_to", out="我的 作业/31", files="report.html"))
    assert unfolded("到达死点，\n那里 V_M\n本应为零\n。") == "到达死点，那里 V_M\n本应为零。"
    assert unfolded("第\n3\n步\n：x\nя（1）\n") == "第\n3\n步：x\nя（1）"


def test_a_key_that_does_not_exist_is_a_fault() -> None:
    with pytest.raises(KeyError, match=r"no sentence check\.NOTHING"):
        say("check.NOTHING")


@pytest.mark.long
def test_every_finding_of_the_words_file_is_said_somewhere() -> None:
    """Keys are searched in the source and the templates: literally, or as the f-string that makes them."""
    spoken = {
        re.escape(key)
        for path in (ROOT / "reports").glob("*.j2")
        for key in re.findall(r'say\("([\w.-]+)"', path.read_text(encoding="utf-8"))
    }
    form = r"(\.(one|other|plain|timed))?"
    for path in files():
        for node in nodes(path):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                spoken.add(re.escape(node.value) + form)
            elif isinstance(node, ast.JoinedStr):
                parts = (re.escape(v.value) if isinstance(v, ast.Constant) else r"[\w -]+" for v in node.values)
                spoken.add("".join(parts) + form)
    pattern = re.compile("|".join(part for part in spoken if re.match(rf"({'|'.join(FINDINGS)})\\\.", part)))
    listed = [key for key in keys(load_phrases().entries) if key.partition(".")[0] in FINDINGS]
    assert sorted(key for key in listed if not pattern.fullmatch(key)) == []


def test_a_language_may_be_half_done_and_its_slips_are_told() -> None:
    half = Phrases("yy", {"decimal": ".", "event": {"smaller_step": "Менший крок.", "rows_kept": "{steep:g}"}})
    assert half.written(say("event.smaller_step")) == "Менший крок."
    assert half.written(say("event.singular")) == "its block is singular"
    with pytest.raises(coursework.InputError, match=r"words\.yy\.toml, event\.rows_kept: .* Known placeholders: \{step\}\."):
        half.written(say("event.rows_kept", step=0.02))


def test_a_page_in_another_language_by_its_words_file(tmp_path: Path) -> None:
    """A file beside words.en.toml is a language; an unknown one is refused before anything is computed."""
    words_file = (ROOT / "reports" / "words.en.toml").read_text(encoding="utf-8")
    (tmp_path / "words.de.toml").write_text(words_file.replace('decimal = "."', 'decimal = ","'), encoding="utf-8")
    with templates_of(tmp_path):
        page = tmp_path / "page.html"
        coursework.write_report(coursework.solve("31", quantities=["table", "checks"]), page, language="de")
        assert "0,48" in page.read_text(encoding="utf-8")
        result = CliRunner().invoke(main, ["run", "31", "--language", "dee", "--out", str(tmp_path / "out")])
        assert result.exit_code == 2
        assert 'no words for the language "dee"' in result.stderr
        assert 'Did you mean "de"?' in result.stderr
        assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("language", words_missing.languages())
def test_every_language_has_the_keys_and_gaps_of_english(language: str) -> None:
    assert [*words_missing.complaints(language)] == []


@pytest.mark.parametrize(
    ("rule", "numbers"),
    [
        ("one-other", {"one": [1], "other": [0, 2, 5, 11, 21, 101]}),
        (
            "one-few-many",
            {"one": [1, 21, 101, 1001], "few": [2, 3, 4, 22, 104], "many": [0, 5, 11, 12, 13, 14, 20, 111]},
        ),
        ("other", {"other": [0, 1, 2, 5]}),
    ],
)
def test_words_beside_a_number_follow_the_language(rule: str, numbers: dict[str, list[int]]) -> None:
    """Source: Unicode CLDR, plural rules of en, ru and uk (whole numbers), zh."""
    for form, listed in numbers.items():
        assert {PLURALS[rule](number) for number in listed} == {form}
    forms = {form: f"{{number}} {form}" for form in numbers}
    other = Phrases("yy", {"plural": rule, "count": {"rows": forms}})
    for form, listed in numbers.items():
        assert [other.written(say_count("count.rows", number)) for number in listed] == [f"{number} {form}" for number in listed]


@pytest.mark.parametrize(("language", "beside_part"), [("en", "rows"), ("ru", "строки"), ("uk", "рядка"), ("zh", "行")])
def test_words_beside_a_part_of_one_have_a_form_of_their_own(language: str, beside_part: str) -> None:
    """Source: Unicode CLDR, "other" of ru and uk is the form of fractions; the genitive singular in both."""
    words = load_phrases(language)
    assert words.written(say("unit.rows", number=24.02)) == beside_part
    assert words.written(say("unit.rows", number=24.0)) == words.written(say("unit.rows", number=24))


@pytest.mark.long
@pytest.mark.parametrize("name", first(1, ("epicyclic", "31", "andrews")))
def test_numbers_have_the_decimal_sign_of_the_page_and_chinese_has_no_spaces(name: str, reading: ModuleType) -> None:
    run = solved(name)
    as_written = " ".join(run.variant.remarks)  # what a file says in its own language stays as it is
    for language in ("ru", "uk"):
        model = build_model(run, language)
        own = tuple(section for section in model.sections if section.name != "method")  # that one names versions
        text = reading.html_text(render_html(replace(model, sections=own)))
        assert [number for number in re.findall(r"\d+\.\d+", text) if number not in as_written] == []
        assert len(re.findall(r"\d,\d", text)) > 300
    sections = build_model(run, "zh").sections
    told = [text_of(part.text) for section in sections for part in section.parts if isinstance(part, Paragraph)]
    assert sum("。" in one for one in told) > 5
    assert [one for one in told if re.search("[\u4e00-\u9fff][。，；：] |\u200b", one)] == []
    assert any("、" in one for one in told)


@pytest.mark.parametrize(
    ("language", "told"),
    [("ru", "= 0,02 рад, r1 = 910 мм и VMy = 2 * sin(p * t)."), ("uk", "= 0,02 рад, r1 = 910 мм і VMy = 2 * sin(p * t).")],
)
def test_what_was_set_has_the_units_of_the_language(language: str, told: str) -> None:
    run = coursework.solve(
        with_set(coursework.load("31"), ["alpha=0.02rad", "r1=910mm", "VMy=2 * sin(p * t)"]), quantities=["table"]
    )
    page = " ".join(said(run, language)).replace("\N{NO-BREAK SPACE}", " ")
    assert told in page
    assert load_phrases(language).said("check.QUOTE.set") in page, "the file quotes numbers of its own data"


@pytest.mark.parametrize(("language", "between"), [("ru", "; "), ("uk", "; "), ("en", ", ")])
def test_numbers_with_a_decimal_comma_are_listed_with_semicolons(language: str, between: str) -> None:
    values = [say("screen.named", name=name, value=value) for name, value in (("phi1", 1.63), ("w1", -1.5))]
    decimal = load_phrases(language).template("decimal")
    listed = load_phrases(language).written(joined(values, "join.numbers"))
    assert listed == f"phi1 1{decimal}63{between}w1 -1{decimal}5"


@pytest.mark.parametrize(
    ("language", "numbered", "named"),
    [
        ("en", "Variant 31: x", "Variant mine: x"),
        ("ru", "Вариант 31. x", "x"),
        ("uk", "Варіант 31. x", "x"),
        ("zh", "第 31 题　x", "x"),
    ],
)
def test_only_a_number_is_that_of_a_task_in_a_heading(language: str, numbered: str, named: str) -> None:
    for name, heading in (("31", numbered), ("mine", named)):
        variant = SimpleNamespace(name=name, title="x")
        context = SimpleNamespace(
            run=SimpleNamespace(variant=variant), variant=variant, is_about_accuracy=False, words=words.load_words(language)
        )
        assert heading_of(context) == heading
