"""`coursework assign`: what a class gets, and that a run of each variant, handed in, earns full marks."""

import csv
import json
import re

import pymupdf
import pytest

import coursework
from coursework.report.graphs.strips import RIGHT, strip
from coursework.words.data_folders import folder
from tests.command import call
from tests.grading.batch.classroom import EQUATIONS
from tests.grading.batch.in_this_process import in_this_process
from tests.sample import first

ROSTER = (
    "id,name,email,group\n"
    "ada,Ada Lovelace,ada@example.org,ME-21\n"
    "Jörg/Ö,<script>x</script> Bob,j@example.org,ME-22\n"
    "=2+2,=HYPERLINK(1),x@example.org,\n"
)
STEMS = ("ada", "x-")


def assigned(folder, roster=ROSTER, *more, template="31", out="out"):
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    result = call("assign", folder / "roster.csv", "--template", template, "--seed", "2026", "--out", folder / out, *more)
    assert result.exit_code == 0, result.output
    assert ("workbooks/ID.xlsx" in result.output) is ("xlsx" in more)
    return folder / out


@pytest.fixture(scope="module")
def out(tmp_path_factory):
    return assigned(tmp_path_factory.mktemp("class"), ROSTER, "--pdf", "--deadline", "12 May <b>")


def lines(out):
    return list(csv.DictReader((out / "roster.csv").read_text(encoding="utf-8-sig").splitlines()))


def plain(text):
    return re.sub("[\u00a0\u202f\u2009]", " ", text)


def page_of(path):
    """Return a page without the marks of what stays on one line."""
    return re.sub(r"<bdi>(.*?)</bdi>", r"\1", plain(path.read_text(encoding="utf-8")))


def files(out):
    return {path.relative_to(out).as_posix(): path.read_bytes() for path in sorted(out.rglob("*")) if path.is_file()}


def test_what_is_written(out):
    names = set(files(out))
    stems = [line["variant"].removesuffix(".toml") for line in lines(out)]
    assert stems[0] == "ada"
    assert all(re.fullmatch(r"x-[0-9a-f]{16}", stem) for stem in stems[1:])
    each = {f"{folder}{stem}.{kind}" for stem in stems
            for folder, kind in (("", "toml"), ("sheets/", "html"), ("key/", "csv"), ("key/", "html"))}  # fmt: skip
    assert names == each | {"roster.csv", "class.html", "sheets.pdf"}


def test_the_roster_has_what_was_drawn_and_what_was_there(out):
    first, second, third = lines(out)
    assert list(first)[:6] == ["id", "name", "email", "variant", "least_decimals", "accepted_decimals"]
    assert list(first)[6:] == [
        "r1", "r2", "r3", "V1", "p", "alpha", "phi1", "phi2", "phi3", "check_row",
        "euler_error", "least_determinant", "largest_velocity", "one_step_gap", "group",
    ]  # fmt: skip
    assert (second["id"], second["group"], third["id"], third["name"]) == ("Jörg/Ö", "ME-22", "=2+2", "'=HYPERLINK(1)")
    variant = coursework.load(out / "ada.toml")
    drawn = coursework.draw("31", "31", 2026, "ada")
    assert (variant.values, variant.time, variant.coordinates) == (drawn.values, drawn.time, drawn.coordinates)
    assert first["r1"] == f"{variant.values['r1']:.3f} m"
    assert first["check_row"] == str(variant.time.check_row)
    assert re.fullmatch(r"0\.\d{4}", first["euler_error"])


def test_the_sheet_says_what_to_do_and_hides_nothing_dangerous(out):
    first, second, _ = lines(out)
    page = page_of(out / "sheets" / "ada.html")
    for said in (
        "Ada Lovelace", "12 May &lt;b&gt;", first["r1"], first["alpha"], f"Check row {first['check_row']}", "25 rows",
        f"at least {first['least_decimals']} decimals", "scale 1:", "the 4 velocity equations",
        "velocity of M", "to the right, upwards",
    ):  # fmt: skip
        assert said in page, said
    assert "<script" not in page
    other = page_of(out / "sheets" / f"{second['variant'].removesuffix('.toml')}.html")
    assert "&lt;script&gt;x&lt;/script&gt; Bob" in other
    assert "<script" not in other
    assert not re.search(r'(?:src|href)="(?!#)', page)
    assert "Solved" not in page


def test_one_pdf_has_every_sheet_on_a_page_of_its_own(out):
    document = pymupdf.open(out / "sheets.pdf")
    assert len(document) == 3
    for page, line in zip(document, lines(out), strict=True):
        text = plain(page.get_text())
        for said in (line["id"], line["r2"], line["phi3"], "12 May", "Task sheet"):
            assert said in text, said
        assert page.rect.width == pytest.approx(595.28, abs=0.1)


