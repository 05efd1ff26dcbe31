"""A program -> its listing in a language.

Enters: a `Program`, a language, the words of the comments.  Leaves: text.  Used by `commands/listing.py` and `appendix.py`.
A language is an entry of `languages.toml`: texts that are filled with what is known of a program.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from textwrap import fill

from coursework.equations.codegen.tabulated import TableLaw
from coursework.report.text.words import Words
from coursework.takeaway.listing.program import Datum, Program
from coursework.takeaway.listing.syntax import Syntax, filled, syntax_of
from coursework.takeaway.listing.writer import Writer, held

_IMPORTED = {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "sqrt"}
MOST = 80  # lines that a page holds
WIDEST = 100  # letters of a line
WIDER = 120  # the same, with no empty lines, if nothing else helps; and of numbers
_BEFORE = 40  # room before the first of several lines of numbers
_SET = re.compile(r"(?:static double )?\w+(?:: double)? :?= [^;=\"']*;?")


def listing(program: Program, language: str, words: Words) -> str:
    """Return the listing of a program."""
    syntax = syntax_of(language)
    lines = _Listing(Writer(program, syntax, words)).lines()
    return "\n".join(dense([line.rstrip() for line in lines], syntax)) + "\n"


class _Listing:
    """The texts of a language, filled for one program."""

    def __init__(self, one: Writer) -> None:
        self.one, self.texts, self.program = one, one.syntax.texts, one.program
        names = one.names
        self.known = {
            "t": one.t, "row": one.row, "rates": one.rates, "count": one.count, "kind": names.own("_kind", "Velocities"),
            "text": names.own("_text", "shown"), "outs": self._listed(one.velocities),
            "data_box": one.box("data"), "rates_box": one.of_velocities, "start_box": one.box("start"),
        }  # fmt: skip

    def lines(self) -> Iterator[str]:
        """Yield the lines of the listing."""
        one, program = self.one, self.program
        inside = one.locals
        later = [one.out(stage, rate) for stage in range(1, program.scheme.slopes) for rate in one.velocities]
        of_data = [one.names[name] for name in one.targets(program.known)]
        known = [line for assigned in program.known for line in one.assigned(assigned)]
        size = one.largest
        in_velocities = self._perhaps("inside", names=", ".join([*inside, *one.velocities]), locals=", ".join(inside))
        arguments = (filled(self.texts.get("argument", "{name}"), name=name) for name in (one.t, *one.coordinates))
        self.known |= {"arguments": ", ".join(arguments), "doubles": ", ".join([one.t, *one.velocities, *later])}
        yield from self._laid("program", {
            "head": one.head(), "data": [*self._data()], "functions": functions(one), "limits": [*self._limits()],
            "blocks": one.blocks(), "rows": self._rows(),
            "known": [filled(self.texts.get("of_data", "{line}"), line=line) for line in known],
            "imports": self._perhaps("imports", calls=", ".join(sorted(program.calls & _IMPORTED))),
            "shared": self._perhaps("shared", names=" ".join(one.data)),
            "declared": self._perhaps("declared", names=", ".join(of_data)),
            "work": self._perhaps("work", work=size and one.names.own("_work", "work"), last=size - 1, size=size, more=size + 1),
            "inside": [line for text in in_velocities for line in one.wrapped(text)],
            "counted": self._perhaps("counted", count=any(block.repeats for block in program.blocks) and one.count),
        })  # fmt: skip

    def _laid(self, key: str, several: Mapping[str, Sequence[str]], **known: object) -> Iterator[str]:
        """Yield the lines of a text; a line that is one name of `several` is replaced by these lines, with its indentation."""
        for line in self.texts[key].splitlines():
            bare = line.strip()
            if bare[1:-1] in several and bare[0] == "{":
                yield from (line.replace(bare, each) for each in several[bare[1:-1]])
            else:
                yield filled(line, **{**self.known, **known})

    def _perhaps(self, key: str, **known: object) -> list[str]:
        """Return the filled text of a key in a list, [] if the language lacks it or a value that it names is empty."""
        text = self.texts.get(key, "")
        asked = [value for name, value in known.items() if f"{{{name}}}" in text]
        return [filled(text, **known)] if asked and all(asked) else []

    def _listed(self, names: Sequence[str]) -> str:
        return ", ".join(names) + self.texts.get("alone", "") * (len(names) == 1)

    def _data(self) -> Iterator[str]:
        """Yield the data, the step, the number of steps and the start, each with its unit."""
        one, program = self.one, self.program
        text = self.texts["datum"]

        def line(datum: Datum) -> str:
            told = f"  {one.comment(datum.told)}" if datum.told else ""
            return filled(text, name=one.names[datum.name], value=repr(datum.value)) + told

        yield from map(line, program.data)
        yield f"{filled(text, name=one.h, value=repr(program.step))}  {one.say('step')}"
        yield f"{filled(self.texts.get('whole', text), name=one.steps, value=max(0, program.rows - 1))}  {one.say('rows')}"
        yield from map(line, program.start)

    def _limits(self) -> Iterator[str]:
        """Yield the values of the velocities for times at which a determinant vanishes but the motion goes on."""
        one = self.one
        for limit in self.program.limits:
            values = [*map(repr, limit.values)]
            size = one.syntax.calls.get("abs", "abs")
            sets = [one.sets(name, value) for name, value in zip(one.velocities, values, strict=True)]
            yield one.say("limit")
            holds = f"{size}({one.t} - {limit.time!r}) <= {limit.within!r}"
            yield from self._laid("limit", {"sets": sets}, holds=holds, values=self._listed(values))

    def _rows(self) -> list[str]:
        """Return the line that prints the heads, and the loop over the rows."""
        one, syntax, program = self.one, self.one.syntax, self.program
        further = [line for stage in range(1, program.scheme.slopes) for line in one.wrapped(self._call(stage))]
        step = [*further, one.box("step"), *one.steps_on()]
        row = [
            one.box("time"), one.sets(f"{syntax.declares}{one.t}", f"{one.row}*{one.h}"),
            one.box("rates"), self._call(0), *one.closed(),
            one.box("row"), *one.wrapped(self._show([one.t, *one.shown()])),
            one.box("more"), *held(syntax.test, step, holds=f"{one.row} < {one.steps}"),
        ]  # fmt: skip
        heads = filled(syntax.prints, heads=",".join(program.heads))
        return [heads, one.box("loop"), *held(syntax.rows, row, i=one.row, n=one.steps), one.box("again"), one.box("end")]

    def _call(self, stage: int) -> str:
        """Return the line that computes the velocities of a slope."""
        one, arguments = self.one, ", ".join(self.one.arguments(stage))
        outs = self._listed([one.out(stage, rate) for rate in one.velocities])
        return filled(self.texts["call"], **{**self.known, "outs": outs, "arguments": arguments, "slope": one.slope(stage)})

    def _show(self, values: Sequence[str]) -> str:
        """Return the line that prints the numbers of a row."""
        told = (filled(self.texts.get("value", "{value}"), value=value, **self.known) for value in values)
        marks = ",".join(["%.15g"] * len(values))
        return filled(self.texts["show"], values=self.texts.get("between", ", ").join(told), marks=marks)


def numbers(values: list[float], open_: str, close: str, wrap: str = "") -> str:
    """Return a list of numbers in brackets, in filled lines."""
    told = ", ".join(f"{value:.15g}" for value in values)
    rows = fill(told, WIDER, initial_indent=" " * _BEFORE, subsequent_indent=" " * 4).lstrip().split("\n")
    return f"{wrap}\n".join([f"{open_}{rows[0]}", *rows[1:]]) + close


def functions(writer: Writer) -> list[str]:
    """Return the functions that the lines of a listing call, [] if they call none: elimination, tabulated laws, the sign, …

    A law from a table is the quartic through five nodes, as in the tool itself, or for a spline a cubic of two values and slopes.
    """
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


def dense(lines: list[str], syntax: Syntax) -> list[str]:
    """Return lines, made fewer if there are more than `MOST`: short assignments share a line, comments move behind code.

    >>> from coursework.takeaway.listing.syntax import syntax_of
    >>> closer(["a = b;", "c = d;"], syntax_of("c"), WIDEST), behind(["// 4 t = i·h", "t = i*h;"], syntax_of("c"), WIDEST)
    (['a = b; c = d;'], ['t = i*h;  // 4 t = i·h'])
    """
    if len(lines) > MOST:
        lines = closer(lines, syntax, WIDEST)
    if len(lines) > MOST:
        lines = behind(lines, syntax, WIDEST)
    return lines if len(lines) <= MOST else [line for line in behind(closer(lines, syntax, WIDER), syntax, WIDER) if line]


def closer(lines: list[str], syntax: Syntax, widest: int) -> list[str]:
    """Return lines in which successive short assignments share a line; of data only those with the same comment."""

    def joined(above: str, line: str) -> str:
        text, said = _parts(line, syntax)
        before, told = _parts(above, syntax)
        fits = said == told and _is_set(text) and _is_set(before) and _margin(text) == _margin(before)
        return f"{before}{'' if before.endswith(';') else ';'} {text.lstrip()}{said}" if fits else ""

    return _merged(lines, joined, widest)


def behind(lines: list[str], syntax: Syntax, widest: int) -> list[str]:
    """Return lines in which a box's comment stands behind the line below it, if both fit."""

    def joined(above: str, line: str) -> str:
        named = re.match(rf" *{re.escape(syntax.comment)}\d+ ", above)
        is_free = line.strip() and not line.lstrip().startswith(syntax.comment) and not _parts(line, syntax)[1]
        return f"{line}  {above.lstrip()}" if named and is_free and _margin(above) == _margin(line) else ""

    return _merged(lines, joined, widest)


def _merged(lines: list[str], joined: Callable[[str, str], str], widest: int) -> list[str]:
    """Return lines, each merged with the one above if `joined` allows it and the result is not too wide."""
    found: list[str] = []
    for line in lines:
        both = joined(found[-1], line) if found else ""
        if both and len(both) <= widest:
            found[-1] = both
        else:
            found.append(line)
    return found


def _parts(line: str, syntax: Syntax) -> tuple[str, str]:
    """Return the code of a line and the comment behind it."""
    text, mark, said = line.partition(f"  {syntax.comment}")
    return (text, mark + said) if text.strip() else (line, "")


def _margin(line: str) -> int:
    return len(line) - len(line.lstrip())


def _is_set(line: str) -> bool:
    """Return whether a line consists of whole assignments."""
    return all(_SET.fullmatch(one.strip()) and one.count("(") == one.count(")") for one in line.rstrip(";").split(";"))
