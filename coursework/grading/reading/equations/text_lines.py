"""A text -> its lines as they are meant, without comments, statements of programs and quotation marks, continuations joined.

Enters: a text as decoded, `Names`.  Leaves: pairs of the number of a line, from 1, and the line; one may hold several equations.
Used by `lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import partial

from coursework.grading.reading.equations.equations import TURNED, Names, names_in, read_as_one
from coursework.grading.reading.equations.line_kinds import (
    is_equation_without_sign,
    is_part_of_equation,
    is_statement,
    without_line_numbers,
)
from coursework.grading.reading.equations.names_in_text import Spellings
from coursework.grading.reading.equations.notation.escapes import unquoted, with_line_ends
from coursework.grading.reading.equations.notation.latex import logical_lines
from coursework.grading.reading.equations.notation.signs import VANISHED, depths, relates_two_sides, relations
from coursework.grading.reading.equations.systems.cells import with_cells_named
from coursework.grading.reading.equations.systems.components import by_components, in_one_vector
from coursework.grading.reading.equations.systems.drawn import in_one_line
from coursework.grading.reading.equations.systems.matrices import in_rows
from coursework.grading.reading.equations.systems.of_c import without_pointers
from coursework.grading.reading.equations.systems.own_functions import as_names
from coursework.grading.reading.equations.systems.parts import LIST, at_commas, of_row
from coursework.grading.reading.equations.systems.round_matrices import in_square_brackets
from coursework.grading.reading.equations.systems.vectors import with_entries_named, with_short_names
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.variant.dimensions.formulas import Clash, Measurer
from coursework.variant.record.places import measures
from coursework.words.errors import Fault

# Rows of empty cells, of which a spreadsheet may leave a million, and blanks longer than anybody types: patterns would be slow.
_BLANKS = re.compile(r"^[;,\t ]++$|(?<=[^\S\n]{40})[^\S\n]+", re.MULTILINE)
_GOES_ON = re.compile(r"(?:(?<![-+*/=>\s])\s*[-+*/=−·(]|[\w)\]]\s*(?:\.{3}|…|\\|\s_)|[-+*/=−·(]\s*(?:\.{3}|…|\\|&|\s_))\s*$")
_FIXED = re.compile(r"^ {5}(?:&|[1-9+$*])\s*(?=[-+*/(]|&)[^=]*$")  # the sixth column of Fortran: the statement goes on
_IMPORT = re.compile(r"\s*(?:from|import)\s+\w")  # from sympy import *
_GOES_ON_SIGN = re.compile(r"\s*(?:\.{3}|…|\\|&|\s_)\s*$")
_MARKED = re.compile(r"[\w)\]]\s*\\\s*$")
_BARE = re.compile(r"[^-+/−–\s]+")  # the names of a line with no other sign: "vC/a -"
_IS_FORMULA = re.compile(r"[=*·+(\\]|\d")
_BEGINS = re.compile(r"\s*[-+*/=−–]")
_ALIGNED = re.compile(r"^(?:\s|&|\\q?quad(?![A-Za-z])|\\[,;:! ]|\\hspace\*?\{[^{}]*\}|\{\})+")  # at the start of a continued line
_NUMBERED = re.compile(r"^\s*(?:\(?\d{1,3}\)?\s*#|#\d{1,3}[.:)]?\s)")  # the number of a line; a comment starts with # alone
_TYPED = re.compile(
    r"\b(\w{1,40})\s*:\s*(?:[dD]ouble|[fF]loat|real|extended|integer|f64|f32|number)\s*="
)  # a declaration in Pascal, Rust, Python
_DECLARED = re.compile(r"^(?:static\s+)?(?:const|let|LET|var|double|float|int)\s+(?=\w{1,40}\s*=)")
# An equation that is assigned to a name: eq[1] := …, eq||1 := … in Maple, F(1) = … == … in MATLAB.
_KEPT = re.compile(
    r">?\s*([^\W\d]\w{0,20})(?:[\[({]\s*|\|\|)(\d{1,3})\s*[\])}]?\s*(?::=\s*(?=[^=]+=)|(=)(?!=)\s*(?=[^=]+==[^=]+$))"
)
# A function of a program, and the expression it returns.
_DEFINED = re.compile(
    r"\s*(?:def\s+(\w{1,40})\s*\([^()]*\)[^:()]{0,40}:|(?:[a-z]{2,9}\s+){0,2}(?:double|float|function|fn|func)\s+(\w{1,40})\s*\([^()]*\)"
    r"[^(){}=]{0,20}\{?)\s*(return\b[^}]*)?\}?\s*"
)
# A function without a name of its own: w3 = (t, y) => … in JavaScript, w3 <- function(t) … in R.
_UNNAMED = re.compile(
    r"^(?:(?:const|let|var)\s+)?(\w{1,40})\s*(?:=|<-)\s*(?:(?:\([\w\s,]*\)|\w{1,20})\s*=>|function\s*\([\w\s,]*\))\s*\{?\s*(?:return\s+)?"
    r"(?=[^{\[\s][^={}]*[*/])|\s*\}\s*;?\s*$"
)
# What a solver of Mathematica finds, {{w3 -> a*b, …}}, and what a calculator stores, a*b→w3.
_FOUND, _RULE = re.compile(r"\s*\{+\s*\w{1,20}\s*(?:->|→)[^=]*$"), re.compile(r"(?<=[{\s,])(\w{1,20})\s*(?:->|→)")
_STORED = re.compile(r"([^=→]*[*/][^=→]*?)\s*(?:→|->)\s*([^\W\d]\w{0,8})\s*;?\s*")
_RETURNED = re.compile(r"return\s+(?=\S)(?!.*=)")
_REMARK = re.compile(
    r"(?<!\\)%(?![io]\d+\)|(?:var)?(?:omega|phi|theta|alpha|beta|gamma|psi)(?:_|\s+(?:right|cdot|\)))).*|(?<![:/])//.*|/\*.{0,200}?\*/|\(\*.{0,200}?\*\)"
)

# Comments of Fortran, known by its words; and the names that a comment of any language explains.
_FORTRAN = re.compile(r"(?im)^[ \t]*(?:!|(?:subroutine|program|implicit|end|call|real|double precision)\b|d(?:sin|cos)\()|\s!\s")
_OF_FORTRAN = re.compile(r"(?:^|(?<=\s))!(?!=).*|^[Cc*](?:\s{2,}.*|\s*$)")
_COMMENT = re.compile(r"(?:^|\s)(?:#|%|//|!|/\*|\(\*|--|[Cc](?=\s{2}))+\s*([^=]*=.*?)\s*(?:\*/|\*\))?$")
_ALIAS = re.compile(r"\s*([^\W\d]\w{0,20})\s*=\s*([^\W\d]\w{0,20})\s*[.]?\s*")
_TAKEN = re.compile(
    r"(?m)^[ \t]*(?:\w{1,20}\s*=\s*)?\{[\w\s,]{1,80}\}\s*/\.\s*(?=(?:\w{4,7}\[)?N?Solve\[)"
)  # {w2, w3} /. Solve[…]
_CONSTANT = re.compile(r"\b\w{1,12}\s*=\s*(?:const\w*|konst\w*|cte|пост\w*)\b\.?,?")  # as x_P = const, …
_COLON = re.compile(r"\s*([^\W\d][\w.]{0,12})\s*:\s*(?!=)([^=:]*[*/][^=:]*)")  # v.P:c*ω.3*cos(φ.3)
_KEYED = re.compile(
    r"^\s*(?:return|[\w.]{1,20}\s*=)\s*\{[\w\s,]*?,?\s*(\w{1,12}\s*:[^{}:]+)\}[;\s]*$"
)  # return {w2, w3, vP: c*w3*…}
_BLOCK, _STARRED = re.compile(r"/\*+((?:[^*]|\*(?!/))*)\*/"), re.compile(r"^[ \t]*\*(?=\s)", re.MULTILINE)
_NUMBER = re.compile(r"\s*-?\d+\.?\d*\s*")
_UNPACKED = re.compile(r"\(?[^\W\d]\w{0,20}(?:\s*,\s*[^\W\d]\w{0,20})+\)?\s*:?=")  # a11, a12 = …, …
# Slashes and dots between the equations of one line, a = b / c = d.
_TWO = re.compile(r"(?<=[^\s:;/{}])\s*//\s*(?=[^\s/])")
_SQUARED = re.compile(
    r"([^\W\d]\w{0,20})\s*(?:\^\s*\{?\s*2\s*\}?|²|\*\*\s*2)\s*=\s*([^=]+?)[\s.,;]*"
)  # DA² = … by the law of cosines
_MOST_SLASHES = 20  # slashes of a line
_ONE = re.compile(r"(?<=\S)\s+[/•·∙⋅●]\s+(?=\S)")


def text_lines(text: str, names: Names) -> Iterator[tuple[int, str]]:
    """Yield (number, line) of the lines that are neither blank nor comments nor statements of a program."""
    function, is_fortran = "", len(_FORTRAN.findall(text)) > 1
    text, numbers = with_line_ends(_BLANKS.sub("", text))
    text = _BLOCK.sub(_uncommented, text) if "/*" in text else text
    for place, line in _continued(logical_lines(_by_names(text, names)), names):
        number = numbers[place - 1] if numbers else place
        if defined := _DEFINED.fullmatch(line):
            called = defined[1] or defined[2]
            meant = [one for one in called.split("_") if one in names.expected.variant.sought]  # w3 in calc_w3
            function = f"{meant[0] if len(meant) == 1 else called} = "
            line = defined[3] or ""
        yield from ((number, said) for said in _called(line, names.spellings))
        line = _OF_FORTRAN.sub("", line) if is_fortran else line
        bare = _REMARK.sub("", _NUMBERED.sub("", _parted(line, names)).partition("#")[0]).strip()
        bare = unquoted(_CONSTANT.sub("", bare) if bare.count("=") > 1 else bare)
        if "→" in bare or "->" in bare:
            bare = _RULE.sub(r"\1 = ", bare.strip("{} ").join("{}")) if _FOUND.match(bare) else bare
            bare = f"{stored[2]} = {stored[1]}" if (stored := _STORED.fullmatch(bare)) else bare
        bare = _UNNAMED.sub(lambda found: f"{found[1]} = " if found[1] else "", bare) if _UNNAMED.match(bare) else bare
        bare = _DECLARED.sub("", _TYPED.sub(r"\1 =", bare))
        if (under := _KEPT.match(bare)) and (under[3] or names.spellings.angle(under[1] + under[2]) is None):
            bare = bare[under.end() :]
        bare = _one_by_one(bare) if _UNPACKED.match(bare) else bare
        bare = by_components(in_one_vector(bare), names.spellings.canonical) if "[" in bare else bare
        if is_statement(bare, names.expected.variant.sought):
            continue
        bare = of_row(bare.strip("'") if bare.startswith("'") else bare)
        if returned := _RETURNED.match(bare):
            rest = bare[returned.end() :]  # a list of residuals is not the value of a name
            is_value = TURNED.search(rest) or function.partition(" ")[0] in names.expected.variant.sought
            bare = f"{function if is_value and not rest.startswith('[') else ''}{rest}"
        bare = _with_sign(bare, names.expected.variant.sought, names.spellings)
        if (square := _SQUARED.fullmatch(bare)) and names.spellings.canonical(square[1]) is None:
            bare = f"{square[1]} = sqrt({square[2]})"
        bare = _closed(bare)
        if any(map(str.isalnum, bare)):  # not an underline of signs below a title
            yield number, bare


def _with_sign(line: str, sought: Sequence[str], spellings: Spellings) -> str:
    """Return a line of a sought velocity, a colon and its formula, as SMath and the objects of JavaScript have it, with "="."""
    if keyed := _KEYED.search(line):
        line = keyed[1]
    found = _COLON.fullmatch(line)
    meant = spellings.canonical(found[1].replace(".", "")) if found else None
    return f"{found[1]} = {found[2]}" if found and meant in sought else line


def _is_name(names: Names, word: str) -> bool:
    """Return whether a word has a meaning; B is a name of the student where the task has a datum b."""
    spellings = names.spellings
    return names.is_name(word) and not (spellings.canonical(word) in spellings.data and spellings.known_as(word) is None)


def _called(line: str, spellings: Spellings) -> Iterator[str]:
    """Yield what a comment says of the student's names, big_r = R: the name, "=" and the task's name."""
    comment = _COMMENT.search(line) if len(line) <= EQUATION_CHARACTERS else None
    for one in re.split("[,;]", comment[1]) if comment else ():
        found = _ALIAS.fullmatch(one)
        if found and spellings.angle(found[1]) is None and spellings.canonical(found[2]):
            yield f"{found[1]} = {found[2]}"


def _uncommented(block: re.Match[str]) -> str:
    r"""Return the lines of a comment of several lines, /* … */, without its signs; they are text as elsewhere."""
    return _STARRED.sub("", block[1]) if "\n" in block[1] else block[0]


def _one_by_one(line: str) -> str:
    """Return a line that sets several names at once with a formula for each of them.

    >>> _one_by_one("a, b = 2*c, d*max(e, f)"), _one_by_one("r, l = 0.5, 2"), _one_by_one("phi1, phi2 = y")
    ('a = 2*c; b = d*max(e, f)', 'r = 0.5; l = 2', 'phi1, phi2 = y')
    """
    left, _, right = line.strip(" ;").partition("=")
    named, values = left.strip("() ").split(","), at_commas(right)
    is_data = all(map(_NUMBER.fullmatch, values))
    if len(named) != len(values) or not ("*" in right or is_data) or "=" in right:
        return line
    return "; ".join(f"{name.strip()} = {value.strip()}" for name, value in zip(named, values, strict=True))


def _by_names(text: str, names: Names) -> str:
    """Return a text with matrix systems written as equations and with names in place of vector entries."""
    variant = names.expected.variant
    text = _TAKEN.sub("", text) if "/." in text else text
    text = with_cells_named(text, names.spellings.angle, names.spellings.data)
    text = without_pointers(text, names.spellings)
    rows = in_rows(
        in_square_brackets(in_one_line(as_names(without_line_numbers(text), partial(_is_name, names)))), variant.sought
    )
    return with_entries_named(with_short_names(rows, variant, names.spellings), variant, names.spellings)


def _closed(line: str) -> str:
    """Return a line without the bracket of a list that opens in it and closes in a later line, or that closes in it.

    >>> _closed("eqs = {a == b,"), _closed("c == d}, {x, y}]"), _closed("[a = b]")
    ('a == b,', 'c == d', '[a = b]')
    """
    inside = depths(line)
    if (begun := LIST.match(line)) and inside[-1] == inside[begun.end() - 1] > 0:
        return line[begun.end() :].strip()
    end = inside.index(-1) if -1 in inside else 0
    return line[:end].strip() if line[end : end + 1] in {"]", "}"} and not relates_two_sides(line[end:]) else line


def _continued(lines: Iterable[tuple[int, str]], names: Names) -> Iterator[tuple[int, str]]:
    """Yield the lines, each joined with its continuation lines; a sign repeated at the line break is kept once."""
    first, kept = 0, ""
    for number, line in lines:
        if kept and line.strip() and len(kept) < EQUATION_CHARACTERS and _goes_on(kept, line, names):
            begun = _GOES_ON_SIGN.sub("", kept).rstrip()
            rest = _ALIGNED.sub("", line)
            kept = f"{begun} {rest[1:] if begun[-1:] == rest[:1] and _BEGINS.match(rest) else rest}".rstrip()
            continue
        if kept:
            yield first, kept
        first, kept = number, line
    if kept:
        yield first, kept


def _goes_on(kept: str, line: str, names: Names) -> bool:
    """Return whether `line` continues `kept`: `kept` ends with a sign or in an open parenthesis, or `line` begins with a sign."""
    if _FIXED.match(line) and "=" in kept:
        return True
    if _IMPORT.match(kept) or not (_IS_FORMULA.search(kept) or all(map(names.spellings.canonical, _BARE.findall(kept)))):
        return False
    if kept.lstrip().startswith("[[") and depths(kept)[-1]:
        return True
    both = "=" in kept and "=" in line
    if both and _MARKED.search(kept) and not _BEGINS.match(_ALIGNED.sub("", line)):
        return False  # in Typst the sign ends a line
    if _GOES_ON.search(kept):
        return not (kept.rstrip().endswith("=") and "=" in line)
    if "=" in kept and not both and kept.count("(") > kept.count(")"):
        return True
    rest = _ALIGNED.sub("", line)
    if both and rest.startswith("=") and rest != line and not kept.startswith("=") and not VANISHED.search(kept):
        return True  # another side of the same equation
    if both or not _BEGINS.match(rest):
        return False
    if "=" in line:
        return line[:1].isspace() or is_part_of_equation(kept, names)
    rest += ")" * (rest.count("(") - rest.count(")"))  # of a quotient whose denominator goes on in the next line
    return "=" in kept and not VANISHED.search(kept) and is_equation_without_sign(rest, names)


def _parted(text: str, names: Names) -> str:
    """Return a line with semicolons for slashes and dots between its equations; what stands behind // is else a remark."""
    if len(text) > EQUATION_CHARACTERS:
        return text
    pieces = _TWO.split(text) if "//" in text else []
    if pieces and all(_is_one(piece, names) for piece in pieces):
        return "; ".join(pieces)
    return "; ".join(_at_slashes(text, names)) if _ONE.search(text) else text


