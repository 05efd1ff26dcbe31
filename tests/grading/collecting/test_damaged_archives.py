"""A damaged part of an archive of a class costs only the student whose it is."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest

from tests.grading.collecting.test_sources import read


@pytest.mark.parametrize("packing", [zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_a_damaged_part_is_one_students_however_it_is_packed(tmp_path: Path, packing: int) -> None:
    content, table = io.BytesIO(), bytes(range(256)) * 4
    with zipfile.ZipFile(content, "w", packing) as file:
        file.writestr("ivanov/table.csv", table)
        file.writestr("petrov/table.csv", table)
    (tmp_path / "class.zip").write_bytes(content.getvalue()[:60] + b"\xff" * 9 + content.getvalue()[69:])
    _, found, _ = read(tmp_path / "class.zip")
    assert [each.files[0].content == table for each in found.values()] == [False, True]
    assert str(found["ivanov"].files[0].trouble).startswith("The file is damaged")
