"""From Python alone to a result: the real `bootstrap` in a folder of its own, with a package that needs no network."""

import os
import re
import subprocess
import sys
import venv
from pathlib import Path

import pytest

from coursework import bootstrap

ROOT = Path(__file__).parent.parent
# A build backend of one file: pip installs the folder by a .pth, as an editable install does, and fetches nothing.
BACKEND = """
import zipfile
def build_editable(folder, settings=None, metadata=None):
    files = {
        "coursework.pth": PLACE,
        "coursework-1.dist-info/METADATA": "Metadata-Version: 2.1\\nName: coursework\\nVersion: 1\\n",
        "coursework-1.dist-info/WHEEL": "Wheel-Version: 1.0\\nGenerator: tests\\nRoot-Is-Purelib: true\\nTag: py3-none-any\\n",
    }
    with zipfile.ZipFile(folder + "/coursework-1-py3-none-any.whl", "w") as wheel:
        for name, text in files.items():
            wheel.writestr(name, text)
        record = "".join(f"{name},,\\n" for name in [*files, "coursework-1.dist-info/RECORD"])
        wheel.writestr("coursework-1.dist-info/RECORD", record)
    return "coursework-1-py3-none-any.whl"
build_wheel = build_editable
"""
PROJECT = """
[build-system]
requires = []
build-backend = "backend"
backend-path = ["."]
[project]
name = "coursework"
version = "1"
"""


@pytest.fixture
def checkout(tmp_path):
    root = tmp_path / "a checkout of Вася"
    package = root / "coursework"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("", encoding="utf-8")
    (package / "__main__.py").write_text("import sys; print('ran', *sys.argv[1:]); sys.exit(1)", encoding="utf-8")
    (package / "bootstrap.py").write_bytes((ROOT / "coursework" / "bootstrap.py").read_bytes())
    (root / "backend.py").write_text(f"PLACE = {str(root)!r}\n{BACKEND}", encoding="utf-8")
    (root / "pyproject.toml").write_text(PROJECT, encoding="utf-8")
    return root


def run(root, *arguments):
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"} | {"PYTHONUTF8": "1"}
    command = [sys.executable, "-m", "coursework.bootstrap", *arguments]
    return subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, encoding="utf-8", check=False)


def test_from_a_half_made_environment_to_a_result(checkout):
    """What Debian leaves without its package is mended; without a connection the next try goes on; then nothing is said."""
    venv.create(checkout / ".venv", with_pip=False)
    (checkout / "backend.py").write_text("raise OSError('no connection')", encoding="utf-8")
    first = run(checkout, "run", "31")
    assert first.returncode == 3
    assert first.stdout.startswith("Preparing coursework in "), first.stdout
    assert "once: a virtual environment (some seconds), then its packages" in first.stdout
    assert "is half-made or its Python is gone; it is made anew." in first.stdout
    assert "The packages could not be installed; pip's own message stands above." in first.stderr
    assert "Traceback" not in first.stderr.rpartition("The packages")[2]
    (checkout / "backend.py").write_text(f"PLACE = {str(checkout)!r}\n{BACKEND}", encoding="utf-8")
    second = run(checkout, "run", "31")
    assert (second.stderr, second.returncode) == ("", 1)
    assert "made anew" not in second.stdout
    assert re.search(r"  packages: \d+ s\. From now on the command is .*coursework", second.stdout)
    assert second.stdout.endswith("ran run 31\n")
    third = run(checkout, "check", "mine")
    assert (third.stdout, third.stderr, third.returncode) == ("ran check mine\n", "", 1)


