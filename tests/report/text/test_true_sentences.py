"""What a page says of mechanisms that are in no file: a shaper with exact rows, a five-bar with two drives, and others."""

from __future__ import annotations

import re
from types import ModuleType
from typing import Any

import pytest

import coursework
from coursework.equations.reduction.meaning import meaning
from coursework.variant.formula.reader import parse as parse_formula
from coursework.variant.reading.reader import parse_variant
from tests.hard.test_change_points import past_the_pivot
from tests.mechanisms.library import mechanism
from tests.report.own import BOOM, STEPHENSON
from tests.results.kinematics.mechanisms import FIVE_BAR, SHAPER, slider_crank

EVERYTHING = ["table", "plots", "checks", "analogs", "invariants"]


def solved(text: str, *quantities: str, **named: Any) -> Any:
    return coursework.solve(parse_variant(text), quantities=quantities or ("table", "plots", "checks"), **named)


def told(real: ModuleType, run: Any, section: str) -> str:
    return str(real.text_of(real.parts(run, section))).replace("\u00a0", " ").replace("\u202f", " ")


def finding(run: Any, code: str) -> Any:
    return next(one for one in run.checks if one.code == code)


@pytest.fixture(scope="module")
def shaper() -> Any:
    return solved(SHAPER, *EVERYTHING)


@pytest.fixture(scope="module")
def five_bar() -> Any:
    return solved(FIVE_BAR)


def test_a_page_of_exact_rows_does_not_begin_with_the_error_of_a_scheme(real: ModuleType, shaper: Any) -> None:
    page = told(real, shaper, "statement")
    assert "Largest error" not in page
    assert "The rows are the motion itself." in page
    assert "For comparison: the largest relative error of explicit Euler with the same step would be " in page
    beside = shaper.distance_to_exact
    assert f", row {beside.row}, {100 * beside.share:.1f} % of its scale." in page, "the error that the command line tells"


def test_a_crank_at_constant_speed_does_not_oscillate(real: ModuleType, shaper: Any) -> None:
    claims = told(real, shaper, "control")
    assert "The step is small against a turn of φ1" in claims
    assert "oscillation" not in claims
    assert "sinusoidal" not in claims
    assert "not judged by rows" not in finding(shaper, "STEP").sentence


def test_a_page_of_some_columns_does_not_say_that_the_file_shows_no_points(real: ModuleType) -> None:
    some = told(real, coursework.solve("31", quantities=["phi3"]), "equations")
    assert "The bodies are rigid" in some and "gives no points" not in some


def test_each_table_names_the_file_that_holds_it_whole(real: ModuleType, shaper: Any) -> None:
    assert "(22 of 101); analogs.csv has them all." in told(real, shaper, "analogs")
    points = solved(SHAPER, "table", "points")
    assert "table.csv has them all." in told(real, points, "points")


@pytest.mark.parametrize(("turns", "row", "last"), [("2", 101, 101), ("3", 101, 151), ("5", 201, 251)])
def test_the_row_that_repeats_need_not_be_the_last(real: ModuleType, turns: str, row: int, last: int) -> None:
    run = solved(SHAPER.replace('end = "2*pi/n"', f'end = "{turns}*pi/n"'), "table", "checks")
    assert len(run.motion.t) == last
    pages = [told(real, run, section) for section in ("statement", "control", "results")]
    named = [f"Row {row} repeats row 1.", f"Row {row} repeats row 1 in its positions.", f"The first row beside row {row}."]
    assert [words in page for words, page in zip(named, pages, strict=True)] == [row < last] * 3
    assert ["last row" in page or "beside the last" in page for page in pages] == [row == last] * 3


def test_a_constant_drive_is_not_said_to_repeat(real: ModuleType, shaper: Any) -> None:
    assert "The stated period is 0.5 s." in told(real, shaper, "statement")


def test_only_the_driven_point_is_said_to_be_driven_as_one(real: ModuleType, five_bar: Any) -> None:
    page = told(real, five_bar, "statement")
    point, _, besides = page.partition("Also known at every moment:")
    assert "Point M is driven." in point
    assert "ω1 = n" not in point
    assert besides


def test_of_one_step_half_the_step_leaves_a_quarter(real: ModuleType, five_bar: Any) -> None:
    page = told(real, five_bar, "results")
    assert "With half the step, each step is off by a quarter of that" in page
    assert "once the step is small, the error of the table is about halved" in page
    assert "a step that starts on the exact curve ends off it by about" in page
    assert "(starting at the time of row" in page
    steps = [solved(FIVE_BAR, "table", "checks", step=0.02 / parts) for parts in (1, 2, 4)]
    off = [
        max(abs(run.motion.column("phi2")[:: 2**k][:20] - run.exact.column("phi2")[:: 2**k][:20])) for k, run in enumerate(steps)
    ]
    assert off[0] / off[1] == pytest.approx(2, abs=0.2)


