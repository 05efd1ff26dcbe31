"""A scheme of another program as a variant file: points, a crank, dyads, and remarks on what has no counterpart.

Enters: a `Scheme`.  Leaves: TOML.  Used by `read.py`.
"""

from __future__ import annotations

import cmath
import json
import re
from collections.abc import Callable, Iterable, Iterator
from string import ascii_uppercase

from coursework.takeaway.foreign.groups import Carried, Chain, Group
from coursework.takeaway.foreign.scheme import SHORTEST, Scheme
from coursework.words.sentences import say
from coursework.words.templates import clean

DIGITS = 12
STEPS = 36  # of a turn
LONGEST = 120  # letters of a title
_LETTER = re.compile(r"[A-Z]\d{0,2}")


def text_of(scheme: Scheme, name: str, said: Callable[[str], str]) -> str:
    """Return the file; `said` returns a sentence in the language of the command."""
    chain = Chain(scheme)
    names = _names(scheme)
    speed = abs(scheme.speed) if scheme.speed else 1.0
    title = clean(scheme.title, LONGEST) or said(say("foreign.title", name=name, program=scheme.program))
    remarks = [said(one) for one in (*scheme.remarks, *(say("foreign.alone", joint=clean(one, 40)) for one in chain.lost))]
    told = [("title", title), ("source", said(say("foreign.source", program=scheme.program)))]
    head = [f"{key} = {json.dumps(value, ensure_ascii=False)}" for key, value in told]
    listed = ",\n".join(f"    {json.dumps(one, ensure_ascii=False)}" for one in remarks)
    lines = ["format = 1", *head, f"remarks = [\n{listed},\n]" if remarks else "remarks = []", "", "[given]"]
    lines += [*_given(scheme, chain, names), f'w0 = "{speed:.{DIGITS}g} rad/s"', "", "[drive]"]
    sign = -1.0 if (scheme.speed or 0.0) < 0 else 1.0
    lines += [f'w{number} = "{_times(sign * group.ratio)}w0"' for number, group in enumerate(_groups(chain), start=1)
              if group.kind == "crank"]  # fmt: skip
    lines += ["", "[coordinates]", *_coordinates(scheme, chain)]
    lines += ["", "[time]", f'step   = "2*pi/({STEPS}*w0)"', 'end    = "2*pi/w0"', 'period = "2*pi/w0"', "", "[points]"]
    lines += [*_points(scheme, chain, names)]
    for number, group in enumerate(_groups(chain), start=1):
        lines += ["", *_group(chain, group, number, names)]
    rails = [f'{{ through = "{names[one.meets]}", angle = "t{number}" }}' for number, one in enumerate(_groups(chain), start=1)
             if one.slider is not None and one.slider.link is None]  # fmt: skip
    lines += [
        "",
        "[frame]",
        f"hinges = {_listed(names[one] for one in chain.hinges)}",
        *([f"rails = [{', '.join(rails)}]"] if rails else []),
    ]
    lines += ["", "[ask]", 'quantities = ["table", "plots", "checks", "points"]']
    return "\n".join(lines) + "\n"


