r"""Typst math of this program -> LaTeX, for a formula that is copied to another document.

Enters: the source of a display.  Leaves: LaTeX for `amsmath`, on one line: the other document decides where it breaks.
Used by the report's page.
"""

from __future__ import annotations

import re
from functools import lru_cache

from coursework.report.text.symbols import GREEK

_TOKEN = re.compile(r'"[^"]*"|[^\W\d_]+(?:\.[^\W\d_]+)*|\d+(?:\.\d+)?|\s+|.', re.DOTALL)
_GREEK = {letter: word for word, letter in GREEK.items()} | {"ε": "varepsilon", "φ": "varphi", "ι": "iota", "υ": "upsilon"}
# Words of Typst -> LaTeX; those in `_CALLS` have a gap (%s) for each argument.
_WORDS = {
    "dot": r"\cdot", "angle": r"\angle", "partial": r"\partial", "degree": r"^\circ", "slash": "/", "quad": r"\quad",
    "thin": r"\,", "phi": r"\varphi", "omega": r"\omega",
    **{name: rf"\{name}" for name in ("sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "ln", "exp")},
}  # fmt: skip
_CALLS = {
    "frac": r"\frac{%s}{%s}", "sqrt": r"\sqrt{%s}", "abs": r"\left|%s\right|", "dot": r"\dot{%s}", "dot.double": r"\ddot{%s}",
    "arrow": r"\vec{%s}", "underline": r"\underline{%s}", "op": r"\operatorname{%s}", "cases": r"\begin{cases}%s\end{cases}",
}  # fmt: skip
_SIGNS = {"−": "-", "·": r"\cdot", "≤": r"\le", "≥": r"\ge", "\u00a0": "~", "%": r"\%"}
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_POWER = re.compile(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
_BREAK = re.compile(r"\\ & quad |^& ")
_WORD = re.compile(r"\\[a-zA-Z]+$")


@lru_cache(maxsize=4096)
def latex(source: str) -> str:
    r"""Return the LaTeX of a display.

    >>> latex('ω_1 = -frac(r_3 ω_3 sin φ_3, r_1 sin(φ_1 - φ_2)) dot "1,5" dot 10^(-3)')
    '\\omega_1=-\\frac{r_3\\omega_3\\sin\\varphi_3}{r_1\\sin(\\varphi_1-\\varphi_2)}\\cdot1{,}5\\cdot10^{-3}'
    """
    return _Reader(_BREAK.sub(" ", source)).until()


class _Reader:
    """A reader that turns Typst tokens into LaTeX one by one."""

    def __init__(self, source: str) -> None:
        self.tokens = [token for token in _TOKEN.findall(source) if not token.isspace()] + [""]
        self.at = 0

    def take(self) -> str:
        token: str = self.tokens[self.at]
        self.at += 1
        return token

    def until(self, *ends: str) -> str:
        """Return the LaTeX of all tokens before the first of `ends`, and take that token too."""
        found = ""
        while self.tokens[self.at] not in (*ends, ""):
            piece = self.one()
            found += f" {piece}" if piece[:1].isalpha() and _WORD.search(found) else piece
        self.take()
        return found

    def one(self) -> str:
        """Return the LaTeX of the next piece: a letter, a number, a word with its arguments, an index, or a bracket."""
        token = self.take()
        if token in {"_", "^"}:
            inside = self.grouped()
            return token + (inside if len(inside) == 1 else f"{{{inside}}}")
        if token == "(":
            return f"({self.until(')')})"
        if token.startswith('"'):
            return _quoted(token[1:-1])
        if self.tokens[self.at] == "(" and token in _CALLS:
            return self.called(token)
        if token in _WORDS:
            return _WORDS[token]
        return f"\\{_GREEK[token]}" if token in _GREEK else _SIGNS.get(token, token)

    def grouped(self) -> str:
        if self.tokens[self.at] != "(":
            return self.one()
        self.take()
        return self.until(")")

    def called(self, name: str) -> str:
        self.take()
        arguments: list[str] = []
        while not arguments or self.tokens[self.at - 1] == ",":
            arguments.append(self.until(",", ")"))
        if name == "cases":
            return _CALLS[name] % r"\\".join(arguments)
        return _CALLS[name] % tuple(arguments)


def _quoted(text: str) -> str:
    """Return the LaTeX of a quoted text, which is a number with its signs, or words."""
    if any(sign.isalpha() for sign in text):
        return r"\text{" + "".join(_SIGNS.get(sign, sign) for sign in text) + "}"
    text = re.sub(r"(?<=\d),(?=\d)", "{,}", text.replace(" ", ""))
    text = _POWER.sub(lambda power: f"^{{{power[0].translate(_RAISED)}}}", text)
    return "".join(_SIGNS.get(sign, sign) for sign in text)
