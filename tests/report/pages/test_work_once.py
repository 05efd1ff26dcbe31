"""What a page needs several times is made once: counted over one page of variant 31."""

import pytest

import coursework
from coursework.motion.geometry.drives import drive
from coursework.motion.integration import loops
from coursework.report.graphs import accuracy_figures
from coursework.report.output.results import Results
from coursework.report.text import text_runs
from coursework.variant.reading.set_values import with_set


@pytest.fixture(scope="module")
def counted():
    """How often was called, for a page, what is named here; and how many sentences a page of other data has beside it."""
    counts = {}

    def count(patch, place, name):
        function = getattr(place, name)

        def called(*values, **named):
            counts[name] = counts.get(name, 0) + 1
            return function(*values, **named)

        patch.setattr(place, name, called)

    with pytest.MonkeyPatch.context() as patch:
        for place, name in ((drive, "_resolution"), (loops, "build"), (accuracy_figures, "_covered")):
            count(patch, place, name)
        run = coursework.solve("31")
        text_runs._split.cache_clear()
        results = Results(run)
        results.compute(pages=True)
        assert results.model.sections
        found = counts | {"sentences": text_runs._split.cache_info().misses}
        results = Results(coursework.solve(with_set(coursework.load("31"), ("r1=0.951m",), None)))
        results.compute(pages=True)
        assert results.model.sections
        found["new sentences"] = text_runs._split.cache_info().misses - found["sentences"]
    return found


@pytest.mark.long
def test_a_drive_is_resolved_once_for_each_length_of_time(counted):
    """Of the structure, of the run, of its period and a little beyond its end: rows counted otherwise end at the same time."""
    assert counted["_resolution"] <= 4


def test_the_loop_of_a_scheme_is_built_once_for_some_rates(counted):
    """The six schemes of the study, for the rates of the run, and the loops with all rows of its tables."""
    assert counted["build"] <= 12


def test_names_of_the_accuracy_figure_are_weighed_at_few_places(counted):
    """At 107 places each, they would be a thousand."""
    assert counted["_covered"] <= 300


def test_sentences_without_a_number_that_changed_are_split_once(counted):
    assert counted["new sentences"] < 0.5 * counted["sentences"]
