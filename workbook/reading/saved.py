"""What the formula cells of a file were saved with, as the values that a program shows on opening it."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import IO, Any

from openpyxl import Workbook
from openpyxl.cell.cell import Cell
from openpyxl.reader.strings import read_string_table
from openpyxl.utils.datetime import WINDOWS_EPOCH, from_ISO8601

from workbook.book.address import Address
from workbook.reading.contents import Cells, entered
from workbook.reading.guard import Inspected, inspect
from workbook.reading.rows import Saved


def saved_values(file: Path | IO[bytes], inspected: Inspected) -> Cells:
    """Return the saved value of each formula cell of a file: a number, a text, True or False, an error; or None."""
    texts: list[str] | None = None
    values: Cells = {}
    for title, cells in inspected.saved.items():
        for (row, column), held in cells.items():
            if held.kind == "s" and texts is None:
                texts = strings(file, inspected.strings)
            values[Address(title, row, column)] = value(held, texts or [])
    return values


def value(held: Saved, texts: list[str]) -> Any:
    """Return a saved value; None where there is none, and an empty text where the type alone says so."""
    kind, text = held
    if not text:
        return "" if kind == "str" else None
    if kind == "n":
        return float(text)
    if kind == "b":
        return text == "1"
    if kind == "s":
        return texts[int(text)] if int(text) < len(texts) else None
    if kind == "d":
        return entered(from_ISO8601(text), WINDOWS_EPOCH)  # type: ignore[no-untyped-call]
    return text


def strings(file: Path | IO[bytes], part: str) -> list[str]:
    """Return the texts that several cells share."""
    if not part:
        return []
    with zipfile.ZipFile(file) as archive, archive.open(part) as source:
        return list(read_string_table(source))


def undated(workbook: Workbook, inspected: Inspected) -> None:
    """Give numbers back that openpyxl took for dates, or for errors where no date is that early: a format is a look."""
    for sheet in workbook.worksheets:
        numbers = inspected.numbers.get(sheet.title, {})
        for place, cell in sheet._cells.items():
            if isinstance(cell, Cell) and cell.data_type in ("d", "e") and place in numbers:
                text = numbers[place]
                cell.value = int(text) if text.strip().lstrip("+-").isdecimal() else float(text)


def values_within(file: IO[bytes], size: int) -> Cells:
    """Return the saved values of another copy of a book; raise Refusal as :func:`inspect` does."""
    return saved_values(file, inspect(file, size))
