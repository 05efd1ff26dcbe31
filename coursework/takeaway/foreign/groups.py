"""Takes a scheme of joints apart into a crank and dyads, the form of a chain here.

Enters: a `Scheme`.  Leaves: `Group`s, `Carried` points, and the joints that belong to none.  Used by `text.py`.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from coursework.system.frozen import frozen
from coursework.takeaway.foreign.scheme import SHORTEST, Scheme, Slider, arm_of


@frozen
class Group:
    """A group: its kind, the joints that it hangs on, the joint where its links meet, its links and their lengths (m)."""

    kind: str
    start: tuple[str, ...]
    meets: str
    links: tuple[int, ...]
    lengths: tuple[float, ...]
    mode: int
    slider: Slider | None = None
    ratio: float = 1.0


@frozen
class Carried:
    """A further joint of a link, at a distance (m) from the joint where the link begins, and at an angle (rad) to it."""

    joint: str
    link: int
    base: str
    distance: float
    angle: float


class Chain:
    """The groups of a scheme, found one after the other, and the joints that belong to none."""

    def __init__(self, scheme: Scheme) -> None:
        self.scheme = scheme
        self.known = set(scheme.fixed)
        self.placed: set[int] = set()
        self.groups: list[Group] = []
        self.carried: list[Carried] = []
        pin = arm_of(scheme.joints, self.known, scheme.links[scheme.crank], scheme.pivot)[0]  # exists: see `Reading.scheme`
        self.lines: dict[int, tuple[str, complex]] = {}  # link -> joint where its angle is measured, its direction
        self._add(Group("crank", (scheme.pivot,), pin, (scheme.crank,), (self._apart(scheme.pivot, pin),), 0))
        for one in scheme.turned:
            pins = arm_of(scheme.joints, self.known, scheme.links[one.link], one.pivot)
            if pins and one.link not in self.placed:
                lengths = (self._apart(one.pivot, pins[0]),)
                self._add(Group("crank", (one.pivot,), pins[0], (one.link,), lengths, 0, ratio=one.ratio))
        while (found := next(self._dyads(), None)) is not None:
            self._add(found)
        self.lost = [name for name in scheme.joints if name not in self.known]
        used_slots = {group.slider for group in self.groups}
        self.lost += [name for name, one in scheme.sliders.items() if one not in used_slots and name not in self.lost]
        used = {name for group in self.groups for name in group.start}
        self.hinges = [name for name in scheme.joints if name in scheme.fixed and name in used]

    def _apart(self, first: str, second: str) -> float:
        return abs(self.scheme.joints[second] - self.scheme.joints[first])

    def _dyads(self) -> Iterator[Group]:
        """Yield the dyads whose outer joints are known by now."""
        at = self.scheme.joints
        for meets in at:
            if meets in self.known:
                continue
            hung = [
                (link, base) for link, joints in enumerate(self.scheme.links) if meets in joints and link not in self.placed
                for base in joints if base in self.known and self._apart(base, meets) > SHORTEST
            ]  # fmt: skip
            one_each = dict(reversed(hung))
            links, bases = tuple(one_each)[::-1], tuple(one_each.values())[::-1]
            slider = self.scheme.sliders.get(meets)
            if slider is not None and links and (slider.link is None or slider.link in self.placed):
                ahead = ((at[meets] - at[bases[0]]) * cmath.exp(-1j * slider.angle)).real
                length = (self._apart(bases[0], meets),)
                yield Group("RRP", bases[:1], meets, links[:1], length, 1 if ahead >= 0 else -1, slider)
            elif len(links) > 1:
                way, reach = at[bases[1]] - at[bases[0]], at[meets] - at[bases[0]]
                lengths = tuple(self._apart(base, meets) for base in bases[:2])
                yield Group("RRR", bases[:2], meets, links[:2], lengths, 1 if (way.conjugate() * reach).imag >= 0 else -1)

        yield from self._levers()

    def _levers(self) -> Iterator[Group]:
        """Yield the links that turn about a known joint and have a slot in which another known joint slides."""
        at = self.scheme.joints
        for pin, slider in self.scheme.sliders.items():
            if pin not in self.known or slider.link is None or slider.link in self.placed:
                continue
            for base in self.scheme.links[slider.link]:
                way = (at[pin] - at[base]) * cmath.exp(-1j * slider.angle)
                if base in self.known and abs(way.real) > SHORTEST:
                    yield Group("RPR", (pin, base), "", (slider.link,), (way.imag,), 1 if way.real > 0 else -1, slider)

    def _add(self, group: Group) -> None:
        self.groups.append(group)
        self.known.add(group.meets)
        slot = group.kind == "RPR" and group.slider
        for link, base in zip(group.links, group.start[1:] if slot else group.start, strict=True):
            self.placed.add(link)
            at = self.scheme.joints
            along = cmath.exp(1j * slot.angle) if slot else at[group.meets] - at[base]
            self.lines[link] = base, along
            for joint in self.scheme.links[link]:
                if joint not in self.known:
                    turned = (at[joint] - at[base]) / along
                    self.carried.append(Carried(joint, link, base, self._apart(base, joint), cmath.phase(turned)))
                    self.known.add(joint)
