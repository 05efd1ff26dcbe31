"""A PDF with its objects compressed holds the same objects, page for page, and half the bytes."""

import pymupdf
import pytest
import typst

from coursework.report.pages.packed import packed

SOURCE = b"""#set document(title: "Packed")
#set text(lang: "en")
#for place in range(40) [
  = Heading #place
  A word, #math.equation(alt: "x", $x_#place$), and a list:
  - one
  - two
]
"""


@pytest.fixture(scope="module")
def written():
    return bytes(typst.compile(SOURCE, format="pdf", pdf_standards=["ua-1"], timestamp=0))


def objects(document):
    """Return every object, as text and as what its stream says."""
    numbers = range(1, document.xref_length())
    said = [document.xref_object(n, compressed=True) for n in numbers]
    return [(text, document.xref_stream(n)) for n, text in zip(numbers, said, strict=True) if "/ObjStm" not in text]


def test_nothing_is_lost(written):
    before, after = pymupdf.open(stream=written), pymupdf.open(stream=packed(written))
    assert not after.is_repaired
    assert len(objects(before)) > 200
    assert [one for one in objects(after) if "/XRef" not in one[0]] == objects(before)
    assert [page.get_text() for page in after] == [page.get_text() for page in before]
    assert after.metadata == {**before.metadata}
    assert after.get_toc() == before.get_toc()


def test_it_is_half_as_long(written):
    assert len(packed(written)) < 0.5 * len(written)


def test_the_same_bytes_again(written):
    assert packed(written) == packed(written)


def test_a_page_written_in_another_way_stays_as_it_is(written):
    for other in (b"", b"%PDF-1.7", packed(written), written + b"\nmore"):
        assert packed(other) == other
