"""A line -> the same line without words, marks and letters at its edges, which may be a remark although they could be factors.

Enters: a line, a test for single names.  Leaves: shorter lines, each with whether a person must say that it is meant.
Used by `equations.py` and `lines.py`.  Such a reading counts only if it is right, so nothing is lost; what changes an equation
is never cut.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import islice
from unicodedata import category

from coursework.grading.reading.equations.formulas.denials import DENIED
from coursework.grading.reading.equations.formulas.labels import ASIAN, CHANGES
from coursework.grading.reading.equations.notation.signs import depths
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.variant.formula.reader import FUNCTION_WORDS

_WORD = r"[^\W\d_]{1,20}(?:['’-][^\W\d_]{1,20})?"
_FIRST = re.compile(rf"\s*(?:({_WORD})[.,:;!]{{0,3}}(?=\s)|([^\w\s(\[{{$\\+\-−–—*/=^'’]{{1,3}})|([*•+]\)))\s*")
_LAST = re.compile(
    rf"(?:(?<=[\s)\]}}])({_WORD})[.,:;!]{{0,3}}|(?<=\s)(?:\([^()]{{1,60}}\)|\[[^\[\]]{{1,60}}\]|\{{[^{{}}]{{1,40}}\}}|<[^<>]{{1,20}}>)[.,;]?"
    r"|(?<=\s(?:in|en)\s)[^\W\d_]{1,3}(?:/[^\W\d_]{1,2}|⁻¹)?[.,;]?|(?<=\s)\d{1,3}[.)]?|(?<=[\s)\]}])[^\w\s()\[\]{}+\-−–*/=^<>'’]{1,9}|(?<=[\s(])\w\s?=\s?[\d.,]{1,8}|=\s*(?:\.{2,9}|…|\?)|(?<=\s)q\W{0,2}e\W{0,2}d\.?)\s*$"
)
_BEFORE_UNIT = re.compile(r"\s(?:in|en)\s$")
# A power, a fraction, or a sign that reckons: where such a thing stands at an edge, it is no remark.
_RECKONS = re.compile(r"[²³¹¼-¾⅐-⅟⁰-⁾]")
_SIGNS, _NO_SIGNS = {"Sm", "Pd", "Sk", *"*/+′″‰%°➕➖➗✖"}, {*"=|<>~`→⇒⟹⇨←⇐↔⇔∴∵∎·⋅∙"}
_NUMBER_ALONE = re.compile(r"[(\[<][\s#№.]*\d{1,3}[\s*.]*[)\]>][.,;]?")
_REFERS = re.compile(
    r"(?:see|fig|figures?|abb|bild|s|seite|pp?|pages?|eqn?|no|nr|gl|gleichung|step|loop|link|part|point|task|row|рис|см|стр|с|ур|звено"
    r"|ланк\w*|контур|шаг|крок|мал|图|式|第|表)\W*",
    re.I,
)
_WRAPPED = re.compile(
    r"^([^=]{0,40}?[:.)\-–•]\s+|\s*)(?:\*\*([^*].*=.*[^*])\*\*|_([^_].*=.*[^_])_|~([^~].*=.*[^~])~|<([^<>]*=[^<>]*)>|\((.*=.*)\)|\{(.*=.*)\}|\[(.*=.*)\])\s*[.,;]?\s*$"
)
_LETTERS = "phi|psi|alpha|beta|gamma|delta|theta|chi|eps|omega"
_FUNCTIONS = "|".join(sorted(FUNCTION_WORDS))
_IN_CHAIN = re.compile(f"{_LETTERS}|{_FUNCTIONS}", re.I)
# sin φ, cosx and cosphi, not "since"
_FUNCTION = re.compile(rf"(?<![^\W_])(?:(?:{_FUNCTIONS})(?=[^\W\d_]?(?![^\W\d_])|{_LETTERS})|(?:pi|π)(?![^\W\d_]))", re.I)
_SAY = {*"xyzXYZоОаАиИіІйвВкКсСуУ"}  # letters that are words or axes
_OPERATOR, _BEFORE_SIGN = re.compile(r"[*/^=·⋅×)]|[-+−–]\s"), re.compile(r"[-+*/^=·⋅×(]\s*$")
_ROMAN = re.compile("[IVX]+")
_COLON = re.compile(  # "Step 4: and v = …", "both wheels have one speed there, so v = …"
    r"[^=:]{0,60}[^\W\d_]{3}[^=:]{0,20}(?::|,\s(?:so|hence|thus|donc|daher|also|luego|откуда|поэтому|значит|тому|звідки)\b)\s+(?=[^=:]+=)"
)
_SHORT, _CUTS, _MOST, _LONG, _WORD_LETTERS = 3, 6, 12, 300, 2


def unwrapped(text: str) -> str:
    """Return a line without the brackets or marks around its whole equation, Loop 2: (v = r*w), and the label before them."""
    found = _WRAPPED.match(text) if len(text) <= EQUATION_CHARACTERS else None
    bare = next(part for part in found.groups()[1:] if part) if found else ""
    return bare if bare and -1 not in depths(bare) else text  # "(3) v = r*w (a)" is no line in brackets


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
    found = ((one, asks) for start in _begun(text, is_single) for one, asks in _ended(*start, is_single) if one != text)
    yield from islice(found, _MOST if len(text) <= _LONG else 1)  # to read a long line takes time


def _begun(text: str, is_single: Callable[[str], bool]) -> Iterator[tuple[str, bool]]:
    """Yield a line, and the line from behind each of its first words; a name of the task among them asks."""
    yield text, False
    start, asks = 0, False
    if (colon := _COLON.match(text)) and not DENIED.search(colon[0]):
        start = colon.end()
        yield text[start:], False
    for _ in range(_CUTS):
        found = _FIRST.match(text, start)
        if not found or "=" not in text[found.end() :] or _changes(found[0]):
            return
        word = found[1] or ""
        asks = asks or (_is_name(word, is_single) and (word != "e" or is_single(word)))  # e is "and" in Italian
        start = found.end()
        if not _OPERATOR.match(text, start):
            yield text[start:], asks


def _ended(text: str, asks: bool, is_single: Callable[[str], bool]) -> Iterator[tuple[str, bool]]:
    """Yield a line, and the line before each of its last words and remarks; one that begins with a name or a sign asks."""
    yield text, asks
    end, is_counted, is_factor = len(text), False, False
    for _ in range(_CUTS):
        found = _LAST.search(text, max(end - 80, 0), end)
        if not found or _changes(found[0]) or (is_counted and not _REFERS.fullmatch(found[0].strip())):
            return
        end, is_counted = found.start(), found[0][0].isdigit()
        kept = text[:end].rstrip(" \t,;:.…–—")
        is_unit = _BEFORE_UNIT.search(text, max(end - 4, 0), end) is not None
        is_said = is_counted or is_unit or _is_remark(found[0].strip(), is_single)
        is_factor = not is_said or (is_factor and len(found[1] or "") < _WORD_LETTERS)  # behind a word a letter is a word too
        if is_counted or "=" not in kept or not kept[-1:].strip("=") or _BEFORE_SIGN.search(kept):
            continue
        yield kept, asks or is_factor


def _is_remark(cut: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether what was cut off is a word, a unit, a number in brackets or a mark, and can be no factor."""
    words = re.findall(r"[^\W\d_]+", cut)
    if not words or re.fullmatch(r"t\s?=[^=]*|q\W{0,2}e\W{0,2}d\W*", cut):  # for t = 0
        return True
    if re.match(r"[(\[{<]\W*\d", cut):  # [0,5 points]
        return any(len(word) >= _SHORT and not _is_name(word, is_single) for word in words)
    return re.match(r"\W*[^\W\d_]+(?![\d_])", cut) is not None and not _is_name(words[0], is_single)


