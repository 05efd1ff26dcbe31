"""Cases beside those of `truths.py`, so that every sentence is said once: decisions, measured values, longer and other tables.

Each is (files, the variant's bytes, decisions, why a person must look).
"""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path

import numpy as np

import coursework
from coursework.grading.batch.decisions import Override
from coursework.grading.batch.work import VariantSource
from coursework.grading.marking.key.key import key_of
from coursework.variant.reading.reader import parse_variant
from coursework.words.sentence import Sentence
from coursework.words.sentences import say
from tests.grading.batch.classroom import EQUATIONS, NAMES
from tests.grading.batch.classroom import csv as table_csv
from tests.grading.marking import students
from tests.grading.marking.equations.test_solved import SECOND, SLIP, solved
from tests.grading.marking.machines import Machine
from tests.grading.marking.students import DATA, START, H, velocities
from tests.grading.marking.table.causes.test_mixed_up import MIXED, of_rows_above, with_rounded_pi, with_sines_exchanged
from tests.grading.pages.truths import RIGHT, files
from tests.grading.reading.equations.notation.notations import PLAIN

RUBRIC = """[parts]
answers = 20
[answers]
wA = { of = "w2", row = 4 }
wB = { of = "w1", row = 4 }
wC = { of = "w3", row = 4 }
wD = { of = "w3", row = 4 }
[table]
carried = 0.9
[conventions]
clockwise = "misconception"
[[confusion]]
datum = "r1"
value = "0.8 m"
because = "AB for DA"
"""
ANSWERS = "wA = 0.1136\nwB = 0.82\nwC = 99\nwD = nine\n"
MACHINE = Machine(coursework.load("31"))
CATALOGUE = Path(__file__).parents[3] / "variants"
Handed = tuple[dict[str, bytes], VariantSource, tuple[Override, ...], Sentence | None]


def text(table: np.ndarray, names: tuple[str, ...], step: float = H, decimals: int = 4) -> bytes:
    """A table without the cells that are NaN."""
    lines = ["t;" + ";".join(names)]
    for k, row in enumerate(table):
        lines.append(f"{k * step:.{decimals + 2}f};" + ";".join("" if np.isnan(v) else f"{v:.{decimals}f}" for v in row))
    return "\n".join(lines).encode()


def by_two(q, w3: float, w4: float, q3: float, third=(1, 1, 1), fourth=(1, 1, 1)) -> np.ndarray:
    """w1 to w4 from w3, w4 and the two equations of D with factors before w1, w2 and what is known; r3's angle is `q3`."""
    cos, sin = np.cos(q3), np.sin(q3)
    known = (0.5 * DATA["r3"] * w4 - DATA["r3"] * w3 * cos, DATA["r3"] * w3 * sin)
    a, b = third[0] * DATA["r1"] * np.sin(q[0]), third[1] * DATA["r2"] * np.sin(q[1])
    c, d = fourth[0] * DATA["r1"] * np.cos(q[0]), fourth[1] * DATA["r2"] * np.cos(q[1])
    w1, w2 = np.linalg.solve([[a, b], [c, d]], [third[2] * known[0], fourth[2] * known[1]])
    return np.array([w1, w2, w3, w4])


def new_phi() -> np.ndarray:
    """What is solved after w3 is solved with phi3 already moved to the next row."""

    def printed(t, q):
        w3 = velocities(t, q)[2]
        moved = q[2] + H * w3
        return by_two(q, w3, 2 * w3 * (np.cos(moved) - 2 * np.sin(moved)), moved)

    return students.table(printed=printed)


def turned(t, q) -> np.ndarray:
    """The velocity w2 with the other sign, and all with what no equation gives."""
    return velocities(t, q) * np.array([1, -1, 1, 1]) + 0.1 * np.sin(9 * t)


