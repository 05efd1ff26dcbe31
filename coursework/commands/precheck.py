"""`coursework precheck`: how files would be read and whether they contradict themselves; it prints no number of the key.

Enters: paths, perhaps a variant.  Leaves: lines on the screen; 0 if every part could be marked, else 1.
Used by `cli.py`.
"""

from __future__ import annotations

from pathlib import Path

import click

from coursework.commands.line.screen import before_a_person, in_language, tell, tell_own_file
from coursework.grading.collecting.sources import collect_files
from coursework.grading.precheck import precheck
from coursework.variant.catalogue import load
from coursework.words.errors import InputError
from coursework.words.sentences import say


def precheck_files(files: tuple[Path, ...], variant: str | None) -> int:
    """Print how the files would be read and return the exit status."""
    chosen = variant or next((str(path) for path in files if path.suffix == ".toml"), None)
    if chosen is None:
        raise InputError(say("fault.C028"))
    tell_own_file(chosen)
    read = load(chosen)
    found = precheck(collect_files(files), read, before_a_person)
    tell(*found.sentences)
    for note in found.notes:
        click.echo(f"  {before_a_person(in_language(note), read.columns)}")
    return 0 if found.fine and found.whole else 1
