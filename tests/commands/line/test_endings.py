"""How a command ends: interrupted, without a reader, on a full disk, in a home that cannot be written."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import coursework
from coursework.report.output.tables import table_csv

pytestmark = pytest.mark.usefixtures("folder")
CSV = ["--quantities", "table,checks", "--format", "csv"]
COMMAND = [sys.executable, "-m", "coursework"]
FULL = Path("/dev/full")


def started(*arguments, **options):
    return subprocess.Popen([*COMMAND, *arguments], stderr=subprocess.PIPE, **options)


def unheard(*arguments):
    """Return the status of a command whose reader has left before it says anything, and what stands on its standard error."""
    reading, writing = os.pipe()
    process = started(*arguments, stdout=writing)
    os.close(writing)
    os.close(reading)
    _, said = process.communicate()
    return process.returncode, said


@pytest.mark.parametrize(
    ("arguments", "status"),
    [
        (["run", "31", *CSV], 0),
        (["run", "stops.toml", *CSV], 1),
        (["run", "31", "--step", "auto", "--error", "0.01", *CSV], 0),
        (["variants"], 0),
        (["check", "31"], 0),
        (["--help"], 0),
        (["run", "nosuch"], 2),
    ],
)
def test_a_reader_that_leaves_changes_neither_status_nor_files(arguments, status, folder):
    page = (Path(__file__).parents[2] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
    (folder / "stops.toml").write_text(page.replace('"4.35 rad"', '"0.02 rad"'), encoding="utf-8")
    found, said = unheard(*arguments)
    assert found == status
    assert said.decode().startswith("C014 there is no variant") or said == b""
    if "csv" in arguments:
        name = arguments[1].removesuffix(".toml")
        assert sorted(path.name for path in (folder / f"coursework-{name}").iterdir()) == ["run.json", "table.csv"]


@pytest.mark.skipif(not FULL.exists(), reason="a device that is always full")
@pytest.mark.parametrize("arguments", [["run", "31", *CSV], ["variants"], ["check", "31"], ["--help"], ["--version"]])
def test_a_full_disk_behind_standard_output(arguments):
    with FULL.open("wb") as full:
        process = started(*arguments, stdout=full)
        _, said = process.communicate()
    assert (process.returncode, said.decode()) == (
        2,
        "standard output could not be written: the disk is full. Lead it elsewhere.\n",
    )


def test_without_any_standard_stream():
    code = "import os, runpy, sys; sys.stdout = sys.stderr = None; sys.argv = ['coursework', 'variants']\n"
    code += "runpy.run_module('coursework', run_name='__main__')"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, check=False).returncode == 0


@pytest.mark.skipif(not FULL.exists(), reason="a device that is always full")
def test_results_into_a_device():
    done = subprocess.run([*COMMAND, "run", "31", *CSV, "--out", str(FULL)], capture_output=True, check=False)
    assert done.returncode == 2
    assert done.stderr.decode() == (
        "W005 /dev/full  could not be written: a part of the path is a file, not a folder. Choose another folder with --out.\n"
    )


# As at a terminal, whatever these tests were started with: Python installs no handler where its parent ignored the signal.
HEARING = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
# The process interrupts itself, as a key does, at the moment that the n-th file is put down.
INTERRUPTED = """
import coursework.system.files.whole_files, signal
real, count = coursework.system.files.whole_files.os.fsync, []
def fsync(number):
    count.append(number)
    if len(count) == {at}:
        signal.raise_signal(signal.SIGINT)
    real(number)
coursework.system.files.whole_files.os.fsync = fsync
from coursework.commands.cli import main
main({arguments!r})
"""


@pytest.mark.parametrize("at", [1, 2])
def test_an_interrupt_ends_with_130_and_one_sentence(at, folder):
    code = HEARING + INTERRUPTED.format(at=at, arguments=["run", "31", *CSV, "--out", "o"])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, check=False)
    assert done.returncode == 130
    assert done.stderr.decode() == "Interrupted: nothing unfinished is left behind.\n"
    assert list(folder.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="an interrupt sent to another process is a POSIX signal")
def test_an_interrupt_from_outside(folder):
    code = HEARING + "from coursework.commands.cli import main; print('begun', flush=True); main(['accuracy', '31'])"
    process = subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    )
    process.stdout.readline()  # before this line the interpreter itself is interrupted, not the command
    time.sleep(1.0)
    os.killpg(process.pid, signal.SIGINT)
    _, said = process.communicate()
    assert (process.returncode, list(folder.iterdir())) == (130, [])
    assert said.decode().endswith("Interrupted: nothing unfinished is left behind.\n")


def test_a_home_that_cannot_be_written(folder):
    (folder / "file").touch()
    nowhere = str(folder / "file" / "home")
    homes = dict.fromkeys(("HOME", "USERPROFILE", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "LOCALAPPDATA", "APPDATA"), nowhere)
    environment = {**{k: v for k, v in os.environ.items() if k != "MPLCONFIGDIR"}, **homes}
    command = [*COMMAND, "run", "31", "--quantities", "table,plots", "--format", "html,pdf", "--out", "o"]
    done = subprocess.run(command, env=environment, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert sorted(path.name for path in Path("o").iterdir()) == ["report.html", "report.pdf", "run.json"]


def test_a_home_that_is_a_file_and_a_sympy_without_its_parts(folder):
    """Nothing is kept between runs: the table is the same, and nothing is said."""
    (folder / "home").touch()
    code = "import sys; sys.modules['gmpy2'] = sys.modules['mpmath'] = None; from coursework.commands.cli import main; main()"
    environment = {**os.environ, "HOME": str(folder / "home"), "XDG_CACHE_HOME": str(folder / "home")}
    command = [sys.executable, "-c", code, "run", "31", "--quantities", "table", "--format", "csv", "--out", "o"]
    done = subprocess.run(command, env=environment, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert Path("o/table.csv").read_bytes() == table_csv(coursework.solve("31", quantities=["table"])).encode()
