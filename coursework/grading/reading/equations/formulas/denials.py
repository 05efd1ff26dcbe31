"""Whether words and marks around an equation say that it does not hold: "wrong: …", "not …", "… (sign reversed)".

Enters: a line, a test for single names.  Leaves: the answer.  Used by `edges.py`, `lines.py` and `remarks.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

# Words that stand before what does not hold, or change a number or a sign.
DENIED = re.compile(
    r"\b(?:not?|never|nicht|keine?|false|wrong|falsch\w*|instead|statt|нет|не|вместо|неверно|pas|faux"
    r"|signs?|\w*vorzeichen\w*|знак\w*|signe|signo|segno|reversed|umgekehrt\w*|moins|menos|meno|doble|doppio|moitié|mitad|metà)\b|[不非错反]",
    re.I,
)
_NEVER = (
    r"not?|never|nicht|kein|не|ні|нет|pas|non|nie|instead\s+of|statt|anstatt|вместо|замість|au\s+lieu\s+de|en\s+vez\s+de|zamiast"
    r"|不是|并非"
)
# What judges an equation, wherever it stands in the line.
JUDGED = re.compile(
    r"\b(?:wrong(?:ly)?|incorrect|false|invalid|mistakes?|crossed|struck|cancel(?:led)?|ignore|falsch\w*|fehlerhaft\w*|fehler|ungültig\w*|неверн\w*|неправильн\w*"
    r"|ошиб\w+|зачеркнуто|неправд\w*|ложь|невірн\w*|хибн\w*|помилк\w*|faux|fausse|erroné\w*|źle|błędn\w*|sbagliat\w*|errat[oa]|incorrect[oa]|erróne\w*|yanlış)\b"
    rf"|\b(?:{_NEVER})\s+(?:true|right|correct|so|richtig|wahr|so|так|верно|правильно|вірно|vrai)\b|[错誤]误?(?!差)|划掉|不(?:对|正确|成立)|[✗✘❌]"
    # That its sign is another one.
    r"|\b(?:signs?|\w*vorzeichen|знак\w*|signe|signo|segno|znak\w*)\s+(?:is\s+|are\s+|to\s+be\s+|ist\s+)?"
    r"(?:reversed|changed|flipped|inverted|opposite|umgekehrt|vertauscht|обратн\w*|противополож\w*|протилежн\w*|inversé|contraire|contrario|cambiado|opposto|przeciwn\w*)"
    r"|\b(?:reversed|changed|flipped|inverted|opposite|other|umgekehrte\w*|andere\w*|falsche\w*|обратн\w*|друг\w+|противополож\w*|протилежн\w*|przeciwn\w*)"
    r"\s+(?:signs?|vorzeichen|знак\w*|znak\w*)\b|反号|符号相反|opposite\s+direction",
    re.IGNORECASE,
)
_BEFORE = re.compile(rf"(?<![^\W\d_])(?:{_NEVER})[\s:(\[{{$]+(\\?[^\W\d]\w*)", re.IGNORECASE)
_ALONE = re.compile(rf"^[\s(\[]*(?:{_NEVER})\s*[):\]]|[(,;–—]\s*(?:{_NEVER})[\s)\].!]*$", re.IGNORECASE)


def is_denied(line: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether a line says of its own equation that it does not hold; "D does not move: v = r*w" does not.

    >>> [is_denied(line, "vrw".__contains__) for line in ("not: (v = r*w)", "Wrong: v = r", "v = r (sign reversed)")]
    [True, True, True]
    >>> [is_denied(line, "vrw".__contains__) for line in ("D does not move: v = r*w", "v = r*w (no slip)", "no. 2: v = r*w")]
    [False, False, False]
    """
    if "=" not in line:
        return False
    return bool(JUDGED.search(line) or _ALONE.search(line) or any(is_single(found[1]) for found in _BEFORE.finditer(line)))
