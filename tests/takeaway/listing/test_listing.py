"""`coursework listing`: each program is run where its language lives and prints the table of its scheme."""

import re
import shutil
import subprocess
import sys
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

import coursework
from coursework.report.text.page_context import PageContext
from coursework.report.text.words import load_words
from coursework.takeaway.listing.chart import block_diagram
from coursework.takeaway.listing.listings import dense, listing
from coursework.takeaway.listing.program import program_of
from coursework.takeaway.listing.syntax import syntax_of
from coursework.takeaway.listing.writer import Writer
from coursework.variant.catalogue import names
from tests.command import call
from tests.effects.dynamics.test_dynamics import JUMPS, pushed
from tests.hard.scenes import scene, solve
from tests.mechanisms.library import mechanism
from tests.motion.singular.test_passages import BY_CLOSURE, past_its_pivot
from tests.sample import SAMPLE, sampled
from tests.solved import solved
from tests.takeaway.workbook.test_workbook import THREE, off

FILES = names()
FORCED = [("example-2-motor", "euler"), ("example-2-motor", "semi-implicit"), ("falling-arm", "rk4")]
PROGRAMS = {"python": sys.executable, "octave": "octave-cli", "c": "gcc", "pascal": "fpc", "javascript": "node"}
ENDINGS = {"python": "py", "octave": "m", "c": "c", "pascal": "pas", "javascript": "js"}
OTHERS = [language for language in PROGRAMS if language != "python"]
GATE = {("31", language) for language in PROGRAMS} | {(name, "python") for name in SAMPLE}


@pytest.mark.parametrize(("boxes", "more", "lines"), [
    (39, ["x = 1;", "x = 1;"], 80), (39, ["x = 1;", "", ""], 39 + 3),  # 80 lines stay; of 81, comments go behind what they say
    (39, ["x = 1;", "x = 1;", ""], 80), (39, ["x = 1;", "x = 1;", "", ""], 39 + 3),  # two in one line are enough, or are not
    (78, ["{", ""], 80), (78, ["{", "", ""], 79),  # no empty lines if nothing else helps
])  # fmt: skip
def test_a_page_of_80_lines_is_not_made_denser(boxes, more, lines):
    boxed = [line for _ in range(boxes) for line in ("// 4 x = 1", "if (1) {}")]
    assert len(dense(boxed + more, syntax_of("c"))) == lines


@cache
def written(run, language, words="en"):
    return listing(program_of(PageContext(run, load_words(words))), language, load_words(words))


