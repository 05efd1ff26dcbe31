"""Before a terminal a run is told in brief: what was computed, whether it is right and close, what to do; elsewhere in full."""

import os
import re
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

from coursework.commands.line import screen
from coursework.commands.run_on_screen import _first_and_last
from coursework.words.sentences import say
from tests.command import call

pytestmark = pytest.mark.usefixtures("folder")
QUICK = ["--quantities", "table,checks", "--format", "csv"]
CODE = re.compile(r"\b(?:ACCURACY|PERIOD-POSITION|CONTINUITY|DRIFT|RESIDUAL|PEAK)\b")


@pytest.fixture
def terminal(monkeypatch):
    """Standard output as a terminal of eighty columns."""
    monkeypatch.setattr("coursework.commands.run.is_terminal", lambda: True)
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((80, 24)))


def test_a_run_fits_one_screen_and_says_the_point_first(terminal):
    result = call("run", "31", *QUICK)
    assert result.exit_code == 0
    lines = result.stdout.splitlines()
    assert len(lines) <= 24
    assert max(map(len, lines)) < 80
    text = " ".join(result.stdout.split())
    assert text.startswith(
        "Rolling wheel, right-angled link, crank and rod (31): explicit Euler, h = 0.02 s, 25 rows. The table is computed right: "
        "5 of 5 checks of the computation; the start is not judged. It is not close to the motion: "
        "largest error 69.8 % of 0.2 rad (phi1, row 20); take --step h/18."
    )
    assert "≈ Closeness to the motion: Computed right, but not close to the exact motion." in text
    assert not CODE.search(text)
    assert text.count("Take --step h/18 (0.00111 s), or --scheme rk4 at the old step (0.005 %).") == 1
    assert lines[-2:] == [
        "Written to coursework-31: table.csv, run.json", "Every check with its number: the same command with --verbose.",
    ]  # fmt: skip


def test_a_run_in_which_everything_passes_names_no_check(terminal):
    lines = call("run", "31", "--scheme", "rk4", *QUICK).stdout.splitlines()
    assert not [line for line in lines if line.lstrip().startswith(("≈", "✗", "!", "✓", "–"))]
    assert len(lines) < 12


def test_files_of_a_folder_are_told_as_one(terminal, folder, monkeypatch):
    monkeypatch.setattr("coursework.commands.run.write_all", lambda *_: ["table.csv", "dxf/a.dxf", "dxf/b.dxf", "run.json"])
    monkeypatch.setattr("coursework.commands.run.earlier_files", lambda _: ("figures/a.svg", "figures/b.svg"))
    for name in ("a", "b"):
        (folder / "coursework-31" / "figures").mkdir(parents=True, exist_ok=True)
        (folder / "coursework-31" / "figures" / f"{name}.svg").touch()
    assert call("run", "31", "--quantities", "table", "--format", "csv").stdout.splitlines()[-2:] == [
        "Written to coursework-31: table.csv, dxf/, run.json", "From an earlier run, and not of this one: figures/",
    ]  # fmt: skip


def test_without_checks_there_is_no_word_of_them(terminal):
    text = call("run", "31", "--quantities", "table", "--format", "csv").stdout
    assert "computed right" not in text
    assert "--verbose" not in text
    assert "  first t = 0 s: phi1 1.63," in text


def test_a_check_that_fails_and_a_motion_that_stops_are_told(terminal, folder):
    page = (folder / "stops.toml", folder / "wrong.toml")
    call("new", "stops", "--from", "31", "--set", "alpha=0.02rad")
    stopped = call("run", str(page[0]), *QUICK)
    assert stopped.exit_code == 1
    text = " ".join(stopped.stdout.split())
    assert "Stopped (dead point): At t = 0.116889 s" in text
    assert "computed right up to the stop: 4 of 4 checks of the computation. It is not close" in text  # the table, not its rows
    call("new", "wrong", "--from", "31", "--set", "period=0.40s")
    failed = call("run", str(page[1]), *QUICK)
    assert failed.exit_code == 1
    assert "✗ Period, positions: " in failed.stdout
    assert "Wrong: Period, positions" in " ".join(failed.stdout.split())


def test_what_was_changed_is_told(terminal):
    text = " ".join(call("run", "31", "--set", "p=12", "--gain", "1", *QUICK).stdout.split())
    assert "p = 12" in text
    assert "Baumgarte’s gain 1 1/s" in text


@pytest.mark.parametrize("language", ["ru", "uk", "zh"])
def test_in_every_language(terminal, language):
    text = call("run", "31", *QUICK, "--language", language).stdout
    assert "≈" in text
    assert "--verbose" in text
    assert not CODE.search(text)
    assert "Every check" not in text


