"""Written equations are compared with derived ones whatever their size, and whatever the sizes of their unknowns."""

from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.motion.geometry.judging import agreement

DERIVED = np.array([[1.0, 1.0, 2.0], [1.0, -1.0, 0.5]])  # rows (A | b)


@pytest.fixture
def confirmed(monkeypatch):
    """Return what is confirmed of one written row beside two derived ones."""

    def judge(derived, written):
        rows = np.vstack([derived, written])
        system = SimpleNamespace(matrices=lambda times, positions: (rows[None, :, :-1], rows[None, :, -1], None))
        monkeypatch.setattr(agreement, "compile_system", lambda *of: system)
        each = [SimpleNamespace(name=name, coefficients={"w": 1}, written=True, line=7) for name in ("d1", "d2", "11")]
        variant = SimpleNamespace(file="v.toml", drive=(), bindings=(), lines={("closure",): 5})
        equations = SimpleNamespace(from_closure=each[:2], equations=each[2:], bound=(), unknowns=("w1", "w2"), variant=variant)
        return agreement._judged(equations, np.zeros(1), np.zeros((1, 2))).agreed

    return judge


@pytest.mark.parametrize("row", [1e-14, 1e-6, 1.0, 1e6, 1e14], ids=lambda size: f"row {size:g}")
@pytest.mark.parametrize("column", [1e-12, 1e-5, 1.0, 1e5, 1e12], ids=lambda size: f"column {size:g}")
@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_wrong_entry_is_seen_and_a_right_one_confirmed_at_every_size(confirmed, row, column, place):
    sizes = np.ones(3)
    sizes[place] = column
    right = row * (DERIVED[0] + DERIVED[1] / 4)
    assert confirmed(DERIVED * sizes, right * sizes) == ("11",)
    wrong = right.copy()
    wrong[place] *= 1 + 1e-3
    with pytest.raises(coursework.InputError, match=r"V302 v\.toml:7  equation 11 contradicts"):
        confirmed(DERIVED * sizes, wrong * sizes)


@pytest.mark.parametrize(("part", "fits"), [(1e-9, True), (1e-7, False)])
def test_just_within_and_just_beyond_the_limit(confirmed, part, fits):
    written = DERIVED[0] * [1, 1, 1 + part]
    if fits:
        assert confirmed(DERIVED, written) == ("11",)
    else:
        with pytest.raises(coursework.InputError, match="V302"):
            confirmed(DERIVED, written)


def test_zero_rows_and_columns_divide_nothing(confirmed):
    derived = np.array([[1.0, 0.0, 2.0], [0.0, 0.0, 0.0]])
    assert confirmed(derived, derived[0]) == ("11",)
