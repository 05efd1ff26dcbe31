"""`coursework run`: compute, write files, print.

Enters: the options of the command.  Leaves: files, lines on the screen, an exit status.  Used by `several.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from coursework.api import make_run, step_choice, variant_of
from coursework.commands.contradictions import terms_named
from coursework.commands.line.screen import is_terminal, refuse_motor, tell, tell_faults, tell_own_file, tell_unprinted
from coursework.commands.run_on_screen import by_folder, tell_run, tell_run_briefly
from coursework.motion.settings import stepping
from coursework.report.output.formats import FORMATS, Format, chosen
from coursework.report.output.results import Results
from coursework.report.output.write import write_set
from coursework.run import Run
from coursework.scene.quantities import DYNAMICS, ENERGY, FORCES, TABLE, quantities_for
from coursework.system.files.file_set import files_of, working_folder
from coursework.system.on_demand import under_way
from coursework.system.processes.budget import Ended
from coursework.variant.reading.set_values import with_set
from coursework.words.sentence import Sentence
from coursework.words.sentences import say, say_count

WRONG_INPUT = 2


def run_variant(
    variant: str, *, out: Path | None, formats: tuple[str, ...] | None, step: str | None, error: float | None, end: str | None,
    scheme: str | None, precision: str, strict: bool, plan: bool, profile: bool, verbose: bool, language: str, live: bool,
    set_values: tuple[str, ...], check_row: int | None, **options: Any,
) -> int:  # fmt: skip
    """Run one variant and return the exit status."""
    wanted = chosen(formats, "run")
    tell_own_file(variant)
    with under_way("reading"):
        read = with_set(variant_of(variant), set_values, check_row)
    if precision == "single" or step == "auto":
        refuse_motor(read)
    if precision == "single":
        with under_way("round_off"):
            status = tell_round_off(
                make_run(read, stepping(read, scheme), step if step != "auto" else None, end, quantities=("table",))
            )
        if not (formats or out):
            return status
    h: float | str | None = step
    if step == "auto":
        scheme = stepping(read, scheme)
        found = make_run(read, scheme, end=end, quantities=("table",))
        if found.scene.stop is not None:
            return tell_stop(found, say("screen.no_step"))
        with under_way("step_search"):
            choice = step_choice(found, error)
        tell(*choice.sentences)
        h, error = choice.step, None
    run = make_run(read, scheme, h, end, error=error, **{**options, "quantities": options["quantities"] or None})
    results = Results(run, language, live)
    if plan:
        tell_plan(results, wanted)
        return 0
    folder = out or Path(f"coursework-{read.name}")
    older = earlier_files(folder)
    written = write_all(results, folder, wanted)
    tell_result = tell_run if verbose or not is_terminal() else tell_run_briefly
    tell_result(run, folder, written)
    tell_older(folder, older, written)
    if profile:
        tell(say("screen.profile_head"))
        ledger = run.scene.ledger
        for name, seconds in ledger.seconds.items():
            tell(f"{name:<20} {ledger.calls[name]:>6} {seconds * 1e3:>8.2f}")
    for refused in results.refused:
        tell_faults(refused)
    return max(run.status(strict), WRONG_INPUT) if results.refused else run.status(strict)


def tell_plan(results: Results, wanted: Sequence[Format]) -> None:
    """Print what would be computed and what left out, the cost of the forces, and what each row evaluates."""
    run = results.run
    tell(*results.plan(any(each.paged for each in wanted)).lines())
    if run.variant.forces is not None:
        from coursework.effects.told import effect_lines

        needed = any(run.asks(one) for one in (FORCES, ENERGY, DYNAMICS))
        tell(*effect_lines(run.variant.forces, run.of(FORCES) if needed else None))
    title = run.scheme_title
    tell(say_count("screen.evaluations", run.tableau.slopes, title=title) if run.tableau else say("screen.scheme", title=title))
    evaluated = run.scene.rates.blocks
    named = [f"({', '.join(block.unknowns)})" for block in run.reduction.blocks]
    left = tuple(name for place, name in enumerate(named) if place not in evaluated)
    tell(say("screen.each_row", used=tuple(named[place] for place in evaluated), left=left or say("fault.part.nothing")))


def tell_stop(run: Run, consequence: Sentence) -> int:
    """Say why a motion stops and what cannot be computed therefore; return the exit status of a stopped motion."""
    assert run.stop is not None
    tell(say("screen.stopped_so", kind=run.stop.name, consequence=consequence, sentence=run.stop.sentence))
    return 1


def tell_round_off(run: Run) -> int:
    """Print the V-curve (error against number of steps) of single precision and return the exit status."""
    if run.stop is not None:
        return tell_stop(run, say("screen.no_error"))
    tell(say("screen.largest_error"))
    tell(f"{'steps':>8} {'double':>12} {'single':>12} {'single, t += h':>15}")
    curve = []
    for row in run.round_off_rows():
        curve.append(row)
        tell(f"{row.steps:>8} {row.double:>12.2e} {row.single:>12.2e} {row.running:>15.2e}")
    best, spoilt = min(curve, key=lambda row: row.single), min(curve, key=lambda row: row.running)
    worse = curve[-1].running / curve[-1].double
    counts = {"best": best.steps, "spoilt": spoilt.steps, "most": curve[-1].steps}
    tell(say("screen.round_off", **counts, least=best.single, running=spoilt.running, worse=worse))
    return 0


def write_all(results: Results, folder: Path, formats: Sequence[Format]) -> list[str]:
    """Compute everything, then write the files as one set; return their names.

    If the budget ends before that, write the tables with the quantities known so far and raise `Ended` again.
    """
    try:
        with terms_named(results.run.variant):
            return _write(results, folder, formats)
    except Ended:
        run = results.run
        computed = {TABLE.name, *vars(run.results)}
        known = [one.name for one in quantities_for(run.asked).values() if one.name in computed]
        tables = [each for each in formats if not each.paged]
        if tables and "motion" in vars(run.scene):
            written = _write(Results(replace(run, asked=tuple(known)), results.language, live=False), folder, tables)
            tell(say("screen.known", out=folder, files=", ".join(written), known=", ".join(known)))
        raise


def _write(results: Results, folder: Path, formats: Sequence[Format]) -> list[str]:
    results.compute(any(each.paged for each in formats))
    with under_way("writing"), working_folder(folder) as hidden:
        written = write_set(results, formats, folder, hidden)
    tell_unprinted(results.unprinted)
    return written


def earlier_files(folder: Path) -> tuple[str, ...] | None:
    """Return the files that an earlier run left in a folder, None if that run ended before its set was complete."""
    names = [f"{Results.stem}.{each.suffix}" for each in FORMATS] + ["table.csv"]
    there = tuple(name for name in names if (folder / name).exists())
    recorded = files_of(folder, Results.record_name)
    if recorded is None:
        return None if there and not (folder / Results.record_name).exists() else there
    return tuple(name for name in recorded if (folder / name).exists())


def tell_older(folder: Path, older: tuple[str, ...] | None, written: list[str]) -> None:
    """Say which files in the folder are from an earlier run."""
    if older is None:
        tell(say("screen.held_unfinished", folder=folder, record=Results.record_name))
        older = tuple(f"{Results.stem}.{each.suffix}" for each in FORMATS)
    if left := [name for name in older if name not in written and (folder / name).exists()]:
        tell(say("screen.from_earlier_run", left=by_folder(left) if is_terminal() else tuple(left)))
