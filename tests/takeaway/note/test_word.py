"""A drawing in Word: beside the PNG that pandoc put down stands its SVG, once, however often it is shown."""

import pytest

from coursework.takeaway.figures.drawings import Picture
from coursework.takeaway.note.word import RELATIONS, TYPES, _with_drawings


@pytest.mark.parametrize("blip", ['<a:blip r:embed="rId7"/>', '<a:blip r:embed="rId7" />', '<a:blip r:embed="rId7"></a:blip>'])
def test_a_drawing_has_its_svg_beside_it(blip):
    files = {
        RELATIONS: b'<Relationships><Relationship Id="rId7" Target="media/a.png"/>'
        b'<Relationship Id="rId8" Target="b"/></Relationships>',
        TYPES: b'<Types><Default Extension="png" ContentType="image/png"/></Types>', "word/media/a.png": b"PNG", "word/b": b"?",
    }  # fmt: skip
    other = '<a:blip r:embed="rId8"/><a:blip r:embed="rId9"/>'
    text = _with_drawings(files, f"<p><wp:inline>{blip}{blip}{other}</p>", {b"PNG": Picture("a", "<svg/>", 1.0, 1.0, "")})
    assert text.count('<a:blip r:embed="rId7"><a:extLst>') == 2 == text.count('r:embed="rIdSvg1"') and other in text
    assert files["word/media/drawing1.svg"] == b"<svg/>" and "word/media/drawing2.svg" not in files
    assert files[RELATIONS].count(b'Id="rIdSvg1"') == 1 and b'Target="media/drawing1.svg"' in files[RELATIONS]
    assert files[TYPES].count(b'Extension="svg"') == 1 and b'Extension="png"' in files[TYPES]
    assert 'distT="0" distB="0"' in text


def test_a_document_without_drawings_has_no_new_parts():
    files = {RELATIONS: b"<Relationships></Relationships>", TYPES: b"<Types></Types>"}
    assert _with_drawings(files, '<a:blip r:embed="rId7"/>', {b"PNG": Picture("a", "<svg/>", 1.0, 1.0, "")}) == (
        '<a:blip r:embed="rId7"/>'
    )
    assert files == {RELATIONS: b"<Relationships></Relationships>", TYPES: b"<Types></Types>"}
