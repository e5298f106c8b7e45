"""Straight ways into pycel: numbers go to the bodies of its operators and functions, past checks of their kind.

pycel converts and checks every argument, and the result is the same where all of them are numbers already. Without
these ways a book takes half as long again. Anything but plain numbers takes pycel's own way.
"""

import functools
import math
from collections.abc import Callable, Iterable, Sequence
from itertools import repeat
from typing import Any

import numpy as np
from pycel.lib import lookup

from workbook.witnesses.pycel.arrays import SUMS, Array, applied, array_of, operated, plain, plainly
from workbook.witnesses.pycel.limits import NUMBERS, OPERATORS, build_operators, count_searches, cross, raised

Function = Callable[..., Any]
RANGES = frozenset((tuple, Array))
PLAIN = NUMBERS | RANGES
COUNTED = NUMBERS | {bool}  # 1 and 0 where they are added or multiplied
NOTHING = frozenset(("", "–"))  # texts in the cells of our books, and surely no numbers
SIMPLE = {name: OPERATORS[name] for name in ("Add", "Sub", "Mult", "Lt", "LtE", "Gt", "GtE", "Eq", "NotEq")}
DIVIDE = OPERATORS["Div"]


def operators() -> Callable[[Any, str, Any], Any]:
    """Return what pycel's code calls for every operator."""
    checked = build_operators(lambda is_exception, message: None)

    def operate(left: Any, operator: str, right: Any) -> Any:
        kind, other = type(left), type(right)
        if kind in NUMBERS and other in NUMBERS:
            if operator in SIMPLE:
                return SIMPLE[operator](left, right)
            if operator == "Div" and right:
                return DIVIDE(left, right)
            if operator == "Pow" and right > 0 and (left >= 0 or type(right) is int):
                return raised(left, right)
        elif kind in RANGES or other in RANGES:
            made = operated(left, operator, right) if kind in PLAIN and other in PLAIN else None
            return in_turn(plain(left), operator, plain(right)) if made is None else made
        return checked(left, operator, right)

    def in_turn(left: Any, operator: str, right: Any) -> Any:
        """Return what an operator makes of ranges, by elements."""
        kind, other = type(left), type(right)
        if kind is tuple and other is tuple:
            if len(left) == len(right) and len(left[0]) == len(right[0]):
                return each(operator, flat(left), flat(right), len(left[0]))
            cross(left, right)
        elif kind is tuple and other in NUMBERS:
            return each(operator, flat(left), repeat(right), len(left[0]))
        elif other is tuple and kind in NUMBERS:
            return each(operator, repeat(left), flat(right), len(right[0]))
        return checked(left, operator, right)

    def each(operator: str, left: Iterable[Any], right: Iterable[Any], columns: int) -> Any:
        """Return what an operator makes of each pair, in rows: at once where its plain way takes all of them."""
        kinds = {type(value) for side in (left, right) if isinstance(side, list) for value in side}
        if operator in SIMPLE and kinds <= (COUNTED if operator in SUMS else NUMBERS):
            return in_rows(map(SIMPLE[operator], left, right), columns)
        return in_rows(map(operate, left, repeat(operator), right), columns)

    return operate


def flat(array: Iterable[Iterable[Any]]) -> list[Any]:
    """Return the cells of a range, row by row."""
    return [value for row in array for value in row]


def in_rows(values: Iterable[Any], columns: int) -> tuple[tuple[Any, ...], ...]:
    """Return cells as a range of so many columns."""
    return tuple(zip(*[iter(values)] * columns, strict=True))


def index(checked: Function) -> Function:
    """Return INDEX, straight for ranges and whole numbers, straightest for a row of a column."""

    def call(array: Any, row: Any, column: Any = None) -> Any:
        if type(row) is float and row.is_integer():
            row = int(row)
        if type(array) is tuple and type(row) is int:
            if column is None and 0 < row <= len(array) and len(array[0]) == 1:
                return array[row - 1][0]
            if column is None or type(column) is int:
                return lookup.index(array, row, column)
        return checked(array, row, column)

    return call


