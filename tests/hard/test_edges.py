"""Four hundred scenes at the edge of doubles, drawn at random, against their true motion: nothing that passes is wrong.

A part runs always; `python3 -m coursework.bootstrap test --long tests/hard/test_edges.py` runs them all, some minutes.
"""

import re

import pytest

from tests.hard.edges import HOLDS, drawn
from tests.hard.judge import judged
from tests.hard.more_edges import drawn as drawn_more
from tests.hard.scenes import ROOT
from tests.sample import first


@pytest.mark.parametrize("seed", first(5, range(1000, 1012)))
def test_nothing_that_passes_is_wrong(seed, draw=drawn):
    edge = draw(seed)
    wrong, told, spent = judged(edge)
    assert not wrong, (edge.told, wrong, told, spent, edge.text)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(1000, 1012))
def test_nothing_that_passes_is_wrong_in_more_families(seed):
    test_nothing_that_passes_is_wrong(seed, drawn_more)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(300))
def test_nothing_that_passes_is_wrong_in_three_hundred(seed):
    test_nothing_that_passes_is_wrong(seed)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(120))
def test_nothing_that_passes_is_wrong_in_a_hundred_and_twenty_more(seed):
    test_nothing_that_passes_is_wrong(seed, drawn_more)


def test_readme_says_down_to_which_distance_what_holds():
    """Its table has the limits that the judge goes by, and the scenes are drawn up to them and beyond."""
    table = (ROOT / "README.md").read_text(encoding="utf-8").partition("| hard case (`tests/hard/test_edges.py`")[2]
    rows = re.findall(r"^\| (\w+)[^|]*\| ([\d.e+-]+)[^|]*\| [^|]+\|$", table.partition("\n\n")[0], re.M)
    assert {word: float(limit) for word, limit in rows} == HOLDS
    scenes = [drawn(seed) for seed in range(300)]
    told = {family: [edge.told for edge in scenes if edge.family == family] for family in ("quick", "turns", "far")}
    assert min(float(one.split()[-1]) for one in told["quick"]) <= 2 * HOLDS["a"]
    assert max(float(one.split()[0]) for one in told["turns"]) > HOLDS["turns"] / 2
    assert max(float(one.split()[1]) for one in told["far"]) > 10 * HOLDS["lengths"]
    assert min(abs(edge.apart) for edge in scenes if edge.family == "dead") < HOLDS["passing"] / 10
