"""The command line: options -> one library call -> exit status.  Progress and colours live here only.

Used by `__main__.py`.  The exit statuses are listed in `program.py`.
Only click is imported at the start; each command imports what else it needs.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from coursework.commands.line import options as line
from coursework.commands.line.program import PASSED, Program


@click.group(cls=Program, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="coursework", prog_name="coursework")
@click.option(
    "--versions", is_flag=True, is_eager=True, expose_value=False, callback=line.versions_shown,
    help="Show what is installed of each extra and exit.",
)  # fmt: skip
def main() -> None:
    """Coursework on plane mechanisms: velocity equations, a table by a scheme, checks, plots, report.

    coursework COMMAND --help tells the options of a command.
    """


@main.command("run", cls=line.CommandWithTemplates, short_help="Compute a variant and write its report.")
@click.argument("variants", nargs=-1, required=True, metavar="VARIANT...", shell_complete=line.offered("variants"))
@click.option("--out", type=line.PATH, help="Folder for the results (default: coursework-NAME; for several coursework-runs).")
@click.option("--format", "formats", type=line.Formats("run"), help="Files to write (default: html,pdf,csv).")
@line.SCHEME
@click.option("--step", help='Step in s, such as 0.02; "h/4": a part of the file\'s step; "auto" with --error.')
@click.option("--error", type=float, help="With --step auto: largest error wanted over the rows, rad or m.")
@click.option("--end", help='End of the run in s, such as 0.48, or with a unit: "480 ms".')
@line.SET
@click.option("--check-row", type=click.IntRange(min=1), help="Row of the graph-analytical check, from 1.")
@click.option(
    "--blank", is_flag=True, help="Leave the construction of the graph-analytical check to the student: the mechanism alone."
)
@click.option("--quantities", callback=line.listed, help="What to compute: quantities, or columns of the table; commas between.")
@click.option("--project", is_flag=True, help="One Newton projection onto the position equations a step.")
@click.option("--gain", type=float, default=0.0, help="Baumgarte's gain in 1/s (a teaching knob; gain times step below 2).")
@click.option("--precision", type=click.Choice(["double", "single"]), default="double", help="single: see what round-off does.")
@click.option("--strict", is_flag=True, help="End with status 1 also where a check only needs a finer step (COARSE).")
@click.option("--verbose", is_flag=True, help="Print every check with its number on a terminal too, as for a file or a program.")
@click.option("--plan", is_flag=True, help="Print what would be computed and what is left out, and stop.")
@click.option("--profile", is_flag=True, help="Print calls and time of every quantity.")
@line.spoken(passed_on=True)
@click.option("--live/--no-live", default=True, show_default=True, help="Let the mechanism move on the page of a screen.")
@click.option("--student", help="Name for the title block.")
@click.option("--group", help="Group for the title block.")
@click.option("--teacher", help="Teacher for the title block.")
@click.option("--institution", help="Institution for the title block.")
@click.option("--date", help="Date for the title block.")
@line.templates(passed_on=True)
@click.option("--combined", is_flag=True, help="All variants in one PDF too: combined.pdf.")
@click.option("--jobs", type=click.IntRange(min=1), default=1, show_default=True, help="Processes that share several variants.")
@line.limited
def run_command(variants: tuple[str, ...], **options: Any) -> int:
    """Run VARIANT (a name of the catalogue or a file) and write its report; several, or a pattern, get a folder each."""
    from coursework.commands.several import run_variants

    return run_variants(variants, **options)


@main.command("animate", short_help="Write the mechanism in motion as one picture.")
@line.VARIANT
@click.option("--out", type=line.PATH, help="The picture to write (default: NAME.gif).")
@line.SCHEME
@line.held_to_limits
@line.spoken(passed_on=True)
def animate_command(variant: str, out: Path | None, scheme: str | None, language: str) -> int:
    """Write VARIANT in motion as one animated picture, the true mechanism beside that of the table."""
    from coursework.commands.animate import animate_variant

    return animate_variant(variant, out, scheme, language)


@main.command("listing", short_help="Print the coursework as a program of your own.")
@line.VARIANT
@click.option(
    "--language", "code", type=click.Choice(["python", "octave", "c", "pascal", "javascript"]),
    help="Language of the program (default: python; none with --chart alone).",
)  # fmt: skip
@line.SCHEME
@click.option("--step", help='Step in s, such as 0.02; "h/4": a part of the file\'s step; "auto" with --error.')
@click.option("--error", type=float, help="With --step auto: largest error wanted over the rows, rad or m.")
@line.SET
@click.option("--out", type=line.PATH, help="The file to write (default: the screen).")
@click.option("--chart", type=line.PATH, help="Write the block diagram of this program: FILE.svg.")
@line.spoken(passed_on=True, option="--comments")
@line.held_to_limits
def listing_command(variant: str, **options: Any) -> int:
    """Print VARIANT as a program that needs no library and prints its table; draw its block diagram."""
    from coursework.commands.listing import list_variant

    return list_variant(variant, **options)


@main.command("check", short_help="Tell faults, mobility, and whether it can move.")
@line.VARIANT
@line.held_to_limits
@line.spoken(passed_on=False)
def check_command(variant: str) -> int:
    """Look at VARIANT: its faults, mobility, blocks, and whether the whole motion is possible."""
    from coursework.commands.check import check_variant

    return check_variant(variant)


@main.command("variants")
@line.spoken(passed_on=True)
def variants_command(language: str) -> int:
    """List the catalogue."""
    from coursework.variant.catalogue import entries

    for entry in entries(language):
        click.echo(f"{entry.name:<22} {entry.title}")
        if entry.teaches:
            click.echo(f"{'':<22}   {entry.teaches}")
    return PASSED


@main.command("new", cls=line.CommandWithKinds, short_help="Write a variant file to fill in.")
@click.argument("name")
@click.option("--with", "more", metavar="forces", help="Add masses and forces, to be changed.")
@click.option("--groups", "kinds", metavar="KIND,KIND…", help="Write a chain of groups of these kinds (below), a crank first.")
@click.option(
    "--from",
    "original",
    shell_complete=line.offered("variants"),
    help="Copy this variant with its tables, or a file of PMKS+, pylinkage, Linkage.",
)
@line.SET
@line.spoken(passed_on=True)
def new_command(name: str, **options: Any) -> int:
    """Write NAME.toml, a commented variant file to fill in, a chain of groups, or a copy of another."""
    from coursework.commands.new import new_variant

    return new_variant(name, **options)


@main.command("accuracy", cls=line.CommandWithTemplates, short_help="Show what accuracy costs in time.")
@line.VARIANT
@click.option("--out", type=line.PATH, help="Folder for the page (default: coursework-NAME).")
@click.option("--format", "formats", type=line.Formats("accuracy"), help="Files to write (default: all of these).")
@line.templates(passed_on=False)
@line.held_to_limits
@line.spoken(passed_on=True)
def accuracy_command(variant: str, out: Path | None, formats: tuple[str, ...] | None, language: str) -> int:
    """Show what accuracy costs in time for VARIANT."""
    from coursework.commands.accuracy import accuracy_page

    return accuracy_page(variant, out, formats, language)


@main.command("grade", cls=line.CommandWithTemplates)
@click.argument("source", type=line.PATH)
@click.option("--variant", shell_complete=line.offered("variants"), help="The variant that everybody has.")
@click.option("--roster", type=line.PATH, help="ROSTER.csv: id,name,email,variant.")
@click.option("--out", type=line.PATH, required=True, help="Folder for the gradebook.")
@click.option("--rubric", type=line.PATH, help=f"How marks are made (TOML; keys: {line.RUBRIC_KEYS}).")
@click.option(
    "--rubric-example", is_flag=True, is_eager=True, expose_value=False, callback=line.rubric_shown,
    help="Print the default rubric.",
)  # fmt: skip
@click.option(
    "--overrides",
    type=line.PATH,
    help="Your own decisions: id,check,points,reason,say; check is table, equations, answers or total. Students read what stands "
    "under say; under reason only if there is no column say.",
)
@click.option("--worksheet", type=line.PATH, help="Moodle's offline grading worksheet, to be filled in.")
@click.option(
    "--canvas",
    type=line.PATH,
    help="Canvas's gradebook export, to be filled in; it has no place for comments: attach feedback/ID.html in SpeedGrader.",
)
@click.option("--results", type=click.Choice(["gradescope", "prairielearn"]), help="One submission, for an autograder.")
@click.option("--no-pages", is_flag=True, help="No feedback pages.")
@line.templates(passed_on=False)
@click.option("--jobs", type=click.IntRange(0, 256), default=0, help="Submissions at once (default: the cores, at most 8).")
@click.option("--scheduler", help="Address of a Dask scheduler: the same on a cluster.")
@click.option(
    "--limit",
    type=line.Limit(0.1, 3600),
    default=10.0,
    show_default=True,
    help="Seconds of the processor for a submission.",
)
@click.option("--memory", type=click.IntRange(256, 65536), default=1024, show_default=True, help="MiB a submission may take.")
@line.spoken(passed_on=True)
def grade_command(source: Path, **options: Any) -> int:
    """Grade SOURCE, a folder or zip of submissions."""
    from coursework.commands.grade import grade_source

    return grade_source(source, **options)


@main.command("assign", cls=line.CommandWithTemplates, short_help="Give every student a variant, a sheet, a key.")
@click.argument("roster", type=line.PATH)
@click.option("--template", required=True, shell_complete=line.offered("variants"), help="The variant whose data are drawn anew.")
@click.option("--ranges", help="What the data may be (TOML; default: those of the template in the catalogue).")
@click.option("--seed", required=True, help="Any number or word: the same seed gives everybody the same data.")
@click.option("--out", type=line.PATH, required=True, help="Folder for variants, sheets and keys.")
@click.option("--pdf", is_flag=True, help="All sheets in one PDF, too.")
@click.option("--format", "workbooks", type=click.Choice(["xlsx"]), help="A workbook for everybody: data and an empty table.")
@click.option("--help-level", type=click.IntRange(0, 1), default=0, show_default=True, help="1: its first row has its formulas.")
@click.option("--deadline", default="", help="What stands on the line of the deadline (default: a line to write on).")
@click.option("--rubric", type=line.PATH, help="By it the sheets say what is marked (TOML, as for grade).")
@line.templates(passed_on=False)
@line.spoken(passed_on=True)
def assign_command(roster: Path, **options: Any) -> int:
    """Give every student of ROSTER (id,name,email) a variant of their own, a task sheet, and you the key."""
    from coursework.commands.assign import assign_class

    return assign_class(roster, **options)


@main.command("precheck", short_help="See how your files would be read.")
@click.argument("files", nargs=-1, required=True, type=line.PATH)
@click.option("--variant", shell_complete=line.offered("variants"), help="The variant you were given.")
@line.spoken(passed_on=False)
def precheck_command(files: tuple[Path, ...], variant: str | None) -> int:
    """See how FILES of yours would be read, before you hand them in; no number of the key is shown."""
    from coursework.commands.precheck import precheck_files

    return precheck_files(files, variant)


@main.command("edit")
@click.argument("name", default="", shell_complete=line.offered("variants"))
@click.option("--port", type=click.IntRange(0, 65535), default=8531, show_default=True, help="Port on this machine (0: any).")
@click.option("--no-browser", is_flag=True, help="Print the address and open no browser.")
@line.limited
@line.spoken(passed_on=True)
@click.pass_context
def edit_command(context: click.Context, /, name: str, language: str, **options: Any) -> int:
    """Open the desk in the browser: NAME typed, checked and drawn at once, over the files of this folder."""
    from coursework.commands.desk import edit

    return edit(name, language=_chosen(context, language), **options)


@main.command("serve")
@click.option("--host", default="", help="Address at which others reach the desk (default: this machine alone).")
@click.option("--port", type=click.IntRange(0, 65535), default=8531, show_default=True, help="Port (0: any).")
@click.option("--workers", type=click.IntRange(1, 64), help="Processes that compute (default: the cores, at most 4).")
@click.option("--root-path", default="", metavar="P", help="What stands before every path behind a proxy, such as /desk.")
@click.option("--proxy", is_flag=True, help="Believe the X-Forwarded headers of the proxy before it.")
@click.option("--allow-host", "hosts", multiple=True, metavar="H", help="A name by which it is called; again for more.")
@click.option("--policy", type=line.PATH, help="What the desk offers (TOML: equations, exact, formats, language).")
@line.spoken(passed_on=True)
@click.pass_context
def serve_command(context: click.Context, /, language: str, **options: Any) -> int:
    """Serve the desk to a class, without files: what is typed stays in each browser."""
    from coursework.commands.desk import serve

    return serve(language=_chosen(context, language), **options)


def _chosen(context: click.Context, language: str) -> str:
    """Return the language if the user has chosen it, "" to use that of each browser."""
    by_itself = context.get_parameter_source("language") is click.core.ParameterSource.DEFAULT
    return "" if by_itself else language
