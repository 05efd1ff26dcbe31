"""Joints are made once, from links and frame or from the chain of groups; mobility, drawing and centres are read off them."""

import ast
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest

import coursework
from coursework.drawing.outline.tracing import read_outline
from coursework.mechanism import groups
from coursework.mechanism import joints as module
from coursework.mechanism.groups import GROUPS, group_kind, joint
from coursework.mechanism.groups.joint import PRISMATIC, REVOLUTE, Joint, JointKind
from coursework.mechanism.joints import FRAME, chain_of_groups, link_names, linkage
from coursework.mechanism.mechanism import build
from coursework.mechanism.one_shaft import fixed_links
from coursework.variant.catalogue import names
from coursework.variant.formula.tree import named, number
from coursework.variant.record.entries import Link
from tests import sources
from tests.hard.scenes import scene
from tests.sources import PACKAGE


def joints(variant):
    mechanism = build(variant)
    return [(found.kind, found.bodies) for found in mechanism.linkage.joints]


def test_links_and_frame_of_variant_31():
    """Three links in a row, two hinged to the frame, the point M driven: as the task sheet draws it."""
    variant = coursework.load("31")
    mechanism = build(variant)
    assert mechanism.linkage.bodies == tuple(link.name for link in variant.links)
    hinges = [joint.where.name for joint in mechanism.linkage.joints if joint.pins and FRAME in joint.bodies]
    assert set(hinges) == set(variant.frame.hinges)
    assert mechanism.mobility.degrees == 2


CHAINS = {
    "example-1": [(REVOLUTE, ("1", "0")), (REVOLUTE, ("1", "2")), (REVOLUTE, ("0", "3")), (REVOLUTE, ("2", "3"))],
    "example-2": [(REVOLUTE, ("1", "0")), (REVOLUTE, ("1", "2")), (REVOLUTE, ("2", "3")), (PRISMATIC, ("3", "0"))],
    "example-4": [(REVOLUTE, ("1", "0")), (REVOLUTE, ("1", "2")), (PRISMATIC, ("2", "3")), (REVOLUTE, ("3", "0"))],
    "example-5": [(REVOLUTE, ("1", "0")), (REVOLUTE, ("1", "2")), (PRISMATIC, ("2", "3")), (PRISMATIC, ("3", "0"))],
}


@pytest.mark.parametrize("name", CHAINS)
def test_a_chain_of_groups_names_its_joints(name):
    """Each dyad of the textbook, by hand: crank on the frame, then two links and three pairs."""
    found = [(kind, tuple(sorted(bodies))) for kind, bodies in joints(replace(coursework.load(name), links=()))]
    assert found == [(kind, tuple(sorted(bodies))) for kind, bodies in CHAINS[name]]


@pytest.mark.parametrize(
    ("name", "rates", "links"),
    [
        ("example-1", ("wa", "wb", "wc"), {"theta1": "1", "theta2": "2", "theta3": "3"}),
        ("example-1", ("w0", "w01", "w3"), {"theta1": "2", "theta2": "1", "theta3": "3"}),  # 0 is the frame
        ("example-2", ("wa", "wb", "vc"), {"theta1": "1", "theta2": "2", "s3": "3"}),
        ("example-4", ("wa", "wb", "vc"), {"theta1": "1", "s2": "2", "theta3": "3"}),
        ("example-5", ("wa", "vb", "vc"), {"theta1": "1", "s2": "2", "s3": "3"}),
        ("prp", ("wa", "vb", "vc"), {"psi": "1", "si": "2", "sj": "3"}),
    ],
)
def test_links_whose_rates_have_no_number_are_counted_along_the_chain(name, rates, links):
    """Crank, then two a group: of RRR first what hangs on its first point, rod before slider, block before lever."""
    variant = coursework.load(name)
    called = dict(zip(variant.rates, rates, strict=True))
    variant = replace(
        variant,
        links=(),
        coordinates=tuple(replace(c, rate=called[c.rate]) for c in variant.coordinates),
        drive=tuple(replace(law, name=called.get(law.name, law.name)) for law in variant.drive),
    )
    chain = chain_of_groups(variant, dict(variant.points))
    assert {chain.coordinates[body]: name for body, name in link_names(chain, variant).items()} == links


