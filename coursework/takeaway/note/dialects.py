"""What Word, OpenDocument and LaTeX write differently: captions, references, numbered formulas, turned pages.

Enters: parts of a tree.  Leaves: parts of a tree.  Used by `blocks.py` and `writer.py`.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from coursework.takeaway.note.tree import Node, image, lowered, math, paragraph, raw, raw_block, styled, text
from coursework.takeaway.note.tree import emphasized as slanted

FIRST_MARK = 90_000  # first id of our bookmarks in Word: pandoc counts its own from 1
UPRIGHT, TURNED = "<w:sectPr/><!--upright-->", "<w:sectPr/><!--turned-->"  # replaced by section properties in `word.py`


class _Office:
    """What Word and OpenDocument have in common; both must be told the widths of a table's columns."""

    needs_widths = True

    def letter(self, letter: str, low: str) -> list[Node]:
        """Return a symbol in a sentence, with its subscript."""
        return [slanted(letter), *([lowered(low)] if low else [])]

    def picture(self, path: str, alt: str, size: tuple[float, float]) -> Node:
        """Return a picture with a size in mm."""
        return image(path, alt, *size)


class Word(_Office):
    """Word: SEQ and REF fields, bookmarks, tabs."""

    suffix = writer = "docx"

    def __init__(self) -> None:
        self.marks = FIRST_MARK

    def caption(self, kind: str, label: tuple[str, str, str], mark: str, said: Sequence[Node]) -> list[Node]:
        """Return the caption of a "figure" or "table": `label` is its word, number and what follows, `said` its text."""
        word, number, behind = label
        field = word_field(f"SEQ {word.strip().replace(' ', '_')} \\* ARABIC", number)
        inlines = [*text(word), raw("openxml", self._marked(mark, field)), *text(behind), *said]
        return [styled(CAPTIONS[kind], [paragraph(inlines)])]

    def numbered(self, latex: str, name: str, mark: str) -> Node:
        """Return a formula with its number at the margin; `mark` is the bookmark for references to it, "" for none."""
        number = f"<w:r><w:t>({escape(name)})</w:t></w:r>"
        tab = "<w:r><w:tab/></w:r>"
        behind = self._marked(mark, number) if mark else number
        return styled("Equation", [paragraph([raw("openxml", tab), math(latex), raw("openxml", tab + behind)])])

    def reference(self, mark: str, said: str) -> Node:
        """Return a reference to a mark."""
        return raw("openxml", word_field(f"REF {mark} \\h", said))

    def turned(self, blocks: list[Node]) -> list[Node]:
        """Return blocks on a landscape page."""

        def ends(section: str) -> Node:
            return raw_block("openxml", f"<w:p><w:pPr>{section}</w:pPr></w:p>")

        return [ends(UPRIGHT), *blocks, ends(TURNED)]

    def _marked(self, mark: str, inside: str) -> str:
        self.marks += 1
        begin = f'<w:bookmarkStart w:id="{self.marks}" w:name="{mark}"/>'
        return f'{begin}{inside}<w:bookmarkEnd w:id="{self.marks}"/>'


class OpenDocument(_Office):
    """OpenDocument: sequences, bookmarks, tabs."""

    suffix = writer = "odt"

    def caption(self, kind: str, label: tuple[str, str, str], mark: str, said: Sequence[Node]) -> list[Node]:
        word, number, behind = label
        name = SEQUENCES[kind]
        field = (
            f'<text:bookmark-start text:name="{mark}"/><text:sequence text:ref-name="{mark}" text:name="{name}" '
            f'text:formula="ooow:{name}+1" style:num-format="1">{number}</text:sequence><text:bookmark-end text:name="{mark}"/>'
        )
        inlines = [*text(word), raw("opendocument", field), *text(behind), *said]
        return [styled(CAPTIONS[kind], [paragraph(inlines)])]

    def numbered(self, latex: str, name: str, mark: str) -> Node:
        number = f"({escape(name)})"
        if mark:
            number = f'<text:bookmark-start text:name="{mark}"/>{number}<text:bookmark-end text:name="{mark}"/>'
        inlines = [raw("opendocument", "<text:tab/>"), math(latex), raw("opendocument", f"<text:tab/>{number}")]
        return styled("Equation", [paragraph(inlines)])

    def reference(self, mark: str, said: str) -> Node:
        field = f'<text:bookmark-ref text:reference-format="text" text:ref-name="{mark}">{escape(said)}</text:bookmark-ref>'
        return raw("opendocument", field)

    def turned(self, blocks: list[Node]) -> list[Node]:
        first, *others = blocks
        assert first["t"] == "Div"
        turned = {"t": "Div", "c": [[first["c"][0][0], [], [["custom-style", "Turned"]]], first["c"][1]]}
        return [turned, *others, styled("Upright", [paragraph([])])]


