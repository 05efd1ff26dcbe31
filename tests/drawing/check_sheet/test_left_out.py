"""A file that lists not all links: what the others determine is drawn and read, and of the rest it is said that it is open."""

from __future__ import annotations

import re
import warnings
from dataclasses import replace

import pytest

from coursework import CourseworkWarning, load, parse_variant, solve
from coursework.drawing.check_sheet.graph_check import check_graph
from coursework.drawing.check_sheet.graph_words import drift
from coursework.words.sentences import load_phrases
from tests.drawing.check_sheet.checked import at_row, check_of, run_of
from tests.mechanisms.library import mechanism


@pytest.mark.parametrize(
    ("name", "link", "open_links", "is_drawn"),
    [
        ("v110", "2", ("2",), True), ("v112", "4", ("1", "2", "4"), True), ("v112", "3", (), True), ("v105", "1", (), True),
        ("v107", "1", ("2",), True), ("v102", "3", ("1", "2", "3"), False), ("v107", "4", ("1", "2", "3"), False),
    ],
)  # fmt: skip
def test_links_that_the_others_do_not_determine_are_named(
    name: str, link: str, open_links: tuple[str, ...], is_drawn: bool
) -> None:
    text = mechanism(name)
    line = next(line for line in text.partition("[links]")[2].split("\n") if re.match(rf"{link}\s*=", line))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", CourseworkWarning)  # that nothing slides in a guide
        check = solve(parse_variant(text.replace(line, "")), quantities=["graph_check"]).graph_check
    assert check is not None
    assert check.findings.missing == open_links
    assert (not check.unread) == is_drawn == bool(check.sheets())
    said = load_phrases("en")
    notes = [said.written(note) for note in check.notes]
    assert {one for one in open_links if f"Link {one} is not determined by the drawing." in notes} == {*open_links}
    if not is_drawn:
        assert "the drawing does not determine every link" in said.written(check.unread)
    else:
        assert not {f"ω{one}" for one in open_links} & {reading.name for reading in check.readings}


def test_a_driven_point_that_has_no_name_leaves_the_drawing_open() -> None:
    """The group hangs on (x, 0), whose velocity was looked for under a name of its own: an error of the tool."""
    check = solve(parse_variant(mechanism("driven-slider")), quantities=["graph_check"]).graph_check
    assert check is not None and "the drawing does not determine every link" in load_phrases("en").written(check.unread)


@pytest.mark.parametrize("name", ["31", "v107", "v108", "v112"])
@pytest.mark.parametrize("row", [2, 12])
def test_a_motion_that_keeps_its_lengths_is_said_to_drift_nowhere(name: str, row: int) -> None:
    """Where a wheel touches is another place of it in each row: only its centre keeps its distance."""
    run = solve(load(name), "exact", quantities=["table"])
    equations = replace(run.scene.equations, variant=at_row(run.variant, row))
    check = check_graph(run.scene.mechanism, equations, run.motion, run.motion)
    assert check is not None
    assert drift(check.sketch) == []


@pytest.mark.parametrize(("name", "side", "link"), [("v104", "OC", "4"), ("v105", "EM", "3"), ("v112", "AE", "2")])
def test_a_link_that_the_scheme_stretches_is_named_with_its_amount(name: str, side: str, link: str) -> None:
    points = run_of(name).points
    first, second = (points[end].position.to_numpy() @ (1, 1j) for end in side)
    lengths = abs(first - second)
    for row in (12, 20):
        off = lengths[row - 1] - lengths[0]
        (told,) = drift(check_of(name, row).sketch)
        assert f"{side} of link {link} is {abs(off) * 1e3:.3g} mm too {'long' if off > 0 else 'short'}" in told