def two_slips() -> np.ndarray:
    """A wrong sign in each of the equations of D."""

    def printed(t, q):
        _, _, w3, w4 = velocities(t, q)
        return by_two(q, w3, w4, q[2], third=(1, -1, 1), fourth=(-1, 1, 1))

    return students.table(printed=printed)


def own_slip() -> dict[str, bytes]:
    """A wrong sign in the second equation, as handed in, and the table made from it."""

    def printed(t, q):
        w3 = velocities(t, q)[2]
        return by_two(q, w3, -2 * w3 * (np.cos(q[2]) + 2 * np.sin(q[2])), q[2])

    slipped = EQUATIONS[1].replace("- r3", "+ r3")
    return files(students.table(printed=printed), equations=(EQUATIONS[0], slipped, *EQUATIONS[2:]))


def own_sum() -> tuple[np.ndarray, tuple[str, ...]]:
    """The last equation is the sum of two of the task's with a slip in it, and the table is made from it."""
    line = f"{EQUATIONS[3].removesuffix(' = 0')} {EQUATIONS[2].replace('+ r1', '- r1')}"

    def printed(t, q):
        _, _, w3, w4 = velocities(t, q)
        known = (
            0.5 * DATA["r3"] * w4 - DATA["r3"] * w3 * np.cos(q[2]),
            DATA["r3"] * w3 * (np.sin(q[2]) + np.cos(q[2])) - 0.5 * DATA["r3"] * w4,
        )
        a, b, c, d = (DATA[r] * f(q[place]) for f in (np.sin, np.cos) for place, r in enumerate(("r1", "r2")))
        w1, w2 = np.linalg.solve([[a, b], [a + c, d - b]], known)
        return np.array([w1, w2, w3, w4])

    return students.table(printed=printed), (*EQUATIONS[:3], line)


def degrees_in(drive: bool) -> np.ndarray:
    """Degrees taken for radians in the drive alone, or in the equations alone."""

    def printed(t, q):
        x = DATA["p"] * t + DATA["alpha"]
        ratio = np.sin(np.pi / 180 * x) / np.sin(x)
        return velocities(t, q, turned=ratio) if drive else velocities(t, q, degrees=True, turned=1 / ratio)

    return students.table(printed=printed)


def rounded_w3() -> bytes:
    """w3 written with one decimal and used so; one w1 mistyped."""
    q, rows = np.array(START), []
    for k in range(25):
        w3 = round(velocities(k * H, q)[2], 1)
        rows.append([*q, *by_two(q, w3, 2 * w3 * (np.cos(q[2]) - 2 * np.sin(q[2])), q[2])])
        q = q + H * np.array(rows[-1][3:6])
    rows[9][3] += 0.3
    lines = ["t;" + ";".join(NAMES)]
    for k, row in enumerate(rows):
        lines.append(";".join([f"{k * H:.2f}", *(f"{v:.{1 if place == 5 else 4}f}" for place, v in enumerate(row))]))
    return "\n".join(lines).encode()


def position() -> str:
    """A position equation: D stays at its height."""
    held = DATA["r3"] * np.cos(START[2]) + DATA["r2"] * np.sin(START[1]) + DATA["r1"] * np.sin(START[0])
    return f"r3*cos(phi3) + r2*sin(phi2) + r1*sin(phi1) = {held:.13f}"


def with_cell(row: int, column: int, value: float, table: np.ndarray = RIGHT) -> np.ndarray:
    changed = table.copy()
    changed[row, column] = value
    return changed


def mixed_units() -> bytes:
    """Angles in degrees beside velocities in rad/s, one angle mistyped."""
    table = RIGHT.copy()
    table[:, :3] = np.degrees(table[:, :3])
    table[6, 0] += 2
    return text(table, tuple(f"{name}, {'deg' if name[0] == 'p' else 'rad/s'}" for name in NAMES))


