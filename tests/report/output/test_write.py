"""Whole files or none."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from types import ModuleType

import pytest

import coursework
from coursework import write_report
from coursework.words.errors import OutputError


def test_suffix_decides(tmp_path: Path) -> None:
    run = coursework.solve("31", quantities=["table"])
    write_report(run, tmp_path / "a.html", tmp_path / "deep" / "b.PDF")
    assert (tmp_path / "a.html").read_bytes().startswith(b"<!DOCTYPE html>")
    assert (tmp_path / "deep" / "b.PDF").read_bytes().startswith(b"%PDF-")
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["a.html", "b.PDF", "deep"]


def test_another_suffix_is_refused_before_anything_is_written(real: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"end in \.html or \.pdf \(found \.docx\)"):
        write_report(real.full(), tmp_path / "a.html", tmp_path / "a.docx")
    assert not list(tmp_path.iterdir())


def test_a_full_disk_leaves_the_old_file_and_nothing_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "a.html"
    target.write_text("before")

    def full(_: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OutputError, match=r"the disk is full\. Free some space"):
        write_report(coursework.solve("31", quantities=["table"]), target)
    assert [path.name for path in tmp_path.iterdir()] == ["a.html"]
    assert target.read_text() == "before"


def test_a_folder_that_is_a_file(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(OutputError, match="is a file, not a folder"):
        write_report(coursework.solve("31", quantities=["table"]), tmp_path / "file" / "a.html")
