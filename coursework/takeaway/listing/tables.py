"""Helpers of a listing that its lines call: elimination, tabulated laws, the time before a break, the sign.

Enters: a `Writer`.  Leaves: functions in its language.  Used by the languages.

A law from a table is the quartic through five nodes, or of a spline the cubic of two values and two slopes, as the tool has it.
"""

from __future__ import annotations

from textwrap import fill

from coursework.equations.codegen.tabulated import TableLaw
from coursework.takeaway.listing.texts import ELIMINATION, FIVE, LAW, LOOK, SIGN, SPLINE
from coursework.takeaway.listing.writer import Writer

_WIDEST, _BEFORE = 120, 40  # letters of a line of numbers, and before the first of them
_BRACKETS = {"python": ("[", "]"), "javascript": ("[", "]"), "c": ("{", "}"), "octave": ("[", "]"), "pascal": ("(", ")")}


def numbers(values: list[float], open_: str, close: str, wrap: str = "") -> str:
    """Return numbers in lines that are filled."""
    told = ", ".join(f"{value:.15g}" for value in values)
    rows = fill(told, _WIDEST, initial_indent=" " * _BEFORE, subsequent_indent=" " * 4).lstrip().split("\n")
    return f"{wrap}\n".join([f"{open_}{rows[0]}", *rows[1:]]) + close


def functions(writer: Writer) -> list[str]:
    """Return the functions that the lines of a listing call, no line where they call none."""
    lines: list[str] = []
    language = writer.syntax.name
    laws = {one[len("_table_") : -2] for one in writer.tables}
    if any(writer.program.tables[name].method != "spline" for name in laws):
        lines += ["", *_filled(FIVE[language], five=writer.names.own("_five", "five"))]
    for called in writer.tables:
        name, order = called[len("_table_") : -2], int(called[-1])
        method = "spline" if writer.program.tables[name].method == "spline" else "five"
        told = writer.say("table", name=name, file=writer.words(f"listing.method.{method}"))
        lines += ["", *([told] if told not in lines else [])]
        lines += _law(writer, writer.names[called], writer.program.tables[name], order)
    if writer.needs_gauss and language in ELIMINATION:
        work = writer.names.own("_work", "work")
        lines += ["", writer.say("gauss"), *_filled(ELIMINATION[language], gauss=writer.gauss, work=work)]
    if "sign" in writer.program.calls and language in SIGN:
        lines += ["", *_filled(SIGN[language])]
    if breaks := writer.program.breaks:
        known = {"look": writer.look, "breaks": ", ".join(map(repr, breaks)), "count": str(len(breaks))}
        lines += ["", writer.say("breaks"), *_filled(LOOK[language], **known)]
    return lines


def _filled(text: str, **known: str) -> list[str]:
    """Return the lines of a text with what stands in it between braces, which the languages have too."""
    for name, value in known.items():
        text = text.replace(f"{{{name}}}", value)
    return text.splitlines()


def _law(writer: Writer, name: str, law: TableLaw, order: int) -> list[str]:
    language = writer.syntax.name
    values, slopes, *_ = (level.tolist() for level in law.levels)  # of a spline its slopes, else those of the law
    open_, close = _BRACKETS[language]
    wrap = " ..." if language == "octave" else ""
    is_spline = law.method == "spline"
    form = "y[s] + u*(m[s] + u*(b + u*a))" if order == 0 else f"(m[s] + u*(2*b + 3*u*a))/{law.step!r}"
    if language == "octave":
        form = form.replace("[s]", "(s)")
    return _filled(
        (SPLINE if is_spline else LAW)[language], name=name, first=f"({law.first!r})", step=repr(law.step),
        last=str(law.intervals - 1), nodes=str(law.intervals + 1), top=str(law.intervals), form=form,
        values=numbers(values if is_spline or order == 0 else slopes, open_, close, wrap),
        slopes=numbers(slopes, open_, close, wrap), five=writer.names.own("_five", "five"),
    )  # fmt: skip
