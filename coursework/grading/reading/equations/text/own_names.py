"""The names that a student defines in a text, D = r1*r2*sin(phi1 - phi2) -> their formulas, section by section.

Enters: the lines of a text, `Names`.  Leaves: where its sections end, the formulas of the names in each; nothing is marked here.
Used by `lines.py`.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from coursework.grading.reading.equations.formulas.equations import WORD, Names, read_as_one
from coursework.grading.reading.equations.formulas.names_in_text import plain_name
from coursework.grading.reading.equations.notation.signs import VANISHED, plain_signs
from coursework.grading.reading.equations.text.line_kinds import are_equal, definition, no_velocity, own_name
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.grading.reading.student_work import EquationReading
from coursework.variant.formula.tree import Formula, evaluate_any, terms
from coursework.words.errors import Fault

_OF_A_POINT = re.compile(r"V[a-z]{1,3}")  # V_a = a·ω1, no product with a datum V although nothing else is said of it
_FUNCTION = re.compile(r"\\?(?:sin|cos|tan|sqrt|cdot|times)(?![a-z])|(?<=\d)[eE](?=[-+]?\d)")
_GATHERED = re.compile(r"(?:\breturn\s+|(?<!atan2)[\[({]\s*|^\s*)(?:\w{1,20}\s*[,;]\s*)+\w{1,20}\s*(?:[\])}]|;?\s*$)")
_MOST_DEFINITIONS, _PASSES = 100, 3
_MOST_SAID = 1000  # lines in which the uses of a name are counted
_OF_ONE_TERM = 2  # terms of 0 = r1*w1, the velocity of a point that moves
_TWO_FORMULAS = 2  # signs of equality in v = a = b
_NEAR = 0.02  # relative difference of two formulas that the start values leave


def sections_of(lines: Sequence[tuple[int, str]], names: Names) -> list[int]:
    """Return where sections of a text end: a new one begins where a name that was used gets another formula.

    A program that solves one system after another calls their matrices and determinants by the same names. Velocities (V_Bx of
    two links) and labels of sums (V_D = … = 0) are not defined anew.
    """
    whole, lines = len(lines), lines[:_MOST_DEFINITIONS]
    left = [line.partition("=")[0].strip() for _, line in lines]
    again = {name for name, count in Counter(left).items() if count > 1 and name}
    known: dict[str, str] = {}
    used, ends = set[str](), list[int]()
    for place, (_, line) in enumerate(lines) if again else ():
        name, formula = own_name(line, names.spellings) if left[place] in again else ("", "")
        called = plain_name(name)
        if name and name[:1] not in "vV" and not VANISHED.search(line):
            if known.get(called, formula) != formula and called in used:
                ends.append(place)
                known, used = {}, set()
            known[called] = formula
        used |= {*map(plain_name, WORD.findall(line.partition("=")[2]))} & known.keys()
    return [*ends, whole]


def definitions_of(lines: Sequence[tuple[int, str]], names: Names, ends: Sequence[int]) -> list[dict[str, Formula]]:
    """Return for each section the student's own names with their formulas, its own before those of the sections around it."""
    words, sections = _words(lines), [lines[begin:end] for begin, end in pairwise([0, *ends])]
    found: list[dict[str, Formula]] = []
    for section in sections:
        found.append(_defined(section, names, words, found[-1] if found else {}))
    for place in reversed(range(len(found) - 1)):  # in a program the data may follow the formulas that use them
        found[place] = _defined(sections[place], names, words, found[place + 1] | found[place])
    return found


def _words(lines: Sequence[tuple[int, str]]) -> Mapping[str, int]:
    """Return in how many lines each name stands."""
    spoken = [plain_signs(line[:EQUATION_CHARACTERS]) for _, line in lines[:_MOST_SAID]]
    # A list that a program only returns, as in return [f1, f2], holds residuals: it is no use of the names.
    spoken = [_GATHERED.sub("", line) for line in spoken]
    return Counter(plain_name(word) for line in spoken for word in {*WORD.findall(line)})


