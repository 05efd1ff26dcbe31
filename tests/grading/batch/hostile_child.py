"""The real work of a process, in which some names of students do what a hostile or broken file might one day do."""

import os
import time
from pathlib import Path

from coursework.grading.batch import workshop
from coursework.system.processes import pool_process

_grade = workshop.Workshop.grade
held = [100]  # MiB, said to be held


def grade(self, submission, source, *more):
    name, once = submission.id, Path(os.environ["COURSEWORK_TEST_ONCE"])
    if name == "killer" or (name == "once" and not once.exists()):
        once.touch()
        os._exit(7)
    if name == "hang":
        time.sleep(600)
    if name == "hog":
        raise MemoryError
    if name.startswith("leaks "):
        held[0] = int(name.split()[1])
    print("noise on standard output", flush=True)
    return _grade(self, submission, source, *more)


workshop.Workshop.grade = grade
pool_process.memory_held = lambda: held[0] * 2**20
opened = workshop.opened
