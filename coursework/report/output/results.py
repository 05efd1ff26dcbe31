"""The results that formats write: a run and its page model, which is built once and only if a format needs it.

Enters: a `SceneRun`.  Leaves: `Results`.  Used by the formats and by the code that writes them.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any

from coursework.report.output.gate import pass_gate
from coursework.report.output.record import record, stamp_of
from coursework.report.output.tables import run_tables, study_csv
from coursework.scene.quantities import PLOTS, quantities_for
from coursework.scene.scene_run import SceneRun
from coursework.system.on_demand import Plan, under_way
from coursework.words.errors import NotToBeHad
from coursework.words.sentences import say

if TYPE_CHECKING:
    from coursework.report.pages.model import ReportModel


class Results:
    """A run ready to be written; `stem` names its pages, `record_name` the file that is written last.

    With `live` the page for a screen has the moving part.  `unprinted` are letters of the PDF for which there was no font;
    `refused` holds the errors of formats that the run cannot have.
    """

    stem = "report"
    record_name = "run.json"

    def __init__(self, run: SceneRun, language: str = "en", live: bool = True, later: tuple[str, ...] = ()) -> None:
        self.run = run
        self.later = later
        self.language = language
        self.live = live
        self.unprinted = ""
        self.refused: list[NotToBeHad] = []

    def compute(self, pages: bool) -> None:
        """Compute what is asked for and check every number, so that an error comes before the first file is written."""
        if pages:
            _ = self.run.extra_tables, self.run.graph_check
        with under_way("gate"):
            pass_gate(self.run, pages)
        for one in quantities_for(self.run.asked).values():
            if pages or not one.only_pages:
                self.run.of(one)

    def plan(self, pages: bool) -> Plan:
        """Return the plan of what to compute for the files, the screen and, if `pages`, the pages."""
        run = self.run
        shown = ["solutions"] if pages else []
        shown += [one for one, seen in (("extremes", run.asks(PLOTS)), ("exact", self.live)) if seen and pages]
        # Exact rows need those of a scheme beside them; for a motion that stops, phases are sought with which it would not.
        shown += [one for one, said in (("scheme_rows", run.tableau is None), ("phases", run.stop is not None)) if said]
        return run.plan_with(*shown, pages=pages)

    @cached_property
    def stamp(self) -> str:
        """Return the stamp of variant, options and version."""
        return stamp_of(self.run, self.language)

    @cached_property
    def model(self) -> ReportModel:
        """Return the page model, with its figures drawn."""
        from coursework.report.pages import build_model

        with under_way("pages"):
            return build_model(self.run, self.language, self.stamp, live=self.live, later=self.later)

    def tables(self) -> Iterable[tuple[str, str]]:
        """Return the CSV texts by name."""
        return run_tables(self.run)

    def record(self) -> dict[str, Any]:
        """Return the content of the record without stamp and files."""
        return record(self.run) | self.letters()

    def letters(self) -> dict[str, Any]:
        """Return the record's entry on letters that are printed as boxes; empty if there are none."""
        told = say("screen.unprinted", letters=self.unprinted)
        return {"unprinted": {"letters": self.unprinted, "sentence": told}} if self.unprinted else {}


class StudyResults(Results):
    """A study of accuracy ready to be written."""

    stem = "accuracy"
    record_name = "accuracy.json"

    def compute(self, pages: bool) -> None:
        """Check every number; by then the study with its running times is complete, before anything is written."""
        with under_way("gate"):
            pass_gate(self.run, pages)

    def tables(self) -> Iterable[tuple[str, str]]:
        """Return the study as CSV."""
        assert self.run.study is not None
        return [("accuracy.csv", study_csv(self.run.study))]

    def record(self) -> dict[str, Any]:
        """Return the variant that was studied, the versions and the scheme."""
        variant, settings = self.run.variant, self.run.settings
        told = {"variant": variant.name, "title": variant.title, "versions": self.run.versions, "scheme": settings.scheme}
        return told | self.letters()
