"""What a note in LaTeX opens with, for XeLaTeX and LuaLaTeX.

Leaves: text of the preamble, the class of the document, tables of a fitting size.  Used by `writer.py`.
"""

from __future__ import annotations

from coursework.takeaway.note import tree
from coursework.takeaway.note.tree import Node

MANY = 7  # columns: a wider table is set smaller
_SHARED = (
    "\\usepackage{graphicx}\\usepackage{pdflscape}\\usepackage{caption}\\usepackage{newunicodechar}"
    "\\newunicodechar{▸}{\\ensuremath{\\triangleright}}\\newunicodechar{✓}{\\ensuremath{\\checkmark}}"
    "\\newunicodechar{✗}{\\ensuremath{\\times}}\\newunicodechar{≈}{\\ensuremath{\\approx}}"
    "\\newunicodechar{≤}{\\ensuremath{\\leq}}\\newunicodechar{≥}{\\ensuremath{\\geq}}\\newunicodechar{⁻}{\\textsuperscript{-}}"
    "\\newunicodechar{−}{\\ensuremath{-}}\\newunicodechar{→}{\\ensuremath{\\to}}"
    "\\newcommand{\\notefont}[2]{\\IfFontExistsTF{#1}{\\setmainfont{#1}}{\\IfFontExistsTF{#2}{\\setmainfont{#2}}{}}}"
)
_CYRILLIC = _SHARED + (
    "\\ifPDFTeX\\else\\notefont{Times New Roman}{CMU Serif}\\fi"
    "\\usepackage{indentfirst}\\setlength{\\parindent}{12.5mm}\\linespread{1.25}"
    "\\captionsetup{labelsep=endash}\\captionsetup[table]{justification=raggedright,singlelinecheck=off}"
)
PREAMBLES = {
    "en": _SHARED + "\\captionsetup{labelsep=period}",
    "ru": _CYRILLIC + "\\AtBeginDocument{\\renewcommand{\\figurename}{Рисунок}\\renewcommand{\\tablename}{Таблица}}",
    "uk": _CYRILLIC + "\\AtBeginDocument{\\renewcommand{\\figurename}{Рисунок}\\renewcommand{\\tablename}{Таблиця}}",
    "zh": _SHARED + "\\captionsetup{labelsep=quad}",
}
CLASSES = {"zh": "ctexart", "en": "article"}  # of documents; "extarticle" in other languages


def sized_tables(blocks: list[Node]) -> list[Node]:
    """Return blocks in which tables stand in small letters, wide ones in smaller."""
    found: list[Node] = []
    for block in blocks:
        if block["t"] != "Table":
            found.append(block)
            continue
        size = "scriptsize" if len(block["c"][2]) > MANY else "small"
        found += [tree.raw_block("latex", f"\\begingroup\\{size}"), block, tree.raw_block("latex", "\\endgroup")]
    return found
