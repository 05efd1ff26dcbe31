"""Right equations of five mechanisms in the notations of programs, countries and habits, made from one plain text each."""

from __future__ import annotations

import re

PLAIN = {
    "31": """VMy - 2*r3*w3*cos(phi3) - r3*w3*sin(phi3) = 0
2*r3*w3*sin(phi3) - r3*w3*cos(phi3) + 0.5*r3*w4 = 0
-0.5*r3*w4 + r3*w3*cos(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0
r3*w3*sin(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0""",
    "v102": """VMx + a*w3*sin(phi3) + c*w3*cos(phi3) = 0
VMy - a*w3*cos(phi3) + c*w3*sin(phi3) = u
VMx + a*w3*sin(phi3) + r2*w2*sin(phi2) + r1*w1*sin(phi1) = 0
VMy - a*w3*cos(phi3) - r2*w2*cos(phi2) - r1*w1*cos(phi1) = 0""",
    "v107": """u*cos(phi3) - s*w3*sin(phi3) = VMx
u*sin(phi3) + s*w3*cos(phi3) = VMy
VMy - b*w3*cos(phi3) - r2*w2*cos(phi2) = 0
VMx + b*w3*sin(phi3) + r2*w2*sin(phi2) + R*w1 = 0""",
    # Two that are in no catalogue: files of their own stand in `tests/grading/whole_class/`.
    "geared": """w4 + k*w1 = 0
r1*w1*sin(phi1) + r2*w2*sin(phi2) - r3*w3*sin(phi3) - r4*w4*sin(phi4) = 0
r1*w1*cos(phi1) + r2*w2*cos(phi2) - r3*w3*cos(phi3) - r4*w4*cos(phi4) = 0""",
    "offset": """a*wa*cos(alpha) + b*wb*cos(beta) = 0
v + a*wa*sin(alpha) + b*wb*sin(beta) = 0""",
}
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_ITALICS = str.maketrans("rωφacusbRVMxykvαβ", "𝑟𝜔𝜑𝑎𝑐𝑢𝑠𝑏𝑅𝑉𝑀𝑥𝑦𝑘𝑣𝛼𝛽")
_NAMES = re.compile(r"\b(VMx|VMy|w[\dab]|phi\d|alpha|beta|r\d|[acusbRkv])\b(?!\()")
_CALLS = re.compile(r"(sin|cos)\(([^()]*)\)")


def _named(text, form):
    return _NAMES.sub(lambda found: form(found[1]), text)


def _greek(name):
    for latin, greek in (("phi", "φ"), ("w", "ω"), ("alpha", "α"), ("beta", "β")):
        name = name.replace(latin, greek)
    return name


def _subscripts(name):
    return _greek(name).translate(_SUBSCRIPTS)


def _latex(name):
    if name.startswith("VM"):
        return f"V_{{M{name[2]}}}"
    parts = re.fullmatch(r"(w|phi|r)(\d|[ab])", name)
    letter = {"w": "\\omega", "phi": "\\varphi", "r": "r", "alpha": "\\alpha", "beta": "\\beta"}
    return f"{letter[parts[1]]}_{{{parts[2]}}}" if parts else letter.get(name, name)


def _calls(text, form):
    return _CALLS.sub(form, text)


def _tex(text, product="\\,"):
    return _calls(_named(text, _latex), r"\\\1 \2").replace("*", product)


def _rates(form):
    return lambda text: re.sub(r"\bw([23])", form, text)


def _lines(form):
    def made(text):
        return "\n".join(form.format(k=k, e=line, K=("I", "II", "III", "IV")[k - 1], L="abcd"[k - 1])
                         for k, line in enumerate(text.split("\n"), 1))  # fmt: skip

    return made


def _full_width(text):
    return "".join(chr(ord(letter) + 0xFEE0) if "!" <= letter <= "~" else letter for letter in text)


def _array(text):
    rows = " \\\\\n".join(_tex(line, " ").replace("=", "&=&") for line in text.split("\n"))
    return f"\\begin{{equation}}\n\\left\\{{\\begin{{array}}{{rcl}}\n{rows}\n\\end{{array}}\\right.\n\\end{{equation}}"


