"""The vectors of a program, y[0], x(2), dydt[1], Y[k, 0] -> the names of the task, in the order found in the text.

Enters: a text, the variant.  Leaves: the text with names in place of vector entries and with returned lists as equations.
Nothing is computed.  Used by `text_lines.py`.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from itertools import islice

from coursework.grading.reading.equations.formulas.names_in_text import Spellings
from coursework.grading.reading.equations.notation.signs import closing
from coursework.grading.reading.equations.systems.parts import at_signs
from coursework.variant.formula.reader import FUNCTION_WORDS
from coursework.variant.record.variant import Variant

_ROW = r"(?:([ijkn](?:\s*[-+]\s*1)?)\s*(?:,|\]\s*\[)\s*)?"  # the row in Y[k, 0] and Y[k][0]
# An entry; a number in brackets that is set apart at the end of a line, "= VMx [11]" or "= ω_4 (1)", is the line's label.
_ENTRY = re.compile(
    rf"(?<![\w.\\'])([^\W\d]\w{{0,20}})(?! \[\d{{1,2}}\][ \t.;]*$|(?<=\d) \(\d{{1,2}}\)[ \t.;]*$)"
    rf" ?([\[(])\s*{_ROW}(\d{{1,2}})\s*[\])]",
    re.MULTILINE,
)
_NAMES = r"((?:[^\W\d]\w{0,20}\s*[,;]\s*)+[^\W\d]\w{0,20})"
_LIST = re.compile(rf"(?:[\[({{]|\breturn )\s*{_NAMES}\s*(?:[\])}}]|$)", re.MULTILINE)
_UNPACKED = re.compile(
    rf"(?m)^[^\n=]{{0,12}}?(?<![\w.]){_NAMES}\s*[\])]?\s*:?=\s*([^\W\d]\w{{0,20}})(?:\[[^\]]{{0,4}}\]|\.T)?;?\s*$"
)
_SAID = re.compile(
    rf"(?<![\w.])([^\W\d]\w{{0,20}})(?:\s*(?:=|:|<-)\s*(?:[\w.]{{1,12}}\()?[\[({{]|:)\s*{_NAMES}\s*(?:[\])}}]|$)", re.MULTILINE
)
_NUMBERS = re.compile(r"[\[({]\s*((?:-?\d++\.?+\d*+(?:\s*+[,;]\s*+|\s++))+-?\d++\.?+\d*+)\s*[\])}]")
_RETURNED = re.compile(r"(?:\breturn\s+|(?<![\w.])d\w{1,12}\s*=\s*)(?:[\w.]{1,12}\s*\(\s*)?(?=[\[({])")
_ZERO_BASED = re.compile(r"\b(?:np|math|Math|std|torch)\.|\bimport\b|#include|\b(?:double|float|const|let|var|func)\s")
_SINES = re.compile(
    r"(?m)(?:^|(?<=;))[ \t]*((?:[^\W\d]\w{0,9}[ \t]*,[ \t]*)?[^\W\d]\w{0,9})[ \t]*="
    r"[ \t]*((?:[\w.]{0,6}(?:sin|cos)\(\s*\w{1,9}\s*\)[ \t]*,?[ \t]*){1,2})(?=;|$)"
)
_SAME = re.compile(r"(?<![\w.])([^\W\d]\w*)\s*(?::?=|<-)\s*\1\s*(?=[;,}\n#%]|//|$)")  # phi1 = phi1
_DERIVATIVE = re.compile(r"d[a-z]\w*|\w+_?dot|(?:w|v|om|omega|ω)", re.IGNORECASE)
_BETWEEN = re.compile("[,;]")
_MOST_LISTS, _MOST_VECTORS, _MOST_CHARACTERS, _MOST_SINES, _LONGEST = 40, 40, 200_000, 20, 4000


def with_entries_named(text: str, variant: Variant, spellings: Spellings) -> str:
    """Return a text with names of the task in place of the entries of vectors.

    The order comes from the line that unpacks or builds the vector, from a comment, from the values returned or from the start
    values; else it is the order of the task.
    """
    text = _of_whole_vectors(text) if len(text) <= _MOST_CHARACTERS else text
    if len(text) > _MOST_CHARACTERS or not (entries := [*_ENTRY.finditer(text)]):
        return _returned(text, [one.rate for one in variant.coordinates])
    uses: dict[str, list[re.Match[str]]] = defaultdict(list)
    for entry in entries:
        uses[entry[1]].append(entry)
    is_zero_based = any(int(entry[4]) == 0 and spellings.canonical(f"{entry[1]}0") is None for entry in entries)
    order = _order(text, variant, spellings)
    rates = {one.name: one.rate for one in variant.coordinates}
    meant: dict[str, dict[int, str]] = {}
    for vector, used in islice(uses.items(), _MOST_VECTORS):  # for each the whole text is searched
        indices = {int(entry[4]) for entry in used}
        by_use = _by_use(text, vector, used, order, variant)
        is_own = is_zero_based or not all(spellings.angle(f"{vector}{index}") for index in indices)
        # f(1) may be an angle whose Greek letter got lost, unless the program assigns the right sides of its system to f.
        is_own = is_own or (vector in {"f", "F"} and [*by_use] == [rates[name] for name in order])
        if not is_own or (used[0][2] == "(" and (vector in spellings.known or vector.lower() in FUNCTION_WORDS)):
            continue
        names = _told(text, vector, spellings) or _from_zero(vector, indices, spellings) or by_use
        is_from_one = used[0][2] == "(" or max(indices) >= len(names) or not _ZERO_BASED.search(text)
        base = int(is_from_one and not is_zero_based)
        found = dict(enumerate(names, start=base)) | _taken(text, vector, spellings)
        if indices & found.keys():
            meant[vector] = found
    named = _ENTRY.sub(lambda entry: _named(entry, meant), text)
    return _returned(_SAME.sub("", named) if meant else text, [rates[name] for name in order])


def with_short_names(text: str, variant: Variant, spellings: Spellings) -> str:
    """Return a program with theta, beta for th, be, if it lists its coordinates so, all in the order of the task."""
    names = [one.name for one in variant.coordinates]
    if not any(len(name) > len("phi") for name in names):
        return text
    for found in islice(re.finditer(rf"(?<![\w.])(?:[^\W\d]\w*[ \t]*,[ \t]*){{{len(names) - 1}}}[^\W\d]\w*", text), _MOST_LISTS):
        pairs = zip(re.findall(r"\w+", found[0]), names, strict=True)
        short = {one: name for one, name in pairs if one != name}
        if short and all(
            len(one) > 1 and name.startswith(one.lower()) and spellings.angle(one) in {None, name} for one, name in short.items()
        ):
            for one, name in short.items():
                text = re.sub(rf"(?<![\w.]){one}(?!\w)", name, text)
            break
    return text


def _of_whole_vectors(text: str) -> str:
    r"""Return a text with sin(q[2]) for s[2], where s = np.sin(q), or s, c = np.sin(q), np.cos(q), and q is a vector.

    >>> _of_whole_vectors("s, c = np.sin(q), np.cos(q)\nw = s[0]*c[1]")
    's, c = np.sin(q), np.cos(q)\nw = sin(q[0])*cos(q[1])'
    """
    meant: dict[str, tuple[str, str]] = {}
    for line in islice(_SINES.finditer(text), _MOST_SINES):
        calls = re.findall(r"(sin|cos)\(\s*(\w+)\s*\)", line[2])
        meant |= dict(zip(re.findall(r"\w+", line[1]), calls, strict=False))
    if not meant:
        return text
    entry = re.compile(rf"(?<![\w.])({'|'.join(meant)}) ?([\[(]\s*\d{{1,2}}\s*[\])])")
    return entry.sub(lambda found: f"{meant[found[1]][0]}({meant[found[1]][1]}{found[2]})", text)


def _named(entry: re.Match[str], meant: dict[str, dict[int, str]]) -> str:
    """Return the name of an entry, with its row if that is not the current one."""
    name = meant.get(entry[1], {}).get(int(entry[4]))
    return entry[0] if name is None else f"{name}[{entry[3]}]" if entry[3] and entry[3] != entry[3].strip("+-1 ") else name


def _order(text: str, variant: Variant, spellings: Spellings) -> list[str]:
    """Return the coordinates in the program's order: of the rates it lists, else of its start values, else of the task."""
    names = [one.name for one in variant.coordinates]
    of_rate = {one.rate: one.name for one in variant.coordinates}
    for found in _LIST.finditer(text):
        listed = [of_rate.get(spellings.canonical(name) or "") for name in re.findall(r"\w+", found[1])]
        if sorted(filter(None, listed)) == sorted(names) and len(listed) == len(names):
            return [name for name in listed if name]
    starts = {one.name: one.start for one in variant.coordinates if one.start is not None}
    for found in _NUMBERS.finditer(text):
        numbers = [float(number) for number in re.split(r"[\s,;]+", found[1])]
        if sorted(numbers) == sorted(starts.values()) and len({*numbers}) == len(names):
            return sorted(names, key=lambda name: numbers.index(starts[name]))
    return names


