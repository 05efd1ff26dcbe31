"""An order of coordinates or points that cannot be meant is a fault with the swap; RPR asks for its mode."""

import re

import pytest

import coursework
from tests.mechanisms.library import mechanism

# Neither a unit nor a length of the last group tells what q4 and p4 are, but the point T does.
CHAIN = mechanism(
    "six-bar-with-sleeve", ('meets = "E"\nlengths = ["L"]\ncoordinates = ["phi5", "s4"]', 'coordinates = ["q4", "p4"]'),
    ("[time]", 'q4 = { rate = "w4" }\np4 = { rate = "u4" }\n[time]'), ('F = "(d, -f)"', 'F = "(d/2, -d)"\nT = "F + L @ q4"'),
    ('"0 deg"', '"40 deg"'), r1="0.3 m", r2="0.8 m", r3="0.6 m", d="0.5 m", f=None, L="0.6 m", n1="2 rad/s", phi5=None, s4=None,
    step="0.05 s", end="1 s", period=None,
)  # fmt: skip


def solved(text):
    return coursework.solve(coursework.parse_variant(text, "v.toml"), quantities=["table"])


def refused(text):
    with pytest.raises(coursework.InputError) as caught:
        solved(text).table  # noqa: B018
    (fault,) = caught.value.faults
    return fault


@pytest.mark.parametrize("names", [("q4", "p4"), ("theta4", "s4"), ("fi4", "x"), ("psi", "s")])
@pytest.mark.parametrize("is_measured", [True, False])
def test_a_distance_where_the_angle_stands(names, is_measured):
    """Where a formula of the file measures one of the two, that tells; else names that only angles have do."""
    text = CHAIN if is_measured else CHAIN.replace('T = "F + L @ q4"\n', "")
    text = re.sub(r"\bq4\b", names[0], re.sub(r"\bp4\b", names[1], text))
    assert len(solved(text).table)
    turned = text.replace(f'["{names[0]}", "{names[1]}"]', f'["{names[1]}", "{names[0]}"]')
    if names == ("q4", "p4") and not is_measured:
        assert list(solved(turned).table.columns)  # nothing tells which of the two is meant
        return
    fault = refused(turned)
    assert fault.code == "V156"
    assert str(fault.message).endswith(f'Write coordinates = ["{names[0]}", "{names[1]}"].')


def test_units_tell_the_order_of_an_rrp():
    text = CHAIN[: CHAIN.index('[[group]]\nkind = "RPR"')].replace('T = "F + L @ q4"\n', "")
    text = text.replace("q4 = { rate", 'q4 = { unit = "rad", rate').replace("p4 = { rate", 'p4 = { unit = "m", rate')
    slider = '[[group]]\nkind = "RRP"\nfrom = ["C"]\nlengths = ["2*r2"]\nguide = { through = "F", angle = "0" }\nmode = "+1"\n'
    assert len(solved(f'{text}{slider}coordinates = ["q4", "p4"]\n').table)
    assert refused(f'{text}{slider}coordinates = ["p4", "q4"]\n').code == "V156"


def with_starts(text, digits, off=0.0):
    row = solved(CHAIN).table.iloc[0]
    for name in ("phi2", "phi3"):
        text = text.replace(f"{name} = {{ rate", f'{name} = {{ start = "{float(row[name]) + off:.{digits}f} rad", rate')
    return text


@pytest.mark.parametrize(("key", "order"), [("from", '["B", "D"]'), ("coordinates", '["phi2", "phi3"]')])
def test_start_values_tell_the_order(key, order):
    first, second = re.findall(r'"(\w+)"', order)
    turned = CHAIN.replace(f"{key} = {order}", f'{key} = ["{second}", "{first}"]')
    fault = refused(with_starts(turned, 12))
    assert fault.code == "V334"
    assert f"with {key} = {order} they do" in str(fault.message)
    assert len(solved(with_starts(CHAIN, 12)).table)


@pytest.mark.parametrize(
    ("is_turned", "off", "code"),
    [(False, 0.9e-6, None), (False, -0.9e-6, None), (False, 1.5e-6, "V332"), (True, 0.019, "V334"), (True, -0.03, "V332")],
)
def test_starts_are_rounded_to_both_sides_of_their_limits(is_turned, off, code):
    text = with_starts(CHAIN.replace('["phi2", "phi3"]', '["phi3", "phi2"]') if is_turned else CHAIN, 12, off)
    if code is None:
        assert len(solved(text).table)
    else:
        with pytest.raises(coursework.InputError, match=code):
            solved(text).table  # noqa: B018


def test_a_start_that_closes_in_no_order_is_told_as_before():
    text = with_starts(CHAIN, 12).replace('d = "0.5 m"', 'd = "0.6 m"')
    with pytest.raises(coursework.InputError, match="V332"):
        solved(text).table  # noqa: B018


def test_rpr_asks_for_its_mode_as_the_others_do():
    for kind in ("RRR", "RPR"):
        head, tail = CHAIN.split(f'kind = "{kind}"')
        fault = refused(f'{head}kind = "{kind}"{tail.replace(chr(10) + "mode = " + chr(34) + "+1" + chr(34), "", 1)}')
        assert fault.code == "V307"
        assert 'Write mode = "+1" (' in str(fault.message)


def test_rpr_takes_the_mode_nearest_to_its_start_values():
    run = solved(CHAIN)
    row = run.table.iloc[0]
    text = CHAIN.replace('["q4", "p4"]\nmode = "+1"', '["q4", "p4"]')
    for name, unit in (("q4", "rad"), ("p4", "m")):
        text = text.replace(f"{name} = {{ rate", f'{name} = {{ start = "{float(row[name])!r} {unit}", rate')
    assert solved(text).table.equals(run.table)
