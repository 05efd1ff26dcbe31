"""What a line of text is: a definition of the student's own, a datum, an equation without its sign, a part of one.

Enters: lines, `Names`.  Leaves: answers to those questions; nothing is marked here.  Used by `lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import pairwise

from coursework.grading.reading.equations.equations import (
    DASH,
    OWN_NAME,
    TURNED,
    WORD,
    Names,
    names_in,
    read_as_one,
)
from coursework.grading.reading.equations.labels import without_labels, without_words
from coursework.grading.reading.equations.meanings import key
from coursework.grading.reading.equations.names_in_text import Spellings
from coursework.grading.reading.equations.plain_text import plain
from coursework.grading.reading.equations.repair import is_name
from coursework.grading.reading.equations.signs import plain_signs, relates_two_sides
from coursework.grading.reading.files.printed import PAIR
from coursework.grading.reading.unit_names import unit_of
from coursework.variant.formula import reader
from coursework.variant.formula.tree import Formula
from coursework.words.errors import Fault

_QUANTITY = re.compile(r"\s*[-+]?\s*\d[\d.,]*(?:[eE][-+]?\d+)?\s*(?:[^\d\s=*+()]{0,8}(?:[-^]?\d)?|(.{1,12}?))\s*[.,;]?\s*")
_AT_START = re.compile(r"\(\s*(?:t\s*=\s*)?0\s*\)")
_SHORT = 80  # characters of a name and its number
_IS_ZERO = re.compile(r"=\s*0(?:[.,]0*)?\s*[.,;]?\s*$")  # of V_Cy = … = 0, which says what V_Cy is, too
_POINT = re.compile(r"\s*\w?[A-ZА-Я]\w?\s*[:.)]?\s*")  # a heading, not a sum
_COUNT = re.compile(r"^\s*([A-Z]{0,2}\.?)(\d{1,2}(?:\.\d{1,2})*)\s+(?=[\w(\\+−-])")  # of a line in a list: 1.1, L2
_OF_STEP = re.compile(r"[\[({]\s*[ijkn]\s*(?:[-+]\s*1\s*)?[\])}]|,\s*[ijkn]\s*(?:[-+]\s*1\s*)?(?=\})")  # the row, no datum k
_FEWEST = 4  # words of an expression that is no prose

# What a program does with equations: it asks, repeats, calls, prints, stops, counts; and the time of a row.
_STATEMENT = re.compile(
    r"(?:In\[\d+\]:=\s*)?(?:\w{1,20}\s*:?=\s*)?[A-Za-z]{0,9}[sS]olve\s*[(\[][\w\s,;\[\]{}\\]*[)\]][^=]*$|(?:if|for|while|else|elseif|function|raise|throw|error|exit|import|from|begin)\b[^=]*(?:[=(\[{].*)?$"
    r"|[A-Z]\w{1,40}\s\w{1,20}\s*=\s*\w{1,40}\(.*\);?$"
    # It adds to what was, makes vectors of numbers and of names, takes them apart, defines functions, calls what integrates.
    r"|\w{1,20}\s*[-+*/]=|(?P<same>[^\W\d]\w{0,19})\s*:?=\s*(?P=same)\s*\+"
    r"|\w{1,20}\s*:?=\s*[\w.]{0,12}\(?\[(?:[\w.,;()\s]|-(?=[\d.]))*\]\)?;?$"
    r"|(?:[a-z]{2,5}\s){0,2}[\[(]?(?:[^\W\d]\w{0,19},\s*)+[^\W\d]\w{0,19}[\])]?\s*=\s*[A-Za-z][\w.]{0,40}(?:[(\[].*[)\]])?;?$"
    r"|(?:t|[^\W\d_]{1,5}_?\d{1,2})(?:,\s*[^\W\d]\w{0,19})+\s*=(?!=)[^=]*$"
    r"|(?:double|float|const|static|\s)+\w{1,20}\[\d*\]\s*="
    r"|(?:[a-z]{2,5}\s)?\w{1,20}\s*(?:<-|=)\s*(?:function\s*\(|\([\w\s,]*\)\s*=>|\[&\])|\w{1,20}\s*<-\s*c\("
    r"|\w{1,20}\s*(?:<-|=)\s*(?:\w{1,9}\.)?(?:zeros|ones|empty|linspace|arange|ode\w*|solve_ivp|lsode|ODEProblem|\w*symbols)\s*\("
    r"|t(?:\[\w\]|\(\w\))?\s*:?=\s*\(?(?:[ikn]|row)(?:\s*-\s*1\s*\))?\s*\*\s*h;?$"
    r"|\w{1,20}\s*:?=\s*[\[({]$|(?:console|sys|plt|DefaultFormatSettings)\..*$|n\s*=\s*\d+;?$"
)


def definition(text: str, names: Names) -> tuple[str, Formula] | None:
    """Return the name and the formula of a line that defines a name of the student's own, None for any other line."""
    name, formula = own_name(text, names.spellings)
    formula = _IS_ZERO.sub("", formula)
    if not name or not formula.strip() or "=" in formula:
        return None
    read = read_as_one(f"0 = {formula}", names)
    return None if isinstance(read, Fault) else (key(name), read.tree.args[1])


def no_velocity(text: str, names: Names) -> bool:
    """Return whether a line names positions and lengths alone: nothing in it has the time in its unit."""
    variant = names.expected.variant
    still = {one.name for one in variant.coordinates} | {one.name for one in variant.given if one.si in {"m", "rad", ""}}
    named = names_in(text, names.spellings)
    return bool(named) and named <= still


