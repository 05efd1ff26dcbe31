"""The second back end of code generation: a straight-line program as a JavaScript function.

Enters: a `Bound`.  Leaves: JavaScript text with the same meaning, over `Math` and the runtime in `reports/live`.
Used by `live`, whose page may not evaluate text: all its formulas are part of its script.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from coursework.equations.codegen.programs import Bound
from coursework.equations.codegen.straight_line import Line

_SOLVED = re.compile(r"_solve\(\((.*)\)\)")
_NAME = re.compile(r"[A-Za-z_]\w*")


def javascript_function(name: str, arguments: Mapping[str, Sequence[str]], body: Bound, results: Sequence[str]) -> str:
    """Return `const name = (t, q, …, out) => {…}`, which writes its results into `out` in order and returns it.

    `arguments` maps the name of each array argument to the private names of its entries; an empty sequence means a number
    with this very name.

    >>> from coursework.equations.codegen.programs import Bound
    >>> line = Line(("v_w",), "v_w = v_p*cos(t)")
    >>> print(javascript_function("rate", {"t": (), "d": ("v_r", "v_p")}, Bound((line,), {}, {}), ["v_w"]))
    const rate = (t, d, out) => {
    const v_p = d[1];
    out[0] = v_p*cos(t);
    return out;
    };
    """
    inside = {word for line in body.lines for word in _NAME.findall(line.value)}
    # A result that no line reads is written directly into `out`.
    direct = {result: f"out[{place}]" for place, result in enumerate(results) if result not in inside}
    written = {target for line in body.lines for target in line.targets if len(line.targets) == 1}
    handed = [
        f"const {one} = {array}[{place}];"
        for array, names in arguments.items()
        for place, one in enumerate(names)
        if one in inside or one in results
    ]
    kept = [f"out[{place}] = {result};" for place, result in enumerate(results) if not (result in direct and result in written)]
    head = f"const {name} = ({', '.join((*arguments, 'out'))}) => {{"
    return "\n".join((head, *handed, *(_statement(line, direct) for line in body.lines), *kept, "return out;", "};"))


def called_tables(body: Bound) -> dict[str, tuple[str, int]]:
    """Return the tabulated laws that a program calls: name in the program -> (name of the law, order of derivative)."""
    called = {word for line in body.lines for word in _NAME.findall(line.text)}
    known = {f"_table_{key}_{order}": (key, order) for key in body.tables for order in range(3)}
    return {name: law for name, law in known.items() if name in called}


def _statement(line: Line, direct: Mapping[str, str]) -> str:
    """Return one line as JavaScript; only functions without arguments, lists and assignments differ from Python."""
    value = _SOLVED.sub(r"_solve([\1])", line.value).replace("lambda: ", "() => ")
    if line.targets[0] in direct and len(line.targets) == 1:
        return f"{direct[line.targets[0]]} = {value};"
    targets = line.targets[0] if len(line.targets) == 1 else f"[{', '.join(line.targets)}]"
    return f"const {targets} = {value};"
