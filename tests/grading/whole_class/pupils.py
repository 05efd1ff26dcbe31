"""A class with its truth: who did what, in which notation and kind of file, for which variant of which mechanism.

Enters: how many, a seed.  Leaves: `Pupil`s.  Nothing of the marks is used: tables come from `Machine`, texts from the notations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from itertools import cycle, islice
from pathlib import Path

import numpy as np

import coursework
from tests.grading.marking.machines import Machine
from tests.grading.reading.notations import NOTATIONS, PLAIN
from tests.grading.reading.written_work import FORMS
from tests.grading.scenes import variant_of
from tests.grading.whole_class.files import CHEAP, FREE, KINDS, Work
from tests.grading.whole_class.tables import faults, slips_of_equations

VARIANTS_OF_EACH = 3
_DATUM = re.compile(r'^((?:V1|V2|w0|n|r1|b) *= *)"([-\d.]+) ([^"]+)"', re.MULTILINE)
TEXTS = NOTATIONS | {name: form for name, form in FORMS.items() if "{e}" not in name or "\n" not in name}
# Forms that ask a person on purpose: nobody can tell what they mean, or only a program could.
QUESTIONS = ("return list", "[ , ]", "paren python", "{e}    /{k}/")
DIGITS = 5


@dataclass(frozen=True)
class Truth:
    """What was done.

    `wrong` are cells (row, column from 0) that were mistyped, None where a whole rule is another; `absent` cells that are not
    there; `lines` (from 1) of the equations that are not right, `sign` the column of the sign that was turned; `code` a
    misconception.
    """

    kind: str
    wrong: frozenset[tuple[int, int]] | None = frozenset()
    absent: frozenset[tuple[int, int]] = frozenset()
    lines: tuple[int, ...] = ()
    sign: int = 0
    code: str = ""


@dataclass(frozen=True)
class Pupil:
    """One submission: its `id`, the mechanism with the number of the variant, notation and kind of file, `files`, the `truth`."""

    id: str
    name: str
    mechanism: str
    number: int
    notation: str
    kind: str
    truth: Truth
    table: np.ndarray
    files: dict[str, bytes] = field(repr=False, default_factory=dict)


def text_of(mechanism: str, number: int) -> str:
    """Return the file of a variant: the mechanism's, with data of its own."""
    path = variant_of(mechanism).path
    assert path is not None
    text = path.read_text(encoding="utf-8")
    return _DATUM.sub(lambda found: f'{found[1]}"{float(found[2]) * (1 + 0.015 * number):.5g} {found[3]}"', text)


@cache
def machine(mechanism: str, number: int, folder: Path) -> Machine:
    """Return the machine of a variant whose file is written into a folder."""
    path = folder / f"{mechanism}-{number}.toml"
    path.write_text(text_of(mechanism, number), encoding="utf-8")
    return Machine(coursework.load(path))


def works(made: Machine, mechanism: str, chance: np.random.Generator) -> Iterator[tuple[Truth, np.ndarray, str]]:
    """Give what may be done with a variant: its truth, the table, the equations as plain text."""
    plain, right = PLAIN[mechanism], made.table()
    yield Truth("right"), right, plain
    lines = plain.split("\n")
    for code, table in faults(made):
        if np.isfinite(table).all() and np.abs(table).max() < 1e4:
            yield Truth("misconception", None, code=code), table, plain
    for name, line, table in slips_of_equations(made):
        own = [*lines]
        place = [c.name for c in made.variant.constraints].index(name)
        own[place] = line
        yield Truth("own equations", None, lines=(place + 1,), code=f"equation_{name}"), table, "\n".join(own)
    for place, line in enumerate(lines):
        signs = [found.start() for found in re.finditer(r"(?<= )[-+](?= )", line)]
        at = int(chance.choice(signs))
        turned = f"{line[:at]}{'-' if line[at] == '+' else '+'}{line[at + 1 :]}"
        yield Truth("sign", lines=(place + 1,), sign=at + 1), right, "\n".join([*lines[:place], turned, *lines[place + 1 :]])
    names = made.variant.columns[made.m :]
    for name in made.variant.sought:
        place, row = made.m + names.index(name), int(chance.integers(2, made.rows - 2))
        by = 0.15 * max(1.0, float(np.abs(right[:, place]).max()))
        yield Truth("slip", frozenset({(row, place)})), made.table(slip=(row, place, by)), plain
    for _ in range(3):
        cells = frozenset((int(chance.integers(1, made.rows)), int(chance.integers(0, made.m))) for _ in range(2))
        mistyped = right.copy()
        for row, place in cells:
            mistyped[row, place] += 0.3
        if len({row for row, _ in cells}) == 2:
            yield Truth("mistyped", cells), mistyped, plain
    for last in (made.rows // 2, made.rows - 3):
        absent = frozenset((k, c) for k in range(last, made.rows) for c in range(right.shape[1]))
        yield Truth("rows missing", absent=absent), right[:last], plain
    zeros = np.zeros_like(right)
    yield from ((Truth("worthless", None, code=""), zeros + value, "the end") for value in (0.0, 1.5))
    yield Truth("worthless", None), np.tile(right[:1], (made.rows, 1)), "w1 = 0"


def written(pupil: Pupil, made: Machine, equations: str) -> dict[str, bytes]:
    """Return the files of a pupil."""
    h = made.variant.time.step
    rows = [[f"{k * h:.6g}", *(f"{value:.{DIGITS}f}" for value in row)] for k, row in enumerate(pupil.table)]
    names = [*(c.name for c in made.variant.coordinates), *made.variant.columns[made.m :]]
    latex = NOTATIONS["latex"](equations).replace("\\,", " ").split("\n")
    return KINDS[pupil.kind](Work(names, rows, TEXTS[pupil.notation](equations), latex))


def pupils(count: int, folder: Path, seed: int = 26, *, cheap: bool = False) -> list[Pupil]:
    """Return a class: one of two right, each notation and each kind of file in turn, the others by all that may be done."""
    chance = np.random.default_rng(seed)
    kinds = CHEAP if cheap else tuple(KINDS)
    turn = cycle([(mechanism, number) for number in range(VARIANTS_OF_EACH) for mechanism in PLAIN])
    notations = cycle(chance.permutation([name for name in TEXTS if name not in QUESTIONS]).tolist())
    todo = {place: works(machine(*place, folder), place[0], chance) for place in islice(turn, VARIANTS_OF_EACH * len(PLAIN))}
    listed = {place: list(found) for place, found in todo.items()}
    others = {place: cycle(chance.permutation(len(found) - 1) + 1) for place, found in listed.items()}
    found = []
    for number in range(count):
        place = next(turn)
        truth, table, equations = listed[place][next(others[place]) if number % 2 else 0]
        kind = kinds[number // 2 % len(kinds)]
        notation = next(notations) if kind in FREE and truth.kind in ("right", "misconception", "slip", "mistyped") else "greek"
        pupil = Pupil(f"q{number:03d}", f"Pupil{number:03d} Zq{number:03d}", *place, notation, kind, truth, table)
        found.append(Pupil(**{**vars(pupil), "files": written(pupil, machine(*place, folder), equations)}))
    return found
