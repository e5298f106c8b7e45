"""A workbook as the rules see it: formulas as forms, cells by columns and rows, who reads whom, and in which order."""

import re
from bisect import bisect_left, bisect_right
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from openpyxl.utils.cell import coordinate_to_tuple
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from workbook.book.address import Address
from workbook.book.columns import Moved, Node, tree
from workbook.book.formula import FUNCTION, TOKEN, Area, Formula, FormulaError, anchors
from workbook.book.rows import is_number
from workbook.reading.files import BookFile
from workbook.witnesses.pycel.compiled import depth_first

NUMBER = re.compile(r"(?<![\w.$:])\d+\.?\d*(?:[eE][+-]?\d+)?(?![\w.:])")
SINGLE = re.compile(r"(?P<column>\$?[A-Za-z]{1,3})(?P<row>\$?\d+)")
NEAR = 3  # rows by which figures under a heading may lie apart


class Form(NamedTuple):
    """A formula taken apart: ``skeleton`` without numbers and references; ``fixed`` tells of each corner's ``$``."""

    skeleton: str
    numbers: tuple[str, ...]
    texts: tuple[str, ...]
    areas: tuple[Area, ...]
    fixed: tuple[tuple[bool, ...], ...]  # of each area: top, left, bottom, right

    @property
    def functions(self) -> frozenset[str]:
        """The names of the functions called."""
        return functions(self.skeleton)

    def across(self, down: bool) -> tuple[Any, ...]:
        """Return all that stays the same where the formula is copied down, or to the right."""
        sides = tuple((a.sheet, a.single, *((a.left, a.right) if down else (a.top, a.bottom))) for a in self.areas)
        return self.skeleton, self.numbers, self.texts, sides

    def along(self, down: bool) -> tuple[int, ...]:
        """Return the rows of its references, or the columns: those that move, or stay, where it is copied."""
        if down:
            return tuple(row for a in self.areas for row in (a.top, a.bottom))
        return tuple(column for a in self.areas for column in (a.left, a.right))


@lru_cache(maxsize=20_000)
def functions(skeleton: str) -> frozenset[str]:
    """Return the names of the functions that a skeleton calls."""
    return frozenset(name.removeprefix("_XLFN.") for name in FUNCTION.findall(skeleton))


@lru_cache(maxsize=20_000)
def numbers_of(shape: str) -> tuple[str, tuple[str, ...]]:
    """Return a shape with ``#`` for each number, and the numbers."""
    return NUMBER.sub("#", shape), tuple(NUMBER.findall(shape))


@lru_cache(maxsize=20_000)
def corners(written: tuple[str, ...]) -> tuple[tuple[bool, ...], ...]:
    """Return of each reference which of top, left, bottom and right has a ``$``; all of a name."""
    fixed = []
    for word in written:
        signs = anchors(word)
        ends = [(end.endswith("$r"), end.startswith("$c")) for end in signs.split(":")] if signs else []
        fixed.append((*ends[0], *ends[-1]) if ends else (True, True, True, True))
    return tuple(fixed)


