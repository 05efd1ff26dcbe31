"""A PDF with text -> its tables and lines, read by pdfplumber (extra `pdf`), with limits on pages, letters, bytes and time.

Enters: bytes.  Leaves: `Document`.  Raises `Refused`; without the extra, the refusal names the command that installs it.
Used by `read_document.py`, and by the batch, as its results depend on whether the extra is installed.
"""

from __future__ import annotations

import ctypes
import importlib
import importlib.util
import io
import itertools
import logging
import threading
import zlib
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from typing import Any

from coursework.grading.reading.documents.document import Document, place_of
from coursework.grading.reading.documents.pdf.pdf_lines import MOST_BARS, Bar, Letter, lines_of, with_fractions
from coursework.grading.reading.documents.pdf.pdf_tables import tables_in
from coursework.grading.reading.files.cells import Cell
from coursework.grading.reading.limits import CELL_CHARACTERS, INFLATED_BYTES, Refused, Room, doubtful, other_kind, unreadable

EXTRA = "pdfplumber"
PAGES, SECONDS, LETTERS = 30, 5.0, 150_000
_THIN, _LONGEST = 1.5, 400.0  # points: the greatest height and length of a fraction bar
_FEWEST = 20  # a PDF with fewer letters is a scan or photographs


def is_pdf(content: bytes) -> bool:
    """Return whether a file is a PDF; other bytes may precede its signature."""
    return b"%PDF-" in content[:1024] and not content.startswith(b"PK")


@cache
def is_readable() -> bool:
    """Return whether the library that reads PDFs is installed."""
    return importlib.util.find_spec(EXTRA) is not None


def document_of_pdf(content: bytes, room: Room) -> Document:
    """Return the tables and lines of a PDF.  Raises `Refused`."""
    if not is_readable():
        raise doubtful("no_pdf_reader", command="coursework --versions")
    try:
        with _bounded():
            return _read(content, room)
    except _Stopped as stopped:
        raise stopped.refused from None
    except (Refused, MemoryError):
        raise
    except Exception as error:  # the library may raise anything for damaged or hostile files
        raise unreadable("pdf_password") if "Password" in repr(error) else other_kind("pdf_damaged") from error


def _read(content: bytes, room: Room) -> Document:
    import pdfplumber

    document = Document("pdf")
    letters = 0
    with pdfplumber.open(io.BytesIO(content)) as pdf:
        if len(pdf.pages) > PAGES:
            raise unreadable("pdf_long", pages=len(pdf.pages), limit=PAGES)
        for number, page in enumerate(pdf.pages, start=1):
            found = list(itertools.islice(_letters(page), LETTERS + 1))
            letters += sum(not letter.text.isspace() for letter in found)
            if letters > LETTERS:
                raise unreadable("too_large_open")
            lines = lines_of(with_fractions(found, _bars(page)))
            for start, rows in tables_in(lines):
                cells = ([Cell(text[:CELL_CHARACTERS]) for text in row[: room.columns]] for row in rows[: room.rows])
                document.add_table(cells, place_of("page_line", page=number, line=start + 1))
            for place, line in enumerate(lines, start=1):
                document.add_line(line.text, place_of("page_line", page=number, line=place))
            page.close()
    if letters < _FEWEST:
        raise other_kind("pdf_scan")
    return document


def _bars(page: Any) -> list[Bar]:
    """Return the thin bars of a page that may be fraction bars."""
    drawn = itertools.islice(itertools.chain(page.lines, page.rects, page.curves), MOST_BARS + 1)
    return [
        Bar(float(bar["x0"]), float(bar["x1"]), (float(bar["y0"]) + float(bar["y1"])) / 2)
        for bar in drawn
        if abs(bar["y1"] - bar["y0"]) < _THIN and _THIN < bar["x1"] - bar["x0"] < _LONGEST
    ]


def _letters(page: Any) -> Iterator[Letter]:
    """Yield the upright letters of a page."""
    for char in page.chars:
        if char["upright"] and char["text"]:
            yield Letter(
                char["text"][:4], float(char["x0"]), float(char["x1"]), float(char["matrix"][5]), float(char["size"]) or 1.0
            )


class _Stopped(BaseException):
    """Raised at a limit inside the library; a `BaseException`, as the library catches ordinary ones."""

    def __init__(self, code: str = "pdf_slow") -> None:
        super().__init__(code)
        self.refused = unreadable(code, seconds=SECONDS)


class _CountedZlib:
    """A replacement for `zlib` in the library that counts all inflated bytes."""

    error = zlib.error

    def __init__(self) -> None:
        self.left = INFLATED_BYTES

    def decompress(self, data: bytes) -> bytes:
        return self.decompressobj().decompress(data)

    def decompressobj(self) -> _CountedZlib._Inflater:
        return self._Inflater(self)

    class _Inflater:
        def __init__(self, counted: _CountedZlib) -> None:
            self.counted, self.inflater = counted, zlib.decompressobj()

        def decompress(self, data: bytes) -> bytes:
            out = self.inflater.decompress(data, self.counted.left + 1)
            self.counted.left -= len(out)
            if self.counted.left < 0:
                raise _Stopped("too_large_open")
            return out


@contextmanager
def _bounded() -> Iterator[None]:
    """Limit the bytes that the library inflates and the time it takes; it has no such limits itself."""
    pdftypes: Any = importlib.import_module("pdfminer.pdftypes")
    logging.getLogger("pdfminer").setLevel(logging.CRITICAL)
    thread = ctypes.c_ulong(threading.get_ident())
    raise_in = ctypes.pythonapi.PyThreadState_SetAsyncExc
    timer = threading.Timer(SECONDS, raise_in, (thread, ctypes.py_object(_Stopped)))
    timer.daemon = True
    usual, pdftypes.zlib = pdftypes.zlib, _CountedZlib()
    timer.start()
    try:
        yield
    finally:
        pdftypes.zlib = usual
        # An exception sent at the last moment arrives here.  Nothing is cancelled by sending none: a debugger would then go round
        # and round in Python 3.11.
        with suppress(_Stopped):
            timer.cancel()
            timer.join()
