"""Several variants are one command: a folder each, one summary, and one faulty file stops nothing."""

import csv
from pathlib import Path

import pytest

from coursework.commands import several
from coursework.commands.several import Item, Outcome, RunTask
from coursework.system.processes.budget import Budget
from coursework.words.sentences import say
from tests.command import call

PAGE = (Path(__file__).parents[1] / "reference" / "format_page_31.toml").read_text(encoding="utf-8")
CSV = ["--format", "csv", "--quantities", "table,checks"]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.toml").write_text(PAGE, encoding="utf-8")
    (tmp_path / "stops.toml").write_text(PAGE.replace('"4.35 rad"', '"0.02 rad"'), encoding="utf-8")
    (tmp_path / "bad.toml").write_text("broken = ", encoding="utf-8")
    return tmp_path


def files_below(place: Path) -> dict[str, bytes]:
    return {path.relative_to(place).as_posix(): path.read_bytes() for path in place.rglob("*") if path.is_file()}


def summary(place: Path) -> dict[str, dict[str, str]]:
    with (place / "summary.csv").open(encoding="utf-8", newline="") as file:
        return {row["variant"]: row for row in csv.DictReader(file)}


def test_each_gets_a_folder_and_the_faulty_ones_a_line(folder):
    result = call("run", "mine", "bad.toml", "stops.toml", "nosuch", "31", *CSV, "--out", "o")
    assert result.exit_code == 2
    assert sorted(path.name for path in Path("o").iterdir()) == ["31", "mine", "stops", "summary.csv"]
    rows = summary(Path("o"))
    assert [row["status"] for row in rows.values()] == ["0", "2", "1", "2", "0"]
    assert (rows["mine"]["rows"], rows["stops.toml"]["rows"], rows["bad.toml"]["rows"]) == ("25", "6", "0")
    assert rows["bad.toml"]["sentence"][5:].startswith("bad.toml:1")
    assert {name: row["code"] for name, row in rows.items() if row["code"]} == {
        name: rows[name]["sentence"][:4] for name in ("bad.toml", "nosuch")
    }
    assert rows["stops.toml"]["sentence"] == "stopped (dead point) at t = 0.116889 s"
    assert int(rows["mine"]["pass"]) >= 5
    assert int(rows["mine"]["coarse"]) >= 1
    assert 'there is no variant "nosuch"' in result.stderr
    assert "5 variants: 2 with status 0, 1 with status 1, 2 with status 2" in result.stdout
    lines = {line.split()[0]: line for line in result.stdout.splitlines() if "  " in line}
    told = {name: bool(row["sentence"]) and row["sentence"][:100] in lines[Path(name).stem] for name, row in rows.items()}
    assert told == {"mine": False, "bad.toml": True, "stops.toml": True, "nosuch": True, "31": False}


def test_the_summary_names_what_is_coarse_only_where_that_counts(folder):
    for strict, status in (([], "0"), (["--strict"], "1")):
        ran = call("run", "mine", "31", "--step", "0.04", *strict, *CSV, "--out", "o")
        assert ran.stderr == "", "a bar is for a terminal"
        row = summary(Path("o"))["31"]
        assert (row["status"], "ACCURACY" in row["sentence"]) == (status, bool(strict))


def test_the_same_as_one_by_one(folder):
    assert call("run", "31", "stops.toml", "v108", *CSV, "--out", "o").exit_code == 1
    for name in ("31", "stops.toml", "v108"):
        call("run", name, *CSV, "--out", "alone")
        assert files_below(Path("alone")) == files_below(Path("o") / name.removesuffix(".toml"))


@pytest.mark.long
def test_the_same_bytes_from_several_processes(folder):
    names = ["31", "bad.toml", "stops.toml", "example-2", "mine"]
    results = [call("run", *names, *CSV, "--out", f"o{jobs}", "--jobs", jobs) for jobs in (1, 2)]
    assert [result.exit_code for result in results] == [2, 2]
    assert results[0].stdout == results[1].stdout.replace("o2", "o1")
    assert results[0].stderr == results[1].stderr
    assert files_below(Path("o1")) == files_below(Path("o2"))
    assert not [path for path in Path("o2").iterdir() if path.name.startswith(".")]


