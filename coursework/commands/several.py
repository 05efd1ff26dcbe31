"""`coursework run A B C …`: several variants in one or more processes, with a folder for each and a summary at the end.

Enters: names, paths and patterns.  Leaves: folders, `summary.csv`, perhaps `combined.pdf`; the worst exit status (3, 2, 1, 0).
Used by `cli.py`; one faulty file never stops the rest.
"""

from __future__ import annotations

import glob
import sys
from collections import Counter
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, nullcontext
from dataclasses import field
from pathlib import Path
from typing import Any, get_args

import click

from coursework.api import make_run, variant_of
from coursework.commands.line.screen import in_language, tell, tell_faults, tell_own_file, tell_unprinted
from coursework.commands.line.templates import with_templates
from coursework.commands.run import WRONG_INPUT, run_variant
from coursework.report.output.formats import chosen
from coursework.report.output.results import Results
from coursework.report.output.write import write_set
from coursework.results.checks.result import Verdict
from coursework.scene.quantities import CHECKS
from coursework.system.files.csv_text import csv_text
from coursework.system.files.file_set import clear_leftovers, working_folder
from coursework.system.files.links import led_to
from coursework.system.files.whole_files import free_name, write_bytes
from coursework.system.frozen import frozen
from coursework.system.processes.budget import Budget, watched
from coursework.variant.catalogue import find
from coursework.variant.reading.set_values import with_set
from coursework.words.errors import CourseworkError, InputError
from coursework.words.sentences import joined, load_phrases, say

SUMMARY = "summary.csv"
COMBINED = "combined.pdf"
VERDICTS: tuple[str, ...] = get_args(Verdict)
MOST_JOBS = 64
OPENED = "coursework.commands.several:opened"
OUR_FAULT = 3


@frozen
class Item:
    """One variant to run: its name as the user gave it, and the folder for its results."""

    variant: str
    folder: str


@frozen
class Outcome:
    """The outcome of one variant; `verdicts` counts its checks, `message` has everything that went wrong.

    `code` is that of the first fault of a refused variant, "" for others.
    `page` is the content of its report, if all reports are to be printed together.
    """

    item: Item
    status: int
    rows: int = 0
    stop: str = ""
    verdicts: Mapping[str, int] = field(default_factory=dict)
    message: str = ""
    code: str = ""
    page: dict[str, Any] | None = None

    @property
    def sentence(self) -> str:
        """Return in one line why the status is not 0."""
        return self.stop or self.message.strip().partition("\n")[0]


