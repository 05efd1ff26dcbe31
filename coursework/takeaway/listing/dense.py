"""Shortens a listing that is longer than a page: short assignments share a line, comments of boxes move behind a line of code.

Enters: lines.  Leaves: fewer lines that say the same.  Used by `listings.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from coursework.takeaway.listing.syntax import Syntax

MOST = 80  # lines that a page holds
WIDEST = 100  # letters of a line
WIDER = 120  # the same, with no empty lines, if nothing else helps
_SET = re.compile(r"(?:static double )?\w+(?:: double)? :?= [^;=\"']*;?")


def dense(lines: list[str], syntax: Syntax) -> list[str]:
    """Return lines, made fewer if there are more than `MOST`.

    >>> from coursework.takeaway.listing.syntax import syntax_of
    >>> closer(["a = b;", "c = d;"], syntax_of("c"), WIDEST), behind(["// 4 t = i·h", "t = i*h;"], syntax_of("c"), WIDEST)
    (['a = b; c = d;'], ['t = i*h;  // 4 t = i·h'])
    """
    if len(lines) > MOST:
        lines = closer(lines, syntax, WIDEST)
    if len(lines) > MOST:
        lines = behind(lines, syntax, WIDEST)
    return lines if len(lines) <= MOST else [line for line in behind(closer(lines, syntax, WIDER), syntax, WIDER) if line]


def closer(lines: list[str], syntax: Syntax, widest: int) -> list[str]:
    """Return lines in which successive short assignments share a line; of data only those with the same comment."""

    def joined(above: str, line: str) -> str:
        text, said = _parts(line, syntax)
        before, told = _parts(above, syntax)
        fits = said == told and _is_set(text) and _is_set(before) and _margin(text) == _margin(before)
        return f"{before}{'' if before.endswith(';') else ';'} {text.lstrip()}{said}" if fits else ""

    return _merged(lines, joined, widest)


def behind(lines: list[str], syntax: Syntax, widest: int) -> list[str]:
    """Return lines in which a box's comment stands behind the line below it, if both fit."""

    def joined(above: str, line: str) -> str:
        named = re.match(rf" *{re.escape(syntax.comment)}\d+ ", above)
        is_free = line.strip() and not line.lstrip().startswith(syntax.comment) and not _parts(line, syntax)[1]
        return f"{line}  {above.lstrip()}" if named and is_free and _margin(above) == _margin(line) else ""

    return _merged(lines, joined, widest)


def _merged(lines: list[str], joined: Callable[[str, str], str], widest: int) -> list[str]:
    """Return lines, each merged with the one above if `joined` allows it and the result is not too wide."""
    found: list[str] = []
    for line in lines:
        both = joined(found[-1], line) if found else ""
        if both and len(both) <= widest:
            found[-1] = both
        else:
            found.append(line)
    return found


def _parts(line: str, syntax: Syntax) -> tuple[str, str]:
    """Return the code of a line and the comment behind it."""
    text, mark, said = line.partition(f"  {syntax.comment}")
    return (text, mark + said) if text.strip() else (line, "")


def _margin(line: str) -> int:
    return len(line) - len(line.lstrip())


def _is_set(line: str) -> bool:
    """Return whether a line consists of whole assignments."""
    return all(_SET.fullmatch(one.strip()) and one.count("(") == one.count(")") for one in line.rstrip(";").split(";"))
