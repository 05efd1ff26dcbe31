"""Lines -> the lines as they are meant, each joined with the lines that continue it.

Enters: numbered lines, `Names`.  Leaves: the joined lines, each with the number of its first line.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from coursework.grading.reading.equations.formulas.equations import OWN_NAME, Names
from coursework.grading.reading.equations.notation.signs import VANISHED, depths
from coursework.grading.reading.equations.text.line_kinds import is_equation_without_sign, is_part_of_equation
from coursework.grading.reading.limits import EQUATION_CHARACTERS

_GOES_ON = re.compile(r"(?:(?<![-+*/=>\s])\s*[-+*/=−·(]|[\w)\]]\s*(?:\.{3}|…|\\|\s_)|[-+*/=−·(]\s*(?:\.{3}|…|\\|&|\s_))\s*$")
_OPEN_END = re.compile(r"=\s*(?:\.{3}|…)?\s*$|\s/\d{1,2}/\s*$")  # "= ..." before another equation says that it goes on elsewhere
_EMPHASISED = re.compile(r"\s*([*_]{1,3})(?=[^\W\d_])[^*=]{2,80}\1\s*")  # *Contact:* in Markdown
_OPENED = re.compile(r"=\s*0\s*[.,;]?\s*\(\s*$")
_FIXED = re.compile(r"^ {5}(?:&|[1-9+$*])\s*([-+*/(&][^=]*)$")  # the sixth column of Fortran: the statement goes on
_STATEMENT = " " * 6  # before the first line of one
_IMPORT = re.compile(r"\s*(?:from|import)\s+\w")  # from sympy import *
_GOES_ON_SIGN = re.compile(r"\s*(?:\.{3}|…|\\|&|\s_)\s*$")
_MARKED = re.compile(r"[\w)\]]\s*(?:\\|\.{3}|…)\s*$")
_BARE = re.compile(r"[^-+/−–\s]+")  # the names of a line with no other sign: "vC/a -"
_IS_FORMULA = re.compile(r"[=*·+(\\]|\d")
_BEGINS = re.compile(r"\s*[-+*/=−–]")
_ALIGNED = re.compile(r"^(?:\s|&|\\q?quad(?![A-Za-z])|\\[,;:! ]|\\hspace\*?\{[^{}]*\}|\{\})+")  # at the start of a continued line
_NEAR = 300  # characters at the end of what was joined: those of a thousand lines are not searched for each


def continued(lines: Iterable[tuple[int, str]], names: Names) -> Iterator[tuple[int, str]]:
    """Yield the lines, each joined with its continuation lines; a sign repeated at the line break is kept once."""
    first, kept = 0, ""
    is_part = False  # what was joined is known to be a part: it is not read again with each of a thousand terms
    for number, line in lines:
        if kept and line.strip() and len(kept) < EQUATION_CHARACTERS and _goes_on(kept, line, names, is_part):
            begun = (kept[:-_NEAR] + _GOES_ON_SIGN.sub("", kept[-_NEAR:])).rstrip()
            # The sixth sign of such a line is no part of the equation where the first one begins in the seventh column.
            mark = _FIXED.match(line) if kept.startswith(_STATEMENT) else None
            rest = _ALIGNED.sub("", mark[1] if mark else line)
            is_part = "=" not in kept and _BEGINS.match(rest) is not None and is_part_of_equation(rest, names)
            kept = f"{begun} {rest[1:] if begun[-1:] == rest[:1] and _BEGINS.match(rest) else rest}".rstrip()
            continue
        if kept:
            yield first, kept
        first, kept, is_part = number, line, False
    if kept:
        yield first, kept


def _goes_on(kept: str, line: str, names: Names, is_part: bool) -> bool:
    """Return whether `line` continues `kept`: `kept` ends with a sign or in an open parenthesis, or `line` begins with a sign.

    `is_part` says that `kept` is known to be a part of an equation.
    """
    if _FIXED.match(line) and "=" in kept:
        return True
    near = max(len(kept) - _NEAR, 0)
    if _EMPHASISED.fullmatch(kept) or _OPENED.search(kept, near) or not any(map(str.isalnum, kept)):
        return False  # "= 0 (": a remark begins, or nothing
    if _IMPORT.match(kept) or not (_IS_FORMULA.search(kept) or all(map(names.spellings.canonical, _BARE.findall(kept[:_NEAR])))):
        return False
    if kept.lstrip().startswith("[[") and depths(kept)[-1]:
        return True
    both = "=" in kept and "=" in line
    is_open = kept.count("(") + kept.count("[") > kept.count(")") + kept.count("]")
    if both and _MARKED.search(kept, near) and not is_open and not _BEGINS.match(_ALIGNED.sub("", line)):
        return False  # in Typst the sign ends a line; "= u ..." leads to the number of the equation
    if _GOES_ON.search(kept, near):
        return not ("=" in line and _OPEN_END.search(kept, near))
    if "=" in kept and not both and kept.count("(") > kept.count(")"):
        return True
    rest = _ALIGNED.sub("", line)
    if both and rest.startswith("=") and rest != line and not kept.startswith("=") and not VANISHED.search(kept):
        return True  # another side of the same equation
    if both and rest[:1] == "+" and kept.count("=") == line.count("=") == 1 and not VANISHED.search(kept):
        name = kept.partition("=")[0].strip()  # V_C = a … + b = 0
        return OWN_NAME.fullmatch(name) is not None and names.spellings.canonical(name) not in names.expected.variant.sought
    if both or not _BEGINS.match(rest):
        return False
    if "=" in line:
        return line[:1].isspace() or is_part or is_part_of_equation(kept, names)
    if "=" not in kept and rest.startswith("+") and (is_part or is_part_of_equation(kept, names)):
        return True
    rest += ")" * (rest.count("(") - rest.count(")"))  # of a quotient whose denominator goes on in the next line
    return "=" in kept and not VANISHED.search(kept) and is_equation_without_sign(rest, names)
