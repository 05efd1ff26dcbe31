"""Which column is which where heads say it, say it twice, say it in part, or say nothing."""

from __future__ import annotations

import pytest

from coursework.grading.reading.expected import Grid, GridColumn
from coursework.grading.reading.limits import Refused
from coursework.grading.reading.numbers import printed
from coursework.grading.reading.table.columns import Places, find_columns
from coursework.grading.reading.table.headers import read_head
from coursework.grading.reading.table.layout import Layout
from coursework.grading.reading.table.units import _ratios, units_of_columns, whole_turns

UNITS = {"phi1": "rad", "phi2": "rad", "w1": "1/s", "w2": "1/s"}
TIMES = "0 0.1 0.2 0.3"
ANY = {"a": "1.63 1.71 1.44 1.9", "b": "0.35 0.31 0.3 0.39", "c": "5.1 4.2 6.6 4.8", "d": "-7.1 -7.9 -7.7 -7.2"}


def find(heads: str, columns: str, given: tuple[str, ...] = (), step: float = 0.1) -> Places:
    """Return where the columns stand in a file: heads, "-" for an empty one, "" for none, above columns parted by "|"."""
    grid = Grid(step, 4, tuple(GridColumn(name, unit, (1.0,) * 4) for name, unit in UNITS.items()), given)
    texts = ["" if text == "-" else text.replace("_", " ") for text in heads.split()]
    cells = [[printed(cell, ".") for cell in column.split()] for column in columns.split("|")]
    body = tuple(zip(*cells, strict=True))
    return find_columns(
        Layout(tuple(read_head(text, UNITS.items()) for text in texts or [""] * len(cells)), bool(texts), body, False, "."), grid
    )


def placed(found: Places) -> str:
    return " ".join(f"{name}:{place.at}{place.by[0]}" for name, place in sorted(found.places.items(), key=lambda one: one[1].at))


def numbers(*names: str) -> str:
    return "|".join(ANY.get(name, name) for name in names)


@pytest.mark.parametrize(("heads", "columns", "given", "places"), [
    ("t phi1 phi2 w1 w2", (TIMES, *"abcd"), (), "t:0h phi1:1h phi2:2h w1:3h w2:4h"),
    ("w2 t phi2 phi1 w1", ("a", TIMES, *"bcd"), (), "w2:0h t:1h phi2:2h phi1:3h w1:4h"),
    ("", (TIMES, *"abcd"), (), "t:0p phi1:1p phi2:2p w1:3p w2:4p"),
    ("", ("1 2 3 4", TIMES, *"abcd"), (), "№:0p t:1p phi1:2p phi2:3p w1:4p w2:5p"),
    ("", ("0 1 2 3", TIMES, *"abcd"), (), "№:0p t:1p phi1:2p phi2:3p w1:4p w2:5p"),
    ("", ("1 2 3 4", *"abcd"), (), "№:0p phi1:1p phi2:2p w1:3p w2:4p"),
    ("", ("4 2 3 1", *"abcd"), (), "№:0p phi1:1p phi2:2p w1:3p w2:4p"),  # whatever the order of the rows
    ("", tuple("abcd"), (), "phi1:0p phi2:1p w1:2p w2:3p"),
    ("", tuple("abc"), ("w1",), "phi1:0p phi2:1p w2:2p"),  # what is given may be left out
    ("", (TIMES, *"abc"), ("w1",), "t:0p phi1:1p phi2:2p w2:3p"),
    ("- phi1 phi2 w1 w2", (TIMES, *"abcd"), (), "t:0p phi1:1h phi2:2h w1:3h w2:4h"),
    ("- - phi1 phi2 w1 w2", ("1 2 3 4", TIMES, *"abcd"), (), "№:0p phi1:2h phi2:3h w1:4h w2:5h"),  # one of both is enough
    ("t ?1 ?2 w1 w2", (TIMES, *"abcd"), (), "t:0h w1:3h w2:4h phi1:1p phi2:2p"),
    ("t ?1 ?2 ?1 ?2", (TIMES, *"abcd"), (), "t:0h phi1:1p phi2:2p w1:3p w2:4p"),
    ("t phi1 - w1 w2", (TIMES, *"abcd"), (), "t:0h phi1:1h phi2:2p w1:3h w2:4h"),
    ("phi1 phi2 w1 w2", tuple("abcd"), (), "phi1:0h phi2:1h w1:2h w2:3h"),
    ("", ("0 0.1 0.3 0.4", *"abcd"), (), "t:0p phi1:1p phi2:2p w1:3p w2:4p"),  # a row is left out
    ("", ("0 0.1 0.1 0.2", *"abcd"), (), "t:0p phi1:1p phi2:2p w1:3p w2:4p"),  # a row stands twice
    ("- phi1 phi2 w1 w2", ("1 2 bad bad", *"abcd"), (), "phi1:1h phi2:2h w1:3h w2:4h"),  # of two no steps are known
    ("- phi1 phi2 w1 w2", ("0 0.1 0.2 bad", *"abcd"), (), "t:0p phi1:1h phi2:2h w1:3h w2:4h"),
    ("t phi1 phi2 rate_of_link_w1 w2", (TIMES, *"abcd"), (), "t:0h phi1:1h phi2:2h w1:3h w2:4h"),
])  # fmt: skip
def test_each_column_stands_where_its_head_or_its_place_says(
    heads: str, columns: tuple[str, ...], given: tuple[str, ...], places: str
) -> None:
    found = find(heads, numbers(*columns), given)
    assert {*placed(found).split()} == {*places.split()}
    assert found.repeated == () and found.asked is None