class View:
    """A workbook; ``forms`` are its formulas, ``numbers`` and ``texts`` the entered cells."""

    def __init__(self, file: BookFile) -> None:
        self.file, self.contents = file, file.contents
        self.forms: dict[Address, Form] = {a: form_of(f) for a, f in self.contents.formulas.items()}
        for cell in self.contents.failed:
            self.forms[cell] = unread_form(self.text(cell), cell)
        held = self.contents.constants
        self.numbers = {a: value for a, value in held.items() if is_number(value)}
        self.texts = {a: value for a, value in held.items() if isinstance(value, str) and value.strip()}

    def text(self, cell: Address) -> str:
        """Return a cell's content as the file writes it; nothing for an empty cell."""
        value = self.file.value(cell)
        return "" if value is None else str(value)

    def figure(self, cell: Address) -> bool:
        """Whether a cell holds a number or a formula."""
        return cell in self.numbers or cell in self.forms

    def empty(self, cell: Address) -> bool:
        """Whether a cell holds nothing."""
        return not self.figure(cell) and self.contents.constants.get(cell) in (None, "")

    @cached_property
    def columns(self) -> dict[tuple[str, int], list[int]]:
        """The sorted rows of all figures, by sheet and column."""
        return by_line((cell.sheet, cell.column, cell.row) for cell in (*self.numbers, *self.forms))

    @cached_property
    def rows(self) -> dict[tuple[str, int], list[int]]:
        """The sorted columns of all figures, by sheet and row."""
        return by_line((cell.sheet, cell.row, cell.column) for cell in (*self.numbers, *self.forms))

    def within(self, area: Area) -> Iterator[Address]:
        """Yield the figures in an area."""
        for column in area.columns if len(area.columns) < 1_000 else ():
            rows = self.columns.get((area.sheet, column), [])
            for row in rows[bisect_left(rows, area.top) : bisect_right(rows, area.bottom)]:
                yield Address(area.sheet, row, column)

    @cached_property
    def blocks(self) -> dict[Address, tuple[int, int]]:
        """The first and last row of the figures that stand one below the other, for each figure."""
        blocks: dict[Address, tuple[int, int]] = {}
        for (sheet, column), rows in self.columns.items():
            for top, bottom in spans(rows):
                blocks |= {Address(sheet, row, column): (top, bottom) for row in range(top, bottom + 1)}
        return blocks

    @cached_property
    def read(self) -> set[Address]:
        """The figures that some formula reads."""
        return self.contents.read([*self.numbers, *self.forms])

    @cached_property
    def readers(self) -> dict[Address, list[Address]]:
        """The formulas that read a cell by itself, in no range."""
        readers = defaultdict(list)
        for cell, form in self.forms.items():
            for area in form.areas:
                if area.single:
                    readers[area.first].append(cell)
        return readers

    @cached_property
    def order(self) -> tuple[list[Address], list[list[Address]]]:
        """All formulas, each behind those that it needs; and the circles among them."""
        return order_formulas(self)

    @cached_property
    def headings(self) -> dict[Address, tuple[Address | None, Address | None]]:
        """The nearest text left of each figure in its row, and the text over the figures of its column."""
        everything = sorted((*self.numbers, *self.forms, *self.texts))
        left, above = dict[Address, Address | None](), dict[Address, Address | None]()
        last: Address | None = None
        for cell in everything:
            if cell in self.texts:
                last = cell
            else:
                left[cell] = last if last and last[:2] == cell[:2] else None
        before: Address | None = None  # the figure or text before it in the column
        for cell in sorted(everything, key=lambda a: (a.sheet, a.column, a.row)):
            if before is None or (before.sheet, before.column) != (cell.sheet, cell.column):
                last = before = None
            if cell in self.texts:
                last = cell
            else:
                if before and cell.row - before.row > NEAR:
                    last = None
                above[cell] = last
            before = cell
        return {cell: (left[cell], above[cell]) for cell in left}

    def calls(self, cell: Address) -> list[Node]:
        """Return the calls of functions in a formula; none of one that cannot be taken apart."""
        with suppress(FormulaError, KeyError, RecursionError):
            return list(calls(tree(self.contents.formulas[cell].shape)))
        return []

    def labels(self, cell: Address) -> tuple[str, str]:
        """Return the text left of a figure, and that over its column."""
        left, above = self.headings.get(cell, (None, None))
        return self.texts[left] if left else "", self.texts[above] if above else ""

    def beside(self, cell: Address) -> str:
        """Return the text directly left of a figure."""
        return self.texts.get(cell._replace(column=cell.column - 1), "") if cell.column > 1 else ""


def calls(node: Node) -> Iterator[Node]:
    """Yield all calls in a formula."""
    if node.kind == "call":
        yield node
    for part in node.parts:
        yield from calls(part)


def by_line(places: Iterable[tuple[str, int, int]]) -> dict[tuple[str, int], list[int]]:
    """Return places, sorted, by sheet and line."""
    lines = defaultdict(list)
    for sheet, line, place in sorted(places):
        lines[sheet, line].append(place)
    return lines


