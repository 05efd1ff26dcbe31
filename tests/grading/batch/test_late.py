"""Work after the deadline: just inside and outside grace and a day, in any zone and language; what nobody knows costs nothing."""

import json
import os
import zipfile
from datetime import datetime, timedelta

import jsonschema
import pytest

from coursework.grading.marking.rubric import read_rubric
from coursework.grading.platforms.moodle_times import moodle_time
from coursework.words.errors import InputError
from tests.grading.batch.classroom import hand_in
from tests.grading.batch.test_batch import grade, rows, submissions
from tests.grading.batch.test_decided import SCHEMA, SHEET
from tests.grading.marking import students

RUBRIC = '[late]\ndeadline = 2026-12-01T23:59:00+08:00\ngrace = "15 min"\nlost_per_day = 0.1\nat_most = 0.25\n'


@pytest.mark.parametrize(
    ("time", "minutes", "share"),
    [
        ("2026-12-01T23:59:00", None, 0), ("2026-12-02T00:14:00", None, 0), ("2026-12-02T00:15:00", 16, 0.1),
        ("2026-12-02T00:14:01", 16, 0.1), ("2026-12-02T23:59:00", 1440, 0.1), ("2026-12-03T00:00:00", 1441, 0.2),
        ("2026-12-03T23:59:00", 2880, 0.2), ("2026-12-04T00:00:00", 2881, 0.25), ("2027-12-04T00:00:00", 528481, 0.25),
        ("2026-12-01T16:14:00+00:00", None, 0), ("2026-12-01T16:15:00+00:00", 16, 0.1), ("2026-12-01T11:15:00-05:00", 16, 0.1),
        ("late", None, 0.1), ("unknown", None, 0), ("", None, 0),
    ],
)  # fmt: skip
def test_begun_days_count_from_the_deadline_and_grace_costs_nothing(time, minutes, share):
    late = read_rubric(RUBRIC).late
    assert late.share(time) == ((minutes, pytest.approx(share)) if share else None)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("deadline = 2026-12-01T23:59:00", "a date with its offset"),
        ('deadline = "2026-12-01T23:59:00"', "a date with its offset"),
        ('deadline = "soon"', "a date with its offset"),
        ('grace = "1 h"', "a date with its offset"),
        ("deadline = 2026-12-01T23:59:00Z\ngrace = 15", 'a span such as "15 min"'),
        ('deadline = 2026-12-01T23:59:00Z\ngrace = "a week"', 'found "a week"'),
        ("deadline = 2026-12-01T23:59:00Z\nat_most = 1.01", "from 0 to 1"),
        ("deadline = 2026-12-01T23:59:00Z\nlost_a_day = 1", 'Did you mean "lost_per_day"?'),
    ],
)
def test_a_deadline_that_cannot_be_meant_is_refused(text, told):
    with pytest.raises(InputError) as fault:
        read_rubric(f"[late]\n{text}\n")
    assert told in str(fault.value)


def test_a_deadline_may_be_a_string():
    text = RUBRIC.replace("2026-12-01T23:59:00+08:00", '"2026-12-01T23:59:00+08:00"')
    assert read_rubric(text) == read_rubric(RUBRIC)


@pytest.mark.parametrize(
    "text",
    [
        "Tuesday, 1 December 2026, 11:59 PM", "Tuesday, 1 December 2026, 23:59", "вторник, 1 декабря 2026, 23:59",
        "вівторок, 1 грудня 2026, 23:59", "Dienstag, 1. Dezember 2026, 23:59", "mardi 1 décembre 2026, 23:59",
        "martes, 1 de diciembre de 2026, 23:59", "2026年12月1日 星期二 23:59", "2026年12月1日 星期二 下午11:59",
        "вторник, 1 декабря 2026 г., 23:59", "2026-12-01 23:59", "Tuesday,\u00a01 December 2026, 11:59\u202fPM",
    ],
)  # fmt: skip
def test_times_of_moodle_in_seven_languages(text):
    assert moodle_time(text) == datetime(2026, 12, 1, 23, 59)


