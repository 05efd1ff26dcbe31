"""Formulas of the page as LaTeX, from which pandoc makes those of Word, OpenDocument and TeX.

Enters: Typst math, as the page sets it.  Leaves: LaTeX.  Used by `writer.py`.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable

from coursework.report.text.numbers import POINT
from coursework.takeaway.note.pandoc import called

_QUOTED = re.compile(r'"([^"]*)"')
_NUMBERS = re.compile(r"[\d.,+−·/()=²³⁰¹⁴⁵⁶⁷⁸⁹⁻ \u2009\u202f]+")  # numbers in quotes that need none: 1,63 + (−2) · 0,02
_RAISED = re.compile(r"[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_DIGITS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
NEXT_LINE = " \\ "
WIDE = 86  # letters that fit on a line
_UNSEEN = re.compile(r"\\(?:frac|left|right|quad|text|mathrm|overset|(?:begin|end)\{\w+\})")
_NAMES = re.compile(r"\\(?!(?:arc)?(?:sin|cos|tan))[A-Za-z]+")
_NO_LETTERS = re.compile(r"[\\{}_^&\s]")
_WORD = re.compile(r"_\{\\text\{([^{}]*?) \}\}")  # pandoc leaves a space after a subscript word
_BEGINS = re.compile(r"^= ")  # at the beginning of a line the sign would lack its left side
_OPENING, _CLOSING = "\\begin{aligned}", "\\end{aligned}"
_BRACKET = re.compile(r"(?<!\\left)(?<!\\right)(?:[()]|\\[lr]brack\b)")
# Word's writer would raise only the closing bracket, which LibreOffice then misses.
_POWER = re.compile(r"(?<!\\left)\(([^()]*(?:\([^()]*\)[^()]*)*)(?<!\\right)\)(?=\^)")
_NO_LEFT, _NO_RIGHT = " \\left. ", " \\right."
_QUAD = "\\quad"
_LEAD = re.compile(r"&?\s*(?:\\quad)*\s*[=+-]*\s*")
_DECIMAL = re.compile(r"(?<=\d)\.(?=\d)")


def latex_of(sources: Iterable[str], mark: str, *, aligned: bool) -> dict[str, str]:
    """Return LaTeX by Typst source; `mark` is the decimal sign of the language.

    A formula of several lines is `aligned`, or a column for programs that show a sign in the empty place before an equals sign.
    """
    listed = list(dict.fromkeys(sources))
    if not listed:
        return {}
    text = "\n\n".join(f"$ {_bare(one, mark)} $" for one in listed)
    tree = json.loads(called(["-f", "typst", "-t", "json"], text.encode()))
    made = [math for block in tree["blocks"] for math in _maths(block)]
    made = [_broken(_result_below(_POWER.sub(_held, _WORD.sub(r"_{\\text{\1}}", one)))) for one in made]
    if mark != POINT:
        made = [_DECIMAL.sub(f"{{{mark}}}", one) for one in made]
    return dict(zip(listed, made if aligned else map(_in_a_column, made), strict=True))


def letters_wide(latex: str) -> int:
    """Return about how many letters the widest line of a formula has; numerator and denominator of a fraction are added."""
    return max(len(_NO_LETTERS.sub("", _NAMES.sub("x", _UNSEEN.sub("", line)))) for line in latex.split("\\\\"))


def _result_below(latex: str) -> str:
    """Return a formula of several lines; if the last line is too long, its result moves to a new line below."""
    above, equals, result = latex.rpartition(" = ")
    end = "\n\\end{aligned}"
    if not (equals and latex.endswith(end) and letters_wide(latex.rpartition("\\\\")[2]) > WIDE):
        return latex
    return f"{above} \\\\\n & = {result}"


def _broken(latex: str) -> str:
    """Return a formula whose too long lines are broken before a + or −, in the outermost sum if possible."""
    body = latex.removeprefix(_OPENING).removesuffix(_CLOSING)
    if "\\begin" in body:
        return latex
    body = body if body != latex else f"& {latex}"
    lines = [_balanced(piece) for line in body.split("\\\\") for piece in _pieces(line.strip())]
    return "\n".join((_OPENING, " \\\\\n".join(lines), _CLOSING)) if len(lines) > 1 else latex


def _pieces(line: str) -> list[str]:
    """Return a line broken into lines that fit, as far as it has places to break."""
    if letters_wide(line) <= WIDE or not (places := _places(line)):
        return [line]
    least = min(depth for depth, _ in places)
    place = max(place for depth, place in places if depth == least)
    return [line[:place].rstrip(), *_pieces(f"& {_QUAD * (1 + (least > 0))} {line[place:].strip()}")]


def _held(power: re.Match[str]) -> str:
    return power[0] if "\\\\" in power[0] else f"\\left({power[1]}\\right)"


def _balanced(line: str) -> str:
    """Return a line in which every bracket whose partner is in another line gets an empty partner here."""
    opened, closed = list[re.Match[str]](), list[re.Match[str]]()
    for found in _BRACKET.finditer(line):
        if found[0] in ("(", "\\lbrack"):
            opened.append(found)
        elif opened:
            opened.pop()
        else:
            closed.append(found)
    begin = len(_LEAD.match(line)[0].rstrip("=+- ")) if closed else 0  # type: ignore[index]
    for found in sorted((*opened, *closed), key=re.Match.start, reverse=True):
        side = "\\left" if found in opened else " \\right"
        line = f"{line[: found.start()]}{side}{found[0]} {line[found.end() :]}"
    return f"{line[:begin]}{_NO_LEFT * len(closed)}{line[begin:]}{_NO_RIGHT * len(opened)}"


def _places(line: str) -> list[tuple[int, int]]:
    """Return (depth of open brackets, place) of each sign between two terms before which the line fits."""
    found, braces, brackets = list[tuple[int, int]](), 0, 0
    lead = _LEAD.match(line)
    begin = lead.end() if lead else 0
    for place, sign in enumerate(line):
        braces += (sign == "{") - (sign == "}") + line.startswith("\\left", place) - line.startswith("\\right", place)
        brackets += (sign == "(") - (sign == ")")
        before = line[:place]
        between = place > begin and line.startswith((" + ", " - "), place) and not before.endswith(("(", "="))
        if between and braces == 0 and letters_wide(before) <= WIDE:
            found.append((brackets, place))
    return found


def _in_a_column(latex: str) -> str:
    if not (latex.startswith(_OPENING) and latex.endswith(_CLOSING)):
        return latex
    lines = latex[len(_OPENING) : -len(_CLOSING)].split("\\\\")
    inside = "\\\\\n".join(_BEGINS.sub(r"\\quad\\text{=} ", line.strip().removeprefix("&").strip()) for line in lines)
    return f"\\begin{{array}}{{l}}\n{inside}\n\\end{{array}}"


def _maths(block: dict[str, object]) -> Iterable[str]:
    inlines = block.get("c")
    for one in inlines if isinstance(inlines, list) else []:
        if isinstance(one, dict) and one.get("t") == "Math":
            yield one["c"][1].strip()


def _bare(source: str, mark: str) -> str:
    """Return Typst math with plain numbers: in quotes they would be words, with spaces around them."""
    source = _QUOTED.sub(lambda found: _number(found[1], mark) if _NUMBERS.fullmatch(found[1]) else found[0], source)
    # Brackets that belong together would prevent a line break.
    return re.sub(r"([\[\]])", r"\\\1", source) if NEXT_LINE in source else source


def _number(text: str, mark: str) -> str:
    text = _RAISED.sub(lambda found: f"^({found[0].translate(_DIGITS)})", text)
    text = re.sub(rf"(?<=\d){re.escape(mark)}(?=\d)", POINT, text)
    return re.sub("[\u2009\u202f]", "", text.replace("−", "-").replace("·", " dot "))
