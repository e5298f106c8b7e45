"""The input cells of a workbook as a machine description, checked by the same models as a file of TOML."""

import json
from collections.abc import Callable, Collection, Iterator
from functools import lru_cache
from typing import Any

from workbook.book.address import Address
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
Check = Callable[[BookFile, Book], None]
Entry = tuple[Quantity, Address, Any]
"""an entry, its cell, and what is entered there"""
UNDO = "undo the change, or take that cell from a copy of the book"


class Entries:
    """Input cells as a description: ``evaluate`` gives values of formulas, ``check`` may refuse the file."""

    def __init__(self, file: BookFile, evaluate: Evaluate, check: Check | None = None) -> None:
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
        torn = [layout.blocks[name] for name in file.torn if name in layout.blocks]
        self._torn = {b.name for b in torn if any(q.role == "input" for q in b.quantities)}
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
        names = (name for name in self.file.places if name.endswith("_built"))
        # what laws and axes were called
        held = {name: self.file.named_value(name)[1] for name in names}
        built = {name: text for name, text in held.items() if isinstance(text, str)}
        laws = {name: built.get(f"{key}_built") for name, key in named.items()}
        machine.laws.built_as({name: text for name, text in laws.items() if text is not None})
        machine.built_as(built)
        _, stamp = self.file.named_value(STAMP)
        machine.verified_at(stamp if is_number(stamp) else None)
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
        address, name = self.file.named_value("book_template")
        if address is None:
            fault = "not a workbook of motionbook: it has no cell named book_template"
            if "MOTION.S" in self.file.workbook.defined_names:
                fault = "holds the functions MOTION.*, but no machine to compare or to read"
            raise ReadError(f"{self.file.path}: {fault}")
        return template_named(name, f"{self.file.path}: {address}")

    def _layout(self) -> dict[str, Any]:
        """Return the layout that the file has of its tables; raise ReadError where that is damaged."""
        cell, text = self.file.named_value(NAME)
        if cell is None:
            fault = f"it has no cell named {NAME}, which says what its tables are"
            raise ReadError(f"{self.file.path}: {fault}; {UNDO}")
        try:
            return read_layout(text, self.template.name)
        except ValueError as fault:
            raise ReadError(f"{self.file.path}: {cell}: {fault}; {UNDO}") from None

    def _declare_empty(self, inputs: Any) -> Book:
        """Declare the book of the file's layout, of so many ``inputs``, with nothing entered."""
        try:
            book = declare_empty(self.template, as_json(self.data))
        except InputError as refused:
            cell, _ = self.file.named_value(NAME)
            raise ReadError(f"{self.file.path}: {cell}: {refused.lines[0]}; {UNDO}") from None
        if (known := len(input_keys(book))) != inputs:
            problem = f"has cells for {quoted(inputs)} entries, where its template has {known}"
            mend = "expected a book of this version: build it anew"
            raise ReadError(f"{self.file.path}: {problem}; {mend}")
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
            self._put_row(block.name, i, row)

    def _put_row(self, table: str, i: int, row: list[Entry]) -> None:
        """Put a row of entries into the description; note a row of a list in which nothing is entered."""
        is_used = "*" not in row[0][0].key or not is_empty(row)
        for q, cell, value in row:
            key = q.key.replace("*", str(i))
            self.cells[key] = f"{cell} ({q.label})"
            has_stand_in = get(self.data, split(key), 0.0) != 0.0
            if value is not None or has_stand_in or (is_used and self._must_be_there(q.key)):
                put(self.data, split(key), value)
            elif "*" in q.key or key[-1].isdigit():
                put(self.data, split(key))
        if not is_used:
            fault = f"nothing is entered in row {i + 1} of the table {table}, but below it"
            mend = "fill it, or move up what is below"
            self._between.append(f"{self.file.path.name}: {row[0][1]}: {fault}; {mend}")

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

    def _entered(self, cell: Address, q: Quantity) -> Entry:
        """Return an entry, of a formula its value; note in a line where that is in doubt."""
        value = self.file.value(cell)
        if not is_formula(value):
            return q, cell, value
        try:
            self.computed[cell] = self._value(cell)
        except DisputedError as doubt:
            self.computed[cell] = None
            fault = f"the formula {quoted(value)} is in doubt: {doubt}; enter the value itself"
            self.disputed.append(f"{self.file.path.name}: {cell} ({q.label}): {fault}")
        return q, cell, self.computed[cell]

    def _formulas(self, layout: Book) -> Iterator[Address]:
        for block in (b for name, b in layout.blocks.items() if name not in self._torn):
            place = self.file.places.get(block.name)
            inputs = [j for j, q in enumerate(block.quantities) if q.role == "input"]
            cells = (cell for j in inputs for cell in place.down(j)) if place else ()
            yield from (cell for cell in cells if is_formula(self.file.value(cell)))

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


def is_empty(row: list[Entry]) -> bool:
    """Whether nothing stands in the cells of a row."""
    return all(value is None for *_, value in row)
