r"""A system that a program has as named matrices, A = [...], b = [...], x = A\b -> its equations, row by row.

Enters: a text.  Leaves: the text with the equations in place of the matrix and without the other parts of the system; unchanged
if it has no such system.  Nothing is computed.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import islice

from coursework.grading.reading.equations.notation.latex import determinant, matrices_in_one_piece
from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.called_matrices import in_matrices
from coursework.grading.reading.equations.systems.components import in_one_vector
from coursework.grading.reading.equations.systems.cramer import with_cells_in_determinants
from coursework.grading.reading.equations.systems.filled import as_wholes
from coursework.grading.reading.equations.systems.of_r import in_brackets
from coursework.grading.reading.equations.systems.parts import at_commas, product, rows_of, vector

_TYPE = r"(?:(?:static|const|double|float|real|auto|let|var)[ \t]+){0,4}"
_DEFINED = re.compile(
    rf"(?<![\w.]){_TYPE}([^\W\d]\w{{0,20}})[ \t]*+:?=[ \t]*+"
    r"(?:[A-Za-z]{1,12}\.)?(?:[A-Za-z]{1,12}[ \t]*+)?\(?\s*+(?=\[)"
)
_NAME = r"([^\W\d]\w{0,20})"
_NAMES = r"[(\[{]?((?:[^\W\d]\w{0,20}[ \t]*[,;][ \t]*)+[^\W\d]\w{0,20})[)\]}]?"
_SOLVER = r"(?:(?:lin|lu|l|LU)?[sS]olve|LinearSolve)\s*[(\[]"
_SOLVED = (
    rf"(?:(?:[A-Za-z]{{1,13}}(?:\.|:-)){{0,2}}{_SOLVER}\s*{_NAME}\s*,\s*{_NAME}\s*[)\]]"
    rf"|{_NAME}[ \t]*\\[ \t]*{_NAME}"
    rf"|{_NAME}\.(?:\w{{1,12}}solve|solve|inv(?:erse)?\(\)[ \t]*[*@])[ \t]*\(?{_NAME}\)?"
    rf"|{_NAME}[ \t]*\^[ \t]*[({{]?[-−]1[)}}]?[ \t]*[*·][ \t]*{_NAME}"
    rf"|(?:[A-Za-z]{{1,9}}\.){{0,2}}[iI]nv(?:ert|erse)?[(\[]\s*{_NAME}\s*[)\]][ \t]*[*@.][ \t]*{_NAME})[ \t]*;?[ \t]*"
)
_PRODUCTS = (
    re.compile(
        rf"(?m)(?:^|[$,;])[ \t]*{_NAME}[ \t]*(?:[*@·⋅×]|\\cdot|\.dot\(|[ \t])[ \t]*{_NAME}\)?"
        rf"[ \t]*={{1,2}}[ \t]*{_NAME}[ \t]*(?=[,;.$]|$)"
    ),
    re.compile(rf"(?m)^[ \t]*{_TYPE}(?:{_NAME}|{_NAMES})[ \t]*:?=[ \t]*{_SOLVED}(?:(?:[%#/].*)?$|(?<=;)|(?<=;[ \t]))"),
    re.compile(rf"(?m)^[ \t]*return[ \t]+{_SOLVED}#[ \t]*{_NAMES}[ \t]*$"),
    re.compile(rf"(?m)^[ \t]*return[ \t]+{_SOLVED}(?:[%#/].*)?$"),
    # A procedure of C, Pascal or Fortran that writes what it solves for into its last vector
    re.compile(
        rf"(?m)(?:^|(?<=;))[ \t]*(?:call[ \t]+)?(?:\w{{0,20}}(?i:solve|gauss|lu)\w{{0,20}})[ \t]*\([ \t]*(?:\d+[ \t]*,[ \t]*)?"
        rf"{_NAME}[ \t]*,[ \t]*{_NAME}[ \t]*,[ \t]*{_NAME}[ \t]*(?:,[ \t]*\w{{1,9}}[ \t]*)?\)[ \t]*(?:;|$)"
    ),
)
_OF_CALLS = re.compile(rf"{_SOLVER}\s*[^\W\d]\w{{0,20}}\s*\(")
_RETURNED = re.compile(r"(?m)^[ \t]*return[ \t]+(?=[\w.]{0,20}\(?\s*\[)")
# Places of the matrix, the unknowns and the right side in each of `_PRODUCTS`; if there are two, the call of a function has them.
_ORDERS = ((0, 1, 2), (1, 0, 2), (0, 2, 1), (0, 2, 1), (0, 2, 1))
_FUNCTION = re.compile(r"(?m)^[ \t]*(?:def|function)\b[^(\n]{0,60}?([^\W\d]\w{0,30})[ \t]*\(")
# w1 = x(1), w1(i) = x(1)
_TAKEN = (
    rf"(?m)(?:^|(?<=[;,]))[ \t]*{_TYPE}{_NAME}(?:[\[(][ijkn][\])])?[ \t]*:?=[ \t]*"
    r"(?:Element\(%s,|%s[ \t]*[\[(])[ \t]*(\d{1,2})(?:[ \t]*,[ \t]*1)?[ \t]*[\])][ \t]*(?:[;,]|$)"
)
_LATEX = re.compile(r"\\(?:begin|math|q?quad)")
_IN_BOLD = re.compile(r"\\(?:mathbf|boldsymbol|bm|vec|mathsf|mathrm|underline|overline)\s*\{(\w)\}|\\[,;:! ]")
# An array with its values in braces, double A[2][2] = {{a, b}, {c, d}};
_IN_BRACES = re.compile(rf"(?m)(?:^|(?<=;))[ \t]*{_TYPE}([^\W\d]\w{{0,20}})((?:[ \t]*\[\w{{0,9}}\]){{1,2}})[ \t]*=[ \t]*(?=\{{)")
_LISTS = re.compile(
    r"(?m)(?:^|(?<=;))[ \t]*([^\W\d]\w{0,20})[ \t]*(?::=|=|:)(?:[ \t]*(matrix)[ \t]*(?=\(\s*\[)|([-\w \t*]{0,60})(?=\{))"
)  # the list may have a factor, w {a, b}
_ASSIGNED = re.compile(r"(?m)^[ \t]*([^\W\d]\w{0,20})[ \t]*:[ \t]*(?=invert\b|[^\W\d]\w{0,20}\[\d)")
# A matrix times its unknowns, which stand there as a vector: A*[w1; w2] = b
_UNKNOWNS = re.compile(
    rf"(?m)(?:^|[$;])[ \t]*{_NAME}[ \t]*[*@·⋅×]?[ \t]*\[(?![ \t]*\d)([^\[\]\n=:]{{3,200}})\]"
    rf"(?:\.?'|\.T|\^\{{?T\}}?|ᵀ)?[ \t]*={{1,2}}[ \t]*({_NAME[1:-1]}|\[[^\[\]\n=]{{3,400}}\])"
    r"(?=[ \t]*[.,;$]?[ \t]*$)"
)
_ROUND, _BRACES = str.maketrans("[]", "()"), str.maketrans("{}", "[]")  # of functions and of lists in Mathematica
# A system that is solved where it is written: solve([[a, b], [c, d]], [e, f]), solve(np.array(...), ...), [a, b; c, d]\[e; f]
_CALLED = re.compile(rf"{_SOLVER}(?=\s*(?:{_NAME[1:-1]}\s*,\s*)?[\w.]{{0,20}}\s*\(?\s*\[)")
_FACTOR = rf"(\[[^=\n]{{1,2000}}\]|{_NAME[1:-1]})"
_DIVIDED = re.compile(
    rf"(?m)(?:(?<==)|(?<=\breturn))[ \t]*(?:@\([\w\s,]{{1,40}}\)[ \t]*)?"
    rf"(?:{_FACTOR}[ \t]*\\|(?:[A-Za-z]{{1,9}}\.){{0,2}}[iI]nv\({_FACTOR}\)[ \t]*[*@]"
    rf"|{_FACTOR}[ \t]*(?:\^[ \t]*[({{]?-1[)}}]?|⁻¹)[ \t]*[*·⋅])[ \t]*(?:[\w.]{{1,12}}\((?=\[))?{_FACTOR}(?:\.?'|\.T|\))?"
    r"(?=[ \t]*(?:;|(?:[%#/].*)?$))"
)
_OF_CALL = ("matrix_of_call", "sides_of_call")
_DETERMINANT = re.compile(r"(?:(?<![\w.])(?:[A-Za-z]{1,13}(?:\.|:-)){1,2}|(?<![\w.]))(?:[dD]et|[dD]eterminant)\s*(?=[(\[])")
_WRAPPED = re.compile(r"\s*[\w.]{0,20}\s*\(?\s*(\[.*\])\s*\)?\s*", re.DOTALL)
_SIGNS = ("[", "matrix", "(1,", "(0,", "bind", "{{", "mat(", "vec(", "█(", "■(", "x:")  # a system has one of them
_MOST, _MOST_SYSTEMS, _LONGEST, _LONGEST_DETERMINANT, _MOST_CHARACTERS = 20, 6, 4000, 2000, 200_000


def in_rows(text: str, sought: Sequence[str] = ()) -> str:
    r"""Return a text with the equations of a system in place of its matrix; unknowns without names are those in `sought`.

    >>> in_rows("A = [a, b; c, d]; k = [e; f];\nw1, w2 = np.linalg.solve(A, k)")
    '(a)*(w1) + (b)*(w2) = e; (c)*(w1) + (d)*(w2) = f; ;\n'
    """
    if len(text) > _MOST_CHARACTERS or not any(sign in text for sign in _SIGNS):
        return text
    text = in_matrices(text)
    text = with_cells_in_determinants(text, {name: content for name, _, _, content in _matrices(text)})
    text = _with_unknowns_named(_without_braces(in_brackets(_as_lists(_with_determinants(text)))))
    text = _returned_as_named(in_one_vector(text))
    text = as_wholes(text)
    for _ in range(_MOST_SYSTEMS):
        apart = _named_apart(text)
        whole = _IN_BOLD.sub(r" \1 ", matrices_in_one_piece(apart)) if _LATEX.search(apart) else apart
        if not (solved := _with_first_system(_with_unknowns_named(whole), sought)):
            break
        text = solved
    return text


def _with_unknowns_named(text: str) -> str:
    """Return a text with A*x = b, x = [w1; w2] and b = [c; d] for A*[w1; w2] = [c; d]."""
    if (found := _UNKNOWNS.search(text)) is None:
        return text
    sides, said = ("sides", f"\nsides = {found[3]}") if found[3].startswith("[") else (found[3], "")
    return f"{text[: found.start(1)]}{found[1]}*unknowns = {sides}{text[found.end() :]}\nunknowns = [{found[2]}]{said}"


def _with_first_system(whole: str, sought: Sequence[str]) -> str:
    """Return a text with equations in place of the first system that is solved in it, "" if there is none.

    A name of several matrices means the last one before the place, else the first one behind it.
    """
    matrices = _matrices(whole)
    for found in (found for pattern in _PRODUCTS for found in islice(pattern.finditer(whole), _MOST)):
        named = {name: (begin, end, content) for name, begin, end, content in reversed(matrices)}
        named |= {name: (begin, end, content) for name, begin, end, content in matrices if begin < found.start()}
        groups = [group for group in found.groups() if group]
        groups += [_names_of_call(whole, found.start())] if len(groups) == 2 else []
        matrix, unknowns, right = (groups[place] for place in _ORDERS[_PRODUCTS.index(found.re)])
        if {matrix, right} <= named.keys():  # unlike those of "double w1 = w0"
            break
    else:
        return ""
    is_listed = not unknowns.isidentifier()
    taken = [] if is_listed else _taken(whole, unknowns, found.end())
    columns = vector(unknowns) if is_listed else vector(named[unknowns][2]) if unknowns in named else []
    columns = columns or [one[1] for one in taken] or _said(whole, unknowns)
    size = len(rows_of(named[matrix][2]))
    columns = columns or _by_digits(unknowns, size, sought) or _among(whole, unknowns, size, sought) or [*sought]
    equations = product(named[matrix][2], columns, vector(named[right][2]))
    if not equations:
        return ""
    is_again = re.search(rf"[\\,*@][ \t]*{re.escape(right)}(?!\w)", whole[found.end() :])  # of another system
    done = {matrix, unknowns} | ({right} if not is_again else set())
    pieces = [(*named[name][:2], "; ".join(equations) if name == matrix else "") for name in done if name in named]
    pieces += [(*one.span(), "") for one in (found, *taken)]
    for begin, end, said in sorted(pieces, reverse=True):
        whole = whole[:begin] + said + "\n" * whole.count("\n", begin, end) + whole[end:]
    return whole


def _said(whole: str, unknowns: str) -> list[str]:
    """Return what a remark says of the entries of a vector, // x(1) = w1, x(2) = w2; in their order."""
    found = re.findall(rf"(?:[/%#!,;]|--)\s*{re.escape(unknowns)}[\[(](\d{{1,2}})[\])]\s*=\s*([^\W\d]\w{{0,20}})", whole)
    return [name for _, name in sorted(found)]


