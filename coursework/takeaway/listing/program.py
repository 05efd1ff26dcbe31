"""A run as a program that a student types in: data, start, velocities block by block, the loop of a scheme, its boxes.

Enters: a `SceneRun`.  Leaves: `Program`, whose boxes carry the numbers of the comments and the diagram.
Raises `InputError` for motions without a tableau: the exact motion, projection, Baumgarte's term.
Used by `writer.py`, `chart.py` and `commands/listing.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from coursework.equations.codegen.names import private, public
from coursework.equations.codegen.programs import Assign, Statement
from coursework.equations.codegen.straight_line import Line
from coursework.equations.codegen.tabulated import TableLaw
from coursework.equations.reduction.statements import block_statements
from coursework.equations.reduction.symbolic import constants, local, symbol
from coursework.equations.reduction.system import scene_program
from coursework.motion.integration.motion import AT_EVENT, Motion
from coursework.motion.schemes import DEFAULT_SCHEME, SEMI_IMPLICIT, Scheme, scheme_of, title_of
from coursework.motion.settings import scheme_for
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import Words
from coursework.scene.scene_run import SceneRun
from coursework.system.frozen import frozen
from coursework.takeaway.listing.by_forces import CORRECTIONS, Moving, moving
from coursework.variant.record.vocabulary import EXACT
from coursework.words.errors import InputError
from coursework.words.sentences import say


@frozen
class Box:
    """A box of the block diagram: its text; `kind` terminator, data, process, subroutine, decision, begin or end of a loop."""

    number: int
    kind: str
    text: str


@frozen
class Datum:
    """A number at the top of a listing: private name, value, and a comment with its unit."""

    name: str
    value: float
    told: str


@frozen
class BlockOf:
    """The lines of one block of velocities; `checked` names its determinant if that can vanish, else "".

    Lines of an iteration are repeated `repeats` times, 0 stands for once.
    """

    box: Box
    lines: tuple[Line, ...]
    checked: str
    repeats: int = 0


@frozen
class Limit:
    """The velocities when a determinant vanishes at a `time` (s) but the motion goes on; valid up to `within` seconds from it."""

    time: float
    within: float
    values: tuple[float, ...]


@frozen
class Program:
    """What the listings of all languages have in common; names are private ones.

    `start` are the states; `velocities` begin with their slopes, in the same order.  `shown` is printed beside the time; `closed`
    pairs coordinates with the outputs of the velocities that replace them.
    """

    title: str
    scheme: Scheme
    scheme_title: str
    beside_exact: bool  # the rows are Euler's, where a plain run has the exact motion
    data: tuple[Datum, ...]
    start: tuple[Datum, ...]
    step: float
    rows: int
    known: tuple[Line, ...]
    blocks: tuple[BlockOf, ...]
    velocities: tuple[str, ...]
    tables: Mapping[str, TableLaw]
    breaks: tuple[float, ...]
    limits: tuple[Limit, ...]
    boxes: Mapping[str, Box]
    declared: tuple[str, ...]
    shown: tuple[str, ...]
    closed: tuple[tuple[str, str], ...] = ()

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Return the private names of the states: the coordinates, and under forces the free rates."""
        return tuple(one.name for one in self.start)

    @property
    def heads(self) -> tuple[str, ...]:
        """Return the heads of the table."""
        return ("t", *(public(name, self.declared) for name in self.shown))

    def returned(self, words: Words) -> Box:
        """Return the last box of the velocities."""
        last = self.blocks[-1]
        return Box(last.box.number + 1 + bool(last.checked), "terminator", words("listing.box.ret"))

    @property
    def calls(self) -> set[str]:
        """Return every word on the right-hand sides of the lines."""
        lines = [*self.known, *(line for block in self.blocks for line in block.lines)]
        return {word for line in lines for word in re.findall(r"[A-Za-z_]\w*", line.value)}


