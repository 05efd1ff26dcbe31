"""Every gap of a sentence is filled where the sentence is said: read off the code, so that rare sentences need no case."""

import ast
import re
import string
from contextlib import suppress
from pathlib import Path

import coursework
from coursework.words.sentences import load_phrases

CALL = re.compile(r'\b(?:say|said|words|say_count)\(\s*"([\w.-]+)"')


def sentences(entries, path=""):
    """Yield each key with what its sentence, or its last form, is."""
    for key, value in entries.items():
        if isinstance(value, str):
            yield path + key, value
        else:
            yield from sentences(value, f"{path}{key}.")
            if "other" in value:
                yield path + key, value["other"]


def gaps(template):
    return {name.partition(".")[0].partition("[")[0] for _, name, _, _ in string.Formatter().parse(template) if name}


def call_at(text, begin):
    """Return the call that begins at a place of the code, None for the sketch of one in a docstring."""
    depth = 0
    for place in re.finditer(r'"(?:[^"\\\n]|\\.)*"|[()]', text[begin:]):
        depth += {"(": 1, ")": -1}.get(place[0], 0)
        if place[0] == ")" and not depth:
            with suppress(SyntaxError):
                return ast.parse(text[begin : begin + place.end()], mode="eval").body
            break
    return None


def test_every_gap_is_filled_where_a_sentence_is_said():
    templates, checked = dict(sentences(load_phrases().entries)), 0
    for path in Path(coursework.__file__).parent.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        for found in CALL.finditer(text):
            needed = gaps(templates.get(found[1], ""))
            if not needed:
                continue
            call = call_at(text, found.start())
            if call is None:
                continue
            given = {keyword.arg for keyword in call.keywords}
            if None not in given:
                checked += 1
                left = needed - given - ({"number"} if ast.unparse(call.func) == "say_count" else set())
                assert not left, f"{path}: {found[1]} is said without {left}"
    assert checked > 700
