"""The section on the structure of the mechanism: links, pairs, mobility, Assur groups, formula of structure.

Enters: a `PageContext`.  Leaves: parts, none if the file does not show all links.  Used by `sections.py`.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from coursework.mechanism.groups import group_kind
from coursework.mechanism.joints import FRAME, Mobility
from coursework.mechanism.structure import FIRST, read_structure
from coursework.mechanism.structure_record import AssurGroup, Member, Structure
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Facts, Part
from coursework.report.text.symbols import symbol
from coursework.report.text.text_runs import ITALIC, unbroken
from coursework.report.wording.closeness import evidence
from coursework.scene.quantities import CHECKS
from coursework.variant.record.held import driving_laws
from coursework.words.templates import clean

FULL_TURN = 2 * math.pi * (1 - 1e-9)
THEN = " → "
LETTERS = ("mobility", "lower", "higher")  # of the formula of mobility


def structure(context: PageContext) -> list[Part]:
    """Return links and pairs with their kinds, the mobility in numbers, groups with class and order."""
    found = read_structure(context.run.scene.mechanism)
    if found is None:
        return []
    say = context.words
    told = {"links": _links(context, found), "pairs": _pairs(context, found)}
    told["mobility"] = say.sentences([_counted(context, found), _freedoms(context, found), _sliders(context, found)])
    if found.groups:
        told["groups"] = _groups(context, found)
    return [Facts([(say(f"structure.{key}"), context.lettered(text, data=False)) for key, text in told.items()])]


def _groups(context: PageContext, found: Structure) -> str:
    """Return the formula of structure, followed by each group with class and order."""
    say = context.words
    codes: list[tuple[str, tuple[str, ...]]] = [(FIRST, (found.driven,))] if found.driven else []
    codes += [(group.group_class, group.links) for group in found.groups]
    begun = say("join.comma").join(_code(*one) for one in codes if one[0] == FIRST)
    formula = THEN.join([begun, *(_code(*one) for one in codes if one[0] != FIRST)])
    groups = [_group(context, group) for group in found.groups if group.group_class != FIRST]
    return say("structure.formula", formula=formula, groups=say("join.semicolon").join(groups)) if groups else formula


def _links(context: PageContext, found: Structure) -> str:
    say = context.words
    pivots = [pair.point for pair in found.pairs if pair.kind.pins and FRAME in pair.links and pair.point]
    shown = [say("structure.frame", points=say("join.comma").join(clean(point) for point in dict.fromkeys(pivots)))]
    if not pivots:
        shown = [say("structure.frame_alone")]
    for link in found.links:
        kind = say(f"structure.kind.{_kind(context, link)}")
        shown.append(say("structure.link", name=clean(link.name), kind=kind, points=_points(link.points)).rstrip())
    return say("join.semicolon").join(shown)


def _points(points: Sequence[str]) -> str:
    """Return the points of a link as in a drawing: AB, or A–Ki if a name has more than one letter."""
    between = "" if all(len(point) == 1 for point in points) else "–"
    return unbroken(between.join(clean(point) for point in points)) if points else ""


def _kind(context: PageContext, link: Member) -> str:
    """Return the key of the word for a link; the motion decides whether a pivoted link is a crank or a rocker."""
    if link.kind != "pivoted":
        return link.kind
    variant = context.run.variant
    judged = evidence(context).exact if context.run.asks(CHECKS) else None
    motion = judged or context.exact or context.run.motion
    angle = next((c.name for c in variant.coordinates if c.rate == link.rate and c.unit == "rad"), "")
    if angle in motion.names and len(motion.t):
        column, rates = motion.column(angle), motion.column(link.rate) if link.rate in motion.names else ()
        if float(column.max() - column.min()) >= FULL_TURN:
            return "turning"
        if len(rates) and min(rates) < 0 < max(rates):
            return "swinging"
    is_driven = any(group_kind(group.kind).driven and angle in group.coordinates for group in variant.groups)
    return "turning" if is_driven else "link"


def _pairs(context: PageContext, found: Structure) -> str:
    say, told = context.words, []
    for kind in dict.fromkeys(pair.kind for pair in found.pairs):
        pairs = [pair for pair in found.pairs if pair.kind is kind]
        listed = [unbroken(f"{clean(pair.point)} ({','.join(map(clean, pair.links))})".strip()) for pair in pairs]
        if listed:
            told.append(say(f"structure.pair.{kind.key}", pairs=say("join.comma").join(listed), **_letters(context)))
    return say("join.semicolon").join(told)


def _letters(context: PageContext) -> dict[str, str]:
    """Return the letters of the formula of mobility, which depend on the language."""
    symbols = {key: symbol(context.words(f"structure.letter.{key}")) for key in LETTERS}
    return {key: f"{ITALIC[0]}{one.letter}{one.subscript}{ITALIC[1]}" for key, one in symbols.items()}


def _numbers(count: Mobility) -> str:
    return unbroken(f"3·{count.links} − 2·{count.lower_pairs} − {count.higher_pairs} = {count.degrees}")


def _counted(context: PageContext, found: Structure) -> str:
    """Return the sentence on the numbers of links, lower and higher pairs, and the mobility that follows."""
    say, count = context.words, found.mobility
    lower = Counter(pair.kind.key for pair in found.pairs if pair.kind.takes == 2)
    listed = say.listing([say(f"structure.count.{key}", number=number) for key, number in lower.items()])
    sliders = any(link.kind == "slider" for link in found.links)
    links = say("structure.with_sliders" if sliders else "structure.moving", number=count.links)
    values = {
        "links": links,
        "number": count.lower_pairs,
        "kinds": listed,
        "others": count.higher_pairs,
        "numbers": _numbers(count),
    }
    return say("structure.counted", **values, **_letters(context))


def _sliders(context: PageContext, found: Structure) -> str:
    """Return the mobility counted without slider blocks, with pins that slide in their guides; "" if no link is such a block."""
    if found.without == found.mobility:
        return ""
    added = [clean(link.name) for link in found.links][found.without.links :]
    values = {"sliders": context.words.listing(added), "numbers": _numbers(found.without), **_letters(context)}
    return context.words.count("structure.without", len(added), **values)


def _freedoms(context: PageContext, found: Structure) -> str:
    """Return the sentence that all freedoms are driven or moved by forces, or why fewer are counted than driven."""
    variant = context.run.variant
    driving = driving_laws(variant)
    drives = [law.name for law in variant.drive if law.name in driving]
    values = {"drives": context.symbol_list(drives), **_letters(context)}
    if found.drives > found.mobility.degrees:
        return context.words("structure.passive", degrees=found.mobility.degrees, **values)
    key = "structure.driven" if variant.motor is None else "structure.moved"
    return context.words.count(key, found.drives, **values)


def _group(context: PageContext, group: AssurGroup) -> str:
    links = context.words.listing([clean(name) for name in group.links])
    key = "structure.dyad" if group.kind else "structure.group"
    values = {"number": len(group.links), "links": links, "class": group.group_class, "order": group.order}
    kind = context.words(f"structure.species.{group.kind}") if group.kind else ""
    return context.words(context.words.phrases.beside(key, len(group.links)), **values, kind=kind)


def _code(group_class: str, links: Sequence[str]) -> str:
    return unbroken(f"{group_class}({','.join(map(clean, links))})")
