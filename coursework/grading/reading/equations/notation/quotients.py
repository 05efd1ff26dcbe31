"""Quotients that are written as calls, frac(a, b) and sec(x) -> (a)/(b) and (1/cos(x)).

Enters: a line in plain signs.  Leaves: the line with such quotients; other text is unchanged.  Used by `plain_text.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from coursework.grading.reading.equations.notation.signs import closing, depths

_FRACTION = re.compile(r"\bfrac\s*(?=\()")  # frac(a, b) in Typst, frac(a)(b) in AsciiMath
_SECANT = re.compile(r"\b(sec|csc|cosec)\s*(?:(?=[(\[])|\s([^\W\d]\w*))", re.IGNORECASE)


def with_fractions(text: str) -> str:
    """Return a line with a/b for frac(a, b) and frac(a)(b).

    >>> with_fractions("frac(a + 1,b) + frac(c)(d)")
    '(a + 1)/(b) + (c)/(d)'
    """
    while found := _FRACTION.search(text):
        end = closing(text, found.end())
        above = text[found.end() + 1 : end]
        cut = next((place for place, depth in enumerate(depths(above)) if depth == 0 and above[place] == ","), len(above))
        if cut == len(above) and not text[end + 1 :].startswith("("):
            return text
        below = f"({above[cut + 1 :]})" if cut < len(above) else ""
        text = f"{text[: found.start()]}({above[:cut]})/{below}{text[end + 1 :]}"
    return text


def with_secants(text: str, is_angle: Callable[[str], bool]) -> str:
    """Return a line with (1/cos(x)) for sec(x) and (1/sin(x)) for csc(x), if that is no unit, 1/sec.

    >>> with_secants("a*sec(b + c)*csc d in 1/sec", "d".__eq__)
    'a*(1/cos(b + c))*(1/sin(d)) in 1/sec'
    """
    for found in reversed([*_SECANT.finditer(text)]):
        end = found.end() - 1 if found[2] else closing(text, found.end())
        if found[2] is None or is_angle(found[2]):
            argument = found[2] or text[found.end() + 1 : end]
            text = f"{text[: found.start()]}(1/{'cos' if found[1].lower() == 'sec' else 'sin'}({argument})){text[end + 1 :]}"
    return text