def printed(text, language, folder):
    """The table that a program prints."""
    if shutil.which(PROGRAMS[language]) is None:
        pytest.skip(f"{PROGRAMS[language]} is not installed")
    file, made = folder / f"own.{ENDINGS[language]}", folder / "made"
    file.write_text(text, encoding="utf-8")
    build = {
        "c": ["gcc", "-Wall", "-Werror", "-o", made, file, "-lm"], "pascal": ["fpc", "-v0", f"-o{made}", file],
    }.get(language)  # fmt: skip
    if build:
        told = subprocess.run(build, capture_output=True, text=True, check=False)
        assert told.returncode == 0, told.stdout + told.stderr
    start = {"python": [sys.executable, "-I", file], "octave": ["octave-cli", "--norc", "-q", file], "javascript": ["node", file]}
    told = subprocess.run(start.get(language, [made]), capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stderr
    head, *rows = told.stdout.splitlines()
    return head, np.array([row.split(",") for row in rows], dtype=float)


def chart_of(run):
    return block_diagram(program_of(PageContext(run, load_words("en"))), load_words("en"))


def agrees(run, language, folder):
    head, rows = printed(written(run, language), language, folder)
    assert head == ",".join(["t", *run.motion.names])
    return off(rows, np.column_stack([run.motion.t, run.motion.rows])) < 1e-9


PAIRS = [
    pytest.param(name, language, marks=() if (name, language) in GATE else pytest.mark.long)
    for name in FILES
    for language in PROGRAMS
]


@pytest.mark.parametrize(("name", "language"), PAIRS)
def test_a_program_prints_the_table_of_eulers_scheme(name, language, tmp_path):
    assert agrees(solved(name, scheme="euler", quantities=["table"]), language, tmp_path)


@pytest.mark.parametrize("language", ["python", *(pytest.param(one, marks=pytest.mark.long) for one in OTHERS)])
@pytest.mark.parametrize(("name", "scheme"), [("robot-arm", "rk4"), ("engine-start", "heun")])
def test_further_slopes_stop_at_a_break_of_the_drive(name, scheme, language, tmp_path):
    assert agrees(solved(name, scheme=scheme, quantities=["table"]), language, tmp_path)


@pytest.mark.parametrize("language", ["python", *(pytest.param(one, marks=pytest.mark.long) for one in OTHERS)])
@pytest.mark.parametrize(("name", "scheme"), FORCED)
def test_a_motion_under_forces_closes_its_positions_and_finds_its_accelerations(name, scheme, language, tmp_path):
    assert agrees(solved(name, scheme=scheme, quantities=["table"]), language, tmp_path)


def test_further_slopes_stop_at_a_jump_of_the_force(tmp_path):
    assert agrees(pushed("q*g", JUMPS.replace("BREAK", "0.5"), "rk4"), "python", tmp_path)


@pytest.mark.parametrize(
    "language", ["python", "c", *(pytest.param(one, marks=pytest.mark.long) for one in OTHERS if one != "c")]
)
def test_a_block_of_three_is_eliminated_in_the_listing(language, tmp_path):
    run = solve(THREE)
    assert agrees(run, language, tmp_path)
    assert ": array[0..2, 0..3] of double;" in written(run, "pascal")  # three rows of three and a right side; no fpc is needed


ODD = scene(
    'phi = { start = "0.3 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }',
    given='lambda = "0.1 m"\nbegin = "0.2 m"\nR = "0.3 m"\nr = "0.2 m"\nh = "0.5 m"\ni = "0.1 m"\nn = "0.2 m"\ny1 = "0.1 m"',
    drive='v = "2"', end=0.2, equations=["u = v*(lambda*sin(phi) + begin*r/R + abs(h - i)*n/R + y1*sqrt(r/R)*exp(-phi)*log(2))"],
)  # fmt: skip


@pytest.mark.parametrize("language", PROGRAMS)
def test_names_that_a_language_keeps_for_itself_are_changed(language, tmp_path):
    assert agrees(solve(ODD), language, tmp_path)


@pytest.mark.parametrize("language", PROGRAMS)
def test_cranks_that_nothing_hangs_on_have_a_program_of_their_drives_alone(language, tmp_path):
    run = coursework.solve(coursework.parse_variant(mechanism("two-arms")), scheme="euler", quantities=["table"])
    assert agrees(run, language, tmp_path)
    numbers = [int(one) for one in re.findall(r"<text[^>]*font-size=\"10\"[^>]*>([0-9]+)<", chart_of(run))]
    assert numbers == [*range(1, len(numbers) + 1)]
    told = re.findall(rf"(?:^ *|  ){re.escape(syntax_of(language).comment)}([0-9]+) ", written(run, language), re.MULTILINE)
    assert {*map(int, told)} == {*numbers}


def test_a_motion_that_stops_prints_the_rows_before(tmp_path):
    variant = coursework.load("31").with_data(given={"alpha": 0.02})
    run = coursework.solve(variant, quantities=["table"])
    assert run.stop is not None and agrees(run, "python", tmp_path)


@pytest.mark.parametrize("language", PROGRAMS)
def test_comments_are_numbered_and_speak_the_language_of_the_report(language):
    mark = re.escape(syntax_of(language).comment)
    for words in ("en", "ru", "uk", "zh"):
        text = written(solved("31"), language, words)
        numbers = [int(one) for one in re.findall(rf"(?:^ *|  ){mark}(\d+) ", text, re.MULTILINE)]
        assert sorted(numbers) == list(range(1, 18)) and 40 <= len(text.splitlines()) <= 80
        assert ("number of steps" in text) is (words == "en")
        assert {"en": "s, step", "ru": "с, шаг", "uk": "с, крок", "zh": "s，步长"}[words] in text
        assert "(16), (18): w1, w2" in text.replace("：", ": ")


@pytest.mark.parametrize("name", sampled(FILES))
def test_a_program_has_forty_to_eighty_lines(name):
    """A chain of many groups and a table of fifty nodes too: their assignments stand closer, comments behind the lines."""
    run = solved(name, scheme="euler", quantities=["table"])
    for language in PROGRAMS:
        lines = written(run, language).splitlines()
        assert 40 <= len(lines) <= 80 and max(map(len, lines)) <= 160


def test_words_of_a_file_stay_in_their_comment():
    text = ODD.replace("[given]", 'title = "a\\u2028b */ print(1) \\\\"\n[given]', 1)
    run = solve(text)
    for language in PROGRAMS:
        first = written(run, language).split("\n")[0]
        assert first.startswith(syntax_of(language).comment) and "print(1)" in first and "\\" not in first


@pytest.mark.usefixtures("folder")
def test_the_command_prints_or_writes(folder):
    shown = call("listing", "31", "--language", "python")
    assert shown.exit_code == 0 and shown.stdout == written(solved("31"), "python")
    assert "W011 own.png" in call("listing", "31", "--chart", "own.png").stderr
    assert "W006 ." in call("listing", "31", "--out", ".").stderr
    alone = call("listing", "31", "--chart", "own.svg")
    assert alone.exit_code == 0 and alone.stdout.startswith("Written to own.svg") and "def rates" not in alone.stdout
    done = call("listing", "31", "--language", "c", "--out", "own.c", "--chart", "own.svg")
    assert done.exit_code == 0
    assert [float(size) for size in re.findall(r": (\d+) kB", done.output)] == pytest.approx(
        [(folder / name).stat().st_size / 1000 for name in ("own.svg", "own.c")], abs=0.51
    )
    assert (folder / "own.c").read_text(encoding="utf-8") == written(solved("31"), "c")
    assert (folder / "own.svg").read_text(encoding="utf-8").startswith("<svg")
    finer = call("listing", "31", "--scheme", "rk4", "--step", "h/2", "--set", "r1=0.9m").stdout
    assert "h = 0.01" in finer and "r1 = 0.9" in finer and "n = 48" in finer


SPLINE = """x, f
0.0, 0.10
0.1, 0.13
0.2, 0.19
0.3, 0.20
0.4, 0.18
0.5, 0.12
0.6, 0.11
"""


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("language", PROGRAMS)
def test_a_law_that_is_a_spline(folder, language):
    (folder / "own.csv").write_text(SPLINE, encoding="utf-8")
    text = scene(
        'phi = { start = "0.05 rad", rate = "v" }\nx = { start = "0 m", rate = "u" }',
        drive='v = "2"',
        end=0.2,
        equations=["u = v*f"],
    ).replace("[time]", '[functions]\nf = { table = "own.csv", of = "phi", method = "spline" }\n[time]')
    (folder / "own.toml").write_text(text, encoding="utf-8")
    assert agrees(coursework.solve(folder / "own.toml", scheme="heun", quantities=["table"]), language, folder)


def test_a_singular_position_that_is_gone_through_prints_its_limit(tmp_path):
    run = solve(past_its_pivot(BY_CLOSURE), "euler")
    assert len(run.scene.search.passages) == 1 and agrees(run, "python", tmp_path)


def test_a_step_that_was_found_is_the_advised_one_or_keeps_an_error():
    def steps(*options):
        return float(re.search(r"^h = (\S+)", call("listing", "31", *options).stdout, re.MULTILINE)[1])

    assert steps("--step", "auto") == pytest.approx(0.02 / 18)
    assert steps("--step", "auto", "--error", "0.05") < 0.02
    assert "C029" in call("listing", "31", "--error", "0.05").stderr


@pytest.mark.parametrize(
    ("options", "code"),
    [(("31", "--scheme", "exact"), "C093"), (("31", "--language", "lisp"), "C054")],
)
def test_what_has_no_listing_is_told(options, code):
    told = call("listing", *options)
    assert told.exit_code == 2 and code in told.stderr


@pytest.mark.parametrize(("scheme", "said"), [(None, True), ("euler", True), ("rk4", False)])
def test_a_listing_says_that_it_is_eulers_where_the_report_is_exact(scheme, said):
    run = coursework.solve("whitworth", scheme=scheme, quantities=["table"])
    heads = {language: written(run, "python", language).splitlines()[:4] for language in ("en", "ru", "uk", "zh")}
    for language, told in {"en": "exact motion", "ru": "точное движение", "uk": "точний рух", "zh": "精确解"}.items():
        assert any(line.startswith("#") and told in line for line in heads[language]) is said
    assert "exact motion" not in written(coursework.solve("31", quantities=["table"]), "python")


@pytest.mark.parametrize(("words", "kept"), [((40, 55), 1), ((40, 56), 2), ((40, 54, 95), 2), ((40, 55, 95), 3)])
def test_a_line_of_code_has_100_letters_at_most(words, kept):
    """With "x = " before them, and a parenthesis where a line goes on."""
    writer = SimpleNamespace(syntax=SimpleNamespace(assign=" = ", around=("(", ")"), wrap=" \\"))
    found = Writer.wrapped(writer, line := "x = " + " ".join("a" * size for size in words))
    assert len(found) == kept and (found == [line]) is (kept == 1), found
