"""Shortcuts past pycel's checks for plain numbers, and ranges of them; pycel computes all else."""

import functools
import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from itertools import repeat
from typing import Any

from pycel.lib import lookup

from workbook.witnesses.pycel.limits import NUMBERS, OPERATORS, build_operators, count_searches, cross, raised

Function = Callable[..., Any]
SIMPLE = {name: OPERATORS[name] for name in ("Add", "Sub", "Mult", "Lt", "LtE", "Gt", "GtE", "Eq", "NotEq")}


def operators() -> Callable[[Any, str, Any], Any]:
    """Return the function that pycel's code calls for every operator."""
    checked = build_operators(lambda is_exception, message: None)

    def operate(left: Any, operator: str, right: Any) -> Any:
        kind, other = type(left), type(right)
        if kind in NUMBERS and other in NUMBERS:
            if operator in SIMPLE:
                return SIMPLE[operator](left, right)
            if operator == "Div" and right:
                return left / right
            if operator == "Pow" and right > 0 and (left >= 0 or type(right) is int):
                return raised(left, right)
        elif kind is tuple or other is tuple:
            sizes = {(len(x), len(x[0])) for x in (left, right) if isinstance(x, tuple)}
            if len(sizes) == 1 and all(isinstance(x, tuple) or type(x) in NUMBERS for x in (left, right)):
                rows = zip(*(x if isinstance(x, tuple) else repeat(repeat(x)) for x in (left, right)), strict=False)
                return tuple(tuple(map(operate, row, repeat(operator), other)) for row, other in rows)
            cross(left, right)
        return checked(left, operator, right)

    return operate


def index(array: Any, row: Any, column: Any = None) -> Any:
    """Return INDEX of ranges and whole numbers, fastest for a row of a column."""
    if type(row) is float and row.is_integer():
        row = int(row)
    if isinstance(array, tuple) and type(row) is int:
        if column is None and 0 < row <= len(array) and len(array[0]) == 1:
            return array[row - 1][0]
        if column is None or type(column) is int:
            return lookup.index(array, row, column)
    return None


def of_number(body: Callable[[float], float], *arguments: Any) -> Any:
    """Return a function of one number in its domain."""
    if len(arguments) == 1 and type(arguments[0]) in NUMBERS:
        with suppress(ValueError, OverflowError):
            return body(arguments[0])
    return None


def of_numbers(body: Callable[[Sequence[float]], float], *arguments: Any) -> Any:
    """Return a function of any numbers, and of one range that holds nothing else."""
    rows = arguments[0] if len(arguments) == 1 and isinstance(arguments[0], tuple) else (arguments,)
    values = [value for row in rows for value in row]
    return body(values) if values and NUMBERS.issuperset(map(type, values)) else None


def chosen(function: Function, test: Any, true_value: Callable[[], Any], false_value: Callable[[], Any]) -> Any:
    """Return IF, of which only the value that counts is worked out, where the test is plain."""
    if type(test) is bool:
        return true_value() if test else false_value()
    return function(test, true_value(), false_value())


ELEMENTARY = ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "sqrt", "log10", "degrees", "radians")
SHORTCUTS: dict[str, Function] = {
    **{name: functools.partial(of_number, getattr(math, name)) for name in ELEMENTARY},
    "ln": functools.partial(of_number, math.log), "abs_": functools.partial(of_number, abs),
    **{f"{body.__name__}_": functools.partial(of_numbers, body) for body in (min, max, sum)},
    "index": index,
}  # fmt: skip
"""shortcuts of pycel's functions, by their names there; each returns None for arguments that it does not take"""
COUNTED: dict[str, Function] = {"if_": cross}
COUNTED |= dict.fromkeys(("match", "vlookup", "hlookup", "lookup"), count_searches)
"""functions that count the cells which pycel's functions will pass through"""


def with_shortcut(name: str, function: Function) -> Function:
    """Return a function of pycel as formulas call it: with its shortcut, if it has one, and counted."""
    way, count = SHORTCUTS.get(name), COUNTED.get(name)

    def call(*arguments: Any) -> Any:
        found = way(*arguments) if way is not None else None
        if found is not None:
            return found
        if count is not None:
            count(*arguments)
        return function(*arguments)

    return call
