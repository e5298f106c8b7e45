"""The book of an unfinished design: entries as they are, FAIL where an entry breaks a rule, no value where needed.

The book is declared for a machine whose entries do. Those that were replaced are put back, and the formula cells that
depend on them have no value, until a program opens the book and works them out. Only the checks of the entries have a
value: what was entered tells it.
"""

from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import Any

from workbook.book.address import Address
from workbook.book.checks import check_cells
from workbook.book.declare import Book, Cell
from workbook.book.depends import Dependence
from workbook.book.limits import EMPTY, Guard
from workbook.book.quantity import FAIL, SAYS, number_format, sample
from workbook.book.rows import as_rows
from workbook.book.sentence import Sentence
from workbook.entries.machine import Fault, Machine
from workbook.fields.paths import key_of
from workbook.law_sheets.library import named_laws


def with_entries(book: Book, machine: Machine) -> Book:
    """Return the book of a machine, with what was entered of its unfinished design."""
    if machine.design.replaced:
        UnfinishedDesign(book, machine).put_into_book()
    return book


class UnfinishedDesign:
    """The entries of an unfinished design, and its faults, by the cells of its book."""

    def __init__(self, book: Book, machine: Machine) -> None:
        self.book = book
        self.laws = {law.key: f"laws.{key_of(law.name)}" for law in named_laws(machine.laws)}
        self.cells = {Address(c.block.sheet.title, c.row, c.column): c for c in book.cells()}
        inputs = [(at, cell.quantity.key, cell.i) for at, cell in self.cells.items() if cell.quantity.role == "input"]
        self.inputs = {self._key(key, row): at for at, key, row in inputs}
        replaced = {self.inputs[key]: old for key, old in machine.design.replaced.items() if key in self.inputs}
        self.entered = {at: old.value for at, old in replaced.items()}
        self.turns = {at: old.turn for at, old in replaced.items()}
        self.faults: dict[tuple[str, str], Fault] = {}  # by the place and the rule
        for fault in machine.design.faults:
            self.faults.setdefault((fault.where, fault.rule), fault)
        self.dependence = Dependence(book)

    def put_into_book(self) -> None:
        """Give the book what was entered, the verdicts of its checks, and no value where a cell depends on faults."""
        limits = {guard.check: self.limit_message(guard) for guard in self.book.guards}
        rules = {q.name: message for _, q in self.book.checks if (message := self.rule_message(q.name, q.rule))}
        failing: dict[Address, Any] = {}
        for check, message in (limits | rules).items():
            failing |= {self._at(check): FAIL, self._at(f"{check}{SAYS}"): message} if message else {}
        known = {self._at(f"{check}{end}") for check in limits | rules for end in ("", SAYS)}
        summed = {at for name in check_cells(self.book) for at in self._column(name)}
        without_value = self.dependence.on([*self.entered, *failing], known | summed)
        self._put(dict.fromkeys(without_value) | self.entered | failing)
        sums = check_cells(self.book).items()
        self._put({at: value for name, column in sums for at, value in zip(self._column(name), column, strict=True)})

    def limit_message(self, guard: Guard) -> str:
        """Return the sentence on the first entry of a block that is beyond its limit or breaks a rule of its row."""
        above = self._key(guard.entries[0][0].key.partition(".*")[0])
        if guard.table and (above, "") in self.faults:
            return EMPTY
        first = min(self._faults_in_rows(guard, above), default=None, key=lambda fault: fault[:2])
        if first is None:
            return ""
        row, place, value = first
        message = guard.message(place, value)
        return Sentence(f"row {row + 1}, {message}") if guard.table else message

    def _faults_in_rows(self, guard: Guard, above: str) -> Iterator[tuple[int, int, Any]]:
        """Yield of each fault its row, its place among the entries and rules that are watched, and the entry."""
        keys = {q.name: q.key for q in self.book.blocks[guard.table].quantities} if guard.table else {}
        for row in range(guard.rows):
            for place, (q, _) in enumerate(guard.entries):
                if fault := self.faults.get((self._key(q.key, row), "")):
                    yield row, place, fault.value
            for place, rule in enumerate(guard.rules, len(guard.entries)):
                if (f"{above}.{row}", rule.rule) in self.faults:
                    at = self.inputs.get(self._key(keys[rule.column], row)) if rule.column else None
                    yield row, place, None if at is None else self.entered.get(at, self.cells[at].content)

    def rule_message(self, check: str, place_and_rule: str) -> str:
        """Return the sentence of the check of a rule that does not hold; nothing where no entered number tells it."""
        where, _, rule = place_and_rule.partition(":")
        fault = self.faults.get((self._key(where), rule)) if rule else None
        if fault is None:
            return ""
        before = [at for at, turn in self.turns.items() if turn < fault.turn]
        return "" if self._at(check) in self.dependence.on(before) else Sentence(fault.message)

    def _key(self, key: str, row: int = 0) -> str:
        """Return the key of an entry in a row, with the law's name where cells have its number."""
        begin = ".".join(key.split(".")[:2])
        return f"{self.laws.get(begin, begin)}{key.removeprefix(begin)}".replace("*", str(row))

    def _at(self, name: str) -> Address:
        """Return the address of a single cell."""
        return self._column(f"{name}.{name}")[0]

    def _column(self, name: str) -> list[Address]:
        """Return the addresses of a column, named ``block.quantity``."""
        block, _, quantity = name.partition(".")
        return self.book.blocks[block].area(quantity).cells()

    def _put(self, values: Mapping[Address, Any]) -> None:
        """Give cells of the book other values; a formula's number format stays."""
        columns: dict[tuple[str, int], list[tuple[Cell, Any]]] = defaultdict(list)
        for at, value in values.items():
            cell = self.cells[at]
            columns[cell.block.name, cell.column - cell.block.column].append((cell, value))
        for (name, j), changes in columns.items():
            block = self.book.blocks[name]
            q = block.quantities[j]
            column = list(as_rows(q.value, block.size, q.name))
            for cell, value in changes:
                column[cell.i] = value
            look = number_format(q, sample(q)) if q.formula is not None else q.format
            changed = q._replace(value=column if block.is_table else column[0], format=look)
            block.quantities = (*block.quantities[:j], changed, *block.quantities[j + 1 :])
        verdicts = {check.name: self.book.blocks[check.name].quantities[0].value for _, check in self.book.checks}
        self.book.checks = [(s, q._replace(value=verdicts[q.name])) for s, q in self.book.checks]
