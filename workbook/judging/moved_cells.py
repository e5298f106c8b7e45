"""The cells of a book in a book that is built anew: by what they are, wherever they lie.

A cell of an axis is looked for at the axis of that name, a row of a table by what it is called or by what is entered
in it, a cell of an engineer's own by the declared cell beside or above it. References in own formulas follow.
"""

import re
from collections.abc import Sequence
from functools import cached_property
from typing import Any

from openpyxl.utils import get_column_letter, quote_sheetname

from workbook.book.address import Address, Place
from workbook.book.declare import Block, Book, Sheet
from workbook.book.formula import REFERENCE, TOKEN, Area, reference
from workbook.book.rows import as_rows
from workbook.fields.texts import lookup_key
from workbook.judging.matching import Match

NAMED = dict.fromkeys(("axis", "drive", "cycle"), "axes")
NAMED |= {"clear": "clearances", "switch": "switches", "tool": "tools"}
"""by what the names of the cells of a part begin with, before its number, the table that names the parts"""
PART = re.compile(rf"({'|'.join(NAMED)})([1-9][0-9]*)(?![0-9])")
HEAD = re.compile(r"(status|block)([1-9][0-9]*)(?![0-9])")  # of a sheet, by its number
OF_PART = re.compile(rf"=\[({'|'.join(sorted(set(NAMED.values())))})\.name\.([0-9]+)\]")
CELL = re.compile(r"(\$?)[A-Za-z]+(\$?)[0-9]+")
ABOVE = 4  # rows of a table's title and heads
LAMBDA = "_xlpm."  # before the names of the parameters of a LAMBDA


class LostError(ValueError):
    """A cell that the new book does not have, or a reference that cannot follow."""


