"""How wide columns are: as declared, and wider where a text may stand that is cut there; how high wrapped texts are.

A text runs over empty cells beside it, as spreadsheet programs show it; where it meets the next one its column grows.
"""

import re
from collections.abc import Iterable, Iterator
from typing import Any

from workbook.book.declare import FIRST, REFERENCE, Block, Book, Quantity, Sheet
from workbook.book.quantity import sample
from workbook.book.rows import as_rows
from workbook.writing import style

WIDTHS = {1: 2, FIRST: 38}
COLUMN_WIDTH = 12
RUN = 12  # columns over which a text may run
TOWARDS = {"left": 1, "right": -1}  # where texts run over: in the middle of a table, nowhere
GAP = 0.75  # digits beside a text, so that it does not touch what stands next to it
WORD, NAME = re.compile(r'"((?:[^"]|"")*)"'), re.compile(r"\w+")
NARROW, SLIM, BROAD = "ilj.,:;'|()[] ", "tfr", "mwMW%ω"
EMS = {**dict.fromkeys(NARROW, 0.3), **dict.fromkeys(SLIM, 0.37), **dict.fromkeys(BROAD, 0.84)}
CAPITAL, LETTER, DIGIT = 0.62, 0.545, 0.507  # of the em, rather more than less: a text must not be cut
FULL = 11.0  # points in which a column's width is counted
BOLD = 1.06  # how much wider than others bold letters are


class Standing:
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
        found = [text for text in as_rows(q.value, block.size, q.name) if isinstance(text, str)]
        yield from found
        if q.role == "input" and q.choices.startswith("="):
            for table, column in [self._book.column_names.get(q.choices[1:], ("", ""))]:
                yield from self._column(table, column)
        if found and q.formula is not None:
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


def text_width(text: str, points: float, bold: bool = False) -> float:
    """Return how wide a text is at most, in digits of a column's width."""
    ems = sum(EMS.get(letter, CAPITAL if letter.isupper() else LETTER) for letter in text)
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


def widths(sheet: Sheet, standing: Standing) -> dict[int, float]:
    """Return the width of each column that has one of its own, in digits."""
    found: dict[int, float] = WIDTHS | sheet.widths
    taken = {(text.row, text.column) for text in sheet.texts if text.text}
    for block in sheet.blocks:
        for q, column in zip(block.quantities, block.columns.values(), strict=True):
            values: list[Any] = as_rows(q.value, block.size, q.name)
            taken |= {(block.row + i, column) for i, value in enumerate(values)
                      if q.formula is not None or value not in (None, "")}  # fmt: skip
    for _, top, left, wide, high in sheet.charts:
        taken |= {(row, column) for row in range(top, top + high) for column in range(left, left + wide)}
    for block in sheet.blocks:
        for q, column in zip(block.quantities, block.columns.values(), strict=True):
            if q.role in ("sentence", "check"):
                continue
            texts: Iterable[str] = standing.texts(block, q)
            if q.wrap:
                texts = [word for text in texts for word in text.split()]
            font = style.ROLES[style.kind(q.role, block.is_table)].font
            needed = max((text_width(text, font.sz or FULL, bool(font.b)) for text in texts), default=0.0)
            has, step = found.get(column, COLUMN_WIDTH), TOWARDS.get(style.alignment(q, sample(q), block.is_table), 0)
            if needed + GAP > has:
                rows = range(block.row, block.row + block.size)
                run = min(free(found, taken, row, column, step) for row in rows)
                found[column] = max(has, needed + GAP - (0 if q.wrap else run))
    return found


def free(found: dict[int, float], taken: set[tuple[int, int]], row: int, column: int, step: int) -> float:
    """Return how much room the empty cells beside a cell have."""
    room = 0.0
    for beside in range(column + step, column + step * (RUN + 1), step or 1):
        if (row, beside) in taken or beside < FIRST:
            break
        room += found.get(beside, COLUMN_WIDTH)
    return room
