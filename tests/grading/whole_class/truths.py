"""Whether what is said of a submission is true of what was done: each kind of sentence against files and a program of its own.

Enters: `Said`, a `Pupil`.  Leaves: what is false, or judged by nobody.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pytest

from tests.grading.marking.machines import Machine
from tests.grading.reading.equations.notation.notations import PLAIN
from tests.grading.reading.table.test_dialects import OF_SPREADSHEETS
from tests.grading.whole_class.graded import Seen
from tests.grading.whole_class.pupils import DIGITS, Pupil, Truth
from tests.grading.whole_class.sentences import Said, Values, of_page, sentences
from tests.grading.whole_class.tables import against_itself

SIGN = re.compile(r"(?<= )[-+](?= )")
CODES = {"rounded_omega_1": "rounded_omega", "swapped_columns": "swapped"}
# Said of how a file was read: true where it stands in files of these kinds; of any where none is named.
OF_FILES = {
    "greek_lost": ("excel_", "with_titles", "zip"), "columns_by_position": (), "transposed": ("turned", "maple_list"),
    "rows_sorted": ("backwards",),
    "from_pdf": ("pdf",), "encoding": (), "sheet": ("xlsx", "ods"), "repaired": (), "two_tables": (), "ignored_file": ("script",),
    "attachment": (),
}  # fmt: skip
_LETTERS = str.maketrans({"α": "alpha", "β": "beta", "ω": "w", "φ": "phi", "_": "", " ": ""})
# Said where a line asks a person, or where nothing of worth was handed in.
OF_QUESTIONS = (
    "feedback.line_adds_nothing", "feedback.lack", "feedback.status.needs_review", "feedback.earned.unread",
    "feedback.line_unread", "feedback.equation.asked", "reading.review", "reading.note.no_part",
    "reading.note.too_coarse", "reading.trouble", "fault",
)  # fmt: skip
# Said of how a page is read, with nothing in it that could be false.
OF_ANY = (
    "feedback.signs", "feedback.rounded", "feedback.left_out", "feedback.left_out_wrong", "feedback.curves_key",
    "feedback.status.graded", "feedback.status.graded_with_notes", "feedback.equation.right", "feedback.equation.unreadable",
    "feedback.hint.repaired", "reading.place",
)  # fmt: skip
READ_OTHERWISE = ("swapped_columns", "sign_drive", "rows_shifted", "origin")


def said_cause(code: str) -> str:
    """Return the key under which a misconception is told to its student."""
    if code in CODES:
        return CODES[code]
    if code.startswith("row_above_"):
        return "row_above"
    stem = code.partition("_")[0]
    return stem if stem in ("sign", "start", "equation", "datum", "swap", "origin") and code != "sign_drive" else code


@dataclass
class Held:
    """What was done, worked out where a sentence asks for it."""

    pupil: Pupil
    seen: Seen
    machine: Machine

    @property
    def truth(self) -> Truth:
        return self.pupil.truth

    @cached_property
    def table(self) -> np.ndarray:
        return np.round(self.pupil.table, DIGITS)

    @cached_property
    def units(self) -> np.ndarray:
        """The units of the last places of the columns: a spreadsheet stores numbers without the zeros at their end."""
        printed = [[f"{value:.{DIGITS}f}" for value in column] for column in self.table.T]
        if self.pupil.kind in OF_SPREADSHEETS:
            printed = [[text.rstrip("0") for text in column] for column in printed]
        return np.array([10.0 ** -max(len(text.partition(".")[2]) for text in column) for column in printed])

    @cached_property
    def names(self) -> list[str]:
        m = self.machine.m
        return [*(c.name for c in self.machine.variant.coordinates), *self.machine.variant.columns[m:]]

    @cached_property
    def sure(self) -> tuple[np.ndarray, np.ndarray]:
        """Which cells are surely wrong, and which surely right; rows that are the task's only."""
        if self.truth.wrong is not None:
            wrong = np.zeros(self.table.shape, dtype=bool)
            for cell in self.truth.wrong:
                wrong[cell] = True
            return wrong, ~wrong
        return against_itself(self.machine, self.table, self.units)

    @cached_property
    def steps(self) -> tuple[int, int]:
        """How many steps surely follow Euler's rule from the printed row before, and how many may."""
        m, h = self.machine.m, self.machine.h
        q, w = self.table[:, :m], self.table[:, m : 2 * m]
        off = np.abs(np.diff(q, axis=0) - h * w[:-1])
        unit, of_rates = self.units[:m], self.units[m : 2 * m]
        return int((off < 1.01 * unit).sum()), int((off < 2 * unit + h * of_rates + 4e-4 * h * np.abs(w[:-1])).sum())

    @property
    def counted(self) -> int:
        return self.machine.rows * len(self.names) - self.machine.m


