"""An evaluator in a process of its own: a process that dies, or that does not end, takes nothing with it.

Run as a script it reads pickles from stdin: an evaluator's name, a file's path and the formula cells that are asked
for; then, again and again, values of other cells. To each it answers on stdout whether it can, and the values of the
formula cells, or else why there are none.
"""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from formulon import Value

Place = tuple[str, int, int]  # sheet, row and column, from 1
MEMORY = 4_000_000_000  # bytes that an evaluator may take, where the system keeps to that
WHOLE = (0, 0, 2**20 - 1, 2**14 - 1)  # of a sheet: first row and column, last row and column
FEW = 2_000  # cells that are asked for one by one


class IronCalc:
    """A file held open by IronCalc."""

    def __init__(self, path: str) -> None:
        from ironcalc import load_from_xlsx

        self.model = load_from_xlsx(path, "en", "UTC", "en")
        self.numbers = {sheet["name"]: i for i, sheet in enumerate(self.model.get_worksheets_properties())}

    def compute(self, given: Mapping[Place, Any], cells: Sequence[Place]) -> list[Any]:
        """Return the values of cells, with ``given`` values in others."""
        model = self.model
        by_kind = model.update_cell_with_bool, model.update_cell_with_text, model.update_cell_with_number
        for (sheet, row, column), value in given.items():
            enter((self.numbers[sheet], row, column), value, model.clear_cell_contents, *by_kind)
        self.model.evaluate()
        return [self.model.get_cell_value(self.numbers[sheet], row, column) for sheet, row, column in cells]


class Formulon:
    """A file held open by formulon."""

    def __init__(self, path: str) -> None:
        import wasmtime

        with suppress(wasmtime.WasmtimeError):  # its program is compiled once for this machine: that takes seconds
            config = wasmtime.Config()
            config.cache = True
            vars(wasmtime)["Engine"] = partial(wasmtime.Engine, config)
        from formulon import Workbook

        self.book = Workbook.load(Path(path).read_bytes())
        self.numbers = {self.book.sheet_name(i): i for i in range(self.book.sheet_count())}
        self.of_tables = [*self.formulas_of_tables()] if list(self.book.iter_tables()) else []

    def formulas_of_tables(self) -> Iterator[tuple[int, int, int, str]]:
        """Yield the formulas with the name of a table, each with its place: formulon computes them once only."""
        for sheet, row, column in self.all_values():
            at = self.numbers[sheet], row - 1, column - 1
            if "[" in (formula := self.book.get_formula(*at) or ""):
                yield *at, formula

    def compute(self, given: Mapping[Place, Any], cells: Sequence[Place]) -> list[Any]:
        """Return the values of cells, with ``given`` values in others; None where one is empty or no single value."""
        by_kind = self.book.set_blank, self.book.set_bool, self.book.set_text, self.book.set_number
        for (sheet, row, column), value in given.items():
            enter((self.numbers[sheet], row - 1, column - 1), value, *by_kind)
        for number, row, column, formula in self.of_tables:
            self.book.set_formula(number, row, column, formula)
        self.book.recalc()
        if len(cells) > FEW:
            every = self.all_values()
            return [every.get(cell) for cell in cells]
        values = (self.book.get_value(self.numbers[sheet], row - 1, column - 1) for sheet, row, column in cells)
        return [formulon_value(value) for value in values]

    def all_values(self) -> dict[Place, Any]:
        """Return the values of all cells, by sheet, row and column."""
        from formulon import MergeRange

        values = {}
        for title, number in self.numbers.items():
            cursor: int | None = None
            while True:
                some, cursor = self.book.get_cells_in_range(number, MergeRange(*WHOLE), cursor)
                values.update({(title, cell.row + 1, cell.col + 1): formulon_value(cell.value) for cell in some})
                if cursor is None:
                    break
        return values


def enter(at: tuple[int, int, int], value: Any, *by_kind: Callable[..., Any]) -> None:
    """Enter a value in a cell by the function for nothing, truth values, texts or numbers."""
    if value is None:
        by_kind[0](*at)
    elif isinstance(value, bool | str):
        by_kind[1 if isinstance(value, bool) else 2](*at, value)
    else:
        by_kind[3](*at, float(value))


def formulon_value(value: Value) -> Any:
    """Return a number, a truth value, a text or an error's name; None for anything else."""
    from formulon import error_display_name

    if value.error_code is not None:
        return error_display_name(value.error_code)
    plain = value.to_python()
    return plain if isinstance(plain, bool | float | str) else None


ENGINES: dict[str, type[IronCalc | Formulon]] = {"formulon": Formulon, "ironcalc": IronCalc}


def limit_memory() -> None:
    """Let this process take no more memory than an evaluator may, on systems that can be asked for that."""
    if sys.platform != "win32":
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))  # of what is only reserved, as for wasm, nothing


def serve() -> None:
    """Answer what is asked on stdin, until that ends."""
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # what an evaluator prints is no answer
        engine: IronCalc | Formulon | None = None
        name, path, cells = pickle.load(sys.stdin.buffer)
        while True:
            try:
                given = pickle.load(sys.stdin.buffer)
            except EOFError:
                return
            try:
                engine = engine or ENGINES[name](path)
                answer: tuple[bool, Any] = True, engine.compute(given, cells)
            except BaseException as error:  # panics of Rust are no Exceptions
                answer = False, f"{type(error).__name__}: {error}"
            pickle.dump(answer, answers)
            answers.flush()


if __name__ == "__main__":
    limit_memory()
    serve()
