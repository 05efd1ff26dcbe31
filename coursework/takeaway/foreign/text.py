"""A scheme of another program as a variant file: points, a crank, dyads, and remarks on what was left out.

Enters: a `Scheme`.  Leaves: TOML, written by `reports/foreign-scheme.toml.j2`.  Used by `read.py`.
"""

from __future__ import annotations

import cmath
import json
import re
from collections.abc import Callable
from functools import partial
from string import ascii_uppercase

from coursework.system.frozen import frozen
from coursework.takeaway.foreign.groups import Chain, Group
from coursework.takeaway.foreign.scheme import SHORTEST, Scheme
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
