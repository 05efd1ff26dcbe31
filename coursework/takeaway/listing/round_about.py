"""What the languages say alike round their lines: data with units, limits at singular positions, breaks of the drive.

Enters: a `Writer`.  Leaves: lines.  Used by `interpreted.py` and `compiled.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from coursework.takeaway.listing.program import Datum
from coursework.takeaway.listing.writer import Writer, held, indented

Lines = list[str]


def data_lines(one: Writer, written: Callable[[str, str], str]) -> Lines:
    """Return data, step, number of steps and start, each with its unit."""
    program = one.program

    def line(datum: Datum) -> str:
        told = f"  {one.comment(datum.told)}" if datum.told else ""
        return f"{written(one.names[datum.name], repr(datum.value))}{told}"

    data, start = [*map(line, program.data)], [*map(line, program.start)]
    step = [written(one.h, repr(program.step)), f"{written(one.steps, str(one.last))}  {one.say('rows')}"]
    return [*data, *step, *start]


def limit_lines(one: Writer, leave: Callable[[Sequence[str]], Lines], test: str, *after: str) -> Lines:
    """Return what stands for the velocities where a determinant vanishes and the motion goes on; `after` ends the test."""
    lines = []
    for limit in one.program.limits:
        holds = f"{one.syntax.calls.get('abs', 'abs')}({one.t} - {limit.time!r}) <= {limit.within!r}"
        lines += [one.say("limit"), test.format(holds=holds), *indented(leave([repr(value) for value in limit.values])), *after]
    return lines


def numbered(stage: int, rate: str) -> str:
    """Return the name of a velocity in a slope of the step; that of the first one is its own."""
    return rate if not stage else f"{rate}_{stage + 1}"


def row_by_row(
    one: Writer, call: Callable[[int], str], show: Callable[[Sequence[str]], str], out: Callable[[int, str], str] = numbered
) -> Lines:
    """Return the head line and the loop over the rows: `call` finds a slope, `show` prints the numbers of a row."""
    syntax, program = one.syntax, one.program
    further = [line for stage in range(1, program.scheme.slopes) for line in one.wrapped(call(stage))]
    step = [*further, one.box("step"), *one.steps_on(out)]
    row = [
        one.box("time"), one.sets(f"{syntax.declares}{one.t}", f"{one.row}*{one.h}"),
        one.box("rates"), call(0), *one.closed(out),
        one.box("row"), *one.wrapped(show([one.t, *one.shown(out)])),
        one.box("more"), *held(syntax.test, step, holds=f"{one.row} < {one.steps}"),
    ]  # fmt: skip
    heads, rows = syntax.prints.format(heads=",".join(program.heads)), held(syntax.rows, row, i=one.row, n=one.steps)
    return [heads, one.box("loop"), *rows, one.box("again"), one.box("end")]


def listed(one: Writer, stage: int) -> str:
    """Return what takes the velocities of a slope from the list that is returned."""
    found = ", ".join(numbered(stage, rate) for rate in one.velocities)
    return f"{one.syntax.declares}[{found}] = {one.rates}({', '.join(one.slope(stage, numbered))});"


def by_printf(values: Sequence[str]) -> str:
    """Return what prints the numbers of a row in C and Octave."""
    return f'printf("{",".join(["%.15g"] * len(values))}\\n", {", ".join(values)});'


def largest_block(one: Writer) -> int:
    """Return the size of the largest block that is solved by elimination, 0 where none is."""
    lines = (line for block in one.program.blocks for line in block.lines)
    return max((len(line.targets) - 1 for line in lines if "_solve" in line.text), default=0)
