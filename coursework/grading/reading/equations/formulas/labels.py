"""A line with numbers, names of links and axes, words, remarks and units around its equation -> the equation alone.

Enters: a line in plain signs, a test for names.  Leaves: the possible equations of the line, the most likely first.
Used by `equations.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import lru_cache

from coursework.grading.reading.equations.formulas.denials import DENIED
from coursework.grading.reading.equations.notation.signs import ARROW, depths, relates_two_sides
from coursework.grading.reading.unit_names import unit_of

_WORD = r"(?:equation|eqn?|gleichung|gl|уравнение|ур|рівняння|рівн|ф-ла|формула|formula|方程|式|№|no)"
_MARKS = "☐☑☒•‣⁃▪▫◦●○■□◆◇▸▹►▻▶▷➢➤➔✓✔✅★☆❖🔹🔸👉"  # of the items of a list
_LABEL = re.compile(
    rf"[\s$]*(?:[*{_MARKS}]\s+|[-–]\s\[[ x]\]\s)?(?:[(\[]?{_WORD}[\s.№]*\(?\d{{1,3}}(?!\d)[a-zа-я]?\)?\]?\s*"
    r"(?:[:)]|\.(?!\d))?(?!\s*:?=)(?=\s|\w|[-+−(.])"
    r"|[(\[{<](?:%[io]\d{1,3}|\d{1,3}(?:\.\d{1,3})?(?:['a-zа-я]|\.[a-zа-я])?|[A-ZА-Я]\.\d{1,3}|\*{1,3})[)\]}>]\s*(?::|\.(?!\d))?(?!=)"
    r"|[\u2460-\u249b\u2776-\u2793]\s*|\d{1,2}\ufe0f?\u20e3\s*|[\u2160-\u217f]{1,3}[).:]?\s+|\d{1,3}/\s+|[a-zа-я]\.\s+|[(\[](?:O?[A-ZА-Я]|[A-Z]{1,2}\d{1,2})[)\]]:?\s+(?![+=*/·])|(?:\d{1,2}|O[xyXY])\s*\|\s+|[A-Z]{1,4}\d{1,3}\.\s+|\d{1,3}[)\]]\s*|\d{1,3}(?:\.\d{1,2})*[.:](?=\s)(?!=)|\d{1,3}\s*[°º]\.?\s*"
    r"|\(?[IVXivx]{1,5}[).]\s+|\*\*[^*=]{1,30}\*\*[:.]?\s*|\*\s+|>\s+|[|{⎧⎨⎪⎩]\s+"
    rf"|(?<=[{_MARKS}\]]\s))\s*",
    re.IGNORECASE,
)
_LABEL_AT_END = re.compile(
    r"(?:\s|(?<=[,;])|(?<![.…])(?=[.…]{3}))(?:[-–—.…]+\s*)?(?:[(\[/<]"
    rf"(?:(?i:{_WORD}[\s.№]*)?\d{{1,3}}(?:[.,]\d{{1,3}})?['a-zа-я]?|\*{{1,3}}|[IVX]{{1,5}})[)\]/>]"
    rf"|(?i:{_WORD})[\s.№]*\(?\d{{1,3}}\)?|(?:—|--)\s?\d{{1,3}}|\((?:[ivx]{{2,5}}|(?<=[-–—.…]{{2}}\s\()[ivx])\)|[\u2460-\u249b\u2776-\u2793])\s*$"
)
_VANISHES = re.compile(r"(=\s*0(?:[.,]0+)?)(?!\w|[.,]\d)(?!\s*[-+*/^])")
_UNIT_AT_END = re.compile(r"[,;]?\s{0,9}(?:\[([^\[\]]{1,12})\]|\(([^()]{1,12})\)|(?:,|(?<=[\w)])\s)\s*(\S{1,8}))\s*[.,;]?\s*$")
_TO_BE_DONE = re.compile(r"\s(?:\|\s*[-+*/:]|/\s*[*:])\s*[-\w.,()*]{1,20}\s*$")  # an operation on both sides: "= 0 | *2"
_SAYS_SO = re.compile(
    r"\s*(?:\b(?:holds?|is\s+(?:true|valid|satisfied)|gilt|ist\s+erfüllt|выполняется|справедливо|виконується|est\s+vérifiée)\b|成立)"
    r"[^=]{0,60}$",
    re.IGNORECASE,
)
_WORDS = re.compile(r"[\s:,.–-]*([^\W\d_]+(?:\.[^\W\d_]+)*)\.?(?=[\s:,.(]|-[^\W\d_]{3}|$)(?!\s*=)")
_SENTENCE = re.compile(r"[^=]*[^\W\d_][\w)]{0,40}[.:!]\s+(?=[A-ZА-ЯІЇЄ][^\W\d_]+\s)")  # one before that with the equation
_ASIDE = re.compile(r"[\s,.:–-]*\(([^()=]{1,40})\)[\s,.:]*(?=[^\s*/^)=])")
_COUNTED = re.compile(
    r"(?:link|bar|point|step|schritt|case|part|loop|звен|ланк|точк|шаг|крок|пункт|контур|构件|杆)\w*\.?\s*$", re.IGNORECASE
)
_NUMBER = re.compile(r"\s*\d{1,3}(?:\t|\s\s|\s(?=[-+]))\s*")
_SAID_IN_WORDS = re.compile(r"(?:\s(?:--?|[–—!'\"])|\s?;)\s*((?:[^\W\d_]+[\s,.]+)+[^\W\d_]+)[.;]?\s*$")
_SAID = re.compile(
    r"[,;.](?:\s+|(?=[\u3400-\u9fff]))([^\W\d_]{2,}|(?:[^\W\d_]\.){2})|(?<=[\w)])\s+(for|at|when|if|because|since|and|und|et|which|где|при|для|если|когда|якщо|коли|бо|für|bei|wenn|weil|pour)\s"
)
# "= r*w1 along and across the lever:"
_WORDS_BEHIND = re.compile(r"(?:(?<=\))|(?<=[^\w.])(\w+))\s((?:[^\W\d_]{2,}[\s,]+){2,}[^\W\d_]{2,})[.:;]?\s*$")
_VERB = re.compile(r"(?<=\))\s([^\W\d_]{4,20})\.\s*$")  # "= a*w1*cos(phi) olur."
_NOTED = re.compile(r"\s\[([^\W\d_]{2,20})[.\s][^\[\]=*/+]{1,40}\]\s*$")  # "= u   [eq. of x]"
_ONLY_WORDS = re.compile(r"[^=*/+()]{0,60}")  # behind an arrow: "= u → x axis"
_LEADER = re.compile(r"\s(?:\.{3,9}|…)\s*([^\W\d_]{3,20})[^=*/+]{0,60}$")  # "= u ... from the yoke"
ASIAN = "\u3040-\u30ff\u3400-\u9fff\uac00-\ud7af"  # letters of Japanese, Chinese and Korean
_ASIAN_BEHIND = re.compile(rf"(?<![{ASIAN}])[{ASIAN}][{ASIAN}\s.,;:]*$")  # "= u 이다."
_POINTS = re.compile(r"^(?:[ :,]|\.(?!\d))+", re.ASCII)  # after the words; a point before a digit is decimal
# Words behind an equation that change it, and a term there.
CHANGES = re.compile(
    r"\b(?:opposite\s+sign|half|halved|twice|doubled?|minus|plus|times|squared|negated|negative|divided|multiplied|halb\w*|doppelt\w*|mal|durch(?!\s+(?:Punkt|de[nr]|das|die))|geteilt"
    r"|половин\w*|пополам|вдвое|удво\w*|минус|плюс|умнож\w*|дел[её]н\w*|мінус|помнож\w*)\b"
    r"|半(?![径徑圆圓周圈])|[倍负負]|[减減](?!速)|乘(?!积)|除(?!了)|加(?!速)|절반|배|빼기|더하기",
    re.IGNORECASE,
)
# Such words that change nothing: part of a turn, when it holds, one length of the drawing told by another, an axis.
_KEEPS = re.compile(
    r"\b(?:for|in|during|after|on|every|each|first|second|für|während|nach|ersten?|на|за|в|после|перв\w{2}|втор\w{2})\s+"
    r"(?:a\s+|the\s+|der\s+|die\s+|eine\s+)?(?:half|halbe[nr]?|половин[аеуы])\s+(?:a\s+|of\s+(?:a|the)\s+|der\s+)?"
    r"(?:turn|revolution|period|cycle|Umdrehung|Periode|оборота|периода)\b"
    r"|\b[A-Z]{2}\s+(?:is|ist)\s+(?:twice|half|doppelt\s+so\s+lang\s+wie)\s+(?:of\s+)?[A-Z]{2}\b|\bhalf\s+of\s+[A-Z]{2}\s+is\s+\w{1,3}\b"
    r"|\b(?:all|these|other)\s+times\b|\btimes\s+are\s+in\b|\bprojection\s+on(?:to)?\s+the\s+negative\s+[xy](?:[\s-]axis)?\b",
)
# Why there is a minus, or a plus; said of an equation that has none, it may be one that is missing.
_WHY = (
    r"(?i:\b(?:(?:the|das)\s+)?(?:знак\s+)?(?:{})(?:\s+sign|zeichen)?\s*(?::|,?\s+(?:because|since|as|means|shows|says|weil|da|bedeutet|heißt"
    r"|так\s+как|потому|означает|показывает|бо|оскільки|означає)\b)|{}号(?:表示|说明|意味|是因为))"
)
_WHY_MINUS, _WHY_PLUS = (re.compile(_WHY.format(*words)) for words in (("minus|минус|мінус", "[负負]"), ("plus|плюс", "正")))
_TERM = re.compile(rf"[\s,.;]*(?:[^\W\d_]{{2,12}}\s+|{ARROW}|\()\s*[-+−–]\s*([^\W_]\w*)")
_RATIO = re.compile(r"[\w)]\s*:\s*[\w(][^=:]*=[^=:]*[\w)]\s*:\s*[\w(][^=:]*$")
_TABBED = re.compile(r"^\s*\d{1,3}\t")
_ASIDE_AT_END = re.compile(rf"(?:\s|(?=\([^()=]{{0,39}}[{ASIAN}]))\(([^()=]{{1,80}})\)[.,;]?\s*$")
_POINT_AT_END = re.compile(r"(?<=\S)\s+\([A-Z]\)[.,;]?\s*$")
_NUMBERED = re.compile(r"\s*\d{1,3}\s[-–—]\s")
_ASIAN_BEFORE = re.compile(rf"[{ASIAN}][:,]?\s*")
_NUMBER_BEHIND = re.compile(r"\s+\d")  # a number after a blank: "at point P 2*r3*w3"; no factor is followed by one
_GLUED = re.compile(r".(?:sin|cos)$")  # names written together with a function: vCcos φ2 is no word
_AXES = ("x", "y", "z", "ox", "oy")
_PREPOSITIONS = (*"авзікосу",)  # Cyrillic prepositions of one letter
_ADDED = re.compile(r"\s+[-+−–]\s")  # behind a single word, which may be a name that the task does not have
_NEAR = 60  # so far before a number its word stands
_LONG = 5  # a word of at least this many letters is not a symbol
_SEVERAL = 3  # so many words are no term, even if the first is a name
_SHORT = 3  # up to this many capitals are a name: BC, AB


def label_of(text: str) -> str:
    """Return the label at the beginning of a line, "" if there is none.

    >>> [label_of(text) for text in ("(16) -0.5*r3", "16) -", "[16] -", "Eq. 3: w1", "(1): w1", "2*w1 = 0", "(2*r1 + 1)*w1")]
    ['(16) ', '16) ', '[16] ', 'Eq. 3: ', '(1): ', '', '']
    """
    found = _LABEL.match(text)
    return found[0] if found and len(found[0]) < len(text) else ""


@lru_cache(1024)  # several readers look at the same line in turn
def without_labels(text: str) -> str:
    """Return a line without the label at its beginning and the number of the equation at its end."""
    text = text[len(label_of(text)) :]
    found = _LABEL_AT_END.search(text)
    is_label = found and relates_two_sides(text[: found.start()].rstrip(" \t=≡＝"))
    return text[: found.start()] if found and is_label else text


def bare_equations(text: str, is_name: Callable[[str], bool]) -> Iterator[str]:
    """Yield the possible equations of a line: without everything around it, then without its label, then the whole line.

    >>> [next(bare_equations(text, {"w1", "w3"}.__contains__)) for text in ("(1) link 3: w3 = 2", "so w3 = 2*w1, 1/s")]
    ['w3 = 2', 'w3 = 2*w1']
    """
    text = _TABBED.sub("", text)
    bare = without_labels(text)
    begun = without_labels(_begun(bare, is_name)).strip()
    for candidate in (begun, _without(_NUMBER, begun), _without(_NUMBERED, begun)):
        ended = _ended(candidate, is_name)
        yield from dict.fromkeys((ended, candidate) if candidate else ())
    yield from (bare, text)
    if named := _POINT_AT_END.search(text):  # "= u (C)": where there is a length c, C may be the point that is meant
        yield from bare_equations(text[: named.start()], is_name)


def _begun(text: str, is_name: Callable[[str], bool]) -> str:
    """Return a line from the start of its equation: after an arrow, a colon, an unopened closing bracket, or words."""
    before = text.rpartition("=")[0]
    for sign in (ARROW, ":"):
        is_ratio = sign == ":" and _RATIO.search(text) and is_name(before.partition(":")[0].strip())  # w2 : w1 = r1 : r2
        if sign in before and "lambda" not in before and not is_ratio:
            text = text[before.rindex(sign) + 1 :]
            before = text.rpartition("=")[0]
    inside = depths(text.partition("=")[0])
    if -1 in inside:
        text = text[inside.index(-1) + 1 :]
    start = 0
    for found in _ASIAN_BEFORE.finditer(text.partition("=")[0]):
        start = found.end()
    return without_words(text[start:], is_name)


def without_words(text: str, is_name: Callable[[str], bool]) -> str:
    """Return a line without the words before its equation, their remarks in parentheses, and the number of a link."""
    if sentence := _SENTENCE.match(text):
        text = text[sentence.end() :]
    start = 0
    while (found := _WORDS.match(text, start)) and found.end() < len(text):
        if not _is_prose(found[1], is_name, start) and not _is_point(text, found, is_name, start):
            break
        start = found.end()
        if (aside := _ASIDE.match(text, start)) and _is_said(aside[1], is_name):
            start = aside.end()
        if _COUNTED.search(text, max(start - _NEAR, 0), start) and (number := re.match(r"\s*\d{1,3}[):.,]?\s+", text[start:])):
            start += number.end()
    rest, said = text[start:], text[:start].rstrip()
    if CHANGES.search(said) and not said.endswith(":"):
        return text  # "minus v = …", but not "multiplied by r: v = …"
    is_term = re.match(r"\s*[*/^=]|\(", rest) or (_ADDED.match(rest) and text[:start].strip().isalpha())
    return _POINTS.sub("", rest) if start and not is_term else text


def _is_prose(word: str, is_name: Callable[[str], bool], after: int) -> bool:
    """Return whether a word is neither a name nor an abbreviation; after other words (`after` > 0) x is an axis, C a point."""
    is_axis = word.casefold() in _AXES
    if is_name(word) or word == "lambda" or _GLUED.search(word):
        return is_axis and after > 0
    if len(word) == 1:
        return is_axis or (after > 0 and (word.isupper() or "À" <= word <= "ÿ"))  # "è", "é", "à"
    return is_axis or not word.isupper() or len(word) > _SHORT


def _is_aside(aside: str, is_name: Callable[[str], bool]) -> bool:
    """Return whether parentheses behind an equation hold a remark, "(x axis)" or "(r1 is the crank)", and no factor."""
    words = re.findall(r"[^\W\d]\w*", aside)
    named = [is_name(word) for word in words]
    if any(named) and re.search(r"[-+*/^·]", aside):
        return False
    return bool(words) and (not named[0] or (not any(named[1:]) and sum(len(word) > 2 for word in words[1:]) > 1))


def _is_said(aside: str, is_name: Callable[[str], bool]) -> bool:
    """Return whether parentheses hold a number of the task sheet or words, not a part of the equation."""
    return aside.strip().isdigit() or any(_is_prose(word, is_name, 1) for word in re.findall(r"[^\W\d_]\w*", aside))


def _is_said_in_words(behind: str, is_name: Callable[[str], bool]) -> bool:
    """Return whether words behind a dash are a reason, "C keeps its height", and no term that is taken away."""
    words = re.findall(r"[^\W\d_]+", behind)
    return (not is_name(words[0]) or len(words) >= _SEVERAL) and any(len(word) >= _LONG and not is_name(word) for word in words)


def _is_point(text: str, found: re.Match[str], is_name: Callable[[str], bool], after: int) -> bool:
    """Return whether a possible name is part of prose: the point in "am Punkt C gilt", a preposition, "velocity" in a header."""
    following = _WORDS.match(text, found.end())
    among = following is not None and len(following[1]) > 1 and _is_prose(following[1], is_name, after)
    word = found[1]
    if after > 0 and len(word) == 1 and word.isupper():
        return among or _NUMBER_BEHIND.match(text, found.end()) is not None
    if among and following is not None and len(word) == 1 and word.isupper() and len(following[1]) >= _LONG:
        return True  # "B noktasının hızı", of the point B
    if among and after > 0 and following is not None and len(word) == 1 and len(following[1]) >= _LONG:
        return True  # "Viteza a bratului"
    return among and (word.casefold() in _PREPOSITIONS or len(word) >= _LONG)


def _without(label: re.Pattern[str], text: str) -> str:
    """Return the text after a number that is set apart at the beginning of a line, "" if there is none."""
    found = label.match(text)
    return text[found.end() :] if found else ""


def _ended(text: str, is_name: Callable[[str], bool]) -> str:
    """Return an equation without the remark or unit behind it, unless that changes it, as "halved" or "minus r1*w1" does."""
    ended = _cut(text, is_name)
    behind = text[len(ended) :]
    term = _TERM.match(behind)
    return text if _changes(behind, ended) or (term and (term[1].isdigit() or is_name(term[1]))) else ended


def _changes(behind: str, equation: str) -> bool:
    """Return whether words behind an equation may change it, as "halved" does, and "minus" where none stands in it."""
    for sign, why in (("-", _WHY_MINUS), ("+", _WHY_PLUS)):
        behind = why.sub("", behind) if sign in equation else behind
    return CHANGES.search(_KEEPS.sub("", behind)) is not None


def _cut(text: str, is_name: Callable[[str], bool]) -> str:
    """Return an equation without what stands behind it, such as "= 0, since C keeps its height"."""
    if found := _VANISHES.search(text):
        return text[: found.end()] if not relates_two_sides(text[found.end() :]) else text
    text = _ASIAN_BEHIND.sub("", _SAYS_SO.sub("", _TO_BE_DONE.sub("", text)))
    if (verb := _VERB.search(text)) and "=" in text[: verb.start()] and not is_name(verb[1]):
        text = text[: verb.start()]
    if (noted := _NOTED.search(text)) and "=" in text[: noted.start()] and not is_name(noted[1]) and not unit_of(noted[1]):
        # "2*w3 [cosinus φ3 - 2]" holds a factor
        text = text if any(len(word) > 1 and is_name(word) for word in re.findall(r"\w+", noted[0])) else text[: noted.start()]
    head, arrow, tail = text.partition(ARROW)
    if arrow and "=" in head and _ONLY_WORDS.fullmatch(tail):
        return _ended(head.rstrip(), is_name)
    if (leader := _LEADER.search(text)) and "=" in text[: leader.start()] and not is_name(leader[1]):
        return _ended(text[: leader.start()], is_name)
    aside = _ASIDE_AT_END.search(text)
    if aside and "=" in text[: aside.start()] and _is_aside(aside[1], is_name):
        return _ended(text[: aside.start()], is_name)
    if (behind := _SAID_IN_WORDS.search(text, text.rfind("=") + 1)) and _is_said_in_words(behind[1], is_name):
        return text[: behind.start()]
    words = _WORDS_BEHIND.search(text, text.rfind("=") + 1)
    is_meant = words is None or not (DENIED.search(words[2]) or any(map(is_name, re.findall(r"\w+", words[2]))))
    if words and is_meant and (not words[1] or is_name(words[1])):
        return text[: words.start(2)].rstrip()
    for said_after in _SAID.finditer(text, text.rfind("=") + 1):
        if not is_name(said_after[1] or said_after[2]):
            return text[: said_after.start()]
    found = _UNIT_AT_END.search(text)
    if found and "=" in text[: found.start()]:
        unit = next(group for group in found.groups() if group)
        if unit_of(unit) and not is_name(unit):
            return text[: found.start()]
    return text
