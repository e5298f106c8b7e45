"""Labels, symbols, units and headings: whether each cell is still called what it is."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, NamedTuple

from workbook.book.address import Address, Place
from workbook.book.declare import FIRST, Block, Sheet, Text
from workbook.judging.matching import MOST_BETWEEN, Match
from workbook.judging.report import LAYOUT, NOTICE, Report
from workbook.judging.shown import units

Kind = Literal["label", "symbol", "unit", "header", "units", "equation", "note"]
ABOVE = ("header", "units", "equation")
QUIET = ("equation", "note")  # reworded, these are nobody's concern; exchanged, they are
HEADINGS = ("heading", "subheading")
NEAR = 4  # cells to the right in which a unit is looked for, should a column have been inserted


class Word(NamedTuple):
    """A declared text that says what a cell is: of a row, or of a column of a table."""

    text: Text
    block: Block
    what: str


def words(match: Match, report: Report) -> None:
    """Enter texts that say something else of a cell, and as notices those that are reworded or gone."""
    named = {(f.sheet, f.cell) for f in report.findings if f.kind == "name"}
    for name in match.headless:
        at = match.file.places[name].cell(0, 0)
        report.say(at, LAYOUT, "no headings", "its headings above it: move them together", f"the table {name}")
    titles(match, report)
    for sheet in match.declared.sheets:
        known = [word for word in declared(sheet) if word.block.name in match.file.places.keys() - match.headless]
        texts: dict[str, set[str]] = {}
        for word in known:
            texts.setdefault(word.text.style, set()).add(word.text.text)
        for word in known:
            place = match.file.places[word.block.name]
            first = place.cell(0, 0)
            if not first.column or (place.sheet, first.a1) not in named:  # column 0: the first one is gone
                judge(match, word, place, texts[word.text.style], report)
        headings(match, sheet, report)


def titles(match: Match, report: Report) -> None:
    """Enter sheets that are called as another of the book's own, and as notices those that are renamed."""
    declared = {sheet.title.casefold() for sheet in match.declared.sheets}
    for sheet in match.declared.sheets:
        held = sheet_of(match, sheet)
        if held is not None and held.casefold() != sheet.title.casefold():
            kind = "shown" if held.casefold() in declared else NOTICE
            report.say(Address(held, 1, 1), kind, held, sheet.title, "the name of the sheet")


def sheet_of(match: Match, sheet: Sheet) -> str | None:
    """Return the sheet of the file that has the blocks of a declared one."""
    return next((match.file.places[b.name].sheet for b in sheet.blocks if b.name in match.file.places), None)


def declared(sheet: Sheet) -> Iterator[Word]:
    """Yield the texts of a sheet that say what its cells are."""
    rows = {block.row: block for block in sheet.blocks if not block.is_table}
    tables = sorted((block for block in sheet.blocks if block.is_table), key=lambda block: block.row)
    for text in sheet.texts:
        if text.text and text.style in ABOVE:
            block = next(
                (b for b in tables if 0 < b.row - text.row <= NEAR and text.column in b.columns.values()), None
            )
            if block is not None:
                yield Word(text, block, f"{block.title}, {text.style}")
        elif text.text and text.style in ("label", "symbol", "unit", "note") and text.row in rows and not text.link:
            block = rows[text.row]
            if text.column in range(FIRST, block.column + 3):
                yield Word(text, block, f"{text.style} of {block.quantities[0].label}")


def judge(match: Match, word: Word, place: Place, others: set[str], report: Report) -> None:
    """Enter what is wrong with one text."""
    style, expected = word.text.style, word.text.text
    near = around(match, word, place)
    if style in ABOVE and not near[0].column:  # the column is gone, which is told
        return
    if any(same(match.file.value(at), expected) for at in near):
        return
    held = match.file.value(near[0])
    found = "" if held is None else str(held)
    kind = NOTICE
    if style in ("unit", "units"):
        kind = unit_kind(style, found, expected, others)
    elif any(same(found, other) for other in others):
        kind = "shown"
    if kind == "shown" or (kind == NOTICE and style not in QUIET):
        report.say(near[0], kind, found or None, expected, word.what)


def unit_kind(style: str, found: str, expected: str, others: set[str]) -> str:
    """Return of which kind a changed unit is; a column's stands in brackets behind its symbol. Nothing for the same."""
    if style == "units":
        symbol, unit = parted(found)
        ours, expected = parted(expected)
        if symbol != ours and any(parted(other)[0] == symbol for other in others):
            return "shown"
        stands = standing(unit, expected, {parted(other)[1] for other in others})
        return NOTICE if not stands and symbol != ours else stands
    return standing(found, expected, others)


def standing(found: str, expected: str, others: set[str]) -> str:
    """Return of which kind a changed unit is: one of the sheet's other units has changed places with it."""
    stands = units.compared(found, expected)
    if stands == "same":
        return ""
    exchanged = bool(found.strip()) and any(same(found, other) for other in others)
    return "shown" if exchanged or stands == "other" else NOTICE


def parted(text: str) -> tuple[str, str]:
    """Return symbol and unit of ``s [mm]``."""
    symbol, _, unit = text.partition("[")
    return " ".join(symbol.split()), unit.strip().removesuffix("]").strip()


def around(match: Match, word: Word, place: Place) -> list[Address]:
    """Return where a text may stand: first where it stood, then where inserted rows or columns have moved it."""
    text, block = word.text, word.block
    at = place.cell(text.row - block.row, text.column - block.column)
    if text.style in ABOVE:
        up = range(1, min(MOST_BETWEEN + NEAR, place.row))
        return [at, *(Address(place.sheet, place.row - n, at.column) for n in up)] if at.row > 0 else [place.cell(0, 0)]
    if text.column < block.column:
        left = [Address(place.sheet, place.row, column) for column in range(1, place.column)]
        return [at, *left] if at.column > 0 else [*left, place.cell(0, 0)]
    return [at, *(place.cell(0, n) for n in range(1, NEAR + 1))]


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
                at, "shown" if held else NOTICE, found, f"over {below(blocks, text.row)}", f"heading {text.text!r}"
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
