"""The templates of `reports/` from which every page is made, and text cleaned of what would spoil a page.

Enters: the name of a template and its contents; text of a student or a file.  Leaves: the escaped page; plain text.
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
from coursework.words.data_folders import REPORTS, folder, folder_of_package
from coursework.words.errors import CourseworkError, Fault, InputError
from coursework.words.generated_code import generated_code, made_once
from coursework.words.scripts import HAN_HERE, is_chinese, made_for
from coursework.words.sentences import say

if TYPE_CHECKING:
    from jinja2 import Environment, Template

# How every template is read; what else the environment holds is in no template's code.
_OPTIONS: dict[str, Any] = {"autoescape": True, "trim_blocks": True, "lstrip_blocks": True, "optimized": False}
READ = frozenset({".j2", ".toml", ".css", ".js", ".typ"})  # endings of the pieces that are text
LONGEST = 2000  # most characters of one text; Typst would take half a minute for a word of 1 MB
_LINE_END = rf"(?<=[{HAN_HERE}])[ \t]*\n\s*(?=[{HAN_HERE}])"
_UNBROKEN = rf"[^\s{HAN_HERE}-]{{25,}}"
_SHORT = 24  # a shorter text needs no place to break in its words
# A piece ends between a sign and the next, not inside a name or number, unless that is longer than a piece.
_PIECE = re.compile(r"\S{1,12}(?!(?<=[\w.,])[\w.,])|\S{1,12}")
# In a stylesheet: comments, blanks around signs, leading zeros and blanks that mean nothing.
_BARE = r"""(?ms)("[^"]*")|/\*.*?\*/|\s*([{};,>])\s*|(?<=:)\s+|(?<=[\s,(:])0(?=\.\d)|^\s+"""
INVISIBLE = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def filled(name: str, /, **content: Any) -> str:
    """Return a template of `reports/` with its gaps filled; the contents are escaped.

    Raises `InputError` if a piece of the instructor's own fails, for example by an unknown gap or a missing part.
    """
    with _told():
        return _template(folder("reports"), name).render(**content)


def filled_part(name: str, part: str, /, **content: Any) -> str:
    """Return a macro of a template of `reports/` with its gaps filled, as `filled` does."""
    with _told():
        return str(getattr(_template(folder("reports"), name).module, part)(**content))


@contextmanager
def _told() -> Iterator[None]:
    """Raise `InputError` with the name of the instructor's piece by which a page failed; let other errors, our own, pass."""
    from jinja2 import TemplateError

    try:
        yield
    except CourseworkError:
        raise
    except Exception as error:
        place = line_in_templates(error)
        if not place and isinstance(error, TemplateError):  # a template of the package lacks something in an own one
            place = (", ".join(name for name in templates_in_use() if name.endswith(".j2")), 0)
        if not place or not place[0]:
            raise
        raise InputError([failing_piece(*place, str(error))]) from error


def failing_piece(name: str, line: int, error: str) -> Fault:
    """Return the fault of an instructor's own piece that cannot be read or filled."""
    return Fault(say("fault.C066", error=error), name, line)


@lru_cache
def _template(place: Path, name: str) -> Template:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    from coursework.words.page_runs import said, said_cell, said_text

    own: Any = FileSystemLoader(place, encoding="utf-8") if place != folder_of_package(REPORTS) else _Package()
    looks = Environment(loader=own, undefined=StrictUndefined, **_OPTIONS)
    looks.globals.update(said=said, said_text=said_text, said_cell=said_cell, look=partial(_look, place))
    return looks.get_template(name)


class _Package:
    """Loads the package's own templates for jinja2, each compiled once an installation."""

    def load(self, environment: Environment, name: str, content: Any) -> Template:
        import jinja2

        file = folder_of_package(REPORTS) / name

        def made(text: str) -> str:
            return environment.compile(text, name, str(file), raw=True)

        code = generated_code(file, made, f"{jinja2.__version__} {_OPTIONS}")
        return environment.template_class.from_code(environment, code, content)


@lru_cache
def _look(place: Path, *names: str) -> str:
    """Return look.css and further stylesheets, without comments and unneeded blanks."""
    from markupsafe import Markup

    return Markup("".join(made_once(place / f"{name}.css", _bare) for name in ("look", *names)))


def _bare(style: str) -> str:
    return re.sub(_BARE, lambda found: found[1] or found[2] or "", style).replace(";}", "}")


def unreadable(piece: Path) -> Fault | None:
    """Return the fault of a text, template or words file that cannot be read, None if it can; Typst reports its own faults."""
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


def clean(text: str, longest: int = LONGEST, *, breaks: bool = True) -> str:
    """Return text without control, direction and unassigned characters, in NFC, with at most `longest` characters.

    Words of more than 24 characters get places to break (U+200B), so that none runs off the page; without `breaks` they do not,
    which is for a text that also enters a file where it is searched.
    """
    if len(text) < _SHORT and len(text) <= longest and text.isascii() and text.isprintable() and "  " not in text:
        return text.strip()  # the case of nearly every table cell
    joined = unicodedata.normalize("NFC", text[: 4 * longest])
    if is_chinese(joined):
        joined = made_for(joined, _LINE_END).sub("", joined)
    spaced = re.sub(r"[^\S\u00a0\u202f]+", " ", joined)
    plain = "".join(letter for letter in spaced if unicodedata.category(letter) not in INVISIBLE).strip()
    if len(plain) > longest:
        plain = plain[: longest - 1].rstrip() + "…"
    if not breaks:
        return plain
    return made_for(plain, _UNBROKEN).sub(lambda word: "\u200b".join(_PIECE.findall(word[0])), plain)
