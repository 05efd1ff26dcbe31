"""What the TOML reader objects to -> a sentence for someone who has never heard of TOML.

Enters: the reader's own message and the text.  Leaves: a `Fault` with line and column.  Used by `source.py`.
"""

from __future__ import annotations

import re

from coursework.variant.formula.alphabet import foreign_letter
from coursework.words.errors import Fault
from coursework.words.sentences import say

_QUOTES = re.compile("[“”„«»‘’]")
# What the reader's message begins with -> the last part of the key of the advice.
_ADVICE = (
    ("Cannot overwrite", "key_twice"),
    ("Cannot mutate", "key_or_section_twice"),
    ("Illegal character '\\n'", "quote"),
    ("Found invalid character '\\r'", "line_ends"),
    ("Unterminated string", "quote"),
    ('Expected "\'"', "single_quote"),
    ("Illegal character", "unprintable"),
    ("Unescaped", "backslash"),
    ("Expected '=' after a key", "equals"),
    ("Expected ']'", "bracket"),
    ("Unclosed array", "open_list"),
    ("Unclosed inline table", "open_table"),
    ("Invalid initial character for a key part", "key"),
    ("Invalid value", "value"),
    ("Exceeds the limit", "digits"),
    ("maximum recursion", "nested"),
)


def explained(message: str, text: str, file: str) -> Fault:
    """Return the fault at the place that the reader's message names; at the end of the text where it names none."""
    match = re.search(r"^(.*?) \(at (?:line (\d+), column (\d+)|end of document)\)", message, re.DOTALL)
    lines = text.split("\n")
    reason = match[1] if match else message
    line, column = (int(match[2]), int(match[3])) if match and match[2] else (len(text.rstrip("\n").split("\n")), 0)
    if not match:
        line = 0
    found = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    advice = _advice(reason, found)
    told = say("fault.V009", advice=advice, found=found[:60]) if found else say("fault.V010", advice=advice)
    return Fault(told, file, line, column)


def _advice(reason: str, found: str) -> str:
    if twice := re.match(r"Cannot declare \((.*?),?\) twice", reason):
        return say("fault.toml.section_twice", name=twice[1].replace("'", "").replace(", ", "."))
    if _QUOTES.search(found) and not reason.startswith("Cannot"):
        return say("fault.toml.straight")
    if reason.startswith("Expected newline"):
        return _after_a_value(found)
    if reason.startswith("Invalid statement"):
        return _no_key(found)
    for begin, key in _ADVICE:
        if reason.startswith(begin):
            return say(f"fault.toml.{key}")
    return reason[:1].lower() + reason[1:]


def _after_a_value(found: str) -> str:
    value = found.partition("=")[2].strip()
    if re.match(r"[-+]?\d+,\d", value):
        return say("fault.toml.point")
    if unit := re.match(r"([-+]?[\d.]+\s*[A-Za-z°/][\w/^]*)", value):
        return say("fault.toml.unit", value=unit[1])
    return say("fault.toml.after")


def _no_key(found: str) -> str:
    key = found.partition("=")[0].strip()
    if strange := foreign_letter(key):
        return say("fault.toml.letter", number=strange[0] + 1, strange=strange[1])
    if key and not key.isascii() and "=" in found:
        return say("fault.toml.greek", key=key)
    return say("fault.toml.line")
