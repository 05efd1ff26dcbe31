"""What a student calls the angles, "α = φ1", "α, β - angles of links 1, 2", "α for link 1" -> spellings of the task's names.

Enters: the pieces of a text, `Names`.  Leaves: `Names` with these spellings, and the pieces without the legend.
Used by `lines.py`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence, Set
from dataclasses import replace

from coursework.grading.reading.equations.formulas.equations import TURNED, Names
from coursework.grading.reading.equations.formulas.names_in_text import Spellings, plain_name
from coursework.grading.reading.equations.notation.latex import without_latex
from coursework.grading.reading.equations.notation.signs import ARROW, plain_signs
from coursework.variant.formula.alphabet import spell
from coursework.variant.formula.reader import FUNCTION_WORDS

_NAME = r"([^\W\d]\w{0,12})"
_SAME = re.compile(
    rf"(?:(?:[^\W\d_]{{3,20}}\b|[-–•*])[\s:,(]*){{0,6}}{_NAME}\s*(?:=|⇒)\s*{_NAME}(?:\s+\([^=()*/]{{3,40}}\)|\s*(?:[.,;)](?!\w)[^=]{{0,120}})?"
    r"|\s+[-–]\s+(?:[а-яіїє]{3}|[^\W\d_]{3,20}\s[^\W\d_]{2})[^=*+/()\d]{0,60})"  # words, no difference
)
_ROW = re.compile(rf"\s*{_NAME}\s*{ARROW}\s*{_NAME}\s*")
_ANGLES = r"(?:angles?|углы|угол|кути|кут|Winkel|angles|ángulos)"
_LISTED = re.compile(
    rf"((?:{_NAME},\s*){{1,9}}{_NAME})\s*[-–:,]?\s[^=*+/]{{0,40}}\b{_ANGLES}\b[^=*+/\d]{{0,40}}\b((?:\d,\s*){{1,9}}\d)\b.*", re.I
)
_OF_LINK = re.compile(
    rf"{_NAME}\s*[-–:(]?\s*(?:{_ANGLES}\s+(?:[^\W\d]+\s+){{0,3}}|(?:for|of|für|для|pour)\s+(?:[^\W\d]+\s+)?)?"
    r"(?:link|bar|rod|звен|ланк|Glied|Stab|barre|barra|构件|杆)[^\W\d]*\s*№?\s*(\d)\)?(?:\s*[.,;]\s*|$)",
    re.I,
)
_OMEGA = ("w", "om", "omega")
_AND = re.compile(r"\s(?:and|und|y|et|e|i|и|та|ve|dan)\s")
_LIST = rf"(?:{_NAME[1:-1]},\s?){{1,6}}{_NAME[1:-1]}(?:\s(?:and|und|y|et|e|i|и|та|ve|dan)\s{_NAME[1:-1]})?"
_BOTH_LISTED = re.compile(rf"(?:[^\W\d_]{{3,20}}\s)?({_LIST})\s(?:[^\W\d_]{{2,20}}\s){{1,4}}({_LIST})\.?")
_GREEK = ("alpha", "beta", "gamma", "delta", "theta", "psi", "chi", "eta", "zeta", "xi", "epsilon", "eps", "phi")
_MOST_CHARACTERS = 300
# c_i = cos(φ_i), perhaps behind words; the index of the other names is set apart from them
_RUNNING = re.compile(r"(?:[^=]*[\s$(])?(\\?[^\W\d]\w{0,5}?)_?\{?([ijk])\}?\$?\s*:?=([^=]*_\{?\2(?![^\W_])[^=]*)")


def with_each_index(line: str, names: Names) -> list[str]:
    """Return what a line with a running index, c_i = cos(φ_i), says for each number of the task's names; else the line."""
    found = _RUNNING.fullmatch(line.replace("ᵢ", "_i")) if len(line) <= _MOST_CHARACTERS else None
    if found is None or not TURNED.search(found[3]):  # v_i = r_i*w_i defines what no equation names
        return [line]
    index = re.compile(rf"_\{{?{found[2]}(?![^\W_])\}}?")
    formulas = {number: index.sub(f"_{number} ", found[3]) for number in "123456789"}
    words = {number: re.findall(r"[^\W\d]\w*", plain_signs(without_latex(one))) for number, one in formulas.items()}
    return [f"{found[1]}_{number} = {formulas[number]}" for number in formulas if all(map(names.is_name, words[number]))] or [
        line
    ]


