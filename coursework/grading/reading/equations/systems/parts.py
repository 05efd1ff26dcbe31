"""One line as typed -> its equations: separated by commas, semicolons, arrows, blanks or "and", or the rows of a matrix product.

Enters: a line.  Leaves: its pieces with one equation each, in the order of the line.
Used by `lines.py` and `matrices.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from coursework.grading.reading.equations.notation.latex import with_formulas_joined
from coursework.grading.reading.equations.notation.signs import ARROW, ARROWS, depths, relates_two_sides
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.variant.formula.reader import MAX_DEPTH

_BETWEEN_BRACKETS = re.compile(  # (a = b) e (c = d), not (a) sin (b) = 0
    r"(?<=\))\s(?:[^\W\d_]{1,5}|&)\s(?=\((?:[^()=]|\([^()]*\)){1,120}=)"
)
_BETWEEN = re.compile(
    rf"{ARROWS.pattern}|\\q?quad(?![A-Za-z])|\t+|\s{{3,}}|&&|\s&\s(?!\s*=)|\|\||\s\|\s|\s--\s|/\\|[∧⋀]|\\(?:land|wedge)(?![A-Za-z])|<br\s*/?>"
    r"|(?<=[\w)]):\s+(?=[^\W\d]\w{0,20}\s*:=)|(?<=[\w)])\.\s(?=[A-ZА-ЯІЇЄΑ-Ω][^\W\d_]{2,20}\s)|\s(?:and|und|et|y|и|та|і|且|和|en|och|og|és|samt|serta|sekä)\s"
    rf"|(?<=[\w)])\s[ei]\s(?=\w{{1,6}}\s*=)|{_BETWEEN_BRACKETS.pattern}"
    r"|\s(?:d['’]où|donc|oraz|ve|iar|si|ja|και|dan|và|și|mentre|sowie|wobei|daher|somit|hence|thus|therefore|откуда"
    r"|отсюда|звідки|звідси|stąd|skąd|de donde|da cui)\s(?=[^=]{1,120}=)"
)
# Another equation begins after "= 0": nothing multiplies or adds to a zero.
_VANISHED = re.compile(
    r"=\s*0(?:[.,]0+)?((?:\\(?:(?:tag|label)\*?\s*\{[^{}]*\}|nonumber|notag)|\s|(?<=\s)/(?=\s))+)(?=[^\s=*/^\\]|\\(?!tag|label|no))"
)
_TURNED_OVER = r"(?:\.T\b|['ᵀ]|\^?\s*\{?\(?(?:[TТ]|\\top)\)?\}?)?"  # the transpose of a vector
_TIMES = r"\s*(?:[*·⋅×@]|\\cdot|\\times)?\s*"
_EQUALS, _ENDS = rf"\s*{_TURNED_OVER}\s*:?={{1,2}}\s*", rf"\s*{_TURNED_OVER}\s*[.,;]?\s*"
# What stands around the matrix, the unknowns and the right side of A·x = b; of x = A⁻¹·b around the unknowns, the matrix …
_BETWEEN_MATRICES = [re.compile(pattern) for pattern in (r"\s*", _TIMES, _EQUALS, _ENDS)]
_BETWEEN_INVERSE = [re.compile(pattern) for pattern in (r"\s*", _EQUALS, rf"\s*⁻¹{_TIMES}", _ENDS)]
_INVERSE = re.compile(r"(?<=\])\s*(?:\^\s*(?:[({]\s*)?-\s*1(?:\s*[)}])?|\^\s*\{\s*\(\s*-1\s*\)\s*\})")
_GROUPS = re.compile(r"\\(?:left|right)\s*[()\[\]|.]")  # around a matrix that has brackets of its own
_BLANK = re.compile(r"(?<![-+*/,\s])\s+(?![*/\s]|[-+]\s)")  # between two cells without a comma
_NEXT_LINE = re.compile(r"\.{3}[^\n]*\n?")  # in MATLAB: the row continues, or ends with a semicolon
_COMMA = re.compile(r"(?<!\\),")
LIST = re.compile(
    r"\s*(?:\w{1,20}\s*:?=\s*(?:@\([\w\s,]{0,40}\)\s*)?|[^\W\d]\w{0,20}:\s*)?([A-Za-z.]{1,20}\s*[(\[]\s*)?(?:\\left)?\s*\\?[\[{]"
)
_ENCLOSED = re.compile(r"\s*(?:\w{1,20}\s*=\s*(?=\(\s*Eq))?()\(")
# A call that solves equations for unknowns, as on a TI calculator or in Mathematica.
_SOLVED = re.compile(
    r"(?:\w{1,20}\s*:?=\s*)?[A-Za-z]{0,9}[sS]olve\s*[(\[](.+?)(?:,\s*[\[{][\w\s,]+[\]}]|(?:,\s*[^\W\d]\w{0,9})+)\s*[)\]];?"
)
_CALLED = re.compile(r"\\?[^\W\d][\w{}\\]{0,20}")
_ROW = re.compile(r"\|(.+)\||\d{1,3}\s*\|(.+)|\"?\d{1,3}\"?\s*;(.+)")  # a row of a table
_ALL_ZERO = re.compile(r"(?:[vV]_?[A-Z]\w{0,18}\s*=\s*){2,12}0\s*[.;]?")  # V_Cy = V_Dx = 0
_LONGEST = 4000
_LEADS_ON = re.compile(
    rf"(?<!\s)(?:\s{{0,9}}(?:{ARROWS.pattern})|\s{{1,9}}(?:and|und|et|и|oraz)|\\(?:text|mbox)\s*\{{\s*[^\W\d_]{{2,12}}\s*\}})\s*$"
)  # to the next piece
_MOST_ROWS, _MOST_WITHIN = 12, 3  # most rows of a matrix; most brackets around it
# sin ψ (ψ = φ3 - β), or "for the second loop (ψ = φ3 - β):"
_SAID_BESIDE = re.compile(
    r"^(.*?)(?:(?<=\s)|^)\(\s*(?:(?:with|where|mit|wobei|где|де|avec|où|con|donde)\s+)?"
    r"([^\W\d]\w{0,9}\s*=\s*(?=[^=,;]*[^\W\d])(?:[^()=,;]|\([^()=]*\)){1,80})(?:,\s[^\W\d_]{3}[^()=]{0,60})?\)\s*([.,;:]?\s*)$"
)
_FORMULA = re.compile(r"^[^=]*[*/·^][^=]*$")
_BETWEEN_DOLLARS = re.compile(r"\$\$?([^$]{3,})\$\$?")


def parts_of(line: str) -> list[str]:
    """Return the equations of one line; each piece has a sign of equality, and a piece without one joins the piece before it.

    >>> parts_of("w3 = 0,5*w1, w4 = atan2(1, w3)"), parts_of("(16) 2*w3 = w1 ⇒ w3 = w1/2")
    (['w3 = 0,5*w1', 'w4 = atan2(1, w3)'], ['(16) 2*w3 = w1', 'w3 = w1/2'])
    """
    solved = _SOLVED.fullmatch(line)
    pieces = [one.strip() for one in at_commas(solved[1].strip(" []{}"))] if solved else []
    if pieces and all("(" in piece for piece in pieces):
        return [one for piece in pieces for one in (parts_of(piece) if relates_two_sides(piece) else [f"{piece} = 0"])]
    if rows := _rows(line) or _listed(line):
        return rows
    if _ALL_ZERO.fullmatch(line):
        return [f"{name.strip()} = 0" for name in line.split("=")[:-1]]
    if len(line) > EQUATION_CHARACTERS:
        return [line]
    said = None if _BETWEEN_BRACKETS.search(line) else _SAID_BESIDE.search(line)
    if said and "$" not in line and not _FORMULA.search(said[1] + said[3].strip()):
        label = said[1] if said[1].rstrip().endswith(":") else ""
        return [*(parts_of(said[1]) if relates_two_sides(said[1]) else []), f"{label}{said[2].strip()}"]
    line = with_formulas_joined(line)
    if line.count("$") > 2 and not relates_two_sides(_BETWEEN_DOLLARS.sub(" ", line)):
        # Prose around formulas: take only the formulas that relate two sides.
        formulas = [found[1].strip() for found in _BETWEEN_DOLLARS.finditer(line)]
        return [piece for formula in formulas if relates_two_sides(formula) for piece in parts_of(formula)] or [line]
    spans: list[tuple[int, int, bool]] = []  # start and end of a piece, and whether it relates two sides
    start = 0
    for cut, after in [*_cuts(line), (len(line), len(line))]:
        if cut < start:
            continue
        relates = relates_two_sides(line[start:cut])
        if spans and not (relates and spans[-1][2]):
            start, _, before = spans.pop()
            relates = relates or before
        spans.append((start, cut, relates))
        start = after
    return [piece for begin, end, _ in spans if (piece := _LEADS_ON.sub("", line[begin:end]).strip())] or [line]


def _cuts(line: str) -> list[tuple[int, int]]:
    """Return (end of a piece, start of the next) for each possible cut."""
    found = [(found.start(), found.end()) for found in _BETWEEN.finditer(line)]
    found += [(found.start(1), found.end()) for found in _VANISHED.finditer(line)]
    for place, (sign, depth) in enumerate(zip(line, depths(line), strict=True)):
        is_decimal = sign == "," and line[place - 1 : place].isdigit() and line[place + 1 : place + 2].isdigit()
        if (
            sign in ",;，；、" and depth <= 0 and not is_decimal and line[place - 1 : place] != "\\"
        ):  # \, and \; are blanks in TeX
            found.append((place, place + 1))
    return sorted(found, key=lambda cut: (cut[0], -cut[1]))  # the longer cut first: at "= 0 and", the word is cut away too


def _rows(line: str) -> list[str]:
    """Return the equations of "[a, b; c, d]*[x; y] = [e; f]", or of "[x; y] = [a, b; c, d]^(-1)*[e; f]", by rows; else []."""
    line = _INVERSE.sub("⁻¹", _GROUPS.sub("", line)) if "[" in line and len(line) <= _LONGEST else ""
    line = line.strip(" $")
    inside = depths(line)
    edges = [k for k, (one, before) in enumerate(zip(inside, [0, *inside], strict=False)) if {one, before} == {0, 1}]
    cuts = [0, *(place + (inside[place] == 0) for place in edges), len(line)]
    pieces = [line[begin:end] for begin, end in pairwise(cuts)]
    if len(pieces) != 2 * len(_BETWEEN_MATRICES) - 1 or any(not piece.startswith("[") for piece in pieces[1::2]):
        return []
    inner = [piece[1:-1] for piece in pieces[1::2]]
    if all(map(re.Pattern[str].fullmatch, _BETWEEN_INVERSE, pieces[::2])):
        unknowns, matrix, right = inner
    elif all(map(re.Pattern[str].fullmatch, _BETWEEN_MATRICES, pieces[::2])):
        matrix, unknowns, right = inner
    else:
        return []
    return product(matrix, vector(unknowns), vector(right))


def product(matrix: str, unknowns: list[str], right: list[str]) -> list[str]:
    """Return the rows of a matrix times the unknowns as equations, [] if the sizes do not match.

    >>> product("[a, b], [c, d]", ["x", "y"], ["e", "0"]), product("a -b; c d", ["x", "y"], ["e", "0"])[0]
    (['(a)*(x) + (b)*(y) = e', '(c)*(x) + (d)*(y) = 0'], '(a)*(x) + (-b)*(y) = e')
    """
    rows_ = rows_of(matrix)
    for rows in (rows_, at_blanks(rows_)):
        if 0 < len(rows) == len(right) <= _MOST_ROWS and all(len(row) == len(unknowns) for row in rows):
            sums = (" + ".join(f"({cell})*({name})" for cell, name in zip(row, unknowns, strict=True)) for row in rows)
            return [f"{one} = {value}" for one, value in zip(sums, right, strict=True)]
    return []


def at_blanks(rows: list[list[str]]) -> list[list[str]]:
    """Return rows without commas with the cells that blanks part; any other rows as they are."""
    return [[cell for cell in at_signs(_BLANK, row[0].strip()) if cell] for row in rows] if {*map(len, rows)} == {1} else rows


def vector(content: str) -> list[str]:
    """Return the cells of a row or column vector; without commas, blanks separate the cells."""
    cells = [cell for row in rows_of(content) for cell in row]
    return [cell for cell in at_signs(_BLANK, cells[0]) if cell] if len(cells) == 1 else cells


def rows_of(content: str) -> list[list[str]]:
    """Return the rows of a matrix: nested lists, or separated by semicolons or line ends."""
    for _ in range(_MOST_WITHIN):
        rows = [row.strip() for row in at_commas(content.rstrip(" \t\n,"))]
        if not all(row.startswith("[") and row.endswith("]") for row in rows):
            rows = re.split(r"[;\n]", _NEXT_LINE.sub(" ", content))
        elif len(rows) == 1:
            content = rows[0][1:-1]
            continue
        break
    return [cells for row in rows if (cells := [one.strip() for one in at_commas(row.strip(" \t[]")) if one.strip()])]


def at_signs(sign: re.Pattern[str], text: str) -> list[str]:
    """Split a text at the matches of `sign` that are not inside brackets."""
    inside, start, pieces = depths(text), 0, list[str]()
    for found in sign.finditer(text):
        if inside[found.start()] == 0:
            pieces.append(text[start : found.start()])
            start = found.end()
    return [*pieces, text[start:]]


def _listed(line: str) -> list[str]:
    """Return the equations of a list: "solve([a = b, c = d], [x, y])", "eqs := {a = b, c = d}", "{a = b; c = d}"; [] if none."""
    found = LIST.match(line) or _ENCLOSED.match(line)
    inside = depths(line[found.end() :]) if found else []
    if found is None or -1 not in inside or max(inside) > MAX_DEPTH:
        return []
    end = found.end() + inside.index(-1)
    pieces = parts_of(line[found.end() : end].rstrip("\\ ,"))
    if len(pieces) < 2:
        return []
    behind = line[end + 1 :][:EQUATION_CHARACTERS].lstrip(" ;,")  # of a call: the unknowns
    return pieces + (parts_of(behind) if not found[1] and relates_two_sides(behind) else [])


def at_commas(row: str) -> list[str]:
    """Split a row at the commas that are not inside brackets."""
    return at_signs(_COMMA, row)


def legend_of_cells(cells: Sequence[str]) -> str:
    """Return "a ⇒ L1" for a row with a name in two cells and nothing else but numbers, which is no equation; "" for any other.

    >>> legend_of_cells(["a", "L1"]), legend_of_cells(["B2", "a", "0.07"]), legend_of_cells(["a", "b", "c"])
    ('a ⇒ L1', 'B2 ⇒ a', '')
    """
    called = [cell for cell in cells if _CALLED.fullmatch(cell)]
    is_legend = len(called) == 2 and not any(map(str.isalpha, "".join(cell for cell in cells if cell not in called)))
    return f" {ARROW} ".join(called) if is_legend else ""


def of_row(line: str) -> str:
    """Return the equations among the cells of a row with bars, or of a numbered one with semicolons; the line if there are none.

    >>> of_row("| 11 | VMy = 2*r3*w3 | C is fixed |"), of_row("11;VMy = 2*r3*w3;C is fixed"), of_row("|a| - |b| = |c|")
    ('VMy = 2*r3*w3', 'VMy = 2*r3*w3', '|a| - |b| = |c|')
    """
    if not (row := _ROW.fullmatch(line)):
        return line
    cells = [cell.strip(' `"') for cell in (row[3].split(";") if row[3] else (row[1] or row[2]).split("|"))]
    if said := legend_of_cells([cell.strip("$") for cell in cells]):
        return said
    return "; ".join(cell for cell in cells if relates_two_sides(cell.strip("="))) or line