def test_the_drawing_of_the_sheet_is_true_to_scale_on_paper(out):
    """Link 1 goes from D to A: on paper it is r1 over the scale, in the PDF as in the SVG."""
    line = lines(out)[0]
    page = page_of(out / "sheets" / "ada.html")
    scale = float(re.search(r"scale 1:([\d.]+)", page)[1])
    link = re.search(r'<line ([^>]*)data-link="1"', page)[1]
    x1, y1, x2, y2 = (float(re.search(rf'{name}="([-\d.]+)"', link)[1]) for name in ("x1", "y1", "x2", "y2"))
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    assert length == pytest.approx(1000 * float(line["r1"].split()[0]) / scale, abs=0.01)


def test_the_key_is_the_table_that_a_run_writes(out):
    result = call("run", out / "ada.toml", "--format", "csv", "--out", out.parent / "run")
    assert result.exit_code == 0, result.output
    assert (out / "key" / "ada.csv").read_bytes() == (out.parent / "run" / "table.csv").read_bytes()
    page = page_of(out / "key" / "ada.html")
    row = lines(out)[0]["check_row"]
    for said in (
        "Euler table",
        "Velocity equations",
        f"Check row {row}",
        "read, mm",
        "must measure 100 mm",
        "(11)",
        "(18)",
    ):
        assert said in page, said
    rate = abs(float(coursework.solve(out / "ada.toml", "euler", quantities=["table"]).motion.velocities[3, 0]))
    decimals = int(lines(out)[0]["least_decimals"]) + 1  # one more than a student prints
    assert f"{rate:.{decimals}f}<" in page


def test_the_page_of_the_class_shows_how_it_spreads(out):
    page = page_of(out / "class.html")
    assert "3 students have variants of their own, from template 31, seed 2026" in page
    drawn, feasible = map(int, re.search(r"Of the first (\d+) draws (\d+) were feasible", page).groups())
    (reasons,) = re.findall("Refused among these first draws: (.*?[.])<", page)
    assert sum(map(int, re.findall(r"\d+", reasons))) == drawn - feasible > 0
    assert page.count('<svg class="chart strip"') == 4 + 10  # measures of difficulty, drawn data
    assert page.count("h0") == 3 * 14  # a mark each
    assert float(strip([1.0, 2.0], 1.0, 2.0, 3.0, ("1", "3"), "3").centre) == RIGHT  # beyond the class, on the axis yet
    units = re.findall(r'<span class="unit">(.*?)</span></th>', page)
    assert units == ["m"] * 3 + ["m/s", "1/s"] + ["rad"] * 4 + [" ", "rad", " ", "rad/s", "rad"]
    assert "<td>3</td><td>0.895</td><td>0.760</td><td>0.419</td><td>4.3</td><td>13.46</td>" in page
    assert "&lt;script&gt;" in page
    assert "<script" not in page


def test_a_student_added_and_another_order_change_nobody_elses_files(out, tmp_path):
    head, *others = ROSTER.splitlines()
    turned = "\n".join([head, "new,New One,n@example.org,", *reversed(others)])
    before, after = files(out), files(assigned(tmp_path, turned, "--pdf", "--deadline", "12 May <b>"))
    same = {name for name in before if name not in {"roster.csv", "class.html", "sheets.pdf"}}
    assert {name: before[name] for name in same} == {name: after[name] for name in same}
    assert set(after) - set(before) == {"new.toml", "sheets/new.html", "key/new.csv", "key/new.html"}
    assert {line["id"]: line for line in lines(out)} == {
        line["id"]: line for line in lines(tmp_path / "out") if line["id"] != "new"
    }
    written = {path: path.stat().st_mtime_ns for path in (tmp_path / "out").rglob("*.html")}
    assert files(assigned(tmp_path, turned, "--pdf", "--deadline", "12 May <b>")) == after
    assert {path: path.stat().st_mtime_ns for path in (tmp_path / "out").rglob("*.html")} == written


def test_the_table_of_a_law_lies_beside_the_variants_that_need_it(tmp_path):
    ranges = tmp_path / "own.toml"
    ranges.write_text('[given]\nl2 = { from = "0.38 m", to = "0.45 m", step = "0.01 m" }\n', encoding="utf-8")
    assigned(tmp_path, "id,name\na,Ann\n", "--ranges", str(ranges), template="variable-crank-table")
    own = coursework.load(tmp_path / "out" / "a.toml")
    assert own.functions[0].table == coursework.load("variable-crank-table").functions[0].table