def _by_digits(unknowns: str, size: int, sought: Sequence[str]) -> list[str]:
    """Return w1, w2 for a vector of two that is called w12; [] for any other."""
    stem = unknowns.rstrip("0123456789")
    named = [f"{stem}{digit}" for digit in unknowns.removeprefix(stem)]
    return named if len(named) == size and {*named} <= {*sought} and named == sorted(named) else []


def _among(whole: str, unknowns: str, size: int, sought: Sequence[str]) -> list[str]:
    """Return the velocities that a vector has in a list where the others have their numbers and places, dq = [x; w3]."""
    for found in re.finditer(rf"[\[(]([\w\s.,;]{{0,200}}(?<![\w.]){re.escape(unknowns)}(?![\w.])[\w\s.,;]{{0,200}})[\])]", whole):
        cells = vector(found[1])
        place = cells.index(unknowns) if unknowns in cells else -1
        listed = [*cells[:place], *sought[place : place + size], *cells[place + 1 :]]
        numbers, others = ([re.sub(r"\D", "", one) or one for one in row] for row in (listed, sought[: len(listed)]))
        if place >= 0 and len(listed) > size and numbers == others:
            return [*sought[place : place + size]]
    return []


def _taken(whole: str, unknowns: str, place: int) -> list[re.Match[str]]:
    """Return where the entries of a vector get names, w1 = x(1), in their order; behind a place, until one comes again."""
    pattern = re.compile(_TAKEN % ((re.escape(unknowns),) * 2))
    found: dict[int, re.Match[str]] = {}
    place = len(whole[:place].rstrip())
    for one in pattern.finditer(whole, place) if pattern.search(whole, place) else pattern.finditer(whole):
        if int(one[2]) in found:
            break
        found[int(one[2])] = one
    return [one for _, one in sorted(found.items())]


