"""The outlines of letters and lines in whole fortieths of a point; that is a fifteenth of the finest pixel of a phone.

Enters: the path of a shape as Typst writes it, with relative commands in pt.  Leaves: the path in whole units.
Used by `svg.py`.
"""

from __future__ import annotations

import re

UNITS = 40  # per pt
_BEGIN = "M 0 0"
_COMMAND = re.compile(r"([mlhvcz])([^a-z]*)")


def outline(path: str, x: float = 0.0, y: float = 0.0, up: int = 1) -> str:
    """Return a path in whole units that starts at (`x`, `y`); `up` is 1 if the heights in `path` count upwards, else -1.

    Each point is rounded from its exact place, so that rounding errors do not add up.  Raises `ValueError` for another start.

    >>> outline("M 0 0m 8.027 3.151h -3.2775v 3.2775c 0 0.184 -0.092 0.276 -0.276 0.276Z ")
    'm321-126h-131v-131c0-7-4-11-11-11z'
    """
    if not path.startswith(_BEGIN):
        raise ValueError("Typst's path begins elsewhere than this version of it wrote")
    at, pen = (x, y), (round(x), round(y))
    begin, found, said, last = (at, pen), "", "", (0, 0)
    for command, told in _COMMAND.findall(path.removeprefix(_BEGIN).replace("Z", "z")):
        numbers = [UNITS * float(number) for number in told.split()]
        if command == "z":
            at, pen = begin
            found += command
            said = command
            continue
        if command in "hv":
            numbers.insert(command == "h", 0.0)
        points = [(at[0] + dx, at[1] - up * dy) for dx, dy in zip(numbers[::2], numbers[1::2], strict=True)]
        steps = [(round(to_x) - pen[0], round(to_y) - pen[1]) for to_x, to_y in points]
        at, pen = points[-1], (pen[0] + steps[-1][0], pen[1] + steps[-1][1])
        if command == "m":
            begin = at, pen
        if command == "c":
            handle, last = last, (steps[2][0] - steps[1][0], steps[2][1] - steps[1][1])
            if steps[0] == handle and said in ("c", "s"):  # the handle mirrors the last one of the curve before
                command, steps = "s", steps[1:]
        written = [steps[0][command == "v"]] if command in "hv" else [number for step in steps for number in step]
        text = "".join(f" {number}" if number >= 0 else str(number) for number in written)
        found += text if command == said != "m" else command + text.lstrip()  # left out if repeated; after m it would mean l
        said = command
    return found