def false_sentences(pupil: Pupil, seen: Seen, machine: Machine) -> list[str]:
    """Return what is said of a pupil and is not so."""
    found, rest = sentences(seen.row["sentence"])
    false = [f"no sentence: {rest[:80]}"] if rest else []
    held = Held(pupil, seen, machine)
    every = [*found, *of_page(seen.raw)]
    for key, values in {(key, tuple(values.items())): (key, values) for key, values in every}.values():
        check = next((CHECKS[stem] for stem in _stems(key) if stem in CHECKS), None)
        if check is None:
            false.append(f"not judged: {key} {dict(values)}")
        elif not check(held, values):
            false.append(f"{key} {dict(values)}")
    return [*false, *_false_of_file(pupil, every), *_false_cause(pupil.truth, every)]


def _stems(key: str) -> Iterator[str]:
    """Give a key and what it begins with, the longest first."""
    parts = key.split(".")
    yield from (".".join(parts[:count]) for count in range(len(parts), 0, -1))


def _false_of_file(pupil: Pupil, every: list[Said]) -> Iterator[str]:
    for key, _ in every:
        note = key.removeprefix("reading.note.")
        if OF_FILES.get(note) and not any(kind in pupil.kind for kind in OF_FILES[note]):
            yield f"{key} of {pupil.kind}"


def _false_cause(truth: Truth, every: list[Said]) -> Iterator[str]:
    said = {key.rpartition(".")[2] for key, _ in every if key.startswith("feedback.misconception.")}
    said = {cause.removesuffix("_several").removesuffix("_value") for cause in said}
    said -= {"share", "partly", "ties", "none"}
    if said and not truth.code:
        yield f"a cause where there is none: {said}"
    if said and truth.code and said_cause(truth.code) not in said:
        yield f"{said} is not {truth.code}"
    if "start" in said and truth.code.startswith("origin"):
        yield "the rest was not made from there"


def _first(held: Held, values: Values) -> bool:
    """A cell that is wrong, none in the rows before it, with the numbers that stand there and that follow from the others."""
    row, place, m = int(values["row"].split()[0]) - 1, held.names.index(values["name"].translate(_LETTERS)), held.machine.m
    wrong, right = held.sure
    found, expected = float(values["found"]), float(values["expected"])
    if held.truth.code in READ_OTHERWISE or held.truth.code.startswith("origin"):
        return True  # columns and signs are named as they were understood
    if wrong[:row].any() or right[row, place] or abs(found - held.table[row, place]) > float(values["tolerance"]):
        return False
    own = held.machine.velocities(row * held.machine.h, held.table[row, :m])
    ways = [held.machine.table()[row, place], own[place - m] if place >= m else held.machine.start[place]]
    if row > 0 and place < m:
        before, h = held.table[row - 1], held.machine.h
        ways += [before[place] + h * before[m + place]]
        ways += [before[place] + h * held.machine.velocities((row - 1) * h, before[:m])[place]]
    near = float(values["tolerance"]) + 1e-9
    return abs(found - expected) > float(values["tolerance"]) and any(abs(expected - way) <= near for way in ways)


def _counts(held: Held, values: Values) -> bool:
    numbers = {name: int(values[name]) for name in ("cells", "wrong", "missing", "carried", "right")}
    m, coarse = held.machine.m, held.truth.kind == "worthless"
    if numbers["cells"] != sum(numbers[name] for name in ("wrong", "missing", "carried", "right")):
        return False
    wrong, right = (found.copy() for found in held.sure)
    wrong[0, :m] = right[0, :m] = False
    if held.truth.wrong is None and (held.truth.code in READ_OTHERWISE or coarse):
        return numbers["cells"] == held.counted >= numbers["wrong"] + numbers["missing"] + numbers["carried"]
    absent = sum(1 for k, place in held.truth.absent if k or place >= m)
    if numbers["cells"] != held.counted or numbers["missing"] != absent:
        return False
    return (
        wrong.sum() <= numbers["wrong"] <= held.counted - absent - right.sum()
        if held.truth.wrong is None
        else (numbers["wrong"] == wrong.sum())
    )


def _line(held: Held, values: Values) -> bool:
    number = int(values["line"]) if values.get("line", "").isdigit() else 0
    if held.truth.kind == "worthless":
        return True
    return number in held.truth.lines if number and "equations.txt" in held.pupil.files else bool(held.truth.lines)


def _equations(held: Held, values: Values) -> bool:
    needed = len(held.machine.variant.sought)
    told = tuple(int(values[name]) for name in ("needed", "independent", "wrong") if name in values)
    if held.truth.kind == "worthless":
        return told[:2] == (needed, 0)
    return told == (needed, needed - len(held.truth.lines), len(held.truth.lines))[: len(told)]