def _with_determinants(text: str) -> str:
    """Return a text with its determinants as sums.

    >>> _with_determinants("w1 = det([a, b; c, d])/np.linalg.det(np.array([[e, f], [g, h]]))")
    'w1 = ((a)*(d) - (b)*(c))/((e)*(h) - (f)*(g))'
    """
    start = 0
    for _ in range(_MOST):
        if (found := _DETERMINANT.search(text, start)) is None:
            break
        end = closing(text, found.end(), _LONGEST_DETERMINANT)
        inner = text[found.end() + 1 : end]
        wrapped = _WRAPPED.fullmatch(inner.translate(_BRACES) if inner.lstrip().startswith("{") else inner)
        said = determinant(rows_of(wrapped[1][1:-1])) if wrapped else ""
        start = found.end()
        if said:
            text = text[: found.start()] + said + "\n" * inner.count("\n") + text[end + 1 :]
            start = found.start() + len(said)
    return text


def _as_lists(text: str) -> str:
    """Return a text with [[a, b], [c, d]] for the matrices of Mathematica, {{a, b}, {c, d}}, and of Maxima, matrix([a, b], …)."""
    named = "{{" in text
    for begun in reversed([*islice(_LISTS.finditer(text), _MOST)]):
        end = closing(text, begun.end(), _LONGEST) + 1
        if end > begun.end() + 1 and (named or begun[2]):
            content = text[begun.end() : end]
            content = f"[{content[1:-1]}]" if begun[2] else content.translate(_ROUND).translate(_BRACES)
            factor = re.sub(r"(?<=\w)$", "*", (begun[3] or "").strip(" \t*"))
            text = f"{text[: begun.start()]}{begun[1]} = {factor}{content}{text[end:]}"
    return _ASSIGNED.sub(r"\1 = ", text) if "matrix" not in text and _ASSIGNED.search(text) else text