def _changes(cut: str) -> bool:
    """Return whether what stands at an edge changes the equation, or says that it does not hold: a sign, a number, a function."""
    if CHANGES.search(cut) or DENIED.search(cut) or _RECKONS.search(cut) or _FUNCTION.search(cut):
        return True
    if any(map(str.isalpha, cut)) or re.match(r"=\s*\W", cut):  # = ...
        return False
    if any(map(str.isdigit, cut)):
        return not (cut.strip(" .)").isdigit() or _NUMBER_ALONE.fullmatch(cut.strip()))
    return any(not {sign, category(sign)}.isdisjoint(_SIGNS) and sign not in _NO_SIGNS for sign in cut)


def _is_name(word: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether a word may be a factor: a name, a letter, the length between two points, or a chain."""
    if "-" in word:
        return any(_is_name(part, is_single) for part in word.split("-"))
    word = re.sub(f"[{ASIAN}]+", "", word)  # 即r is r behind a word
    if is_single(word) or (len(word) == 1 and word not in _SAY) or _is_chain(word, is_single):
        return True
    if word.isupper() and 1 < len(word) <= _SHORT and not _ROMAN.fullmatch(word):
        return True
    return any(map(_is_greek, word)) and len(word) <= _SHORT


def _is_greek(letter: str) -> bool:
    return "\u0370" <= letter <= "\u03ff"


def _is_chain(word: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether a word is a chain of names with a Greek one or a function, as aphi; "Maschine", with chi in it, is none."""
    return _IN_CHAIN.search(word) is not None and all(is_single(one) or _is_greek(one) for one in _IN_CHAIN.sub("", word))
