"""What the command line leaves behind: every digit, the same bytes always, and nothing half-written where the disk says no."""

import csv
import errno
import json
import os
from pathlib import Path

import pytest

import coursework
from coursework.system.files import whole_files
from tests.commands.test_cli import QUICK, call, process

pytestmark = pytest.mark.usefixtures("folder")


def test_table_has_the_columns_of_the_file_and_every_digit():
    assert call("run", "31", "--quantities", "table", "--format", "csv").exit_code == 0
    with Path("coursework-31/table.csv").open(encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    assert head == ["t", "phi1", "phi2", "phi3", "w1", "w2", "w3", "w4"]
    motion = coursework.solve("31", quantities=["table"]).motion
    assert [float(row[0]) for row in rows] == motion.t.tolist()
    assert [[float(cell) for cell in row[1:]] for row in rows] == motion.rows.tolist()


PARTS = ("x", "y", "vx", "vy")


@pytest.mark.parametrize(
    ("quantities", "more"),
    [
        ("accelerations", ["dw1", "dw2", "dw3", "dw4"]),
        ("points", [f"{point}.{part}" for point in "DABMCP" for part in PARTS]),
        (
            "points,accelerations",
            ["dw1", "dw2", "dw3", "dw4", *(f"{q}.{part}" for q in "DABMCP" for part in (*PARTS, "ax", "ay"))],
        ),
    ],
)
def test_what_is_asked_for_stands_behind_the_columns(quantities, more):
    assert call("run", "31", "--quantities", quantities, "--format", "csv").exit_code == 0
    head = Path("coursework-31/table.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    assert head == ["t", "phi1", "phi2", "phi3", "w1", "w2", "w3", "w4", *more]


def test_a_column_alone():
    assert call("run", "31", "--quantities", "phi3", "--format", "csv").exit_code == 0
    assert Path("coursework-31/table.csv").read_text(encoding="utf-8").splitlines()[0] == "t,phi3,w3"


def test_analogs_and_invariants_have_files_of_their_own():
    result = call("run", "example-2", "--quantities", "table,analogs,invariants", "--format", "csv")
    assert result.stdout.endswith("table.csv, table-euler.csv, analogs.csv, invariants.csv, run.json\n")
    assert Path("coursework-example-2/invariants.csv").read_text(encoding="utf-8").startswith("k,a_k,b_k,c_k\n")
    assert len(Path("coursework-example-2/analogs.csv").read_text(encoding="utf-8").splitlines()) == 38


def test_the_record_says_how_the_numbers_came_about():
    call("run", "31", "--scheme", "rk4", "--step", "0.01", "--out", "here/and/there", *QUICK)
    record = json.loads(Path("here/and/there/run.json").read_text(encoding="utf-8"))
    assert {
        "variant",
        "title",
        "versions",
        "scheme",
        "step",
        "end",
        "rows",
        "evaluations",
        "quantities",
        "stop",
        "checks",
    } <= set(record)
    assert (record["variant"], record["scheme"], record["step"], record["end"]) == ("31", "rk4", 0.01, 0.48)
    assert (record["rows"], record["evaluations"], record["stop"]) == (49, 192, None)
    assert record["versions"]["coursework"] == coursework.__version__
    run = coursework.solve("31", "rk4", step=0.01, quantities=["table", "checks"])
    assert [check["code"] for check in record["checks"]] == [check.code for check in run.checks]
    for check, found in zip(run.checks, record["checks"], strict=True):
        keys = ["code", "group", "verdict", "value", "unit", "limit", "column", "row", "sentence"]
        assert [key for key in found if key not in {"step", "first", "last"}] == keys
        assert ("first" in found) == ("last" in found) == (check.code in {"PERIOD-POSITION", "PERIOD-VELOCITY"})
        assert (found["verdict"], found["sentence"]) == (check.verdict, check.sentence)


def test_html_and_pdf(folder):
    result = call("run", "31", "--student", "A. Student", "--group", "ME-21", "--date", "2 May", "--out", "o")
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in (folder / "o").iterdir()) == ["report.html", "report.pdf", "run.json", "table.csv"]
    page = Path("o/report.html").read_text(encoding="utf-8")
    assert all(word in page for word in ("A. Student", "ME-21", "2 May"))
    assert Path("o/report.pdf").read_bytes().startswith(b"%PDF-")


def test_the_same_bytes_in_every_process(folder):
    """A process of its own with one seed of hashes, and this one, which has another and has run other tests before."""
    arguments = ("run", "31", "--student", "O. K.")
    done = process(*arguments, "--out", "o1", PYTHONHASHSEED="1" if os.environ.get("PYTHONHASHSEED") != "1" else "2")
    here = call(*arguments, "--out", "o2")
    assert (done.returncode, here.exit_code) == (0, 0), done.stderr
    assert done.stdout.decode().replace("\r\n", "\n").replace("o1", "o") == here.stdout.replace("o2", "o")
    for name in ("table.csv", "run.json", "report.html", "report.pdf"):
        assert (folder / "o1" / name).read_bytes() == (folder / "o2" / name).read_bytes(), name


# ---- what cannot be written


def test_a_folder_below_a_file():
    Path("file").write_text("mine", encoding="utf-8")
    result = call("run", "31", "--out", "file/results", *QUICK)
    assert result.exit_code == 2
    assert "could not be written: a part of the path is a file, not a folder. Choose another folder with --out." in result.stderr
    assert Path("file").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize(
    ("number", "sentence"),
    [
        (errno.ENOSPC, "the disk is full. Free some space, or choose another folder with --out."),
        (errno.EDQUOT, "your share of the disk is used up."),
        (errno.EACCES, "the folder or file is not writable. Close it in other programs, or choose another folder with --out."),
        (errno.EROFS, "the disk is read-only. Choose another folder with --out."),
        (errno.EIO, f"{os.strerror(errno.EIO)}. Choose another folder with --out."),
    ],
)
@pytest.mark.parametrize("moment", ["fsync", "replace", "mkdir"])
def test_a_disk_that_says_no_leaves_what_was_there(moment, number, sentence, folder, monkeypatch):
    (folder / "o").mkdir()
    (folder / "o" / "table.csv").write_text("before", encoding="utf-8")

    def refuse(*_args, **_options):
        raise OSError(number, os.strerror(number))

    with monkeypatch.context() as patch:
        patch.setattr(
            *{"fsync": (whole_files.os, "fsync"), "replace": (Path, "replace"), "mkdir": (Path, "mkdir")}[moment], refuse
        )
        result = call("run", "31", "--out", "o", *QUICK)
    assert result.exit_code == 2
    refused = Path("o") if moment == "mkdir" else Path("o", "table.csv")
    assert result.stderr[5:].startswith(f"{refused}  could not be written: {sentence}")
    assert [path.name for path in (folder / "o").iterdir()] == ["table.csv"]
    assert (folder / "o" / "table.csv").read_text(encoding="utf-8") == "before"


def test_an_interrupt_leaves_nothing_half_written(folder, monkeypatch):
    def interrupt(_number):
        raise KeyboardInterrupt

    monkeypatch.setattr(whole_files.os, "fsync", interrupt)
    with pytest.raises(KeyboardInterrupt):
        whole_files.write_bytes(folder / "table.csv", b"x")
    assert list(folder.iterdir()) == []
