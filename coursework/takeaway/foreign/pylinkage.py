"""A JSON file of pylinkage: that of its mechanisms (joints and links), or that of its older linkages (joints with parents).

Enters: bytes.  Leaves: `Scheme`.  Raises `InputError`.  Used by `read.py`.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any

from coursework.takeaway.foreign.scheme import (
    MOST_JOINTS,
    Scheme,
    Slider,
    Turned,
    driven_link,
    left_out,
    link_of,
    no_crank,
    number,
    refused,
)
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

PROGRAM = "pylinkage"
OLDER = {"Static", "Crank", "Revolute", "Fixed", "Prismatic", "Linear"}


def read(content: bytes) -> Scheme:
    """Return the mechanism."""
    try:
        told = json.loads(content)
    except (ValueError, RecursionError):
        raise refused(PROGRAM, "JSON") from None
    joints = _listed(told, "joints")
    if not joints or len(joints) > MOST_JOINTS:
        raise refused(PROGRAM, "joints")
    is_older = any(joint.get("type") in OLDER for joint in joints)
    return _older(told, joints) if is_older else _mechanism(told, joints)


def _listed(told: Any, key: str) -> list[dict[str, Any]]:
    found = told.get(key, []) if isinstance(told, dict) else []
    if not isinstance(found, list) or not all(isinstance(one, dict) for one in found):
        raise refused(PROGRAM, key)
    return found


def _place(x: object, y: object, name: str) -> complex:
    return complex(number(x, PROGRAM, name), number(y, PROGRAM, name))


def _mechanism(told: dict[str, Any], joints: list[dict[str, Any]]) -> Scheme:
    places, fixed, sliders, remarks = dict[str, complex](), set[str](), dict[str, Slider](), [say("foreign.unit")]
    axes, trackers = dict[str, float](), dict[str, list[str]]()
    for joint in joints:
        name, position = str(joint.get("id", "")), joint.get("position")
        kind = str(joint.get("type", "revolute"))
        if kind not in ("ground", "revolute", "prismatic", "tracker"):
            remarks.append(left_out(f"{kind} {name}"))
            continue
        if not isinstance(position, list) or len(position) != 2:
            raise refused(PROGRAM, name)
        places[name] = _place(position[0], position[1], name)
        if kind == "ground":
            fixed.add(name)
        if kind == "tracker":
            trackers[name] = [str(joint.get(f"ref_joint{end}_id", "")) for end in (1, 2)]
        if kind == "prismatic":
            axis = joint.get("axis", [1.0, 0.0])
            if not isinstance(axis, list) or len(axis) != 2:
                raise refused(PROGRAM, name)
            axes[name] = math.atan2(number(axis[1], PROGRAM, name), number(axis[0], PROGRAM, name))
    links, drives = list[tuple[str, ...]](), list[tuple[str, int, float]]()
    for link in _listed(told, "links"):
        kind, named = str(link.get("type", "link")), link.get("joints", [])
        if not isinstance(named, list):
            raise refused(PROGRAM, "links")
        members = tuple(str(name) for name in named if str(name) in places)
        if kind == "ground":
            sliders |= {name: Slider(places[name], axes[name]) for name in members if name in axes}
        elif kind in ("driver", "link"):
            links.append(members)
        else:
            remarks.append(left_out(f"{kind} {link.get('id', '')}"))
        if kind == "driver":
            pivot = str(link.get("motor_joint") or next((name for name in members if name in fixed), ""))
            drives.append((pivot, len(links) - 1, number(link.get("angular_velocity", 0.0), PROGRAM, "angular_velocity")))
    remarks += [left_out(f"prismatic {name}") for name in axes if name not in sliders]
    for name, ends in trackers.items():  # a further point of the link that has both
        if (own := link_of(links, *ends)) is None:
            remarks.append(left_out(f"tracker {name}"))
        else:
            links[own] = (*links[own], name)
    if not drives or drives[0][0] not in fixed:
        raise no_crank(PROGRAM)
    pivot, crank, speed = drives[0]
    turned = [Turned(at, link, rate / speed) for at, link, rate in drives[1:] if at in fixed and speed]
    title = str(told.get("name") or "")
    remarks.append(say("foreign.step"))
    return Scheme(
        PROGRAM, title, places, frozenset(fixed), tuple(links), sliders, pivot, crank, speed, tuple(remarks), tuple(turned)
    )


class _Older:
    """Joints that name their parents."""

    def __init__(self) -> None:
        self.places: dict[str, complex] = {}
        self.fixed: set[str] = set()
        self.links: list[list[str]] = []
        self.sliders: dict[str, Slider] = {}
        self.remarks: list[Sentence] = [say("foreign.unit")]
        self.cranks: list[tuple[str, str, float]] = []
        self.lines: dict[str, list[str]] = {}  # the two joints of a moving line on which a joint slides

    def parent(self, joint: dict[str, Any], key: str) -> str:
        told = joint.get(key)
        if not isinstance(told, dict):
            return ""
        if told.get("inline"):
            name = str(told.get("name") or f"{joint.get('name')}-{key}")
            self.places[name] = _place(told.get("x"), told.get("y"), name)
            self.fixed.add(name)
            return name
        return str(told.get("ref", ""))

    def link(self, *names: str) -> None:
        """Join joints to a link, or to the one that has two of them already."""
        for link in self.links:
            if len({*link} & {*names}) > 1:
                link += [name for name in names if name not in link]
                return
        self.links.append(list(names))

    def add(self, joint: dict[str, Any]) -> None:
        name, kind = str(joint.get("name", "")), str(joint.get("type"))
        self.places[name] = _place(joint.get("x"), joint.get("y"), name)
        parents = [self.parent(joint, key) for key in ("joint0", "joint1", "joint2")]
        if any(one and one not in self.places for one in parents):
            raise refused(PROGRAM, name)
        if kind == "Static":
            self.fixed.add(name)
        elif kind == "Crank" and parents[0]:
            self.link(parents[0], name)
            if parents[0] in self.fixed:
                self.cranks.append((parents[0], name, number(joint.get("angle", 0.0), PROGRAM, name)))
            else:
                self.remarks.append(left_out(f"Crank {name}"))
        elif kind == "Revolute" and all(parents[:2]):
            self.link(parents[0], name)
            self.link(parents[1], name)
        elif kind == "Fixed" and all(parents[:2]):
            self.link(*parents[:2], name)
        elif kind in ("Prismatic", "Linear") and all(parents) and self._holds(parents[1:]):
            self.link(parents[0], name)
            if not self.fixed.issuperset(parents[1:]):
                self.lines[name] = parents[1:]
            ends = [self.places[one] for one in parents[1:]]
            way = ends[1] - ends[0]
            self.sliders[name] = Slider(ends[0], math.atan2(way.imag, way.real))
        else:
            self.remarks.append(left_out(f"{kind} {name}"))

    def _holds(self, ends: list[str]) -> bool:
        """Return whether a line is one of the frame, or of a link."""
        return self.fixed.issuperset(ends) or link_of(self.links, *ends) is not None


def _older(told: dict[str, Any], joints: list[dict[str, Any]]) -> Scheme:
    found = _Older()
    for joint in joints:
        found.add(joint)
    if not found.cranks:
        raise no_crank(PROGRAM)
    links = tuple(tuple(link) for link in found.links if not found.fixed.issuperset(link))
    (pivot, pin, speed), *others = found.cranks
    crank = driven_link(PROGRAM, links, pivot, frozenset(found.fixed - {pin}))
    turned = [
        Turned(at, own, rate / speed) for at, name, rate in others if speed and (own := link_of(links, at, name)) is not None
    ]
    for name, ends in found.lines.items():
        found.sliders[name] = replace(found.sliders[name], link=link_of(links, *ends))
    title = str(told.get("name") or "")
    remarks = (*found.remarks, say("foreign.step"))
    fixed = frozenset(found.fixed)
    return Scheme(PROGRAM, title, found.places, fixed, links, found.sliders, pivot, crank, speed, remarks, tuple(turned))