def program_of(context: PageContext) -> Program:
    """Return the program of a run, with texts in the words of a page."""
    run, motion = context.run, rows_of(context.run)
    scene, variant = run.scene, run.variant
    scheme = scheme_of(motion.scheme, (SEMI_IMPLICIT.name,))
    found = moving(run) if variant.motor is not None else _by_laws(run)
    shown = tuple(map(private, variant.columns))
    boxes = _boxes(context)
    states = [(private(one.name), one.unit) for one in variant.coordinates]
    states += [(name, variant.unit_of(public(name, ()))) for name in found.states]
    start = zip(states, (*scene.start, *found.start), strict=True)
    units = {private(one.name): one.shown_si for one in found.variant.given}
    limits = tuple(
        Limit(one.middle.time, AT_EVENT * one.middle.time, tuple(one.middle.velocities[name] for name in variant.velocities))
        for one in scene.search.passages
    )
    blocks = tuple(_blocks(context, found, len(boxes)))
    title = context.words("listing.title", name=variant.name, title=context.variant.title)
    return Program(
        title, scheme, context.words.written(title_of(scheme)),
        scheme is DEFAULT_SCHEME and scheme_for(variant) == EXACT,
        tuple(Datum(name, found.numbers[name], context.words.unit(units.get(name, "s"))) for name in found.data),
        tuple(Datum(name, value, context.words.unit(unit)) for (name, unit), value in start),
        motion.step, len(motion.t), found.known, blocks, found.outs, scene.equations.tables,
        scene.rates.breaks if scheme.slopes > 1 else (), limits, boxes, found.variant.names, shown, found.closed,
    )  # fmt: skip


def _by_laws(run: SceneRun) -> Moving:
    """Return the parts of the program of a motion that is prescribed by the drive."""
    velocities = run.variant.velocities
    statements: list[Statement] = [
        one for index, block in enumerate(run.reduction.blocks) for one in block_statements(block, index)
    ]
    statements += [Assign(local(f"_{private(name)}"), symbol(name)) for name in velocities]
    found = scene_program(run.scene.equations, statements)
    written = {f"_{private(name)}" for name in velocities}
    lines = tuple(line for line in found.lines if not written & set(line.targets))
    return Moving(run.variant, constants(run.variant), found.known, lines, found.data, tuple(map(private, velocities)))


def rows_of(run: SceneRun) -> Motion:
    """Return the rows that a listing prints: those of the run's scheme, or Euler's if the run's own table is the exact motion."""
    if run.settings.project or run.settings.gain:
        raise InputError(say("fault.C092"))
    motion = run.scene.scheme_rows or run.motion
    refuse_exact(motion.scheme)
    return motion


def refuse_exact(scheme: str | None) -> None:
    """Raise `InputError` if the exact motion itself is asked for."""
    if scheme == EXACT:
        raise InputError(say("fault.C093"))


def _boxes(context: PageContext) -> dict[str, Box]:
    """Return the boxes of the main program by purpose, in order."""
    kinds = {
        "start": "terminator", "data": "data", "loop": "begin", "time": "process", "rates": "subroutine", "row": "data",
        "more": "decision", "step": "process", "again": "end", "end": "terminator",
    }  # fmt: skip
    return {key: Box(number, kind, context.words(f"listing.box.{key}")) for number, (key, kind) in enumerate(kinds.items(), 1)}


def _blocks(context: PageContext, found: Moving, taken: int) -> Iterator[BlockOf]:
    """Yield the blocks of velocities, each with the lines that it needs first."""
    blocks, is_forced = context.run.reduction.blocks, found.variant.motor is not None
    known = {name for line in found.known for name in line.targets}
    number, waiting = taken + 2, list(found.lines)  # after the terminator of the velocities
    if found.closed:
        names = ", ".join(public(name, ()) for name, _ in found.closed)
        yield BlockOf(Box(number, "process", context.words("listing.closing", names=names)), found.closing, "", CORRECTIONS)
        number += 1
    for index, block in enumerate(blocks):
        left, own = set(map(private, block.unknowns)), list[Line]()
        while waiting and (left or (index == len(blocks) - 1 and not is_forced)):
            line = waiting.pop(0)
            own.append(line)
            left -= set(line.targets)
        determinant = f"_det{index}"
        value = next((line.value for line in own if determinant in line.targets), "")
        fixed = value.removeprefix("-") in known or value.removeprefix("-").replace(".", "").isdigit()
        told = context.words(
            "listing.block", names=", ".join(block.unknowns),
            equations=", ".join(f"({context.equation(name)})" for name in block.equations),
        )  # fmt: skip
        yield BlockOf(Box(number, "process", told), tuple(own), "" if fixed else determinant)
        number += 1 if fixed else 2
    if not blocks and not is_forced:  # the drives give every velocity
        yield BlockOf(Box(number, "process", ", ".join(found.variant.velocities)), tuple(waiting), "")
    if is_forced:
        closed = tuple(Line((after,), f"{after} = {name}") for name, after in found.closed)
        yield BlockOf(Box(number, "process", context.words("listing.forces")), (*waiting, *closed), "")