def test_a_dyad_on_a_moving_guide_slides_on_the_link_that_carries_it():
    found = joints(replace(coursework.load("prp"), links=()))
    assert sum(kind.slides for kind, _ in found) == 2
    assert any(kind.slides and FRAME not in bodies for kind, bodies in found)


@pytest.mark.parametrize("name", names())
def test_a_chain_has_the_freedoms_of_its_drives(name):
    variant = replace(coursework.load(name), links=())
    if not variant.groups:
        assert linkage(variant, {}) is None
        return
    mobility = build(variant).mobility
    assert mobility is None or mobility.degrees == len(variant.known_rates)


@pytest.mark.parametrize("kind", [kind for kind in GROUPS if not kind.driven], ids=repr)
def test_every_dyad_adds_two_links_and_three_pairs(kind):
    assert kind.shape.coordinates == 2
    assert len(kind.carries) == 2


# ---- a kind of joint is one record

# A pin in a slot, which the tool has never heard of, and what a dyad RRP is with each as its last joint: freedoms, blocks.
DUMMIES = {
    JointKind("pin in a slot", takes=1, holders=1, slides=True): (2, 1),
    JointKind("glued", takes=2, holders=2): (1, 0),
    JointKind("touching", takes=1, holders=0): (2, 0),
}


@pytest.mark.parametrize(("kind", "expected"), DUMMIES.items(), ids=repr)
def test_a_kind_alone_is_counted_drawn_and_in_the_plans(kind, expected, monkeypatch):
    """By hand: W = 3·3 - 2·4 = 1, one more where the joint takes one freedom less; a point that both hold is a hinge."""
    variant = replace(coursework.load("example-2"), links=())
    crank, dyad = variant.groups

    def ending(*given):
        *first, last = group_kind(dyad.kind).joints(*given)
        return (*first, Joint(kind, last.bodies, last.where, last.along))

    other = replace(group_kind(dyad.kind), name="another", joints=ending)
    monkeypatch.setattr(groups, "GROUPS", (*groups.GROUPS, other))
    changed = replace(variant, groups=(crank, replace(dyad, kind=other.name)))
    mechanism = build(changed)
    outline, before = read_outline(mechanism), read_outline(build(variant))
    assert (mechanism.mobility.degrees, len(outline.blocks)) == expected
    assert len(outline.hinges) - len(before.hinges) == (kind.holders == 2)
    assert sum(bool(rail.rider) for rail in outline.rails) == expected[1]


KINDS = {name: kind for name, kind in vars(joint).items() if isinstance(kind, JointKind)}


def test_no_kind_is_named_where_it_is_not_made():
    """Others ask the record: no text is the name of a kind, and no constant of one stands outside the files that make joints."""
    makers = {
        "mechanism/joints.py",
        *(f"takeaway/foreign/{path.name}" for path in (PACKAGE / "takeaway" / "foreign").glob("*.py")),  # words of other programs
        *(f"mechanism/groups/{path.name}" for path in (PACKAGE / "mechanism" / "groups").glob("*.py")),
    }
    told = {kind.name for kind in KINDS.values()}
    for path in sources.files():
        place, nodes = path.relative_to(PACKAGE).as_posix(), sources.nodes(path)
        if place != "mechanism/groups/joint.py" and not place.startswith("takeaway/foreign/"):
            assert told.isdisjoint(node.value for node in nodes if isinstance(node, ast.Constant)), place
        if place not in makers:
            assert not re.search(rf"\b({'|'.join(KINDS)})\b", sources.text(path)), place
        compared = [side for node in nodes if isinstance(node, ast.Compare) for side in (node.left, *node.comparators)]
        assert not [side for side in compared if isinstance(side, ast.Name) and side.id in KINDS], place


