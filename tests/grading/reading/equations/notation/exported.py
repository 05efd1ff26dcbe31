"""Right equations as exports, keyboards, solvers and calculators leave them: a form makes the text of one plain text each."""

from __future__ import annotations

import json
import re

from tests.grading.reading.equations.notation.notations import _calls, _greek, _lines, _named, _tex

SLIDER = """a*wa*cos(alpha) + b*wb*cos(beta) = 0
v + a*wa*sin(alpha) + b*wb*sin(beta) = 0"""


def _sides(form):
    return lambda text: "\n".join(form(*line.split(" = ")) for line in text.split("\n"))


def _moved(text):
    """The side that is no sum first: 0 = …, u = …"""
    return _sides(lambda left, right: f"{right} = {left}")(text)


def _wide(text, signs="=+-()"):
    return text.translate({ord(sign): ord(sign) + 0xFEE0 for sign in signs})


def _heads(text):
    return _calls(text, lambda found: f"{found[1].title()}[{found[2]}]")


def _joined(sign, form=lambda text: text):
    return lambda text: sign.join(map(form, text.split("\n")))


FORMS = {
    "slashes": _joined(" / "), "slashes, moved": lambda t: _joined(" / ")(_moved(t)), "dots": _joined(" • "),
    "double dashes": _joined(" -- "), "bars": _joined(" || "), "a bar": _joined(" | "), "tight bars": _joined("||"),
    "and of a logician": _joined(" ∧ "), "and of a program": _joined(" /\\ "), "an ampersand": _joined(" & "),
    "and of LaTeX": _joined(" \\land ", _tex),
    "escaped": _joined("\\n"), "escaped twice": _joined("\\\\n"), "escaped for Windows": _joined("\\r\\n"),
    "escaped in a cell": lambda t: f'equations,"{_joined(chr(92) + "n")(t)}"', "escaped LaTeX": _joined("\\n", _tex),
    "Julia": lambda t: t.replace(" = ", " ~ "), "Julia, named": lambda t: _lines("eq{k} = {e}")(t.replace(" = ", " ~ ")),
    "Julia, a list": lambda t: "eqs = [\n    " + ",\n    ".join(t.replace(" = ", " ~ ").split("\n")) + "\n]",
    "Julia, dotted": lambda t: t.replace("sin(", "sin.(").replace("cos(", "cos.("),
    "components": lambda t: re.sub("VM([xy])", r"(V_M)_\1", t), "by axes": lambda t: re.sub("VM([xy])", r"V_\1^M", t),
    "rates of places": lambda t: re.sub("VM([xy])", r"d\1_M/dt", t), "axes first": lambda t: re.sub("VM([xy])", r"V\1M", t),
    "components in LaTeX": lambda t: re.sub(r"V_\{M([xy])\}", r"\\left(V_{M}\\right)_{\1}", _tex(t)),
    "YAML": lambda t: "equations:\n" + _lines('  - "{e}"')(t), "YAML, named": _lines("eq{k}: '{e}'"),
    "YAML, rows": _lines('- name: {k}\n  because: C is fixed\n  equation: "{e}"'), "TOML": _lines('eq{k} = "{e}"'),
    "TOML, a list": lambda t: "eqs = [" + ", ".join(f"'{line}'" for line in t.split("\n")) + "]",
    "TOML, tables": _lines('[[equation]]\ntext = "{e}"\n'),
    "wide signs": _wide, "wide signs alone": lambda t: _wide(t, "=()"),
    "other signs": lambda t: t.replace("*", "⋆").replace("=", "≜").replace(" - ", " ˗ "),
    "script l": lambda t: re.sub("r(?=[0-9])", "ℓ", t),
    "a vector's length": lambda t: re.sub(r"\b(r\d)\b", r"|\1|", t),
    "Roman": lambda t: "\n".join(f"{'ⅠⅡⅢⅣ'[k]}. {line}" for k, line in enumerate(t.split("\n"))), "ticked": _lines("☑ {e}"),
    "keycaps": _lines("{k}\ufe0f\u20e3 {e}"), "numbers in brackets behind": _lines("{e}    [eq. {k}]"),
    "a remark": _lines('{e} "C is fixed"'), "a remark of a shell": _lines("{e} ! C is fixed"),
    "empty groups": lambda t: _tex(t).replace(" - ", " {}-{} ").replace(r"\,", r"\cdot{}"),
    "in colour": lambda t: "\n".join(f"\\textcolor{{red}}{{{_tex(line)}}}" for line in t.split("\n")),
    "a brace below": lambda t: _sides(lambda left, right: f"\\underbrace{{{left}}}_{{C}} = {right}")(_tex(t)),
    "split": lambda t: "\n".join(
        "\\begin{equation}\\begin{split}\n" + re.sub(" ([-+]) ", r" \\\\ &\\quad \1 ", _tex(line), count=1).replace("=", "={}&")
        + "\n\\end{split}\\end{equation}" for line in t.split("\n")
    ),
    "Typst, one formula": lambda t: "$ " + " \\\n  ".join(_named(t, lambda n: n).replace("*", " ").split("\n")) + " $",
    "a calculator": lambda t: f"solve({' and '.join(t.split(chr(10)))},w1,w2)",
    "fsolve": lambda t: "F = @(x) [" + "; ...\n  ".join(_sides(lambda left, right: f"{left} - ({right})")(t).split("\n")) + "];",
    "Mathcad": lambda t: "Given\n" + _named(t, _greek) + "\nFind(w1, w2) =",
    "XML": _lines('<equation id="{k}">{e}</equation>'), "printed": _lines("print('{e}')"),
    "spoken zero": lambda t: t.replace("= 0", "equals zero"), "dotted equals": lambda t: t.replace("=", ".=="),
    "spoken signs": lambda t: t.replace(" - ", " minus ").replace(" + ", " plus "), "bars of axes": _lines("Ox| {e}"),
    "a mark at the sign": lambda t: _tex(t).replace("=", r"\stackrel{!}{=}").replace(" - ", r" \mathbin{-} "),
    "rates of time": lambda t: re.sub(r"\bw([23])", "φ\u0307_\\1(t)", t), "letters and numbers": _lines("(E{k}) {e}"),
    "why it vanishes": _lines('"{k}","{e}","C is fixed, so v_C = 0"'), "why, and no blank": _lines("{e}; C is fixed"),
    "halves of LaTeX": lambda t: _tex(t).replace("0.5", r"\nicefrac{1}{2}").replace("= 0", r"\phantom{x} {=} \hphantom{-} 0"),
    "over": lambda t: _tex(t).replace("0.5", r"{1 \over 2}").replace("\\omega", r"{\omega}"),
    "Mathematica": lambda t: "eqs = {" + ",\n  ".join(_heads(t).replace("=", "==").split("\n")) + "}",
}  # fmt: skip

