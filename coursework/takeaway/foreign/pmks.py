"""Reads what PMKS writes: one line per joint, "ground,input,R,0,0", in a file, or after "mech=" in its share address.

Enters: bytes.  Leaves: `Scheme`.  Raises `InputError`.  Used by `read.py`.
A line names the links that meet, the kind of joint, x, y, the angle of a slide (degrees), and four letters t or f, the last of
which marks the driven joint; without these letters the link called "input" is driven.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from urllib.parse import unquote

from coursework.takeaway.foreign.scheme import MOST_JOINTS, Reading, Scheme, Slider, Turned
from coursework.words.sentences import say

PROGRAM = "PMKS"
KINDS = ("R", "P", "RP", "G")
STRAIGHT = 1e-6  # sine: how far from the line of both pivots teeth may meet
GROUND, INPUT = "ground", "input"
_FLAGS = re.compile("[tf]{4}")


def read(content: bytes) -> Scheme:
    """Return the mechanism in a file or address."""
    text = content.decode("utf-8-sig", "replace").strip()
    if "mech=" in text:
        text = unquote(text.partition("mech=")[2].partition("&")[0])
    rows = [row.strip() for row in re.split(r"[|\n]", text) if row.strip()]
    return _Rows(rows).made()


class _Rows(Reading):
    """Collects joints and the links that meet in them."""

    def __init__(self, rows: list[str]) -> None:
        super().__init__(PROGRAM)
        if not rows or len(rows) > MOST_JOINTS:
            raise self.refused(1)
        self.links: dict[str, list[str]] = {}
        self.blocks: dict[str, float] = {}  # links that slide on the frame, and at which angle (rad)
        self.gears: list[tuple[str, str, complex]] = []  # two links and the place where their teeth meet
        self.driven = ""
        self.remarks += [say("foreign.unit"), say("foreign.speed")]
        for place, row in enumerate(rows, start=1):
            self._joint(re.split(r"[,\s]+", row), place)

    def _joint(self, words: list[str], place: int) -> None:
        at = next((k for k, word in enumerate(words) if word in KINDS), 0)
        if not 1 <= at <= 12 or len(words) < at + 3:
            raise self.refused(place)
        links, kind, rest = words[:at], words[at], words[at + 1 :]
        flags = rest.pop() if _FLAGS.fullmatch(rest[-1]) else ""
        name = str(place)
        point = complex(self.number(rest[0], place), self.number(rest[1], place))
        angle = math.radians(self.number(rest[2], place)) if len(rest) > 2 else 0.0
        others = [one for one in links if one != GROUND]
        if kind == "G" and len(others) == 2 == len(links):
            self.gears.append((others[0], others[1], point))
            return
        if kind == "G" or (kind != "R" and (GROUND not in links or len(others) != 1)):
            self.leave_out(", ".join(words))
            return
        if kind == "P":
            self.blocks[others[0]] = angle
            return
        self.places[name] = point
        for one in others:
            self.links.setdefault(one, []).append(name)
        if kind == "RP":
            self.sliders[name] = Slider(point, angle)
        elif GROUND in links:
            self.fixed.add(name)
            if flags.endswith("t") or (INPUT in links and not self.driven):
                self.driven = name

    def made(self) -> Scheme:
        for block, angle in self.blocks.items():
            joints = self.links.pop(block, [])
            for name in joints[:1]:
                self.sliders[name] = Slider(self.places[name], angle)
            for name in joints[1:]:
                self.leave_out(f"{block}, {name}")
        links = self.moving(self.links.values())
        crank = self.crank_of(links, self.driven)
        names = [name for name, joints in self.links.items() if not self.fixed.issuperset(joints)]
        turned = [*self._geared(names, crank)]  # this also adds remarks on other gears
        return self.scheme(links, self.driven, crank, None, turned)

    def _geared(self, names: list[str], crank: int) -> Iterator[Turned]:
        """Yield the links that gears on fixed pivots turn; all other gears become remarks."""
        ratios, waiting = {names[crank]: 1.0}, list(self.gears)
        while found := next((one for one in waiting if (one[0] in ratios) != (one[1] in ratios)), None):
            waiting.remove(found)
            first, second, teeth = found if found[0] in ratios else (found[1], found[0], found[2])
            pivots = [next((joint for joint in self.links.get(link, ()) if joint in self.fixed), "") for link in (first, second)]
            if second in names and all(pivots):
                near, far = (teeth - self.places[pivot] for pivot in pivots)
                if abs(far) > 0 and abs((near * far.conjugate()).imag) <= STRAIGHT * abs(near) * abs(far):
                    ratios[second] = ratios[first] * (near / far).real
                    yield Turned(pivots[1], names.index(second), ratios[second])
                    continue
            self.leave_out(f"{first}, {second}, G")
        for first, second, _ in waiting:
            self.leave_out(f"{first}, {second}, G")
