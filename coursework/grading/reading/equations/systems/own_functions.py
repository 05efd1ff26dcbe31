"""A function of the student: with the same arguments always, V(t) := …, A(f) = […], a name, V and A; else what it says of them.

Enters: a text, and what says whether a name means something already.  Leaves: the text without such functions.
Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import at_commas, at_signs

_NAME = r"[^\W\d]\w{0,20}"
_DEFINED = re.compile(rf"(?m)^[ \t]*({_NAME})[ \t]*\([ \t]*{_NAME}[ \t]*(?:,[ \t]*{_NAME}[ \t]*){{0,9}}\)[ \t]*:?=(?!=)")
_HANDLE = re.compile(rf"(?m)(?:^|;)[ \t]*({_NAME})[ \t]*=[ \t]*@\([\w\s,]{{1,60}}\)")  # V = @(t) … of MATLAB
_OF_SOUGHT = re.compile(r"(?m)^([ \t]*v_?\w{1,6})\([^\W\d]\w{0,5}\)(?=[ \t]*:=)")  # vP(ω2):=…, a velocity and what it depends on
# A function of one line with letters of its own: A = @(x, y) […], f := x -> …, f = lambda x: …, f[x_] := …, def f(x): return …
_ITS = rf"({_NAME}(?:[ \t]*,[ \t]*{_NAME}){{0,5}})"
_SAID = re.compile(
    rf"(?m)^[ \t]*(?:(?:const|let|var)[ \t]+)?(?:({_NAME})[ \t]*(?:[(\[]{_ITS}[)\]][ \t]*:?=(?!=)"
    rf"|:?=[ \t]*(?:@\({_ITS}\)|\(?{_ITS}\)?[ \t]*[-=]>|lambda[ \t]+{_ITS}:))"
    rf"|def[ \t]+({_NAME})\({_ITS}\):[ \t]*\n?[ \t]*return\b)[ \t]*([^\n]{{1,400}})$"
)
_WORD, _END, _LIST = re.compile(r"(\.?[^\W\d]\w*)"), re.compile("[;%#]"), re.compile(r"(?:[\w.]{1,14}\(\s*)?[\[{]")
_MOST, _LONGEST, _MOST_CHARACTERS = 20, 300, 100_000


def with_bodies(text: str, is_known: Callable[[str], bool]) -> str:
    r"""Return a text with what a function with letters of its own says of its arguments, in place of each call.

    >>> known = {"p", "t"}.__contains__
    >>> with_bodies("A = @(x, y) [x; y*s];\nv = A(p, q + 1)", known), with_bodies("f(t) = 2*t\nw = f(2)", known)
    ('\nv = [p; (q + 1)*s]', 'f(t) = 2*t\nw = f(2)')
    """
    for found in [*_SAID.finditer(text)][_MOST::-1]:
        name, its, body = (one for one in found.groups() if one)
        letters = [one.strip(" \t_") for one in its.split(",")]
        body, begun = at_signs(_END, body)[0].strip(), found.start()
        call = re.compile(rf"(?<![\w.\\]){name}[ \t]*(?=[(\[])")
        if is_known(name) or "t" in letters or all(map(is_known, letters)) or call.search(body):
            continue  # the velocities themselves, or their change in time
        begin = _LIST.match(body)
        is_list = begin is not None and closing(body, begin.end() - 1) + begin[0].count("(") == len(body) - 1
        rest = text[found.end() :]
        for _ in range(_MOST):
            used = call.search(rest)
            end = closing(rest, used.end(), _LONGEST) if used else 0
            given = [one.strip() for one in at_commas(rest[used.end() + 1 : end])] if used else []
            if used is None or len(given) != len(letters) or given == letters or len(rest) > _MOST_CHARACTERS:
                break
            meant = dict(zip(letters, (one if one.isidentifier() else f"({one})" for one in given), strict=True))
            said = "".join(meant.get(one, one) for one in map(str, _WORD.split(body)))
            rest = rest[: used.start()] + (said if is_list else f"({said})") + rest[end + 1 :]
        if rest != text[found.end() :] and not call.search(rest):
            text = text[:begun] + "\n" * found[0].count("\n") + rest
    return text


def as_names(text: str, is_known: Callable[[str], bool]) -> str:
    r"""Return a text in which functions that always have the same arguments are names.

    >>> as_names("V(t) := a*t\nw = V( t )/r", {"w"}.__contains__), as_names("x(i) = 1\ny = x(j)", {"w"}.__contains__)
    ('V := a*t\nw = V/r', 'x(i) = 1\ny = x(j)')
    """
    text = _OF_SOUGHT.sub(lambda found: found[1] if is_known(found[1].strip()) else found[0], text)
    handles = _HANDLE.findall(text)
    for name in [*dict.fromkeys([*(found[1] for found in _DEFINED.finditer(text)), *handles])][:_MOST]:
        used = re.compile(rf"(?<![\w.\\]){name}[ \t]*\(([^()\n]{{0,80}})\)")
        uses = [re.sub(r"\s", "", arguments) for arguments in used.findall(text)]
        is_function = name in handles or ("," in uses[0] if is_known(name) else len(uses) > 1)  # w3(t) may be a product
        if is_function and len({*uses}) == 1:
            text = used.sub(name, text)
    return text
