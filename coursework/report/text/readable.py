"""How small a picture may be shown before its words can no longer be read.

Enters: SVG in which one unit is 1 mm, and its width.  Leaves: the least width.
Used by `parts.py`.
"""

from __future__ import annotations

import math
import re

DRAWING, GRAPH = 11.0, 12.0  # px, as high as letters must be
INDEX = 0.7  # of it, what is set lower
PIXELS = 96 / 25.4  # of 1 mm, as browsers count
_SIZE = re.compile(r'(<tspan dy="[\d.]+" )?font-size="([\d.]+)"')


def least_width(svg: str, width: float, word: float = DRAWING) -> float:
    """Return the width (mm, not below 0.1 mm too small) at which the smallest word of a picture is so many px, an index 70 %.

    `width` (mm) is that of the picture at its own size; 0 is returned where it has no words.

    >>> least_width('<svg><text font-size="3.2">A<tspan dy="0.8" font-size="2.3">1</tspan></text></svg>', 100.0)
    91.0
    """
    parts = ((INDEX if lowered else 1.0) * word / (PIXELS * float(size)) for lowered, size in _SIZE.findall(svg))
    return math.ceil(10 * width * max(parts, default=0.0)) / 10
