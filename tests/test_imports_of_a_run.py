"""What nobody asked for is not even imported: asked of a fresh interpreter."""

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import coursework
from coursework.report.output.tables import run_tables
from tests.grading.batch.classroom import hand_in

LOOK = """
import json, sys
{code}
print(json.dumps(sorted(sys.modules)))
"""
COMMAND = """
from coursework.commands.cli import main
import contextlib, io
with contextlib.redirect_stdout(io.StringIO()):
    try:
        main({arguments!r})
    except SystemExit as end:
        assert not end.code, end.code
"""
HEAVY = {"numpy", "sympy", "pydantic", "pandas", "scipy", "matplotlib", "jinja2", "typst"}
PAGES = {"sympy", "pydantic", "pandas", "scipy", "matplotlib", "jinja2", "typst", "coursework.report.pages"}
EXTRA = {
    "coursework.results.kinematics.accelerations",
    "coursework.results.kinematics.points",
    "coursework.drawing.check_sheet.graph_check",
    "coursework.results.checks.check",
    "coursework.results.accuracy.study",
    "coursework.effects",
    "coursework.variant.record.forces",
    "coursework.variant.formula.mass_units",
}


@cache
def imported(code, folder=None):
    """Return the modules that a program has loaded in the end; where its folder does not matter, it runs once."""
    done = subprocess.run([sys.executable, "-c", LOOK.format(code=code)], capture_output=True, text=True, cwd=folder, check=False)
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stdout.splitlines()[-1]))


def command(*arguments):
    return COMMAND.format(arguments=list(arguments))


@pytest.mark.parametrize(
    ("code", "absent"),
    [
        ("import coursework", HEAVY | {"click"}),
        (command("--help"), HEAVY),
        (command("run", "--help"), HEAVY),
        (command("variants"), HEAVY),
        (command("run", "31", "--quantities", "table", "--format", "csv"), PAGES | EXTRA),
        (command("run", "31", "--quantities", "phi3", "--format", "csv"), PAGES | EXTRA),
        (
            command("run", "31", "--quantities", "table,checks", "--format", "csv"),
            PAGES | EXTRA - {"coursework.results.checks.check"},
        ),
        (
            command("run", "31", "--quantities", "accelerations", "--format", "csv"),
            PAGES | EXTRA - {"coursework.results.kinematics.accelerations"},
        ),
        # The words beside a graph tell the extremes of a velocity, which are where its derivative is zero.
        (
            command("run", "31", "--quantities", "table,plots", "--format", "html"),
            {"sympy", "pydantic", "pandas", "scipy", *EXTRA} - {"coursework.results.kinematics.accelerations"},
        ),
        # It refuses what `run` would refuse to draw.
        (command("check", "31"), PAGES | EXTRA - {"coursework.drawing.check_sheet.graph_check"}),
        (command("run", "31", "--plan"), PAGES | EXTRA),
    ],
    ids=["import", "help", "run help", "variants", "table", "one angle", "checks", "accelerations", "html", "check", "plan"],
)
def test_what_is_not_imported(code, absent, tmp_path):
    found = imported(code, tmp_path)
    assert "coursework" in found
    assert found & absent == set()


def test_the_look_at_imports_sees_them(tmp_path):
    assert {"numpy", "sympy", "pandas"} <= imported(
        "import coursework\nrun = coursework.solve('31', quantities=['table'])\nrun.table, run.scene.reduction.blocks[0].matrix",
        tmp_path,
    )


@pytest.mark.parametrize(
    ("arguments", "others"),
    [
        (("run", "31", "--format", "csv"), {"click", "numpy"}),
        (("check", "31"), {"click", "numpy"}),
        (("run", "31"), {"click", "numpy", "jinja2", "markupsafe", "typst"}),
        (("grade", "in", "--variant", "31", "--out", "out"), {"click", "numpy", "jinja2", "markupsafe"}),
    ],
    ids=lambda one: one[0] if isinstance(one, tuple) else "",
)
def test_the_libraries_of_a_command(arguments, others, tmp_path):
    if arguments[0] == "grade":
        hand_in(tmp_path / "in" / "ada")
    modules = imported(command(*arguments), tmp_path)
    bare = imported("")
    assert {name.partition(".")[0] for name in modules - bare} - sys.stdlib_module_names == {"coursework", *others}
    assert "numpy.ma" not in modules
    rooms = {name.split(".")[1] for name in modules if name.startswith("coursework.")}
    assert rooms & {"grading", "assigning"} == ({"grading"} if arguments[0] == "grade" else set())


# SymPy is not installed, and the home folder is a file: no folder can be made or read there.
BARE = """
import sys
sys.modules["sympy"] = None
"""


def test_a_run_without_sympy_or_a_home_is_the_same(tmp_path):
    (tmp_path / "home").write_text("")
    home = {name: str(tmp_path / "home") for name in ("HOME", "USERPROFILE", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "APPDATA")}
    run = command("run", "31", "--format", "csv,html", "--out", "bare")
    done = subprocess.run(
        [sys.executable, "-c", BARE + run], capture_output=True, text=True, cwd=tmp_path, env=os.environ | home, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    whole = coursework.solve("31")
    assert (tmp_path / "bare" / "table.csv").read_bytes() == dict(run_tables(whole))["table.csv"].encode()
    versions = json.loads((tmp_path / "bare" / "run.json").read_bytes())["versions"]
    assert versions == {name: version for name, version in whole.versions.items() if name != "sympy"}


@pytest.mark.parametrize(("own", "threads"), [({}, 1), ({"OPENBLAS_NUM_THREADS": "2"}, 2)], ids=["run", "said by the user"])
def test_a_command_starts_no_thread_that_nobody_needs(own, threads, tmp_path):
    count = Path("/proc/self/task")
    if not count.is_dir() or os.cpu_count() == 1:
        pytest.skip("nothing counts the threads of a process here")
    # One that is ending is counted for a moment still.
    code = (
        command("run", "31", "--format", "csv")
        + f"""
import os, sys, time
end = time.monotonic() + 5
while (found := len(os.listdir({str(count)!r}))) != {threads} and time.monotonic() < end:
    time.sleep(0.01)
sys.exit(found != {threads})
"""
    )
    bare = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    assert subprocess.run([sys.executable, "-c", code], cwd=tmp_path, env=bare | own, check=False).returncode == 0
