"""Drawn data -> the variant of a student: its file, and the variant read from that file.

Enters: the template, the accepted data of a student.  Leaves: `Individual`.
Used through `import coursework`, and for a whole class by `assign.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

from coursework.assigning.accept import Acceptance, Accepted
from coursework.assigning.ranges import Lots, Ranges
from coursework.assigning.reader import ranges_file, ranges_of, read_ranges
from coursework.grading.marking.decimals import decimals_accepted
from coursework.grading.marking.key.key import key_to_mark_by
from coursework.grading.platforms.names import file_stem
from coursework.motion.schemes import DEFAULT_SCHEME
from coursework.motion.settings import Settings, scheme_for
from coursework.scene.model.model import Model, compile_model
from coursework.scene.model.variant_text import variant_text
from coursework.system.frozen import frozen
from coursework.variant.catalogue import load
from coursework.variant.reading.reader import parse_variant
from coursework.variant.record.changes import followers
from coursework.variant.record.variant import Variant
from coursework.variant.toml.positions import KeyPath
from coursework.variant.toml.rewriting import SAID_OF_NUMBERS, rewritten
from coursework.words.data_folders import folder
from coursework.words.errors import CourseworkError, Fault, InputError
from coursework.words.reasons import reason_of
from coursework.words.sentences import say

FOLDER = "ranges"  # the folder within the catalogue


@frozen
class Individual:
    """One student's variant: the accepted data, the bytes of the file, and the variant read from them."""

    accepted: Accepted
    content: bytes
    variant: Variant


class Assignment:
    """A template with its ranges and a seed, ready to give variants to students in any order."""

    def __init__(self, template: Variant, ranges: Ranges, seed: str | int) -> None:
        if template.path is None:
            raise InputError(say("fault.A003", name=template.name))
        if template.motor is not None:
            line = template.nearest_line("motor")
            raise InputError([Fault(say("fault.A032"), template.file, line)])
        self.original = template.path.read_text(encoding="utf-8-sig")
        beside = template.path.parent
        self.tables = {law.file: (beside / law.file).read_bytes() for law in template.laws if law.file}
        self.template, self.ranges = template, ranges
        self.model: Model = compile_model(template)
        self.acceptance = Acceptance(self.model, Lots(template, ranges, str(seed)))

    def individuals(self, students: Iterable[str], done: Callable[[int], None] = lambda number: None) -> list[Individual]:
        """Return the variant of each student.  Raises `InputError` if the ranges leave a student without one."""
        return [self.individual(accepted) for accepted in self.acceptance.accepted(students, done)]

    def individual(self, accepted: Accepted) -> Individual:
        """Return the variant with the accepted data: the template's file with these values, read again."""
        if followers(self.template):
            given = {path[1]: text for path, text in accepted.values.items() if path[0] == "given"}
            start = {path[1]: text for path, text in accepted.values.items() if path[0] == "coordinates"}
            variant = self.template.with_data(given, start, check_row=accepted.check_row)
            content = variant_text(variant, self.original, self._scheme).encode("utf-8")
        else:  # no start follows from the data, so they need not be read twice
            changes: dict[KeyPath, Any] = {path: text for path, text in accepted.values.items() if path[0] != "time"}
            if accepted.check_row is not None:
                changes["time", "check_row"] = accepted.check_row
            content = rewritten(self.original, changes, SAID_OF_NUMBERS).encode("utf-8")
        return Individual(accepted, content, parse_variant(content, file_stem(accepted.id), tables=self.tables))

    @cached_property
    def accepted_decimals(self) -> int:
        """Return the least number of decimals with which everyone's table is marked, from the template."""
        try:
            gap = key_to_mark_by(self.template).gap
        except CourseworkError:  # a template that cannot move itself; the median over the pilot draws stands for it
            gap = self.acceptance.centre.numbers["one_step_gap"]
        return decimals_accepted(gap)

    @property
    def settings(self) -> Settings:
        """Return the settings with which the tables of the class are made."""
        return Settings(DEFAULT_SCHEME.name)

    @property
    def _scheme(self) -> str:
        """Return the scheme that each file must name so that a run makes the marked table; "" if it is used without that."""
        own = scheme_for(self.template)
        return "" if own == DEFAULT_SCHEME.name else DEFAULT_SCHEME.name


def draw(template: Variant | str | Path, ranges: Ranges | Mapping[str, Any] | str | Path, seed: str | int, id: str) -> Variant:
    """Return the variant that a student is given: the same one whoever else is in the class.

    `ranges`: a ranges file, the name of a template in the catalogue, or plain data of the same form.  Raises `InputError` for
    ranges with faults, and, with a count of each reason, if they leave too few mechanisms.

    >>> import coursework
    >>> variant = coursework.draw("31", "31", seed=2026, id="ada")
    >>> coursework.feasible(variant).possible, variant.values["r1"] != 0.953
    (True, True)
    """
    return draw_many(template, ranges, seed, [id])[0]


def draw_many(
    template: Variant | str | Path, ranges: Ranges | Mapping[str, Any] | str | Path, seed: str | int, ids: Iterable[str]
) -> list[Variant]:  # fmt: skip
    """Return the variants of several students, each the same as `draw` gives.

    >>> import coursework
    >>> one, other = coursework.draw_many("31", "31", 2026, ["ada", "bert"])
    >>> one.values == coursework.draw("31", "31", 2026, "ada").values
    True
    """
    chosen = load(template) if isinstance(template, (str, Path)) else template
    return [one.variant for one in Assignment(chosen, load_ranges(ranges, chosen), seed).individuals(ids)]


def load_ranges(ranges: Ranges | Mapping[str, Any] | str | Path, template: Variant) -> Ranges:
    """Return ranges from a file, from the catalogue by the template's name, or from plain data.  Raises `InputError`."""
    if isinstance(ranges, Ranges):
        return ranges
    if isinstance(ranges, Mapping):
        return ranges_of(ranges, template)
    path = ranges_file(ranges, folder("variants") / FOLDER)
    return read_ranges(read_file(path), str(path), template)


def read_file(path: Path) -> bytes:
    """Return the bytes of a file named by the instructor.  Raises `InputError`."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError(say("fault.A002", file=str(path), why=reason_of(error))) from error
