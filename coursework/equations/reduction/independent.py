"""Which equations determine the unknown velocities; redundant, contradictory and missing ones are reported by name.

Enters: velocity equations and the start.  Leaves: the indices to use and sentences.  Raises `InputError`.
Source: Dulmage, Mendelsohn 1958 (structure); rank by orthogonalisation in the author's order (numbers).
Used by `blocks.py` and `closed_positions.py`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from coursework.equations.algebra.calculus import derivative
from coursework.equations.reduction.equations import VelocityEquation, VelocityEquations
from coursework.equations.reduction.matching import match, over_and_under
from coursework.equations.reduction.symbolic import symbol
from coursework.equations.reduction.system import LinearSystem, compile_system, compile_values
from coursework.system.arrays import Array
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import joined, say, say_count

# A row counts as dependent if its rest after projection is below this fraction of its length: 1e-9 is far above round-off
# (1e-16 times the condition of a benign scene) and far below any angle that a task sheet can mean.
DEPENDENT = 1e-9
# A smaller relative difference is a repetition; a larger one was written in the file.
EXACTLY = 1e-14
_ZERO = 1e-12
_MISSING = "fault.V404"
_MOST_CONDITION = 1e15


def choose(
    equations: VelocityEquations, start: Sequence[float], *, numbers: bool = False
) -> tuple[tuple[int, ...], tuple[str, ...]]:
    """Return the indices of a maximal independent set of equations in the author's order, and sentences about the others.

    `start`: coordinates at t = 0 (rad, m).  With `numbers`, the numerical rank is checked even if each velocity has an equation
    of its own, because two of these equations may still be multiples of each other.  Raises `InputError` if velocities remain
    undetermined or two equations contradict each other.
    """
    listed = equations.equations
    rows = [frozenset(equations.unknowns.index(name) for name in equation.coefficients) for equation in listed]
    owner = match(rows, len(equations.unknowns))
    if len(listed) == len(equations.unknowns) and -1 not in owner and not numbers:
        return tuple(range(len(listed))), ()
    system = compile_system(equations, listed)
    matrix, right, _ = system.matrix(0.0, start)
    generic = _generic(system, start)
    base = matrix if len(independent_rows(matrix)) == len(independent_rows(generic)) else generic
    kept = independent_rows(base)
    names = [equation.name for equation in listed]
    size = float(np.abs(matrix * equations.speed_units).max(initial=0.0))
    sames, conflicts = _judge_dropped(matrix, right, kept, names, size)
    if conflicts:
        # What follows from the geometry cannot be corrected: so of contradicting equations the written one is reported.
        order = sorted(range(len(listed)), key=lambda place: listed[place].written is not None)
        kept = [order[place] for place in independent_rows(base[order])]
        sames, conflicts = _judge_dropped(matrix, right, kept, names, size)
    if len(kept) < len(equations.unknowns) and (nearly := _nearly(base, kept, names)):
        raise InputError([_too_near(equations, nearly, base)])
    if len(kept) == len(equations.unknowns) and (names_tied := _tied(equations, start, matrix, kept)):
        told = say("fault.V750", names=names_tied)
        raise InputError([Fault(told, equations.variant.file, equations.variant.nearest_line("motor", "rates"))])
    if conflicts or len(kept) < len(equations.unknowns):
        of_positions = [Fault(say("fault.V405", name=one.name), equations.variant.file, one.line) for one in _still(equations)]
        raise InputError(of_positions or [_fault(equations, base, kept, sames, conflicts, rows, owner)])
    notes = tuple(say("equation.redundant", same=_same(names)) for names in sames)
    return tuple(kept), notes


def _tied(equations: VelocityEquations, start: Sequence[float], matrix: Array, kept: list[int]) -> tuple[str, ...]:
    """Return the rates that forces are to move freely although the equations that are left out tie them to each other."""
    rates = equations.variant.motor.rates if equations.variant.motor else ()
    if not rates or len(kept) == len(equations.equations):
        return ()
    slopes = [derivative(one.right_side, symbol(rate)) for one in equations.equations for rate in rates]
    right = np.array(compile_values(equations, slopes)[0](0.0, *start), dtype=float).reshape(-1, len(rates))
    names, size = [equation.name for equation in equations.equations], float(np.abs(matrix * equations.speed_units).max())
    tied = [rate for rate, column in zip(rates, right.T, strict=True) if _judge_dropped(matrix, column, kept, names, size)[1]]
    return tuple(tied)


def _generic(system: LinearSystem, start: Sequence[float]) -> Array:
    # Any fixed irrational shifts will do: they leave the special position in which a mechanism may start.
    shifted = [value + 0.1 * ((0.618 * (i + 1)) % 1.0) + 0.05 for i, value in enumerate(start)]
    return system.matrix(0.0137, shifted)[0]


def independent_rows(matrix: Array) -> list[int]:
    """Return the rows that are independent of the rows kept before them (modified Gram-Schmidt)."""
    basis: list[Array] = []
    kept = []
    scale = np.max(np.abs(matrix), axis=0, initial=0.0)
    scaled = matrix / np.where(scale > 0, scale, 1.0)
    for index, row in enumerate(scaled):
        length = float(np.linalg.norm(row))
        rest = row.copy()
        for direction in basis * 2:
            rest = rest - (rest @ direction) * direction
        if length > 0 and np.linalg.norm(rest) > DEPENDENT * length:
            basis.append(rest / np.linalg.norm(rest))
            kept.append(index)
    return kept


def _left_out(matrix: Array, kept: list[int], names: list[str]) -> Iterator[tuple[int, Array, list[str]]]:
    """Yield each row that is not kept, its weights over the kept rows, and the names of those with a weight."""
    for index in sorted({*range(len(names))} - {*kept}):
        weights = np.linalg.lstsq(matrix[kept].T, matrix[index], rcond=None)[0]
        yield index, weights, [names[k] for k, weight in zip(kept, weights, strict=True) if abs(weight) > DEPENDENT]


def _judge_dropped(
    matrix: Array, right: Array, kept: list[int], names: list[str], size: float
) -> tuple[list[tuple[str, list[str]]], list[tuple[str, list[str], float]]]:
    """Return, for the rows left out, (name, names it repeats) and (name, names it contradicts, difference).

    `size` is that of the largest term for velocities of 1 rad/s: sides that are zero but for its round-off are equal.
    """
    sames: list[tuple[str, list[str]]] = []
    conflicts: list[tuple[str, list[str], float]] = []
    for index, weights, involved in _left_out(matrix, kept, names):
        gap = float(right[index] - weights @ right[kept])
        scale = abs(right[index]) + float(np.abs(weights) @ np.abs(right[kept]))
        if abs(gap) > DEPENDENT * max(scale, 1e-300) and abs(gap) > _ZERO * size:
            conflicts.append((names[index], involved, gap))
        else:
            sames.append((names[index], involved))
    return sames, conflicts


def _nearly(matrix: Array, kept: list[int], names: list[str]) -> list[tuple[str, list[str], float]]:
    """Return (name, names it nearly repeats, relative difference) for the rows left out that are no exact repetition."""
    found = []
    for index, weights, involved in _left_out(matrix, kept, names):
        size = float(np.linalg.norm(matrix[index]))
        part = float(np.linalg.norm(matrix[index] - weights @ matrix[kept])) / size if size else 0.0
        if part > EXACTLY * (1 + float(np.max(np.abs(weights), initial=0.0))):
            found.append((names[index], involved, part))
    return found


def _too_near(equations: VelocityEquations, nearly: list[tuple[str, list[str], float]], matrix: Array) -> Fault:
    """Return the fault of equations that differ by too little for double precision.

    The condition is that of rows scaled to equal length; near 1e15, the reciprocal of round-off, its value is unreliable.
    """
    unknowns, listed = equations.unknowns, equations.equations
    name, others, part = max(nearly, key=lambda one: one[2])
    line = next(equation.line for equation in listed if equation.name == name)
    why = say("equation.nearly", name=name, others=tuple(others), part=part)
    lengths = np.linalg.norm(matrix, axis=1, keepdims=True)
    condition = min(float(np.linalg.cond(matrix / np.where(lengths > 0, lengths, 1.0))), _MOST_CONDITION)
    told = say(
        "fault.V404.nearly", count=len(unknowns), unknowns=", ".join(unknowns), rows=len(listed),
        condition=10.0 ** np.floor(np.log10(condition)), why=why,
    )  # fmt: skip
    return Fault(told, equations.variant.file, line)


def _still(equations: VelocityEquations) -> Iterator[VelocityEquation]:
    """Yield the written equations that contain coordinates and no velocity."""
    variant = equations.variant
    coordinates, moving = {one.name for one in variant.coordinates}, {*variant.velocities, *(law.name for law in variant.drive)}
    for one in equations.equations:
        names = {name for side in one.written or () for name in side.names()}
        if names & coordinates and not names & moving:
            yield one


def _same(pair: tuple[str, list[str]]) -> str:
    name, others = pair
    if not others:
        return say("equation.nothing", name=name)
    return say("equation.same_together" if len(others) > 1 else "equation.same", name=name, others=tuple(others))


def _fault(
    equations: VelocityEquations, matrix: Array, kept: list[int], sames: list[tuple[str, list[str]]],
    conflicts: list[tuple[str, list[str], float]], rows: list[frozenset[int]], owner: list[int],
) -> Fault:  # fmt: skip
    unknowns, drive = equations.unknowns, equations.variant.drive
    counts = {"count": len(unknowns), "unknowns": ", ".join(unknowns), "rows": len(rows)}
    sentences: list[Sentence] = []
    driven, written = tuple(law.name for law in drive), {one.name: one.written for one in equations.equations if one.written}
    is_whole = len(kept) == len(unknowns)  # else even more would be missing with fewer drives: a closure is wrong
    if is_whole and conflicts and len(drive) > 1 and not any({name, *others} & written.keys() for name, others, _ in conflicts):
        freedom = max(0, len(drive) - len(conflicts))  # all equations are those of the geometry: none of them is wrong
        sentences.append(say_count("equation.too_many_drives", freedom, drive=driven))
    elif conflicts:
        for name, others, gap in conflicts:
            laws = [rate for rate in equations.variant.known_rates if any(rate in side.names() for side in written.get(name, ()))]
            key = "together" if len(others) > 1 else "one" if others else "drive" if laws else "nothing"
            listed = others or [f"{law} (:{equations.variant.nearest_line('drive', law)})" for law in laws]
            sentences.append(say(f"equation.contradicts.{key}", name=name, others=tuple(listed), gap=abs(gap)))
        if not is_whole:  # without one of them even more would be missing
            sentences.append(say("equation.correct_one"))
        else:
            sentences.append(say("equation.drive_less", drive=driven) if len(drive) > 1 else say("equation.correct"))
    sentences += [say("equation.dependent", sentence=_same(pair)) for pair in sames]
    idle = () if is_whole else tuple(law.name for law in drive if not _moves(law.name, equations))
    if idle and not conflicts:
        sentences.insert(0, say("equation.idle", names=idle, rate=equations.variant.coordinates[0].rate))
    if not is_whole:
        open_to = _undetermined(matrix, kept, unknowns)
        sentences.append(say("equation.missing", names=tuple(open_to)))
        told = _structure(equations, rows, owner)
        sentences += told
        nowhere = any(one.key.startswith("equation.in_none") and one.values["involved"] == tuple(open_to) for one in told)
        if not (conflicts or nowhere or idle):  # an idle drive prescribes nothing
            sentences.append(say_count("equation.ways", len(unknowns) - len(kept), drives=len(drive)))
    file = equations.variant.file
    lines = {equation.name: equation.line for equation in equations.equations}
    own = {lines[name] for name, *_ in conflicts or sames}
    if idle and not conflicts:
        own = {equations.variant.nearest_line("drive", idle[0])}
    line = own.pop() if len(own) == 1 else equations.variant.nearest_line("coordinates")
    code = "fault.V403" if conflicts else _MISSING
    return Fault(say_count(code, len(kept), **counts, why=joined(sentences)), file, line)


def _moves(law: str, equations: VelocityEquations) -> bool:
    """Return whether a law of [drive] is the rate of a coordinate or occurs in an equation."""
    parts = (part for one in equations.equations for part in one.parts)
    return law in equations.variant.rates or any(symbol(law) in part.free_symbols for part in parts)


def _undetermined(matrix: Array, kept: list[int], unknowns: tuple[str, ...]) -> list[str]:
    if not kept:
        return list(unknowns)
    _, sizes, directions = np.linalg.svd(matrix[kept])
    free = directions[int(np.sum(sizes > DEPENDENT * sizes[0])) :]
    return [name for column, name in enumerate(unknowns) if np.max(np.abs(free[:, column]), initial=0.0) > DEPENDENT]


def _structure(equations: VelocityEquations, rows: list[frozenset[int]], owner: list[int]) -> list[Sentence]:
    """Return sentences about equations that share too few unknowns and unknowns that share too few equations."""
    names = [equation.name for equation in equations.equations]
    (crowd, shared), (few, involved) = (
        (tuple(names[row] for row in part[0]), tuple(equations.unknowns[column] for column in part[1]))
        for part in over_and_under(rows, owner)
    )
    told = []
    if len(crowd) > len(shared):
        told.append(say_count("equation.crowd" if shared else "equation.empty", len(crowd), names=crowd, involved=shared))
    if few:
        key = "equation.alone_in" if len(involved) == 1 else "equation.only_in"
        told.append(say_count(key, len(few), names=few, involved=involved))
    elif involved:
        told.append(say_count("equation.in_none", len(involved), involved=involved))
    return told
