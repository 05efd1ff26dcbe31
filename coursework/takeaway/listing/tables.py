"""Helpers of a listing that its lines call: elimination, tabulated laws, the time before a break, the sign.

Enters: a `Writer`.  Leaves: functions in its language.  Used by the languages.

A law from a table is the quartic through five nodes, or of a spline the cubic of two values and two slopes, as the tool has it.
"""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING

from coursework.equations.codegen.tabulated import TableLaw

if TYPE_CHECKING:
    from coursework.takeaway.listing.writer import Writer


_WIDEST, _BEFORE = 120, 40  # letters of a line of numbers, and before the first of them


def levels(law: TableLaw) -> tuple[list[float], list[float]]:
    """Return what a law and its slope are made of at the nodes: values, and derivatives or slopes of the spline."""
    first, second, *_ = (level.tolist() for level in law.levels)
    return first, second


def numbers(values: list[float], open_: str, close: str, wrap: str = "") -> str:
    """Return numbers in lines that are filled."""
    told = ", ".join(f"{value:.15g}" for value in values)
    rows = fill(told, _WIDEST, initial_indent=" " * _BEFORE, subsequent_indent=" " * 4).lstrip().split("\n")
    return f"{wrap}\n".join([f"{open_}{rows[0]}", *rows[1:]]) + close


ELIMINATION = {
    "python": """def {gauss}(a):
    size, determinant = len(a), 1.0
    for j in range(size):
        p = max(range(j, size), key=lambda r: abs(a[r][j]))
        if p != j:
            a[j], a[p], determinant = a[p], a[j], -determinant
        determinant *= a[j][j]
        for r in range(size):
            if r != j:
                f = a[r][j]/a[j][j]
                a[r] = [x - f*y for x, y in zip(a[r], a[j])]
    return [a[j][size]/a[j][j] for j in range(size)] + [determinant]
""",
    "javascript": """function {gauss}(a) {
    const size = a.length;
    let determinant = 1.0;
    for (let j = 0; j < size; j++) {
        let p = j;
        for (let r = j; r < size; r++) if (Math.abs(a[r][j]) > Math.abs(a[p][j])) p = r;
        if (p !== j) { [a[j], a[p]] = [a[p], a[j]]; determinant = -determinant; }
        determinant *= a[j][j];
        for (let r = 0; r < size; r++) if (r !== j) {
            const f = a[r][j]/a[j][j];
            a[r] = a[r].map((x, c) => x - f*a[j][c]);
        }
    }
    return [...a.map((row, j) => row[size]/row[j]), determinant];
}
""",
    "c": """static double {gauss}(int size) {
    double determinant = 1.0, f;
    for (int j = 0; j < size; j++) {
        int p = j;
        for (int r = j; r < size; r++) if (fabs({work}[r][j]) > fabs({work}[p][j])) p = r;
        if (p != j) determinant = -determinant;
        for (int c = 0; c <= size; c++) { f = {work}[j][c]; {work}[j][c] = {work}[p][c]; {work}[p][c] = f; }
        determinant *= {work}[j][j];
        for (int r = 0; r < size; r++) if (r != j) {
            f = {work}[r][j]/{work}[j][j];
            for (int c = j; c <= size; c++) {work}[r][c] -= f*{work}[j][c];
        }
    }
    for (int j = 0; j < size; j++) {work}[j][size] /= {work}[j][j];
    return determinant;
}
""",
    "pascal": """function {gauss}(size: integer): double;
var a, b, c, p: integer; f, d: double;
begin
  d := 1.0;
  for a := 0 to size - 1 do begin
    p := a;
    for b := a to size - 1 do if abs({work}[b][a]) > abs({work}[p][a]) then p := b;
    if p <> a then d := -d;
    for c := 0 to size do begin f := {work}[a][c]; {work}[a][c] := {work}[p][c]; {work}[p][c] := f end;
    d := d*{work}[a][a];
    for b := 0 to size - 1 do if b <> a then begin
      f := {work}[b][a]/{work}[a][a];
      for c := a to size do {work}[b][c] := {work}[b][c] - f*{work}[a][c];
    end;
  end;
  for a := 0 to size - 1 do {work}[a][size] := {work}[a][size]/{work}[a][a];
  {gauss} := d;
end;
""",
}

