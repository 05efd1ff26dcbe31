"""Small strips of marks over an axis: one number of each student of a class, drawn alike for data, difficulty and points.

Enters: numbers.  Leaves: `Strip`s, whose places are text for `reports/strip.html.j2`.
Used by `assigning/` and `grading/`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.system.frozen import frozen

HEIGHT = 52.0  # px
LEFT, RIGHT, BASE = 12.0, 348.0, 34.0  # px, of the axis
MARK = 2.5  # px, radius of a mark; marks that would touch are stacked
HIGHEST = 90.0  # px, of a stack of marks; if more are stacked, they overlap


@frozen
class Strip:
    """The strip of one number: its band and centre as places on the axis, a mark (x, y) per student, words for the ends."""

    band: tuple[str, str]
    centre: str
    middle: str
    marks: tuple[tuple[str, str], ...]
    first: str
    last: str
    height: str


def strip(values: Sequence[float], low: float, high: float, centre: float, ends: tuple[str, str], middle: str) -> Strip:
    """Return the strip of `values`, whose axis also contains the band from `low` to `high` and the `centre`.

    `ends` are the words at the ends, `middle` those of the centre.  Marks that would touch are stacked in the order of the
    values, so that equal classes give equal pictures.
    """
    least, most = min([low, centre, *values]), max([high, centre, *values])
    span = (most - least) or 1.0

    def x(value: float) -> float:
        return LEFT + (RIGHT - LEFT) * (value - least) / span if most > least else (LEFT + RIGHT) / 2

    lasts: list[float] = []  # of each level of marks: where its last mark stands
    placed: list[tuple[float, int]] = []
    for at in map(x, sorted(values)):
        level = next((k for k, end in enumerate(lasts) if at - end >= 2 * MARK), len(lasts))
        lasts[level : level + 1] = [at]
        placed.append((at, level))
    pitch = min(2 * MARK, HIGHEST / max(1, len(lasts)))
    height = HEIGHT + pitch * max(0, len(lasts) - 2)
    base = height - (HEIGHT - BASE)
    shown = ends if most > least else ("", "")  # the middle says it
    marks = tuple((f"{at:.1f}", f"{base - MARK - pitch * level:.1f}") for at, level in placed)
    return Strip((f"{x(low):.1f}", f"{x(high) - x(low):.1f}"), f"{x(centre):.1f}", middle, marks, *shown, f"{height:.0f}")
