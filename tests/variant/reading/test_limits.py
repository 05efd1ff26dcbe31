"""Files made to harm: too large, too deep, too many, of other letters.  Each is refused in one sentence, in bounded time."""

import json
import os
import re
import sys
import time

import pytest

import coursework
from coursework.report.output.record import record
from coursework.variant.reading.reader import parse_variant
from coursework.variant.toml.source import MAX_BYTES
from coursework.words.errors import MOST_SHOWN

PLAIN = """[given]
r = "1 m"
[drive]
w = "1"
[coordinates]
q = { start = "0 rad", rate = "w" }
[unknowns]
u = "m/s"
[time]
step = "0.1 s"
end = "1 s"
[[constraint]]
equation = "r*w*sin(q) = u"
"""
NESTED = "keys or lists are nested beyond what a variant needs: at most 8 parts in a key, 20 brackets inside each other."


def refused(content):
    """Return what is said about a text, and require that it is said at once."""
    begun = time.process_time()
    with pytest.raises(coursework.InputError) as caught:
        parse_variant(content, "f.toml")
    assert time.process_time() - begun < 5  # a loose bound: unbounded reading would take minutes
    return str(caught.value)


def test_the_plain_file_is_read():
    assert parse_variant(PLAIN).columns == ("q", "w", "u")


