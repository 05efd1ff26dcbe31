"""Listings in C and Pascal, whose names are declared before they are used.

Enters: a `Writer`.  Leaves: the lines of a listing.  Used by `listings.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.takeaway.listing.program import Box
from coursework.takeaway.listing.round_about import Lines, break_times, data_lines, further_slopes, largest_block, limit_lines
from coursework.takeaway.listing.tables import functions
from coursework.takeaway.listing.writer import Writer, indented


def c(one: Writer) -> Lines:
    """Return the listing in C."""
    outs, slopes = one.velocities, one.program.scheme.slopes
    arguments = ", ".join(f"double {name}" for name in (one.t, *one.coordinates))
    kind, inside = one.names.own("_kind", "Velocities"), ", ".join([*one.locals, *outs])
    slope = [one.names.own(f"_k{stage}", f"u{stage + 1}", f"slope{stage + 1}") for stage in range(slopes)]

    def stop(name: str, box: Box) -> Lines:
        return [one.of(box), f'if ({name} == 0.0) {{ fprintf(stderr, "{name} = 0\\n"); exit(1); }}']

    def out(stage: int, rate: str) -> str:
        return f"{slope[stage]}.{rate}"

    limits = limit_lines(one, lambda values: [f"return ({kind}) {{{', '.join(values)}}};"], "if ({holds})")
    looks: Lines = []
    if one.program.breaks:
        looks = ["", one.say("breaks"), f"static double {one.look}(double t, double after) {{"]
        looks += [f"    const double b[] = {{{break_times(one)}}};"]
        looks += [f"    for (int j = 0; j < {len(one.program.breaks)}; j++)"]
        looks += ["        if (fabs(after - b[j]) <= 1e-13*b[j]) t = fmin(t, after*(1 - 1e-13));", "    return t;", "}"]
    values = ", ".join([one.t, *one.shown(out)])
    form = ",".join(["%.15g"] * len(one.program.heads))
    further = further_slopes(one, lambda stage: f"{kind} {slope[stage]} = {one.rates}({', '.join(one.slope(stage, out))});")
    loop = [
        one.box("time"), f"double {one.t} = {one.row}*{one.h};",
        one.box("rates"), f"{kind} {slope[0]} = {one.rates}({', '.join([one.t, *one.coordinates])});",
        *one.closed(out), one.box("row"), *one.wrapped(f'printf("{form}\\n", {values});'),
        one.box("more"), f"if ({one.row} < {one.steps}) {{", *indented([*further, one.box("step"), *one.steps_on(out)]), "}",
    ]  # fmt: skip
    known = [one.names[name] for name in one.targets(one.program.known)]
    sign = ["", "static double sign(double x) { return (x > 0) - (x < 0); }"] if one.needs_sign else []
    data = data_lines(one, lambda name, value: f"{'int' if name == one.steps else 'static double'} {name} = {value};")
    work = (
        [f"static double {one.names.own('_work', 'work')}[{largest_block(one)}][{largest_block(one) + 1}];"]
        if one.needs_gauss
        else []
    )
    return [
        *one.head(), "#include <math.h>", "#include <stdio.h>", "#include <stdlib.h>", "",
        one.box("data"), *data, *([f"static double {', '.join(known)};"] if known else []), *work,
        f"typedef struct {{ double {', '.join(outs)}; }} {kind};", *functions(one), *sign, *looks, "",
        one.of_velocities, f"static {kind} {one.rates}({arguments}) {{",
        *indented([*one.wrapped(f"double {inside};"), *limits, *one.blocks(stop), f"return ({kind}) {{{', '.join(outs)}}};"]),
        "}", "",
        one.box("start"), "int main(void) {",
        *indented([
            *one.known(), f'printf("{",".join(one.program.heads)}\\n");', one.box("loop"),
            f"for (int {one.row} = 0; {one.row} <= {one.steps}; {one.row}++) {{", *indented(loop), "}", one.box("again"),
            one.box("end"), "return 0;",
        ]), "}",
    ]  # fmt: skip


def pascal(one: Writer) -> Lines:
    """Return the listing in Pascal."""
    outs, slopes = one.velocities, one.program.scheme.slopes
    arguments = "; ".join([f"{', '.join([one.t, *one.coordinates])}: double", f"var {', '.join(outs)}: double"])

    def stop(name: str, box: Box) -> Lines:
        return [one.of(box), f"if {name} = 0.0 then begin writeln(stderr, '{name} = 0'); halt(1) end;"]

    later = {
        (stage, rate): one.names.own(f"_{rate}_{stage}", f"{rate}_{stage + 1}") for stage in range(1, slopes) for rate in outs
    }

    def out(stage: int, rate: str) -> str:
        return later[stage, rate] if stage else rate

    def leave(values: Sequence[str]) -> Lines:
        return [*(f"{name} := {value};" for name, value in zip(outs, values, strict=True)), "exit end;"]

    limits = limit_lines(one, leave, "if {holds} then begin")
    looks: Lines = []
    if one.program.breaks:
        count = len(one.program.breaks)
        looks = ["", one.say("breaks"), f"function {one.look}(t, after: double): double;"]
        looks += [f"const b: array[1..{count}] of double = ({break_times(one)});", "var j: integer;", "begin"]
        looks += [f"  for j := 1 to {count} do", "    if abs(after - b[j]) <= 1e-13*b[j] then t := min(t, after*(1 - 1e-13));"]
        looks += [f"  {one.look} := t;", "end;"]
    further = further_slopes(
        one, lambda stage: f"{one.rates}({', '.join([*one.slope(stage, out), *(out(stage, rate) for rate in outs)])});"
    )
    values = [one.t, *one.shown(out)]
    text = one.names.own("_text", "shown")
    shown = ", ',', ".join(f"{text}({value})" for value in values)
    loop = [
        one.box("time"), f"{one.t} := {one.row}*{one.h};",
        one.box("rates"), f"{one.rates}({', '.join([one.t, *one.coordinates, *outs])});",
        *one.closed(out), one.box("row"), *one.wrapped(f"writeln({shown});"),
        one.box("more"), f"if {one.row} < {one.steps} then begin",
        *indented([*further, one.box("step"), *one.steps_on(out)]), "end;",
    ]  # fmt: skip
    known = [one.names[name] for name in one.targets(one.program.known)]
    data = [
        f"  {line}"
        for line in data_lines(one, lambda name, value: f"{name}: {'integer' if name == one.steps else 'double'} = {value};")
    ]
    further_names = [*later.values()]
    work = (
        [f"  {one.names.own('_work', 'work')}: array[0..{largest_block(one) - 1}, 0..{largest_block(one)}] of double;"]
        if one.needs_gauss
        else []
    )
    return [
        *one.head(), "{$mode objfpc}", "program coursework;", "uses math, sysutils;", "",
        one.box("data"), "var", *data, *([f"  {', '.join(known)}: double;"] if known else []), *work,
        f"  {one.row}: integer;", f"  {', '.join([one.t, *outs, *further_names])}: double;", *functions(one), *looks, "",
        one.of_velocities, f"procedure {one.rates}({arguments});",
        *(one.wrapped(f"var {', '.join(one.locals)}: double;") if one.locals else []),
        *([f"    {one.count}: integer;"] if one.repeats else []), "begin",
        *indented([*limits, *one.blocks(stop)]), "end;", "",
        f"function {text}(x: double): string;", f"begin {text} := FloatToStrF(x, ffGeneral, 15, 0) end;", "",
        one.box("start"), "begin",
        *indented([
            "DefaultFormatSettings.DecimalSeparator := '.';",
            "SetExceptionMask([exInvalidOp, exDenormalized, exZeroDivide, exOverflow, exUnderflow, exPrecision]);",
            *one.known(), f"writeln('{','.join(one.program.heads)}');", one.box("loop"),
            f"for {one.row} := 0 to {one.steps} do begin", *indented(loop), "end;", one.box("again"), one.box("end"),
        ]), "end.",
    ]  # fmt: skip
