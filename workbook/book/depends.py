"""Find which formula cells of a declared book depend on given cells.

A look-up whose place is known reads one cell of its range, a choice one of its branches. Both are followed with the
values declared, so that an entry in one row of a table does not reach the formulas that depend on other rows.
"""

import operator
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any

from workbook.book.address import Address
from workbook.book.columns import Formulas, Moved, Node, tree
from workbook.book.declare import Book
from workbook.book.formula import Area, Formula

CHOOSING = frozenset(("INDEX", "MATCH", "IF", "CHOOSE"))  # functions that need not read all that they name
COMPARED: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq, "<>": operator.ne, "<": operator.lt, ">": operator.gt, "<=": operator.le, ">=": operator.ge,
}  # fmt: skip


class Dependence:
    """The cells that the formulas of a book refer to."""

    def __init__(self, book: Book) -> None:
        self._formulas: dict[Address, Formula | Moved] = {}
        self._values: dict[Address, Any] = {}
        self._by_cell: dict[Address, list[Address]] = defaultdict(list)
        self._by_column: dict[tuple[str, int], dict[Area, list[Address]]] = defaultdict(lambda: defaultdict(list))
        self._known: dict[Address, frozenset[Area]] = {}
        keyed = (name.split(".") for name in book.keyed)
        self._keyed = {book.blocks[table].area(column) for table, column in keyed}
        areas = book.areas()
        readers = {sheet.title: Formulas(sheet.title, lambda name, _: areas[name]) for sheet in book.sheets}
        for cell in book.cells():
            title = cell.block.sheet.title
            at = Address(title, cell.row, cell.column)
            self._values[at] = cell.expected
            if cell.quantity.formula is not None:
                formula = self._formulas[at] = readers[title].read(cell.content, cell.row)
                for area in {one for one in formula.arguments if isinstance(one, Area)}:
                    if area.size == 1:
                        self._by_cell[area.first].append(at)
                    else:
                        for column in area.columns:
                            self._by_column[area.sheet, column][area].append(at)

    def on(self, changed: Iterable[Address], known: Collection[Address] = ()) -> set[Address]:
        """Return the formula cells that depend on ``changed``; the search stops at those that are ``known``."""
        found: set[Address] = set()
        waiting = list(changed)
        seen = set(waiting)
        while waiting:
            at = waiting.pop()
            columns = self._by_column[at.sheet, at.column].items()
            readers = [reader for area, those in columns if area.holds(at) for reader in those]
            for reader in [*self._by_cell.get(at, ()), *readers]:
                if reader not in seen and reader not in known and self._reads(reader, at):
                    seen.add(reader)
                    found.add(reader)
                    waiting.append(reader)
        return found

    def _reads(self, reader: Address, at: Address) -> bool:
        """Whether a formula, as its values are, reads a cell."""
        if reader not in self._known:
            formula = self._formulas[reader]
            areas: Iterable[Area | str] = formula.arguments
            if CHOOSING & formula.functions:
                areas = Reading(formula.arguments, self._values, self._keyed).of(tree(formula.shape))
            self._known[reader] = frozenset(area for area in areas if isinstance(area, Area))
        return any(area.holds(at) for area in self._known[reader])


class Reading:
    """What a formula of these arguments reads, as the values are; ``keyed`` are columns of keys 2 · number + share."""

    def __init__(self, arguments: Sequence[Area | str], values: Mapping[Address, Any], keyed: Collection[Area]) -> None:
        self.arguments, self.values, self.keyed = arguments, values, keyed

    def of(self, *nodes: Node) -> Iterator[Area]:
        """Yield the areas that are read."""
        for node in nodes:
            called = (node.value, len(node.parts)) if node.kind == "call" else None
            if node.kind == "argument":
                yield from self.areas(node)
            elif called == ("INDEX", 2):
                yield from self.indexed(*node.parts)
            elif called == ("MATCH", 3):
                yield from self.matched(*node.parts[:2])
            elif called == ("IF", 3):
                condition, *branches = node.parts
                truth = self.truth(condition)
                yield from self.of(condition, *(branches if truth is None else [branches[0 if truth else 1]]))
            elif called and node.value == "CHOOSE":
                choice, *branches = node.parts
                number = self.value(choice)
                known = isinstance(number, int) and number > 0
                yield from self.of(choice, *(branches[number - 1 : number] if known else branches))
            else:
                yield from self.of(*node.parts)

    def areas(self, node: Node) -> Iterator[Area]:
        """Yield the area that a node is, if it is one."""
        if node.kind == "argument" and isinstance(area := self.arguments[node.value], Area):
            yield area

    def indexed(self, place: Node, number: Node) -> Iterator[Area]:
        """Yield the areas that INDEX reads of a column: one cell, where the row is known."""
        row = self.value(number)
        yield from self.of(number)
        for area in self.areas(place):
            if area.left == area.right and isinstance(row, int) and 0 < row <= area.size:
                yield area._replace(top=area.top + row - 1, bottom=area.top + row - 1)
                return
        yield from self.of(place)

    def matched(self, key: Node, place: Node) -> Iterator[Area]:
        """Yield the areas that MATCH reads: of a column of keys 2 · number + share only those of its number."""
        yield from self.of(key)
        area, first = next(self.areas(place), None), key
        while first.kind == "operation" and first.value in ("+", "-"):
            first = first.parts[0]
        twice = first.value == "*" and first.parts[0] == Node("number", 2.0)
        number = self.value(first.parts[1]) if twice else None
        if area is None or area not in self.keyed or not isinstance(number, int):
            yield from self.of(place)
            return
        rows = [i for i, cell in enumerate(area.cells()) if number <= self.values[cell] / 2 < number + 1]
        if rows:
            yield area._replace(top=area.top + rows[0], bottom=area.top + rows[-1])

    def value(self, node: Node) -> Any:
        """Return the value of a number, a text or a cell, or None; a whole number as an int."""
        found = node.value if node.kind == "number" else None
        if node.kind == "argument":
            found = self.arguments[node.value]
        if isinstance(found, Area):
            found = self.values.get(found.first) if found.size == 1 else None
        return int(found) if isinstance(found, float) and found.is_integer() else found

    def truth(self, node: Node) -> bool | None:
        """Return whether a comparison, or several joined by NOT, AND and OR, holds; None where that is unknown."""
        if node.kind == "operation" and node.value in COMPARED:
            return compared(node.value, *map(self.operand, node.parts))
        if node.kind != "call" or node.value not in ("NOT", "AND", "OR"):
            return None
        truths = [self.truth(part) for part in node.parts]
        decisive = bool(node.value == "OR")  # one part of this truth decides AND and OR
        if node.value != "NOT" and decisive in truths:
            return decisive
        if None in truths:
            return None
        return not truths[0] if node.value == "NOT" else not decisive

    def operand(self, node: Node) -> Any:
        """Return the value of one side of a comparison; an empty cell is an empty text."""
        for area in self.areas(node):
            if area.size > 1 or area.first not in self.values:
                return None
            found = self.values[area.first]
            return "" if found is None else found
        return self.value(node)


def compared(sign: str, one: Any, other: Any) -> bool | None:
    """Return whether a comparison holds; None where a side is unknown, or where texts are compared by size."""
    if one is None or other is None:
        return None
    texts = [isinstance(value, str) for value in (one, other)]
    if any(texts) and sign not in ("=", "<>"):
        return None
    if all(texts):
        one, other = one.lower(), other.lower()
    return COMPARED[sign](one, other)
