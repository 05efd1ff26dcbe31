"""Tables as programs print them on a console, and as programs have them, are read whole: boxes, pieces, factors, lists, names."""

from __future__ import annotations

import json
from collections.abc import Callable

import numpy as np
import pandas as pd
import pytest

from coursework.grading.reading.read_submission import read_submission
from coursework.grading.reading.submission import Submission, submitted_file
from tests.grading.reading.table.misread import GRID, HEAD, ROWS
from tests.grading.scenes import expected

VALUES = np.array([[float(cell) for cell in row] for row in ROWS])
FRAME = pd.DataFrame(VALUES, columns=HEAD)
COUNT = len(HEAD)


def box(corner: str, line: str, bar: str) -> str:
    rule = corner + corner.join(line * 10 for _ in HEAD) + corner
    rows = [bar + bar.join(f" {cell:>8} " for cell in row) + bar for row in [HEAD, *ROWS]]
    return "\n".join([rule, rows[0], rule, *rows[1:], rule])


def pieces(title: str, wide: int, factor: int = 0) -> str:
    out = ["T =", "", *([f"   1.0e+{factor:02d} *", ""] if factor else [])]
    for start in range(0, COUNT, wide):
        end = min(start + wide, COUNT)
        out += [title.format(first=start + 1, last=end), ""] if end > start + 1 else [f" Column {end}:", ""]
        out += ["".join(f"{value:12.{4 + factor}f}" for value in row[start:end]) for row in VALUES / 10**factor] + [""]
    return "\n".join(out)


def printed(width: int) -> str:
    return np.array2string(VALUES, precision=4, suppress_small=True, max_line_width=width, threshold=10**6)


LISTS = [", ".join(row) for row in ROWS]
BY_COLUMN = {head: [row[at] for row in ROWS] for at, head in enumerate(HEAD)}
TEXTS: dict[str, str] = {
    "box of signs": box("+", "-", "|"), "box of lines": box("┼", "─", "│"), "box of double lines": box("╬", "═", "║"),
    "Typst": f"#table(columns: {COUNT}, " + ",\n".join(", ".join(f"[{c}]" for c in row) for row in [HEAD, *ROWS]) + ")",
    "one cell in each line": "Table 1\n" + "\n".join("\n".join(row) for row in [HEAD, *ROWS]),
    "org": box("|", "-", "|"), "double bars": "\n".join(" || ".join(row) for row in [HEAD, *ROWS]),
    "matlab": pieces("  Columns {first} through {last}", 4), "matlab, narrow": pieces("  Columns {first} through {last}", 3),
    "octave": pieces(" Columns {first} through {last}:", 5), "a last column alone": pieces(" Columns {first} through {last}:", 7),
    "octave, two": pieces(" Columns {first} and {last}:", 2), "a factor": pieces("  Columns {first} through {last}", 4, 1),
    "a factor, whole": "ans =\n\n   1.0e+03 *\n\n"
    + "\n".join("".join(f"{value / 1000:13.7f}" for value in row) for row in VALUES),
    "numpy": printed(200), "numpy, wrapped": printed(50),
    "rows over lines": "\n".join("  ".join(row[k : k + 3]) for row in [HEAD, *ROWS] for k in range(0, COUNT, 3)),
    "matlab source": "T = [" + "; ...\n".join(map(" ".join, ROWS)) + "];",
    "python source": f"import math\nheads = {HEAD}\ntable = [\n    [" + "],\n    [".join(LISTS) + "],\n]\n",
    "maple": f"T := Matrix({len(ROWS)}, {COUNT}, [[{'], ['.join(LISTS)}]]);", "mathematica": f"{{{{{'}, {'.join(LISTS)}}}}}",
    "lists by line": "\n".join(f"[{row}]" for row in LISTS),
    "a list a quantity": "\n".join(f"{name} = [{', '.join(cells)}]" for name, cells in BY_COLUMN.items()),
    "a vector a quantity": "\n".join(f"{name} =\n\n   {'   '.join(cells)}\n" for name, cells in BY_COLUMN.items()),
    "a column a quantity": "\n\n".join(f"{name}:\n" + "\n".join(cells) for name, cells in BY_COLUMN.items()),
    "names with values": "\n".join(", ".join(map(" = ".join, zip(HEAD, row, strict=True))) for row in ROWS),
    "a value a line": "\n\n".join(f"step {k}\n" + "\n".join(map("{} = {}".format, HEAD, row)) for k, row in enumerate(ROWS)),
    "a record a line": "\n".join(json.dumps(dict(zip(HEAD, map(float, row), strict=True))) for row in ROWS),
    "pandas": FRAME.to_string(), "pandas, wrapped": FRAME.to_string(line_width=60),
    "pandas, by time": FRAME.set_index("t").to_string(),
    "pandas, by time, wrapped": FRAME.set_index("t").to_string(line_width=60),
    "r, wrapped": "\n".join(
        " ".join(["  ", *(cell.rjust(9) for cell in row)]) if not k else f"{k:<2} " + " ".join(cell.rjust(9) for cell in row)
        for part in (slice(0, 5), slice(5, COUNT)) for k, row in enumerate([HEAD[part], *(row[part] for row in ROWS)])
    ),
    "yaml": "\n".join(f"{name}:\n" + "\n".join(f"  - {cell}" for cell in cells) for name, cells in BY_COLUMN.items()),
    "a remark before the heads": "# " + " ".join(HEAD) + "\n" + "\n".join(map(" ".join, ROWS)),
    "heads of several words": "  ".join(["time, s", *(f"value {name}, x" for name in HEAD[1:])])
    + "\n" + "\n".join("   ".join(row) for row in ROWS),
    "rows parted by blank lines": "\n\n".join(map("  ".join, [HEAD, *ROWS])),
}  # fmt: skip


