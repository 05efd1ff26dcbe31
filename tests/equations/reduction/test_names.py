"""Whatever a file calls its things, the numbers stay the same: symbols and generated code have private names, one to one."""

import builtins
import itertools
import keyword
import math
import re

import numpy as np
import pytest

import coursework
from coursework.equations.codegen import names as private_names
from coursework.motion.schemes import SCHEMES
from coursework.report.formulas.typst_math import text
from coursework.results.accuracy.trace import trace
from coursework.variant.formula.reader import FUNCTION_WORDS
from coursework.variant.formula.tree import Formula
from coursework.variant.reading.reader import parse_variant
from tests import sample
from tests.mechanisms.library import mechanism

# One name in every role; `drive` is also the rate of a coordinate, `law` has derivatives of first and second order.
PLAIN = """
format = 1
[given]
datum = "0.4 m"
speed = "3 rad/s"
[drive]
drive = "speed*cos(2*t)"
[functions]
law = "0.1 + 0.02*sin(angle)"
other = "0.05 + 0.01*sin(angle)*cos(other_angle)"
[coordinates]
angle = { start = "0.3 rad", rate = "drive" }
other_angle = { start = "0.2 rad", rate = "rate" }
[unknowns]
unknown = "m/s"
[points]
point = "(datum*sin(angle), law)"
[links]
link = { points = ["point"], rate = "drive" }
[time]
step = "0.02 s"
end = "0.06 s"
[[constraint]]
name = "constraint"
because = "the slopes of both laws and the second rates are needed"
equation = "datum*rate*cos(other_angle) + law*drive*cos(angle) + other*rate = 0"
[[constraint]]
name = "second"
because = "a velocity that is no rate"
equation = "unknown = datum*rate*sin(other_angle) - law*drive*sin(angle)"
"""
ROLES = ("datum", "speed", "drive", "law", "other", "angle", "other_angle", "rate", "unknown", "point", "link", "constraint")
_WORD = re.compile(rf"\b(?:{'|'.join(sorted(ROLES, key=len, reverse=True))})\b")


def renamed(names):
    """Return the plain variant with other names for some roles; keys and prose stay."""
    lines = []
    for line in PLAIN.splitlines():
        if line.startswith(("because", "[[", "[", "format")):
            lines.append(line)
            continue
        key, equals, value = line.partition(" = ")
        swap = {word: names.get(word, word) for word in ROLES}
        value = re.sub(r"\brate = ", "RATE = ", value) if line.startswith(("angle", "other_angle", "link")) else value
        value = _WORD.sub(lambda match, swap=swap: swap[match[0]], value).replace("RATE = ", "rate = ")
        lines.append(f"{swap.get(key, key)}{equals}{value}")
    return "\n".join(lines)


def computed(source, *asked):
    """Return what generated code computes for a variant: the table, what is asked for, and a loop."""
    run = coursework.solve(parse_variant(source, "names"), quantities=["points", *asked])
    scene = run.scene
    return np.hstack([run.columns()[1].ravel(), trace(SCHEMES["rk4"], scene.rates, scene.start, run.step, range(4), 2).ravel()])


MEANT = {asked: computed(PLAIN, *asked) for asked in ((), ("accelerations",))}


def test_the_plain_variant_moves():
    assert np.all(np.ptp(coursework.solve(parse_variant(PLAIN, "names")).motion.rows, axis=0) > 1e-4)


def admitted(name):
    return bool(re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,39}", name)) and name not in {*FUNCTION_WORDS, "t", "pi"}


# What Python, its builtins, `math`, NumPy and SymPy's namespace of one letter call theirs.
WORDS = sorted(filter(admitted, {*keyword.kwlist, *keyword.softkwlist, *dir(builtins), *dir(math), *"SNQIECO"}))
ARRAYS = sorted(filter(admitted, {*dir(np), *dir(np.linalg)} - set(WORDS)))


def dealt(names):
    """Deal names out to the roles, a hand a variant; the last hand is filled up with plain names."""
    scalars = [role for role in ROLES if role not in {"link", "constraint"}]
    for first in range(0, len(names), len(scalars)):
        hand = dict(zip(scalars, names[first : first + len(scalars)], strict=False))
        yield {**hand, "link": names[first], "constraint": names[first]}


