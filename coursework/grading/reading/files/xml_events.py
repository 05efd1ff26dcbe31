"""Parts of a spreadsheet or document as a stream of elements, stopped as soon as enough is known.

Enters: chunks of XML.  Leaves: calls of a handler.  Raises `Refused` for a DOCTYPE (entities) and for what is no XML.
Used by `xlsx.py`, `ods.py` and the readers of documents.
"""

from __future__ import annotations

from collections.abc import Container, Iterable
from typing import Protocol
from xml.parsers import expat

from coursework.grading.reading.limits import Refused, unreadable

_MOST_NESTED = 200


class Handler(Protocol):
    """What a reader of elements offers; names come without their prefix."""

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        """Meet the beginning of an element; attribute names come without their prefix too."""

    def end(self, name: str) -> None:
        """Meet its end."""

    def text(self, text: str) -> None:
        """Meet text, perhaps in several pieces."""


class Enough(Exception):
    """A handler has what it wants."""


def stream(chunks: Iterable[bytes], handler: Handler, wanted: Container[str] | None = None) -> None:
    """Send the elements of a document to a handler until it has enough; `wanted` are the names it looks at, all where None."""
    parser = expat.ParserCreate()
    depth = 0
    bare: dict[str, str] = {}  # a document of a word processor has fifty names and ten thousand elements

    def bare_name(name: str) -> str:
        short = name.rpartition(":")[2]
        bare[name] = short if wanted is None or short in wanted else ""
        return bare[name]

    def begin(name: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > _MOST_NESTED:
            raise unreadable("damaged")
        short = bare.get(name)
        if short is None:
            short = bare_name(name)
        if not short:
            return
        if attributes and ":" in "".join(attributes):
            attributes = {key.rpartition(":")[2]: value for key, value in attributes.items()}
        handler.begin(short, attributes)

    def end(name: str) -> None:
        nonlocal depth
        depth -= 1
        if short := bare[name]:
            handler.end(short)

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