def _without_braces(text: str) -> str:
    """Return a text with the arrays of C in brackets: A = [[a, b], [c, d]]"""
    arrays = [*islice(_IN_BRACES.finditer(text), _MOST)]
    for found in reversed(arrays) if any(one[2].count("[") > 1 for one in arrays) else ():
        end = closing(text, found.end(), _LONGEST) + 1
        text = f"{text[: found.start()]}{found[1]} = {text[found.end() : end].translate(_BRACES)}{text[end:]}"
    return text


def _returned_as_named(text: str) -> str:
    """Return a text in which functions that return a matrix or a right side, solve(A(q), b(t)), are such matrices: A = …"""
    begun = _FUNCTION.search(text) if _OF_CALLS.search(text) else None
    for _ in range(_MOST):
        if begun is None or (returned := _RETURNED.search(text, begun.end())) is None:
            break
        function, begun = begun, _FUNCTION.search(text, begun.end())
        called = re.compile(rf"(?<=[(,\s]){re.escape(function[1])}\s*\([\w\s,.*\[\]]{{0,60}}\)(?=\s*[,)])")
        if (begun is None or returned.start() < begun.start()) and called.search(text, returned.end()):
            named = f"{function[1]} = {called.sub(function[1], text[returned.end() :])}"
            text = text[: returned.start()] + named
            begun = _FUNCTION.search(text, returned.start())
    return text


