"""The default rubric as a file to begin with: every key a line, what is optional as a comment.

Enters: nothing.  Leaves: the text of a TOML file.  Used by `options.py`.
"""

from __future__ import annotations

from typing import Any

from coursework.grading.marking.rubric import CONVENTIONS, Rubric

_OPTIONAL = {
    "answers": '# wAB = { of = "w2", row = 4, tolerance = 0.05 }\n',
    "confusion": '# [[confusion]]\n# datum = "alpha"\n# value = "0.02 rad"\n# because = "the step under the wrong letter"\n',
}
_LATE = """# [late]
# deadline = 2026-12-01T23:59:00+08:00
# grace = "15 min"
# lost_per_day = 0.1
# at_most = 0.5
"""


def rubric_example() -> str:
    """Return the default rubric, valid as it is."""
    plain = Rubric().plain()
    lines = [_line(key, value) for key, value in plain.items() if not isinstance(value, (dict, list))]
    for key, value in plain.items():
        if isinstance(value, dict):
            lines += [f"[{key}]\n", *(_line(name, worth) for name, worth in value.items())]
        lines += [_OPTIONAL[key]] if key in _OPTIONAL else []
    return "".join([*lines, _LATE])


def _line(key: str, value: Any) -> str:
    choice = {"missing_part": ("review", "zero"), "clockwise": CONVENTIONS}.get(key, ())
    others = "".join(f'  # or "{other}"' for other in choice if other != value)
    written = f'"{value}"' if isinstance(value, str) else f"{value:g}"
    return f"{key} = {written}{others}\n"
