"""The file of a draft: every key that a chain has, a comment on each, in the language asked.

Enters: a `Draft`, the name of the file, what puts a sentence into a language.  Leaves: the text.
Used by `commands/new.py` and the desk.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from unicodedata import east_asian_width

from coursework.mechanism.drafts.chain import SWING, TURNED, Draft, GroupDraft, GuideOf
from coursework.variant.record.roles import role, roles, title
from coursework.variant.record.vocabulary import EXACT, SCHEME_NAMES
from coursework.words.sentences import say

_COMMENT = 46  # the column where comments begin
_STEPS, _CHECK_ROW = 72, 10
Said = Callable[[str], str]
Line = tuple[str, str]  # what the file says, and the comment


def text_of(draft: Draft, name: str, said: Said, asked: Sequence[str]) -> str:
    """Return the file, which asks for some quantities; `said` returns a sentence in the language of the comments."""
    lines = [_written(code, said(comment) if comment else "") for code, comment in _lines(draft, name, asked)]
    return "\n".join(lines) + "\n"


def additions(draft: Draft, number: int, said: Said) -> dict[str, list[str]]:
    """Return the lines that a file gets for the groups of a draft, by section; the first of them is its group `number`."""
    parts: dict[str, list[Line]] = {
        "given": [*_given(draft)][1:-1], "drive": [*_drive(draft)][1:-1], "coordinates": [*_coordinates(draft)][1:-1],
        "points": [*_points(draft)],
        "group": [line for place, group in enumerate(draft.groups, start=number) for line in _group(group, place)],
    }  # fmt: skip
    return {
        section: [_written(code, said(comment) if comment else "") for code, comment in lines] for section, lines in parts.items()
    }


def _written(code: str, comment: str) -> str:
    if not comment:
        return code
    wide = sum(east_asian_width(letter) in "WF" for letter in code)
    return f"{code:<{_COMMENT - wide}} # {comment}" if code else f"# {comment}"


def _lines(draft: Draft, name: str, asked: Sequence[str]) -> Iterator[Line]:
    kinds = ", ".join(str(group.kind) for group in draft.groups)
    yield "", say("new.head", name=name, kinds=kinds)
    yield "", say("new.change_data")
    yield "", say("new.change_groups")
    if any(crank.swings for crank in draft.cranks):
        yield "", say("new.swings")
    yield "", ""
    yield "format  = 1", say("new.format")
    yield f'title   = "{kinds}"', say("new.title")
    yield 'source  = ""', say("new.source")
    yield "", ""
    yield from _given(draft)
    yield from _drive(draft)
    yield from _coordinates(draft)
    yield from _time(draft)
    yield "[points]", say("new.points")
    yield from _points(draft)
    for number, group in enumerate(draft.groups, start=1):
        yield from _group(group, number)
    yield from _frame(draft)
    yield "[ask]", say("new.ask")
    listed = ", ".join(f'"{quantity}"' for quantity in asked)
    yield f"quantities = [{listed}]", say("new.quantities")


def _given(draft: Draft) -> Iterator[Line]:
    yield "[given]", say("new.given")
    for crank in draft.cranks:
        yield (
            f'n{crank.crank} = "60 rpm"',
            say("new.speed" if not crank.swings else "new.swinging", rate=crank.coordinates[0].rate),
        )
        if crank.swings:
            yield f'swing{crank.crank} = "{SWING} rad"', say("new.swing", angle=crank.coordinates[0].name)
    for group in draft.groups:
        for number, length in enumerate(group.lengths, start=1):
            yield f'{length} = "{draft.lengths[length]:g} m"', role(group.kind.shape, "lengths", group.letters, number)
        for guide in group.guides:
            key = "new.angle_on" if guide.turns else "new.angle_of"
            yield f'{guide.angle} = "{draft.angles[guide.angle]} deg"', say(key, point=guide.through, turns=guide.turns)
    for point, place in draft.places.items():
        if place:
            yield f'x{point} = "{place.real:g} m"', say("datum.x", point=point)
            yield f'y{point} = "{place.imag:g} m"', say("datum.y", point=point)
    yield "", ""


def _drive(draft: Draft) -> Iterator[Line]:
    yield "[drive]", say("new.drive")
    for crank in draft.cranks:
        n, swing = f"n{crank.crank}", f"swing{crank.crank}"
        law = f"{swing}*{n}*cos({n}*t)" if crank.swings else n
        yield f'{crank.coordinates[0].rate} = "{law}"', say("new.law", angle=crank.coordinates[0].name)
    yield "", ""


def _coordinates(draft: Draft) -> Iterator[Line]:
    yield "[coordinates]", say("new.coordinates")
    for group in draft.groups:
        for place, own in enumerate(group.coordinates, start=1):
            start = f'start = "{TURNED[(group.crank - 1) % len(TURNED)]} deg", ' if group.kind.driven else ""
            unit = f', unit = "{own.unit}"'
            yield (
                f'{own.name} = {{ {start}rate = "{own.rate}"{unit} }}',
                role(group.kind.shape, "coordinates", group.letters, place),
            )
    yield "", ""


def _points(draft: Draft) -> Iterator[Line]:
    for point, at in draft.places.items():
        place = f"(x{point}, y{point})" if at else "(0, 0)"
        yield f'{point} = "{place}"', say("new.point")


def _time(draft: Draft) -> Iterator[Line]:
    yield "[time]", say("new.time")
    yield f'step      = "2*pi/({_STEPS}*n1)"', say("new.step", steps=_STEPS)
    yield 'end       = "2*pi/n1"', say("new.end")
    yield 'period    = "2*pi/n1"', say("new.period")
    yield f"check_row = {_CHECK_ROW}", say("new.check_row")
    yield f'scheme    = "{EXACT}"', say("new.scheme", known=", ".join(SCHEME_NAMES))
    yield "", ""


def _group(group: GroupDraft, number: int) -> Iterator[Line]:
    meaning = roles(group.kind.shape, group.letters)
    written = {
        "from": f"[{_quoted(group.points)}]",
        "guide": ", ".join(map(_guide, group.guides)),
        "offset": '"0"',
        "angle": '"90 deg"',
        "lengths": f"[{_quoted(group.lengths)}]",
        "meets": f'"{group.meets}"',
        "coordinates": f"[{_quoted([own.name for own in group.coordinates])}]",
        "mode": '"+1"',
    }
    yield "", ""
    yield "[[group]]", say("new.group", number=number)
    yield f'kind        = "{group.kind}"', title(group.kind.shape, group.letters)
    for key, meant in meaning.items():
        if key == "guides":
            yield "guides      = [", ""
            for place, guide in enumerate(group.guides, start=1):
                yield f"    {_guide(guide)},", role(group.kind.shape, key, group.letters, place)
            yield "]", ""
        else:
            yield f"{key:<11} = {written[key]}", meant


def _quoted(names: list[str] | tuple[str, ...]) -> str:
    return ", ".join(f'"{name}"' for name in names)


def _guide(guide: GuideOf) -> str:
    angle = f"{guide.turns} + {guide.angle}" if guide.turns else guide.angle
    return f'{{ through = "{guide.through}", angle = "{angle}", offset = "0" }}'


def _frame(draft: Draft) -> Iterator[Line]:
    fixed = [guide for group in draft.groups for guide in group.guides if guide.through in draft.places]
    hinges = [point for point in draft.places if point not in {guide.through for guide in fixed}]
    yield "", ""
    yield "[frame]", say("new.frame")
    yield f"hinges = [{_quoted(hinges)}]", say("new.hinges")
    if fixed:
        rails = ", ".join(f'{{ through = "{guide.through}", angle = "{guide.angle}" }}' for guide in fixed)
        yield f"rails  = [ {rails} ]", say("new.rails")
    yield "", ""
