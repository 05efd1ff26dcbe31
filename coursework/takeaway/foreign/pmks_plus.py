"""Reads what PMKS+ shares: settings, joints, links and forces in one line, in its address or its file (.pmks).

Enters: bytes.  Leaves: `Scheme`.  Raises `InputError`.  Used by `read.py`.
The parts are separated by points; an empty part ends the joints, the links and the forces.  Numbers are thousandths in base 64,
negative if they begin with "0"; the first letter of a joint packs its flags.
"""

from __future__ import annotations

import math
from itertools import takewhile

from coursework.takeaway.foreign.scheme import MOST_JOINTS, Reading, Scheme, Slider

PROGRAM = "PMKS+"
LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-"
LONGEST = 8  # most letters of a number
PRISMATIC, INPUT, GROUNDED, WELDED = 1, 2, 4, 8  # flags of a joint
CLOCKWISE = 1  # flag in the settings
UNITS = (0.0254, 0.01, 1.0)  # m: inch, centimetre, metre
SETTINGS = 4


def is_shared(text: str) -> bool:
    """Return whether a text looks like what PMKS+ shares."""
    return text.count(".") > SETTINGS and ".." in text


def read(content: bytes) -> Scheme:
    """Return the mechanism in a file or address."""
    text = content.decode("utf-8-sig", "replace").strip()
    parts = text.rpartition("?")[2].split(".")
    shared = _Shared(PROGRAM)
    if not is_shared(text) or len(parts) > 10 * MOST_JOINTS:
        raise shared.refused(1)
    flags, _, whole, kinds = parts[:SETTINGS]
    rest = iter(parts[SETTINGS:])
    joints, links, forces = (list(takewhile(bool, rest)) for _ in range(3))
    turns = shared.integer(whole.partition(",")[0]) * (-1 if shared.integer(flags[-1:]) & CLOCKWISE else 1)
    unit = LETTERS.find(kinds[:1])
    if not 0 <= unit < len(UNITS) or len(joints) > MOST_JOINTS:
        raise shared.refused(kinds)
    return shared.made(UNITS[unit], joints, links, forces, turns * math.tau / 60)


class _Shared(Reading):
    """Collects joints and links, one after the other."""

    def integer(self, text: str) -> int:
        """Return a number in base 64.  Raises `InputError`."""
        if not 0 < len(text) <= LONGEST or any(letter not in LETTERS for letter in text):
            raise self.refused(text[:LONGEST] or "–")
        value = 0
        for letter in text:
            value = value * len(LETTERS) + LETTERS.index(letter)
        return -value if text[0] == "0" else value

    def made(self, unit: float, joints: list[str], links: list[str], forces: list[str], speed: float) -> Scheme:
        """Return the mechanism; `unit` is in m, `speed` in rad/s."""
        self.slides: dict[str, float] = {}  # angles (rad) of prismatic joints on the frame
        self.links: list[tuple[str, ...]] = []
        self.driven = ""
        for joint in joints:
            self._joint(joint, unit)
        for link in links:
            self._link(link)
        for force in forces:
            self.leave_out(f"force {force[1:].partition(',')[0]}")
        self.places = {name: at for name, at in self.places.items() if name not in self.slides}
        moving = self.moving(self.links)
        return self.scheme(moving, self.driven, self.crank_of(moving, self.driven), speed)

    def _joint(self, told: str, unit: float) -> None:
        flags, words = self.integer(told[:1]), told[1:].split(",")
        if len(words) < 5:
            raise self.refused(told[:20])
        name, x, y, angle = words[0], *(self.integer(word) / 1000 for word in words[2:5])
        self.places[name] = complex(x, y) * unit
        if flags & WELDED:
            self.leave_out(f"weld {name}")
        if flags & PRISMATIC:
            if flags & GROUNDED and not flags & INPUT:
                self.slides[name] = angle
            else:
                self.leave_out(f"slide {name}")
        elif flags & GROUNDED:
            self.fixed.add(name)
            if flags & INPUT:
                self.driven = self.driven or name

    def _link(self, told: str) -> None:
        words = told.split(",")
        joints = tuple(takewhile(bool, words[7:]))
        if len(words) < 8 or any(name not in self.places for name in joints):
            raise self.refused(told[:20])
        is_root, kind, name = told[:1] == "Y", told[1:2], words[0][2:]
        if is_root and kind == "P":
            angle = next((self.slides[one] for one in joints if one in self.slides), None)
            pins = [one for one in joints if one not in self.slides]
            if angle is None or len(pins) != 1:
                self.leave_out(f"slider {name}")
            else:
                self.sliders[pins[0]] = Slider(self.places[pins[0]], angle)
        elif is_root:
            self.links.append(tuple(one for one in joints if one not in self.slides))
            for one in joints:
                if one in self.slides:
                    self.leave_out(f"slide {one}")
