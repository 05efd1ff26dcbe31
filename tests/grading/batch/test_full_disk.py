"""A journal on a full disk: nothing that is half written is taken for written, and what was written stays."""

from __future__ import annotations

import errno
from contextlib import nullcontext
from pathlib import Path

import pytest

from coursework.grading.batch.journal import Entry, Journal
from coursework.words.errors import OutputError


class _Full:
    """A file on a disk that has room for a few more bytes: the first write is short, the next one fails."""

    def __init__(self, room: int) -> None:
        self.room = room

    def write(self, content: bytes) -> int:
        if not self.room:
            raise OSError(errno.ENOSPC, "")
        written, self.room = min(self.room, len(content)), max(self.room - len(content), 0)
        return written

    def seek(self, *_: int) -> int:
        return 0

    tell = seek

    def close(self) -> None:
        """Nothing is open."""


def test_a_grade_of_which_a_full_disk_took_the_beginning_is_not_taken_for_written(tmp_path, monkeypatch):
    whole = Entry("k1", "a", {"status": "graded"})
    for room, is_refused in ((20, True), (10_000, False)):
        with monkeypatch.context() as full:
            full.setattr(Path, "open", lambda *_, room=room, **__: _Full(room))
            with Journal(tmp_path) as journal, pytest.raises(OutputError) if is_refused else nullcontext():
                journal.add(whole)


def test_a_journal_that_there_is_no_room_to_tidy_stays_as_it_is(tmp_path, monkeypatch):
    with Journal(tmp_path) as journal:
        place = journal.add(Entry("k1", "a", {"status": "graded"}))
        before = journal.path.read_bytes()
        with monkeypatch.context() as full:
            full.setattr(Path, "open", lambda *_, **__: nullcontext(_Full(20)))
            with pytest.raises(OutputError) as refused:
                journal.rewrite([place, place])
        assert (refused.value.faults[0].code, journal.path.read_bytes()) == ("W001", before)
        journal.rewrite([place])
    assert [path.name for path in tmp_path.iterdir()] == ["journal.jsonl"]
    assert (tmp_path / "journal.jsonl").read_bytes() == before


def test_a_line_torn_off_by_a_crash_spoils_none_behind_it(tmp_path):
    (tmp_path / "journal.jsonl").write_bytes(b'{"sum": "half of a li')
    with Journal(tmp_path) as journal:
        place = journal.add(Entry("k1", "a", {"status": "graded", "score": 1.0}))
        assert (journal.places()[0], journal.read(place).id) == ({"k1": place}, "a")


def test_a_line_that_was_changed_meanwhile_is_not_taken_for_a_grade(tmp_path):
    with Journal(tmp_path) as journal:
        place = journal.add(Entry("k1", "a", {"status": "graded"}))
        assert journal.read(place).id == "a"
        journal.path.write_bytes(journal.path.read_bytes().replace(b"graded", b"graced"))
        with pytest.raises(RuntimeError, match="the line at 0 was changed"):
            journal.read(place)
