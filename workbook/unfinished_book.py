"""The book of an unfinished design: entries as they are, FAIL where an entry breaks a rule, no value where needed.

The book is declared for a machine whose entries do. Those that were replaced are put back; the formula cells that hang
on them have no engine value (None), but for the checks of the rules themselves, and what these come to together.
"""

from collections.abc import Iterator
from functools import cache
from typing import Any

from workbook.book.address import Address
from workbook.book.declare import Book, Quantity
from workbook.book.depends import Dependence
from workbook.book.limits import EMPTY, EXPECTED, FULL, MESSAGE, MESSAGES, USED, Guard, in_use, room_text
from workbook.book.quantity import FAIL, OK, SAYS, number_format, sample
from workbook.book.rows import as_rows
from workbook.book.sentence import Sentence
from workbook.book.summary import check_cells
from workbook.entries.machine import Fault, Machine
from workbook.fields.paths import key_of
from workbook.law_sheets.library import named_laws

MOST_TURNS = 1000


def with_entries(book: Book, machine: Machine) -> Book:
    """Return the book of a machine, with what was entered of its unfinished design."""
    return UnfinishedBook(book, machine).book if machine.design.replaced else book


class UnfinishedBook:
    """A book changed to an unfinished design: first the entries, then checks, then the cells that depend on entries."""

    def __init__(self, book: Book, machine: Machine) -> None:
        self.book, self.design = book, machine.design
        self.laws = {law.key: f"laws.{key_of(law.name)}" for law in named_laws(machine.laws)}
        self.at = {Address(c.block.sheet.title, c.row, c.column): c for c in book.cells()}
        inputs = [(at, cell) for at, cell in self.at.items() if cell.quantity.role == "input"]
        self.inputs = {self._key(cell.quantity.key, cell.i): at for at, cell in inputs}
        self.dependence = Dependence(book)
        self.hanging = cache(self.dependence.on)
        self.values: dict[tuple[str, int], list[Any]] = {}
        turns = dict(self._entered())
        known = self._known(turns)
        summed = {at for name in check_cells(book) for at in self._column(name)}
        moved = [at for at, value in known.items() if self.at[at].expected != value]
        for at in self.dependence.on([*turns, *moved], {*known, *summed}):
            self._put(at, None)
        for at, value in known.items():
            self._put(at, value)
        self._write()
        for name, values in check_cells(book).items():
            for at, value in zip(self._column(name), values, strict=True):
                self._put(at, value)
        self._write()

    def _entered(self) -> Iterator[tuple[Address, int]]:
        """Put what was entered into the inputs; yield those cells, and the turn in which each was replaced."""
        for key, at in self.inputs.items():
            if old := self.design.replaced.get(key):
                self._put(at, old.value)
                yield at, old.turn

    def _known(self, turns: dict[Address, int]) -> dict[Address, Any]:
        """Return the verdicts of the checks of the entries, and the columns that they read."""
        known: dict[Address, Any] = {}
        for guard in self.book.guards:
            messages, sentence = self._in_rows(guard) if guard.table else self._beside(guard)
            known |= messages | self._verdict(guard.check, sentence)
        for _, q in self.book.checks:
            where, _, rule = q.rule.partition(":")
            if rule:
                text = self._told(q, self._key(where), rule, turns)
                known |= {} if text is None else self._verdict(q.name, text)
        return known

    def _beside(self, guard: Guard) -> tuple[dict[Address, Any], str]:
        """Return the messages beside single cells, and the first of them, if any."""
        messages: dict[Address, Any] = {}
        message = ""
        for place, (q, _) in enumerate(guard.entries):
            name = f"{q.name}{EXPECTED}"
            (at,) = self._column(f"{name}.{name}")
            faults = list(self._faults(self._key(q.key), ""))
            messages[at] = guard.message(place, faults[0].value) if faults else q.source
            message = message or (messages[at] if faults else "")
        return messages, message

    def _in_rows(self, guard: Guard) -> tuple[dict[Address, Any], str]:
        """Return the messages of a table, and the sentence on the first of them, if any."""
        block = self.book.blocks[f"{guard.table}{MESSAGES}"]
        columns = {name: as_rows("", guard.rows, name) for name in guard.columns}
        for place, i, value in self._beyond(guard):
            column = columns[guard.column(place)]
            column[i] = column[i] or guard.message(place, value)
        columns[MESSAGE] = [next(filter(None, row), "") for row in zip(*columns.values(), strict=True)]
        if USED in block.columns:
            table = self.book.blocks[guard.table]
            entered = [
                q._replace(value=self.values.get((guard.table, table.columns[q.name] - table.column), q.value))
                for q in self._inputs(guard.table)
            ]
            columns[USED] = in_use(guard.rows, entered)
        text = next((Sentence(f"row {i}, {message}") for i, message in enumerate(columns[MESSAGE], 1) if message), "")
        known: dict[Address, Any] = {}
        for name, values in columns.items():
            known |= zip(self._column(f"{block.name}.{name}"), values, strict=True)
        if USED in columns:
            full = f"{guard.table}{FULL}"
            known |= dict.fromkeys(self._column(f"{full}.{full}"), room_text(columns[USED]))
        above = self._key(guard.entries[0][0].key.partition(".*")[0])
        return known, EMPTY if any(self._faults(above, "")) else text

    def _beyond(self, guard: Guard) -> Iterator[tuple[int, int, Any]]:
        """Yield what breaks limits and rules in a table: its place among those that are watched, row and value."""
        for place, (q, _) in enumerate(guard.entries):
            for i in range(guard.rows):
                yield from ((place, i, fault.value) for fault in self._faults(self._key(q.key, i), ""))
        above = self._key(guard.entries[0][0].key.partition(".*")[0])
        for place, rule in enumerate(guard.rules, len(guard.entries)):
            column = next((q.key for q in self._inputs(guard.table) if q.name == rule.column), "")
            for i in range(guard.rows):
                if any(self._faults(f"{above}.{i}", rule.rule)):
                    yield place, i, self._held(self._key(column, i))

    def _inputs(self, table: str) -> list[Quantity]:
        return [q for q in self.book.blocks[table].quantities if q.role == "input"]

    def _told(self, q: Quantity, where: str, rule: str, turns: dict[Address, int]) -> str | None:
        """Return the sentence of a rule's check: nothing where it holds, None where the entries do not tell."""
        faults = list(self._faults(where, rule))
        below = f"{where}."
        if where and not any(f.turn == 0 and f.where != where and f.key.startswith(below) for f in self.design.faults):
            return next((fault.message for fault in faults if fault.turn == 0), "")  # asked of what was entered
        last = faults[0].turn if faults else MOST_TURNS
        (at,) = self._column(f"{q.name}.{q.name}")
        if at in self.hanging(frozenset(at for at, turn in turns.items() if turn < last)):
            return None
        return faults[0].message if faults else ""

    def _verdict(self, check: str, message: str) -> dict[Address, Any]:
        """Return the content of a check, and in the sentence beside it."""
        (at,), (beside,) = self._column(f"{check}.{check}"), self._column(f"{check}{SAYS}.{check}{SAYS}")
        source = next(q.source for _, q in self.book.checks if q.name == check)
        return {at: FAIL, beside: Sentence(message)} if message else {at: OK, beside: source}

    def _faults(self, where: str, rule: str) -> Iterator[Fault]:
        return (fault for fault in self.design.faults if (fault.where, fault.rule) == (where, rule))

    def _held(self, key: str) -> Any:
        """Return the entry at a key of an input."""
        if key in self.design.replaced:
            return self.design.replaced[key].value
        return self.at[self.inputs[key]].content if key in self.inputs else None

    def _key(self, key: str, row: int = 0) -> str:
        """Return the key of an entry in a row, with the law's name where cells have its number."""
        begin = ".".join(key.split(".")[:2])
        return f"{self.laws.get(begin, begin)}{key.removeprefix(begin)}".replace("*", str(row))

    def _column(self, name: str) -> list[Address]:
        """Return the addresses of a column, named ``block.quantity``."""
        block, _, quantity = name.partition(".")
        return self.book.blocks[block].area(quantity).cells()

    def _put(self, at: Address, value: Any) -> None:
        cell = self.at[at]
        key = (cell.block.name, cell.column - cell.block.column)
        if key not in self.values:
            self.values[key] = list(as_rows(cell.quantity.value, cell.block.size, cell.quantity.name))
        self.values[key][cell.i] = value

    def _write(self) -> None:
        """Give the blocks of the book what was put into their cells."""
        for (name, j), values in self.values.items():
            block = self.book.blocks[name]
            q = block.quantities[j]
            look = number_format(q, sample(q)) if q.formula is not None else q.format
            changed = q._replace(value=values if block.is_table else values[0], format=look)
            block.quantities = (*block.quantities[:j], changed, *block.quantities[j + 1 :])
        own = {block.quantities[0].name: block.quantities[0] for block in self.book.blocks.values()}
        self.book.checks = [(s, q._replace(value=own[q.name].value)) for s, q in self.book.checks]
