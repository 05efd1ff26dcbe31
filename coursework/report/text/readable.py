"""The smallest size of a picture at which its words can still be read.

Enters: SVG in which one unit is 1 mm, and its width.  Leaves: the least width.
Used by `parts.py`.
"""

from __future__ import annotations

import math
import re

DRAWING, GRAPH = 11.0, 12.0  # px, the least height of letters
INDEX = 0.7  # parts of that height which suffice for a subscript
PIXELS = 96 / 25.4  # per mm, as browsers count
_SIZE = re.compile(r'(<tspan dy="[\d.]+" )?font-size="([\d.]+)"')


def least_width(svg: str, width: float, word: float = DRAWING) -> float:
    """Return the width (mm, rounded up to 0.1 mm) at which the smallest letters are `word` px high, or 70 % in a subscript.

    `width` (mm) is that of the picture at its own size; the result is 0 if it has no words.

    >>> least_width('<svg><text font-size="3.2">A<tspan dy="0.8" font-size="2.3">1</tspan></text></svg>', 100.0)
    91.0
    """
    parts = ((INDEX if lowered else 1.0) * word / (PIXELS * float(size)) for lowered, size in _SIZE.findall(svg))
    return math.ceil(10 * width * max(parts, default=0.0)) / 10
