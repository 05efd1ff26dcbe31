"""Listings in Python, JavaScript and Octave: what stands round the lines that all languages have in common.

Enters: a `Writer`.  Leaves: the lines of a listing.  Used by `listings.py`.
"""

from __future__ import annotations

from collections.abc import Sequence

from coursework.takeaway.listing.program import Box
from coursework.takeaway.listing.round_about import Lines, break_times, data_lines, further_slopes, limit_lines, numbered
from coursework.takeaway.listing.tables import functions
from coursework.takeaway.listing.writer import Writer, indented


def python(one: Writer) -> Lines:
    """Return the listing in Python."""
    outs = [*one.velocities]
    arguments = ", ".join([one.t, *one.coordinates])

    def stop(name: str, box: Box) -> Lines:
        told = f'raise SystemExit("{name} = 0")'
        return [one.of(box), f"if {name} == 0.0:", f"    {told}"]

    def several(names: Sequence[str]) -> str:
        return ", ".join(names) + ("," if len(names) == 1 else "")

    limits = limit_lines(one, lambda values: [f"return {several(values)}"], "if {holds}:")
    calls = sorted(one.program.calls & {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "sqrt"})
    looks: Lines = []
    if one.program.breaks:
        looks = ["", one.say("breaks"), f"def {one.look}(t, after):"]
        looks += [f"    for b in ({break_times(one)},):", "        if abs(after - b) <= 1e-13*b:"]
        looks += ["            t = min(t, after*(1 - 1e-13))", "    return t"]
    loop = [one.box("time"), f"{one.t} = {one.row}*{one.h}", one.box("rates"), f"{several(outs)} = {one.rates}({arguments})"]
    values = ", ".join([one.t, *one.shown(numbered)])
    loop += [
        *one.closed(numbered),
        one.box("row"),
        *one.wrapped(f'print(",".join(f"{{x:.15g}}" for x in [{values}]))'),
        one.box("more"),
    ]
    further = further_slopes(
        one,
        lambda stage: (
            f"{several([numbered(stage, rate) for rate in outs])} = {one.rates}({', '.join(one.slope(stage, numbered))})"
        ),
    )
    sign = ["", "def sign(x):", "    return (x > 0) - (x < 0)"] if one.needs_sign else []
    return [
        *one.head(), *([f"from math import {', '.join(calls)}"] if calls else []), "",
        one.box("data"), *data_lines(one, lambda name, value: f"{name} = {value}"), *one.known(),
        *functions(one), *sign, *looks, "",
        one.of_velocities, f"def {one.rates}({arguments}):",
        *indented([*limits, *one.blocks(stop), f"return {several(outs)}"]), "",
        one.box("start"), f'print("{",".join(one.program.heads)}")',
        one.box("loop"), f"for {one.row} in range({one.steps} + 1):",
        *indented([*loop, f"if {one.row} < {one.steps}:", *indented([*further, one.box("step"), *one.steps_on(numbered)])]),
        one.box("again"), one.box("end"),
    ]  # fmt: skip


