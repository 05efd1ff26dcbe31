"""What is drawn over several lines -> one line: [ a  b ] [x] = [e] above [ c  d ] [y]   [f], or a fraction with its bar.

Enters: a text.  Leaves: the text with such a block in its first line; other text is unchanged.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.grading.reading.equations.systems.parts import vector

_OPENS, _CLOSES = r"[\[(|⎡⎢⎣⎛⎜⎝]", r"[\])|⎤⎥⎦⎞⎟⎠]"
_LINE = re.compile(
    rf"\s*{_OPENS}\s*(\S.{{0,500}}?)\s*{_CLOSES}\s*[*·⋅×]?\s*{_OPENS}\s*([^\W\d][\w'̇]{{0,20}})\s*{_CLOSES}"
    rf"\s*(=?)\s*(?:([-−]?[\w*·⋅ ]{{0,40}}?)\s*[*·⋅]?\s*)?{_OPENS}\s*(\S.{{0,500}}?)\s*{_CLOSES}\s*[.,;]?\s*"
)
_BETWEEN = re.compile(r"[\s\[\]()|⎡⎢⎣⎛⎜⎝⎤⎥⎦⎞⎟⎠*·⋅×]*(=?)[\s\[\]()|⎡⎢⎣⎛⎜⎝⎤⎥⎦⎞⎟⎠]*")  # with the signs of the drawing alone
_APART = re.compile(r"\s{2,}|\t|,|&")
# A quotient whose bar begins behind the sign of equality: no title that is underlined.
_FRACTION = re.compile(r"(?m)^([^\n=]{1,80}=)([^\n=]{1,200})\n([ \t]*)[-–—―_─]{4,80}[ \t]*\n([^\n=]{1,200})$")
_BAR = re.compile(r"[─―—–_]{2,}|-{3,}")  # in the middle of the line, as SymPy, Maxima and MATLAB draw it
# What a program shows of a name: S.w2, then "ans =" and the formula below; In [5]: sol[w2], then Out[5]: and the formula
_SHOWN = re.compile(
    r"(?m)^[ \t]*(?:In ?\[\d+\]:=?[ \t]*)?(pretty\()?(?:[^\W\d]\w{0,9}[.\[])?([^\W\d]\w{0,9})\]?\)?;?[ \t]*\n"
    r"(?:[ \t]*\n)*(?:ans[ \t]*=[ \t]*\n(?:[ \t]*\n)*|Out\[\d+\][:=][ \t]*"
    r"|(?(1)(?=[^\n=]*\n[ \t]*[-+]?[ \t]*[-─]{3})|(?!)))(?=[ \t]*\S)"
)
_BEFORE = re.compile(r"[^\W\d]\w{0,9} = (?=[ \t]{2})")
_PROSE = re.compile(r"[^\W\d_]{3,}\s+[^\W\d_]{3,}")
_SUM = re.compile(r"[-+−–]")
_APART_BEFORE, _APART_BEHIND = re.compile(r"\s*|.*[-+−–*·]\s*"), re.compile(r"\s*|\s*[-+−–*·].*")
_FEWEST, _MOST, _LONGEST = 2, 12, 600


def in_one_line(text: str) -> str:
    r"""Return a text in which each product of matrices or fraction that is drawn over several lines stands in one.

    >>> in_one_line("[ 2*a   0 ] [w1]   [ -e ]\n[ c  -d ] [w2] = [ 0 ]\nx = 1")
    '[2*a, 0; c, -d]*[w1; w2] = [-e; 0]\n\nx = 1'
    >>> in_one_line("[a 0] [w1]   [e]\n[c + d  -b] [w2] = [f]")
    '[a, 0; c + d, -b]*[w1; w2] = [e; f]\n'
    >>> in_one_line("w3 = a*w1\n     ----\n      b\n"), in_one_line("w3 = a\n------\nb\n")
    ('w3 = (a*w1)/(b)\n\n\n', 'w3 = a\n------\nb\n')
    """
    text = _SHOWN.sub(lambda found: "\n" * found[0].count("\n") + f"{found[2]} = ", text)
    lines = _FRACTION.sub(_quotient, text).split("\n")
    for place in range(1, len(lines) - 1):
        if "=" not in lines[place] and _BAR.search(lines[place]) and (name := _BEFORE.match(lines[place - 1])):
            above, line, below = lines[place - 1][name.end() :], lines[place], lines[place + 1]
            blank = " " * len(name[0])
            lines[place - 1 : place + 2] = blank + above, name[0] + line, blank + below
        if "=" in lines[place] and len(lines[place]) < _LONGEST and (said := _of_bars(*lines[place - 1 : place + 2])):
            lines[place - 1 : place + 2] = ["", said, ""]
    begun = (len(line) < _LONGEST and sum(map(line.count, "[|(⎡⎢⎣⎛⎝")) > _FEWEST for line in lines)
    found = [_LINE.fullmatch(line) if may_be else None for line, may_be in zip(lines, begun, strict=True)]
    place = 0
    while place < len(lines):
        end, rows, relates = place, list[re.Match[str]](), False
        while end < len(lines) and len(lines[end]) < _LONGEST and len(rows) <= _MOST:
            row, between = found[end], _BETWEEN.fullmatch(lines[end]) if rows and lines[end].strip() else None
            if row is None and between is None:
                break
            rows += [row] if row else []
            relates |= bool(row[3] if row else between and between[1])
            end += 1
        if relates and len(rows) >= _FEWEST and (said := _said(rows)):
            lines[place:end] = [said, *[""] * (end - place - 1)]
        place = max(end, place + 1)
    return "\n".join(lines)


def _quotient(found: re.Match[str]) -> str:
    """Return the quotient that is drawn with its bar, in as many lines; of a sum, the numerator is what stands above the bar."""
    begin, right, below = len(found[3].expandtabs()), found[2], found[4].strip()
    if begin < len(found[1]) - 1 or not any(map(str.isalpha, below)) or _PROSE.search(below):
        return found[0]
    bar = found[0].split("\n")[1].strip()
    start, end = begin - len(found[1]), begin - len(found[1]) + len(bar)
    is_whole = not right[: max(start - 1, 0)].strip() and not right[end + 1 :].strip()
    if is_whole or not _SUM.search(right.strip()[1:]):
        return f"{found[1]} ({right.strip()})/({below})\n\n"
    before, above, behind = right[: max(start, 0)], right[max(start, 0) : end].strip(), right[end:]
    if not _APART_BEFORE.fullmatch(before) or not _APART_BEHIND.fullmatch(behind) or above.count("(") != above.count(")"):
        return found[0]
    return f"{found[1]}{before}({above})/({below}){behind}\n\n"


def _of_bars(above: str, line: str, below: str) -> str:
    """Return a line with the quotients that are drawn around its bars; "" if there is none, or more than these above or below.

    >>> _of_bars("      a*b", "w3 = ----- + e", "     c - d")
    'w3 = ((a*b)/(c - d)) + e'
    """
    bars = [found.span() for found in _BAR.finditer(line) if "=" in line[: found.start()] and "=" not in above + below]
    for begin, end in reversed(bars):
        upper, lower = above[begin:end].strip(), below[begin:end].strip()
        if not upper or not lower:
            return ""
        if len(bars) == 1:  # it may be shorter than what it divides
            upper, lower, above, below = above.strip(), below.strip(), "", ""
        line = f"{line[:begin]}(({upper})/({lower})){line[end:]}"
        above, below = (f"{one[:begin]}{' ' * len(one[begin:end])}{one[end:]}" for one in (above, below))
    return "" if above.strip() or below.strip() else line


def _said(rows: Sequence[re.Match[str]]) -> str:
    """Return the product of a block as one line, "" if its matrix is not square."""
    matrix = [[cell for cell in _APART.split(row[1]) if cell.strip()] for row in rows]
    matrix = [cells if len(cells) == len(rows) else vector(row[1]) for cells, row in zip(matrix, rows, strict=True)]
    if any(len(cells) != len(rows) for cells in matrix):
        return ""
    left, names, right = "; ".join(map(", ".join, matrix)), "; ".join(row[2] for row in rows), "; ".join(row[5] for row in rows)
    factor = next((f"{row[4].strip()}*" for row in rows if row[4]), "")
    return f"[{left}]*[{names}] = {factor}[{right}]"
