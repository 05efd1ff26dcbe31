"""Folders of submissions for variant 31, made from students' own formulas."""

from __future__ import annotations

from pathlib import Path

from tests.grading.marking import students

NAMES = ("phi1", "phi2", "phi3", "w1", "w2", "w3", "w4")
EQUATIONS = (
    "VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0",
    "2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0",
    "-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0",
    "r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0",
)


def csv(table, decimals=4):
    lines = ["t;" + ";".join(NAMES)]
    lines += [f"{k * 0.02:.2f};" + ";".join(f"{value:.{decimals}f}" for value in row) for k, row in enumerate(table)]
    return "\n".join(lines).replace(".", ",").encode()


def hand_in(folder: Path, table=None, equations=EQUATIONS, decimals=4):
    folder.mkdir(parents=True)
    (folder / "table.csv").write_bytes(csv(students.table() if table is None else table, decimals))
    (folder / "equations.txt").write_text("\n".join(equations), encoding="utf-8")


def small_class(root: Path) -> Path:
    """Seven students: two right, a slip, Heun, a wrong sign, a pdf for a table, nothing at all."""
    hand_in(root / "ada")
    hand_in(root / "bert", decimals=3)
    hand_in(root / "carl", students.slip(10, 1, 1.05))
    hand_in(root / "dora", students.table(students.heun))
    hand_in(root / "emil", equations=(*EQUATIONS[:3], EQUATIONS[3].replace("- r1", "+ r1")))
    (root / "fred").mkdir()
    (root / "fred" / "table.csv").write_bytes(b"%PDF-1.7 not a table")
    (root / "gina").mkdir()
    return root
