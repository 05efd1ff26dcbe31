"""A class with its truth: right work earns all in every notation and file, each sentence is so, causes are named."""

from __future__ import annotations

import pytest

from tests.grading.whole_class.graded import Seen, graded
from tests.grading.whole_class.pupils import Pupil, machine, pupils
from tests.grading.whole_class.truths import false_sentences

SAMPLE, WHOLE = 40, 300
SEED = 118  # by which every kind of work is in the sample
QUESTIONS = 0.02  # of the right works


@pytest.fixture(
    scope="module",
    params=[pytest.param((SAMPLE, True), id="sample"), pytest.param((WHOLE, False), id="whole", marks=pytest.mark.long)],
)
def school(request, tmp_path_factory):
    """The class, what was said of everybody, and where the variants stand."""
    count, is_cheap = request.param
    folder = tmp_path_factory.mktemp("class")
    everybody = pupils(count, folder, SEED, cheap=is_cheap)
    return everybody, graded(everybody, folder), folder


def _of_kind(school, *kinds: str) -> list[tuple[Pupil, Seen]]:
    found = [(pupil, school[1][pupil.id]) for pupil in school[0] if pupil.truth.kind in kinds]
    assert found
    return found


def test_right_work_earns_all_in_every_notation_and_kind_of_file(school):
    right = _of_kind(school, "right")
    less = {(pupil.notation, pupil.kind): seen.row["status"] for pupil, seen in right if seen.row["points"] != "100.00"}
    assert set(less.values()) <= {"needs-review"}, less
    assert len(less) <= QUESTIONS * len(right), less


@pytest.mark.long
def test_no_sentence_is_false(school):
    everybody, seen, folder = school
    false = {
        (pupil.mechanism, pupil.notation, pupil.kind, pupil.truth.kind, pupil.truth.code): told
        for pupil in everybody
        if (told := false_sentences(pupil, seen[pupil.id], machine(pupil.mechanism, pupil.number, folder)))
    }
    assert not false


def test_the_first_wrong_cell_is_the_one_that_was_changed(school):
    for pupil, seen in _of_kind(school, "slip", "mistyped"):
        row, place = min(pupil.truth.wrong)
        made = machine(pupil.mechanism, pupil.number, school[2])
        names = [*(c.name for c in made.variant.coordinates), *made.variant.columns[made.m :]]
        assert seen.row["first_wrong"] == f"row {row + 1} {names[place]}", (pupil.id, pupil.kind)
    for pupil, seen in _of_kind(school, "right", "sign", "rows missing"):
        assert seen.row["first_wrong"] == "", (pupil.id, pupil.kind)


def test_every_misconception_is_named_and_none_where_none_is(school):
    for pupil in school[0]:
        named = school[1][pupil.id].entry["misconception"]
        codes = {named["code"], *named["ties"]} if named else set()
        assert pupil.truth.code in codes if pupil.truth.code else not codes, (pupil.id, pupil.mechanism, pupil.truth.code, codes)


def test_nobody_reads_of_another(school):
    everybody, seen, _ = school
    names = {pupil.name.split()[1]: pupil.id for pupil in everybody}
    for pupil in everybody:
        assert not {other for name, other in names.items() if name in seen[pupil.id].raw or other in seen[pupil.id].raw} - {
            pupil.id
        }
