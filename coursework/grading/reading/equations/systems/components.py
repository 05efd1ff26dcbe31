r"""Sums of vectors with factors, -r*w1*[sin(a); cos(a)] or u*[c, s] + w*[-s, c] -> one vector, and its equations by components.

Enters: a text or a line; what a name means.  Leaves: the text with one vector in place of each sum, a line of scalar equations.
Nothing is computed.  Used by `matrices.py` and `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import partial
from itertools import chain, islice

from coursework.grading.reading.equations.notation.signs import closing, depths
from coursework.grading.reading.equations.systems.parts import rows_of, vector

# A vector of two to four cells, perhaps in the call that makes one; an index A[0, 1] stands at its name.
_VECTOR = re.compile(
    r"(?:(?:(?:np|numpy|sp|sympy)\.)?(?:array|Matrix|[vV]ector)\(\s*|(?<![\w)\]]))\[(?=(?:[^\[\]\n]|\[\d\]){0,2000}(?:[;\n]|,(?!\d)))"
)
_ENDS, _COMMAND = "=\\;,\n:{}", re.compile(r"\\[A-Za-z]{2}")  # a command of LaTeX, \omega, ends nothing
_NO_FACTOR = re.compile(
    r"\^\s*[({]?\s*-\s*1|⁻¹|\\(?![A-Za-z]{2})|[%@]|\b(?:function|return|inv\w*|pinv|solve|lambda)\b", re.IGNORECASE
)
_SUM = re.compile(r"(?<=[\w)\]])\s*([-+])|^\s*([-+])")
_PRODUCT = re.compile(r"\s*[*·⋅]\s*")
_SIZES, _MOST, _LONGEST = range(2, 5), 20, 2000
_BOTH = re.compile(r"\s*(?:\w{1,9}\s*:\s*)?\[([^\[\]=]+)\]\s*={1,2}\s*\[([^\[\]=]+)\]\s*[.,;]?\s*")
_NAMED = re.compile(
    r"\s*(?:\\(?:vec|bar|overline|mathbf|boldsymbol)\s*)?\{?\s*(?:\\(?:vec|mathbf)\s*)?(?:\{(?=\w\}_))?([vV]\}?_?\{?\w{1,3}\}?)\s*\}?\s*:?="
    r"\s*(?:[\w.]{1,12}\(\s*)?\[((?:[^\[\]=]|\[[ijkn]\])+)\]\)?\s*[.,;]?\s*"
)
# A vector whose entries are used, vB = [a, b] and then vB[0]
_ENTRIES = re.compile(r"(?m)(?:^|(?<=;))[ \t]*([^\W\d]\w{0,12})[ \t]*=[ \t]*(?:[\w.]{1,14}\(\s*)?(?=\[)")
_VECTOR_NAME = r"([^\W\d]\w{0,12})"
_DOT = re.compile(
    rf"(?<![\w.])(?:(?:np\.|numpy\.)?(?:dot|inner)\(\s*{_VECTOR_NAME}\s*,\s*{_VECTOR_NAME}\s*\)"
    rf"|{_VECTOR_NAME}\.dot\(\s*{_VECTOR_NAME}\s*\)|{_VECTOR_NAME}(?:\.?'\s*\*|(?:\.T)?\s*@)\s*{_VECTOR_NAME})(?!\w)"
)
_ALONE = re.compile(r"\)?[ \t]*(?:\.?'|\.T\b)?[ \t]*(?:;|$|[%#/])", re.MULTILINE)  # behind it, no sum goes on
# An object of JavaScript, vP = {x: a, y: b}
_FIELDS = re.compile(r"(?:(?:const|let|var)\s+)?([vV]_?\w{1,3})\s*=\s*\{\s*x\s*:\s*([^{}:]+?),\s*y\s*:\s*([^{}:]+?),?\s*\}")


def in_one_vector(text: str) -> str:
    r"""Return a text with each sum of vectors of one size, each with its factor, as one vector.

    >>> in_one_vector("B=-r*w1*[sin(a); cos(a)];"), in_one_vector("v = u*[c, s] + p*w*[-s, c]"), in_one_vector("[a, b] = y[0]")
    ('B=[-r*w1*(sin(a)); -r*w1*(cos(a))];', 'v = [u*(c) + p*w*(-s); u*(s) + p*w*(c)]', '[a, b] = y[0]')
    """
    text = _FIELDS.sub(lambda found: f"{found[1]} = [{found[2]}; {found[3]}]" + "\n" * found[0].count("\n"), text)
    place = 0
    for _ in range(_MOST):
        if (found := _VECTOR.search(text, place)) is None:
            break
        begin, end = _around(text, found)
        said = _as_one(text[begin:end])
        if said:
            if text[begin - 1 : begin] == "(" and text[end : end + 1] == ")" and not re.search(r"\w\s*\($", text[:begin]):
                begin, end = begin - 1, end + 1
            text = text[:begin] + said + text[end:]
        place = max(begin + len(said), found.end())
    return text


def with_entries_apart(text: str) -> str:
    r"""Return a text with vBx = a; vBy = b for a vector vB = [a, b] of formulas of which entries are used.

    >>> with_entries_apart("v = [a*w, -b*w]\nv[0] - c = 0\nv[1] + d = 0"), with_entries_apart("v = [a*w, b]\nA*x = v")
    ('vx = a*w; vy = -b*w\nvx - c = 0\nvy + d = 0', 'v = [a*w, b]\nA*x = v')
    >>> with_entries_apart("A = [a, b; c, d];\nD = A(1,1)*A(2,2) - A(1,2)*A(2,1)")
    ';\nD = (a)*(d) - (b)*(c)'
    """
    for found in reversed([*islice(_ENTRIES.finditer(text), _MOST)]):
        end = closing(text, found.end(), _LONGEST)
        content, said = text[found.end() + 1 : end], rf"(?<![\w.]){found[1]}"
        begun = end + 1 + ("(" in found[0] and text.startswith(")", end + 1))
        cells, behind, lines = vector(content), text[begun:], "\n" * text.count("\n", found.start(), begun)
        pair = re.compile(said + r" ?[\[(]\s*([0-3])\s*(?:,|\]\s*\[)\s*([0-3])\s*[\])](?!\s*=(?!=))")
        if re.search(said + r" ?[\[(]\s*\d\s*(?:,|\]\s*\[)\s*\d\s*[\])]\s*[-+*/]?=(?!=)", behind):
            continue  # a cell is another one later
        if (places := pair.findall(behind)) and _ALONE.match(text, end + 1):
            first = min(map(int, chain(*places))) and 1
            rows = {f"{i},{k}": f"({cell})" for i, row in enumerate(rows_of(content), first) for k, cell in enumerate(row, first)}
            behind = pair.sub(partial(_named_entry, rows), behind)
            is_whole = re.search(rf"{said}(?!\w)", behind) is not None
            text = text[: begun if is_whole else found.start()] + ("" if is_whole else lines) + behind
            continue
        entry = re.compile(said + r" ?[\[(]\s*([0-3])\s*[\])](?!\s*=(?!=))")
        used = {int(index) for index in entry.findall(behind)}
        first = min(used, default=2) and 1
        is_formula = len(cells) in _SIZES and "*" in content and _ALONE.match(text, end + 1)
        if not is_formula or not used or max(used) - first >= len(cells):
            continue
        names = {str(place): f"{found[1]}{axis}" for place, axis in enumerate("xyz_"[: len(cells)], first)}
        behind = entry.sub(partial(_named_entry, names), behind)
        is_whole = re.search(rf"{said}(?!\w)", behind) is not None  # it is used as a whole, too
        told = zip(names.items(), cells, strict=True)
        apart = "; ".join(f"{name} = {cell}" for (place, name), cell in told if int(place) in used or not is_whole)
        text = f"{text[:begun]}{behind}\n{apart}" if is_whole else text[: found.start()] + apart + lines + behind
    return text


def with_dot_products(text: str) -> str:
    r"""Return a text with the dot products of named vectors as sums, vC'*e, dot(vC, e) or vC @ e.

    >>> with_dot_products("v = [a; b];\ne = [c; d];\nw = -(v.'*e)/R"), with_dot_products("v = [a; b]\nw = v @ A")
    (';\n;\nw = -(((a)*(c) + (b)*(d)))/R', 'v = [a; b]\nw = v @ A')
    """
    factors = {name for found in _DOT.finditer(text) for name in found.groups()}
    defined = [found for found in _ENTRIES.finditer(text) if found[1] in factors][:_MOST]
    said = {found[1]: (found, closing(text, found.end(), _LONGEST)) for found in defined}
    cells = {name: vector(text[found.end() + 1 : end]) for name, (found, end) in said.items() if _ALONE.match(text, end + 1)}

    def summed(found: re.Match[str]) -> str:
        one, other = (cells.get(name, []) for name in found.groups() if name)
        pairs = zip(one, other, strict=False)
        return f"({' + '.join(f'({a})*({b})' for a, b in pairs)})" if len(one) == len(other) in _SIZES else found[0]

    rest = _DOT.sub(summed, text)
    for name, (found, end) in reversed(said.items()):  # what was named for these products alone
        if len(re.findall(rf"(?<![\w.]){name}(?!\w)", rest)) == 1:
            rest = rest.replace(text[found.start() : end + 1], "\n" * text.count("\n", found.start(), end), 1)
    return rest


def _named_entry(names: Mapping[str, str], entry: re.Match[str]) -> str:
    return names.get(",".join(entry.groups()), entry[0])


def _around(text: str, vector_: re.Match[str]) -> tuple[int, int]:
    """Return where the sum begins and ends in which a vector stands."""
    begin = vector_.start()
    level = 0
    for at in range(begin - 1, max(begin - _LONGEST, -1), -1):
        level += {")": 1, "]": 1, "(": -1, "[": -1}.get(text[at], 0)
        if level < 0 or (level == 0 and text[at] in _ENDS and not _COMMAND.match(text, at)):
            break
        begin = at
    end = begin
    inside = depths(text[begin : begin + _LONGEST])
    for at, depth in enumerate(inside, start=begin):
        if depth < 0 or (depth == 0 and text[at] in _ENDS and not _COMMAND.match(text, at)):
            break
        end = at + 1
    return begin + len(text[begin:end]) - len(text[begin:end].lstrip()), begin + len(text[begin:end].rstrip())


def _as_one(sum_: str) -> str:
    """Return the one vector that a sum is, "" if it is none or has a single vector without a factor."""
    inside = depths(sum_)
    cuts = [found.start(found.lastindex or 0) for found in _SUM.finditer(sum_) if inside[found.start(found.lastindex or 0)] == 0]
    terms = [sum_[a:b] for a, b in zip([0, *cuts], [*cuts, len(sum_)], strict=True) if sum_[a:b].strip()]
    read = [_term(term) for term in terms]
    sizes = {len(cells) for _, cells in filter(None, read)}
    if None in read or len(sizes) != 1 or not sizes <= {*_SIZES} or (len(read) == 1 and read[0] and not read[0][0].strip()):
        return ""
    rows = [" ".join(f"{factor}({cells[row]})" for factor, cells in filter(None, read)) for row in range(sizes.pop())]
    return f"[{'; '.join(rows)}]"


def _term(term: str) -> tuple[str, list[str]] | None:
    """Return the factor of a vector, with its sign and the sign of the product, and the cells; None if this is no such term."""
    found = [*islice(_VECTOR.finditer(term), 2)]
    if len(found) != 1:
        return None
    opening = found[0].end() - 1
    end = closing(term, opening)
    cells = vector(term[opening + 1 : end])
    behind = term[end + 1 :].strip()
    behind = behind.removeprefix(")").strip() if "(" in found[0][0] else behind
    behind = re.sub(r"^\.?(?:'|T\b)", "", behind)
    before = _PRODUCT.sub("*", term[: found[0].start()]).strip()
    sign, factor = (before[0], before[1:].strip()) if before[:1] in {"+", "-"} else ("", before)
    if (behind and not behind.startswith(("*", "·"))) or _NO_FACTOR.search(factor + behind) or len(cells) not in _SIZES:
        return None
    factors = "*".join(one for one in (factor.rstrip("* "), behind.lstrip("*· ")) if one)
    factors = f"{factors}*" if factors else ""
    return (f"{sign} {factors}" if sign == "+" else sign + factors), cells


def by_components(line: str, meaning: Callable[[str], str | None]) -> str:
    """Return a line of vectors as one equation for each component; v_K = [a; b] as those of v_Kx and v_Ky.

    >>> by_components("[a; b] = [c; d]", {}.get), by_components("v_K = [a, b]", {"v_Kx": "vKx", "v_Ky": "vKy"}.get)
    ('a = c; b = d', 'vKx = a; vKy = b')
    """
    if "[" not in line:
        return line
    if both := _BOTH.fullmatch(line):
        left, right = vector(both[1]), vector(both[2])
        return "; ".join(map(" = ".join, zip(left, right, strict=True))) if len(left) == len(right) > 1 else line
    named = _NAMED.fullmatch(line)
    cells = vector(named[2]) if named else []
    if named is None or len(cells) != _SIZES[0]:
        return line
    called = re.sub(r"[{}]", "", named[1])
    components = [meaning(f"{called}{axis}") for axis in "xy"]
    # The velocity of a point that nothing is asked about is only a step on the way.
    return "; ".join(f"{name} = {cell}" for name, cell in zip(components, cells, strict=True) if name)
