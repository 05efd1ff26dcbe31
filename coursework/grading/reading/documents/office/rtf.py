r"""RTF as WordPad, Word and LibreOffice write it -> its tables, paragraphs and equations.

Enters: bytes.  Leaves: `Document`.  Raises `Refused`.  Pictures, objects and hidden text are skipped.
A table is recognised by \intbl, \cell and \row, one inside a cell by \itap, \nestcell and \nestrow.  Used by `read_document.py`.
"""

from __future__ import annotations

import re
from dataclasses import replace

from coursework.grading.reading.documents.document import Document
from coursework.grading.reading.documents.formulas import omml
from coursework.grading.reading.documents.formulas.formula_tree import FormulaTree
from coursework.grading.reading.documents.office.builder import DocumentBuilder
from coursework.grading.reading.documents.signs import symbol_font
from coursework.grading.reading.limits import Room, unreadable
from coursework.system.frozen import frozen

_TOKEN = re.compile(
    r"\\(?P<word>[a-zA-Z]{1,32})(?P<number>-?[0-9]{1,9})? ?|\\'(?P<hex>[0-9a-fA-F]{2})|\\(?P<sign>.)|(?P<brace>[{}])"
    r"|(?P<end>[\r\n]+)|(?P<text>[^\\{}\r\n]+)",
    re.DOTALL,
)
_MOST_TOKENS, _DEEPEST, _MOST_TABLES_DEEP = 500_000, 10_000, 10
_SKIPPED = {
    "fonttbl", "colortbl", "stylesheet", "info", "pict", "object", "header", "headerl", "headerr", "headerf", "footer", "footerl",
    "footerr", "footerf", "footnote", "annotation", "themedata", "datastore", "nonshppict", "nonesttables", "listtable",
    "mmathPict", "fldinst", "revtbl", "rsidtbl", "generator", "listtext", "filetbl", "xmlnstbl", "mmathPr", "deleted",
}  # fmt: skip
_KEPT = {"nesttableprops", "moMath", "moMathPara"}  # optional destinations (marked \*) that are read here
_BREAKS = {"par": "\n", "line": "\n", "tab": "\t", "page": "\n", "sect": "\n", "softline": "\n"}
_LETTERS = {
    "emdash": "—", "endash": "–", "lquote": "'", "rquote": "’", "ldblquote": '"', "rdblquote": '"', "bullet": "•", "emspace": " ",
    "enspace": " ", "qmspace": " ",
}  # fmt: skip
_CHARSETS = {0: "", 2: "symbol", 77: "mac_roman", 128: "cp932", 129: "cp949", 134: "gb18030", 136: "cp950", 161: "cp1253",
             162: "cp1254", 186: "cp1257", 204: "cp1251", 238: "cp1250"}  # fmt: skip
_FONT = re.compile(r"\\f([0-9]{1,5})(?=[^0-9])[^;{}]{0,300}?\\fcharset([0-9]{1,3})")


@frozen
class _Group:
    """The state that holds inside a pair of braces."""

    is_skipped: bool = False
    codec: str = ""
    position: str = ""
    after_unicode: int = 1  # number of fallback characters after each \u
    node: str = ""  # the element of an equation that the group is, "" if none


def is_rtf(content: bytes) -> bool:
    """Return whether a file is RTF."""
    return content.startswith(b"{\\rtf")


def document_of_rtf(content: bytes, room: Room) -> Document:
    """Return the tables, paragraphs and equations of an RTF file."""
    return _Reader(DocumentBuilder("rtf", room), content.decode("latin-1")).read()


