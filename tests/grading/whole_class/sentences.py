"""The sentences of a page or a comment, found again by the words file.

Enters: a text, a page.  Leaves: (key, values) of its sentences, and what no sentence explains.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from string import Formatter

from tests.grading.pages.seen import plain

WORDS = Path(__file__).parents[3] / "reports" / "words.en.toml"
ROOMS = ("feedback", "marking", "reading", "fault")
FEWEST = 8  # letters of its own in a sentence
BLOCKS = re.compile(r"</?(?:p|li|td|th|h\d|div|tr|section|figcaption|figure|svg|code|header|br|ol|ul)\b[^>]*>")
Values = Mapping[str, str]
Said = tuple[str, Values]


def _leaves(entries: Mapping[str, object], path: str = "") -> dict[str, str]:
    found: dict[str, str] = {}
    for key, value in entries.items():
        found |= _leaves(value, f"{path}{key}.") if isinstance(value, dict) else {f"{path}{key}": str(value)}
    return found


@cache
def _patterns() -> list[tuple[str, int, re.Pattern[str], list[str]]]:
    """Return for each sentence that ends like one how many letters of its own it has, a pattern, its words between gaps.

    The gaps are named groups of the pattern.
    """
    words = tomllib.loads(WORDS.read_text(encoding="utf-8"))
    found = []
    for key, text in _leaves({room: words[room] for room in ROOMS}).items():
        literal = sum(len(part.strip()) for part, *_ in Formatter().parse(text))
        if not text.endswith((".", ":", ".”", "”")) or literal < FEWEST:
            continue
        pieces, names, own = [], set(), list[str]()
        for part, name, _, _ in Formatter().parse(text):
            pieces.append(re.escape(plain(part)) if part.strip() else part)
            own += [plain(part)] if part.strip() else []
            if name is not None:
                pieces.append("(.{0,400}?)" if name in names or not name else f"(?P<{name}>.{{0,400}}?)")
                names.add(name)
        found.append((key, literal, re.compile("".join(pieces) + r"(?=\s|$)"), own))
    return found


@cache
def sentences(text: str) -> tuple[tuple[Said, ...], str]:
    """Return the sentences of a text with their values, and what is left over."""
    text, found, rest, place = plain(text).strip(), [], "", 0
    possible = [one for one in _patterns() if all(words in text for words in one[-1])]
    while place < len(text):
        fits = [(own, key, match) for key, own, pattern, _ in possible if (match := pattern.match(text, place))]
        if fits:
            _, key, match = max(fits, key=lambda fit: fit[0])
            found.append((key, match.groupdict()))
            place = match.end()
            while text[place : place + 1] == " ":
                place += 1
        else:
            rest, place = rest + text[place], place + 1
    return tuple(found), rest.strip()


def of_page(page: str) -> Iterator[Said]:
    """Give the sentences of a page, block by block."""
    body = re.sub(r"<style>.*?</style>|<code>.*?</code>|<table>.*?</table>|<svg.*?</svg>", " ", page, flags=re.DOTALL)
    for block in BLOCKS.split(body):
        yield from sentences(block)[0]
