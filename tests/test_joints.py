"""Joints are made once, from links and frame or from the chain of groups; mobility and centres are read off them."""

from dataclasses import replace

import pytest

import coursework
from coursework.catalogue import names
from coursework.groups import GROUPS
from coursework.joints import FRAME, linkage
from coursework.mechanism import build


def joints(variant):
    mechanism = build(variant)
    return [(joint.kind, joint.bodies) for joint in mechanism.linkage.joints]


def test_links_and_frame_of_variant_31():
    """Three links in a row, two hinged to the frame, the point M driven: as the task sheet draws it."""
    variant = coursework.load("31")
    mechanism = build(variant)
    assert mechanism.linkage.bodies == tuple(link.name for link in variant.links)
    assert set(mechanism.linkage.points("R", FRAME)) == set(variant.frame.hinges)
    assert mechanism.mobility.degrees == 2


CHAINS = {
    "example-1": [("R", ("1", "0")), ("R", ("1", "2")), ("R", ("0", "3")), ("R", ("2", "3"))],
    "example-2": [("R", ("1", "0")), ("R", ("1", "2")), ("R", ("2", "3")), ("P", ("3", "0"))],
    "example-4": [("R", ("1", "0")), ("R", ("1", "3")), ("P", ("3", "2")), ("R", ("2", "0"))],
    "example-5": [("R", ("1", "0")), ("R", ("1", "2")), ("P", ("2", "3")), ("P", ("3", "0"))],
}


@pytest.mark.parametrize("name", CHAINS)
def test_a_chain_of_groups_names_its_joints(name):
    """Each dyad of the textbook, by hand: crank on the frame, then two links and three pairs."""
    found = [(kind, tuple(sorted(bodies))) for kind, bodies in joints(replace(coursework.load(name), links=()))]
    assert found == [(kind, tuple(sorted(bodies))) for kind, bodies in CHAINS[name]]


def test_a_dyad_on_a_moving_guide_slides_on_the_link_that_carries_it():
    found = joints(replace(coursework.load("prp"), links=()))
    assert sum(kind == "P" for kind, _ in found) == 2
    assert any(kind == "P" and FRAME not in bodies for kind, bodies in found)


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
