"""Listings in Python, JavaScript and Octave: what stands round the lines that all languages have in common.

Enters: a `Writer`.  Leaves: the lines of a listing.  Used by `listings.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from coursework.takeaway.listing.round_about import Lines, by_printf, data_lines, limit_lines, listed, numbered, row_by_row
from coursework.takeaway.listing.tables import functions
from coursework.takeaway.listing.writer import Writer, indented


def python(one: Writer) -> Lines:
    """Return the listing in Python."""
    outs = one.velocities

    def several(names: Sequence[str]) -> str:
        return ", ".join(names) + ("," if len(names) == 1 else "")

    def call(stage: int) -> str:
        return f"{several([numbered(stage, rate) for rate in outs])} = {one.rates}({', '.join(one.slope(stage, numbered))})"

    limits = limit_lines(one, lambda values: [f"return {several(values)}"], "if {holds}:")
    calls = sorted(one.program.calls & {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "sqrt"})
    return [
        *one.head(), *([f"from math import {', '.join(calls)}"] if calls else []), "",
        one.box("data"), *data_lines(one, lambda name, value: f"{name} = {value}"), *one.known(),
        *functions(one), "",
        one.of_velocities, f"def {one.rates}({', '.join([one.t, *one.coordinates])}):",
        *indented([*limits, *one.blocks(), f"return {several(outs)}"]), "",
        one.box("start"),
        *row_by_row(one, call, lambda values: f'print(",".join(f"{{x:.15g}}" for x in [{", ".join(values)}]))'),
    ]  # fmt: skip


def javascript(one: Writer) -> Lines:
    """Return the listing in JavaScript."""
    outs = one.velocities

    def show(values: Sequence[str]) -> str:
        return f'console.log([{", ".join(values)}].map((x) => Number(x.toPrecision(15))).join(","));'

    limits = limit_lines(one, lambda values: [f"return [{', '.join(values)}];"], "if ({holds})")
    inside = [*one.wrapped(f"let {', '.join([*one.locals, *outs])};"), *limits, *one.blocks(), f"return [{', '.join(outs)}];"]
    return [
        *one.head(), "", one.box("data"), *data_lines(one, lambda name, value: f"let {name} = {value};"),
        *(f"const {line}" for line in one.known()), *functions(one), "",
        one.of_velocities, f"function {one.rates}({', '.join([one.t, *one.coordinates])}) {{", *indented(inside), "}", "",
        one.box("start"), *row_by_row(one, partial(listed, one), show),
    ]  # fmt: skip


def octave(one: Writer) -> Lines:
    """Return the listing in Octave."""
    outs = one.velocities

    def leave(values: Sequence[str]) -> Lines:
        return [*(f"{name} = {value};" for name, value in zip(outs, values, strict=True)), "return;"]

    limits = limit_lines(one, leave, "if {holds}", "end")
    shared = [f"global {' '.join(one.data)};"] if one.data else []
    return [
        *one.head(), "1;", *functions(one), "",
        one.of_velocities, f"function [{', '.join(outs)}] = {one.rates}({', '.join([one.t, *one.coordinates])})",
        *indented([*shared, *limits, *one.blocks()]), "end", "",
        one.box("data"), *shared, *data_lines(one, lambda name, value: f"{name} = {value};"), *one.known(), "",
        one.box("start"), *row_by_row(one, partial(listed, one), by_printf),
    ]  # fmt: skip
