"""A text, line by line -> the equations and answers in it, whether it has a table beside them or not.

Enters: decoded text, `Expected`, how the table in the text was read (if any).  Leaves: `Lines`.
Used by `read_submission.py`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice

from coursework.grading.reading.equations.answers import read_answer
from coursework.grading.reading.equations.equations import TURNED, Names, most_lines, names_for, names_in, names_of, read_line
from coursework.grading.reading.equations.legends import with_legend
from coursework.grading.reading.equations.line_kinds import (
    definition,
    is_datum,
    is_equation_without_sign,
    is_part_of_equation,
    is_row,
    is_statement,
    is_step,
    no_velocity,
    own_name,
    parted,
    sign_of_list,
    without_line_numbers,
)
from coursework.grading.reading.equations.names_in_text import plain_name
from coursework.grading.reading.equations.notation.latex import logical_lines
from coursework.grading.reading.equations.notation.signs import depths, plain_signs, relates_two_sides
from coursework.grading.reading.equations.systems.complex_lines import real_and_imaginary
from coursework.grading.reading.equations.systems.drawn import in_one_line
from coursework.grading.reading.equations.systems.matrices import in_rows
from coursework.grading.reading.equations.systems.parts import LIST, of_row, parts_of
from coursework.grading.reading.equations.systems.vectors import with_entries_named
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.student_work import AnswerLine, EquationLine, Reading
from coursework.grading.reading.unit_names import unit_of
from coursework.variant.formula.reader import MAX_CHARACTERS
from coursework.variant.formula.tree import Formula

_SIGNS = {";": ";", "tab": "\t"}  # not the comma or the blank, which also occur in equations
_WORD = re.compile(r"[^\W\d]\w*")
# Rows of empty cells, of which a spreadsheet may leave a million, and blanks longer than anybody types: patterns would be slow.
_BLANKS = re.compile(r"^[;,\t ]++$|(?<=[^\S\n]{40})[^\S\n]+", re.MULTILINE)
# Of a table, with nothing but numbers.
_ROW = re.compile(r"^[-+−]?\d[^;\t ,\n]*+(?:[;\t ]|,[^,\n]*+,)[-+−\d.,eE;\t ]*+$", re.MULTILINE)
_EDGES = " \t;,\"'"  # signs that a spreadsheet puts around a line typed into one cell
_GOES_ON = re.compile(r"(?:(?<![-+*/=>\s])\s*[-+*/=−·(]|[\w)\]]\s*(?:\.{3}|…|\\|\s_)|[-+*/=−·(]\s*(?:\.{3}|…|\\|&|\s_))\s*$")
_IMPORT = re.compile(r"\s*(?:from|import)\s+\w")  # from sympy import *
_GOES_ON_SIGN = re.compile(r"\s*(?:\.{3}|…|\\|&|\s_)\s*$")
_BARE = re.compile(r"[^-+/−–\s]+")  # the names of a line with no other sign: "vC/a -"
_IS_FORMULA = re.compile(r"[=*·+(\\]|\d")
_BEGINS = re.compile(r"\s*[-+*/=−–]")
_ALIGNED = re.compile(r"^(?:\s|&|\\q?quad(?![A-Za-z])|\\[,;:! ]|\\hspace\*?\{[^{}]*\}|\{\})+")  # at the start of a continued line
_VANISHED = re.compile(r"(?:[=≡]|\\equiv)\s*0(?:[.,]0*)?\s*[.,;]?\s*(?:\\\w+\s*)*$")
_MEASURED, _CHECKED = re.compile(r"\d[.,]\d\d"), re.compile(r"[=≈]\s*[-+−]?\d+[.,]\d\d+(?:\s+[^\s\d]\S{0,7})?[.,;]?\s*$")
_UNIT_BEHIND = re.compile(r"\d\s+(\S{1,8}?)[.,;]?\s*$")
_NUMBERED = re.compile(r"^\s*(?:\(?\d{1,3}\)?\s*#|#\d{1,3}[.:)]?\s)")  # the number of a line; a comment starts with # alone
_TYPED = re.compile(
    r"\b(\w{1,40})\s*:\s*(?:[dD]ouble|[fF]loat|real|extended|integer|f64|f32|number)\s*="
)  # a declaration in Pascal, Rust, Python
_DECLARED = re.compile(r"^(?:static\s+)?(?:const|let|var|double|float|int)\s+(?=\w{1,40}\s*=)")
# An equation that is assigned to a name: eq[1] := …, eq||1 := … in Maple, F(1) = … == … in MATLAB.
_KEPT = re.compile(
    r">?\s*([^\W\d]\w{0,20})(?:[\[({]\s*|\|\|)(\d{1,3})\s*[\])}]?\s*(?::=\s*(?=[^=]+=)|(=)(?!=)\s*(?=[^=]+==[^=]+$))"
)
_FUNCTION = re.compile(r"\\?(?:sin|cos|tan|sqrt|cdot|times)(?![a-z])|(?<=\d)[eE](?=[-+]?\d)")
_ANALOG = re.compile(r"(?<![^\W\d_])d\s*[^\W\d]\w*\s*\)?\s*/\s*\(?\s*d\s*(?!t\b)[^\W\d]")
# A function of Python or C, and the expression it returns.
_DEFINED = re.compile(
    r"\s*(?:def\s+(\w{1,40})\s*\([^()]*\)[^:()]{0,40}:|(?:static\s+)?(?:double|float)\s+(\w{1,40})\s*\([^()]*\)\s*\{?)\s*(return\b[^}]*)?\}?\s*"
)
_RETURNED = re.compile(r"return\s+(?=\S)(?!.*=)")
_GATHERED = re.compile(r"(?:\breturn\s+|(?<!atan2)[\[({]\s*)(?:\w{1,20}\s*[,;]\s*)+\w{1,20}\s*(?:[\])}]|$)")
_KEY = re.compile(r"\s*[\"'][\w .]{1,20}[\"']\s*(?::|=>)\s*(?=[\"'])")  # "11": "w1 = …",
_QUOTES = '"“”„«»`'
_REMARK = re.compile(
    r"(?<!\\)%(?![io]\d+\)|(?:var)?(?:omega|phi|theta|alpha|beta|gamma|psi)(?:_|\s+(?:right|cdot|\)))).*|(?<![:/])//.*|/\*.{0,200}?\*/|\(\*.{0,200}?\*\)"
)
# Limits on time: per equation that may be handed in, so many lines of a text are tried; in all, so many characters.
_TRIED, _CHARACTERS = 10, 60_000
_MOST_LINES, _MOST_DEFINITIONS, _PASSES = 20_000, 100, 3


@dataclass(slots=True)
class Lines:
    """The equations and answers of a text; `unread` counts the lines with "=" that were not tried."""

    equations: list[EquationLine] = field(default_factory=list)
    answers: list[AnswerLine] = field(default_factory=list)
    unread: int = 0


_Kept = Callable[[EquationLine], EquationLine | None]


def read_lines(text: str, name: str, expected: Expected, beside: Reading | None = None, kept: _Kept | None = None) -> Lines:
    """Return the equations and answers in a text; `#` begins a comment, prose without "=" is skipped.

    `beside` is the table in the same text, None if it has none.  Its rows are skipped and do not count as lines that were tried.
    Its titles may contain "=" too (`h = 0.02 s`, `w1 = 13.08`), so beside a table a line is an equation only if it names a sought
    velocity and something that this depends on; unreadable lines are kept only if others can be read.  `kept` filters the lines
    of a document, where "=" is frequent: it returns the line to keep, or None, and then the line does not count as an equation.
    """
    most = most_lines(expected)
    names = names_for(expected)
    pieces = _pieces(text, names) if beside is None else _beside(text, names, _SIGNS.get(beside.separator))
    names, lines = with_legend(list(islice(pieces, _MOST_LINES)), names)
    own = _definitions(lines, names) if beside is None else {}
    with_own = replace(
        names,
        own=own,
        spellings=replace(names.spellings, own=own),
        listed=sign_of_list([line for _, line in lines if relates_two_sides(line[:MAX_CHARACTERS])], names.spellings.canonical),
    )
    found, answers = Lines(), dict[str, AnswerLine]()
    tried = characters = 0
    defined = set[str]()
    for number, line in lines:
        tried, characters = tried + 1, characters + min(len(line), MAX_CHARACTERS)
        if tried > _TRIED * most or characters > _CHARACTERS or len(found.equations) > most:
            found.unread += "=" in line
        elif expected.answers and (answer := read_answer(line[:500], expected.answers)):
            answers.setdefault(answer.name, answer)
        elif beside is None and (
            _defines(line, own, names, defined) or is_datum(line, names) or is_step(line, names) or is_row(line)
        ):
            continue
        elif beside is None and _is_equation(line, names):
            read = read_line(line, name, number, with_own)
            found.equations += [read] if kept is None else [one for one in [kept(read)] if one]
        elif beside is not None and relates(read := read_line(line, name, number, names), names):
            found.equations.append(read)
    if beside is not None and all(line.tree is None for line in found.equations):
        found.equations = []
    checks = [_is_of_one_row(line, names) for line in found.equations]
    if not all(checks):  # some lines are true equations
        found.equations = [
            replace(line, may_be_datum=line.may_be_datum or one) for line, one in zip(found.equations, checks, strict=True)
        ]
    found.answers = [*answers.values()]
    return found


def _written(text: str, names: Names) -> Iterator[tuple[int, str]]:
    """Yield (number, line) of the lines that are neither blank nor comments nor statements of a program."""
    function = ""
    for number, line in _continued(logical_lines(_by_names(_BLANKS.sub("", text), names)), names):
        if defined := _DEFINED.fullmatch(line):
            called = defined[1] or defined[2]
            meant = [one for one in called.split("_") if one in names.expected.variant.sought]  # w3 in calc_w3
            function = f"{meant[0] if len(meant) == 1 else called} = "
            line = defined[3] or ""
        bare = _REMARK.sub("", _NUMBERED.sub("", parted(line, names)).partition("#")[0]).strip()
        bare = bare if '_"' in bare else _KEY.sub("", bare).strip(_QUOTES + " ,")  # but V_"Mx" has an index in Typst
        bare = _DECLARED.sub("", _TYPED.sub(r"\1 =", bare))
        if (under := _KEPT.match(bare)) and (under[3] or names.spellings.angle(under[1] + under[2]) is None):
            bare = bare[under.end() :]
        if is_statement(bare, names.expected.variant.sought):
            continue
        bare = of_row(bare.strip("'") if bare.startswith("'") else bare)
        if returned := _RETURNED.match(bare):
            rest = bare[returned.end() :]  # a list of residuals is not the value of a name
            is_value = TURNED.search(rest) or function.partition(" ")[0] in names.expected.variant.sought
            bare = f"{function if is_value and not rest.startswith('[') else ''}{rest}"
        bare = _closed(bare)
        if any(map(str.isalnum, bare)):  # not an underline of signs below a title
            yield number, bare


def _by_names(text: str, names: Names) -> str:
    """Return a text with matrix systems written as equations and with names in place of vector entries."""
    rows = in_rows(in_one_line(without_line_numbers(text)), names.expected.variant.sought)
    return with_entries_named(rows, names.expected.variant, names.spellings)


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
        if kept and line.strip() and len(kept) < MAX_CHARACTERS and _goes_on(kept, line, names):
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
    if _IMPORT.match(kept) or not (_IS_FORMULA.search(kept) or all(map(names.spellings.canonical, _BARE.findall(kept)))):
        return False
    if kept.lstrip().startswith("[[") and depths(kept)[-1]:
        return True
    both = "=" in kept and "=" in line
    if _GOES_ON.search(kept):
        return not (kept.rstrip().endswith("=") and "=" in line)
    if "=" in kept and not both and kept.count("(") > kept.count(")"):
        return True
    rest = _ALIGNED.sub("", line)
    if both or not _BEGINS.match(rest):
        return False
    if "=" in line:
        return line[:1].isspace() or is_part_of_equation(kept, names)
    return "=" in kept and not _VANISHED.search(kept) and is_equation_without_sign(rest, names)


def _pieces(text: str, names: Names) -> Iterator[tuple[int, str]]:
    """Yield the equations and answers; one line may contain several."""
    for number, line in _written(text, names):
        for part in parts_of(line):
            yield from ((number, one) for one in real_and_imaginary(part) or [part])


def _beside(text: str, names: Names, sign: str | None) -> Iterator[tuple[int, str]]:
    """Yield the lines with a name and "=" that may be equations or answers; skip table rows, which contain `sign`."""
    for number, line in _written(_ROW.sub("", text), names):
        bare = line.strip(_EDGES)
        if "=" in bare and not (sign and sign in bare) and _WORD.search(bare):
            yield number, bare


def _is_equation(line: str, names: Names) -> bool:
    return "=" in line or relates_two_sides(line[:MAX_CHARACTERS]) or is_equation_without_sign(line, names)


def _definitions(lines: Sequence[tuple[int, str]], names: Names) -> dict[str, Formula]:
    """Return the student's own names that other lines use, with their formulas; a formula may use other such names."""
    own: dict[str, Formula] = {}
    spoken = [plain_signs(line[:MAX_CHARACTERS]) for _, line in lines[: _TRIED * _MOST_DEFINITIONS]]
    # A list that a program only returns, as in return [f1, f2], holds residuals: it is no use of the names.
    spoken = [_GATHERED.sub("", line) for line in spoken]
    words = Counter(plain_name(word) for line in spoken for word in {*_WORD.findall(line)})
    names_left = {plain_name(name) for line in lines[:_MOST_DEFINITIONS] if (name := own_name(line[1], names.spellings)[0])}
    with_own = replace(names, own=own, spellings=replace(names.spellings, own=dict.fromkeys(names_left)))
    labels: set[str] = set()  # names that label several lines: V_D = … = 0 along x, and again along y
    for turn in range(_PASSES):  # in a program the data may follow the formulas that use them
        waiting = 0
        for _, line in lines[:_MOST_DEFINITIONS]:
            waits = {*map(plain_name, _WORD.findall(line.partition("=")[2]))} & names_left - own.keys()
            waiting += bool(waits)
            if waits and turn < _PASSES - 1:
                continue
            if (found := definition(line, with_own)) and (words[found[0]] > 1 or no_velocity(line, names)):
                labels |= {found[0]} if not turn and found[0] in own and _VANISHED.search(line) else set()
                own.setdefault(*found)
        if not waiting:
            break
    return {name: formula for name, formula in own.items() if name not in labels}


