"""One line as typed -> the line without the notation of LaTeX, programs and people around and inside its equation.

Enters: one line as typed.  Leaves: the line without LaTeX, prefixes and indices of programs and one-character fractions, with
derivatives as names of the variant.  Used by `equations.py`.
"""

from __future__ import annotations

import re
from functools import lru_cache

from coursework.grading.reading.equations.formulas.derived_sums import derived, with_sums_derived, with_the_rest_unread
from coursework.grading.reading.equations.formulas.names_in_text import BUILT_IN, Spellings, plain_name
from coursework.grading.reading.equations.notation.degrees import with_factors
from coursework.grading.reading.equations.notation.latex import without_latex
from coursework.grading.reading.equations.notation.quotients import with_fractions, with_secants
from coursework.grading.reading.equations.notation.signs import plain_signs
from coursework.grading.reading.table.headers import FACTORS
from coursework.grading.reading.unit_names import unit_of
from coursework.variant.formula.tree import constant, named
from coursework.variant.record.variant import Variant

_PREFIX = re.compile(r"\b(?:\w{1,9}::(?=[A-Za-z])|(?:j?np|numpy|c?math|Math|sp|sympy|tf)\.(?=[A-Za-z]))|\((?:double|float)\)")
# A point between names multiplies (as in France) if the line has no other product sign; else a field follows it, par.r1.
_POINT = re.compile(r"((?<![^\W\d])[^\W\d]\w{0,40}|[\d)])\.(?=([^\W\d]\w{0,40}|\())")
_BY_POINT = re.compile(r"(?<![\w.])([^\W\d]{1,7})\.(\w{1,4})(?![\w.]|\((?!\s*t\s*\)))")  # an index in Mathcad: ω.3, V.My
_BEHIND_PRIME = re.compile(r"(?<=\w')\.(?=[^\W\d]|\()")  # in France: θ'.sin θ
_KEYED = re.compile(r"[^\W\d]\w{0,20}\[\s*['\"](\w{1,20})['\"]\s*\]")  # d["r1"] of Python
_FRACTIONS = {"½": "(1/2)", "¼": "(1/4)", "¾": "(3/4)", "⅓": "(1/3)", "⅔": "(2/3)"}
_OF_POINT = re.compile(r"([xy])_?\{?([A-Z])\}?")
_NAME = r"([^\W\d](?:\w|\{\w{0,9}\}){0,40})"
_PRIME = r"\s*['′’](?:\s*[\[(]\s*t\s*[\])])?"
_DERIVATIVES = (
    re.compile(rf"\(\(\s*[dΔ∆]\s*{_NAME}\s*\)\s*/\s*\(\s*[dΔ∆]\s*t\s*\)\)"),  # as \frac leaves it
    re.compile(rf"\bd\s*\(\s*{_NAME}\s*\)\s*/\s*d\s*t\b"),
    re.compile(rf"(?:\bd\s*/\s*d\s*t\b|\(\(\s*d\s*\)\s*/\s*\(\s*d\s*t\s*\)\))\s*\(\s*{_NAME}\s*\)"),
    re.compile(rf"(?:\bd\s*/\s*d\s*t\b|\(\(\s*d\s*\)\s*/\s*\(\s*d\s*t\s*\)\))\s*{_NAME}"),
    re.compile(rf"(?:\bd[\s_]*|[Δ∆]\s*){_NAME}\s*/\s*[dΔ∆]\s*t\b"),
    re.compile(rf"{_NAME}{_PRIME}"),
    re.compile(r"([^\W\d]\u0307(?:\w|\{\w{0,9}\}){0,40})"),
    re.compile(r"\b([^\W\d]\w{0,40}?_?dot(?:_?\d{1,3})?)\b"),
    re.compile(rf"\bdot[\s_]*\(?\s*{_NAME}\s*\)?"),
    re.compile(rf"'?\b(?:diff|D|Diff|der|Derivative)\s*\(\s*{_NAME}\s*(?:\(\s*t\s*\))?\s*(?:,\s*t\s*)?\)(?:\s*\(\s*t\s*\))?"),
    re.compile(rf"{_NAME}\.diff\(\s*t\s*\)"),
    re.compile(rf"\bd_?{_NAME}_?dt\b"),
    re.compile(rf"\bD_?{_NAME}"),
)
_GLUED = re.compile(r"(|.*[\w}])((?:[φϕθ]|phi|theta)\u0307?_?\d{1,2}|[^\W\d]\u0307_?\d{0,2})(|sin|cos|tg|tan)")
_DIFFERENTIAL = re.compile(r"\bd_?([^\W\d]\w{0,40})\b")
_DT = re.compile(r"(?<=[\w)\]}])\s*\*?\s*\bdt\b(?!\s*=)|(?<![/\w])(?<!/ )dt\b\s*(?:\*|(?=[\w(]))\s*()|\bdt\b(?=\s*=)")
# As programs name derivatives, unless it is a name of the variant: dphi3, phi3p, thd3, phi3_t.
_SHORT_DERIVATIVES = (
    _DIFFERENTIAL, re.compile(r"\b([^\W\d]\w{0,40}?)_?[dpt]\b"),
    re.compile(r"\b([^\W\d]{1,9}(?=_?[dp]_?\d{1,3}\b))_?[dp]_?(\d{1,3})\b"),
)  # fmt: skip
_AT_TIME = re.compile(r"\b(?:sin|cos|tan|tg)\s*[({]?\s*[^\W\d]\w{0,40}?\d?_t\b")  # sin(phi3_t): all names are those at a time
_T_BEHIND = re.compile(r"(?<=\w)_t\b")
_DOTTED = re.compile(r"\bdot\s*\(\s*([^\W\d]+)\s*\)_?(\d{1,3})")
_STAR_MATH = re.compile(r"%(?=[a-z]{3,8}(?:_|\b))|\b(?:left|right)\s*(?=[()\[\]])")
_TYPST = re.compile(r"(?<=[\w)])\s+dot\s+(?=(\w+)|\()|(?<=\bphi)\.alt(?![a-z])")
_TYPST_SPACE = re.compile(r"(?<=[\w)])\s+(?:thin|med|thick|wide)\s+(?=[\w(])")
# A double of Fortran, 2.D0 or 2d0, the kind behind its numbers, 2.0_dp, and its functions such as DSIN; a datum d multiplies.
_DOUBLE = re.compile(r"(?<![\w.])(\d++\.?+\d*+|\.\d++)[dD](?=([-+]?\d{1,2})(?!\w))")
_OF_KIND = re.compile(r"(?<![\w.])(\d++\.?+\d*+|\.\d++)_(?:[dwsq]p|r?k?(?:4|8|16)|rk|real(?:32|64)|double)\b", re.IGNORECASE)
_OF_DOUBLES = re.compile(r"\b(?:D(?=(?:SIN|COS|TAN|SQRT)\b)|d(?=(?:sin|cos|tan|sqrt)\b))")
_SUBSCRIPT = re.compile(r"\bSubscript\s*\[\s*(\w{1,20})\s*,\s*(\w{1,9})\s*\]")  # an index in Mathematica
_INDEXED = re.compile(r"(?<![\w.])([^\W\d]\w*)\s?(?:\[\s*([\w\s,]{1,12})\s*\]|\(\s*(\d{1,2})\s*\))")
_OF_TIME = re.compile(r"(?<![\w.])([^\W\d]\w*)\s*(?:\(\s*(?:t|\w+\s*,[\w\s,]{1,60})\s*\)|\[\s*t\s*\])")
_OF_ROW = re.compile(r"(?<![\w.])([^\W\d]\w*(?:\[\s*\d{1,2}\s*\])?)(?:\s?\[\s*[ijkn]\s*\]|\(i\))")
_ARC = re.compile(r"(?<!\w)[a𝑎](sin|cos|tan)")
_LAMBDA = re.compile(r"(^\s*|=\s*)lambda\b[\w\s,]{0,60}:(?!.*=)|(=\s*)@\s*\([\w\s,]{0,60}\)")  # in Python, in MATLAB
_METHOD = re.compile(r"(\b\w{1,20}|\([^()]*\))\.(sin|cos|sqrt)\(\)")  # phi3.sin() in Rust
_BEHIND_GREEK = re.compile(r"(?<=[α-ωϕ])(?=(?:sin|cos|sen|tan|tg)(?![a-z]))|(?<=[A-Za-z])(?=[α-ωϕ]_?\d{0,2}')")  # l·ω_ψsinψ, lψ'
_BROADCAST = re.compile(r"\b(sin|cos|tan|sqrt)\.(?=\()")  # sin.(phi3) in Julia
_BARS = re.compile(r"\|\s*([^\W\d]\w{0,5})\s*\|")  # the length of a vector, |r3|
_DEGREE = r"(?:°|º|\^\s*\{?\s*\\?circ\b\s*\}?)"
_DEGREES = re.compile(rf"((?:[-+*/(]|\b(?:sin|cos)(?=[\s\d]))\s*)(\d{{1,3}}(?:[.,]\d{{1,9}})?)\s*{_DEGREE}")
_MINUTES = re.compile(rf"(\d{{1,3}})\s*{_DEGREE}\s*(\d{{1,2}})\s*'(?!')(?:\s*(\d{{1,2}}(?:[.,]\d+)?)\s*(?:''|\"|″|$))?")
_MEASURED = re.compile(
    r"\s*([-+−]?\s*\d[\d.,]*(?:[eE][-+]?\d+)?)\s*[\[(]?\s*([^\W\d]\w*|[^\W\d]\w*/\w+|1/\w+|°)\s*[\])]?\s*[.,;]?\s*"
)
_UNIT = r"(?:[^\W\d_]{1,4}|1)(?:\s?/\s?[^\W\d_]{1,3})?(?:\^?-1)?"
_OF_A_NUMBER = re.compile(rf"(?<![\w.,])\d+(?:[.,]\d+)?(?:\s*[·⋅*]?\s*{_UNIT}(?![\w(\[.])|\s*[\[(]\s*{_UNIT}\s*[\])])")
_OF_A_NAME = re.compile(rf"(?<=[\w)])\s*\[\s*({_UNIT})\s*\]")
_ROOT = re.compile(r"√\s*(\d+(?:[.,]\d+)?|[^\W\d]\w*)")
_OVER = re.compile(r"(?<=[})])\s+over\s+(?=[{(\w])")  # in StarMath; TeX's \over divides the whole group
_EQUATION = re.compile(r"\bEq(?:uality)?\s*\((.*),([^,]*)\)\s*$")  # an equation in SymPy
_POWER = re.compile(r"\bpow\s*\(((?:[^(),]|\([^()]*\))*),\s*(\d)\s*\)")