def _is_one(text: str, names: Names) -> bool:
    """Return whether a text may be an equation by itself: it relates two sides and names a sought velocity and something else."""
    named = names_in(text, names.spellings) if relates_two_sides(text) else set[str]()
    return len(named) > 1 and not named.isdisjoint(names.expected.variant.sought)


def _at_slashes(text: str, names: Names) -> list[str]:
    """Return the equations of a line that slashes or dots part.

    In a = b / c = d the slash divides if a and b / c can have one unit, and parts two equations if only a and b can. If neither
    can, nothing is right in which it divides: it parts the two, if it is the only one and each may be an equation by itself.
    """
    inside, signs = depths(text), relations(text)
    pieces, start = list[str](), 0
    slashes = [found for found in _ONE.finditer(text) if inside[found.start()] == 0]
    for found in slashes if len(signs) > 1 and len(slashes) <= _MOST_SLASHES else ():
        before = max((sign for sign in signs if sign < found.start()), default=-1)
        behind = min((sign for sign in signs if sign > found.start()), default=-1)
        if before < start or behind < 0 or not _is_one(text[found.end() :], names):
            continue
        alone = sum(before < other.start() < behind for other in slashes) == 1
        parts = text[start:before], text[before : found.start()], text[found.end() : behind]
        is_zero = "0" in {part.strip("= ") for part in parts}
        divides = not is_zero and _has_one_unit(text[start:behind], names)
        if not divides and (
            _has_one_unit(text[start : found.start()], names) or (alone and _is_one(text[start : found.start()], names))
        ):
            pieces.append(text[start : found.start()])
            start = found.end()
    return [*pieces, text[start:]]


def _has_one_unit(text: str, names: Names) -> bool:
    """Return whether a text can be read as an equation whose terms all have one unit."""
    read = read_as_one(text.rstrip(" :<"), names)
    if isinstance(read, Fault):
        return False
    units = measures(names.expected.variant)
    try:
        Measurer(units, frozenset(units)).measure(read.tree)  # beside any name a number is a plain one
    except Clash:
        return False
    return True