def own_name(text: str, spellings: Spellings) -> tuple[str, str]:
    """Return the one word on the left of a line, where it may be a name of the student's own, and what it equals; else ""."""
    if len(text) > reader.MAX_CHARACTERS:
        return "", ""
    plainly = plain_signs(text.replace("$", " "))
    bare = without_words(without_labels(plainly), lambda word: is_name(word, spellings))
    name, sign, formula = bare.partition("=")
    name = re.sub(r"[{}\\]", "", name.strip(" :\t"))
    meant = spellings.canonical(name)
    # A letter that only its size tells from a datum or a coordinate is the student's own: nobody solves for these.
    # But S = 0.4 is where a coordinate s begins, as S = S0 is, and S = 0.4 + u*h where it goes.
    is_own = meant is None or (meant in {*spellings.data, *spellings.rates} and key(name) != key(meant))
    if meant in spellings.rates and is_own:
        named = names_in(formula, spellings)
        is_own = bool(TURNED.search(formula) or named & {*spellings.rates}) and named.isdisjoint(spellings.rates.values())
    return (name, formula) if sign and is_own and OWN_NAME.fullmatch(name) else ("", "")


def is_equation_without_sign(text: str, names: Names) -> bool:
    """Return whether a line without a sign of equality is the left side of an equation, read or not, and not a line of prose."""
    if len(text) > reader.MAX_CHARACTERS or not any(sign in text for sign in "+-−*·⋅×") or relates_two_sides(text):
        return False
    if not names_in(text, names.spellings):
        return False
    return not isinstance(read_as_one(text, names), Fault) or _is_mostly_names(text, names)


def is_part_of_equation(text: str, names: Names) -> bool:
    """Return whether a line without a sign of equality is a sum or a term that the next line may go on with."""
    if is_equation_without_sign(text, names):
        return True
    is_heading = _POINT.fullmatch(text) and text.strip() not in names.spellings.known
    if len(text) > _SHORT or relates_two_sides(text) or is_heading:
        return False
    return bool(names_in(text, names.spellings)) and not isinstance(read_as_one(text, names), Fault)


def _is_mostly_names(text: str, names: Names) -> bool:
    """Return whether a line is made of names of the variant, numbers and signs, but for one word."""
    words = WORD.findall(plain(text, names.spellings))
    strange = [word for word in words if not names.is_name(word)]
    return len(strange) <= 1 and bool(names_in(text, names.spellings) & {*names.expected.variant.sought}) and len(words) > _FEWEST


def sign_of_list(lines: Sequence[str], is_name: Callable[[str], object]) -> re.Pattern[str] | None:
    """Return what several lines begin with as a list does: each with a dash and a blank, or with numbers that count up by one.

    >>> texts = ["- a = b", "- c = d"], ["1.1 a = b", "1.2 c = d"], ["2 a = b", "0.5 c = d"]
    >>> [bool(sign_of_list(lines, {"r1"}.__contains__)) for lines in texts]
    [True, True, False]
    """
    if len(lines) > 1 and all(DASH.match(without_labels(line)) for line in lines):
        return DASH
    begun = [found for line in lines if (found := _COUNT.match(line)) and not (found[1] and is_name(found[1] + found[2]))]
    numbers = [([found[1], *found[2].split(".")[:-1]], int(found[2].rpartition(".")[2])) for found in begun]
    steps = [(one[0] == other[0], other[1] - one[1]) for one, other in pairwise(numbers)]
    return _COUNT if steps and all(step == (True, 1) for step in steps) else None


def is_step(text: str, names: Names) -> bool:
    """Return whether a line is the rule of the scheme, "phi3[k+1] = phi3[k] + h*w3[k]", which is no equation of velocities."""
    left, _, right = _OF_STEP.sub("", text[: reader.MAX_CHARACTERS]).partition("=")
    moved = names_in(left, names.spellings)
    begun = moved if left.rstrip().endswith("+") else set[str]()  # phi3 += h*w3
    used = names_in(right, names.spellings) | begun
    used -= {"h"}  # which may be a length of the task, too
    return any(moved == {one.name} and used == {one.name, one.rate} for one in names.expected.variant.coordinates)


def is_statement(text: str) -> bool:
    """Return whether a line is what a program does with equations, or round them, and none itself.

    >>> is_statement("y = y + h*rhs(t, y)"), is_statement("phi1, phi2 = y"), is_statement("w1, w2 = 0"), is_statement("w1 = 2*w2")
    (True, True, True, False)
    """
    return _STATEMENT.match(text) is not None


def is_row(text: str) -> bool:
    """Return whether a line is a row of a table that a program prints with its names: "t = 0.02 w1 = 2.5 w2 = -1.3".

    >>> is_row("t=0.02 w1=2.5; w2=-1.3"), is_row("w1 = 2.5*w2, w3 = 1")
    (True, False)
    """
    rest, count = PAIR.subn("", text)
    return count > 1 and not any(map(str.isalnum, rest))


def is_datum(text: str, names: Names) -> bool:
    """Return whether a line says a number only, of a datum or of the start: "r1 = 0.953 m", "w1(0) = 2"."""
    if len(text) > _SHORT:
        return False
    bare = without_words(without_labels(_AT_START.sub("@", plain_signs(text))), lambda word: is_name(word, names.spellings))
    name, sign, value = bare.partition("=")
    name, begins, _ = re.sub(r"[{}\\$\s]", "", name).partition("@")
    meant = names.spellings.canonical(name)
    # A name that the task does not have, as h, is a datum of the student's own, or else an answer misspelt.
    is_given = bool(begins) or (meant not in names.expected.variant.sought if meant else not names.expected.answers)
    quantity = _QUANTITY.fullmatch(value) if sign and is_given and OWN_NAME.fullmatch(name) else None
    return quantity is not None and (not quantity[1] or bool(unit_of(quantity[1])))
