"""On paper figures have their numbers in the order in which they stand, those of the screen, also before a turned sheet.

A quick-return mechanism of the catalogue, in which it does, the same with forces, where the sheet is one of several figures, and
a chain that is in no file.
"""

import re
import unicodedata

import pymupdf
import pytest

from coursework.report.text.parts import Figure, Panels, Table
from tests.command import call
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, solved
from tests.sample import diagonal

BEGINS = 24  # letters of a caption, its number among them


def plain(text):
    """Return letters and digits alone, those of formulas as any other."""
    return "".join(letter for letter in unicodedata.normalize("NFKC", text) if letter.isalnum())


@pytest.mark.long
@pytest.mark.parametrize(("name", "language"), [*diagonal(2, ("whitworth", "own"), ("en", "ru")), ("whitworth-forces", "en")])
def test_numbers_of_figures_grow_on_paper(tmp_path, name, language):
    own = mechanism("slider-crank", ('"0 deg"', '"20 deg"'), n="40 rpm", step="0.05 s", end="1.5 s", period=None)
    (tmp_path / "own.toml").write_text(own, encoding="utf-8")
    asked = "table,plots,checks,graph_check,plans" if name != "whitworth-forces" else "table,forces"
    told = call("run", name if name != "own" else tmp_path / "own.toml", "--quantities", asked,
                "--language", language, "--format", "html,pdf", "--out", tmp_path / "out")  # fmt: skip
    assert told.exit_code in (0, 1), told.output
    word = {"en": r"Figure (\d+)\.", "ru": r"Рисунок (\d+)\b"}[language]
    paper = "".join(page.get_text() for page in pymupdf.open(tmp_path / "out" / "report.pdf"))
    numbers = [int(found) for found in re.findall(word, paper)]
    assert len(numbers) >= 5
    assert numbers == [*range(1, len(numbers) + 1)]
    screen = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    for drawing in ("graph-check", "check-plan") if "graph_check" in asked else ():
        (told,) = re.findall(rf'<figure[^>]* id="{drawing}"[^>]*>.*?<figcaption[^>]*>(.*?)</figcaption>', screen, re.DOTALL)
        begin = plain(re.sub("<.*?>", "", told))[:BEGINS]
        assert begin in plain(paper), begin


@pytest.mark.parametrize(("language", "words"), [("en", ("Table", "Figure")), ("ru", ("Таблица", "Рисунок"))])
def test_tables_and_figures_are_counted_each_for_themselves(language, words):
    """A formula has no number, nor has what has no caption."""
    parts = [part for section in model_of(solved("31"), language).sections for part in section.parts]
    for kinds, word in zip((Table, Figure | Panels), words, strict=True):
        labels = [part.label for part in parts if isinstance(part, kinds) and part.caption]
        assert len(labels) > 2
        assert [re.findall(r"\w+", label) for label in labels] == [[word, str(number)] for number in range(1, len(labels) + 1)]