def test_patterns_are_expanded_by_us(folder):
    result = call("run", "[ms]*.toml", "mine", "31", *CSV, "--out", "o")
    assert list(summary(Path("o"))) == ["mine.toml", "stops.toml", "31"]  # mine only once, and what comes after it too
    assert result.exit_code == 1
    assert call("run", "x*.toml", *CSV, "--out", "p").exit_code == 2
    assert list(summary(Path("p"))) == ["x*.toml"]


def test_brackets_in_a_folder_are_no_pattern(folder):
    place = Path("One Drive [2026]")
    place.mkdir()
    (place / "mine.toml").write_text(PAGE, encoding="utf-8")
    assert not several._is_pattern(f"{place}/mine")
    assert several._expanded(f"{place}/m*.toml") == [str(place / "mine.toml")]
    assert several._expanded("O*/mine.toml") == [str(place / "mine.toml")]


def test_folders_differ_also_where_a_and_A_are_the_same(folder):
    for place in ("a", "b", "c"):
        Path(place).mkdir()
    Path("a/M.toml").write_text(PAGE, encoding="utf-8")
    Path("b/m.toml").write_text(PAGE, encoding="utf-8")
    Path("c/summary.csv.toml").write_text(PAGE, encoding="utf-8")
    assert call("run", "a/M.toml", "b/m.toml", "c/summary.csv.toml", *CSV, "--out", "o").exit_code == 0
    assert [row["folder"] for row in summary(Path("o")).values()] == ["M", "m-2", "summary.csv-2"]


def test_a_fault_of_the_tool_is_told_with_its_traceback_and_the_rest_runs(monkeypatch):
    real = several.make_run

    def broken(read, **options):
        if read.name == "mine":
            raise RuntimeError("something of ours")
        return real(read, **options)

    monkeypatch.setattr(several, "make_run", broken)
    result = call("run", "mine", "31", *CSV, "--out", "o")
    assert result.exit_code == 3
    assert "Traceback" in result.stderr
    assert [row["status"] for row in summary(Path("o")).values()] == ["3", "0"]


# An end may come between opening a file and holding it: then the collector closes it, and says so.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning", "ignore::ResourceWarning")
def test_a_budget_is_that_of_each_variant():
    result = call("run", "mine", "31", "--budget", "1e-9", *CSV, "--out", "o")
    assert result.exit_code in {0, 2}  # a variant that is done before the first look has kept its budget
    for row in summary(Path("o")).values():
        assert row["status"] == "0" or "(limit --budget 1e-09)" in row["sentence"]


@pytest.mark.parametrize("options", [["--plan"], ["--profile"], ["--precision", "single"], ["--step", "auto"], ["--error", "1"]])
def test_what_looks_at_one_variant_asks_for_one(options):
    result = call("run", "mine", "31", *options)
    assert result.exit_code == 2
    assert "look at one variant. Name one." in result.stderr


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_process_that_dies_takes_only_its_item_along(jobs, monkeypatch, capfd):
    """Whether it is the first of the pool or the second that is lost: the others are run, each once, as it would die again."""
    monkeypatch.setattr(several, "OPENED", "tests.commands.dying:opened")
    items = [Item(name, name) for name in ("die", "a", "b", "die", "die", "c")]
    task = RunTask(Path("o"), None, "en", {}, Budget())
    found = {}
    for index, outcome in several.outcomes(task, items, 1 + jobs):
        assert index not in found
        found[index] = outcome
    assert [(found[k].item, found[k].status) for k in range(6)] == [(item, 2 if item.variant == "die" else 0) for item in items]
    assert {outcome.message for outcome in found.values() if outcome.status} == {say("screen.lost", variant="die")}
    assert capfd.readouterr().err.count("dies") == 3


def test_the_worst_status_is_that_of_the_command():
    items = [Outcome(Item(str(status), str(status)), status) for status in (0, 3, 1, 2)]
    assert list(several.summary_lines(items))[-1] == (
        "4 variants: 1 with status 0, 1 with status 1, 1 with status 2, 1 with status 3"
    )
