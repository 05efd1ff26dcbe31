"""One budget of processor time and memory over a run, and what happens when it is spent.

Enters: limits and the name of the file.  Leaves: nothing, or `BudgetSpent` in the run that is watched.  Used by `commands/`.

Processor time is that of the whole process, on every system.  Memory is what the process holds beyond what it held at the
start: on Linux and Windows what it holds now, elsewhere (macOS) the most it has held so far; where the system tells neither,
memory is not watched.
"""

from __future__ import annotations

import _thread
import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

from coursework.system.file_set import discard_all
from coursework.system.frozen import frozen
from coursework.system.on_demand import UNDER_WAY
from coursework.words.errors import CourseworkError, Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import load_phrases, say

PACE = 0.1  # s between two looks
GRACE = 5.0  # s that a run has to clear up by itself, before the process is ended around it
MIB = 2**20
WRONG_INPUT = 2
SWALLOWING = ("weakref", "_weakrefset", "importlib")  # where callbacks and half-read files swallow what is raised


class BudgetSpent(CourseworkError):
    """A run took more time or memory than it may."""


class Ended(BaseException):
    """Raised wherever the run happens to be; no library's `except Exception` holds it up.

    Who catches it on its way has `GRACE` seconds.
    """


@frozen
class Budget:
    """`seconds` of processor time; `memory` in MiB beyond the start."""

    seconds: float = 60.0
    memory: float = 1024.0


@contextmanager
def watched(budget: Budget, name: str, last_word: Callable[[Fault], None] | None = None) -> Iterator[None]:
    """Watch what is done inside; it ends with `BudgetSpent` once it has taken more than the budget.

    Where the run does not answer (a library that computes without looking up), unfinished files are removed, `last_word` is
    called with the fault, and the process ends with status 2.  To be used in the main thread, where signals arrive.
    """
    watch = _Watch(budget, name, last_word or _say_last)
    before = signal.signal(signal.SIGTERM, watch.answer)
    try:
        try:
            watch.start()
            yield
        finally:
            watch.stop()
            signal.signal(signal.SIGTERM, before)
    except Ended:
        raise BudgetSpent([watch.fault] if watch.fault else []) from None


class _Watch(threading.Thread):
    def __init__(self, budget: Budget, name: str, last_word: Callable[[Fault], None]) -> None:
        super().__init__(daemon=True)
        self.budget, self.of, self.last_word = budget, name, last_word
        self.begun, self.held = time.process_time(), memory_held()
        self.fault: Fault | None = None
        self._raised = False
        self._done = threading.Event()

    def run(self) -> None:
        while not self._done.wait(PACE):
            if spent := self._spent():
                self.fault = spent
                last = time.monotonic() + GRACE
                while not self._raised and time.monotonic() < last:
                    _thread.interrupt_main(signal.SIGTERM)
                    self._done.wait(PACE)
                if not self._done.wait(max(0.0, last - time.monotonic())):
                    self._end_process(spent)
                return

    def stop(self) -> None:
        """Stop watching; an end that was called for in this very moment arrives here."""
        self._done.set()
        self.join()

    def answer(self, number: int, frame: FrameType | None) -> None:
        """End the run, in the main thread; a SIGTERM of somebody else ends it as an interrupt does.

        Where Python swallows what is raised it is left to the next time: the watch asks again.
        """
        if self.fault:
            if frame is not None and str(frame.f_globals.get("__name__")).startswith(SWALLOWING):
                return
            self._raised = True
            raise Ended
        raise KeyboardInterrupt

    def _spent(self) -> Fault | None:
        if time.process_time() - self.begun > self.budget.seconds:
            return Fault(out_of_time(self.budget.seconds), self.of)
        held = memory_held()
        if held is not None and self.held is not None and held - self.held > self.budget.memory * MIB:
            return Fault(say("fault.E002", limit=f"{self.budget.memory:g}", stage=_stage()), self.of)
        return None

    def _end_process(self, fault: Fault) -> None:
        discard_all()
        self.last_word(fault)
        os._exit(WRONG_INPUT)


def out_of_time(seconds: float) -> Sentence:
    """Return what is told of a run whose processor time is spent."""
    return say("fault.E001", limit=f"{seconds:g}", stage=_stage())


def _say_last(fault: Fault) -> None:
    if sys.stderr is not None:
        sys.stderr.write(f"{fault}\n")
        sys.stderr.flush()


def _stage() -> str:
    """Return what the run is doing, in words."""
    name = UNDER_WAY[-1] if UNDER_WAY else "other"
    key = f"ended.stage.{name}"
    return say(key) if load_phrases().has(key) else name.replace("_", " ")


def memory_held() -> int | None:
    """Return how many bytes of memory this process holds, None where the system does not tell."""
    if sys.platform == "win32":
        return _working_set()
    try:
        with open("/proc/self/statm", encoding="ascii") as file:  # noqa: PTH123  read ten times a second
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError):
        pass
    try:
        import resource
    except ImportError:
        return None
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else most * 1024


def limit_memory(mib: float, held: int = 0) -> None:
    """Bound the address space of this process at so much beyond what it has `held` (bytes), where the platform can."""
    try:
        import resource
    except ImportError:  # Windows: the limit of time is what remains
        return
    resource.setrlimit(resource.RLIMIT_AS, (held + int(mib) * MIB, resource.getrlimit(resource.RLIMIT_AS)[1]))


def _working_set() -> int | None:
    """Return the working set of this process on Windows (bytes)."""
    import ctypes

    class Counters(ctypes.Structure):
        # PROCESS_MEMORY_COUNTERS of the Windows API, psapi.h
        _fields_ = (
            ("size", ctypes.c_uint32), ("page_faults", ctypes.c_uint32),
            *((name, ctypes.c_size_t) for name in (
                "peak_working_set", "working_set", "quota_peak_paged", "quota_paged", "quota_peak_nonpaged",
                "quota_nonpaged", "pagefile", "peak_pagefile",
            )),
        )  # fmt: skip

    kernel: Any = getattr(ctypes, "windll").kernel32  # noqa: B009  exists on Windows only
    kernel.GetCurrentProcess.restype = ctypes.c_void_p
    kernel.K32GetProcessMemoryInfo.argtypes = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32)
    counters = Counters(size=ctypes.sizeof(Counters))
    if not kernel.K32GetProcessMemoryInfo(kernel.GetCurrentProcess(), ctypes.byref(counters), counters.size):
        return None
    return int(counters.working_set)
