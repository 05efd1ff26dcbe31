"""What leaves the drawing board: one picture with its words, the same for screen and paper.

Enters: SVG made in this room or in `plans`.  Leaves: `Drawing`.
Used by `drawing/figures.py`, `quantities.py`, `scene_run.py` and `figures.py`.
"""

from __future__ import annotations

from coursework.system.frozen import frozen


@frozen
class Drawing:
    """One figure: `id` for links, `svg` (one unit = 1 mm) of `width` by `height` mm, `caption`, and `alt`, its description.

    One wider than a column gets a landscape page of its own; an `exact` one is printed at exactly its size, as it has a scale.
    `steps` are sentences to be numbered below it; `letters` name points in them and are set as in a formula.
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
