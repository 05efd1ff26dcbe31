"""What the processes of a pool do in `test_pool.py`: answer, die, hang, leak or lie, as a job says."""

from __future__ import annotations

import os
import sys
import time
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from coursework.system.processes import pool_process


@dataclass(frozen=True, slots=True)
class Job:
    name: str
    does: str = ""


@dataclass(frozen=True, slots=True)
class Told:
    """Which job was done, and by which process."""

    name: str
    pid: int


@contextmanager
def opened(folder):
    def work(job: dict[str, Any]):
        name, does = job["name"], job["does"]
        Path(folder, f"{name}.{os.getpid()}").touch()
        print("noise", flush=True)
        match does.split():
            case ["spent"]:
                os._exit(2)
            case ["die"]:
                os._exit(7)
            case ["once"] if len(list(Path(folder).glob(f"{name}.*"))) == 1:
                os._exit(7)
            case ["wait", seconds]:
                time.sleep(float(seconds))
            case ["compute", seconds]:
                end = time.process_time() + float(seconds)
                while time.process_time() < end:
                    pass
            case ["until", there]:
                while not Path(folder, there).exists():
                    time.sleep(0.01)
            case ["held", mib]:
                pool_process.memory_held = lambda: int(mib) * 2**20
            case ["take", mib]:
                return Told(name, len(bytearray(int(mib) * 2**20)))
            case ["long", size]:
                return Told("x" * int(size), 0)
            case ["read"]:
                return Told(repr(sys.stdin.read()), 0)
            case ["another"]:
                return {"name": name, "pid": 0, "more": 1}
        return Told(name, os.getpid())

    yield work
    Path(folder, "put away").touch()
