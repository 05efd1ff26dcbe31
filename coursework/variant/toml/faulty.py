"""Why a file is no TOML: the reader's message as advice in a student's words, at the place where the fault is made.

Enters: the message, the text of the file, and its structure.  Leaves: `Fault`s.
Used by `source.py`, which loads it for a faulty file only, and by `mends.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from coursework.variant.formula.alphabet import foreign_letter
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

QUOTES = re.compile("[“”„«»‘’]")
_PLACE = re.compile(r"^(.*?) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)
_OPEN_KEY = re.compile(r"[ \t]*([\w-]+)[ \t]*=")
_SINGLE = re.compile(r"[ \t]*\[[ \t]*(constraint|group|quote)[ \t]*\]")  # these sections stand in double brackets
_STRANGE_NAME = re.compile(r"[\w-]+[^\w=\[{\"#-][^=\[{\"#]*=")  # a name with a prime or a space in it, before its sign
_KEY_EXPECTED = re.compile(r"Invalid statement|Invalid initial character|Expected '=' after|Expected '\]'")
# Start of the TOML reader's message -> the last part of the key of the advice.
_ADVICE = (
    ("Cannot overwrite", "key_twice"),
    ("Duplicate inline table key", "key_twice"),
    ("Cannot mutate", "key_or_section_twice"),
    ("Cannot redefine", "key_or_section_twice"),
    ("Illegal character '\\n'", "quote"),
    ("Unterminated string", "quote"),
    ("Expected \"'", "single_quote"),
    ("Illegal character", "unprintable"),
    ("Found invalid character", "unprintable"),
    ("Unescaped", "backslash"),
    ("Escaped character", "backslash"),
    ("Invalid hex value", "backslash"),
    ("Expected '=' after a key", "equals"),
    ("Expected ']", "bracket"),
    ("Unclosed array", "open_list"),
    ("Unclosed inline table", "open_table"),
    ("Invalid statement", "line"),
    ("Invalid initial character for a key part", "key"),
    ("Invalid value", "value"),
    ("Invalid date", "value"),
    ("Exceeds the limit", "digits"),
    ("maximum recursion", "nested"),
)


def explained(message: str, text: str, structure: Sequence[str], file: str) -> list[Fault]:
    """Return the fault that the reader's message names; if it is a key with foreign letters, also those of all such later keys.

    `structure` are the lines of the text without its strings and comments.
    """
    lines = text.split("\n")
    first = _first(message, lines, structure, file)
    keys = {line: key for line, one in enumerate(structure, start=1) if (key := _OPEN_KEY.match(one)) and not key[1].isascii()}
    found = [first]
    for line, key in keys.items() if first.line in keys else ():
        if line > first.line and (advice := _strange(lines[line - 1], key.start(1))):
            found.append(Fault(_told(advice, lines[line - 1].strip()), file, line, key.start(1) + 1))
    return found


def _first(message: str, lines: Sequence[str], structure: Sequence[str], file: str) -> Fault:
    """Return the fault at the place that the reader's message names, or at the end of the text if it names none."""
    match = _PLACE.search(message)
    reason = match[1] if match else message
    last = max((number for number, one in enumerate(lines, start=1) if one), default=1) if match else 0
    line, column = (int(match[2]), int(match[3])) if match and match[2] else (last, 0)
    line, single = _in_single_brackets(reason, lines, structure, line)
    if reason.startswith("Unclosed array") and line and not lines[line - 1][: max(column - 1, 0)].strip():
        above = enumerate(lines[: line - bool(column)], start=1)  # at the end of the text no column is named
        line = max((number for number, one in above if one.strip() and one.lstrip()[0] != "#"), default=line)
        column = len(lines[line - 1].rstrip()) + 1
    found = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    strange = _strange(lines[line - 1], column - 1) if found and column and _KEY_EXPECTED.match(reason) else None
    advice = single or strange or _of_key(reason, lines[line - 1], column - 1) or _advice(reason, found)
    return Fault(_told(advice, found), file, line, column)


def _in_single_brackets(reason: str, lines: Sequence[str], structure: Sequence[str], line: int) -> tuple[int, str | None]:
    """Return the line of a section in single brackets that stands in double ones elsewhere, and the advice; else `line`, None."""
    begun = []
    here = lines[line - 1] if 0 < line <= len(lines) else ""
    if reason.startswith("Cannot declare"):
        begun = [(line, _SINGLE.match(here))]
    elif reason.startswith("Cannot overwrite") and _SINGLE.match(here.replace("[[", "[").replace("]]", "]")):
        begun = [(number, _SINGLE.match(one)) for number, one in enumerate(structure, start=1)]
    return next(((number, say("fault.toml.double", name=one[1])) for number, one in begun if one), (line, None))


def _told(advice: str, found: str) -> Sentence:
    return say("fault.V009", advice=advice, found=found[:60]) if found else say("fault.V010", advice=advice)


def _strange(line: str, at: int) -> str | None:
    """Return the advice about a key with a foreign letter at offset `at` of a line, None for any other fault."""
    key = next((word[0] for word in re.finditer(r"[\w-]+", line) if word.start() <= at < word.end()), "")
    if strange := foreign_letter(key):
        return say("fault.toml.letter", number=strange[0] + 1, strange=strange[1])
    return None if key.isascii() else say("fault.toml.greek", key=key)


def _of_key(reason: str, line: str, at: int) -> str | None:
    """Return the advice about what stands at offset `at` of a line in place of a key; None for any other fault."""
    if reason.startswith("Expected '=' after") and _STRANGE_NAME.match(line.strip()) and at < line.find("="):
        return say("fault.toml.key")
    if reason.startswith("Invalid initial character") and "{" in line[:at]:
        if line[:at].rstrip().endswith(","):
            return say("fault.toml.last_comma") if line[at : at + 1] == "}" else None
        return say("fault.toml.open_table") if not line[at:].strip() else None
    return None


def _advice(reason: str, found: str) -> str:
    if twice := re.match(r"Cannot declare \((.*?),?\) twice", reason):
        return say("fault.toml.section_twice", name=twice[1].replace("'", "").replace(", ", "."))
    if "\r" in found:
        return say("fault.toml.line_ends")
    if QUOTES.search(found) and not reason.startswith("Cannot"):
        return say("fault.toml.straight")
    if reason.startswith("Expected newline"):
        return _after_a_value(found)
    for begin, key in _ADVICE:
        if reason.startswith(begin):
            return say(f"fault.toml.{key}")
    return reason[:1].lower() + reason[1:]  # of a later Python, whose reader says it otherwise


def _after_a_value(found: str) -> str:
    value = found.partition("=")[2].strip()
    if re.match(r"[-+]?\d+,\d", value):
        return say("fault.toml.point")
    if unit := re.match(r"([-+]?[\d.]+\s*[A-Za-z°/][\w/^]*)", value):
        return say("fault.toml.unit", value=unit[1])
    return say("fault.toml.after_text" if value[:1] in {'"', "'"} else "fault.toml.after")
