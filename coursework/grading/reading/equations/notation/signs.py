"""Letters and signs as programs paste them -> those of a keyboard: mathematical italics, full-width letters, subscripts, arrows …

Enters: one line as typed.  Leaves: the line in plain letters, with one form of "=" and of the arrow.  Nothing is guessed here.
Used by `plain_text.py`, `parts.py` and `matrices.py`.
"""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache
from itertools import accumulate

ARROW = "⇒"  # between two equations of a line, or between a remark and its equation
_MATHEMATICAL, _FULL_WIDTH = range(0x1D400, 0x1D800), range(0xFF01, 0xFF5F)
_SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₒₓₕₖₗₘₙₚₛₜᵢᵣᵤᵥⱼ", "0123456789aeoxhklmnpstiruvj", strict=True))
_SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-", strict=True))
_RAISED = re.compile(f"[{''.join(_SUPERSCRIPTS)}]+")
_MINUS = re.compile(r"(?<=\s)⁻(?=\s)")  # set higher by mistake: no exponent stands alone
_DOT = "\u0307"
_OF_NO_KEYBOARD = re.compile(r"[^\x00-\x7f]")
_EQUAL = "≡≈≅≃≐≑≔≝≜≟⩴⩵⩶꓿⹀"
_SIGNS = {
    **dict.fromkeys(_EQUAL, "="), **dict.fromkeys("−‐‑‒–—―﹣﹘─━➖˗₋", "-"), "﹢": "+",
    **dict.fromkeys("∗•∙⋅·●∘×✕✖⨯⸱・⋆⁎✱﹡\u2062", "*"), **dict.fromkeys("⁄∕÷⌟┘", "/"), **dict.fromkeys("〖⟦❨", "("),
    **dict.fromkeys("〗⟧❩", ")"), **dict.fromkeys("，、", ","), "。": ".", "【": "[", "】": "]", "；": ";", "：": ":",
    **dict.fromkeys("\u00ad\u200b\u200c\u200d\u200e\u200f\u2060\u2061\u2063\u2064\ufe0e\ufe0f\ufeff", ""),
    **dict.fromkeys("\u00a0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f\u3000", " "),
    "∂": "d", "ℓ": "l", "ϖ": "ω", "ɸ": "φ", "∅": "φ", "⌀": "φ", "Ø": "φ", "ø": "φ", "’": "'", "′": "'", "ʹ": "'",
}  # fmt: skip
ARROWS = re.compile(
    rf"<?={{1,3}}>|-{{1,3}}>|<->|[→⟶⟹⇔⟺↔⟷➔➜➡∴{ARROW}]"
    r"|\\(?:Rightarrow|Longrightarrow|implies|rightarrow|longrightarrow|to|Leftrightarrow|iff|therefore|leadsto)(?![A-Za-z])"
)
_IN_TEX = r"\\(?:equiv|approx|simeq|cong|doteq|coloneqq|triangleq)(?![A-Za-z])"
_RELATION = re.compile(rf"[=＝{_EQUAL}]|{_IN_TEX}|\bEq(?:uality)?\s*\(|(?<=[\w\])])\s*<-\s")
_EQUALS = re.compile(rf"(?<![<>!]):=|=:|\.?={{2,}}|{_IN_TEX}|(?<=[\w\])])\s*<-(?=\s)")  # <- in R
# An equation of Symbolics in Julia, e1 = a*w1 ~ 0: of two names alone it may say that one is proportional to the other.
_OF_JULIA = re.compile(r"^((?:\s*\w{1,20}\s*=)?[^=~]*[\w)\]])\s+\.?~(?=\s+[-+\w(][^=~]*$)")
_FORMULA = re.compile(r"\*|(?:sin|cos)\b|(?<![\w.])0(?![\w.])")
_WORDS = re.compile(
    r"\b(?:is\s+equal\s+to|equals|равно|равна|равен|дорівнює|ist\s+gleich|gleich|est\s+égale?\s+à|es\s+igual\s+a)\b|等于|等於",
    re.I,
)
VANISHED = re.compile(r"(?:[=≡]|\\equiv)(?:[\s&]|\{\})*0(?:[.,]0*)?\s*+(?:[.,;]\s*+)?(?:\\\w+\s*)*$")
_ZERO = re.compile(r"=\s+(?:zero|null|ноль|нулю|нуль|零)\b", re.I)
# A spoken sign between two terms; before a word it may be one of a remark, "with a minus sign", "minus the speed of C".
_SPOKEN = re.compile(
    r"(?<=[\w)]\s)((?i:plus|minus|плюс|минус|мінус))(?=\s[\w(])"
    r"(?!\s(?:the|of|as|so|in|an|at|[^\W\d_A-Z]{4,})\b(?<!alpha|gamma|delta|theta|omega)(?<!beta|sqrt))"
)
_UNDER = re.compile(r"_\s*(?:\{([^{}]*)\}|\(([^()]*)\))")
_QUOTED = re.compile(r'(?<=\w)_\s?"(\w{1,9})"')  # an index in Typst
_OPERATOR = re.compile(r"[-+*/=^]")
_AXIS = re.compile(r"(?<=\w)\^\s*(?:[{(]\s*\(?([xyz])\)?\s*[)}]|([xyz])(?!\w))((?:_\w+)?)")
_COMPONENT = re.compile(r"[(\[{]\s*([^\W\d]_?\w{0,3})\s*[)\]}]\s*[_^]\s*[({]?\s*([xyz])\s*[)}]?(?!\w)")  # (V_M)_x
_OF_POINT = re.compile(r"(?<=\w)_([xyz])\s*\^\s*[({]?\s*([A-Z])\s*[)}]?(?!\w)")  # V_x^M
_LENGTH = re.compile(r"\|\s*([A-Z]\w?'?[A-Z]\w?'?)\s*\|")  # the length between two points


