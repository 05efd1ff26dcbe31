"""One submission -> its contents; what each file is depends on its content, never on its name alone.

Enters: `Submission`, `Expected`.  Leaves: `StudentWork`; nothing a student hands in makes it raise (except `MemoryError`).
Used by whoever marks a submission, and by `precheck`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from coursework.grading.reading.documents.document import FORMATTED, Document
from coursework.grading.reading.documents.page import has_tables, with_formulas
from coursework.grading.reading.documents.read_document import (
    document_of_archive,
    document_of_bytes,
    document_of_sheets,
    document_of_text,
    lines_of_document,
    tables_of_document,
)
from coursework.grading.reading.equations.formulas.equations import TURNED, most_lines
from coursework.grading.reading.equations.lines import Lines, read_lines
from coursework.grading.reading.equations.variant_files import is_variant_file, read_variant_file
from coursework.grading.reading.expected import Expected
from coursework.grading.reading.files.archive import Archive
from coursework.grading.reading.files.encoding import decode
from coursework.grading.reading.files.html_text import text_of
from coursework.grading.reading.files.kinds import (
    flat_open_document,
    has_pictures,
    is_html,
    is_link,
    is_named_as_table,
    is_record,
    kind_of_parts,
    real_kind,
)
from coursework.grading.reading.files.ods import CONTENT
from coursework.grading.reading.limits import FILE_BYTES, FILES, INFLATED_BYTES, Refused, unreadable
from coursework.grading.reading.opened import opened, refused_kind
from coursework.grading.reading.student_work import AnswerLine, EquationLine, FileEntry, StudentWork, Table, Trouble
from coursework.grading.reading.submission import Note, Submission, SubmittedFile, note
from coursework.grading.reading.table.parts import Part, joined
from coursework.grading.reading.table.table import read_parts
from coursework.grading.reading.table.tables_of_file import alike, is_spreadsheet, read_spreadsheet, table_of_text
from coursework.system.files.zipped import zipped
from coursework.words.sentence import Sentence
from coursework.words.sentences import say

_SHOWN = 40  # most characters of a cell that are quoted
_BLANK = " \t\n\ufeff\u200b"
_Kind = Literal["table", "equations", "answers", "variant", "attachment", "ignored"]


@dataclass(slots=True)
class _Found:
    """The contents of the submission found so far."""

    expected: Expected
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
    left: int = INFLATED_BYTES  # what may still be inflated from archives, of all files together
    unopened: Sentence | None = None
    pictured: Sentence | None = None  # what is missing may be in pictures

    def look(self, text: str, name: str) -> None:
        """Remember that a file has pictures: `text` is what it holds, or the names of its parts."""
        if has_pictures(text):
            self.pictured = say("reading.trouble.pictures", name=name)

    def without_work(self, refused: Refused) -> Refused:
        """Return the refusal of a file in which nothing was found: if there are pictures, they may hold the work."""
        return Refused(Trouble("unreadable", "other_kind", self.pictured)) if self.pictured else refused

    def take(self, tables: Sequence[tuple[Part, Table]], lines: Lines, equations: list[EquationLine]) -> tuple[_Kind, ...]:
        """Add what a file holds and return its kinds; `equations` is the list of this object that takes its equations."""
        self.tables += tables
        equations += lines.equations
        self.answers += lines.answers
        self.unread += lines.unread
        held: dict[_Kind, object] = {"table": tables, "equations": lines.equations, "answers": lines.answers}
        return tuple(kind for kind, what in held.items() if what)

    def read(self, file: SubmittedFile, is_alone: bool) -> tuple[_Kind, ...]:
        """Read one file and return its kinds."""
        could_be_table = is_alone or is_named_as_table(file.name)
        try:
            if kinds := self._read(file):
                return kinds
            if could_be_table:
                raise self.without_work(unreadable("no_table", name=file.name))
            self.notes.append(note("ignored_file", name=file.name, why=say("reading.why.nothing")))
            return ("ignored",)
        except Refused as refused:
            is_question = refused.trouble.state == "needs-review"
            (self.refused if could_be_table or is_question else self.attached).append(refused.trouble)
            if refused.trouble.code == "no_pdf_reader":
                self.unopened = refused.trouble.text
            why = refused.trouble.text
            is_empty = refused.trouble.code == "empty"
            self.notes.append(Note("empty_part", why) if is_empty else note("attachment", name=file.name, why=why))
            return ("attachment",)

    def _read(self, file: SubmittedFile) -> tuple[_Kind, ...]:
        """Read one file and return its kinds, () if nothing was found in it.  Raises `Refused`."""
        if kind := real_kind(file.content):
            raise refused_kind(kind)
        if is_link(file.content):
            raise unreadable("link", name=file.name)
        if file.trouble:
            raise Refused(Trouble("unreadable", file.trouble.key.rpartition(".")[2], file.trouble))
        if document := document_of_bytes(file.content, self.expected.grid):
            return self._read_document(document, file.name)
        if flat := flat_open_document(file.content):
            parts = [("mimetype", flat), (CONTENT, file.content)]
            return self._read_archive(replace(file, content=zipped(parts)))
        if file.content.startswith(b"PK"):
            return self._read_archive(file)
        if not file.content.strip():
            raise unreadable("empty", name=file.name)
        return self._read_text(file)

    def _read_archive(self, file: SubmittedFile) -> tuple[_Kind, ...]:
        archive = Archive(file.content, self.left)
        self.look("\n".join(archive.parts), file.name)
        try:
            return self._read_parts(archive, file.name)
        finally:
            self.left = max(archive.left, FILE_BYTES)  # a file of the usual size is read behind one that is too large

    def _read_parts(self, archive: Archive, name: str) -> tuple[_Kind, ...]:
        grid = self.expected.grid
        if document := document_of_archive(archive, grid):
            return self._read_document(document, name)
        if kind := kind_of_parts(list(archive.parts)):
            raise refused_kind(kind)
        if not is_spreadsheet(archive):
            raise unreadable("nested_zip")
        read, sheets = read_spreadsheet(archive, name, grid)
        lines = lines_of_document(document_of_sheets(sheets), name, self.expected)
        if not (read or lines.equations or lines.answers):
            raise self.without_work(unreadable("no_sheet_table", name=name))
        return self.take([read] if read else [], lines, self.beside)

    def _read_document(self, document: Document, name: str) -> tuple[_Kind, ...]:
        """Read a document, which may hold a table, equations and answers, and return its kinds."""
        tables, refused = tables_of_document(document, name, self.expected.grid)
        kinds = self.take(tables, lines_of_document(document, name, self.expected), self.equations)
        if refused and not tables:
            if not kinds:
                raise refused
            if refused.trouble.state == "needs-review":
                self.refused.append(refused.trouble)
        if document.kind == "pdf" and kinds:
            self.notes.append(note("from_pdf", name=name))
        if not kinds and document.kind in FORMATTED:  # a person has to look at it
            raise self.without_work(refused_kind(FORMATTED[document.kind], "empty_document"))
        return kinds

    def _read_text(self, file: SubmittedFile) -> tuple[_Kind, ...]:
        decoded, name, expected = decode(file.content), file.name, self.expected
        if is_record(decoded.text):
            return ("ignored",)
        self.look(decoded.text, name)
        decoded = replace(decoded, text=with_formulas(decoded.text))
        if is_variant_file(decoded.text):
            self._read_variant(file)
            return ("variant",)
        if is_html(decoded.text):
            if not (said := text_of(decoded.text)).strip(_BLANK) and not self.pictured:
                raise unreadable("empty", name=name)  # as a platform's editor leaves it
            decoded = decoded if has_tables(decoded.text) else replace(decoded, text=said)
        document = document_of_text(decoded, expected.grid)
        if document and (document.tables or document.texts or document.is_whole):
            return self._read_document(document, name)
        if is_html(decoded.text):
            decoded = replace(decoded, text=text_of(decoded.text))
        refused = None
        try:
            if read := table_of_text(decoded, name, expected.grid):
                return self.take([read], read_lines(decoded.text, name, expected, read[1].reading), self.beside)
        except Refused as error:
            refused = error
        lines = lines_of_document(document, name, expected) if document else read_lines(decoded.text, name, expected)
        is_work = any(line.tree is not None or TURNED.search(line.text) for line in lines.equations)
        if refused and not lines.answers and not is_work:
            raise refused
        return self.take([], lines, self.equations)

    def _read_variant(self, file: SubmittedFile) -> None:
        read = read_variant_file(file.content, file.name, self.expected)
        self.equations += read.lines
        self.review = self.review or read.review
        if read.differing:
            self.notes.append(note("data_differ", name=file.name, data=read.differing))
        if read.unknown_keys:
            self.notes.append(note("ignored_file", "keys", name=file.name, keys=read.unknown_keys))

    def one_table(self) -> tuple[Table | None, Trouble | None]:
        """Return the table with the greatest weight, or the trouble if there is none or if two different ones weigh the same."""
        if not self.tables:
            instead = self.refused or ([] if self.equations or self.answers else self.attached)
            if instead:
                return None, instead[0]
            return None, Trouble("missing", "missing", say(f"reading.trouble.{'missing' if self.entries else 'no_files'}"))
        tables = [table for _, table in self.tables]
        wholes = joined([part for part, _ in self.tables], self.expected.grid)
        if len(wholes) < len(tables):  # some files hold parts of one table
            tables = [table for _, table in read_parts(wholes, self.expected.grid) if isinstance(table, Table)] or tables
        tables = [table for table in tables if not table.unsure] or tables
        ranked = sorted(tables, key=lambda table: (table.weight, sum(column.decimals for column in table.columns)), reverse=True)
        best, *others = ranked
        equal = [other for other in others if other.weight == best.weight and not alike(other, best)]
        if equal:
            names = tuple(_named(table) for table in (best, *equal))
            return None, Trouble("needs-review", "two_tables", say("reading.trouble.two_tables", names=names))
        if others:
            self.notes.append(note("two_tables", name=_named(best), others=tuple(map(_named, others))))
        self.notes += best.notes
        cut_short = say("reading.review.cut_short", name=_named(best)) if best.is_cut else None
        self.review = self.review or best.unsure or cut_short or _unread_cells(best)
        return best, None


def read_submission(submission: Submission, expected: Expected) -> StudentWork:
    """Return the table, equations and answers of a submission."""
    found = _Found(expected, notes=list(submission.notes), review=submission.review)
    files = [inner for file in submission.files for inner in opened(file)]
    for file in files[FILES:]:
        found.notes.append(note("ignored_file", name=file.name, why=say("reading.why.too_many", limit=FILES)))
    for file in files[:FILES]:
        kinds = found.read(file, len(files) == 1)
        found.entries.append(FileEntry(file.name, kinds[0], kinds, file.size, file.sha256))
    table, trouble = found.one_table()
    handed = found.equations or found.beside
    lines = _with_files(_first_of_each(handed, most_lines(expected)))
    if unread := found.unread + len(handed) - len(lines):
        found.notes.append(note("ignored_file", "lines", number=unread))
    if dropped := found.unread + sum(line.may_be_one for line in handed) - sum(line.may_be_one for line in lines):
        found.review = found.review or say("reading.review.lines_dropped", number=dropped)
    return StudentWork(
        tuple(found.entries),
        table,
        trouble,
        tuple(lines) if lines else None,
        tuple(found.answers),
        tuple(found.notes),
        found.review,
        found.unopened,
        found.pictured,
    )


def _first_of_each(lines: Sequence[EquationLine], most: int) -> list[EquationLine]:
    """Return the first `most` lines that may be equations and as many of the others, in the order handed in."""
    left = {True: most, False: most}
    kept = []
    for line in lines:
        left[line.may_be_one] -= 1
        if left[line.may_be_one] >= 0:
            kept.append(line)
    return kept


def _with_files(lines: list[EquationLine]) -> list[EquationLine]:
    """Return the lines with their files in their places if there are several files: the number of a line alone names two."""
    if len({line.file for line in lines}) < 2:
        return lines
    return [replace(line, place=say("reading.place.in_file", file=line.file, place=line.where)) for line in lines]


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