class Tex:
    """LaTeX: its own commands for captions, labels and tags."""

    suffix, writer, needs_widths = "tex", "latex", False

    def letter(self, letter: str, low: str) -> list[Node]:
        return [raw("latex", f"\\({tex_letter(letter)}{f'_{{{_indexed(low)}}}' if low else ''}\\)")]

    def caption(self, kind: str, label: tuple[str, str, str], mark: str, said: Sequence[Node]) -> list[Node]:
        return [paragraph([raw("latex", "\\captionof{" + kind + "}{"), *said, raw("latex", f"\\label{{{mark}}}}}")])]

    def numbered(self, latex: str, name: str, mark: str) -> Node:
        label = f"\\label{{{mark}}}" if mark else ""
        return raw_block("latex", f"\\begin{{equation}}\\tag{{{_escaped(name)}}}{label}\n{latex}\n\\end{{equation}}")

    def reference(self, mark: str, said: str) -> Node:
        return raw("latex", f"\\hyperref[{mark}]{{{_escaped(said)}}}")

    def picture(self, path: str, alt: str, size: tuple[float, float]) -> Node:
        fitted = f"width={size[0]:.2f}mm,height={size[1]:.2f}mm"
        return raw("latex", f"\\includegraphics[{fitted},alt={{{_escaped(alt)}}}]{{{path}}}")

    def turned(self, blocks: list[Node]) -> list[Node]:
        return [raw_block("latex", "\\begin{landscape}"), *blocks, raw_block("latex", "\\end{landscape}")]


CAPTIONS = {"figure": "Image Caption", "table": "Table Caption"}
SEQUENCES = {"figure": "Figure", "table": "Table"}
Dialect = Word | OpenDocument | Tex
DIALECTS: dict[str, type[Dialect]] = {"docx": Word, "odt": OpenDocument, "tex": Tex}
_TEX = {
    "\\": "\\textbackslash{}", "{": "\\{", "}": "\\}", "$": "\\$", "&": "\\&", "#": "\\#", "_": "\\_", "%": "\\%",
    "~": "\\textasciitilde{}", "^": "\\textasciicircum{}",
}  # fmt: skip


def begun_field(instruction: str, more: str = "") -> str:
    """Return the beginning of a Word field, up to the text that it shows; `more` are its attributes."""
    said = f'<w:r><w:instrText xml:space="preserve"> {escape(instruction, quote=False)} </w:instrText></w:r>'
    return f'<w:r><w:fldChar w:fldCharType="begin"{more}/></w:r>{said}<w:r><w:fldChar w:fldCharType="separate"/></w:r>'


ENDED_FIELD = '<w:r><w:fldChar w:fldCharType="end"/></w:r>'


def word_field(instruction: str, shown: str) -> str:
    """Return a Word field, with the text that it shows until Word updates it."""
    return f"{begun_field(instruction)}<w:r><w:t>{escape(shown)}</w:t></w:r>{ENDED_FIELD}"


def tex_letter(letter: str) -> str:
    """Return a letter of a formula, with the dot above it if it has one."""
    plain = _escaped(letter.replace("\u0307", ""))
    return f"\\dot{{{plain}}}" if "\u0307" in letter else plain


def _indexed(low: str) -> str:
    return _escaped(low).replace("′", "'")


def _escaped(said: str) -> str:
    return "".join(_TEX.get(letter, letter) for letter in said if letter.isprintable() or letter == "\u00a0")
