"""The first bytes of a file -> its real kind, whatever its name says; also which file names are ignored.

Enters: bytes and names.  Leaves: the name of a kind that is not read, "" for the other kinds.
Used by `read_submission.py`, `opened.py` and whoever collects files.
"""

from __future__ import annotations

import re
from pathlib import PurePosixPath

TABLE_ENDINGS = {
    ".csv", ".tsv", ".txt", ".prn", ".dat", ".xls", ".xlsx", ".xlsm", ".xlsb", ".ods", ".numbers", ".xmcd", ".mcdx", ".zip",
}  # fmt: skip
_IGNORED = {"__macosx", "desktop.ini", "thumbs.db"}
_MAGIC = (
    (b"\xff\xd8\xff", "JPEG"), (b"\x89PNG", "PNG"), (b"GIF8", "GIF"), (b"Rar!", "RAR"),
    (b"7z\xbc\xaf", "7z"), (b"II*\x00", "TIFF"), (b"MM\x00*", "TIFF"), (b"BM", "BMP"), (b"\x1f\x8b", "gzip"),
    (b"SQLite format", "SQLite"), (b"AT&TFORM", "DjVu"), (b"MATLAB 5.0 MAT-file", "MATLAB MAT"),
)  # fmt: skip
_OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_PARTS = (
    ("ppt/", "PowerPoint"), ("xl/workbook.bin", "xlsb"), ("Index/", "Apple Numbers"),
    ("Index.zip", "Apple Numbers"), ("mathcad/", "Mathcad Prime"), ("matlab/", "MATLAB Live Script"),
    ("FixedDocSeq", "XPS"), ("FixedDocumentSequence", "XPS"),
)  # fmt: skip
_HTML = re.compile(
    r"\s*(?:<\?xml\b[^<>]{0,200}>\s*)?"
    r"<(?:!--|(?:!doctype html|html|head|body|meta|style|title|center|b|p|div|table|span|br|ul|ol|h[1-6])\b)",
    re.IGNORECASE,
)
# How `run.json` and `accuracy.json` begin, which `coursework run` and `accuracy` write last, and how they end.
_RECORD = re.compile(r'\s*\{\s*"variant": ".{0,9999}?"versions": \{"coursework": "', re.DOTALL)
_ITS_END = re.compile(r'"stamp": "[0-9a-f]+",\s*"files": \{')
# A file that only leads to the work: of Windows (.url, .lnk), macOS (.webloc), Google's drive (.gdoc), or an address alone.
_SHORTCUT = b"L\0\0\0\x01\x14\x02\0"
_LINK = re.compile(
    r"\s*(?:\[InternetShortcut\]|<\?xml.{0,400}?<key>URL</key>|https?://\S+\s*\Z"
    r"|\{[^{}]{0,99}\"(?:url|doc_id)\": ?\"[^{}\[\]]*\}\s*\Z)",  # no work may stand in it
    re.DOTALL | re.IGNORECASE,
)
_PICTURED = re.compile(
    r"^(?:word|xl)/(?:media|embeddings|drawings)/\w|^Pictures/|<img\b|!\[[^\]\n]{0,200}\]\(|\\includegraphics\b"
    r'|"image/(?:png|jpeg|svg\+xml)"',
    re.MULTILINE | re.IGNORECASE,
)
_ROOT_WITHIN = 8192  # bytes, in which the root of an XML file ends
_FLAT = re.compile(rb"<office:document\s[^<>]*office:mimetype=\"(application/vnd\.oasis\.opendocument\.(?:text|spreadsheet))")
OLD_EXCEL, OLD_WORD = "xls", "doc"
ARCHIVES = {"RAR", "7z", "gzip"}
PICTURES = {"JPEG", "PNG", "GIF", "TIFF", "BMP", "HEIC", "WebP", "DjVu"}
_WORD_STREAM = "WordDocument".encode("utf-16-le")  # the name of a stream inside an OLE file


def real_kind(content: bytes) -> str:
    """Return the kind of a file that is not read (a picture, an OLE file, Mathcad …), "" for any other file."""
    if content.startswith(_OLE):
        return OLD_WORD if _WORD_STREAM in content else OLD_EXCEL
    head = content[:4096]
    if head.lstrip(b"\xef\xbb\xbf \r\n\t").startswith(b"<?xml") and b"mathsoft" in head:
        return "Mathcad"
    if head[4:12] in {b"ftypheic", b"ftypheix", b"ftypmif1", b"ftypheif"}:
        return "HEIC"
    if head.startswith(b"RIFF") and head[8:12] == b"WEBP":
        return "WebP"
    return next((kind for magic, kind in _MAGIC if content.startswith(magic) and (magic != b"BM" or b"\0" in head)), "")


def flat_open_document(content: bytes) -> bytes:
    """Return the kind (a media type) of an OpenDocument file that is one file of XML, b"" for any other file."""
    head = content[:_ROOT_WITHIN] if content.lstrip(b"\xef\xbb\xbf \r\n\t").startswith(b"<?xml") else b""
    found = _FLAT.search(head)
    return found[1] if found else b""


def has_pictures(text: str) -> bool:
    r"""Return whether a text shows pictures, or the names of an archive's parts have pictures, drawings or embedded objects.

    >>> has_pictures("word/document.xml\nword/media/image1.png"), has_pictures("so ![](eq.png)"), has_pictures("word/media")
    (True, True, False)
    """
    return _PICTURED.search(text) is not None


def kind_of_parts(names: list[str]) -> str:
    """Return the kind of a zip file that is not read, by the names of its parts; "" for any other zip file."""
    return next((kind for start, kind in _PARTS if any(name.startswith(start) for name in names)), "")


def is_ignored(path: str) -> bool:
    """Return whether a part of a path is a hidden or temporary name, or one that an operating system creates."""
    parts = (part for part in PurePosixPath(path).parts if part != "..")  # harmless, as nothing is written to a path from a zip
    return any(part.startswith((".", "~")) or part.casefold() in _IGNORED for part in parts)


def is_named_as_table(name: str) -> bool:
    """Return whether the ending of a file's name is one of a table."""
    return PurePosixPath(name.replace("\\", "/")).suffix.lower() in TABLE_ENDINGS


def is_link(content: bytes) -> bool:
    """Return whether a file is no work but the address of one.

    >>> [is_link(text) for text in (b"https://disk.example/a b", b"https://disk.example/a", b"[InternetShortcut]")]
    [False, True, True]
    >>> [is_link(text) for text in (b'{"url": "disk.example", "t": [0, 0.1, 0.2]}', b'{"url": "disk.example", "doc_id": "a"}')]
    [False, True]
    """
    head = content[:2000]
    return content.startswith(_SHORTCUT) or bool(_LINK.match(head.decode("utf-8-sig", "replace")))


def is_html(text: str) -> bool:
    """Return whether a text is HTML, as Moodle stores text typed online."""
    return bool(_HTML.match(text[:500].lstrip("\ufeff")))


def is_record(text: str) -> bool:
    """Return whether a text is the record of a run that this tool wrote beside a table: it is no work of a student."""
    return bool(_RECORD.match(text.removeprefix("\ufeff")) and _ITS_END.search(text))