class _Reader:
    """Handles control words and groups; open groups are kept in a list, without recursion."""

    def __init__(self, builder: DocumentBuilder, text: str) -> None:
        self.builder, self.source = builder, text
        usual = re.search(r"\\ansicpg([0-9]{3,5})", text[:2000])
        self.usual = {"936": "gb18030", "65001": "utf-8"}.get(usual[1], f"cp{usual[1]}") if usual else "cp1252"
        table = text.find("{\\fonttbl")
        fonts = _FONT.findall(text[table : table + 100_000]) if table >= 0 else []
        self.fonts = {int(font): _CHARSETS.get(int(charset), "") for font, charset in fonts}
        self.groups = [_Group()]
        self.formula: FormulaTree | None = None
        self.waiting = bytearray()  # bytes in a code page, collected until they are decoded together
        self.leaving = 0  # number of fallback characters still to skip after a \u
        self.is_starred = self.is_first = False
        self.level = 0  # number of nested tables around the paragraph
        self.merges: list[tuple[bool, bool]] = []  # per cell of a row: continues the cell on the left, the one above
        self.merge = (False, False)
        self.at: list[int] = []  # per open table: number of cells of the row so far

    def read(self) -> Document:
        """Return the document of the whole file.  Raises `Refused` if it has too many tokens or is nested too deeply."""
        place, tokens = 0, 0
        while match := _TOKEN.match(self.source, place):
            place = match.end()
            tokens += 1
            if tokens > _MOST_TOKENS or len(self.groups) > _DEEPEST:
                raise unreadable("too_large_open")
            kind = match.lastgroup
            if kind == "number" or kind == "word":
                number = match["number"]
                if match["word"] == "bin":
                    place += max(int(number or 0), 0)
                self._word(match["word"], int(number) if number else None)
            elif kind == "brace":
                self._brace(match[0])
            elif kind == "hex":
                self._byte(int(match[0][2:], 16))
            elif kind == "sign":
                self._sign(match[0][1])
            elif kind == "text":
                self._text(match[0])
        self._flush()
        return self.builder.finished()

    def _brace(self, brace: str) -> None:
        self._flush()
        self.leaving = 0
        if brace == "{":
            self.groups.append(replace(self.groups[-1], node=""))
            self.is_starred, self.is_first = False, True
        elif len(self.groups) > 1:
            closed = self.groups.pop()
            if closed.node and self.formula is not None:
                if closed.node == "oMath":
                    self.builder.formula(omml.text_of_omml(self.formula.top))
                    self.formula = None
                else:
                    self.formula.end()

    def _sign(self, sign: str) -> None:
        if sign == "*":
            self.is_starred = True
        elif sign in "\\{}":
            self._text(sign)
        elif sign in "~_":
            self._put(" " if sign == "~" else "-")
        elif sign in "\r\n":
            self._word("par", None)

    def _word(self, word: str, number: int | None) -> None:
        self._flush()
        group = self.groups[-1]
        is_first, self.is_first = self.is_first, False
        if is_first and (word in _SKIPPED or (self.is_starred and word not in _KEPT)):
            known = self.formula is not None and word.startswith("m")
            if not known or word in _SKIPPED:
                self.groups[-1] = replace(group, is_skipped=True)
                return
        if group.is_skipped:
            return
        if is_first and word.startswith("m") and self._began(word[1:]):
            return
        if word == "u" and number is not None:
            self._put(chr(number % 65536))
            self.leaving = self.groups[-1].after_unicode
        elif word == "uc":
            self.groups[-1] = replace(group, after_unicode=min(max(number or 0, 0), 20))
        elif word == "f":
            self.groups[-1] = replace(group, codec=self.fonts.get(number or 0, ""))
        elif word in {"super", "sub"}:
            self.groups[-1] = replace(group, position=word if number != 0 else "")
        elif word in {"nosupersub", "plain"}:
            self.groups[-1] = replace(group, position="")
        elif word == "v" and number != 0:  # hidden
            self.groups[-1] = replace(group, is_skipped=True)
        elif word in _BREAKS:
            self._break(word)
        elif word in _LETTERS:
            self._put(_LETTERS[word])
        else:
            self._table_word(word, number)

    def _began(self, name: str) -> bool:
        """Begin an equation or an element of one if the group is such; return whether it is."""
        if self.formula is None and name == "oMath":
            self._to_level()
            self.formula = FormulaTree(name)
        elif self.formula is None or name not in omml.ELEMENTS:
            return False
        else:
            self.formula.begin(name, {})
        self.groups[-1] = replace(self.groups[-1], node=name)
        return True

    def _table_word(self, word: str, number: int | None) -> None:
        if word == "pard":
            self.level = 0
        elif word == "intbl":
            self.level = max(self.level, 1)
        elif word == "itap":
            self.level = min(max(number or 0, 0), _MOST_TABLES_DEEP)
        elif word == "trowd":
            self.merges, self.merge = [], (False, False)
        elif word in {"clmrg", "clvmrg"}:
            self.merge = (self.merge[0] or word == "clmrg", self.merge[1] or word == "clvmrg")
        elif word == "cellx":
            self.merges, self.merge = [*self.merges[:1000], self.merge], (False, False)
        elif word in {"cell", "nestcell"}:
            self.level = max(self.level, 1 if word == "cell" else 2)
            self._to_level()
            self._close_cell()
        elif word in {"row", "nestrow"} and self.at:
            self.builder.close_paragraph()
            self.builder.close_row()
            self.at[-1] = 0

    def _close_cell(self) -> None:
        self.builder.close_paragraph()
        at = self.at[-1]
        beside, above = self.merges[at] if at < len(self.merges) else (False, False)
        self.builder.close_cell(1, above, beside)
        self.at[-1] += 1

    def _to_level(self) -> None:
        """Open or close tables until as many are open as the paragraph is nested in."""
        while len(self.at) > self.level:
            self.builder.close_table()
            self.at.pop()
        while len(self.at) < self.level:
            self.builder.close_paragraph()
            self.builder.open_table()
            self.at.append(0)

    def _break(self, word: str) -> None:
        if self.formula is not None:
            self.formula.text(" ")
        elif word == "par":
            self._to_level()
            self.builder.close_paragraph()
        else:
            self._put(_BREAKS[word])

    def _byte(self, code: int) -> None:
        if self.leaving:
            self.leaving -= 1
        else:
            self.waiting.append(code)

    def _text(self, text: str) -> None:
        self.is_first = False
        if self.leaving:
            gone = min(self.leaving, len(text))
            text, self.leaving = text[gone:], self.leaving - gone
        if text:
            if text.isascii():
                self._flush()
                self._put(text if self.groups[-1].codec != "symbol" else "".join(map(symbol_font, text)))
            else:
                self.waiting += text.encode("latin-1")

    def _flush(self) -> None:
        """Decode and add the collected bytes."""
        if not self.waiting:
            return
        raw, codec = bytes(self.waiting), self.groups[-1].codec
        self.waiting.clear()
        if codec == "symbol":
            self._put("".join(map(symbol_font, raw.decode("latin-1"))))
            return
        try:
            self._put(raw.decode(codec or self.usual, errors="replace"))
        except LookupError:  # an unknown code page
            self._put(raw.decode("cp1252", errors="replace"))

    def _put(self, text: str) -> None:
        if self.groups[-1].is_skipped:
            return
        if self.formula is not None:
            node = self.groups[-1].node
            if node in {"begChr", "endChr", "chr"}:
                self.formula.value(text.strip())
            else:
                self.formula.text(text)
        elif text.strip() or self.builder.has_paragraph:
            self._to_level()
            self.builder.text(text, self.groups[-1].position)
