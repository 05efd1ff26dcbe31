"""A class with its truth: who did what, in which notation and kind of file, for which variant of which mechanism.

Enters: how many, a seed.  Leaves: `Pupil`s.  Nothing of the marks is used: tables come from `Machine`, texts from the notations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache, partial
from itertools import cycle
from pathlib import Path

import numpy as np

import coursework
from tests.grading.marking.machines import Machine
from tests.grading.reading.equations.notation.notations import NOTATIONS, PLAIN
from tests.grading.reading.equations.notation.written_work import FORMS
from tests.grading.scenes import variant_of
from tests.grading.whole_class.files import CHEAP, FREE, KINDS, Work
from tests.grading.whole_class.tables import Make, faults, is_a_table, slips_of_equations

VARIANTS_OF_EACH = 3
_DATUM = re.compile(r'^((?:V1|V2|w0|n|r1|b) *= *)"([-\d.]+) ([^"]+)"', re.MULTILINE)
TEXTS = NOTATIONS | {name: form for name, form in FORMS.items() if "{e}" not in name or "\n" not in name}
# Forms that ask a person on purpose: nobody can tell what they mean, or only a program could.
QUESTIONS = ("{e}    /{k}/",)
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


def works(made: Machine, mechanism: str, chance: np.random.Generator) -> Iterator[tuple[Truth, Make, str]]:
    """Give what may be done with a variant: its truth, what makes the table, the equations as plain text."""
    plain = PLAIN[mechanism]
    right, lines = made.table, plain.split("\n")
    names = [c.name for c in made.variant.constraints]
    for code, table in faults(made):
        yield Truth("misconception", None, code=code), table, plain
    for name, line, table in slips_of_equations(made):
        place = names.index(name)
        truth = Truth("own equations", None, lines=(place + 1,), code=f"equation_{name}")
        yield truth, table, "\n".join([*lines[:place], line, *lines[place + 1 :]])
    for place, line in enumerate(lines):
        signs = [found.start() for found in re.finditer(r"(?<= )[-+](?= )", line)]
        at = int(chance.choice(signs))
        turned = f"{line[:at]}{'-' if line[at] == '+' else '+'}{line[at + 1 :]}"
        yield Truth("sign", lines=(place + 1,), sign=at + 1), right, "\n".join([*lines[:place], turned, *lines[place + 1 :]])
    columns = made.variant.columns[made.m :]
    for name in made.variant.sought:
        place, row = made.m + columns.index(name), int(chance.integers(2, made.rows - 2))
        by = 0.15 * max(1.0, float(np.abs(right()[:, place]).max()))
        yield Truth("slip", frozenset({(row, place)})), partial(made.table, slip=(row, place, by)), plain
    for _ in range(3):
        rows = chance.choice(np.arange(1, made.rows), 2, replace=False).tolist()
        cells = frozenset((row, int(chance.integers(0, made.m))) for row in rows)
        yield Truth("mistyped", cells), partial(_mistyped, made, cells), plain
    for last in (made.rows // 2, made.rows - 3):
        absent = frozenset((k, c) for k in range(last, made.rows) for c in range(made.m + len(columns)))
        yield Truth("rows missing", absent=absent), partial(_first_rows, made, last), plain
    for value in (0.0, 1.5):
        yield Truth("worthless", None), partial(np.full, (made.rows, made.m + len(columns)), value), "the end"
    yield Truth("worthless", None), lambda: np.tile(right()[:1], (made.rows, 1)), "w1 = 0"


def _mistyped(made: Machine, cells: frozenset[tuple[int, int]]) -> np.ndarray:
    table = made.table()
    for cell in cells:
        table[cell] += 0.2 + 0.01 * cell[0]  # each by another amount: none is carried from another
    return table


def _first_rows(made: Machine, last: int) -> np.ndarray:
    return made.table()[:last]


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
    done: dict[tuple[str, int], Iterator[tuple[Truth, Make, str]]] = {}
    found = []
    for number in range(count):
        place = next(turn)
        made = machine(*place, folder)
        if number % 2:
            if place not in done:
                todo = list(works(made, place[0], chance))
                done[place] = cycle([todo[k] for k in chance.permutation(len(todo))])
            made_of = ((truth, make(), equations) for truth, make, equations in done[place])
            truth, table, equations = next(work for work in made_of if not work[0].code or is_a_table(work[1], made))
        else:
            truth, table, equations = Truth("right"), made.table(), PLAIN[place[0]]
        kind = kinds[number // 2 % len(kinds)]
        notation = next(notations) if kind in FREE and truth.kind in ("right", "misconception", "slip", "mistyped") else "greek"
        pupil = Pupil(f"q{number:03d}", f"Pupil{number:03d} Zq{number:03d}", *place, notation, kind, truth, table)
        found.append(Pupil(**{**vars(pupil), "files": written(pupil, made, equations)}))
    return found