@frozen
class RunTask:
    """How the variants are run: output folder, formats, language, options, budget, templates, and whether to make one PDF too."""

    out: Path
    formats: tuple[str, ...] | None
    language: str
    options: dict[str, Any]
    budget: Budget
    templates: Path | None = None
    combined: bool = False

    @contextmanager
    def ready(self) -> Iterator[Callable[[Item], Outcome]]:
        """Open the folder for unfinished files; yield the function that runs one variant."""
        with with_templates(self.templates), working_folder(self.out) as hidden:
            yield lambda item: self._outcome(item, hidden)

    def lost(self, item: Item, late: bool) -> Outcome:
        """Return the outcome of a variant whose process ended without an answer."""
        return Outcome(item, WRONG_INPUT, message=say("screen.lost", variant=item.variant))

    def _outcome(self, item: Item, hidden: Path) -> Outcome:
        try:
            with watched(self.budget, item.variant):
                return self._run(item, hidden)
        except (CourseworkError, MemoryError) as error:
            code = error.faults[0].code if isinstance(error, CourseworkError) else ""
            return Outcome(item, WRONG_INPUT, message=self._message(error), code=code)
        except Exception as error:
            import traceback

            crashed = say("screen.crashed", variant=item.variant, kind=type(error).__name__, error=str(error))
            message = f"{crashed}\n{traceback.format_exc()}"
            return Outcome(item, OUR_FAULT, message=message)

    def _message(self, error: CourseworkError | MemoryError) -> str:
        written = load_phrases(self.language).written
        return error.told(written) if isinstance(error, CourseworkError) else written(say("screen.memory"))

    def _run(self, item: Item, hidden: Path) -> Outcome:
        formats = chosen(self.formats, "run")
        options = dict(self.options)
        strict, live = options.pop("strict"), options.pop("live")
        read = with_set(variant_of(item.variant), options.pop("set_values"), options.pop("check_row"))
        run = make_run(read, **{**options, "quantities": options["quantities"] or None})
        results = Results(run, self.language, live)
        results.compute(self.combined or any(each.paged for each in formats))
        unfinished = hidden / item.folder
        unfinished.mkdir(exist_ok=True)
        write_set(results, formats, self.out / item.folder, unfinished)
        checks = run.checks if run.asks(CHECKS) else ()
        written = load_phrases(self.language).written
        stop = "" if run.stop is None else written(say("screen.stopped", kind=run.stop.name, time=run.stop.time))
        wrong = {"FAIL", "ERROR", *(["COARSE"] if strict else [])}
        failed = "; ".join(f"{check.code}: {written(check.sentence)}" for check in checks if check.verdict in wrong)
        page = results.model.plain() if self.combined else None
        refused = "\n".join(map(self._message, results.refused))
        status = max(run.status(strict), WRONG_INPUT if refused else 0)
        counts: Counter[str] = Counter(c.verdict for c in checks)
        return Outcome(item, status, len(run.motion.t), stop, counts, refused or failed, page=page)


@contextmanager
def opened(plain_task: Any) -> Iterator[Callable[[Any], Outcome]]:
    """Yield the function that runs variants one after the other in a process of the pool."""
    from coursework.system.processes.plain_lines import record_of

    with record_of(RunTask, plain_task).ready() as work:
        yield lambda plain_item: work(record_of(Item, plain_item))


def outcomes(task: RunTask, items: Sequence[Item], jobs: int) -> Generator[tuple[int, Outcome], None, None]:
    """Yield (index, outcome) of each item when it is done, computed in this process for one job, else in `jobs` processes."""
    if jobs == 1:
        with task.ready() as work:
            for index, item in enumerate(items):
                yield index, work(item)
        return
    from coursework.system.processes.pool import Pool, Trade  # imported here, as only several processes need it

    # A run ended by its budget would take as long a second time, so it is tried only once.
    trade = Trade(OPENED, task, Outcome, task.lost, tries=1, quiet=False)
    with Pool(trade, min(jobs, len(items))) as pool:
        yield from pool.answers(enumerate(items))


def run_variants(
    variants: tuple[str, ...], *, out: Path | None, formats: tuple[str, ...] | None, jobs: int, budget: float, memory: float,
    language: str, templates: Path | None, combined: bool, **options: Any,
) -> int:  # fmt: skip
    """Run one or several variants; return the exit status of the one, or the worst of several."""
    limits = Budget(budget, memory)
    if len(variants) == 1 and not _is_pattern(variants[0]) and not combined:
        with watched(limits, variants[0], tell_faults):
            return run_variant(variants[0], out=out, formats=formats, language=language, **options)
    for_one = {name: options.pop(name) for name in ("plan", "profile", "precision", "error", "verbose")}
    if for_one["plan"] or for_one["profile"] or for_one["error"] or for_one["precision"] == "single" or options["step"] == "auto":
        raise InputError(say("fault.C032"))
    task = RunTask(out or Path("coursework-runs"), formats, language, options, limits, templates, combined)
    return run_several(variants, jobs, task)