@lru_cache(1024)  # several readers look at the same line in turn
def plain(text: str, spellings: Spellings) -> str:
    """Return a line without LaTeX and prefixes of programs, with derivatives replaced by the names of rates.

    >>> plain("w(3) := diff(phi[3](t), t)", Spellings(frozenset({"w3", "phi3"}), {}, {"phi3": "w3"})).split()
    ['w3', '=', 'w3']
    """
    text = plain_signs(_PREFIX.sub("", without_latex(_OVER.sub(" / ", plain_signs(text)))))
    text = text if text.isascii() else _BEHIND_GREEK.sub(" ", text)
    if "|" in text:
        text = _BARS.sub(lambda found: found[1] if spellings.canonical(found[1]) in spellings.data else found[0], text)
    text = _BROADCAST.sub(r"\1", text) if ".(" in text else text
    text = _METHOD.sub(r"\2(\1)", text)
    text = with_factors(_DEGREES.sub(r"\1(\2*pi/180)", of_minutes(text)))
    text = _LAMBDA.sub(r"\1\2 ", _ROOT.sub(r"sqrt(\1)", text).replace("√", "sqrt"))
    text = with_secants(text, lambda word: spellings.angle(word) is not None)
    text = _OF_ROW.sub(lambda found: _of_row(found, spellings), text)
    for sign, fraction in _FRACTIONS.items():
        text = text.replace(sign, fraction)
    text = _STAR_MATH.sub("", re.sub(r"\b(?:cdot|times)\b", "*", text))
    text = with_fractions(_TYPST_SPACE.sub(" ", text))
    text = _TYPST.sub(lambda found: _dot_or_product(found, spellings), text)
    text = _BEHIND_PRIME.sub(" ", _KEYED.sub(r"\1", text))
    is_field = "*" in text
    text = _BY_POINT.sub(lambda found: _with_index(found, spellings, is_field), text)
    text = _POINT.sub(lambda found: _pointed(found, spellings, is_field), text)
    text = _OF_KIND.sub(r"\1", _DOUBLE.sub(lambda found: _double(found, spellings), text))
    text = _OF_DOUBLES.sub(lambda found: found[0] if found[0] in spellings.data else "", text)
    text = _DOTTED.sub(r"dot(\1\2)", _SUBSCRIPT.sub(r"\1\2", text))
    text = _OF_TIME.sub(lambda found: _of_time(found, spellings), _INDEXED.sub(lambda found: _indexed(found, spellings), text))
    text = with_sums_derived(_EQUATION.sub(r"\1 = \2", _POWER.sub(r"(\1)^\2", text)), spellings)
    for pattern in _DERIVATIVES:
        text = pattern.sub(lambda found: _rate(found, spellings), text)
    text = with_the_rest_unread(text)
    text = _with_differentials(text, spellings) if "dt" in text else text
    text = _OF_TIME.sub(lambda found: _of_time(found, spellings), text) if "(t" in text else text  # of a rate, phi3dot(t)
    text = _T_BEHIND.sub("", text) if _AT_TIME.search(text) else text
    for pattern in _SHORT_DERIVATIVES:
        text = pattern.sub(
            lambda found: found[0] if spellings.canonical(found[0]) or spellings.is_own(found[0]) else _rate(found, spellings),
            text,
        )
    return text


