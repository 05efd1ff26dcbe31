"""A pool loses no job, neither with its first worker nor with its second; its limits are where they are said to be."""

import sys
import threading
import time

import pytest

from coursework.system.processes import pool
from coursework.system.processes.pool import Pool, Trade, Worker
from tests.system.processes.jobs import Job, Told


def trade(folder, **limits):
    return Trade(
        "tests.system.processes.jobs:opened", str(folder), Told, lambda job, late: Told(job.name, -1 if late else 0), **limits
    )


def begun(folder, name):
    """Return the processes that have begun a job."""
    return [int(path.suffix[1:]) for path in folder.glob(f"{name}.*")]


def until(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.mark.parametrize("lost", [0, 1])
def test_the_work_of_a_worker_that_is_lost_is_done_by_another(tmp_path, lost):
    """Worker 0 and worker 1 each hold a job when one of them is killed: its job is done by another process, the rest go on."""
    with Pool(trade(tmp_path), 2) as two:
        held = [two.submit(Job(str(k), "until killed")) for k in range(2)]
        more = [two.submit(Job(f"more{k}")) for k in range(4)]
        until(lambda: all(begun(tmp_path, k) for k in range(2)))
        two._workers[lost]._child.kill()
        (tmp_path / "killed").touch()
        told = [future.result(60) for future in (*held, *more)]
    assert [found.name for found in told] == ["0", "1", "more0", "more1", "more2", "more3"]
    assert all(found.pid > 0 for found in told)
    (again,) = [k for k in range(2) if len(begun(tmp_path, k)) == 2]
    (killed,) = set(begun(tmp_path, again)) - {told[again].pid}
    assert killed not in {found.pid for found in told}
    assert begun(tmp_path, 1 - again) == [told[1 - again].pid]  # the other one has not been disturbed
    assert all(len(begun(tmp_path, f"more{k}")) == 1 for k in range(4))  # and nothing is done twice


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_every_job_is_answered_once_whatever_happens(tmp_path, workers):
    jobs = [Job("a"), Job("b", "die"), Job("c", "once"), Job("d"), Job("e", "another"), Job("f", "die"), Job("g"), Job("h")]
    with Pool(trade(tmp_path), workers) as some:
        found = list(some.answers((job.name, job) for job in jobs))
    assert sorted(key for key, _ in found) == list("abcdefgh")
    assert all(told.name == key for key, told in found)
    assert {key for key, told in found if not told.pid} == {"b", "e", "f"}
    assert {name: len(begun(tmp_path, name)) for name in "abcdefgh"} == dict(
        zip("abcdefgh", (1, 2, 2, 1, 2, 2, 1, 1), strict=True)
    )


@pytest.mark.parametrize(("tries", "pid"), [(1, False), (2, True)])
def test_so_many_tries(tmp_path, tries, pid):
    with Worker(trade(tmp_path, tries=tries)) as worker:
        assert bool(worker.answer(Job("a", "once")).pid) is pid


@pytest.mark.parametrize(("seconds", "late"), [(1, False), (60, True)])
def test_silence_is_ended_after_its_limit_and_not_tried_again(tmp_path, seconds, late):
    with Worker(trade(tmp_path, seconds=2)) as worker:
        worker.answer(Job("warm"))
        assert (worker.answer(Job("a", f"wait {seconds}")).pid == -1) is late
        assert worker.answer(Job("b")).pid > 0
    assert len(begun(tmp_path, "a")) == 1


@pytest.mark.parametrize(("seconds", "late"), [(1, False), (60, True)])
def test_a_process_may_take_its_time_to_start(tmp_path, monkeypatch, seconds, late):
    monkeypatch.setattr(pool, "STARTING", 3.0)
    with Worker(trade(tmp_path, seconds=0.5)) as worker:
        assert (worker.answer(Job("a", f"wait {seconds}")).pid == -1) is late


@pytest.mark.skipif(sys.platform == "win32", reason="the system tells no process that its time is spent")
@pytest.mark.parametrize(("does", "late"), [("wait 1", False), ("compute 0.2", False), ("compute 60", True)])
def test_time_that_the_machine_spends_on_others_is_not_counted(tmp_path, does, late):
    with Worker(trade(tmp_path, seconds=60, processor=0.5)) as worker:
        worker.answer(Job("warm"))
        assert (worker.answer(Job("a", does)).pid == -1) is late
    assert len(begun(tmp_path, "a")) == 1


@pytest.mark.parametrize(("mib", "enough"), [(100, True), (800, False)])
def test_memory_is_limited(tmp_path, mib, enough):
    with Worker(trade(tmp_path, memory=700)) as worker:
        assert worker.answer(Job("a", f"take {mib}")).pid == (mib * 2**20 if enough else 0)


@pytest.mark.parametrize(("mib", "kept"), [(355, True), (356, False)])
def test_a_process_that_has_grown_is_replaced(tmp_path, mib, kept):
    with Worker(trade(tmp_path)) as worker:
        first, grown, last = (worker.answer(Job(str(k), f"held {held}")) for k, held in enumerate((100, mib, 100)))
    assert first.pid == grown.pid
    assert (first.pid == last.pid) is kept


@pytest.mark.parametrize(("answers", "kept"), [(2, True), (3, False)])
def test_a_process_is_replaced_after_so_many_answers(tmp_path, monkeypatch, answers, kept):
    monkeypatch.setattr(pool, "REPLACED_AFTER", 3)
    with Worker(trade(tmp_path)) as worker:
        pids = [worker.answer(Job(str(k))).pid for k in range(answers + 1)]
    assert len({*pids[:-1]}) == 1
    assert (pids[0] == pids[-1]) is kept


@pytest.mark.parametrize(("size", "enough"), [(1900, True), (2100, False)])
def test_an_answer_has_an_end(tmp_path, monkeypatch, size, enough):
    monkeypatch.setattr(pool, "MOST_BYTES", 2000)
    with Worker(trade(tmp_path)) as worker:
        assert (len(worker.answer(Job("a", f"long {size}")).name) == size) is enough


def test_a_process_reads_no_jobs_by_itself_and_puts_away_what_it_has(tmp_path):
    with Worker(trade(tmp_path)) as worker:
        assert worker.answer(Job("a", "read")).name == "''"
        assert worker.answer(Job("b")).pid > 0
        assert not (tmp_path / "put away").exists()
    assert (tmp_path / "put away").exists()


def test_closing_ends_what_works_and_begins_nothing_more(tmp_path):
    before = threading.active_count()
    with Pool(trade(tmp_path), 2) as two:
        futures = [two.submit(Job(str(k), "wait 600")) for k in range(6)]
        until(lambda: begun(tmp_path, 0) and begun(tmp_path, 1))
        closing = time.monotonic()
    assert time.monotonic() - closing < 30
    assert [future.cancelled() for future in futures] == [False] * 2 + [True] * 4
    assert all(future.done() for future in futures)
    assert not any(begun(tmp_path, k) for k in range(2, 6))
    assert threading.active_count() == before
    assert all(worker._child is None for worker in two._workers)


def test_jobs_are_drawn_as_they_are_needed(tmp_path):
    drawn = []

    def jobs():
        for k in range(50):
            drawn.append(k)
            yield k, Job(str(k))

    with Pool(trade(tmp_path), 1) as one:
        answers = one.answers(jobs())
        next(answers)
        assert len(drawn) == pool.AHEAD
        next(answers)
        assert len(drawn) <= pool.AHEAD + 1
        answers.close()


def test_a_job_that_is_given_up_is_not_begun_or_its_process_is_ended_and_it_is_not_tried_again(tmp_path):
    with Pool(trade(tmp_path), 1) as one:
        jobs = [Job("long", "wait 60"), Job("queued"), Job("next")]
        under_way, queued, following = (one.submit(job) for job in jobs)
        until(lambda: begun(tmp_path, "long"))
        one.drop(queued, jobs[1])
        one.drop(under_way, jobs[0])
        assert under_way.result(60).pid == -1
        assert following.result(60).pid > 0
        assert queued.cancelled()
        one.drop(following, jobs[2])  # done long since: nothing happens
    assert (len(begun(tmp_path, "long")), begun(tmp_path, "queued"), one.ended) == (1, [], 1)


def test_a_process_that_has_spent_its_budget_is_not_tried_again(tmp_path):
    with Worker(trade(tmp_path)) as worker:
        assert worker.answer(Job("a", "spent")).pid == -1
        assert worker.answer(Job("b")).pid > 0
    assert len(begun(tmp_path, "a")) == 1


def test_processes_without_a_job_for_long_end_all_but_one(tmp_path):
    with Pool(trade(tmp_path), 3) as some:
        [future.result(60) for future in [some.submit(Job(str(k), "wait 0.3")) for k in range(3)]]
        alive = [worker for worker in some._workers if worker._child is not None]
        some.rest(60.0)
        assert [worker for worker in some._workers if worker._child is not None] == alive
        some.rest(0.0)
        assert len([worker for worker in some._workers if worker._child is not None]) == 1
        assert some.submit(Job("again")).result(60).pid > 0
