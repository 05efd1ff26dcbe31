"""The command line: options -> one library call -> exit status.  Progress and colours live here only.

Exit status: 0 all passed; 1 a check failed or the motion stopped; 2 the input is wrong; 3 a fault of the tool.
Only click and the tableaux are imported at start; everything else inside the command that needs it.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any

import click

from coursework.schemes import DEFAULT_SCHEME, SCHEMES

_FORMATS = ("html", "pdf", "csv")
PASSED, FAILED, WRONG_INPUT, OUR_FAULT = 0, 1, 2, 3


def _guarded(command: Callable[..., int]) -> Callable[..., None]:
    """Turn what a command returns or raises into the exit status; a traceback is kept only for our own faults."""

    @wraps(command)
    def run(*args: Any, **options: Any) -> None:
        from coursework.errors import CourseworkError

        try:
            sys.exit(command(*args, **options))
        except CourseworkError as error:
            click.echo(str(error), err=True)
            sys.exit(WRONG_INPUT)
        except BrokenPipeError:
            # The reader of our output (head, a pager) has left; what was written stays.
            sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115, PTH123
            sys.exit(PASSED)
        except (click.ClickException, click.exceptions.Exit, SystemExit):
            raise
        except Exception:
            import traceback

            traceback.print_exc()
            click.echo("This is a fault of the tool, not of your file. Please report it with the lines above.", err=True)
            sys.exit(OUR_FAULT)

    return run


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="coursework", prog_name="coursework")
def main() -> None:
    """Euler-scheme coursework of two-degree-of-freedom mechanisms: table, plots, checks, report."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors="replace")


def _listed(_context: click.Context, _option: click.Parameter, value: str | None) -> tuple[str, ...]:
    return tuple(part.strip() for part in value.split(",") if part.strip()) if value else ()


def _offered(name: str) -> Callable[[click.Context, click.Parameter, str], list[Any]]:
    """Return what completes a word in the shell; nothing is imported before the tab key is pressed."""

    def complete(context: click.Context, parameter: click.Parameter, typed: str) -> list[Any]:
        from coursework.commands import completion

        found: list[Any] = getattr(completion, name)(context, parameter, typed)
        return found

    return complete


_VARIANT = click.argument("variant", shell_complete=_offered("variants"))


@main.command("run")
@_VARIANT
@click.option("--out", type=click.Path(path_type=Path), help="Folder for the results (default: coursework-NAME).")
@click.option("--format", "formats", callback=_listed, default="html,pdf,csv", show_default=True, help="html, pdf, csv.")
@click.option(
    "--scheme", default=DEFAULT_SCHEME.name, show_default=True, shell_complete=_offered("schemes"), help=f"{', '.join(SCHEMES)}."
)
@click.option("--step", help='Step in s, such as 0.02; "auto" with --error finds one.')
@click.option("--error", type=float, help="With --step auto: largest error wanted over the rows, rad or m.")
@click.option("--end", type=float, help="End of the run in s.")
@click.option("--quantities", callback=_listed, help="What to compute: quantities, or columns of the table; commas between.")
@click.option("--project", is_flag=True, help="One Newton projection onto the position equations a step.")
@click.option("--gain", type=float, default=0.0, help="Baumgarte's gain in 1/s (a teaching knob; gain times step below 2).")
@click.option("--precision", type=click.Choice(["double", "single"]), default="double", help="single: see what round-off does.")
@click.option("--plan", is_flag=True, help="Print what would be computed and what is left out, and stop.")
@click.option("--profile", is_flag=True, help="Print calls and time of every quantity.")
@click.option(
    "--language", default="en", show_default=True, shell_complete=_offered("languages"),
    help="Language of the pages: a words file in reports/.",
)  # fmt: skip
@click.option("--student", help="Name for the title block.")
@click.option("--group", help="Group for the title block.")
@click.option("--date", help="Date for the title block.")
@_guarded
def run_command(variant: str, **options: Any) -> int:
    """Run VARIANT (a name of the catalogue or a file) and write its report."""
    from coursework.commands.run import run_variant

    return run_variant(variant, **options)


@main.command("check")
@_VARIANT
@_guarded
def check_command(variant: str) -> int:
    """Look at VARIANT: its faults, mobility, blocks, and whether the whole motion is possible."""
    from coursework.commands.check import check_variant

    return check_variant(variant)


@main.command("variants")
@_guarded
def variants_command() -> int:
    """List the catalogue."""
    from coursework.catalogue import entries

    for entry in entries():
        click.echo(f"{entry.name:<22} {entry.title}")
        if entry.teaches:
            click.echo(f"{'':<22}   {entry.teaches}")
    return PASSED


@main.command("new")
@click.argument("name")
@click.option("--from", "original", shell_complete=_offered("variants"), help="Copy this variant, with the tables it reads.")
@_guarded
def new_command(name: str, original: str | None) -> int:
    """Write NAME.toml, a commented variant file to fill in, or a copy of another."""
    from coursework.commands.new import new_variant

    return new_variant(name, original)


@main.command("accuracy")
@_VARIANT
@click.option("--out", type=click.Path(path_type=Path), help="Folder for the page (default: coursework-NAME).")
@click.option("--format", "formats", callback=_listed, default="html,pdf", show_default=True, help="html, pdf.")
@_guarded
def accuracy_command(variant: str, out: Path | None, formats: tuple[str, ...]) -> int:
    """Show what accuracy costs in time for VARIANT."""
    from coursework.commands.accuracy import accuracy_page

    return accuracy_page(variant, out, formats)