def _defines(line: str, own: Mapping[str, Formula], names: Names, before: set[str]) -> bool:
    """Return whether a line defines a name of the student; a second formula for a velocity (V_Bx of two links) is an equation."""
    name, formula = own_name(line, names.spellings) if own else ("", "")
    called = plain_name(name)
    if called not in own or (called in before and name[:1] in "vV" and _WORD.search(_FUNCTION.sub("", formula))):
        return False
    before.add(called)
    # V_Cy = … = 0 is also an equation; V_Cy = 0.3*4.1 = 1.23 is its value in some row.
    return "=" not in formula or not _WORD.search(_FUNCTION.sub("", formula))


def _is_of_one_row(read: EquationLine, names: Names) -> bool:
    """Return whether a line relates only sought velocities and numbers, as "w3 = 6.12": a value or check of some row."""
    named = names_of(read, names) if read.tree is not None else set[str]()
    variant = names.expected.variant
    if (found := _UNIT_BEHIND.search(read.text)) and unit_of(found[1]):
        named -= names_in(found[1], names.spellings)  # w2 = 2.03 1/s, although s is a length of the task
    if _ANALOG.search(read.text):  # d(theta2)/d(theta1) = -2.93/10 is a ratio of velocities
        named -= {one.rate for one in variant.coordinates} - {*variant.sought}
    is_checked = _CHECKED.search(read.text) and not _VANISHED.search(read.text)  # r1*w1 = 1.08
    return bool(named) and bool(is_checked or named <= {*variant.sought}) and _MEASURED.search(read.text) is not None


def relates(read: EquationLine, names: Names) -> bool:
    """Return whether a line names a sought velocity and another name than a sought velocity or t."""
    named, sought = names_of(read, names), {*names.expected.variant.sought}
    return bool(named & sought and named - sought - {"t"})
