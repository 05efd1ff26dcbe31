"""Rows and columns of a matrix are brought to one size, so that small units beside large ones are no bad condition."""

from __future__ import annotations

import numpy as np
import pytest

from coursework.results.checks.computed_right.conditioning import equilibrated


@pytest.mark.parametrize("sizes", [(1e-6, 1.0), (1.0, 1e6), (1e-3, 0.5), (2.0, 3.0)])
def test_lengths_of_any_size_make_the_same_matrix(sizes: tuple[float, float]) -> None:
    """Micrometres beside metres: each row is multiplied by its size, each column divided by it."""
    plain = np.array([[1.0, 0.5], [-0.5, 1.0]])
    matrix = np.array(sizes)[:, None] * plain / np.array(sizes[::-1])
    assert equilibrated(matrix[None], np.abs(matrix))[0] == pytest.approx(plain, rel=1e-3)


def test_a_row_that_vanishes_stays_zero() -> None:
    matrix = np.array([[0.0, 0.0], [4.0, 4.0]])
    assert equilibrated(matrix[None], matrix)[0].tolist() == [[0.0, 0.0], pytest.approx([1.0, 1.0])]
    assert equilibrated(np.array([[[1.0, 1.0], [2.0, 2.0]]]), np.array([[2.0, 2.0], [2.0, 2.0]]))[0] == pytest.approx(
        np.array([[0.5, 0.5], [1.0, 1.0]])
    )  # by what the entries can be, not by what they are