def test_one_drive_of_two_may_be_a_sine(five_bar: Any) -> None:
    assert (
        finding(five_bar, "SINUSOID").sentence == "Not every drive consists of sines of time, so the velocities need not either."
    )


def test_harmonics_are_told_where_the_motion_is_no_single_sine(real: ModuleType) -> None:
    run = coursework.solve("31")
    assert (
        "harmonics 1, 2, 3 carry 16, 82, 2 % of w1 in the table (31, 65, 4 % in the exact motion)"
        in finding(run, "SINUSOID").sentence
    )
    claims = told(real, run, "control")
    assert "not of one sine: 1, 2, 3 carry 16, 82, 2 % of ω1 in the table" in claims
    assert "as the drive is" not in claims


def test_where_one_sine_carries_all_the_motion_is_as_the_drive(real: ModuleType) -> None:
    """A crank that swings a little moves its slider as a sine, whatever the guide."""
    run = solved(slider_crank(0.0, 1.2, "0.2*n*cos(n*t)"), "table", "checks")
    assert finding(run, "SINUSOID").sentence.startswith(
        "The velocities are sinusoidal, as the drive is: its own frequency alone carries 9"
    )
    assert "The velocities are sinusoidal, as the drive is" in told(real, run, "control")
    wide = solved(slider_crank(0.0, 0.0, "0.9*n*cos(n*t)"), "table", "checks")
    assert "but not the drive’s own frequency alone" in finding(wide, "SINUSOID").sentence


@pytest.mark.parametrize(
    ("offset", "words"),
    [
        ("", "(the slider is at the pivot of its guide)"),
        ('offset = "0.02 m"\n', "(the slider is level with the pivot of its guide)"),
    ],
)
def test_a_slider_stands_on_its_pivot_only_without_an_offset(offset: str, words: str) -> None:
    variant = parse_variant(SHAPER.replace('coordinates = ["phi3", "s"]\n', f'coordinates = ["phi3", "s"]\n{offset}'))
    assert meaning(parse_formula("s"), variant, ()) == f"the distance s is zero {words}"


def test_a_distance_that_no_point_shows_is_no_more_than_zero() -> None:
    variant = parse_variant(past_the_pivot(0.1, 0.02))
    assert meaning(parse_formula("s"), variant, ()) == "the distance s is zero"
    placed = parse_variant(past_the_pivot(0.1, 0.02) + '[points]\nO = "(0, 0)"\nQ = "O + s @ phi"\n')
    assert meaning(parse_formula("s"), placed, ()) == "the distance s is zero (Q lies on O)"


def test_a_point_placed_at_an_angle_to_a_link_does_not_hide_how_its_group_counts_the_angle() -> None:
    told = meaning(parse_formula("sin(phi2 - phi3)"), parse_variant(STEPHENSON), ())
    assert told == "link 2 and link 3 lie on one line (stretched or folded)"


def test_an_angle_counted_from_the_vertical_makes_no_link_vertical() -> None:
    upright = FIVE_BAR.replace("r2 @ phi2", "r2 @ (phi2 - pi/2)")
    assert meaning(parse_formula("cos(phi2)"), parse_variant(FIVE_BAR), ()) == "link 2 is vertical"
    told = [meaning(parse_formula(text), _parsed(upright), ()) for text in ("cos(phi2)", "sin(phi2 - phi3)", "sin(phi1 - phi3)")]
    assert told == ["cos(phi2) is zero", "sin(phi2 - phi3) is zero", "link 1 and link 3 lie on one line (stretched or folded)"]


def test_an_angle_whose_arm_is_written_by_components_is_counted_as_they_say() -> None:
    arms = {"(r2*sin(phi2), -r2*cos(phi2))": False, "(-r2*cos(phi2), -r2*sin(phi2))": True, "r2 @ (pi/2 - phi2)": False}
    for arm, vertical in arms.items():  # at cos(phi2) = 0, the first and the third lie along x
        placed = parse_variant(FIVE_BAR.replace("r2 @ phi2", arm))
        told = meaning(parse_formula("cos(phi2)"), placed, ())
        assert told == ("link 2 is vertical" if vertical else "cos(phi2) is zero"), arm
    both = FIVE_BAR.replace("r2 @ phi2", "(r2*sin(phi2), r2*cos(phi2))").replace("r3 @ phi3", "r3 @ (pi/2 - phi3)")
    told = meaning(parse_formula("sin(phi2 - phi3)"), parse_variant(both), ())
    assert told == "link 2 and link 3 lie on one line (stretched or folded)"


