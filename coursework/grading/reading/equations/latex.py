r"""LaTeX as students type it -> the plain signs that equations are read in.

Enters: text with commands such as \frac, \dot, \cdot, align and &=.  Leaves: text without them; an unknown command is left as
its word, for the strict reader to refuse.  Nothing is run or expanded: there are no macros here.
Used by `lines.py` (what is one line) and `plain_text.py` (what stands in it).
"""

from __future__ import annotations

import re

from coursework.variant.formula.alphabet import greek

_COMMAND = re.compile(r"\\[A-Za-z]+")
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{[A-Za-z]+\*?\}(?:\{[lcr|]*\})?")
_LINE_END = re.compile(r"\\\\(?:\s*\[[^\]\n]{0,20}\])?")
_DELIMITERS = re.compile(r"\\[\[\]()]|\$\$?")
_DROPPED = re.compile(
    r"\\(?:left|right|[bB]ig+[lr]?|displaystyle|textstyle|limits|nonumber|notag|hfill|,|;|!|:| )"
    r"|\\(?:label|tag)\s*\*?\{[^{}]*\}|&"
)
_SPACE = re.compile(r"\\q?quad(?![A-Za-z])|~")
_UPRIGHT = re.compile(r"\\(?:text|mathrm|mathit|mathsf|operatorname|textit|textrm|rm|mathbf|boldsymbol|vec)\s*\{([^{}]*)\}")
_SIGNS = {"\\cdot": "*", "\\times": "*", "\\ast": "*", "\\div": "/", "\\pi": "pi", "\\omega": "ω", "\\varphi": "φ",
          "\\vartheta": "θ", "\\varepsilon": "ε", "\\epsilon": "ε", "\\lambda": "λ", "\\prime": "'"}  # fmt: skip
_MOST = 200  # fractions and dots in one line


def logical_lines(text: str) -> list[tuple[int, str]]:
    r"""Return the lines with their numbers (from 1); between \begin and \end a line ends at \\ and not where the text breaks.

    >>> logical_lines("\\begin{align}\na &= b\n + c \\\\\nd &= e\n\\end{align}\nf = g")
    [(2, 'a &= b + c'), (4, 'd &= e'), (6, 'f = g')]
    """
    if "\\" not in text:
        return list(enumerate(text.split("\n"), start=1))
    lines: list[tuple[int, str]] = []
    inside, first, kept = False, 0, ""
    for number, line in enumerate(text.split("\n"), start=1):
        opens, closes = "\\begin" in line, "\\end" in line
        pieces = [_DELIMITERS.sub(" ", piece) for piece in _LINE_END.split(_ENVIRONMENT.sub(" ", line))]
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


def without_latex(text: str) -> str:
    r"""Return one line without commands.

    >>> without_latex(r"\dot{\varphi}_3 &= \frac{V_{My}}{r_3\left(2\cos\varphi_3 + \sin\varphi_3\right)} \tag{16}").split()
    ['φ̇_3', '=', '((V_{My})/(r_3(2', 'cos', 'φ_3', '+', 'sin', 'φ_3)))']
    """
    if "\\" not in text:
        return text.replace("&", " ") if "&=" in text else text
    text = _SPACE.sub(" ", _DROPPED.sub("", text))
    text = _UPRIGHT.sub(r"{\1}", text)
    text = _COMMAND.sub(lambda found: _sign(found[0]), text)
    for name in ("frac", "dfrac", "tfrac", "cfrac"):
        text = _fractions(text, f"\\{name}")
    for _ in range(_MOST):
        dotted = re.sub(r"\\dot\s*(?:\{\s*(\w)([^{}]*)\}|(\w))", lambda m: f" {m[1] or m[3]}\u0307{m[2] or ''}", text, count=1)
        if dotted == text:
            break
        text = dotted
    return re.sub(r"\\([A-Za-z]+)", r" \1 ", text)


def _sign(command: str) -> str:
    """Return the sign or the Greek letter of a command, apart from what stands before it; any other command as it stands."""
    sign = _SIGNS.get(command) or greek(command[1:])
    return f" {sign}" if sign != command[1:] else command


def _fractions(text: str, command: str) -> str:
    for _ in range(_MOST):
        start = text.find(command)
        if start < 0:
            return text
        above, place = _argument(text, start + len(command))
        below, end = _argument(text, place)
        text = f"{text[:start]}(({above})/({below})){text[end:]}"
    return text


def _argument(text: str, place: int) -> tuple[str, int]:
    """Return what a command takes at a place, a group in braces or one sign, and where the text goes on."""
    while place < len(text) and text[place].isspace():
        place += 1
    if text[place : place + 1] != "{":
        return text[place : place + 1], place + 1
    depth = 0
    for end in range(place, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if not depth:
            return text[place + 1 : end], end + 1
    return text[place + 1 :], len(text)
