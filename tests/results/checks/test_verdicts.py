"""Verdicts against an independent comparison with the true motion, and every advised step run: a short form of verdicts.py."""

import pytest

import coursework
from tests.results.checks.independent import judge
from tests.results.checks.verdicts import contradictions, random_variants, unkept

SOME = ("31", "stephenson", "example-6", "variable-crank", "v105", "engine-start")


@pytest.mark.long
@pytest.mark.parametrize("name", SOME)
@pytest.mark.parametrize(("scheme", "factor"), [("euler", 1.0), ("heun", 3.0)])
def test_no_verdict_is_contradicted_and_every_advised_step_keeps_its_word(name, scheme, factor):
    variant = coursework.load(name)
    run = coursework.solve(variant, scheme, step=factor * variant.time.step, quantities=["table", "checks"])
    assert contradictions(run, judge(run)) == []
    assert unkept(run, variant, scheme) == []


@pytest.mark.long
def test_random_variants():
    judged = coarse = 0
    for run in random_variants(10, seed=7):
        judged += 1
        coarse += any(finding.step is not None for finding in run.checks)
        assert contradictions(run, judge(run)) == [], run.variant.title
        assert unkept(run, run.variant, run.scheme) == [], run.variant.title
    assert judged == 10
    assert coarse >= 1


@pytest.mark.parametrize(
    ("name", "told"), [("example-4", "differs most, by 1e-07 m beside 1.07703 m,"), ("whitworth", "0.0866025 m and 0.086602 m,")]
)
def test_numbers_that_read_alike_are_not_told_as_two_that_differ(name, told):
    run = coursework.solve(name, scheme="rk4", quantities=["table", "checks"])
    assert told in next(one.sentence for one in run.checks if one.code == "PERIOD-POSITION")
