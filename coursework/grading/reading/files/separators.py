"""Text -> rows of cells: find the separator of a file that does not name it.

Enters: a decoded text.  Leaves: `Split`.  Only the form of the numbers counts, never the key.
Used by `tables_of_file.py`; `is_progression` is used by `layout.py` and `columns.py` too.
"""

from __future__ import annotations

import csv
import itertools
import re
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from io import StringIO
from itertools import pairwise

from coursework.grading.reading.files.cells import BlankRows
from coursework.grading.reading.files.printed import in_whole_lines, listed_rows, named_rows, rows_of_lines, rows_of_typst
from coursework.grading.reading.limits import CELL_CHARACTERS, LINE_CHARACTERS, Room, unreadable
from coursework.grading.reading.numbers import looks_numeric, marks, plain_text
from coursework.system.frozen import frozen

NAMES = {"\t": "tab", " ": "blanks"}
_SAMPLE = 80  # number of lines used to choose the separator
_HINT = re.compile(r'\s*"?sep=(.)"?[;,\t]*\s*', re.IGNORECASE)
_PARTED = re.compile(r"[;\t|]")
_TOKEN = re.compile(r'"[^"]*"|[^ \t"]+')
_BARS = str.maketrans(dict.fromkeys("│┃║┆┊❘", "|"))
_REMARKS = {"#", "%", "//", "!", "--", "%%", "##"}
_KNITTED = re.compile(r"(?m)^(?:##|#>)(?=[ \t])")  # the prefix of each line of R's output in a knitted page
_BEST = (1.0, 1.0, 1.0, 0.0)  # how a score begins if nothing in a table speaks against its separator
_FEWEST = 3  # least number of consecutive rows of numbers that make a block


@frozen
class Split:
    """Rows of texts; `separator` as in grades.json; `has_pairs` if decimal commas were taken for separators (1,5 as 1 and 5)."""

    separator: str
    rows: tuple[tuple[str, ...], ...]
    has_pairs: bool = False


def split(text: str, room: Room) -> Split | None:
    r"""Return the rows of the table in a text, None if it has none.  Raises `Refused` if a line is too long.

    >>> split("t;phi1;w1\n0;1,5;2\n0,1;1,7;2", Room(600, 40)).separator
    ';'
    """
    text = _KNITTED.sub("  ", text if "," in text else text.replace("，", ","))
    lines = in_whole_lines(list(_lines(text.translate(_BARS), room.rows)))
    if rows := rows_of_typst(text, room.rows) or listed_rows("\n".join(lines), room):
        return Split("cells", rows)
    sample = lines[:_SAMPLE]
    if 2 * sum(map(looks_numeric, sample)) > sum(map(bool, sample)) and not any(_PARTED.search(line) for line in sample):
        each = list(_lines(text, room.rows * room.columns))  # one cell in each line
        if rows := rows_of_lines(each, _progresses):
            return Split("cells", rows[: room.rows + 1])
    if lines and (hint := _HINT.fullmatch(lines[0])):
        return Split(NAMES.get(hint[1], hint[1]), _cells(["", *lines[1:]], hint[1], room.columns))
    signs = [sign for sign in (";", "\t", ",", "|", " ") if sign == " " or any(sign in line for line in lines[:_SAMPLE])]
    judged: list[tuple[str, tuple[tuple[float, ...], bool]]] = []
    for sign in signs:
        if sign == " " and any(score[:4] == _BEST for _, (score, _) in judged):
            break  # blanks are the last choice among equally good ones
        if found := _judged(_cells(lines[:_SAMPLE], sign, room.columns), sign):
            judged.append((sign, found))
    if not judged:
        # Each number may be on a line of its own.
        rows = named_rows("\n".join(_lines(text, room.rows * room.columns)), room.rows)
        return Split("cells", rows) if rows else None
    sign, (_, has_pairs) = max(judged, key=lambda one: one[1][0])  # of equally good ones the first
    return Split(NAMES.get(sign, sign), _cells(lines, sign, room.columns), has_pairs)