def test_an_angle_that_only_the_closure_counts_is_counted_as_it_says() -> None:
    held = 'holds = ["M.x - B.x - r2*sin(phi2) - r3*cos(phi3)", "M.y - B.y + r2*cos(phi2) - r3*sin(phi3)"]'
    upright = (
        FIVE_BAR.replace('C = "B + r2 @ phi2"', "")
        .replace("C + r3 @ phi3", "(0.5, 0.1)")
        .replace('"B", "C"', '"B", "M"')
        .replace('"C", "M"', '"M"')
    )
    variant = parse_variant(upright.replace('driven = "M"', held).replace("VMx", "ux").replace("VMy", "uy"))
    assert meaning(parse_formula("cos(phi2)"), variant, ()) == "cos(phi2) is zero"
    assert meaning(parse_formula("cos(phi3)"), variant, ()) == "link 3 is vertical"


def _parsed(text: str) -> Any:
    return parse_variant(
        text.replace("r2*w2*sin(phi2)", "r2*w2*sin(phi2 - pi/2)").replace("r2*w2*cos(phi2)", "r2*w2*cos(phi2 - pi/2)")
    )


def test_the_caption_names_every_drive(real: ModuleType, five_bar: Any) -> None:
    page = told(real, five_bar, "statement")
    assert "The arrow shows how M is driven. The bent arrow is the given ω1." in page
    pushed = solved(past_the_pivot(0.1, 0.02) + '[points]\nO = "(0, 0)"\nQ = "O + s @ phi"\n[frame]\nhinges = ["O"]\n')
    assert "No motion is given" not in told(real, pushed, "statement")
    law_of_no_rate = solved(mechanism("four-bar-by-squared-lengths"))
    assert "Also given, without an arrow: vp." in told(real, law_of_no_rate, "statement")


def test_closures_without_written_equations_are_derived_once(real: ModuleType) -> None:
    page = told(real, solved(mechanism("clockwise-four-bar")), "equations")
    assert "Closed vector contour" in page
    assert "The velocity of a point follows from another" not in page


def test_the_velocity_of_a_link_is_not_called_like_a_rate_counted_from_another_link(real: ModuleType) -> None:
    page = told(real, solved(mechanism("four-bar-with-relative-angles"), "graph_check"), "graph_check")
    assert "ω of link 2" in page
    assert "ω₂" not in page


def test_a_drive_that_jumps_makes_the_graphs_jump(real: ModuleType) -> None:
    law = '{ pieces = [["0 s", "n"], ["0.25 s", "2*n"]] }'
    run = solved(SHAPER.replace('w1 = "n"', f"w1 = {law}").replace('period = "2*pi/n"\n', ""), "table", "checks")
    assert "no jump except in velocities where the drive jumps" in told(real, run, "control")
    assert finding(run, "CONTINUITY").sentence.startswith("The exact motion jumps only in its velocities, where the drive jumps")


def test_rows_that_a_scheme_ends_are_not_the_end_of_the_motion(real: ModuleType) -> None:
    run = solved(past_the_pivot(0.001, 0.02), "table", "checks")
    page = " ".join(told(real, run, section) for section in ("statement", "dead_point", "control", "results"))
    assert "the mechanism itself goes on" in page
    assert "The rows end before the motion does: the step is too large." in page
    assert "The motion stops" not in page
    assert "nothing beyond it would be a motion" not in page


def test_what_the_numbers_are_parts_of_is_said_where_they_first_stand(real: ModuleType, five_bar: Any) -> None:
    assert "5 of 5 checks of the computation" in five_bar.summary
    assert re.search(r"% of 0.49 rad \(phi2, row \d+\)", five_bar.summary)
    assert "a column’s scale: its range in the exact motion" in told(real, five_bar, "control")


# An arm whose second angle is counted from its first link, and one whose links have rates of their own.
ARM = mechanism("arm-with-relative-angle")


@pytest.mark.parametrize(
    ("sign", "factor", "told"),
    [
        ("+", "sin(phi2)", "link 1 and link 2 lie on one line (stretched or folded)"),
        ("-", "sin(phi2)", "link 1 and link 2 lie on one line (stretched or folded)"),
        ("+", "cos(phi2)", "link 1 and link 2 are at a right angle to each other"),
        ("+ a/b +", "sin(phi2)", "sin(phi2) is zero"),
    ],
)
def test_an_angle_counted_from_another_link_tells_how_both_lie(sign: str, factor: str, told: str) -> None:
    variant = parse_variant(ARM.replace("phi1 + phi2", f"phi1 {sign} phi2"))
    assert meaning(parse_formula(factor), variant, ()) == told


def test_what_slides_along_a_link_that_moves_is_no_sleeve_on_a_pivot(real: ModuleType) -> None:
    assert "Link 3 slides along link 2." in told(real, solved(BOOM, "table"), "statement")
    assert "Sleeve 4 carries the bar 3, which slides in it." in told(
        real, coursework.solve("v107", quantities=["table"]), "statement"
    )