# What a program says, solved for the velocities; each ends with its last formula.
SOLVED = {"w3": "VMy/(r3*(2*cos(phi3) + sin(phi3)))", "w4": "2*w3*(cos(phi3) - 2*sin(phi3))",
          "w1": "-r3*w3*sin(phi3)*(2*cos(phi2) + sin(phi2))/(r1*sin(phi1 - phi2))",
          "w2": "r3*w3*sin(phi3)*(2*cos(phi1) + sin(phi1))/(r2*sin(phi1 - phi2))"}  # fmt: skip


def _program(form, between="\n"):
    return between.join(form.format(n=name, f=formula, t=formula.title()) for name, formula in SOLVED.items())


PROGRAMS = {
    "arrows of JavaScript": _program("const {n} = (t, y) => {f};"), "functions of R": _program("{n} <- function(t, y) {f}"),
    "functions of Go": _program("func {n}(t float64) float64 {{\n    return {f}\n}}"),
    "functions of C": _program("double {n}(double t) {{\n    return {f};\n}}"),
    "functions of Python": _program("def {n}(t, phi):\n    return {f}"),
    "formulas that go on": _program("{n} = {f};").replace(" + ", "\n      + ").replace(" - ", "\n      - "),
    "formulas with marks": _program("      {n} = {f}").replace(" + ", " + &\n     & ").replace(" - ", " - &\n     & "),
    "stored": _program("{f}→{n}"), "found": "{{" + _heads(_program("{n} -> {f}", ", ")) + "}}",
    "slashes": _program("{n} = {f}", " / "), "a dictionary": "w = {\n    " + _program("'{n}': {f}", ",\n    ") + "\n}",
    "SymPy": "import sympy as sp\n" + _program("sp.Eq({n}, {f}),"),
    "YAML": _program('{n}: "{f}"'),
    "units of LaTeX": "\n".join(
        f"${_tex(name)} = {_tex(formula)}\\,\\si{{\\radian\\per\\second}}$" for name, formula in SOLVED.items()
    ),
}  # fmt: skip

RECORDS = {
    "records": lambda t: json.dumps([{"n": k, "eq": line, "why": "C is fixed"} for k, line in enumerate(t.split("\n"))]),
    "sides": lambda t: json.dumps([dict(zip(("lhs", "rhs"), line.split(" = "), strict=True)) for line in t.split("\n")]),
    "escaped": lambda t: json.dumps({"equations": t.replace("\n", "\\n")}),
    "wide": lambda t: json.dumps({"equations": _wide(t).split("\n")}),
}  # fmt: skip
