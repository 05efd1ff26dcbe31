"""The section about the structure says what a hand counts, in words and formulas that can be found; or is not there."""

from __future__ import annotations

import re

import pytest

import coursework
from coursework.drawing.outline.tracing import read_outline
from coursework.scene.scene_run import SceneRun
from coursework.words.data_folders import folder
from tests.mechanisms.library import mechanism
from tests.report.made import model_of, page_of, paper_of
from tests.report.own import FIVE_BAR, SHAPER, STEPHENSON
from tests.report.reading import html_text, pdf_text
from tests.report.real import V31

WITHOUT_LINKS = re.sub(r"\[links\].*(?=\[closure\])", "", V31, flags=re.DOTALL)


def told(run: SceneRun, language: str = "en") -> dict[str, str]:
    """Return the items of the section as plain text, "" for none."""
    sections = [section for section in model_of(run, language).sections if section.name == "structure"]
    parts = sections[0].parts if sections else []
    items = [item for part in parts for item in getattr(part, "items", [])]
    return {
        head: "".join(run.get("t", run.get("v", "") + run.get("s", "") + run.get("c", "")) for run in runs)
        for head, runs in items
    }


def solved(text: str, quantities: tuple[str, ...] = ("table", "checks")) -> SceneRun:
    return coursework.solve(coursework.parse_variant(text), quantities=quantities)


def test_the_shaper_on_the_page() -> None:
    found = told(solved(SHAPER))
    assert found["Links"] == "0 frame (A, D); 1 crank AB; 2 slider B; 3 slotted lever DE; 4 coupler EF; 5 slider F"
    assert found["Pairs"] == "turning, R: A (0,1), B (1,2), D (0,3), E (3,4), F (4,5); sliding, P: B (2,3), F (0,5)"
    assert "W = 3n − 2p5 − p4 = 3·5 − 2·7 − 0 = 1" in found["Mobility"]
    assert "5 moving links, each slider one of them, the frame not" in found["Mobility"]
    assert "one is driven (ω1)" in found["Mobility"]
    assert found["Groups"].startswith("Structural formula I(0,1) → II(2,3) → II(4,5); ")
    assert "links 2 and 3: class II, order 2 (RPR)" in found["Groups"]


def test_a_dyad_has_its_species_where_the_language_counts_them() -> None:
    assert "II класс, 2-й порядок (3-й вид, ВПВ)" in told(solved(SHAPER), "ru")["Группы"]
    assert "II клас, 2-й порядок (2-й вид, ВВП)" in told(solved(SHAPER), "uk")["Групи"]


def test_two_drives_are_two_links_of_class_one() -> None:
    found = told(solved(FIVE_BAR))
    assert "= 3·4 − 2·5 − 0 = 2" in found["Mobility"]
    assert "I(0,1), I(0,4) → II(2,3)" in found["Groups"]
    assert "1 crank AB" in found["Links"] and "4 crank ED" in found["Links"]


def test_what_swings_is_a_rocker_and_what_turns_round_a_crank() -> None:
    """Four-bar 0.2, 0.5, 0.4, 0.45 m by Grashof: 0.2 + 0.5 < 0.4 + 0.45, so the shortest link turns and the other swings."""
    links = told(coursework.solve(coursework.load("example-1"), quantities=("table", "checks")))["Links"]
    assert "1 crank AB" in links and "3 rocker DC" in links
    # Before its first turning point nobody sees whether it will turn round.
    assert "3 link DC" in told(coursework.solve(coursework.load("example-1").timed(end=0.05), quantities=("table",)))["Links"]
    assert "1 rocker DA" in told(coursework.solve(coursework.load("31")))["Links"]


def test_a_driven_point_stands_where_a_driven_link_would() -> None:
    found = told(coursework.solve(coursework.load("31")))
    assert found["Links"] == "0 frame (D); 1 rocker DA; 2 coupler AB; 3 coupler MBC; 4 wheel CP"
    assert "3·4 − 2·5 − 0 = 2" in found["Mobility"] and "4 R and 1 of rolling without slip" in found["Mobility"]
    assert "I(M) → II(3,4) → II(1,2)" in found["Groups"]


def test_a_slider_that_is_no_link_of_the_list_is_counted_both_ways() -> None:
    text = told(coursework.solve(coursework.load("example-2"), quantities=("table",)))["Mobility"]
    assert "3·3 − 2·4 − 0 = 1" in text and "3·2 − 2·2 − 1 = 1" in text
    assert "With the pin of slider 3 set directly in its guide" in text


