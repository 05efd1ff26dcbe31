"""From a fresh checkout to a first result with Python alone: a virtual environment, the package, then the job.

    python -m coursework.bootstrap run 31      any command of `coursework`
    python -m coursework.bootstrap edit        the desk in the browser, with what it needs besides
    python -m coursework.bootstrap test        the tests
    python -m coursework.bootstrap test --long the tests and what takes long: every file where else a sample is tried

Enters: the words of the command.  Leaves: `.venv` beside `pyproject.toml`, and the status of the command.
Uses the standard library only and is the same on Windows, macOS and Linux; who calls it is a user's terminal.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HOME = ROOT / ".venv"
OLDEST = (3, 11)
WRONG_INPUT, NOT_PREPARED, INTERRUPTED = 2, 3, 130
MEASURED = "tests/benchmarks"  # their ratios need a machine that does nothing else
LONG = "--long"
MEGABYTES = {"[test]": 250, "[desk]": 95}
EXTRAS = {"test": "[test]", "edit": "[desk]", "serve": "[desk]"}
SILENCE = 15  # seconds after which a line says that the installation is still at work


class NotPrepared(Exception):
    """The error if the environment cannot be made; its text tells the user what to do."""


def main(arguments: list[str]) -> int:
    """Prepare, then run a command of `coursework`, or the tests; return its exit status."""
    if not arguments or arguments[0] in {"-h", "--help"}:
        print(__doc__)
        return 0 if arguments else WRONG_INPUT
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="replace")  # type: ignore[union-attr]  # folder names may have letters the terminal lacks
    testing = arguments[0] == "test"
    try:
        refuse_too_old(sys.version_info[:2])
        python = prepare(EXTRAS.get(arguments[0], ""))
        if testing:
            return test(python, arguments[1:])
        return ended(subprocess.Popen([str(python), "-m", "coursework", *arguments]))
    except NotPrepared as fault:
        print(fault, file=sys.stderr)
        return NOT_PREPARED
    except KeyboardInterrupt:
        print("Interrupted. The same command again goes on from here.", file=sys.stderr)
        return INTERRUPTED


def ended(command: subprocess.Popen[bytes]) -> int:
    """Return the exit status of a command; an interrupt reaches the command too, which ends by itself."""
    while True:
        try:
            return command.wait()
        except KeyboardInterrupt:
            continue


def test(python: Path, wanted: list[str]) -> int:
    """Run the `wanted` tests; if none are named, all tests on every core, and then the benchmarks alone.

    Long tests are left out unless `LONG` is among the words.
    """
    marked = ["-m", ""] if LONG in wanted else []
    wanted = [word for word in wanted if word != LONG]
    workers = str(1 + (os.cpu_count() or 1))  # one waits for a browser or a process while the others work
    # A file stays with one worker: what its tests share is made once.
    spread = ["-n", workers, "--dist", "loadfile", "--no-loadscope-reorder"]
    everywhere = [*spread, "--benchmark-disable", "--ignore", MEASURED]
    runs = [wanted] if wanted else [everywhere, [MEASURED]]
    tests = [str(python), "-m", "pytest", *marked]
    return max(subprocess.run([*tests, *chosen], cwd=ROOT).returncode for chosen in runs)


def refuse_too_old(version: tuple[int, ...]) -> None:
    """Raise `NotPrepared` for a Python older than `OLDEST`."""
    if version < OLDEST:
        wanted = ".".join(map(str, OLDEST))
        other = f"py -{wanted}" if os.name == "nt" else f"python{wanted}"
        raise NotPrepared(
            f"Python {wanted} or newer is needed; this one ({sys.executable}) is {'.'.join(map(str, version))}. "
            f'Install a newer one from python.org and call it by its number: "{other} -m coursework.bootstrap run 31".'
        )


def prepare(extra: str) -> Path:
    """Make the environment and install the package with `extra` into it, unless that has been done; return its Python.

    Installs again if pyproject.toml, the folder or Python has changed.  Raises `NotPrepared`.
    """
    python = python_of(HOME)
    stamp = HOME / f"installed{extra or '-plain'}.txt"
    content = f"{ROOT}\n{(ROOT / 'pyproject.toml').read_text(encoding='utf-8')}"
    version = version_of(python)
    if version and stamp.is_file() and stamp.read_text(encoding="utf-8") == f"{version}\n{content}":
        return python
    print(
        f"Preparing coursework in {HOME}, once: a virtual environment (some seconds), then its packages from the Python "
        f"package index (about {MEGABYTES.get(extra, 90)} MB; one to five minutes, as the connection allows).",
        flush=True,
    )
    if not version or not answers(python, "-m", "pip", "--version"):
        make_environment()
    install(python, extra)
    stamp.write_text(f"{version_of(python)}\n{content}", encoding="utf-8")
    return python


def python_of(home: Path) -> Path:
    """Return the interpreter of a virtual environment."""
    return home / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def version_of(python: Path) -> str:
    """Return the version of an interpreter, "" if it does not exist, does not start or is too old."""
    return answers(python, "-c", f"import sys; print(*sys.version_info[:2]) if sys.version_info >= {OLDEST} else sys.exit(1)")


def answers(python: Path, *arguments: str) -> str:
    """Return the output of a call of an interpreter, "" if the call fails."""
    try:
        return subprocess.run([str(python), *arguments], capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def make_environment() -> None:
    """Make `.venv`; replace one that is half-made or whose Python is gone.  Raises `NotPrepared`."""
    missing = [name for name in ("venv", "ensurepip") if importlib.util.find_spec(name) is None]
    if missing:
        raise NotPrepared(lacking(missing[0]))
    import venv

    begun = time.monotonic()
    try:
        if HOME.exists() or HOME.is_symlink():
            print(f"{HOME} is half-made or its Python is gone; it is made anew.", flush=True)
            shutil.rmtree(HOME) if HOME.is_dir() and not HOME.is_symlink() else HOME.unlink()
        venv.create(HOME, with_pip=True)
    except subprocess.CalledProcessError as error:
        raise NotPrepared(lacking("ensurepip")) from error
    except OSError as error:
        raise NotPrepared(
            f"{HOME} could not be made: {error.strerror or error}. Is the folder writable, the disk not full?"
        ) from error
    print(f"  virtual environment: {time.monotonic() - begun:.0f} s", flush=True)


def lacking(module: str) -> str:
    """Return what to install if Python came without one of its modules, as on Debian and Ubuntu."""
    number = f"{sys.version_info[0]}.{sys.version_info[1]}"
    return (
        f'This Python ({sys.executable}) came without its module "{module}". On Debian and Ubuntu it is one package: '
        f"sudo apt install python{number}-venv   Elsewhere install Python from python.org. Then type the same command again."
    )


def install(python: Path, extra: str) -> None:
    """Install the package from this folder, editable; a line every `SILENCE` seconds says that it is still at work.

    Modules are compiled only when they are first imported: most never are, and compiling all took half of the time.
    """
    begun = time.monotonic()
    quiet = ["--quiet", "--disable-pip-version-check", "--no-compile"]
    command = [str(python), "-m", "pip", "install", *quiet, "--editable", f"{ROOT}{extra}"]
    with subprocess.Popen(command) as pip:
        while still_at_work(pip):
            print(f"  packages: at work for {time.monotonic() - begun:.0f} s", flush=True)
    if pip.returncode:
        raise NotPrepared(
            "The packages could not be installed; pip's own message stands above. Most often there is no connection. "
            "Type the same command again when there is: what has been fetched is kept."
        )
    command_line = python.with_name("coursework.exe" if os.name == "nt" else "coursework")
    print(f"  packages: {time.monotonic() - begun:.0f} s. From now on the command is {command_line}", flush=True)


def still_at_work(process: subprocess.Popen[bytes]) -> bool:
    """Return whether a process has not ended after another `SILENCE`."""
    try:
        process.wait(SILENCE)
    except subprocess.TimeoutExpired:
        return True
    return False


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
