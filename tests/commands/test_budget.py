"""A run ends when its budget is spent: with a sentence, status 2, and nothing unfinished left."""

import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from coursework.system.on_demand import under_way
from coursework.system.processes import budget
from coursework.system.processes.budget import Budget, BudgetSpent, memory_held, watched
from coursework.words.errors import Fault
from coursework.words.sentences import say
from tests.command import call

pytestmark = pytest.mark.usefixtures("folder")


def busy(seconds: float) -> None:
    begun = time.process_time()
    while time.process_time() - begun < seconds:
        pass


# Everything is imported before: an end that is called for inside an import can get lost there until the grace is over.
SPENT = """
import os, shutil, sys
import coursework.commands.accuracy
from coursework.commands.cli import main
from coursework.equations.reduction.structure import structures
from coursework.system.processes import budget

def status(*arguments):
    try:
        main(arguments)
    except SystemExit as end:
        return end.code

os.mkdir("first")
os.chdir("first")
assert status("run", "31") == 0
os.chdir("..")
shutil.rmtree("first")
print("spent", flush=True)
budget.PACE = 0.001
structures.cache_clear()  # of a template that this process knows, a table would be there in time
sys.exit(status(sys.argv[1], "31", "--budget", "0.005"))
"""


@pytest.mark.parametrize("command", ["run", "check", "accuracy"])
def test_a_run_over_its_budget_is_ended(command, folder):
    done = subprocess.run([sys.executable, "-c", SPENT, command], capture_output=True, check=False, timeout=60)
    assert done.returncode == 2
    told, said = done.stderr.decode(), done.stdout.decode().partition("spent\n")[2]
    assert told.startswith("E001 31  ended after 0.005 s of processor time, in ")
    assert told.endswith(" (limit --budget 0.005).\n")
    assert all(path.name in said for path in folder.rglob("*")), "what is left was whole by then, and is told"


def test_the_sentence_says_what_was_being_done():
    with pytest.raises(BudgetSpent) as ended, watched(Budget(0.05, 1000), "31.toml"), under_way("accelerations"):
        busy(20)
    assert str(ended.value) == "E001 31.toml  ended after 0.05 s of processor time, in second derivatives (limit --budget 0.05)."


def test_memory_beyond_the_start_is_limited():
    held = []
    sentence = r"^E002 m  ended, as it took more than 30 MiB of memory, in .* \(limit --memory 30\)\.$"
    with pytest.raises(BudgetSpent, match=sentence), watched(Budget(60, 30), "m"):
        while True:
            held.append(b"x" * 2**20)
            time.sleep(0.005)
    assert 20 < len(held) < 400


def test_what_stays_inside_its_budget_is_left_alone():
    before = signal.getsignal(signal.SIGTERM)
    with watched(Budget(30, 1000), "31"):
        busy(0.25)
    assert signal.getsignal(signal.SIGTERM) is before


def test_no_fault_inside_is_mistaken_for_a_spent_budget():
    with pytest.raises(ZeroDivisionError), watched(Budget(30, 1000), "31"):
        _ = 1 / 0
    with pytest.raises(KeyboardInterrupt), watched(Budget(30, 1000), "31"):
        signal.raise_signal(signal.SIGTERM)  # somebody ends the process: as an interrupt


def test_memory_held_is_that_of_the_process():
    before = memory_held()
    assert before is not None
    block = bytearray(64 * 2**20)
    block[::4096] = b"x" * len(block[::4096])
    assert 50 * 2**20 < memory_held() - before < 100 * 2**20


# A library that answers nothing, as C code in a long call does.
DEAF = """
import sys, time
from pathlib import Path
from types import SimpleNamespace
from coursework.system.processes import budget
from coursework.system.files.file_set import working_folder
budget.GRACE = 0.2
with budget.watched(budget.Budget(0.1, 1000), "31.toml"), working_folder(Path("o")) as hidden:
    (hidden / "half").touch()
    while True:
        try:
            while True:
                pass
        except BaseException:
            pass
"""


def test_what_does_not_answer_is_ended_from_outside(folder):
    done = subprocess.run([sys.executable, "-c", DEAF], capture_output=True, check=False, timeout=60)
    assert done.returncode == 2
    assert done.stderr.decode().startswith("E001 31.toml  ended after 0.1 s of processor time, in ")
    assert list(Path("o").iterdir()) == []


@pytest.mark.parametrize("option", ["--budget", "--memory"])
@pytest.mark.parametrize("value", ["0", "-1", "x"])
def test_a_budget_is_a_number_above_zero(option, value):
    assert call("run", "31", option, value).exit_code == 2


def test_an_end_that_comes_within_a_callback_comes_again():
    """What is raised in the callback of an object that dies, Python prints and swallows."""
    frames = [SimpleNamespace(f_globals={"__name__": name}) for name in ("weakref", "importlib._bootstrap", "coursework.run")]
    watch = budget._Watch(Budget(), "mine", lambda fault: None)
    watch.fault = Fault(say("fault.W030"))
    for frame in frames[:2]:
        watch.answer(15, frame)
    assert not watch._raised
    with pytest.raises(budget.Ended):
        watch.answer(15, frames[2])
