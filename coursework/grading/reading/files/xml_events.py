"""Parts of a spreadsheet or document as a stream of elements, stopped as soon as enough is known.

Enters: chunks of XML.  Leaves: calls of a handler.  Raises `Refused` for a DOCTYPE (entities) and for what is no XML.
Used by `xlsx.py`, `ods.py` and the readers of documents.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Protocol
from xml.parsers import expat

from coursework.grading.reading.limits import Refused, unreadable

_MOST_NESTED = 200
_NONE: dict[str, str] = {}


class Handler(Protocol):
    """What a reader of elements offers; names come without their prefix."""

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        """Meet the beginning of an element; attribute names come without their prefix too."""

    def end(self, name: str) -> None:
        """Meet its end."""

    def text(self, text: str) -> None:
        """Meet text, perhaps in several pieces."""


def whole(text: str | None, otherwise: int) -> int:
    """Return the whole number that an attribute is, another where it is none."""
    return int(text) if text and len(text) <= 8 and text.isascii() and text.isdigit() else otherwise


class Enough(Exception):
    """A handler has what it wants."""


class _BareNames(dict[str, str]):
    """Names without their prefix, "" for those nobody wants."""

    def __init__(self, wanted: Mapping[str, bool] | None) -> None:
        super().__init__()
        self.wanted = wanted

    def __missing__(self, name: str) -> str:
        short = name.rpartition(":")[2]
        self[name] = short if self.wanted is None or short in self.wanted else ""
        return self[name]


def stream(chunks: Iterable[bytes], handler: Handler, wanted: Mapping[str, bool] | None = None) -> None:
    """Send the elements of a document to a handler until it has enough.

    `wanted` are the names it looks at, and whether their attributes too; all where None.
    """
    parser = expat.ParserCreate()
    depth = 0
    meet, leave = handler.begin, handler.end
    bare = _BareNames(wanted)  # a document of a word processor has fifty names and ten thousand elements

    def begin(name: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > _MOST_NESTED:
            raise unreadable("damaged")
        short = bare[name]
        if not short:
            return
        if wanted is not None and not wanted[short]:
            attributes = _NONE
        elif attributes and ":" in "".join(attributes):
            attributes = {key.rpartition(":")[2]: value for key, value in attributes.items()}
        meet(short, attributes)

    def end(name: str) -> None:
        nonlocal depth
        depth -= 1
        if short := bare[name]:
            leave(short)

    def doctype(*_: object) -> None:
        raise unreadable("doctype")

    parser.StartElementHandler = begin
    parser.EndElementHandler = end
    parser.CharacterDataHandler = handler.text
    parser.StartDoctypeDeclHandler = doctype
    parser.EntityDeclHandler = doctype
    parser.buffer_text = True
    waiting, fed, unread = bytearray(), 0, 0
    try:
        for chunk in chunks:
            waiting += chunk
            if len(waiting) < unread:
                continue
            # What has no end yet, a comment or a tag, is read again from its beginning: not before there is twice as much of it.
            parser.Parse(waiting, False)
            fed += len(waiting)
            unread = fed - parser.CurrentByteIndex
            waiting.clear()
        parser.Parse(waiting, True)
    except Enough:
        return
    except expat.ExpatError as error:
        raise unreadable("damaged") from error
    except (Refused, MemoryError):
        raise
    except (ValueError, LookupError) as error:  # an encoding that nobody knows
        raise unreadable("damaged") from error