def _sign(held: Held, values: Values) -> bool:
    """The term that is named begins with the sign that was turned."""
    if held.truth.kind != "sign" or "equations.txt" not in held.pupil.files:
        return bool(held.truth.lines)
    plain = PLAIN[held.pupil.mechanism].split("\n")[held.truth.lines[0] - 1]
    behind = re.split(r" [-+=] ", plain[held.truth.sign + 1 :].strip())[0]
    return _bare(values["term"]) == _bare(behind)


def _bare(term: str) -> str:
    return re.sub(r"[\s()]", "", term)


def _cells(held: Held, values: Values) -> bool:
    points, most, counted = (float(values[name]) for name in ("points", "most", "counted"))
    return points == pytest.approx(most * counted / held.counted, abs=0.011) and held.truth.kind not in ("right", "sign")


def _product(held: Held, values: Values) -> bool:
    points, most, worth, explained = (float(values[name]) for name in ("points", "most", "worth", "explained"))
    return points == pytest.approx(most * worth * explained, abs=0.011) and points > float(values["alone"])


def _steps(held: Held, values: Values) -> bool:
    if "steps" not in values:  # zeros are printed with one decimal, which shows no step
        return held.truth.kind == "worthless"
    steps = (len(held.table) - 1) * held.machine.m
    least, most = held.steps
    told = int(values.get("held", steps))
    return int(values["steps"]) == steps and least <= told <= most and ("held" not in values or told < steps)


def _repeated(held: Held, values: Values) -> bool:
    rows = {1 + k for k in range(1, len(held.table)) if np.array_equal(held.table[k], held.table[k - 1])}
    told = set()
    for part in re.split(r", | and ", values["rows"]):
        first, _, last = part.partition("–")
        told |= {*range(int(first), int(last or first) + 1)}
    return told == rows


def _unread(held: Held, values: Values) -> bool:
    """A line that could not be read asks a person; of how many that may be is another test."""
    return held.truth.kind == "worthless" or held.seen.row["status"] == "needs-review"


def _fewer_decimals(held: Held, values: Values) -> bool:
    fewer = int((held.units > 2 * 10.0 ** -int(values["least"])).sum()) * len(held.table)
    return held.truth.kind == "worthless" or int(values["count"]) == fewer


def _wrong_rule(held: Held, values: Values) -> bool:
    return held.truth.wrong is None


def _true(held: Held, values: Values) -> bool:
    return True


def _of_share(held: Held, values: Values) -> bool:
    return held.truth.wrong is None and values["share"].isdigit() and 93 <= int(values["share"]) <= 100


Check = Callable[[Held, Values], bool]
CHECKS: dict[str, Check] = {
    "marking.first": _first,
    "marking.verdict.equations.right": lambda held, values: not held.truth.lines and held.truth.kind != "worthless",
    "marking.verdict.integration": _steps,
    "marking.verdict.arithmetic.right": lambda held, values: not (held.sure[0].any() or held.truth.absent),
    "marking.verdict.arithmetic.present": lambda held, values: not held.sure[0].any() and bool(held.truth.absent),
    "feedback.counts": _counts,
    "feedback.all_right": lambda held, values: held.truth.kind in ("right", "sign") and int(values["cells"]) == held.counted,
    "feedback.earned.cells": _cells,
    **dict.fromkeys([f"feedback.earned.{rule}" for rule in ("misconception", "other_step", "start", "own_equations")], _product),
    **dict.fromkeys(("feedback.independent", "feedback.earned.equations"), _equations),
    **dict.fromkeys(("feedback.line_wrong", "feedback.place_wrong", "feedback.equation.wrong", "feedback.hint"), _line),
    "feedback.hint.sign": _sign,
    **dict.fromkeys(
        ("feedback.misconception", "feedback.counts_start", "feedback.start_costs", "reading.note.turns"), _wrong_rule
    ),
    "feedback.misconception.share": _of_share,
    "feedback.misconception.none": lambda held, values: not held.truth.code and held.truth.wrong is None,
    "feedback.lack.repeats": lambda held, values: held.pupil.notation == "twice" or _unread(held, values),
    "feedback.rows.repeated": _repeated,
    "feedback.rows.shifted": lambda held, values: held.truth.code == "rows_shifted",
    "feedback.shut": lambda held, values: held.truth.wrong != frozenset() and int(values["number"]) > 0,
    "feedback.sign_shut": lambda held, values: held.truth.wrong != frozenset(),
    "feedback.read_as": lambda held, values: (
        (int(values["present"]), int(values["needed"])) == (len(held.table), held.machine.rows)
    ),
    "reading.note.fewer_decimals": _fewer_decimals,
    "reading.note.rows_missing": lambda held, values: bool(held.truth.absent),
    **dict.fromkeys(OF_QUESTIONS, _unread),
    **dict.fromkeys(OF_ANY, _true),
    **{f"reading.note.{note}": _true for note in OF_FILES},
}
