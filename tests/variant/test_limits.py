"""Files made to harm: too large, too deep, too many, of other letters.  Each is refused in one sentence, in bounded time."""

import time

import pytest

import coursework
from coursework.errors import MOST_SHOWN
from coursework.variant.reader import parse_variant
from coursework.variant.source import MAX_BYTES

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
    assert refused(b"#" * 1_000_000) == f"f.toml  {sentence}"
    path = tmp_path / "large.toml"
    path.write_bytes(b"#" * 1_000_000)
    with pytest.raises(coursework.InputError) as caught:
        coursework.load(path)
    assert str(caught.value) == f"{path}  {sentence}"


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
    assert refused(content) == f"f.toml:{line}  {NESTED}"


@pytest.mark.parametrize(
    "content",
    ['"' * 65_000, "'" * 65_000, '"""' * 21_000, 'a = "' + '\\"' * 30_000, "a = '''" + "'" * 60_000, "a" * 65_000, "a=" * 32_000],
    ids=["quotes", "apostrophes", "triple", "escapes", "open text", "letters", "equals"],
)
def test_texts_that_never_end_cost_nothing(content):
    assert refused(content).startswith("f.toml:1")


def test_an_integer_of_five_thousand_digits():
    sentence = refused(PLAIN.replace('"1 m"', "1" + "0" * 5_000))
    assert sentence == "f.toml  the file is not TOML here: a number has too many digits."


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
    sentence = 'points.Q, column 2: the value of "exp(P.x/E.x)" is beyond any number that can be meant.'
    assert str(caught.value) == f"f.toml:17  {sentence}"


def test_thousands_of_faults_are_counted_and_not_all_told():
    data = "".join(f'g{i} = "1 furlong"\n' for i in range(3_000))
    lines = refused(PLAIN.replace("[drive]", data + "[drive]")).split("\n")
    assert len(lines) == MOST_SHOWN + 1
    assert lines[-1] == f"… and {3_000 - MOST_SHOWN} faults more."


def test_thousands_of_unknown_names_do_not_take_minutes():
    rows = "".join(f'[[constraint]]\nequation = "{"+".join(f"x{i}y{j}" for j in range(120))} = 0"\n' for i in range(40))
    data = "".join(f'g{i} = "1 m"\n' for i in range(1_000))
    assert refused(PLAIN.replace("[drive]", data + "[drive]") + rows).endswith("faults more.")


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (
            PLAIN.replace("[given]", "# шатун\n[given]").encode("cp1251"),
            "f.toml:1:3  this letter is not UTF-8 text (found byte 0xf8).",
        ),
        (PLAIN.encode("utf-16"), "f.toml:1:1  this letter is not UTF-8 text (found byte 0xff)."),
        (PLAIN.encode() + b"\0", "f.toml:14:1  the file is not TOML here: a line is a [section]"),
        (b"", "f.toml  the section [coordinates] is missing."),
        (b"\x89PNG\r\n\x1a\n", "f.toml:1:1  this letter is not UTF-8 text (found byte 0x89)."),
    ],
    ids=["cp1251", "UTF-16", "NUL", "empty", "picture"],
)
def test_other_bytes(content, sentence):
    assert refused(content).startswith(sentence)


def test_letters_that_do_not_print_are_shown_as_codes():
    said = refused(PLAIN.replace("r*w", "r\\u202e\\u001b[2J*w"))
    assert "\\u202e" in said
    assert said.isprintable()
