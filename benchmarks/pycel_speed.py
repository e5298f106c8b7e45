"""pycel's cost a formula cell: stock, called cell by cell, against the witness of this project, on the same books.

    .venv/bin/python benchmarks/pycel_speed.py [CELLS]

Stock pycel is slow on the large book, so it is timed on the first CELLS cells (1,500) of each sheet in turn, after
those that they need; both routes parse, compile and evaluate.
"""

from __future__ import annotations

import io
import sys
import time
from collections.abc import Callable
from itertools import chain, zip_longest

from openpyxl import Workbook, load_workbook
from pycel import ExcelCompiler
from pycel.excelwrapper import ExcelOpxWrapperNoData
from rich.console import Console
from rich.table import Table

from workbook.book.address import Address
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES
from workbook.witnesses.pycel.model import PycelModel
from workbook.writing import archive
from workbook.writing.write import parts

SIZES = ((12, 10), (180, 50), (360, 100))
"""points of the cycle and of a law"""


class Wrapper(ExcelOpxWrapperNoData):
    """pycel's reader of a workbook, mended for the defined names of openpyxl 3.1; without it no name is found."""

    @property
    def defined_names(self) -> dict[str, list[tuple[str, str]]]:
        if self._defined_names is None:
            self._defined_names = {
                name: [(cells, sheet) for sheet, cells in defined.destinations]
                for name, defined in self.workbook.defined_names.items()
            }
        return self._defined_names


def book(cycle: int, law: int) -> Workbook:
    template = TEMPLATES["machine"]
    machine = read_machine(template.description)
    sizes = machine.sizes.model_copy(update={"cycle": cycle, "law": law})
    declared = template.declare(machine.model_copy(update={"sizes": sizes}))
    return load_workbook(io.BytesIO(archive.zipped(parts(declared, template.model))))


def timed(work: Callable[[], object]) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def in_turn(model: PycelModel, most: int) -> list[Address]:
    """Cells of all sheets in turn, in an order in which stock pycel's recursion stays shallow."""
    sheets: dict[str, list[Address]] = {}
    for cell in model.order:
        sheets.setdefault(cell.sheet, []).append(cell)
    mixed = chain.from_iterable(zip_longest(*sheets.values()))
    chosen = {address for address in mixed if address is not None}
    return [address for address in model.order if address in chosen][:most]


def stock(workbook: Workbook, cells: list[Address]) -> float:
    """Seconds a cell of stock pycel, for ``cells`` one by one."""
    compiler = ExcelCompiler(excel=Wrapper(workbook))
    return timed(lambda: [compiler.evaluate(str(address)) for address in cells]) / len(cells)


def main() -> None:
    most = int(sys.argv[1]) if len(sys.argv) > 1 else 1500
    table = Table("Formula cells", "Stock, µs a cell", "Here, µs a cell", "of which evaluating", "Ratio")
    for cycle, law in SIZES:
        workbook = book(cycle, law)
        model = PycelModel(workbook)
        n = len(model.formulas)
        reading = timed(lambda w=workbook: PycelModel(w)) / n
        evaluating = timed(model.evaluate) / n
        slow = stock(workbook, in_turn(model, most))
        figures = (slow, reading + evaluating, evaluating)
        table.add_row(f"{n:,}", *(f"{1e6 * x:.0f}" for x in figures), f"{slow / (reading + evaluating):.0f}")
    Console().print(table)


if __name__ == "__main__":
    main()
