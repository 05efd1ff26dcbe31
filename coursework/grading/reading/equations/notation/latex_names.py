r"""Commands that a text defines itself, \newcommand{\om}[1]{\omega_{#1}} -> the text with their meanings in place.

Enters: LaTeX, or Mathematica's names of Greek letters.  Leaves: the text without such commands, of limited size.
Used by `latex.py` and `markdown.py`.
"""

from __future__ import annotations

import re
from functools import partial

_BODY = r"\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\}){0,20}\}){0,200})\}"
_COMMAND = re.compile(
    rf"\\(?:(?:re)?newcommand|providecommand|DeclareMathOperator)\*?\s*+\{{?\s*+\\([A-Za-z]{{1,20}})\s*+\}}?\s*+(?:\[([1-3])\])?\s*+{_BODY}"
    rf"|\\def\s*+\\([A-Za-z]{{1,20}})\s*+((?:#[1-3]){{0,3}})\s*+{_BODY}"
)
# Of the packages physics, mathtools and empheq: a matrix, brackets, a vector, words between the rows, a system after a brace.
_OF_PACKAGES = (
    (
        re.compile(
            r"\\[pbvs]?(?:mqty|matrixquantity)\*?\s*([(\[{])((?:[^()\[\]{}]|[({\[][^()\[\]{}]{0,200}[)}\]]){0,2000})[)\]}]"
        ),
        r"\\begin{pmatrix}\2\\end{pmatrix}",
    ),
    (re.compile(r"\\qty\s*(?=[(\[{])|\\(?:begin|end)\{(?:subequations|empheq)\}(?:\[[^\[\]]{0,60}\])?(?!\{)"), ""),
    (re.compile(r"\\begin\{empheq\}(?:\[[^\[\]]{0,60}\])?\{(\w{1,12}\*?)\}"), r"\\begin{\1}"),
    (re.compile(r"\\v[bau]\*?\s*(?=\{)"), r"\\vec"),
    (re.compile(r"\\(?:short)?intertext\s*\{[^{}]{0,200}\}"), r"\\\\ "),
    (
        re.compile(r"\\binom\s*\{((?:[^{}]|\{[^{}]{0,60}\}){0,200})\}\s*\{((?:[^{}]|\{[^{}]{0,60}\}){0,200})\}"),
        r"\\begin{pmatrix}\1\\\\ \2\\end{pmatrix}",
    ),
)
_ARGUMENT, _LONGEST = r"\s*(?:\{([^{}]{0,80})\}|([^\s\\{}]))", 80
_ELL = re.compile(r"\\ell(?![A-Za-z])")  # is typed for a length l
_LETTER = re.compile(r"\\\[(?:Curly|Capital|Script)?([A-Z][a-z]{1,10})\]")  # a Greek letter in Mathematica: \[CurlyPhi]
_MOST_NAMES, _MOST_CHARACTERS, _WITHIN = 40, 200_000, 3  # the last limits how deeply names are nested


def with_own_commands(text: str) -> str:
    r"""Return a text with its own commands replaced by their meanings, and without their definitions.

    >>> with_own_commands(r"\newcommand{\om}[1]{\omega_{#1}}\def\p{\varphi} \om3 \sin\p_3, \om{2} \[Omega]4")
    ' \\omega_{3} \\sin\\varphi _3, \\omega_{2} Omega4'
    """
    text = _ELL.sub(" l ", _LETTER.sub(lambda found: found[1], text))
    for pattern, meant in _OF_PACKAGES:
        text = pattern.sub(meant, text)
    names = {found[1] or found[4]: found for found in _COMMAND.finditer(text)}
    if not names or len(names) > _MOST_NAMES:
        return text
    text = _COMMAND.sub(lambda found: "\n" * found[0].count("\n"), text)
    for _ in range(_WITHIN):
        before = text
        for name, found in names.items():
            count, body = (int(found[2] or 0), found[3]) if found[1] else (len(found[5]) // 2, found[6])
            if len(text) + text.count(f"\\{name}") * (len(body) + _LONGEST * body.count("#")) > _MOST_CHARACTERS:
                return text
            text = re.sub(rf"\\{name}(?![A-Za-z]){_ARGUMENT * count}", partial(_put, body), text)
        if text == before:
            break
    return text


def _put(body: str, used: re.Match[str]) -> str:
    """Return the meaning of a command with its arguments; a blank keeps a final letter apart from a letter that follows."""
    groups = used.groups()
    for place in range(len(groups) // 2):
        given = groups[2 * place]
        body = body.replace(f"#{place + 1}", groups[2 * place + 1] if given is None else given)
    body = " ".join(body.split("\n"))
    return f"{body} " if body[-1:].isalpha() else body
