"""A line -> the same line without words, marks and letters at its edges, which may be a remark although they could be factors.

Enters: a line, a test for single names.  Leaves: shorter lines, each with whether a person must say that it is meant.
Used by `equations.py`.  Such a reading counts only if it is right, so nothing is lost; what changes an equation is never cut.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import islice

from coursework.grading.reading.equations.formulas.labels import CHANGES
from coursework.grading.reading.equations.notation.signs import depths
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.variant.formula.reader import FUNCTION_WORDS

_WORD = r"[^\W\d_]{1,20}(?:['’-][^\W\d_]{1,20})?"
_FIRST = re.compile(rf"\s*(?:({_WORD})[.,:;!]{{0,3}}(?=\s)|([^\w\s(\[{{$\\+\-−–—*/=^'’]{{1,3}})|([*•+]\)))\s*")
_LAST = re.compile(
    rf"(?:(?<=[\s)\]}}])({_WORD})[.,:;!]{{0,3}}|(?<=\s)(?:\([^()]{{1,60}}\)|\[[^\[\]]{{1,60}}\]|\{{[^{{}}]{{1,40}}\}}|<[^<>]{{1,20}}>)[.,;]?"
    r"|(?<=\s(?:in|en)\s)[^\W\d_]{1,3}(?:/[^\W\d_]{1,2}|⁻¹)?[.,;]?|(?<=\s)\d{1,3}[.)]?|(?<=[\s)\]}])[^\w\s()\[\]{}+\-−–*/=^<>'’]{1,9}|(?<=[\s(])\w\s?=\s?[\d.,]{1,8}|=\s*(?:\.{2,9}|…|\?))\s*$"
)
_WRAPPED = re.compile(
    r"^([^=]{0,40}?[:.)\-–•]\s+|\s*)(?:\*\*([^*].*=.*[^*])\*\*|_([^_].*=.*[^_])_|~([^~].*=.*[^~])~|<([^<>]*=[^<>]*)>|\((.*=.*)\)|\{(.*=.*)\}|\[(.*=.*)\])\s*[.,;]?\s*$"
)
_DENIED = re.compile(
    r"\b(?:not?|never|nicht|keine?|false|wrong|falsch|instead|statt|нет|не|вместо|неверно|pas|faux)\b|[不非错]", re.I
)
_GREEK = re.compile(r"phi|psi|alpha|beta|gamma|delta|theta|chi|eps|omega|" + "|".join(FUNCTION_WORDS), re.I)
_OPERATOR, _BEFORE_SIGN = re.compile(r"[*/^=·⋅×)]|[-+−–]\s"), re.compile(r"[-+*/^=·⋅×(]\s*$")
_ROMAN = re.compile("[IVX]+")
_COLON = re.compile(  # "Step 4: and v = …", "both wheels have one speed there, so v = …"
    r"[^=:]{0,60}[^\W\d_]{3}[^=:]{0,20}(?::|,\s(?:so|hence|thus|donc|daher|also|luego|откуда|поэтому|значит|тому|звідки)\b)\s+(?=[^=:]+=)"
)
_SHORT, _CUTS, _MOST, _LONG = 3, 6, 12, 300


def without_edges(text: str, is_single: Callable[[str], bool]) -> Iterator[tuple[str, bool]]:
    """Yield a line without some of what stands at its edges, and whether a person must be asked because that may be a factor.

    `is_single` tells whether a word is one name of the task or the student, not a chain of names such as "et" for e*t.

    >>> [*without_edges("et u = w*r  usw.", {"u", "w", "r"}.__contains__)]
    [('et u = w*r', False), ('u = w*r  usw.', False), ('u = w*r', False)]
    >>> [*without_edges("e u = w*r (s)", {"e", "u", "w", "r", "s"}.__contains__)]
    [('e u = w*r', True), ('u = w*r (s)', True), ('u = w*r', True)]
    >>> [*without_edges("minus u = w*r", str.isalpha)], [*without_edges("u = w*r - s", str.isalpha)]
    ([], [])
    """
    if len(text) > EQUATION_CHARACTERS or "=" not in text:
        return
    wrapped = _WRAPPED.match(text)
    bare = next(part for part in wrapped.groups()[1:] if part) if wrapped else ""
    if bare and -1 not in depths(bare):  # "(3) v = r*w (a)" is no line in parentheses
        yield bare, False
        text = bare
    found = ((one, asks) for start in _begun(text, is_single) for one, asks in _ended(*start, is_single) if one != text)
    yield from islice(found, _MOST if len(text) <= _LONG else 1)  # to read a long line takes time


def _begun(text: str, is_single: Callable[[str], bool]) -> Iterator[tuple[str, bool]]:
    """Yield a line, and the line from behind each of its first words; a name of the task among them asks."""
    yield text, False
    start, asks = 0, False
    if colon := _COLON.match(text):
        start = colon.end()
        yield text[start:], False
    for _ in range(_CUTS):
        found = _FIRST.match(text, start)
        if not found or "=" not in text[found.end() :] or _changes(found[0]):
            return
        asks = asks or _is_name(found[1] or "", is_single)
        start = found.end()
        if not _OPERATOR.match(text, start):
            yield text[start:], asks


def _ended(text: str, asks: bool, is_single: Callable[[str], bool]) -> Iterator[tuple[str, bool]]:
    """Yield a line, and the line before each of its last words and remarks; one that begins with a name or a sign asks."""
    yield text, asks
    end = len(text)
    for _ in range(_CUTS):
        found = _LAST.search(text, max(end - 80, 0), end)
        if not found or _changes(found[0]):
            return
        end = found.start()
        kept = text[:end].rstrip(" \t,;:.…–—")
        if found[0][0].isdigit() or "=" not in kept or not kept[-1:].strip("=") or _BEFORE_SIGN.search(kept):
            continue
        yield kept, asks or not _is_remark(found[0].strip(), is_single)


def _is_remark(cut: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether what was cut off is a word, a unit, a number in brackets or a mark, and can be no factor."""
    words = re.findall(r"[^\W\d_]+", cut)
    if not words:
        return not any(map(str.isdigit, cut)) or re.fullmatch(r"[(\[{<]\W*\d{1,3}\W*", cut) is not None
    if re.match(r"[(\[{<]\W*\d", cut):  # [0,5 points]
        return any(len(word) >= _SHORT and not _is_name(word, is_single) for word in words)
    return re.match(r"\W*[^\W\d_]+(?![\d_])", cut) is not None and not _is_name(words[0], is_single)


def _changes(cut: str) -> bool:
    return CHANGES.search(cut) is not None or _DENIED.search(cut) is not None


def _is_name(word: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether a word may be a factor: a name, the length between two points, or a chain with a function or Greek name."""
    if "-" in word:
        return any(_is_name(part, is_single) for part in word.split("-"))
    if is_single(word) or _GREEK.search(word) or (word.isupper() and 1 < len(word) <= _SHORT and not _ROMAN.fullmatch(word)):
        return True
    return bool(word) and not word.isascii() and any("\u0370" <= sign <= "\u03ff" for sign in word) and len(word) <= _SHORT
