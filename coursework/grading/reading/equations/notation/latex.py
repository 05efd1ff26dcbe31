r"""LaTeX as students type it -> the plain signs in which equations are read.

Enters: text with commands such as \frac, \dot, \cdot, align and &=.  Leaves: text without them; an unknown command is left as
its word, for the strict reader to refuse.  Nothing is run; what a text itself calls by a short name is put in its place.
Used by `text_lines.py` (what is one line), `plain_text.py` (what stands in it) and, for a formula or matrix of others,
`markdown.py`, `parts.py`, `matrices.py` and `formula_text.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache

from coursework.grading.reading.equations.notation.latex_names import with_own_commands
from coursework.grading.reading.equations.notation.signs import ARROW, relates_two_sides
from coursework.variant.formula.alphabet import greek

_BETWEEN = re.compile(r"(?<!\$)\s*\$\s*(?:-(?=-))?([-+–−])\s*\$\s*(?!\$)")
_COMMAND = re.compile(r"\\[A-Za-z]+")
ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{[A-Za-z]+\*?\}(?:\[[tbc]\])?(?:\{[lcrLCR|@\d\s]*(?:\{[^{}]*\}[lcrLCR|@\s]*)*\})?")
_MATRIX = re.compile(
    r"(\\left\s*\|\s*|\\det\s*)?\\begin\s*\{((?:[pbvBV]|small)?matrix|array)\}(?:\[[tbc]\])?(?:\{[lcr|@\s]*\})?(.{0,4000}?)\\end\s*\{\2\}(?(1)\s*(?:\\right\s*\|)?)",
    re.DOTALL,
)
LINE_END = re.compile(r"\\(?:\\\*?(?:\s*\[[^\]\n]{0,20}\])?|newline|tabularnewline|cr(?![A-Za-z]))")
_SYSTEM = re.compile(r"\\(systeme|cases)\*?(?:\[[^\[\]]{0,30}\])?\s*(?=\{)")  # \systeme{a = b, c = d}, \cases{a = b\cr c = d}
_PREAMBLE = re.compile(r"\A.*?\\begin\s*\{document\}", re.DOTALL)
_OPENS, _CLOSES = re.compile(r"\\begin|(?<!\\)\\\["), re.compile(r"\\end|(?<!\\)\\\]")
_REMARK = re.compile(r"(?<!\\)%.*")
_DELIMITERS = re.compile(r"\\[\[\]()]|\$\$?")
_INLINE = re.compile(r"(?<!\\)\\\(((?:[^\\]|\\(?![()]))++)\\\)|(?<![$\\])\$([^$]+)\$(?!\$)")  # a formula within a line of prose
_WORD, _SIGNS_OF_FORMULA = re.compile(r"[^\W\d_]{2,}"), re.compile(r"[=+*^\\]|\s[-−/]\s")
_DROPPED = re.compile(
    r"\\(?:left|right)\s*(?:\\[{}|]|\.)"
    r"|\\(?:left|right|[bB]ig+[lrm]?|displaystyle|textstyle|limits|nonumber|notag|hfill|noindent)(?![A-Za-z])|\\[,;!: ]"
    r"|\\(?:label|tag|hspace|vspace|[hv]?phantom|intertext|ref|eqref)\s*\*?\{[^{}]*\}"
    r"|\\(?:text|textrm|mbox|hbox)\s*\{\s*\([^{}=]{0,40}\)\s*\}|\\eqno\s*\([^()]*\)|&"
)
_ALIGNED = re.compile(r"&\s*=|=\s*&")
_BOXED = re.compile(r"^\s*\\(?:boxed|fbox)\s*\{(.*)\}([^{}]*)$")
_INDEX = re.compile(r"(?<=_\d)(?=[A-Za-z])")  # \omega_3s_3 is a product: without braces an index is one sign
_PRIME, _POWER = re.compile(r"\^\s*\{?\s*(?:\\prime(?![A-Za-z])|')\s*\}?"), re.compile(r"\^\s*\{\s*(-?\d)\s*\}")
_EMPTY = re.compile(r"\{\s*\}")  # {} around a sign or behind a command
_COLOUR = re.compile(r"\\(?:text|row|cell)?color(?:box)?\s*(?:\[[^\[\]]{0,20}\])?\s*\{[^{}]{0,40}\}(?=\s*(\{)?)")
_OF_ONE_LETTER = re.compile(r"\\(?:mathrm|mathit|mathsf|text|rm|it|operatorname)\s+([A-Za-z])(?![A-Za-z])")  # \mathrm d
_BRACED = re.compile(r"\\(?:under|over)(?:brace|bracket)\s*(?=\{)")  # marks a part, with a remark below or above
_REMARK_AT = re.compile(r"\s*[_^]\s*\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|\s*[_^]\s*\w")
_DOTTED_GROUP = re.compile(r"\{\s*(\\dot\s*(?:\{[^{}]{1,20}\}|\\?[A-Za-z]+))\s*\}")  # {\dot\varphi}_3
_IN_BRACES = re.compile(r"(?<![A-Za-z])\{\s*([-+=]|\\[a-z]+(?=\s*\}\s*_))\s*\}")  # {=} and {\omega}_3
_OVER = re.compile(r"\{([^{}]{0,200})\\over(?![A-Za-z])([^{}]{0,200})\}")
_UNIT = re.compile(r"\\(?:si|unit)\s*(?:\[[^\[\]]{0,40}\])?\{([^{}]{1,60})\}")
_SET_OVER = re.compile(r"\\(?:overset|stackrel|underset)\s*\{[^{}]{0,20}\}\s*\{([^{}]{0,20})\}")  # a mark at a sign
_UNITS = {"\\radian": "rad", "\\second": "s", "\\meter": "m", "\\metre": "m", "\\per": "/", "\\degree": "°"}
_SPACE = re.compile(r"\\q?quad(?![A-Za-z])|~")
_UPRIGHT = re.compile(
    r"\\(?:text|mathrm|mathbin|mathrel|mathord|mathit|mathsf|mathnormal|mathop|operatorname\*?|textit|textrm|textbf|rm|mathbf|boldsymbol|bm|mbox|hbox|vec"
    r"|overline|underline|bar|hat|ensuremath|num|ang)\s*\{([^{}]*)\}"
)
_SIGNS = {"\\cdot": "*", "\\times": "*", "\\ast": "*", "\\div": "/", "\\pi": "pi", "\\omega": "ω", "\\varphi": "φ",
          "\\vartheta": "θ", "\\varepsilon": "ε", "\\epsilon": "ε", "\\lambda": "λ", "\\prime": "'", "\\bullet": "*",
          "\\lbrace": "{", "\\rbrace": "}", "\\lbrack": "[", "\\rbrack": "]", "\\lvert": "|", "\\rvert": "|",
          **dict.fromkeys(("\\equiv", "\\approx", "\\simeq", "\\cong", "\\doteq", "\\coloneqq", "\\triangleq"), "="),
          **dict.fromkeys(("\\Rightarrow", "\\Longrightarrow", "\\implies", "\\rightarrow", "\\longrightarrow", "\\to",
                           "\\Leftrightarrow", "\\iff", "\\therefore", "\\leadsto"), ARROW)}  # fmt: skip
# A derivative of the packages physics, derivative and diffcoeff: \dv{\varphi_3}{t}, \dv[1]{t}\varphi_3.
_DERIVATIVE = re.compile(r"\\(?:o?dv|pdv|derivative|diff)(?![A-Za-z])\*?\s*(?:\[1\])?(?=\s*\{)")
_FRACTION = re.compile(r"\\(?:[dtcs]|nice)?frac")
_DOT = re.compile(r"\\dot\s*(?:\{\s*(\w)([^{}]*)\}|(\w))")
_DECIMAL = re.compile(r"(?<=\d)(?:,|\{,\})(?=\d)")
_MOST, _LONGEST = 200, 2000  # fractions in one line, environments in a text; characters of an argument

_ASCIIDOC = re.compile(r"\b(?:latexmath|asciimath|stem):\[(.*)\]")
_SIZES = (2, 3)


def logical_lines(text: str) -> list[tuple[int, str]]:
    r"""Return (number from 1, line) of the logical lines; between \begin and \end only \\ ends a line, a line break does not.

    >>> logical_lines("\\begin{align}\na &= b\n + c \\\\\nd &= e\n\\end{align}\nf = g")
    [(2, 'a &= b + c'), (4, 'd &= e'), (6, 'f = g')]
    >>> logical_lines("\\documentclass{article}\\begin{document}\nSo\n\\begin{align}\na &= b\n\\end{align}\n\\end{document}")
    [(2, 'So'), (4, 'a &= b')]
    """
    text = _ASCIIDOC.sub(r"\1", text)
    if "\\" not in text:
        return list(enumerate(text.split("\n"), start=1))
    text = with_own_commands(text)
    text = _PREAMBLE.sub(lambda found: "\n" * found[0].count("\n"), text).replace("\\end{document}", "")  # prose of a document
    text = _worked_out(_SYSTEM, _system, _worked_out(_BRACED, _unbraced, text))
    text = matrices_in_one_piece(text)
    lines: list[tuple[int, str]] = []
    inside, first, kept = False, 0, ""
    for number, line in enumerate((_REMARK.sub("", line) for line in text.split("\n")), start=1):
        opens, closes = _OPENS.search(line) is not None, _CLOSES.search(line) is not None
        if line.count("$$") == 1:
            opens, closes = not inside, inside
        line = line if inside or opens else _of_sentence(line)
        pieces = [_DELIMITERS.sub(" ", piece) for piece in LINE_END.split(ENVIRONMENT.sub(" ", line))]
        for place, piece in enumerate(pieces):
            if place or not (inside and kept):
                if kept.strip():
                    lines.append((first, kept))
                first, kept = number, ""
            kept = f"{kept} {piece.strip()}".strip()
        inside = (inside or opens) and not closes
        if not inside and kept:
            lines.append((first, kept))
            kept = ""
    return [*lines, (first, kept)] if kept.strip() else lines


def _of_sentence(line: str) -> str:
    r"""Return the formulas of a sentence that relate two sides, if words stand behind one of them; any other line as it is.

    >>> _of_sentence(r"so \(a = b\) and $c = d$, where $c$ is known"), _of_sentence(r"for $C$: $a = b$ (3)")
    ('a = b; c = d', 'for $C$: $a = b$ (3)')
    """
    found = [*_INLINE.finditer(line)]
    formulas = [one for one in found if relates_two_sides(one[1] or one[2])]
    outside = _INLINE.sub(" ", line)
    if not formulas or not _WORD.search(_INLINE.sub(" ", line[formulas[0].end() :])) or _SIGNS_OF_FORMULA.search(outside):
        return line
    return "; ".join((one[1] or one[2]).strip() for one in formulas)


def with_formulas_joined(line: str) -> str:
    """Return a line in which formulas with only a sign between them are one, $a$ -- $b$."""
    return _BETWEEN.sub(r" \1 ", line) if line.count("$") > 2 else line


def matrices_in_one_piece(text: str) -> str:
    r"""Return the text with each matrix in one piece: [a, b; c, d] for \begin{pmatrix}a & b \\ c & d…"""
    return _MATRIX.sub(_as_matrix, text) if text.count("\\begin") < _MOST else text


def _as_matrix(found: re.Match[str]) -> str:
    r"""Return a matrix in one piece, "[a, b; c, d]" as in MATLAB; leave an array of equations (after a brace) unchanged."""
    if "=" in found[3]:
        return found[0]
    rows = [row.split("&") for row in LINE_END.split(found[3].replace("\n", " ")) if row.strip()]
    sum_ = determinant(rows) if found[1] or found[2] == "vmatrix" else ""
    return (sum_ or (found[1] or "") + in_one_piece(rows)) + "\n" * found[0].count("\n")


def in_one_piece(rows: Iterable[Iterable[str]]) -> str:
    """Return a matrix as MATLAB writes it.

    >>> in_one_piece([["a", " 0,5 "], ["c", "d"]])
    ' [a, 0.5; c, d] '
    """
    written = (", ".join(_DECIMAL.sub(".", cell.strip()) for cell in row) for row in rows)
    return f" [{'; '.join(row for row in written if row.strip())}] "


@lru_cache(1024)  # several readers look at the same line in turn
def without_latex(text: str) -> str:
    r"""Return a line with its LaTeX commands replaced by plain signs.

    >>> without_latex(r"\dot{\varphi}_3 &= \frac{V_{My}}{r_3\left(2\cos\varphi_3 + \sin\varphi_3\right)} \tag{16}").split()
    ['φ̇_3', '=', '((V_{My})/(r_3', '(2', 'cos', 'φ_3', '+', 'sin', 'φ_3', ')))']
    """
    if "\\" not in text:
        return text.replace("&", " ") if _ALIGNED.search(text) else text
    text = _INDEX.sub(" ", _SET_OVER.sub(r" \1 ", text) if "{=}" in text else text)
    text = _OVER.sub(r"((\1)/(\2))", _IN_BRACES.sub(r" \1 ", text))
    text = _OF_ONE_LETTER.sub(
        r" \1 ", _COLOUR.sub(lambda found: "\\boxed" if found[1] else "", _EMPTY.sub(" ", _UNIT.sub(_unit, text)))
    )
    text = _DOTTED_GROUP.sub(r"\1", _worked_out(_BRACED, _unbraced, text)) if "brace" in text or "{\\dot" in text else text
    text = _PRIME.sub("'", _POWER.sub(r"^\1 ", text))
    text = _SPACE.sub(" ", _DROPPED.sub(" ", _BOXED.sub(r"\1\2", text)))
    text = _UPRIGHT.sub(_upright, text.replace("{,}", ","))
    text = _COMMAND.sub(lambda found: _sign(found[0]), text)
    text = _worked_out(_FRACTION, _fraction, _worked_out(_DERIVATIVE, _derivative, text))
    while (dotted := _DOT.sub(lambda m: f" {m[1] or m[3]}\u0307{m[2] or ''}", text)) != text:
        text = dotted
    return re.sub(r"\\([A-Za-z]+)", r" \1 ", text)


def _unit(found: re.Match[str]) -> str:
    r"""Return a unit of siunitx in brackets, [1/s] for \per\second."""
    unit = "".join(_UNITS.get(command, command) for command in re.findall(r"\\[A-Za-z]+|[^\\]+", found[1])).replace(" ", "")
    return f" [{'1' if unit.startswith('/') else ''}{unit}]"


def _worked_out(command: re.Pattern[str], meaning: Callable[[str, int], tuple[str, int]], text: str) -> str:
    """Return a text with each command as its `meaning`, which is told the place of the arguments and tells where they end."""
    for _ in range(_MOST):
        if (found := command.search(text)) is None:
            break
        said, end = meaning(text, found.end())
        text = text[: found.start()] + said + text[end:]
    return text


def _unbraced(text: str, place: int) -> tuple[str, int]:
    """Return what stands in a brace drawn below or above it, without the remark at the brace."""
    inner, end = _argument(text, place)
    remark = _REMARK_AT.match(text, end)
    is_matrix = inner.strip().startswith("\\begin") and inner.count("\\end") == 1
    return inner if is_matrix else f"({inner})", remark.end() if remark else end


def _system(text: str, place: int) -> tuple[str, int]:
    """Return the equations that a command encloses, as lines of an environment."""
    inner, end = _argument(text, place)
    said = inner if LINE_END.search(inner) else _DECIMAL.sub(".", inner).replace(",", r"\\")
    return rf"\begin{{cases}}{said}\end{{cases}}", end


def _upright(found: re.Match[str]) -> str:
    """Return the content of a font command: a name stays in one piece, words are separated from what follows."""
    inner = found[1].strip()
    if not re.fullmatch(r"[\w\\^']*", inner):
        return f" {inner} "
    return f"{{{inner}}}" if found.string[: found.start()].rstrip().endswith(("_", "^")) else inner


def _sign(command: str) -> str:
    """Return the sign or Greek letter of a command, with a blank before it; leave any other command unchanged."""
    sign = _SIGNS.get(command) or greek(command[1:])
    return f" {sign}" if sign != command[1:] else command


def _fraction(text: str, place: int) -> tuple[str, int]:
    above, place = _argument(text, place)
    below, end = _argument(text, place)
    return f"(({above})/({below}))", end


def _derivative(text: str, place: int) -> tuple[str, int]:
    r"""Return a derivative of packages as a fraction: ((d φ_3)/(d t)) for \dv{φ_3}{t}, ((d)/(d t)) for \dv{t}."""
    above, end = _argument(text, place)
    if not text[end:].lstrip().startswith("{"):
        return f"((d)/(d {above}))", end
    below, end = _argument(text, end)
    return f"((d {above})/(d {below}))", end


def _argument(text: str, place: int) -> tuple[str, int]:
    """Return the argument of a command at a place (a group in braces or one character) and the place behind it."""
    while place < len(text) and text[place].isspace():
        place += 1
    if text[place : place + 1] != "{":
        return text[place : place + 1], place + 1
    depth = 0
    most = min(len(text), place + _LONGEST)
    for end in range(place, most):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if not depth:
            return text[place + 1 : end], end + 1
    return text[place + 1 : most], most


def determinant(rows: Sequence[Sequence[str]]) -> str:
    """Return a determinant as a sum, "" if it is not square or has more rows than one writes out.

    >>> determinant([["a", "b"], ["c", "d + e"]]), determinant([["a", "b"]])
    ('((a)*(d + e) - (b)*(c))', '')
    """
    if len(rows) not in _SIZES or any(len(row) != len(rows) for row in rows):
        return ""
    if len(rows) == _SIZES[0]:
        (a, b), (c, d) = rows
        return f"(({a})*({d}) - ({b})*({c}))"
    first, *others = rows
    minors = (determinant([[*row[:column], *row[column + 1 :]] for row in others]) for column in range(3))
    return (
        "(" + "".join(f" {'+-'[k % 2]} ({cell})*{minor}" for k, (cell, minor) in enumerate(zip(first, minors, strict=True))) + ")"
    )