def depths(text: str) -> list[int]:
    """Return for each character of a text the depth of brackets after it; -1 at a closing bracket that was never opened."""
    return [*accumulate((sign in "([{") - (sign in ")]}") for sign in text)]


def closing(text: str, opening: int, most: int | None = None) -> int:
    """Return the place of the bracket that closes the one at `opening`, among the `most` next signs; `opening` if there is none.

    >>> closing("a*(b + [c]) - d", 2), closing("(a", 0)
    (10, 0)
    """
    inside = depths(text[opening : opening + most] if most else text[opening:])
    return opening + inside.index(0) if 0 in inside else opening


def relates_two_sides(text: str) -> bool:
    """Return whether a text has a sign or word of equality (an arrow is none)."""
    return _RELATION.search(ARROWS.sub(" ", text)) is not None or _WORDS.search(text) is not None or _of_julia(text) != text


def _of_julia(text: str) -> str:
    return _OF_JULIA.sub(r"\1 =", text) if "~" in text and "\\" not in text and _FORMULA.search(text) else text


def relations(text: str) -> list[int]:
    """Return where the signs of equality of a text stand."""
    return [found.start() for found in _RELATION.finditer(text)]


@lru_cache(1024)  # several readers look at the same line in turn
def plain_signs(text: str) -> str:
    r"""Return a line with the letters and signs of a keyboard; Greek letters are kept.

    >>> plain_signs("2𝑟₃𝜔₃⋅sin⁡〖𝜑_3〗 − ½r_{3}ω_3^z ≡ 0"), plain_signs("V_(M y) := φ ̇_3 sin²φ３")
    ('2r3ω3*sin(φ_3) - ½r_3ω_3 = 0', 'V_My = φ̇_3 sin^2 φ3')
    """
    text = _OF_NO_KEYBOARD.sub(lambda found: _plain(found[0]), text)
    if not text.isascii():
        text = _MINUS.sub("-", text)
        text = _RAISED.sub(lambda found: "^" + "".join(_SUPERSCRIPTS[digit] for digit in found[0]) + " ", text)
    text = re.sub(rf"([^\W\d])[\s]*(?:{_DOT}|˙)", rf"\1{_DOT}", text)
    text = re.sub(rf"([^\W\d_])(_?\d{{1,2}})(?:{_DOT}|˙)", rf"\1{_DOT}\2", text)  # typed behind the index
    text = _EQUALS.sub("=", ARROWS.sub(f" {ARROW} ", text))
    text = _WORDS.sub(" = ", text)
    text = _of_julia(_ZERO.sub("= 0", text))
    text = _SPOKEN.sub(lambda found: "+" if found[1][0].lower() in "pп" else "-", text)
    text = re.sub(r"(?<=\w)\s+_(?=[\w{(])|_\s+(?=\w)", "_", text)
    text = _QUOTED.sub(r"_\1", text)
    for _ in range(3):  # up to three nested indices
        text = _UNDER.sub(_index, text)
    if "_" in text:
        text = _OF_POINT.sub(r"_\2\1", _COMPONENT.sub(r"\1\2", text))
    return _AXIS.sub(_axis, re.sub(r"(?<=\w)\.(?=[*/^])|(?<=[)\]\s])\.(?=[*/^'])", "", _LENGTH.sub(r"\1", text)))


@lru_cache(4096)  # a text has few different letters
def _plain(letter: str) -> str:
    if ord(letter) in _MATHEMATICAL or ord(letter) in _FULL_WIDTH:
        return unicodedata.normalize("NFKC", letter)
    if unicodedata.decomposition(letter).endswith(" 0307"):
        return unicodedata.normalize("NFD", letter)
    return _SIGNS.get(letter, _SUBSCRIPTS.get(letter, letter))


def _index(found: re.Match[str]) -> str:
    inner = found[1] if found[1] is not None else found[2]
    if _OPERATOR.search(inner) or not inner.strip():
        return found[0]
    return "_" + re.sub(r"[\s,;_{}()]", "", inner)


def _axis(found: re.Match[str]) -> str:
    """Return the axis of a projection as an index: V_My for V_M^y; z is dropped, as all rotation in the plane is about z."""
    axis = found[1] or found[2]
    return found[3] + ("" if axis == "z" else axis if found[3] else f"_{axis}")
