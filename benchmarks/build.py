"""Building a template's book against openpyxl writing the same cells bare, as a ratio in one run."""

from __future__ import annotations

import io
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from rich.console import Console
from rich.table import Table

from workbook.build import build
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES, Template

ROUNDS = 5
GOAL = 1.3

Cells = list[tuple[str, int, int, object]]


def contents(template: Template) -> Cells:
    """Return sheet, row, column and content of every cell of the template's book: texts, numbers, formulas."""
    book = template.declare(read_machine(template.description))
    texts = [(sheet.title, text.row, text.column, text.text) for sheet in book.sheets for text in sheet.texts]
    cells = [(cell.block.sheet.title, cell.row, cell.column, cell.content) for cell in book.cells()]
    return [*texts, *((*place, content) for *place, content in cells if content is not None)]


def bare(cells: Cells) -> None:
    """Write the cells with openpyxl alone: no styles, names, charts, validation or values of formulas."""
    from openpyxl import Workbook  # after workbook, which has it write without lxml, wherever that is installed

    workbook = Workbook()
    pages = {title: workbook.create_sheet(title) for title in dict.fromkeys(sheet for sheet, *_ in cells)}
    for sheet, row, column, value in cells:
        pages[sheet].cell(row, column, value)
    workbook.save(io.BytesIO())


def whole(template: Template) -> None:
    """Build the book as the command does: description, declaration, cells, styles, charts, values, file."""
    with tempfile.TemporaryDirectory() as folder:
        build(read_machine(template.description), Path(folder) / template.book.name)


def least(tasks: list[Callable[[], None]]) -> list[float]:
    """Return the least processor time of each task in seconds; the rounds take turns."""
    best = [float("inf")] * len(tasks)
    for _ in range(ROUNDS):
        for k, task in enumerate(tasks):
            begin = time.process_time()
            task()
            best[k] = min(best[k], time.process_time() - begin)
    return best


def main() -> None:
    """Print the ratio for every template."""
    table = Table(
        "Book",
        "Cells",
        "Bare [CPU s]",
        "Built [CPU s]",
        "Ratio",
        "Goal",
        title="Building / openpyxl writing the cells bare",
    )
    for template in TEMPLATES.values():
        cells = contents(template)
        bare_time, built_time = least([lambda c=cells: bare(c), lambda t=template: whole(t)])  # type: ignore[misc]
        ratio = built_time / bare_time
        verdict = f"≤ {GOAL:g} " + ("met" if ratio <= GOAL else "missed")
        table.add_row(
            template.name, f"{len(cells):,}", f"{bare_time:.2f}", f"{built_time:.2f}", f"{ratio:.2f}", verdict
        )
    Console().print(table)


if __name__ == "__main__":
    main()
