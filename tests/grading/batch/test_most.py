"""How many processes grade at once, and up to how many variants the tables of a class are compared."""

import os
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.grading.batch.class_list import class_tables
from coursework.grading.batch.gradebook import Options
from coursework.grading.marking.key import key


@pytest.mark.parametrize(("cores", "jobs", "processes"), [(None, 0, 1), (4, 0, 4), (8, 0, 8), (64, 0, 8), (64, 12, 12)])
def test_as_many_processes_as_cores_up_to_eight_or_as_asked(monkeypatch, cores, jobs, processes):
    monkeypatch.setattr(os, "cpu_count", lambda: cores)
    assert Options(jobs).processes == processes


@pytest.mark.parametrize(("variants", "compared"), [(0, 0), (1, 0), (2, 2), (500, 500), (501, 0)])
def test_tables_of_two_to_five_hundred_variants_are_compared(monkeypatch, variants, compared):
    monkeypatch.setattr(key, "tables_of", lambda given: dict.fromkeys(given, np.zeros((1, 1))))
    assert len(class_tables(dict.fromkeys(map(str, range(variants)), SimpleNamespace()))) == compared
