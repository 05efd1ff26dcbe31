"""What a finding says beside its verdict: numbers at a limit, what leaves its place, and what to write where nothing judges."""

import pytest

import coursework
from coursework.results.checks.result import digits_apart, percent
from tests.mechanisms.library import mechanism

ALONG_THE_CHAIN = ('D = "(xD, yD)"', 'D = "B - r3 @ phi3"'), ('G = "(xG, yG)"', 'G = "E - r5 @ phi5"')
HOLDS = ["(B - D - r3 @ phi3).x", "(B - D - r3 @ phi3).y", "(E - G - r5 @ phi5).x", "(E - G - r5 @ phi5).y"]


def found(text: str, code: str):
    run = coursework.solve(coursework.parse_variant(text), quantities=["table", "checks"])
    return next(finding for finding in run.checks if finding.code == code)


@pytest.mark.parametrize(
    ("share", "shown"),
    [(0.0494, "4.9 %"), (0.04996, "4.996 %"), (0.05, "5.0 %"), (0.050049, "5.005 %"), (0.0506, "5.1 %"), (0.05 + 1e-12, "5 %")],
)
def test_a_share_on_one_side_of_its_limit_never_reads_like_one_on_the_other(share, shown):
    assert str(percent(share, 0.05)) == shown
    assert str(percent(share)) == f"{100 * share:.1f} %"


@pytest.mark.parametrize(
    ("share", "shown"),
    [
        (0.0, "0 %"), (9.9e-7, "less than 0.0001 %"), (1.01e-6, "0.0001 %"), (4.94e-4, "0.049 %"), (5.1e-4, "0.1 %"),
        (9.994, "999.4 %"), (10.0, "1,000 %"), (99.99, "9,999 %"), (100.0, "more than 10,000 %"), (1e6, "more than 10,000 %"),
    ],
)  # fmt: skip
def test_a_share_has_as_many_digits_as_anybody_compares(share, shown):
    assert str(percent(share)) == shown


def test_digits_are_added_only_where_two_numbers_would_read_alike():
    assert [digits_apart(value, 0.05, 3, "g") for value in (0.0500499, 0.0496, 0.05, 0.7)] == [4, 3, 3, 3]


def test_what_is_open_is_told_by_what_leaves_its_place():
    """A pivot along the chain moves, a slider leaves its guide, between two links they no longer meet."""
    apart = str(found(mechanism("windshield-wiper"), "DRIFT").sentence)
    assert "with this step the links no longer meet" in apart
    pivot = found(mechanism("windshield-wiper", *ALONG_THE_CHAIN, holds=None), "DRIFT")
    assert "G.y is" in str(pivot.sentence) and "with this step the pivot G moves" in str(pivot.sentence)
    slider = found(mechanism("slider-crank-with-slide-velocity", step="0.05 s"), "DRIFT")
    assert "C.y is" in str(slider.sentence) and "with this step C leaves its guide" in str(slider.sentence)
    rod = ("(xC - xB)^2 + (yC - yB)^2 - r2^2", "(C.x - xB)^2 + (C.y - yB)^2 - r2^2")  # a length, though one point stands in it
    assert "the links no longer meet" in str(
        found(mechanism("four-bar-by-squared-lengths", rod, step="0.03 s", end="0.06 s"), "DRIFT").sentence
    )


def test_the_length_that_nothing_keeps_is_told_with_the_line_that_keeps_it():
    """Both pivots are given by data, and nothing says that links 3 and 5 reach them."""
    loose = found(mechanism("windshield-wiper", holds="[]"), "AGREEMENT")
    written = ", ".join(f'"{hold}"' for hold in HOLDS)
    assert loose.verdict == "SKIP" and loose.is_news
    assert "Nothing keeps the distance between D and B (link 3), G and E (link 5)." in str(loose.sentence)
    assert f"write [closure] holds = [{written}]" in str(loose.sentence)
    assert found(mechanism("windshield-wiper", holds=f"[{written}]"), "AGREEMENT").verdict == "PASS"


def test_a_crank_in_x_and_y_is_not_told_not_to_turn():
    """It turns evenly, yet no angle of the file says so; beside it, a crank with an angle is judged by its turns."""
    crank = (
        'format = 1\n[given]\nr = "0.2 m"\nn = "3 rad/s"\n[drive]\nw = "n"\n[time]\nstep = "0.01 s"\nend = "0.2 s"\n'
        '[coordinates]\nx = { start = "0.2 m", rate = "vx" }\ny = { start = "0 m", rate = "vy" }\n'
        '[[constraint]]\nequation = "vx = -w*y"\n[[constraint]]\nequation = "vy = w*x"\n'
    )
    told = found(crank, "STEP")
    assert (
        told.verdict == "SKIP" and "crank" not in str(told.sentence) and "no driven coordinate is an angle" in str(told.sentence)
    )
    assert found(crank.replace("x = {", 'f = { start = "0 rad", rate = "w" }\nx = {'), "STEP").verdict == "PASS"
