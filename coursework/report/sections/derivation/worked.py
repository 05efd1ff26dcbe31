"""The formula behind a further table, and one of its rows computed with numbers that give the printed result.

Enters: a `PageContext` and the name of the quantity.  Leaves: parts, none if the formula is too long to read.
Used by the list of sections, by name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from coursework.equations.algebra.calculus import expand, replaced
from coursework.equations.algebra.expression import ZERO, Expression, add
from coursework.equations.reduction.symbolic import expanded, symbol
from coursework.equations.reduction.tidying.tidy import as_sum, product, quotient
from coursework.motion.geometry.time_derivatives import acceleration_rest, compile_rows, derivative, moved_rate
from coursework.report.formulas.display import display
from coursework.report.text.numbers import THIN
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Display, Equations, Paragraph, Part
from coursework.report.text.text_runs import ITALIC
from coursework.scene.quantities import ACCELERATIONS, ANALOGS, INVARIANTS, POINTS
from coursework.variant.formula.tree import Formula, FormulaFault, evaluate, named, number, spelled

if TYPE_CHECKING:
    from coursework.results.kinematics.extra import ExtraTable

MOST_EQUATIONS = 6  # differentiated equations on a page
MOST_PARTS = 100  # of an expression that is differentiated for a page
LONGEST = 160  # characters of a formula that is written out
AT_REST = 1e-9  # parts of the velocity of the fastest point: a slower point rests
UPRIGHT = 1e-6  # parts of the velocity along y: a point that is slower than that along x moves only along y
DIGITS, MOST_DIGITS = 6, 15  # least and most digits of a factor; it has as few as give the printed result
SHOWN = 5  # significant digits of a result


def worked(context: PageContext, quantity: str, extra: ExtraTable) -> list[Part]:
    """Return the formula of a further table and one of its rows in numbers; empty if there is nothing to write out."""
    write = _WRITERS.get(quantity)
    return write(context, extra) if write is not None and len(extra.rows) else []


def _row(context: PageContext, rows: int) -> int:
    return min(context.run.variant.time.row_of_check, rows) - 1


def _accelerations(context: PageContext, extra: ExtraTable) -> list[Part]:
    """Return the velocity equations differentiated once more, with Coriolis's terms named, and one solution in numbers."""
    equations, reduction = context.run.scene.equations, context.run.reduction
    used = [one for one in equations.equations if one.name in reduction.used]
    if len(used) > MOST_EQUATIONS or any(slope.size > MOST_PARTS for one in used for slope in one.coefficients.values()):
        return []
    dots = {derivative(name): symbol(f"d{name}") for name in context.run.motion.velocity_names}
    rests = [replaced(expanded(acceleration_rest(equations, one, moved_rate)), dots) for one in used]
    lines: list[tuple[Formula, Formula]] = []
    for one, rest in zip(used, rests, strict=True):
        left = add(*[slope * symbol(f"d{name}") for name, slope in one.coefficients.items()])
        lines.append((as_sum(left, equations.order), as_sum(rest, equations.order)))
    if not lines or any(len(spelled(side)) > LONGEST for line in lines for side in line):
        return []
    rates = context.rates
    shown = [
        display(left, right, rates, context.equation(one.name) + "′") for one, (left, right) in zip(used, lines, strict=True)
    ]
    variant = context.run.variant
    free = {*(name for one in used for name in one.coefficients), *variant.known_rates} - {*variant.given_rates}
    meant = [
        f"{context.lettering(f'd{name}')} = d{THIN}{context.lettering(name)}/d{THIN}{context.lettering('t')}"
        for name in context.run.motion.velocity_names
        if name in free
    ]
    intro = context.words("worked.accelerations", meant=context.words.listing(meant))
    parts: list[Part] = [Paragraph(context.lettered(intro)), Equations(shown)]
    if pairs := _coriolis(context, rests):
        parts.append(Paragraph(context.lettered(context.words("worked.coriolis", terms=context.words.listing(pairs)))))
    row = _row(context, len(context.run.motion.t))
    values = {**_slopes(context, rests, row), **_values(context, row)}
    for name, formula in _solved(context, dict(zip((one.name for one in used), rests, strict=True))):
        put = _in_numbers(context, named(name), formula, values)
        if put is not None:
            intro = context.words("worked.solved", row=row + 1, symbol=context.label(name))
            return [*parts, Paragraph(context.lettered(intro)), Equations([display(named(name), formula, rates), put])]
    return parts


