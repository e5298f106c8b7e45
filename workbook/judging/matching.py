"""The cells of a file that are cells of the declaration: by defined names and the blocks that they anchor."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from typing import Any, NamedTuple

from workbook.book.address import Address, Place
from workbook.book.declare import Block, Book, Cell, Sheet
from workbook.book.formula import Area, FormulaError, read
from workbook.book.rows import as_rows
from workbook.reading.files import BookFile, is_formula

Argument = Area | str
Index = tuple[str, int, int]  # block, row and column of a cell
MOST_BETWEEN = 10  # rows that someone may have put between a header and its table
HEAD = range(1, 4)  # how far above a table its headings are declared


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


@dataclass
class Match:
    """A file matched with a declaration, cell by cell."""

    file: BookFile
    declared: Book
    pairs: list[Pair] = field(default_factory=list)
    misfits: list[tuple[Block, Place | None]] = field(default_factory=list)  # blocks gone, or of another size there
    columns: list[list[Pair]] = field(default_factory=list)  # the same by columns of blocks

    def __post_init__(self) -> None:
        for block in self.declared.blocks.values():
            place = self.file.places.get(block.name)
            if place is None or (self.size_of(block), place.columns) != (block.size, len(block.quantities)):
                self.misfits.append((block, place))
            if place is None:
                continue
            for j, cells in enumerate(block.by_column()):
                if j < place.columns and place.rows and place.cell(0, j).column:
                    addresses = zip(cells, place.down(j), strict=False)  # either may have more rows
                    self.columns.append(
                        [Pair(cell, at, self.file.value(at), is_formula(cell.content)) for cell, at in addresses]
                    )
        self.pairs += chain.from_iterable(self.columns)

    def placed(self, sheet: Sheet) -> list[tuple[Block, Place]]:
        """Return the blocks of a declared sheet that the file has, with their places."""
        return [(block, self.file.places[block.name]) for block in sheet.blocks if block.name in self.file.places]

    @cached_property
    def sheets(self) -> list[tuple[Sheet, str]]:
        """The declared sheets of which the file has blocks, each with the title of the sheet on which they are."""
        return [(sheet, placed[0][1].sheet) for sheet in self.declared.sheets if (placed := self.placed(sheet))]

    def size_of(self, block: Block) -> int:
        """Return how many rows a block had in the file, those counted that are gone."""
        fit = self.file.fits.get(block.name)
        return fit.size if fit is not None else self.file.places[block.name].rows

    @cached_property
    def numbers(self) -> dict[Address, int]:
        """The place of each declared cell among ``pairs``."""
        return {pair.address: n for n, pair in enumerate(self.pairs)}

    def same_shape(self, pair: Pair) -> bool:
        """Whether a formula of the file is as declared, wherever rows, columns or sheets have moved to."""
        if pair.held == pair.cell.content:
            return True
        return self.same_formula(pair.cell.content, pair.cell.block, pair.held, pair.address.sheet)

    def same_formula(self, content: str, block: Block, text: str, sheet: str) -> bool:
        """Whether the formula ``text`` on a sheet of the file means what ``content`` means in a declared block."""
        arguments = self._arguments(content, block, text, sheet)
        return arguments is not None and all(self.same(pair, other) for pair, other in arguments)

    def _arguments(self, content: str, block: Block, text: str, sheet: str) -> list[tuple[Argument, Argument]] | None:
        """Return the arguments of two formulas, declared and held, in pairs; None where these differ in shape."""
        try:
            declared = read(content, block.sheet.title, self.declared_area)
            held = read(text, sheet, self.file.contents.area)
        except FormulaError:
            return None
        alike = (declared.shape, declared.anchors) == (held.shape, held.anchors)
        return list(zip(declared.arguments, held.arguments, strict=True)) if alike else None

    def differing_corners(self, pair: Pair) -> Iterator[tuple[Index, Index]]:
        """Yield the corners by which a formula of the declared shape differs: declared, and held."""
        for our, other in self._arguments(pair.cell.content, pair.cell.block, pair.held, pair.address.sheet) or ():
            if not isinstance(our, str) and not isinstance(other, str) and not self.same(our, other):
                for ours, theirs in zip(corners(our), corners(other), strict=True):
                    yield self._declared_index.get(ours, ours), self._held_index.get(theirs, theirs)

    def leads_out(self, address: Address) -> bool:
        """Whether the formula in a cell of the file begins or ends a reference at a cell of no block."""
        formula = self.file.contents.formulas.get(address)
        areas = (
            (argument for argument in formula.arguments if isinstance(argument, Area)) if formula is not None else ()
        )
        return any(corner not in self._held_index for area in areas for corner in corners(area))

    def lost(self, area: Area | None) -> bool:
        """Whether the file has not the column that a declared area is."""
        name, _, j = self._declared_index[area.first] if area is not None else ("", 0, 0)
        return name not in self.file.places or not self.file.places[name].cell(0, j).column

    def declared_value(self, address: Address) -> Any:
        """Return the content of a declared cell, at its address in the declaration."""
        name, i, j = self._declared_index[address]
        block = self.declared.blocks[name]
        return as_rows(block.quantities[j].value, block.size, name)[i]

    def same(self, declared: Area | str | None, held: Area | str | None) -> bool:
        """Whether two arguments mean the same: every cell is named by its block and its place in the block."""
        if not isinstance(declared, Area) or not isinstance(held, Area):
            return declared == held
        ours, theirs = (
            [index.get(corner, corner) for corner in corners(area)]
            for area, index in ((declared, self._declared_index), (held, self._held_index))
        )
        single, (name, i, _), there = declared.single and held.single, ours[0], theirs[0]
        moved = single and i == -1 and isinstance(there, Address) and name in self.headless
        if moved and isinstance(self.file.value(Address(*there)), str | None):  # its table's header was left behind
            return True
        return declared.single == held.single and all(map(self._same_cell, ours, theirs))

    def _same_cell(self, declared: Index, held: Index) -> bool:
        """Whether two cells match; in a table that has lost rows also by a row's number, and if each is the last."""
        if declared == held:
            return True
        (name, i, j), (other, h, k) = declared, held
        block = self.declared.blocks.get(name)
        if block is None or (name, j) != (other, k):
            return False
        place, fit = self.file.places[name], self.file.fits.get(name)
        before = sum(count for row, count in fit.lost if row <= place.cell(h, 0).row) if fit else 0
        return i == h + before or (i == block.size - 1 and h == place.rows - 1)

    @cached_property
    def _declared_index(self) -> dict[Address, Index]:
        return cell_index({name: declared_place(b) for name, b in self.declared.blocks.items()}, lambda name: 1)

    @cached_property
    def _held_index(self) -> dict[Address, Index]:
        places = {name: self.file.places[name] for name in self.declared.blocks if name in self.file.places}
        return cell_index(places, self._header_above)

    def _header_above(self, name: str) -> int:
        """Return how many rows above a block its header stands: a line with any of its texts, else the next text."""
        place = self.file.places[name]
        for line, texts in enumerate(self._heading(self.declared.blocks[name])):
            for up in range(1, min(MOST_BETWEEN, place.row - line)):
                held = self._line_held(place, up + line)
                if any(cell and cell == other for cell, other in zip(texts, held, strict=True)):
                    return up
        above = range(1, min(MOST_BETWEEN, place.row))
        return next((up for up in above if any(isinstance(cell, str) for cell in self._line_held(place, up))), 1)

    def _heading(self, block: Block) -> list[list[str | None]]:
        """Return the lines of a block's heading as declared, from the line just above it."""
        columns = block.columns.values()
        return [[self._texts.get((block.sheet.title, block.row - up, column)) for column in columns] for up in HEAD]

    def _line_held(self, place: Place, up: int) -> list[Any]:
        """Return the contents of the file so many rows above a block."""
        return [self.file.value(place.cell(-up, j)) for j in range(place.columns)]

    @cached_property
    def headless(self) -> set[str]:
        """The tables that have lost their headings: there is no text just above, and none of their own further up."""
        headless = set()
        for block in self.declared.blocks.values():
            place = self.file.places.get(block.name) if block.is_table else None
            names = {text for line in self._heading(block) for text in line if text} if place else set()
            held = (
                {
                    up: {text for text in self._line_held(place, up) if isinstance(text, str)}
                    for up in range(1, min(MOST_BETWEEN + len(HEAD), place.row))
                }
                if place
                else {}
            )
            if names and not any(held.get(up) for up in HEAD) and not any(names & texts for texts in held.values()):
                headless.add(block.name)
        return headless

    @cached_property
    def _texts(self) -> dict[Index, str]:
        return {(s.title, text.row, text.column): text.text for s in self.declared.sheets for text in s.texts}

    @cached_property
    def declared_area(self) -> Callable[[str, str], Area]:
        """The function for the area of a name in the declaration, whatever sheet it stands on, or ``title!``."""
        areas = {name.lower(): area for name, area in self.declared.areas().items()}

        def area(name: str, sheet: str) -> Area:
            if name.lower() not in areas:
                raise FormulaError("#NAME?", f"the name {name} does not lead to cells")
            return areas[name.lower()]

        return area


def corners(area: Area) -> tuple[Address, Address]:
    """Return the first and the last cell of an area."""
    return area.first, Address(area.sheet, area.bottom, area.right)


def declared_place(block: Block) -> Place:
    """Return where the declaration has a block."""
    return Place(block.sheet.title, block.row, block.column, block.size, len(block.quantities))


def cell_index(places: dict[str, Place], header: Callable[[str], int]) -> dict[Address, Index]:
    """Return the place of every cell of the blocks, and of tables' headers ``header`` rows above, which are row −1."""
    columns = [(name, place, j) for name, place in places.items() for j in range(place.columns)]
    up = {name: header(name) for name, place in places.items() if place.rows > 1 or place.columns > 1}
    cells = {place.cell(-up[name], j): (name, -1, j) for name, place, j in columns if name in up}
    return cells | {at: (name, i, j) for name, place, j in columns for i, at in enumerate(place.down(j))}
