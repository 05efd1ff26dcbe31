"""The remarks of a text: comments of programs, what they say of the student's names, reasons beside an equation.

Enters: a text or a line, `Spellings`.  Leaves: it without them; what a comment says of a name.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from coursework.grading.reading.equations.formulas.denials import is_judged
from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.limits import EQUATION_CHARACTERS

_NUMBERED = re.compile(r"^\s*(?:\(?\d{1,3}\)?\s*#|#\d{1,3}[.:)]?\s)")  # the number of a line; a comment starts with # alone
_REMARK = re.compile(
    r"(?<!\\)%(?![io]\d+\)|(?:var)?(?:omega|phi|theta|alpha|beta|gamma|psi)(?:_|\s+(?:right|cdot|\)))).*|(?<![:/])//.*|/\*.{0,200}?\*/|\(\*.{0,200}?\*\)"
)
_DASHED = re.compile(r":[-–—](?=\s)")  # "Along the rod:- u = …": the dash is no minus
_STRUCK = re.compile(
    r"(?<!\S)~~(?=\S)[^~\n]{1,400}(?<=\S)~~(?!\w)(?:\s+(?:wrong|falsch|неверно|no)\b[^=]*$)?"
)  # struck out in Markdown; in TeX two blanks
# A term behind the sign of a comment: put away, or meant as well?
_COMMENTED_TERM = re.compile(r"(.*=[^=]*?[^=\s])\s*(?:#|%|//|/\*|\(\*|!)\s*([-+−–][\w\s.*·⋅^(){}\\]+?)(?:\*[/)])?\s*")
# What is said or asked of the equation before it; a term is neither.
_ASKED = re.compile(r"\s(?:<-{1,3}|←)\s(?!\s*[-+−–])(?=[^=]*$)|\s\?{2,9}(?!\s*[-+−–*/·])")
# Comments of Fortran, known by its words; and the names that a comment of any language explains.
_FORTRAN = re.compile(r"(?im)^[ \t]*(?:!|(?:subroutine|program|implicit|end|call|real|double precision)\b|d(?:sin|cos)\()|\s!\s")
_OF_FORTRAN = re.compile(r"(?:^|(?<=\s))!(?!=).*|^[Cc*](?:\s{2,}.*|\s*$)")
_COMMENT = re.compile(r"(?:^|\s)(?:#|%|//|!|/\*|\(\*|--|[Cc](?=\s{2}))++\s*+([^=]*+(?:=.*?)?)\s*(?:\*/|\*\))?$")
_LISTS = re.compile(r"(\w{1,20}(?:,\s?\w{1,20}){1,9})\s?=\s?(\w{1,20}(?:,\s?\w{1,20}){1,9})\.?")  # q1, q2 = phi1, phi2
_ALIAS = re.compile(r"\s*([^\W\d]\w{0,20})\s*=\s*([^\W\d]\w{0,20})\s*[.]?\s*")
_STAYS = r"=\s*(?:const\w*|konst\w*|cte|пост\w*)\b\.?"  # as x_P = const, …
_CONSTANT = re.compile(rf"\b\w{{1,12}}\s*{_STAYS},?")
_CONSTANT_TOO = re.compile(rf"(=\s*\w{{1,12}}|=[^=]{{1,200}}?(?=\s*=[^=]*$))\s*{_STAYS}(?:,\s*[^\W\d_]{{2,12}}\s*$)?")
_SAME_AS = re.compile(r"(?<==)([^=]{3,200})\s\(\s*=\s*([\w\s*/+^·-]{1,20})\)\s*[.;]?$")  # D = … (= s)
_BLOCK, _STARRED = re.compile(r"/\*((?:[^*]|\*(?!/))*+)(\*/|\Z)"), re.compile(r"^[ \t]*\*(?=\s)", re.MULTILINE)


def is_fortran(text: str) -> bool:
    """Return whether a text is a program in Fortran, whose comments begin otherwise."""
    return len(_FORTRAN.findall(text)) > 1


def without_blocks(text: str) -> str:
    """Return a text in which the lines of long comments, /* … */, are lines as elsewhere."""
    return _BLOCK.sub(_uncommented, text) if "/*" in text else text


def without_comments_of_fortran(line: str) -> str:
    """Return a line of Fortran without its comment."""
    return _OF_FORTRAN.sub("", line)


def without_remarks(line: str, is_name: Callable[[str], bool]) -> str:
    """Return a line without its number and the comment in it or behind it, unless the comment may be a term, // + r1*w1."""
    line = _NUMBERED.sub("", _STRUCK.sub("", _DASHED.sub(":", line)))
    term = _COMMENTED_TERM.fullmatch(line) if len(line) <= EQUATION_CHARACTERS else None
    words = re.findall(r"[^\W\d]\w*", term[2]) if term else []
    if term and words and all(map(is_name, words)):
        return f"{term[1]} // {term[2]}"  # a question: no reader understands it
    bare = _REMARK.sub("", line.partition("#")[0]).strip()
    if "=" in bare and len(line) <= EQUATION_CHARACTERS and is_judged(line.removeprefix(bare)):
        return line  # with what the comment says of it
    line = bare
    line = _SAME_AS.sub(r"\1 = \2", line) if len(line) <= EQUATION_CHARACTERS else line
    asked = _ASKED.search(line) if len(line) <= EQUATION_CHARACTERS else None
    return line[: asked.start()] if asked and "=" in line[: asked.start()] and not is_judged(line) else line


def without_constants(line: str) -> str:
    """Return a line of several equations without those that only say what stays as it is, x_P = const."""
    return _CONSTANT.sub("", _CONSTANT_TOO.sub(r"\1", line)) if line.count("=") > 1 else line


def names_said(line: str, spellings: Spellings) -> Iterator[str]:
    """Yield what a comment says of the student's names, big_r = R: the name, "=" and the task's name."""
    comment = _COMMENT.search(line) if len(line) <= EQUATION_CHARACTERS else None
    if comment and (both := _LISTS.fullmatch(comment[1])):
        own, theirs = (re.split(r"\s*,\s*", said) for said in both.groups())
        if len(own) == len(theirs) and all(map(spellings.angle, theirs)):
            yield from (f"{name} = {meant}" for name, meant in zip(own, theirs, strict=True) if spellings.angle(name) != meant)
            return
    for one in re.split("[,;]", comment[1]) if comment else ():
        found = _ALIAS.fullmatch(one)
        if found and spellings.angle(found[1]) is None and spellings.canonical(found[2]):
            yield f"{found[1]} = {found[2]}"


def _uncommented(block: re.Match[str]) -> str:
    r"""Return the lines of a comment of several lines, /* … */, without its signs; they are text as elsewhere."""
    said = block[1].lstrip("*")
    return _STARRED.sub("", said) if block[2] and "\n" in said else block[0]