MONTHS = {
    "en": "January February March April May June July August September October November December",
    "ru": "января февраля марта апреля мая июня июля августа сентября октября ноября декабря",
    "uk": "січня лютого березня квітня травня червня липня серпня вересня жовтня листопада грудня",
    "de": "Januar Februar März April Mai Juni Juli August September Oktober November Dezember",
    "fr": "janvier février mars avril mai juin juillet août septembre octobre novembre décembre",
    "es": "enero febrero marzo abril mayo junio julio agosto septiembre octubre noviembre diciembre",
}


@pytest.mark.parametrize("language", MONTHS)
def test_every_month_of_every_language(language):
    for number, name in enumerate(MONTHS[language].split(), start=1):
        between = " de " if language == "es" else " "
        assert moodle_time(f"x, 7{between}{name}{between}2026, 08:05") == datetime(2026, number, 7, 8, 5), name


@pytest.mark.parametrize(
    ("text", "hour"), [("12:05 AM", 0), ("12:05 PM", 12), ("1:05 AM", 1), ("1:05 PM", 13), ("1:05", 1), ("13:05 PM", 13)]
)
def test_noon_and_midnight(text, hour):
    assert moodle_time(f"Friday, 1 May 2026, {text}") == datetime(2026, 5, 1, hour, 5)


@pytest.mark.parametrize(
    "text", ["-", "", "1 Foo 2026, 10:00", "31 June 2026, 10:00", "1 May 2026", "1 May 2026, 25:00", "x" * 9999]
)
def test_what_is_no_time_is_none(text):
    assert moodle_time(text) is None


DEADLINE = datetime.fromisoformat("2026-12-01T23:59:00+08:00")


def changed(folder, *times):
    """Give the files of a folder times of their last change, by name; the last of these to the rest."""
    for number, file in enumerate(sorted(folder.iterdir())):
        time = times[min(number, len(times) - 1)].timestamp()
        os.utime(file, (time, time))


def moodle_class(root, times):
    """Return the arguments of a class with a worksheet, a student a time."""
    lines = []
    for number, time in enumerate(times, start=7000):
        folder = root / "in" / f"Ann {number}_{number}_assignsubmission_file"
        hand_in(folder, students.slip(10, 1, 1.05))
        changed(folder, DEADLINE - timedelta(days=1))
        lines.append(f'Participant {number},Ann {number},a@x,s,,100.00,Yes,"{time}",-,\r\n')
    (root / "sheet.csv").write_bytes((SHEET + "".join(lines)).encode())
    (root / "rubric.toml").write_text(RUBRIC, encoding="utf-8")
    return root / "in", root / "out", "--worksheet", root / "sheet.csv", "--rubric", root / "rubric.toml"


def moodle(after):
    return f"{datetime(2026, 12, 1, 23, 59) + timedelta(minutes=after):%A, %d %B %Y, %I:%M %p}"


def test_a_late_class(tmp_path):
    arguments = moodle_class(tmp_path, [moodle(0), moodle(15), moodle(16), moodle(1441), moodle(99999), "-"])
    done = grade(*arguments)
    assert done.exit_code == 0, done.output
    assert "the times of their files, which copying may have changed: 1." in done.output
    assert "not known" not in done.output
    out = tmp_path / "out"
    jsonschema.validate(json.loads((out / "grades.json").read_text(encoding="utf-8")), SCHEMA)
    found = list(submissions(out).values())
    assert [entry["late"] for entry in found] == [
        None, None, {"minutes": 16, "lost": 10.0}, {"minutes": 1441, "lost": 20.0}, {"minutes": 99999, "lost": 25.0}, None,
    ]  # fmt: skip
    for entry in found:
        lost = entry["late"]["lost"] if entry["late"] else 0
        earned = entry["table"]["score"] + entry["equations"]["score"]
        assert entry["score"] == pytest.approx(earned - lost, abs=0.006)
        said = [note["text"] for note in entry["notes"] if note["code"] == "late"]
        assert len(said) == (entry["late"] is not None or entry is found[-1])
        page = (out / entry["page"]).read_text(encoding="utf-8")
        assert all(text in page for text in said)
    assert "its newest file was last changed on 2026-11-30 23:59" in found[-1]["notes"][-1]["text"]
    page = (out / found[2]["page"]).read_text(encoding="utf-8")
    assert '<th scope="row">late</th><td>−10</td>' in page
    assert "(0 d 0 h 16 min): 10 of 100 points are lost." in rows(out)[found[2]["id"]]["sentence"]
    assert "(69 d 10 h 39 min): 25 of 100" in rows(out)[found[4]["id"]]["sentence"]
    assert "Marked now: 0" in grade(*arguments).output
    sheet = tmp_path / "sheet.csv"
    sheet.write_bytes(sheet.read_bytes().replace(moodle(16).encode(), moodle(15).encode()))
    assert "Marked now: 1" in grade(*arguments).output
    assert submissions(out)[found[2]["id"]]["late"] is None