def _defined(
    lines: Sequence[tuple[int, str]], names: Names, words: Mapping[str, int], before: Mapping[str, Formula]
) -> dict[str, Formula]:
    """Return the student's own names that other lines use, with their formulas; a formula may use other such names."""
    left = [own_name(line, names.spellings) for _, line in lines[:_MOST_DEFINITIONS]]
    names_left = {plain_name(name) for name, _ in left if name}
    changing = {plain_name(name) for name, formula in left if name in WORD.findall(formula)}  # K = K + r1*w1
    own = {name: formula for name, formula in before.items() if name not in names_left}
    with_own = replace(names, own=own, spellings=names.spellings.with_own(dict.fromkeys([*before, *names_left])))
    labels: set[str] = set()  # names that label several lines: V_D = … = 0 along x, and again along y
    for turn in range(_PASSES):  # in a program the data may follow the formulas that use them
        met, is_waiting = set[str](), False
        for line in (one for _, whole in lines[:_MOST_DEFINITIONS] for one in _apart(whole, with_own)):
            if {*map(plain_name, WORD.findall(line.partition("=")[2]))} & names_left - own.keys():
                is_waiting = True
                if turn < _PASSES - 1:
                    met.add(plain_name(own_name(line, names.spellings)[0]))
                    continue
            if (found := definition(line, with_own)) and (
                words[found[0]] > 1 or _OF_A_POINT.fullmatch(found[0]) or no_velocity(line, names)
            ):
                if found[0] in changing:
                    continue
                if found[0] in met:
                    labels |= {found[0]} if VANISHED.search(line) else set()
                    first = own.get(found[0], found[1])
                    is_ratio = first.op == "/" and all(_has_velocity(names, one) for one in first.args)
                    if is_ratio and not _has_velocity(names, found[1]) and found[1].op != "number":
                        own[found[0]] = found[1]  # i = w2/w1, i = 1 + R/r: what i is without velocities stays linear
                else:
                    own.setdefault(*found)
                met.add(found[0])
        if not is_waiting:
            break
    counts = Counter(plain_name(name) for name, _ in left)
    again = [line for (_, line), (name, _) in zip(lines, left, strict=False) if name and counts[plain_name(name)] > 1]
    unclear = labels | {*_contradicted(again, replace(with_own, own={**own}))}
    return {name: formula for name, formula in own.items() if name not in unclear}


def _apart(line: str, names: Names) -> list[str]:
    """Return v = a and v = b for a line v = a = b in which a and b are different, so that a = b is an equation."""
    name, formula = own_name(line, names.spellings) if line.count("=") == _TWO_FORMULAS else ("", "")
    is_one = not name or VANISHED.search(line) or definition(line, names) is not None
    return [line] if is_one else [f"{name} = {side}" for side in formula.split("=")]


def defines(line: str, names: Names, before: set[str]) -> bool:
    """Return whether a line defines a name of the student; a second formula for a velocity is an equation.

    So it is for V_Bx of two links, and for n = w2/w1, n = 1 - R/r.
    """
    own = names.own
    name, formula = own_name(line, names.spellings) if own else ("", "")
    called = plain_name(name)
    if called not in own:
        return False
    is_again = called in before if name[:1] in "vV" else says_more(line, names)
    if is_again and WORD.search(_FUNCTION.sub("", formula)):
        return False
    before.add(called)
    # V_Cy = … = 0 is also an equation; V_Cy = 0.3*4.1 = 1.23 is its value in some row.
    return "=" not in formula or not WORD.search(_FUNCTION.sub("", formula))


def may_vanish(line: str, names: Names) -> EquationReading | None:
    """Return "formula = 0" for a line that gives the velocity of a point, V_P = …, by those sought; None for any other.

    Whether the point rests, the text may say elsewhere, in another line for V_P or in words.
    """
    name, formula = own_name(line, names.spellings)
    formula = formula.strip(" .,;")
    if name[:1] not in {"v", "V"} or not formula or "=" in formula:
        return None
    read = read_as_one(f"0 = {formula}", names)
    if isinstance(read, Fault) or len([*terms(read.tree)]) <= _OF_ONE_TERM or not _has_velocity(names, read.tree):
        return None
    return replace(read, text=f"0 = {formula}")


def says_more(line: str, names: Names) -> bool:
    """Return whether another formula for a name, of which one has a velocity, says more than the one that is put in."""
    found = _otherwise(line, names)
    return found is not None and _has_velocity(names, names.own[found[0]], found[1])


def _otherwise(line: str, names: Names) -> tuple[str, Formula] | None:
    """Return the name and formula of a line that defines a name anew, None if it is no such line or says the same."""
    found = definition(line, names)
    return found if found and found[0] in names.own and not are_equal(names.own[found[0]], found[1]) else None


def _has_velocity(names: Names, *formulas: Formula) -> bool:
    sought = {*names.expected.variant.sought}
    return any(sought & {*formula.names()} for formula in formulas)


def _contradicted(lines: Sequence[str], names: Names) -> Iterator[str]:
    """Yield the names of which two formulas without velocities differ at the start: which is meant, nobody can tell."""
    start = {one.name: one.values[0] for one in names.expected.grid.columns if one.values} | {**names.expected.variant.values}
    for line in lines:
        if (found := _otherwise(line, names)) is None or found[0][:1] in "vV":
            continue
        first, second = names.own[found[0]], found[1]
        if second.op != "number" and not _has_velocity(names, first, second) and not _meet(first, second, start):
            yield found[0]


def _meet(first: Formula, second: Formula, start: Mapping[str, float]) -> bool:
    """Return whether two formulas have nearly the same value at the start, as two ways around a closed loop have."""
    try:
        one, other = (evaluate_any(tree, {**start, "pi": math.pi, "t": 0.0}) for tree in (first, second))
    except (ArithmeticError, ValueError, KeyError):
        return True
    return abs(one - other) <= _NEAR * max(abs(one), abs(other))
