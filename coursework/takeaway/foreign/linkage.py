"""Reads a file of Linkage (.linkage2): connectors, links, anchors, an input with its speed, sliders.

Enters: bytes.  Leaves: `Scheme`.  Raises `InputError`.  Used by `read.py`.
XML is read by expat, without entities or declarations; lengths are stored in units of 1/96 inch.
"""

from __future__ import annotations

import cmath
import math
from xml.parsers import expat

from coursework.takeaway.foreign.scheme import MOST_JOINTS, Reading, Scheme, Slider, Turned, link_of
from coursework.words.sentences import say

PROGRAM = "Linkage"
UNIT = 0.0254 / 96  # m
DEPTH = 12
_LINK, _CONNECTOR, _LIMIT = "link", "connector", "slidelimit"


def read(content: bytes) -> Scheme:
    """Return the mechanism in a file."""
    elements = _Elements()
    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = elements.begin, elements.end
    parser.StartDoctypeDeclHandler = elements.declared
    try:
        parser.Parse(content, True)
    except expat.ExpatError as error:
        raise elements.refused(error.lineno) from None
    return elements.made()


class _Elements(Reading):
    """Collects connectors and links."""

    def __init__(self) -> None:
        super().__init__(PROGRAM)
        self.above: list[str] = []
        self.inputs: list[tuple[str, float]] = []
        self.limits: dict[str, list[str]] = {}
        self.links: list[list[str]] = []
        self.scale = 1.0
        self.last = ""

    def declared(self, *_: object) -> None:
        raise self.refused("<!DOCTYPE")

    def begin(self, tag: str, told: dict[str, str]) -> None:
        kind, above = tag.lower(), self.above[-1] if self.above else ""
        self.above.append(kind)
        if len(self.above) > DEPTH or len(self.places) > MOST_JOINTS or len(self.links) > MOST_JOINTS:
            raise self.refused(tag)
        if kind == "program":
            self.scale = self.number(told.get("scalefactor", "1"), "scalefactor")
        elif kind == _CONNECTOR and above == _LINK:
            self.links[-1].append(told.get("id", ""))
        elif kind == _CONNECTOR:
            self._connector(told)
        elif kind == _LIMIT and above == _CONNECTOR:
            self.limits.setdefault(self.last, []).append(told.get("id", ""))
        elif kind == _LINK:
            self.links.append([])
            for name in ("actuator", "gear"):
                if told.get(name) == "true":
                    self.leave_out(f"{name} (link {told.get('id', '')})")
        elif above not in ("", "selected", "background") and kind not in ("linkage2", "selected", "background"):
            self.leave_out(f"<{tag}>")

    def end(self, _tag: str) -> None:
        self.above.pop()

    def _connector(self, told: dict[str, str]) -> None:
        self.last = name = told.get("id", "")
        self.places[name] = complex(*(self.number(told.get(axis), f"connector {name}") for axis in "xy")) * UNIT
        if told.get("anchor") == "true":
            self.fixed.add(name)
        if told.get("input") == "true":
            self.inputs.append((name, self.number(told.get("rpm", "nan"), f"connector {name}")))
        if told.get("slider") == "true":
            self.limits.setdefault(name, [])

    def made(self) -> Scheme:
        fixed = self.fixed
        if any(name not in self.places for link in self.links for name in link):
            raise self.refused("Link")
        if not self.inputs:
            raise self.no_crank()
        if self.scale != 1.0:
            self.leave_out(f"scalefactor {self.scale:g}")
        links = self.moving(map(dict.fromkeys, self.links))
        for name, limits in self.limits.items():
            slot = None if fixed.issuperset(limits) else link_of(links, *limits)
            if len(limits) == 2 and all(one in self.places for one in limits) and (slot is not None or fixed.issuperset(limits)):
                ends = [self.places[one] for one in limits]
                self.sliders[name] = Slider(ends[0], cmath.phase(ends[1] - ends[0]), slot)
            else:
                self.leave_out(f"slider (connector {name})")
        pivot, rpm = self.inputs[0]
        turned = []
        for name, further in self.inputs[1:]:
            driven = next((place for place, link in enumerate(links) if name in link and name in fixed), None)
            if driven is None or not rpm:
                self.leave_out(f"input (connector {name})")
            else:
                turned.append(Turned(name, driven, further / rpm))
        self.remarks.append(say("foreign.sense"))
        return self.scheme(links, pivot, self.crank_of(links, pivot), rpm * math.tau / 60, turned)
