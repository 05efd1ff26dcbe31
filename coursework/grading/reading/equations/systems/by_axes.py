"""A line that adds vectors of two components, v_E = v_A + w2 (-p sin φ2, p cos φ2), -> its equations along x and along y.

Enters: a line.  Leaves: both equations in one line, in which v_A is v_Ax and v_Ay; any other line as it is.
Used by `text_lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.notation.signs import closing, depths
from coursework.grading.reading.limits import EQUATION_CHARACTERS

_SIGN = re.compile(r"(?<=[\w)\]}])\s*([-+−–])(?=\s*[\w(\[])|^\s*([-+−–])")
_NAMED = re.compile(r"\s*(?:\\?(?:vec|mathbf|boldsymbol)\s*)?\{?(v)⃗?_?\{?([A-Z]\w?)\}?\s*\}?\s*")
_PAIR = re.compile(r"(?<![\w)\]])\(|(?<![\w)\]])\[|(?<=[\w)])\s+[(\[]")
_DECIMAL = re.compile(r"\d,\d")
_ZERO = re.compile(r"\s*0\s*[.,;]?\s*")
_WORDS = re.compile(r"^(?:[^\W\d_]{3,12}\s+)?(?=v_?[A-Z{])")


def along_axes(line: str) -> str:
    """Return a line of vectors as two equations; a line with anything else in it does not change.

    >>> along_axes("v_E = v_A + w2 (-p sin f, p cos f)")
    'v_Ex = v_Ax + w2*(-p sin f); v_Ey = v_Ay + w2*(p cos f)'
    >>> along_axes("v_B - v_A = [a; b]"), along_axes("w3 = atan2(a, b)"), along_axes("v = r (a, b)")
    ('v_Bx - v_Ax = (a); v_By - v_Ay = (b)', 'w3 = atan2(a, b)', 'v = r (a, b)')
    """
    if len(line) > EQUATION_CHARACTERS or "=" not in line or not ("," in line or ";" in line):
        return line
    sides = [_side(side) for side in _WORDS.sub("", line.strip(), count=1).rstrip(" .,;").split("=")]
    if len(sides) < 2 or None in sides or not any("(" in side[0] for side in sides if side):
        return line
    return "; ".join(" = ".join(side[axis] for side in sides if side) for axis in (0, 1))


def _side(text: str) -> tuple[str, str] | None:
    """Return a sum of vectors along both axes, None if it is none."""
    if _ZERO.fullmatch(text):
        return "0", "0"
    inside = depths(text)
    cuts = [found.start(found.lastindex or 0) for found in _SIGN.finditer(text) if not inside[found.start(found.lastindex or 0)]]
    terms = [text[a:b].strip() for a, b in zip([0, *cuts], [*cuts, len(text)], strict=True) if text[a:b].strip()]
    found = [_term(term) for term in terms]
    if not found or None in found:
        return None
    x, y = (" ".join(one[axis] for one in found if one) for axis in (0, 1))
    return x.strip(), y.strip()


def _term(term: str) -> tuple[str, str] | None:
    """Return a vector with its sign and factor along both axes, None if it is none."""
    sign = f"{term[0]} " if term[0] in "+-−–" else ""
    rest = term[1:].strip() if sign else term
    if named := _NAMED.fullmatch(rest):
        return f"{sign}v_{named[2]}x", f"{sign}v_{named[2]}y"
    for opened in _PAIR.finditer(rest):
        begin = opened.end() - 1
        end = closing(rest, begin)
        content = rest[begin + 1 : end]
        cut = _cut(content)
        before, behind = rest[:begin].strip(" *·"), rest[end + 1 :].strip(" *·.'ᵀ")
        if cut and {*",;["}.isdisjoint(before + behind):
            factors = "".join(f"{one}*" for one in (before, behind) if one)
            return f"{sign}{factors}({content[:cut].strip()})", f"{sign}{factors}({content[cut + 1 :].strip()})"
    return None


def _cut(content: str) -> int:
    """Return where the only comma or semicolon between two cells stands, 0 if there is none or another."""
    inside = depths(content)
    found = [
        at for at, sign in enumerate(content) if sign in ",;" and not inside[at] and not _DECIMAL.match(content, max(at - 1, 0))
    ]
    return found[0] if len(found) == 1 else 0
