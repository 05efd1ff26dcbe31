"""The length by which one link slides along another, where points or closed loops of the file name it: a cylinder's stroke.

Enters: bodies, a joint of them.  Leaves: the coordinate and the direction of its growth.  Used by `scheme.py`.
"""

from __future__ import annotations

from coursework.mechanism.groups.joint import Joint
from coursework.mechanism.structure import Bodies
from coursework.variant.formula.tree import Formula, named, signed


def slid_length(bodies: Bodies, joint: Joint) -> tuple[str, Formula] | None:
    """Return the length by which the first body of a joint slides along the second, and the angle of the way it grows.

    In B + s @ psi = C the guide turns with psi; if B is a point of it, or C one of the block, the block goes the way of psi.
    None if no sum of the file says so.
    """
    variant, points, (block, guide) = bodies.mechanism.variant, bodies.points(), joint.bodies
    rate = bodies.rates().get(guide)
    turns = {c.name for c in variant.coordinates if c.rate == rate}
    lengths = {named(c.name) for c in variant.coordinates if c.unit == "m"} if joint.kind.slides else ()
    sums = [Formula("-", (formula, named(point))) for point, formula in variant.points]
    sums += [one.difference for one in variant.constraints if one.is_closure]
    for each in sums if lengths and turns else ():
        terms = [*signed(each)]
        ends = [
            sign if term.name in points[guide] else -sign for term, sign in terms if term.name in points[guide] + points[block]
        ]
        for term, sign in terms:
            if ends and term.op == "@" and term.args[0] in lengths and turns.intersection(term.args[1].names()):
                angle = term.args[1]
                return term.args[0].name, angle if sign == ends[0] else Formula("+", (angle, named("pi")))
    return None
