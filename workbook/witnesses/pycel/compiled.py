"""Shapes of formulas compiled by pycel, each once, and the steps of an evaluation: formulas called, ranges filled."""

import importlib
import keyword
import math
import re
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from pycel import excelformula
from pycel.excelformula import ExcelFormula, FunctionNode, Token, Tokenizer
from pycel.excelutil import EMPTY, list_like
from pycel.lib.function_helpers import load_functions
from pycel.lib.function_info import all_excel_functions

from workbook.book.address import Address
from workbook.book.formula import Area, FormulaError
from workbook.witnesses.pycel import limits, shortcuts
from workbook.witnesses.pycel.shortcuts import Range
from workbook.witnesses.pycel.trees import TREES

excelformula.ast = TREES  # pycel's own name only
MODULES = (limits, *(importlib.import_module(name) for name in ExcelFormula.default_modules))
UNSUITED = frozenset({"OFFSET", "INDIRECT", "SUBTOTAL"})  # they need pycel's graph, or a number in the text
DUMMY = re.compile(r"A[0-9]+(:B[0-9]+)?")
ADDRESS_ASKED = re.compile(r'_REF_\("(.*?)"\)')
LONGEST_TEXT = 32_767  # characters that a cell can hold
LARGEST_EXACT = 2**53  # whole numbers beyond are not exact in a cell
arguments: dict[str, Any] = {}  # what the dummies of the shape under evaluation stand for
_space: dict[str, Any] = {
    "__builtins__": {}, **dict.fromkeys(("_C_", "_R_", "_REF_"), arguments.__getitem__), "pi": math.pi,
    "excel_operator_operand_fixup": shortcuts.operate, "chosen": shortcuts.chosen,
}  # fmt: skip


class Compiled(NamedTuple):
    """A shape to be called once ``arguments`` holds the values of its dummies."""

    call: Callable[[], Any]
    dummies: tuple[str, ...]
    addresses: frozenset[str]  # dummies whose address is asked for, not their value


@lru_cache(maxsize=20_000)
def compiled(shape: str) -> Compiled | FormulaError:
    """Return a shape as pycel compiles it, or the error why it cannot; either is cached."""
    try:
        tokens = Tokenizer(shape).items
        check_tokens(tokens)
        return _compiled(with_signs_first(shape, tokens))
    except FormulaError as error:
        return error
    except RecursionError:
        return FormulaError("#VALUE!", "the formula is nested too deeply")
    except Exception as error:  # pycel's parser and compiler raise whatever Python raises
        why = error.__context__ or error  # pycel wraps what was raised in an error that quotes all of its text
        return FormulaError("#NAME?", f"pycel cannot compile it: {str(why)[:120]}")


def check_tokens(tokens: Sequence[Token]) -> None:
    """Raise FormulaError for all but dummies, numbers, operators and functions: pycel would hand it on to Python."""
    for token in tokens:
        if token.type == Token.OPERAND and token.subtype in (Token.RANGE, Token.TEXT):
            if not DUMMY.fullmatch(token.value):
                raise FormulaError("#NAME?", f"{token.value[:40]!r} cannot be read")
        elif token.type == Token.OP_IN and (token.value == ":" or token.subtype == Token.INTERSECT):
            raise FormulaError("#REF!", "references that are computed or intersected are not evaluated")
        elif token.type == Token.FUNC and token.subtype == Token.OPEN:
            check_function(token.value[:-1].upper().removeprefix("_XLFN."))


def check_function(name: str) -> None:
    """Raise FormulaError for a function that pycel does not have."""
    if name not in all_excel_functions:
        raise FormulaError("#NAME?", f"{name[:40]} is no function of Excel")
    python = name.lower().replace(".", "_")
    python = FunctionNode.func_map.get(python, python)
    known = hasattr(FunctionNode, f"func_{python}") or any(callable(getattr(m, python, None)) for m in MODULES)
    if not known or name in UNSUITED or keyword.iskeyword(python):
        raise FormulaError("#NAME?", f"pycel has no function {name}")


def with_signs_first(shape: str, tokens: Sequence[Token]) -> str:
    """Return a shape whose powers take signs first, as Excel's do, not Python's: ``-A1^A2`` is ``(0-A1)^A2``."""
    if not any(token.type == Token.OP_PRE for token in tokens):
        return shape
    words = [token.value for token in tokens]
    for i, token in enumerate(tokens):
        if token.type == Token.OP_PRE:
            last = last_of_operand(tokens, i + 1)
            after = next((t for t in tokens[last + 1 :] if t.subtype != Token.CLOSE), token)
            if after.value == "^":
                words[i], words[last] = f"(0{words[i]}", f"{words[last]})"
    return f"={''.join(words)}"


def last_of_operand(tokens: Sequence[Token], first: int) -> int:
    """Return the place of the last token of the operand that begins at ``first``, its signs and parentheses with it."""
    depth = 0
    for i in range(first, len(tokens)):
        depth += (tokens[i].subtype == Token.OPEN) - (tokens[i].subtype == Token.CLOSE)
        if depth == 0 and tokens[i].type != Token.OP_PRE:
            return i
    return len(tokens) - 1


def lazy_if(node: FunctionNode) -> str:
    """Return Python for an IF of which only the value that counts is worked out: FALSE where it has no second."""
    test, *values = (child.emit for child in node.children)
    values += ["False"] * (len(values) == 1)
    return f"chosen(if_, {test}, {', '.join(f'lambda: {value}' for value in values)})"