NOTATIONS = {
    "greek": lambda t: _named(t, _greek),
    "subscripts": lambda t: _named(t, _subscripts).replace("*", "⋅").replace("-", "−"),
    "italics": lambda t: _named(t, lambda n: _subscripts(n).translate(_ITALICS)).replace("*", "").replace("-", "−"),
    "thin blanks": lambda t: _named(t, lambda n: _subscripts(n).translate(_ITALICS)).replace("*", "\u2009"),
    "glued": lambda t: _calls(_named(t, _greek).replace("*", ""), r"\1\2"),
    "latex": _tex,
    "latex braces": lambda t: _calls(_named(t, _latex), r"\\\1{\2}").replace("*", " \\cdot "),
    "latex array": _array,
    "latex cases": lambda t: "\\begin{cases} " + " \\\\ ".join(map(_tex, t.split("\n"))) + " \\end{cases}",
    "latex equiv": lambda t: _tex(t).replace("= 0", "\\equiv 0,"),
    "latex z": lambda t: re.sub(r"\\omega_\{(\d)\}", r"\\omega_{\1}^{z}", _tex(t)),
    "mathrm": lambda t: re.sub(r"\\omega_\{([23])\}", r"\\frac{\\mathrm{d}\\varphi_{\1}}{\\mathrm{d}t}", _tex(t)),
    "w^z": lambda t: re.sub(r"\bw(\d)", r"ω_\1^z", t),
    "diff": _rates(r"diff(phi\1,t)"),
    "dot": _rates("φ\u0307_\\1"),
    "phidot": _rates(r"phidot\1"),
    "matlab": lambda t: re.sub(r"\b(w|phi|r)(\d)", r"\1(\2)", t).replace("*", ".*").replace("\n", ";\n"),
    "maple": lambda t: _lines("eq{k} := {e}:")(re.sub(r"\b(phi|r|w)(\d)", r"\1[\2]", t)),
    "mathcad": lambda t: _named(t, _greek).replace("*", "·").replace("=", "≡"),
    "mathematica": lambda t: _calls(t, lambda m: f"{m[1].title()}[{m[2]}]").replace("=", "==").replace("*", " "),
    "sympy": lambda t: "\n".join(re.sub(r"^(.*) = (.*)$", r"sp.Eq(\1, \2)", line) for line in t.split("\n")),
    "full width": _full_width,
    "word": lambda t: _calls(re.sub(r"(phi|w|r)(\d)", r"\1_(\2)", t), "\\1\u2061〖\\2 〗").replace("phi", "φ").replace("*", "∙"),
    "V_M^y": lambda t: t.replace("VMx", "V_M^x").replace("VMy", "V_M^y"),
    "cyrillic": lambda t: t.replace("phi", "ф").replace("0.5", "0,5"),
    "x": lambda t: t.replace("*", " x "),
    "chain": lambda t: "\n".join(f"V_D = {e}" if e.endswith("= 0") else e for e in t.split("\n")),
    "chain 0": lambda t: "\n".join(re.sub(" = 0$", " = V_C = 0", e) for e in t.split("\n")),
    "unit": _lines("{e}   [м/с]"), "reason": _lines("{e} (D)"), "remark": _lines("{e} // D"), "dash": _lines("- {e}"),
    "d/dt": _rates(r"(d/dt φ\1)"), "partial": _rates(r"∂φ\1/∂t"), "times": lambda t: t.replace("*", " times "),
    "d over dt": lambda t: re.sub(r"\\omega_\{([23])\}", r"\\frac{d}{dt}\\varphi_{\1}", _tex(t)),
    "dot behind the index": _rates("φ\\1\u0307"), "Rust": lambda t: _calls(t, r"f64::\1(\2)"),
    "br": lambda t: t.replace("\n", "<br/>"),
    "prime raised": lambda t: re.sub(r"\\omega_\{([23])\}", r"\\varphi_{\1}^{\\prime}", _tex(t)),
    "VBA": lambda t: re.sub(r"(?m)^(.{9,}?) ([-+] )", r"\1 _\n      \2", t), "slash": lambda t: t.replace(" = 0\n", " = 0 / "),
    "Equality": lambda t: "\n".join("Equality({}, {})".format(*line.split(" = ")) for line in t.split("\n")),
    "num": lambda t: _tex(t).replace("0.5", "\\num{0.5}"), "typst": lambda t: re.sub("VM([xy])", r'V_"M\1"', t).replace("*", " "),
    "a set of Maple": lambda t: "eqs := {" + ", ".join(t.split("\n")) + "}:",
    "a list of SymPy": lambda t: "eqs = [" + ", ".join("Eq({}, {})".format(*line.split(" = ")) for line in t.split("\n")) + "]",
    "arrow": _lines("Eq. ({k}) → {e}"), "twice": _lines("{e} ⇒ {e}"), "one line": lambda t: "; ".join(t.split("\n")),
    "quad": lambda t: " \\quad ".join(t.split("\n")),
    # A comma of \, ends no equation, wherever it stands.
    "glued, with primes": lambda t: _rates(r"φ\1'")(_named(t, _greek).replace("*", "")).replace("=", "＝"),
    "glued, in brackets": lambda t: _calls(_named(t, _subscripts).replace("*", ""), r"\1[\2]"),
    "latex quad": lambda t: " \\quad ".join(map(_tex, t.split("\n"))),
    "latex one line": lambda t: "; ".join(map(_tex, t.split("\n"))),
    "latex chain": lambda t: re.sub(r"(?m)^(.*) = 0$", r"V_D = \1 \\equiv 0,", _tex(t)),
    "latex labels": lambda t: "\n".join(f"f_{k} = {_tex(e)} \\;;" for k, e in enumerate(t.split("\n"), 1)),
    **{form: _lines(form) for form in (
        "({k}) link 3: {e}", "w{k}: {e}", "Equation for x: {e}", "проекция на x: {e}", "X方向：{e}", "由图可得{e}", "M_x) {e}",
        "{L}) {e}", "{k}° {e}", "{K}. {e}", "({K}) {e}", "From the closure {e}", "Звено {k} {e}", "V_Cy = 0: {e}",
        "**{k}.** {e}", "{k}# {e}",
        "▸ {e}", "✅ {e}", "{k}] {e} (C)", "Punkt C: {e} — {k}", "{e} [{k}]", "– {e} % eq",
        "(3.{k}) {e}", "(A.{k}) {e}", "{k} - {e}", "{k}\t{e}", "f{k} = {e}", "| {e}", "{e} ..... ({k})", "{e} \\eqno({k})",
    )},
}  # fmt: skip


def slips(text):
    """The text with one slip in one line, each in turn: a sign, sine for cosine, an angle, a factor."""
    for found in re.finditer(r"(?<= )[-+](?= )|sin|cos|phi[23]|(?<=[ \n])2\*|0\.5\*", text):
        other = {"-": "+", "+": "-", "sin": "cos", "cos": "sin", "phi2": "phi3", "phi3": "phi2"}.get(found[0], "")
        yield text[: found.start()] + other + text[found.end() :]
