r"""StarMath, the language in which LibreOffice's formulas are typed -> text on one line.

Enters: text such as "{V_My} over {r_3 left( 2 cos %phi_3 right)} = %omega_3".  Leaves: text.
The size is limited; open groups are kept in a list, without recursion.  Used by `mathml.py`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from coursework.grading.reading.documents.formulas.formula_text import dotted, fraction, index, on_one_line, power, root
from coursework.variant.formula.alphabet import greek

_MOST_CHARACTERS, _DEEPEST = 8000, 60
_TOKEN = re.compile(r"\"[^\"]*\"|%[A-Za-z]+|[A-Za-z]+|[0-9]+(?:[.,][0-9]+)?|\s+|.", re.DOTALL)
_DROPPED = {
    "left", "right", "nitalic", "ital", "italic", "bold", "nbold", "alignl", "alignc", "alignr", "none", "func", "size", "color",
    "vec", "bar", "overline", "hat", "displaystyle", "phantom", "~", "`", "lvert", "widevec",
}  # fmt: skip
_SIGNS = {"cdot": " * ", "times": " * ", "ast": " * ", "div": "/", "minus": "-", "plus": "+", "lbrace": "", "rbrace": "",
          "lbrack": "(", "rbrack": ")", "varphi": "φ", "omega": "ω", "vartheta": "θ", "epsilon": "ε",
          "varepsilon": "ε", "lambda": "λ", "infinity": "∞", "pi": "pi", "[": "(", "]": ")", "over": ""}  # fmt: skip


@dataclass(slots=True)
class _Group:
    """The contents of a pair of braces; `waiting` are the operations to apply to the next part, the innermost last."""

    parts: list[str] = field(default_factory=list)
    waiting: list[str] = field(default_factory=list)
    rows: list[str] = field(default_factory=list)


def text_of_starmath(text: str) -> str:
    """Return a formula as text, with one line per row.

    >>> text_of_starmath("%omega_3 = {V_{My}} over {r_3 (2 cos %phi_3)}").split()
    ['ω_3', '=', '((V_{My})/(r_3', '(2', 'cos', 'φ_3', ')))']
    """
    groups = [_Group()]
    for found in _TOKEN.finditer(text[:_MOST_CHARACTERS]):
        token = found[0]
        group = groups[-1]
        if token == "{":
            if len(groups) > _DEEPEST:
                return "…"
            groups.append(_Group())
        elif token == "}":
            if len(groups) > 1:
                _add(groups[-2], _whole(groups.pop()))
        elif token in {"_", "^", "over", "sqrt", "dot", "sup", "sub", "rsub", "rsup"}:
            group.waiting.append({"sub": "_", "rsub": "_", "sup": "^", "rsup": "^"}.get(token, token))
        elif token in {"newline", "#"}:
            group.rows.append("".join(group.parts))
            group.parts, group.waiting = [], []
        elif token.isspace():
            if group.parts and not group.waiting:
                group.parts.append(" ")
        elif token not in _DROPPED and token not in {"stack", "matrix", "binom"}:
            _add(group, _plain(token))
    while len(groups) > 1:  # braces that are never closed
        _add(groups[-2], _whole(groups.pop()))
    whole = _whole(groups[0])
    return whole if len(text) <= _MOST_CHARACTERS else f"{whole}…"


def _plain(token: str) -> str:
    if token.startswith('"'):
        return token.strip('"')
    if token.startswith("%"):
        return _SIGNS.get(token[1:].lower()) or greek(token[1:].lower())
    return _SIGNS.get(token.lower(), token)


def _whole(group: _Group) -> str:
    text = "".join(group.parts)
    return "\n".join([*group.rows, text]) if group.rows else text


def _add(group: _Group, part: str) -> None:
    """Add a part after applying the waiting operations to it."""
    while group.waiting:
        what = group.waiting.pop()
        if what == "sqrt":
            part = root(part, "")
        elif what == "dot":
            part = dotted(part)
        else:
            before = _taken(group)
            part = {"_": index, "^": power}.get(what, fraction)(before, on_one_line(part))
    group.parts.append(part)


def _taken(group: _Group) -> str:
    """Remove and return the part before, without the blanks after it."""
    while group.parts and not group.parts[-1].strip():
        group.parts.pop()
    return group.parts.pop() if group.parts else ""
