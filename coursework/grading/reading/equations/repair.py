"""Equations as people write them -> the strict form that formulas are read in.

Enters: one line of text, the declared names.  Leaves: the text that is read in its place; nothing is evaluated, and what
cannot be repaired is left for the strict reader to refuse.
Used by `equations.py`.
"""

from __future__ import annotations

import re
from functools import cache
from typing import NamedTuple

from coursework.grading.reading.equations.names_in_text import Spellings
from coursework.grading.reading.equations.plain_text import plain
from coursework.variant.formula.alphabet import LOOK_ALIKE

_SIGNS = str.maketrans({
    "[": "(", "]": ")", "{": "(", "}": ")", "∗": "*", "•": "*", "⁄": "/", "＝": "=", "（": "(", "）": ")", "＋": "+", "－": "-",
    "\u00a0": " ", "\u202f": " ", "\u2009": " ", "\u200b": None, "\ufeff": None, "‐": "-", "‑": "-", "—": "-", "`": None,
    "$": None,
})  # fmt: skip
_TAIL = " \t\r.,;"
_NAMED = re.compile(r"^(\s*[^\W\d]\w*)\s*(?:[:;\t]\s*=|=\s*=)\s*")  # the name beside a formula of a spreadsheet
_DECIMAL_COMMA = re.compile(r"(?<![\w.,])(\d+),(\d+)(?![\d,])")
_SUBSCRIPT = re.compile(r"(?<!\w)[^\W\d]\w*\[|[)\]]\[")  # a name before a bracket may be a product or a list: not guessed
_WORDS = {"ф": "phi", "Ф": "phi", "щ": "w", "∅": "phi", "Ø": "phi", "ø": "phi"}
_TOKEN = re.compile(
    r"(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+(?![\w.]))?)|(?P<name>[^\W\d]\w*)|(?P<sign>\S)"
    r"|(?P<blank>\s+)"
)
_FUNCTIONS = (
    "arcsin", "arccos", "arctan", "arctg", "atan2", "asin", "acos", "atan", "sqrt", "sin", "cos", "tan", "ctg", "cot", "tg",
    "exp", "log", "ln", "abs",
)  # fmt: skip


class _Token(NamedTuple):
    kind: str
    text: str


def repaired(text: str, spellings: Spellings) -> str:
    """Return a line as the strict reader wants it: decimal points, brackets, products and arguments written out, `= 0` added.

    >>> repaired("2l1 sin φ3 + 0,5 = 0", Spellings(frozenset({"l1", "phi3"}), {}, {}))
    '2 * l1 * sin(phi3) + 0.5 = 0'
    """
    if _SUBSCRIPT.search(text):
        return text
    typed = re.sub(r"_\{(\w+)\}", r"_\1", plain(text.replace("$", " "), spellings)).translate(_SIGNS).rstrip(_TAIL)
    typed = _NAMED.sub(r"\1 = ", typed.replace(":=", "=").replace("==", "="))
    typed = typed.replace("\\", " ").replace("²", "^2 ").replace("³", "^3 ").strip()
    if "atan2" not in typed:
        typed = _DECIMAL_COMMA.sub(r"\1.\2", typed)
    sides = [_side(side, spellings) for side in typed.split("=")]
    if len(sides) == 3:  # V_Cy = … = 0 says what the sum is before it says that it vanishes
        sides = sides[1:]
    return " = ".join(sides if len(sides) > 1 else [*sides, "0"])


def _side(text: str, spellings: Spellings) -> str:
    pieces = [(str(found.lastgroup), found[0]) for found in _TOKEN.finditer(text)]
    spelled = {piece: _spelled(*piece, spellings) for piece in dict.fromkeys(pieces)}  # each name is looked up once
    tokens = [token for piece in pieces for token in spelled[piece]]
    return _written(_applied(_joined(tokens, spellings)))


