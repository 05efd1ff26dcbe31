"""A length below zero is refused with the way to mean it; offsets and coordinates keep their sign."""

import pytest
from click.testing import CliRunner

import coursework
from coursework.commands.cli import main
from coursework.variant.catalogue import find
from tests.mechanisms.library import changed, mechanism

LEVER = mechanism("arm-with-offsets")
WHEEL = mechanism("rolling-wheel")


def with_datum(text, name, value):
    return coursework.parse_variant(changed(text, **{name: value}), "v.toml")


def refused(text, name, value):
    with pytest.raises(coursework.InputError) as caught:
        with_datum(text, name, value)
    return caught.value.faults


@pytest.mark.parametrize(("text", "name", "line"), [(LEVER, "a", 18), (LEVER, "b", 19), (WHEEL, "R", 16), (WHEEL, "Q", 21)])
def test_a_length_below_zero_is_refused_where_it_is_used(text, name, line):
    assert with_datum(text, name, "1e-9 m").values[name] == 1e-9
    (fault,) = refused(text, name, "-1e-9 m")
    assert (fault.code, fault.line) == ("V308", line)
    assert str(fault.message).startswith(f"{name}: a finite length above zero was expected, found -1e-9 m.")
    assert "turn its angle by pi instead" in str(fault.message)
    assert {fault.code for fault in refused(text, name, "0 m")} == {"V087"}


@pytest.mark.parametrize("name", ["e", "h"])
def test_an_offset_and_a_coordinate_may_be_negative(name):
    assert with_datum(LEVER, name, "-0.05 m").values[name] == -0.05


def test_what_a_formula_says_of_lengths_above_zero_is_meant():
    assert with_datum(LEVER.replace("a @ phi1", "(a - b) @ phi1"), "a", "0.2 m").values["a"] == 0.2
    assert with_datum(LEVER.replace('"A + b @ phi2"', '"A + -b @ phi2"'), "b", "0.5 m").values["b"] == 0.5


@pytest.mark.parametrize(
    ("name", "datum"), [("31", "r1=-0.953m"), ("31", "r3=-457mm"), ("example-1", "r1=-0.4m"), ("v107", "R=-0.2m")]
)
def test_set_is_refused_as_the_file_is(name, datum, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    told = CliRunner().invoke(main, ["run", name, "--set", datum, "--format", "csv"])
    assert told.exit_code == 2
    assert "V308" in told.stderr
    assert "turn its angle by pi instead" in told.stderr
    assert len(told.stderr.splitlines()) == 1


def test_many_sets_tell_of_the_one_with_a_length_below_zero():
    sets = {"r1": [0.4, -0.4]}
    with pytest.raises(coursework.InputError, match="D021 set 2: r1: a finite length above zero"):
        coursework.solve_many("example-1", sets)
    assert coursework.feasible_many("example-1", sets)[0].tolist() == [True, False]


def test_without_geometry_a_negative_length_is_a_remark():
    text = find("31").read_text(encoding="utf-8")
    bare = text[: text.index("[points]")] + text[text.index("[ask]") :].replace('"graph_check", ', "").replace(
        '"graph_check"', '"table"'
    )
    bare = bare.replace('quantities = ["table", "plots", "checks", "table", "accuracy"]', 'quantities = ["table"]')
    assert coursework.parse_variant(bare).plausibility == ()
    remarks = coursework.parse_variant(
        bare.replace('r2    = { value = "', 'r2    = { value = "-').replace('"0.847 m"', '"-0.847 m"')
    ).plausibility
    assert [remark.code for remark in remarks] == ["LENGTH"]
    assert "r2 = -0.847 m is negative" in str(remarks[0].sentence)


@pytest.mark.parametrize(("sets", "told"), [
    ({"x": [0.01, 0.4]}, "D021 set 2: RRR, the link from B: a finite length above zero was expected, found -0.05 m"),
    ({"x": [0.4, 0.5]}, "D021 set 1: RRR, the link from B: a finite length above zero was expected, found -0.05 m"),
    ({"r3": [5.0, 6.0]}, "D021 set 1: RRR .B, D. cannot be assembled"),
])  # fmt: skip
def test_many_sets_of_a_link_whose_length_is_a_function_tell_of_the_first_without_one(sets, told):
    law = ("[time]", '[functions]\nq = "r2 - x"\n[time]'), ('["r2", "r3"]', '["q", "r3"]'), ("[given]", '[given]\nx = "1 cm"')
    variant = coursework.parse_variant(mechanism("four-bar", *law))
    with pytest.raises(coursework.InputError, match=told):
        coursework.solve_many(variant, sets)
