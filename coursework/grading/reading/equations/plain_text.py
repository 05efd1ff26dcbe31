"""What stands round an equation or in it for people and programs -> a line without it.

Enters: one line as typed.  Leaves: the line without its label, and with LaTeX, prefixes of programs, fractions of one sign and
derivatives in the words of the variant.  Used by `equations.py` and `repair.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.latex import without_latex
from coursework.grading.reading.equations.names_in_text import Spellings

_WORD = r"(?:equation|eqn?|gleichung|gl|уравнение|ур|рівняння|рівн|ф-ла|формула|formula|方程|式|№|no)"
_LABEL = re.compile(
    rf"[\s$]*(?:[*•‣▪]\s+)?(?:{_WORD}[\s.№]*\(?\d{{1,3}}[a-zа-я]?\)?\s*[:.)]?(?!=)(?=\s|\w|[-+−(])"
    r"|[(\[]\d{1,3}[a-zа-я]?[)\]]\s*[:.]?(?!=)|\d{1,3}[)]\s*|\d{1,3}[.:](?=\s)(?!=)|(?<=[•‣▪]\s))\s*",
    re.IGNORECASE,
)
_LABEL_AT_END = re.compile(r"\s[(\[]\d{1,3}[a-zа-я]?[)\]]\s*$", re.IGNORECASE)
_PREFIX = re.compile(r"\b(?:np|numpy|math|Math|cmath|sp|sympy|tf|jnp)\.(?=[A-Za-z])")
_FRACTIONS = {"½": "(1/2)", "¼": "(1/4)", "¾": "(3/4)", "⅓": "(1/3)", "⅔": "(2/3)"}
_NAME = r"([^\W\d](?:\w|\{\w*\})*)"
_DERIVATIVES = (
    re.compile(rf"\(\(\s*d\s*{_NAME}\s*\)\s*/\s*\(\s*d\s*t\s*\)\)"),  # as \frac leaves it
    re.compile(rf"\bd\s*\(\s*{_NAME}\s*\)\s*/\s*d\s*t\b"),
    re.compile(rf"\bd\s*/\s*d\s*t\s*\(?\s*{_NAME}\s*\)?"),
    re.compile(rf"\bd[\s_]*{_NAME}\s*/\s*d\s*t\b"),
    re.compile(rf"{_NAME}\s*['′’]"),
    re.compile(r"([^\W\d]\u0307(?:\w|\{\w*\})*)"),
    re.compile(r"\b([^\W\d]\w*?)_?dot\b"),
)


def label_of(text: str) -> str:
    """Return the label at the beginning of a line, "" where there is none.

    >>> [label_of(text) for text in ("(16) -0.5*r3", "16) -", "[16] -", "Eq. 3: w1", "(1): w1", "2*w1 = 0", "(2*r1 + 1)*w1")]
    ['(16) ', '16) ', '[16] ', 'Eq. 3: ', '(1): ', '', '']
    """
    found = _LABEL.match(text)
    return found[0] if found and len(found[0]) < len(text) else ""


def without_labels(text: str) -> str:
    """Return a line without its label and its number at the end."""
    text = text[len(label_of(text)) :]
    found = _LABEL_AT_END.search(text)
    return text[: found.start()] if found and "=" in text[: found.start()] else text


def plain(text: str, spellings: Spellings) -> str:
    """Return a line without LaTeX and prefixes of programs, with names of rates for derivatives."""
    text = _PREFIX.sub("", without_latex(text))
    for sign, fraction in _FRACTIONS.items():
        text = text.replace(sign, fraction)
    for pattern in _DERIVATIVES:
        text = pattern.sub(lambda found: _rate(found, spellings), text)
    return text


def _rate(found: re.Match[str], spellings: Spellings) -> str:
    """Return the name of the rate of a coordinate, what stood there where it is none."""
    name = spellings.canonical(re.sub("[{}\u0307]", "", found[1]))
    return f" {spellings.rates[name]} " if name in spellings.rates else found[0]