def test_two_students_with_equal_data_are_told(tmp_path):
    (tmp_path / "few.toml").write_text('[given]\np = { choice = ["12.9 1/s"] }\n', encoding="utf-8")
    page = assigned(tmp_path, ROSTER, "--ranges", tmp_path / "few.toml") / "class.html"
    assert "Equal data" in page.read_text(encoding="utf-8")


@pytest.mark.long
@pytest.mark.parametrize(("template", "most"), [("31", 100), ("homework", 60)])
@pytest.mark.parametrize("count", first(1, (2, 4)))
def test_what_each_student_runs_and_hands_in_earns_full_marks(tmp_path, template, most, count):
    """Roster to variants to runs to grades: the table, and the equations where the variant has them."""
    out = assigned(
        tmp_path, "id,name,email\n" + "".join(f"s{k},Student {k},s{k}@example.org\n" for k in range(count)), template=template
    )
    for line in lines(out):
        folder = tmp_path / "submissions" / line["id"]
        assert call("run", out / line["variant"], "--format", "csv", "--out", folder).exit_code == 0
        decimals = int(line["least_decimals"])
        table = [row.split(",") for row in (folder / "table.csv").read_text(encoding="utf-8").splitlines()]
        rounded = [table[0], *([row[0], *(f"{float(cell):.{decimals}f}" for cell in row[1:])] for row in table[1:])]
        for path in folder.iterdir():
            path.unlink()
        (folder / "table.csv").write_text("\n".join(",".join(row) for row in rounded), encoding="utf-8")
        if template == "31":
            (folder / "equations.txt").write_text("\n".join(EQUATIONS), encoding="utf-8")
    rubric = tmp_path / "rubric.toml"
    rubric.write_text("" if most == 100 else "[parts]\ntable = 60\nequations = 0\n", encoding="utf-8")
    options = ("--roster", out / "roster.csv", "--out", tmp_path / "marks", "--rubric", rubric)
    with in_this_process():
        result = call("grade", tmp_path / "submissions", *options)
    assert result.exit_code == 0, result.output
    grades = list(csv.DictReader((tmp_path / "marks" / "grades.csv").read_text(encoding="utf-8-sig").splitlines()))
    assert [(grade["id"], grade["status"], float(grade["points"])) for grade in grades] == [
        (f"s{k}", "graded", 100.0) for k in range(count)
    ]


def test_another_students_data_are_told_apart(tmp_path):
    out = assigned(tmp_path, "id,name,email\na,A,a@x\nb,B,b@x\n")
    for student, other in (("a", "b"), ("b", "b")):
        folder = tmp_path / "submissions" / student
        assert call("run", out / f"{other}.toml", "--format", "csv", "--out", folder).exit_code == 0
    options = ("--roster", out / "roster.csv", "--out", tmp_path / "marks")
    with in_this_process():
        assert call("grade", tmp_path / "submissions", *options).exit_code == 0
    grades = json.loads((tmp_path / "marks" / "grades.json").read_text(encoding="utf-8"))
    assert "variant_b" in json.dumps(grades) or "other" in json.dumps(grades)


@pytest.mark.parametrize(
    ("roster", "words", "told"),
    [
        ("id,name,email\n", (), "nobody is on the roster"),
        ("name,email\nA,a@x\n", (), 'there is no column "id"'),
        ("id\na\na\n", (), 'the id "a" is already in line 2'),
        (
            "id\na\n",
            ("--ranges", "nowhere"),
            'There are no ranges named "nowhere". Name a file (--ranges FILE), or those of a template: 31',
        ),
        ("id\na\n", ("--ranges", "nowhere.toml"), "nowhere.toml: the file could not be read (there is no such file or folder)."),
        ("id\na\n", ("--template", "cardan"), 'There are no ranges named "cardan"'),
        ("id\na\n", ("--language", "xx"), 'no words for the language "xx"'),
    ],
)
def test_what_cannot_be_assigned_is_told_and_nothing_is_written(tmp_path, roster, words, told):
    (tmp_path / "roster.csv").write_text(roster, encoding="utf-8")
    result = call("assign", tmp_path / "roster.csv", "--template", "31", "--seed", "1", "--out", tmp_path / "out", *words)
    assert result.exit_code == 2
    assert told in result.output
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("words", [(), ("--ranges", "mine.toml")])
def test_a_variant_in_the_place_of_ranges_is_told_by_one_sentence_with_the_command(tmp_path, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.toml").write_text((folder("variants") / "31.toml").read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "roster.csv").write_text("id\na\n", encoding="utf-8")
    result = call("assign", "roster.csv", "--template", "mine.toml", "--seed", "1", "--out", "out", *words)
    assert result.exit_code == 2
    assert result.output.count("A033") == 1 and result.output.count("mine.toml:") == 1, result.output
    assert "coursework assign ROSTER --template mine.toml --ranges RANGES.toml" in result.output
