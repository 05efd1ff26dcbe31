"""What a file may name: schemes and kinds of group.  Their mathematics stands floors above, under the same names.

Enters: nothing.  Leaves: names.  Used by `reader.py`, `schema.py`, `shape.py` and `places.py`, and by whoever makes a motion.
A test holds the names to the records: `SCHEMES` of `motion/schemes.py` and `GROUPS` of `mechanism/groups/`.
"""

from __future__ import annotations

SCHEME_NAMES = ("euler", "midpoint", "heun", "ralston", "rk4")
EXACT = "exact"  # stands for a scheme: the motion of the mechanism itself, which no tableau makes
# The kinds of group, and how many of the coordinates of each, the first ones, are angles; the others are lengths.
GROUP_KINDS = {"crank": 1, "RRR": 2, "RRP": 1, "RPR": 1, "RPP": 0, "PRP": 0}


def scheme_names() -> tuple[str, ...]:
    """Return every name that `--scheme` and a variant file may give: the schemes, and the exact motion."""
    return (*SCHEME_NAMES, EXACT)
