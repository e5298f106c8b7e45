"""Widths of columns, heights of wrapped texts, and the rows after which a printed page ends.

A text runs over empty cells beside it, as spreadsheet programs show it; where it meets the next its column grows.
A page ends between tables, charts and sections, not within them.
"""

import math
import re
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import accumulate, pairwise
from typing import NamedTuple

from workbook.book.declare import FIRST, REFERENCE, Block, Book, Quantity, Sheet
from workbook.book.quantity import FAIL, OK
from workbook.book.rows import as_rows
from workbook.book.sheet import COLUMN_WIDTH, WIDTHS
from workbook.writing import style

RUN = 12  # columns over which a text may run
TOWARDS = {"left": 1, "right": -1}  # where texts run over: in the middle of a table, nowhere
INDENT = 1.3  # digits
GAP = 0.75  # digits beside a text, so that it does not touch what stands next to it
WORD, NAME = re.compile(r'"((?:[^"]|"")*)"'), re.compile(r"\w+")
NARROW, SLIM, BROAD = "ilj.,:;'|()[] ", "tfr", "mwMW%ω"
EMS = {**dict.fromkeys(NARROW, 0.3), **dict.fromkeys(SLIM, 0.37), **dict.fromkeys(BROAD, 0.84)}
# of the em, rather more than less: a text must not be cut
CAPITAL, LETTER, DIGIT = 0.62, 0.545, 0.507
HEAD = 10.0  # points of a table's heads
FULL = 11.0  # points in which a column's width is counted
TWO_LINES = 0.7  # the share of a text that the longer of two lines takes
BOLD = 1.06  # how much wider than others bold letters are


class PossibleTexts:
    """The texts that may stand in cells: what is there, what a formula can take from other cells, or says itself."""

    def __init__(self, book: Book) -> None:
        self._book = book
        self._known: dict[tuple[str, str], frozenset[str]] = {}

    def texts(self, block: Block, q: Quantity) -> frozenset[str]:
        """Return the texts that may stand in a column of a block."""
        key = block.name, q.name
        if key not in self._known:
            self._known[key] = frozenset()  # a formula that names its own column, the row above
            self._known[key] = frozenset(self._of(block, q))
        return self._known[key]

    def _of(self, block: Block, q: Quantity) -> Iterator[str]:
        if q.role == "check":
            yield from (OK, FAIL)
            return
        texts = [text for text in as_rows(q.value, block.size, q.name) if isinstance(text, str)]
        yield from texts
        if q.role == "input" and q.choices.startswith("="):
            for table, column in [self._book.column_names.get(q.choices[1:], ("", ""))]:
                yield from self._column(table, column)
        if texts and q.formula is not None:
            for formula in {q.formula} if isinstance(q.formula, str) else set(q.formula):
                yield from self._taken(block, formula)

    def _taken(self, block: Block, formula: str) -> Iterator[str]:
        """Yield what a formula says, and what stands in the cells that it names."""
        yield from (word.replace('""', '"') for word in WORD.findall(formula))
        for first, second, _ in REFERENCE.findall(formula):
            within = not second or second == "-1"
            yield from self._column(block.name if within else first, first if within else second[1:])
        for name in set(NAME.findall(REFERENCE.sub("", WORD.sub("", formula)))):
            yield from self._column(name, name)

    def _column(self, table: str, column: str) -> frozenset[str]:
        block = self._book.blocks.get(table)
        q = next((q for q in block.quantities if q.name == column), None) if block else None
        return self.texts(block, q) if block and q else frozenset()


@lru_cache(maxsize=10_000)
def text_width(text: str, points: float, bold: bool = False) -> float:
    """Return how wide a text is at most, in digits of a column's width."""
    ems = math.fsum(EMS.get(letter, CAPITAL if letter.isupper() else LETTER) for letter in text)
    return ems * points / FULL / DIGIT * (BOLD if bold else 1.0)


def lines_of(text: str, points: float, room: float) -> int:
    """Return how many lines a text takes that is wrapped at its blanks, in a column ``room`` wide."""
    count, taken = 1, 0.0
    for word in text.split():
        needed = text_width(f" {word}" if taken else word, points)
        if taken and taken + needed > room:
            count, taken, needed = count + 1, 0.0, text_width(word, points)
        taken += needed
        while taken > room:
            count, taken = count + 1, taken - room
    return count