def _lines(text: str, most: int) -> Iterator[str]:
    """Yield the lines to read, up to `most` filled ones or until too many blank ones.  Raises `Refused` if one is too long."""
    blank = BlankRows()
    filled = 0
    for line in StringIO(text):
        if filled >= most:
            return
        if len(line) > LINE_CHARACTERS + line.endswith("\n"):
            raise unreadable("long_line", limit=LINE_CHARACTERS)
        is_blank = not line.strip(' \t;,|"\u00a0\n')
        if blank.too_many(is_blank):
            return
        filled += not is_blank
        yield line.removesuffix("\n")


def _cells(lines: list[str], sign: str, most: int) -> tuple[tuple[str, ...], ...]:
    if sign == " ":
        return _between_blanks(lines, most)
    if sign == "|":  # the rows of a boxed table begin and end with a bar
        lines = [line.strip().strip("|").replace(" || ", " | ") for line in lines]
    # Quoted cells may contain separators and line ends; `csv` gets lines of limited length only.
    reader = csv.reader((line + "\n" for line in lines), delimiter=sign, quotechar='"', skipinitialspace=True)
    with suppress(csv.Error):  # a cell is too long
        rows = list(reader)
        if not (rows and "\n" in "".join(rows[-1][-1:])[:-1] and sum(line.count('"') for line in lines) % 2):
            return tuple(tuple(cell.strip()[:CELL_CHARACTERS] for cell in row[:most]) for row in rows)
    # An unclosed quotation mark makes one cell of all that follows: it is left out.
    return tuple(tuple(cell.strip(' \t"')[:CELL_CHARACTERS] for cell in line.split(sign)[:most]) for line in lines)


def _between_blanks(lines: list[str], most: int) -> tuple[tuple[str, ...], ...]:
    """Return the tokens of the lines; tables separated by blank lines or headers are aligned one by one."""
    blocks: list[list[str]] = [[]]
    count = 0  # rows of numbers in the current block
    for is_row, group in itertools.groupby(lines, lambda line: line.lstrip("[({-+ |\t")[:1].isdigit()):
        block = list(group)
        if is_row and len(block) < _FEWEST:  # rows of numbers with other lines between them
            return _aligned(lines, most)
        if count:  # a line after rows of numbers begins a new block
            blocks.append([])
        count = len(block) if is_row else 0
        blocks[-1] += block
    return tuple(row for block in blocks for row in _aligned(block, most))


def _aligned(lines: list[str], most: int) -> tuple[tuple[str, ...], ...]:
    """Return the tokens of the lines; in a row of too few numbers, each number goes to the column it is printed under."""
    found = [list(itertools.islice(_TOKEN.finditer(line), most)) for line in lines]
    rows = [tuple(match[0].strip('"')[:CELL_CHARACTERS] for match in matches) for matches in found]
    numeric = [bool(row) and all(map(looks_numeric, row)) for row in rows]
    widths = Counter(len(row) for row, is_numeric in zip(rows, numeric, strict=True) if is_numeric)
    usual = max(widths, key=lambda width: (widths[width], width), default=0)
    if usual < 3:
        return tuple(rows)
    whole = [matches for matches, row, is_numeric in zip(found, rows, numeric, strict=True) if is_numeric and len(row) == usual]
    spans = [(min(m[at].start() for m in whole), max(m[at].end() for m in whole)) for at in range(usual)]
    numbers = [plain_text(matches[0][0]) for matches in whole]
    counted = len(numbers) > 1 and any(numbers == [str(k + start) for k in range(len(numbers))] for start in (0, 1))
    for at, row in enumerate(rows):
        if not numeric[at]:
            rows[at] = _in_words(lines[at], _headed(found[at], row, spans) if counted else row, usual)
        elif 1 < len(row) < usual:
            rows[at] = _below(found[at], row, spans)
    return tuple(rows)


