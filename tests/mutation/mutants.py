"""Faults to put into a formula, one at a time: what slips in when people edit a workbook.

A formula is cut up by openpyxl's tokenizer, not by the program's own, so that what the one cannot read the other
still damages.
"""

import random
import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import chain, zip_longest
from typing import Any

from openpyxl.formula import Tokenizer
from openpyxl.formula.tokenizer import Token
from openpyxl.utils import column_index_from_string, get_column_letter

from workbook.book.address import Address
from workbook.book.declare import Book, Cell

OPERATORS = {
    "+": "- *", "-": "+ *", "*": "/ +", "/": "* -", "^": "* /",
    "<": "<= >", "<=": "< >=", ">": ">= <", ">=": "> <=", "=": "<> >", "<>": "=",
}  # fmt: skip
FUNCTIONS = {"SIN": "COS", "MAX": "MIN", "AND": "OR", "RADIANS": "DEGREES", "SUM": "MAX", "COUNT": "SUM", "ABS": "SIGN"}
FUNCTIONS |= {after: before for before, after in FUNCTIONS.items() if before in ("SIN", "MAX", "AND", "RADIANS")}
CORNER = re.compile(r"(\$?)([A-Z]{1,3})(\$?)([0-9]+)")
REFERENCE = re.compile(rf"((?:'(?:[^']|'')+'|\w+)!)?({CORNER.pattern})(?::({CORNER.pattern}))?")
KINDS = ("value", "operator", "function", "literal", "reference", "anchor", "range", "name")
STEPS = ((-1, 0), (1, 0), (0, -1), (0, 1))  # rows, columns


@dataclass(frozen=True)
class Mutant:
    """One cell's formula with one fault in it."""

    address: Address
    kind: str
    original: str
    mutated: Any

    def __str__(self) -> str:
        return f"{self.address} [{self.kind}] {self.original}  ->  {self.mutated}"


def tokens_of(formula: str) -> list[Token]:
    """Return the tokens of a formula; their texts, joined, are the formula without its first sign."""
    return list(Tokenizer(formula).items)


class Mutator:
    """Makes the mutants of a declared book's formulas."""

    def __init__(self, book: Book) -> None:
        self.targets = dict(book.names())
        self.declared = {(cell.block.sheet.title, cell.row, cell.column) for cell in book.cells()}
        scalars = [b.quantities[0] for b in book.blocks.values() if not b.is_table]
        self.scalars = {q.name for q in scalars}
        self.inputs = [q.name for q in scalars if q.role == "input" and not isinstance(q.value, str)]
        self.makers: dict[str, Callable[[list[Token], int], Iterable[str]]] = {
            "operator": operators,
            "function": functions,
            "literal": literals,
            "reference": shifts,
            "anchor": anchors,
            "range": partial(ranges, self.targets),
            "name": self._names,
        }

    def of(self, cell: Cell) -> Iterator[Mutant]:
        """Yield every mutant of one formula cell, each text once."""
        address, formula = Address(cell.block.sheet.title, cell.row, cell.column), cell.content
        yield Mutant(address, "value", formula, cell.expected)
        tokens = tokens_of(formula)
        seen = {formula}
        for kind, make in self.makers.items():
            for at in range(len(tokens)):
                for text in make(tokens, at):
                    mutated = "=" + "".join(t.value if i != at else text for i, t in enumerate(tokens))
                    is_above = kind == "reference" and not self._is_read(address.sheet, tokens[at].value, text)
                    if mutated not in seen and not is_above:
                        seen.add(mutated)
                        yield Mutant(address, kind, formula, mutated)
        for mutated in self._swaps(tokens):
            if mutated not in seen:
                seen.add(mutated)
                yield Mutant(address, "name", formula, mutated)

    def _is_read(self, sheet: str, *references: str) -> bool:
        """Whether any is more than a single cell above a table: a table's first row names these, and reads none."""
        corners = [CORNER.fullmatch(reference) for reference in references]
        return any(
            corner is None or (sheet, int(corner[4]), column_index_from_string(corner[2])) in self.declared
            for corner in corners
        )

    def _names(self, tokens: list[Token], at: int) -> Iterator[str]:
        """Put the name of the input before or after in place of an input's."""
        if tokens[at].value in self.inputs:
            i = self.inputs.index(tokens[at].value)
            yield self.inputs[i - 1]
            yield self.inputs[(i + 1) % len(self.inputs)]

    def _swaps(self, tokens: list[Token]) -> Iterator[str]:
        """Exchange two names of single cells."""
        named = [i for i, t in enumerate(tokens) if t.value in self.scalars]
        for n, i in enumerate(named):
            for j in named[n + 1 :]:
                texts = [t.value for t in tokens]
                texts[i], texts[j] = texts[j], texts[i]
                yield "=" + "".join(texts)


