"""The tables of a file, held against its layout: whole, with rows or columns put in, or torn.

A table is whole if its name leads to its rows and columns, and its headings stand above it. Rows in which nothing but
entries stands, and columns without a heading of the table, were put in. Every other table is torn, which is the
user's to undo.
"""

import math
from collections import defaultdict
from collections.abc import Container

from openpyxl.utils import get_column_letter

from workbook.book.address import Address
from workbook.book.declare import Block, Book
from workbook.book.rows import as_rows, is_number
from workbook.errors import listed
from workbook.reading.files import BookFile

MOST_BETWEEN = 10  # rows that someone may have put between a table's headings and its first row
HEADER_ROWS = range(1, 4)  # above a table, where its headings are declared
LAST_DIGITS = 1e-9  # of a number that numbers rows
UNDO = "undo that, or take the table from a copy"


def fit_tables(file: BookFile, layout: Book) -> None:
    """Take rows and columns that were put into tables out of their places, and enter the tables that are torn."""
    beside = defaultdict[tuple[str, int, int, int], list[Block]](list)
    for name, block in layout.blocks.items():
        place = file.places.get(name)
        if place is None:
            file.torn[name] = f"{block.sheet.title}: cells are gone, or have no name"
        elif block.is_table:
            beside[place.sheet, place.row, place.rows, block.size].append(block)
        elif (count := place.rows * place.columns) > 1:
            file.torn[name] = f"{place.cell(0, 0)}: {count} cells have a name that is of 1"
    for blocks in beside.values():
        for block in blocks:
            fit_columns(file, block)
        if whole := [block for block in blocks if block.name not in file.torn]:
            fit_rows(file, whole)


def fit_rows(file: BookFile, blocks: list[Block]) -> None:
    """Take inserted rows out of the places of tables that share rows; enter as torn those of other numbers of rows."""
    place, size = file.places[blocks[0].name], blocks[0].size
    if place.rows == size:
        return
    computed = [(b, j) for b in blocks for j, q in enumerate(b.quantities) if q.role != "input"]
    columns = [map(file.value, file.places[b.name].down(j)) for b, j in computed]
    rows = zip(*columns, strict=True)
    own = [i for i, row in enumerate(rows) if any(value not in (None, "") for value in row)]
    own = own if place.rows > size else list(range(place.rows))
    missing, row = size - len(own), place.row + first_other_row(file, blocks, own)
    for block in blocks:
        if missing:
            state = f"gone above row {row}" if missing > 0 else f"too many at row {row}"
            count = "a row is" if abs(missing) == 1 else f"{abs(missing)} rows are"
            file.torn[block.name] = f"{place.sheet}: {count} {state}"
        else:
            whole = file.places[block.name]._replace(rows=len(own), rows_at=tuple(own))
            file.places[block.name] = whole
            inserted = sorted({*range(place.rows)} - {*own})
            file.inserted[block.name] = tuple(place.row + i for i in inserted)


def first_other_row(file: BookFile, blocks: list[Block], own: list[int]) -> int:
    """Return the first of the ``own`` rows of tables that has another number than declared; else the row behind."""
    numbers = [
        (file.places[block.name].down(j), as_rows(q.value, block.size, block.name))
        for block in blocks
        for j, q in enumerate(block.quantities)
        if q.role != "input" and q.formula is None
    ]
    for k, i in enumerate(own[: blocks[0].size]):
        for held, declared in ((file.value(cells[i]), values[k]) for cells, values in numbers):
            both = is_number(declared) and is_number(held)
            if both and not math.isclose(held, declared, rel_tol=LAST_DIGITS, abs_tol=LAST_DIGITS):
                return i
    return own[-1] + 1 if own else 0


def fit_columns(file: BookFile, block: Block) -> None:
    """Take columns that were put in out of a table's place; enter a table without columns, or without headings."""
    place, added = file.places[block.name], file.places[block.name].columns - len(block.quantities)
    labels = declared_headers(block)
    heads = (place.cell(-up, j) for up in HEADER_ROWS for j in range(len(labels)))
    if not added and (not any(labels) or any(isinstance(file.value(at), str) for at in heads)):
        return
    furthest = block.row - min(header_rows(block)) + MOST_BETWEEN
    rows = range(place.row - furthest, place.row)
    columns = range(place.column, place.column + place.columns)
    above = [{file.value(Address(place.sheet, row, c)) for row in rows} for c in columns]
    inserted = [c for c, texts in enumerate(above) if not texts & set(labels)]
    if added > 0 and len(inserted) == added:
        own = tuple(c for c in range(place.columns) if c not in inserted)
        file.places[block.name] = place._replace(columns=len(labels), columns_at=own)
    elif added > 0:
        file.torn[block.name] = f"{place.sheet}: {added} columns are too many"
    elif added < 0:
        differ = [label not in texts for label, texts in zip(labels, above, strict=False)]
        at = differ.index(True) if any(differ) else place.columns
        letter = get_column_letter(place.column + at)
        gone = ", ".join(map(repr, labels[at : at - added]))
        file.torn[block.name] = f"{place.sheet}: a column is gone before column {letter}: {gone}"
    elif len(inserted) == place.columns:
        file.torn[block.name] = f"{place.cell(0, 0)}: no headings stand above the table"


def declared_headers(block: Block) -> list[str]:
    """Return the heading of each column of a table, as declared; nothing for a column without."""
    rows = header_rows(block)
    texts = (text for text in block.sheet.texts if text.style == "header" and text.row in rows)
    headers = {text.column: text.text for text in texts}
    return [headers.get(block.column + j, "") for j in range(len(block.quantities))]


def header_rows(block: Block) -> list[int]:
    """Return the rows in which headings of a table may be declared: its own, or those of a like table above."""
    return [block.shared_heads] if block.shared_heads else [block.row - up for up in HEADER_ROWS]


def tear_lines(file: BookFile, names: Container[str]) -> list[str]:
    """Return in a line each where tables of these names are torn, what is gone, and what to do."""
    tables = defaultdict[str, list[str]](list)
    for name, tear in file.torn.items():
        if name in names:
            tables[tear].append(name)
    return [f"{file.path.name}: {tear}, of {listed(torn)}; {UNDO}" for tear, torn in tables.items()]
