"""Every fault has a code of its own, and its sentence stands in the words file, never in Python."""

from __future__ import annotations

import ast
import re
import tomllib
from collections import Counter
from pathlib import Path

import coursework
from coursework.words.errors import Fault
from coursework.words.sentences import say
from tests.sources import files, nodes

ROOT = Path(__file__).parents[2]
WORDS = tomllib.loads((ROOT / "reports" / "words.en.toml").read_text(encoding="utf-8"))
CODE = re.compile(r"[A-Z]\d{3}")
# Whoever makes one of these tells a user something.
TELLING = {
    "Fault", "InputError", "OutputError", "CourseworkError", "FormulaFault", "UnitFault", "TableFault", "FormulaRefused",
    "OutsideTable", "NotFollowed", "BudgetSpent", "UsageError", "BadParameter", "ClickException",
}  # fmt: skip


def codes() -> list[str]:
    return sorted(key for key in WORDS["fault"] if CODE.fullmatch(key))


def test_every_code_is_used_at_one_place() -> None:
    used: Counter[str] = Counter()
    for path in files():
        texts = [node.value for node in nodes(path) if isinstance(node, ast.Constant) and isinstance(node.value, str)]
        named = [key for text in texts for key in re.findall(r"\bfault\.([A-Z]\d{3}(?:\.\w+)?)\b", text)]
        assert len(named) == len(set(named))  # a code may be told in two forms
        used.update({key.partition(".")[0] for key in named})
    assert sorted(used) == codes()
    assert {code: count for code, count in used.items() if count > 1} == {}


def test_no_sentence_of_a_fault_stands_in_python() -> None:
    for path in files():
        for node in nodes(path):
            if not isinstance(node, ast.Call):
                continue
            name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            if name in TELLING:
                for part in [*node.args, *(keyword.value for keyword in node.keywords)]:
                    assert not _has_prose(part), f"{path.relative_to(ROOT)}:{node.lineno}"


def _has_prose(node: ast.expr) -> bool:
    """Return whether two words stand side by side in a text that is written down here."""
    if isinstance(node, ast.Call):  # what is said by a key is looked up, and its values are checked where they are made
        return False
    texts = (part.value for part in ast.walk(node) if isinstance(part, ast.Constant) and isinstance(part.value, str))
    return any(re.search(r"[a-z]{2,} [a-z]{2,}", text) for text in texts)


def test_every_sentence_of_a_fault_ends_as_one() -> None:
    for code in codes():
        entry = WORDS["fault"][code]
        for sentence in entry.values() if isinstance(entry, dict) else [entry]:
            assert sentence.endswith((".", "?", "}")), code


def test_a_fault_knows_its_code_and_what_it_speaks_about() -> None:
    fault = Fault(say("fault.V063", step=-0.5), "variants/07.toml", 14, 8, "time.step")
    assert str(fault) == "V063 variants/07.toml:14:8  time.step: the step must be greater than 0, found -0.5 s."
    assert fault.plain() == {
        "code": "V063", "file": "variants/07.toml", "line": 14, "column": 8, "place": "time.step", "values": {"step": -0.5},
        "sentence": "the step must be greater than 0, found -0.5 s.",
    }  # fmt: skip


def test_an_error_tells_one_line_a_fault_code_first() -> None:
    try:
        coursework.solve("31", scheme="eulr")
    except coursework.InputError as error:
        assert [fault.code for fault in error.faults] == ["C003"]
        assert str(error).startswith('C003 there is no scheme "eulr". Did you mean "euler"?')
