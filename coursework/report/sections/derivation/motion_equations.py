"""The equations of motion: constraints, vector equations of the paths, projections, and the choice among them.

Enters: a `PageContext`.  Leaves: displayed equations with the words around them.  Used by `sections.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from coursework.equations.reduction.textbook.solution import ShownEquation
from coursework.mechanism.derivation.contours import Contour, contours_of
from coursework.mechanism.derivation.derive import Combination, Derivation, Numbered, derive
from coursework.mechanism.derivation.paths import Path, Term
from coursework.mechanism.derivation.segments import ZERO, Angle
from coursework.mechanism.proposal import proposals
from coursework.motion.geometry.judging.agreement import confirmed
from coursework.report.formulas import typst_math as setting
from coursework.report.formulas.display import display
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Bullets, Display, Equations, Paragraph, Part
from coursework.report.text.text_runs import runs, unbroken
from coursework.variant.formula.made import part_of_pi, summed
from coursework.variant.formula.tree import Formula, named, number
from coursework.words.sentence import Sentence
from coursework.words.templates import clean


def equations(context: PageContext) -> list[Part]:
    """Return the derivation from paths between points if the file shows them, then the written equations and the contours.

    A file with closures or groups and no written equations is derived only from contours.
    """
    written = [one for one in context.run.equations if not one.derived]
    parts: list[Part] = []
    chain = not written and any(one.is_closure for one in context.run.scene.mechanism.constraints)
    rows = _configurations(context)
    found = None if chain else derive(context.run.scene.mechanism, rows)
    intro = "constraints.intro"
    if found is not None:
        reductions = _reductions(context, found.projections)
        parts += [*_derived_from_points(context, found), *reductions]
        intro = "constraints.chosen" if reductions else "constraints.taken"
    elif written and rows:  # without rows of all coordinates nobody knows what the points would give
        parts.append(Paragraph(runs(_unchecked(context, [one.name for one in written]))))
    if written:
        parts.append(Paragraph(context.say(intro)))
        parts.append(Equations([_shown(context, one) for one in written], compact=found is not None))
    parts += _rank(context, found) if found else []
    parts += _contours(context, first=not parts)
    notes = [Bullets([context.rich(note) for note in context.run.reduction.notes])] if context.run.reduction.notes else []
    return [*parts, *notes]


def _configurations(context: PageContext) -> list[dict[str, float]]:
    motion = context.run.motion
    if len(motion.coordinate_names) < len(context.run.variant.coordinates):
        return []
    return [dict(zip(motion.coordinate_names, row, strict=True)) for row in motion.coordinates.tolist()]


def _reason(context: PageContext, equation: ShownEquation) -> str:
    """Return the reason of a written equation, in the language of the page if the file has it."""
    reasons = {constraint.name: constraint.because for constraint in context.variant.constraints}
    return reasons.get(equation.name, equation.because)


def _shown(context: PageContext, equation: ShownEquation) -> Display:
    """Return an equation with its reason before it; a note follows one that is redundant."""
    because = equation.because if equation.derived else _reason(context, equation)
    reason = context.rich(because)
    reason = reason if equation.derived else context.in_its_language(because, reason)
    angles = context.angles
    one = display(
        angles.put_in(equation.left), angles.put_in(equation.right), context.rates, context.equation(equation.name), reason
    )
    return one if equation.used else replace(one, after=context.say("constraints.unused"))


def _derived_from_points(context: PageContext, found: Derivation) -> list[Part]:
    words = context.words
    nought = [f"{known.point}{axis}" for known in found.graph.known for axis in "xy" if known.part(axis) == ZERO]
    zero = [context.symbol(f"V{clean(name)}") for name in nought]
    line = [Display(f"{one.typst} = 0", f"{one.text} = 0") for one in zero]
    ways = words("join.comma").join(unbroken("–".join(clean(point) for point in path.points)) for path in found.paths)
    nought_first: list[Part] = [Paragraph(context.say("constraints.joints")), Equations(line, flow=True)] if zero else []
    return [
        *nought_first,
        Paragraph(runs(words("constraints.paths", paths=ways))),
        Equations([_vector_equation(path) for path in found.paths], flow=True),
        Paragraph(context.say("constraints.projections")),
        Equations([_projection(context, one) for one in found.projections]),
    ]


def _vector_equation(path: Path) -> Display:
    """Return V_C = V_M + V_BM + V_CB."""
    pairs = [(path.points[0], ""), *((second, before) for before, second in pairwise(path.points))]
    math = " + ".join(_vector(point, about) for point, about in pairs)
    text = " + ".join(f"V_{point}{about}" for point, about in pairs)
    return Display(f"{_vector(path.points[-1], '')} = {math}", f"V_{path.points[-1]} = {text}")


def _vector(point: str, about: str) -> str:
    names = " ".join(name if len(name) == 1 else f'"{name}"' for name in (point, about) if name)
    return f"arrow(V)_({names})"


def _projection(context: PageContext, one: Numbered) -> Display:
    projection = one.projection
    left = named(f"V{projection.path.points[-1]}{projection.axis}")
    start = [] if projection.start == ZERO else [(projection.start, 1)]
    right = summed([*start, *((_term(term), term.sign) for term in projection.terms)])
    made = display(left, right, context.rates, one.name)
    end_math, end_text = setting.math(projection.end, context.rates), setting.text(projection.end, context.rates)
    return replace(made, math=f"{made.math} = {end_math}", text=f"{made.text} = {end_text}")


def _term(term: Term) -> Formula:
    turned = Formula("call", (_angle(term.angle),), term.function)
    rate = named(term.rate)
    if term.length is None:
        return Formula("*", (rate, turned))
    return Formula("*", (Formula("*", (rate, term.length)), turned))


def _angle(angle: Angle) -> Formula:
    """Return an angle as it is drawn, not reduced: phi3 + 3 pi/2."""
    offset = part_of_pi(angle.offset)
    if angle.base is None:
        return offset
    return angle.base if angle.offset == 0 else Formula("+", (angle.base, offset))


def _reductions(context: PageContext, found: Sequence[Numbered]) -> list[Part]:
    """Return the reduction formulas that the projections need."""
    used: dict[tuple[str, Fraction, bool], None] = {}
    for one in found:
        for term in one.projection.terms:
            if term.angle.offset:
                used[term.function, term.angle.offset, term.angle.base is not None] = None
    lines = [_reduction(*key) for key in used if key[1] in _QUARTERS]
    return [Paragraph(context.say("constraints.reductions")), Equations(lines, flow=True)] if lines else []


_QUARTERS = {Fraction(1, 2): 1, Fraction(1): 2, Fraction(3, 2): 3}
_VALUES = {"cos": ("cos", "-sin", "-cos", "sin"), "sin": ("sin", "cos", "-sin", "-cos")}
_NUMBERS = {"cos": (1, 0, -1, 0), "sin": (0, 1, 0, -1)}


def _reduction(function: str, offset: Fraction, has_base: bool) -> Display:
    """Return cos(phi + pi) = -cos phi, or cos 3pi/2 = 0."""
    quarters = _QUARTERS[offset]
    phi = named("phi")
    if not has_base:
        return display(Formula("call", (part_of_pi(offset),), function), number(_NUMBERS[function][quarters]))
    value = _VALUES[function][quarters]
    reduced = Formula("call", (phi,), value.lstrip("-"))
    right = Formula("neg", (reduced,)) if value.startswith("-") else reduced
    return display(Formula("call", (Formula("+", (phi, part_of_pi(offset))),), function), right)


def _rank(context: PageContext, found: Derivation) -> list[Part]:
    """Return the sentences on how many equations are independent, which are sums of others, and which follow from no path."""
    words = context.words
    count = len(found.projections)
    told = [words("constraints.rank", count=count, rank=found.rank)] if count > found.rank else []
    if 1 < count == found.rank:
        told.append(words("constraints.rank_all"))
    sums = [_sum(one) for one in found.dependent if one.terms]
    if sums:
        told.append(words("constraints.sums", sums=words("join.semicolon").join(sums)))
    names = {one.name for one in found.projections}
    mixed = [f"({clean(name, 40)})" for name in found.followed if name not in names]
    if mixed:
        told.append(words("constraints.mixed", names=words.listing(mixed)))
    right, open_to_doubt = _confirmed(context, found.beyond)
    told += [words("constraints.beyond_compared", names=words.listing(right))] if right else []
    told += [words("constraints.beyond", names=words.listing(open_to_doubt))] if open_to_doubt else []
    told += [context.told(sentence) for sentence in _proposed(context, found.beyond)]
    return [Paragraph(runs(words.sentences(told)))] if told else []


def _proposed(context: PageContext, names: Sequence[str]) -> list[Sentence]:
    """Return advice on what to add to the file so that the geometry can check the equations `names`."""
    closure = context.run.scene.closure
    unjudged = dict(closure.unjudged) if closure is not None else {}
    lacking = dict.fromkeys(unknown for name in names for unknown in unjudged.get(name, ()))
    return proposals(context.run.variant, lacking)


def _unchecked(context: PageContext, written: Sequence[str]) -> str:
    """Return the sentences on which signs are confirmed, of equations that follow from no path between points."""
    words = context.words
    right, open_to_doubt = _confirmed(context, written)
    advice = [context.told(sentence) for sentence in _proposed(context, written)]
    if not right:
        return words.sentences([words("constraints.unchecked"), *advice])
    rest = [words("constraints.open", names=words.listing(open_to_doubt))] if open_to_doubt else []
    return words.sentences([words("constraints.compared", names=words.listing(right)), *rest, *advice])


def _confirmed(context: PageContext, names: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the equations that the positions confirm, and those that they do not, as "(12)"."""
    scene = context.run.scene
    agreed = confirmed(scene.equations, scene.closure, scene.start)
    right, rest = [name for name in names if name in agreed], [name for name in names if name not in agreed]
    return [f"({clean(name, 40)})" for name in right], [f"({clean(name, 40)})" for name in rest]


