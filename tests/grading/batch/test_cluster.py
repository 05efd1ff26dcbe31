"""The same bytes from a Dask cluster, and a worker that is killed loses nothing and doubles nothing."""

import json
import os
import signal
import threading
import time
from contextlib import nullcontext

import pytest
from click.testing import CliRunner

from coursework.commands.cli import main
from tests.grading.batch.classroom import hand_in, small_class
from tests.grading.batch.in_this_process import in_this_process


@pytest.fixture(scope="module")
def cluster():
    import distributed  # half a second for every process that collects this file

    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as running:
        yield running


def grade(source, out, *options):
    """Mark on a cluster or, where none is named, in this process: `test_batch.py` asks that several write the same."""
    with nullcontext() if "--scheduler" in options else in_this_process():
        done = CliRunner().invoke(main, ["grade", str(source), "--variant", "31", "--out", str(out), *options])
    assert done.exit_code == 0, done.output
    return done


@pytest.mark.filterwarnings("ignore")
def test_the_cluster_writes_the_same_bytes(cluster, tmp_path):
    source = small_class(tmp_path / "in")
    grade(source, tmp_path / "serial", "--language", "uk")
    grade(source, tmp_path / "cluster", "--scheduler", cluster.scheduler_address, "--language", "uk")
    serial, found = (
        {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        for folder in (tmp_path / "serial", tmp_path / "cluster")
    )
    assert found == serial


@pytest.mark.filterwarnings("ignore")
def test_a_killed_worker_loses_nothing_and_doubles_nothing(cluster, tmp_path, monkeypatch):
    from coursework.grading.batch import workers

    monkeypatch.setattr(workers, "CHUNK", 2)
    source, out = tmp_path / "in", tmp_path / "out"
    for number in range(12):
        hand_in(source / f"st{number:02d}")
    victims = [worker.process.pid for worker in cluster.workers.values() if hasattr(worker, "process")]

    def kill():
        journal = out / "journal.jsonl"
        while not (journal.is_file() and journal.stat().st_size):
            time.sleep(0.05)
        os.kill(victims[0], signal.SIGKILL)

    killer = threading.Thread(target=kill, daemon=True)
    killer.start()
    grade(source, out, "--scheduler", cluster.scheduler_address)
    killer.join(timeout=30)
    entries = json.loads((out / "grades.json").read_text(encoding="utf-8"))["submissions"]
    assert [entry["id"] for entry in entries] == sorted(f"st{number:02d}" for number in range(12))
    assert {entry["status"] for entry in entries} == {"graded"}
    grade(source, tmp_path / "serial")
    for name in ("grades.json", "grades.csv", "class.html", "journal.jsonl", "feedback/st07.html"):
        assert (out / name).read_bytes() == (tmp_path / "serial" / name).read_bytes()


def test_no_scheduler_is_told_in_a_sentence(tmp_path, monkeypatch):
    hand_in(tmp_path / "in" / "ada")
    from coursework.grading.batch import workers

    monkeypatch.setattr(workers, "PATIENCE", 1)
    options = ["--variant", "31", "--out", str(tmp_path / "out"), "--scheduler", "tcp://127.0.0.1:9"]
    done = CliRunner().invoke(main, ["grade", str(tmp_path / "in"), *options])
    assert done.exit_code == 2
    assert "no scheduler answers at tcp://127.0.0.1:9" in done.output