@pytest.mark.parametrize(("first", "step", "is_time"), [
    ("0 0.1 0.2 0.3", 0.1, True), ("0 0.1 0.2 0.3", 0.0953, True), ("0 0.1 0.2 0.3", 0.0951, False),
    ("0 0.1 0.2 0.3", 0.1052, True), ("0 0.1 0.2 0.3", 0.1054, False), ("0.1 0.2 0.3 0.4", 0.1, False),
    ("0.0 0.1 0.9 0.3", 0.3, False),  # these do not rise in equal steps
    ("0 0.1 0.3 0.4", 0.1, True), ("0.1 0.2 0.4 0.5", 0.1, False), ("0 0.2 0.1 0.4", 0.1, False), ("0 0 0 0", 0.1, False),
    ("0 0.1 bad bad", 0.1, False),  # two numbers tell nothing
    ("0 0.1 0.309 0.4", 0.1, True), ("0 0.1 0.311 0.4", 0.1, False),  # a row left out, and rounded by a tenth of the step
])  # fmt: skip
def test_numbers_before_too_few_columns_are_the_time_where_they_are_that_of_the_task(
    first: str, step: float, is_time: bool
) -> None:
    """Three columns for four: one lacks, so that the first is one of them unless it is the time."""
    with pytest.raises(Refused) as refused:
        find("", numbers(first, *"ab"), step=step)
    assert refused.value.trouble.text.values["found"] == (2 if is_time else 3)


@pytest.mark.parametrize(("times", "step", "name"), [
    ("0 1 2 3", 0.08, "№"), ("0 1 2 3", 0.09, "t"), ("1 2 3 4", 0.08, "№"), ("2 3 4 5", 0.08, "t"), ("0 2 4 6", 0.08, "t"),
    ("0 1 2 bad", 0.08, "№"), ("0 1 bad bad", 0.08, "t"),  # two numbers do not show how they go on
])  # fmt: skip
def test_a_time_in_whole_seconds_is_the_number_of_the_row_where_steps_are_short(times: str, step: float, name: str) -> None:
    assert placed(find("t phi1 phi2 w1 w2", numbers(times, *"abcd"), step=step)).split()[0] == f"{name}:0h"


@pytest.mark.parametrize(("heads", "columns", "code"), [
    ("", tuple("abc"), "count_columns"), ("", (TIMES, *"abc"), "count_columns"),
    ("", (TIMES, *"abc", "9 8 7 5", "d"), "count_columns"), ("", ("2 3 4 5", TIMES, *"abcd"), "count_columns"),
    ("", ("1 2 4 5", TIMES, *"abcd"), "count_columns"), ("?1 ?1 ?2 ?2", tuple("abcd"), "heads_disagree"),
    ("t w1 w1", (TIMES, "a", "b"), "two_columns"), ("t x y", (TIMES, *"ab"), "count_columns"),
    ("t phi1 x", (TIMES, "a", "1.5 bad2 1.1 1.2"), ""), ("t phi1 phi2", (TIMES, "a", "bad1 bad2 bad3 bad4"), "unread_column"),
    ("t phi1 x y z q", (TIMES, *"abcd", "9 8 7 5"), "unread_heads"),
    ("t ?3 ?4 ?5", (TIMES, *"abc"), "count_columns"), ("№ t", ("1 2 3 4", TIMES), "no_columns"),
])  # fmt: skip
def test_what_cannot_be_told_is_refused(heads: str, columns: tuple[str, ...], code: str) -> None:
    try:
        found = find(heads, numbers(*columns))
    except Refused as refused:
        assert refused.trouble.code == code
    else:
        assert code == "" or (code, found) == (code, None)


