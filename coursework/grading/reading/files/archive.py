"""A zip file in memory, read with limits on every size while it is inflated.

Enters: the bytes of an archive.  Leaves: names of parts, parts in chunks.  Raises `Refused`; nothing is extracted to disk.
Used by the readers of spreadsheets, documents and handed-in archives.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator

from coursework.grading.reading.limits import DOCUMENT_PARTS, INFLATED_BYTES, PARTS, unreadable
from coursework.system.files.zipped import DAMAGED

_CHUNK = 64 * 1024
_END = b"PK\x05\x06"
_DIRECTORY_BYTES = 256 * 1024  # most bytes of the directory (the list of parts), which is read before any part
_DOCUMENTS = {"word/document.xml", "content.xml"}
_PACKED = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}


class Archive:
    """A zip file; all bytes that are inflated from it count towards one limit."""

    def __init__(self, content: bytes, left: int = INFLATED_BYTES) -> None:
        """Open an archive, of which `left` bytes may be inflated.

        Raises `Refused` if it is damaged, or has too many parts or too large a directory.
        """
        self.left = left
        end = content.rfind(_END)
        if end < 0 or int.from_bytes(content[end + 12 : end + 16], "little") > _DIRECTORY_BYTES:
            raise unreadable("damaged" if end < 0 else "too_large_open")
        try:
            self._zip = zipfile.ZipFile(io.BytesIO(content))
        except DAMAGED as error:
            raise unreadable("damaged") from error
        # A damaged directory may list a part without a name, on which `is_dir` fails.
        self.parts = {part.filename: part for part in self._zip.infolist() if part.filename and not part.is_dir()}
        # Each formula of an OpenDocument text takes three parts; parts are inflated only when read, and these bytes are counted.
        if len(self._zip.infolist()) > (DOCUMENT_PARTS if _DOCUMENTS & self.parts.keys() else PARTS):
            raise unreadable("too_large_open")

    def chunks(self, name: str) -> Iterator[bytes]:
        """Yield a part in chunks.  Raises `Refused` if it is encrypted or damaged, or if too many bytes were inflated in all."""
        part = self.parts[name]
        if part.flag_bits & 0x1:
            raise unreadable("password")
        if part.compress_type not in _PACKED:
            raise unreadable("damaged")
        try:
            with self._zip.open(part) as file:
                while chunk := file.read(_CHUNK):
                    self.left -= len(chunk)
                    if self.left < 0:
                        raise unreadable("too_large_open")
                    yield chunk
        except DAMAGED as error:
            raise unreadable("damaged") from error

    def read(self, name: str, most: int) -> bytes:
        """Return a whole part.  Raises `Refused` if it has more than `most` bytes."""
        content = bytearray()
        for chunk in self.chunks(name):
            content += chunk
            if len(content) > most:
                raise unreadable("too_large_open")
        return bytes(content)


def legible_name(part: zipfile.ZipInfo) -> str:
    """Return the name of a part; repair a name that an old Russian program wrote without declaring its encoding."""
    name = part.filename
    if part.flag_bits & 0x800 or name.isascii():
        return name
    for encoding in ("utf-8", "cp866"):
        try:
            guess = name.encode("cp437").decode(encoding)
        except UnicodeError:
            continue
        # cp866 has the same box-drawing signs as cp437, so a name is taken as cp866 only if it has Cyrillic letters.
        if any("Ѐ" <= letter <= "ӿ" for letter in guess) or encoding == "utf-8":
            return guess
    return name
