"""A drawing in OpenDocument: beside its picture stands its SVG, with its title as text."""

from coursework.takeaway.figures.drawings import Picture
from coursework.takeaway.note.open_document import MANIFEST, _with_drawings


def test_a_drawing_whose_title_has_what_does_not_print_leaves_the_text_readable():
    files = {"a.png": b"PNG", MANIFEST: b"<manifest:manifest></manifest:manifest>"}
    drawn = {b"PNG": Picture("a", "<svg/>", 1.0, 1.0, "the <wheel>\x07\u202e")}
    text = _with_drawings(files, '<draw:image xlink:href="a.png"/>', drawn)
    assert text.endswith("<svg:desc>the &lt;wheel&gt;</svg:desc>") and "a.svg" in files


def test_a_picture_that_is_no_drawing_stays_as_it_is():
    files = {"a.png": b"PNG", MANIFEST: b"<manifest:manifest></manifest:manifest>"}
    text = '<p><draw:image xlink:href="a.png"/><draw:image xlink:href="b.png"/></p>'
    assert _with_drawings(files, text, {b"other": Picture("a", "<svg/>", 1.0, 1.0, "")}) == text
    assert files[MANIFEST] == b"<manifest:manifest></manifest:manifest>"
