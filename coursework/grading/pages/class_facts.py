"""Facts about a whole class: states, points, first wrong rows, misconceptions, and files that are the same.

Enters: finished submissions one by one.  Leaves: `ClassFacts`.  Used by grades.json and the class page.
Only a few numbers are kept of each submission, so that the class of a university fits into memory.
"""

from __future__ import annotations

import statistics
from collections import Counter, defaultdict
from collections.abc import Container, Mapping
from dataclasses import dataclass, field
from typing import Any

from coursework.grading.marking.rubric import PARTS

# Work of these kinds with all its points is alike by nature, as long as its file is plain text: a file of an office program
# holds times and names of its own.
_ALIKE, _PLAIN = {"table", "equations"}, (".csv", ".txt", ".tsv", ".prn", ".md")
SAME_FILE_KINDS = ("table", "equations", "answers", "variant", "attachment")


@dataclass
class ClassFacts:
    """Counts over the class; `names` and `pages` by id; `everyone` lists (id, state, points, points of the parts, first wrong
    cell).
    """

    states: Counter[str] = field(default_factory=Counter)
    scores: list[float] = field(default_factory=list)
    most: float = 0.0
    misconceptions: dict[str, list[str]] = field(default_factory=lambda: defaultdict(list))
    first_rows: Counter[int] = field(default_factory=Counter)
    first_columns: Counter[str] = field(default_factory=Counter)
    by_variant: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    files: dict[str, list[str]] = field(default_factory=lambda: defaultdict(list))
    other_data: list[tuple[str, str]] = field(default_factory=list)
    to_look_at: list[tuple[str, str, str]] = field(default_factory=list)
    names: dict[str, str] = field(default_factory=dict)
    variants: dict[str, None] = field(default_factory=dict)
    pages: dict[str, str] = field(default_factory=dict)
    everyone: list[tuple[str, str, float | None, tuple[float | None, ...], str]] = field(default_factory=list)
    file_names: dict[str, str] = field(default_factory=dict)
    chosen: set[str] = field(default_factory=set)  # files that would not be the same by nature

    def add(self, entry: Mapping[str, Any], reason: str = "") -> None:
        """Count one submission, given as grades.json writes it; `reason` says why it has no number."""
        self.states[entry["status"]] += 1
        if entry["variant"]:
            self.variants[entry["variant"]] = None
        self.names[entry["id"]] = entry["name"] or entry["id"]
        if entry["page"]:
            self.pages[entry["id"]] = entry["page"]
        parts = tuple(entry[part].get("score") if entry[part] else None for part in PARTS)
        self.everyone.append((entry["id"], entry["status"], entry["score"], parts, entry["table"]["first_wrong"] or ""))
        self.most = max(self.most, float(entry["max"] or 0.0))
        if entry["score"] is not None:
            self.scores.append(entry["score"])
            self.by_variant[entry["variant"]].append(entry["score"])
        else:
            self.to_look_at.append((entry["id"], entry["status"], reason))
        if named := entry["misconception"]:
            self.misconceptions[named["code"]].append(entry["id"])
            if named["code"].startswith("variant_"):
                self.other_data.append((entry["id"], named["code"].removeprefix("variant_")))
        if first := entry["first_wrong"]:
            self.first_rows[first["row"]] += 1
            self.first_columns[first["column"]] += 1
        for file in entry["files"]:
            if file["kind"] in SAME_FILE_KINDS and file["bytes"]:
                self.files[file["sha256"]].append(entry["id"])
                self.file_names.setdefault(file["sha256"], file["name"])
                if not _is_simply_right(file, entry):
                    self.chosen.add(file["sha256"])

    @property
    def same_files(self) -> list[list[str]]:
        """Return groups of ids that handed in the same bytes, each group once."""
        return [list(group) for group in sorted(self._shared(self.files))]

    @property
    def shared(self) -> dict[tuple[str, ...], list[str]]:
        """Return for each group of ids the names of the files that they share, except those that are simply right."""
        return self._shared(self.chosen)

    def _shared(self, among: Container[str]) -> dict[tuple[str, ...], list[str]]:
        groups: dict[tuple[str, ...], list[str]] = {}
        for sha256, ids in self.files.items():
            if len(set(ids)) > 1 and sha256 in among:
                groups.setdefault(tuple(sorted(set(ids))), []).append(self.file_names[sha256])
        return groups

    @property
    def hardest_column(self) -> str | None:
        """Return the column with the most first wrong cells, by name if several have as many; None if no cell is wrong."""
        return min(self.first_columns, key=lambda name: (-self.first_columns[name], name)) if self.first_columns else None

    def plain(self) -> dict[str, Any]:
        """Return the facts as grades.json writes them under `class`."""
        return {
            "graded": len(self.scores),
            "mean": round(statistics.fmean(self.scores), 2) if self.scores else None,
            "median": round(statistics.median(self.scores), 2) if self.scores else None,
            "misconceptions": {code: len(ids) for code, ids in sorted(self.misconceptions.items())},
            "first_wrong_rows": {str(row): self.first_rows[row] for row in sorted(self.first_rows)},
            "hardest_column": self.hardest_column,
            "same_files": self.same_files,
        }


def _is_simply_right(file: Mapping[str, Any], entry: Mapping[str, Any]) -> bool:
    """Return whether a file holds nothing but work with all its points, as whoever works right would hand in."""
    kinds = {*file.get("kinds", (file["kind"],))}
    if not kinds <= _ALIKE or not file["name"].casefold().endswith(_PLAIN):
        return False
    parts = [entry[kind] for kind in kinds]
    return all(part and part["score"] is not None and part["score"] == part["max"] for part in parts)
