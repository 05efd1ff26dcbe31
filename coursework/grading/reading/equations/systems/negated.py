r"""A right side with a minus before its name, A*x = -b or -b = [c; d] -> a name of its own with the cells that it has so.

Enters: a text.  Leaves: the text with that name; unchanged if it has no such vector.  Nothing is computed.
Used by `text_lines.py`.
"""

from __future__ import annotations

import re

from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import vector

_NAME = r"([^\W\d]\w{0,20})"
_MINUS = rf"[-−–][ \t]*{_NAME}"
_USED = re.compile(rf"(?m)(?<=[=,\\*@·⋅])[ \t]*+(?:\([ \t]*{_MINUS}[ \t]*\)|{_MINUS})(?=[ \t]*(?:\)|[.,;$]?[ \t]*$))")
_DEFINED = re.compile(rf"(?m)^[ \t]*+([-−–]?)[ \t]*+{_NAME}[ \t]*:?=[ \t]*(?:[\w.]{{1,12}}\([ \t]*)?(?=\[)")
_OF_SCILAB = re.compile(r"(?<=\blinsolve\()([^\W\d]\w{0,20}[ \t]*,)[ \t]*(?=[^\W\d]\w{0,20}[ \t]*\))")  # solves A*x + b = 0
# The minus before what solves, x = -A\b or -inv(A)*b, is one before the right side.
_BEFORE = re.compile(
    r"(?m)(?<==)[ \t]*[-−–][ \t]*([\w.:]{1,40}(?:[(\[]\w{0,20}[,)])?(?:\^[({]?[-−]1[)}]?)?[ \t]*[\\*@·⋅]?)[ \t]*"
    rf"(?<!\w)(?={_NAME}[)\]]?[ \t]*(?:[;%#/]|$))"
)
_LONGEST, _ENDING = 4000, "minus"


def with_a_name(text: str) -> str:
    r"""Return a text with another name for each vector that has a minus before its name.

    >>> with_a_name("b = [c; d]\nA*x = -b"), with_a_name("-b = [c; d]\nA*x = -b"), with_a_name("w = -b")
    ('bminus = [-(c); -(d)]\nA*x = bminus', 'bminus = [c; d]\nA*x = bminus', 'w = -b')
    """
    text = _OF_SCILAB.sub(r"\1 -", text) if "linsolve" in text and "//" in text else text
    vectors = {found[2] for found in _DEFINED.finditer(text)}
    text = _BEFORE.sub(lambda found: f" {found[1]}-" if found[2] in vectors else found[0], text)
    used = {found[1] or found[2] for found in _USED.finditer(text)}
    if not used:
        return text
    told, added = set[str](), list[str]()
    for found in reversed([*_DEFINED.finditer(text)]):
        name, opening = found[2], found.end()
        end = closing(text, opening, _LONGEST)
        cells = vector(text[opening + 1 : end])
        if name not in used or name in told or len(cells) < 2:
            continue
        told.add(name)
        ending = f"{name}{_ENDING} = "
        said = text[opening : end + 1] if found[1] else f"[{'; '.join(f'-({cell})' for cell in cells)}]"
        if found[1] or not re.search(rf"(?<![\w.]){name}(?!\w)", _USED.sub("", text[: found.start()] + text[end:])):
            lines = "\n" * text.count("\n", found.start(), end) if not found[1] else ""
            text = f"{text[: found.start()]}{ending}{said}{lines}{text[end + 1 :].removeprefix(')' if '(' in found[0] else '')}"
        else:
            added.append(f"\n{ending}{said}")

    def named(found: re.Match[str]) -> str:
        name = found[1] or found[2]
        return f" {name}{_ENDING}" if name in told else found[0]

    return _USED.sub(named, text) + "".join(added)
