"""Where temporary files lie while a set of files is written, and what is as before once it is."""

import os
import tempfile

import pytest

from coursework.system.files import file_set
from coursework.system.files.file_set import MATPLOTLIB, scratch_in


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
