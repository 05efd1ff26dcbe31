"""`coursework assign`: a roster, a template and ranges -> a variant, a sheet and a key for every student.

Enters: options.  Leaves: files in OUT; the exit status.  Used by `cli.py`.
"""

from __future__ import annotations

from pathlib import Path

import click

from coursework.assigning.assign import Wishes, assign
from coursework.assigning.variants import Assignment, load_ranges, read_file
from coursework.commands.line.screen import in_language, tell, tell_own_file, tell_unprinted
from coursework.grading.marking.rubric import Rubric, check_rubric, read_rubric
from coursework.grading.platforms.roster import read_roster
from coursework.report.text.words import load_words
from coursework.variant.catalogue import load
from coursework.words.errors import InputError
from coursework.words.sentences import say


def assign_class(
    roster: Path, *, template: str, ranges: str | None, seed: str, out: Path, pdf: bool, deadline: str, rubric: Path | None,
    language: str, workbooks: str | None, help_level: int,
) -> int:  # fmt: skip
    """Give each student of a roster a variant and return the exit status."""
    words = load_words(language)
    listed = read_roster(read_file(roster), str(roster), "id,name,email")
    if not listed:
        raise InputError(say("fault.A006", file=str(roster)))
    tell_own_file(template)
    chosen = load(template)
    assignment = Assignment(chosen, load_ranges(ranges or template, chosen), seed)
    marking = read_rubric(read_file(rubric).decode("utf-8-sig", errors="replace"), str(rubric)) if rubric else Rubric()
    check_rubric(marking, chosen, str(rubric))
    centre, count = assignment.acceptance.centre, len(listed)
    tell(say("assign.pilot", feasible=centre.feasible, drawn=centre.drawn))
    letters: list[str] = []
    wishes = Wishes(seed, deadline, pdf, marking, workbooks is not None, help_level)
    with click.progressbar(length=2 * count, label=in_language(say("assign.progress")), width=30) as bar:
        written = assign(listed, assignment, out, wishes, words, bar.update, bar.update, letters.append)
        bar.finish()
    tell_unprinted("".join(letters))
    tell(say("assign.written", count=count, out=str(out), written=tuple(written)))
    return 0
