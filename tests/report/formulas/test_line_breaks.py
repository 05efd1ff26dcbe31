"""Where a long product with a sum at its end is parted into the terms of that sum."""

import pytest

from coursework.report.formulas.svg import LONG, _opened

END = "e sin phi_2 " + "a" * LONG


@pytest.mark.parametrize(
    ("piece", "parts"),
    [
        (f"g (a - b (c + d) + {END})", ["g \\(a", " - b (c + d)", f" + {END}\\)"]),
        (f"g (a - b) (c + {END})", [f"g (a - b) (c + {END})"]),  # the parenthesis at the end is another one
        ("g (a - b)", ["g (a - b)"]),
    ],
)
def test_a_sum_in_parentheses_of_its_own_is_parted_at_its_signs(piece, parts):
    assert [*map(str.rstrip, _opened(piece))] == parts
