"""Where temporary files lie while a set of files is written, and what is as before once it is."""

import errno
import os
import tempfile

import pytest

from coursework.system.files import file_set, whole_files
from coursework.system.files.file_set import MATPLOTLIB, scratch_in
from coursework.system.files.whole_files import write_bytes
from coursework.words.errors import OutputError


@pytest.mark.parametrize(("named", "writable", "inside"), [
    (None, True, None), (None, False, "scratch"), ("theirs", True, "theirs"), ("theirs", False, "theirs"),
])  # fmt: skip
@pytest.mark.parametrize("tempdir", [None, "/elsewhere"])
def test_scratch_lies_in_the_folder_and_matplotlibs_settings_where_they_have_no_place(
    tmp_path, monkeypatch, named, writable, inside, tempdir
):
    monkeypatch.setattr(tempfile, "tempdir", tempdir)
    monkeypatch.setattr(file_set, "_is_writable", lambda folder: writable)
    monkeypatch.delenv(MATPLOTLIB, raising=False)
    if named:
        monkeypatch.setenv(MATPLOTLIB, named)
    with scratch_in(tmp_path):
        assert tempfile.tempdir == str(tmp_path)
        assert os.environ.get(MATPLOTLIB) == (str(tmp_path) if inside == "scratch" else inside)
    assert tempfile.tempdir == tempdir
    assert os.environ.get(MATPLOTLIB) == named


def test_a_file_is_written_whole_with_its_folders_and_leaves_nothing_beside_it(tmp_path, monkeypatch):
    place = tmp_path / "a" / "b" / "c.txt"
    for content in (b"one", b"two"):
        write_bytes(place, content)
        assert [(one.name, one.read_bytes()) for one in place.parent.iterdir()] == [("c.txt", content)]

    def full(path, content):
        path.write_bytes(content[:2])
        raise OSError(errno.ENOSPC, "")

    monkeypatch.setattr(whole_files, "write_through", full)
    with pytest.raises(OutputError):
        write_bytes(place, b"three")
    assert [(one.name, one.read_bytes()) for one in place.parent.iterdir()] == [("c.txt", b"two")]
