"""`coursework grade`: a folder or zip of submissions -> gradebook, pages, class page; also one submission for an autograder.

Enters: options.  Leaves: files in OUT; the exit status (0 = every submission has a state).
Used by `cli.py`.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import click

from coursework.commands.line.screen import in_language, tell, tell_own_file
from coursework.grading.batch.class_list import ClassList, class_of_one, class_of_roster, class_tables, handed_in, read_source
from coursework.grading.batch.decisions import Override, read_overrides
from coursework.grading.batch.gradebook import PAGES, Graded, Options, grade_class
from coursework.grading.batch.journal import Journal
from coursework.grading.batch.work import Outcome, Setup, Task, VariantSource
from coursework.grading.batch.workers import trade_of
from coursework.grading.batch.written import record_in, write_gradebook
from coursework.grading.collecting.sources import Source, collect_one
from coursework.grading.marking.late import LATE, OF_FILE, UNKNOWN
from coursework.grading.marking.rubric import Rubric, check_rubric, read_rubric
from coursework.grading.platforms.autograder import autograder_results, created_at
from coursework.grading.platforms.canvas import Gradebook, read_gradebook
from coursework.grading.platforms.downloads import canvas_owner
from coursework.grading.platforms.roster import read_roster
from coursework.grading.platforms.worksheet import Worksheet, read_worksheet
from coursework.grading.reading.submission import Submission
from coursework.system.files.links import led_to
from coursework.system.files.lock import held, refuse_link
from coursework.system.processes.pool import Trade, Worker
from coursework.words.custom_templates import templates_in_use
from coursework.words.errors import Fault, InputError, OutputError
from coursework.words.reasons import reason_of
from coursework.words.sentences import joined, say

MOST_NAMED = 10  # most ids named in one line on the screen


def grade_source(
    source: Path, *, variant: str | None, roster: Path | None, out: Path, rubric: Path | None, overrides: Path | None,
    worksheet: Path | None, canvas: Path | None, results: str | None, no_pages: bool, jobs: int, scheduler: str | None,
    limit: float, memory: int, language: str,
) -> int:  # fmt: skip
    """Grade one source and return the exit status."""
    if results and variant is None:
        raise InputError(say("fault.C024"))
    if (variant is None) == (roster is None):
        raise InputError(say("fault.C023"))
    tell_own_file(variant or "")
    text = _bytes(rubric).decode("utf-8-sig", errors="replace") if rubric else ""
    marking = read_rubric(text, str(rubric or "rubric"))
    if marking.is_scaled:
        tell(say("screen.scaled", sum_of=sum(marking.weights.values()), points=marking.points), err=True)
    if results:
        assert variant is not None
        chosen, content = read_source(variant, Path())
        check_rubric(marking, chosen, str(rubric or "rubric"))
        trade = trade_of(Setup(text, pages=False, memory_mib=memory, language=language), limit)
        grade = _grade_of_one(source, content, trade, results if marking.late else "")
        autograder_results(grade, marking, results, out / "results.json", language)
        return 0
    with Source(source) as opened:
        sheet = read_worksheet(_bytes(worksheet), str(worksheet)) if worksheet else None
        if sheet is not None:
            sheet.check_total(marking.points, str(rubric) if rubric else say("grading.default_rubric"))
        gradebook = read_gradebook(_bytes(canvas), str(canvas), marking.points) if canvas else None
        listed = _listed(opened, variant, roster, sheet)
        for found in listed.variants.values():
            check_rubric(marking, found, str(rubric or "rubric"))
        decided = _decided(overrides, listed, marking)
        setup = Setup(text, not no_pages, class_tables(listed.variants), memory, templates_in_use(), language)
        _prepare(out, source)
        tell(*opened.remarks, *([say("screen.no_scheduler")] if scheduler == "" else []))
        with (
            held(out),
            Journal(out) as journal,
            click.progressbar(length=len(listed.places), label=in_language(say("screen.progress.grade")), width=30) as bar,
        ):
            graded = grade_class(
                listed, opened, setup, journal, out, Options(jobs, scheduler, limit), decided, lambda: bar.update(1)
            )
            bar.finish()
            moodle = opened.platform == "moodle" and not no_pages
            written = write_gradebook(
                out, listed, graded, marking, worksheet=sheet, canvas=gradebook, moodle=moodle, language=language
            )
            if len(graded.places) != len(listed.places):
                raise RuntimeError(f"{len(listed.places)} submissions, {len(graded.places)} grades")
            _tell(listed, graded, out, written)
            if marking.late:
                _tell_times([handed_in(opened, place) for place in listed.places])
            _tell_missed(listed, sheet, gradebook)
            journal.rewrite([graded.places[student] for student in sorted(graded.places)])
    return 0


def _tell_missed(listed: ClassList, sheet: Worksheet | None, gradebook: Gradebook | None) -> None:
    """Tell how many students Canvas does not know, and whose grades Moodle does not let change."""
    if gradebook and (count := sum(bool(p.file_lists) and record_in(gradebook, p) is None for p in listed.places)):
        tell(say("screen.not_in_canvas", count=count))
    if sheet and (locked := [place.id for place in listed.places if place.row and place.row.locked]):
        who = joined(locked[:MOST_NAMED] + ["…"] * (len(locked) > MOST_NAMED), "join.comma")
        tell(say("screen.locked", count=len(locked), who=who))


def _listed(opened: Source, variant: str | None, roster: Path | None, sheet: Worksheet | None) -> ClassList:
    if roster is not None:
        return class_of_roster(opened, read_roster(_bytes(roster), str(roster)), roster, sheet)
    assert variant is not None
    return class_of_one(opened, variant, sheet)


def _decided(overrides: Path | None, listed: ClassList, rubric: Rubric) -> dict[str, tuple[Override, ...]]:
    if overrides is None:
        return {}
    folders = {one.folder: place.id for place in listed.places for one in place.file_lists if one.folder}
    return read_overrides(_bytes(overrides), str(overrides), [place.id for place in listed.places], rubric, folders)


def _grade_of_one(source: Path, variant: VariantSource, trade: Trade[Task, Outcome], platform: str) -> dict[str, Any]:
    """Return the grade of one submission; if its time matters, `platform` is the one that tells it, else ""."""
    submission = collect_one(source)
    time = _handed_in_alone(source, submission, platform) if platform else ""
    with Worker(trade) as worker:
        return worker.answer(Task(submission, variant, handed_in=time)).grade


def _handed_in_alone(source: Path, submission: Submission, platform: str) -> str:
    """Return the time of one submission from Gradescope, or whether Canvas marks one of its files as late.

    The files' own times tell nothing: the platform writes the files when it has them marked.
    """
    if platform == "gradescope" and (time := created_at(source)):
        return time
    owners = (canvas_owner(file.name) for file in submission.files)
    return LATE if any(owner and owner.late for owner in owners) else UNKNOWN


def _prepare(out: Path, source: Path) -> None:
    """Create OUT.  Raises `InputError` if it is inside the graded folder, `OutputError` if it cannot be made or is a link."""
    if source.is_dir() and led_to(out).is_relative_to(led_to(source)):
        raise InputError([Fault(say("fault.C074", source=source), str(out))])
    refuse_link(out / PAGES)
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError([Fault(say("fault.W012", reason=reason_of(error)), str(out))]) from error


def _bytes(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError([Fault(say("fault.G007", reason=reason_of(error)), str(path))]) from error


def _tell(listed: ClassList, graded: Graded, out: Path, written: list[str]) -> None:
    counts, fresh, kept = Counter(graded.states.values()), graded.fresh, len(graded.places)
    named = {state: say(f"feedback.state.{state.replace('-', '_')}") for state in sorted(counts)}
    counted = [say("screen.state", count=counts[state], state=name) for state, name in named.items()]
    told = joined(counted, "join.numbers") if counted else say("screen.nobody")
    tell(say("screen.submissions", count=len(listed.places), told=told, fresh=fresh, kept=kept - fresh))
    if graded.changes:
        tell(say("screen.changed", changed=len(graded.changes)))
    if listed.not_on_roster:
        tell(say("screen.not_on_roster", count=len(listed.not_on_roster)))
    tell(say("screen.written_to", out=out, files=", ".join(written)))


def _tell_times(times: list[str]) -> None:
    for key, word in (("late_unknown", UNKNOWN), ("late_by_file", OF_FILE)):
        if count := sum(time.startswith(word) for time in times):
            tell(say(f"screen.{key}", count=count))
