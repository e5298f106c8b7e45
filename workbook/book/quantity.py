"""A quantity of the field, declared once: cell, documentation, rule of its input, engine's value; and its place."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from math import inf
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from openpyxl.utils import get_column_letter

from workbook.book.chart import in_scope
from workbook.book.formula import Area
from workbook.book.rows import as_rows, is_number
from workbook.book.sentence import CheckSentence, Sentence, quoted

if TYPE_CHECKING:
    from workbook.book.sheet import Sheet

FAILS = "not met"  # what a check says where it fails that says nothing else
OK, FAIL = "OK", "FAIL"  # the verdicts of checks
SAYS, WHERE = "_says", ": where, and by how much"
"""behind the name of a check, and behind its label: the cell that says where it fails"""
WANTED = ": what is expected"  # behind the label of an entry: the message beside it

FLOOR = 1e-3  # of the unit: a size that is negligible for most quantities
# for units in which usual values are smaller
FLOORS = {"kg m²": 1e-9, "kg cm²": 1e-5, "m²/rad⁴": 1e-6}

# of figures beside a limit: the share of it that rounding may add, and what none is above
ROUNDED, MOST = 1e-9, 1e9

# below each size: four digits that count
LOOKS = ((1.0, "0.0000"), (10.0, "0.000"), (100.0, "0.00"), (1000.0, "0.0"))
NOISE = 1e-12  # rounding, of any unit and as a share of a value
SHORT = 10  # letters of a word that stands below figures as they do
PLAIN = "0.0##"  # how numbers are shown that an engineer enters

Role = Literal["input", "calculation", "result", "check", "constant", "sentence", "title"]


class Quantity(NamedTuple):
    """A quantity of the field: what it is called, how its cell computes it, what the engine says of it."""

    name: str  # of its cell, without blanks; ``@`` stands for the sheet's scope
    label: str
    symbol: str = ""
    unit: str = ""
    role: Role = "calculation"
    formula: str | Sequence[str] | None = None  # for all rows of a table, or for each
    value: Any = None  # in its unit: what an input or constant holds, or the engine's value of the formula; a row each
    source: str = ""
    key: str = ""  # of an input: its place in the description, with ``*`` for the table's row
    scale: float = 0.0  # what deviations are measured against at least, where zeros come from rounding larger numbers
    format: str = ""
    choices: str = ""
    align: str = ""
    # whether its texts take several lines, and their column need hold their words alone
    wrap: bool = False
    upper_limit: float = inf  # of an input: its largest value, where that depends on other entries
    # of figures beside a limit: above it they are shown as beyond it; none by default
    limit: float = 0.0
    good: str = ""  # a word that is shown as the verdict OK is
    # the condition, without =, under which the cell does not count, and is shown in grey
    grey: str = ""
    red: str = ""  # likewise, under which it tells what is beyond limits
    inks: tuple[str, ...] = ()  # of each row, where they differ from that of its kind
    row_label: str = ""  # the label that stands in its row, where that is another than its own
    says: str = ""  # of a check: the formula of where it fails, and by how much
    sentence: str = ""  # what that formula gives, by the engine, where the check fails

    @property
    def beside(self) -> str:
        """The label that stands in its row: of a sentence that of its check, of a message that of its entry."""
        return self.row_label or self.label.removesuffix(WHERE).removesuffix(WANTED)

    @property
    def floor(self) -> float:
        """The least scale of deviations, where the greatest size in the column is smaller."""
        return self.scale or FLOORS.get(self.unit, FLOOR)

    def within(self, scope: str) -> Quantity:
        """Return the quantity with ``scope`` for each ``@`` in its name and formulas."""
        formula = self.formula
        texts = (self.name, self.says, self.grey, self.red)
        formulas = (formula,) if isinstance(formula, str) else formula or ()
        if not any("@" in text for text in (*texts, *formulas)):
            return self
        if formula is not None:
            formula = in_scope(formula, scope) if isinstance(formula, str) else [in_scope(f, scope) for f in formula]
        name, says, grey, red = (in_scope(text, scope) for text in texts)
        return self._replace(name=name, formula=formula, says=says, grey=grey, red=red)


def given(name: str, label: str, symbol: str, unit: str, value: Any, key: str, **more: Any) -> Quantity:
    """Return an input: a cell that the engineer fills; of a column the value is a sequence."""
    return Quantity(name, label, symbol, unit, "input", None, value, key=key, **more)


def calc(
    name: str, label: str, symbol: str, unit: str, formula: Any, value: Any, source: str = "", **more: Any
) -> Quantity:
    """Return a working: a formula cell on the way to a result; its value comes by other means than the formula."""
    return Quantity(name, label, symbol, unit, "calculation", formula, value, source, **more)


def result(
    name: str, label: str, symbol: str, unit: str, formula: Any, value: Any, source: str = "", **more: Any
) -> Quantity:
    """Return a result: a formula cell that the engineer came for."""
    return Quantity(name, label, symbol, unit, "result", formula, value, source, **more)


def constant(name: str, label: str, symbol: str, unit: str, value: Any, source: str = "", **more: Any) -> Quantity:
    """Return a number or text that belongs to the method and not to the machine: locked, and verified."""
    return Quantity(name, label, symbol, unit, "constant", None, value, source, **more)


def check(
    name: str, label: str, condition: str, ok: bool, source: str = "", says: str | CheckSentence = ""
) -> Quantity:
    """Return a check: a cell that says OK where ``condition``, a formula without =, is TRUE, and FAIL where it is not.

    Whether it is ``ok`` comes by other means. Where it fails, the cell beside it ``says`` why: a formula without =,
    with what it gives where the design breaks no rule of the entries.
    """
    text, more = says if isinstance(says, CheckSentence) else (says, "")
    formula, value = f'=IF({condition},"{OK}","{FAIL}")', OK if ok else FAIL
    return Quantity(name, label, "", "", "check", formula, value, source, says=text, sentence=more)


def sentence(q: Quantity) -> Quantity:
    """Return the cell beside a check, which says where it fails and by how much; else what the check is about."""
    formula = f'=IF({q.name}="OK",{quoted(q.source)},{q.says or quoted(FAILS)})'
    value = q.source if q.value == "OK" else Sentence(q.sentence or FAILS)
    return Quantity(f"{q.name}{SAYS}", f"{q.label}{WHERE}", "", "", "sentence", formula, value, align="left")


def sample(q: Quantity) -> Any:
    """Return the value whose size sets the format of all cells of a quantity: the only value, or the greatest."""
    if q.format or isinstance(q.value, str) or not hasattr(q.value, "__len__"):
        return q.value
    values = list(q.value)
    numbers = [v for v in values if is_number(v)]
    return max(numbers, key=abs) if numbers else next(iter(values), None)


def side_of(q: Quantity, is_table: bool) -> str:
    """Return the side of a quantity's cells: numbers right, words left, verdicts centred; any, of what is yet empty."""
    value = sample(q)
    if q.align or q.role == "check":
        return q.align or "center"
    if not is_table:
        return "left" if isinstance(value, str) and len(value) >= SHORT else "right"
    if isinstance(value, str) and not q.unit:
        return "left"
    return "general" if value is None and not (q.unit or q.format) else "right"


