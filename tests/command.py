"""The command line, called in the process of the tests.

Enters: arguments as a user types them.  Leaves: click's result: exit code, output.
"""

from contextvars import copy_context

from click.testing import CliRunner, Result

from coursework.commands.cli import main


def call(*arguments: object) -> Result:
    """Return what came of a command; its language ends with it, as with the process of a user."""
    return copy_context().run(CliRunner().invoke, main, [str(argument) for argument in arguments])
