"""What a child needs to grade one submission, as plain data that crosses to another process or machine.

Enters: variants, rubric, options.  Leaves: `Setup`, `Task`, `Outcome`.  Used by the child, the supervisor and the cluster.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from functools import cached_property
from typing import Any

import coursework
from coursework.grading.submission import Submission, submission_from

# Raised whenever marks may come out otherwise: a second run then grades everything anew.
GRADING_VERSION = 1


@dataclass(frozen=True)
class VariantSource:
    """A variant as bytes: its file, its side tables, its name; a child never looks at the disk for it."""

    name: str
    content: bytes
    tables: Mapping[str, bytes] = field(default_factory=dict)

    @cached_property
    def sha256(self) -> str:
        """Return the hash of all bytes."""
        digest = hashlib.sha256(self.content)
        for name in sorted(self.tables):
            digest.update(name.encode() + b"\0" + self.tables[name])
        return digest.hexdigest()

    def plain(self) -> dict[str, Any]:
        """Return the source as JSON can carry it."""
        tables = {name: base64.b64encode(content).decode("ascii") for name, content in self.tables.items()}
        return {"name": self.name, "content": base64.b64encode(self.content).decode("ascii"), "tables": tables}


def source_from(plain: Mapping[str, Any]) -> VariantSource:
    """Return the source that `plain()` wrote."""
    tables = {name: base64.b64decode(content) for name, content in plain["tables"].items()}
    return VariantSource(plain["name"], base64.b64decode(plain["content"]), tables)


@dataclass(frozen=True)
class Setup:
    """What holds for a whole batch: the rubric's text, whether pages are wanted, Euler's tables of the class's variants."""

    rubric: str = ""
    pages: bool = True
    class_tables: Mapping[str, list[list[float]]] = field(default_factory=dict)
    memory_mib: int = 1024

    @cached_property
    def fingerprint(self) -> str:
        """Return the hash of what changes marks: the rubric, the variants of the class, the version."""
        tables = json.dumps(self.class_tables, sort_keys=True)
        parts = [self.rubric, str(GRADING_VERSION), coursework.__version__, tables]
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()

    def plain(self) -> dict[str, Any]:
        """Return the setup as JSON can carry it."""
        return {
            "rubric": self.rubric, "pages": self.pages, "memory_mib": self.memory_mib,
            "class_tables": dict(self.class_tables),
        }  # fmt: skip


def setup_from(plain: Mapping[str, Any]) -> Setup:
    """Return the setup that `plain()` wrote."""
    return Setup(plain["rubric"], plain["pages"], plain["class_tables"], plain["memory_mib"])


@dataclass(frozen=True, slots=True)
class Task:
    """One submission and the variant it is graded by."""

    submission: Submission
    variant: VariantSource

    def line(self) -> bytes:
        """Return the task as one line of JSON."""
        plain = {"submission": self.submission.plain(), "variant": self.variant.plain()}
        return json.dumps(plain, ensure_ascii=True, separators=(",", ":")).encode("ascii") + b"\n"

    def key(self, setup: Setup) -> str:
        """Return the content a journal knows this work by: files, variant, rubric, version; never a path or a clock."""
        digest = hashlib.sha256(setup.fingerprint.encode())
        digest.update(self.variant.sha256.encode())
        digest.update(json.dumps(self.submission.plain(), sort_keys=True).encode())
        return digest.hexdigest()


def task_from(line: bytes) -> Task:
    """Return the task of a line."""
    plain = json.loads(line)
    return Task(submission_from(plain["submission"]), source_from(plain["variant"]))


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of one submission: `grade` as grades.json says it, and its page ("" where none was asked for)."""

    id: str
    grade: dict[str, Any]
    page: str = ""

    def line(self) -> bytes:
        """Return the outcome as one line of JSON."""
        return json.dumps(asdict(self), ensure_ascii=True, separators=(",", ":"), allow_nan=False).encode("ascii") + b"\n"


def outcome_from(line: bytes) -> Outcome:
    """Return the outcome of a line.  Raises `ValueError` where a line is torn."""
    plain = json.loads(line)
    if not isinstance(plain, dict) or set(plain) != {"id", "grade", "page"}:
        raise ValueError("not an outcome")
    return Outcome(plain["id"], plain["grade"], plain["page"])
