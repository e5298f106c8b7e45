"""An evaluator in a process of its own: a process that dies, or that does not end, takes nothing with it.

Run as a script it reads a request from stdin, an evaluator's name and what it is given, and writes to stdout whether it
answers, and the values, or else why there are none. Both are pickles.
"""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from formulon import Value, Workbook

WHOLE = (0, 0, 2**20 - 1, 2**14 - 1)  # of a sheet: first row and column, last row and column


def formualizer(data: bytes) -> bytes:
    """Return a file with the results of its formulas."""
    from formualizer import recalculate_xlsx_bytes

    filled: bytes = recalculate_xlsx_bytes(data)["bytes"]
    return filled


def ironcalc(path: str, cells: list[tuple[str, int, int]]) -> list[Any]:
    """Return the values of cells, each named by its sheet, row and column."""
    from ironcalc import load_from_xlsx

    model = load_from_xlsx(path, "en", "UTC", "en")
    model.evaluate()
    numbers = {sheet["name"]: i for i, sheet in enumerate(model.get_worksheets_properties())}
    return [model.get_cell_value(numbers[sheet], row, column) for sheet, row, column in cells]


def formulon(data: bytes) -> dict[tuple[str, int, int], Any]:
    """Return the values of all cells of a file."""
    from formulon import Workbook

    with Workbook.load(data) as book:
        book.recalc()
        return formulon_values(book)


def formulon_values(book: Workbook) -> dict[tuple[str, int, int], Any]:
    """Return the values of all cells of a book, by sheet, row and column."""
    from formulon import MergeRange

    values = {}
    for number in range(book.sheet_count()):
        title, more = book.sheet_name(number), True
        cursor: int | None = None
        while more:
            some, cursor = book.get_cells_in_range(number, MergeRange(*WHOLE), cursor)
            more = cursor is not None
            values.update({(title, cell.row + 1, cell.col + 1): formulon_value(cell.value) for cell in some})
    return values


def formulon_value(value: Value) -> Any:
    """Return a number, a truth value, a text or an error's name; None for anything else."""
    from formulon import error_display_name

    if value.error_code is not None:
        return error_display_name(value.error_code)
    plain = value.to_python()
    return plain if isinstance(plain, bool | float | str) else None


EVALUATORS: dict[str, Callable[..., Any]] = {"formualizer": formualizer, "formulon": formulon, "ironcalc": ironcalc}


def answer(name: str, *given: Any) -> tuple[bool, Any]:
    """Return whether an evaluator answers, and its answer, or why it has none."""
    try:
        return True, EVALUATORS[name](*given)
    except BaseException as error:  # panics of Rust are no Exceptions
        return False, f"{type(error).__name__}: {error}"


if __name__ == "__main__":
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # what an evaluator prints is no answer
        pickle.dump(answer(*pickle.load(sys.stdin.buffer)), answers)
