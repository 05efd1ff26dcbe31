"""Start values of a chain: as near as they are written, in the order of its groups, told in the unit that was typed."""

import math

import pytest

import coursework
from coursework.motion.geometry.start import start_values
from tests.mechanisms.library import changed, mechanism
from tests.scene.model.test_start import angles, four_bar

FROM, NAMES = 'from = ["B", "D"]', 'coordinates = ["phi2", "phi3"]'


def faults(off=0.0, *, unit="deg", changes=(), place=0):
    """Return codes, values and the starts of a file whose start is `off` (rad) beside where the dyad closes."""
    start = list(angles(0.1, 1))
    start[place] += off
    first = repr(start[0] if unit == "rad" else math.degrees(start[0]))
    text = changed(four_bar(f"{first} {unit}", f"{math.degrees(start[1])!r} deg", mode="+1"), *changes)
    try:
        run = coursework.solve(coursework.parse_variant(text, "own.toml"))
        found = start_values(run.scene.equations)
    except coursework.InputError as error:
        return [(fault.code, fault.message.values) for fault in error.faults]
    assert found == pytest.approx([math.radians(40), *angles(0.1, 1)], abs=1e-12)
    return []


@pytest.mark.parametrize("place", [0, 1])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_start_is_where_the_dyad_closes_but_for_a_millionth(sign, place):
    assert faults(sign * 0.9e-6, place=place) == []
    ((code, told),) = faults(sign * 1.1e-6, place=place)
    wanted = math.degrees(angles(0.1, 1)[place])
    assert (code, told["name"], told["unit"]) == ("V332", ("phi2", "phi3")[place], "deg")
    assert (told["start"], told["closed"]) == (pytest.approx(wanted + math.degrees(sign * 1.1e-6)), pytest.approx(wanted))


def test_a_start_is_told_in_the_unit_that_was_typed():
    ((_, told),) = faults(0.1, unit="rad")
    assert (told["unit"], told["closed"]) == ("rad", pytest.approx(angles(0.1, 1)[0]))


@pytest.mark.parametrize(("old", "new", "key"), [
    (FROM, 'from = ["D", "B"]', "from"), (NAMES, 'coordinates = ["phi3", "phi2"]', "coordinates"),
])  # fmt: skip
@pytest.mark.parametrize(("off", "is_swap"), [(0.0, True), (0.019, True), (-0.019, True), (0.021, False), (-0.021, False)])
def test_points_or_coordinates_in_the_other_order_are_told_where_the_start_shows_it(old, new, key, off, is_swap):
    found = faults(off, changes=[(old, new)])
    assert [code for code, _ in found] == (["V334"] if is_swap else ["V332", "V332"])
    if is_swap:
        told = found[0][1]
        assert (told["number"], told["kind"], told["key"]) == (2, "RRR", key)
        assert told["swapped"] == {"from": '["B", "D"]', "coordinates": '["phi2", "phi3"]'}[key]


@pytest.mark.parametrize(("rod", "mended"), [("0.30 m", True), ("0.001 m", False)])
def test_the_other_mode_of_an_earlier_group_is_advised_where_with_it_a_group_closes(rod, mended):
    other = 'coordinates = ["phi3", "s"]\nmode = "-1"'
    wrong = mechanism("shaper", ('coordinates = ["phi3", "s"]\nmode = "+1"', other), b=rod)
    with pytest.raises(coursework.InputError, match=r"V306 .*group 3 .*too short\.") as caught:
        _ = coursework.solve(coursework.parse_variant(wrong)).table
    assert str(caught.value).endswith('With mode = "+1" in group 2 it can.') == mended
    if mended:
        right = changed(wrong, (other, other.replace("-1", "+1")))
        assert coursework.solve(coursework.parse_variant(right)).stop is None


@pytest.mark.parametrize(("short", "is_told"), [("1.1e-4", False), ("0.9e-4", True), ("1e-12", True)])
def test_a_gap_that_rounding_may_have_made_is_told_as_that(short, is_told):
    """The crank of 0.4 m is turned away from D, 1.2 m from A: rods of 1 m and 0.6 m would just reach."""
    text = coursework.load("example-1").path.read_text(encoding="utf-8")
    text = changed(text, ('"0 deg"', '"180 deg"'), ('r3 = "0.7 m"', f'r3 = "{0.6 - float(short)!r} m"'))
    with pytest.raises(coursework.InputError, match="cannot be assembled at t = 0 s: B and D are") as refused:
        assert coursework.solve(coursework.parse_variant(text), quantities=["table"]).stop
    assert ("Such a small gap may come from the rounding" in str(refused.value)) == is_told
