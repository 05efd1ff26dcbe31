"""Every page of the catalogue on a phone and a screen, light and dark: nothing cut, covered, pale or beyond the keyboard.

The judge is `screen.js`, in a real browser; a page made of faults shows that it sees each of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

from coursework.variant.catalogue import names
from tests.report.made import model_of, page_of, solved
from tests.sample import SAMPLE, first

pytestmark = pytest.mark.browser

HERE = Path(__file__).parent
PHONE, BETWEEN, SCREEN = {"width": 390, "height": 844}, {"width": 640, "height": 900}, {"width": 1400, "height": 900}
TRANSLATED = (("31", "ru"), ("31", "uk"), ("31", "zh"), ("v107", "ru"), ("example-3", "zh"), ("epicyclic", "uk"))
REST = [pytest.param(name, "en", marks=pytest.mark.long) for name in names() if name not in SAMPLE]
# The points of Cardan's circles run through both rims on straight lines, three of them on one.
ON_RIMS = {"cardan": 1 / 2}
FAULTY = """<!DOCTYPE html><html lang=""><head><style>
.low { color: #777; background: #fff; } .high { color: #767676; background: #fff; } .wide { width: 500px; }
.box { width: 100px; overflow-x: auto; } a:focus-visible { outline: none; }
</style></head><body><h1>One</h1><h3>Three</h3><p id="a" class="low">low</p><p id="a" class="high">high</p>
<div class="wide">wide</div><div class="box"><div class="wide">moved</div></div><table><tr><th></th></tr></table>
<a href="#nowhere"></a><a href="#a">here</a><input><section>no name</section>
<svg width="100" height="40" viewBox="0 0 100 40"><text x="2" y="20">one</text><text x="12" y="20">two</text>
<text x="90" y="30">three</text><text x="2" y="38" font-size="10.9">four</text></svg>
<svg width="100" height="40" viewBox="0 0 100 40"><text x="2" y="14" font-size="11">five
<tspan dy="2" font-size="7.6">six</tspan></text>
<text x="2" y="34" font-size="11">seven<tspan dy="2" font-size="7.7">eight</tspan></text></svg></body></html>"""


@pytest.fixture(scope="module")
def page(browser: Any) -> Iterator[Any]:
    context = browser.new_context(viewport=PHONE)
    context.add_init_script(path=HERE / "screen.js")
    yield context.new_page()
    context.close()


def shown(variant: str, language: str, folder: Path, page: Any) -> list[str]:
    """Open a page of a variant; return what the browser said of it."""
    path = folder / "report.html"
    path.write_text(page_of(model_of(solved(variant), language, live=True)), encoding="utf-8")
    said: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(path.as_uri())
    return said


def resize(page: Any, size: dict[str, int]) -> None:
    """Give the page another window, and the time to draw what depends on it."""
    page.set_viewport_size(size)
    page.evaluate("new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)))")


def faults(page: Any) -> list[str]:
    """Return what a person would complain about: on a phone, and with both colours of a screen."""
    resize(page, PHONE)
    found = [*page.evaluate("judge.layout()"), *page.evaluate("judge.access()"), *page.evaluate("judge.lines()")]
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        found += [f"{scheme}: {fault}" for fault in page.evaluate("judge.contrast()")]
    return found


@pytest.mark.long
@pytest.mark.parametrize(("variant", "language"), [*((name, "en") for name in SAMPLE), *TRANSLATED, *REST])
def test_a_page_is_read_on_every_screen(variant: str, language: str, page: Any, tmp_path: Path) -> None:
    assert shown(variant, language, tmp_path, page) == []
    assert faults(page) == []
    for size in (BETWEEN, SCREEN):
        resize(page, size)
        assert page.evaluate("judge.layout()") == []
    for size, share in ((SCREEN, 1 / 4), (PHONE, 1 / 3)):
        resize(page, size)
        words = page.evaluate("document.querySelector('#live') && judge.moving()")
        if words:
            assert words["start"] == []
            assert words["later"] <= words["looked"] * ON_RIMS.get(variant, share)


def test_the_judge_sees_a_word_of_the_moving_part_on_a_line_or_a_word(page: Any, tmp_path: Path) -> None:
    """An upright line 1 px beside the letters, then 1 px within; then a second word."""
    path = tmp_path / "words.html"
    drawn = '<svg id="f" viewBox="0 0 99 99" width="99"><g class="live-body"><path/></g><g class="live-words">{0}{0}</g></svg>'
    path.write_text(drawn.format('<text x="20" y="40" dy="5" font-size="20">H</text>'), encoding="utf-8")
    page.goto(path.as_uri())
    page.evaluate("f.querySelector('text').setAttribute('x', 60)")

    def on(way: str) -> list[str]:
        return list(page.evaluate("(d) => { f.querySelector('path').setAttribute('d', d); return judge.standing(f).on; }", way))

    right = page.evaluate("f.querySelector('text').getBBox().x + f.querySelector('text').getBBox().width - 1")
    assert on(f"M{right + 1} 20V60") == []
    assert on(f"M{right - 1} 20V60") == ["H"]
    page.evaluate("f.querySelector('text').setAttribute('x', 22)")
    assert on("M0 0H1") == ["H", "H"]


def test_a_formula_breaks_where_a_person_breaks_it(page: Any, tmp_path: Path) -> None:
    """On a phone nothing of variant 31 has to be moved sideways to be read but its tables, plots and the construction."""
    shown("31", "en", tmp_path, page)
    resize(page, PHONE)
    wide = "[...document.querySelectorAll('.formula')].filter((one) => one.scrollWidth > one.clientWidth + 1).length"
    assert page.evaluate(wide) == 0
    tops = "(one) => new Set([...one.children].map((piece) => piece.getBoundingClientRect().top)).size"
    lines = f"[...document.querySelectorAll('.formula.pieces')].map({tops})"
    assert max(page.evaluate(lines)) > 1
    resize(page, SCREEN)
    assert page.evaluate(wide) == 0


def test_the_keyboard_is_seen_and_a_wide_screen_hides_nothing(page: Any, tmp_path: Path) -> None:
    shown("31", "en", tmp_path, page)
    resize(page, SCREEN)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        assert page.evaluate("judge.focus()") == []
    assert page.evaluate("judge.layout()") == []
    assert page.evaluate("judge.access()") == []


@pytest.mark.parametrize(("variant", "language"), first(2, (("31", "en"), ("v107", "ru"), ("jansen", "en"))))
def test_no_line_ends_between_a_number_and_its_unit(variant: str, language: str, page: Any, tmp_path: Path) -> None:
    shown(variant, language, tmp_path, page)

    def ends(widths: Iterable[int]) -> list[str]:
        found = []
        for width in widths:
            resize(page, {"width": width, "height": 900})
            found += page.evaluate("judge.lines()")
        return found

    assert ends((*range(320, 400, 14), 800, 1100, 1250, 1400)) == []
    page.add_style_tag(content="bdi { white-space: normal !important; }")
    assert len(ends((320, 348, 376))) > 5


def test_the_judge_sees_each_fault(page: Any, tmp_path: Path) -> None:
    path = tmp_path / "faulty.html"
    path.write_text(FAULTY, encoding="utf-8")
    page.goto(path.as_uri())
    found = "\n".join([*faults(page), *page.evaluate("judge.focus()")])
    for fault in (
        "px wide", "wider than the window: div.wide", 'one on the other: svg "one" "two"', 'svg "three"', '10.9 px: svg "four"',
        '7.6 px: svg "six"',
        "no language", "no title", "not one main", "no name: section", "h3 behind h1", "twice: #a", "a picture without words",
        "a table without a name", "an empty head", "without scope", "a link without text", "a link to nothing: #nowhere",
        "a control without a label", "goes on unseen: div.box",
        "moved only with a mouse: div.box", "4.48 instead of 4.5: #a p.low", "no outline: a",
    ):  # fmt: skip
        assert fault in found, fault
    assert not [good for good in ("p.high", 'svg "five', 'svg "seven', 'svg "eight') if good in found]
