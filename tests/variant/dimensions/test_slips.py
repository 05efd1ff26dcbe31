"""No good file is suspected; a unit exchanged is always caught and its datum named; a name left out of a product is caught."""

import re
import time
from functools import cache

import pytest

import coursework
from coursework.variant.catalogue import names
from coursework.variant.reading.reader import parse_variant, read_variant
from coursework.words.data_folders import folder
from tests.hard.families import random_case
from tests.sample import SAMPLE
from tests.variant.dimensions.slips import exchanged_units, names_left_out

PAGE = folder("variants").parent / "tests" / "reference" / "format_page_31.toml"
# Without tables: a file that has one is read beside it.
CATALOGUE = {name: (folder("variants") / f"{name}.toml").read_text(encoding="utf-8") for name in names()}


@cache
def generated() -> tuple[str, ...]:
    return tuple(random_case(seed).text for seed in range(150))


@pytest.fixture
def read(tmp_path):
    """Return a function that reads a text as a file beside the tables of the catalogue."""
    for table in folder("variants").glob("*.csv"):
        (tmp_path / table.name).write_bytes(table.read_bytes())

    def read_text(text):
        path = tmp_path / "spoilt.toml"
        path.write_text(text, encoding="utf-8")
        return read_variant(path)

    return read_text


@pytest.mark.parametrize("name", names())
def test_no_file_of_the_catalogue_is_suspected(name):
    assert coursework.load(name).plausibility == ()


def test_no_other_good_file_is_suspected():
    assert coursework.load(PAGE).plausibility == ()
    assert coursework.load(folder("reports") / "new-variant.toml").plausibility == ()


def test_no_generated_mechanism_is_suspected():
    """Four-bars, slider-cranks and chains with drives of bare numbers; their lengths differ by factors of up to 3000."""
    codes = {remark.code for text in generated() for remark in parse_variant(text).plausibility}
    assert codes <= {"LENGTH"}


@pytest.mark.parametrize("asked", [SAMPLE, pytest.param(names(), marks=pytest.mark.long)], ids=["sample", "all"])
def test_every_unit_exchanged_is_caught_and_its_datum_named(read, asked):
    tried = 0
    for name in asked:
        text = CATALOGUE[name]
        for slip in exchanged_units(text, coursework.load(name)):
            tried += 1
            with pytest.raises(coursework.InputError) as caught:
                read(slip.text)
            said = str(caught.value)
            assert "\n" not in said, said
            named = re.search(rf'(^|[ ;,]){slip.name} = "|coordinates\.{slip.name}\.start', said)
            assert named, (name, slip.what, said)
            assert f"spoilt.toml:{slip.line}" in said or f"(line {slip.line})" in said
    assert tried >= 601 * len(asked) / len(CATALOGUE) * 3 / 4


def left_out(texts, read):
    """Return how many names were left out, how many were caught, where a datum was blamed, and which got a remark."""
    tried, blamed, remarked, missed = 0, [], 0, []
    for text in texts:
        for slip in names_left_out(text):
            tried += 1
            try:
                variant = read(slip.text)
            except coursework.InputError as error:
                if re.search(r"toml:\d+  \w+ = ", str(error)):
                    blamed.append(str(error))
                continue
            missed.append(slip.what)
            remarked += any(remark.code == "NUMBER" for remark in variant.plausibility)
    return tried, blamed, remarked, missed


@pytest.mark.long
def test_a_name_left_out_of_a_product_is_caught_and_no_datum_blamed(read):
    """At least 453 of 459, as in the catalogue and in generated equations; what is left is a number beside a velocity."""
    tried, blamed, remarked, missed = left_out(CATALOGUE.values(), read)
    assert blamed == []
    others = left_out([text for text in generated() if "equation" in text][: len(CATALOGUE)], read)
    tried, remarked, missed = tried + others[0], remarked + others[2], missed + others[3]
    assert tried >= 459 * 3 / 4
    assert len(missed) * 459 <= 6 * max(tried, 459)
    assert remarked == len(missed)


def test_a_formula_beside_a_wrong_datum_is_judged_too(read):
    """One file, a unit exchanged and another that is unknown: both are told, in file order."""
    text = CATALOGUE["31"].replace('"0.953 m"', '"0.953 mtr"').replace('"4.35 rad"', '"4.35 m"')
    with pytest.raises(coursework.InputError) as caught:
        read(text)
    first, second = str(caught.value).split("\n")
    assert first.endswith('given.r1: a length was expected: m, cm, mm (found "0.953 mtr").')
    assert ':18  alpha = "4.35 m" is a length; ' in second


def test_in_a_file_of_thousands_of_data_the_culprit_is_not_looked_for(read):
    """Freeing each of 1500 data in turn would take seconds; the two terms are told, and that is all."""
    data = "".join(f'g{i} = "1 m"\n' for i in range(1500))
    sums = "".join(f'[[constraint]]\nequation = "w4 = {"+".join(f"g{i * 7 + j}" for j in range(60))}"\n' for i in range(60))
    begun = time.process_time()
    with pytest.raises(coursework.InputError, match=r"constraint 16: r2\*sin\(phi2\) is a length"):
        read(CATALOGUE["31"].replace("[drive]", data + "[drive]").replace("r2*w2*sin", "r2*sin") + sums)
    assert time.process_time() - begun < 5
