"""The lines of a PDF page -> the rows of cells of its tables, by the positions of the words.

Enters: `PageLine`s.  Leaves: rows of texts; a number that is broken in its cell is put together.
Used by `pdf.py`.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

from coursework.grading.reading.documents.pdf.pdf_lines import PageLine, Word
from coursework.grading.reading.numbers import looks_numeric

_CELL_GAP = 0.62  # share of the size of letters: the gap between two cells
_BROKEN = 2  # lines in which a broken number may go on
_NAMING = re.compile(r"\d|^(?:№|#|[^\W\d]{1,2})(?:,|$)")


def tables_in(lines: Sequence[PageLine]) -> list[tuple[int, list[list[str]]]]:
    """Return the tables of a page as rows of texts, each with the index of its first line (from 0).

    Rows of numbers belong to one table if at most two other lines are between them; up to four lines above are its heads.
    """
    numbers = [place for place, line in enumerate(lines) if line.is_numbers]
    runs: list[list[int]] = []
    for index, place in enumerate(numbers):
        near = [len(lines[at].words) for at in numbers[max(index - 2, 0) : index + 2]]  # two rows of four words, then two of five
        is_wider = len(near) == 4 and near[0] == near[1] != near[2] == near[3]
        begins = place - numbers[index - 1] > 1 and (is_wider or _first(lines[place]) < _first(lines[numbers[index - 1]]))
        if runs and place - runs[-1][-1] <= 3 and not begins:
            runs[-1].append(place)
        else:
            runs.append([place])
    tables = []
    end = 0
    for run in runs:
        if len(run) > 1 or len(lines[run[0]].words) > 2:  # a page may have room for one row only
            start = max(run[0] - 4, end)
            tables.append((start, _rows(lines[start : run[-1] + 1], lines[run[-1] + 1 : run[-1] + 1 + _BROKEN])))
        end = run[-1] + 1
    return tables


def _first(line: PageLine) -> float:
    """Return the first number of a row (its time or row number), which starts again in another table; 0 if it has none."""
    found = re.match(r"\d{1,9}(?:[.,]\d{1,9})?$", line.words[0].text)
    return float(found[0].replace(",", ".")) if found else 0.0


def _rows(lines: Sequence[PageLine], behind: Sequence[PageLine] = ()) -> list[list[str]]:
    """Return lines as rows of cells: each word goes to the column of numbers above or below it.

    A number that is broken at the end of its cell is put together, also from the lines `behind` the last row.
    """
    widths = Counter(len(line.words) for line in lines if line.is_numbers)
    usual = max(widths, key=lambda width: (widths[width], width))
    whole = [line.words for line in lines if line.is_numbers and len(line.words) == usual]
    spans = [(min(words[at].left for words in whole), max(words[at].right for words in whole)) for at in range(usual)]
    decimals = [max(_decimals(words[at].text) for words in whole) for at in range(usual)]
    rows: list[list[str]] = []
    was_whole = False
    for place, line in enumerate((*lines, *behind)):
        is_whole = line.is_numbers and len(line.words) == usual
        if was_whole and not is_whole and (rest := _rest_of_numbers(line, rows[-1], spans, decimals)):
            rows[-1] = [text + more for text, more in zip(rows[-1], rest, strict=True)]
            continue
        if place >= len(lines):
            break
        if is_whole:
            rows.append([word.text for word in line.words])
        else:
            rows.append(_below([part for cell in _cells(line) for part in _parted(cell, line, spans)], spans))
        was_whole = is_whole
    return rows


def _rest_of_numbers(
    line: PageLine, row: Sequence[str], spans: Sequence[tuple[float, float]], decimals: Sequence[int]
) -> list[str]:
    """Return what a line adds to each number of the row above it, [] if a word stands below a number that is whole."""
    rest = [""] * len(row)
    for word in line.words:
        over = [at for at, (left, right) in enumerate(spans) if word.left < right and left < word.right]
        if len(over) != 1 or not re.fullmatch(r"[\d.,]+", word.text) or _decimals(row[over[0]]) >= max(decimals[over[0]], 1):
            return []
        rest[over[0]] = word.text
    return rest


def _decimals(text: str) -> int:
    return len(re.sub(r"^[^.,]*[.,]?", "", text))


def _cells(line: PageLine) -> list[Word]:
    """Return the words of a line, joined where only a blank separates them; numbers stay separate."""
    cells: list[Word] = []
    for word in line.words:
        last = cells[-1] if cells else None
        apart = last is None or word.left - last.right > _CELL_GAP * line.size
        if apart or last is None or (looks_numeric(word.text) and looks_numeric(last.text)):
            cells.append(Word(word.text, word.left, word.right))
        else:
            last.text, last.right = f"{last.text} {word.text}", word.right
    return cells


def _parted(cell: Word, line: PageLine, spans: Sequence[tuple[float, float]]) -> list[Word]:
    """Split a cell into the heads of neighbouring columns with a narrow gap; a title over several columns stays whole.

    Each column must get words: all but the time's with a number, or else short names; the aligned side shows where each begins.
    """
    over = [span for span in spans if cell.left < span[1] and span[0] < cell.right]
    if len(over) < 2:
        return [cell]
    if abs(cell.left - over[0][0]) < 0.5 * line.size:
        ends = [left - 0.5 * line.size for left, _ in over[1:]]
    elif abs(cell.right - over[-1][1]) < 0.5 * line.size:
        ends = [right + 0.5 * line.size for _, right in over[:-1]]
    else:
        ends = [(before[1] + after[0]) / 2 for before, after in pairwise(over)]
    parts: list[list[Word]] = [[] for _ in over]
    for word in line.words:
        if cell.left <= word.left and word.right <= cell.right:
            parts[bisect_right(ends, (word.left + word.right) / 2)].append(word)
    texts = [" ".join(word.text for word in words) for words in parts]
    numbered = sum(any(map(str.isdigit, text)) for text in texts)
    if not all(texts) or not (numbered >= len(over) - 1 or all(map(_NAMING.search, texts))):
        return [cell]
    return [Word(text, *span) for text, span in zip(texts, over, strict=True)]


def _below(cells: Sequence[Word], spans: Sequence[tuple[float, float]]) -> list[str]:
    row = [""] * len(spans)
    for cell in cells:
        over = [at for at, (left, right) in enumerate(spans) if cell.left < right and left < cell.right]
        middle = (cell.left + cell.right) / 2
        nearest = min(range(len(spans)), key=lambda at: abs((spans[at][0] + spans[at][1]) / 2 - middle))
        for at in over or [nearest]:
            row[at] = f"{row[at]} {cell.text}".strip()
    return row