class Moves:
    """The places that cells of a matched file have in a fresh book; names of the engineer's own stay."""

    def __init__(self, match: Match, fresh: Book, own_sheets: set[str]) -> None:
        self.match, self.fresh, self.old = match, fresh, match.declared
        self.own_sheets, self.own_names = own_sheets, set[str]()
        self.renamed: dict[str, str] = {}  # public names that formulas have, by those that they had
        self.other_units: dict[str, str] = {}  # by public names, what changed
        self.changed_rows: set[str] = set()  # rows of other entries now to which formulas refer
        self._rows: dict[str, list[int | None]] = {}

    @cached_property
    def numbers(self) -> dict[str, dict[int, int]]:
        """By table that names parts, the number of each part in the fresh book by its number in the file."""
        tables = sorted(set(NAMED.values()))
        return {table: pair_names(part_names(self.old, table), part_names(self.fresh, table)) for table in tables}

    @cached_property
    def laws(self) -> dict[str, str]:
        """The beginnings of the names of cells of the engineer's own laws, by what they were."""
        old, new = (
            {name.removesuffix("_called"): block for name, block in book.blocks.items() if name.endswith("_called")}
            for book in (self.old, self.fresh)
        )
        names = [[str(block.quantities[0].value) for block in laws.values()] for laws in (old, new)]
        return {[*old][i - 1]: [*new][j - 1] for i, j in pair_names(*names).items()}

    def remarks(self) -> list[str]:
        """Return a line for each part that is taken to be renamed, and for what formulas have anew."""
        lines = [f"formulas of your own have {new} in place of {old}" for old, new in self.renamed.items()]
        lines += [*self.other_units.values()]
        lines += [f"a formula of your own refers to {row}, which has other entries now" for row in self.changed_rows]
        for table, numbers in self.numbers.items():
            old, new = (part_names(book, table) for book in (self.old, self.fresh))
            pairs = ((old[i - 1], new[j - 1]) for i, j in numbers.items())
            lines += [f"{before} is taken to be called {after} now" for before, after in pairs if before != after]
        return lines

    def name(self, old: str) -> str | None:
        """Return the name that the fresh book would have for what a name of the file's cells means; None if no part."""
        if (part := PART.match(old)) and NAMED[part[1]] in self.old.blocks:
            number = self.numbers[NAMED[part[1]]].get(int(part[2]))
            return f"{part[1]}{number}{old[part.end() :]}" if number else None
        if head := HEAD.match(old):
            sheet = self.sheet(self.old.sheets[int(head[2]) - 1])
            return f"{head[1]}{self.fresh.sheets.index(sheet) + 1}{old[head.end() :]}" if sheet else None
        law, _, rest = old.partition("_")
        return f"{self.laws[law]}_{rest}" if law in self.laws else old

    def sheet(self, old: Sheet) -> Sheet | None:
        """Return the fresh sheet that has what a sheet of the file has."""
        blocks = (block for block in old.blocks if not HEAD.match(block.name))
        return next((new.sheet for block in blocks if (new := self.block(block.name))), None)

    def block(self, old: str) -> Block | None:
        """Return the fresh block that a block of the file is."""
        name = self.name(old)
        return self.fresh.blocks.get(name) if name else None

    def rows(self, old: Block, new: Block) -> list[int | None]:
        """Return for each row of a table its row in the fresh one, from 0; None where that lacks it."""
        if old.name not in self._rows:
            self._rows[old.name] = self._paired(old.lead or old, new.lead or new)
        return self._rows[old.name]

    def _paired(self, old: Block, new: Block) -> list[int | None]:
        parts = [rows_of_parts(block) for block in (old, new)]
        if all(parts):
            numbers = self.numbers[parts[0][0][0]]
            places = {number: i for i, (_, number) in enumerate(parts[1])}
            return [places.get(numbers.get(number, 0)) for _, number in parts[0]]
        names = [row_names(block) for block in (old, new)]
        rows = names if all(names) else [row_entries(block) for block in (old, new)]
        held: dict[Any, int] = {row: i for i, row in reversed([*enumerate(rows[1])])}
        same = [i if i < new.size else None for i in range(old.size)]  # of rows with other entries
        return [held.get(row, None if all(names) and row else same[i]) for i, row in enumerate(rows[0])]

    def cell(self, at: Address) -> Address:
        """Return where a cell of the file is in the fresh book; raise LostError where it is not."""
        if at.sheet in self.own_sheets:
            return at
        if (index := self.match.index_of(at)) is None:
            return self.beside(at)
        name, i, j = index
        old = self.old.blocks[name]
        q, new = old.quantities[j], self.block(name)
        columns = {} if new is None else new.columns
        column = new.column if new and not new.is_table else columns.get(q.name)
        row = self.rows(old, new)[i] if new else None
        if new is None or column is None or row is None:
            raise LostError(f"{q.label or name}, in {at}, is not in the new book")
        return Address(new.sheet.title, new.row + row, column)

    def beside(self, at: Address) -> Address:
        """Return where a cell of the engineer's own goes: with what stands in its row, else with what is above it."""
        known = ((b, self.match.file.places.get(name)) for name, b in self.old.blocks.items())
        places = [(block, place) for block, place in known if place and place.sheet == at.sheet]
        level = [(b, p) for b, p in places if p.row - (ABOVE if b.is_table else 0) <= at.row < p.row + p.rows]
        level.sort(key=lambda pair: (pair[1].column > at.column, abs(at.column - pair[1].column)))
        above = sorted((pair for pair in places if pair[1].row + pair[1].rows <= at.row), key=lambda p: -p[1].row)
        near = [
            Address(new.sheet.title, row, at.column)
            for old, place in level or above
            if (new := self.block(old.name)) and (row := self._row_beside(old, place, new, at.row))
        ]
        if near:  # something of its row may stay where it is, as what is to the right on the page of a drive does
            return next((there for there in near if level and there.row == at.row), near[0])
        declared = next((old for old, title in self.match.sheets if title == at.sheet), None)
        if declared is None or (sheet := self.sheet(declared)) is None:
            raise LostError(f"the new book has no sheet {at.sheet}")
        return Address(sheet.title, at.row, at.column)

    def _row_beside(self, old: Block, place: Place, new: Block, row: int) -> int | None:
        """Return the fresh row, level with or below a block, of a row that is so of the old one."""
        if row < place.row:
            return new.row - (place.row - row)
        last = place.row + place.rows - 1
        if row > last:
            return new.row + new.size - 1 + row - last
        i = next((i for i, at in enumerate(place.down(0)) if at.row >= row), 0)
        moved = self.rows(old, new)[i] if i < old.size else None
        return None if moved is None else new.row + moved

    def area(self, area: Area) -> Area:
        """Return where a cell or a range is; raise LostError where it is not, or is torn."""
        ends = area.first, Address(area.sheet, area.bottom, area.right)
        first, last = self.cell(ends[0]), self.cell(ends[1])
        if whole := self._whole_columns(area):
            first, last = (end._replace(row=r) for end, r in zip((first, last), whole, strict=True))
        spans = last.row - first.row, last.column - first.column
        left = (Address(area.sheet, row, area.left) for row in range(area.top, area.bottom + 1))
        is_torn = len({self.cell(at).row - at.row for at in left}) > 1 and not whole
        if first.sheet != last.sheet or spans[1] != area.right - area.left or is_torn:
            raise LostError(f"{area.sheet}!{area.a1} is torn in the new book")
        return Area(first.sheet, first.row, first.column, last.row, last.column, area.single)

    def _whole_columns(self, area: Area) -> tuple[int, int] | None:
        """Return the first and last row of the fresh table where an area covers all rows of a table's columns."""
        first = self.match.index_of(area.first)
        last = self.match.index_of(Address(area.sheet, area.bottom, area.right))
        if area.single or not first or not last or first[0] != last[0] or first[1] != 0:
            return None
        new = self.block(first[0])
        is_whole = last[1] == self.old.blocks[first[0]].size - 1
        return (new.row, new.row + new.size - 1) if new and is_whole else None

    def formula(self, text: str, at: Address, to: str) -> str:
        """Return an own formula of a cell as it is on the sheet ``to``; raise LostError where it cannot follow."""

        def replaced(token: re.Match[str]) -> str:
            kind, word = token.lastgroup, token[0]
            if kind == "reference":
                return self._reference(word, at, to)
            if kind == "name" and word.upper() not in ("TRUE", "FALSE") and not word.startswith(LAMBDA):
                return self._name(word)
            if kind == "other":
                raise LostError("it refers to another file, or to a table by its name")
            return self._lines(word, at) if kind == "lines" else word

        return TOKEN.sub(replaced, text)

    def _lines(self, word: str, at: Address) -> str:
        """Return whole rows or columns, which stay only where their sheet is the engineer's own."""
        before = word.rpartition("!")[0].strip("'").replace("''", "'")
        if (before or at.sheet) not in self.own_sheets:
            raise LostError(f"{word} are whole rows or columns of a sheet that is built anew")
        return word

    def _reference(self, word: str, at: Address, to: str) -> str:
        """Return a reference, with its signs $, to where its cells are; with its sheet where that is needed."""
        before, first, _, last = REFERENCE.fullmatch(word).groups()  # type: ignore[union-attr]
        old = reference(word, at.sheet, self.match.file.contents.area)
        new = self.area(old)
        if old.single and (index := self.match.index_of(old.first)):
            self._note_row(index[0], index[1])
        cells = cell_at(first, new.top, new.left)
        cells += f":{cell_at(last, new.bottom, new.right)}" if last else ""
        if before and new.sheet == old.sheet:
            return f"{before}{cells}"
        return f"{quote_sheetname(new.sheet)}!{cells}" if before or new.sheet != to else cells

    def _note_row(self, name: str, i: int) -> None:
        """Note a row of a table whose entries are in no row of the fresh one: that of its number is taken."""
        lead, new = (block and (block.lead or block) for block in (self.old.blocks[name], self.block(name)))
        if not lead or not new or not lead.is_table or rows_of_parts(lead) or row_names(lead):
            return
        if (row := row_entries(lead)[i]) != (i,) and row not in row_entries(new):
            self.changed_rows.add(f"row {i + 1} of the table {lead.title or lead.name}")

    def _name(self, word: str) -> str:
        """Return the name that the fresh book has for what a name in a formula means."""
        name = word.rpartition("!")[2]
        if name.casefold() in self.own_names:
            return word
        known = {each.casefold(): each for each in (*self.old.public, *self.old.blocks, *self.old.column_names)}
        old = known.get(name.casefold())
        new = old and (self._public(old) if old in self.old.public else self.name(old))
        if not old or new not in (self.fresh.public.keys() | self.fresh.blocks.keys() | self.fresh.column_names.keys()):
            raise LostError(f"the name {name} is not in the new book")
        if new.casefold() != name.casefold():
            self.renamed[old] = new
        return name if new.casefold() == name.casefold() else new

    def _public(self, old: str) -> str | None:
        """Return the public name that a public name of the file is now; note where its unit is another."""
        cell = self.old.public[old]
        block = self.block(cell)
        new = next((name for name, held in self.fresh.public.items() if block and held == block.name), None)
        units = [held.quantities[0].unit for held in (self.old.blocks[cell], block) if held]
        if new and units[0] != units[1]:
            self.other_units[old] = f"{new} is in {units[1] or 'no unit'}, and was in {units[0] or 'no unit'}"
        return new