def _solved(context: PageContext, rests: Mapping[str, Expression]) -> Iterator[tuple[str, Formula]]:
    """Yield name and formula of the derivative of the first velocity of each small block, those with Coriolis's term first.

    Blocks of more than two unknowns and formulas that are too long are left out.
    """
    equations, found = context.run.scene.equations, []
    by_name = {one.name: one for one in equations.equations}
    for block in context.run.reduction.blocks:
        if block.size > 2:
            continue
        rows = [by_name[name] for name in block.equations]
        right = [
            rests[one.name]
            - add(*[slope * symbol(f"d{name}") for name, slope in one.coefficients.items() if name not in block.unknowns])
            for one in rows
        ]
        matrix = [[one.coefficients.get(name, ZERO) for name in block.unknowns] for one in rows]
        if block.size == 1:
            above, below = right[0], matrix[0][0]
        else:
            above = right[0] * matrix[1][1] - right[1] * matrix[0][1]
            below = matrix[0][0] * matrix[1][1] - matrix[1][0] * matrix[0][1]
        formula = quotient(expanded(above), product(below, equations.order), equations.order)
        if formula.op != "number" and len(spelled(formula)) <= LONGEST:
            found.append((not _coriolis(context, right), f"d{block.unknowns[0]}", formula))
    for _, name, formula in sorted(found, key=lambda one: one[0]):
        yield name, formula


def _coriolis(context: PageContext, rests: list[Expression]) -> list[str]:
    """Return the products 2 w u of a sliding velocity u and an angular velocity w that occur in the second derivatives."""
    variant = context.run.variant
    slides = [c.rate for c in variant.coordinates if c.unit == "m"]
    turns = [c.rate for c in variant.coordinates if c.unit == "rad"]
    terms = [term for rest in rests for term in expand(rest).terms]
    found = [(u, w) for u in slides for w in turns if any({symbol(u), symbol(w)} <= term.free_symbols for term in terms)]
    return [THIN.join(("2", context.lettering(w), context.lettering(u))) for u, w in found]


def _points(context: PageContext, extra: ExtraTable) -> list[Part]:
    """Return position, velocity and, if asked for, acceleration of the last point along x, as formulas and in numbers.

    A point that moves only along y is written along y.  A point that rests (as the pivot in which a contour ends), whose place
    is a coordinate by itself, or whose formulas are too long gives way to the one before it.
    """
    equations = context.run.scene.equations
    named_points = [name.partition(".")[0] for name in extra.names if name.endswith(".vx")]
    rows = len(context.run.motion.t)
    row = _row(context, rows)
    speeds = [np.max(np.abs(extra.rows[:, index]), initial=0.0) for index, unit in enumerate(extra.units) if unit == "m/s"]
    for point in reversed(named_points):
        fastest = [np.max(np.abs(extra.rows[:, extra.names.index(f"{point}.v{axis}")]), initial=0.0) for axis in "xy"]
        if max(fastest) <= AT_REST * max(speeds):
            continue
        axis = "x" if fastest[0] > UPRIGHT * fastest[1] else "y"
        place = equations.symbols.vectors[point]["xy".index(axis)]
        if place.size > MOST_PARTS:
            continue
        place = expanded(place)
        rate = expanded(equations.symbols.rate(place))
        levels = [(axis, place), (f"v{axis}", rate)]
        if f"{point}.a{axis}" in extra.names:
            dots = {derivative(name): symbol(f"d{name}") for name in context.run.motion.velocity_names}
            levels.append((f"a{axis}", replaced(expanded(moved_rate(equations, rate)), dots)))
        formulas = [(f"{point}.{key}", as_sum(expression, equations.order)) for key, expression in levels]
        if formulas[0][1].op == "name" or any(len(spelled(formula)) > LONGEST for _, formula in formulas):
            continue
        values = _values(context, row)
        shown = [display(named(name), formula, context.rates) for name, formula in formulas]
        put = [_in_numbers(context, named(name), formula, values) for name, formula in formulas]
        if None in put:
            continue
        return [
            Paragraph(context.lettered(context.words("worked.points", point=point, axis=axis.join(ITALIC)))), Equations(shown),
            Paragraph(context.say("worked.row", row=row + 1)), Equations([one for one in put if one is not None]),
        ]  # fmt: skip
    return []


