"""The data of the shell's scripts at the start: words, schemes, formats, the opened file, the policy of this desk.

Enters: the parts of a `Plan` and a language; a name and a folder.  Leaves: plain data.  Raises `InputError` for a name that
no file may have.  Used by `application.py` and `server.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursework.desk.inside import is_name, refused_name
from coursework.desk.job import Policy
from coursework.desk.serving.files import Files
from coursework.desk.serving.folder import SUFFIX, Folder, etag_of
from coursework.desk.serving.replies import languages
from coursework.motion.schemes import SCHEMES, title_of
from coursework.report.output.formats import formats_for
from coursework.system.version import VERSION
from coursework.variant.catalogue import names
from coursework.variant.record.vocabulary import EXACT
from coursework.words.data_folders import folder as package_folder
from coursework.words.errors import InputError
from coursework.words.sentences import ENGLISH, load_phrases, say


def opened(name: str, folder: Path | None) -> dict[str, Any]:
    """Return `name`, `text` and `etag` of a file in the folder, else of a variant of the catalogue, else an empty text.

    `etag` is None for a text that is not in the folder yet.
    """
    stem = name.removesuffix(SUFFIX)
    if not name or folder is None:
        return {"name": "", "text": "", "etag": None}
    if not is_name(stem):
        raise InputError(refused_name(name))
    own = Folder(folder).read(stem)
    if own is not None:
        return {"name": stem, "text": own.decode("utf-8-sig", "replace"), "etag": etag_of(own)}
    known = stem.lower() in names()
    text = (package_folder("variants") / f"{stem.lower()}{SUFFIX}").read_text(encoding="utf-8") if known else ""
    return {"name": stem, "text": text, "etag": None}


def config_of(
    language: str, root: str, policy: Policy, files: Files | None, opened: Mapping[str, Any]
) -> dict[str, Any]:  # fmt: skip
    """Return the data for the scripts; the text of the `opened` file is read anew, since it may have changed."""
    phrases = load_phrases(language)
    now = dict(opened)
    titles = {name: title_of(scheme) for name, scheme in SCHEMES.items()} | ({EXACT: say("exact.title")} if policy.exact else {})
    if files and opened["name"] and (content := files.folder.read(opened["name"])) is not None:
        now |= {"text": content.decode("utf-8-sig", "replace"), "etag": etag_of(content)}
    return {
        **now, "root": root, "mode": "edit" if files else "serve", "version": VERSION, "language": language,
        "languages": [[each, load_phrases(each).template("desk.language_name")] for each in languages()],
        "schemes": [[name, phrases.written(title)] for name, title in titles.items()],
        "formats": [suffix for suffix, each in formats_for("run").items()
                    if (files or each.is_here()) and suffix in (policy.formats or (suffix,))],
        "policy": {"equations": policy.equations, "exact": policy.exact, "language": policy.language},
        "folder": str(files.folder.path) if files else None, "writable": bool(files and files.folder.is_writable()),
        "words": shell_words(language, is_own=files is not None),
    }  # fmt: skip


def shell_words(language: str, *, is_own: bool) -> dict[str, str]:
    """Return the words of the shell; words that a language does not have yet are English.

    Whoever has started the desk (`is_own`) is told how to start it again where it does not answer.
    """
    own, english = (load_phrases(each).entries.get("desk", {}).get("shell", {}) for each in (language, ENGLISH))
    words: dict[str, str] = {**english, **own}
    return words | {"state_unreachable": words["state_start_again"]} if is_own else words
