"""The texts that cells of a workbook share: put together where they are rich, without their readings, no more than are wanted."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from coursework.grading.reading.files.xlsx import _shared, _SheetReader
from coursework.grading.reading.limits import Room

TEXTS = (
    "<sst><si><t>t</t></si><si><r><t>phi</t></r><r><t>1</t></r></si>"
    "<si><t>角</t><rPh><t>カク</t></rPh></si><si><t>w1</t></si><si><t>w2</t></si></sst>"
)


@pytest.mark.parametrize(("wanted", "found"), [
    ({0}, {0: "t"}), ({1, 3}, {1: "phi1", 3: "w1"}), ({4, 0}, {0: "t", 4: "w2"}), ({2, 9}, {2: "角"}),
])  # fmt: skip
def test_the_texts_that_are_wanted_are_found_wherever_they_stand(wanted: set[int], found: dict[int, str]) -> None:
    archive = SimpleNamespace(parts={"xl/sharedStrings.xml": None}, chunks=lambda part: iter([TEXTS.encode()]))
    assert _shared(archive, wanted) == found


def test_a_workbook_without_shared_texts_has_none() -> None:
    assert _shared(SimpleNamespace(parts={}), {0}) == {}


@pytest.mark.parametrize("column", [1, 2])
def test_a_cell_is_its_value_without_the_formula_before_it(column: int) -> None:
    reader = _SheetReader(Room(9, 9))
    for _ in range(column):
        reader.begin("c", {})
        reader.text(" ")
        for part, text in (("f", "B1*2"), ("v", "6")):
            reader.begin(part, {})
            reader.text(text)
            reader.end(part)
        reader.text(" ")
        reader.row = 1
        reader.end("c")
    assert [cell.text for cell, *_ in reader.rows[1].values()] == ["6"] * column
