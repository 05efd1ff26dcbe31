"""The real child, in which some names of students do what a hostile or broken file might one day do."""

import os
import sys
import time
from pathlib import Path

from coursework.grading.batch import child, workshop

_grade = workshop.Workshop.grade
held = [100]  # MiB, said to be held


def grade(self, submission, source):
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
    return _grade(self, submission, source)


workshop.Workshop.grade = grade
child.most_memory = lambda: held[0]

if __name__ == "__main__":
    sys.exit(child.main())
