"""`coursework new`: a variant file to fill in, which runs as it is: a commented template, a chain of groups, or a copy.

Enters: a name, the kinds of a chain (--groups), what to copy (--from), what to change in the copy (--set).
Leaves: NAME.toml in the current folder, and the tables that it reads.
Used by `cli.py`.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursework.commands.line.screen import in_language, tell, tell_own_file
from coursework.desk.inside import is_name, refused_name
from coursework.scene.model.variant_text import variant_text
from coursework.scene.quantities import ACCELERATIONS, ANALOGS, CHECKS, GRAPH_CHECK, INVARIANTS, PLOTS, POINTS, TABLE, Quantity
from coursework.system.files.whole_files import write_bytes
from coursework.variant.catalogue import find, load, names
from coursework.variant.reading.reader import parse_variant
from coursework.variant.reading.set_values import with_set
from coursework.variant.record.vocabulary import GROUP_KINDS
from coursework.words.data_folders import REPORTS, folder
from coursework.words.errors import InputError
from coursework.words.sentences import closest, say, say_count

MOST_GROUPS = 20
# A comment after # (a text before it has no # inside), or a reason.
_TEXTS = re.compile(r"""(^[^#\n]*# |^because *= ")(.+?)("?$)""", re.M)

if TYPE_CHECKING:
    from coursework.mechanism.drafts.chain import Draft


def new_variant(
    name: str, original: str | None, set_values: Sequence[str], kinds: str | None, language: str, more: str | None
) -> int:
    """Write NAME.toml: a copy of `original`, a chain of `kinds`, or the template; never overwrite a file with other content."""
    if kinds is not None and original is not None:
        raise InputError(say("fault.C070"))
    if set_values and original is None:
        raise InputError(say("fault.C045"))
    stem = name.removesuffix(".toml")
    if not is_name(stem):
        raise InputError(refused_name(name))
    if stem.lower() in names():
        raise InputError(say("fault.C026", stem=stem))
    target = Path(f"{stem}.toml")
    if original is not None:
        contents = _copies(target, original, set_values)
    else:
        contents = {target: _template(stem, language) if kinds is None else _chain(stem, kinds)}
    if more is not None:
        contents[target] = _with_forces(contents, target, more)
    for path, content in contents.items():
        if path.exists() and (path == target or path.read_bytes() != content):
            raise InputError(say("fault.C027", path=path))
    for path, content in contents.items():
        write_bytes(path, content)
    key = "screen.new_set" if set_values else "screen.new"
    tell(say_count(key, len(contents), listed=tuple(map(str, contents)), name=stem))
    return 0


def _template(stem: str, language: str) -> bytes:
    """Return the template; a file beside it maps its comments and texts to their translations, if the language has one."""
    place = folder(REPORTS)
    text = (place / "new-variant.toml").read_text(encoding="utf-8")
    if (translated := place / f"new-variant.{language}.toml").is_file():
        said = tomllib.loads(translated.read_text(encoding="utf-8"))
        text = _TEXTS.sub(lambda found: f"{found[1]}{said.get(found[2], found[2])}{found[3]}", text)
    return text.replace("NAME", stem).encode("utf-8")


def _chain(stem: str, kinds: str) -> bytes:
    """Return the file of a chain.  Raises `InputError` if the kinds do not make one."""
    from coursework.mechanism.drafts.chain import DoesNotClose, draft_of
    from coursework.mechanism.drafts.text import text_of
    from coursework.mechanism.groups import group_kind

    asked = [kind.strip() for kind in kinds.split(",") if kind.strip()]
    meant = {kind.lower(): kind for kind in GROUP_KINDS}
    known = ", ".join(GROUP_KINDS)
    if wrong := [kind for kind in asked if kind.lower() not in meant]:
        hint = closest(wrong[0], [*meant.values()]) or closest(wrong[0].upper(), [*meant.values()])
        raise InputError(say("fault.C071", kind='", "'.join(dict.fromkeys(wrong)), hint=hint, known=known))
    named = [meant[kind.lower()] for kind in asked]
    if len(named) < 2 or len(named) > MOST_GROUPS or not group_kind(named[0]).driven:
        raise InputError(say("fault.C072", found=", ".join(named) or say("fault.part.nothing"), most=MOST_GROUPS))
    try:
        draft = draft_of(named)
        return text_of(draft, stem, in_language, [one.name for one in _asked(draft)]).encode("utf-8")
    except DoesNotClose as error:
        raise InputError(say("fault.C073", number=error.number, kind=named[error.number - 1])) from error


def _with_forces(contents: Mapping[Path, bytes], target: Path, more: str) -> bytes:
    """Return a file, one of `contents`, with sections of masses and forces added.

    Raises `InputError` for another section, if it has them, and if the file would not run with them.
    """
    from coursework.api import make_run
    from coursework.effects.draft import with_forces

    if more != "forces":
        raise InputError(say("fault.C075", found=more))
    content, files = contents[target], {str(path): content for path, content in contents.items()}
    variant = parse_variant(content, target.name, files)
    if variant.forces is not None:
        raise InputError(say("fault.C076"))
    made = with_forces(variant, content.decode("utf-8"), in_language).encode("utf-8")
    try:
        make_run(parse_variant(made, target.name, files), quantities=["forces"]).results.force_checks  # noqa: B018
    except InputError as refused:
        raise InputError(say("fault.C079", name=target.name, why=refused.faults[0].message)) from refused
    return made


def _asked(draft: Draft) -> Iterator[Quantity[Any]]:
    """Yield the quantities that can be computed for a chain."""
    yield from (TABLE, PLOTS, CHECKS, GRAPH_CHECK, ACCELERATIONS, POINTS)
    if draft.turns_one_crank:
        yield ANALOGS
        if draft.slides:
            yield INVARIANTS


def _copies(target: Path, original: str, set_values: Sequence[str]) -> dict[Path, bytes]:
    """Return the contents of the file and its tables by their new paths.  Raises `InputError` if the original has faults."""
    from coursework.takeaway.foreign.read import foreign_text

    if (taken := foreign_text(original, target.stem, in_language)) is not None:
        if set_values:
            raise InputError(say("fault.C097"))
        return {target: taken.encode("utf-8")}
    tell_own_file(original)
    source = find(original)
    variant = with_set(load(source), set_values)
    tables = [law.file for law in variant.laws if law.file]
    text = variant_text(variant, source.read_text(encoding="utf-8-sig"))
    return {target: text.encode("utf-8"), **{Path(name): (source.parent / name).read_bytes() for name in tables}}
