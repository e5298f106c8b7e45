"""Which formula cells of a declared book hang on given cells, and which do not, whatever stands in these.

A look-up whose place is known reads one cell of its range, a choice one of its branches: what these say with the
values declared is taken, so that an entry in one row of a table leaves alone what hangs on the others.
"""

import operator
import re
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.book.columns import Formulas, Moved
from workbook.book.declare import Block, Book
from workbook.book.formula import TOKEN, Area, Formula, FormulaError


class Call(NamedTuple):
    """A function with its arguments, each a list of words and calls."""

    name: str
    arguments: list[list[Any]]


class Word(NamedTuple):
    """A word of a formula: an area, a text, a number or a sign."""

    kind: str
    value: Any


DUMMY = re.compile(r"A([0-9]+)(:B[0-9]+)?")
CHOOSING = frozenset(("INDEX", "MATCH", "IF", "CHOOSE"))  # functions that need not read all that they name
ARGUMENT = "argument"
TWICE = Word("number", 2.0)


def together(arguments: list[list[Any]]) -> list[Any]:
    """Return the words of several arguments."""
    return [word for argument in arguments for word in argument]


class Dependence:
    """What the formula cells of a book refer to."""

    def __init__(self, book: Book) -> None:
        self._book = book
        self._formulas: dict[Address, Formula | Moved] = {}
        self._values: dict[Address, Any] = {}
        self._by_cell: dict[Address, list[Address]] = defaultdict(list)
        self._by_column: dict[tuple[str, int], dict[Area, list[Address]]] = defaultdict(lambda: defaultdict(list))
        self._known: dict[Address, frozenset[Area]] = {}
        self._titles = {sheet.title for sheet in book.sheets}
        self._keyed = {self._column(*name.split(".")) for name in book.keyed}
        readers = {sheet.title: Formulas(sheet.title, self._area) for sheet in book.sheets}
        for cell in book.cells():
            title = cell.block.sheet.title
            at = Address(title, cell.row, cell.column)
            self._values[at] = cell.expected
            if cell.quantity.formula is not None:
                formula = self._formulas[at] = readers[title].read(cell.content, cell.row)
                for area in set(formula.arguments):
                    if isinstance(area, Area):
                        self._note(area, at)

    def _note(self, area: Area, at: Address) -> None:
        if area.size == 1:
            self._by_cell[area.first].append(at)
        else:
            for column in range(area.left, area.right + 1):
                self._by_column[area.sheet, column][area].append(at)

    def on(self, changed: Iterable[Address], known: Collection[Address] = ()) -> set[Address]:
        """Return the formula cells that hang on ``changed``; those that are ``known`` are not asked, nor passed."""
        found: set[Address] = set()
        waiting = list(changed)
        seen = set(waiting)
        while waiting:
            at = waiting.pop()
            for reader in self._readers(at):
                if reader not in seen and reader not in known and self._reads(reader, at):
                    seen.add(reader)
                    found.add(reader)
                    waiting.append(reader)
        return found

    def _readers(self, at: Address) -> Iterator[Address]:
        yield from self._by_cell.get(at, ())
        for area, readers in self._by_column[at.sheet, at.column].items():
            if area.holds(at):
                yield from readers

    def _reads(self, reader: Address, at: Address) -> bool:
        """Whether a formula, as its values are, reads a cell."""
        if reader not in self._known:
            formula = self._formulas[reader]
            areas = formula.arguments
            if CHOOSING & formula.functions:
                areas = tuple(self._used(bound(parsed(formula.shape), areas)))
            self._known[reader] = frozenset(area for area in areas if isinstance(area, Area))
        return any(area.holds(at) for area in self._known[reader])

    def _used(self, nodes: list[Any]) -> Iterator[Area]:
        for node in nodes:
            if isinstance(node, Word):
                if isinstance(node.value, Area):
                    yield node.value
            elif node.name == "INDEX" and len(node.arguments) == 2:
                yield from self._indexed(*node.arguments)
            elif node.name == "MATCH" and len(node.arguments) == 3:
                yield from self._matched(*node.arguments[:2])
            elif node.name == "IF" and len(node.arguments) == 3:
                condition, *branches = node.arguments
                truth = self._truth(condition)
                yield from self._used(condition)
                yield from self._used(branches[0 if truth else 1] if truth is not None else together(branches))
            elif node.name == "CHOOSE":
                choice, *branches = node.arguments
                number = self._value(choice)
                yield from self._used(choice)
                taken = branches[number - 1 : number] if isinstance(number, int) and number > 0 else branches
                yield from self._used(together(taken))
            else:
                yield from self._used(together(node.arguments))

    def _indexed(self, place: list[Any], number: list[Any]) -> Iterator[Area]:
        yield from self._used(number)
        area = place[0].value if len(place) == 1 and isinstance(place[0], Word) else None
        row = self._value(number)
        if isinstance(area, Area) and area.left == area.right and isinstance(row, int) and 0 < row <= area.size:
            yield area._replace(top=area.top + row - 1, bottom=area.top + row - 1)
        else:
            yield from self._used(place)

    def _matched(self, key: list[Any], place: list[Any]) -> Iterator[Area]:
        """Yield what a look-up reads: in a column of keys 2 · number + share those of its number."""
        yield from self._used(key)
        area = place[0].value if len(place) == 1 and isinstance(place[0], Word) else None
        number = self._value(key[2:3]) if len(key) > 2 and key[0] == TWICE else None
        if area not in self._keyed or not isinstance(number, int):
            yield from self._used(place)
            return
        rows = [i for i, cell in enumerate(area.cells()) if number <= self._values[cell] / 2 < number + 1]
        if rows:
            yield area._replace(top=area.top + rows[0], bottom=area.top + rows[-1])

    def _value(self, nodes: list[Any]) -> Any:
        """Return what a plain word stands for, or None; a whole number as one."""
        if len(nodes) != 1 or not isinstance(nodes[0], Word):
            return None
        found = nodes[0].value
        if isinstance(found, Area):
            found = self._values.get(found.first) if found.size == 1 else None
        return int(found) if isinstance(found, float) and found.is_integer() else found

    def _truth(self, nodes: list[Any]) -> bool | None:
        """Return whether a plain comparison, or several joined, holds; None where that cannot be told."""
        if len(nodes) == 1 and isinstance(nodes[0], Call):
            name, arguments = nodes[0]
            told = [self._truth(argument) for argument in arguments]
            if name == "NOT":
                return None if told[0] is None else not told[0]
            if name == "AND":
                return False if False in told else None if None in told else True
            if name == "OR":
                return True if True in told else None if None in told else False
            return None
        for i, node in enumerate(nodes):
            if isinstance(node, Word) and node.kind == "comparison":
                return compared(node.value, self._held(nodes[:i]), self._held(nodes[i + 1 :]))
        return None

    def _held(self, nodes: list[Any]) -> Any:
        """Return what one side of a comparison is; an empty cell is an empty text."""
        if len(nodes) == 1 and isinstance(nodes[0], Word) and isinstance(nodes[0].value, Area):
            area = nodes[0].value
            if area.size > 1 or area.first not in self._values:
                return None
            found = self._values[area.first]
            return "" if found is None else found
        return self._value(nodes)

    def _area(self, name: str, sheet: str) -> Area:
        """Return what a name of the book means, or ``title!``."""
        if name.endswith("!") and name[:-1] in self._titles:
            return Area(name[:-1], 1, 1, 1, 1, True)
        book = self._book
        if name in book.blocks:
            block = book.blocks[name]
            return placed(block, block.column, len(block.quantities))
        return self._column(*book.column_names[name])

    def _column(self, table: str, column: str) -> Area:
        """Return the area of a column of a table, or of several side by side."""
        block = self._book.blocks[table]
        first, last = block.ends(column)
        return placed(block, first, last - first + 1)