def test_a_guide_drawn_through_the_pivot_it_begins_at_has_the_pin_of_its_group_on_it():
    """`new --groups` writes rails through the first point of a guide; with [links] the crank's pivot would be what slides."""
    variant = coursework.load("example-2")
    begun = replace(variant, frame=replace(variant.frame, rails=((named("A"), variant.frame.rails[0][1]),)))
    assert joints(begun) == joints(variant)
    assert read_outline(build(begun)).blocks == read_outline(build(variant)).blocks
    bare = replace(begun, groups=())  # equations do not tell what slides: the pivot does not
    assert not any(joint.kind.slides for joint in linkage(bare, {}).joints)


def test_a_planet_on_its_carrier_rolls_by_a_higher_pair():
    """By hand: carrier, planet, rod; O, C, E turn, the contact and the pin of the guide take one freedom each: 9 − 6 − 2 = 1."""
    variant = coursework.load("epicyclic")
    mobility = build(variant).mobility
    assert (mobility.degrees, mobility.lower_pairs, mobility.higher_pairs) == (1, 3, 2)
    carrier, *others = variant.links
    free = build(replace(variant, links=(replace(carrier, points=("C",)), *others))).mobility
    assert (free.lower_pairs, free.higher_pairs) == (3, 1)  # what does not hold O keeps no distance from it


def test_each_link_of_a_shaft_is_fixed_to_one_before_it():
    """Three gears of a shaft are fixed by two pairs: the third is fixed to the second by way of the first."""
    gears = [
        Link(name, ("O", f"A{name}"), rate, None, None, None) for name, rate in (("1", "w"), ("2", "w"), ("3", "w"), ("4", "v"))
    ]
    assert [*fixed_links(gears, {}, {})] == [("1", "2", "O"), ("1", "3", "O")]
    away = [*gears[:2], Link("5", ("P", "Q"), "w", None, None, None)]
    assert [*fixed_links(away, {}, {})] == [("1", "2", "O")]


@pytest.mark.parametrize(("folded", "freedoms"), [("pi - a", 2), ("a + pi/3", 1)])
def test_four_links_of_one_rate_are_four_bodies_where_they_turn_both_ways(folded, freedoms):
    """The rhombus of a jack turns two of its links at w, two at -w: 3*4 - 2*5, its foot on the frame.  In one sense: one body."""
    points = f'A = "(0, 0)"\nB = "A + r @ a"\nC = "A + r @ ({folded})"\nE = "B + r @ ({folded})"'
    links = "\n".join(
        f'{place} = {{ points = ["{one}", "{other}"], rate = "w" }}'
        for place, (one, other) in enumerate(("AB", "AC", "BE", "CE"), 1)
    )
    text = scene(
        'a = { start = "0.7 rad", rate = "w" }', given='r = "0.2 m"', drive='w = "1"',
        more=f'[points]\n{points}\n[links]\n{links}\n[frame]\nhinges = ["A"]',
    )  # fmt: skip
    assert build(coursework.parse_variant(text)).mobility.degrees == freedoms


@pytest.mark.parametrize("radius", [0.004, 250.0])
@pytest.mark.parametrize(("part", "found"), [(0.0098, "C"), (-0.0098, "C"), (0.0102, None), (-0.0102, None)])
def test_the_line_of_a_rack_passes_the_contact_within_a_hundredth_of_the_radius(radius, part, found, monkeypatch):
    """A wheel about O touches at Q, above it; the rack runs along x, through C far to the right."""
    places = {"O": 0j, "Q": 1j * radius, "C": radius * (7 + 1j * (1 + part))}
    monkeypatch.setattr(module, "blocks_of", lambda _: {"C": "4"})
    monkeypatch.setattr(module, "riders", lambda _: ("C",))
    monkeypatch.setattr(module, "with_points", lambda *_: places)
    frame = SimpleNamespace(hinges=("O",), rails=[(named("C"), number(0))])
    variant = SimpleNamespace(frame=frame, coordinates=[], values={}, points=())
    assert module.rack_of(SimpleNamespace(wheel="O", contact="Q"), variant) == found
