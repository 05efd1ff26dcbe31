"""Cut a Chinese face to the signs that the words need:  python -m tests.report.cut_font NotoSansCJK-Regular.ttc

Enters: Google's Noto Sans CJK (a collection; the face for simplified Chinese is taken), under the SIL Open Font License.
Leaves: `reports/fonts/NotoSansSC.otf` with the signs of `words.zh.toml`, of the Chinese texts of the catalogue and all of
GB 2312, in which the names of people and schools are written.  What that lacks is set in the faces of the machine.
"""

from __future__ import annotations

import sys
import unicodedata
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTCollection, TTFont

ROOT = Path(__file__).parents[2]
FACE = ROOT / "reports" / "fonts" / "NotoSansSC.otf"
MARKS = "“”‘’—…"  # which Chinese sets as wide as its signs
FAMILY = "Noto Sans CJK SC"


def wanted() -> set[str]:
    """Return every wide sign of the words file, of the catalogue and of GB 2312."""
    files = [ROOT / "reports" / "words.zh.toml", *sorted((ROOT / "variants").rglob("*.toml"))]
    text = "".join(path.read_text(encoding="utf-8") for path in files)
    return {sign for sign in text if unicodedata.east_asian_width(sign) in "WF"} | national()


def national() -> set[str]:
    """Return the 6763 hanzi of GB 2312, with its punctuation."""
    rows = (*range(0xA1, 0xA4), *range(0xB0, 0xF8))
    signs = (bytes((row, place)).decode("gb2312", "ignore") for row in rows for place in range(0xA1, 0xFF))
    return {sign for sign in signs if sign and (unicodedata.east_asian_width(sign) in "WF" or sign in MARKS)}


def signs_of(face: Path) -> set[str]:
    """Return the signs that a face has."""
    return set(map(chr, TTFont(face).getBestCmap()))


def main(collection: Path) -> None:
    """Write the cut face."""
    options = Options(layout_features=["*"], name_IDs=["*"], notdef_outline=True, hinting=False)
    subsetter = Subsetter(options)
    subsetter.populate(text="".join(sorted(wanted())))
    (font,) = (font for font in TTCollection(collection).fonts if font["name"].getDebugName(1) == FAMILY)
    font["head"].modified = font["head"].created  # the same bytes on every run
    font.recalcTimestamp = False
    subsetter.subset(font)
    FACE.parent.mkdir(exist_ok=True)
    font.save(FACE)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