def cell_at(cell: str, row: int, column: int) -> str:
    """Return a cell of a reference at another place, with its signs $."""
    across, down = CELL.fullmatch(cell).groups()  # type: ignore[union-attr]
    return f"{across}{get_column_letter(column)}{down}{row}"


def part_names(book: Book, table: str) -> list[str]:
    """Return the names of the parts in a table; of a table that a book lacks, none."""
    block = book.blocks.get(table)
    q = next((q for q in block.quantities if q.name == "name"), None) if block else None
    return [*map(str, filter(None, as_rows(q.value, block.size, table)))] if q and block else []


def pair_names(old: Sequence[str], new: Sequence[str]) -> dict[int, int]:
    """Return the number of each of the old names among the new ones, from 1.

    Where as many are there as before, those of unknown names are taken to be renamed, in their order.
    """
    places = {lookup_key(name): j for j, name in enumerate(new, 1)}
    pairs = {i: places[key] for i, key in enumerate(map(lookup_key, old), 1) if key in places}
    if len(old) == len(new):
        left = [[i for i in range(1, len(old) + 1) if i not in known] for known in (pairs.keys(), pairs.values())]
        pairs |= dict(zip(*left, strict=True))
    return pairs


def rows_of_parts(block: Block) -> list[tuple[str, int]]:
    """Return the part that each row of a table is about, by its table and number; nothing where they are about none."""
    if block.name in NAMED.values():
        return [(block.name, i) for i in range(1, block.size + 1)]
    for q in block.quantities if block.is_table else ():
        formulas = q.formula if isinstance(q.formula, list | tuple) else [q.formula or ""]
        parts = [OF_PART.fullmatch(str(text)) for text in formulas]
        if len(parts) == block.size and all(parts):
            return [(part[1], int(part[2])) for part in parts if part]
    return []


def row_names(block: Block) -> list[Any]:
    """Return the texts that name the rows of a table, None of those without; nothing where none do."""
    for q in block.quantities if block.is_table else ():
        if q.name in ("name", "code") and q.formula is None:
            return [name or None for name in as_rows(q.value, block.size, q.name)]
    return []


def row_entries(block: Block) -> list[tuple[Any, ...]]:
    """Return the entries of each row of a table; of a row without entries, its number alone."""
    inputs = [as_rows(q.value, block.size, q.name) for q in block.quantities if q.role == "input"]
    rows = [tuple(column[i] for column in inputs) for i in range(block.size)]
    return [row if any(value not in (None, "") for value in row) else (i,) for i, row in enumerate(rows)]