def _spelled(kind: str, text: str, spellings: Spellings) -> list[_Token]:
    """Return a name in its declared spelling, or the names and functions it was glued together from."""
    if kind == "blank":
        return [_Token("blank", " ")]
    if kind != "name":
        return [_Token(kind, text)]
    plain = "".join(_WORDS.get(letter, LOOK_ALIKE.get(letter, letter)) for letter in text)
    if plain.lower() in _FUNCTIONS:
        return [_Token("function", plain.lower())]
    if known := spellings.canonical(plain) or spellings.canonical(text):
        return [_Token("name", known)]
    parts = _split(plain, spellings) if len(plain) <= 60 else None
    return list(parts) if parts else [_Token("name", plain)]


def _split(text: str, spellings: Spellings) -> tuple[_Token, ...] | None:
    """Return the one way to take a word apart into declared names, numbers and functions, None where there is none or several."""

    @cache
    def ways(start: int) -> tuple[tuple[_Token, ...], ...]:
        if start == len(text):
            return ((),)
        found = []
        for end in range(start + 1, len(text) + 1):
            piece = text[start:end]
            # A digit belongs to the name before it.
            if end < len(text) and text[end].isdigit():
                continue
            token = _Token("function", piece.lower()) if piece.lower() in _FUNCTIONS else None
            if token is None and (known := spellings.canonical(piece)):
                token = _Token("name", known)
            if token:
                found += [(token, *rest) for rest in ways(end)]
            if len(found) > 1:
                return tuple(found[:2])
        return tuple(found)

    found = ways(0)
    return found[0] if len(found) == 1 else None


def _joined(tokens: list[_Token], spellings: Spellings) -> list[_Token]:
    """Return the tokens without blanks; an index that stood apart is put to its name."""
    joined: list[_Token] = []
    bare = [token for token in tokens if token.kind != "blank"]
    for token in bare:
        last = joined[-1] if joined else None
        if last and last.kind == "name" and token.kind == "number" and last.text not in spellings.known:
            known = spellings.canonical(last.text + token.text)
            if known:
                joined[-1] = _Token("name", known)
                continue
        joined.append(token)
    return joined


def _applied(tokens: list[_Token]) -> list[_Token]:
    """Return the tokens with the argument of each function in parentheses, powers of functions behind them."""
    out: list[_Token] = []
    powers: list[tuple[int, str]] = []  # for each power of a function: the level of parentheses it waits for, and itself
    level = place = 0
    while place < len(tokens):
        token = tokens[place]
        place += 1
        level += {"(": 1, ")": -1}.get(token.text, 0)
        if token.kind == "function":
            power, place = _power(tokens, place)
            argument, place = _argument(tokens, place)
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
    """Return the power that stands between a function and its argument, and where the argument begins."""
    if place + 1 < len(tokens) and tokens[place].text == "^" and tokens[place + 1].kind == "number":
        return tokens[place + 1].text, place + 2
    return "", place


def _argument(tokens: list[_Token], place: int) -> tuple[list[_Token], int]:
    """Return a function's argument in parentheses (none where they stand there already), and where the text goes on."""
    end = place
    while end < len(tokens) and tokens[end].kind == "number":
        end += 1
    if end < len(tokens) and tokens[end].kind == "name":
        end += 1
    if end == place:
        return [], place
    inside = tokens[place:end]
    return [_Token("sign", "("), *inside, _Token("sign", ")")], end


def _written(tokens: list[_Token]) -> str:
    """Return the text of tokens; a product without a sign gets one."""
    pieces: list[str] = []
    before = _Token("sign", "")
    for token in tokens:
        ends = before.kind in {"number", "name"} or before.text == ")"
        begins = token.kind in {"number", "name", "function"} or token.text == "("
        if ends and begins:
            pieces.append(" * ")
        elif token.kind == "sign" and token.text in {"+", "-", "*", "/"} and ends:
            pieces.append(f" {token.text} ")
            before = token
            continue
        pieces.append(token.text)
        before = token
    return "".join(pieces).strip()
