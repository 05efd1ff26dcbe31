"""The head of a column -> the columns of the task that it may name, and its unit.

Enters: a head's text and the columns of the task.  Leaves: `Head`.  The aliases come from the names of the columns and
`words.toml`.
Used by whatever reads a file of a student or of a platform.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from coursework.grading.reading.unit_names import WORDS, fold, unit_of
from coursework.system.frozen import frozen

TIME = "t"
INDEX = "№"
_PUNCTUATION = re.compile(r"[\s_,.;:$\\{}()\[\]'\"=*^~-]+")

# For each SI unit of a column: the units in which it may be printed, with their factors to SI.
PRINTED: dict[str, dict[str, float]] = {
    "rad": {"rad": 1.0, "deg": 0.017453292519943295},
    "1/s": {"1/s": 1.0, "deg/s": 0.017453292519943295, "rpm": 0.10471975511965977},
    "m": {"m": 1.0, "mm": 0.001, "cm": 0.01},
    "m/s": {"m/s": 1.0, "mm/s": 0.001, "cm/s": 0.01},
    "s": {"s": 1.0, "ms": 0.001},
    "N": {"N": 1.0, "kN": 1000.0},
    "N·m": {"N·m": 1.0, "kN·m": 1000.0},
}
FACTORS = {unit: factor for units in PRINTED.values() for unit, factor in units.items()}
_OF_FORCE = re.compile(r"(.+?)[\s,/(\[]+(k?)[nh]([·*]?m)?[)\]]?\s*")  # N or kN after a name; `fold` turns the Cyrillic Н into h
_LONGEST = 80  # most characters of a head that are read
_SYMBOLS, _QUANTITIES = WORDS["symbols"], WORDS["quantities"]
_TURNING = [*_SYMBOLS["phi"], *_SYMBOLS["theta"]]
_BY_UNIT = {"rad": _TURNING, "1/s": _SYMBOLS["w"], "m/s": ["v", "u"], "m": ["s", "x"]}
_RATE, _ANGLE, _OTHER = ([*map(fold, WORDS[part])] for part in ("rate", "angle", "other"))
_ORDINALS = {str(k): [*map(fold, words)] for k, words in enumerate(WORDS["ordinals"], start=1)}
_PRIME = re.compile(r"(?<=[^\W_])['′’](?=\w|\s?[(\[,]|$)")
_OF_TIME = ("(t)", "(tk)", "(ti)", "[t]")
_FUNCTIONS = {"sin", "cos", "tan", "tg", "cot", "ctg"}  # a column of sin(phi1) is not the column phi1
_STEMS = ("phi", "theta", "psi", "alpha", "beta", "gamma", "omega", "om", "th", "fi")


@frozen
class Head:
    """What a head may mean: `candidates` are the columns (also time or row number) it may name, several if Greek was lost.

    `unit` is its unit or "".  `told` has the one column that a head describes in words instead of naming it, () if none.
    """

    text: str
    candidates: tuple[str, ...]
    unit: str
    told: tuple[str, ...] = ()

    @property
    def is_certain(self) -> bool:
        """Return whether the head names exactly one column."""
        return len(self.candidates) == 1


def read_head(text: str, columns: Iterable[tuple[str, str]]) -> Head:
    """Return what a head may mean for a task with these `columns`, pairs (name, SI unit).

    >>> read_head("ω1z, 1/с", [("phi1", "rad"), ("w1", "1/s")])
    Head(text='ω1z, 1/с', candidates=('w1',), unit='1/s', told=())
    """
    return _head(text, tuple(columns))


@lru_cache(maxsize=4096)
def _head(text: str, known: tuple[tuple[str, str], ...]) -> Head:
    whole = fold(" ".join(text[:_LONGEST].split()))
    whole = whole if whole.startswith("'") else _PRIME.sub("dot", whole)
    body, unit = _without_unit(whole)
    if any(si in {"N", "N·m"} for _, si in known) and (force := _OF_FORCE.fullmatch(whole)):
        body, unit = force[1], ("kN" if force[2] else "N") + ("·m" if force[3] else "")
    if (name := _PUNCTUATION.sub("", whole)) in aliases(known):  # in "Winkel c" the c is an index, not a unit
        body, unit = name, ""
    found = _looked_up(body, known)
    if len(found) > 1 and unit:
        units = dict(known)
        fitting = tuple(name for name in found if name not in units or _fits(unit, units[name]))
        found = fitting or found
    return Head(text.strip(), found, unit, () if found else _told(text, known))


def _looked_up(body: str, known: tuple[tuple[str, str], ...]) -> tuple[str, ...]:
    """Return the columns that a folded head, given without its unit, may name."""
    key = _PUNCTUATION.sub("", body)
    found = aliases(known).get(key, ())
    if not found and "?" in key:  # a Greek letter that the encoding does not have
        word, _, rest = key.rpartition("?")
        found = aliases(known).get(word.strip("?") + rest, ()) if word.strip("?") else _indexed(known, rest.removesuffix("z"))
    return found


def _told(text: str, known: tuple[tuple[str, str], ...]) -> tuple[str, ...]:
    """Return the column that a head in words describes: by a symbol among the words, or by the quantity and the link's number.

    >>> _told("rate of link w1 (rad/s)", (("w1", "1/s"),)), _told("кутова швидкість 2-ї ланки", (("w1", "1/s"), ("w2", "1/s")))
    (('w1',), ('w2',))
    """
    said, unit = _without_unit(fold(" ".join(text[:_LONGEST].split())))
    words = re.findall(r"\w+", said)
    if {*words} & _FUNCTIONS or any(word in said for word in _OTHER):
        return ()
    own = {fold(name) for name, _ in known}
    symbols = [word for word in words if len(words) > 1 and (word in own or any(map(str.isdigit, word[1:])))]
    named = {found[0] for word in symbols if len(found := _looked_up(word, known)) == 1} - {TIME, INDEX}
    named -= {name for name, si in known if unit and not _fits(unit, si)}
    return tuple(named)[:1] if len(named) == 1 else () if named else _of_kind(said, unit, known)


def _of_kind(said: str, unit: str, known: tuple[tuple[str, str], ...]) -> tuple[str, ...]:
    """Return the one column whose quantity and index the words name, () if none or several fit."""
    turns, moves = (any(word in said for word in words) for words in (_ANGLE, _RATE))
    kinds = {si for si in PRINTED if unit and _fits(unit, si) and (not moves or si != "rad")}
    if turns or moves:
        kinds = {"rad"} if not moves else {"1/s"} if turns or "1/s" in kinds else kinds & {"m/s"} or {"m/s", "1/s"}
    indices = {*re.findall(r"\d+", said)} or {k for k, words in _ORDINALS.items() if any(word in said for word in words)}
    if len(indices) > 1 or not kinds or not (turns or moves or indices):
        return ()
    found = [name for name, si in known if si in kinds and (not indices or _parts(name)[1] in indices)]
    if not indices and "m/s" in kinds:
        found = [name for name, si in known if si == "m/s"]
    return tuple(found) if len(found) == 1 else ()


def may_be(head: Head, unit: str) -> bool:
    """Return whether a head that names no column may belong to a column with this SI unit; "V_M" must be a length or speed."""
    if head.unit or " " in head.text:
        return " " in head.text or _fits(head.unit, unit)
    is_linear = _PUNCTUATION.sub("", fold(head.text)).startswith(("v", "x", "y", "s"))
    return unit in {"m", "m/s"} or not is_linear


def _indexed(columns: tuple[tuple[str, str], ...], index: str) -> tuple[str, ...]:
    """Return the columns whose names have this index."""
    return tuple(name for name, _ in columns if _parts(name)[1] == index)


def _fits(unit: str, si: str) -> bool:
    return unit in PRINTED.get(si, {}) or (unit == "deg" and si == "1/s") or (unit == "rad" and si == "1/s")


def _without_unit(text: str) -> tuple[str, str]:
    """Return a folded head without its unit, and the unit ("" if it has none)."""
    bracket = re.fullmatch(r"(.*?)[(\[]([^()\[\]]{1,20})[)\]]\s*", text)
    if bracket:
        if unit := unit_of(bracket[2]):
            return bracket[1].rstrip("/, "), unit
        if bracket[1] and f"({bracket[2].strip()})" in _OF_TIME:
            return bracket[1], ""
    for pattern in (r"(.+?)\s*,\s*(\S.*)", r"(.+)\s+in\s+(\S+)", r"(.*\S)\s+(\S+)", r"(.+?)\s*/\s*(\S.*)", r"(.*[^\s°])\s*(°)"):
        match = re.fullmatch(pattern, text)
        if match and (unit := unit_of(match[2])):
            return _without_unit(match[1])[0] if match[1].endswith(_OF_TIME) else match[1], unit
    return text, ""


def _parts(name: str) -> tuple[str, str]:
    """Return the folded stem and index of a column's name: phi1 -> phi, 1; wpsi -> w, psi; uC -> u, c; psi -> psi, ""."""
    plain = fold(name)
    stem = next((stem for stem in _STEMS if plain.startswith(stem)), plain[:1])
    return stem, plain[len(stem) :]