def _told(text: str, vector: str, spellings: Spellings) -> list[str]:
    """Return the names of a vector's entries from a line that unpacks it or a line or comment that lists it; [] if none."""
    lists = [found[1] for found in _UNPACKED.finditer(text) if found[2] == vector]
    lists += [found[2] for found in _SAID.finditer(text) if found[1] == vector]
    for listed in lists:
        names = [spellings.canonical(name) for name in re.findall(r"\w+", listed)]
        if all(names):
            return [name for name in names if name]
    return []


def _from_zero(vector: str, indices: set[int], spellings: Spellings) -> list[str]:
    """Return r1, r2, r3 for r[0], r[1], r[2], if the task has all these names; else, or if r[0] does not occur, []."""
    names = [spellings.canonical(f"{vector}{index + 1}") for index in range(max(indices) + 1)]
    return [name for name in names if name] if 0 in indices and all(names) else []


def _taken(text: str, vector: str, spellings: Spellings) -> dict[int, str]:
    """Return the names by index that are assigned from entries, phi1 = y[0], or assigned to entries, dydt[0] = w1."""
    entry = rf"{re.escape(vector)} ?[\[(]\s*(\d{{1,2}})\s*[\])]"
    found: dict[int, str] = {}
    ends, equals = r"\s*(?:[;,}#%]|//|$)", r"\s*(?::\s*\w+\s*)?(?::?=|<-)\s*"
    for match in re.finditer(rf"(?m)(?<![\w.])([^\W\d]\w{{0,20}}){equals}{entry}{ends}", text):
        if name := spellings.angle(match[1]):
            found.setdefault(int(match[2]), name)
    for match in re.finditer(rf"(?m)(?<![\w.]){entry}{equals}([^\W\d]\w{{0,20}}){ends}", text):
        if (name := spellings.canonical(match[2])) and name not in spellings.data:
            found.setdefault(int(match[1]), name)
    for match in re.finditer(rf"(?m)(?<![\w.]){entry}\s*=[^=;\n]*;?[ \t]*(?:/\*|//|%|#|!)[ \t]*(\w+)[ \t]*(?:\*/)?$", text):
        if name := spellings.canonical(match[2]):  # out[0] = …; /* w */
            found.setdefault(int(match[1]), name)
    return found


