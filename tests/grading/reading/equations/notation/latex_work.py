"""Right equations in LaTeX as it is typed: environments, lines broken in them, tags, words between.

Made from one plain text each, as `notations.py` does; `written_work.py` has the other forms.
"""

from __future__ import annotations

import re

from tests.grading.reading.equations.notation.notations import _calls, _latex, _named, _tex


def each(form):
    return lambda text: "\n".join(form(k, line) for k, line in enumerate(text.split("\n"), 1))


def brk(sep, indent=""):
    def made(k, line):
        # break after the middle operator
        places = [m.start() for m in re.finditer(r" [-+] ", line)]
        if not places:
            return line
        at = places[len(places) // 2]
        return line[:at] + sep(line[at : at + 3]) + line[at + 3 :]

    return each(made)


LATEX = {
    "eqnarray": lambda t: (
        "\\begin{eqnarray}\n" + " \\\\\n".join(_tex(line).replace("=", "&=&") for line in t.split("\n")) + "\n\\end{eqnarray}"
    ),
    "gather*": lambda t: "\\begin{gather*}\n" + " \\\\\n".join(_tex(line) for line in t.split("\n")) + "\n\\end{gather*}",
    "aligned": lambda t: (
        "\\[\\left\\{\\begin{aligned}\n"
        + " \\\\\n".join("&" + _tex(line) for line in t.split("\n"))
        + "\n\\end{aligned}\\right.\\]"
    ),
    "aligned +&": lambda t: (
        "\\begin{align*}\n"
        + " \\\\\n".join("& " + brk(lambda o: " \\nonumber\\\\\n & \\quad " + o.lstrip())(_tex(line)) for line in t.split("\n"))
        + "\n\\end{align*}"
    ),
    "multline": lambda t: "\n".join(
        "\\begin{multline}\n" + brk(lambda o: "\\\\\n" + o.lstrip())(_tex(line)) + "\n\\end{multline}" for line in t.split("\n")
    ),
    "split": lambda t: "\n".join(
        "\\begin{equation}\\begin{split}\n"
        + brk(lambda o: "\\\\\n & " + o.lstrip())(_tex(line).replace("=", "&="))
        + "\n\\end{split}\\end{equation}"
        for line in t.split("\n")
    ),
    "tag": lambda t: "\n".join(f"$${_tex(line)} \\tag{{{k}}}$$" for k, line in enumerate(t.split("\n"), 1)),
    "label": lambda t: "\n".join(
        f"\\begin{{equation}}\\label{{e{k}}}\n{_tex(line)}\n\\end{{equation}}" for k, line in enumerate(t.split("\n"), 1)
    ),
    "text": lambda t: "\n".join(f"\\text{{Am Punkt }}C\\text{{ gilt: }} {_tex(line)}" for line in t.split("\n")),
    "mbox": lambda t: "\n".join(f"$\\mbox{{x: }} {_tex(line)}$" for line in t.split("\n")),
    "quad text": lambda t: "\n".join(f"$${_tex(line)} \\quad \\text{{(C)}}$$" for line in t.split("\n")),
    "prose latex": lambda t: "\n".join(f"Am Punkt $C$ gilt ${_tex(line)}$, also mit $t > 0$." for line in t.split("\n")),
    "prose latex zh": lambda t: "\n".join(f"对点$C$有${_tex(line)}$，其中$\\omega_3$为角速度。" for line in t.split("\n")),
    "prose latex ru": lambda t: "\n".join(f"Для точки $C$ имеем ${_tex(line)}$, где $t$ — время." for line in t.split("\n")),
    "mathsf": lambda t: re.sub(r"\\omega", r"\\mathit{\\omega}", _tex(t)),
    "boldsymbol": lambda t: re.sub(r"\\omega", r"\\boldsymbol{\\omega}", _tex(t)),
    "operatorname": lambda t: _tex(t).replace("\\sin", "\\operatorname{sin}"),
    "left(": lambda t: _calls(_named(t, _latex), r"\\\1\\left(\2\\right)").replace("*", " "),
    "\\!": lambda t: _tex(t, "\\!"),
    "\\;": lambda t: _tex(t, "\\;"),
    "\\times": lambda t: _tex(t, "\\times "),
    "~": lambda t: _tex(t, "~"),
    "big": lambda t: _calls(_named(t, _latex), r"\\\1\\bigl(\2\\bigr)").replace("*", " "),
}
