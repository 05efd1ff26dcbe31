"""`coursework new`: a commented variant file to fill in, which runs as it is."""

from __future__ import annotations

import re
from pathlib import Path

import click

from coursework.data import folder
from coursework.errors import InputError
from coursework.files import write_bytes


def new_variant(name: str) -> int:
    """Write NAME.toml in the current folder; an existing file is left alone."""
    stem = name.removesuffix(".toml")
    if not re.fullmatch(r"[\w-]{1,60}", stem):
        raise InputError(f'"{name}" cannot be the name of a variant: letters, digits, _ and - only.')
    target = Path(f"{stem}.toml")
    if target.exists():
        raise InputError(f"{target} exists already and is left as it is. Choose another name.")
    text = (folder("reports") / "new-variant.toml").read_text(encoding="utf-8")
    write_bytes(target, text.replace("NAME", stem).encode("utf-8"))
    click.echo(f"{target} is written. Fill it in, then: coursework check {target}")
    return 0