def test_a_megabyte_is_not_read(tmp_path):
    sentence = f"the file has 1000000 bytes; a variant file has at most {MAX_BYTES}. Is it the right file?"
    path = tmp_path / "large.toml"
    # The line is the one that is no longer read: the first of one long line, the 6555th of lines of ten letters.
    for content, line in ((b"#" * 1_000_000, 1), (b"#########\n" * 100_000, MAX_BYTES // 10 + 1)):
        assert refused(content) == f"V006 f.toml:{line}  {sentence}"
        path.write_bytes(content)
        with pytest.raises(coursework.InputError) as caught:
            coursework.load(path)
        assert str(caught.value) == f"V006 {path}:{line}  {sentence}"


def test_the_largest_file_is_read_and_one_letter_more_is_not():
    full = PLAIN + "#" * (MAX_BYTES - len(PLAIN.encode()))
    assert parse_variant(full).columns == ("q", "w", "u")
    assert "bytes; a variant file has at most" in refused(full + "#")


@pytest.mark.parametrize(
    ("content", "line"),
    [
        ("a" + ".a" * 30_000 + " = 1", 1),
        ("x = { a" + ".a" * 30_000 + " = 1 }", 1),
        ('"a"' + '."b"' * 9 + " = 1", 1),
        ("[" + "a." * 9 + "b]", 1),
        ("[a.b.c.d.e.f.g.h]\n[a . b . c . d . e . f . g . h . i]", 2),
        ("a = " + "[" * 60_000, 1),
        ("a = " + "[\n" * 30_000, 21),
        ("a = " + "{ b = [\n" * 7_000, 11),
    ],
    ids=["dotted", "dotted inside", "quoted", "header", "spaced", "lists", "lines of lists", "tables"],
)
def test_nesting(content, line):
    assert refused(content) == f"V008 f.toml:{line}  {NESTED}"


@pytest.mark.parametrize(
    "content",
    ['"' * 65_000, "'" * 65_000, '"""' * 21_000, 'a = "' + '\\"' * 30_000, "a = '''" + "'" * 60_000, "a" * 65_000, "a=" * 32_000],
    ids=["quotes", "apostrophes", "triple", "escapes", "open text", "letters", "equals"],
)
def test_texts_that_never_end_cost_nothing(content):
    assert refused(content)[1:].startswith(("009 f.toml:1", "010 f.toml:1"))


def test_an_integer_of_five_thousand_digits():
    sentence = refused(PLAIN.replace('"1 m"', "1" + "0" * 5_000))
    assert sentence == "V010 f.toml  the file is not TOML here: a number has too many digits."


@pytest.mark.parametrize(
    ("deep", "sentence"),
    [
        ("(" * 10_000 + "r" + ")" * 10_000, "constraint 1: a text of at most 2000 letters was expected"),
        ("(" * 900 + "r" + ")" * 900, "the formula is nested or long beyond 60 levels or 500 parts."),
        ("-" * 1_500 + "r", "the formula is nested deeper than 60 levels."),
        ("+".join(["r"] * 600), "the formula has more than 500 parts; split it."),
        ("sin(" * 70 + "r" + ")" * 70, "the formula is nested or long beyond 60 levels or 500 parts."),
        ("r^2" + "^2" * 100, "the exponent is too large; at most 8 is read."),
    ],
    ids=["10000 parentheses", "900 parentheses", "signs", "terms", "functions", "powers"],
)
def test_formulas_beyond_reason(deep, sentence):
    assert sentence in refused(PLAIN.replace("r*w*sin(q)", f"{deep}*w"))


def test_powers_of_sums_are_not_multiplied_out():
    """Eight factors of ten names each are a hundred million terms; the numbers come out all the same."""
    names = "".join(f"a{i} = {i}\n" for i in range(1, 11))
    total = "+".join(f"a{i}*q" for i in range(1, 11))
    text = PLAIN.replace("[given]\n", f"[given]\n{names}").replace("r*w*sin(q)", f"r*w*(({total})/100)^8")
    motion = coursework.solve(parse_variant(text), quantities=["table"]).motion
    for q, u in zip(motion.column("q"), motion.column("u"), strict=True):
        assert u == pytest.approx((55 * q / 100) ** 8, rel=1e-12, abs=1e-300)


def test_powers_of_powers_of_points():
    """What points hide is bounded too: P8.x would be a power of sixteen million."""
    points = '[points]\nP0 = "r @ q"\n' + "".join(f'P{i} = "(P{i - 1}.x^8/r^7, 0)"\n' for i in range(1, 9))
    text = PLAIN.replace("r*w*sin(q) = u", "r*w = u") + points + '[closure]\nholds = ["P8.x"]\n'
    begun = time.process_time()
    run = coursework.solve(parse_variant(text), quantities=["table"])
    assert run.motion.column("q").tolist() == pytest.approx([i / 10 for i in range(11)], abs=1e-15)
    assert time.process_time() - begun < 20


def test_constants_hidden_in_points():
    points = '[points]\nP = "(exp(20)*exp(20), 0)"\nE = "(1, 0)"\nQ = "(exp(P.x/E.x)*E.x, 0)"\n'
    with pytest.raises(coursework.InputError) as caught:
        coursework.solve(parse_variant(PLAIN + points, "f.toml"), quantities=["table"]).columns()
    sentence = 'points.Q, column 2: the value of "exp(P.x/E.x)" is too large to be what was meant.'
    assert str(caught.value) == f"V133 f.toml:17  {sentence}"


def test_thousands_of_faults_are_counted_and_not_all_told():
    data = "".join(f'g{i} = "1 furlong"\n' for i in range(3_000))
    lines = refused(PLAIN.replace("[drive]", data + "[drive]")).split("\n")
    assert len(lines) == MOST_SHOWN + 1
    assert lines[-1] == f"… +{3_000 - MOST_SHOWN}"


@pytest.mark.long
def test_thousands_of_unknown_names_do_not_take_minutes():
    rows = "".join(f'[[constraint]]\nequation = "{"+".join(f"x{i}y{j}" for j in range(120))} = 0"\n' for i in range(40))
    data = "".join(f'g{i} = "1 m"\n' for i in range(1_000))
    assert re.search(r"\n… \+\d+$", refused(PLAIN.replace("[drive]", data + "[drive]") + rows))


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (
            PLAIN.replace("[given]", "# шатун\n[given]").encode("cp1251"),
            "V007 f.toml:1:3  this letter is not UTF-8 text (found byte 0xf8).",
        ),
        (PLAIN.encode("utf-16"), "V007 f.toml:1:1  this letter is not UTF-8 text (found byte 0xff)."),
        (PLAIN.encode() + b"\0", "V009 f.toml:14:1  the file is not TOML here: a line is a [section]"),
        (b"", "V012 f.toml:1  the section [coordinates] is missing."),
        (b"{\\rtf1 r = 1}", "V021 f.toml  this is RTF, not plain text. Copy its text into a text editor (Notepad)"),
        (b"PK\x03\x04\x14", "V021 f.toml  this is DOCX/ODT/ZIP, not plain text."),
        (b"PK = 3", "V012 f.toml:1  the section [coordinates] is missing."),
        (b"\x89PNG\r\n\x1a\n", "V007 f.toml:1:1  this letter is not UTF-8 text (found byte 0x89)."),
    ],
    ids=["cp1251", "UTF-16", "NUL", "empty", "RTF", "Word", "key", "picture"],
)
def test_other_bytes(content, sentence):
    assert refused(content).startswith(sentence)


