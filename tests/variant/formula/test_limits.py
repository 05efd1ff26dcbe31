"""What a formula may not be: a program, or larger than anything a person writes; the bounds themselves, on both sides."""

import builtins
import math

import pytest

from coursework.variant.formula.reader import MAX_CHARACTERS, MAX_DEPTH, MAX_EXPONENT, MAX_NODES, parse, parse_equation
from coursework.variant.formula.tree import FormulaFault, evaluate, spelled

HOSTILE = [
    "__import__('os').system('x')", '__import__("os").system("x")', "().__class__.__base__.__subclasses__()",
    "open('/etc/passwd')", "eval('1')", "exec('1')", "getattr(a, 'b')", "a.__class__", "a.b", "a[0]", "a[0:1]", "[1, 2]",
    "{1: 2}", "{1, 2}", "(1, 2)", "lambda: 1", "lambda x: x", "f'{a}'", "b'a'", "'a'", '"a"', "a if b else c", "a or b",
    "not a", "a and b", "a < b", "a == b", "[x for x in a]", "{x for x in a}", "(x for x in a)", "x := 1", "(x := 1)", "a; b",
    "a\nb", "a, b", "*a", "**a", "sin(*a)", "sin(x=1)", "sin(**a)", "print(1)", "a(b)", "a()", "1()", "(a)(b)", "a @ b", "~a",
    "a % b", "a // b", "a << 1", "a | b", "a & b", "`a`", "$a", "a?", "a!", "await a", "yield a", "0x10", "1_000", "1j",
    "1e5j", "0b1", "0o7", "1L", "...", "a...", "..", "", " ", "()", "((", "))", "+", "-", "a +", "* a", "a ** ", "sin",
    "sin a", "sin^2(a)", "sin()", "sin(a, b)", "atan2(a)", "2a", "a b", "a(", "a)", "0,5", "a'", "a\x00", "\ufeff", "a\u200b",
    "𝟘", "٣", "соs(a)", "х",
]  # fmt: skip
TOWERS = [
    "9**9**9", "9^9^9", "a**a", "a**b", "2**1e9", "2**999", "2**-9", "a**(b)", "1e999", "1e13", "1e400", "1e-400", "1e-999999999",
    "exp(exp(exp(99)))", "exp(1000)", "((9^8)^8)^8", "(1e12^8)^2", "(((0.0001^8)^8)^8)^8", "1/0", "0/0", "1/(1-1)", "log(0)",
    "sqrt(-1)", "(-1)^(1/2)", "asin(2)", "log(-1)", "ctg(0)", "0^-1", "1e12*1e12*1e12*1e12*1e12*1e12*1e12*1e12*1e12",
]  # fmt: skip


@pytest.fixture(scope="module", autouse=True)
def _usual_records():
    """Words are read with the first sentence, constructors of records written out with the first dozen: neither is a formula."""
    assert not accepted("$") and accepted("+".join(["a"] * 40))


def fault(text, monkeypatch, read=parse):
    """Return what is said about a text; nothing may be executed while it is read."""

    def executed(*_args, **_options):
        raise AssertionError("a formula was handed to Python")

    with monkeypatch.context() as patch:
        for name in ("eval", "exec", "compile", "__import__"):
            patch.setattr(builtins, name, executed)
        try:
            read(text)
        except FormulaFault as found:
            return found.message
    return ""


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_programs_are_refused(text, monkeypatch):
    assert fault(text, monkeypatch)
    assert fault(f"{text} = 1", monkeypatch, parse_equation)


@pytest.mark.parametrize("text", TOWERS, ids=TOWERS)
def test_towers_are_refused(text, monkeypatch):
    assert fault(text, monkeypatch)


def accepted(text):
    try:
        parse(text)
    except FormulaFault:
        return False
    return True


@pytest.mark.parametrize(
    ("build", "most"),
    [
        (lambda n: "a" * n, MAX_CHARACTERS),
        (lambda n: "(" * n + "a" + ")" * n, MAX_DEPTH),
        (lambda n: "-" * n + "a", MAX_DEPTH),
        (lambda n: "+".join(["a"] * ((n + 1) // 2)), MAX_NODES),
        (lambda n: f"a^{n}", MAX_EXPONENT),
        (lambda n: f"a^(-{n})", MAX_EXPONENT),
        (lambda n: f"{n}e11", 10),
    ],
    ids=["letters", "parentheses", "signs", "parts", "exponent", "negative exponent", "number"],
)
def test_bounds(build, most):
    assert accepted(build(most))
    assert not accepted(build(most + 1)) or build(most + 1) == build(most)
    assert not accepted(build(most + 2))


@pytest.mark.parametrize(("text", "fits"), [("1e12^8*9e3", True), ("1e12^8*1.1e4", False)])
def test_a_part_made_of_numbers_lies_within_a_googol_and_its_reciprocal(text, fits):
    assert accepted(text) == accepted(f"1/({text})") == fits


def test_columns_count_letters_as_written():
    for text, column in [("a·b + соs(a)", 7), ("a² + $", 6), ("2a", 2), ("a +", 4), ("sin(a", 6), ("a = b", 3)]:
        with pytest.raises(FormulaFault) as caught:
            parse(text)
        assert caught.value.column == column, text


@pytest.mark.parametrize(
    ("text", "column", "found"), [("a", 1, 0), ("a = b = c", 7, "2"), ("a == b", 4, "2"), ("=", 1, None), ("a =", 4, None)]
)
def test_equations_have_one_sign_of_equality(text, column, found):
    with pytest.raises(FormulaFault) as caught:
        parse_equation(text)
    assert caught.value.column == column
    if found:
        assert caught.value.message == f'an equation "left = right" needs exactly one "=" ({found} found).'


def test_vectors_stand_only_in_the_geometry():
    for text in ("a @ b", "(a, b)", "a.x"):
        assert not accepted(text)
        parse(text, vectors=True)


@pytest.mark.parametrize("text", ["1/(a - a)", "log(a - a)", "exp(1e3*a)", "(a - 1)^(1/2)"])
def test_values_that_are_no_numbers_are_told(text):
    with pytest.raises(FormulaFault) as caught:
        evaluate(parse(text), {"a": 0.9})
    assert caught.value.message.split()[-1] in {"zero.", "number."}


def test_a_cotangent_of_a_cotangent_does_not_double_the_formula():
    """Read as cos/sin the argument stood twice: sixty letters made a formula of 2^55 parts."""
    tree = parse("ctg(" * 55 + "x" + ")" * 55)
    assert sum(1 for _ in tree.walk()) == 3 * 55 + 1
    assert parse(spelled(tree)) == tree
    assert evaluate(parse("ctg(x)"), {"x": 0.7}) == pytest.approx(math.cos(0.7) / math.sin(0.7), rel=1e-15)


DEEP = [
    "-" * 58 + "x", "-" * 40 + "x", "+".join(["abcdef"] * 250), "-(" * 29 + "x" + ")*r" * 29, "(" * 58 + "x" + ")" * 58,
    "-2*r*(-x)/(-y)",
]  # fmt: skip


@pytest.mark.parametrize("text", DEEP, ids=range(len(DEEP)))
def test_what_is_as_deep_or_as_long_as_may_be_is_read_back(text):
    tree = parse(text)
    again = parse(spelled(tree))
    values = {"x": 1.25, "r": 1.5, "y": 0.75, "abcdef": 0.5}
    assert evaluate(again, values) == evaluate(tree, values)
