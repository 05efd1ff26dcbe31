"""An equation is judged only if the geometry knows every velocity in it; [unknowns] says which velocity an unknown is.

The mechanisms are none of the catalogue; each sign of each written equation is turned, and none of them passes.
"""

import re
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.equations.reduction.bound import STILL, Geometry
from coursework.equations.reduction.structure import structures
from coursework.words.data_folders import folder
from tests.mechanisms.library import mechanism

TEMPLATE = (folder("reports") / "new-variant.toml").read_text(encoding="utf-8").replace("NAME", "mine")
BOUND = 'u = { unit = "m/s", of = "B", along = "0 deg" }'
# A slider-crank; a shaper, whose u is its block along the lever; the same as a chain with three velocities by hand beside it;
# two gears and a sleeve on the second; gears in two stages, the last with a crank that a position equation leaves open; a planet.
OWN = (
    "slider-crank-with-slide-velocity", "shaper-equations", "shaper-with-more-velocities", "gears", "gears-and-crank",
    "planet-between-sun-and-ring",
)  # fmt: skip
FILES = {"template": TEMPLATE, **{name: mechanism(name) for name in OWN}}
WRITTEN = re.compile(r'name *= "([^"]+)"\n(?:because *= "[^"]*"\n)?equation *= "([^"]+)"')


def closure_of(text):
    structures.cache_clear()
    return coursework.solve(coursework.parse_variant(text, "v.toml"), quantities=["table"]).scene.closure


def agreement_of(text, scheme=None):
    run = coursework.solve(coursework.parse_variant(text, "v.toml"), scheme=scheme, quantities=["table", "checks"])
    return run, next(check for check in run.checks if check.code == "AGREEMENT")


def turned(text):
    """Yield (name, file) with one sign of one equation turned."""
    for found in WRITTEN.finditer(text):
        body, begin = found[2], found.start(2)
        for place in [place for place, letter in enumerate(body) if letter in "+-"]:
            other = f"{body[:place]}{'-' if body[place] == '+' else '+'}{body[place + 1 :]}"
            yield found[1], f"{text[:begin]}{other}{text[begin + len(body) :]}"
        if body[0].isalpha():
            yield found[1], f"{text[:begin]}-{text[begin:]}"
        left, right = body.split(" = ")
        if right != "0":
            yield found[1], f"{text[:begin]}-({left}) = {right}{text[begin + len(body) :]}"


CASES = [(file, place) for file, text in FILES.items() for place, _ in enumerate(turned(text))]


@pytest.mark.parametrize("file", FILES)
def test_every_equation_of_a_right_file_is_judged(file):
    closure = closure_of(FILES[file])
    assert closure.agreed == tuple(found[1] for found in WRITTEN.finditer(FILES[file]))
    assert closure.unjudged == ()


@pytest.mark.long
@pytest.mark.parametrize(("file", "place"), CASES)
def test_no_turned_sign_passes(file, place):
    name, text = [*turned(FILES[file])][place]
    with pytest.raises(coursework.InputError, match=rf"V302 v\.toml:\d+  equation {name} contradicts the geometry"):
        closure_of(text)


def test_the_sign_of_the_template_that_passed():
    wrong = TEMPLATE.replace("VMx - r3*w3*sin(phi3) = u", "VMx + r3*w3*sin(phi3) = u")
    with pytest.raises(coursework.InputError, match="equation 4 contradicts") as caught:
        closure_of(wrong)
    assert len(caught.value.faults) == 1


def test_two_wrong_equations_are_both_named():
    wrong = TEMPLATE.replace("VMx - r3*w3*sin(phi3) = u", "VMx + r3*w3*sin(phi3) = u").replace("VMy + r3*w3", "VMy - r3*w3")
    with pytest.raises(coursework.InputError) as caught:
        closure_of(wrong)
    assert [str(fault.message)[:10] for fault in caught.value.faults] == ["equation 3", "equation 4"]


def test_what_the_file_says_of_an_unknown_is_not_asked_for_again():
    """Without its driven point the geometry holds no coordinate, so that u of B is not known either."""
    _, found = agreement_of(TEMPLATE.replace('driven = "M"', ""))
    assert "nothing in the geometry gives w1, w2, w3 and u." in found.sentence
    assert found.sentence.endswith("Say in [points] and [closure] how phi3 is held; then the geometry gives w3.")


@pytest.mark.parametrize("entry", ['u = "m/s"', 'u = { unit = "m/s" }'])
@pytest.mark.parametrize("sign", "+-")
def test_what_stays_unbound_is_said_first_and_never_praised(entry, sign):
    text = TEMPLATE.replace(BOUND, entry).replace("VMx - r3*w3", f"VMx {sign} r3*w3")
    run, found = agreement_of(text)
    assert (found.verdict, found.value) == ("SKIP", None)
    assert found.sentence.startswith("3 of 4 equations agree; 4 is not judged: nothing in the geometry gives u.")
    assert 'u = { unit = "m/s", of = "B", along = "0 deg" }, if u is the velocity of B along its guide' in found.sentence
    first = "The table is computed right; equation 4 is not judged: nothing in the geometry gives u; the start is not judged."
    assert run.summary.startswith(first)


def test_a_proposal_taken_over_binds():
    _, found = agreement_of(TEMPLATE.replace(BOUND, 'u = "m/s"'))
    line = re.search(r"u = \{[^}]*\}", found.sentence)[0]
    assert closure_of(TEMPLATE.replace(BOUND, line)).unjudged == ()


