"""What the journal knows a work by stays from one version of the program to the next: else a class is marked anew for nothing."""

from coursework.grading.batch import work
from coursework.grading.batch.decisions import Override
from coursework.grading.batch.work import Setup, Task, VariantSource
from coursework.grading.reading.documents.pdf import pdf
from coursework.grading.reading.submission import Submission, note, submitted_file
from coursework.words.sentences import say


def test_the_key_of_a_work_is_what_it_was(monkeypatch):
    monkeypatch.setattr(work, "VERSION", "0")
    monkeypatch.setattr(work, "GRADING_VERSION", 2)
    monkeypatch.setattr(pdf, "is_readable", lambda: True)
    files = (
        submitted_file("table.csv", b"t;phi1\r\n\xff\x00"),
        submitted_file("скан.pdf", b"%PDF", say("feedback.part.table"), 9_000_000),
    )
    review = say("reading.review.resubmitted", names=("a", say("feedback.part.table")))
    submission = Submission("Ім'я", None, files, (note("attachment", name="скан.pdf", why=""),), review)
    task = Task(submission, VariantSource("31", b"x=1\n", {"law.csv": b"0;1\n"}), (Override("total", 5.5, "read on paper"),))
    assert task.key(Setup("points = 50", True, {}, 1024, {"page.css": b"a{}"}, "uk")).split() == [
        "e094d55545694040d6545a27f15061eb", "34f4a1e14e12d67c099d6aa1be156d43", "26eb3a82d928e07376735ec51611312f",
        "47a74f1edd4e0484de3f159651e95058", "c6459a4a6fd8bfab24b9234a45991ee8",
    ]  # fmt: skip
