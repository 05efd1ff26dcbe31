"""Listings in C and Pascal, whose names are declared before they are used.

Enters: a `Writer`.  Leaves: the lines of a listing.  Used by `listings.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.takeaway.listing.round_about import Lines, by_printf, data_lines, largest_block, limit_lines, row_by_row
from coursework.takeaway.listing.tables import functions
from coursework.takeaway.listing.writer import Writer, indented


def c(one: Writer) -> Lines:
    """Return the listing in C."""
    outs, slopes = one.velocities, one.program.scheme.slopes
    arguments = ", ".join(f"double {name}" for name in (one.t, *one.coordinates))
    kind, inside = one.names.own("_kind", "Velocities"), ", ".join([*one.locals, *outs])
    slope = [one.names.own(f"_k{stage}", f"u{stage + 1}", f"slope{stage + 1}") for stage in range(slopes)]

    def out(stage: int, rate: str) -> str:
        return f"{slope[stage]}.{rate}"

    def call(stage: int) -> str:
        return f"{kind} {slope[stage]} = {one.rates}({', '.join(one.slope(stage, out))});"

    limits = limit_lines(one, lambda values: [f"return ({kind}) {{{', '.join(values)}}};"], "if ({holds})")
    rows = row_by_row(one, call, by_printf, out)
    known = [one.names[name] for name in one.targets(one.program.known)]
    data = data_lines(one, lambda name, value: f"{'int' if name == one.steps else 'static double'} {name} = {value};")
    size = largest_block(one)
    work = [f"static double {one.names.own('_work', 'work')}[{size}][{size + 1}];"] if size else []
    return [
        *one.head(), "#include <math.h>", "#include <stdio.h>", "#include <stdlib.h>", "",
        one.box("data"), *data, *([f"static double {', '.join(known)};"] if known else []), *work,
        f"typedef struct {{ double {', '.join(outs)}; }} {kind};", *functions(one), "",
        one.of_velocities, f"static {kind} {one.rates}({arguments}) {{",
        *indented([*one.wrapped(f"double {inside};"), *limits, *one.blocks(), f"return ({kind}) {{{', '.join(outs)}}};"]),
        "}", "",
        one.box("start"), "int main(void) {", *indented([*one.known(), *rows, "return 0;"]), "}",
    ]  # fmt: skip


def pascal(one: Writer) -> Lines:
    """Return the listing in Pascal."""
    outs, slopes = one.velocities, one.program.scheme.slopes
    arguments = "; ".join([f"{', '.join([one.t, *one.coordinates])}: double", f"var {', '.join(outs)}: double"])

    later = {
        (stage, rate): one.names.own(f"_{rate}_{stage}", f"{rate}_{stage + 1}") for stage in range(1, slopes) for rate in outs
    }

    def out(stage: int, rate: str) -> str:
        return later[stage, rate] if stage else rate

    def call(stage: int) -> str:
        return f"{one.rates}({', '.join([*one.slope(stage, out), *(out(stage, rate) for rate in outs)])});"

    def leave(values: Sequence[str]) -> Lines:
        return [*(f"{name} := {value};" for name, value in zip(outs, values, strict=True)), "exit end;"]

    limits = limit_lines(one, leave, "if {holds} then begin")
    text = one.names.own("_text", "shown")

    def show(values: Sequence[str]) -> str:
        shown = ", ',', ".join(f"{text}({value})" for value in values)
        return f"writeln({shown});"

    rows = row_by_row(one, call, show, out)
    known = [one.names[name] for name in one.targets(one.program.known)]
    data = data_lines(one, lambda name, value: f"  {name}: {'integer' if name == one.steps else 'double'} = {value};")
    size = largest_block(one)
    work = [f"  {one.names.own('_work', 'work')}: array[0..{size - 1}, 0..{size}] of double;"] if size else []
    return [
        *one.head(), "{$mode objfpc}", "program coursework;", "uses math, sysutils;", "",
        one.box("data"), "var", *data, *([f"  {', '.join(known)}: double;"] if known else []), *work,
        f"  {one.row}: integer;", f"  {', '.join([one.t, *outs, *later.values()])}: double;", *functions(one), "",
        one.of_velocities, f"procedure {one.rates}({arguments});",
        *(one.wrapped(f"var {', '.join(one.locals)}: double;") if one.locals else []),
        *([f"    {one.count}: integer;"] if one.repeats else []), "begin",
        *indented([*limits, *one.blocks()]), "end;", "",
        f"function {text}(x: double): string;", f"begin {text} := FloatToStrF(x, ffGeneral, 15, 0) end;", "",
        one.box("start"), "begin",
        *indented([
            "DefaultFormatSettings.DecimalSeparator := '.';",
            "SetExceptionMask([exInvalidOp, exDenormalized, exZeroDivide, exOverflow, exUnderflow, exPrecision]);",
            *one.known(), *rows,
        ]), "end.",
    ]  # fmt: skip