def test_fewer_freedoms_than_drives_are_not_laid_to_special_dimensions_alone() -> None:
    """A point that a guide leads, driven along it and, by zero, across it."""
    arm = (folder("variants") / "robot-arm.toml").read_text(encoding="utf-8")
    arm = re.sub(r"(?m)^VMx = .*\nVMy = .*", 'VMx = "V*sin(pi*t/T)"\nVMy = "0"', arm).replace('"1.2 m/s"', '"0.1 m/s"')
    arm = arm.replace('hinges = ["D"]', 'hinges = ["D"]\nrails = [{ through = "M", angle = "0" }]')
    assert "W = 1: one freedom, and one is driven" in told(solved(arm, ("table",)))["Mobility"]
    leaning = arm.replace('VMy = "0"', 'VMy = "VMx*tan(pi/180)"').replace('angle = "0"', 'angle = "1 deg"')
    found = told(solved(leaning, ("table",)))["Mobility"]
    assert "W = 1, yet the mechanism follows" in found
    assert "or it drives a point where a guide already leads it" in found


def test_without_links_there_is_no_such_section() -> None:
    assert told(solved(WITHOUT_LINKS)) == {}
    assert told(solved(V31))


@pytest.mark.long
@pytest.mark.parametrize(("language", "formula"), [("en", "W = 3n"), ("ru", "W = 3n"), ("uk", "W = 3n"), ("zh", "F = 3n")])
def test_page_and_paper_have_the_formula(language: str, formula: str) -> None:
    model = model_of(solved(SHAPER), language)
    page = page_of(model)
    section = page[page.index('<section id="structure">') :].partition("</section>")[0]
    assert f"{formula} − 2" in html_text(section)
    assert formula.replace(" ", "") in pdf_text(paper_of(model)).replace(" ", "")
    assert "I(0,1) → II(2,3) → II(4,5)" in html_text(section)


# A five-bar without a second crank: its last pivot C is pushed along a guide, by a length beside the groups.
PRESS = (
    STEPHENSON.partition('[[group]]\nkind = "RRR"\nfrom = ["G"')[0]
    .replace('C = "(0.35, 0)"\nE = "(0.60, 0.10)"\nG = "B + r6 @ (phi2 + delta)"\n', 'C = "(s, 0)"\n')
    .replace(
        'phi4 = { rate = "w4", unit = "rad" }\nphi5 = { rate = "w5", unit = "rad" }\n', 's = { start = "0.35 m", rate = "us" }\n'
    )
    .replace('w1 = "n1"', 'w1 = "n1"\nus = "0.2*r1*n1*sin(n1*t)"')
    + '[frame]\nhinges = ["A"]\nrails = [{ through = "C", angle = "0" }]\n'
)


def test_a_driven_slide_beside_the_groups_has_its_point_and_its_slider() -> None:
    run = solved(PRESS, ("table",))
    pairs = told(run)["Pairs"].replace("\u00a0", " ")
    assert "sliding, P: C (0,4)" in pairs and "C (3,4)" in pairs
    outline = read_outline(run.scene.mechanism)
    assert outline is not None and [(block.link, block.at, block.open) for block in outline.blocks] == [("4", "C", False)]


def test_a_crank_of_driven_length_carries_a_slider_that_its_rod_hangs_on() -> None:
    """By hand: 1 turns about A, the slider 4 runs along it with the pin B; W = 3·4 − 2·5 = 2, two of them driven."""
    longer = (
        PRESS.replace('lengths = ["r1"]', 'lengths = ["s"]').replace('"(s, 0)"', '"(0.35, 0)"').replace('"0.35 m"', '"0.1 m"')
    )
    longer = longer.replace('hinges = ["A"]\nrails = [{ through = "C", angle = "0" }]', 'hinges = ["A", "C"]')
    run = solved(longer, ("table",))
    pairs = told(run)["Pairs"].replace("\u00a0", " ")
    assert "sliding, P: B (1,4)" in pairs and "B (2,4)" in pairs and "A (0,1)" in pairs
    assert "I(0,1), I(1,4) → II(2,3)" in told(run)["Groups"].replace("\u00a0", " ")


def test_of_a_point_that_a_cam_lifts_no_body_is_known_and_no_pivot_drawn() -> None:
    """C follows a law of the crank angle on a guide: it is no hinge of the frame, and a count would leave its link out."""
    led = PRESS.replace('s = { start = "0.35 m", rate = "us" }\n', "").replace('us = "0.2*r1*n1*sin(n1*t)"\n', "")
    led = led.replace('C = "(s, 0)"', 'C = "(lift, 0)"\n[functions]\nlift = "0.35 + 0.02*sin(phi1)"', 1)
    run = solved(led, ("table", "plans"))
    mechanism = run.scene.mechanism
    outline = read_outline(mechanism)
    page = html_text(page_of(model_of(run)))
    assert re.search(r"VC = [\d.]+ m/s is given", page) and "No two known lines" not in page
    assert mechanism.linkage is None and outline is not None and outline.hinges == ("A",)


# A guide through A turned by a drive, another one pushed along by a second: a pin between both.
PIN = mechanism("pin-between-guides")


def test_what_turns_with_a_guide_has_its_pivot_where_the_guide_begins() -> None:
    run = solved(PIN, ("table", "plans"))
    assert "A (0,1)" in told(run)["Pairs"].replace("\u00a0", " ")
    page = html_text(page_of(model_of(run)))
    assert "The bent arrow is the given ω." in page and "where two lines meet" in page and "No two known lines" not in page
