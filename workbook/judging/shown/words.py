"""Labels, symbols, units and headings: whether each cell is still called what it is."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Literal, NamedTuple

from workbook.book.address import Address
from workbook.book.declare import FIRST, Block, Sheet, Text
from workbook.judging.matching import MOST_BETWEEN, Match
from workbook.judging.report import LAYOUT, NOTICE, SHOWN, Report
from workbook.judging.shown import units

Kind = Literal["label", "symbol", "unit", "header", "units", "equation", "note"]
ABOVE = ("header", "units", "equation")
QUIET = ("equation", "note")  # reworded, these are nobody's concern; exchanged, they are
HEADINGS = ("heading", "subheading")
MOST_ASIDE = 6  # columns that someone may have put between a cell and the texts of its row
TELLING = re.compile(r"[0-9]+|[%‰]|\b(?:OK|FAIL)\b")
"""what a translation leaves as it is"""


class Word(NamedTuple):
    """A declared text that says what a cell is: of a row, or of a column of a table."""

    text: Text
    block: Block
    what: str

    @property
    def above(self) -> bool:
        """Whether it stands above a column."""
        return self.text.style in ABOVE

    @property
    def counts(self) -> bool:
        """Whether it is a label, a symbol or a unit."""
        return self.text.style not in QUIET


class Found(NamedTuple):
    """A declared text, and where it stands in the file, or something else in its place."""

    at: Address
    word: Word


def words(match: Match, report: Report) -> list[Found]:
    """Enter texts that say something else of a cell, and as notices those that are reworded; return where they are."""
    named = {(f.sheet, f.cell) for f in report.findings if f.kind == "name"}
    for name in match.headless:
        at = match.file.places[name].cell(0, 0)
        report.say(at, LAYOUT, "no headings", "its headings above it: move them together", f"the table {name}")
    titles(match, report)
    everything, there = [], match.file.places.keys() - match.headless
    for sheet in match.declared.sheets:
        known = [word for word in declared(sheet) if word.block.name in there]
        found = list(standing(match, known))
        texts: dict[str, set[str]] = {}
        for word in known:
            texts.setdefault(word.text.style, set()).add(word.text.text)
        for one in found:
            first = match.file.places[one.word.block.name].cell(0, 0)
            if not first.column or (first.sheet, first.a1) not in named:  # column 0: the first one is gone
                judge(match, one, texts[one.word.text.style], report)
        unnamed(match, sheet, report)
        headings(match, sheet, report)
        everything += found
    return everything


def titles(match: Match, report: Report) -> None:
    """Enter sheets that are called as another of the book's own, and as notices those that are renamed."""
    declared = {sheet.title.casefold() for sheet in match.declared.sheets}
    for sheet in match.declared.sheets:
        held = sheet_of(match, sheet)
        if held is not None and held.casefold() != sheet.title.casefold():
            kind = SHOWN if held.casefold() in declared else NOTICE
            report.say(Address(held, 1, 1), kind, held, sheet.title, "the name of the sheet")


def sheet_of(match: Match, sheet: Sheet) -> str | None:
    """Return the sheet of the file that has the blocks of a declared one."""
    return next((match.file.places[b.name].sheet for b in sheet.blocks if b.name in match.file.places), None)


def declared(sheet: Sheet) -> Iterator[Word]:
    """Yield the texts of a sheet that say what its cells are."""
    rows = {b.row: b for b in sorted(sheet.blocks, key=lambda b: -b.column) if not b.is_table}
    tables = sorted((block for block in sheet.blocks if block.is_table), key=lambda block: block.row)
    for text in sheet.texts:
        if text.text and text.style in ABOVE:
            block = next((b for b in tables if 0 < b.row - text.row <= 4 and text.column in b.columns.values()), None)
            if block is not None:
                yield Word(text, block, f"{block.title}, {text.style}")
        elif text.text and text.style in ("label", "symbol", "unit", "note") and text.row in rows and not text.link:
            block = rows[text.row]
            if text.column in range(FIRST, block.column + 3):
                yield Word(text, block, f"{text.style} of {block.quantities[0].label}")


def standing(match: Match, known: Iterable[Word]) -> Iterator[Found]:
    """Yield where texts stand: all of a line above a table, and all of one column beside cells, moved alike.

    They are the nearest in which most of these texts are found, so that a right text elsewhere excuses no wrong one.
    """
    lines: dict[tuple[str, int], list[Word]] = {}
    for word in known:
        offset = word.text.row - word.block.row if word.above else word.text.column - word.block.column
        lines.setdefault((word.block.name if word.above else "", offset), []).append(word)
    for (_, offset), line in lines.items():
        furthest = MOST_BETWEEN + 4 if line[0].above else MOST_ASIDE
        aside = range(furthest) if offset > 0 else range(0, -furthest, -1)
        places = ([place(match, word, offset + more) for word in line] for more in aside)
        most = next((found for found in places if found and most_are_there(match, line, found)), None)
        for word, at in zip(line, most or [place(match, word, offset) for word in line], strict=True):
            if at.column > 0 and at.row > 0:
                yield Found(at, word)


def place(match: Match, word: Word, offset: int) -> Address:
    """Return the cell so many rows or columns away from that which a text belongs to."""
    block, held = word.block, match.file.places[word.block.name]
    if not word.above:
        return held.cell(0, offset)
    column = held.cell(0, word.text.column - block.column).column
    return Address(held.sheet, held.row + offset, column)


def most_are_there(match: Match, line: list[Word], found: list[Address]) -> bool:
    """Whether more than half of some texts stand in these cells."""
    there = sum(at.row > 0 and at.column > 0 and same(match.file.value(at), word.text.text)
                for word, at in zip(line, found, strict=True))  # fmt: skip
    return 2 * there > len(line)


