"""A class of variant 31 in which it is known of every student what was done: files, and the truth about them.

Everything is made from the formulas of `students.py`; nothing of the tool makes what its sentences are held against.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from tests.grading.batch.classroom import EQUATIONS, NAMES
from tests.grading.batch.classroom import csv as table_csv
from tests.grading.marking import students
from tests.grading.marking.students import ROWS, H, slopes, velocities
from tests.mechanisms.library import changed

RIGHT = students.table()
VARIANT = Path(__file__).parents[3] / "variants" / "31.toml"


def write_variants(folder: Path) -> None:
    """Write the variant of the class, s01, and that of another student, s02, into a folder."""
    text = VARIANT.read_text(encoding="utf-8")
    for name, amplitude in (("s01", "4.5 m/s"), ("s02", "4.0 m/s")):
        (folder / f"{name}.toml").write_text(changed(text, V1=amplitude), encoding="utf-8")


@dataclass
class Truth:
    """What was done: `wrong` cells (row, column from 0), `absent` cells, the first wrong one, lines that are not right.

    `sign` (line from 1, column from 1) is the character that was changed; `code` what the table was made with.
    """

    wrong: set[tuple[int, int]] | None = None
    absent: set[tuple[int, int]] = field(default_factory=set)
    lines: tuple[int, ...] = ()
    idle: tuple[int, ...] = ()
    unread: tuple[int, ...] = ()
    sign: tuple[int, int] | None = None
    said: tuple[str, ...] = ()
    code: str = ""
    counted: bool = True


Case = tuple[dict[str, bytes], Truth]


def files(table: np.ndarray | None = RIGHT, equations: tuple[str, ...] | None = EQUATIONS, decimals: int = 4) -> dict[str, bytes]:
    found = {} if table is None else {"table.csv": table_csv(table, decimals)}
    return found | ({} if equations is None else {"equations.txt": "\n".join(equations).encode()})


def mistyped(*cells: tuple[int, int]) -> Case:
    table = np.round(RIGHT, 4)
    for row, column in cells:
        table[row, column] += 0.3
    return files(table), Truth(wrong={*cells})


def turned(line: int, old: str, new: str) -> Case:
    """One sign of one line turned; the truth is where it stands."""
    changed = [*EQUATIONS]
    column = changed[line - 1].index(old) + 1
    changed[line - 1] = changed[line - 1].replace(old, new, 1)
    return files(equations=tuple(changed)), Truth(wrong=set(), lines=(line,), sign=(line, column))


def edited(old: str, new: str) -> Case:
    """The last line with one slip in it."""
    return files(equations=(*EQUATIONS[:3], EQUATIONS[3].replace(old, new))), Truth(wrong=set(), lines=(4,))


def latex() -> Case:
    """The same slip in a line of LaTeX: the plus before r_1 should be a minus."""
    line = r"r_3 \omega_3 \sin\varphi_3 - r_2 \omega_2 \cos\varphi_2 + r_1 \omega_1 \cos\varphi_1 = 0"
    return files(equations=(*EQUATIONS[:3], line)), Truth(wrong=set(), lines=(4,), sign=(4, line.index("+") + 1))


def made(code: str) -> Case:
    return files(students.MISCONCEPTIONS[code]()), Truth(code=code)


def steps_by(increment: Callable, code: str) -> Case:
    """A table whose angles step with velocities of both rows, by repetition until it stands."""
    q, rows = np.array(students.START), []
    for k in range(ROWS):
        rows.append(np.concatenate([q, velocities(k * H, q)]))
        following = q + H * slopes(k * H, q)
        for _ in range(60):
            following = q + H * increment(slopes(k * H, q), slopes((k + 1) * H, following))
        q = following
    return files(np.array(rows)), Truth(code=code)


def exact() -> Case:
    q, rows, parts = np.array(students.START), [], 200
    for k in range(ROWS):
        rows.append(np.concatenate([q, velocities(k * H, q)]))
        for part in range(parts):
            t, h = (k + part / parts) * H, H / parts
            first = slopes(t, q)
            q = q + h * slopes(t + h / 2, q + h / 2 * first)
    return files(np.array(rows)), Truth(code="exact")


def early() -> Case:
    table = RIGHT.copy()
    table[:-1, 3:] = RIGHT[1:, 3:]
    return files(table), Truth(code="omega_early")


def rounded() -> Case:
    table = students.table(lambda t, q: H * np.round(slopes(t, q), 1))
    return files(table), Truth(code="rounded_omega_1")


def origin() -> Case:
    table = RIGHT.copy()
    table[:, 1] = np.pi - table[:, 1]
    return files(table), Truth(code="origin_phi2")


def without(rows: tuple[int, ...] = (), columns: tuple[int, ...] = (), blank: tuple[int, int] | None = None) -> Case:
    kept = [k for k in range(ROWS) if k not in rows]
    chosen = [c for c in range(7) if c not in columns]
    lines = ["t;" + ";".join(NAMES[c] for c in chosen)]
    lines += [f"{k * H:.2f};" + ";".join("" if (k, c) == blank else f"{RIGHT[k, c]:.4f}" for c in chosen) for k in kept]
    absent = {(k, c) for k in range(ROWS) for c in range(7) if k in rows or c in columns or (k, c) == blank}
    found = {"table.csv": "\n".join(lines).encode(), "equations.txt": "\n".join(EQUATIONS).encode()}
    return found, Truth(wrong=set(), absent=absent)


def degrees() -> Case:
    table = np.degrees(RIGHT)
    table[5, 1] += 3
    lines = ["t;" + ";".join(f"{name}, {'deg' if name[0] == 'p' else 'deg/s'}" for name in NAMES)]
    lines += [f"{k * H:.2f};" + ";".join(f"{value:.4f}" for value in row) for k, row in enumerate(table)]
    return files() | {"table.csv": "\n".join(lines).encode()}, Truth(
        wrong={(5, 1)}, said=(f"{table[5, 1]:.4f} deg stands there",)
    )


def repeated() -> Case:
    table = np.round(RIGHT, 4)
    table[10:] = table[9]
    return files(table), Truth(said=("Rows that are the same as the row before them: 11–25.",))


def shifted() -> Case:
    table = np.vstack([RIGHT[:10], RIGHT[11:]])
    return files(table), Truth(
        said=("Rows 11 to 24 hold the numbers of rows 12 to 25 of the task.",), absent={(24, c) for c in range(7)}
    )


def long_numbers() -> Case:
    table = RIGHT.copy()
    table[8, 4] *= 1.2
    return files(table, decimals=15), Truth(wrong={(8, 4)}, said=("Long numbers are rounded here",))


def lacking() -> Case:
    first, third = EQUATIONS[0], EQUATIONS[2]
    lines = (
        "VMy*sin(phi1) = 0",
        "sin(phi1)^2 + cos(phi1)^2 = 1",
        "w1*w2 = 3",
        first,
        f"2*({first.removesuffix(' = 0')}) = 0",
        third,
    )
    lines += (f"{first.removesuffix(' = 0')} + {third.removesuffix(' = 0')} = 0",)
    said = (
        "Line 1 of the equations is not right. It names none of the velocities that are sought (w1, w2, w3 and w4).",
        "Line 2 of the equations earns nothing. It is true for any motion",
        "Line 3 of the equations is not right. In a velocity equation the velocities are neither multiplied",
        "Line 5 of the equations earns nothing. It says the same as line 4 and adds nothing.",
        "Line 7 of the equations earns nothing. It follows from the other lines and adds nothing.",
    )
    return files(equations=lines), Truth(wrong=set(), lines=(1, 3), idle=(2, 5, 7), said=said)


def cases() -> dict[str, Case]:
    """Return the class; only the kind of a case stands in the id, never the name of another."""
    heun = students.table(students.heun)
    unread = (*EQUATIONS[:3], "r3*w3*sin(phi3) § r2*w2*cos(phi2) - foo*w1 = 0")
    own = students.table(printed=lambda t, q: velocities(t, q, r2=2 * students.DATA["r2"]))
    slip_lines = (*EQUATIONS[:2], EQUATIONS[2].replace("r2*w2", "2*r2*w2"), EQUATIONS[3].replace("r2*w2", "2*r2*w2"))
    found: dict[str, Case] = {
        "right": (files(), Truth(wrong=set())),
        "two-decimals": (files(decimals=3), Truth(wrong=set())),
        "slip": (files(students.slip(10, 1, 1.05)), Truth(wrong={(10, 4)})),
        "four": mistyped((3, 3), (7, 4), (12, 5), (20, 6)),
        "forty": mistyped(*[(row, column) for row in range(2, 22) for column in (3, 6)]),
        "minus": turned(4, "- r1", "+ r1"),
        "plus": turned(3, "+ r2", "- r2"),
        "cosine": edited("cos(phi2)", "sin(phi2)"),
        "other-name": edited("r2*w2", "r1*w2"),
        "factor": edited("r2*w2", "2*r2*w2"),
        "latex": latex(),
        "lacking": lacking(),
        "unread": (files(equations=unread), Truth(wrong=set(), unread=(4,))),
        "own": (files(own, slip_lines), Truth(lines=(3, 4))),
        "heun-minus": (edited("- r1", "+ r1")[0] | {"table.csv": table_csv(heun)}, Truth(lines=(4,), code="heun")),
        "no-equations": (files(equations=None), Truth(wrong=set())),
        "no-table": (files(None), Truth()),
        "nothing": ({}, Truth()),
        "a-pdf": ({"table.csv": b"%PDF-1.7 x"}, Truth()),
        "start": (files(students.table(start=(1.73, 3.37, 2.87))), Truth(wrong={(0, 0)})),
        "zeros": (files(np.zeros((ROWS, 7))), Truth(said=("Rows that are the same as the row before them: 2–25.",))),
        "no-rows": without(rows=(6, *range(14, 25)), blank=(3, 4)),
        "no-column": without(columns=(6,)),
        "coarse": (files(decimals=1), Truth(counted=False, said=("Cells with too few decimals",))),
        "degrees": degrees(), "long": long_numbers(), "repeated": repeated(), "shifted": shifted(),
        "trapezoid": steps_by(lambda before, after: (before + after) / 2, "trapezoid"),
        "backward": steps_by(lambda before, after: after, "backward"),
        "exact": exact(), "early": early(), "rounded": rounded(), "origin": origin(),
        "another": (files(students.table(printed=lambda t, q: velocities(t, q, V1=4.0))), Truth(code="variant_s02")),
        "confused": (files(students.table(printed=lambda t, q: velocities(t, q, r1=0.8))), Truth(code="confusion_r1")),
    }  # fmt: skip
    return found | {f"m-{code.replace('_', '-')}": made(code) for code in students.MISCONCEPTIONS}