def _by_use(text: str, vector: str, used: Sequence[re.Match[str]], order: Sequence[str], variant: Variant) -> Sequence[str]:
    """Return the names in a vector by its use: coordinates if sin or cos takes it, rates if formulas are assigned to it …"""
    if re.search(rf"(?:sin|cos)\s*\(\s*[-+\w.*\s]{{0,20}}{re.escape(vector)} ?[\[(]", text, re.IGNORECASE):
        return order
    assigned = {int(entry[4]): made[1] for entry in used if (made := re.match(r"\s*:?=([^=\n][^\n]*)", text[entry.end() :]))}
    if assigned:
        rates = {one.name: one.rate for one in variant.coordinates}
        speeds = [rates[name] for name in order]
        if len(assigned) > len(speeds):  # all velocities in one vector, not only those that are integrated
            speeds += [name for name in variant.velocities if name not in speeds]
        is_solved = len(assigned) == len(order) and any("/" in formula for formula in assigned.values())
        own = any(
            rate in re.findall(r"\w+", formula) for rate, (_, formula) in zip(speeds, sorted(assigned.items()), strict=False)
        )
        return speeds if _DERIVATIVE.fullmatch(vector) or (is_solved and not own) else ()
    indices = {int(entry[4]) for entry in used}
    is_factor = any("*" in {text[entry.end() : entry.end() + 2].strip(), text[: entry.start()].rstrip()[-1:]} for entry in used)
    return variant.sought if is_factor and len(indices) == len(variant.sought) else ()


def _returned(text: str, rates: Sequence[str]) -> str:
    """Return a text with a returned list, [w1, (…)/(…)], written as equations, if it has some rates in their places."""
    for found in _RETURNED.finditer(text):
        begun = found.end()
        end = closing(text, begun, _LONGEST)
        cells = [" ".join(cell.split()) for cell in at_signs(_BETWEEN, text[begun + 1 : end])]
        pairs = [*zip(rates, cells, strict=False)]
        is_other = any(cell in rates and cell != rate for rate, cell in pairs)  # return {us, w2, vz}, in an order of its own
        if end == begun or is_other or any(map(_ENTRY.fullmatch, cells)):
            continue  # or a list without an end, or an entry of a vector without names
        if len(cells) == len(rates) and 0 < sum(rate == cell for rate, cell in pairs) < len(rates):
            equations = "; ".join(f"{rate} = {cell}" for rate, cell in pairs if rate != cell)
            return text[: found.start()] + equations + "\n" * text.count("\n", begun, end) + text[end + 1 :].lstrip(")")
    return text
