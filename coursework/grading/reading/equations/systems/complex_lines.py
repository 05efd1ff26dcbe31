r"""A loop equation in complex numbers, i·r1·w1·e^{i·phi1} + … = 0 -> its real and its imaginary part, as two equations.

Enters: a line.  Leaves: two lines, none if it has no such power or one that is not understood.  Used by `lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.notation.latex import without_latex
from coursework.grading.reading.equations.notation.signs import depths, plain_signs
from coursework.grading.reading.limits import EQUATION_CHARACTERS

_POWER = re.compile(
    r"(?<![^\W\d_])(?:e\s*\^\s*|exp\s*(?=[({\[]))(?:([({\[])\s*(-?)\s*1?[ij]\s*[*·]?\s*|(-?)1?[ij]\s*[*·]?\s*([^\W\d]\w*))"
)
_ROUND = re.compile(r"\\(?:mathrm|text|mathit)\s*\{([eij])\}|\b(?:np|numpy|cmath)\.(?=exp)")
_UNIT = re.compile(r"(?<![\w^.])1?[ij](?![\w(]|\s*\()|(?<![\w^.])1?[ij](?=\s*[*·(])")
_GLUED = re.compile(r"(?<![\w\\^.])([ij])(?=[A-Za-z]_)")  # iV_x
_FACTORED = re.compile(r"\s*[-+]?\s*1?[ij]\s*[*·]?\s*[(\[{](.*)[)\]}](\s*=\s*0[.,;]?\s*)")  # i·(…) = 0
_NAMED = re.compile(r"^\s*[^\W\d]\w{0,20}\s*=")  # V_E = V_Ex + i·V_Ey = …
_SIGN = re.compile(r"(?<=[\w)}\]\s])\s*[-+]\s*(?=[^\s])|^\s*[-+]\s*")


def real_and_imaginary(line: str) -> list[str]:
    """Return the real and the imaginary part of an equation of complex numbers, [] if it is none or is not understood.

    >>> real_and_imaginary("i a w1 e^{i phi1} - exp(i*phi2)*v = u")
    ['1 a w1 (-sin(phi1)) - (cos(phi2))*v = u', '1 a w1 (cos(phi1)) - (sin(phi2))*v = 0']
    >>> real_and_imaginary("i (a e^(i phi1)) = 0"), real_and_imaginary("e*w1 = 0")
    (['a (cos(phi1)) = 0', 'a (sin(phi1)) = 0'], [])
    """
    if len(line) > EQUATION_CHARACTERS or not _POWER.search(
        text := plain_signs(without_latex(_GLUED.sub(r"\1 ", _ROUND.sub(r"\1", line))))
    ):
        return []
    if (factored := _FACTORED.fullmatch(text)) and -1 not in depths(factored[1]):
        text = factored[1] + factored[2]
    text = _NAMED.sub("", text) if text.count("=") > 1 else text
    sides = [[_parts(term) for term in _terms(side)] for side in text.split("=")]
    if len(sides) != 2 or any(term is None for side in sides for term in side):
        return []
    found = (["".join(term[place] for term in side if term and term[place].strip()) for side in sides] for place in (0, 1))
    return [" = ".join(side.strip().removeprefix("+").strip() or "0" for side in pair) for pair in found]


def _terms(side: str) -> list[str]:
    """Return the terms of a sum, each with its sign."""
    inside = depths(side)
    cuts = [found.start() for found in _SIGN.finditer(side) if found.start() and inside[found.end() - 1] == 0]
    return [side[begin:end] for begin, end in zip([0, *cuts], [*cuts, len(side)], strict=True)]


def _parts(term: str) -> tuple[str, str] | None:
    """Return the real and the imaginary part of a term, "" for zero, None if the term is not understood."""
    powers = list(_POWER.finditer(term))
    if len(powers) > 1:
        return None
    before, angle, after = term, "", ""
    if powers:
        found = powers[0]
        inside = depths(term[found.end() :])
        if (found[1] and -1 not in inside) or depths(term)[found.start()]:
            return None
        end = found.end() + (inside.index(-1) if found[1] else 0)
        angle = f"{found[2] or found[3] or ''}{term[found.end() : end] if found[1] else found[4]}"
        before, after = term[: found.start()], term[end + (1 if found[1] else 0) :]
    rest = before + after
    units, inside = list(_UNIT.finditer(rest)), depths(rest)
    if len(units) > 1 or any(inside[unit.start()] for unit in units):
        return None
    before, after = _UNIT.sub("1", before), _UNIT.sub("1", after)
    if not powers:
        return ("", before) if units else (before, "")
    cosine, sine = (
        f"{before}({sign}{function}({angle})){after}" for sign, function in (("", "cos"), ("-" if units else "", "sin"))
    )
    return (sine, cosine) if units else (cosine, sine)
