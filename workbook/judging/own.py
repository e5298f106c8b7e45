"""What an engineer has added to a book and can be taken into a new one: where its place and what it refers to stay."""

from collections.abc import Iterator
from typing import Any

from openpyxl.cell.cell import Cell
from openpyxl.workbook.defined_name import DefinedName

from workbook.book.address import Address
from workbook.book.declare import Book, Sheet
from workbook.judging.matching import Match
from workbook.reading.contents import Contents
from workbook.reading.files import BookFile
from workbook.writing.own import Own


def carried_over(match: Match, fresh: Book) -> Own:
    """Return what of a matched file beside its declared cells is taken into a fresh book of the same inputs."""
    file = match.file
    ours = {pair.address.sheet for pair in match.pairs}
    own = [sheet for sheet in file.workbook.worksheets if sheet.title not in ours | {s.title for s in fresh.sheets}]
    steady = {sheet.title for sheet in fresh.sheets if stays(file, sheet)}
    known = steady | {sheet.title for sheet in own}
    taken = {(a.sheet, a.row, a.column) for a in match.addresses} | set(occupied(fresh))
    cells = [cell for sheet in file.workbook.worksheets if sheet.title in known for cell in sheet._cells.values()
             if isinstance(cell, Cell)]  # fmt: skip
    free = [cell for cell in cells if (cell.parent.title, cell.row, cell.column) not in taken]
    held = [(cell, content) for cell in free if (content := content_of(file.contents, cell, known)) is not None]
    notes = [cell for cell in cells if cell.comment is not None]
    return Own(tuple(own), tuple(held), tuple(notes), tuple(names(match, known)))


def stays(file: BookFile, sheet: Sheet) -> bool:
    """Whether the blocks of a fresh sheet lie in the file where a fresh build has them."""
    found = [(file.places.get(block.name), block) for block in sheet.blocks]
    return all(
        place is not None and place[:4] == (sheet.title, block.row, block.column, block.size) for place, block in found
    )


def occupied(book: Book) -> Iterator[tuple[str, int, int]]:
    """Yield the cells of a book in which something stands."""
    yield from ((cell.block.sheet.title, cell.row, cell.column) for cell in book.cells())
    yield from ((sheet.title, text.row, text.column) for sheet in book.sheets for text in sheet.texts if text.text)


def content_of(contents: Contents, cell: Cell, known: set[str]) -> Any:
    """Return what a cell holds; None for nothing, and for a formula that refers to other sheets than the known."""
    address = Address(cell.parent.title, cell.row, cell.column)
    if cell.data_type != "f":
        return contents.constants.get(address)
    formula = contents.formulas.get(address)
    if formula is None or address in contents.arrays:
        return None
    sheets = {area.sheet for area in formula.arguments if not isinstance(area, str)}
    return cell.value if sheets <= known else None


def names(match: Match, known: set[str]) -> Iterator[DefinedName]:
    """Yield the names of one's own that lead to cells of known sheets."""
    declared = {name.casefold() for name, _ in match.declared.names()}
    for name, defined in match.file.workbook.defined_names.items():
        if name.casefold() not in declared and not name.startswith("_xl"):
            sheets = {title for title, _ in defined.destinations}
            if sheets and sheets <= known:
                yield defined