@pytest.mark.parametrize(
    ("words", "extra"), [(["run", "edit"], ""), (["edit"], "[desk]"), (["serve", "test"], "[desk]"), (["test"], "[test]")]
)
def test_a_command_is_prepared_with_what_it_needs(words, extra, monkeypatch):
    prepared = []
    monkeypatch.setattr(bootstrap, "prepare", lambda extra: prepared.append(extra) or sys.executable)
    monkeypatch.setattr(bootstrap, "test", lambda python, more: 0)
    monkeypatch.setattr(subprocess, "Popen", lambda command: None)
    monkeypatch.setattr(bootstrap, "ended", lambda process: 0)
    assert (bootstrap.main(words), prepared) == (0, [extra])


@pytest.mark.parametrize("module", ["venv", "ensurepip"])
def test_the_one_package_to_install_is_named(module, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(bootstrap, "HOME", tmp_path / ".venv")
    monkeypatch.setitem(sys.modules, module, None)  # as where Debian has left it out
    assert bootstrap.main(["run", "31"]) == 3
    told = capsys.readouterr().err
    assert f'came without its module "{module}"' in told
    assert f"sudo apt install python{sys.version_info[0]}.{sys.version_info[1]}-venv " in told
    assert not (tmp_path / ".venv").exists()


def test_a_link_in_the_place_of_the_environment_goes_and_what_it_leads_to_stays(tmp_path, monkeypatch):
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere/work.txt").touch()
    (tmp_path / ".venv").symlink_to(tmp_path / "elsewhere")
    monkeypatch.setattr(bootstrap, "HOME", tmp_path / ".venv")
    monkeypatch.setattr(venv, "create", lambda home, with_pip: home.mkdir())
    bootstrap.make_environment()
    assert (tmp_path / "elsewhere/work.txt").exists()
    assert not (tmp_path / ".venv").is_symlink()


def test_why_there_is_no_environment_is_told(tmp_path, monkeypatch):
    def refused(home, with_pip):
        raise PermissionError(13, "Permission denied", str(home))

    monkeypatch.setattr(bootstrap, "HOME", tmp_path / ".venv")
    monkeypatch.setattr(venv, "create", refused)
    with pytest.raises(bootstrap.NotPrepared, match=r"could not be made: Permission denied\. Is the folder"):
        bootstrap.make_environment()


@pytest.mark.parametrize("version", [(3, 7), (3, 10)])
def test_too_old_a_python_is_told(version, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(bootstrap, "HOME", tmp_path / ".venv")
    monkeypatch.setattr(sys, "version_info", version)
    assert bootstrap.main(["run", "31"]) == 3
    told = capsys.readouterr().err
    assert told.startswith("Python 3.11 or newer is needed; this one (")
    assert f") is {version[0]}.{version[1]}. Install a newer one from python.org" in told
    assert not (tmp_path / ".venv").exists()


def test_the_oldest_python_is_not_told():
    bootstrap.refuse_too_old((3, 11))


def test_without_a_command_it_says_what_it_is_for(capsys):
    assert bootstrap.main([]) == 2
    assert "python -m coursework.bootstrap run 31" in capsys.readouterr().out
    assert bootstrap.main(["--help"]) == 0


@pytest.mark.parametrize(
    ("words", "marked", "runs"), [([], False, 2), (["--long"], True, 2), (["--long", "tests/hard"], True, 1)]
)
def test_what_takes_long_is_asked_for(words, marked, runs, tmp_path, monkeypatch):
    commands = []
    ended = subprocess.CompletedProcess([], 0)
    monkeypatch.setattr(subprocess, "run", lambda command, **_: commands.append(command) or ended)
    assert bootstrap.test(tmp_path / "python", words) == 0
    assert len(commands) == runs
    assert all((command[3:5] == ["-m", ""]) is marked for command in commands)
    assert not any("--long" in command for command in commands)


def test_an_interpreter_that_fails_has_no_answer():
    python = Path(sys.executable)
    assert bootstrap.answers(python, "-S", "-c", "print(' 5 ')") == "5"
    assert bootstrap.answers(python, "-S", "-c", "print(5); raise SystemExit(1)") == ""
    assert bootstrap.answers(python.with_name("no-python"), "-c", "print(5)") == ""