def with_legend(lines: Sequence[tuple[int, str]], names: Names) -> tuple[Names, list[tuple[int, str]]]:
    """Return the names with what the lines call the coordinates, and the other lines; the letter of a datum may be an angle."""
    called: dict[str, str] = {}
    rest: list[tuple[int, str]] = []
    for number, line in lines:
        found = [*_pairs(line, names.spellings, {*names.expected.variant.velocities})]
        called |= {plain_name(name): meant for name, meant in found if plain_name(name) not in called}
        # and the rate of the angle β that is ψ is ω_β
        rates = {f"{sign}{plain_name(name)}": names.spellings.rates.get(meant) for name, meant in found for sign in _OMEGA}
        called |= {name: rate for name, rate in rates.items() if rate and names.spellings.canonical(name) is None}
        if not found and (data := _of_datum(line, names.spellings)):
            line = data
        rest += [] if found else [(number, line)]
    if not called:
        return names, rest
    before = names.spellings
    beside = replace(before, others=before.others | called)  # a letter of a datum stays the datum
    spellings = replace(beside, known=before.known - {*called})
    return replace(
        names, spellings=spellings, before=replace(names, spellings=beside) if before.known & {*called} else None
    ), rest


def _of_datum(line: str, spellings: Spellings) -> str:
    """Return "a = L1" for "a ⇒ L1", the row of a table that gives a datum the name of the student; "" for any other line."""
    same = _ROW.fullmatch(plain_signs(without_latex(line))) if ARROW in line else None
    is_datum = same is not None and spellings.canonical(same[2]) in spellings.data and spellings.canonical(same[1]) is None
    return f"{same[1]} = {same[2]}" if same and is_datum else ""


def _pairs(line: str, spellings: Spellings, velocities: Set[str]) -> Iterator[tuple[str, str]]:
    """Yield (name of the student, coordinate or velocity sought) of a line that says nothing else."""
    text = plain_signs(without_latex(line)).strip() if len(line) <= _MOST_CHARACTERS else ""
    if same := _SAME.fullmatch(text):
        for name, other in (same.groups(), same.groups()[::-1]):
            meant = spellings.angle(other)
            is_rate = meant in velocities and spellings.canonical(name) is None and not re.search(r"[*/+]|\.\w", text)
            is_angle = meant in spellings.rates and meant in spellings.known
            if meant and (is_rate or is_angle) and _is_free(name, spellings):
                yield name, meant
                return
    else:
        if both := [found for part in text.split(";") if (found := _BOTH_LISTED.fullmatch(part.strip()))]:
            yield from (pair for found in both for pair in _of_lists(found, spellings, velocities))
            return
        listed, of_links = _LISTED.fullmatch(text), _OF_LINK.findall(text)
        own, numbers = (re.findall(r"\w+", listed[1]), re.findall(r"\d", listed[4])) if listed else ([], [])
        if of_links and not _OF_LINK.sub("", text):
            own, numbers = [name for name, _ in of_links], [number for _, number in of_links]
            own *= all(spell(name).rstrip("0123456789_") in _GREEK for name in own)  # L of link 1 is a length
        angles = [spellings.angle(f"phi{number}") for number in numbers]
        pairs = [(name, angle) for name, angle in zip(own, angles, strict=False) if angle in spellings.rates and angle]
        yield from pairs if len(own) == len(numbers) == len(pairs) and all(_is_free(one, spellings) for one in own) else ()


def _of_lists(found: re.Match[str], spellings: Spellings, velocities: Set[str]) -> list[tuple[str, str]]:
    """Return the pairs of "a, b and c are the angles phi1, phi2 and phi3", if each name there is free for what it shall mean."""
    own, theirs = (re.findall(r"[^\W\d]\w*", _AND.sub(",", said)) for said in found.groups())
    meant = [spellings.angle(one) for one in theirs]
    pairs = [(name, one) for name, one in zip(own, meant, strict=False) if one in {*velocities, *spellings.rates} and one]
    new = [(name, one) for name, one in pairs if spellings.canonical(name) != one]
    return new if len(own) == len(theirs) and all(_is_free(name, spellings) for name, _ in new) else []


def _is_free(name: str, spellings: Spellings) -> bool:
    """Return whether a name means nothing in the task, or only a datum with a Greek letter, which angles have as well."""
    if name.lower() in FUNCTION_WORDS:
        return False
    meant = spellings.canonical(name)
    return (
        spellings.angle(name) is None if meant is None else meant in spellings.data and spell(name).rstrip("0123456789") in _GREEK
    )