def _sum(one: Combination) -> str:
    terms = [(f"({clean(name, 40)})", sign) for sign, name in one.terms]
    first = ("−" if terms[0][1] < 0 else "") + terms[0][0]
    rest = "".join(f" {'−' if sign < 0 else '+'} {name}" for name, sign in terms[1:])
    return f"({clean(one.name, 40)}) = {first}{rest}"


def _contours(context: PageContext, first: bool) -> list[Part]:
    """Return for each closed contour its vector equation, its projections and their derivatives; then other derived equations.

    `first`: these are the first parts of the section.
    """
    derived = [one for one in context.run.equations if one.derived]
    if not derived:
        return []
    parts: list[Part] = []
    if angles := [display(named(name), angle, context.rates) for name, angle in context.angles.angles]:
        parts += [Paragraph(context.say("constraints.angles")), Equations(angles, flow=True)]
    rest = {one.name: one for one in derived}
    contours = contours_of(context.run.scene.mechanism)
    parts += _points(context, contours)
    for contour in contours:
        both = [rest.pop(f"{contour.name}{axis}") for axis in "xy" if f"{contour.name}{axis}" in rest]
        if not both:
            continue
        label = context.contours.get(contour.name, clean(contour.name, 40))
        vector = _set(context, contour.left, contour.right)
        two = [_set(context, *sides) for sides in zip(contour.left_parts, contour.right_parts, strict=True)]
        parts += [
            Paragraph(context.lettered(context.words("constraints.contour", name=label))),
            Equations([vector]), Paragraph(context.say("constraints.two")), Equations(two, flow=True),
            Paragraph(context.say("constraints.derivatives")),
            Equations([replace(_shown(context, one), before=[]) for one in both]),
        ]  # fmt: skip
    if rest:
        alone = first and len(rest) == len(derived)
        parts.append(Paragraph(context.say("constraints.differentiated" if alone else "constraints.kept")))
        parts.append(Equations([_shown(context, one) for one in rest.values()]))
    return parts


def _set(context: PageContext, left: Formula, right: Formula) -> Display:
    """Return an equation of positions, its constant angles under their names."""
    return display(context.angles.put_in(left), context.angles.put_in(right), context.rates)


def _points(context: PageContext, contours: Sequence[Contour]) -> list[Part]:
    """Return the positions of the moving points that occur in the contours."""
    mechanism = context.run.scene.mechanism
    met = {name for one in contours for side in (one.left, one.right) for name in side.names()}
    coordinates = {coordinate.name for coordinate in context.run.variant.coordinates}
    points = [(name, formula) for name, formula in mechanism.points if name in met and (set(formula.names()) & coordinates)]
    shown = [_set(context, named(name), formula) for name, formula in points]
    return [Paragraph(context.say("constraints.points")), Equations(shown, flow=True)] if shown else []