def _values(context: PageContext, row: int) -> dict[str, float]:
    """Return the data, and the laws and entries of a row, by name (SI)."""
    motion = context.run.motion
    values = {**context.run.variant.values, "t": float(motion.t[row]), "pi": np.pi}
    laws = [law.name for law in context.run.variant.laws if law.name not in motion.names]
    values |= _in_row(context, {name: symbol(name) for name in laws}, row)
    values |= {name: float(motion.column(name)[row]) for name in motion.names}
    if context.run.asks(ACCELERATIONS):
        second = context.run.results.accelerations[row].tolist()
        values |= {f"d{name}": value for name, value in zip(motion.velocity_names, second, strict=True)}
    return values


def _slopes(context: PageContext, rests: list[Expression], row: int) -> dict[str, float]:
    """Return the slopes of laws ("∂us/∂t") that occur in the second derivatives, by name, in a row (SI)."""
    equations = context.run.scene.equations
    free = sorted({one for rest in rests for one in rest.free_symbols}, key=str)
    named_symbols = {name: one for one in free if (name := as_sum(one, equations.order).name).startswith("∂")}
    return _in_row(context, named_symbols, row)


def _in_row(context: PageContext, wanted: Mapping[str, Expression], row: int) -> dict[str, float]:
    """Return the values (SI) of the expressions `wanted` in a row, by their names."""
    motion, at = context.run.motion, slice(row, row + 1)
    values = compile_rows(context.run.scene.equations, [*wanted.values()], 1)
    found = values(motion.t[at], motion.coordinates[at], motion.velocities[at])[0] if wanted else np.zeros(0)
    return dict(zip(wanted, found.tolist(), strict=True))


def _in_numbers(context: PageContext, left: Formula, right: Formula, values: Mapping[str, float]) -> Display | None:
    """Return `left` = `right` with numbers for its names, with as few digits as give the printed result.

    Return None if a name has no value or no number of digits gives that result.
    """
    needed, clean = right.names(), context.numbers.without_noise
    if not {*needed} <= {*values, "pi"}:
        return None
    try:
        result = _printed(context, evaluate(right, dict(values)))
        for digits in range(DIGITS, MOST_DIGITS + 1):
            rounded = {name: float(f"{clean(values[name], 1.0):.{digits}g}") for name in needed if name in values}
            if _printed(context, evaluate(right, rounded)) == result:
                one = display(left, _put(right, rounded), context.rates)
                return Display(f'{one.math} = "{result}"', f"{one.text} = {result}")
    except (FormulaFault, KeyError):  # a law has no value for the formula
        return None
    return None


def _printed(context: PageContext, value: float) -> str:
    return context.numbers.scalar(context.numbers.without_noise(value, 1.0), SHOWN)


def _factors(context: PageContext, *values: float) -> Iterator[str]:
    """Yield numbers as factors of a product, negative ones in parentheses."""
    texts = (context.numbers.scalar(value, DIGITS + 2) for value in values)
    return (f"({text})" if text.startswith("−") else text for text in texts)


def _put(tree: Formula, values: Mapping[str, float]) -> Formula:
    """Return a formula with `values` in place of their names."""
    if tree.op == "name" and tree.name in values:
        return number(Fraction(repr(values[tree.name])))
    return replace(tree, args=tuple(_put(arg, values) for arg in tree.args)) if tree.args else tree