def test_a_direction_the_other_way_is_told_as_such():
    with pytest.raises(coursework.InputError, match=r"Or is u \(line \d+\) meant the other way round\?"):
        closure_of(TEMPLATE.replace('along = "0 deg"', 'along = "180 deg"'))
    other = TEMPLATE.replace('along = "0 deg"', 'along = "180 deg"').replace("r3*w3*sin(phi3) = u", "r3*w3*sin(phi3) = -u")
    assert closure_of(other).unjudged == ()


def test_the_rate_of_a_link_has_no_direction_to_turn():
    wrong = FILES["gears-and-crank"].replace("z3*w2 = -z4*w4", "z3*w2 = z4*w4")
    with pytest.raises(coursework.InputError, match=r"equation second contradicts .* w2 is taken as line 19 says\.$"):
        closure_of(wrong)


def test_what_the_geometry_says_stands_for_an_equation_where_none_is_written():
    bare = re.sub(r"\[\[constraint\]\][^\[]*\n\n", "", TEMPLATE[: TEMPLATE.index("# --- geometry")])
    bare = re.sub(r"\[\[constraint\]\](?:.*\n)*", "", bare) + TEMPLATE[TEMPLATE.index("[points]") :]
    assert "equation" not in bare.split("[points]")[0].split("[time]")[1]
    derived, written = (agreement_of(text, "rk4")[0].table["u"].to_numpy() for text in (bare, TEMPLATE))
    np.testing.assert_allclose(derived, written, atol=1e-6 * np.ptp(written))


def test_a_planet_has_an_equation_for_each_of_its_contacts():
    """Without written equations both contacts move it; by Willis the carrier has the mean of both rates, weighted by teeth."""
    text = FILES["planet-between-sun-and-ring"]
    bare = coursework.parse_variant(text[: text.index("[[constraint]]")] + text[text.index("[points]") :], "v.toml")
    table = coursework.solve(bare, "rk4", quantities=["table"]).table
    np.testing.assert_allclose(table["wh"], (20 * 8 * np.pi + 52 * 15 * np.cos(10 * table.index)) / 72, rtol=1e-12)
    wrong = text.replace("z3*(w3 - wh) = z2", "z3*(w3 - wh) = -z2")
    with pytest.raises(coursework.InputError, match=r"equation ring contradicts the geometry"):
        closure_of(wrong)


def test_a_wheel_on_a_rail_has_its_rate_from_the_geometry():
    """Both equations of 31 that hold w4 turned: no contradiction among themselves, and yet wrong."""
    wrong = coursework.load("31").path.read_text(encoding="utf-8")
    wrong = wrong.replace("+ 0.5*r3*w4 = 0", "- 0.5*r3*w4 = 0").replace('"-0.5*r3*w4 + ', '"0.5*r3*w4 + ')
    with pytest.raises(coursework.InputError) as caught:
        closure_of(wrong)
    assert [str(fault.message)[:11] for fault in caught.value.faults] == ["equation 12", "equation 16"]


def test_the_relative_velocity_of_a_block_is_the_rate_of_its_distance():
    run = coursework.solve(coursework.parse_variant(FILES["shaper-equations"], "v.toml"), scheme="exact", quantities=["table"])
    phi1 = run.table["phi1"].to_numpy()
    w1 = 4 * np.pi
    distance = np.hypot(0.1 * np.cos(phi1), 0.25 + 0.1 * np.sin(phi1))
    np.testing.assert_allclose(run.table["u"], 0.25 * 0.1 * np.cos(phi1) * w1 / distance, atol=1e-9)


# A scotch yoke: the one coordinate is driven, so no position equation is needed.
ALL_DRIVEN = mechanism("scotch-yoke")


def test_where_the_drives_place_every_coordinate_the_geometry_judges_and_the_exact_motion_is_known(tmp_path):
    file = tmp_path / "yoke.toml"
    file.write_text(ALL_DRIVEN, encoding="utf-8")
    run = coursework.solve(file, scheme="exact")
    verdicts = {check.code: check.verdict for check in run.checks}
    assert (verdicts["AGREEMENT"], verdicts["DRIFT"]) == ("PASS", "SKIP")
    t = run.table.index.to_numpy()
    np.testing.assert_allclose(run.table["v"], 0.4 * np.pi * np.cos(np.pi / 6 + 4 * np.pi * t), atol=1e-12)
    for slip in ("v = -r*w*cos(f)", "v = r*w*sin(f)"):
        file.write_text(ALL_DRIVEN.replace("v = r*w*cos(f)", slip), encoding="utf-8")
        with pytest.raises(coursework.InputError, match=r"V302.*equation a "):
            _ = coursework.solve(file).table


@pytest.mark.parametrize(("contacts", "rails", "circles", "touches"), [
    (("K",), (), 1, True), (("K",), (), 0, False), (("K", "L"), (), 1, False), (("K", "L"), (), 2, True), (("K", "L"),
    ("L",), 1, True),
    (("K", "L"), ("K",), 0, True), (("L",), (), 1, True), (("L",), ("L",), 1, False), (("K", None, None), (), 1, True),
])  # fmt: skip
def test_a_contact_stands_still_on_a_rail_or_where_each_has_a_circle_of_the_frame(contacts, rails, circles, touches):
    frame = SimpleNamespace(
        hinges=(), rails=[(SimpleNamespace(name=name), None) for name in rails], circles=("circle",) * circles
    )
    links = [SimpleNamespace(wheel="P", contact=contact) for contact in contacts]
    geometry = SimpleNamespace(_bodies={}, variant=SimpleNamespace(frame=frame, links=links))
    found = Geometry._touched(geometry, SimpleNamespace(wheel="P", contact="K"), None)
    assert found == ((STILL, STILL) if touches else None)
