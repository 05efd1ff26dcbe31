"""One submission -> its contents; what each file is depends on its content, never on its name alone.

Enters: `Submission`, `Expected`.  Leaves: `StudentWork`; nothing a student hands in makes it raise (except `MemoryError`).
Used by whoever marks a submission, and by `precheck`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from coursework.grading.reading.documents.document import FORMATTED, Document
from coursework.grading.reading.documents.page import with_formulas
from coursework.grading.reading.documents.read_document import (
    document_of_archive,
    document_of_bytes,
    document_of_sheets,
    document_of_text,
    is_document,
    lines_of_document,
    tables_of_document,
)
from coursework.grading.reading.equations.equations import TURNED, most_lines
from coursework.grading.reading.equations.lines import Lines, read_lines
from coursework.grading.reading.equations.variant_files import is_variant_file, read_variant_file
from coursework.grading.reading.expected import Expected, Grid
from coursework.grading.reading.files.archive import Archive, legible_name
from coursework.grading.reading.files.encoding import Decoded, decode
from coursework.grading.reading.files.html_text import text_of
from coursework.grading.reading.files.kinds import (
    OLD_EXCEL,
    OLD_WORD,
    PICTURES,
    is_html,
    is_ignored,
    is_named_as_table,
    is_record,
    kind_of_parts,
    real_kind,
)
from coursework.grading.reading.limits import FILE_BYTES, FILES, Refused, other_kind, unreadable
from coursework.grading.reading.student_work import AnswerLine, EquationLine, FileEntry, StudentWork, Table, Trouble
from coursework.grading.reading.submission import Note, Submission, SubmittedFile, note, submitted_file
from coursework.grading.reading.table.parts import Part, joined
from coursework.grading.reading.table.table import read_parts
from coursework.grading.reading.table.tables_of_file import alike, is_spreadsheet, read_spreadsheet, table_of_text
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_SHOWN = 40  # most characters of a cell that are quoted
_Kind = Literal["table", "equations", "answers", "variant", "attachment", "ignored"]


@dataclass(slots=True)
class _Found:
    """The contents of the submission found so far."""

    tables: list[tuple[Part, Table]] = field(default_factory=list)
    refused: list[Trouble] = field(default_factory=list)  # files refused where a table was expected
    attached: list[Trouble] = field(default_factory=list)  # other files that cannot be read
    equations: list[EquationLine] = field(default_factory=list)
    beside: list[EquationLine] = field(default_factory=list)  # equations beside a table; used if `equations` is empty
    answers: list[AnswerLine] = field(default_factory=list)
    notes: list[Note] = field(default_factory=list)
    entries: list[FileEntry] = field(default_factory=list)
    review: Sentence | None = None
    unread: int = 0  # number of lines that were not tried
    unopened: Sentence | None = None

    def take(self, lines: Lines, equations: list[EquationLine]) -> None:
        """Add the answers and equations of a text; `equations` is the list of this object that takes the equations."""
        equations += lines.equations
        self.answers += lines.answers
        self.unread += lines.unread


def read_submission(submission: Submission, expected: Expected) -> StudentWork:
    """Return the table, equations and answers of a submission."""
    found = _Found(notes=list(submission.notes), review=submission.review)
    files = [inner for file in submission.files for inner in _opened(file)]
    for file in files[FILES:]:
        found.notes.append(note("ignored_file", name=file.name, why=say("reading.why.too_many", limit=FILES)))
    for file in files[:FILES]:
        kinds = _read(file, len(files) == 1, expected, found)
        found.entries.append(FileEntry(file.name, kinds[0], kinds, file.size, file.sha256))
    table, trouble = _one_table(found, expected.grid)
    handed = found.equations or found.beside
    lines = handed[: most_lines(expected)]
    if unread := found.unread + len(handed) - len(lines):
        found.notes.append(note("ignored_file", "lines", number=unread))
    return StudentWork(
        tuple(found.entries),
        table,
        trouble,
        tuple(lines) if lines else None,
        tuple(found.answers),
        tuple(found.notes),
        found.review,
        found.unopened,
    )


def _opened(file: SubmittedFile) -> list[SubmittedFile]:
    """Return the file itself, or the files inside it if it is a plain zip (opened only one level deep, in memory)."""
    if not file.content.startswith(b"PK") or file.trouble:
        return [file]
    try:
        archive = Archive(file.content)
        if is_spreadsheet(archive) or is_document(archive) or kind_of_parts(list(archive.parts)):
            return [file]
        inside: list[SubmittedFile] = []
        for part in archive.parts.values():
            name = legible_name(part)
            if not is_ignored(name) and len(inside) <= FILES:
                inside.append(submitted_file(f"{file.name}/{name}", archive.read(part.filename, FILE_BYTES)))
        return sorted(inside, key=lambda entry: entry.name)
    except Refused as refused:
        return [replace(file, trouble=refused.trouble.text)]


def _read(file: SubmittedFile, is_alone: bool, expected: Expected, found: _Found) -> tuple[_Kind, ...]:
    """Read one file into `found` and return its kinds."""
    could_be_table = is_alone or is_named_as_table(file.name)
    try:
        if kind := real_kind(file.content):
            raise _other_kind(kind)
        if file.trouble:
            raise Refused(Trouble("unreadable", file.trouble.key.rpartition(".")[2], file.trouble))
        if document := document_of_bytes(file.content, expected.grid):
            return _read_document(document, file, could_be_table, expected, found)
        if file.content.startswith(b"PK"):
            return _read_archive(file, could_be_table, expected, found)
        if not file.content.strip():
            raise unreadable("empty")
        return _read_text(file, could_be_table, expected, found)
    except Refused as refused:
        is_question = refused.trouble.state == "needs-review"
        (found.refused if could_be_table or is_question else found.attached).append(refused.trouble)
        if refused.trouble.code == "no_pdf_reader":
            found.unopened = refused.trouble.text
        code = "empty_part" if refused.trouble.code == "empty" else "attachment"
        found.notes.append(note(code, name=file.name, why=refused.trouble.text))
        return ("attachment",)


def _other_kind(kind: str, key: str = "other_kind") -> Refused:
    """Return the refusal of a file of this kind, which tells the student how to save it instead."""
    if kind in {OLD_EXCEL, OLD_WORD}:
        return unreadable("old_excel" if kind == OLD_EXCEL else "old_word")
    return other_kind("picture" if kind in PICTURES else key, kind=kind)


def _read_archive(file: SubmittedFile, could_be_table: bool, expected: Expected, found: _Found) -> tuple[_Kind, ...]:
    archive = Archive(file.content)
    if document := document_of_archive(archive, expected.grid):
        return _read_document(document, file, could_be_table, expected, found)
    if kind := kind_of_parts(list(archive.parts)):
        raise _other_kind(kind)
    if not is_spreadsheet(archive):
        raise unreadable("nested_zip")
    read, sheets = read_spreadsheet(archive, file.name, expected.grid)
    lines = lines_of_document(document_of_sheets(sheets), file.name, expected)
    tables = [read] if read else []
    kinds = _kinds(tables, lines)
    if not kinds:
        raise unreadable("no_sheet_table", name=file.name)
    found.tables += tables
    found.take(lines, found.beside)
    return kinds


def _read_document(
    document: Document, file: SubmittedFile, could_be_table: bool, expected: Expected, found: _Found
) -> tuple[_Kind, ...]:
    """Read a document, which may hold a table, equations and answers, into `found` and return its kinds."""
    tables, refused = tables_of_document(document, file.name, expected.grid)
    lines = lines_of_document(document, file.name, expected)
    found.tables += tables
    found.take(lines, found.equations)
    kinds = _kinds(tables, lines)
    if refused and not tables:
        if not kinds:
            raise refused
        if refused.trouble.state == "needs-review":
            found.refused.append(refused.trouble)
    if document.kind == "pdf" and kinds:
        found.notes.append(note("from_pdf", name=file.name))
    if not kinds and document.kind in FORMATTED:  # a person has to look at it
        raise _other_kind(FORMATTED[document.kind], "empty_document")
    return kinds or _nothing_in(file, could_be_table, found)


def _kinds(tables: Sequence[object], lines: Lines) -> tuple[_Kind, ...]:
    held: dict[_Kind, object] = {"table": tables, "equations": lines.equations, "answers": lines.answers}
    return tuple(kind for kind, what in held.items() if what)


def _nothing_in(file: SubmittedFile, could_be_table: bool, found: _Found) -> tuple[_Kind, ...]:
    """Note that nothing was found in a file.  Raises `Refused` if the file could be a table."""
    if could_be_table:
        raise unreadable("no_table", name=file.name)
    found.notes.append(note("ignored_file", name=file.name, why=say("reading.why.nothing")))
    return ("ignored",)


def _read_text(file: SubmittedFile, could_be_table: bool, expected: Expected, found: _Found) -> tuple[_Kind, ...]:
    decoded = decode(file.content)
    if is_record(decoded.text):
        return ("ignored",)
    decoded = replace(decoded, text=with_formulas(decoded.text))
    if is_variant_file(decoded.text):
        _read_variant(file, expected, found)
        return ("variant",)
    if (document := document_of_text(decoded, expected.grid)) and (document.tables or document.texts or document.is_whole):
        return _read_document(document, file, could_be_table, expected, found)
    if is_html(decoded.text):
        decoded = Decoded(text_of(decoded.text), decoded.encoding, decoded.had_nuls)
    refused = None
    try:
        if read := table_of_text(decoded, file.name, expected.grid):
            found.tables.append(read)
            beside = read_lines(decoded.text, file.name, expected, read[1].reading)
            found.take(beside, found.beside)
            return _kinds([read], beside)
    except Refused as error:
        refused = error
    lines = lines_of_document(document, file.name, expected) if document else read_lines(decoded.text, file.name, expected)
    if refused and not lines.answers and not any(line.tree is not None or TURNED.search(line.text) for line in lines.equations):
        raise refused
    found.take(lines, found.equations)
    return _kinds([], lines) or _nothing_in(file, could_be_table, found)


def _read_variant(file: SubmittedFile, expected: Expected, found: _Found) -> None:
    read = read_variant_file(file.content, file.name, expected)
    found.equations += read.lines
    found.review = found.review or read.review
    if read.differing:
        found.notes.append(note("data_differ", name=file.name, data=read.differing))
    if read.unknown_keys:
        found.notes.append(note("ignored_file", "keys", name=file.name, keys=read.unknown_keys))


def _one_table(found: _Found, grid: Grid) -> tuple[Table | None, Trouble | None]:
    """Return the table with the greatest weight, or the trouble if there is none or if two different ones weigh the same."""
    if not found.tables:
        instead = found.refused or ([] if found.equations or found.answers else found.attached)
        if instead:
            return None, instead[0]
        return None, Trouble("missing", "missing", say(f"reading.trouble.{'missing' if found.entries else 'no_files'}"))
    tables = [table for _, table in found.tables]
    wholes = joined([part for part, _ in found.tables], grid)
    if len(wholes) < len(tables):  # some files hold parts of one table
        tables = [table for _, table in read_parts(wholes, grid) if isinstance(table, Table)] or tables
    tables = [table for table in tables if not table.unsure] or tables
    ranked = sorted(tables, key=lambda table: (table.weight, sum(column.decimals for column in table.columns)), reverse=True)
    best, *others = ranked
    equal = [other for other in others if other.weight == best.weight and not alike(other, best)]
    if equal:
        names = tuple(_named(table) for table in (best, *equal))
        return None, Trouble("needs-review", "two_tables", say("reading.trouble.two_tables", names=names))
    if others:
        found.notes.append(note("two_tables", name=_named(best), others=tuple(map(_named, others))))
    found.notes += best.notes
    found.review = found.review or best.unsure or _unread_cells(best)
    return best, None


def _unread_cells(table: Table) -> Sentence | None:
    """Return why a person must look at cells whose text has digits but is no number, None if there are none."""
    unread = [
        (row, column.name, text)
        for column in table.columns
        for row, (text, flag) in enumerate(zip(column.texts, column.flags, strict=True), start=1)
        if flag == "text" and any(map(str.isdigit, text)) and not text.lstrip().startswith("=")
    ]
    if not unread:
        return None
    row, name, text = min(unread)
    return say("reading.review.unread_cells", number=len(unread), row=row, column=name, text=text[:_SHOWN])


def _named(table: Table) -> str | Sentence:
    """Return the name of a table's file, with the place of the table in it if known."""
    return say("reading.place.in_file", place=table.place, file=table.reading.file) if table.place else table.reading.file
