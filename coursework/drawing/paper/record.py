"""What leaves the drawing board: one picture with its words, the same for the screen and for paper.

Enters: SVG made in this room or in `plans`.  Leaves: `Drawing`.
Used by `drawing/figures.py`, `quantities.py`, `scene_run.py` and `figures.py`.
"""

from __future__ import annotations

from coursework.system.frozen import frozen


@frozen
class Drawing:
    """One figure: `id` for links, `svg` (one unit = 1 mm) of `width` by `height` mm, `caption`, and `alt` for who cannot see it.

    `wide` drawings need a landscape page of their own; `exact` ones are printed at exactly their size, which carries a scale.
    `steps` are sentences to be numbered below it; `letters` are those that name points there, set as in a formula.
    """

    id: str
    svg: str
    width: float
    height: float
    caption: str
    alt: str
    exact: bool = False
    steps: tuple[str, ...] = ()
    letters: tuple[str, ...] = ()
