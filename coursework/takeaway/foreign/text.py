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
from coursework.takeaway.foreign.scheme import Scheme
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
    lines += [f'w1 = "{"-" if (scheme.speed or 0.0) < 0 else ""}w0"', "", "[coordinates]", *_coordinates(scheme, chain)]
    lines += ["", "[time]", f'step   = "2*pi/({STEPS}*w0)"', 'end    = "2*pi/w0"', 'period = "2*pi/w0"', "", "[points]"]
    lines += [*_points(scheme, chain, names)]
    for number, group in enumerate(_groups(chain), start=1):
        lines += ["", *_group(group, number, names)]
    rails = [f'{{ through = "{names[one.meets]}", angle = "t{number}" }}' for number, one in enumerate(_groups(chain), start=1)
             if one.slider is not None]  # fmt: skip
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
        for letter, length in zip("ab", group.lengths, strict=False):
            yield _datum(f"l{number}{letter}", length, "m")
        if group.slider is not None:
            yield _datum(f"xK{number}", group.slider.through.real, "m")
            yield _datum(f"yK{number}", group.slider.through.imag, "m")
            yield _datum(f"t{number}", group.slider.angle, "rad")
    for step in chain.steps:
        if isinstance(step, Carried):
            yield _datum(f"d{names[step.joint]}", step.distance, "m")
            yield _datum(f"b{names[step.joint]}", step.angle, "rad")


def _datum(name: str, value: float, unit: str) -> str:
    return f'{name} = "{value + 0.0:.{DIGITS}g} {unit}"'


def _coordinates(scheme: Scheme, chain: Chain) -> Iterator[str]:
    first, *others = _groups(chain)
    start = cmath.phase(scheme.joints[first.meets] - scheme.joints[first.start[0]])
    yield f'phi1 = {{ start = "{start:.{DIGITS}g} rad", rate = "w1" }}'
    for number, group in enumerate(others, start=2):
        yield f'phi{number}a = {{ rate = "w{number}a", unit = "rad" }}'
        second = f's{number} = {{ rate = "u{number}", unit = "m" }}'
        yield second if group.kind == "RRP" else f'phi{number}b = {{ rate = "w{number}b", unit = "rad" }}'


def _angle(chain: Chain, link: int) -> str:
    """Return the coordinate of a link."""
    for number, group in enumerate(_groups(chain), start=1):
        if link in group.links:
            return "phi1" if number == 1 else f"phi{number}{'ab'[group.links.index(link)]}"
    raise KeyError(link)


def _points(scheme: Scheme, chain: Chain, names: dict[str, str]) -> Iterator[str]:
    for name in scheme.joints:
        if name in scheme.fixed:
            yield f'{names[name]} = "(x{names[name]}, y{names[name]})"'
    for number, group in enumerate(_groups(chain), start=1):
        if group.slider is not None:
            yield f'K{number} = "(xK{number}, yK{number})"'
    for step in chain.steps:
        if isinstance(step, Carried):
            letter = names[step.joint]
            yield f'{letter} = "{names[step.base]} + d{letter} @ ({_angle(chain, step.link)} + b{letter})"'


def _group(group: Group, number: int, names: dict[str, str]) -> Iterator[str]:
    yield "[[group]]"
    yield f'kind        = "{group.kind}"'
    yield f"from        = {_listed(names[one] for one in group.start)}"
    if group.slider is not None:
        yield f'guide       = {{ through = "K{number}", angle = "t{number}" }}'
    yield f'meets       = "{names[group.meets]}"'
    yield f"lengths     = {_listed(f'l{number}{letter}' for letter, _ in zip('ab', group.lengths, strict=False))}"
    coordinates = {"crank": ["phi1"], "RRP": [f"phi{number}a", f"s{number}"], "RRR": [f"phi{number}a", f"phi{number}b"]}
    yield f"coordinates = {_listed(coordinates[group.kind])}"
    if group.mode:
        yield f'mode        = "{group.mode:+d}"'
