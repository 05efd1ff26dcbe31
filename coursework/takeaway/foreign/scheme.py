"""What a file of another program says of a mechanism, as far as it has a counterpart here.

Leaves: `Scheme`, `Slider`, `Turned`.  Used by the readers of this folder, `groups.py` and `text.py`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from coursework.system.frozen import frozen
from coursework.words.errors import InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

MOST_BYTES = 1_000_000
MOST_JOINTS = 100  # more has no page a student could read
LARGEST = 1e9  # of a coordinate


@frozen
class Slider:
    """A joint that slides on a line through a place, at an angle (rad): of the frame, or of a moving link by its number."""

    through: complex
    angle: float
    link: int | None = None


@frozen
class Turned:
    """A further link that turns about a fixed joint: so many times as fast as the crank."""

    pivot: str
    link: int
    ratio: float


@frozen
class Scheme:
    """Places of joints (m) by id, which of them are fixed, the joints of each moving link, sliders, and the crank.

    The crank turns about the joint `pivot`, its link is `links[crank]`, `speed` (rad/s) None where the file says none.
    `remarks` list what the file has that is left out, and what it does not say.
    """

    program: str
    title: str
    joints: Mapping[str, complex]
    fixed: frozenset[str]
    links: tuple[tuple[str, ...], ...]
    sliders: Mapping[str, Slider]
    pivot: str
    crank: int
    speed: float | None
    remarks: tuple[Sentence, ...]
    turned: tuple[Turned, ...] = ()


def refused(program: str, place: object) -> InputError:
    """Return what is told of a file that cannot be read as one of a program."""
    return InputError(say("fault.C094", program=program, place=place))


def number(value: object, program: str, place: object) -> float:
    """Return a finite number.  Raises `InputError`."""
    try:
        found = float(str(value))
    except ValueError:
        raise refused(program, place) from None
    if not math.isfinite(found) or abs(found) > LARGEST:
        raise refused(program, place)
    return found


def left_out(what: str) -> Sentence:
    """Return the remark about something without a counterpart."""
    return say("foreign.left_out", what=what[:80])


def no_crank(program: str) -> InputError:
    """Return what is told where nothing turns about a fixed joint."""
    return InputError(say("fault.C095", program=program))


def link_of(links: Sequence[Sequence[str]], *joints: str) -> int | None:
    """Return the number of the link that has some joints, None where none has."""
    return next((place for place, own in enumerate(links) if set(joints) <= set(own)), None)


def driven_link(program: str, links: tuple[tuple[str, ...], ...], pivot: str, fixed: frozenset[str]) -> int:
    """Return which link turns about a fixed joint.  Raises `InputError` where none does."""
    for place, joints in enumerate(links):
        if pivot in joints and not fixed.issuperset(joints):
            return place
    raise no_crank(program)