def test_the_total_that_the_instructor_decides_is_the_last_word_and_parts_are_not(tmp_path):
    arguments = moodle_class(tmp_path, [moodle(16), moodle(16), moodle(16)])
    ids = ["7000", "7001", "7002"]  # Moodle's numbers; a decision may name the folder, too
    folder = "Ann 7000_7000_assignsubmission_file"
    decided = tmp_path / "overrides.csv"
    lines = [f"{folder},total,50,x", f"{ids[1]},table,50,x", f"{ids[2]},table,0,x", f"{ids[2]},equations,4,x"]
    decided.write_text("\n".join(["id,check,points,reason", *lines]), encoding="utf-8")
    assert grade(*arguments, "--overrides", decided).exit_code == 0
    found = submissions(tmp_path / "out")
    assert [(found[one]["score"], found[one]["late"]["lost"]) for one in ids] == [(50, 0), (80, 10), (0, 4)]  # never below 0


def test_without_the_section_time_does_not_matter(tmp_path):
    arguments = moodle_class(tmp_path, [moodle(99999)])
    assert grade(*arguments[:4]).exit_code == 0
    (found,) = submissions(tmp_path / "out").values()
    assert (found["late"], found["score"] > 99) == (None, True)


def test_canvas_says_who_is_late(tmp_path):
    hand_in(tmp_path / "made")
    (tmp_path / "in").mkdir()
    for name in ("leeann_LATE_101_1", "raybob_102_2"):
        for file in ("table.csv", "equations.txt"):
            (tmp_path / "in" / f"{name}_{file}").write_bytes((tmp_path / "made" / file).read_bytes())
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(RUBRIC, encoding="utf-8")
    export = tmp_path / "export.csv"
    lines = ["Student,ID,Coursework (555)", "    Points Possible,,100", '"Bob, Ray",102,', '"Lee, Ann",101,EX', '"No, One",103,7']
    export.write_text("\n".join(lines), encoding="utf-8")
    assert grade(tmp_path / "in", tmp_path / "out", "--rubric", rubric, "--canvas", export).exit_code == 0
    filled = (tmp_path / "out" / "canvas.csv").read_text(encoding="utf-8-sig").splitlines()
    assert filled == [*lines[:2], '"Bob, Ray",102,100', *lines[3:]]  # who is excused, and who has handed in nothing, stay
    found = submissions(tmp_path / "out")
    assert (found["101"]["late"], found["101"]["score"]) == ({"minutes": None, "lost": 10.0}, 90)
    assert (found["102"]["late"], found["102"]["score"], found["102"]["notes"]) == (None, 100, [])


