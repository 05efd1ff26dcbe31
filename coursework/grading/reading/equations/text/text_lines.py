"""A text -> its lines as they are meant, without comments, statements of programs and quotation marks, continuations joined.

Enters: a text as decoded, `Names`.  Leaves: pairs of the number of a line, from 1, and the line; one may hold several equations.
Used by `lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import partial

from coursework.grading.reading.equations.formulas.equations import Names
from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.notation.escapes import unquoted, with_line_ends
from coursework.grading.reading.equations.notation.latex import logical_lines
from coursework.grading.reading.equations.systems.cells import with_cells_named
from coursework.grading.reading.equations.systems.component_sums import by_axes, may_be_of_vectors
from coursework.grading.reading.equations.systems.components import (
    by_components,
    in_one_vector,
    with_dot_products,
    with_entries_apart,
)
from coursework.grading.reading.equations.systems.drawn import in_one_line
from coursework.grading.reading.equations.systems.matrices import in_rows
from coursework.grading.reading.equations.systems.negated import with_a_name
from coursework.grading.reading.equations.systems.of_c import without_pointers
from coursework.grading.reading.equations.systems.own_functions import as_names, with_bodies
from coursework.grading.reading.equations.systems.parts import of_row, parts_of
from coursework.grading.reading.equations.systems.round_matrices import in_square_brackets
from coursework.grading.reading.equations.systems.vectors import with_entries_named, with_short_names
from coursework.grading.reading.equations.text.continued_lines import continued
from coursework.grading.reading.equations.text.line_kinds import is_statement
from coursework.grading.reading.equations.text.list_marks import without_line_numbers
from coursework.grading.reading.equations.text.remarks import (
    is_fortran,
    names_said,
    without_blocks,
    without_comments_of_fortran,
    without_constants,
    without_remarks,
)
from coursework.grading.reading.equations.text.slashes import parted_at_slashes
from coursework.grading.reading.equations.text.statements import (
    as_value,
    closed,
    function_begun,
    residuals,
    with_sign,
    without_declarations,
)

# Rows of empty cells, of which a spreadsheet may leave a million, and blanks longer than anybody types: patterns would be slow.
_BLANKS = re.compile(r"^[;,\t ]++$|(?<=[^\S\n]{40})[^\S\n]+", re.MULTILINE)
_AXIS_APART = re.compile(r"(?<=_[A-Z]),\s?([xy])(?!\w)|(?<=_\{[A-Z]),\s?([xy])(?=\})")  # v_P,x is v_Px
_GREEK_SIGNS = re.compile(r"(?<![^\W\d_])(ημ|συν)(?=\s?(?:[\[(]|[α-ω]_?\d?(?![^\W\d_])))")  # sine and cosine in Greece
_TAKEN = re.compile(
    r"(?m)^[ \t]*(?:\w{1,20}\s*=\s*)?\{[\w\s,]{1,80}\}\s*/\.\s*(?=(?:\w{4,7}\[)?N?Solve\[)"
)  # {w2, w3} /. Solve[…]
# The velocity of a point as the derivative of its place: xB', \\dot{x}_B, dx_B/dt
_OF_PLACE = re.compile(
    r"(?<![\w.\\])(?:([xy])_?(\{?[A-Z]\d?\}?)['’′](?!['’′\w])|d([xy])_?(\{?[A-Z]\d?\}?)\s*/\s*dt(?!\w)"
    r"|([xy]\u0307|[ẋẏ])_?(\{?[A-Z]\d?\}?)(?!\w))|\\dot\s?\{?\s?([xy])\s?\}?_(\{?[A-Z]\d?\}?)(?!\w)"
)
# The derivative by an angle that a stroke means if the text says so: ' = d/dphi1
_STROKE = re.compile(r"['’′]\s*(?:=|means|denotes|:)\s*d\s*/\s*d\s?([^\W\d]\w{0,8})")
_STROKED = re.compile(r"(?<![\w'])([^\W\d]\w{0,8})['’′](?!['’′\w])")
_OF_CRAMER = re.compile(r"(?<!\w)([Δ∆D])(?:['’′]{2}|″)|(?<!\w)([Δ∆D])['’′]")  # Δ'' and Δ', determinants beside Δ
_PROMPT = re.compile(r"(?m)^[ \t]*>{1,3}[ \t]+")  # of Maple, MATLAB and Python
_INDEX = re.compile(r"(?m)(?<=[^\W\d])\[(\d{1,2})(?!\w)(?=[^\[\]\n]{0,400}(?:$|\[))|(?<=[α-ω])\.(\d)")  # φ[3 and φ.3 of Mathcad
# Equations between brackets, one in each line, as MATLAB has them: they end where the line does.
_EQUATIONS = re.compile(r"(==[^\n;,\[\]%#=]{0,400}[^\s;,\[\].+*/%#-])(?=[ \t]*(?:[%#].*)?\n[^\n\]]*==)")
_OF_RATES = re.compile(r"(?<!\w)([A-Za-z])(['’′\u0307])(?=\s*=\s*[\[(][\w\s,;{}]{3,80}[\])])")
_SQUARED = re.compile(
    r"([^\W\d]\w{0,20})\s*(?:\^\s*\{?\s*2\s*\}?|²|\*\*\s*2)\s*=\s*+([^=]*[^=\s.,;])[\s.,;]*"
)  # DA² = … by the law of cosines
_ADDED = re.compile(r"([^\W\d]\w{0,19})\s*(?:(?=[-+]\s*=)|:?=\s*\1\s*(?=[-+]))([-+])\s*=?(?!=)\s*([^=]+)")


def text_lines(text: str, names: Names, passed: list[tuple[int, str]] | None = None) -> Iterator[tuple[int, str]]:
    """Yield (number, line) of the lines that are neither blank nor comments nor statements of a program.

    Comments and statements with a sign of equality are added to `passed`.
    """
    passed = [] if passed is None else passed
    said = [(number, function, part) for number, function, line in _bare_lines(text, names, passed) for part in _of_vectors(line)]
    sought, spellings = names.expected.variant.sought, names.spellings
    axes = by_axes([line for *_, line in said], spellings.canonical, partial(_is_name, names))
    for (number, function, _), bare in zip(said, axes, strict=True):
        bare = by_components(bare, spellings.canonical)
        if added := _added(bare, names.expected.variant.velocities, spellings):
            bare = added
        elif is_statement(bare, sought):
            passed.append((number, bare))
            continue
        bare = as_value(of_row(bare.strip("'") if bare.startswith("'") else bare), function, sought)
        bare = with_sign(closed(bare), sought, spellings)
        square = _SQUARED.fullmatch(bare)
        if square and square[1][0] in "vV" and square[2].count("²") + square[2].count("^") > 1:
            continue  # V_a² = V_e² + V_r²: of sizes, where the projections say all
        if square and spellings.canonical(square[1]) is None:
            bare = f"{square[1]} = sqrt({square[2]})"
        if cells := residuals(bare, names):
            yield from ((number, cell) for cell in cells)
            continue
        bare = closed(bare)
        if any(map(str.isalnum, bare)):  # not an underline of signs below a title
            yield number, bare


def _of_vectors(line: str) -> list[str]:
    """Return the equations of vectors that a line has beside each other; any other line as it is."""
    parts = parts_of(line) if line.count("=") > 1 and may_be_of_vectors(line) else [line]
    return parts if all(map(may_be_of_vectors, parts)) else [line]


def _bare_lines(text: str, names: Names, passed: list[tuple[int, str]]) -> Iterator[tuple[int, str, str]]:
    """Yield (number, function in which it stands, line) without remarks, declarations and constants."""
    function, fortran = "", is_fortran(text)
    sought, spellings = names.expected.variant.sought, names.spellings
    text, numbers = with_line_ends(_BLANKS.sub("", text))
    for place, line in continued(logical_lines(_by_names(without_blocks(text), names)), names):
        number = numbers[place - 1] if numbers else place
        if begun := function_begun(line, sought):
            function, line = begun
        yield from ((number, function, said) for said in names_said(line, spellings))
        line = without_comments_of_fortran(line) if fortran else line
        bare = unquoted(without_constants(without_remarks(parted_at_slashes(line, names), names.is_name)))
        passed += [(number, line)] if "=" in line and "=" not in bare and "~~" not in line else []  # not what was struck out
        yield number, function, in_one_vector(without_declarations(bare, spellings))


def _added(line: str, velocities: Sequence[str], spellings: Spellings) -> str:
    """Return "K = K + …" for a line that adds a velocity to a name of the student, "" for any other; a step in time adds none."""
    found = _ADDED.fullmatch(line)
    words = {*re.findall(r"\w+", found[3])} if found else set[str]()
    if not found or spellings.canonical(found[1]) or words.isdisjoint(velocities) or words & {"h", "dt", "t"}:
        return ""
    return f"{found[1]} = {found[1]} {found[2]} {found[3]}"


def _is_name(names: Names, word: str) -> bool:
    """Return whether a word has a meaning; B is a name of the student where the task has a datum b."""
    spellings = names.spellings
    return names.is_name(word) and not (spellings.canonical(word) in spellings.data and spellings.known_as(word) is None)


def _by_names(text: str, names: Names) -> str:
    """Return a text with matrix systems written as equations and with names in place of vector entries."""
    variant = names.expected.variant
    text = _TAKEN.sub("", text) if "/." in text else text
    text = _GREEK_SIGNS.sub(lambda found: "sin" if found[1] == "ημ" else "cos", _AXIS_APART.sub(r"\1\2", text))
    for letter, sign in {found.groups() for found in _OF_RATES.finditer(text)}:  # J·q' = B, where q' = [w2; w3]
        text = re.sub(rf"(?<!\w){letter}{sign}", f"{letter}dotted", text)
    if (stroke := _STROKE.search(text)) and stroke[1] != "t":
        text = _STROKED.sub(rf"d\1/d{stroke[1]}", _STROKE.sub("", text))
    text = _OF_CRAMER.sub(lambda found: f"{found[1]}_II" if found[1] else f"{found[2]}_I", text)
    text = _EQUATIONS.sub(r"\1;", _INDEX.sub(r"\1\2", _PROMPT.sub("", text)))
    text = _OF_PLACE.sub(lambda found: _velocity(found, names.spellings), text)
    text = with_cells_named(text, names.spellings.angle, names.spellings.data)
    text = without_pointers(text, names.spellings)
    is_known = partial(_is_name, names)
    text = as_names(with_bodies(without_line_numbers(text), is_known), is_known)
    named = with_a_name(in_square_brackets(in_one_line(text)))
    rows = in_rows(with_entries_apart(with_dot_products(named)), variant.sought)
    return with_entries_named(with_short_names(rows, variant, names.spellings), variant, names.spellings)


def _velocity(found: re.Match[str], spellings: Spellings) -> str:
    """Return the velocity of a point, V_Bx, for the derivative of its place, unless that is a coordinate of the task."""
    axis, point = filter(None, found.groups())
    axis = {"ẋ": "x", "ẏ": "y"}.get(axis, axis[0])
    point = point.strip("{}")
    said = f"V_{{{point}{axis}}}" if "\\" in found[0] or "{" in found[0] else f"V_{point}{axis}"
    return found[0] if spellings.canonical(axis + point) or spellings.canonical(f"{axis}_{point}") else said
