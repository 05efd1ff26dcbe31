"""Files spoilt at random: whatever is wrong with them is a fault of the file with a sentence, never a crash of the tool.

The same files every time; a new crash is looked for by hand, `python -m tests.variant.fuzz 100000`.
"""

import pytest

from tests.sample import first
from tests.variant.fuzz import TooLong, limited, most_held, spoilt, tried


@pytest.mark.parametrize(("begin", "read"), first(1, ((0, 60), (60, 150), (10_000, 150))))
def test_a_spoilt_file_is_computed_or_told(tmp_path, begin, read):
    before = most_held()  # other tests of this process may have held more than any file here
    *_, tally = tried(range(begin, begin + read), read // 6, 1, tmp_path)
    assert tally.failures == []
    assert tally.counts["read: done"] + tally.counts["read: refused"] == read
    assert tally.counts["computed"] == read // 6
    assert tally.counts["pages: done"] == 1
    assert tally.memory - before < 1024


def test_the_fuzz_finds_what_fails(tmp_path, monkeypatch):
    """A reader that crashes on some files, and one that never ends, are both told with their seeds."""
    calls = []

    def broken(path):
        calls.append(path)
        if len(calls) == 2:
            raise ZeroDivisionError("as planned")
        raise TooLong

    monkeypatch.setattr("tests.variant.fuzz.read_variant", broken)
    *_, tally = tried(range(3), 0, 0, tmp_path)
    assert [(seed, stage) for seed, stage, _ in tally.failures] == [(0, "read"), (1, "read"), (2, "read")]
    assert "ZeroDivisionError: as planned" in tally.failures[1][2]
    assert "took more than" in tally.failures[0][2]


def test_a_seed_makes_the_same_file_again():
    from random import Random

    text = 'a = "1 m"\nb = 2\n'
    assert [spoilt(text, Random(seed)) for seed in range(50)] == [spoilt(text, Random(seed)) for seed in range(50)]
    assert len({spoilt(text, Random(seed)) for seed in range(50)}) > 40


def test_work_that_never_ends_is_ended():
    with pytest.raises(TooLong), limited(0.2):
        while True:
            pass
