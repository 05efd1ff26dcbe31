"""Numbers as PMKS+ shares them: to the base 64, at most eight letters, negative behind a zero."""

import pytest

import coursework
from coursework.takeaway.foreign.pmks_plus import PROGRAM, _Shared


@pytest.mark.parametrize(("text", "number"), [
    ("0", 0), ("1", 1), ("A", 10), ("a", 36), ("-", 63), ("10", 64), ("--", 4095), ("01", -1), ("0--", -4095),
    ("10000000", 64**7), ("--------", 64**8 - 1), ("100000000", None), ("", None), ("1.0", None), ("é", None),
])  # fmt: skip
def test_a_number(text, number):
    if number is None:
        with pytest.raises(coursework.InputError, match="C094"):
            _Shared(PROGRAM).integer(text)
    else:
        assert _Shared(PROGRAM).integer(text) == number