def widths(sheet: Sheet, standing: PossibleTexts) -> dict[int, float]:
    """Return the width of each column that has its own, in digits."""
    known_widths: dict[int, float] = WIDTHS | sheet.widths
    for text in sheet.texts:
        is_folded = 0 < sheet.folded_rows <= text.row  # heads of such workings make no page wider
        if text.style in ("header", "units") and not is_folded:
            words = text.text.split() if text.style == "header" or sheet.one_page else [text.text]
            needed = (
                GAP
                + INDENT * style.indent(text.side, text.column)
                + max((text_width(word, HEAD, text.style == "header") for word in words), default=0.0)
            )
            if 0 < sheet.print_columns < text.column:  # of workings, which make no printed row high
                needed = max(needed, GAP + TWO_LINES * text_width(text.text, HEAD, bold=True))
            known_widths[text.column] = max(needed, known_widths.get(text.column, COLUMN_WIDTH))
        elif text.style == "unit" and not is_folded:  # before a note
            needed = 2 * GAP + text_width(text.text, HEAD)
            known_widths[text.column] = max(needed, known_widths.get(text.column, COLUMN_WIDTH))
    taken = taken_rows(sheet)
    for block in sheet.blocks:
        for q, column in zip(block.quantities, block.columns.values(), strict=True):
            if q.role in ("sentence", "check") or q.align == "fill":  # cut off at its cell's end
                continue
            texts: Iterable[str] = standing.texts(block, q)
            if q.wrap:
                texts = [word for text in texts for word in text.split()]
            font = style.ROLES[style.style_role(q.role, block)].font
            needed = max((text_width(text, font.sz or FULL, bool(font.b)) for text in texts), default=0.0)
            has = known_widths.get(column, COLUMN_WIDTH)
            aligned = style.aligned(q, block.is_table, column)
            needed += INDENT * aligned.indent
            if needed + GAP > has:
                step = TOWARDS.get(aligned.side, 0)
                rows = range(block.row, block.row + block.size)
                run = min(free_width(known_widths, taken, row, column, step) for row in rows)
                known_widths[column] = max(has, needed + GAP - (0 if q.wrap else run))
    return known_widths


def taken_rows(sheet: Sheet) -> Mapping[int, set[int]]:
    """Return the rows of each column in which a cell shows something or a chart lies."""
    taken: defaultdict[int, set[int]] = defaultdict(set)
    for text in sheet.texts:
        if text.text:
            taken[text.column].add(text.row)
    for block in sheet.blocks:
        rows = range(block.row, block.row + block.size)
        for q, column in zip(block.quantities, block.columns.values(), strict=True):
            values = as_rows(q.value, block.size, q.name)
            shown = (row for row, value in zip(rows, values, strict=True) if value not in (None, ""))
            taken[column].update(shown if q.formula is None else rows)
    for _, top, left, wide, high in sheet.charts:
        for column in range(left, left + wide):
            taken[column].update(range(top, top + high))
    return taken


def free_width(known: dict[int, float], taken: Mapping[int, set[int]], row: int, column: int, step: int) -> float:
    """Return how much room the empty cells beside a cell have; ``taken`` as :func:`taken_rows` returns it."""
    room = 0.0
    for beside in range(column + step, column + step * (RUN + 1), step or 1):
        if row in taken.get(beside, ()) or beside < FIRST:
            break
        room += known.get(beside, COLUMN_WIDTH)
    return room


MARGINS = {"left": 0.4, "right": 0.4, "top": 0.45, "bottom": 0.6, "header": 0.25, "footer": 0.3}
"""inches; A4 in landscape less these is in points"""
WIDTH = 72 * (297 / 25.4 - MARGINS["left"] - MARGINS["right"])
HEIGHT = 72 * (210 / 25.4 - MARGINS["top"] - MARGINS["bottom"])
WIDE, BESIDE = 5.25, 3.75  # of a column in points: each digit of its width, and what is beside them
ROW = 15.0  # points of a row, and of a row that a chart is high
TALL = {"title": 24.0, "heading": 18.0}
LEAST_SCALE, STEP = 0.71, 0.02  # of a print: texts of 10 points become 7; what is tried between
ASIDE = 0.98  # share of a page's width that is filled at most
SPARE = 0.96  # share of a page that is filled at most: programs differ in how high rows are
# costs of a further page, and of cutting any of these
PAGE, SECTION, FIGURES, TABLE, CHART = 20, 4, 3, 60, 200
CLOSE = 3  # rows of a section, and of a table, that its heading keeps to


