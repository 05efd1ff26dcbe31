"""The program that runs a command: its exit status, and a sentence for each exception.

Used by `cli.py`.

Exit status: 0 all passed; 1 a check failed or the motion stopped; 2 the input is wrong or the output cannot be written;
3 a fault of the tool; 130 interrupted.
"""

from __future__ import annotations

import re
import sys
from typing import Any, NoReturn

import click

from coursework.system.processes.one_thread import keep_to_one_thread
from coursework.system.standard_streams import patient_streams
from coursework.words.errors import CourseworkError

_DASHED = re.compile("[‐‑‒–—−]-?[a-z]+(-[a-z]+)*(=|$)")  # a word processor has put dashes for the hyphens of --step
PASSED, FAILED, WRONG_INPUT, OUR_FAULT, INTERRUPTED = 0, 1, 2, 3, 130


class Program(click.Group):
    """The group of commands, each of which returns its exit status; exceptions become a sentence and a status here."""

    def main(self, *args: Any, **options: Any) -> NoReturn:
        """Run one command line and end the process with its status."""
        keep_to_one_thread()
        options["standalone_mode"] = False
        with patient_streams() as output:
            status = self._status(*args, **options)
            if output is not None and output.lost:
                click.echo(output.lost, err=True)
                status = max(status, WRONG_INPUT)
        sys.exit(status)

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Return what stands behind the options of the group; a word that only looks like an option is misuse, not a file."""
        for word in args:
            if _DASHED.match(word):
                raise click.NoSuchOption(word.partition("=")[0], ctx=ctx)
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run a command; on an interrupt print one sentence."""
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt:
            _tell("screen.interrupted")
            return INTERRUPTED

    def _status(self, *args: Any, **options: Any) -> int:
        """Return the exit status; print a traceback only for faults of the tool."""
        try:
            return int(super().main(*args, **options) or PASSED)
        except CourseworkError as error:
            from coursework.commands.line.screen import tell_faults

            tell_faults(error)
            return WRONG_INPUT
        except click.ClickException as error:
            from coursework.commands.line.misuse import tell_misuse

            tell_misuse(error, list(args[0] if args and args[0] else options.get("args") or sys.argv[1:]))
            return WRONG_INPUT
        except (click.Abort, KeyboardInterrupt):
            return INTERRUPTED
        except MemoryError:
            _tell("screen.memory")
            return WRONG_INPUT
        except Exception:
            import traceback

            traceback.print_exc()
            _tell("screen.our_fault")
            return OUR_FAULT


# Python keeps frames in blocks of 16 kB and gives a block back when its first frame ends: a loop whose calls begin one takes and
# returns memory each time (5 microseconds; 1900 times in a run).  A frame of this size begins a block with room for all others.
Program.main.__code__ = Program.main.__code__.replace(co_stacksize=16_000)


def _tell(key: str) -> None:
    from coursework.commands.line.screen import tell
    from coursework.words.sentences import say

    tell(say(key), err=True)
