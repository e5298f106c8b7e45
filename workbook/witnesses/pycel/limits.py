"""pycel's functions within limits: it looks here first, so no cell fills a disk with 9^9^9^9 or takes a day."""

import math
from collections.abc import Callable
from functools import wraps
from types import FunctionType
from typing import Any

from pycel import excellib, excelutil
from pycel.excelutil import NUM_ERROR, PYTHON_AST_OPERATORS, VALUE_ERROR, is_array_arg
from pycel.lib import lookup as lookups
from pycel.lib import stats, text
from pycel.lib.function_helpers import excel_helper, excel_math_func

MOST_DIGITS = 308  # of a number that a cell can hold
MOST_TEXT = 32_767  # characters that a cell can hold
MOST_PERIODS = 1_000_000
LARGEST_ROOT = 1e9
MOST_WILDCARDS = 3  # in a criterion
NUMBERS = frozenset((float, int))  # not bool, whose kind counts in comparisons
NEAR = 1e-14  # relative: numbers farther apart differ in 15 digits
MOST_CROSSED = 1_000_000  # cells of all arrays that cross a row with a column, in an evaluation


class ArrayCells:
    """Counts the cells of arrays that formulas make of a row and a column, or by looking up each of a range."""

    cells = 0


def cross(*arrays: Any) -> None:
    """Count the array of all ``arrays`` before it exists: of a column and a row of 10,000 cells it has 100 million."""
    sizes = [(len(array), len(array[0])) for array in arrays if isinstance(array, tuple)]
    if len(set(sizes)) > 1:
        count_cells(max(rows for rows, _ in sizes) * max(columns for _, columns in sizes))


def count_searches(wanted: Any, array: Any, *_: Any) -> None:
    """Count the cells that are passed through where each of a range is looked up in another."""
    if isinstance(wanted, tuple) and isinstance(array, tuple):
        count_cells(len(wanted) * len(wanted[0]) * len(array) * len(array[0]))


def count_cells(cells: int) -> None:
    """Count cells; raise ValueError beyond the limit."""
    ArrayCells.cells += cells
    if ArrayCells.cells > MOST_CROSSED:
        raise ValueError(f"the arrays of this workbook hold over {MOST_CROSSED:,} cells")


def raised(number: float, exponent: float) -> Any:
    """Return ``number ** exponent``, or #NUM! where no cell can hold it, and for 0 to the power of 0."""
    if not number and not exponent:
        return NUM_ERROR
    if number and exponent * math.log10(abs(number)) > MOST_DIGITS:
        return NUM_ERROR
    result = number**exponent
    if not isinstance(result, complex):
        return result
    root = round(1 / exponent) if abs(exponent) >= 1 / LARGEST_ROOT else 0
    odd = root % 2 == 1 and math.isclose(root * exponent, 1)  # 1/3, 1/5 and so on, as Excel's ^ takes these
    return -(abs(number) ** exponent) if odd else NUM_ERROR


def to_15_digits(compare: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    """Return a comparison to 15 digits (learn.microsoft.com, "Numeric precision in Excel"): 0.1+0.2=0.3 is TRUE."""

    def compared(left: Any, right: Any) -> Any:
        numbers = left != right and type(left) in NUMBERS and type(right) in NUMBERS
        equal = numbers and math.isclose(left, right, rel_tol=NEAR) and f"{left:.15g}" == f"{right:.15g}"
        return compare(left, left if equal else right)

    return compared


@excel_math_func  # type: ignore[untyped-decorator]
def power(number: float, power: float) -> Any:
    """Return POWER of a size that a cell can hold."""
    result = raised(number, power) if number or not power else None
    return result if result == NUM_ERROR or number < 0 else excellib.power(number, power)


def product(*factors: Any) -> Any:
    """Return PRODUCT, which pycel does not have: of numbers as SUM takes them, 0 of none."""
    numbers = excellib._numerics(*factors)
    if isinstance(numbers, str):
        return numbers
    result = math.prod(map(float, numbers)) if numbers else 0.0
    return result if math.isfinite(result) else NUM_ERROR


def sumproduct(*arrays: Any) -> Any:
    """Return a number of Python's: pycel's ROUND and others fail on NumPy's; a single cell is a range."""
    result = excellib.sumproduct(*(array if is_array_arg(array) else ((array,),) for array in arrays))
    return result if isinstance(result, str) else result.item()


def _searching(function: Callable[..., Any]) -> Any:
    """Return a function that refuses texts for which pycel's regular expressions could search for ever."""

    @wraps(function)
    def call(*arguments: Any) -> Any:
        for a in arguments:
            wildcards = a.count("*") + a.count("?") if isinstance(a, str) else 0
            if wildcards > MOST_WILDCARDS or (wildcards and not set("()[]{}+|^$\\").isdisjoint(a)):
                raise ValueError(f"the criterion {a[:20]!r} is not evaluated")
        return function(*arguments)

    return call


def _within(most: float, number: Any, function: Callable[..., Any], *arguments: Any) -> Any:
    """Return the result of a function, or #NUM! where a number is larger than the most of its kind."""
    return function(*arguments) if not isinstance(number, int | float) or abs(number) <= most else NUM_ERROR


@wraps(text.substitute)
def substitute(text_: str, old_text: str, new_text: str, instance_num: Any = None) -> Any:
    """Return SUBSTITUTE of no longer a text than a cell can hold."""
    if len(text_) + text_.count(old_text) * (len(new_text) - len(old_text)) > MOST_TEXT:
        return VALUE_ERROR
    return text.substitute(text_, old_text, new_text, instance_num)


# of a single cell too
index = wraps(lookups.index)(lambda array, *at: lookups.index(array if is_array_arg(array) else ((array,),), *at))
round_ = excel_math_func(lambda x, digits=0: _within(MOST_DIGITS, digits, excellib.round_, x, digits))
trunc = excel_math_func(lambda x, digits=0: _within(MOST_DIGITS, digits, excellib.trunc, x, digits))
fact = excel_math_func(lambda x: _within(170, max(x, 0), excellib.fact, x))
factdouble = excel_helper(cse_params=-1)(
    lambda x: _within(300, excelutil.coerce_to_number(x, convert_all=True), excellib.factdouble, x)
)
pv = excel_math_func(
    lambda rate, nper, pmt, fv=0, due=0: _within(MOST_PERIODS, nper, excellib.pv, rate, nper, pmt, fv, due)
)
match, vlookup, hlookup = _searching(lookups.match), _searching(lookups.vlookup), _searching(lookups.hlookup)
countif, countifs = _searching(stats.countif), _searching(stats.countifs)
sumif, sumifs = _searching(excellib.sumif), _searching(excellib.sumifs)
averageif, averageifs = _searching(stats.averageif), _searching(stats.averageifs)
maxifs, minifs = _searching(stats.maxifs), _searching(stats.minifs)

# pycel's own code for operators, over its own table of them with the power that knows a limit
COMPARED = {name: to_15_digits(PYTHON_AST_OPERATORS[name]) for name in ("Lt", "LtE", "Gt", "GtE", "Eq", "NotEq")}
OPERATORS = PYTHON_AST_OPERATORS | {"Pow": raised} | COMPARED
_globals = vars(excelutil) | {"PYTHON_AST_OPERATORS": OPERATORS}
build_operators = FunctionType(excelutil.build_operator_operand_fixup.__code__, _globals)
