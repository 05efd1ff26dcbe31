"""Every sentence said of a submission, found again by the words file, and whether it is true of what was done.

Enters: a text, a `Pupil`.  Leaves: (key, values) of its sentences, what no sentence explains, and the false ones.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from string import Formatter

import numpy as np

from tests.grading.pages.test_true_sentences import plain
from tests.grading.whole_class.graded import Seen
from tests.grading.whole_class.pupils import DIGITS, Pupil, Truth
from tests.grading.whole_class.tables import against_itself

WORDS = Path(__file__).parents[3] / "reports" / "words.en.toml"
ROOMS = ("feedback", "marking", "reading")
FEWEST = 8  # letters of its own in a sentence
Values = Mapping[str, str]


def _leaves(entries: Mapping[str, object], path: str = "") -> dict[str, str]:
    found: dict[str, str] = {}
    for key, value in entries.items():
        found |= _leaves(value, f"{path}{key}.") if isinstance(value, dict) else {f"{path}{key}": str(value)}
    return found


@cache
def _patterns() -> list[tuple[str, re.Pattern[str]]]:
    """Return a pattern for each sentence that ends like one; gaps are groups by their names."""
    words = tomllib.loads(WORDS.read_text(encoding="utf-8"))
    found = []
    for key, text in _leaves({room: words[room] for room in ROOMS}).items():
        literal = sum(len(part.strip()) for part, *_ in Formatter().parse(text))
        if not text.rstrip("”\"").endswith((".", ":")) or literal < FEWEST:
            continue
        pieces, names = [], set()
        for literal, name, _, _ in Formatter().parse(text):
            pieces.append(re.escape(plain(literal)) if literal.strip() else literal)
            if name is not None:
                pieces.append("(.{0,400}?)" if name in names or not name else f"(?P<{name}>.{{0,400}}?)")
                names.add(name)
        found.append((key, re.compile("".join(pieces) + r"(?=\s|$)")))
    return found


def sentences(text: str) -> tuple[list[tuple[str, Values]], str]:
    """Return the sentences of a text with their values, and what is left over."""
    text, found, rest, place = plain(text).strip(), [], "", 0
    while place < len(text):
        fits = [(len(pattern.pattern), key, match) for key, pattern in _patterns() if (match := pattern.match(text, place))]
        if fits:
            _, key, match = max(fits, key=lambda fit: fit[0])
            found.append((key, match.groupdict()))
            place = match.end()
            while text[place : place + 1] == " ":
                place += 1
        else:
            rest, place = rest + text[place], place + 1
    return found, rest.strip()


CODES = {"rounded_omega_1": "rounded_omega", "swapped_columns": "swapped"}


def said_cause(code: str) -> str:
    """Return the key under which a misconception is told to its student."""
    if code in CODES:
        return CODES[code]
    stem = code.partition("_")[0]
    return stem if stem in ("sign", "start", "equation", "datum", "swap", "origin") and code != "sign_drive" else code


def false_sentences(pupil: Pupil, seen: Seen, machine) -> list[str]:
    """Return what is said of a pupil and is not so."""
    found, rest = sentences(seen.row["sentence"])
    false = [f"no sentence: {rest[:80]}"] if rest else []
    truth = pupil.truth
    for key, values in found:
        check = CHECKS.get(key.removeprefix("feedback."))
        if check is None:
            false += [] if key in SAID_OF_FILES or key.startswith(("marking.row", "marking.first")) else [f"not judged: {key}"]
        elif not check(truth, values, pupil, machine):
            false.append(f"{key} {dict(values)}")
    causes = {key.rpartition(".")[2].removesuffix("_several") for key, _ in found if key.startswith("feedback.misconception.")}
    causes -= {"share", "partly", "ties", "none"}
    if causes and truth.kind not in ("misconception", "own equations", "worthless"):
        false.append(f"a cause where there is none: {causes}")
    if causes and truth.code and said_cause(truth.code) not in causes:
        false.append(f"{causes} is not {truth.code}")
    return false + _false_of_page(pupil, seen, machine)


def _false_of_page(pupil: Pupil, seen: Seen, machine) -> list[str]:
    """Return what else the page says in its own words: that all is right, how many steps follow."""
    truth, false = pupil.truth, []
    if "The equations are right and complete." in seen.page and truth.lines:
        false.append("equations said to be right")
    if "No number is wrong." in seen.page and (truth.wrong or truth.absent or truth.wrong is None and not _follows(pupil, machine)):
        false.append("no number said to be wrong")
    if (all_follow := re.search(r"All (\d+) steps of the coordinates follow", seen.page)) and truth.wrong is not None:
        steps = (len(pupil.table) - 1) * machine.m
        if truth.wrong or int(all_follow[1]) != steps:
            false += [] if int(all_follow[1]) == steps and not truth.wrong else [all_follow[0]]
    return false


def _follows(pupil: Pupil, machine) -> bool:
    return not against_itself(machine, np.round(pupil.table, DIGITS), 10.0**-DIGITS)[0].any()


def _counts(truth: Truth, values: Values, pupil: Pupil, machine) -> bool:
    cells = machine.rows * pupil.table.shape[1] - machine.m
    given = {(0, place) for place in range(machine.m)}
    wrong = truth.wrong is None or int(values["wrong"]) == len(truth.wrong - given)
    return int(values["cells"]) == cells and wrong and int(values["missing"]) == len(truth.absent - given)


def _line(truth: Truth, values: Values, pupil: Pupil, machine) -> bool:
    if truth.kind == "worthless":
        return True
    number = int(values["line"]) if values.get("line", "").isdigit() else 0
    return number in truth.lines if number and "equations.txt" in pupil.files else bool(truth.lines)


def _equations(truth: Truth, values: Values, pupil: Pupil, machine) -> bool:
    needed = len(machine.variant.sought)
    if truth.kind == "worthless":
        return int(values["independent"]) == 0
    right = needed - len(truth.lines)
    return (int(values["needed"]), int(values["independent"]), int(values["wrong"])) == (needed, right, len(truth.lines))


def _sum(truth: Truth, values: Values, pupil: Pupil, machine) -> bool:
    points, most = float(values["points"]), float(values["most"])
    return points <= most and (truth.kind != "right")


def _first(truth: Truth, values: Values, pupil: Pupil, machine) -> bool:
    row = int(values["row"]) - 1
    if truth.wrong:
        return row == min(row for row, _ in truth.wrong)
    return truth.wrong is None


Check = Callable[[Truth, Values, Pupil, object], bool]
CHECKS: dict[str, Check] = {
    "counts": _counts, "line_wrong": _line, "place_wrong": _line, "earned.equations": _equations,
    **{f"earned.{rule}": _sum for rule in ("cells", "misconception", "start", "own_equations")},
    "counts_start": lambda truth, values, pupil, machine: truth.wrong is None,
    "start_costs": lambda truth, values, pupil, machine: truth.wrong is None,
    "misconception.none": lambda truth, values, pupil, machine: not truth.code,
    "rows.repeated": lambda truth, values, pupil, machine: truth.kind == "worthless" or truth.code == "rows_shifted",
    "rows.shifted": lambda truth, values, pupil, machine: truth.code == "rows_shifted",
    **{f"shut.{gate}": (lambda truth, values, pupil, machine: truth.wrong != frozenset())
       for gate in ("start", "used_velocity", "rows", "motion", "chance")},
    "hint.sign": lambda truth, values, pupil, machine: bool(truth.lines),
    **{f"misconception.{key}": (lambda truth, values, pupil, machine: truth.wrong is None)
       for key in ("share", "partly", "ties")},
}  # fmt: skip
for _key, _ in _patterns():
    if _key.startswith("marking.wrong") or (_key.startswith("marking.") and "Row {row}" in str(_)):
        CHECKS[_key] = _first
    elif _key.startswith("feedback.misconception."):
        CHECKS.setdefault(_key.removeprefix("feedback."), lambda truth, values, pupil, machine: truth.wrong is None)
# Said of files and states, not of the work: that a line could not be read, what stood in no document.
SAID_OF_FILES = ("feedback.line_unread", "feedback.place_unread", "feedback.earned.unread", "feedback.more_lines")
