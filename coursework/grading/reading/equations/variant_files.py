"""A variant file that a student handed in -> its equations, and its data that differ from the assigned ones.

Enters: the bytes of a TOML file, the assigned variant.  Leaves: `VariantFile`.  Data are compared and listed, never used.
Used by `read_submission.py`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

from coursework.grading.reading.equations.formulas.equations import names_for, names_in, strictly
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.student_work import EquationLine
from coursework.system.frozen import frozen
from coursework.variant import catalogue
from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.reader import MAX_CHARACTERS
from coursework.variant.formula.tree import Formula
from coursework.variant.formula.units import UnitFault, read
from coursework.variant.reading.schema import Constraint
from coursework.variant.reading.schema import VariantFile as Schema
from coursework.variant.toml.source import MAX_BYTES, Source, read_source
from coursework.words.errors import Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import closest, say

_ITS_OWN = re.compile(r"^[ \t]*(?:format[ \t]*=|\[coordinates\])", re.MULTILINE)  # every variant has coordinates
_SAME = 1e-9
_KEYS_OF_CONSTRAINT = tuple(Constraint.keys())


@frozen
class VariantFile:
    """The content of a variant file: equations, names of differing data, unknown keys, and why a person must look (or None)."""

    lines: tuple[EquationLine, ...]
    differing: tuple[str, ...] = ()
    unknown_keys: tuple[str, ...] = ()
    review: Sentence | None = None


def is_variant_file(text: str) -> bool:
    """Return whether a text looks like a variant file."""
    return _ITS_OWN.search(text[: 4 * MAX_BYTES]) is not None


def read_variant_file(content: bytes, name: str, expected: Expected) -> VariantFile:
    """Return the content of a variant file; one that is not valid TOML counts as one unreadable equation, for a person."""
    try:
        source = read_source(content, name, {})
    except InputError as error:
        fault = error.faults[0]
        line = max(fault.line, 1)  # some faults are those of the file as a whole
        text = "".join(content.decode("utf-8", errors="replace").split("\n")[line - 1 : line])[:MAX_CHARACTERS]
        return VariantFile((EquationLine(name, line, text, fault=fault, relates=True),))
    known = Schema.keys().keys()
    unknown = tuple(str(key)[:40] for key in source.data if key not in known)
    differing = _differing(source.data, expected)
    lines = tuple(_constraints(source, name, expected))
    return VariantFile(lines, differing, unknown, _other_variant(source.data, differing, expected))


def _differing(data: dict[str, Any], expected: Expected) -> tuple[str, ...]:
    """Return the names of the data and start values that differ from the assigned ones."""
    variant = expected.variant
    given = {spell(str(key)): value for key, value in _section(data, "given").items()}
    found = [entry.name for entry in variant.given if entry.name in given and _differs(given[entry.name], entry.value)]
    starts = {spell(str(key)): value for key, value in _section(data, "coordinates").items()}
    for coordinate in variant.coordinates:
        entry = starts.get(coordinate.name)
        start = entry.get("start") if isinstance(entry, dict) else None
        if coordinate.start is not None and start is not None and _differs(start, coordinate.start):
            found.append(coordinate.name)
    return tuple(found)


def _section(data: dict[str, Any], name: str) -> dict[str, Any]:
    section = data.get(name)
    return section if isinstance(section, dict) else {}


def _differs(value: object, assigned: float) -> bool:
    if not isinstance(value, (str, int, float)):
        return True
    try:
        return abs(read(value).value - assigned) > _SAME * max(abs(assigned), 1e-6)
    except (UnitFault, ValueError, OverflowError):
        return True


def _other_variant(data: dict[str, Any], differing: tuple[str, ...], expected: Expected) -> Sentence | None:
    """Return why a person must look if the title is that of another variant of the catalogue, None if it is not."""
    title = data.get("title")
    if not differing and set(map(spell, _section(data, "coordinates"))) == {entry.name for entry in expected.variant.coordinates}:
        return None
    if not isinstance(title, str) or not title or title == expected.variant.title:
        return None
    named = _catalogue().get(title)
    return say("reading.review.other_variant", submitted=named, assigned=expected.variant.name) if named else None


@cache
def _catalogue() -> dict[str, str]:
    """Return the names of the catalogue's variants, by their titles."""
    return {entry.title: entry.name for entry in catalogue.entries() if entry.title}


def _constraints(source: Source, file: str, expected: Expected) -> list[EquationLine]:
    """Return the equations of a variant file; variant files are read strictly, without repair."""
    entries = source.data.get("constraint")
    names = names_for(expected)
    lines: list[EquationLine] = []
    for place, entry in enumerate(entries if isinstance(entries, list) else []):
        if not isinstance(entry, dict):
            continue
        key = next((one for one in ("equation", "closure") if one in entry), None) or _misspelt(entry)
        text = entry.get(key)
        line = source.positions.find(("constraint", place, key))[0]
        if not isinstance(text, str):
            continue
        if key not in _KEYS_OF_CONSTRAINT:
            read: Formula | Fault = Fault(
                say("fault.G067", key_=key[:40], hint=closest(key, _KEYS_OF_CONSTRAINT), known=_KEYS_OF_CONSTRAINT)
            )
        else:
            read = Fault(say("fault.G062")) if key == "closure" else strictly(text, names)
        if isinstance(read, Fault):
            fault = Fault(read.message, file, line, read.column)
            asks = key != "closure" and len(names_in(text, names.spellings)) > 1
            lines.append(EquationLine(file, line, text[:MAX_CHARACTERS], fault=fault, relates=asks))
        else:
            lines.append(EquationLine(file, line, text, read))
    return lines


def _misspelt(entry: Mapping[str, object]) -> str:
    """Return the unknown key under which a constraint has its equation, "" if there is none."""
    return next(
        (key for key, text in entry.items() if key not in _KEYS_OF_CONSTRAINT and isinstance(text, str) and "=" in text), ""
    )