def form_of(formula: Formula | Moved) -> Form:
    """Return the form of a formula that was read."""
    written = formula.pattern.formula.written if isinstance(formula, Moved) else formula.written
    arguments = formula.arguments
    skeleton, numbers = numbers_of(formula.shape)
    texts = tuple(a for a in arguments if isinstance(a, str))
    if texts:
        written = tuple(word for word, a in zip(written, arguments, strict=True) if not isinstance(a, str))
    return Form(skeleton, numbers, texts, tuple(a for a in arguments if isinstance(a, Area)), corners(written))


def unread_form(text: str, cell: Address) -> Form:
    """Return the form of a formula that cannot be taken apart: its references by their distances in the skeleton."""

    def distance(match: re.Match[str]) -> str:
        row, column = match["row"], match["column"]
        at_row, at_column = coordinate_to_tuple((column + row).replace("$", ""))
        r = row if "$" in row else f"[{at_row - cell.row}]"
        return f"R{r}C{at_column}" if "$" in column else f"R{r}C[{at_column - cell.column}]"

    def replaced(token: re.Match[str]) -> str:
        return SINGLE.sub(distance, token[0]) if token.lastgroup == "reference" else token[0]

    return Form("=" + TOKEN.sub(replaced, text[1:]).upper(), (), (), (), ())


def spans(places: Iterable[int], gap: int = 1) -> Iterator[tuple[int, int]]:
    """Yield the first and last of numbers that follow each other, sorted as they are."""
    first = last = None
    for place in places:
        if last is not None and place > last + gap:
            yield int(first or 0), last
            first = place
        first, last = place if first is None else first, place
    if last is not None:
        yield int(first or 0), last


def order_formulas(view: View) -> tuple[list[Address], list[list[Address]]]:
    """Return all formulas, each behind those that it needs but on a circle; and the circles."""
    needs = needs_of(view)
    if not needs:
        return [], []
    nodes = list(needs)
    numbers = {node: n for n, node in enumerate(nodes)}
    reads = {numbers[node]: [numbers[other] for other in others] for node, others in needs.items()}
    edges = np.array([(a, b) for a, others in reads.items() for b in others] or [(0, 0)]).T
    graph = coo_matrix((np.ones(edges.shape[1]), (edges[0], edges[1])), shape=(len(nodes), len(nodes)))
    labels = connected_components(graph, connection="strong")[1].tolist()
    sizes, groups = Counter(labels), defaultdict[int, list[Address]](list)
    for cell in view.forms:
        groups[labels[numbers[cell]]].append(cell)
    circles = [sorted(some) for n, some in groups.items() if sizes[n] > 1 or some[0] in needs[some[0]]]
    order = (nodes[n] for n in depth_first(reads)[0])
    return [node for node in order if isinstance(node, Address)], circles


def needs_of(view: View) -> dict[Any, set[Any]]:
    """Return the formulas that each reads; of a range the largest of the parts into which columns are halved."""
    rows = by_line((cell.sheet, cell.column, cell.row) for cell in view.forms)
    needs: dict[Any, set[Any]] = {
        (line, k): {part(line, of, 2 * k), part(line, of, 2 * k + 1)}
        for line, of in rows.items()
        for k in range(1, len(of))
    }
    for cell, form in view.forms.items():
        needs[cell] = {area.first for area in form.areas if area.single and area.first in view.forms}
        lines = (((a.sheet, column), a) for a in form.areas if not a.single for column in a.columns)
        needs[cell].update(n for line, a in lines if line in rows for n in parts(line, rows[line], a.top, a.bottom))
    return needs


def part(line: tuple[str, int], rows: list[int], at: int) -> Any:
    """Return a part of a column by its number: a formula, or two halves."""
    return Address(line[0], rows[at - len(rows)], line[1]) if at >= len(rows) else (line, at)


def parts(line: tuple[str, int], rows: list[int], top: int, bottom: int) -> Iterator[Any]:
    """Yield the largest parts of a column that make up a range of rows."""
    low, high = bisect_left(rows, top) + len(rows), bisect_right(rows, bottom) + len(rows)
    while low < high:
        if low % 2:
            yield part(line, rows, low)
        if high % 2:
            yield part(line, rows, high - 1)
        low, high = (low + 1) // 2, high // 2
