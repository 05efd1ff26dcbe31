"""A budget of processor time and memory for one run, and the end of a run that exceeds it.

Enters: limits and the name of the file.  Leaves: nothing, or `BudgetSpent` raised in the watched run.  Used by `commands/`.

Processor time is that of the whole process, on every system.  Memory is counted beyond what the process held at the start:
on Linux and Windows its present memory, elsewhere (macOS) its peak so far.  If the system reports neither, memory is not
watched.
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

from coursework.system.files.file_set import discard_all
from coursework.system.frozen import frozen
from coursework.system.on_demand import UNDER_WAY
from coursework.words.errors import CourseworkError, Fault
from coursework.words.sentence import Sentence
from coursework.words.sentences import load_phrases, say

PACE = 0.1  # s between two checks of the budget
GRACE = 5.0  # s that a run has to clean up by itself before its process is ended
MIB = 2**20
WRONG_INPUT = 2
SWALLOWING = ("weakref", "_weakrefset", "importlib")  # modules whose callbacks and half-finished imports swallow exceptions


class BudgetSpent(CourseworkError):
    """A run took more time or memory than it may."""


class Ended(BaseException):
    """Raised in the main thread, wherever the run is; a `BaseException`, so that no library's `except Exception` stops it.

    Code that catches it on the way, for instance to clean up, has `GRACE` seconds.
    """


@frozen
class Budget:
    """Limits of a run: `seconds` of processor time, and `memory` in MiB beyond what the process held at the start."""

    seconds: float = 60.0
    memory: float = 1024.0


@contextmanager
def watched(budget: Budget, name: str, last_word: Callable[[Fault], None] | None = None) -> Iterator[None]:
    """Watch the code inside the `with` block; raise `BudgetSpent` there once it exceeds the budget.

    If the run does not react (a library may compute without checking for signals), unfinished files are removed, `last_word` is
    called with the fault, and the process ends with status 2.  Must be used in the main thread, where signals arrive.
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
        """Stop watching; a signal sent at this very moment may still raise `Ended` here."""
        self._done.set()
        self.join()

    def answer(self, number: int, frame: FrameType | None) -> None:
        """Handle SIGTERM in the main thread: raise `Ended` if the budget is spent, else `KeyboardInterrupt`.

        Where Python would swallow the exception, nothing is raised: the watch sends the signal again.
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
    """Return the message for a run that has spent its processor time."""
    return say("fault.E001", limit=f"{seconds:g}", stage=_stage())


def _say_last(fault: Fault) -> None:
    if sys.stderr is not None:
        sys.stderr.write(f"{fault}\n")
        sys.stderr.flush()


def _stage() -> str:
    """Return in words what the run is computing now."""
    name = UNDER_WAY[-1] if UNDER_WAY else "other"
    key = f"ended.stage.{name}"
    return say(key) if load_phrases().has(key) else name.replace("_", " ")


def memory_held() -> int | None:
    """Return the memory (bytes) that this process holds (its peak, if only that is known), None if the system does not tell."""
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
    """Limit the address space of this process to `held` bytes plus `mib` MiB, where the platform supports it."""
    try:
        import resource
    except ImportError:  # Windows: only the limit of time remains
        return
    resource.setrlimit(resource.RLIMIT_AS, (held + int(mib) * MIB, resource.getrlimit(resource.RLIMIT_AS)[1]))


def end_after(seconds: float | None) -> None:
    """Have the system end this process by SIGPROF once it has spent so much more processor time, where it can; never if None."""
    if sys.platform != "win32":
        signal.setitimer(signal.ITIMER_PROF, seconds or 0.0)


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