@lru_cache(maxsize=64)
def aliases(columns: tuple[tuple[str, str], ...]) -> Mapping[str, tuple[str, ...]]:
    """Return every folded head that is understood, with the columns it may name; the task's own names take precedence."""
    found: dict[str, list[str]] = {}

    def offer(spelling: str, name: str) -> None:
        names = found.setdefault(_PUNCTUATION.sub("", fold(spelling)), [])
        if name not in names:
            names.append(name)

    parts = {name: _parts(name) for name, _ in columns}
    own = {fold(name): name for name, _ in columns}
    for name, unit in columns:
        stem, index = parts[name]
        symbols = _SYMBOLS.get(stem, [stem])
        if [parts[other][1] for other, kind in columns if kind == unit].count(index) == 1:
            # If only one angle (or speed …) has this index, any symbol of its quantity may name it.
            symbols = [*symbols, *_BY_UNIT.get(unit, [])]
        for symbol in (*symbols, *_QUANTITIES.get(unit, [])):
            offer(symbol + index, name)
            for word in _QUANTITIES.get(unit, []):
                offer(word + symbol + index, name)
            if unit == "1/s":
                for angle in _TURNING if index else ():
                    for rate in ("d{0}{1}/dt", "d{0}{1}dt", "{0}{1}dot", "{0}dot{1}", "dot{0}{1}", "{0}\u0307{1}"):
                        offer(rate.format(angle, index), name)
                offer(f"{symbol}{index}z", name)
                offer(f"{symbol}z{index}", name)
    for spelling in WORDS["times"]:
        for word in ("", *WORDS["before_times"]):
            offer(word + spelling, TIME)
    for spelling in WORDS["indices"]:
        offer(spelling, INDEX)
    # A name of the task always means that column, whatever else the word could mean.
    return {key: (own[key],) if key in own else tuple(names) for key, names in found.items()} | {
        key: (name,) for key, name in own.items()
    }