def judge(match: Match, found: Found, others: set[str], report: Report) -> None:
    """Enter what is wrong with one text."""
    style, expected = found.word.text.style, found.word.text.text
    value = match.file.value(found.at)
    if same(value, expected):
        return
    held = "" if value is None else str(value)
    kind = reworded(held, expected, others)
    if style in ("unit", "units"):
        kind = unit_kind(style, held, expected, others)
    if kind == SHOWN or (kind == NOTICE and style not in QUIET):
        report.say(found.at, kind, held or None, expected, found.word.what)


def reworded(held: str, expected: str, others: Iterable[str]) -> str:
    """Return of which kind other words are: another's name misleads, and so do figures, translated words do not."""
    more = set(TELLING.findall(held)) - set(TELLING.findall(expected))
    return SHOWN if more or any(same(held, other) for other in others) else NOTICE


def unit_kind(style: str, held: str, expected: str, others: set[str]) -> str:
    """Return of which kind a changed unit is; a column's stands in brackets behind its symbol. Nothing for the same."""
    if style == "unit":
        return changed(held, expected, others)
    symbol, unit = parted(held)
    ours, expected = parted(expected)
    if symbol != ours and any(parted(other)[0] == symbol for other in others):
        return SHOWN
    found = changed(unit, expected, {parted(other)[1] for other in others})
    return NOTICE if not found and symbol != ours else found


def changed(held: str, expected: str, others: set[str]) -> str:
    """Return of which kind a changed unit is: one of the sheet's other units has changed places with it."""
    stands = units.compared(held, expected)
    if stands == "same":
        return ""
    exchanged = bool(held.strip()) and any(same(held, other) for other in others)
    return SHOWN if exchanged or stands == "other" else NOTICE


def unnamed(match: Match, sheet: Sheet, report: Report) -> None:
    """Enter a unit, or figures, beside a cell whose quantity has no unit."""
    named = {(text.row, text.column) for text in sheet.texts}
    for block in sheet.blocks:
        held, q = match.file.places.get(block.name), block.quantities[0]
        if block.is_table or held is None or q.role in ("check", "sentence") or (block.row, block.column + 1) in named:
            continue
        at = held.cell(0, 1)
        text = match.file.value(at)
        if isinstance(text, str) and at not in match.addresses and units.is_unit(text):
            report.say(at, SHOWN, text, None, f"unit of {q.label}")


def parted(text: str) -> tuple[str, str]:
    """Return symbol and unit of ``s [mm]``."""
    symbol, _, unit = text.partition("[")
    return " ".join(symbol.split()), unit.strip().removesuffix("]").strip()


def same(held: object, expected: str) -> bool:
    """Whether a cell holds a text, however its lines and spaces are broken."""
    return isinstance(held, str) and held.split() == expected.split()


def headings(match: Match, sheet: Sheet, report: Report) -> None:
    """Enter headings that stand over another part of their sheet, and as notices those that are gone."""
    title = sheet_of(match, sheet)
    if title is None:
        return
    sheets = {place.sheet for place in map(match.file.places.get, names_of(sheet)) if place}
    known = {name: rows_of(match, name) for name in sheets}
    blocks = sorted(sheet.blocks, key=lambda block: block.row)
    for text in sheet.texts:
        if text.style not in HEADINGS or not text.text:
            continue
        low, high = bounds(match, blocks, text.row)
        if leads(match, blocks, text, known):
            continue
        rows = known[title]
        held = rows.get(" ".join(text.text.split()), [])
        if len(held) <= sum(same(text.text, t.text) for t in sheet.texts if t.style not in HEADINGS):
            held = []  # what is there stands for something else
        if not any(low < row < high for row in held):
            at = Address(title, held[0] if held else max(low + 1, 1), text.column)
            found = "over another part" if held else None
            report.say(
                at, SHOWN if held else NOTICE, found, f"over {below(blocks, text.row)}", f"heading {text.text!r}"
            )


def names_of(sheet: Sheet) -> list[str]:
    """Return the names of a sheet's blocks."""
    return [block.name for block in sheet.blocks]


def leads(match: Match, blocks: list[Block], text: Text, known: dict[str, dict[str, list[int]]]) -> bool:
    """Whether a heading stands over the block that it is declared for, wherever they have been moved together."""
    block = next((b for b in blocks if b.row > text.row), None)
    place = match.file.places.get(block.name) if block is not None else None
    if place is None:
        return False
    others = [
        p.row for b in blocks if b is not block and (p := match.file.places.get(b.name)) and p.sheet == place.sheet
    ]
    above = [row for row in known[place.sheet].get(" ".join(text.text.split()), []) if row < place.row]
    return bool(above) and not any(above[-1] < row < place.row for row in others)


def bounds(match: Match, blocks: list[Block], row: int) -> tuple[int, float]:
    """Return the rows of the file between which a heading belongs: below the block before it, above the next."""
    places = match.file.places
    low = max((places[b.name].row for b in blocks if b.row < row and b.name in places), default=0)
    high = min((places[b.name].row for b in blocks if b.row > row and b.name in places), default=float("inf"))
    return low, high


def below(blocks: list[Block], row: int) -> str:
    """Return in words what stands below a row."""
    block = next((b for b in blocks if b.row > row), None)
    return "nothing" if block is None else block.title or block.quantities[0].label


def rows_of(match: Match, title: str) -> dict[str, list[int]]:
    """Return the rows in which each text of a sheet stands."""
    found: dict[str, list[int]] = {}
    for (row, _), cell in match.file.workbook[title]._cells.items():
        if cell.data_type == "s" and isinstance(cell.value, str):
            found.setdefault(" ".join(cell.value.split()), []).append(row)
    return found