def _with_differentials(text: str, spellings: Spellings) -> str:
    """Return an equation of differentials, dphi2 = … dt, divided by dt: without it, as the others are read as rates."""
    is_other = any(spellings.canonical(found[0]) is None and spellings.angle(found[1]) for found in _DIFFERENTIAL.finditer(text))
    return _DT.sub(lambda found: found[1] or "", text) if is_other and "dt" not in spellings.known else text


def _pointed(found: re.Match[str], spellings: Spellings, is_field: bool) -> str:
    """Return the name before a point with a product sign, or "" if a field follows; leave other points ("i.e. r1") unchanged."""
    before, behind = found[1], found[2]
    if (
        behind != "("
        and not behind.lower().startswith(("sin", "sen", "cos", "tan", "sqrt"))
        and spellings.canonical(behind) is None
        and not spellings.is_own(behind)
    ):
        return found[0]
    if is_field or (len(before) > 1 and before.isalpha() and spellings.canonical(before) is None):
        return "" if len(before) > 1 or before.isalpha() else found[0]
    return f"{before}*" if before == ")" or before.isdigit() or spellings.canonical(before) else found[0]


def _dot_or_product(found: re.Match[str], spellings: Spellings) -> str:
    """Return the product that `dot` is in Typst, unless a coordinate follows: in AsciiMath that is its derivative."""
    if found[0].strip() != "dot":
        return ""
    return found[0] if found[1] and spellings.angle(found[1]) in spellings.rates else " * "