def ranges(targets: dict[str, str], tokens: list[Token], at: int) -> Iterator[str]:
    """Move one end of a range; a defined name of a range is spelled out first."""
    text = str(tokens[at].value)
    if tokens[at].type != Token.OPERAND:
        return
    found = REFERENCE.fullmatch(targets.get(text, text))
    if not found or not found[7]:
        return
    sheet, first, last = found[1] or "", found[2], found[7]
    for rows, columns in STEPS:
        yield from ordered(sheet, first, moved(last, rows, columns))
        yield from ordered(sheet, moved(first, rows, columns), last)


def operators(tokens: list[Token], at: int) -> Iterator[str]:
    """Put another operator; a leading minus becomes a plus."""
    token = tokens[at]
    if token.type == Token.OP_IN:
        yield from OPERATORS.get(token.value, "").split()
    elif token.type == Token.OP_PRE and token.value == "-":
        yield "+"


def functions(tokens: list[Token], at: int) -> Iterator[str]:
    """Put the function that is its pair."""
    token = tokens[at]
    if token.type == Token.FUNC and token.subtype == Token.OPEN and token.value[:-1] in FUNCTIONS:
        yield FUNCTIONS[token.value[:-1]] + "("


def literals(tokens: list[Token], at: int) -> Iterator[str]:
    """Raise one digit of a number, or put another letter last in a text."""
    token = tokens[at]
    if token.type != Token.OPERAND:
        return
    if token.subtype == Token.NUMBER:
        for i, digit in enumerate(token.value):
            if digit.isdigit():
                yield token.value[:i] + str((int(digit) + 1) % 10) + token.value[i + 1 :]
    elif token.subtype == Token.TEXT and len(token.value) > 2:
        last = token.value[-2]
        yield token.value[:-2] + ("x" if last != "x" else "y") + '"'


def shifts(tokens: list[Token], at: int) -> Iterator[str]:
    """Move a reference, a cell or a whole range, by a row or a column."""
    found = REFERENCE.fullmatch(tokens[at].value)
    if tokens[at].type != Token.OPERAND or not found:
        return
    sheet, first, last = found[1] or "", found[2], found[7]
    for rows, columns in STEPS:
        corners = [moved(corner, rows, columns) for corner in (first, last) if corner]
        if all(corners):
            yield sheet + ":".join(c for c in corners if c)


def anchors(tokens: list[Token], at: int) -> Iterator[str]:
    """Drop one $."""
    text = tokens[at].value
    if tokens[at].type == Token.OPERAND and REFERENCE.fullmatch(text):
        for i, sign in enumerate(text):
            if sign == "$":
                yield text[:i] + text[i + 1 :]


def moved(corner: str, rows: int, columns: int) -> str | None:
    """Return a cell reference moved on the sheet, its $ kept; None beyond the sheet's edge."""
    found = CORNER.fullmatch(corner)
    assert found is not None
    row, column = int(found[4]) + rows, column_index_from_string(found[2]) + columns
    return f"{found[1]}{get_column_letter(column)}{found[3]}{row}" if row > 0 and column > 0 else None


def ordered(sheet: str, first: str | None, last: str | None) -> Iterator[str]:
    """Yield a range if its corners still lie in order."""
    if first and last:
        a, b = CORNER.fullmatch(first), CORNER.fullmatch(last)
        assert a is not None
        assert b is not None
        if int(a[4]) <= int(b[4]) and column_index_from_string(a[2]) <= column_index_from_string(b[2]):
            yield f"{sheet}{first}:{last}"


class Orchard:
    """Every formula cell of a book, sorted by quantity, to draw mutants from."""

    def __init__(self, book: Book) -> None:
        self.mutator = Mutator(book)
        self.strata: dict[tuple[str, str], list[Cell]] = defaultdict(list)
        for cell in book.cells():
            if isinstance(cell.content, str) and cell.content.startswith("="):
                self.strata[cell.block.name, cell.quantity.name].append(cell)

    def sample(self, size: int, seed: int | str) -> list[Mutant]:
        """Return ``size`` mutants, spread evenly over quantities and kinds of fault; one of each quantity comes first.

        Of a long column its first, second and last rows and one between are drawn from: three hundred equal rows
        count no more than one cell that stands alone.
        """
        drawn = random.Random(seed)
        groups: dict[tuple[str, str, str], list[Mutant]] = defaultdict(list)
        for stratum, cells in self.strata.items():
            for cell in representatives(cells, drawn):
                for mutant in self.mutator.of(cell):
                    groups[(mutant.kind, *stratum)].append(mutant)
        keys = list(groups)
        drawn.shuffle(keys)
        met: Counter[tuple[str, ...]] = Counter()
        turn = {}
        for key in keys:
            drawn.shuffle(groups[key])
            turn[key] = met[key[1:]]
            met[key[1:]] += 1
        rounds = chain.from_iterable(zip_longest(*(groups[key] for key in sorted(keys, key=turn.__getitem__))))
        return [m for m in rounds if m is not None][:size]


def representatives(cells: list[Cell], drawn: random.Random) -> list[Cell]:
    """Return the first two, the last and one of the other cells of a column; every cell where formulas differ."""
    if len(cells) <= 4 or not isinstance(cells[0].quantity.formula, str):
        return cells
    return [*cells[:2], drawn.choice(cells[2:-1]), cells[-1]]
