"""Whether words and marks around an equation say that it does not hold: "wrong: …", "not …", "… (sign reversed)".

Enters: a line, a test for single names.  Leaves: the answer.  Used by `edges.py`, `labels.py`, `lines.py` and `remarks.py`.
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
# What judges an equation, wherever it stands in the line; "crossed" alone is a mechanism, "ignore friction" no judgement.
_JUDGED = re.compile(
    r"\b(?:wrong(?:ly)?|incorrect|false|invalid(?!\s+(?:at|for|if|in|when)\b)|mistakes?|(?:crossed|struck)\s+(?:out|through|off)"
    r"|(?:ignore|cancel(?:led)?)(?:\s+(?:this|that|it|line))*\s*(?:[)\]:.!]|$)"
    r"|falsch\w*|fehlerhaft\w*|fehler|ungültig\w*|неверн\w*|неправильн\w*|ошиб\w+|зачеркнуто|неправд\w*|ложь|невірн\w*|хибн\w*|помилк\w*"
    r"|faux|fausse|erroné\w*|źle|błędn\w*|sbagliat\w*|errat[oa]|incorrect[oa]|erróne\w*|yanlış)\b"
    rf"|\b(?:{_NEVER})\s+(?:true|right|correct|so|richtig|wahr|так|верно|правильно|вірно|vrai)\b"
    r"|=\s*0\s*(?:≠|!=|\\neq?\b)|(?<!交)[错誤]误?(?!差)|划掉|不(?:对(?![称心])|正确|成立)|[✗✘❌]",
    re.IGNORECASE,
)
# That its sign is another one, unless all of it was moved or multiplied, or the sign is that of another book.
_SIGNED = re.compile(
    r"\b(?:signs?|\w*vorzeichen|знак\w*|signe|signo|segno|znak\w*)\s+(?:is\s+|are\s+|to\s+be\s+|ist\s+)?"
    r"(?:reversed|changed|flipped|inverted|opposite|umgekehrt|vertauscht|обратн\w*|противополож\w*|протилежн\w*|inversé|contraire|contrario|cambiado|opposto|przeciwn\w*)"
    r"|\b(?:reversed|changed|flipped|inverted|opposite|other|umgekehrte\w*|andere\w*|falsche\w*|обратн\w*|друг\w+|противополож\w*|протилежн\w*|przeciwn\w*)"
    r"\s+(?:signs?|vorzeichen|знак\w*|znak\w*)\b|反号|符号相反",
    re.IGNORECASE,
)
_MOVED = re.compile(
    r"\b(?:both|all|sides?|mov\w+|multipl\w+|convention\w*|than|beide\w*|seiten?|als|обе\w*|сторон\w*|перен[её]с\w*|перенос\w*|умнож\w+|чем)\b"
    r"|[-−]1\b|移项",
    re.IGNORECASE,
)
# What takes a judgement back: "not wrong", "no mistake", "ошибки нет", "corrected".
_TAKEN_BACK = re.compile(
    r"\b(?:not?|never|without|nicht|keine?|ohne|не|ни|нет|без|немає|pas|sans|non|sin|senza|bez)\s+(?:an?\s+|any\s+)?"
    r"(?:wrong|incorrect|false|mistakes?|ignore|falsch|fehler|неверно|ошиб\w+|помил\w+|faux|erroné|errores|errori|błęd\w*)\b"
    r"|\b(?:ошиб\w+|помил\w+)\s+(?:нет|немає)\b|(?:没有|无)错误?"
    r"|\b(?:corrected|fixed|korrigiert|berichtigt|исправл\w+|виправл\w+|corrigée?s?|corregid[oa]s?|corrett[oae]|poprawion\w*)\b|[更修]正",
    re.IGNORECASE,
)
# A name behind such a word begins an equation, not "(r2, not r1)"; before a colon it ends a sentence, "it turns not: v = …".
_BEFORE = re.compile(rf"(?<![^\W\d_])(?:{_NEVER})[\s(\[{{$]+(\\?[^\W\d]\w*)(?=[^=,;:]*=)", re.IGNORECASE)
_ALONE = re.compile(rf"^[\s(\[]*(?:{_NEVER})\s*[):\]]|[(,;–—]\s*(?:{_NEVER})[\s)\].!]*$", re.IGNORECASE)


def is_judged(text: str) -> bool:
    """Return whether words or marks say that an equation is wrong or has another sign.

    >>> [is_judged(text) for text in ("# wrong", "(sign reversed)", "crossed out", "v ✗")]
    [True, True, True, True]
    >>> [is_judged(text) for text in ("wrong sign corrected", "no mistake", "crossed bars", "signs changed: all moved")]
    [False, False, False, False]
    """
    if _TAKEN_BACK.search(text):
        return False
    behind = text.rpartition("=")[2]  # "with the opposite sign: v = …" tells which equation comes
    return bool(_JUDGED.search(text) or (_SIGNED.search(behind) and not _MOVED.search(text)))


def is_denied(line: str, is_single: Callable[[str], bool]) -> bool:
    """Return whether a line says of its own equation that it does not hold; "D does not move: v = r*w" does not.

    >>> [is_denied(line, "vrw".__contains__) for line in ("not: (v = r*w)", "not v = r", "Wrong: v = r", "v = r (sign reversed)")]
    [True, True, True, True]
    >>> [is_denied(line, "vrw".__contains__) for line in ("D turns not: v = r*w", "v = r*w (r, not w)", "no. 2: v = r*w")]
    [False, False, False]
    """
    if "=" not in line:
        return False
    return is_judged(line) or bool(_ALONE.search(line)) or any(is_single(found[1]) for found in _BEFORE.finditer(line))