@pytest.mark.parametrize(("second", "counts"), [
    ("1.63 1.71 1.44 1.9", 0), ("1.6 1.7 1.4 1.9", 0), ("1.6300 1.7100 1.4400 1.9000", 0), ("1.64 1.71 1.44 1.9", 0),
    ("1.65 1.71 1.44 1.9", None),
    ("1.6350 1.7100 1.4400 1.9000", 0), ("1.6352 1.7100 1.4400 1.9000", None), ("1.6249 1.7100 1.4400 1.9000", 0),
])  # fmt: skip
def test_a_column_that_stands_twice_is_one_where_rounding_makes_both_alike(second: str, counts: int | None) -> None:
    """By 0.505 of each last place: 1.63 and 1.6352 are 0.0052 apart, a little more than 0.505*(0.01 + 0.0001)."""
    if counts is None:
        with pytest.raises(Refused, match="Columns 2 and 3 are both called phi1"):
            find("t phi1 phi1 w1", numbers(TIMES, "a", second, "c"))
        return
    found = find("t phi1 phi1 phi2 w1 w2", numbers(TIMES, "a", second, *"bcd"))
    assert (found.places["phi1"].at, found.repeated) == (1 + counts, ("phi1",))


def test_of_the_same_column_in_two_units_the_finer_counts() -> None:
    """1.63 rad is 93.4 deg: a tenth of a degree is 0.0017 rad, finer than 0.01."""
    for finer, coarser, at in (("phi1,deg", "phi1,rad", 1), ("phi1,rad", "phi1,deg", 2)):
        degrees, radians = "93.4 98.0 82.5 108.9", "1.63 1.71 1.44 1.90"
        columns = (degrees, radians) if at == 1 else (radians, degrees)
        found = find(f"t {finer} {coarser} w1", numbers(TIMES, *columns, "c"))
        assert (found.places["phi1"].at, found.repeated) == (at, ("phi1",))


@pytest.mark.parametrize(
    ("heads", "asked"), [("t phi1 phi2 x y", True), ("t phi1 phi2 w1 v2", False), ("t phi1 phi2 w1 x", False)]
)
def test_heads_that_name_no_column_of_the_task_are_taken_in_order_and_asked_about(heads: str, asked: bool) -> None:
    """One alone whose name is that of a length, x or v2, is no angular velocity."""
    found = find(heads, numbers(TIMES, *"abcd"))
    assert ((found.asked is not None), "w2" in found.places) == (asked, asked)


def test_a_column_without_a_head_is_asked_about_by_its_number() -> None:
    found = find("t phi1 phi2 - q", numbers(TIMES, *"abcd"))
    assert found.asked is not None and found.asked.values["heads"] == ("(4)", "q")
    assert placed(found).endswith("w1:3p w2:4p")


@pytest.mark.parametrize(("factor", "unit"), [(1.0, "m/s"), (1000.0, "mm/s")])
def test_the_speed_of_a_slider_is_no_angular_velocity_whatever_its_steps_say(factor: float, unit: str) -> None:
    """In a wrong table the unit of a slider's speed was said to be rad/s."""
    task = {
        "s": ("m", "u", (0.5, 0.52, 0.57, 0.6)),
        "u": ("m/s", "", (0.2, 0.5, 0.3, 0.1)),
        "w": ("1/s", "", (2.0, 3.0, 4.0, 5.0)),
    }
    grid = Grid(0.1, 4, tuple(GridColumn(name, of, values, rate) for name, (of, rate, values) in task.items()))
    own = {"s": (0.5, 0.52, 0.57, 0.6), "u": tuple(factor * v for v in task["u"][2]), "w": (2.6, 1.1, 7.0, 3.3)}
    assert units_of_columns(grid, dict.fromkeys(task, ""), own)["u"] == unit


def test_a_sliding_speed_that_is_wild_in_the_first_row_alone_keeps_its_unit():
    speeds = (1.0, 1.4, 2.75, 2.7, 2.8)
    grid = Grid(0.1, 5, (GridColumn("u", "m/s", speeds),), ())
    assert units_of_columns(grid, {"u": ""}, {"u": [-175.0, 0.13, 0.44, 0.93, 1.75]})["u"] == "m/s"


RATE = [4.0 - 0.3 * k for k in range(5)]


