"""Why links and joints leave more freedoms than are driven: which joint may be missing.

Enters: a `Mechanism`, points that lie in one place.  Leaves: a `Fault`.  Used by `scheme.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from coursework.mechanism.left_out import left_out
from coursework.mechanism.mechanism import Mechanism
from coursework.mechanism.structure import driven_freedoms, in_order
from coursework.variant.formula.tree import Formula, spelled
from coursework.variant.record.held import rates_without_angle
from coursework.variant.record.variant import Variant
from coursework.words.errors import Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say

Pairs = tuple[tuple[str, str], ...]
_PROPORTIONAL = {"name", "number", "+", "-", "*", "/", "neg"}


def loose(mechanism: Mechanism, near: Callable[[], Pairs] | None) -> Fault:
    """Return the fault of a file whose links and joints cannot carry forces; `near` gives the points that may be hinges."""
    variant, mobility, drives = mechanism.variant, mechanism.mobility, driven_freedoms(mechanism.variant)
    if bare := rates_without_angle(variant):
        lines = "; ".join(f'angle_{link} = {{ start = "0 deg", rate = "{rate}" }}' for rate, link in bare.items())
        return Fault(say("fault.V722.angle", lines=lines), variant.file, variant.nearest_line("drive", next(iter(bare))))
    if mobility is None or not 0 < drives < mobility.degrees:
        return Fault(say("fault.V722.none"), variant.file, 1)
    found = near() if near is not None else ()
    told = [remark.sentence for remark in variant.plausibility if remark.code == "PIVOT"]
    told += [say("fault.meet.pair", one=one, other=other) for one, other in found]
    gears = {links: name for name, links in reversed([*_turning_together(variant)])}
    told += [say("fault.meet.gears", equation=name, links=links) for links, name in gears.items()]
    nothing = [] if told or near is None else [say("fault.meet.none")]
    told += [*left_out(mechanism), *nothing]
    meet: Sentence | str = say("fault.meet.some", pairs=joined(told)) if told else ""
    line = variant.nearest_line("links", variant.links[0].name) if variant.links else 1
    return Fault(say("fault.V722.loose", degrees=mobility.degrees, drives=drives, meet=meet), variant.file, line)


def _turning_together(variant: Variant) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield each equation, by its name or as it is held, that makes links turn in proportion, as gears do, with these links."""
    by_rate = {link.rate: link.name for link in variant.links if link.rate and not link.contact}
    by_angle = {one.name: by_rate[one.rate] for one in variant.coordinates if one.rate in by_rate}
    fixed = {*variant.values, "pi"}
    written: list[tuple[str, Formula, dict[str, str]]] = [
        (one.name, one.difference, by_angle if one.is_closure else by_rate) for one in variant.constraints
    ]
    written += [(spelled(held), held, by_angle) for held in variant.holds]
    for name, formula, turning in written:
        names = {*formula.names()} - fixed
        links = {turning[one] for one in names if one in turning}
        if len(links) > 1 and names <= {*turning} and {part.op for part in formula.walk()} <= _PROPORTIONAL:
            yield name, tuple(in_order(links))
