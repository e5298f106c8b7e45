"""Put entries in order in memory before a book is judged; each repair is a finding, and the file stays as it is.

Blanks around names go, names that look-ups misread are exchanged, empty rows are filled. A book from whose tables cells
were cut is refused: only who cut them knows what belongs where.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Block, Book
from workbook.entries import rules
from workbook.errors import ReadError
from workbook.fields.texts import LOOKED_UP, NO_NAME, PATTERN
from workbook.judging.comparison import ExpectedValues, differs
from workbook.judging.layout import table_titles
from workbook.judging.matching import Match
from workbook.judging.report import LAYOUT, NOTICE, Finding, Report
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile, is_formula

EMPTY = ", but below it"  # how the line on a row that was left empty ends


def repair_book(file: BookFile, layout: Book, model: type[BaseModel]) -> list[Finding]:
    """Put entries in order; return findings, and notices, on what was not. Raises ReadError for cells that were cut."""
    refuse_cut_cells(file, layout)
    if notices := [*repair_names(file, layout, model), *close_gaps(file, layout)]:
        file.mended = True
        file.__dict__.pop("contents", None)  # they are of the cells as they were
    return notices


def repair_names(file: BookFile, layout: Book, model: type[BaseModel]) -> Iterator[Finding]:
    """Trim names that formulas look up, and exchange those that look-ups take for a pattern or a value."""
    cells = {at: block for block in layout.blocks.values() for at in lookup_cells(file, block, model)}
    texts = {at: as_text(file.value(at)) for at in cells}
    for text in dict.fromkeys(texts.values()):
        if (name := usable_name(text, set(texts.values()))) == text:
            continue
        trimmed = name == text.strip()
        kind = NOTICE if trimmed and name not in texts.values() else "entry"
        expected = f"{name!r}, without blanks around it" if trimmed else f"a name that look-ups find, such as {name!r}"
        for at in (at for at, held in texts.items() if held == text):
            set_value(file, at, name)
            yield Finding(at.sheet, at.a1, kind, repr(text), expected, cells[at].title or cells[at].quantities[0].label)
        file.saved |= {at: v.replace(text, name) for at, v in file.saved.items() if isinstance(v, str)}


def lookup_cells(file: BookFile, block: Block, model: type[BaseModel]) -> Iterator[Address]:
    """Yield the cells of a block in which a name is entered that formulas look up."""
    if (place := file.places.get(block.name)) is None:
        return
    for j, q in enumerate(block.quantities):
        if q.role != "input" or not place.cell(0, j).column:
            continue
        constraints: Sequence[Any] = ()
        with suppress(KeyError, AttributeError, IndexError):  # of a law, by the name of its sheet
            constraints = rules.field_at(model, q.key)[1]
        if LOOKED_UP in constraints:
            yield from (at for at in place.down(j) if as_text(file.value(at)))


def as_text(held: Any) -> str:
    """Return the text that is entered as a name: a number as its digits; nothing for a formula or an empty cell."""
    if is_formula(held) or isinstance(held, bool) or held is None:
        return ""
    return held if isinstance(held, str) else f"{held:.15g}"


def usable_name(text: str, others: set[str]) -> str:
    """Return a name as look-ups find it again: itself where they do, trimmed, or a name that is none of the others."""
    name = "".join("_" if sign in PATTERN else sign for sign in text.strip())
    changed = name != text.strip()
    while NO_NAME.fullmatch(name) or (changed and name in others):
        name, changed = f"{name}_", True
    return name


def close_gaps(file: BookFile, layout: Book) -> Iterator[Finding]:
    """Move entries up over rows of their tables that were left empty."""
    for block in layout.blocks.values():
        place = file.places.get(block.name)
        columns = [j for j, q in enumerate(block.quantities) if q.role == "input" and "*" in q.key]
        if place is None or not columns or not all(place.cell(0, j).column for j in columns):
            continue
        rows = [[file.value(place.cell(i, j)) for j in columns] for i in range(place.rows)]
        used = [i for i, row in enumerate(rows) if any(value is not None for value in row)]
        if used == list(range(len(used))) or any(is_formula(value) for row in rows for value in row):
            continue
        for i in range(place.rows):
            for j, value in zip(columns, rows[used[i]] if i < len(used) else [None] * len(columns), strict=True):
                set_value(file, place.cell(i, j), value)
        file.saved = {at: value for at, value in file.saved.items() if at.sheet != place.sheet}
        empty = next(i for i in range(place.rows) if i not in used)
        at, message = place.cell(empty, columns[0]), f"nothing is entered in row {empty + 1} of the table {block.name}"
        yield Finding(at.sheet, at.a1, NOTICE, f"{message}{EMPTY}", "fill it, or move up what is below", block.title)


def set_value(file: BookFile, at: Address, value: Any) -> None:
    """Enter a value into a cell of the copy that is judged."""
    cell = file.workbook[at.sheet].cell(at.row, at.column)
    cell._value, cell.data_type = value, "s" if isinstance(value, str) else "n"  # type: ignore[union-attr]


def report_wrong_results(before: Cells, match: Match, ordered: Cells, report: Report) -> None:
    """Enter a finding in place of a notice on an empty row where results are others than with the rows moved up."""
    right = ExpectedValues(match, match.declared)
    single = (p.address for p in match.pairs if p.declared_formula and not p.cell.block.is_table)
    wrong = [a for a in single if differs(right, a, before.get(a)) and not differs(right, a, ordered.get(a))]
    for notice in [notice for notice in report.notices if is_empty_row(notice)] if wrong else ():
        report.notices.remove(notice)
        expected = f"{notice.expected}: by it {len(wrong)} results are wrong, {wrong[0]} the first"
        report.findings.append(replace(notice, kind=LAYOUT, expected=expected))


def is_empty_row(notice: Finding) -> bool:
    """Whether a finding tells of a row that was left empty before others."""
    return str(notice.computed).endswith(EMPTY)


# Cells that were cut from a table


def refuse_cut_cells(file: BookFile, layout: Book) -> None:
    """Raise ReadError where cells of a table were cut and pasted elsewhere: what, from where, to where.

    Formulas follow the cells that they read: a cell that has the declared shape and leads out of all tables, at a place
    whose own cell is empty, says where that is now.
    """
    match = Match(file, layout)
    empty = {p.address: p for p in match.pairs if p.held is None}
    ways = defaultdict[tuple[str, str, int, int], set[Address]](set)
    for pair in (p for p in match.pairs if p.declared_formula and p.held != p.cell.content) if empty else ():
        for (name, i, j), there in match.differing_corners(pair) if match.leads_out(pair.address) else ():
            place = match.file.places.get(name)
            home = place.cell(i, j) if place is not None and i >= 0 else None
            if home in empty and isinstance(there, Address) and is_filled(match, there):
                ways[name, there.sheet, there.row - home.row, there.column - home.column].add(home)
    for (name, sheet, down, right), homes in ways.items():
        rows, columns = [at.row for at in homes], [at.column for at in homes]
        home_sheet = next(iter(homes)).sheet
        first, last = (Address(home_sheet, end(rows), end(columns)) for end in (min, max))
        pasted = [Address(sheet, at.row + down, at.column + right) for at in (first, last)]
        raise ReadError(
            f"{file.path}: {first}:{last.a1} of {table_titles([layout.blocks[name]])} was cut, and pasted to "
            f"{pasted[0]}:{pasted[1].a1}; expected all cells of a table in their places: cut and paste them back"
        )


def is_filled(match: Match, address: Address) -> bool:
    """Whether a cell holds anything, and is none of the declared ones."""
    exists = address.sheet in match.file.workbook.sheetnames and address not in match.numbers
    return exists and address.row > 0 and address.column > 0 and match.file.value(address) is not None