def _compiled(shape: str) -> Compiled:
    formula = ExcelFormula(shape)
    for node in formula.ast.ast if formula.ast else ():
        if node.value.upper() == "IF(" and len(node.children) in (2, 3):
            node.func_if = partial(lazy_if, node)  # by which pycel asks a node for its Python
    code, names = formula.compiled_python
    functions: list[Callable[[], Any]] = []
    _space["lambdas"] = functions
    new = set(names) - _space.keys()
    missing = load_functions(names, _space, MODULES)
    if missing:
        raise FormulaError("#NAME?", f"pycel has no function {', '.join(sorted(missing)).upper()}")
    for name in new:
        _space[name] = shortcuts.with_shortcut(name, _space[name])
    exec(code, _space)  # noqa: S102 - what pycel wrote of a shape: check() let no word of the file's own pass
    dummies = tuple(match[0] for match in DUMMY.finditer(shape))
    return Compiled(functions[0], dummies, frozenset(ADDRESS_ASKED.findall(formula.python_code)))


class FormulaStep(NamedTuple):
    """One formula cell: its shape, and the numbers of the cells, ranges and texts that this is called with."""

    compiled: Compiled
    sources: Sequence[int]

    def compute(self, values: list[Any]) -> Any:
        """Return the content of the cell; raise what pycel raises, and OverflowError for what no cell can hold."""
        arguments.update(zip(self.compiled.dummies, map(values.__getitem__, self.sources), strict=True))
        return as_cell_value(self.compiled.call())


class RangeStep(NamedTuple):
    """One range: the numbers of its cells, row by row."""

    sources: Sequence[int]
    width: int

    def compute(self, values: list[Any]) -> Range:
        """Return the range as pycel's functions take it."""
        cells = map(values.__getitem__, self.sources)
        return Range(zip(*[cells] * self.width, strict=True))


def as_cell_value(result: Any) -> Any:
    """Return a result as a cell holds it: 0 for nothing, of an array its first element."""
    kind = type(result)
    if kind is float and not math.isfinite(result):
        raise OverflowError
    if kind is float or kind is bool:
        return result
    if kind is int:
        return result if abs(result) <= LARGEST_EXACT else float(result)
    if result is None or result == EMPTY:
        return 0
    if kind is str:
        return result if len(result) <= LONGEST_TEXT else "#VALUE!"
    return as_cell_value(result[0]) if list_like(result) else as_cell_value(result.item())


def error_value(error: Exception) -> str:
    """Return the error value of a cell whose computation raised an error."""
    return "#NUM!" if isinstance(error, OverflowError) else "#VALUE!"


class Numbering:
    """Gives numbers from 1; ``values`` holds what each begins with, and None, the empty cell of ranges, at 0."""

    def __init__(self) -> None:
        self.values: list[Any] = [None]
        self._columns: dict[tuple[str, int], dict[int, int]] = {}
        self._others: dict[Hashable, int] = {}

    def column(self, sheet: str, column: int) -> dict[int, int]:
        """Return the numbers of a column's cells, by row; it grows with them."""
        return self._columns.setdefault((sheet, column), {})

    def cell(self, address: Address, value: Any = None) -> int:
        """Return the number of a cell; a new number, with ``value``, for what has none."""
        number = self.column(address.sheet, address.column).setdefault(address.row, len(self.values))
        if number == len(self.values):
            self.values.append(value)
        return number

    def within(self, area: Area) -> list[int]:
        """Return the numbers of the cells within an area that have one."""
        numbers, asked, columns = list[int](), range(area.top, area.bottom + 1), list(area.columns)
        if len(columns) > 1:
            columns = [column for sheet, column in self._columns if sheet == area.sheet and column in columns]
        for column in columns:
            rows = self._columns.get((area.sheet, column), {})
            numbers += [
                rows[row] for row in (asked if len(asked) < len(rows) else rows) if row in asked and row in rows
            ]
        return numbers

    def other(self, key: Hashable, value: Any = None) -> int:
        """Return the number of a range or text; a new number, with ``value``, for what has none."""
        number = self._others.setdefault(key, len(self.values))
        if number == len(self.values):
            self.values.append(value)
        return number


def evaluation_order(needs: dict[int, Sequence[int]]) -> tuple[list[int], dict[int, int]]:
    """Return keys so that each follows those keys that it needs; for each in a cycle, a key that it needs there."""
    cyclic: dict[int, int] = {}
    order, met_again = depth_first(needs)
    if met_again:
        from scipy.sparse import coo_array  # slow to import, and most books have no cycle
        from scipy.sparse.csgraph import connected_components

        ends = np.array([(key, need) for key, reads in needs.items() for need in reads])
        size = 1 + ends.max()
        parts = connected_components(coo_array((ends[:, 0] + 1, ends.T), (size, size)), connection="strong")[1]
        cyclic = dict(ends[parts[ends[:, 0]] == parts[ends[:, 1]]].tolist())
        order, _ = depth_first(needs | dict.fromkeys(cyclic, ()))
    return order, cyclic


def depth_first(needs: Mapping[int, Sequence[int]]) -> tuple[list[int], bool]:
    """Return keys, each after those that it needs, and whether any needs itself, in a fifth of graphlib's time."""
    order: list[int] = []
    done: dict[int, bool] = {}  # of the keys that were begun
    met_again = False
    for root in needs:
        path = [] if root in done else [(root, iter(needs[root]))]
        done.setdefault(root, False)
        while path:
            key, left = path[-1]
            for need in left:
                if need not in done and need in needs:
                    done[need] = False
                    path.append((need, iter(needs[need])))
                    break
                met_again |= not done.get(need, True)
            else:
                path.pop()
                done[key] = True
                order.append(key)
    return order, met_again