def of_one(body: Callable[[float], float], over: Callable[[Any], Any]) -> Callable[[Function], Function]:
    """Return a function of one number, straight for a number in its domain, and so for each of a range."""

    def shortened(checked: Function) -> Function:
        def call(*arguments: Any) -> Any:
            kind = type(arguments[0]) if len(arguments) == 1 else None
            if kind is Array:
                return applied(over, arguments[0]) or checked(*arguments)
            if kind in NUMBERS:
                try:
                    return body(arguments[0])
                except (ValueError, OverflowError):
                    pass
            elif kind is tuple:
                return over_range(arguments[0])
            return checked(*arguments)

        def over_range(array: Any) -> Any:
            values = flat(array)
            if NUMBERS.issuperset(map(type, values)):
                try:
                    return in_rows(map(body, values), len(array[0]))
                except (ValueError, OverflowError):
                    pass
            return in_rows(map(call, values), len(array[0]))

        return call

    return shortened


def condition(checked: Function) -> Function:
    """Return IF, straight for a comparison, with at most one range: then every element is of its size."""

    def call(test: Any, true_value: Any, false_value: Any = 0) -> Any:
        if type(test) is not bool or (type(true_value) is tuple and type(false_value) is tuple):
            cross(test, true_value, false_value)
            return checked(test, true_value, false_value)
        chosen, other = (true_value, false_value) if test else (false_value, true_value)
        return tuple((chosen,) * len(row) for row in other) if type(other) is tuple else chosen

    return call


def chosen(function: Function, test: Any, true_value: Callable[[], Any], false_value: Callable[[], Any]) -> Any:
    """Return IF of two single values, of which only the one that counts is worked out, where the test is plain."""
    if type(test) is bool:
        return true_value() if test else false_value()
    return function(test, true_value(), false_value())


def searching(checked: Function) -> Function:
    """Return a look-up that counts what it passes through before it begins."""

    def call(*arguments: Any) -> Any:
        count_searches(*arguments[:2])
        return checked(*arguments)

    return call


def of_many(body: Callable[[Sequence[float]], float]) -> Callable[[Function], Function]:
    """Return a function of any numbers, straight for numbers and for one range that holds nothing else."""

    def shortened(checked: Function) -> Function:
        def call(*arguments: Any) -> Any:
            one_range = len(arguments) == 1 and type(arguments[0]) in RANGES
            values = numbers_of(plain(arguments[0]) if one_range else (arguments,))
            return body(values) if values else checked(*arguments)

        return call

    return shortened


def smallest(checked: Function) -> Function:
    """Return SMALL, straight for a range of numbers and texts that stand for nothing."""

    def call(array: Any, k: Any) -> Any:
        if type(array) is tuple and type(k) is int:
            values = numbers_of(tuple([value for value in row if value not in NOTHING] for row in array))
            if 1 <= k <= len(values):
                return sorted(values)[k - 1]
        return checked(array, k)

    return call


def product_sum(checked: Function) -> Function:
    """Return SUMPRODUCT, straight for ranges of numbers of one size."""

    def call(*arrays: Any) -> Any:
        if arrays and RANGES.issuperset(map(type, arrays)):
            found: list[Any] = list(map(array_of, arrays))
            numbers = all(cells is not None and cells.dtype != bool for cells in found)
            if numbers and len({cells.shape for cells in found}) == 1:
                return functools.reduce(np.multiply, found).sum().item()
        return checked(*arrays)

    return call


def numbers_of(array: Iterable[Iterable[Any]]) -> list[float]:
    """Return the cells of a range if all of them are numbers, else nothing."""
    values = flat(array)
    return values if NUMBERS.issuperset(map(type, values)) else []


SHORTENED: dict[str, Callable[[Function], Function]] = {
    "index": index,
    "sin": of_one(math.sin, np.sin),
    "cos": of_one(math.cos, np.cos),
    "sqrt": of_one(math.sqrt, np.sqrt),
    "exp": of_one(math.exp, np.exp),
    "ln": of_one(math.log, np.log),
    "abs_": of_one(abs, np.abs),
    "if_": condition,
    "match": searching,
    "vlookup": searching,
    "hlookup": searching,
    "lookup": searching,
    "min_": of_many(min),
    "max_": of_many(max),
    "sum_": of_many(sum),
    "small": smallest,
    "sumproduct": product_sum,
}
"""pycel's functions that have a straight way, by their names there"""

KNOWING = frozenset(("sin", "cos", "sqrt", "exp", "ln", "abs_", "min_", "max_", "sum_", "sumproduct"))
"""those that take arrays"""


def shortened(name: str, function: Function) -> Function:
    """Return a function of pycel as formulas call it: with its straight way, if it has one, and for arrays."""
    plain_one = plainly(function)
    if name not in SHORTENED:
        return plain_one
    made = SHORTENED[name](plain_one)
    return made if name in KNOWING else plainly(made)