def _in_words(line: str, row: tuple[str, ...], usual: int) -> tuple[str, ...]:
    """Return the headers of a line: words with one blank between them are one header; a leading comment sign is dropped."""
    if len(row) == usual + 1 and row[0] in _REMARKS:
        return row[1:]
    wide = tuple(re.split(r"\s{2,}|\t", line.strip())) if len(row) > usual else row
    return wide if len(wide) in {usual, usual - 1} else row


def _headed(matches: list[re.Match[str]], row: tuple[str, ...], spans: list[tuple[int, int]]) -> tuple[str, ...]:
    """Return the headers of a printed data frame: each ends where its column ends; the row numbers have none."""
    if not matches or matches[0].start() < spans[0][1] or matches[-1].end() != spans[-1][1]:
        return row
    cells = [""] * len(spans)
    for match, text in zip(matches, row, strict=True):
        at = next(at for at, (_, end) in enumerate(spans) if match.end() <= end)
        cells[at] = f"{cells[at]} {text}".strip()
    return tuple(cells)


def _below(matches: list[re.Match[str]], row: tuple[str, ...], spans: list[tuple[int, int]]) -> tuple[str, ...]:
    """Return a row with "" in columns without a number under them; () if a token cannot be assigned to one column."""
    cells = [""] * len(spans)
    for match, text in zip(matches, row, strict=True):
        under = [at for at, (start, end) in enumerate(spans) if match.start() < end and start < match.end()]
        if len(under) != 1 or cells[under[0]]:
            return ()
        cells[under[0]] = text
    return tuple(cells)


def _judged(rows: tuple[tuple[str, ...], ...], sign: str) -> tuple[tuple[float, ...], bool] | None:
    """Return a score of how well rows look like a table, and whether decimal commas were split; None if there are no numbers."""
    numeric = [[looks_numeric(cell) for cell in row] for row in rows]
    body = [index for index, row in enumerate(numeric) if sum(row) >= 2 and 2 * sum(row) >= sum(map(bool, rows[index]))]
    if len(body) < 2:
        return None
    width = max(len(rows[index]) for index in body)
    counts = [sum(j < len(numeric[i]) and numeric[i][j] for i in body) for j in range(width)]
    columns = sum(2 * count >= len(body) for count in counts)
    parsed = sum(counts)
    unparsed = sum(bool(cell) and not is_number for i in body for cell, is_number in zip(rows[i], numeric[i], strict=True))
    texts = [cell for i in body for cell, is_number in zip(rows[i], numeric[i], strict=True) if is_number]
    has_pairs = sign == "," and len(texts) > 5 and all(re.fullmatch("[-+]?[0-9]+", plain_text(text)) for text in texts)
    score = (
        columns >= 3 and not has_pairs, columns >= 2, _progresses(rows, body), -round(4 * unparsed / (parsed + unparsed)),
        sign != " ", parsed - 2 * unparsed, _fitting_mark(texts, sign),
    )  # fmt: skip
    return tuple(map(float, score)), has_pairs


def _fitting_mark(texts: list[str], sign: str) -> bool:
    """Return whether the decimal mark is the usual one with this separator: comma with ";", point with ","."""
    comma, point, _, _ = marks(texts)
    return (sign == ";" and comma > 0) or (sign == "," and point > 0)


def _progresses(rows: tuple[tuple[str, ...], ...], body: list[int]) -> bool:
    """Return whether one of the first two columns rises in equal steps, as the time does."""
    for place in (0, 1):
        texts = [plain_text(rows[i][place]).replace(",", ".") for i in body]
        values = [float(text) for text in texts if re.fullmatch(r"[-+]?[0-9]{1,12}(?:\.[0-9]{0,12})?", text)]
        if 2 * len(values) >= len(body) and is_progression(sorted(values)):
            return True
    return False


def is_progression(values: list[float], slack: float = 0.0) -> bool:
    """Return whether sorted numbers rise in about equal steps; `slack` is the rounding error of each number."""
    if len(values) < 3 or not values[-1] > values[0]:
        return False
    steps = [later - earlier for earlier, later in pairwise(values)]
    mean = (values[-1] - values[0]) / len(steps)
    return all(abs(step - mean) <= 0.3 * mean + 2 * slack for step in steps)
