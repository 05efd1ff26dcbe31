"""Helper functions that the lines of a listing call: elimination, tabulated laws, the time before a break, the sign.

Enters: a `Writer`.  Leaves: functions in its language.  Used by the languages.

As in the tool itself, a law from a table is the quartic through five nodes, or for a spline the cubic of two values and slopes.
"""

from __future__ import annotations

from textwrap import fill

from coursework.equations.codegen.tabulated import TableLaw
from coursework.takeaway.listing.syntax import filled
from coursework.takeaway.listing.writer import Writer

_WIDEST, _BEFORE = 120, 40  # letters of a line of numbers, and room before the first of them


def numbers(values: list[float], open_: str, close: str, wrap: str = "") -> str:
    """Return a list of numbers in brackets, in filled lines."""
    told = ", ".join(f"{value:.15g}" for value in values)
    rows = fill(told, _WIDEST, initial_indent=" " * _BEFORE, subsequent_indent=" " * 4).lstrip().split("\n")
    return f"{wrap}\n".join([f"{open_}{rows[0]}", *rows[1:]]) + close


def functions(writer: Writer) -> list[str]:
    """Return the functions that the lines of a listing call, [] if they call none."""
    lines: list[str] = []
    own = writer.syntax.texts
    laws = {one[len("_table_") : -2] for one in writer.tables}
    if any(writer.program.tables[name].method != "spline" for name in laws):
        lines += ["", *filled(own["five"], five=writer.names.own("_five", "five")).splitlines()]
    for called in writer.tables:
        name, order = called[len("_table_") : -2], int(called[-1])
        method = "spline" if writer.program.tables[name].method == "spline" else "five"
        told = writer.say("table", name=name, file=writer.words(f"listing.method.{method}"))
        lines += ["", *([told] if told not in lines else [])]
        lines += _law(writer, writer.names[called], writer.program.tables[name], order)
    if writer.largest and "gauss" in own:
        work = writer.names.own("_work", "work")
        lines += ["", writer.say("gauss"), *filled(own["gauss"], gauss=writer.gauss, work=work).splitlines()]
    if "sign" in writer.program.calls and "sign" in own:
        lines += ["", *filled(own["sign"]).splitlines()]
    if breaks := writer.program.breaks:
        known = {"look": writer.look, "breaks": ", ".join(map(repr, breaks)), "count": str(len(breaks))}
        lines += ["", writer.say("breaks"), *filled(own["before_break"], **known).splitlines()]
    return lines


def _law(writer: Writer, name: str, law: TableLaw, order: int) -> list[str]:
    syntax, is_spline = writer.syntax, law.method == "spline"
    values, slopes, *_ = (level.tolist() for level in law.levels)  # slopes of the spline, or of the law
    at = syntax.node
    form = f"y{at} + u*(m{at} + u*(b + u*a))" if order == 0 else f"(m{at} + u*(2*b + 3*u*a))/{law.step!r}"
    return filled(
        syntax.texts["spline" if is_spline else "law"], name=name, first=f"({law.first!r})", step=repr(law.step),
        last=str(law.intervals - 1), nodes=str(law.intervals + 1), top=str(law.intervals), form=form,
        values=numbers(values if is_spline or order == 0 else slopes, *syntax.brackets, syntax.wrap),
        slopes=numbers(slopes, *syntax.brackets, syntax.wrap), five=writer.names.own("_five", "five"),
    ).splitlines()  # fmt: skip
