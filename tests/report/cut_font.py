"""Cut a Chinese face to the signs that the words need:  python -m tests.report.cut_font NotoSansCJK-Regular.ttc

Enters: Google's Noto Sans CJK (a collection; the face for simplified Chinese is taken), under the SIL Open Font License.
Leaves: `reports/fonts/NotoSansSC.otf` with the signs of `words.zh.toml` and of the Chinese texts of the catalogue.  A name
that a student types is set in the faces of the machine, as for any script.
"""

from __future__ import annotations

import sys
import unicodedata
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTCollection, TTFont

ROOT = Path(__file__).parents[2]
FACE = ROOT / "reports" / "fonts" / "NotoSansSC.otf"
FAMILY = "Noto Sans CJK SC"


def wanted() -> set[str]:
    """Return every wide sign of the words file and of the catalogue."""
    files = [ROOT / "reports" / "words.zh.toml", *sorted((ROOT / "variants").rglob("*.toml"))]
    text = "".join(path.read_text(encoding="utf-8") for path in files)
    return {sign for sign in text if unicodedata.east_asian_width(sign) in "WF"}


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