def same(names, *asked):
    """Raise where a variant with other names gives other numbers; what an acceleration is called is no name."""
    velocities = {names.get(role, role) for role in ("drive", "rate", "unknown")}
    if not velocities & {name[1:] for name in names.values() if name[0] == "d"}:
        assert np.max(np.abs(computed(renamed(names), *asked) - MEANT[asked])) < 1e-12, names


@pytest.mark.long
@pytest.mark.parametrize("turn", sample.first(3, range(len(ROLES) - 2)))
def test_every_word_of_python_in_every_role(turn):
    for hand in dealt(WORDS[turn:] + WORDS[:turn]):
        same(hand)


@pytest.mark.long
def test_every_name_of_numpy():
    for hand in dealt(ARRAYS):
        same(hand)


# Pairs of which one could become the other: by an underscore added, by joining two names, by a prefix of the tool's own.
ALIKE = [("e", "e_"), ("v_x", "x"), ("k0", "d3_7")]


def spread(roles):
    """Yield hands in which every alike pair has two roles of its own; over all hands each has every two roles in either order."""
    count = len(roles)
    for first, gap in itertools.product(range(count), range(1, count)):
        places: list[tuple[int, int]] = []
        for shift in range(count):
            pair = first + shift, first + shift + gap
            if len(places) < len(ALIKE) and not {place % count for place in pair} & set(itertools.chain(*places)):
                places.append((pair[0] % count, pair[1] % count))
        yield {
            roles[place]: name for pair, alike in zip(places, ALIKE, strict=True) for place, name in zip(pair, alike, strict=True)
        }


@pytest.mark.long
def test_every_pair_of_roles():
    hands = list(spread(ROLES[:-2]))
    for first, second in ALIKE:
        held = {tuple(role for name in (first, second) for role in hand if hand[role] == name) for hand in hands}
        assert held == set(itertools.permutations(ROLES[:-2], 2))
    for hand in hands:
        same(hand, "accelerations")


@pytest.mark.long
def test_link_and_constraint_are_apart_from_all_others():
    for role, other in itertools.product(ROLES[:-2], ROLES[-2:]):
        same({role: "e", other: "e"})


def test_derivatives_of_names_that_join_to_the_same_word():
    """∂k/∂x_y and ∂k_x/∂y, each beside a datum with the name that both would have."""
    names = {"law": "k", "other": "k_x", "angle": "x_y", "other_angle": "y", "datum": "k_x_y", "speed": "k_x_y_"}
    same(names, "accelerations")
    run = coursework.solve(parse_variant(renamed(names), "names"), quantities=["accelerations"])
    run.columns()
    meant = {"∂k/∂x_y": ("k", "x_y"), "∂k_x/∂y": ("k_x", "y")}
    assert run.scene.equations.symbols.derivatives_among([*meant, "k", "k_x_y"]) == meant
    shown = {text(Formula("name", name=name)) for name in [*meant, "k_x_y", "k_x_y_"]}
    assert len(shown) == len(meant) + 2


def test_a_component_of_a_loop_has_a_name_that_the_file_gave_to_no_equation():
    """The loop 3 is 3x and 3y: beside an equation called 3x a motion was told as singular at its start."""
    for second, names in (("3", ["3x", "3", "3'x", "3'y"]), ("3x", ["3x", "3x'", "3x''", "3y"])):
        text = mechanism("pantograph", ('name     = "1"', 'name = "3x"'), ('name     = "2"', f'name = "{second}"'))
        assert [one.name for one in coursework.solve(parse_variant(text)).scene.equations.equations] == names


def test_private_names_are_one_to_one_and_read_back():
    declared = ["t", "d3_7", "v_x", "x", "a_x", "k0", "_".join("ab"), "e", "e_", "lambda"]
    made = {name: private_names.private(name) for name in declared}
    slopes = {(a, b): private_names.derivative(made[a], made[b], declared) for a in declared[1:] for b in declared}
    second = {(a, b): private_names.derivative(slopes["x", a], made[b], declared) for a in declared for b in declared}
    everything = [*made.values(), *slopes.values(), *second.values(), *map(private_names.acceleration, declared)]
    assert len(set(everything)) == len(everything)
    assert all(name.isidentifier() and not keyword.iskeyword(name) for name in everything)
    assert [private_names.public(name, declared) for name in made.values()] == declared
    assert {private_names.public(name, declared) for name in slopes.values()} == {f"∂{a}/∂{b}" for a, b in slopes}
