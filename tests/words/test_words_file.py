"""The reader of words files against the standard reader of TOML: the same sentences, the same refusals."""

import tomllib

import pytest

from coursework.words.data_folders import folder
from coursework.words.sentences import load_phrases
from coursework.words.words_file import _plain_words, read_words


@pytest.mark.parametrize("path", sorted(folder("reports").glob("words.*.toml")), ids=lambda path: path.name)
def test_the_words_files_are_read_as_toml(path):
    text = path.read_text(encoding="utf-8")
    assert _plain_words(text, tomllib.loads) == tomllib.loads(text)


@pytest.mark.parametrize(
    "text",
    [
        "", "\n", "# only a remark\n", 'a = "x"', '[a]\nb = "x" # why\nc.d = "y"\nc.e = "z"\n', "[a]\nb = '\\n'\n",
        'a = "\\u00a0"\n', '[a.b]\nc = "x"\n[a]\nd = "y"\n', '[a]\nb = """x\n[c]\n"""\n', "a = 1\n", '"1/s" = "x"\n',
        'a = ["x"]\n', '[[a]]\nb = "x"\n',
        # What the standard reader refuses.
        'a = "x\n', 'a = "x"\na = "y"\n', "[a]\n[a]\n", '[a]\nb.c = "x"\n[a.b]\n', '[a]\nb = "x"\n[a.b]\n',
        '[a.b]\n[a]\nb.c = "x"\n', 'a = "x"\n[a]\n', "[a..b]\n", "[]\n", 'a = "\x01"\n', 'a = "\\q"\n', "a\n",
        'a = "x" b\n', 'ä = "x"\n', 'a.b = "x"\na = "y"\n',
    ],
)  # fmt: skip
def test_another_file_too(text):
    try:
        expected = tomllib.loads(text)
    except ValueError:
        expected = None
    try:
        assert read_words(text) == expected
    except ValueError:
        assert expected is None


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_zero_is_written_without_a_sign(language: str) -> None:
    assert load_phrases(language).said("check.START.value", name="u", value=-0.0) == "u = 0"
    assert load_phrases(language).said("check.START.value", name="u", value=-2.0) == "u = -2"
