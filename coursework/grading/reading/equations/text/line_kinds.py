"""The kind of a line of text: a definition of the student, a datum, an equation without a sign, part of an equation …

Enters: lines, `Names`.  Leaves: the answers to such questions; nothing is marked here.
Used by `lines.py`, `own_names.py`, `text_lines.py` and `continued_lines.py`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from coursework.grading.reading.equations.formulas.equations import (
    OWN_NAME,
    TURNED,
    WORD,
    Names,
    names_in,
    read_as_one,
)
from coursework.grading.reading.equations.formulas.labels import ASIAN, without_labels, without_words
from coursework.grading.reading.equations.formulas.names_in_text import BUILT_IN, Spellings, plain_name
from coursework.grading.reading.equations.formulas.plain_text import in_si, of_minutes, plain
from coursework.grading.reading.equations.formulas.repair import is_name, is_product
from coursework.grading.reading.equations.notation.signs import plain_signs, relates_two_sides
from coursework.grading.reading.files.printed import PAIR
from coursework.grading.reading.limits import EQUATION_CHARACTERS
from coursework.grading.reading.unit_names import unit_of
from coursework.variant.formula.tree import Formula, constant, evaluate_any, terms
from coursework.words.errors import Fault

_QUANTITY = re.compile(r"\s*[-+]?\s*\d[\d.,]*(?:[eE][-+]?\d+)?\s*(?:[^\d\s=*+()]{0,8}(?:[-^]?\d)?|(.{1,12}?))\s*[.,;]?\s*")
_AT_START = re.compile(r"\(\s*(?:t\s*=\s*)?0\s*\)")
_MOST_SIDES, _SAME_VALUE = 4, 1e-9
_SHORT = 80  # most characters of a name with its number
_IS_ZERO = re.compile(r"=\s*0(?:[.,]0*)?\s*[.,;]?\s*$")  # in V_Cy = … = 0, which also defines V_Cy
_POINT = re.compile(r"\s*\w?[A-ZА-Я]\w?\s*[:.)]?\s*")  # a heading, not a sum
_OF_STEP = re.compile(r"[\[({]\s*[ijkn]\s*(?:[-+]\s*1\s*)?[\])}]|,\s*[ijkn]\s*(?:[-+]\s*1\s*)?(?=\})")  # a row, not a datum k
_OF_POINT = r"\s*[vV]_?\{?(?:(?:[A-Z]\d?'?){1,2}|[aeru]|abs|rel|tr|отн|пер|абс)\}?\s*"
_OF_POINTS = re.compile(rf"{_OF_POINT}=(?:{_OF_POINT}[-+])+{_OF_POINT}[.,;]?\s*")
_TIME = re.compile(r"(?<![^\W\d])d?[th](?!\w)")
_SAID = re.compile(r"\W*[^\W\d_]{3,}\s+[^\W\d_]{2,}\s")
_COMPLEX = re.compile(r"\b(?:e\s*\^|exp\b)")
_SPEED, _NATURAL = re.compile(r"[vV]_?[A-Za-z]{1,3}\d?"), re.compile(r"[^\W\d_]{3,}|[\u4e00-\u9fff]{2,}")
_BEFORE_NAME = re.compile(rf"^[{ASIAN}]{{1,20}}\s*(?=[^\W\d])")  # 滑块速度v
_SEVERAL_WORDS, _SENTENCE = 3, 6  # words in a sentence without a velocity, and in one that may name some
_NUMBER_SAID = re.compile(
    r"[\w\s,;:.]*?(?<![\w.])(\w{1,20})\s*=\s*-?\d[\d.,]{0,12}(?:\s[^=*+()]{0,30})?$"
)  # n = 60 rpm, w = 9 1/s all the time
_ATTRIBUTE = re.compile(r"\w\.[^\W\d]")  # phi1.real
_MAY_BE_SPEED = re.compile(r"[vwudqnωΩ]|om|rot|.*(?:\d|dot|punkt|rate|speed|geschw|скор|швидк|оборот|速)", re.IGNORECASE)
_TANGENT = re.compile(r"(?:tan|tg|cot|ctg|sec)\s*[\[({]?\s*\\?[^\W\d]|[sc]_?\d", re.IGNORECASE)
_BEGUN = re.compile(
    r"(?:if|for|do|while|else|import|from|begin)\b(?!\s*\()[^=]*[^=<>!:]=(?!=)"
)  # a word of programs and of sentences
_FEWEST = 4  # an expression has more words than this, so that it is not prose

# Statements of a program that are not equations: it asks, repeats, calls, prints, stops, counts; also the time of a row.
_STATEMENT = re.compile(
    r"(?:In\[\d+\]:=\s*)?(?:\w{1,20}\s*:?=\s*)?[A-Za-z]{0,9}[sS]olve\s*[(\[][\w\s,;\[\]{}\\]*[)\]][^=]*$|(?:if|for|do|while|else|elseif|function|raise|throw|error|exit|import|from|begin)\b[^=]*(?:[=(\[{].*)?$"
    r"|[A-Z]\w{1,40}\s\w{1,20}\s*=\s*\w{1,40}\(.*\);?$"
    # It adds to a variable, makes vectors of numbers and names, unpacks them, defines functions, calls an integrator.
    r"|\w{1,20}\s*[-+*/]=|(?P<same>[^\W\d]\w{0,19})\s*:?=\s*(?P=same)\s*\+"
    r"|\w{1,20}\s*:?=\s*[\w.]{0,12}\(?\[(?:[\w.,;()\s]|-(?=[\d.]))*\]\)?;?$"
    r"|(?:[a-z]{2,5}\s){0,2}[\[(]?(?:[^\W\d]\w{0,19},\s*)+[^\W\d]\w{0,19}[\])]?\s*=\s*[A-Za-z][\w.]{0,40}(?:[(\[].*[)\]])?;?$"
    r"|(?:t|[^\W\d_]{1,5}_?\d{1,2})(?:,\s*[^\W\d]\w{0,19})+\s*=(?!=)[^=]*$"
    r"|(?:double|float|const|static|\s)+\w{1,20}\[\d*\]\s*="
    r"|(?:[a-z]{2,5}\s)?\w{1,20}\s*(?:<-|=)\s*(?:function\s*\(|\([\w\s,]*\)\s*=>|\[&\])|\w{1,20}\s*<-\s*c\("
    r"|\w{1,20}\s*(?:<-|=)\s*(?:\w{1,9}\.)?(?:zeros|ones|empty|linspace|arange|ode\w*|solve_ivp|lsode|ODEProblem|\w*symbols)\s*\("
    r"|(?:\w{1,20}(?:\([\w\s,]*\))?\s*:?=\s*)?[fF]ind\s*\([\w\s,]*\)\s*(?::?=|→)?$"
    r"|(?:(?:const|let|var)\s+)?\{[\w\s,]*\}\s*=\s*\w{1,20};?$|\w{1,20}\s*=\s*\(.*\)\s*=>\s*\{$|\w{1,20}\s*=\s*sym\w*\(.*\);?$"
    r"|t(?:\[\w\]|\(\w\))?\s*:?=\s*\(?(?:[ikn]|row)(?:\s*-\s*1\s*\))?\s*\*\s*(?:h|dt|\d[\d.]*);?$"
    r"|\w{1,20}\s*:?=\s*[\[({]$|(?:console|sys|plt|DefaultFormatSettings)\..*$|n\s*=\s*\d+;?$"
)


def definition(text: str, names: Names) -> tuple[str, Formula] | None:
    """Return the name and the formula of a line that defines a name of the student, None for any other line."""
    name, formula = own_name(text, names.spellings)
    formula = _IS_ZERO.sub("", formula)
    if not name or not formula.strip() or is_vector_sum(text, names):
        return None
    read = [read_as_one(f"0 = {in_si(side)}", names) for side in formula.split("=", _MOST_SIDES)]
    trees = [one.tree.args[1] for one in read if not isinstance(one, Fault)]
    said = [tree for tree in trees if constant(tree) in {None, 0}] or trees  # D = R + r = 0.12 m says what D is, and its value
    is_same = len(trees) == len(read) and all(are_equal(said[0], tree) for tree in said[1:])
    return (plain_name(name), said[0]) if is_same else None


def are_equal(one: Formula, other: Formula) -> bool:
    """Return whether two formulas have the same value with some number for each name: D = a*b - c*d = … in two steps."""
    values = {name: 0.7 + 0.13 * place for place, name in enumerate(sorted({*one.names(), *other.names()}))}
    try:
        found = [evaluate_any(tree, values | {"pi": math.pi}) for tree in (one, other)]
    except (ArithmeticError, ValueError, KeyError):
        return False
    return abs(found[0] - found[1]) <= _SAME_VALUE * max(map(abs, found))


def no_velocity(text: str, names: Names) -> bool:
    """Return whether a line names positions and lengths alone: nothing in it has the time in its unit."""
    variant = names.expected.variant
    still = {one.name for one in variant.coordinates} | {one.name for one in variant.given if one.si in {"m", "rad", ""}}
    named = names_in(text, names.spellings)
    return bool(named) and named <= still


def own_name(text: str, spellings: Spellings) -> tuple[str, str]:
    """Return the word left of "=" if it may be a name of the student, and the formula on the right; ("", "") if it may not."""
    if len(text) > EQUATION_CHARACTERS:
        return "", ""
    plainly = plain_signs(text.replace("$", " "))
    bare = without_words(without_labels(plainly), lambda word: is_name(word, spellings))
    name, sign, formula = bare.partition("=")
    name = _BEFORE_NAME.sub("", re.sub(r"[{}\\]", "", name.strip(" :&\t")).rpartition(":")[2].strip())
    meant = spellings.canonical(name)
    # A letter that differs from a datum or coordinate only in being a capital is the student's name, as nobody solves for those.
    # But S = 0.4 or S = S0 is where a coordinate s starts, and S = 0.4 + u*h its next value.
    is_own = meant is None or (meant in {*spellings.data, *spellings.rates} and plain_name(name) != plain_name(meant))
    if meant in spellings.rates and is_own:
        named = names_in(formula, spellings)
        is_own = bool(TURNED.search(formula) or named & {*spellings.rates}) and named.isdisjoint(spellings.rates.values())
        # f1 = -r*w1*s1 is a right side of a system: nothing in it is an angle or the time that an angle grows with.
        is_own = is_own or (bool(named & spellings.data) and named.isdisjoint(spellings.angles) and not _TIME.search(formula))
    if meant and plain_name(name) != plain_name(meant) and not is_own and not re.search(r"\d", name):
        # A law of time alone, v = V1*sin(p*t), is that of the drive, though the task has only one speed v may be short for.
        words = {spellings.canonical(word) for word in WORD.findall(plain(formula, spellings))} - {None}
        is_own = "t" in words and words <= {*spellings.data, *BUILT_IN}
    is_own = is_own and not _is_rate(name, formula, spellings)
    is_own = is_own and OWN_NAME.fullmatch(name) is not None and not (meant is None and is_product(name, spellings))
    return (name, formula) if sign and is_own else ("", "")


def _is_rate(name: str, formula: str, spellings: Spellings) -> bool:
    """Return whether a name is the derivative of a coordinate, dphi2 or phi2p, and not the student's for a difference or a sine.

    Of s, a coordinate of one letter, st and sp may be sines as well: there a velocity must stand in the formula.
    """
    rates = {*spellings.rates.values()}
    found = plain(name, spellings.with_own({})).strip()
    if found == name or found not in rates or spellings.canonical(name):
        return False
    named = names_in(formula, spellings)
    is_short = any(len(coordinate) == 1 and rate == found for coordinate, rate in spellings.rates.items())
    return bool(named & rates) if is_short else not named or not named <= {*spellings.angles, *spellings.rates}


def is_equation_without_sign(text: str, names: Names) -> bool:
    """Return whether a line without "=" is the left side of an equation (readable or not) rather than prose."""
    if len(text) > EQUATION_CHARACTERS or not any(sign in text for sign in "+-−*·⋅×") or relates_two_sides(text):
        return False
    if text.rstrip().endswith(":") and _SAID.match(text):
        return False  # "divided by r*w1:"
    if not names_in(text, names.spellings):
        return False
    return not isinstance(read_as_one(text, names), Fault) or _is_mostly_names(text, names)


def only_names_a_term(text: str, tree: Formula, names: Names) -> bool:
    """Return whether a line without "=" may be no equation but name a term: "we divide by r1*w1", "r1*w1"."""
    if relates_two_sides(text):
        return False
    strange = [word for word in WORD.findall(plain_signs(text)) if not names.is_name(word)]
    return len(strange) > 1 or sum(constant(term) != 0 for term in terms(tree)) == 1


def is_part_of_equation(text: str, names: Names) -> bool:
    """Return whether a line without "=" is a sum or a term that the next line may continue."""
    if is_equation_without_sign(text, names):
        return True
    is_heading = _POINT.fullmatch(text) and text.strip() not in names.spellings.known
    if len(text) > _SHORT or relates_two_sides(text) or is_heading:
        return False
    return bool(names_in(text, names.spellings)) and not isinstance(read_as_one(text, names), Fault)


def _is_mostly_names(text: str, names: Names) -> bool:
    """Return whether a line consists of names of the variant, numbers and signs, except for at most one word."""
    words = WORD.findall(plain(text, names.spellings))
    strange = [word for word in words if not names.is_name(word)]
    return len(strange) <= 1 and bool(names_in(text, names.spellings) & {*names.expected.variant.sought}) and len(words) > _FEWEST


def is_step(text: str, names: Names) -> bool:
    """Return whether a line is a step of the scheme, "phi3[k+1] = phi3[k] + h*w3[k]", and so not a velocity equation."""
    left, _, right = _OF_STEP.sub("", text[:EQUATION_CHARACTERS]).partition("=")
    moved = names_in(left, names.spellings)
    begun = moved if left.rstrip().endswith("+") else set[str]()  # phi3 += h*w3
    used = names_in(right, names.spellings) | begun
    used -= {"h"}  # the step; h may also be a length of the task
    return any(moved == {one.name} and used == {one.name, one.rate} for one in names.expected.variant.coordinates)


def is_statement(text: str, sought: Sequence[str] = ()) -> bool:
    """Return whether a line is a statement of a program around the equations and not an equation itself.

    A call that gives velocities that are `sought` from sines and cosines has an equation in it.

    >>> is_statement("y = y + h*rhs(t, y)"), is_statement("phi1, phi2 = y"), is_statement("w1, w2 = 0"), is_statement("w1 = 2*w2")
    (True, True, True, False)
    """
    if _STATEMENT.match(text) is None:
        return False
    left, _, right = text.partition("=")
    is_said = any(sign in text for sign in "*/·") and {*re.findall(r"\w+", text)} & {*sought}
    if _BEGUN.match(text) and (is_said or TURNED.search(text)):
        return False  # "for C: r1*w1*sin(phi1) = …"
    return not ("," in left and {*re.findall(r"\w+", left)} & {*sought} and TURNED.search(right))


def is_row(text: str) -> bool:
    """Return whether a line is a table row that a program prints with names: "t = 0.02 w1 = 2.5 w2 = -1.3".

    >>> is_row("t=0.02 w1=2.5; w2=-1.3"), is_row("w1 = 2.5*w2, w3 = 1")
    (True, False)
    """
    rest, count = PAIR.subn("", text)
    return count > 1 and not any(map(str.isalnum, rest))


def is_vector_sum(text: str, names: Names) -> bool:
    """Return whether a line adds velocities of points as vectors, V_C = V_B + V_CB; without axes it is no equation of numbers."""
    found = _OF_POINTS.fullmatch(plain_signs(text).rpartition(":")[2])
    return found is not None and any(names.spellings.canonical(word) is None for word in WORD.findall(found[0]))


def says_nothing(text: str, names: Names) -> bool:
    """Return whether a line that cannot be read has no velocity equation in it.

    Without a sine, it names the velocity of a point that the task does not ask for (v_B = v_A + v_BA, V_e = w*r: what is right in
    that stands in the projections), or no velocity sought among words; or it says where a point is, … = x_F.
    """
    if len(text) > EQUATION_CHARACTERS:
        return False
    plainly = plain(text, names.spellings)
    strange = [word for word in WORD.findall(plainly) if not names.is_name(word)]
    named = names_in(text, names.spellings)
    number = None if names.expected.answers else _NUMBER_SAID.match(plainly)  # where answers are asked it may be one, misspelt
    is_free = named.isdisjoint(names.expected.variant.sought) and not TURNED.search(plainly)  # V_C = 2 r w sinn φ is an equation
    if number and is_free:
        return True
    # "On a x = r cos φ": of places alone, in words none of which may be a velocity of the student
    is_said = any(len(word) > 1 for word in strange) and all(map(str.isalpha, strange)) and not _ATTRIBUTE.search(text)
    if is_said and not any(map(_MAY_BE_SPEED.match, strange)) and "[" not in text and no_velocity(text, names):
        return True
    if not any(sign.search(plainly) for sign in (TURNED, _TANGENT, _COMPLEX)):
        sought = named & {*names.expected.variant.sought}
        words = len([*filter(_NATURAL.fullmatch, strange)])
        is_sentence = words >= _SENTENCE and "=" not in plainly if sought else words >= _SEVERAL_WORDS
        # v_P = v_A + v_PA = … = 0 relates velocities: what could not be read of it may be right
        is_related = sought and len(named & {*names.spellings.rates.values(), *names.expected.variant.velocities}) > 1
        return (any(map(_SPEED.fullmatch, strange)) and not is_related) or is_sentence
    left, _, right = plainly.partition("=")
    return no_velocity(left, names) and strange == [right.strip(" .,;")]


def is_law(text: str, names: Names) -> bool:
    """Return whether a line gives the speed of a point as a law of time and data, V_M = V1*sin(p*t), as the task does."""
    law = definition(text, names)
    told = {*law[1].names()} if law and law[0][0] in "vV" else set[str]()
    return "t" in told and told <= {*names.spellings.data, *BUILT_IN}


def is_question(text: str, names: Names) -> bool:
    """Return whether a line asks the teacher something, "why is w3 = 0 at the dead point?", with one name and a number in it."""
    if not text.rstrip().endswith(("?", "？")) or TURNED.search(text) or len(text) > EQUATION_CHARACTERS:
        return False
    strange = [word for word in WORD.findall(text) if not names.is_name(word)]
    return len(strange) >= _SEVERAL_WORDS and len(names_in(text, names.spellings)) <= 1


def is_datum(text: str, names: Names) -> bool:
    """Return whether a line only gives the number of a datum or a start value: "r1 = 0.953 m", "w1(0) = 2"."""
    if len(text) > _SHORT:
        return False
    bare = without_words(
        without_labels(_AT_START.sub("@", of_minutes(plain_signs(text)))), lambda word: is_name(word, names.spellings)
    )
    name, sign, value = bare.partition("=")
    name, begins, _ = re.sub(r"[{}\\$\s]", "", name).partition("@")
    meant = names.spellings.canonical(name)
    # A name that the task does not have, such as h, is a datum of the student; if answers are asked, it may be a misspelt answer.
    is_given = bool(begins) or (meant not in names.expected.variant.sought if meant else not names.expected.answers)
    quantity = _QUANTITY.fullmatch(value) if sign and is_given and OWN_NAME.fullmatch(name) else None
    return quantity is not None and (not quantity[1] or bool(unit_of(quantity[1])))
