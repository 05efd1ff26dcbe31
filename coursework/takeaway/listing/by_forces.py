"""A motion under forces as the parts of a program: closed positions, velocities block by block, accelerations.

Enters: a run with [motor].  Leaves: `Moving`: lines and names for programs and workbooks.  Used by `program.py` and the workbook.
The states are all coordinates and the free rates; Newton's corrections close the other coordinates at each slope.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from coursework.effects.dynamics.closed_positions import newton_statements
from coursework.effects.dynamics.motion_writer import MotionWriter
from coursework.effects.scheme import read_scheme
from coursework.equations.algebra.calculus import replaced
from coursework.equations.algebra.expression import ZERO, Expression
from coursework.equations.codegen.names import private
from coursework.equations.codegen.programs import Assign, Program, Statement, program, renamed
from coursework.equations.codegen.straight_line import Line
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.report.live.by_forces import given_once, with_weights
from coursework.scene.exact_scene import scene_of
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.variant.record.variant import Variant

_WORD = re.compile(r"[A-Za-z_]\w*")
CORRECTIONS = 8  # of a position near that of the step before: each error is about the square of the last


@frozen
class Moving:
    """The parts of the program; `outs` name the results of a slope, the rates of the states first.

    Under forces `variant` has masses and loads as data, `states` are the free rates, which join the coordinates, and `numbers`
    are the data and what positions keep constant.
    """

    variant: Variant
    numbers: dict[str, float]
    known: tuple[Line, ...]
    lines: tuple[Line, ...]
    data: tuple[str, ...]
    outs: tuple[str, ...]
    closing: tuple[Line, ...] = ()
    states: tuple[str, ...] = ()
    start: tuple[float, ...] = ()
    closed: tuple[tuple[str, str], ...] = ()


def moving(run: SceneRun) -> Moving:
    """Return the program parts of a run that is moved by forces."""
    variant = with_weights(run.variant)
    scene = scene_of(variant, run.settings)
    equations = scene.equations
    assert variant.motor is not None
    own = MotionWriter(equations, scene.reduction, read_scheme(scene.mechanism), tuple(scene.start))
    moved = own.statements()
    statements = [*given_once([*(Assign(local(name), value) for name, value in own.weights.items()), *moved])]
    names = [c.name for c in variant.coordinates]
    free = {names[place] for place in own.free}
    outs = [f"_rate_{name}" if name in free else private(c.rate) for name, c in zip(names, variant.coordinates, strict=True)]
    outs += [one.name for one in own.solved]
    outs += [private(name) for name, _ in variant.unknowns if name not in variant.rates]
    closed = tuple((private(names[place]), f"_closed_{names[place]}") for place in own.others)
    statements += [Assign(local(f"_rate_{names[place]}"), symbol(rate)) for place, rate in zip(own.free, own.rates, strict=True)]
    corrections, kept, _ = newton_statements(equations, scene.start, own.others)
    zeros = {local(f"_kept{k}"): ZERO for k, value in enumerate(kept) if not value}
    corrections = [_with(one, zeros) for one in corrections]
    known = {**constants(variant), **{f"_kept{k}": value for k, value in enumerate(kept) if value}}

    def written(wanted: Sequence[Statement]) -> Program:
        definitions = equations.symbols.definitions.without({symbol(rate) for rate in own.rates})
        return program(wanted, definitions, known, equations.tables)

    main, closing = written(statements), written(corrections)
    listed = [name for line in (*closing.known, *closing.lines) for name in line.targets if not name.startswith("_step")]
    taken = {name: f"{name.replace('_det', '_near')}_n" for name in listed}
    after = [Line((name,), f"{name} = {name} + _step{place}") for place, (name, _) in zip(own.others, closed, strict=True)]
    start = dict(variant.motor.start)
    return Moving(
        variant, known, (*main.known, *_renamed(closing.known, taken)), _needed(main.lines, outs),
        tuple(name for name in known if name in (*main.data, *closing.data)), tuple(outs) + tuple(name for _, name in closed),
        (*_renamed(closing.lines, taken), *after), tuple(map(private, own.rates)),
        tuple(start.get(rate, 0.0) for rate in own.rates), closed,
    )  # fmt: skip


def _with(one: Statement, values: Mapping[Expression, Expression]) -> Statement:
    """Return a statement in which symbols are replaced by expressions."""
    if isinstance(one, Assign):
        return replace(one, value=replaced(one.value, values))
    return replace(one, entries=tuple(replaced(entry, values) for entry in one.entries))


def _renamed(lines: Sequence[Line], names: dict[str, str]) -> Iterator[Line]:
    for line in renamed(lines, names):
        yield Line(tuple(names.get(name, name) for name in line.targets), line.text)


def _needed(lines: Sequence[Line], wanted: Iterable[str]) -> tuple[Line, ...]:
    """Return the lines on which the names in `wanted` depend, and those of all determinants."""
    found, read = list[Line](), set(wanted)
    for line in reversed(lines):
        if any(name in read or name.startswith("_det") for name in line.targets):
            found.append(line)
            read |= {*_WORD.findall(line.value)}
    return tuple(reversed(found))