def test_verbose_is_what_a_pipe_gets(terminal):
    brief = call("run", "31", *QUICK).stdout
    full = call("run", "31", *QUICK, "--verbose").stdout
    assert brief != full
    assert "  ≈ COARSE ACCURACY         0.698 of the scale (limit 0.05), phi1, row 20" in full.splitlines()
    assert "  – SKIP   TABLE-DIGITS     No law is given as a table." in full.splitlines()  # why it is not known
    piped = subprocess.run([sys.executable, "-m", "coursework", "run", "31", *QUICK], capture_output=True, check=True)
    assert piped.stdout.decode("utf-8").splitlines() == full.splitlines()


def test_the_record_is_the_same(terminal, folder):
    call("run", "31", *QUICK, "--out", "brief")
    call("run", "31", *QUICK, "--verbose", "--out", "full")
    assert (folder / "brief" / "run.json").read_bytes() == (folder / "full" / "run.json").read_bytes()


def test_several_variants_may_be_verbose_too(terminal):
    assert call("run", "31", "v101", *QUICK, "--verbose").exit_code == 0


def test_a_variant_called_as_its_file_is_named_once_and_a_step_without_an_end_has_four_digits(terminal):
    call("new", "mine")
    text = call("run", "mine", *QUICK, "--set", "step=1/60").stdout
    assert text.startswith("mine: explicit Euler, h = 0.01667 s, 61 rows.\n")


@pytest.mark.parametrize(("text", "lines"), [
    ("the largest error is 43.1 % of its scale", ["the largest error", "is 43.1 % of its scale"]),
    ("it begins at rest, with h = 0.02 s, and turns", ["it begins at rest, with", "h = 0.02 s, and turns"]),
    ("наибольшая скорость 1,5 рад/с у звена", ["наибольшая", "скорость 1,5 рад/с у", "звена"]),
    ("степень подвижности W = 3·4 − 2·5 = 2", ["степень подвижности", "W = 3·4 − 2·5 = 2"]),
    ("координата phi2 равна пи — а не нулю", ["координата phi2 равна", "пи — а не нулю"]),
])  # fmt: skip
def test_a_number_keeps_its_unit_and_its_letter(monkeypatch, capsys, text, lines):
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((26, 24)))
    screen.tell_wrapped(text)
    assert capsys.readouterr().out.splitlines() == lines


@pytest.mark.parametrize(("width", "count"), [(22, 2), (23, 1)])
def test_a_line_is_broken_where_it_does_not_fit_and_keeps_a_number_with_its_word(monkeypatch, capsys, width, count):
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((width, 24)))
    screen.tell_wrapped("  first w2 -1, w3 5.55", hanging="    ")
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == count
    assert lines[-1].endswith("w3 5.55")


def test_a_real_terminal_is_noticed(folder):
    pty = pytest.importorskip("pty", reason="this system has no pseudo-terminals")
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "coursework", "run", "31", *QUICK]
    with subprocess.Popen(command, stdout=theirs, stderr=subprocess.PIPE, env={**os.environ, "COLUMNS": "80"}) as process:
        os.close(theirs)
        told = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:  # Linux says so where the other end is closed
                break
            if not part:
                break
            told += part
        assert process.wait() == 0
    os.close(ours)
    text = told.decode("utf-8")
    assert text.startswith("Rolling wheel")
    assert "≈ Closeness to the motion" in text
    assert "COARSE" not in text


def test_a_sentence_is_broken_before_a_person_and_a_formula_is_not(monkeypatch, capsys):
    monkeypatch.setattr(screen, "is_terminal", lambda: True)
    monkeypatch.setattr("shutil.get_terminal_size", lambda: os.terminal_size((24, 24)))
    screen.tell(say("screen.note", sentence="what the whole file means"))
    screen.tell("    w1 = -(VMx*cos(phi2) + VMy*sin(phi2))/r1")
    assert capsys.readouterr().out.splitlines() == [
        "  what the whole file", "    means", "    w1 = -(VMx*cos(phi2) + VMy*sin(phi2))/r1",
    ]  # fmt: skip


@pytest.mark.parametrize("size", [0.004, 250.0])
def test_what_is_left_of_zero_by_round_off_is_printed_as_0(size):
    """Below 1e-12 of the largest number of a unit: of a column, or of another one with its unit."""
    rows = np.array([[0.98e-12 * size, size, 1.02e-12 * size], [-1.02e-12 * size, 0.0, 0.0]])
    motion = SimpleNamespace(t=np.arange(2.0), rows=rows, names=("a", "b", "c"))
    run = SimpleNamespace(motion=motion, variant=SimpleNamespace(unit_of=lambda _: "m"))
    first, last = ([part.values["value"] for part in line.values["values"].values["parts"]] for line in _first_and_last(run))
    assert (first, last) == ([0.0, size, rows[0, 2]], [rows[1, 0], 0.0, 0.0])