def _with_index(found: re.Match[str], spellings: Spellings, is_field: bool) -> str:
    """Return a name with its index joined, unless what stands behind the point is a name of its own and the point multiplies."""
    is_index = (
        found[2].isdigit() or (is_field and spellings.canonical(found[1] + found[2])) or spellings.canonical(found[2]) is None
    )
    return found[1] + found[2] if is_index and spellings.angle(found[1] + found[2]) else found[0]


def _number_in_si(found: re.Match[str]) -> str:
    quantity = re.sub("[·⋅*]", " ", found[0])
    number = in_si(quantity)
    return found[0] if number == quantity else f"({number})" if "*" in number else number


def of_minutes(text: str) -> str:
    """Return a line whose angles in degrees, minutes and seconds are degrees with decimals.

    >>> of_minutes("cos(12°30') + sin(0°0'36'')")
    'cos(12.500000000°) + sin(0.010000000°)'
    """
    return _MINUTES.sub(_with_minutes, text)


def _with_minutes(found: re.Match[str]) -> str:
    seconds = float((found[3] or "0").replace(",", "."))
    return f"{int(found[1]) + int(found[2]) / 60 + seconds / 3600:.9f}°"


def _double(found: re.Match[str], spellings: Spellings) -> str:
    """Return the digits of a double with e for d; leave 0.5d1 unchanged if the task has a d1, as it is a product."""
    return found[0] if spellings.canonical(f"d{found[2]}") else f"{found[1]}e"