def test_letters_that_do_not_print_are_shown_as_codes():
    said = refused(PLAIN.replace("r*w", "r\\u202e\\u001b[2J*w"))
    assert "\\u202e" in said
    assert said.isprintable()


HEX = "0x" + "f" * 4_000
RICH = (
    PLAIN
    + """[functions]
k = "1"
[points]
A = "(0, 0)"
[links]
1 = { points = ["A"] }
2 = { points = ["A"], slides = 1 }
[frame]
hinges = ["A"]
rails = [{ through = "A", angle = 0 }]
[ask]
quantities = ["table"]
"""
)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('r = "1 m"', f"r = {HEX}"), ('w = "1"', f"w = {HEX}"), ('w = "1"', f'w = {{ pieces = [[{HEX}, "1"]] }}'),
        ('w = "1"', f"w = {{ pieces = [[0, {HEX}]] }}"), ('start = "0 rad"', f"start = {HEX}"), ('rate = "w"', f"rate = {HEX}"),
        ('u = "m/s"', f"u = {HEX}"), ('step = "0.1 s"', f"step = {HEX}"), ('end = "1 s"', f"end = {HEX}"),
        ('end = "1 s"', f'end = "1 s"\ncheck_row = {HEX}'), ('end = "1 s"', f'end = "1 s"\nperiod = {HEX}'),
        ("[[constraint]]", f"[[constraint]]\nname = {HEX}"), ('k = "1"', f"k = {HEX}"), ('A = "(0, 0)"', f"A = {HEX}"),
        ("slides = 1", f"slides = {HEX}"), ('hinges = ["A"]', f"hinges = [{HEX}]"), ("angle = 0", f"angle = {HEX}"),
        ('quantities = ["table"]', f"quantities = [{HEX}]"), ("[given]", f"format = {HEX}\n[given]"),
        ("[given]", f"title = {HEX}\n[given]"), ("[given]", f"nothing = {HEX}\n[given]"),
    ],
)  # fmt: skip
def test_hexadecimal_numbers_of_any_size_wherever_a_number_may_stand(before, after):
    assert before in RICH
    said = refused(RICH.replace(before, after, 1))
    assert said.endswith("a number of at most 1e12 was expected, found a whole number of 4817 digits.")
    assert re.match(r"V\d+ f\.toml:\d+:\d+  ", said)


@pytest.mark.parametrize(
    ("before", "after", "sentence"),
    [
        ('end = "1 s"', 'end = "1000 s"\nperiod = "0.0999 s"', "the period (0.0999 s) must be at least one step (0.1 s)."),
        ('end = "1 s"', 'end = "1000.2 s"\nperiod = "0.1 s"',
         "time.end: the run lasts for 1e+04 periods; at most 10000 are computed. Take an earlier end."),
        ('end = "1 s"', 'end = "20000.1 s"', "2e+05 rows are asked for; at most 200000 are computed."),
    ],
)  # fmt: skip
def test_what_a_run_may_cost(before, after, sentence):
    assert sentence in refused(PLAIN.replace(before, after))


