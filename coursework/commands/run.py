"""`coursework run`: compute, write, tell in a few lines."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from coursework.api import load, solve
from coursework.checks.result import GROUPS
from coursework.errors import InputError
from coursework.file_set import files_of, working_folder
from coursework.output.formats import FORMATS, PAGES, Format, chosen
from coursework.output.results import Results
from coursework.output.write import write_set
from coursework.run import Run
from coursework.schemes import DEFAULT_SCHEME, EXACT, PRECISE, SCHEMES
from coursework.sentences import listing, load_phrases, say
from coursework.variant.record import Variant
from coursework.variant.set_values import with_set


def run_variant(
    variant: str, *, out: Path | None, formats: tuple[str, ...] | None, step: str | None, error: float | None, end: float | None,
    scheme: str | None, precision: str, strict: bool, plan: bool, profile: bool, language: str, live: bool,
    set_values: tuple[str, ...], check_row: int | None, **options: Any,
) -> int:  # fmt: skip
    """Return the exit status of one run."""
    wanted = chosen(formats, "run")
    read = with_set(load(variant), set_values, check_row)
    if precision == "single":
        return tell_round_off(solve(read, _stepping(read, scheme), step_of(step, read), end, quantities=("table",)))
    if error is not None and step != "auto":
        raise InputError(say("fault.C029"))
    h = step_of(step, read)
    if step == "auto":
        scheme = _stepping(read, scheme)
        found = solve(read, scheme, end=end, quantities=("table",))
        if found.scene.stop is not None:
            return tell_stop(found, "no step makes this motion possible")
        h = auto_step(found, error)
    run = make_run(read, step=h, end=end, scheme=scheme, **options)
    if plan:
        on_pages = ("solutions",) if any(PAGES in each.serves for each in wanted) else ()
        click.echo("\n".join(run.plan_with(*on_pages).lines()))
        used, left = run.blocks_evaluated()
        cost = f", {run.tableau.slopes} evaluations a step" if run.tableau else ""
        click.echo(f"Scheme: {run.scheme_title}{cost}.")
        click.echo(f"In each row: the velocities {listing(used)}; left out: {listing(left) or 'nothing'}.")
        return 0
    folder = out or Path(f"coursework-{read.name}")
    older = earlier_files(folder)
    written = write_all(run, folder, wanted, language, live)
    tell(run, folder, written)
    tell_older(folder, older, written)
    if profile:
        click.echo("\nquantity              calls      ms")
        ledger = run.scene.ledger
        for name, seconds in ledger.seconds.items():
            click.echo(f"{name:<20} {ledger.calls[name]:>6} {seconds * 1e3:>8.2f}")
    return run.status(strict)


def make_run(
    read: Variant, *, step: float | None, end: float | None, scheme: str | None, quantities: tuple[str, ...], project: bool,
    gain: float, student: str | None, group: str | None, date: str | None,
) -> Run:  # fmt: skip
    """Return the run that the options of the command line ask for."""
    return solve(
        read, scheme, step, end, quantities=quantities or None, project=int(project), gain=gain,
        student=student, group=group, date=date,
    )  # fmt: skip


def _stepping(variant: Variant, scheme: str | None) -> str:
    """Return the scheme whose step or precision is asked about.  Raises `InputError` for the exact motion, which has neither."""
    if scheme == EXACT:
        raise InputError(say("fault.C007", scheme=PRECISE.name))
    return scheme or (variant.time.scheme if variant.time.scheme in SCHEMES else DEFAULT_SCHEME.name)


def tell_stop(run: Run, consequence: str) -> int:
    """Say why a motion stops and what therefore cannot be had; return the exit status of a stopped motion."""
    assert run.stop is not None
    click.echo(f"Stopped ({run.stop.kind}), so {consequence}. {run.stop.sentence}")
    return 1


def auto_step(run: Run, error: float | None) -> float:
    """Return the step for `--step auto --error WISH`, and say what it costs."""
    if error is None:
        raise InputError(say("fault.C030"))
    from coursework.accuracy.step_rules import step_rules
    from coursework.accuracy.step_search import choose_step

    scene = run.scene
    choice = choose_step(
        scene.rates, run.scheme, scene.begin, run.step, run.end, error,
        step_rules(scene.equations, scene.search), lambda scheme, step: scene.rerun(scheme, step) is not None,
    )  # fmt: skip
    for sentence in choice.sentences:
        click.echo(sentence)
    return choice.step


def tell_round_off(run: Run) -> int:
    """Print the V-curve of single precision."""
    from coursework.accuracy.round_off import round_off_curve

    if run.stop is not None:
        return tell_stop(run, "there is no error to show")
    click.echo("Largest error of the last row (rad or m), against the exact motion:")
    click.echo(f"{'steps':>8} {'double':>12} {'single':>12} {'single, t += h':>15}")
    rows = len(run.motion.t) - 1
    exact = run.exact.coordinates[-1]
    curve = []
    for row in round_off_curve(run.scene.rates, run.scheme, run.scene.start, run.step, rows, exact):
        curve.append(row)
        click.echo(f"{row.steps:>8} {row.double:>12.2e} {row.single:>12.2e} {row.running:>15.2e}")
    best, spoilt = min(curve, key=lambda row: row.single), min(curve, key=lambda row: row.running)
    worse = curve[-1].running / curve[-1].double
    click.echo(f"Single precision is best with {best.steps} steps ({best.single:.1e}); with t += h already with {spoilt.steps}")
    click.echo(f"({spoilt.running:.1e}), and with {curve[-1].steps} steps t += h is {worse:.0f} times worse than doubles.")
    return 0


def step_of(text: str | None, variant: Variant) -> float | None:
    """Return a step in seconds: a number, or h/N, a whole part of the step h of the file."""
    if text in {None, "auto"}:
        return None
    assert text is not None
    head, slash, parts = text.partition("/")
    if slash and head.strip() == "h" and parts.strip().isdecimal() and int(parts) > 0:
        return variant.time.step / int(parts)
    try:
        return float(text.removesuffix("s").strip())
    except ValueError:
        told = say("fault.C031", text=text)
        raise InputError(told) from None


def write_all(run: Run, folder: Path, formats: Sequence[Format], language: str, live: bool) -> list[str]:
    """Compute everything, then write the files as one set; return their names."""
    results = Results(run, language, live)
    results.compute(any(PAGES in each.serves for each in formats))
    with working_folder(folder) as hidden:
        return write_set(results, formats, folder, hidden)


def earlier_files(folder: Path) -> tuple[str, ...] | None:
    """Return the files of the set that an earlier run left in a folder; None where it was ended before it had finished them."""
    names = [f"{Results.stem}.{each.suffix}" for each in FORMATS] + ["table.csv"]
    there = tuple(name for name in names if (folder / name).exists())
    recorded = files_of(folder, Results.record_name)
    if recorded is None:
        return None if there and not (folder / Results.record_name).exists() else there
    return tuple(name for name in recorded if (folder / name).exists())


def tell_older(folder: Path, older: tuple[str, ...] | None, written: list[str]) -> None:
    """Say which files in the folder are not of this run."""
    if older is None:
        click.echo(f"{folder} held an unfinished set: an earlier run was ended before it had written its {Results.record_name}.")
        older = tuple(f"{Results.stem}.{each.suffix}" for each in FORMATS)
    if left := [name for name in older if name not in written and (folder / name).exists()]:
        click.echo(f"From an earlier run, and not of this one: {listing(left)}")


def tell_remarks(run: Run) -> None:
    """Print what looks like a slip of the pen in the file."""
    for remark in run.variant.plausibility:
        click.echo(f"  {remark.code}: {say('remark.line', line=remark.line, sentence=remark.sentence)}")


def tell(run: Run, folder: Path, written: list[str]) -> None:
    """Print the result, its summary first."""
    motion = run.motion
    if run.summary:
        click.echo(run.summary)
    click.echo(f"{run.variant.title}  ({run.variant.name})")
    if run.variant.set_values:
        click.echo(say("run.set", listed=tuple(f"{name} = {value}" for name, value in run.variant.set_values.items())))
    click.echo(f"{run.scheme_title}, h = {motion.step:g} s, {len(motion.t)} rows")
    if run.lesson is not None:
        click.echo(run.lesson.sentence)
    if gain := run.settings.gain:
        share = gain * motion.step
        told = f"gain·step = {share:.3g}, a position error becomes {1 - share:.3g} of itself a step"
        click.echo(f"Baumgarte's gain {gain:g} 1/s: {told}")
    names: tuple[Any, ...] = motion.names
    if len(motion.t):
        for label, row in (("first", 0), ("last", -1)):
            values = ", ".join(f"{name} {value:.5g}" for name, value in zip(names, motion.rows[row], strict=True))
            click.echo(f"  {label:<5} t = {motion.t[row]:.6g} s: {values}")
    if run.stop is not None:
        click.echo(f"Stopped ({run.stop.kind}): {run.stop.sentence}")
        if run.scene.phases:
            click.echo(run.scene.phases)
    tell_remarks(run)
    if "checks" in run.asked:
        tell_checks(run)
    click.echo(f"Written to {folder}: {', '.join(written)}")


def tell_checks(run: Run) -> None:
    """Print what every check has found, group by group, and the sentences of those that did not pass."""
    words = load_phrases()
    for group in GROUPS:
        click.echo(words.template(f"checks.group.{group}"))
        for check in (check for check in run.checks if check.group == group):
            value = "" if check.value is None else f" {check.value:.3g}"
            limit = "" if check.limit is None else f" (limit {check.limit:.3g})"
            unit = f" {check.unit}" if check.unit and value else ""
            where = "".join(f", {part}" for part in (check.column, f"row {check.row}" if check.row else "") if part)
            mark = words.template(f"checks.mark.{check.verdict}")
            click.echo(f"  {mark} {check.verdict:<6} {check.code:<16}{value}{unit}{limit}{where}")
    for check in run.checks:
        if check.verdict in {"COARSE", "FAIL", "ERROR"} and check.code != "STOP":
            click.echo(f"  {check.code}: {check.sentence}")
