"""`coursework new`: a variant file to fill in, which runs as it is: the commented template, or a copy of a variant.

Enters: a name, with --from what to copy, with --set what is other in the copy.
Leaves: NAME.toml in the current folder, with the tables it reads.
Used by `cli.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from coursework.commands.screen import tell, tell_own_file
from coursework.scene.model.variant_text import variant_text
from coursework.system.whole_files import write_bytes
from coursework.variant.catalogue import find, load, names
from coursework.variant.reading.set_values import with_set
from coursework.words.data_folders import folder
from coursework.words.errors import InputError
from coursework.words.sentences import say, say_count


def new_variant(name: str, original: str | None = None, set_values: Sequence[str] = ()) -> int:
    """Write NAME.toml, a copy of `original` or of the template; files that exist are left alone."""
    if set_values and original is None:
        raise InputError(say("fault.C045"))
    stem = name.removesuffix(".toml")
    if not re.fullmatch(r"[\w-]{1,60}", stem):
        raise InputError(say("fault.C025", name=name))
    if stem.lower() in names():
        raise InputError(say("fault.C026", stem=stem))
    target = Path(f"{stem}.toml")
    contents = {target: _template(stem)} if original is None else _copies(target, original, set_values)
    for path, content in contents.items():
        if path.exists() and (path == target or path.read_bytes() != content):
            raise InputError(say("fault.C027", path=path))
    for path, content in contents.items():
        write_bytes(path, content)
    key = "screen.new_set" if set_values else "screen.new"
    tell(say_count(key, len(contents), listed=tuple(map(str, contents)), name=stem))
    return 0


def _template(stem: str) -> bytes:
    text = (folder("reports") / "new-variant.toml").read_text(encoding="utf-8")
    return text.replace("NAME", stem).encode("utf-8")


def _copies(target: Path, original: str, set_values: Sequence[str]) -> dict[Path, bytes]:
    """Return the file and its tables by the paths they go to.  Raises `InputError` where the original has faults."""
    tell_own_file(original)
    source = find(original)
    variant = with_set(load(source), set_values)
    tables = [law.file for law in (*variant.drive, *variant.functions) if law.file]
    text = variant_text(variant, source.read_text(encoding="utf-8-sig"))
    return {target: text.encode("utf-8"), **{Path(name): (source.parent / name).read_bytes() for name in tables}}
