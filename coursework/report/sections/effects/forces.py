"""The section on forces: masses and inertia of the check row, the plan of each group, the lever, comparison, all rows.

Enters: a `PageContext` of a run that was asked for forces.  Leaves: parts.  Used by the list of sections, by name.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from coursework.drawing.force_plans.force_plans import ForcePlans, make_force_plans
from coursework.drawing.force_plans.vectors import DIRECTION, KNOWN, SUPERSCRIPT, ForceVector, GroupPlan
from coursework.drawing.paper.symbols import LOWERED
from coursework.effects.force_scheme import drives_of
from coursework.effects.kinetostatics.analysis import ForceAnalysis
from coursework.effects.kinetostatics.flywheel import find_flywheel
from coursework.mechanism.joints import FRAME
from coursework.report.graphs.figures import drawn
from coursework.report.graphs.force_graphs import force_graphs
from coursework.report.sections.graphs import key, smooth_motion
from coursework.report.text.numbers import NOTHING
from coursework.report.text.page_context import PageContext
from coursework.report.text.parts import Cell, Column, Display, Equations, Paragraph, Part, Runs, Table
from coursework.report.text.tables import extra_parts
from coursework.report.text.text_runs import numeral, runs
from coursework.scene.quantities import ENERGY, FORCES
from coursework.system.arrays import Array
from coursework.words.sentences import ranges

MILLIMETRES = 1  # decimals of a length in mm, which is read to half a mm
_ROUND_OFF = 1e-12  # parts of a force: a smaller component is round-off


def forces(context: PageContext) -> list[Part]:
    """Return what is known, each group with its plan, the lever, the readings compared, and the reactions of all rows."""
    found = context.run.of(FORCES)
    if not found.rows.count:
        return []
    row = min(context.run.variant.time.row_of_check, found.rows.count) - 1
    told = [*_convention(context, found), *_between(context, found)]
    convention = context.lettered(context.words.sentences(told))
    parts: list[Part] = [Paragraph(convention), _known(context, found, row)]
    if np.isfinite(found.reactions.rows).all():
        plans = make_force_plans(found, row)
        for number, plan in enumerate(plans.plans):
            parts += _group(context, plans, plan, number)
        parts += _levers(context, plans)
        parts += _compared(context, plans)
    exact = context.run.results.exact_forces
    legend = key(context, dotted=exact is not found, exact=exact is not None)
    return [
        *parts,
        *_rows(context, found),
        *force_graphs(context, found, _smooth(context, exact), legend),
        *_told(context, found),
    ]


def _smooth(context: PageContext, exact: ForceAnalysis | None) -> ForceAnalysis | None:
    """Return the forces of the exact motion, between its rows too where that is known."""
    motion = smooth_motion(context, exact.rows.motion) if exact is not None and exact.rows.count > 2 else None
    return exact if exact is None or motion is None else exact.over(motion, context.run.scene.accelerations_of(motion))


def energy(context: PageContext) -> list[Part]:
    """Return energies and powers of all rows, with words as heads; those that are 0 in all rows are only named below."""
    table = context.run.of(ENERGY).as_table(context.run.motion.t)
    if not len(table.rows):
        return []
    heads = [context.words(f"forces.energy_{name}") for name in table.names[1:]]
    is_shown = [name == "T" or size > 0 for name, size in zip(table.names[1:], _sizes(table.rows), strict=True)]
    kept = [0, *(1 + int(k) for k in np.flatnonzero(is_shown))]
    names, units = (tuple(whole[k] for k in kept) for whole in (table.names, table.units))
    parts = extra_parts(context, replace(table, names=names, units=units, rows=table.rows[:, kept]), "energy.csv")
    for place, part in enumerate(parts):
        if isinstance(part, Table):  # row and time are its first columns
            before, own = part.columns[: 1 - len(kept)], part.columns[1 - len(kept) :]
            own = [replace(column, head=runs(heads[k - 1])) for column, k in zip(own, kept[1:], strict=True)]
            parts[place] = replace(part, columns=[*before, *own])
    if not all(is_shown):
        none = context.words.listing([head for head, shown in zip(heads, is_shown, strict=True) if not shown])
        parts.append(Paragraph(context.say("forces.energy_none", parts=none), "note"))
    return parts


def _sizes(rows: Array) -> Array:
    """Return the largest absolute value of each column after the time; 0 for a power that is only round-off of the others."""
    t, kinetic, *_ = (rows := np.nan_to_num(rows)).T
    largest: Array = np.abs(rows[:, 1:]).max(axis=0)
    powers = largest[2:]  # after the two energies
    working = max(float(powers.max()), float(np.abs(np.diff(kinetic) / np.diff(t)).max(initial=0.0)))
    powers[powers <= _ROUND_OFF * working] = 0.0
    return largest


def _between(context: PageContext, found: ForceAnalysis) -> Iterator[str]:
    """Yield on which two links each drive acts that stands on no frame."""
    for name, one in zip(found.drive_names, drives_of(found.rows.scheme), strict=True):
        if FRAME not in {one.on, one.off}:
            yield context.words("forces.between", name=name, on=one.on, off=one.off)


def _convention(context: PageContext, found: ForceAnalysis) -> Iterator[str]:
    yield context.words("forces.convention")
    if any(name[0] in "NKT" for name in found.reactions.names):
        yield context.words("forces.guides")
    for one in found.rows.scheme.unknowns:
        if one.name[0] == "K" and f"R{one.name[1:]}x" in found.reactions.names:
            yield context.words("forces.shaft", links=context.words.listing([one.off, one.on]))
    if pins := found.rows.scheme.pins:
        yield context.words("forces.pins", points=context.words.listing(list(pins)))
    empty = np.isnan(found.reactions.rows)
    locked = empty.all(axis=1) & bool(found.rows.scheme.forces.friction) & np.isfinite(found.reactions.condition)
    if locked.any():
        yield context.words("forces.locked")
    if empty[~locked].any():
        yield context.words("forces.blank")


def _known(context: PageContext, found: ForceAnalysis, row: int) -> Table:
    """Return the table of masses, centres and inertia forces in a row."""
    rows, numbers = found.rows, context.numbers
    lines: list[list[Cell]] = []
    for body in rows.scheme.bodies:
        acts = [one for one in found.actions if one.body == body.name and one.effect == "inertia"]
        force = _clear(sum((complex(one.force[row]) for one in acts if one.force is not None), 0j))
        couple = sum(float(one.couple[row]) for one in acts if one.couple is not None)
        at = complex(rows.vector(body.centre)[row])
        values = [float(rows.mass(body)[row]), float(rows.inertia(body)[row]), at.real, at.imag, force.real, force.imag, couple]
        lines.append([body.name, *(numeral(numbers.scalar(value)) for value in values)])
    symbols = [("m", "kg"), ("J", "kg·m²"), ("x_S", "m"), ("y_S", "m"), ("F_inx", "N"), ("F_iny", "N"), ("M_in", "N·m")]
    heads = [Column(context.say("structure.kind.link"), words=True)]
    heads += [Column(context.symbol_runs([name]), context.unit(unit)) for name, unit in symbols]
    return Table(heads, lines, context.say("forces.known", row=row + 1), id="forces-known")


def _clear(force: complex) -> complex:
    """Return a force; a component that is only its round-off is 0."""
    least = _ROUND_OFF * abs(force)
    return complex(force.real if abs(force.real) > least else 0.0, force.imag if abs(force.imag) > least else 0.0)


def _group(context: PageContext, plans: ForcePlans, plan: GroupPlan, number: int) -> list[Part]:
    row, numbers = plans.row, context.numbers
    names = context.words.listing(list(plan.bodies))
    told = [context.words("forces.group" if len(plan.bodies) > 1 else "forces.single", names=names)]
    for moment in plan.moments:
        told.append(
            context.words(
                "forces.moment" if moment.point else "forces.moment_at_pin",
                point=moment.point, link=moment.body, name=_text_of(moment.name),
                about=context.with_unit(numbers.scalar(float(moment.about[row])), "N·m"),
                length=context.with_unit(numbers.scalar(float(moment.length[row])), "m"),
                force=context.with_unit(numbers.scalar(float(abs(moment.across[row]))), "N"),
            )
        )  # fmt: skip
    sides = [" + ".join(terms) for terms in (map(_math_of, plan.vectors), (_text_of(one.name) for one in plan.vectors))]
    equation = Display(f"{sides[0]} = 0", f"{sides[1]} = 0")
    drawing = plans.group_drawing(number, context.words.written)
    return [Paragraph(context.lettered(context.words.sentences(told))), Equations([equation]), drawn(context, drawing)]


def _text_of(name: str) -> str:
    """Return the name of a force as text: R₁₂ᵗ."""
    name, part = _parted(name)
    return name.translate(LOWERED) + part


def _parted(name: str) -> tuple[str, str]:
    """Return the name of a reaction and, raised, the t or n of its part across or along a link; "" for the whole reaction."""
    part = SUPERSCRIPT.get(name[-1], "") if name[0] == "R" else ""
    return name[:-1] if part else name, part


def _set(word: tuple[str, str, str]) -> Runs:
    """Return a force, given as (letter, index, text after them), as runs."""
    letter, low, after = word
    return [{"v": letter, "s": low}, *([{"t": after}] if after else [])] if low else [{"t": letter + after}]


def _math_of(vector: ForceVector) -> str:
    """Return a force as Typst math: underlined twice if it is known, once if only its direction is known."""
    letter, low, after = vector.word
    raised = {"ᵗ": "^t", "ⁿ": "^n"}.get(after, "")
    symbol = f'{letter}_"{low}"{raised}' if low else f'"{letter}"{raised}'
    return {KNOWN: f"underline(underline({symbol}))", DIRECTION: f"underline({symbol})"}.get(vector.role, symbol)


def _levers(context: PageContext, plans: ForcePlans) -> list[Part]:
    parts: list[Part] = []
    numbers = context.numbers
    drawings = plans.lever_drawings(context.words.written)
    for lever, drawing in zip(plans.levers, drawings, strict=True):
        unit = plans.analysis.units[plans.analysis.names.index(lever.drive)]
        lines: list[list[Cell]] = [
            [_set(one.word), numeral(numbers.scalar(abs(one.force))), numeral(numbers.fixed(one.h, MILLIMETRES)),
             numeral(numbers.scalar(abs(one.force) * one.h * lever.unit))]
            for one in lever.arms
        ]  # fmt: skip
        heads = [
            Column(context.say("forces.force"), words=True), Column(context.symbol_runs(["F"]), context.unit("N")),
            Column(context.symbol_runs(["h"]), context.unit("mm")), Column(context.say("forces.product"), context.unit(unit)),
        ]  # fmt: skip
        told = context.words(
            "forces.lever.sum", drive=context.lettering(lever.drive),
            couples=context.with_unit(numbers.scalar(lever.couples), unit),
            read=context.with_unit(numbers.scalar(lever.read), unit),
        )  # fmt: skip
        caption = context.lettered(context.words("forces.lever.table", drive=context.lettering(lever.drive)))
        parts += [drawn(context, drawing), Table(heads, lines, caption), Paragraph(context.lettered(told))]
    return parts


def _compared(context: PageContext, plans: ForcePlans) -> list[Part]:
    """Return `table#forces-compare`: values computed, values read from the plans and the lever, differences in percent."""
    numbers = context.numbers
    lines: list[list[Cell]] = []
    for one in plans.readings():
        apart = f"{numbers.fixed(100 * (one.read - one.computed) / one.computed, 2)}" if one.mm else NOTHING
        values = [numbers.scalar(one.computed), numbers.fixed(one.mm, MILLIMETRES), numbers.scalar(one.read), apart]
        name, part = _parted(one.name)
        lines.append([context.symbol_runs([name], part), context.unit("N"), *map(numeral, values)])
    for lever in plans.levers:
        unit = context.unit(plans.analysis.units[plans.analysis.names.index(lever.drive)])
        computed = float(_without_noise(plans.analysis)[plans.row, plans.analysis.names.index(lever.drive)])
        apart = numbers.fixed(100 * (lever.read - computed) / computed, 2) if computed else NOTHING
        values = [numbers.scalar(computed), NOTHING, numbers.scalar(lever.read), apart]
        lines.append([context.symbol_runs([lever.drive]), unit, *map(numeral, values)])
    if not lines:
        return []
    keys = ("forces.force", "given.unit", "forces.computed", "units.mm", "forces.read", "forces.apart")
    heads = [Column(context.say(key), words=place < 2) for place, key in enumerate(keys)]
    return [Table(heads, lines, context.say("forces.compare", row=plans.row + 1), id="forces-compare")]


def _rows(context: PageContext, found: ForceAnalysis) -> list[Part]:
    names = found.reactions.names
    rows = np.column_stack([found.rows.motion.t, _without_noise(found)])
    table = replace(found.as_table(), names=("t", *names), units=("s", *found.units[: len(names)]), rows=rows)
    return extra_parts(context, table, "forces.csv")


def _without_noise(found: ForceAnalysis) -> Array:
    """Return reactions and drives (n, k); an entry that is only round-off of the largest in its row is 0."""
    rows = found.reactions.rows
    largest = np.abs(np.nan_to_num(rows)).max(axis=1, initial=0.0)[:, None]
    return np.where(np.abs(rows) < _ROUND_OFF * largest, 0.0, rows)


def _told(context: PageContext, found: ForceAnalysis) -> list[Part]:
    """Return the sentences on the rows in which the drive brakes, on its mean, and on the flywheel."""
    power = found.energy.drive
    known = power[np.isfinite(power)]
    brakes = [place + 1 for place in np.flatnonzero(power < -1e-9 * np.abs(known).max(initial=0.0)).tolist()]
    told = [context.words("forces.brakes", rows=context.words("join.comma").join(ranges(brakes, len(brakes))))] if brakes else []
    if not brakes and len(known) == len(power):
        told = [context.words("forces.drives")]
    wheel = find_flywheel(found, context.run.variant.time.period)
    if wheel is not None:
        largest = float(np.abs(found.column(found.drive_names[0])).max())
        even = context.numbers.without_noise(wheel.mean, largest)
        mean, excess = context.quantity(even, "N·m", 4), context.quantity(wheel.excess, "J", 4)
        told.append(context.words("forces.mean", mean=mean, excess=excess))
        if wheel.needed is not None:
            told.append(context.words("forces.flywheel", inertia=context.quantity(wheel.needed, "kg·m²", 4)))
    return [Paragraph(context.lettered(context.words.sentences(told)))] if told else []