# The quartic of Lagrange through five nodes, a function of all such laws; `y` are the numbers at the nodes.
FIVE = {
    "python": """def {five}(x, y, first, step):
    u = (x - first)/step
    s = min(max(min(max(int(u), 0), len(y) - 2) - 1, 0), len(y) - 5)
    total = 0.0
    for a in range(5):
        part = y[s + a]
        for b in range(5):
            if b != a:
                part = part*(u - s - b)/(a - b)
        total = total + part
    return total
""",
    "javascript": """function {five}(x, y, first, step) {
    const u = (x - first)/step;
    const s = Math.min(Math.max(Math.min(Math.max(Math.trunc(u), 0), y.length - 2) - 1, 0), y.length - 5);
    let total = 0.0;
    for (let a = 0; a < 5; a++) {
        let part = y[s + a];
        for (let b = 0; b < 5; b++) if (b !== a) part = part*(u - s - b)/(a - b);
        total += part;
    }
    return total;
}
""",
    "c": """static double {five}(double x, const double y[], int nodes, double first, double step) {
    double u = (x - first)/step, total = 0.0;
    int s = (int) u;
    s = (s < 0 ? 0 : s > nodes - 2 ? nodes - 2 : s) - 1;
    s = s < 0 ? 0 : s > nodes - 5 ? nodes - 5 : s;
    for (int a = 0; a < 5; a++) {
        double part = y[s + a];
        for (int b = 0; b < 5; b++) if (b != a) part = part*(u - s - b)/(a - b);
        total += part;
    }
    return total;
}
""",
    "octave": """function total = {five}(x, y, first, step)
    u = (x - first)/step;
    s = min(max(min(max(fix(u), 0), numel(y) - 2) - 1, 0), numel(y) - 5);
    total = 0.0;
    for a = 0:4
        part = y(s + a + 1);
        for b = [0:a-1, a+1:4]
            part = part*(u - s - b)/(a - b);
        end
        total = total + part;
    end
end
""",
    "pascal": """function {five}(x: double; const y: array of double; first, step: double): double;
var u, part: double; a, b, s: integer;
begin
  u := (x - first)/step; result := 0.0;
  s := min(max(min(max(trunc(u), 0), high(y) - 1) - 1, 0), high(y) - 4);
  for a := 0 to 4 do begin
    part := y[s + a];
    for b := 0 to 4 do if b <> a then part := part*(u - s - b)/(a - b);
    result := result + part;
  end;
end;
""",
}
LAW = {
    "python": """def {name}(x):
    y = {values}
    return {five}(x, y, {first}, {step})
""",
    "javascript": """function {name}(x) {
    const y = {values};
    return {five}(x, y, {first}, {step});
}
""",
    "c": """static double {name}(double x) {
    static const double y[] = {values};
    return {five}(x, y, {nodes}, {first}, {step});
}
""",
    "octave": """function value = {name}(x)
    y = {values};
    value = {five}(x, y, {first}, {step});
end
""",
    "pascal": """function {name}(x: double): double;
const y: array[0..{top}] of double = {values};
begin {name} := {five}(x, y, {first}, {step}) end;
""",
}
# The cubic of a spline, `form` in u from the two values and the two slopes at the ends of an interval.
SPLINE = {
    "python": """def {name}(x):
    y = {values}
    m = {slopes}
    u = (x - {first})/{step}
    s = min(max(int(u), 0), {last})
    u = u - s
    a, b = 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1], -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1]
    return {form}
""",
    "javascript": """function {name}(x) {
    const y = {values};
    const m = {slopes};
    const s = Math.min(Math.max(Math.trunc((x - {first})/{step}), 0), {last}), u = (x - {first})/{step} - s;
    const a = 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1], b = -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1];
    return {form};
}
""",
    "c": """static double {name}(double x) {
    static const double y[] = {values};
    static const double m[] = {slopes};
    double u = (x - {first})/{step};
    int s = (int) u;
    s = s < 0 ? 0 : s > {last} ? {last} : s;
    u = u - s;
    double a = 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1], b = -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1];
    return {form};
}
""",
    "octave": """function value = {name}(x)
    y = {values};
    m = {slopes};
    u = (x - {first})/{step};
    s = min(max(fix(u), 0), {last});
    u = u - s;
    s = s + 1;
    a = 2*y(s) - 2*y(s + 1) + m(s) + m(s + 1);
    b = -3*y(s) + 3*y(s + 1) - 2*m(s) - m(s + 1);
    value = {form};
end
""",
    "pascal": """function {name}(x: double): double;
const y: array[0..{top}] of double = {values};
const m: array[0..{top}] of double = {slopes};
var u, a, b: double; s: integer;
begin
  u := (x - {first})/{step};
  s := min(max(trunc(u), 0), {last});
  u := u - s;
  a := 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1]; b := -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1];
  {name} := {form};
end;
""",
}
_BRACKETS = {"python": ("[", "]"), "javascript": ("[", "]"), "c": ("{", "}"), "octave": ("[", "]"), "pascal": ("(", ")")}


