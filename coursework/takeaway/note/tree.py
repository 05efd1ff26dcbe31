"""Pandoc's document tree, as far as a note needs it: plain data that fits into JSON.

Enters: text and parts of the tree.  Leaves: parts of the tree.  Used by `blocks.py`, `dialects.py` and `writer.py`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

Node = dict[str, Any]
VERSION = [1, 23, 1]


def attributes(name: str = "", **values: str) -> list[Any]:
    """Return attributes of a node: an id and further ones ("custom_style" becomes custom-style)."""
    return [name, [], [[key.replace("_", "-"), value] for key, value in values.items()]]


def printed(said: str) -> str:
    """Return a text in one line without unprintable characters, which no document may hold."""
    return "".join(letter for letter in said.replace("\n", " ") if letter.isprintable() or letter in "\u00a0\u2009\u202f\u3000")


def text(said: str) -> list[Node]:
    """Return the words of a text and the spaces between them."""
    found: list[Node] = []
    for place, word in enumerate(printed(said).split(" ")):
        if place:
            found.append({"t": "Space"})
        if word:
            found.append({"t": "Str", "c": word})
    return found


def emphasized(said: str) -> Node:
    """Return italic text."""
    return {"t": "Emph", "c": text(said)}


def strong(inlines: Sequence[Node]) -> Node:
    """Return bold text."""
    return {"t": "Strong", "c": list(inlines)}


def lowered(said: str) -> Node:
    """Return an italic subscript."""
    return {"t": "Subscript", "c": [emphasized(said)]}


def raised(said: str) -> Node:
    """Return a superscript."""
    return {"t": "Superscript", "c": text(said)}


def math(latex: str, *, displayed: bool = False) -> Node:
    """Return a formula."""
    return {"t": "Math", "c": [{"t": "DisplayMath" if displayed else "InlineMath"}, latex]}


def image(path: str, alt: str, width: float, height: float) -> Node:
    """Return a picture with a size in mm."""
    return {"t": "Image", "c": [attributes(width=f"{width:.4f}mm", height=f"{height:.4f}mm"), text(alt), [path, ""]]}


def raw(dialect: str, source: str) -> Node:
    """Return inline source of one format, which is kept as it is."""
    return {"t": "RawInline", "c": [dialect, source]}


def raw_block(dialect: str, source: str) -> Node:
    """Return a block of source of one format, which is kept as it is."""
    return {"t": "RawBlock", "c": [dialect, source]}


def paragraph(inlines: Iterable[Node]) -> Node:
    """Return a paragraph."""
    return {"t": "Para", "c": list(inlines)}


def code(lines: str) -> Node:
    """Return a block of code."""
    return {"t": "CodeBlock", "c": [attributes(), lines]}


def styled(style: str, blocks: Iterable[Node]) -> Node:
    """Return paragraphs with a style."""
    return {"t": "Div", "c": [attributes(custom_style=style), list(blocks)]}


def heading(level: int, name: str, inlines: Iterable[Node]) -> Node:
    """Return a heading with an id."""
    return {"t": "Header", "c": [level, attributes(name), list(inlines)]}


def bullets(items: Iterable[Iterable[Node]]) -> Node:
    """Return a bullet list."""
    return {"t": "BulletList", "c": [[{"t": "Plain", "c": list(item)}] for item in items]}


def table(
    heads: Sequence[Sequence[Node]], rows: Sequence[Sequence[Sequence[Node]]], words: Sequence[bool], widths: Sequence[float] = ()
) -> Node:
    """Return a table; `words` tells which columns are left-aligned; the others are numbers, right-aligned.

    `widths` of the columns are parts of the text width; without them each program chooses its own.
    """

    def row(cells: Sequence[Sequence[Node]]) -> list[Any]:
        made = [[attributes(), {"t": "AlignDefault"}, 1, 1, [{"t": "Plain", "c": list(cell)}] if cell else []] for cell in cells]
        return [attributes(), made]

    wide = [{"t": "ColWidth", "c": width} for width in widths] or [{"t": "ColWidthDefault"}] * len(words)
    columns = [[{"t": "AlignLeft" if left else "AlignRight"}, width] for left, width in zip(words, wide, strict=True)]
    head = [attributes(), [row(heads)] if any(heads) else []]
    body = [attributes(), 0, [], [row(one) for one in rows]]
    return {"t": "Table", "c": [attributes(), [None, []], columns, head, [body], [attributes(), []]]}


def document(blocks: list[Node], **meta: Any) -> Node:
    """Return a document."""
    return {"pandoc-api-version": VERSION, "meta": meta, "blocks": blocks}
