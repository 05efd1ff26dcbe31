"""From a fresh checkout to a first result with Python alone: a virtual environment, the package, then the job.

    python -m coursework.bootstrap run 31      any command of `coursework`
    python -m coursework.bootstrap test        the tests

Uses the standard library only and is the same on Windows, macOS and Linux.
"""

from __future__ import annotations

import os
import subprocess
import sys
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HOME = ROOT / ".venv"


def python_of(home: Path) -> Path:
    """Return the interpreter of a virtual environment."""
    return home / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def prepare(extra: str) -> Path:
    """Make the environment and install the package into it (again where pyproject.toml has changed); return its Python."""
    python = python_of(HOME)
    if not python.exists():
        venv.create(HOME, with_pip=True)
    stamp = HOME / f"installed{extra or '-plain'}.txt"
    wanted = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    if not stamp.exists() or stamp.read_text(encoding="utf-8") != wanted:
        command = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--editable", f"{ROOT}{extra}"]
        subprocess.run(command, check=True)
        stamp.write_text(wanted, encoding="utf-8")
    return python


def main(arguments: list[str]) -> int:
    """Prepare, then run a command of `coursework`, or the tests."""
    if not arguments:
        print(__doc__)
        return 2
    try:
        python = prepare("[test]" if arguments[0] == "test" else "")
    except subprocess.CalledProcessError:
        print("The packages could not be installed. pip's own message stands above; most often there is no connection.")
        return 3
    if arguments[0] == "test":
        return subprocess.run([str(python), "-m", "pytest", *arguments[1:]], cwd=ROOT).returncode
    return subprocess.run([str(python), "-m", "coursework", *arguments]).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