def in_si(quantity: str) -> str:
    """Return a number with a unit as a number in SI, and any other text as it is.

    >>> in_si(" 700 мм"), in_si("0,7 [m]"), in_si("2*r1")
    ('(700)*0.001', '0,7', '2*r1')
    """
    found = _MEASURED.fullmatch(quantity)
    factor = FACTORS.get(unit_of(found[2])) if found else None
    if found is None or factor is None:
        return quantity
    return found[1] if factor == 1 else f"({found[1]})*{factor:.12g}"


def of_units(text: str) -> str:
    """Return a line whose quantities are numbers in SI, and without the units in brackets behind its names.

    >>> of_units("457 mm*w3 - 0,8 [м]·ω2 + r1 [m]*w1 = 0")
    '((457)*0.001)*w3 - 0,8·ω2 + r1*w1 = 0'
    """
    bare = _OF_A_NAME.sub(lambda found: "" if unit_of(found[1]) else found[0], text)
    return _OF_A_NUMBER.sub(_number_in_si, bare)


def of_products(text: str, spellings: Spellings) -> str:
    """Return a line with a*sin(phi) for asin(phi), if there is a datum a: products are often written without a sign."""
    return _ARC.sub(r"a*\1", text) if "a" in spellings.data else text


def of_one_component(text: str, variant: Variant) -> str:
    """Return a line with V_My for the drawing's V_M, if point M is driven along one axis only."""
    moving = [law.name for law in variant.drive if law.formula is None or constant(law.formula) != 0]
    stems = [name[:-1] for name in moving if name[-1:] in {"x", "y"} and name.startswith("V")]
    for stem, name in zip(stems, moving, strict=True) if len(stems) == len(moving) and len({*stems}) == len(stems) else ():
        text = re.sub(rf"(?<!\w)[Vv]_?\{{?{re.escape(stem[1:])}\}}?(?![\w^{{]|_\w)", name, text)
    return text


def _indexed(found: re.Match[str], spellings: Spellings) -> str:
    """Return the name w3 for `w[3]` or `w(3)` if the variant has it; if it has a name w, `w(3)` stays as a product."""
    name, index = found[1], re.sub(r"[\s,]", "", found[2] or found[3])
    meant = spellings.angle(name + index)
    if meant is None or (found[3] and name in spellings.known):
        return found[0]
    return meant if name.lower() in {"ph", "th"} else name + index  # spelled so for no name of a task


def _of_row(found: re.Match[str], spellings: Spellings) -> str:
    """Return the name alone for its value in the current row, `w3[i]`; values in other rows, `[i + 1]`, stay as they are."""
    meant = spellings.angle(re.sub(r"[\[\]\s]", "", found[1]))
    return found[0] if meant in (None, "pi") else found[1]


def _of_time(found: re.Match[str], spellings: Spellings) -> str:
    """Return the coordinate for `phi3(t)`; a datum before (t) stays as a product."""
    meant = spellings.angle(found[1])
    return found[0] if meant is None or meant in {*spellings.data, *BUILT_IN} else found[1]


def _rate(found: re.Match[str], spellings: Spellings) -> str:
    """Return the name of a coordinate's rate for a derivative; leave it unchanged if it is not of a coordinate."""
    name = spellings.angle(re.sub("[{}\u0307]|_?dot", "", "".join(found.groups())))
    called = re.sub("[\u0307']", "", found[1])
    own = spellings.own.get(plain_name(called)) if spellings.is_own(called) else None
    is_angle = own is not None and own.op == "name" and own.name in spellings.rates  # θ1, where the text says that it is φ1
    if is_angle or (spellings.is_own(called) and ("/" in found[0] or ".diff" in found[0])):
        return derived(own, spellings)
    if name in spellings.rates:
        return f" {spellings.rates[name]} "
    if (point := _OF_POINT.fullmatch(found[1])) and (rate := spellings.rates.get("".join(point.groups()).lower())):
        return f" {rate} "  # x_E', where x_E = … stands before
    if "/" in found[0] and name and name not in spellings.data:
        return derived(named(name), spellings)
    glued = _GLUED.fullmatch(found[1]) if len(found.groups()) == 1 else None  # r2φ2' and, before a function, φ̇2sin
    name = spellings.angle(re.sub("\u0307", "", glued[2])) if glued else None
    return f"{glued[1]} {spellings.rates[name]} {glued[3]}" if glued and name in spellings.rates else found[0]