def _names(scheme: Scheme) -> dict[str, str]:
    """Return a letter for each joint: its own where all are letters, else A, B, C and so on."""
    if all(_LETTER.fullmatch(name) for name in scheme.joints):
        return {name: name for name in scheme.joints}
    count = len(ascii_uppercase)
    return {name: ascii_uppercase[k % count] + (str(k // count) if k >= count else "") for k, name in enumerate(scheme.joints)}


def _listed(items: Iterable[str]) -> str:
    return json.dumps(list(items))


def _groups(chain: Chain) -> Iterator[Group]:
    return (step for step in chain.steps if isinstance(step, Group))


def _given(scheme: Scheme, chain: Chain, names: dict[str, str]) -> Iterator[str]:
    """Yield lengths, places and angles: `l` of links, `x` and `y` of fixed joints, `d` and `b` of carried ones."""
    for name in scheme.joints:
        if name in scheme.fixed:
            at = scheme.joints[name]
            yield _datum(f"x{names[name]}", at.real, "m")
            yield _datum(f"y{names[name]}", at.imag, "m")
    for number, group in enumerate(_groups(chain), start=1):
        if group.kind == "RPR":
            yield _datum(f"e{number}", group.lengths[0], "m")
            continue
        for letter, length in zip("ab", group.lengths, strict=False):
            yield _datum(f"l{number}{letter}", length, "m")
        if group.slider is not None and group.slider.link is not None:
            base, along = chain.lines[group.slider.link]
            place = (group.slider.through - scheme.joints[base]) / along
            if not _starts(scheme, chain, group):
                yield _datum(f"dK{number}", abs(place * along), "m")
                yield _datum(f"bK{number}", cmath.phase(place), "rad")
            yield _datum(f"t{number}", cmath.phase(cmath.exp(1j * group.slider.angle) / along), "rad")
        elif group.slider is not None:
            yield _datum(f"xK{number}", group.slider.through.real, "m")
            yield _datum(f"yK{number}", group.slider.through.imag, "m")
            yield _datum(f"t{number}", group.slider.angle, "rad")
    for step in chain.steps:
        if isinstance(step, Carried):
            yield _datum(f"d{names[step.joint]}", step.distance, "m")
            yield _datum(f"b{names[step.joint]}", step.angle, "rad")


def _starts(scheme: Scheme, chain: Chain, group: Group) -> bool:
    """Return whether the slot of a moving link goes through the joint from which the link is counted."""
    assert group.slider is not None and group.slider.link is not None
    return abs(group.slider.through - scheme.joints[chain.lines[group.slider.link][0]]) <= SHORTEST


def _datum(name: str, value: float, unit: str) -> str:
    return f'{name} = "{value + 0.0:.{DIGITS}g} {unit}"'


def _coordinates(scheme: Scheme, chain: Chain) -> Iterator[str]:
    for number, group in enumerate(_groups(chain), start=1):
        if group.kind == "crank":
            start = cmath.phase(scheme.joints[group.meets] - scheme.joints[group.start[0]])
            yield f'phi{number} = {{ start = "{start:.{DIGITS}g} rad", rate = "w{number}" }}'
            continue
        yield f'phi{number}a = {{ rate = "w{number}a", unit = "rad" }}'
        second = f's{number} = {{ rate = "u{number}", unit = "m" }}'
        yield second if group.kind != "RRR" else f'phi{number}b = {{ rate = "w{number}b", unit = "rad" }}'


def _times(factor: float) -> str:
    """Return a factor before a name."""
    return {1.0: "", -1.0: "-"}.get(factor, f"{factor:.{DIGITS}g}*")


def _angle(chain: Chain, link: int) -> str:
    """Return the coordinate of a link."""
    for number, group in enumerate(_groups(chain), start=1):
        if link in group.links:
            return f"phi{number}" if group.kind == "crank" else f"phi{number}{'ab'[group.links.index(link)]}"
    raise KeyError(link)


def _points(scheme: Scheme, chain: Chain, names: dict[str, str]) -> Iterator[str]:
    for name in scheme.joints:
        if name in scheme.fixed:
            yield f'{names[name]} = "(x{names[name]}, y{names[name]})"'
    for number, group in enumerate(_groups(chain), start=1):
        if group.slider is None or group.kind == "RPR":
            continue
        if group.slider.link is None:
            yield f'K{number} = "(xK{number}, yK{number})"'
        elif not _starts(scheme, chain, group):
            base, angle = chain.lines[group.slider.link][0], _angle(chain, group.slider.link)
            yield f'K{number} = "{names[base]} + dK{number} @ ({angle} + bK{number})"'
    for step in chain.steps:
        if isinstance(step, Carried):
            letter = names[step.joint]
            yield f'{letter} = "{names[step.base]} + d{letter} @ ({_angle(chain, step.link)} + b{letter})"'


def _group(chain: Chain, group: Group, number: int, names: dict[str, str]) -> Iterator[str]:
    yield "[[group]]"
    yield f'kind        = "{group.kind}"'
    yield f"from        = {_listed(names[one] for one in group.start)}"
    slides = [f"phi{number}a", f"s{number}"]
    if group.kind == "RPR":
        yield f'offset      = "e{number}"'
    else:
        if group.slider is not None:
            through, turns = f"K{number}", ""
            if group.slider.link is not None:
                turns = f"{_angle(chain, group.slider.link)} + "
                through = names[chain.lines[group.slider.link][0]] if _starts(chain.scheme, chain, group) else through
            yield f'guide       = {{ through = "{through}", angle = "{turns}t{number}" }}'
        yield f'meets       = "{names[group.meets]}"'
        yield f"lengths     = {_listed(f'l{number}{letter}' for letter, _ in zip('ab', group.lengths, strict=False))}"
    coordinates = {"crank": [f"phi{number}"], "RRP": slides, "RPR": slides, "RRR": [f"phi{number}a", f"phi{number}b"]}
    yield f"coordinates = {_listed(coordinates[group.kind])}"
    if group.mode:
        yield f'mode        = "{group.mode:+d}"'
