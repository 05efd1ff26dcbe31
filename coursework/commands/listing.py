"""`coursework listing`: the coursework as a program, and the block diagram of that program.

Enters: a variant, a language, a scheme.  Leaves: the listing on the screen or in a file, a picture.  Used by `cli.py`.
"""

from __future__ import annotations

from pathlib import Path

import click

from coursework.api import make_run, variant_of
from coursework.commands.line.screen import tell, tell_own_file
from coursework.motion.settings import stepping
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.system.files.whole_files import write_bytes, wrong_ending
from coursework.takeaway.listing.chart import block_diagram
from coursework.takeaway.listing.listings import listing
from coursework.takeaway.listing.program import program_of, refuse_exact
from coursework.variant.reading.set_values import with_set
from coursework.variant.record.variant import Variant
from coursework.words.sentences import say


def list_variant(
    variant: str, *, code: str | None, scheme: str | None, step: str | None, error: float | None, set_values: tuple[str, ...],
    out: Path | None, chart: Path | None, language: str,
) -> int:  # fmt: skip
    """Write the program, the block diagram or both, and return 0."""
    refuse_exact(scheme)
    if chart is not None and chart.suffix.lower() != ".svg":
        raise wrong_ending(chart, ".svg")
    if out or chart:
        tell_own_file(variant)
    read = with_set(variant_of(variant), set_values, None)
    chosen = stepping(read, scheme) if read.motor is None else scheme
    advised = step == "auto" and error is None
    run = make_run(read, chosen, _advised(read, chosen) if advised else step, error=error, quantities=("table",))
    words = load_words(language)
    program = program_of(PageContext(run, words))
    if chart is not None:
        _write(chart, block_diagram(program, words))
    if code is None and out is None and chart is not None:
        return 0
    text = listing(program, code or "python", words)
    if out is None:
        click.echo(text, nl=False)
    else:
        _write(out, text)
    return 0


def _advised(variant: Variant, scheme: str | None) -> float:
    """Return the step that the checks advise, or that of the file if it is small enough."""
    checks = make_run(variant, scheme, quantities=("table", "checks")).checks
    return next((one.step for one in checks if one.code == "ACCURACY" and one.step), variant.time.step)


def _write(path: Path, text: str) -> None:
    content = text.encode("utf-8")
    write_bytes(path, content)
    tell(say("screen.animated", path=str(path), size=len(content) / 1000))
