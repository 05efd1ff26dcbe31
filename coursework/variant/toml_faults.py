"""What the TOML reader objects to -> a sentence for someone who has never heard of TOML.

Enters: the reader's own message and the text.  Leaves: a `Fault` with line and column.  Used by `source.py`.
"""

from __future__ import annotations

import re

from coursework.errors import Fault
from coursework.formula.alphabet import foreign_letter

_QUOTES = re.compile("[“”„«»‘’]")
# What the reader's message begins with -> advice.
_SENTENCES = (
    ("Cannot overwrite", "this key stands twice; keep one of the two"),
    ("Cannot mutate", "this key or section stands twice; keep one of the two"),
    ("Illegal character '\\n'", 'a quotation mark " is missing at the end of the text'),
    ("Unterminated string", 'a quotation mark " is missing at the end of the text'),
    ('Expected "\'"', "a quotation mark ' is missing at the end of the text"),
    ("Illegal character", "a text contains a letter that does not print; remove it"),
    ("Unescaped", "a backslash in a text is written twice: \\\\"),
    ("Expected '=' after a key", 'a key is followed by "=": key = value'),
    ("Expected ']'", "a bracket ] is missing after the name of a section"),
    ("Unclosed array", "a list is not closed: a comma or ] is missing"),
    ("Unclosed inline table", "a table in braces stands on one line: a comma or } is missing"),
    ("Invalid initial character for a key part", "a key was expected here: letters, digits, _ and - only"),
    ("Invalid value", 'a number, or a text in quotation marks " ", was expected'),
    ("Exceeds the limit", "a number has too many digits"),
    ("maximum recursion", "keys or lists are nested beyond what a variant needs"),
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
    sentence = _sentence(reason, found)
    shown = f' (found "{found[:60]}")' if found else ""
    return Fault(f"the file is not TOML here: {sentence}{shown}.", file, line, column)


def _sentence(reason: str, found: str) -> str:
    if twice := re.match(r"Cannot declare \((.*?),?\) twice", reason):
        return f"the section [{twice[1].replace(chr(39), '').replace(', ', '.')}] stands twice; put its lines together"
    if _QUOTES.search(found) and not reason.startswith("Cannot"):
        return 'quotation marks are the straight ones, " "'
    if reason.startswith("Expected newline"):
        return _after_a_value(found)
    if reason.startswith("Invalid statement"):
        return _no_key(found)
    for begin, sentence in _SENTENCES:
        if reason.startswith(begin):
            return sentence
    return reason[:1].lower() + reason[1:]


def _after_a_value(found: str) -> str:
    value = found.partition("=")[2].strip()
    if re.match(r"[-+]?\d+,\d", value):
        return "decimals are written with a point: 0.5"
    if unit := re.match(r"([-+]?[\d.]+\s*[A-Za-z°/][\w/^]*)", value):
        return f'a value with a unit stands in quotation marks: "{unit[1]}"'
    return "nothing may follow the value; a text stands in quotation marks"


def _no_key(found: str) -> str:
    key = found.partition("=")[0].strip()
    if strange := foreign_letter(key):
        return f"letter {strange[0] + 1} of the key is the {strange[1]}; names use Latin or Greek letters"
    if key and not key.isascii() and "=" in found:
        return f'a key with Greek letters stands in quotation marks: "{key}" = …'
    return "a line is a [section], key = value, or a remark after #"