@pytest.mark.parametrize("after", ['end = "1000 s"\nperiod = "0.1 s"', 'end = "20000 s"'])
def test_what_it_may_just_cost(after):
    assert parse_variant(PLAIN.replace('end = "1 s"', after)).time.steps > 9_000


@pytest.mark.parametrize(("count", "fits"), [(38, True), (39, False)])
def test_rows_times_columns(count, fits):
    """100 001 rows of 40 columns are 40 numbers beyond four millions; of 39 columns they fit."""
    more = "".join(f'v{i} = "m/s"\n' for i in range(count - 2))
    text = (
        PLAIN.replace('end = "1 s"', 'end = "10000 s"')
        .replace("[time]", f"{more}[time]")
        .replace("= u", "= u" + "".join(f"+v{i}" for i in range(count - 2)))
    )
    text += "".join(f'[[constraint]]\nequation = "v{i} = u"\n' for i in range(count - 2))
    if fits:
        assert len(parse_variant(text).columns) == count + 1
    else:
        assert refused(text).endswith(
            "time.step: 100001 rows of 40 columns are asked for; a table has at most 4000000 numbers. Take a larger step."
        )


@pytest.mark.skipif(sys.platform in {"win32", "darwin"}, reason="names of files are text there")
def test_a_name_of_a_file_that_is_no_text(tmp_path):
    path = tmp_path / os.fsdecode(b"v\xff\xe9.toml")
    path.write_text(PLAIN, encoding="utf-8")
    variant = coursework.load(path)
    assert variant.name == "v%FF%E9"
    run = coursework.solve(variant, quantities=["table"])
    assert json.loads(json.dumps(record(run), ensure_ascii=False).encode("utf-8"))["variant"] == "v%FF%E9"


def test_the_line_of_what_is_not_there_is_that_of_what_it_would_stand_in():
    variant = parse_variant(PLAIN)
    for path, line in ((("given", "r"), 2), (("given", "x"), 1), (("points", "A"), 1), ((), 1), (("time", "period"), 9)):
        assert variant.nearest_line(*path) == line
    assert (variant.line_of("time", "end"), variant.line_of("time", "period")) == (11, 0)


@pytest.mark.parametrize(("before", "after", "told"), [
    ('[coordinates]\nq = { start = "0 rad", rate = "w" }\n', "[coordinates]\n", "a section of at least 1 line"),
    ('w = "1"', "w = { pieces = [] }", "a list of at least 1"),
    ('w = "1"', 'w = { pieces = [["0 s", "1", "2"]] }', "drive.w.pieces.1"),
    ("[time]", '[ask]\nquantities = [""]\n[time]', "a text of at least 1 letter"),
    ("[time]", '[[group]]\nkind = "crank"\ncoordinates = []\n[time]', "a list of at least 1"),
    ("[time]", '[[group]]\nkind = "crank"\ncoordinates = ["a", "b", "c"]\n[time]', "a list of at most 2"),
    ("[time]", '[forces]\ns = { spring = ["A"] }\n[time]', "a list of at least 2"),
    ("[time]", '[forces]\ns = { spring = ["A", "B", "C"] }\n[time]', "a list of at most 2"),
    ("[given]", f'title = "{"x" * 301}"\n[given]', "a text of at most 300 letters"),
])  # fmt: skip
def test_too_long_and_too_short_is_told_with_what_may_stand_there(before, after, told):
    assert before in PLAIN
    assert told in refused(PLAIN.replace(before, after))


@pytest.mark.parametrize("name", ["q", "guide", "rails", "time"])
def test_the_keys_that_are_known_are_those_of_the_table_however_it_is_called(name):
    said = refused(PLAIN.replace('q = { start = "0 rad"', f'{name} = {{ near = "0 rad"').replace("sin(q)", "1"))
    assert "Known: rate, start, unit." in said
