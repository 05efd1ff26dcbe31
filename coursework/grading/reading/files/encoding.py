"""Bytes -> text, in whatever encoding a spreadsheet saved it.

Enters: the bytes of a text file.  Leaves: `Decoded`; never raises, uses no numbers of the text.
Used by whatever reads a file of a student or of a platform.
"""

from __future__ import annotations

import codecs
import re
from itertools import pairwise

from coursework.system.frozen import frozen

MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be"))
# Words found in the headers of such tables; each counts 50 points in the score, a plausible letter 0.5 to 5 points.
_DOMAIN = re.compile(
    "рад|град|кут|угол|угл|время|час|швидк|скорость|вариант|варіант|таблиц|об/мин|об/хв|1/с|группа|група|студент|сек|вал|крив|"
    "角|时间|時間|速度|弧度|度|秒|表|学号|姓名|"
    "winkel|zeit|geschwindigkeit|größe|grad|für|über|schritt",
)
_MIXED = re.compile("[a-z][а-я]|[а-я][a-z]")  # no word mixes both alphabets
_SEARCHED = 200_000
_SAMPLE = 4000


@frozen
class Decoded:
    """A text, the name of its encoding, and whether NUL bytes were removed from it."""

    text: str
    encoding: str
    had_nuls: bool


def decode(content: bytes) -> Decoded:
    """Return the text of a file: by byte order mark, else UTF-16 if every second byte is 0, else strict UTF-8.

    If none of these fits, take the most likely of cp1251, gb18030, cp1252 and cp866.

    >>> decode("кут, рад;1,5".encode("cp1251")).encoding
    'cp1251'
    """
    for mark, encoding in MARKS:
        if content.startswith(mark):
            return _clean(content[len(mark) :].decode(encoding.removesuffix("-sig"), errors="replace"), encoding)
    if wide := _utf16_without_mark(content):
        return _clean(content.decode(wide, errors="replace"), wide)
    try:
        return _clean(content.decode("utf-8"), "utf-8")
    except UnicodeDecodeError:
        # Only lines with non-ASCII characters tell one encoding from another.
        lines = (line for line in content[:_SEARCHED].splitlines() if not line.isascii())
        sample = b"\n".join(lines)[:_SAMPLE]
    encoding = max(("cp1251", "gb18030", "cp1252", "cp866"), key=lambda name: _score(sample, name))
    return _clean(content.decode(encoding, errors="replace"), encoding)


def _utf16_without_mark(content: bytes) -> str:
    """Return the UTF-16 encoding of a text in which most of every second byte are 0, "" for any other text."""
    sample = content[:2000]
    if len(sample) < 8 or len(content) % 2:
        return ""
    even, odd = sample[0::2].count(0), sample[1::2].count(0)
    if odd > 0.6 * len(sample) / 2 and even == 0:
        return "utf-16-le"
    return "utf-16-be" if even > 0.6 * len(sample) / 2 and odd == 0 else ""


def _clean(text: str, encoding: str) -> Decoded:
    bare = text.replace("\0", "") if "\0" in text else text
    return Decoded(bare.replace("\r\n", "\n").replace("\r", "\n"), encoding, len(bare) < len(text))


def _score(sample: bytes, encoding: str) -> float:
    """Return a score of how well a decoding fits the text of a table: table words, plausible letters, no odd characters."""
    text = sample.decode(encoding, errors="replace")
    judge = {"gb18030": _chinese, "cp1252": _german}.get(encoding, _cyrillic)
    lowered = text.lower()
    score = 50.0 * len(_DOMAIN.findall(lowered)) - 6.0 * len(_MIXED.findall(lowered))
    for before, letter in pairwise(" " + text):
        if letter == "\ufffd" or not (letter.isprintable() or letter.isspace()):
            score -= 20
        elif not letter.isascii() and letter not in "\u00a0\u202f":
            score += judge(before, letter)
    return score if encoding != "cp866" else 0.9 * score


def _cyrillic(before: str, letter: str) -> float:
    if "а" <= letter.lower() <= "я" or letter.lower() in "іїєґё":
        # A capital letter inside a word shows that the encoding is wrong.
        return -2 if letter.isupper() and before.islower() else 2
    return 1 if letter in "№°·×−–—«»" else -2


def _german(before: str, letter: str) -> float:
    if letter in "äöüßÄÖÜéèàçñáíóúêâî":
        return 1 if before.isascii() else -1
    return 0.5 if letter in "°²³·µ×−–—" and before.isascii() else -2


def _chinese(before: str, letter: str) -> float:
    """Score a character by its code: common characters come first in GB 2312, two random bytes land anywhere."""
    raw = letter.encode("gb18030", errors="ignore")
    return 5 if len(raw) == 2 and (0xB0 <= raw[0] <= 0xD7 or 0xA1 <= raw[0] <= 0xA6) and raw[1] >= 0xA1 else -3
