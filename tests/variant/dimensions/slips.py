"""Slips made on purpose in good files: a unit exchanged for one of another dimension, a name left out of a product.

Enters: the text of a variant file.  Leaves: spoilt texts with what was done.  Used by `test_slips.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from coursework.variant.record.variant import Variant

# What a hurried hand writes instead: two units of other dimensions for each.
OTHERS = {
    "m": ("m/s", "rad"), "rad": ("m", "rad/s"), "s": ("m", "1/s"), "1/s": ("s", "m/s"), "m/s": ("m", "rpm"),
    "m/s^2": ("m/s", "m"), "1/s^2": ("1/s", "m/s^2"), "N": ("kg", "N*m"),
    "kg": ("m", "N"), "N*m": ("N", "m"), "N*s/m": ("N", "N*m"), "N*m*s": ("N*m", "N"),
}  # fmt: skip


@dataclass(frozen=True)
class Slip:
    """A spoilt file: `name` is the datum or the name left out, `line` where, `what` was done."""

    text: str
    name: str
    line: int
    what: str


def exchanged_units(text: str, variant: Variant) -> Iterator[Slip]:
    """Yield the file with each unit of [given] and of each start exchanged, one at a time."""
    si = {given.name: given.si for given in variant.given} | {c.name: c.unit for c in variant.coordinates}
    lines = text.split("\n")
    section = ""
    for number, line in enumerate(lines, start=1):
        if header := re.match(r"\[+(\w+)", line):
            section = header[1]
        pattern = {
            "given": r'(\w+)\s*=\s*(?:\{ value = )?"([-+\d.e]+) ([^"]+)"',
            "coordinates": r'(\w+)\s*=\s*\{\s*start\s*=\s*"([-+\d.e]+) ([^"]+)"',
        }
        found = re.match(pattern[section], line) if section in pattern else None
        for other in OTHERS[si[found[1]]] if found else ():
            assert found is not None
            spoilt = line[: found.start(3)] + other + line[found.end(3) :]
            yield Slip("\n".join([*lines[: number - 1], spoilt, *lines[number:]]), found[1], number, f"{found[3]} -> {other}")


def names_left_out(text: str) -> Iterator[Slip]:
    """Yield the file with one name left out of a product of a constraint, one at a time; plain ratios stay."""
    lines = text.split("\n")
    ratios = {found[1] for line in lines if (found := re.match(r'(\w+)\s*=\s*(?:\{ value = )?"?[-\d.]+"?\s*(?:[#,]|$)', line))}
    for number, line in enumerate(lines, start=1):
        found = re.match(r'(equation|closure)\s*=\s*"([^"]*)"', line)
        if not found:
            continue
        formula = found[2]
        for factor in re.finditer(r"(?<![\w.)])([A-Za-z]\w*)\*|[*/]([A-Za-z]\w*)(?![\w(.])", formula):
            if (factor[1] or factor[2]) in ratios:
                continue
            shorter = formula[: factor.start()] + formula[factor.end() :]
            spoilt = line.replace(formula, shorter)
            yield Slip("\n".join([*lines[: number - 1], spoilt, *lines[number:]]), factor[1] or factor[2], number, shorter)
