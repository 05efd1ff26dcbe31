"""A class with its individual variants -> the page that shows the spread of data and difficulty.

Enters: `Handout`s and the assignment they come from.  Leaves: HTML without script.  Used by `assign.py`.
"""

from __future__ import annotations

import statistics
from collections.abc import Sequence

from coursework.assigning.accept import Accepted
from coursework.assigning.handout import Handout, difficulty_text
from coursework.assigning.page_words import Plain, symbol_runs
from coursework.assigning.ranges import MEASURES, Range
from coursework.assigning.variants import Assignment
from coursework.report.graphs.strips import strip
from coursework.report.text.words import Words
from coursework.system.grouped import grouped
from coursework.variant.formula.units import read
from coursework.words.stylesheets import fitted
from coursework.words.templates import clean, filled

LONGEST = 120


def class_page(handouts: Sequence[Handout], assignment: Assignment, seed: str, words: Words) -> str:
    """Return the page of a class that has at least one student."""
    accepted = [handout.individual.accepted for handout in handouts]
    centre = assignment.acceptance.centre
    draws = [one.attempt + 1 for one in accepted]
    refused = [words(f"assign.refused.{reason}", number=number) for reason, number in sorted(centre.refused.items())]
    ranges = assignment.ranges.ranges
    summary = words.phrases.said(
        "assigned.summary", count=len(handouts), template=clean(assignment.template.name, LONGEST), seed=clean(seed, LONGEST),
        drawn=centre.drawn, feasible=centre.feasible, mean=statistics.fmean(draws), most=max(draws),
    )  # fmt: skip
    return fitted(filled("assigned.html.j2", words=words, language=words.phrases.language, summary=summary,
        refused=words("assigned.refused", reasons=words("join.numbers").join(refused)) if refused else "",
        difficulty=[_measure(name, accepted, assignment, words) for name in MEASURES],
        data=[_datum(one, accepted, assignment, words) for one in ranges if one.count > 1],
        columns=[_column(one, accepted, assignment, words) for one in ranges],
        measures=[(words(f"assigned.{name}"), words.unit(MEASURES[name])) for name in MEASURES],
        students=[_student(handout, words) for handout in handouts],
        same=[words("join.comma").join(group) for group in _equal(accepted)],
    ))  # fmt: skip


def _measure(name: str, accepted: Sequence[Accepted], assignment: Assignment, words: Words) -> Plain:
    """Return the strip of one measure of difficulty; without a band, it shows the range of the values instead."""
    values = [one.numbers[name] for one in accepted]
    centre = assignment.acceptance.centre.numbers[name]
    banded = name in assignment.ranges.difficulty.numbers
    low, high = assignment.acceptance.band(name) if banded else (min(values), max(values))
    reach = (min(low, centre, *values), max(high, centre, *values))
    ends = tuple(words.amount(words.numbers.scalar(value), MEASURES[name]) for value in reach)
    return {
        "title": words(f"assigned.{name}"),
        "strip": strip(values, low, high, centre, (ends[0], ends[1]), words.numbers.scalar(centre)),
    }


def _datum(one: Range, accepted: Sequence[Accepted], assignment: Assignment, words: Words) -> Plain:
    """Return the strip of one drawn datum within its range."""
    values = [read(each.values[one.path]).value for each in accepted]
    every = sorted((read(text).value, text) for text in one.ends)
    (low, first), (high, last) = every[0], every[-1]
    ends, middle = (_dressed(first, words), _dressed(last, words)), (low + high) / 2
    told = strip(values, low, high, middle, ends, words.numbers.limit(middle))
    return {"symbol": _head(one, assignment, words), "strip": told}


def _head(one: Range, assignment: Assignment, words: Words) -> list[dict[str, str]]:
    return [{"t": words("assigned.row")}] if one.path[0] == "time" else symbol_runs(assignment.template, one.name)


def _dressed(text: str, words: Words) -> str:
    quantity = read(text)
    return words.amount(words.numbers.dressed(quantity.text), quantity.unit)


def _column(one: Range, accepted: Sequence[Accepted], assignment: Assignment, words: Words) -> Plain:
    """Return the column of one datum; its unit stands at the head if all values have the same unit."""
    texts = [each.values[one.path] for each in accepted]
    units = {read(text).unit for text in texts}
    unit = units.pop() if len(units) == 1 else ""
    cells = [_dressed(read(text).text if unit else text, words) for text in texts]
    return {"symbol": _head(one, assignment, words), "unit": words.unit(unit), "cells": cells}


def _student(handout: Handout, words: Words) -> Plain:
    accepted = handout.individual.accepted
    return {
        "id": clean(handout.student.id, LONGEST),
        "name": clean(handout.student.name, LONGEST),
        "file": handout.stem,
        "decimals": handout.least_decimals,
        "numbers": [difficulty_text(accepted.numbers[name]).replace(".", words("decimal")) for name in MEASURES],
    }


def _equal(accepted: Sequence[Accepted]) -> list[list[str]]:
    """Return the groups of students who have the same data."""
    data = [tuple(text for path, text in sorted(one.values.items()) if path[0] != "time") for one in accepted]
    alike = grouped((texts, clean(one.id, LONGEST)) for texts, one in zip(data, accepted, strict=True))
    return [students for students in alike.values() if len(students) > 1]