class Pages(NamedTuple):
    """How a sheet is printed: the scale, and the rows after which a page ends."""

    scale: float
    breaks: list[int]


def pages(sheet: Sheet, last: int, columns: int, wide: Mapping[int, float], high: Mapping[int, float]) -> Pages:
    """Return the fewest pages on which texts can be read, as large as they can be; widths in digits, heights in pt."""
    widest = min(
        1.0, ASIDE * WIDTH / math.fsum(WIDE * wide.get(c, COLUMN_WIDTH) + BESIDE for c in range(1, columns + 1))
    )
    scales = [widest - k * STEP for k in range(max(0, int((widest - LEAST_SCALE) / STEP)) + 1)]
    scales.append(min(widest, LEAST_SCALE))
    if sheet.page_end:
        scales = [min(widest, ASIDE * HEIGHT / row_ends(sheet, last, high)[sheet.page_end])]
    possible = [Pages(scale, breaks(sheet, last, scale, high)) for scale in scales]
    return min(possible, key=lambda pages: len(pages.breaks))


def row_ends(sheet: Sheet, last: int, high: Mapping[int, float]) -> list[float]:
    """Return how far down each row ends (points), from the top of the first on."""
    tall = {1: TALL["title"]} | {text.row: TALL[text.style] for text in sheet.texts if text.style in TALL}
    return list(accumulate((high.get(row) or tall.get(row, ROW) for row in range(1, last + 1)), initial=0.0))


def breaks(sheet: Sheet, last: int, scale: float, high: Mapping[int, float]) -> list[int]:
    """Return the rows after which a page ends, by the cheapest cuts; the first page may be a whole."""
    ends, start = row_ends(sheet, last, high), sheet.page_end or sheet.head
    room = SPARE * HEIGHT / scale - ends[sheet.head]
    costs = [0] * (last + 1)  # of a page that ends with a row
    for first, end, cost in unbroken_spans(sheet, last, ends):
        for row in range(first, min(end, last + 1)):
            costs[row] += cost
    # by the row that a page ends with: cost, page before
    best: dict[int, tuple[int, int]] = {start: (0, 0)}
    for row in range(start + 1, last + 1):
        possible = [
            (cost + PAGE + (costs[row] if row < last else 0), before)
            for before, (cost, _) in best.items()
            if ends[row] - ends[before] <= room
        ]
        if possible:
            best[row] = min(possible, key=lambda choice: (choice[0], -choice[1]))
    rows: list[int] = []
    row = best[last][1] if last in best else start
    while row > start:
        rows.append(row)
        row = best[row][1]
    return [*([start] if sheet.page_end else []), *rows[::-1]]


def unbroken_spans(sheet: Sheet, last: int, ends: list[float]) -> Iterator[tuple[int, int, int]]:
    """Yield rows of charts, tables with titles and checks, figures, sections, and what it costs to cut them."""
    rows = sorted({block.row for block in sheet.blocks if not block.is_table})
    begins, finishes = ([row for row in rows if row + step not in rows] for step in (-1, 1))
    yield from ((first, end, FIGURES) for first, end in zip(begins, finishes, strict=True))
    for _, row, _, _, height in sheet.charts:
        if row <= last:
            yield row, bisect_left(ends, ends[row - 1] + height * ROW), CHART
    checks = [block for block in sheet.blocks if block.quantities[0].role == "check" and block.column == FIRST + 2]
    judged, headed = {block.row for block in checks}, {0}
    for block in sheet.blocks:
        if block.is_table and block.lead is None:
            heads = block.shared_heads  # of the first below them they are a part
            above = [block.row - 1 if heads in headed else heads - 1]
            above = above if heads else text_rows(sheet, "subheading", block.row - 1)
            headed.add(heads)
            title, end = max(above, default=block.row), block.row + block.size - 1
            yield title, end + 2 if end + 2 in judged else end, TABLE
            yield title, block.row + CLOSE - 1, TABLE
    for head, behind in pairwise([*text_rows(sheet, "heading", last), last + 1]):
        yield head, behind - 1, SECTION
        yield head, head + CLOSE, TABLE


def text_rows(sheet: Sheet, style: str, last: int) -> list[int]:
    """Return the rows down to the last in which texts of a style stand, in their order."""
    return sorted(text.row for text in sheet.texts if text.style == style and text.row <= last)