def start_and_slips() -> np.ndarray:
    """Begun from another angle, with a cell of every row mistyped: the start explains a part of the table, nothing all of it."""
    table = students.table(start=(1.73, 3.37, 2.87))
    for row in range(1, len(table)):
        table[row, row % 7] += 0.3
    return table


def markdown() -> bytes:
    """A document with a wrong line, one that says what another says, one that nobody can read."""
    lines = (EQUATIONS[0], EQUATIONS[0].replace("VMy", "2*VMy - VMy"), EQUATIONS[3].replace("- r1", "+ r1"))
    lines += ("r3*w3*sin(phi3) § r2*w2*cos(phi2) - foo*w1 = 0",)
    return "\n\n".join(["# Kinematics", *(f"${line}$" for line in lines)]).encode()


def long_table(rows: int, wrong: int) -> np.ndarray:
    q, found = np.array(START), []
    for k in range(rows):
        found.append(np.concatenate([q, velocities(k * H, q)]))
        q = q + H * found[-1][3:6]
    found_rows = np.array(found)
    found_rows[rows - wrong :, 6] += 0.5
    return found_rows


def cases_of_all(source: VariantSource) -> dict[str, Handed]:
    """Return the class of a rubric with measured values."""
    numbers = [";".join(f"{value:.4f}" for value in (k * H, *row)) for k, row in enumerate(RIGHT)]
    more: dict[str, dict[str, bytes]] = {
        "answers": files() | {"answers.txt": ANSWERS.encode()},
        "position": files(equations=(position(), "w1 = w1 + 0*w2", *EQUATIONS)),
        "solved": files(equations=tuple(solved((SLIP, SECOND), (SLIP, SECOND)).split("\n"))),
        "own-slip": own_slip(),
        "missing-term": files(equations=(*EQUATIONS[:3], "r3*w3*sin(phi3) - r2*w2*cos(phi2) = 0")),
        "many-lines": files(equations=tuple(f"w1 = {k}*w2" for k in range(9))),
        "rounded-data": files(equations=(EQUATIONS[0].replace("2*r3*w3", "0.9145*w3"), *EQUATIONS[1:])),
        "number-copied": files(equations=(EQUATIONS[0].replace("r3", "0.557"), *EQUATIONS[1:])),
        "other-sign": files(students.table(printed=partial(velocities, alpha=-4.35))),
        "by-place": {"table.csv": "\n".join(numbers).encode()},
        "wrong-drive": files(equations=("VMy = V1*cos(p*t + alpha)", *EQUATIONS)),
        "prose": files(equations=(*EQUATIONS, "w2 = how r2 turns?")),
        "sines": files(equations=tuple(line.replace("cos(phi3)", "cos phi3") for line in EQUATIONS)),
        "velocities-alone": {"table.csv": text(with_cell(4, 0, 9.0, RIGHT[:, 3:]), NAMES[3:])},
        "mixed-units": {"table.csv": mixed_units()},
        "one-velocity-missing": {"table.csv": text(with_cell(5, 4, np.nan, with_cell(6, 1, 3.0)), NAMES)},
        "every-second-row": {"table.csv": text(np.where(np.arange(25)[:, None] % 2, np.nan, with_cell(8, 1, 9.0)), NAMES)},
        "rounded-w3": {"table.csv": rounded_w3()},
        "document": {"work.md": markdown(), "table.csv": files()["table.csv"]},
        "two-slips": files(two_slips()),
        "start-and-slips": files(start_and_slips()),
        "start-and-turned": files(students.table(start=(1.7, 3.2, 2.6), printed=turned)),
        "own-sum": files(*own_sum()),
        "degrees-drive": files(degrees_in(drive=True)),
        "degrees-equations": files(degrees_in(drive=False)),
        "degrees-put-in": files(students.table(printed=lambda t, q: velocities(t, np.degrees(q)))),
        "new-phi": files(new_phi()),
        "rows-above": files(of_rows_above(MACHINE)),
        "cosine-in-drive": files(with_sines_exchanged(MACHINE)),
        "data-rounded": files(
            Machine(MACHINE.variant, data={"r1": 0.95, "r2": 0.85, "r3": 0.46, "p": 13.0, "alpha": 4.4}).table()
        ),
        **{code.replace("_", "-"): files(made(MACHINE)) for code, made in MIXED.items()},
        "clockwise": files(np.hstack([RIGHT[:, :3], -RIGHT[:, 3:]])),
        "point-slipped": files(np.hstack([10 * RIGHT[:, :3], RIGHT[:, 3:]])),
        "one-column-slipped": files(RIGHT * np.where(np.arange(7) == 4, 10, 1)),
        "one-column-a-row-early": files(np.hstack([RIGHT[:, :3], RIGHT[[*range(1, 25), 24], 3:4], RIGHT[:, 4:]])),
        "rows-from-the-last-on": files(RIGHT[::-1]),
        "no-velocities": files(np.hstack([RIGHT[:, :3], 0 * RIGHT[:, 3:]])),
        "angles-a-row-late": files(np.hstack([RIGHT[[0, *range(24)], :3], RIGHT[:, 3:]])),
    }
    found: dict[str, Handed] = {student: (handed, source, (), None) for student, handed in more.items()}
    right = files()
    found["decided"] = (right, source, (Override("table", 20.0, ""), Override("equations", 10.0, "because")), None)
    found["decided-in-all"] = (right, source, (Override("total", 20.0, "because"),), None)
    found["twin"] = (right, source, (), say("reading.review.same_id", names=("twin", "Twin")))
    longer = VariantSource("long", source.content.replace(b'end       = "0.48 s"', b'end       = "1.48 s"'))
    for wrong in (1, 70):
        found[f"long-{wrong}"] = ({"table.csv": table_csv(long_table(75, wrong))}, longer, (), None)
    slip = "c*w3*sin(phi3) - r2*w2*cos(phi2) + r1*w1*cos(phi1)"
    slider = Machine(coursework.load("v102"), lines={"2": f"{slip} - u"})
    lines = PLAIN["v102"].split("\n")
    lines[1] = f"{slip} = u"
    handed = {"table.csv": text(slider.table(), slider.variant.columns, slider.h), "equations.txt": "\n".join(lines).encode()}
    found["own-line"] = (handed, VariantSource("v102", (CATALOGUE / "v102.toml").read_bytes()), (), None)
    two_laws = Machine(coursework.load("v107"), drive={"VMy": "V2*sin(p*t + alpha)"})
    handed = {"table.csv": text(two_laws.table(), two_laws.variant.columns, two_laws.h)}
    found["one-law"] = (handed, VariantSource("v107", (CATALOGUE / "v107.toml").read_bytes()), (), None)
    by_pi = VariantSource("by-pi", re.sub(rb'(?m)^p( *)= "13.*?"', rb'p\1= "125 rpm"', source.content))
    handed = files(with_rounded_pi(parse_variant(by_pi.content, "by-pi.toml", {}), p=125 * 3.14 / 30))
    found["rounded-pi"] = (handed, by_pi, (), None)
    fourbar = key_of(coursework.load("example-1"))
    handed = {"table.csv": text(fourbar.branches[0], fourbar.names, fourbar.step, 5)}
    example = VariantSource("example-1", (CATALOGUE / "example-1.toml").read_bytes())
    found["branch"] = (handed, example, (), None)
    uneven = parse_variant(example.content.replace(b'w1 = "w0"', b'w1 = "w0*(1 + 0.3*sin(5*t))"'), "uneven.toml", {})
    handed = {
        "table.csv": text(
            coursework.solve(uneven, scheme="euler").table[[*fourbar.names]].to_numpy(), fourbar.names, fourbar.step, 5
        )
    }
    found["other-drive"] = (handed, example, (), None)
    return found
