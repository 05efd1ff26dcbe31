"""Right equations as a hand may write them: every habit at random at once.

`python -m tests.grading.reading.equations.notation.fuzz_equations 2000` tries more of them.

Enters: a seed.  Leaves: texts of right equations.  Nothing of the readers is used.
One habit a text: how names, products, functions, minus signs and brackets are written; in each line by chance terms and factors
are in another order, a term stands on the other side, the whole is multiplied by a number.
"""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass

from tests.grading.reading.equations.notation.notations import PLAIN

_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_GREEK = {"phi": "φ", "w": "ω", "alpha": "α", "beta": "β"}
_LETTERS = re.compile(r"(phi|w|r|alpha|beta)(\d?|[ab])")


def _greek(name: str) -> str:
    found = _LETTERS.fullmatch(name)
    return name if not found else _GREEK.get(found[1], found[1]) + found[2]


NAMES: tuple[Callable[[str], str], ...] = (
    str,
    _greek,
    lambda name: _greek(name).translate(_SUBSCRIPTS),
    lambda name: re.sub(r"^(phi|w|r)(\w)$", r"\1_\2", name),
    lambda name: re.sub(r"^(φ|ω|r)(\w)$", r"\1_\2", _greek(name)),
    lambda name: re.sub(r"^w(\w)$", r"omega\1", name),
    lambda name: re.sub(r"^w(\w)$", r"omega_\1", name),
    lambda name: re.sub(r"^(phi|w|r)(\w)$", r"\1[\2]", name),
    lambda name: re.sub(r"^(phi|w|r)(\w)$", r"\1{\2}", name).replace("{", "_{"),
)
TIMES = ("*", " * ", "·", " · ", "⋅", " × ", "×", " ")
MINUS = ("-", "−", "–")
CALLS: tuple[Callable[[str, str], str], ...] = (
    lambda function, x: f"{function}({x})",
    lambda function, x: f"{function} ({x})",
    lambda function, x: f"{function}( {x} )",
    lambda function, x: f"{function} {x}",
    lambda function, x: f"{function}[{x}]",
    lambda function, x: f"{function.upper()}({x})",
    lambda function, x: f"{function.capitalize()}({x})",
)
SIGNS = (" {} ", "{}", " {}", "{} ")
LABELS = (
    "{e}",
    "so {e}",
    "Eq. {k} {e}",
    "({k}) {e}",
    "{k}) {e}",
    "{k}. {e}",
    "[{k}] {e}",
    "{e} ({k})",
    "{e};",
    "{e},",
    "Eq. {k}: {e}",
    "({k}): {e}",
)


@dataclass(frozen=True)
class Hand:
    """The habits of one text."""

    name: Callable[[str], str]
    times: str
    minus: str
    call: Callable[[str, str], str]
    sign: str
    label: str
    half: str
    comma: bool


def hand(chance: random.Random) -> Hand:
    """Return habits by chance; where a blank multiplies, names are those that end where they end."""
    return Hand(
        chance.choice(NAMES), chance.choice(TIMES), chance.choice(MINUS), chance.choice(CALLS), chance.choice(SIGNS),
        chance.choice(LABELS), chance.choice(("0.5", ".5", "1/2", "0,5", "(1/2)", "½")), chance.random() < 0.3,
    )  # fmt: skip


def _terms(side: str) -> list[tuple[str, list[str]]]:
    """Return the terms of a sum as (sign, factors)."""
    found = re.findall(r"([-+]?) *([^-+]+)", side.strip())
    return [(sign or "+", body.strip().split("*")) for sign, body in found if body.strip() != "0"]


def _factor(text: str, habits: Hand) -> str:
    if call := re.fullmatch(r"(sin|cos)\((\w+)\)", text):
        return habits.call(call[1], habits.name(call[2]))
    return habits.half if text == "0.5" else habits.name(text) if text[0].isalpha() else text


def _sum(terms: list[tuple[str, list[str]]], habits: Hand, chance: random.Random) -> str:
    if not terms:
        return "0"
    text = ""
    for number, (sign, factors) in enumerate(terms):
        numbers = [one for one in factors if not one[0].isalpha()]
        others = [one for one in factors if one[0].isalpha()]
        # A function written without brackets takes what follows: it stands last.
        others.sort(key=lambda one: ("(" in one, chance.random()))
        body = habits.times.join(_factor(one, habits) for one in [*numbers, *others])
        if chance.random() < 0.15:
            body = chance.choice(("({})", "[{}]", "{{{}}}")).format(body)
        shown = habits.minus if sign == "-" else "+"
        text += (shown if sign == "-" else "") + body if not number else habits.sign.format(shown) + body
    return text


def _line(line: str, habits: Hand, chance: random.Random) -> str:
    left, right = (_terms(side) for side in line.split("="))
    turn = {"+": "-", "-": "+"}
    if chance.random() < 0.5:
        chance.shuffle(left)
    for _ in range(chance.randrange(3)):
        if len(left) > 1:
            sign, factors = left.pop(chance.randrange(len(left)))
            right.append((turn[sign], factors))
    if chance.random() < 0.2:
        left, right = right, left
    if chance.random() < 0.15:
        left, right = ([(turn[sign], factors) for sign, factors in side] for side in (left, right))
    one, other = _sum(left, habits, chance), _sum(right, habits, chance)
    if other == "0" and chance.random() < 0.1:
        one = chance.choice(("2*({})", "({})", "[{}]", "-({})", "({})/2")).format(one)
    return one + chance.choice((" = ", "=", " =", " == ")) + other


def written(mechanism: str, chance: random.Random) -> str:
    """Return the right equations of a mechanism in one hand."""
    habits = hand(chance)
    lines = [_line(line, habits, chance) for line in PLAIN[mechanism].split("\n")]
    return "\n".join(habits.label.format(e=line, k=k) for k, line in enumerate(lines, 1))


def main(count: int, first: int = 0) -> None:
    """Say which right equations are marked wrong, or cost in silence; and how many are a question."""
    from tests.grading.reading.equations.notation.test_notations import marked

    asked = 0
    for seed in range(first, first + count):
        chance = random.Random(seed)
        mechanism = chance.choice(list(PLAIN))
        text = written(mechanism, chance)
        found = marked(text, mechanism)
        asked += found.share < 1.0
        if found.wrong or (found.share < 1.0 and found.unread is None):
            told = [(mark.verdict, mark.line.text, mark.line.repaired) for mark in found.marks if mark.verdict != "right"]
            print(seed, mechanism, *told, sep="\n    ")
    print(f"{count} texts, {asked} questions")


if __name__ == "__main__":
    main(*(int(number) for number in sys.argv[1:]))
