"""What a file is told to write so that the geometry knows a velocity: from how the velocity is called and what slides where."""

import math
from types import SimpleNamespace

import pytest

import coursework
from coursework.mechanism.proposal import loose_arms, proposed
from coursework.variant.formula.reader import parse
from coursework.variant.reading.reader import parse_variant
from tests.mechanisms.library import mechanism


def variant(unknowns, **said):
    """A file with links 1 to 3, of which 3 leads from B to E at phi3 and 5 slides on it by its point P."""
    link = lambda name, points, **more: SimpleNamespace(  # noqa: E731
        name=name, points=points, rate=more.get("rate"), slides=more.get("slides"), contact=more.get("contact")
    )
    links = [link("1", ("A", "B"), rate="w1"), link("2", ("B", "C"), rate="w2"), link("3", ("B", "E"), rate="w3")]
    places = [("A", "(0, 0)"), ("B", "A + r @ phi1"), ("E", "B - a @ phi3"), ("C", "B + b @ phi2"), ("P", "B + s @ phi3")]
    coordinates = [SimpleNamespace(name=f"phi{k}", rate=f"w{k}", unit="rad") for k in (1, 2, 3)]
    known = {
        "unknowns": unknowns, "coordinates": coordinates, "bindings": (), "holds": (), "groups": (), "links": links,
        "points": [(name, parse(place, vectors=True)) for name, place in places], "frame": SimpleNamespace(rails=()),
    }  # fmt: skip
    more = {"links": [*links, link("5", ("P",), slides="3")]} if said.pop("slides", False) else {}
    return SimpleNamespace(**known | more | said)


def rail(point, angle):
    return SimpleNamespace(rails=[(parse(point), parse(angle))])


BOUND = SimpleNamespace(point="C", name="v")


@pytest.mark.parametrize(("unknowns", "name", "said", "told"), [
    ((), "w2", {}, "Say in [points] and [closure] how phi2 is held; then the geometry gives w2."),
    ([("w2", "1/s")], "w2", {}, 'w2 = { unit = "1/s", of = "link 2" }, if w2 is the rate of link 2.'),
    ([("w21", "1/s")], "w21", {}, 'w21 = { unit = "1/s", of = "link 2", relative = "1" }, if w21 is the rate of link 2 against'),
    ([("w41", "1/s")], "w41", {}, 'such as w41 = { unit = "1/s", of = "link 41" }; in [links] that link has two'),
    ([("w7", "1/s")], "w7", {}, 'such as w7 = { unit = "1/s", of = "link 7" }; in [links] that link has two'),
    ([("om", "1/s")], "om", {}, 'such as om = { unit = "1/s", of = "link 4" }; in [links] that link has two'),
    ([("u", "m/s")], "u", {}, 'such as u = { unit = "m/s", of = "P", along = "0 deg" }.'),
    ([("u", "m/s")], "u", {"frame": rail("C", "pi/2")}, 'of = "C", along = "90 deg" }, if u is the velocity of C along'),
    ([("u", "m/s")], "u", {"frame": rail("C", "beta")}, 'of = "C", along = "beta" }, if u is the velocity of C along its guide.'),
    ([("u", "m/s")], "u", {"holds": [parse("C.y", vectors=True)]}, 'of = "C", along = "0 deg" }, if u is the velocity of C'),
    ([("u", "m/s")], "u", {"holds": [parse("C.x", vectors=True)]}, 'of = "C", along = "90 deg" }, if u is the velocity of C'),
    ([("u", "m/s")], "u", {"slides": True},
     'of = "P", along = "phi3", relative = "3" }, if u is the velocity of P along link 3.'),
    ([("u", "m/s")], "u", {"slides": True, "frame": rail("C", "0")}, 'of = "C", along = "0 deg" }, if u is'),
    ([("vP", "m/s")], "vP", {"slides": True, "frame": rail("C", "0")}, 'of = "P", along = "phi3", relative = "3" }, if vP is'),
    ([("u", "m/s")], "u", {"slides": True, "frame": rail("C", "0"), "bindings": [BOUND]}, 'of = "P", along = "phi3"'),
    ([("u", "m/s")], "u", {"frame": rail("C", "0"), "bindings": [BOUND]}, 'such as u = { unit = "m/s", of = "P", along = '),
    ([("vC", "m/s")], "vC", {"frame": rail("C", "0"), "bindings": [BOUND]}, 'of = "C", along = "0 deg" }, if vC is'),
])  # fmt: skip
def test_what_is_proposed(unknowns, name, said, told):
    assert told in str(proposed(variant(unknowns, **said), name))


@pytest.mark.parametrize(("other", "link"), [("(x + a, 0)", "1"), ("E + a @ th", "5")])
def test_a_rack_is_not_proposed_as_what_turns(other, link):
    said = f'E = "(x, 0)"\nF = "{other}"\n[links]\n5 = {{ points = ["E", "F"] }}\n[[group]]'
    text = mechanism("driven-slider", ("[time]", '[unknowns]\nom = "1/s"\n[time]'), ("[[group]]", said))
    assert f'of = "link {link}"' in str(proposed(parse_variant(text), "om"))


def test_an_arm_that_nothing_ties_is_told_by_the_one_length_that_it_has():
    """Of the wiper the rockers DB (80 mm) and GE (75 mm) are positions of other links; two data of one length tell nothing."""
    text = mechanism("windshield-wiper")
    read = parse_variant(text, "own")
    start = coursework.solve(read, quantities=["table"]).scene.start
    arms = [(one.link, one.begin, one.end, one.length, one.angle) for one in loose_arms(read, start)]
    assert arms == [("3", "D", "B", "r3", "phi3"), ("5", "G", "E", "r5", "phi5")]
    for more, links in (('k = "80 mm"', ["5"]), ('k = "90 mm"', ["3", "5"]), ('k = "0.08 m/s"', ["3", "5"])):
        found = loose_arms(parse_variant(text.replace("[given]", f"[given]\n{more}"), "own"), start)
        assert [one.link for one in found] == links, more


@pytest.mark.parametrize("size", [0.08, 5.0])
@pytest.mark.parametrize("share", [0.0098, 0.0102])
@pytest.mark.parametrize("what", ["angle", "datum", "tied"])
def test_a_start_gives_an_arm_within_a_hundredth_of_its_length_at_any_size(size, share, what):
    """A at rest, E on a ray at 2*asin(share/2) from that of phi, where a tenth more of x lengthens AE by a share of it."""
    off, more = (2 * math.asin(share / 2) if what == "angle" else 0.0), (0.1 if what != "tied" else share) * 10 * size
    one = SimpleNamespace(
        coordinates=[SimpleNamespace(name="x", rate="u", unit="m"), SimpleNamespace(name="phi", rate="w", unit="rad")],
        values={"l": size, "k": more, "off": 1.0 + off}, links=[SimpleNamespace(name="2", points=("A", "E"), rate="w")],
        points=[(name, parse(place, vectors=True)) for name, place in (("A", "(0, 0)"), ("E", "A + (l + k*x) @ off"))],
        given=[SimpleNamespace(name="l", si="m", value=size * (1 + share) if what == "datum" else size)],
    )  # fmt: skip
    told = loose_arms(one, [0.0, 1.0])
    assert [arm.angle for arm in told] == (["phi"] if (share < 0.01) is (what != "tied") else [])
