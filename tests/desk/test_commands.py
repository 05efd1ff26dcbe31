"""`coursework edit` and `coursework serve` before they serve: what is missing or wrong is one sentence."""

from __future__ import annotations

from importlib import util
from pathlib import Path

import pytest

from coursework.commands import desk as command
from coursework.desk.policy import read_policy
from coursework.desk.serving import server
from coursework.desk.serving.config import opened
from coursework.words.errors import InputError
from tests.command import call
from tests.desk.desks import TEXT
from tests.test_imports_of_a_run import imported


@pytest.mark.parametrize("words", [("edit",), ("serve",)])
def test_a_missing_extra_is_told_with_the_line_that_installs_it(folder, monkeypatch, words):
    find = util.find_spec
    monkeypatch.setattr(command, "find_spec", lambda name: None if name == "uvicorn" else find(name))
    result = call(*words)
    assert result.exit_code == 2
    assert "-m pip install" in result.output
    assert "[desk]" in result.output


def test_a_desk_for_others_bounds_what_a_text_may_take_and_an_own_one_as_it_is_told(folder, monkeypatch):
    wishes = []
    monkeypatch.setattr(server, "serve", lambda wish, told: wishes.append(wish))
    assert call("serve", "--port", "0").exit_code == 0
    assert call("edit", "31", "--no-browser", "--port", "0", "--budget", "7", "--memory", "300").exit_code == 0
    assert [(wish.bounds.seconds, wish.bounds.memory) for wish in wishes] == [(5.0, 512.0), (7.0, 300.0)]
    assert [wish.folder for wish in wishes] == [None, folder]


@pytest.mark.parametrize("name", ["../x", "a/b", "CON", ".toml", "a b"])
def test_a_name_that_no_file_may_have(folder, name):
    result = call("edit", name, "--no-browser", "--port", "0")
    assert result.exit_code == 2
    assert "C084" in result.output


def test_a_name_is_found_in_the_folder_then_in_the_catalogue_then_it_is_new(folder):
    assert opened("31", folder) == {"name": "31", "text": TEXT, "etag": None}
    assert opened("mine", folder) == {"name": "mine", "text": "", "etag": None}
    assert opened("", folder) == {"name": "", "text": "", "etag": None}
    Path("31.toml").write_text("own", encoding="utf-8")
    own = opened("31.toml", folder)
    assert (own["name"], own["text"], bool(own["etag"])) == ("31", "own", True)


def test_a_policy_says_what_is_offered(folder):
    Path("p.toml").write_text('equations = false\nexact = false\nformats = ["html"]\nlanguage = "uk"\n', encoding="utf-8")
    policy = read_policy(Path("p.toml"))
    assert (policy.equations, policy.exact, policy.formats, policy.language) == (False, False, ("html",), "uk")


@pytest.mark.parametrize(
    ("text", "codes"),
    [
        ("equations = 1", ["C083"]), ("equation = true", ["C082"]), ("x", ["V009"]), ('formats = ["doc"]', ["C015"]),
        ('language = "de"', ["L002"]), ('exact = 1\nlanguage = "de"\nformats = ["doc"]', ["C083", "L002", "C015"]),
    ],
)  # fmt: skip
def test_a_wrong_policy_is_told(folder, text, codes):
    Path("p.toml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as wrong:
        read_policy(Path("p.toml"))
    assert [fault.code for fault in wrong.value.faults] == codes
    assert [fault.line for fault in wrong.value.faults] == [*range(1, len(codes) + 1)]
    assert call("serve", "--policy", "p.toml").exit_code == 2
    assert call("serve", "--policy", "none.toml").stderr.startswith("V003")


def test_the_server_loads_no_mathematics_and_a_run_no_server(folder):
    serving = imported("import coursework.desk.serving.server", folder)
    assert not serving & {"sympy", "pydantic", "pandas", "matplotlib", "typst"}
    running = imported("import coursework.commands.run", folder)
    assert not running & {"starlette", "uvicorn", "watchfiles", "asyncio", "coursework.desk"}
