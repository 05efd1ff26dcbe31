"""Equations as people write them -> the strict form that the formula reader accepts.

Enters: one line in plain text, the declared names.  Leaves: the text to read instead; nothing is evaluated, and what cannot be
repaired is left for the strict reader to refuse.
Used by `equations.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Set
from functools import cache, lru_cache
from typing import NamedTuple

from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.variant.formula.alphabet import LOOK_ALIKE
from coursework.variant.formula.reader import FUNCTION_WORDS

_SIGNS = str.maketrans({"[": "(", "]": ")", "{": "(", "}": ")", "`": None, "$": None})
_INDEX = 2  # letters in a name or index that is set apart
_TAIL = " \t\r.,;:✓✔☑"
_NAMED = re.compile(r"^(\s*[^\W\d]\w*)\s*(?:[:;\t]\s*=|=\s*=)\s*")  # a name before the formula of a spreadsheet
_DECIMAL_COMMA = re.compile(r"(?<![\w.,])(\d+),(\d+)(?![\d,])")
_SUBSCRIPT = re.compile(r"(?<!\w)([^\W\d]\w*)\[\s*[\w\s,:.-]*\]")  # an index that no name of the variant has; it is not guessed
_CELLS = re.compile(r"[\w)\]]\t+[-\w(\[][^\t]*[\w)\]]\t+[-\w(\[]")  # three cells of a row are no product
_WORDS = {"ф": "phi", "Ф": "phi", "щ": "w"}
# The names of functions in other languages, also in their spreadsheets.
_ELSEWHERE = {"sen": "sin", **dict.fromkeys(("корень", "корінь", "wurzel", "racine", "raiz", "raíz"), "sqrt")}
_LONGER = re.compile(r"(?i)(?<![a-z])(cot|tan)(?:g|an|ang)(?![a-z])")  # cotg, cotan, tang: no tangent of a length g
_LONG_FUNCTIONS = ("sin", "cos", "sen")
_DIVIDED = re.compile(r"(?<=[\w)])\s*:\s*(?=[\w(])")
_NUMBER = re.compile(r"[-+]?\s*(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_WORD = re.compile(r"[^\W\d]\w*")
_TIMES = re.compile(r"(?<=[\w)])\s+[xх]\s+(?=[\w(])")
_TOKEN = re.compile(
    r"(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+(?![\w.]))?)|(?P<name>[^\W\d]\w*)|(?P<sign>\S)"
    r"|(?P<blank>\s+)"
)


class _Token(NamedTuple):
    kind: str
    text: str


class Sides(NamedTuple):
    """The two or more sides of a line, in the strict form; `is_whole` is False if the line had no "=" and "= 0" was added."""

    texts: tuple[str, ...]
    is_whole: bool = True


def sides_of(text: str, spellings: Spellings, *, closely: bool = False) -> Sides:
    """Return the sides of a line in plain text, with decimal points, parentheses, products and arguments written out.

    If there is only one side, the other is 0.  With `closely`, a product without a sign binds closer than a division:
    V/r(a + b) is V/(r(a + b)).

    >>> sides_of("2l1 sin φ3 + 0,5", Spellings(frozenset({"l1", "phi3"}), {}, {}))
    Sides(texts=('2 * l1 * sin(phi3) + 0.5', '0'), is_whole=False)
    """
    if _CELLS.search(text) or not all(name.lower().endswith(tuple(FUNCTION_WORDS)) for name in _SUBSCRIPT.findall(text)):
        return Sides(tuple(text.split("=")))
    typed = _NAMED.sub(r"\1 = ", text.replace("$", " ").translate(_SIGNS).rstrip(_TAIL))
    typed = typed.replace("\\", " ").strip()
    typed = _LONGER.sub(r"\1", typed)
    if "atan2" not in typed:
        typed = _DECIMAL_COMMA.sub(r"\1.\2", typed)
    if "x" not in spellings.known:
        typed = _TIMES.sub(" * ", typed)
    sides = [
        _side(_DIVIDED.sub(" / ", side) if place else side, spellings, closely) for place, side in enumerate(typed.split("="))
    ]
    return Sides(tuple(sides)) if len(sides) > 1 else Sides((*sides, "0"), is_whole=False)


def _side(text: str, spellings: Spellings, closely: bool) -> str:
    pieces = [(str(found.lastgroup), found[0]) for found in _TOKEN.finditer(text)]
    tokens = [token for piece in pieces for token in _spelled(*piece, spellings)]
    return _written(_applied(_joined(tokens, spellings), spellings.angles), closely)


def is_name(word: str, spellings: Spellings) -> bool:
    """Return whether a word is a name of the variant, a function or a chain of these; "Am" begins a sentence, it is not a*m."""
    pieces = _spelled("name", word, spellings)
    if word.istitle() and len(pieces) > 1 and all(piece.kind == "name" for piece in pieces):
        return "".join(piece.text for piece in pieces) == word
    return all(piece.kind == "function" or piece.text in spellings.known for piece in pieces)


def is_value(text: str) -> bool:
    """Return whether a side is a number in some row, also one that is still to be worked out, 0.05/(1.1*sin(0.62))."""
    if _NUMBER.fullmatch(text):
        return bool(float(text.replace(" ", "")))
    return not {*_WORD.findall(text)} - {*FUNCTION_WORDS, "pi"}


def is_product(word: str, spellings: Spellings) -> bool:
    """Return whether a word is a product without signs, r3ω3sinφ3 or r3ω3, and not a name of the student such as ca."""
    pieces = _spelled("name", word, spellings)
    speeds = {*spellings.rates.values()}
    return len(pieces) > 1 and any(one.kind == "function" or (one.text in speeds and not one.text.isalpha()) for one in pieces)


@lru_cache(4096)  # the same few names occur in every line
def _spelled(kind: str, text: str, spellings: Spellings) -> tuple[_Token, ...]:
    """Return a name in its declared spelling, or the names and functions that it is a chain of."""
    if kind == "blank":
        return (_Token("blank", " "),)
    if kind != "name":
        return (_Token(kind, text),)
    plain = "".join(_WORDS.get(letter, LOOK_ALIKE.get(letter, letter)) for letter in text)
    if (function := _ELSEWHERE.get(text.lower(), plain.lower())) in FUNCTION_WORDS:
        return (_Token("function", function),)
    if known := spellings.canonical(plain) or spellings.canonical(text):
        return (_Token("name", known),)
    is_one = len(plain) > 60 or spellings.is_own(plain)  # dd and ve, which the text defines, are not d*d and v*e
    parts = None if is_one else _split(plain, spellings)
    return parts or (_Token("name", plain),)


def _split(text: str, spellings: Spellings) -> tuple[_Token, ...] | None:
    """Return the parts of a word that is a chain of names and functions, None if there is no way or several.

    Names as the task has them go before other spellings: vrcos is vr*cos, though v may be short for the only speed.
    """
    if found := _chain(text, spellings.known_as, spellings.angles):
        return found
    # c_3 that the text itself defines is one, too, in ac_3
    found = _chain(text, spellings.canonical, spellings.angles) or _chain(
        text,
        lambda piece: spellings.canonical(piece) or (piece * (piece[-1].isdigit() and spellings.is_own(piece))),
        spellings.angles,
    )
    # VB is the velocity of B and Vr a relative one, not v*b and v*r
    letters = text.replace("_", "")
    is_word = letters.isascii() and letters.isalpha() and not letters.islower()
    return None if found is None or (is_word and all(part.kind == "name" for part in found)) else found


def _chain(text: str, meaning: Callable[[str], str | None], angles: Set[str]) -> tuple[_Token, ...] | None:
    @cache
    def ways(start: int) -> tuple[tuple[_Token, ...], ...]:
        if start == len(text):
            return ((),)
        found = []
        # senψ is sen(ψ), also where s, e and n are names
        called = next(
            (len(one) for one in _LONG_FUNCTIONS if text.lower().startswith(one, start) and len(text) > start + len(one)), 0
        )
        for end in range(start + max(called, 1), start + called + 1 if called else len(text) + 1):
            piece = text[start:end]
            # A digit belongs to the name before it.
            if (end < len(text) and text[end].isdigit()) or "_" in {piece[0], piece[-1]}:  # in lω_ψ no name is ω_
                continue
            function = _ELSEWHERE.get(piece.lower(), piece.lower())
            token = _Token("function", function) if function in FUNCTION_WORDS else None
            if token is None and (known := meaning(piece)):
                token = _Token("name", known)
            if token:
                found += [(token, *rest) for rest in ways(end)]
            if len(found) > 1:
                return tuple(found[:2])
        return tuple(found)

    found = ways(0)
    if len(found) > 1:  # in Lωβ the velocity ωβ is a factor: no angle is one
        found = tuple(way for way in found if not any(token.kind == "name" and token.text in angles for token in way))
    return found[0] if len(found) == 1 else None


def _joined(tokens: list[_Token], spellings: Spellings) -> list[_Token]:
    """Return the tokens without blanks; an index separated by a blank is joined to its name, "V M y" of a PDF to VMy."""
    joined: list[_Token] = []
    bare = [token for token in tokens if token.kind != "blank"]
    for token in bare:
        for before in (2, 1):
            parts = [one.text for one in joined[-before:] if one.kind == "name" and one.text not in spellings.known]
            known = spellings.canonical("".join([*parts, token.text])) if token.kind == "name" and len(parts) == before else None
            if known and len(token.text) <= _INDEX and len(parts[0]) <= _INDEX:
                joined[-before:], token = [], _Token("name", known)
                break
        last = joined[-1] if joined else None
        if last and last.kind == "name" and token.kind == "number" and last.text not in spellings.known:
            known = spellings.canonical(last.text + token.text)
            if known:
                joined[-1] = _Token("name", known)
                continue
        joined.append(token)
    return joined


def _applied(tokens: list[_Token], angles: Set[str]) -> list[_Token]:
    """Return the tokens with each function's argument in parentheses and a function's power moved behind the argument."""
    out: list[_Token] = []
    powers: list[tuple[int, str]] = []  # pending powers of functions, with the level where each goes
    level = place = 0
    while place < len(tokens):
        token = tokens[place]
        place += 1
        level += {"(": 1, ")": -1}.get(token.text, 0)
        if token.kind == "function":
            power, place = _power(tokens, place)
            argument, place = _argument(tokens, place, angles)
            out += [_Token("sign", "("), token] if power else [token]
            out += argument
            if power and argument:
                out += _raised(power)
            elif power:
                powers.append((level, power))
            continue
        out.append(token)
        if token.text == ")" and powers and powers[-1][0] == level:
            out += _raised(powers.pop()[1])
    return out


def _raised(power: str) -> list[_Token]:
    return [_Token("sign", ")"), _Token("sign", "^"), _Token("number", power)]


def _power(tokens: list[_Token], place: int) -> tuple[str, int]:
    """Return the power between a function and its argument ("" if none), and the place where the argument begins."""
    if place + 1 < len(tokens) and tokens[place].text == "^" and tokens[place + 1].kind == "number":
        return tokens[place + 1].text, place + 2
    return "", place


def _argument(tokens: list[_Token], place: int, angles: Set[str]) -> tuple[list[_Token], int]:
    """Return a function's argument with parentheses added ([] if it has its own), and the place behind it.

    An angle that is added behind it, sin pt + α, belongs to the argument: no velocity equation has an angle as a term.
    """
    end, _ = _term(tokens, place, angles)
    if end == place:
        return [], place
    while end < len(tokens) and tokens[end].text in {"+", "-"}:
        after, is_angle = _term(tokens, end + 1, angles)
        behind = tokens[after] if after < len(tokens) else _Token("sign", "")
        if not is_angle or behind.kind != "sign" or behind.text in {"*", "/", "^", "("}:
            break
        end = after
    return [_Token("sign", "("), *tokens[place:end], _Token("sign", ")")], end


def _term(tokens: list[_Token], place: int, angles: Set[str]) -> tuple[int, bool]:
    """Return the end of numbers and a name, or a name and the time, pt, from a place on; and whether they are an angle."""
    end = place
    while end < len(tokens) and tokens[end].kind == "number":
        end += 1
    if end == len(tokens) or tokens[end].kind != "name":
        return end, False
    name, end = tokens[end].text, end + 1
    other = end + (end < len(tokens) and tokens[end].text == "*")
    is_of_time = other < len(tokens) and tokens[other].kind == "name" and "t" in {name, tokens[other].text}
    if is_of_time and name not in angles:
        return other + 1, True
    return end, name in angles


def _written(tokens: list[_Token], closely: bool) -> str:
    """Return the text of tokens with missing product signs; with `closely`, such products are put in parentheses after "/"."""
    pieces: list[str] = []
    before = _Token("sign", "")
    below: list[int] = []  # levels of parentheses at which a product without a sign follows "/"
    level = 0
    for token in tokens:
        ends = before.kind in {"number", "name"} or before.text == ")"
        begins = token.kind in {"number", "name", "function"} or token.text == "("
        if below and below[-1] == level and (token.text in {"+", "-", "*", "/", ")", "="} and ends):
            below.pop()
            pieces.append(")")
        level += {"(": 1, ")": -1}.get(token.text, 0)
        if ends and begins:
            pieces.append(" * ")
        elif token.kind == "sign" and token.text in {"+", "-", "*", "/"} and ends:
            pieces.append(f" {token.text} ")
            before = token
            continue
        if closely and before.text == "/":
            below.append(level - (token.text == "("))
            pieces.append("(")
        pieces.append(token.text)
        before = token
    return ("".join(pieces) + ")" * len(below)).strip()
