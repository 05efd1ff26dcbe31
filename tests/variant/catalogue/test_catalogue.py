"""Every file of the catalogue: complete, possible over its whole run, and its lesson true."""

import numpy as np
import pytest

import coursework
from coursework.variant.catalogue import entries, names
from tests.solved import solved

VARIANTS = names()


def test_the_catalogue_holds_the_sources_and_a_course_more():
    from_sources = {"31", "v101", "v102", "v104", "v105", "v107", "v108", "v110", "v112", "homework", "prp", "variable-crank"}
    from_sources |= {f"example-{n}" for n in range(1, 7)}
    assert from_sources <= set(VARIANTS)
    assert len(set(VARIANTS) - from_sources) >= 8


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.name)
def test_title_source_and_lesson(entry):
    assert entry.title
    assert entry.source
    assert entry.teaches


@pytest.mark.parametrize("name", VARIANTS)
def test_runs_to_its_end_and_passes_its_checks(name):
    run = solved(name, quantities=["table", "checks"])
    assert run.stop is None, run.stop
    assert [check for check in run.checks if check.verdict in {"FAIL", "ERROR"}] == []
    assert np.all(np.isfinite(run.columns()[1]))


@pytest.mark.parametrize("name", VARIANTS)
def test_what_the_file_asks_for_can_be_computed(name):
    run = solved(name)
    columns, rows = run.columns()
    assert rows.shape == (len(run.motion.t), len(columns))
    for table in run.extra_tables.values():
        assert np.all(np.isfinite(table.rows))


@pytest.mark.parametrize("name", VARIANTS)
def test_no_determinant_changes_sign(name):
    run = solved(name, quantities=["table"])
    for motion in (run.motion, run.exact):
        assert np.all(np.sign(motion.determinants) == np.sign(motion.determinants[0]))


@pytest.mark.parametrize("name", VARIANTS)
def test_as_many_freedoms_as_drives(name):
    variant = coursework.load(name)
    mobility = coursework.solve(variant, quantities=["table"]).scene.mechanism.mobility
    drives = (2 if variant.driven else 0) + len(variant.known_rates)
    assert mobility is None or mobility.degrees == drives
