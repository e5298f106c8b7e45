"""The input cells of a workbook as a machine description, checked by the same models as a file of TOML."""

import json
from collections.abc import Callable, Collection, Iterator, Sequence
from functools import lru_cache
from typing import Any

from workbook.book.address import Address, Place
from workbook.book.declare import Block, Book, Quantity
from workbook.book.rows import is_number
from workbook.book.stamp import NAME as STAMP
from workbook.book_layout import INPUTS, NAME, as_json, input_keys, read_layout
from workbook.entries import rules
from workbook.entries.machine import Machine
from workbook.errors import DisputedError, InputError, ReadError, quoted
from workbook.fields.paths import get, has_key, put, split
from workbook.fields.types import MakesCells
from workbook.reading.descriptions import cell_key, empty_machine, make_machine, template_named
from workbook.reading.files import BookFile, is_formula, require_narrow
from workbook.reading.table_fit import fit_tables, tear_lines
from workbook.templates import AnyTemplate

Evaluate = Callable[[BookFile, Collection[Address]], Callable[[Address], Any]]
"""takes the formula cells that will be asked for, and returns a function that gives the value of each"""
UNDO = "undo the change, or take that cell from a copy of the book"


class Entries:
    """Input cells as a description: ``evaluate`` gives values of formulas, ``check`` may refuse the file."""

    def __init__(
        self, file: BookFile, evaluate: Evaluate, check: Callable[[BookFile, Book], None] | None = None
    ) -> None:
        require_narrow(file)
        self.file = file
        self.disputed: list[str] = []
        self.cells: dict[str, str] = {}
        self.computed: dict[Address, Any] = {}
        self.template = self._template()
        self.data = self._layout()
        # of each table of entries the cells under its last row, which nothing reads
        self.beyond: list[str] = []
        self._between: list[str] = []
        self._laws = {key: law["family"] for key, law in self.data["laws"].items()}
        layout = self._declare_empty(self.data.pop(INPUTS, None))
        fit_tables(file, layout)
        self._torn = {b.name for b in layout.blocks.values() if any(q.role == "input" for q in b.quantities)}
        self._torn &= file.torn.keys()
        if check:
            check(file, layout)
        self._value = evaluate(file, [*self._formulas(layout)])
        for block in layout.blocks.values():
            self._read_block(block)

    def machine(self) -> Machine:
        """Return the entries; raise InputError whose lines name the sheet, the cell and what is expected."""
        if self._torn:
            raise InputError(tear_lines(self.file, self._torn))
        if self.disputed:
            raise InputError(self.disputed)
        if self._between:
            raise InputError(self._between[:1])
        data, named = self._by_name()
        machine = make_machine(self.template, data, lambda key: self._where(cell_key(key, named)))
        built = {
            name: text
            for name, place in self.file.places.items()  # what laws and axes were called
            if name.endswith("_built") and isinstance(text := self.file.value(place.cell(0, 0)), str)
        }
        machine.laws.built_as({name: built[f"{key}_built"] for name, key in named.items() if f"{key}_built" in built})
        machine.built_as(built)
        stamp = self.file.places.get(STAMP)
        machine.verified_at(held if stamp and is_number(held := self.file.value(stamp.cell(0, 0))) else None)
        return machine

    def _by_name(self) -> tuple[dict[str, Any], dict[str, str]]:
        """Return the entries with the book's own laws by their names, and for each of these names its key."""
        laws = dict(self.data.get("laws", {}))
        named: dict[str, str] = {}
        for key, family in self._laws.items():
            entry = dict(laws.pop(key, {}))
            name, cell = entry.pop("called", None), self._where(f"laws.{key}.called")
            if not isinstance(name, str) or name in laws:
                fault = f"found {quoted(name)}" if name is not None else "empty"
                raise InputError([f"{cell}: {fault}; expected a name that no other law has"])
            laws[name], named[name] = {**entry, "family": family}, key
        return self.data | {"laws": laws}, named

    def _template(self) -> AnyTemplate:
        place = self.file.places.get("book_template")
        if place is None and "MOTION.S" in self.file.workbook.defined_names:
            raise ReadError(f"{self.file.path}: holds the functions MOTION.*, but no machine to compare or to read")
        if place is None:
            raise ReadError(f"{self.file.path}: not a workbook of motionbook: it has no cell named book_template")
        address = place.cell(0, 0)
        return template_named(self.file.value(address), f"{self.file.path}: {address}")

    def _layout(self) -> dict[str, Any]:
        """Return the layout that the file has of its tables; raise ReadError where that is damaged."""
        place = self.file.places.get(NAME)
        if place is None:
            raise ReadError(f"{self.file.path}: it has no cell named {NAME}, which says what its tables are; {UNDO}")
        cell = place.cell(0, 0)
        try:
            return read_layout(self.file.value(cell), self.template.name)
        except ValueError as fault:
            raise ReadError(f"{self.file.path}: {cell}: {fault}; {UNDO}") from None

    def _declare_empty(self, inputs: Any) -> Book:
        """Declare the book of the file's layout, of so many ``inputs``, with nothing entered."""
        try:
            book = declare_empty(self.template, as_json(self.data))
        except InputError as refused:
            cell, (first, *_) = self.file.places[NAME].cell(0, 0), refused.lines
            raise ReadError(f"{self.file.path}: {cell}: {first}; {UNDO}") from None
        if (known := len(input_keys(book))) != inputs:
            problem = f"has cells for {quoted(inputs)} entries, where its template has {known}"
            raise ReadError(f"{self.file.path}: {problem}; expected a book of this version: build it anew")
        return book

    def _read_block(self, block: Block) -> None:
        inputs = [(j, q) for j, q in enumerate(block.quantities) if q.role == "input"]
        if not inputs or block.name in self._torn:
            return
        place = self.file.places[block.name]
        rows = [[self._entered(place.cell(i, j), q) for j, q in inputs] for i in range(place.rows)]
        self._look_below(block, [place.cell(place.rows - 1, j) for j, _ in inputs])
        table, is_list, _ = inputs[0][1].key.partition(".*")
        if is_list:
            while rows and is_empty(rows[-1]):
                rows.pop()
            if self._is_stand_in(table) if rows else self._must_be_there(table):
                put(self.data, split(table), [])
        for i, row in enumerate(rows):
            self._put_row(block.name, place, i, inputs, row)

    def _put_row(
        self, table: str, place: Place, i: int, inputs: Sequence[tuple[int, Quantity]], row: list[Any]
    ) -> None:
        """Put a row of entries into the description; note a row of a list in which nothing is entered."""
        is_used = "*" not in inputs[0][1].key or not is_empty(row)
        for (j, q), value in zip(inputs, row, strict=True):
            key = q.key.replace("*", str(i))
            self.cells[key] = f"{place.cell(i, j)} ({q.label})"
            has_stand_in = get(self.data, split(key), 0.0) != 0.0
            if value is not None or has_stand_in or (is_used and self._must_be_there(q.key)):
                put(self.data, split(key), value)
            elif "*" in q.key or key[-1].isdigit():
                put(self.data, split(key))
        if not is_used:
            where = f"{self.file.path.name}: {place.cell(i, inputs[0][0])}: nothing is entered in row {i + 1}"
            text = f"of the table {table}, but below it; fill it, or move up what is below"
            self._between.append(f"{where} {text}")

    def _look_below(self, block: Block, last: list[Address]) -> None:
        """Note what stands in a table's columns directly under its last row, where nothing reads it."""
        below = [at._replace(row=at.row + 1) for at in last]
        there = [(at.a1, self.file.value(at)) for at in below] if block.is_table else []
        held = [a1 for a1, value in there if value is not None and not is_formula(value)]
        if held:
            message = f"{last[0].sheet}: {', '.join(held)} stand under the last row of the table {block.name}, where "
            mend = "enter them in a spare row of it, or build the book with more rows"
            self.beyond.append(f"{message}nothing reads them; {mend}")

    def _is_stand_in(self, table: str) -> bool:
        """Whether the layout has a stand-in for the rows of a table."""
        limits = rules.field_at(self.template.model, table)[1] if has_key(self.data, table) else []
        return any(isinstance(c, MakesCells) and c.stand_in is not None for c in limits)

    def _must_be_there(self, key: str) -> bool:
        """Whether an empty cell of an entry is not what a description without it means."""
        begin, _, rest = key.partition(".")
        name, _, below = rest.partition(".")
        known = f"{begin}.{self._laws.get(name, name)}.{below}" if begin == "laws" else key
        model = self.template.model
        return not rules.is_required(model, known) and rules.must_be_entered(model, known)

    def _entered(self, cell: Address, q: Quantity) -> Any:
        """Return an entry, of a formula its value; note in a line where that is in doubt."""
        value = self.file.value(cell)
        if not is_formula(value):
            return value
        try:
            self.computed[cell] = self._value(cell)
        except DisputedError as doubt:
            self.computed[cell] = None
            where = f"{self.file.path.name}: {cell} ({q.label})"
            self.disputed.append(f"{where}: the formula {quoted(value)} is in doubt: {doubt}; enter the value itself")
        return self.computed[cell]

    def _formulas(self, layout: Book) -> Iterator[Address]:
        for block in layout.blocks.values():
            place = None if block.name in self._torn else self.file.places.get(block.name)
            columns = [place.down(j) for j, q in enumerate(block.quantities) if q.role == "input"] if place else []
            yield from (cell for column in columns for cell in column if is_formula(self.file.value(cell)))

    def _where(self, key: str) -> str:
        """Return the cell of ``key``, or of the first entry below or above it."""
        below = (cell for known, cell in self.cells.items() if known.startswith(f"{key}."))
        best = self.cells.get(key) or next(below, None)
        if best is None and "." in key:
            return self._where(key.rpartition(".")[0])
        return f"{self.file.path.name}: {best or key}"


@lru_cache(maxsize=2)
def declare_empty(template: AnyTemplate, layout: str) -> Book:
    """Declare the book of a layout (JSON) with nothing entered; the latest serve all saves of a book."""
    return template.declare_complete(empty_machine(template, json.loads(layout)))


def is_empty(row: Sequence[Any]) -> bool:
    """Whether nothing stands in the cells of a row."""
    return all(value is None for value in row)