def _names_of_call(text: str, place: int) -> str:
    """Return "w1, w2" of the line w1, w2 = rates(t, y) for the function rates that returns at a place, else ""."""
    functions = [found[1] for found in _FUNCTION.finditer(text, 0, place)]
    called = re.search(rf"(?m)^[ \t]*{_NAMES}[ \t]*=[ \t]*{re.escape(functions[-1])}[ \t]*\(", text) if functions else None
    return called[1] if called else ""


def _named_apart(text: str) -> str:
    """Return a text in which matrix and right side have names, defined at the end, where they stand in the line that solves."""
    for begun in _CALLED.finditer(text):
        end = closing(text, begun.end() - 1, _LONGEST)
        if parts := _solved_for(at_commas(text[begun.end() : end])):
            before, between, behind = text[: begun.end()], ", ", text[end:]
            lines = "\n" * text.count("\n", begun.end(), end)
            break
    else:
        if (divided := _DIVIDED.search(text)) is None:
            return text
        parts = [one for one in divided.groups() if one]
        before, between, behind, lines = f"{text[: divided.start()]} ", "\\", text[divided.end() :], ""
    names = [name if part.startswith("[") else part for name, part in zip(_OF_CALL, parts, strict=True)]
    defined = "".join(f"\n{name} = {part}" for name, part in zip(names, parts, strict=True) if part.startswith("["))
    return before + between.join(names) + behind.replace("\n", f"{lines}\n", 1) + defined if defined else text


def _solved_for(arguments: Sequence[str]) -> list[str]:
    """Return a matrix and a right side, each as its name or its cells in brackets; [] if these are other arguments."""
    found = [_WRAPPED.fullmatch(argument) for argument in arguments]
    parts = [one[1] if one else argument.strip() for one, argument in zip(found, arguments, strict=True)]
    is_matrix = len(parts) == 2 and (not found[0] or re.search(r"[;\[]", parts[0][1:]) is not None)
    return parts if is_matrix and (found[1] or parts[1].isidentifier()) else []


def _matrices(text: str) -> list[tuple[str, int, int, str]]:
    """Return the matrices of a text: name, start, end and content of each."""
    found = []
    for begun in list(_DEFINED.finditer(text))[:_MOST]:
        end = closing(text, begun.end(), _LONGEST) + 1
        if end > begun.end() + 1 and "=" not in text[begun.end() : end]:  # no list of equations
            closed = end + (text[end : end + 1] == ")") if "(" in begun[0] else end
            found.append((begun[1], begun.start(), closed, text[begun.end() + 1 : end - 1]))
    return found