def _quotients(context: PageContext, extra: ExtraTable) -> list[Part]:
    """Return how the derivatives of a coordinate by the crank angle follow from time derivatives, and a row in numbers."""
    exact, variant = context.run.exact, context.run.variant
    crank = next(c for c in variant.coordinates if c.name == extra.names[0])
    other = next((c for c in variant.coordinates if f"d{c.name}/d{crank.name}" in extra.names), None)
    if other is None or len(extra.rows) != len(exact.t):
        return []
    row = _row(context, len(exact.t))
    second = dict(zip(exact.velocity_names, context.run.scene.exact_accelerations[row].tolist(), strict=True))
    w, v = float(exact.column(crank.rate)[row]), float(exact.column(other.rate)[row])
    q, c, u, turn = (context.symbol(name) for name in (other.name, crank.name, other.rate, crank.rate))
    du, dw = context.symbol(f"d{other.rate}"), context.symbol(f"d{crank.rate}")
    first, twice = f"frac(d {q.typst}, d {c.typst})", f"frac(d^2 {q.typst}, d {c.typst}^2)"
    one, two = f"d{q.text}/d{c.text}", f"d²{q.text}/d{c.text}²"
    second_text = f"{two} = ({du.text} − {one} {dw.text})/{turn.text}²"
    shown = [
        Display(f"{first} = frac({u.typst}, {turn.typst})", f"{one} = {u.text}/{turn.text}"),
        Display(f"{twice} = frac(1, {turn.typst}^2) ({du.typst} - {first} {dw.typst})", second_text),
    ]
    place = extra.names.index(f"d{other.name}/d{crank.name}")
    results = [_printed(context, float(value)) for value in extra.rows[row, place : place + 2]]
    v_, w_, a_, r_, e_ = _factors(context, v, w, second[other.rate], v / w, second[crank.rate])
    told = (f"{v_}/{w_} = {results[0]}", f"({a_} − {r_} · {e_})/{w_}² = {results[1]}")
    put = [
        Display(f'{sign} = "{text}"', f"{name} = {text}")
        for sign, name, text in zip((first, twice), (one, two), told, strict=True)
    ]
    return [
        Paragraph(context.lettered(context.words("worked.analogs", name=context.lettering(other.name)))),
        Equations(shown, flow=True),
        Paragraph(context.say("worked.row", row=row + 1)), Equations(put, flow=True),
    ]  # fmt: skip


def _invariants(context: PageContext, extra: ExtraTable) -> list[Part]:
    """Return the formulas of a, b, c, and a line in the middle of the table in numbers, with S and Φ from the caption."""
    known = getattr(extra.title, "values", {})
    driven = [c.name for c in context.run.variant.driven_coordinates]
    if not {"stroke", "angle"} <= {*known} or len(driven) != 1 or len(extra.names) != 4:
        return []
    numbers, crank = context.numbers, context.symbol(driven[0])
    stroke, angle = float(known["stroke"].values["value"]), float(known["angle"])
    k, a, b, c = extra.rows[len(extra.rows) // 2].tolist()
    s0, s1, s2, size, turn = _factors(context, a * stroke, b * stroke / angle, c * stroke / angle**2, stroke, angle)
    ends = [_printed(context, value) for value in (a, b, c)]
    told = (f"{s0}/{size} = {ends[0]}", f"{s1} · {turn}/{size} = {ends[1]}", f"{s2} · {turn}²/{size} = {ends[2]}")
    first, second = f"frac(d s, d {crank.typst})", f"frac(d^2 s, d {crank.typst}^2)"
    shown = [
        Display("a_k = s / S", "a_k = s/S"),
        Display(f"b_k = {first} dot Φ / S", f"b_k = ds/d{crank.text} · Φ/S"),
        Display(f"c_k = {second} dot Φ^2 / S", f"c_k = d²s/d{crank.text}² · Φ²/S"),
    ]
    put = [Display(f'{letter}_k = "{text}"', f"{letter}_k = {text}") for letter, text in zip("abc", told, strict=True)]
    return [
        Paragraph(context.lettered(context.words("worked.invariants", crank=context.lettering(driven[0])))),
        Equations(shown, flow=True),
        Paragraph(context.lettered(context.words("worked.line", k=numbers.fixed(k, SHOWN - 1)))), Equations(put, flow=True),
    ]  # fmt: skip


_WRITERS: dict[str, Callable[[PageContext, ExtraTable], list[Part]]] = {
    ACCELERATIONS.name: _accelerations,
    POINTS.name: _points,
    ANALOGS.name: _quotients,
    INVARIANTS.name: _invariants,
}