def number_format(q: Quantity, value: Any) -> str:
    """Return the format of a quantity: its own, or decimals that suit the size of its values."""
    if q.format:
        return q.format
    if not is_number(value):
        return "General"
    if isinstance(value, int):
        return "0"
    size = abs(value) * (1.0 + NOISE)  # 0.999… by rounding is shown as 1
    if size < NOISE:
        return LOOKS[0][1]
    if size < 1e-3 or size >= 1e6:
        return "0.000E+00"
    return next((look for limit, look in LOOKS if size < limit), "0")


class Cell(NamedTuple):
    """One declared cell, where the generated book has it; ``row`` and ``column`` also tell its offset."""

    block: Block
    quantity: Quantity
    i: int
    row: int
    column: int
    content: Any
    expected: Any


class Row(int):
    """The number of a row; ``row[n]`` is that of the row n below. Python formats it in twice the time of an int."""

    def __getitem__(self, below: int | str) -> int:
        return self + int(below)


@dataclass
class Block:
    """Quantities placed on a sheet: a row of a table each ``size``, or a single cell."""

    name: str
    sheet: Sheet
    row: int
    column: int
    quantities: tuple[Quantity, ...]
    size: int
    title: str = ""
    is_table: bool = True
    is_large: bool = False  # a figure between its name and its unit
    shared_heads: int = 0  # of a table without heads of its own: the row of the names of its columns, above a like one
    blank: str = ""  # of a table: the condition under which a row is not used, and shows nothing but its inputs
    # of a table: the condition under which its results are errors, and are not shown
    quiet: str = ""
    # of columns beside a table: that table, whose cells of the same row formulas may name
    lead: Block | None = None
    workings: Block | None = None
    """of a table: its workings to the right, whose cells in the same row its formulas may name"""

    @cached_property
    def columns(self) -> dict[str, int]:
        """The sheet column of each quantity, by name."""
        return {q.name: self.column + i for i, q in enumerate(self.quantities)}

    @property
    def top(self) -> int:
        """The row above the block, and above its heads if it has its own."""
        return self.row - 1 if self.shared_heads else self.row - 4

    @property
    def seen(self) -> dict[str, int]:
        """The sheet column of each quantity that a formula may name for its own row."""
        beside = (self.lead, self.workings)
        return {**{name: column for block in beside if block for name, column in block.columns.items()}, **self.columns}

    @property
    def at(self) -> str:
        """The block's first cell, such as ``B7``."""
        return f"{get_column_letter(self.column)}{self.row}"

    @property
    def span(self) -> str:
        """The block's cells as an absolute A1 range, without the sheet."""
        return span(self.row, self.column, self.row + self.size - 1, self.column + len(self.quantities) - 1)

    def reference(self, quantity: str, end: str = "", fixed: str = "$") -> str:
        """Return the range of a column or of ``c0:c5``, or of its row ``.first``, ``.last`` or ``.3``."""
        top, bottom = self.row, self.row + self.size - 1
        if end:
            row = {".first": 1, ".last": self.size}.get(end) or int(end[1:])
            top = bottom = self.row + row - 1
        first, last = self.ends(quantity)
        return span(top, first, bottom, last, fixed)

    def ends(self, quantity: str) -> tuple[int, int]:
        """Return the sheet's numbers of the first and the last of columns (``c0:c5``), of a column twice the same."""
        first, _, last = quantity.partition(":")
        return self.columns[first], self.columns[last or first]

    def area(self, quantity: str = "") -> Area:
        """Return the area of some columns, or of all."""
        first, last = self.ends(quantity or f"{self.quantities[0].name}:{self.quantities[-1].name}")
        bottom = self.row + self.size - 1
        return Area(self.sheet.title, self.row, first, bottom, last, self.size == 1 and first == last)

    @property
    def blanked(self) -> tuple[Quantity, ...]:
        """The columns that show nothing in a row that is not used: all but the inputs."""
        return tuple(q for q in self.quantities if self.blank and q.role != "input")

    def when(self, condition: str, row: int) -> str:
        """Return a condition in a row of the sheet, as a formula without its sign of equality."""
        return self.sheet.book.resolve(f"={condition}", self, "$").format(row, Row(row)).removeprefix("=")

    def cells(self) -> Iterator[Cell]:
        """Yield the declared cells, column by column, with contents and the engine's values."""
        return chain.from_iterable(self.by_column())

    def by_column(self) -> Iterator[list[Cell]]:
        """Yield the declared cells of each column."""
        for q, column in zip(self.quantities, self.columns.values(), strict=True):
            both = enumerate(self.contents(q))
            yield [Cell(self, q, i, self.row + i, column, content, value) for i, (content, value) in both]

    def contents(self, q: Quantity) -> Iterator[tuple[Any, Any]]:
        """Return content and engine's value of each cell of a column, from the top."""
        where = f"{self.name}.{q.name}"
        contents = values = as_rows(q.value, self.size, where)
        if q.formula is not None:
            texts = as_rows(q.formula, self.size, where)
            patterns = {text: self.sheet.book.resolve(text, self) for text in set(texts)}
            contents = [patterns[text].format(row, Row(row)) for row, text in enumerate(texts, self.row)]
        return zip(contents, values, strict=True)


def span(top: int, left: int, bottom: int, right: int, fixed: str = "$") -> str:
    """Return an A1 range, or a cell where both corners are the same; ``fixed`` stands before columns."""
    first = f"{fixed}{get_column_letter(left)}${top}"
    last = f"{fixed}{get_column_letter(right)}${bottom}"
    return first if first == last else f"{first}:{last}"
