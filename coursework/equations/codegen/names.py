"""Declared names <-> private names of symbols and generated code, one to one; text is made with declared names.

Enters: names as a variant declares them (letters, digits, _).  Leaves: unique private names.
Used by whoever makes symbols or generated code, and by `reduction.tidy`, which makes text of them.

A declared name gets the prefix v_, the time derivative of a velocity a_.  A derivative by a coordinate is named by the two
numbers of declaration (d3_7, and d3_7_7 for the second one), a value that is read twice k0, k1 …; other names of the tool
begin with _.  The time t keeps its name, which no file may declare.
"""

from __future__ import annotations

from collections.abc import Sequence


def private(name: str) -> str:
    """Return the private name of a declared name, or of t.

    >>> private("lambda")
    'v_lambda'
    """
    return name if name == "t" else f"v_{name}"


def acceleration(velocity: str) -> str:
    """Return the private name of the time derivative of a velocity."""
    return f"a_{velocity}"


def derivative(name: str, by: str, declared: Sequence[str]) -> str:
    """Return the private name of the derivative of one private name by another, by their numbers in `declared`.

    >>> derivative("v_r", "v_phi", ["t", "r", "phi"]), derivative("d1_2", "t", ["t", "r", "phi"])
    ('d1_2', 'd1_2_0')
    """
    numbers = name[1:] if name[0] == "d" else str(declared.index(name.removeprefix("v_")))
    return f"d{numbers}_{declared.index(by.removeprefix('v_'))}"


def public(name: str, declared: Sequence[str]) -> str:
    """Return the meaning of a private name: the declared name, or "∂r/∂phi" for a derivative.

    >>> public("v_e_", []), public("d1_2", ["t", "r", "phi"])
    ('e_', '∂r/∂phi')
    """
    if name[0] != "d":
        return name.removeprefix("v_")
    first, *others = (declared[int(number)] for number in name[1:].split("_"))
    for by in others:
        first = f"∂{first}/∂{by}"
    return first
