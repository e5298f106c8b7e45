"""Rows and columns inserted into a table or deleted from it, sought by row numbers, formulas and headings."""

from collections.abc import Callable, Sequence

from workbook.book.address import Address, Fit, Place
from workbook.book.declare import Block, Book
from workbook.book.formula import area_of
from workbook.book.limits import MESSAGES
from workbook.book.rows import as_rows
from workbook.reading.files import BookFile

LOOKED_AT = 30  # rows of a table, where its columns are distinguished
HEADER = 12  # rows above a table in which its headings are looked for


def changed_tables(file: BookFile, layout: Book) -> dict[str, Fit]:
    """Return the fit of each table with inserted or deleted rows or columns; a single cell that grew is its first."""
    fits: dict[str, Fit] = {}
    for name, block in layout.blocks.items():
        place = file.places.get(name)
        if place is None or name in file.fits:
            continue
        if not block.is_table:
            if place.rows * place.columns > 1:
                fits[name] = Fit(place._replace(rows=1, columns=1), named=place)
        else:
            measured = with_lost_end(block, in_rows_of_lead(file, block, fit_table(file, block, place), fits))
            if measured.inserted or measured.added or measured.lost or measured.gone:
                fits[name] = measured
    return fits


def in_rows_of_lead(file: BookFile, block: Block, measured: Fit, fits: dict[str, Fit]) -> Fit:
    """Return the fit of a table without row numbers: it has the rows of the table that it stands beside."""
    lead = block.lead
    if lead is None or lead.name not in fits or numbering_column(block) is not None:
        return measured
    place, beside = file.places[block.name], file.places[lead.name]
    if (place.sheet, place.row, place.rows) != (beside.sheet, beside.row, beside.rows):
        return measured
    fit = fits[lead.name]
    own = measured.place._replace(rows=fit.place.rows, rows_at=fit.place.rows_at)
    return measured._replace(place=own, inserted=fit.inserted, lost=fit.lost)


def with_lost_end(block: Block, measured: Fit) -> Fit:
    """Return the fit of a table, with the rows that a table of entries lacks at its end among those it has lost.

    How long such a table was is known before anything is read; other tables may be declared shorter then.
    """
    missing = block.size - measured.size
    if missing <= 0 or not any(q.role == "input" for q in block.quantities):
        return measured
    behind = measured.place.cell(measured.place.rows - 1, 0).row + 1
    return measured._replace(lost=(*measured.lost, (behind, missing)))


def fit_table(file: BookFile, block: Block, place: Place) -> Fit:
    """Return the fit of a table in ``place``, to which its name leads."""
    columns = range(place.columns) if place.columns == len(block.quantities) else matched_columns(file, block, place)
    own = place._replace(columns=len(columns), columns_at=() if isinstance(columns, range) else tuple(columns))
    rows, lost = own_rows(file, block, own)
    fitted = own if len(rows) == place.rows else own._replace(rows=len(rows), rows_at=tuple(rows))
    return Fit(
        fitted,
        tuple(place.row + r for r in range(place.rows) if r not in set(rows)),
        tuple(place.column + c for c in range(place.columns) if c not in set(columns)),
        tuple((place.row + r, count) for r, count in lost),
        tuple(j for j, c in enumerate(columns) if c is None),
    )


def own_rows(file: BookFile, block: Block, place: Place) -> tuple[Sequence[int], list[tuple[int, int]]]:
    """Return which rows of a place are the table's own, and before which of them so many rows are gone."""
    j, rows = numbering_column(block), range(place.rows)
    formulas = [k for k, q in enumerate(block.quantities) if q.formula is not None and place.cell(0, k).column]
    if j is None or not place.cell(0, j).column:
        spots = [(place, k) for k in formulas]
        beside = None if spots else file.places.get(f"{block.name}{MESSAGES}")  # messages of the same rows
        if beside and (beside.sheet, beside.row, beside.rows) == (place.sheet, place.row, place.rows):
            spots = [(beside, k) for k in range(beside.columns)]
        own = [r for r in rows if not spots or any(holds_formula(file, where.cell(r, k)) for where, k in spots)]
        return (own if 2 * len(own) > place.rows else rows), []
    first = as_rows(block.quantities[j].value, block.size, block.name)[0]
    held_there = (file.value(place.cell(r, j)) for r in rows)
    numbers = [int(x) if type(x) in (int, float) and x % 1 == 0 else None for x in held_there]
    if numbers == list(range(first, first + place.rows)):
        return rows, []
    empty = [not any(holds_formula(file, place.cell(r, k)) for k in formulas) for r in rows]
    return rows_by_numbers(numbers, empty, first, lambda r: row_referred_to(file, place, r)) or (rows, [])


