"""`variants/variant.schema.json`, which editors read while a file is typed: fresh, and true of every good file.

To write it anew after `coursework/variant/reading/schema.py` has changed:  python tests/variant/reading/test_schema.py
"""

import json
import tomllib
from pathlib import Path

import jsonschema
import pytest

from coursework.variant.catalogue import names
from coursework.variant.reading.models import json_schema
from coursework.words.data_folders import folder

ROOT = Path(__file__).parents[3]
FILE = ROOT / "variants" / "variant.schema.json"
BAD = Path(__file__).parents[1] / "bad"


def data(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def validator():
    schema = json.loads(FILE.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def test_the_file_is_fresh():
    fresh = json.loads(FILE.read_text(encoding="utf-8")) == json_schema()
    assert fresh, "the schema has changed: write it anew with  python tests/variant/reading/test_schema.py"


@pytest.mark.parametrize("name", names())
def test_the_catalogue_fits(name, validator):
    validator.validate(data(folder("variants") / f"{name}.toml"))


@pytest.mark.parametrize("path", [ROOT / "tests" / "reference" / "format_page_31.toml", ROOT / "reports" / "new-variant.toml"])
def test_other_good_files_fit(path, validator):
    validator.validate(data(path))


@pytest.mark.parametrize(
    "name",
    [
        "shape-unknown-keys",
        "shape-missing-sections",
        "shape-missing-keys",
        "shape-wrong-types",
        "shape-check-row-zero",
        "group-kind",
    ],
)
def test_faults_of_shape_do_not_fit(name, validator):
    assert not validator.is_valid(data(BAD / f"{name}.toml"))


def test_every_key_of_the_format_page_is_in_it():
    sections = set(data(ROOT / "tests" / "reference" / "format_page_31.toml"))
    assert sections <= set(json_schema()["properties"])


def test_the_catalogue_names_it_where_editors_look():
    assert (folder("variants") / "31.toml").read_text(encoding="utf-8").startswith("#:schema ./variant.schema.json\n")


if __name__ == "__main__":
    FILE.write_text(json.dumps(json_schema(), indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
