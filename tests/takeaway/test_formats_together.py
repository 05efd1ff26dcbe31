"""Every format in one run, each process as a user starts it: the same bytes, all of them in run.json; what is missing is told."""

import hashlib
import json
import os
import subprocess
import sys

import pytest

ALL = "xlsx,docx,odt,tex,figures,dxf,csv"
WITHOUT = "import sys; sys.modules.update(dict.fromkeys({missing})); from coursework.commands.cli import main; main({words})"


def run(folder, *, missing=(), **environment):
    """Every format into a folder; returns status, what standard error says, and the files."""
    code = WITHOUT.format(missing=missing, words=["run", "31", "--format", ALL, "--out", str(folder)])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=os.environ | environment)
    files = {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    return done.returncode, done.stderr, files


@pytest.mark.long
def test_the_same_bytes_in_every_process_and_all_in_the_record(tmp_path):
    first = run(tmp_path / "a", TZ="UTC", PYTHONHASHSEED="1")
    assert first == run(tmp_path / "b", TZ="Asia/Irkutsk", PYTHONHASHSEED="2") and first[:2] == (0, "")
    files = first[2]
    listed = json.loads(files.pop("run.json"))["files"]
    assert listed == {name: hashlib.sha256(content).hexdigest() for name, content in files.items()}
    assert {"report.xlsx", "report.docx", "report.odt", "report.tex", "table.csv", "figures/mechanism.svg"} <= set(listed)
    assert "dxf/mechanism.dxf" in listed


@pytest.mark.long
def test_what_has_no_package_is_told_in_a_line_each_and_the_rest_is_written(tmp_path):
    status, told, files = run(tmp_path, missing=["xlsxwriter", "pypandoc", "ezdxf"])
    lines = told.splitlines()
    assert status == 2 and [line.split()[3] for line in lines] == ["xlsx", "docx", "odt", "tex", "dxf"]
    extras = ["workbook", "note", "note", "note", "dxf"]
    assert all(f'[{extra}]"' in line for extra, line in zip(extras, lines, strict=True))
    assert {name.partition("/")[0] for name in files} == {"figures", "table.csv", "run.json"}
    assert set(json.loads(files.pop("run.json"))["files"]) == set(files)
