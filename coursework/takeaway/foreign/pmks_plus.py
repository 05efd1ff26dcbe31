"""What PMKS+ shares: settings, joints, links and forces in one line, in its address or its file (.pmks).

Enters: bytes.  Leaves: `Scheme`.  Raises `InputError`.  Used by `read.py`.
Parts stand behind each other with points between, an empty one ends joints, links and forces; numbers are thousandths, to the
base of 64, negative behind a "0"; the first letter of a joint packs what it is.
"""

from __future__ import annotations

import math
from itertools import takewhile

from coursework.takeaway.foreign.scheme import MOST_JOINTS, Scheme, Slider, driven_link, left_out, no_crank, refused
from coursework.words.sentence import Sentence

PROGRAM = "PMKS+"
LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-"
LONGEST = 8  # letters of a number
PRISMATIC, INPUT, GROUNDED, WELDED = 1, 2, 4, 8  # of a joint
CLOCKWISE = 1  # of the settings
UNITS = (0.0254, 0.01, 1.0)  # m: inch, centimetre, metre
SETTINGS = 4


def is_shared(text: str) -> bool:
    """Return whether a text looks like what PMKS+ shares."""
    return text.count(".") > SETTINGS and ".." in text


def read(content: bytes) -> Scheme:
    """Return the mechanism."""
    text = content.decode("utf-8-sig", "replace").strip()
    parts = text.rpartition("?")[2].split(".")
    if not is_shared(text) or len(parts) > 10 * MOST_JOINTS:
        raise refused(PROGRAM, 1)
    flags, _, whole, kinds = parts[:SETTINGS]
    rest = iter(parts[SETTINGS:])
    joints, links, forces = (list(takewhile(bool, rest)) for _ in range(3))
    turns = _integer(whole.partition(",")[0]) * (-1 if _integer(flags[-1:]) & CLOCKWISE else 1)
    unit = LETTERS.find(kinds[:1])
    if not 0 <= unit < len(UNITS) or len(joints) > MOST_JOINTS:
        raise refused(PROGRAM, kinds)
    return _Shared(UNITS[unit], joints, links, forces).scheme(turns * math.tau / 60)


def _integer(text: str) -> int:
    if not 0 < len(text) <= LONGEST or any(letter not in LETTERS for letter in text):
        raise refused(PROGRAM, text[:LONGEST] or "–")
    value = 0
    for letter in text:
        value = value * len(LETTERS) + LETTERS.index(letter)
    return -value if text[0] == "0" else value


class _Shared:
    """Joints and links, one after the other."""

    def __init__(self, unit: float, joints: list[str], links: list[str], forces: list[str]) -> None:
        self.unit = unit
        self.places: dict[str, complex] = {}
        self.fixed: set[str] = set()
        self.slides: dict[str, float] = {}  # prismatic joints on the frame, by their angle
        self.sliders: dict[str, Slider] = {}
        self.links: list[tuple[str, ...]] = []
        self.driven = ""
        self.remarks: list[Sentence] = []
        for joint in joints:
            self._joint(joint)
        for link in links:
            self._link(link)
        self.remarks += [left_out(f"force {force[1:].partition(',')[0]}") for force in forces]

    def _joint(self, told: str) -> None:
        flags, words = _integer(told[:1]), told[1:].split(",")
        if len(words) < 5:
            raise refused(PROGRAM, told[:20])
        name, x, y, angle = words[0], *(_integer(word) / 1000 for word in words[2:5])
        self.places[name] = complex(x, y) * self.unit
        if flags & WELDED:
            self.remarks.append(left_out(f"weld {name}"))
        if flags & PRISMATIC:
            if flags & GROUNDED and not flags & INPUT:
                self.slides[name] = angle
            else:
                self.remarks.append(left_out(f"slide {name}"))
        elif flags & GROUNDED:
            self.fixed.add(name)
            if flags & INPUT:
                self.driven = self.driven or name

    def _link(self, told: str) -> None:
        words = told.split(",")
        joints = tuple(takewhile(bool, words[7:]))
        if len(words) < 8 or any(name not in self.places for name in joints):
            raise refused(PROGRAM, told[:20])
        is_root, kind, name = told[:1] == "Y", told[1:2], words[0][2:]
        if is_root and kind == "P":
            angle = next((self.slides[one] for one in joints if one in self.slides), None)
            pins = [one for one in joints if one not in self.slides]
            if angle is None or len(pins) != 1:
                self.remarks.append(left_out(f"slider {name}"))
            else:
                self.sliders[pins[0]] = Slider(self.places[pins[0]], angle)
        elif is_root:
            self.links.append(joints)

    def scheme(self, speed: float) -> Scheme:
        if not self.driven:
            raise no_crank(PROGRAM)
        places = {name: at for name, at in self.places.items() if name not in self.slides}
        fixed = frozenset(self.fixed)
        links = tuple(link for link in self.links if not fixed.issuperset(link))
        crank = driven_link(PROGRAM, links, self.driven, fixed)
        return Scheme(PROGRAM, "", places, fixed, links, self.sliders, self.driven, crank, speed, tuple(self.remarks))
