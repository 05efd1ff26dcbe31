"""`coursework edit` and `coursework serve`: the desk in the browser.

Enters: the options of the two commands.  Leaves: a server until Ctrl-C.  Used by `cli.py`.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from coursework.commands.line.screen import tell
from coursework.system.extras import installing_extra
from coursework.system.processes.budget import Budget
from coursework.words.errors import InputError
from coursework.words.sentences import say

SERVERS = ("starlette", "uvicorn", "watchfiles")
BUDGET_OF_OTHERS = Budget(5.0, 512.0)  # for one text on a desk that is open to others


def edit(name: str, *, port: int, no_browser: bool, budget: float, memory: float, language: str) -> int:
    """Open the desk over the files of this folder."""
    _require_extra()
    from coursework.desk.job import Policy
    from coursework.desk.serving.application import Wish
    from coursework.desk.serving.server import serve

    serve(Wish(port, Budget(budget, memory), Policy(), name, Path.cwd(), language=language, browser=not no_browser), _told)
    return 0


def serve(
    *, host: str, port: int, workers: int | None, root_path: str, proxy: bool, hosts: tuple[str, ...], policy: Path | None,
    language: str,
) -> int:  # fmt: skip
    """Serve the desk to others."""
    _require_extra()
    from coursework.desk.job import Policy
    from coursework.desk.policy import read_policy
    from coursework.desk.serving.application import Wish
    from coursework.desk.serving.server import serve

    root = "/" + root_path.strip("/") if root_path.strip("/") else ""
    offered = read_policy(policy) if policy else Policy()
    serve(Wish(port, BUDGET_OF_OTHERS, offered, "", None, host, workers, root, proxy, hosts, language), _told)
    return 0


def _told(sentence: str) -> None:
    tell(sentence, err=True)


def _require_extra() -> None:
    """Raise `InputError` with the command that installs the server packages, if one is missing."""
    if any(find_spec(name) is None for name in SERVERS):
        raise InputError(say("fault.C080", command=installing_extra("desk")))