def placed(block: Block, column: int, columns: int) -> Area:
    """Return the area of a block's columns."""
    last, right = block.row + block.size - 1, column + columns - 1
    return Area(block.sheet.title, block.row, column, last, right, block.size == columns == 1)


COMPARED: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq, "<>": operator.ne, "<": operator.lt, ">": operator.gt, "<=": operator.le, ">=": operator.ge,
}  # fmt: skip


def compared(sign: str, one: Any, other: Any) -> bool | None:
    """Return whether a comparison holds; None where it is none of two numbers, or of texts for equality."""
    if one is None or other is None:
        return None
    texts = [isinstance(value, str) for value in (one, other)]
    if any(texts) and sign not in ("=", "<>"):
        return None
    if all(texts):
        one, other = one.lower(), other.lower()
    return COMPARED[sign](one, other)


@lru_cache(maxsize=10_000)
def parsed(shape: str) -> list[Any]:
    """Return a shape as words and calls; of an argument its number. Raises FormulaError for text that is none."""
    open_calls: list[tuple[str, list[list[Any]]]] = [("", [[]])]
    position = 1
    while position < len(shape):
        found = TOKEN.match(shape, position)
        if found is None or found.lastgroup == "other":
            position = signed(shape, position, open_calls)
            continue
        position = found.end()
        kind, word = found.lastgroup or "", found[0]
        if kind == "function":
            open_calls.append((word[:-1].upper(), [[]]))
        elif kind == "number":
            open_calls[-1][1][-1].append(Word(kind, float(word)))
        elif dummy := DUMMY.fullmatch(word):
            open_calls[-1][1][-1].append(Word(ARGUMENT, int(dummy[1]) - 1))
    return open_calls[0][1][0]


def bound(nodes: list[Any], arguments: Sequence[Area | str]) -> list[Any]:
    """Return words and calls of a shape with its arguments in place."""
    return [
        Call(node.name, [bound(each, arguments) for each in node.arguments]) if isinstance(node, Call)
        else Word(ARGUMENT, arguments[node.value]) if node.kind == ARGUMENT else node
        for node in nodes
    ]  # fmt: skip


def signed(text: str, position: int, open_calls: list[tuple[str, list[list[Any]]]]) -> int:
    """Take in a sign between words; return where the next word begins."""
    sign = text[position]
    if sign == "(":
        open_calls.append(("", [[]]))
    elif sign == ",":
        open_calls[-1][1].append([])
    elif sign == ")":
        if len(open_calls) == 1:
            raise FormulaError("#NAME?", "a bracket closes that none opens")
        name, arguments = open_calls.pop()
        open_calls[-1][1][-1].append(Call(name, arguments))
    else:
        longer = text[position : position + 2]
        sign = longer if longer in COMPARED else sign
        open_calls[-1][1][-1].append(Word("comparison" if sign in COMPARED else "sign", sign))
    return position + len(sign)