def rows_by_numbers(
    numbers: Sequence[int | None], empty: Sequence[bool], first: int, leads_up: Callable[[int], int | None]
) -> tuple[list[int], list[tuple[int, int]]] | None:
    """Return :func:`own_rows` by the rows' numbers from ``first``; None if they do not say. ``empty`` lack formulas."""
    own: list[int] = []
    aside: list[int] = []
    lost: list[tuple[int, int]] = []
    last = first - 1
    for r, number in enumerate(numbers):
        if number is not None and number > last:
            missing = number - last - 1
            if missing and missing == len(aside):
                own += aside  # emptied, not inserted
            elif missing:
                lost.append((r, missing))
            own.append(r)
            last, aside = number, []
        elif number is not None and own and number == last:
            if any(leads_up(below) == r for below in range(r + 1, min(r + 2, len(numbers)))):
                own[-1] = r  # the copy was put above it
        elif number is None and empty[r]:
            aside.append(r)
        else:
            return None
    return own, lost


def row_referred_to(file: BookFile, place: Place, r: int) -> int | None:
    """Return the row of a place above row ``r`` to which single references in its formulas lead."""
    own = area_of(place)
    for j in range(place.columns):
        formula = file.contents.formulas.get(place.cell(r, j))
        for area in formula.arguments if formula is not None else ():
            if not isinstance(area, str) and area.single and own.holds(area.first) and area.top < place.row + r:
                return area.top - place.row
    return None


def numbering_column(block: Block) -> int | None:
    """Return the column in which a table numbers its rows, if any."""
    for j, q in enumerate(block.quantities):
        if q.role not in ("input", "check") and q.formula is None and block.size > 1:
            values = as_rows(q.value, block.size, block.name)
            if isinstance(values[0], int) and values == list(range(values[0], values[0] + block.size)):
                return j
    return None


def holds_formula(file: BookFile, address: Address) -> bool:
    """Whether a cell holds a formula."""
    cell = file.cell(address)
    return cell is not None and cell.data_type == "f"


def matched_columns(file: BookFile, block: Block, place: Place) -> list[int | None]:
    """Return for each declared column its number in the place, None where it is gone; their order stays."""
    names = {
        column: {t.text for t in block.sheet.texts if t.column == column and 0 < block.row - t.row <= 4 and t.text}
        for column in block.columns.values()
    }
    ups = range(1, min(HEADER, place.row))
    cells = [[Address(place.sheet, place.row - up, place.column + c) for up in ups] for c in range(place.columns)]
    above = [{text for text in map(file.value, column) if isinstance(text, str)} for column in cells]
    rows = range(place.row, place.row + min(place.rows, LOOKED_AT))
    kinds = [
        sum(holds_formula(file, Address(place.sheet, row, place.column + c)) for row in rows) / len(rows)
        for c in range(place.columns)
    ]  # the share of formulas in each column
    likes = [
        [2 * len(names[column] & above[c]) + 1 - abs((q.formula is not None) - share) for c, share in enumerate(kinds)]
        for q, column in zip(block.quantities, block.columns.values(), strict=True)
    ]
    best: list[list[tuple[float, tuple[int | None, ...]]]] = [[(0.0, ())] * (place.columns + 1)]
    for j, row in enumerate(likes):
        line = [(best[j][0][0], (*best[j][0][1], None))]
        for c in range(place.columns):
            taken, skipped, gone = best[j][c], line[c], best[j][c + 1]
            line.append(
                max((taken[0] + row[c], (*taken[1], c)), skipped, (gone[0], (*gone[1], None)), key=lambda way: way[0])
            )
        best.append(line)
    return list(best[-1][-1][1])
