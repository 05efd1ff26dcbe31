"""Displayed equations as SVG for the HTML page: set by Typst as on paper, each only once per process, with places to break.

Enters: Typst math sources.  Leaves: SVGs that refer to glyphs, and the glyphs, which all SVGs share: outlines in whole
fortieths of a point, a fifteenth of the finest pixel of a phone.
Used by `assigning/sheet.py` and `html.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import zip_longest
from pathlib import Path
from string import ascii_letters
from sys import intern

from coursework.report.formulas.typesetting import refusal, typeset
from coursework.system.frozen import frozen
from coursework.words.data_folders import folder

_SYMBOL = re.compile(r'<symbol id="([^"]+)"[^>]*>\s*<path d="([^"]+)"\s*/>\s*</symbol>')
_RUN = re.compile(r'<g transform="matrix\(1 0 0 -1 (\S+) (\S+)\)"\s*>((?:\s*<use [^>]*/>)*)\s*</g>')
_COPY = re.compile(r'href="#([^"]+)" x="([^"]+)" y="([^"]+)"')
_NOTHING = re.compile(r"<g [^>]*/>|</g>(?:<g[^>]*>|</svg>)?$|</svg>$")  # the last: where the next formula begins
# A bar of a fraction or a root; its line ends, corners and their limit are those of every line, so they are not kept.
_BAR = re.compile(
    r'<path fill="none" stroke="#000000" stroke-width="(\S+)"[^>]*? transform="translate\((\S+) (\S+)\)" d="([^"]*)"/>'
)
_OPENING = re.compile(r'<svg[^>]*?viewBox="0 0 (?P<wide>\S+) (?P<high>\S+)"[^>]*>')
# The frame with which `equation.typ` tells the size of a formula; what follows is placed from its corner.
_FRAME = re.compile(r'<path fill="none" stroke="#f012be"[^>]* d="M 0 0v (?P<high>\S+)h (?P<wide>\S+)v \S+Z "/>')
_OTHER = "Typst's SVG has another shape than this version of it wrote"
_NAMED = re.compile(r'class="(g[0-9A-F]+)"')
# A marker is drawn in units of the width of its line, which is 1.
MARKERS = ".math{width:var(--wide)}.formula .math,.math{fill:none}marker{overflow:visible}"
_LETTERS = ascii_letters.swapcase()  # short names for the most frequent glyphs
MOST_CACHED = 2000  # equations kept; with more (a batch over many variants) the cache is emptied


@frozen
class Picture:
    """A formula as SVG; `pieces` is the number of its pieces, which may stand one below the other."""

    svg: str
    pieces: int = 1


@frozen
class Drawn:
    """Pictures by source, and the glyphs and repeated formulas to which they refer (these stand once in the page)."""

    pictures: dict[str, Picture]
    glyphs: str


_cache: dict[tuple[Path, str], tuple[Picture, dict[str, str]]] = {}


def draw(sources: Iterable[str], *, breaks: bool = False) -> Drawn:
    """Return every equation as SVG; `breaks`: a long one in pieces.  Raises `OutputError` if Typst is not installed."""
    listed = [(source, pieces(source) if breaks else [source]) for source in sources]
    wanted = Counter(piece for _, parts in listed for piece in parts)
    if len(_cache) > MOST_CACHED:
        _cache.clear()
    looks = folder("reports")  # the instructor's own templates may draw them in another way
    if missing := [piece for piece in wanted if (looks, piece) not in _cache]:
        try:
            pages = typeset("equation.typ", missing, "svg")
        except RuntimeError as error:  # typst.TypstError
            raise refusal(error) from error
        pages = pages if isinstance(pages, list) else [pages]
        found = (formula for page in pages for formula in _taken_apart(page.decode("utf-8")))
        for piece, formula in zip(missing, found, strict=True):
            _cache[looks, piece] = formula
    glyphs: dict[str, str] = {}
    for piece in wanted:
        glyphs |= _cache[looks, piece][1]
    uses = Counter(glyph for piece in wanted for glyph in _NAMED.findall(_cache[looks, piece][0].svg))
    often = sorted(glyphs, key=lambda glyph: (-uses[glyph], glyph))
    names = {glyph: _LETTERS[place : place + 1] or f"g{place}" for place, glyph in enumerate(often)}
    common = [_marker(name, glyphs[glyph]) for glyph, name in names.items()]
    style = "".join(f".{name}{{marker-mid:url(#{name})}}" for name in names.values())
    drawn: dict[str, Picture] = {}
    for piece, times in wanted.items():
        picture = _cache[looks, piece][0]
        body = _NAMED.sub(lambda told: f'class="{names[told[1]]}"', picture.svg)
        if times > 1:
            head, inside = body.removesuffix("</svg>").split(">", 1)
            common.append(f'<g id="f{len(common)}">{inside}</g>')
            body = f'{head}><use href="#f{len(common) - 1}"/></svg>'
        drawn[piece] = replace(picture, svg=body)
    pictures = {source: _joined([drawn[piece] for piece in parts]) for source, parts in listed}
    return Drawn(pictures, f"<style>{MARKERS}{style}</style>{''.join(common)}")


def _joined(parts: list[Picture]) -> Picture:
    if len(parts) == 1:
        return parts[0]
    return Picture("".join(part.svg for part in parts), len(parts))


def _taken_apart(svg: str) -> Iterator[tuple[Picture, dict[str, str]]]:
    """Yield every formula of a page without its glyphs, and their outlines by id; an own template may set one on each page.

    Raises `ValueError` if the SVG has another form.
    """
    body, _, definitions = svg.partition("<defs")
    glyphs = {intern(found[1]): intern(found[2]) for found in _SYMBOL.finditer(definitions)}  # one string for all formulas
    begins = list(_FRAME.finditer(body)) or list(_OPENING.finditer(body))
    if not begins:
        raise ValueError(_OTHER)
    for begin, after in zip_longest(begins, begins[1:]):
        yield _formula(float(begin["wide"]), float(begin["high"]), body[begin.end() : after and after.start()], glyphs)


def _formula(wide: float, high: float, body: str, outlines: dict[str, str]) -> tuple[Picture, dict[str, str]]:
    placed = [
        (copy[1], round(UNITS * (float(run[1]) + float(copy[2]))), round(UNITS * (float(run[2]) - float(copy[3]))))
        for run in _RUN.finditer(body)  # heights inside a run count upwards
        for copy in _COPY.finditer(run[3])
    ]
    # Heights are counted from the baseline of most letters, so that most of them are 0.
    line = Counter(y for _, _, y in placed).most_common(1)[0][0] if placed else 0
    places: dict[str, list[tuple[int, int]]] = {}
    for glyph, x, y in placed:
        places.setdefault(glyph, []).append((x, y - line))
    bars = _BAR.sub(lambda bar: _bar(bar, line), _NOTHING.sub("", _RUN.sub("", body)))
    if "<use" in bars or "<g" in bars or "transform" in bars or not places.keys() <= outlines.keys():
        raise ValueError(_OTHER)
    size = f'style="--wide:{wide:.2f}pt"'
    # Two digits more than the eye needs: the height decides on which pixels the text beside the formula stands.
    head = f'<svg class="math" viewBox="0 {-line} {UNITS * wide:.7g} {UNITS * high:.7g}" {size} aria-hidden="true">'
    letters = "".join(_set(glyph, where) for glyph, where in places.items())
    return Picture(f"{head}{letters}{bars.strip()}</svg>"), {glyph: outlines[glyph] for glyph in places}


def _bar(bar: re.Match[str], line: int) -> str:
    thick, x, y = (UNITS * float(number) for number in bar.groups()[:3])
    way = outline(bar[4], x, y - line, up=-1)
    # `currentColor` gives the bar the colour of the text, on a dark screen too.
    return f'<path stroke="currentColor" stroke-width="{thick:g}" d="M{round(x)} {round(y - line)}{way}"/>'


@lru_cache(maxsize=MOST_CACHED)
def _marker(glyph: str, path: str) -> str:
    """Return a glyph as an SVG marker, so that one element of a formula holds the places of all copies of the glyph.

    One element per copy would mean a thousand elements on a page, and a browser goes through all of them at each repaint.
    """
    return f'<marker id="{glyph}"><path d="{outline(path)}"/></marker>'


def _set(glyph: str, places: list[tuple[int, int]]) -> str:
    """Return an invisible line with the glyph at each of its corners, but not at its two ends."""
    way, height, level = "M0 0", 0, False
    for x, y in places:
        level, before = y == height, level
        way += f"{' ' if before else 'H'}{x}" if level else f"{'L' if before else ' '}{x} {y}"
        height = y
    return f'<path class="{glyph}" d="{way.replace(" -", "-")}z"/>'


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


LONG = 56  # characters of Typst math; a shorter formula fits the screen of a phone
TOGETHER = 44  # characters of neighbouring pieces that fit on one line of a phone beside the formula's number, so they are joined
_SET_ALREADY = re.compile(r"^& | \\ & quad(?= )")  # line breaks already set in a formula that is too long for a line on paper
_SIGNS = (" = ", " + ", " - ")
_AFTER = " "  # stands before a sign that begins a piece, so that `equation.typ` sets the sign as one between two terms


def pieces(source: str) -> list[str]:
    """Return the pieces of a formula; a short formula, or one without a place to break, stays one piece.

    >>> pieces("x = a + b")
    ['x = a + b']
    >>> pieces("V_(D y) = ω_4 frac(r_3, 2) cos(π slash 2) + ω_3 r_3 cos(φ_3 + 3 π slash 2) = 0")
    ['V_(D y) = ω_4 frac(r_3, 2) cos(π slash 2)', ' + ω_3 r_3 cos(φ_3 + 3 π slash 2) = 0']
    """
    if len(source) < LONG or "cases(" in source:
        return [source]
    parted = _parted(_SET_ALREADY.sub("", source))
    return _gathered([piece for long in parted for piece in _opened(long)])


def _gathered(found: list[str]) -> list[str]:
    """Return the pieces with short neighbours joined, and with a final "= 0" joined to the piece before it."""
    kept = found[:1]
    for piece in found[1:]:
        if len(kept[-1]) + len(piece) <= TOGETHER or piece == f"{_AFTER}= 0":
            kept[-1] += piece
        else:
            kept.append(piece)
    return kept


def _parted(source: str) -> list[str]:
    """Return the formula split before "=", "+" and "-" outside all parentheses; all pieces but the first begin with the sign."""
    places, depth, is_text = [0], 0, False
    for place, sign in enumerate(source):
        if sign == '"':
            is_text = not is_text
        elif not is_text:
            depth += (sign == "(") - (sign == ")")
            if depth == 0 and place and source.startswith(_SIGNS, place):
                places.append(place)
    ends = [*places[1:], len(source)]
    found = [source[begin:end].strip() for begin, end in zip(places, ends, strict=True)]
    return [found[0], *(_AFTER + piece for piece in found[1:])]


def _opened(piece: str) -> list[str]:
    """Return a long product that ends in a sum, "g (a - b + c)", split at the terms of that sum; another piece whole."""
    begin = piece.find(" (")
    if len(piece) < LONG or begin < 0 or not piece.endswith(")") or "(" in piece[:begin].replace("_(", ""):
        return [piece]
    inside = _parted(piece[begin + 2 : -1])
    depth = 0
    for sign in piece[begin + 2 : -1]:
        depth += (sign == "(") - (sign == ")")
        if depth < 0:  # the last parenthesis does not close the first one
            return [piece]
    return [f"{piece[:begin]} \\({inside[0]}", *inside[1:-1], f"{inside[-1]}\\)"] if len(inside) > 1 else [piece]
