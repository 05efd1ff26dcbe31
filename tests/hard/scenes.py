"""Small variant files for the hard cases, written in the documented format."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import coursework
from coursework.run import Run
from coursework.variant.reading.reader import parse_variant

ROOT = Path(__file__).parents[2]
REFERENCE = ROOT / "tests" / "reference"
CASES = {case["id"]: case for case in json.loads((REFERENCE / "hard_cases.json").read_text(encoding="utf-8"))["cases"]}
V31 = (ROOT / "variants" / "31.toml").read_text(encoding="utf-8").split("[ask]")[0]
# Variant 31 with its phase read as 0.02: a scene that cannot be driven (H01).
V31_IMPOSSIBLE = V31.replace('"4.35 rad"', '"0.02 rad"')


def expected(case: str) -> dict[str, Any]:
    """Return the expected numbers of a case."""
    found: dict[str, Any] = CASES[case]["expected"]
    return found


def scene(
    coordinates: str, *, given: str = "", drive: str = "", unknowns: str = "", step: float = 0.02, end: float = 1.0,
    equations: Iterable[str] = (), closures: Iterable[str] = (), more: str = "", time: str = "",
) -> str:  # fmt: skip
    """Return the text of a variant; sections are given as their lines, constraints are numbered from 1."""
    lines = ["format = 1", "[given]", given, "[drive]", drive, "[coordinates]", coordinates, "[unknowns]", unknowns]
    lines += ["[time]", f'step = "{step!r} s"', f'end = "{end!r} s"', time]
    written = [*(("equation", text) for text in equations), *(("closure", text) for text in closures)]
    for number, (kind, text) in enumerate(written, start=1):
        lines += ["[[constraint]]", f'name = "{number}"', f'{kind} = "{text}"']
    return "\n".join([*lines, more])


def rates(*names: str) -> str:
    """Return coordinates x1, x2 … that start at zero, with these rates."""
    return "\n".join(f'x{i} = {{ start = "0 rad", rate = "{name}" }}' for i, name in enumerate(names, start=1))


def four_bar(
    a: float, b: float, c: float, d: float, start: Sequence[float], *, speed: str = "1", step: float = 0.02, end: float = 1.0,
    time: str = "", unit: str = "m",
) -> str:  # fmt: skip
    """Return a four-bar by its closure a@theta + b@p = (d, 0) + c@q from `start` (theta, p, q), crank speed in rad/s."""
    return scene(
        f'theta = {{ start = "{start[0]!r} rad", rate = "w1" }}\n'
        f'p = {{ start = "{start[1]!r} rad", rate = "wp" }}\nq = {{ start = "{start[2]!r} rad", rate = "wq" }}',
        given="\n".join(f'{name} = "{value!r} {unit}"' for name, value in zip("abcd", (a, b, c, d), strict=True)),
        drive=f'w1 = "{speed}"',
        step=step,
        end=end,
        closures=["a @ theta + b @ p = (d, 0) + c @ q"],
        time=time,
    )


def solve(text: str, scheme: str = "euler", quantities: Sequence[str] = ("table",), **options: Any) -> Run:
    """Return the run of a text."""
    return coursework.solve(parse_variant(text), scheme, quantities=quantities, **options)


def check(run: Run, code: str) -> Any:
    """Return one check of a run that was asked for its checks."""
    return next(found for found in run.checks if found.code == code)


def numbers(text: str) -> list[float]:
    """Return the numbers in a sentence."""
    return [float(found) for found in re.findall(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", text)]
