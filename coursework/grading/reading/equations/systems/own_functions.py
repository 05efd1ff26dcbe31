"""A function of the student that always has the same arguments, V(t) := …, A(f) = […] -> a name, V and A.

Enters: a text, and what says whether a name means something already.  Leaves: the text without the arguments of such functions.
Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

_NAME = r"[^\W\d]\w{0,20}"
_DEFINED = re.compile(rf"(?m)^[ \t]*({_NAME})[ \t]*\([ \t]*{_NAME}[ \t]*(?:,[ \t]*{_NAME}[ \t]*){{0,9}}\)[ \t]*:?=(?!=)")
_HANDLE = re.compile(rf"(?m)(?:^|;)[ \t]*({_NAME})[ \t]*=[ \t]*@\([\w\s,]{{1,60}}\)")  # V = @(t) … of MATLAB
_OF_SOUGHT = re.compile(r"(?m)^([ \t]*v_?\w{1,6})\([^\W\d]\w{0,5}\)(?=[ \t]*:=)")  # vP(ω2):=…, a velocity and what it depends on
_MOST = 20


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
