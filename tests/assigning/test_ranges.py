"""A ranges file: what it may say, what each fault is told as, and the values a range has."""

import json
import tomllib
from pathlib import Path

import jsonschema
import pytest

import coursework
from coursework.assigning.ranges import MEASURES, Difficulty, Limits
from coursework.assigning.reader import DIFFICULTY, LIMITS, SECTIONS, read_ranges
from coursework.words.data_folders import folder

RANGES = folder("variants") / "ranges"
SCHEMA = json.loads((RANGES / "ranges.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def read(text, template="31"):
    return read_ranges(text.encode(), "r.toml", coursework.load(template))


def texts(line, section="given", template="31"):
    (one,) = read(f"[{section}]\n{line}", template).ranges
    return [one.text(place) for place in range(one.count)]


@pytest.mark.parametrize(
    ("line", "values"),
    [
        ('r1 = { from = "0.98 m", to = "1.01 m", step = "0.01 m" }', ["0.98 m", "0.99 m", "1.00 m", "1.01 m"]),
        ('r1 = { from = "0.98 m", to = "1.0099 m", step = "0.01 m" }', ["0.98 m", "0.99 m", "1.00 m"]),
        ('r1 = { from = "98 cm", to = "99 cm", step = "0.5 cm" }', ["98.0 cm", "98.5 cm", "99.0 cm"]),
        ('alpha = { from = "-0.01 rad", to = "0.01 rad", step = "0.01 rad" }', ["-0.01 rad", "0.00 rad", "0.01 rad"]),
        ('V1 = { from = 4, to = 5, step = 0.5 }', ["4.0", "4.5", "5.0"]),
        ('p = { choice = ["12.5 1/s", "13.08 1/s"] }', ["12.5 1/s", "13.08 1/s"]),
        ('alpha = { from = "200 deg", to = "210 deg", step = "10 deg" }', ["200 deg", "210 deg"]),
    ],
)  # fmt: skip
def test_a_range_has_the_digits_it_is_written_with(line, values):
    assert texts(line) == values


FAULTS = [
    ("[given]\nr1 = 0.9", "r.toml:2:6  given.r1: a range was expected. Write { from"),
    ('[given]\nr9 = { choice = ["1 m"] }',
     'r.toml:2:1  given.r9: "r9" is not a given datum of the template. Given: r1, r2, r3, V1,'),
    ('[given]\nalpa = { choice = [1] }', 'given.alpa: "alpa" is not a given datum of the template. Did you mean "alpha"?'),
    ('[start]\nphi9 = { choice = ["1"] }',
     'r.toml:2:1  start.phi9: "phi9" is not a coordinate of the template. Did you mean "phi3"?'),
    ('[given]\nr1 = { from = "1 m", to = "2 m" }', "r.toml:2:6  given.r1: the range lacks step."),
    ('[given]\nr1 = { from = "1 m", to = "2 m", step = "1 mm" }', "from, to and step have different units"),
    ('[given]\nr1 = { from = "1 m", to = "2 m", step = "0 m" }',
     "r.toml:2:41  given.r1.step: the step must be greater than 0, found 0."),
    ('[given]\nr1 = { from = "2 m", to = "1.999 m", step = "1 m" }', "the range is empty: it goes from 2 to 1.999."),
    ('[given]\nr1 = { from = "2 rad", to = "3 rad", step = "1 rad" }', 'a length was expected: m, cm, mm (found "2 rad")'),
    ('[given]\nr1 = { choice = ["1 m", "2 mn"] }',
     'r.toml:2:25  given.r1.choice.2: a length was expected: m, cm, mm (found "2 mn")'),
    ("[given]\nr1 = { choice = [] }", "choice is a list of values"),
    ('[given]\nr1 = { choice = ["1 m"], step = "1 m" }', "either from, to and step, or choice"),
    ('[given]\nr1 = { form = "1 m", to = "2 m", step = "1 m" }', 'the key "form" is not known here. Did you mean "from"?'),
    ('[given]\nr1 = { choice = [true] }', "a value with a unit was expected, found true"),
    ('[given]\nr1 = { choice = [[1]] }', "a value with a unit was expected, such as"),
    ('[given]\nalpha = { choice = [1] }\n"α" = { choice = [1] }', 'r.toml:3:1  given.α: "α" occurs twice'),
    ('[limit]\ntries = 1\n[given]\nr1 = { choice = ["1 m"] }',
     'r.toml:1:2  limit: the key "limit" is not known here. Did you mean "limits"?'),
    ("[limits]\ntries = 1", "nothing is drawn"),
    ("[time]\ncheck_row = { choice = [4] }", "nothing is drawn"),
    ("given = 3", "a section [given] of lines key = value was expected"),
    ("[time]\ncheck_row = { choice = [4.5] }", "rows of the table from 1 to 25 were expected, found 4.5"),
    ("[difficulty]\nnumbers = 3", "a list was expected"),
    ("[difficulty]\nbanb = 0.1", 'r.toml:2:1  difficulty.banb: the key "banb" is not known here. Did you mean "band"?'),
    ("[limits]\ntrys = 1", 'r.toml:2:1  limits.trys: the key "trys" is not known here. Did you mean "tries"?'),
    ('[difficulty]\nnumbers = ["euler_eror"]',
     'r.toml:2:12  difficulty.numbers.1: "euler_eror" is not a measure. Did you mean "euler_error"?'),
    ('[difficulty]\nnumbers = [["x"]]', "is not a measure"),
    ('[given]\nr1 = { choice = ["1 m"]', "the file is not TOML here"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "told"), FAULTS)
def test_each_fault_is_told_with_file_line_and_advice(text, told):
    with pytest.raises(coursework.InputError) as refused:
        read(text)
    assert told in str(refused.value), str(refused.value)
    assert str(refused.value)[5:].startswith("r.toml")


def test_all_faults_are_told_at_once_in_file_order():
    with pytest.raises(coursework.InputError) as refused:
        read('[given]\nr1 = 1\nr2 = 2\n[limits]\ntries = 0\n[start]\nphi1 = { choice = ["1 m"] }')
    assert [fault.line for fault in refused.value.faults] == [2, 3, 5, 7]


def test_the_hardest_allowed_is_by_the_band_harder_than_the_easiest():
    assert [Difficulty(band).reach for band in (0.21, 0.44)] == [pytest.approx((1 / 1.1, 1.1)), pytest.approx((1 / 1.2, 1.2))]


def test_a_start_that_the_geometry_gives_may_not_be_listed():
    with pytest.raises(coursework.InputError, match=r"the start of theta2 follows from the data"):
        read('[start]\ntheta2 = { choice = ["1 rad"] }', "homework")
    assert texts('theta1 = { choice = ["10 deg"] }', "start", "homework") == ["10 deg"]
    with pytest.raises(coursework.InputError, match=r"the start of phi\d? ?\w* follows"):
        read('[start]\nphi4 = { choice = ["1 rad"] }', "pantograph")


INSIDE_AND_OUTSIDE = [
    ("limits", "tries", "1", "0"),
    ("limits", "tries", "100000", "100001"),
    ("limits", "least_determinant", "1", "1.001"),
    ("limits", "least_determinant", "0.001", "0"),
    ("limits", "least_transmission", '"90 deg"', '"91 deg"'),
    ("limits", "largest_velocity", '"1 1/s"', '"1 m"'),
    ("limits", "least_rows_a_turn", "1000000", "1000001"),
    ("difficulty", "band", "10", "10.1"),
    ("difficulty", "band", "0.001", "0"),
]


@pytest.mark.parametrize(("section", "key", "inside", "outside"), INSIDE_AND_OUTSIDE)
def test_limits_on_both_sides(section, key, inside, outside):
    head = '[given]\nr1 = { choice = ["1 m"] }\n'
    read(f"{head}[{section}]\n{key} = {inside}")
    with pytest.raises(coursework.InputError, match=rf"r.toml:4:\d+  {section}.{key}: "):
        read(f"{head}[{section}]\n{key} = {outside}")


@pytest.mark.parametrize(("row", "fits"), [("1", True), ("25", True), ("0", False), ("26", False)])
def test_rows_of_the_check_lie_in_the_table(row, fits):
    text = f'[given]\nr1 = {{ choice = ["1 m"] }}\n[time]\ncheck_row = {{ from = {row}, to = {row}, step = 1 }}'
    if fits:
        assert read(text).ranges[-1].text(0) == row
    else:
        with pytest.raises(coursework.InputError, match="rows of the table from 1 to 25"):
            read(text)


def test_the_schema_has_the_keys_of_the_reader():
    properties = SCHEMA["properties"]
    assert tuple(properties) == SECTIONS
    assert tuple(properties["limits"]["properties"]) == LIMITS
    assert tuple(properties["difficulty"]["properties"]) == DIFFICULTY
    assert properties["difficulty"]["properties"]["numbers"]["items"]["enum"] == list(MEASURES)
    assert properties["difficulty"]["properties"]["band"]["default"] == Difficulty().band
    assert properties["limits"]["properties"]["tries"]["default"] == Limits().tries
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("path", sorted(RANGES.glob("*.toml")), ids=lambda path: path.stem)
def test_ranges_of_the_catalogue_fit_the_schema_and_their_template(path):
    text = path.read_text(encoding="utf-8")
    assert text.startswith("#:schema ./ranges.schema.json\n")
    VALIDATOR.validate(tomllib.loads(text))
    assert read_ranges(path.read_bytes(), path.name, coursework.load(path.stem)).ranges


@pytest.mark.parametrize("text", [text for text, told in FAULTS[:1] + FAULTS[4:5] + FAULTS[10:13]])
def test_faults_of_shape_do_not_fit_the_schema(text):
    assert not VALIDATOR.is_valid(tomllib.loads(text))


def test_the_folder_of_ranges_is_no_part_of_the_list_of_variants():
    from coursework.variant.catalogue import names

    assert {path.stem for path in RANGES.glob("*.toml")} < set(names())
    assert not any("range" in name for name in names())
    assert Path(RANGES).is_dir()


def test_draws_depend_on_what_a_range_says_in_whatever_order_it_is_said():
    """The same seed gives the same data only as long as this text stays the same."""
    given = ['r1 = { choice = ["0.9 m", "0.95 m"] }', 'alpha = { choice = ["249 °", "4.35 rad"] }']
    digests = {read("[given]\n" + "\n".join(lines)).digest for lines in (given, given[::-1])}
    assert digests == {'[["given", "alpha", "249 °", "4.35 rad"], ["given", "r1", "0.9 m", "0.95 m"]]'}