@pytest.mark.parametrize("zipped", [False, True])
def test_where_no_platform_says_when_the_newest_file_does(tmp_path, zipped):
    """A zip has no zone: its times are of the deadline's.  The least time that it can have says nothing."""
    source, none = tmp_path / "in", datetime(1980, 1, 1)
    after = {"ann": (-30, -20), "bob": (-3000, 1500), "cid": (16, 14), "dan": (14,), "eve": None}
    for name, minutes in after.items():
        hand_in(source / name)
        changed(source / name, *([DEADLINE + timedelta(minutes=one) for one in minutes] if minutes else [DEADLINE]))
    if zipped:
        with zipfile.ZipFile(tmp_path / "in.zip", "w") as archive:
            for name, minutes in after.items():
                for number, file in enumerate(sorted((source / name).iterdir())):
                    local = DEADLINE + timedelta(minutes=minutes[min(number, len(minutes) - 1)]) if minutes else none
                    archive.writestr(zipfile.ZipInfo(f"{name}/{file.name}", local.timetuple()[:6]), file.read_bytes())
        source = tmp_path / "in.zip"
    (tmp_path / "rubric.toml").write_text(RUBRIC, encoding="utf-8")
    done = grade(source, tmp_path / "out", "--rubric", tmp_path / "rubric.toml")
    assert done.exit_code == 0, done.output
    found = submissions(tmp_path / "out")
    assert [found[name]["late"] for name in ["ann", "bob", "cid", "dan"]] == [
        None, {"minutes": 1500, "lost": 20.0}, {"minutes": 16, "lost": 10.0}, None,
    ]  # fmt: skip
    assert found["eve"]["late"] is None
    times = {"ann": "2026-12-01 23:39", "bob": "2026-12-03 00:59", "cid": "2026-12-02 00:15", "dan": "2026-12-02 00:13"}
    for name, time in times.items():
        page = (tmp_path / "out" / found[name]["page"]).read_text(encoding="utf-8")
        assert f"No platform says when this was handed in; its newest file was last changed on {time}" in page
    page = (tmp_path / "out" / found["eve"]["page"]).read_text(encoding="utf-8")
    assert ("When this was handed in is not known; nothing was deducted." in page) is zipped
    assert f"may have changed: {5 - zipped}." in done.output
    assert ("Submissions whose time is not known, nothing deducted: 1." in done.output) is zipped
    assert "Marked now: 0" in grade(source, tmp_path / "out", "--rubric", tmp_path / "rubric.toml").output


@pytest.mark.parametrize(("name", "score"), [("leeann_LATE_101_1_", 90), ("", 100)])
def test_gradescope_gets_what_is_lost_as_a_test_of_its_own(tmp_path, name, score):
    hand_in(tmp_path / "in")
    for file in ("table.csv", "equations.txt"):
        (tmp_path / "in" / file).rename(tmp_path / "in" / f"{name}{file}")
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(RUBRIC, encoding="utf-8")
    done = grade(tmp_path / "in", tmp_path / "out", "--results", "gradescope", "--rubric", rubric)
    assert done.exit_code == 0, done.output
    results = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert results["score"] == score
    assert sum(test["score"] for test in results["tests"]) == score
    assert [test["score"] for test in results["tests"] if test["name"] == "late"] == ([-10.0] if name else [])
    assert ("is not known" in results["output"]) == (not name)


@pytest.mark.parametrize(
    ("metadata", "lost"),
    [
        ('{"created_at": "2026-12-01T08:13:22.365935-08:00", "users": []}', None),
        ('{"created_at": "2026-12-03T14:22:32.365935-08:00"}', -25.0), ('{"created_at": "2026-12-02T16:00:00Z"}', -20.0),
        ("[]", None), ("{", None), ('{"created_at": 5}', None), ('{"created_at": "soon"}', None), ("[" * 100_000, None),
    ],
)  # fmt: skip
def test_gradescope_says_when_it_was_handed_in(tmp_path, metadata, lost):
    hand_in(tmp_path / "submission")
    (tmp_path / "submission_metadata.json").write_text(metadata, encoding="utf-8")
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(RUBRIC, encoding="utf-8")
    done = grade(tmp_path / "submission", tmp_path / "results", "--results", "gradescope", "--rubric", rubric)
    assert done.exit_code == 0, done.output
    results = json.loads((tmp_path / "results" / "results.json").read_text(encoding="utf-8"))
    assert [test["score"] for test in results["tests"] if test["name"] == "late"] == ([lost] if lost else [])
    assert results["score"] == 100 + (lost or 0)
    assert ("is not known" in results["output"]) == ("created_at" not in metadata or "soon" in metadata or ": 5" in metadata)
