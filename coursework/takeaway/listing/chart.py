"""The block diagram of a program, ISO 5807 (ГОСТ 19.701); its boxes have the numbers of the listing's comments.

Enters: a `Program` and words.  Leaves: SVG.  Used by `commands/listing.py` and `appendix.py`.

There are two columns: the program with its loop between two loop limits, and beside it the velocities, which the program calls
as a predefined process.  A block whose determinant can vanish is followed by a decision that leads to a stop.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from textwrap import wrap
from xml.sax.saxutils import escape

from coursework.report.text.words import Words
from coursework.system.frozen import frozen
from coursework.takeaway.listing.program import Box, Program
from coursework.words.templates import clean

WIDTH, HEIGHT, GAP, APART, EDGE = 190.0, 44.0, 22.0, 90.0, 20.0  # px: size of a box, distances between boxes
_LETTERS = 30  # letters of a line in a box
_CUT = 12.0  # px: width of a slanted side


# Attributes, no style sheet: in a page a style sheet would change every other drawing too.
_LETTERING = (
    """font-family="sans-serif, 'Noto Sans CJK SC', 'Noto Serif CJK SC', 'Microsoft YaHei'" font-size="12" """
    'fill="currentColor" text-anchor="middle"'
)
_BOX = 'fill="none" stroke="currentColor" stroke-width="1.2"'
_LINE = 'fill="none" stroke="currentColor"'
_TIP = 'fill="currentColor"'
_NUMBER = 'font-size="10" text-anchor="start"'


@frozen
class Placed:
    """A box, and the middle of its upper edge."""

    box: Box
    x: float
    y: float


def block_diagram(program: Program, words: Words) -> str:
    """Return the block diagram as SVG."""
    main, own = _columns(program, words)
    width, height = size_of(program, words)
    drawn = [part for column in (main, own) for part in _column(column)]
    drawn += list(_skip(main, program)) + list(_stops(own, words))
    label = clean(program.title)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" width="{width:g}" height="{height:g}" '
        f'role="img" aria-label="{escape(label, {chr(34): "&quot;"})}">'
        f"<g {_LETTERING}>{''.join(drawn)}</g></svg>\n"
    )


def size_of(program: Program, words: Words) -> tuple[float, float]:
    """Return width and height of the block diagram, px."""
    main, own = _columns(program, words)
    return own[0].x + WIDTH / 2 + APART, max(one.y for one in (*main, *own)) + HEIGHT + EDGE


def _columns(program: Program, words: Words) -> tuple[list[Placed], list[Placed]]:
    main = _down(program.boxes.values(), EDGE + WIDTH / 2)
    return main, _down(_velocities(program, words), EDGE + WIDTH + APART + WIDTH / 2)


def _velocities(program: Program, words: Words) -> Iterator[Box]:
    """Yield the boxes of the velocities, from first to last terminator."""
    yield Box(len(program.boxes) + 1, "terminator", words("listing.box.rates"))
    for block in program.blocks:
        yield block.box
        if block.checked:
            told = words("listing.zero", name=f"D{int(block.checked[4:]) + 1}")
            yield Box(block.box.number + 1, "decision", told)
    yield program.returned(words)


def _down(boxes: Iterable[Box], x: float) -> list[Placed]:
    return [Placed(box, x, EDGE + place * (HEIGHT + GAP)) for place, box in enumerate(boxes)]


def _column(column: list[Placed]) -> Iterator[str]:
    for place, one in enumerate(column):
        yield _outline(one)
        yield from _text(one)
        if place:
            yield _arrow(one.x, one.y - GAP, one.x, one.y)


def _outline(one: Placed) -> str:
    left, right, top, low = one.x - WIDTH / 2, one.x + WIDTH / 2, one.y, one.y + HEIGHT
    match one.box.kind:
        case "terminator":
            return f'<rect {_BOX} x="{left:g}" y="{top:g}" width="{WIDTH:g}" height="{HEIGHT:g}" rx="{HEIGHT / 2:g}"/>'
        case "data":
            return _polygon((left + _CUT, top), (right, top), (right - _CUT, low), (left, low))
        case "decision":
            return _polygon((one.x, top), (right, top + HEIGHT / 2), (one.x, low), (left, top + HEIGHT / 2))
        case "begin":
            return _polygon(
                (left, low), (left, top + _CUT), (left + _CUT, top), (right - _CUT, top), (right, top + _CUT), (right, low)
            )
        case "end":
            return _polygon(
                (left, top), (right, top), (right, low - _CUT), (right - _CUT, low), (left + _CUT, low), (left, low - _CUT)
            )
    box = f'<rect {_BOX} x="{left:g}" y="{top:g}" width="{WIDTH:g}" height="{HEIGHT:g}"/>'
    if one.box.kind == "subroutine":
        sides = "".join(f"M{x:g} {top:g}V{low:g}" for x in (left + 8, right - 8))
        box += f'<path {_LINE} d="{sides}"/>'
    return box


def _polygon(*points: tuple[float, float]) -> str:
    return f'<polygon {_BOX} points="{" ".join(f"{x:g},{y:g}" for x, y in points)}"/>'


def _text(one: Placed) -> Iterator[str]:
    lines = _lines(clean(one.box.text))
    top = one.y + HEIGHT / 2 + 4 - 7 * (len(lines) - 1)
    for place, line in enumerate(lines):
        yield f'<text x="{one.x:g}" y="{top + 14 * place:g}">{escape(line)}</text>'
    yield f'<text {_NUMBER} x="{one.x - WIDTH / 2:g}" y="{one.y - 3:g}">{one.box.number}</text>'


def _lines(text: str) -> list[str]:
    """Return a text as at most three lines of a box."""
    found = wrap(text, _LETTERS, break_long_words=False, break_on_hyphens=False)
    return found if len(found) <= 3 else [*found[:2], f"{found[2]} …"]


def _arrow(x0: float, y0: float, x: float, y: float) -> str:
    line = f'<path {_LINE} d="M{x0:g} {y0:g}L{x:g} {y:g}"/>'
    if x0 == x:
        return f'{line}<path {_TIP} d="M{x:g} {y:g}l-3 -7h6z"/>'
    return f'{line}<path {_TIP} d="M{x:g} {y:g}l-7 -3v6z"/>'


def _skip(main: list[Placed], program: Program) -> Iterator[str]:
    """Yield the path around the step, which is taken when no further row is wanted."""
    places = {one.box.number: one for one in main}
    more, again = (places[program.boxes[key].number] for key in ("more", "again"))
    x = more.x + WIDTH / 2
    out, low = x + 25, again.y + HEIGHT / 2
    yield f'<path {_LINE} d="M{x:g} {more.y + HEIGHT / 2:g}H{out:g}V{low:g}H{x:g}"/>'
    yield f'<path {_TIP} d="M{x:g} {low:g}l7 -3v6z"/>'
    yield f'<text x="{x + 12:g}" y="{more.y + HEIGHT / 2 - 5:g}">−</text>'
    yield f'<text x="{more.x + 10:g}" y="{more.y + HEIGHT + 14:g}">+</text>'


def _stops(own: list[Placed], words: Words) -> Iterator[str]:
    """Yield the exits that are taken when a determinant is zero."""
    for one in own:
        if one.box.kind == "decision":
            x, y = one.x + WIDTH / 2, one.y + HEIGHT / 2
            yield _arrow(x, y, x + 26, y)
            yield f'<rect {_BOX} x="{x + 26:g}" y="{y - 13:g}" width="52" height="26" rx="13"/>'
            yield f'<text x="{x + 52:g}" y="{y + 4:g}">{escape(words("listing.box.end"))}</text>'
            yield f'<text x="{x + 12:g}" y="{y - 5:g}">+</text><text x="{one.x + 10:g}" y="{one.y + HEIGHT + 14:g}">−</text>'
