"""Facts about a whole class: states, points, first wrong rows, misconceptions, and files that are the same.

Enters: finished submissions one by one.  Leaves: `ClassFacts`.  Used by grades.json and the class page.
Only a few numbers are kept of each submission, so that the class of a university fits into memory.
"""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from coursework.grading.marking.rubric import PARTS
from coursework.system.frozen import changing, frozen
from coursework.system.grouped import grouped

# Work of these kinds with all its points is alike by nature, as long as its file is plain text: a file of an office program
# holds times and names of its own.
_ALIKE, _PLAIN = {"table", "equations"}, (".csv", ".txt", ".tsv", ".prn", ".md")
SAME_FILE_KINDS = ("table", "equations", "answers", "variant", "attachment")


@frozen
class Listed:
    """One submission: its state, its points and those of its parts (None without a number).

    `first` are row and column of its first wrong cell, `misconception` is a code, "" if none is named; `reason` says why it has
    no number.
    """

    id: str
    name: str
    variant: str
    page: str
    state: str
    score: float | None
    parts: tuple[float | None, ...]
    first: tuple[int, str] | None
    misconception: str
    reason: str


@changing
class HandedIn:
    """A file by its bytes: its name at first, who handed it in; `is_chosen`: it would not be the same by nature."""

    name: str
    ids: list[str]
    is_chosen: bool = False


@dataclass
class ClassFacts:
    """Everyone in the class, the most points that anyone could have, and the files by their hash."""

    everyone: list[Listed] = field(default_factory=list)
    most: float = 0.0
    files: dict[str, HandedIn] = field(default_factory=dict)

    def add(self, entry: Mapping[str, Any], reason: str = "") -> None:
        """Count one submission, given as grades.json writes it; `reason` says why it has no number."""
        parts = tuple(entry[part].get("score") if entry[part] else None for part in PARTS)
        first, named = entry["first_wrong"], entry["misconception"]
        self.everyone.append(
            Listed(
                entry["id"], entry["name"] or entry["id"], entry["variant"] or "", entry["page"] or "", entry["status"],
                entry["score"], parts, (first["row"], first["column"]) if first else None, named["code"] if named else "", reason,
            )
        )  # fmt: skip
        self.most = max(self.most, float(entry["max"] or 0.0))
        for file in entry["files"]:
            if file["kind"] in SAME_FILE_KINDS and file["bytes"]:
                same = self.files.setdefault(file["sha256"], HandedIn(file["name"], []))
                same.ids.append(entry["id"])
                same.is_chosen |= not _is_simply_right(file, entry)

    @property
    def states(self) -> Counter[str]:
        """Return how many submissions are in each state."""
        return Counter(one.state for one in self.everyone)

    @property
    def scores(self) -> list[float]:
        """Return the points of all submissions with a number."""
        return [one.score for one in self.everyone if one.score is not None]

    @property
    def to_look_at(self) -> list[Listed]:
        """Return the submissions without a number."""
        return [one for one in self.everyone if one.score is None]

    @property
    def by_variant(self) -> dict[str, list[float]]:
        """Return the points of all submissions with a number, by variant."""
        return grouped((one.variant, one.score) for one in self.everyone if one.score is not None)

    @property
    def misconceptions(self) -> dict[str, list[str]]:
        """Return the ids by the code of their misconception."""
        return grouped((one.misconception, one.id) for one in self.everyone if one.misconception)

    @property
    def other_data(self) -> list[tuple[str, str]]:
        """Return the ids of those who worked with the data of another variant, and its name."""
        return [
            (one.id, name) for one in self.everyone if (name := one.misconception.removeprefix("variant_")) != one.misconception
        ]

    @property
    def first_rows(self) -> Counter[int]:
        """Return how many submissions have their first wrong cell in each row."""
        return Counter(one.first[0] for one in self.everyone if one.first)

    @property
    def first_columns(self) -> Counter[str]:
        """Return how many submissions have their first wrong cell in each column."""
        return Counter(one.first[1] for one in self.everyone if one.first)

    @property
    def same_files(self) -> list[list[str]]:
        """Return groups of ids that handed in the same bytes, each group once."""
        return [list(group) for group in sorted(_shared(self.files.values()))]

    @property
    def shared(self) -> dict[tuple[str, ...], list[str]]:
        """Return for each group of ids the names of the files that they share, except those that are simply right."""
        return _shared(file for file in self.files.values() if file.is_chosen)

    def plain(self) -> dict[str, Any]:
        """Return the facts as grades.json writes them under `class`; the hardest column has most of the first wrong cells."""
        scores, columns = self.scores, self.first_columns
        return {
            "graded": len(scores),
            "mean": round(statistics.fmean(scores), 2) if scores else None,
            "median": round(statistics.median(scores), 2) if scores else None,
            "misconceptions": {code: len(ids) for code, ids in sorted(self.misconceptions.items())},
            "first_wrong_rows": {str(row): number for row, number in sorted(self.first_rows.items())},
            "hardest_column": min(columns, key=lambda name: (-columns[name], name), default=None),
            "same_files": self.same_files,
        }


def _shared(files: Iterable[HandedIn]) -> dict[tuple[str, ...], list[str]]:
    """Return the names of the files that several people handed in, by their ids."""
    return grouped((tuple(sorted(ids)), file.name) for file in files if len(ids := {*file.ids}) > 1)


def _is_simply_right(file: Mapping[str, Any], entry: Mapping[str, Any]) -> bool:
    """Return whether a file holds nothing but work with all its points, as whoever works right would hand in."""
    kinds = {*file.get("kinds", (file["kind"],))}
    if not kinds <= _ALIKE or not file["name"].casefold().endswith(_PLAIN):
        return False
    parts = [entry[kind] for kind in kinds]
    return all(part and part["score"] is not None and part["score"] == part["max"] for part in parts)