def functions(writer: Writer) -> list[str]:
    """Return the functions that the lines of a listing call, no line where they call none."""
    lines: list[str] = []
    language = writer.syntax.name
    laws = {one[len("_table_") : -2] for one in writer.tables}
    if any(writer.program.tables[name].method != "spline" for name in laws):
        lines += ["", *FIVE[language].replace("{five}", writer.names.own("_five", "five")).splitlines()]
    for called in writer.tables:
        name, order = called[len("_table_") : -2], int(called[-1])
        told = writer.say("table", name=name, file=law_file(writer, name))
        lines += ["", *([told] if told not in lines else [])]
        lines += _law(writer, writer.names[called], writer.program.tables[name], order)
    if writer.needs_gauss and language in ELIMINATION:
        work = writer.names.own("_work", "work")
        lines += ["", writer.say("gauss")]
        lines += ELIMINATION[language].replace("{gauss}", writer.gauss).replace("{work}", work).splitlines()
    return lines


def law_file(writer: Writer, name: str) -> str:
    """Return how a tabulated law goes between its nodes."""
    return writer.words(f"listing.method.{'spline' if writer.program.tables[name].method == 'spline' else 'five'}")


def _law(writer: Writer, name: str, law: TableLaw, order: int) -> list[str]:
    language = writer.syntax.name
    values, slopes = levels(law)
    open_, close = _BRACKETS[language]
    wrap = " ..." if language == "octave" else ""
    is_spline = law.method == "spline"
    form = "y[s] + u*(m[s] + u*(b + u*a))" if order == 0 else f"(m[s] + u*(2*b + 3*u*a))/{law.step!r}"
    if language == "octave":
        form = form.replace("[s]", "(s)")
    text = (SPLINE if is_spline else LAW)[language]
    shown = {
        "{name}": name, "{first}": f"({law.first!r})", "{step}": repr(law.step), "{last}": str(law.intervals - 1),
        "{nodes}": str(law.intervals + 1), "{top}": str(law.intervals), "{form}": form,
        "{values}": numbers(values if is_spline or order == 0 else slopes, open_, close, wrap),
        "{slopes}": numbers(slopes, open_, close, wrap), "{five}": writer.names.own("_five", "five"),
    }  # fmt: skip
    for mark, value in shown.items():
        text = text.replace(mark, value)
    return text.splitlines()
