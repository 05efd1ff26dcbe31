"""Parts of a spreadsheet or document as a stream of XML elements, stopped as soon as enough is known.

Enters: chunks of XML.  Leaves: calls of a handler.  Raises `Refused` for a DOCTYPE (entities) and for invalid XML.
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
    """The methods of a reader of elements; names are passed without their prefix."""

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        """Handle the start of an element; the names of its attributes have no prefix either."""

    def end(self, name: str) -> None:
        """Handle the end of an element."""

    def text(self, text: str) -> None:
        """Handle text, perhaps in several pieces."""


def whole(text: str | None, otherwise: int) -> int:
    """Return the value of an attribute as a non-negative integer, `otherwise` if it is none."""
    return int(text) if text and len(text) <= 8 and text.isascii() and text.isdigit() else otherwise


class Enough(Exception):
    """Raised by a handler that needs no more of the document."""


class _BareNames(dict[str, str]):
    """Maps element names to their form without prefix, or to "" if not `wanted`."""

    def __init__(self, wanted: Mapping[str, bool] | None) -> None:
        super().__init__()
        self.wanted = wanted

    def __missing__(self, name: str) -> str:
        short = name.rpartition(":")[2]
        self[name] = short if self.wanted is None or short in self.wanted else ""
        return self[name]


def stream(chunks: Iterable[bytes], handler: Handler, wanted: Mapping[str, bool] | None = None) -> None:
    """Send the elements of a document to a handler until it raises `Enough`.

    `wanted` maps the names of the elements to send to whether their attributes are needed; None sends everything.
    """
    parser = expat.ParserCreate()
    depth = 0
    meet, leave = handler.begin, handler.end
    bare = _BareNames(wanted)  # cached: a document has about fifty names but ten thousand elements

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
            # `expat` parses an unfinished comment or tag again from its start, so wait until the unread text has doubled.
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
    except (ValueError, LookupError) as error:  # an unknown encoding
        raise unreadable("damaged") from error
