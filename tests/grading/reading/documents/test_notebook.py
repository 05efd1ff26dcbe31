"""What the outputs and the text of a notebook's cells become, and what is no notebook."""

from __future__ import annotations

import json
from typing import Any

import pytest

from coursework.grading.reading.documents.document import Document, place_of
from coursework.grading.reading.documents.notebook import document_of_notebook, is_notebook


def notebook(*cells: dict[str, Any]) -> Document:
    return document_of_notebook(json.dumps({"cells": cells, "nbformat": 4}), "utf-8")


def code(*outputs: dict[str, Any], source: str = "w = 9") -> dict[str, Any]:
    return {"cell_type": "code", "source": source, "outputs": outputs}


def printed(*text: str) -> dict[str, Any]:
    return {"output_type": "stream", "text": [*text]}


def shown(**data: Any) -> dict[str, Any]:
    return {"output_type": "execute_result", "data": {f"text/{kind}": text for kind, text in data.items()}}


@pytest.mark.parametrize(("outputs", "texts"), [
    ([printed("a ", "b"), printed("c")], ["a bc"]), ([printed("\x1b[1ma\x1b[0m")], ["a"]), ([shown(plain="x")], ["x"]),
    ([shown(plain="\x1b[31mx")], ["x"]),
    ([shown(plain="x", html="<p>x</p>")], ["x"]),
    ([shown(plain="x", latex="$w = 1$")], ["$w = 1$"]),
    ([printed("a"), shown(plain="x"), printed("b")], ["a", "x", "b"]), ([shown(html="<p>x</p>")], []), ([shown()], []),
    ([shown(plain=["x", None, "y"])], ["xy"]), ([{"output_type": "error"}], []),
])  # fmt: skip
def test_outputs_of_a_cell_are_texts_the_last_first(outputs: list[dict[str, Any]], texts: list[str]) -> None:
    assert [text for text, _ in notebook(code(*outputs)).texts] == texts[::-1]


def test_a_table_of_html_is_shown_as_its_text_in_the_place_of_the_plain_one() -> None:
    page = shown(plain="a b", html="<TABLE><tr><td>1</td><td>2</td></tr></TABLE>")
    ((text, _),) = notebook(code(page)).texts
    assert text.split() == ["1", "2"]


def test_cells_have_numbers_and_the_text_of_markdown_is_read_but_not_that_of_code() -> None:
    text = {"cell_type": "markdown", "source": ["so $w1 = 2$\n", "w2 = 3"]}
    found = notebook({"cell_type": "raw", "source": "w0 = 1"}, text, code(printed("w3 = 4\nw4\t= 5\nw5")), code(printed("last")))
    assert [(line.text, line.place) for line in found.lines] == [
        ("w0 = 1", place_of("cell", number=1)), ("w1 = 2", place_of("cell", number=2)), ("so", place_of("cell", number=2)),
        ("w2 = 3", place_of("cell", number=2)), ("w3 = 4", place_of("cell", number=3)),
    ]  # fmt: skip
    assert [place for _, place in found.texts] == [place_of("cell", number=4), place_of("cell", number=3)]
    assert found.first_counts


@pytest.mark.parametrize(("count", "first"), [(200, 0), (201, 1)])
def test_the_last_two_hundred_outputs_are_looked_at(count: int, first: int) -> None:
    found = notebook(*(code(printed(str(number))) for number in range(count)))
    assert [text for text, _ in found.texts] == [str(number) for number in reversed(range(first, count))]


@pytest.mark.parametrize(("count", "read"), [(2000, 1), (2001, 0)])
def test_two_thousand_cells_are_looked_at(count: int, read: int) -> None:
    assert len(notebook(*[{}] * (count - 1), code(printed("a"))).texts) == read


@pytest.mark.parametrize(
    "broken", [{"cells": 1}, {"cells": [1, "a", {"cell_type": 1}, {"cell_type": "code", "outputs": [1, {"data": 2}]}]}]
)
def test_a_notebook_of_another_shape_shows_nothing(broken: dict[str, Any]) -> None:
    found = document_of_notebook(json.dumps(broken), "utf-8")
    assert (found.texts, found.lines, found.tables) == ([], [], [])


@pytest.mark.parametrize(("text", "is_one"), [
    ('\ufeff\n {"cells": [], "nbformat": 4}', True), ('["cells", "nbformat"]', False), ('{"cells": []}', False),
    ('{"nbformat": 4}', False),
])  # fmt: skip
def test_a_notebook_is_known_by_its_names(text: str, is_one: bool) -> None:
    assert is_notebook(text) is is_one
