"""A scheme of another program, taken apart into a crank and dyads, as a variant file with remarks on what was left out.

Enters: a `Scheme`.  Leaves: TOML, written by `reports/foreign-scheme.toml.j2`.  Used by `read.py`.
"""

from __future__ import annotations

import cmath
import json
import re
from collections.abc import Callable, Iterator
from functools import partial
from string import ascii_uppercase

from coursework.system.frozen import frozen
from coursework.takeaway.foreign.scheme import SHORTEST, Scheme, Slider, arm_of
from coursework.words.sentences import say
from coursework.words.templates import clean, filled

LONGEST = 120  # most letters of a title
_LETTER = re.compile(r"[A-Z]\d{0,2}")


@frozen
class _Guide:
    """The line on which a group slides, at an `angle` (rad), `through` a point at the place `at` (m) in the frame.

    A line on a moving link `turns` with the coordinate of that name, and its angle is relative to it; `at` is then relative to
    the joint `base` and to the direction of the link, at a `distance` (m).  `starts`: the line goes through that joint itself.
    """

    number: int
    through: str
    at: complex
    angle: float
    turns: str = ""
    base: str = ""
    distance: float = 0.0
    starts: bool = False


def text_of(scheme: Scheme, name: str, said: Callable[[str], str]) -> str:
    """Return the variant file; `said` translates a sentence into the language of the command."""
    chain, names, quoted = Chain(scheme), _names(scheme), partial(json.dumps, ensure_ascii=False)
    groups = list(enumerate(chain.groups, start=1))
    lost = [say("foreign.alone", joint=clean(one, 40)) for one in chain.lost]
    return filled(
        "foreign-scheme.toml.j2",
        title=clean(scheme.title, LONGEST) or said(say("foreign.title", name=name, program=scheme.program)),
        source=said(say("foreign.source", program=scheme.program)),
        remarks=[said(one) for one in (*scheme.remarks, *lost)],
        speed=scheme.speed or 1.0,
        fixed={names[one]: at for one, at in scheme.joints.items() if one in scheme.fixed},
        hinges=chain.hinges,
        groups=groups,
        carried=chain.carried,
        lines=chain.lines,
        guides={n: found for n, group in groups if (found := _guide(chain, n, group, names)) is not None},
        rails=[(n, group) for n, group in groups if group.slider is not None and group.slider.link is None],
        names=names,
        angle=partial(_angle, chain),
        coordinates=_coordinates,
        lengths=lambda n, group: [f"l{n}{letter}" for letter, _ in zip("ab", group.lengths, strict=False)],
        listed=lambda joints: quoted([names[one] for one in joints]),
        quoted=quoted,
        phase=cmath.phase,
    )


def _names(scheme: Scheme) -> dict[str, str]:
    """Return a name for each joint: its own if all are capital letters (with digits), else A, B, C and so on."""
    if all(_LETTER.fullmatch(name) for name in scheme.joints):
        return {name: name for name in scheme.joints}
    count = len(ascii_uppercase)
    return {name: ascii_uppercase[k % count] + (str(k // count) if k >= count else "") for k, name in enumerate(scheme.joints)}


def _coordinates(number: int, group: Group) -> list[str]:
    """Return the names of a group's coordinates, angles of links first."""
    if group.kind == "crank":
        return [f"phi{number}"]
    return [f"phi{number}a", f"phi{number}b" if group.kind == "RRR" else f"s{number}"]


def _angle(chain: Chain, link: int) -> str:
    """Return the name of the coordinate of a link."""
    number, group = next(found for found in enumerate(chain.groups, start=1) if link in found[1].links)
    return _coordinates(number, group)[group.links.index(link)]


def _guide(chain: Chain, number: int, group: Group, names: dict[str, str]) -> _Guide | None:
    """Return the line on which a dyad slides; None if it does not slide, or is a lever, which is that line itself."""
    slider = group.slider
    if slider is None or group.kind == "RPR":
        return None
    if slider.link is None:
        return _Guide(number, f"K{number}", slider.through, slider.angle)
    base, along = chain.lines[slider.link]
    way = slider.through - chain.scheme.joints[base]
    starts = abs(way) <= SHORTEST
    through, angle = names[base] if starts else f"K{number}", cmath.phase(cmath.exp(1j * slider.angle) / along)
    place = way / along
    return _Guide(number, through, place, angle, _angle(chain, slider.link), names[base], abs(place * along), starts)


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
