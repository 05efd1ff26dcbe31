"""Sections [masses] and [forces] for a file that has none yet: a mass to be edited for every body, weight, one load.

Enters: a variant and the text of its file.  Leaves: the text with the sections.  Used by `commands/new.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from coursework.effects.force_scheme import Body, ForceScheme
from coursework.effects.scheme import read_scheme
from coursework.mechanism.mechanism import build
from coursework.variant.record.forces import Forces
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say

_ASKED = re.compile(r"^(quantities\s*=\s*\[)([^\]]*?),?\s*\]", re.M)


def with_forces(variant: Variant, text: str, said: Callable[[str], str]) -> str:
    """Return the text of a variant's file with masses and forces; `said` translates a remark.

    Raises `InputError` if the file does not show its links and joints.
    """
    scheme = read_scheme(build(variant), Forces())
    own = "\n".join(_sections(scheme, said))
    at = text.find("[ask]")
    text = f"{text.rstrip()}\n\n{own}\n" if at < 0 else f"{text[:at]}{own}\n\n{text[at:]}"
    return _ASKED.sub(_asked, text, count=1)


def _asked(found: re.Match[str]) -> str:
    """Return the list of quantities with forces and energy added, each once."""
    more = [one for one in ('"forces"', '"energy"') if one not in found[2]]
    return f"{found[1]}{', '.join([found[2], *more] if found[2].strip() else more)}]"


def _sections(scheme: ForceScheme, said: Callable[[str], str]) -> Iterator[str]:
    yield f"[masses]                       # {said(say('new.masses'))}"
    for body in scheme.bodies:
        points = scheme.holds[body.name]
        parts = ['mass = "1 kg"']
        if body.turns:
            wheel = _is_wheel(scheme, body)
            parts.append('inertia = "disc"' if wheel else 'inertia = "rod"' if len(points) == 2 else 'inertia = "0.01 kg*m^2"')
            parts += [f'centre = "{points[0]}"'] if len(points) > 2 and not wheel else []
        yield f"{body.name} = {{ {', '.join(parts)} }}"
    yield ""
    yield f"[forces]                       # {said(say('new.forces'))}"
    yield 'gravity = "9.81 m/s^2"'
    last = scheme.bodies[-1]
    held = scheme.holds[last.name]  # a wheel lists its centre first, and its contact is not one of its own points
    yield f'F1 = {{ on = "{last.name}", at = "{held[0] if _is_wheel(scheme, last) else held[-1]}", force = "(-100, 0)" }}'


def _is_wheel(scheme: ForceScheme, body: Body) -> bool:
    """Return whether a body rolls at its own contact; a bar that a wheel rolls on has none."""
    return body.span is not None and any(one.name[0] == "T" and one.at == body.span[1] for one in scheme.unknowns)