@pytest.mark.parametrize(("heads", "factors", "units"), [
    (("rad", "1/s"), (57.29578, 1.0), ("deg", "1/s")), (("deg", "1/s"), (1.0, 1.0), ("rad", "1/s")),
    (("rad", "1/s"), (57.29578, 57.29578), ("deg", "deg/s")), (("rad", "1/s"), (1.0, 9.549297), ("rad", "rpm")),
    (("rad", "1/s"), (10.0, 1.0), ("rad", "1/s")),  # another number is no unit
])  # fmt: skip
def test_a_head_that_the_numbers_contradict_is_only_a_slip(heads, factors, units):
    """The steps are made with the velocities; a label alone cost 26 of 60 points."""
    angle = [1.4]
    for rate in RATE[:-1]:
        angle.append(angle[-1] + 0.02 * rate)
    grid = Grid(0.02, 5, (GridColumn("q", "rad", angle, "w"), GridColumn("w", "1/s", RATE)))
    own = {"q": [factors[0] * value for value in angle], "w": [factors[1] * value for value in RATE]}
    assert tuple(units_of_columns(grid, dict(zip("qw", heads, strict=True)), own).values()) == units


@pytest.mark.parametrize(("head", "angle"), [("rad", 1.0), ("deg", 57.29578), ("", 57.29578)])
@pytest.mark.parametrize(("unit", "rate"), [("1/s", 1.0), ("deg/s", 57.29578), ("rpm", 9.549297)])
def test_velocities_that_are_all_wrong_have_the_unit_in_which_they_make_the_steps(head, angle, unit, rate):
    wrong, angles, right = [3.0, 4.9, 2.7, 4.4, 3.1], [1.4], [1.4]
    for own, key in zip(wrong[:-1], RATE[:-1], strict=True):
        angles.append(angles[-1] + 0.02 * own)
        right.append(right[-1] + 0.02 * key)
    grid = Grid(0.02, 5, (GridColumn("q", "rad", right, "w"), GridColumn("w", "1/s", RATE)))
    own = {"q": [angle * value for value in angles], "w": [rate * value for value in wrong]}
    assert units_of_columns(grid, {"q": head, "w": ""}, own) == {"q": "rad" if angle == 1.0 else "deg", "w": unit}


@pytest.mark.parametrize(("head", "factor", "unit"), [
    ("m", 1000.0, "mm"), ("mm", 1.0, "m"), ("cm", 1000.0, "mm"), ("m", 10.0, "m"), ("m", 985.0, "m"), ("m", 995.0, "mm"),
])  # fmt: skip
def test_a_length_or_speed_under_the_head_of_another_unit_is_only_a_slip_of_the_head(head, factor, unit):
    """It cost 3 points of 60 in one mechanism and 9 in another; up to 1 % the factor must be that of the unit."""
    grid = Grid(0.02, 5, (GridColumn("s", "m", RATE, "u"), GridColumn("v", "m/s", RATE)))
    own = {name: [factor * value for value in RATE] for name in "sv"}
    assert units_of_columns(grid, {"s": head, "v": f"{head}/s"}, own) == {"s": unit, "v": f"{unit}/s"}


def test_a_velocity_that_only_looks_converted_keeps_the_unit_of_its_head():
    """A crank turning 9.55 times too fast, as the angles do: its speed was taken in revolutions per minute."""
    grid = Grid(0.02, 5, (GridColumn("q", "rad", [0.0, 0.2, 0.4, 0.6, 0.8], "w"), GridColumn("w", "1/s", [10.0] * 5)))
    own = {"q": [9.549297 * 0.2 * k for k in range(5)], "w": [95.49297] * 5}
    assert units_of_columns(grid, {"q": "rad", "w": "1/s"}, own) == {"q": "rad", "w": "1/s"}


@pytest.mark.parametrize(("key", "own", "turns"), [
    ((5.57, 5.6, 5.7, 5.8), (0.0,) * 4, ()),  # near a turn, but it is no motion
    ((5.57, 5.6, 5.7, 5.8), (-0.7132, -0.6832, -0.5832, -0.4832), (-1,) * 4), ((5.57,) * 4, (-0.7132,) * 4, (-1,) * 4),
])  # fmt: skip
def test_a_column_that_stands_still_has_no_whole_turns(key, own, turns):
    assert whole_turns(GridColumn("phi3", "rad", key), own) == turns


@pytest.mark.parametrize("size", [0.004, -250.0])
@pytest.mark.parametrize(("part", "ratios"), [(0.049, []), (-0.049, []), (0.051, [2.0, 2.0]), (-0.051, [2.0, 2.0])])
def test_a_cell_that_is_small_in_its_column_gives_no_ratio(size: float, part: float, ratios: list[float]) -> None:
    assert _ratios([size, part * size], [2 * size, 2 * part * size]) == pytest.approx(ratios)
