"""A program of more operations than any mechanism needs is refused while it is made, not after."""

import pytest

from coursework.equations.codegen.straight_line import MOST_OPERATIONS, FormulaRefused, StraightLine
from coursework.equations.reduction.symbolic import local


def chain(count: int) -> StraightLine:
    """Return the lines of x + 1, (x + 1)*x, … : as many different operations as asked for."""
    x = local("v_x")
    lines = StraightLine((), {}, set())
    lines.add([local(f"v_y{0}")], [x])
    made = len(lines._forms)
    for number in range(count - made + 1):
        lines._number("sin" if number % 2 else "cos", made + number - 1)
    return lines


def test_twenty_thousand_operations_are_printed_and_one_more_is_refused():
    assert len(chain(MOST_OPERATIONS)._forms) == MOST_OPERATIONS + 1
    with pytest.raises(FormulaRefused, match="lead to more than 20000 operations"):
        chain(MOST_OPERATIONS + 1)