PROMPT = ">> main\n\n"
BEHIND = [(case, PROMPT) for case in TEXTS if case != "a record a line"]  # behind a prompt those are no data any more


@pytest.mark.parametrize(("case", "before"), [*((case, "") for case in TEXTS), *BEHIND])
def test_a_printed_table_is_read_whole(case: str, before: str) -> None:
    table = read_submission(Submission("x", None, (submitted_file("t.txt", (before + TEXTS[case]).encode()),)), expected()).table
    assert table is not None and all(table.rows_present)
    read = np.array([column.values for column in sorted(table.columns, key=lambda column: GRID.names.index(column.name))])
    assert read.shape == VALUES[:, 1:].T.shape and np.abs(read - VALUES[:, 1:].T).max() < 1e-9


JSON: dict[str, Callable[[], object]] = {
    "parts of a record": lambda: [{"t": row[0], "phi": [*row[1:4]], "w": [*row[4:]]} for row in VALUES.tolist()],
    "rows under a name": lambda: {"t": [*VALUES[:, 0]], "phi": VALUES[:, 1:4].tolist(), "w": VALUES[:, 4:].tolist()},
    "lists under a name": lambda: {"t": [*VALUES[:, 0]], "phi": VALUES[:, 1:4].T.tolist(), "w": VALUES[:, 4:].T.tolist()},
    "records in a record": lambda: [
        {"t": row[0], "angles": dict(zip(HEAD[1:4], row[1:4], strict=True)), "w": row[4:]} for row in VALUES.tolist()
    ],
}


@pytest.mark.parametrize("case", JSON)
def test_numbers_of_one_row_under_one_name_are_columns(case: str) -> None:
    file = submitted_file("t.json", json.dumps(JSON[case]()).encode())
    table = read_submission(Submission("x", None, (file,)), expected()).table
    assert table is not None and [column.name for column in table.columns] == HEAD[1:]
    assert [column.values[0] for column in table.columns] == VALUES[0, 1:].tolist()
