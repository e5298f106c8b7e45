"""The cells of a file that are cells of the declaration: by defined names and the blocks that they anchor."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from typing import Any, NamedTuple, Self

from workbook.book.address import Address, Place
from workbook.book.declare import Block, Book, Cell, Quantity, Sheet
from workbook.book.formula import Area, FormulaError, read
from workbook.book.rows import as_rows
from workbook.reading.files import BookFile, is_formula
from workbook.reading.table_fit import MOST_BETWEEN

Argument = Area | str
Arguments = list[tuple[Argument, Argument]]  # declared and held
Index = tuple[str, int, int]  # block, row and column of a cell
HEADING = -1  # the row of a table's headings, before its first


class Pair(NamedTuple):
    """A declared cell, where the file has it, and what the file holds there."""

    cell: Cell
    address: Address
    held: Any
    declared_formula: bool  # whether a formula belongs here

    @property
    def what(self) -> str:
        """The quantity in words, with its table and row."""
        q, block = self.cell.quantity, self.cell.block
        return f"{q.label} ({block.name}, row {self.cell.i + 1})" if block.is_table else q.label


@dataclass(repr=False)  # of a book with all its cells it would take gigabytes
class Match:
    """A file matched with a declaration, cell by cell."""

    file: BookFile
    declared: Book
    pairs: list[Pair] = field(default_factory=list)
    columns: list[list[Pair]] = field(default_factory=list)  # the same by columns of blocks

    def __post_init__(self) -> None:
        self.columns = self.columns or list(self._placed_columns())
        self.pairs += chain.from_iterable(self.columns)

    def _placed_columns(self) -> Iterator[list[Pair]]:
        """Yield the cells of each column of a block that the file has."""
        for block in self.declared.blocks.values():
            place = self.file.places.get(block.name)
            if place is None or block.name in self.file.torn:
                continue
            for j, column in enumerate(block.by_column()):
                cells = zip(column, place.down(j), strict=True)
                yield [Pair(c, at, self.file.value(at), is_formula(c.content)) for c, at in cells]

    def again(self, declared: Book, entered: Iterable[Address]) -> Self:
        """Return the match of the file with another declaration, after the cells ``entered`` got other values."""
        if layout_of(declared) != layout_of(self.declared):
            return type(self)(self.file, declared)
        touched, columns = {at[::2] for at in entered}, []
        for pairs, block, q, values in self.by_quantity(declared):
            if pairs[0].address[::2] in touched:
                pairs = [pair._replace(held=self.file.value(pair.address)) for pair in pairs]
            contents = values if q.formula is None else [pair.cell.content for pair in pairs]
            each = zip(pairs, contents, values, strict=True)
            columns.append([Pair(Cell(block, q, *old.cell[2:5], *both), *old[1:]) for old, *both in each])
        match = type(self)(self.file, declared, columns=columns)
        match.numbers = self.numbers
        return match

    def by_quantity(self, declared: Book) -> Iterator[tuple[list[Pair], Block, Quantity, list[Any]]]:
        """Yield the columns, each with its block, quantity and values in a declaration of the same layout."""
        for pairs in self.columns:
            cell = pairs[0].cell
            block = declared.blocks[cell.block.name]
            q = block.quantities[cell.column - cell.block.column]
            yield pairs, block, q, as_rows(q.value, block.size, q.name)

    def placed(self, sheet: Sheet) -> list[tuple[Block, Place]]:
        """Return the blocks of a declared sheet that the file has, with their places."""
        places = self.file.places
        return [(block, places[block.name]) for block in sheet.blocks if block.name in places]

    @cached_property
    def sheets(self) -> list[tuple[Sheet, str]]:
        """The declared sheets of which the file has blocks, each with the title of the sheet on which they are."""
        placed = ((sheet, self.placed(sheet)) for sheet in self.declared.sheets)
        return [(sheet, blocks[0][1].sheet) for sheet, blocks in placed if blocks]

    @cached_property
    def numbers(self) -> dict[Address, int]:
        """The place of each declared cell among ``pairs``."""
        return {pair.address: n for n, pair in enumerate(self.pairs)}

    def same_formula(self, content: str, block: Block, text: str, sheet: str) -> bool:
        """Whether the formula ``text`` on a sheet of the file means what ``content`` means in a declared block.

        Rows, columns and sheets may have moved.
        """
        if text == content:
            return True
        arguments = self._arguments(content, block, text, sheet)
        return arguments is not None and all(self.same(pair, other) for pair, other in arguments)

    def holds_formula(self, pair: Pair) -> bool:
        """Whether the formula in a cell means what its declared formula means."""
        content, block = pair.cell.content, pair.cell.block
        return self.same_formula(content, block, pair.held, pair.address.sheet)

    def _arguments(self, content: str, block: Block, text: str, sheet: str) -> Arguments | None:
        """Return the arguments of two formulas, declared and held, in pairs; None where these differ in shape."""
        try:
            declared = read(content, block.sheet.title, self.declared_area)
            held = read(text, sheet, self.file.contents.area)
        except FormulaError:
            return None
        alike = (declared.shape, declared.anchors) == (held.shape, held.anchors)
        return list(zip(declared.arguments, held.arguments, strict=True)) if alike else None

    def cells_read_elsewhere(self, pair: Pair) -> Iterator[tuple[Address, Address]]:
        """Yield the cells that a formula of the declared shape reads outside of all blocks: their places, and those."""
        content, block = pair.cell.content, pair.cell.block
        for our, other in self._arguments(content, block, pair.held, pair.address.sheet) or ():
            if isinstance(our, Area) and isinstance(other, Area):
                for ours, theirs in zip(corners(our), corners(other), strict=True):
                    name, i, j = self._declared_index.get(ours, ("", HEADING, 0))
                    place = self.file.places.get(name)
                    if i != HEADING and place and theirs not in self._held_index:
                        yield place.cell(i, j), theirs

    def declared_value(self, address: Address) -> Any:
        """Return the content of a declared cell, at its address in the declaration."""
        name, i, j = self._declared_index[address]
        block = self.declared.blocks[name]
        return as_rows(block.quantities[j].value, block.size, name)[i]

    def same(self, declared: Argument | None, held: Argument | None) -> bool:
        """Whether two arguments mean the same: every cell is named by its block and its place in the block."""
        if not isinstance(declared, Area) or not isinstance(held, Area):
            return declared == held
        are_alike = map(self._same_cell, corners(declared), corners(held))
        return declared.single == held.single and all(are_alike)

    def _same_cell(self, declared: Address, held: Address) -> bool:
        """Whether two cells have the same place in a block; a heading's is every text or gap just above its column."""
        ours = self._declared_index.get(declared, declared)
        name, row, column = ours
        if row != HEADING or name not in self.file.places:
            return ours == self._held_index.get(held, held)
        top = self.file.places[name].cell(0, column)
        is_above = top.row - MOST_BETWEEN <= held.row < top.row
        is_heading = is_above and held == top._replace(row=held.row)
        return is_heading and isinstance(self.file.value(held), str | None)

    @cached_property
    def _declared_index(self) -> dict[Address, Index]:
        places = [(block.name, declared_place(block)) for block in self.declared.blocks.values()]
        tables = [(name, place) for name, place in places if self.declared.blocks[name].is_table]
        columns = [(name, place, j) for name, place in tables for j in range(place.columns)]
        headings = {place.cell(HEADING, j): (name, HEADING, j) for name, place, j in columns}
        return headings | cell_index(places)

    @cached_property
    def labels(self) -> set[Address]:
        """The cells of the file that hold a text of its sheet as declared: at its place, if nothing has moved there."""
        labels, held = set[Address](), self.file.contents.constants.items()
        for sheet, title in self.sheets:
            texts = {Address(title, text.row, text.column): text.text for text in sheet.texts}
            words = {*texts.values()}
            if all(p[:4] == (title, b.row, b.column, b.size) for b, p in self.placed(sheet)):
                labels |= {at for at, text in held if texts.get(at) == text}
            else:
                labels |= {at for at, text in held if at.sheet == title and text in words}
        return labels

    def index_of(self, held: Address) -> Index | None:
        """Return the block, row and column of a cell of the file; None where it is of no block."""
        return self._held_index.get(held)

    @cached_property
    def _held_index(self) -> dict[Address, Index]:
        placed = (pair for sheet in self.declared.sheets for pair in self.placed(sheet))
        return cell_index((block.name, place) for block, place in placed)

    @cached_property
    def declared_area(self) -> Callable[[str, str], Area]:
        """The function for the area of a name in the declaration, whatever sheet it stands on, or ``title!``."""
        areas = {name.lower(): area for name, area in self.declared.areas().items()}

        def area(name: str, sheet: str) -> Area:
            if name.lower() not in areas:
                raise FormulaError("#NAME?", f"the name {name} does not lead to cells")
            return areas[name.lower()]

        return area


def layout_of(book: Book) -> list[tuple[Any, ...]]:
    """Return all on which the formulas of a book hang: the places of its blocks, and formulas as they are declared."""
    return [
        (
            name,
            block.sheet.title,
            block.row,
            block.column,
            block.size,
            block.seen,
            [q.formula for q in block.quantities],
        )
        for name, block in book.blocks.items()
    ]


def corners(area: Area) -> tuple[Address, Address]:
    """Return the first and the last cell of an area."""
    return area.first, Address(area.sheet, area.bottom, area.right)


def declared_place(block: Block) -> Place:
    """Return where the declaration has a block."""
    return Place(block.sheet.title, block.row, block.column, block.size, len(block.quantities))


def cell_index(places: Iterable[tuple[str, Place]]) -> dict[Address, Index]:
    """Return the place of every cell of the blocks."""
    columns = [(name, place, j) for name, place in places for j in range(place.columns)]
    return {at: (name, i, j) for name, place, j in columns for i, at in enumerate(place.down(j))}
