"""Reads a JSON file of pylinkage: of its mechanisms (joints and links), or of its older linkages (joints with parents).

Enters: bytes.  Leaves: `Scheme`.  Raises `InputError`.  Used by `read.py`.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from coursework.takeaway.foreign.scheme import MOST_JOINTS, Links, Reading, Scheme, Slider, Turned, link_of
from coursework.words.sentences import say

PROGRAM = "pylinkage"
OLDER = {"Static", "Crank", "Revolute", "Fixed", "Prismatic", "Linear"}


def read(content: bytes) -> Scheme:
    """Return the mechanism in a file."""
    try:
        told = json.loads(content)
    except (ValueError, RecursionError):
        raise Reading(PROGRAM).refused("JSON") from None
    found = _Joints(told)
    joints = found.listed("joints")
    if not joints or len(joints) > MOST_JOINTS:
        raise found.refused("joints")
    is_older = any(str(joint.get("type")) in OLDER for joint in joints)
    return _Older(told).made(joints) if is_older else _Mechanism(told).made(joints)


class _Joints(Reading):
    """The joints of a file with the content `told`."""

    def __init__(self, told: Any) -> None:
        super().__init__(PROGRAM)
        self.told = told
        self.remarks.append(say("foreign.unit"))

    def listed(self, key: str) -> list[dict[str, Any]]:
        """Return the list of records under a key, [] if there is none."""
        found = self.told.get(key, []) if isinstance(self.told, dict) else []
        if not isinstance(found, list) or not all(isinstance(one, dict) for one in found):
            raise self.refused(key)
        return found

    def place(self, x: object, y: object, name: str) -> None:
        """Put a joint at a place."""
        self.places[name] = complex(self.number(x, name), self.number(y, name))

    def finished(self, links: Links, pivot: str, crank: int, speed: float, turned: Sequence[Turned]) -> Scheme:
        """Return the mechanism with what all files of pylinkage share: they may have a title, and give no step."""
        self.remarks.append(say("foreign.step"))
        return self.scheme(links, pivot, crank, speed, turned, str(self.told.get("name") or ""))


class _Mechanism(_Joints):
    """Joints, and links that list their joints."""

    def made(self, joints: list[dict[str, Any]]) -> Scheme:
        """Return the mechanism made of joints and the links of the file."""
        axes, trackers = dict[str, float](), dict[str, list[str]]()
        for joint in joints:
            name, position = str(joint.get("id", "")), joint.get("position")
            kind = str(joint.get("type", "revolute"))
            if kind not in ("ground", "revolute", "prismatic", "tracker"):
                self.leave_out(f"{kind} {name}")
                continue
            if not isinstance(position, list) or len(position) != 2:
                raise self.refused(name)
            self.place(position[0], position[1], name)
            if kind == "ground":
                self.fixed.add(name)
            if kind == "tracker":
                trackers[name] = [str(joint.get(f"ref_joint{end}_id", "")) for end in (1, 2)]
            if kind == "prismatic":
                axis = joint.get("axis", [1.0, 0.0])
                if not isinstance(axis, list) or len(axis) != 2:
                    raise self.refused(name)
                axes[name] = math.atan2(self.number(axis[1], name), self.number(axis[0], name))
        links, drives = list[tuple[str, ...]](), list[tuple[str, int, float]]()
        for link in self.listed("links"):
            kind, named = str(link.get("type", "link")), link.get("joints", [])
            if not isinstance(named, list):
                raise self.refused("links")
            members = tuple(str(name) for name in named if str(name) in self.places)
            if kind == "ground":
                self.sliders |= {name: Slider(self.places[name], axes[name]) for name in members if name in axes}
            elif kind in ("driver", "link"):
                links.append(members)
            else:
                self.leave_out(f"{kind} {link.get('id', '')}")
            if kind == "driver":
                pivot = str(link.get("motor_joint") or next((name for name in members if name in self.fixed), ""))
                drives.append((pivot, len(links) - 1, self.number(link.get("angular_velocity", 0.0), "angular_velocity")))
        for name in [name for name in axes if name not in self.sliders]:
            self.leave_out(f"prismatic {name}")
        for name, ends in trackers.items():  # a further point of the link that has both reference joints
            if (own := link_of(links, *ends)) is None:
                self.leave_out(f"tracker {name}")
            else:
                links[own] = (*links[own], name)
        if not drives or drives[0][0] not in self.fixed:
            raise self.no_crank()
        pivot, crank, speed = drives[0]
        turned = [Turned(at, link, rate / speed) for at, link, rate in drives[1:] if at in self.fixed and speed]
        return self.finished(tuple(links), pivot, crank, speed, turned)


class _Older(_Joints):
    """Joints that name their parent joints."""

    def __init__(self, told: Any) -> None:
        super().__init__(told)
        self.links: list[list[str]] = []
        self.cranks: list[tuple[str, str, float]] = []
        self.lines: dict[str, list[str]] = {}  # the two joints of a moving line on which a joint slides

    def parent(self, joint: dict[str, Any], key: str) -> str:
        told = joint.get(key)
        if not isinstance(told, dict):
            return ""
        if told.get("inline"):
            name = str(told.get("name") or f"{joint.get('name')}-{key}")
            self.place(told.get("x"), told.get("y"), name)
            self.fixed.add(name)
            return name
        return str(told.get("ref", ""))

    def link(self, *names: str) -> None:
        """Join joints to a new link, or add them to the link that already has two of them."""
        for link in self.links:
            if len({*link} & {*names}) > 1:
                link += [name for name in names if name not in link]
                return
        self.links.append(list(names))

    def add(self, joint: dict[str, Any]) -> None:
        name, kind = str(joint.get("name", "")), str(joint.get("type"))
        self.place(joint.get("x"), joint.get("y"), name)
        parents = [self.parent(joint, key) for key in ("joint0", "joint1", "joint2")]
        if any(one and one not in self.places for one in parents):
            raise self.refused(name)
        if kind == "Static":
            self.fixed.add(name)
        elif kind == "Crank" and parents[0]:
            self.link(parents[0], name)
            if parents[0] in self.fixed:
                self.cranks.append((parents[0], name, self.number(joint.get("angle", 0.0), name)))
            else:
                self.leave_out(f"Crank {name}")
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
            self.leave_out(f"{kind} {name}")

    def _holds(self, ends: list[str]) -> bool:
        """Return whether a line belongs to the frame or to a link."""
        return self.fixed.issuperset(ends) or link_of(self.links, *ends) is not None

    def made(self, joints: list[dict[str, Any]]) -> Scheme:
        """Return the mechanism made of joints."""
        for joint in joints:
            self.add(joint)
        if not self.cranks:
            raise self.no_crank()
        links = self.moving(self.links)
        (pivot, _, speed), *others = self.cranks
        crank = self.crank_of(links, pivot)
        turned = [
            Turned(at, own, rate / speed) for at, name, rate in others if speed and (own := link_of(links, at, name)) is not None
        ]
        for name, ends in self.lines.items():
            self.sliders[name] = replace(self.sliders[name], link=link_of(links, *ends))
        return self.finished(links, pivot, crank, speed, turned)
