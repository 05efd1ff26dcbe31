"""Counts as bars a person reads at a glance, drawn in the page itself.

Enters: labels and counts.  Leaves: `Bar`s with places in an SVG.  Used by `class_page.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.system.frozen import frozen

WIDTH, HEIGHT, FOOT, HEAD = 640.0, 150.0, 22.0, 16.0
MOST_LABELS = 16


@frozen
class Bar:
    """One bar: its place and size in the drawing (its units), label below ("" where labels would touch), count above."""

    x: str
    y: str
    width: str
    height: str
    middle: str
    label: str
    count: int


def bars(counts: Sequence[tuple[str, int]]) -> tuple[Bar, ...]:
    """Return the bars of labelled counts, all of one width."""
    if not counts:
        return ()
    most = max(count for _, count in counts) or 1
    pitch = WIDTH / len(counts)
    every = -(-len(counts) // MOST_LABELS)
    made = []
    for place, (label, count) in enumerate(counts):
        height = (HEIGHT - FOOT - HEAD) * count / most
        made.append(
            Bar(
                f"{place * pitch + 0.1 * pitch:.1f}", f"{HEIGHT - FOOT - height:.1f}", f"{0.8 * pitch:.1f}", f"{height:.1f}",
                f"{(place + 0.5) * pitch:.1f}", label if place % every == 0 else "", count,
            )
        )  # fmt: skip
    return tuple(made)