def run_several(variants: Sequence[str], jobs: int, task: RunTask) -> int:
    """Run every variant, write the summary, and return the worst exit status."""
    chosen(task.formats, "run")
    items = _items(variants)
    done: dict[int, Outcome] = {}
    shows = sys.stderr is not None and sys.stderr.isatty()
    bar = (
        click.progressbar(length=len(items), label=in_language(say("screen.progress.run")), file=sys.stderr)
        if shows
        else nullcontext()
    )
    try:
        with bar as progress, closing(outcomes(task, items, min(jobs, MOST_JOBS))) as found:
            for index, outcome in found:
                done[index] = outcome
                if progress is not None:
                    progress.update(1)
    finally:
        if task.out.is_dir():
            clear_leftovers(task.out)
    ordered = [done[index] for index in range(len(items))]
    write_bytes(task.out / SUMMARY, summary_csv(ordered).encode("utf-8", "backslashreplace"))
    written = [SUMMARY]
    if pages := [outcome.page for outcome in ordered if outcome.page is not None]:
        from coursework.report.pages.pdf import paper_of

        paper = paper_of(pages)
        write_bytes(task.out / COMBINED, paper.content)
        tell_unprinted(paper.missing)
        written.append(COMBINED)
    for outcome in ordered:
        if outcome.status >= WRONG_INPUT:
            tell(outcome.message.rstrip(), err=True)
    tell(*summary_lines(ordered), say("screen.written_folders", out=task.out, file=", ".join(written)))
    return max(outcome.status for outcome in ordered)


def summary_csv(ordered: Iterable[Outcome]) -> str:
    """Return the summary as CSV: per variant its status, rows, checks by verdict, what went wrong, and the code of a fault."""
    head = ["variant", "folder", "status", "rows", *(verdict.lower() for verdict in VERDICTS), "sentence", "code"]
    rows = (
        [each.item.variant, each.item.folder, each.status, each.rows, *(each.verdicts.get(verdict, 0) for verdict in VERDICTS),
         each.sentence, each.code]
        for each in ordered
    )  # fmt: skip
    return csv_text(head, rows)


def summary_lines(ordered: Sequence[Outcome]) -> Iterator[str]:
    """Yield the lines of the summary for a person."""
    width = max([len("variant"), *(len(each.item.folder) for each in ordered)])
    heads = "  ".join(f"{verdict:>6}" for verdict in VERDICTS)
    yield f"{'variant':<{width}}  status    rows  {heads}"
    for each in ordered:
        counts = "  ".join(f"{each.verdicts.get(verdict, 0):>6}" for verdict in VERDICTS)
        why = "" if not each.status else f"  {each.sentence[:100]}"
        yield f"{each.item.folder:<{width}}  {each.status:>6}  {each.rows:>6}  {counts}{why}"
    counted = Counter(each.status for each in ordered)
    found = [say("screen.counted", count=counted[status], status=status) for status in sorted(counted)]
    if [*counted] == [0]:
        found = [say("screen.all_counted", count=len(ordered))]
    yield say("screen.summary", count=len(ordered), counts=joined(found, "join.comma"))


def _items(variants: Sequence[str]) -> list[Item]:
    """Return the items to run, each file once, with folder names that differ even if case is ignored."""
    items: dict[str, Item] = {}
    taken = {SUMMARY, COMBINED}
    for variant in (found for word in variants for found in _expanded(word)):
        tell_own_file(variant)
        try:
            path = find(variant)
        except CourseworkError:
            path = Path(variant)
        if (key := str(led_to(path))) not in items:
            items[key] = Item(variant, free_name(path.stem.strip(". ") or "variant", taken))
    return [*items.values()]


def _is_pattern(word: str) -> bool:
    return glob.has_magic(word) and not (Path(word).exists() or Path(f"{word}.toml").exists())


def _expanded(word: str) -> list[str]:
    """Return the sorted files of a pattern; one without files is returned itself, to be reported as a fault."""
    if not _is_pattern(word):
        return [word]
    folder = Path(word).parent
    if folder.is_dir():  # brackets in its name are no pattern
        word = str(Path(glob.escape(str(folder)), Path(word).name))
    return sorted(found for found in glob.glob(word, recursive=True) if Path(found).is_file()) or [word]  # noqa: PTH207  may begin at the root
