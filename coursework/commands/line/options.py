"""The options that several commands share, and what each does before a command begins.

Enters: the words of a command line, through click.  Leaves: decorators for commands.  Only click is imported at the start.
Used by `cli.py`.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from contextlib import suppress
from functools import partial, wraps
from pathlib import Path
from typing import Any

import click

from coursework.system.late import late

MOST = 1e6  # s (eleven days), MiB (a million)
# The keys of a rubric; listed here for the help, which imports nothing of the grading.
RUBRIC_KEYS = "points, missing_part, parts, table, answers, conventions, confusion, late"


class Formats(click.ParamType):  # type: ignore[type-arg]  # generic only in the newest click
    """A comma-separated list of the formats of a command; formats that are written only on request come last."""

    name = "formats"

    def __init__(self, user: str) -> None:
        self.user = user

    def get_metavar(self, param: click.Parameter, ctx: click.Context | None = None) -> str:
        """Return the formats as the help shows them."""
        from coursework.report.output.formats import formats_for

        return ",".join(formats_for(self.user))

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, ...]:
        """Return the suffixes of the formats."""
        return listed(ctx, param, value) if isinstance(value, str) else value


def listed(_context: click.Context | None, _option: click.Parameter | None, value: str | None) -> tuple[str, ...]:
    """Return the parts of a comma-separated word."""
    return tuple(part.strip() for part in value.split(",") if part.strip()) if value else ()


offered = partial(late, "commands.line.completion")  # the function that completes a word in the shell, by name


class SchemeOption(click.Option):
    """An option whose help lists the schemes; they are looked up only when the help is printed."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        from coursework.variant.record.vocabulary import OF_FORCES, scheme_names

        self.help = f"{', '.join(scheme_names())}; under forces also {', '.join(OF_FORCES)} (default: that of the file)."
        return super().get_help_record(ctx)


VARIANT = click.argument("variant", shell_complete=offered("variants"))
SCHEME = click.option("--scheme", cls=SchemeOption, shell_complete=offered("schemes"))


class PathType(click.Path):
    """A file or folder.  In `--out --set r1=1m` the path was forgotten; a folder called "--set" is "./--set"."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the path of an option.  Raises `click.BadOptionUsage` for what looks like the next option."""
        if param is not None and str(value).startswith("--"):
            raise click.BadOptionUsage(param.opts[0], "the path is missing", ctx)
        return super().convert(value, param, ctx)


PATH = PathType(path_type=Path)


def _speaks(_context: click.Context, _option: click.Parameter, language: str) -> str:
    from coursework.commands.line.screen import speak

    speak(language)
    return language


def spoken(*, passed_on: bool, option: str = "--language") -> Callable[[Callable[..., int]], Callable[..., int]]:
    """Add the option for the language of a command; `passed_on` is True for commands that also make pages."""
    return click.option(
        option, "language", envvar="COURSEWORK_LANGUAGE", default="en", show_default=True, is_eager=True, expose_value=passed_on,
        callback=_speaks, shell_complete=offered("languages"),
        help=f"Language of {'pages' if option == '--language' else 'comments'} and messages: a words file in reports/.",
    )  # fmt: skip


def rubric_shown(context: click.Context, _option: click.Parameter, asked: bool) -> None:
    """Print the default rubric and end the program, if the option is given."""
    if asked and not context.resilient_parsing:
        from coursework.words.data_folders import REPORTS, folder

        click.echo((folder(REPORTS) / "rubric.toml").read_text(encoding="utf-8"), nl=False)
        context.exit()


def versions_shown(context: click.Context, _option: click.Parameter, asked: bool) -> None:
    """Print the installed packages of each extra and end the program, if the option is given."""
    if asked and not context.resilient_parsing:
        from coursework.commands.line.versions import tell_versions

        tell_versions()
        context.exit()


class CommandWithTemplates(click.Command):
    """A command with `--templates`: the pieces are in use before anything is printed, wherever the option is in the line."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        if any(word.startswith("--templates") for word in args):
            from coursework.commands.line.misuse import language_of, values_of
            from coursework.commands.line.screen import speak
            from coursework.commands.line.templates import with_templates
            from coursework.words.errors import InputError

            given = [value for value in values_of(args, "--templates") if not value.startswith("--")]
            with suppress(InputError):  # a language that only the own pieces have
                speak(language_of(args))
            if given:
                ctx.with_resource(with_templates(Path(given[-1])))
        try:
            return super().parse_args(ctx, args)
        except BaseException:
            ctx.close()
            raise


class CommandWithKinds(click.Command):
    """A command whose help ends with the table of kinds of groups, made from the records of the groups."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Move the language option to the front, so that the help is printed in that language wherever the option is."""
        spoken = [k for k, arg in enumerate(args) if arg == "--language" or (k and args[k - 1] == "--language")]
        spoken += [k for k, arg in enumerate(args) if arg.startswith("--language=")]
        return super().parse_args(ctx, [args[k] for k in spoken] + [arg for k, arg in enumerate(args) if k not in spoken])

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        from coursework.commands.line.kinds import kinds_table

        language = str(ctx.params.get("language") or os.environ.get("COURSEWORK_LANGUAGE") or "en")
        formatter.write(f"\n{kinds_table(language)}\n")


def templates(*, passed_on: bool) -> Callable[[Callable[..., int]], Callable[..., int]]:
    """Add `--templates` to a `CommandWithTemplates`; `passed_on` is True if the command itself needs the folder."""
    return click.option(
        "--templates", type=PATH, expose_value=passed_on,
        help="Folder of your own pieces of pages; each stands before the piece of reports/ of the same name.",
    )  # fmt: skip


SET = click.option(
    "--set", "set_values", multiple=True, metavar="NAME=VALUE",
    help="Other data, such as r1=0.91m; start values; step, end, period; N=3 (the guide's row of the check). Again for more.",
)  # fmt: skip


class Limit(click.FloatRange):
    """A number above zero; of more than `MOST`, which no system can count, `MOST` is taken."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number."""
        found = super().convert(value, param, ctx)
        return self.fail(str(value), param, ctx) if math.isnan(found) else min(found, MOST)


def limited(command: Callable[..., int]) -> Callable[..., int]:
    """Add the two options that limit time and memory to a command that computes."""
    above_zero = Limit(min=0, min_open=True)
    seconds = click.option(
        "--budget", type=above_zero, default=60.0, show_default=True, help="Most processor time of a variant, s."
    )
    memory = click.option(
        "--memory", type=above_zero, default=1024.0, show_default=True, help="Most memory beyond the start, MiB."
    )
    return seconds(memory(command))


def held_to_limits(command: Callable[..., int]) -> Callable[..., int]:
    """Add the same options to a command on one variant, and run the command within these limits."""

    @wraps(command)
    def watching(*, variant: str, budget: float, memory: float, **options: Any) -> int:
        from coursework.commands.line.screen import tell_faults
        from coursework.system.processes.budget import Budget, watched

        with watched(Budget(budget, memory), variant, tell_faults):
            return command(variant=variant, **options)

    return limited(watching)
