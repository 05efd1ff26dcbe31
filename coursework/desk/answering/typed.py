"""A typed text -> its variant and its run, or its faults with their places.

Enters: the body of a request.  Leaves: `Desk`, which reads the variant once; faults as the browser shows them.
Used by `bench.py` and the modules beside it.
"""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Any

from coursework.api import make_run, step_of, variant_in
from coursework.desk.answering.mends import appended, mends_of
from coursework.desk.inside import TablesOf
from coursework.desk.job import Setup, fault_entry
from coursework.motion.schemes import DEFAULT_SCHEME, SCHEMES
from coursework.motion.settings import scheme_for
from coursework.run import Run
from coursework.variant.reading.tables import MAX_TABLE_BYTES
from coursework.variant.record.variant import Variant
from coursework.variant.record.vocabulary import EXACT
from coursework.words.data_folders import folder
from coursework.words.errors import MOST_SHOWN, CourseworkError, Fault, InputError
from coursework.words.sentence import Sentence
from coursework.words.sentences import Phrases, load_phrases, say

UNNAMED = "variant"
DEAR = {"E001": "desk.over_time", "E002": "desk.over_memory"}


class Desk:
    """One text and the request about it; `body` is that of the request."""

    def __init__(self, body: dict[str, Any], language: str, setup: Setup) -> None:
        self.body, self.language, self.setup = body, language, setup
        self.text: str = str(body.get("text") or "").removeprefix("\ufeff").replace("\r\n", "\n")
        self.name: str = str(body.get("name") or UNNAMED)

    @property
    def words(self) -> Phrases:
        """Return the words of the language of the request."""
        return load_phrases(self.language)

    @cached_property
    def tables(self) -> TablesOf:
        """Return the tables that the text may name: those sent with it, those of the folder, those of the catalogue."""
        sent = {name: str(text).encode("utf-8") for name, text in (self.body.get("tables") or {}).items()}
        own = (Path(self.setup.folder),) if self.setup.folder else ()
        return TablesOf(sent, (*own, folder("variants")), MAX_TABLE_BYTES)

    @cached_property
    def variant(self) -> Variant:
        """Return the variant.  Raises `InputError` with every fault of the text."""
        return variant_in(self.text, self.name, self.tables)

    @cached_property
    def run(self) -> Run:
        """Return the run with the scheme and step of the request, as far as the policy allows.  Raises `InputError`."""
        scheme = str(self.body["scheme"]) if self.body.get("scheme") else None
        if not self.setup.policy.exact and scheme_for(self.variant, scheme) not in SCHEMES:
            if scheme == EXACT:
                raise InputError(say("fault.C087", what=EXACT))
            scheme = DEFAULT_SCHEME.name
        return make_run(self.variant, scheme, self.step)

    def unchanged(self, why: Sentence | str) -> dict[str, Any]:
        """Return the answer that leaves the text as it is, and says why."""
        return {"text": self.text, "ranges": [], "sentence": self.words.written(why)}

    @property
    def step(self) -> float | None:
        """Return the step of the request (s), None for that of the file.  Raises `InputError`."""
        return step_of(str(self.body["step"]), self.variant) if self.body.get("step") else None


def faults_of(error: CourseworkError, desk: Desk) -> list[dict[str, Any]]:
    """Return the faults of a text, each with its place in it (None for a fault elsewhere) and the change that mends it."""
    lines = desk.text.split("\n")
    faults = error.faults[:MOST_SHOWN]
    mends = mends_of(faults, lines)
    return [
        fault_entry(fault.code, _said(fault, desk), fault.line, fault.column, mend)
        for fault, mend in zip(faults, mends, strict=True)
    ]


def _said(fault: Fault, desk: Desk) -> str:
    """Return the sentence of a fault, as `check` says it; on a shared desk, users are not told how to raise limits."""
    dear = DEAR.get(fault.code) if not desk.setup.folder else None
    return desk.words.written(say(dear, limit=fault.message.values["limit"])) if dear else fault.said(desk.words.written)


def remarks_of(desk: Desk) -> list[dict[str, Any]]:
    """Return the remarks on values that look like slips, and the advice on which section to add next."""
    slips = [
        {"code": remark.code, "line": remark.line, "sentence": desk.words.written(remark.sentence)}
        for remark in desk.variant.plausibility
    ]
    return slips + _next_section(desk)


def _next_section(desk: Desk) -> list[dict[str, Any]]:
    """Return the section that a text with equations needs for a drawing or for judging them, and its first lines; or empty."""
    variant = desk.variant
    if not variant.constraints or variant.driven or variant.holds or any(one.is_closure for one in variant.constraints):
        return []
    points, laws = [name for name, _ in variant.points], {law.name for law in variant.drive}
    key, begun = "closure", next((f'[closure]\ndriven = "{one}"\nholds  = []' for one in points if f"V{one}x" in laws), "")
    if not points:
        key, begun = "points", '[points]\nA = "(0, 0)"'
    mend = appended(begun, desk.text.split("\n")) if begun else None
    return [{"code": "", "line": None, "sentence": desk.words.written(say(f"desk.next_{key}")), "mend": mend}]