def javascript(one: Writer) -> Lines:
    """Return the listing in JavaScript."""
    outs = one.velocities
    arguments = ", ".join([one.t, *one.coordinates])

    def stop(name: str, box: Box) -> Lines:
        return [one.of(box), f'if ({name} === 0.0) throw new Error("{name} = 0");']

    limits = limit_lines(one, lambda values: [f"return [{', '.join(values)}];"], "if ({holds})")
    looks: Lines = []
    if one.program.breaks:
        looks = ["", one.say("breaks"), f"function {one.look}(t, after) {{"]
        looks += [f"    for (const b of [{break_times(one)}])"]
        looks += ["        if (Math.abs(after - b) <= 1e-13*b) t = Math.min(t, after*(1 - 1e-13));", "    return t;", "}"]
    further = further_slopes(
        one,
        lambda stage: (
            f"const [{', '.join(numbered(stage, rate) for rate in outs)}] = {one.rates}({', '.join(one.slope(stage, numbered))});"
        ),
    )
    values = ", ".join([one.t, *one.shown(numbered)])
    loop = [
        one.box("time"), f"const {one.t} = {one.row}*{one.h};",
        one.box("rates"), f"const [{', '.join(outs)}] = {one.rates}({arguments});",
        *one.closed(numbered), one.box("row"),
        *one.wrapped(f'console.log([{values}].map((x) => Number(x.toPrecision(15))).join(","));'),
        one.box("more"), f"if ({one.row} < {one.steps}) {{", *indented([*further, one.box("step"), *one.steps_on(numbered)]), "}",
    ]  # fmt: skip
    inside = [*one.wrapped(f"let {', '.join([*one.locals, *outs])};"), *limits, *one.blocks(stop), f"return [{', '.join(outs)}];"]
    return [
        *one.head(), "", one.box("data"), *data_lines(one, lambda name, value: f"let {name} = {value};"),
        *(f"const {line}" for line in one.known()), *functions(one), *looks, "",
        one.of_velocities, f"function {one.rates}({arguments}) {{", *indented(inside), "}", "",
        one.box("start"), f'console.log("{",".join(one.program.heads)}");',
        one.box("loop"), f"for (let {one.row} = 0; {one.row} <= {one.steps}; {one.row}++) {{", *indented(loop), "}",
        one.box("again"), one.box("end"),
    ]  # fmt: skip


def octave(one: Writer) -> Lines:
    """Return the listing in Octave."""
    outs = one.velocities
    arguments = ", ".join([one.t, *one.coordinates])

    def stop(name: str, box: Box) -> Lines:
        return [one.of(box), f"if {name} == 0", f'    error("{name} = 0");', "end"]

    def leave(values: Sequence[str]) -> Lines:
        return [*(f"{name} = {value};" for name, value in zip(outs, values, strict=True)), "return;"]

    limits = limit_lines(one, leave, "if {holds}", "end")
    looks: Lines = []
    if one.program.breaks:
        looks = ["", one.say("breaks"), f"function t = {one.look}(t, after)", f"    for b = [{break_times(one)}]"]
        looks += [
            "        if abs(after - b) <= 1e-13*b",
            "            t = min(t, after*(1 - 1e-13));",
            "        end",
            "    end",
            "end",
        ]
    further = further_slopes(
        one,
        lambda stage: (
            f"[{', '.join(numbered(stage, rate) for rate in outs)}] = {one.rates}({', '.join(one.slope(stage, numbered))});"
        ),
    )
    values = ", ".join([one.t, *one.shown(numbered)])
    form = ",".join(["%.15g"] * len(one.program.heads))
    loop = [
        one.box("time"), f"{one.t} = {one.row}*{one.h};",
        one.box("rates"), f"[{', '.join(outs)}] = {one.rates}({arguments});",
        *one.closed(numbered), one.box("row"), *one.wrapped(f'printf("{form}\\n", {values});'),
        one.box("more"), f"if {one.row} < {one.steps}", *indented([*further, one.box("step"), *one.steps_on(numbered)]), "end",
    ]  # fmt: skip
    shared = f"global {' '.join(one.data)};" if one.data else ""
    return [
        *one.head(), "1;", *functions(one), *looks, "",
        one.of_velocities, f"function [{', '.join(outs)}] = {one.rates}({arguments})",
        *indented([*([shared] if shared else []), *limits, *one.blocks(stop)]), "end", "",
        one.box("data"), *([shared] if shared else []),
        *data_lines(one, lambda name, value: f"{name} = {value};"), *one.known(), "",
        one.box("start"), f'printf("{",".join(one.program.heads)}\\n");',
        one.box("loop"), f"for {one.row} = 0:{one.steps}", *indented(loop), "end", one.box("again"), one.box("end"),
    ]  # fmt: skip
