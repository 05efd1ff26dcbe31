"""What every page starts from: the templates of `reports/`, and text cleaned of what would spoil a page.

Enters: the name of a template and what fills it; text of a student or a file.  Leaves: the page, escaped; plain text.
Used by the report and by the pages of grading.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursework.words.custom_templates import line_in_templates, templates_in_use
from coursework.words.data_folders import folder
from coursework.words.errors import CourseworkError, Fault, InputError
from coursework.words.scripts import HAN_HERE, is_chinese, made_for
from coursework.words.sentences import say

if TYPE_CHECKING:
    from jinja2 import Template

READ = frozenset({".j2", ".toml", ".css", ".js", ".typ"})  # the kinds of pieces that are text
LONGEST = 2000  # characters of one text: a word of 1 MB would take Typst half a minute
_LINE_END = rf"(?<=[{HAN_HERE}])[ \t]*\n\s*(?=[{HAN_HERE}])"
_UNBROKEN = rf"[^\s{HAN_HERE}-]{{25,}}"
_SHORT = 24  # characters, below which no word needs a place to break
_PIECE = re.compile(r"\S{1,12}")
# Of a stylesheet: remarks, what stands around marks, zeros and marks that say nothing.
_BARE = re.compile(r"""("[^"]*")|/\*.*?\*/|\s*([{};,>])\s*|(?<=:)\s+|(?<=[\s,(:])0(?=\.\d)|^\s+""", re.DOTALL | re.MULTILINE)
_INVISIBLE = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def filled(name: str, /, **content: Any) -> str:
    """Return a template of `reports/` with its gaps filled; what is filled in is escaped.

    Raises `InputError` where a piece of the instructor's own fails, such as by a gap that nothing fills, or lacks a part.
    """
    with _told():
        return _template(folder("reports"), name).render(**content)


def filled_part(name: str, part: str, /, **content: Any) -> str:
    """Return a macro of a template of `reports/` with its gaps filled, as `filled` does."""
    with _told():
        return str(getattr(_template(folder("reports"), name).module, part)(**content))


@contextmanager
def _told() -> Iterator[None]:
    """Tell by which piece of the instructor's own a page failed; where it was none, the error is ours."""
    from jinja2 import TemplateError

    try:
        yield
    except CourseworkError:
        raise
    except Exception as error:
        place = line_in_templates(error)
        if not place and isinstance(error, TemplateError):  # what another template misses in an own one
            place = (", ".join(name for name in templates_in_use() if name.endswith(".j2")), 0)
        if not place or not place[0]:
            raise
        raise InputError([failing_piece(*place, str(error))]) from error


def failing_piece(name: str, line: int, error: str) -> Fault:
    """Return what is told of an instructor's own piece that cannot be read or filled."""
    return Fault(say("fault.C066", error=error), name, line)


@lru_cache
def _template(place: Path, name: str) -> Template:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    from coursework.words.page_runs import said, said_cell, said_text

    looks = Environment(
        loader=FileSystemLoader(place, encoding="utf-8"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        optimized=False,  # a page is filled once, seldom twice
    )
    looks.globals.update(said=said, said_text=said_text, said_cell=said_cell, look=partial(_look, place))
    return looks.get_template(name)


@lru_cache
def _look(place: Path, *names: str) -> str:
    """Return look.css and further stylesheets, without the remarks and margins that only their reader needs."""
    from markupsafe import Markup

    texts = ((place / f"{name}.css").read_text(encoding="utf-8") for name in ("look", *names))
    return Markup(_BARE.sub(lambda found: found[1] or found[2] or "", "".join(texts)).replace(";}", "}"))


def unreadable(piece: Path) -> Fault | None:
    """Return why a text, a template or a words file cannot be read.  What Typst refuses is told when it does."""
    import tomllib

    from jinja2 import Environment, TemplateSyntaxError

    if piece.suffix not in READ:
        return None
    try:
        text = piece.read_text(encoding="utf-8")
        if piece.suffix == ".j2":
            Environment().parse(text)
        if piece.suffix == ".toml":
            tomllib.loads(text)
    except UnicodeDecodeError as error:
        line = error.object[: error.start].count(b"\n") + 1
        return Fault(say("fault.C065", content=error.object[error.start]), str(piece), line)
    except TemplateSyntaxError as error:
        return failing_piece(str(piece), error.lineno, error.message or "")
    except tomllib.TOMLDecodeError as error:
        return failing_piece(str(piece), 0, str(error))
    return None


def clean(text: str, longest: int = LONGEST) -> str:
    """Return text without control, direction and unassigned characters, NFC, at most `longest` characters.

    Words beyond 24 letters get places to break (U+200B), so that none runs off the page.
    """
    if len(text) < _SHORT and text.isascii() and text.isprintable() and "  " not in text:
        return text.strip()[:longest]  # nearly every cell of a table
    joined = unicodedata.normalize("NFC", text[: 4 * longest])
    if is_chinese(joined):
        joined = made_for(joined, _LINE_END).sub("", joined)
    spaced = re.sub(r"[^\S\u00a0\u202f]+", " ", joined)
    plain = "".join(letter for letter in spaced if unicodedata.category(letter) not in _INVISIBLE).strip()
    if len(plain) > longest:
        plain = plain[: longest - 1].rstrip() + "…"
    return made_for(plain, _UNBROKEN).sub(lambda word: "\u200b".join(_PIECE.findall(word[0])), plain)
