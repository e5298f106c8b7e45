"""What the formula cells of a file were saved with, as the values that a program shows on opening it."""

import zipfile
from pathlib import Path
from typing import IO, Any

from openpyxl.reader.strings import read_string_table
from openpyxl.utils.datetime import WINDOWS_EPOCH, from_ISO8601

from workbook.book.address import Address
from workbook.reading.contents import Cells, entered
from workbook.reading.guard import Inspected, inspect
from workbook.reading.rows import Written


def saved_values(file: Path | IO[bytes], inspected: Inspected) -> Cells:
    """Return the saved value of each formula cell of a file: a number, a text, True or False, an error; or None."""
    texts: list[str] | None = None
    values: Cells = {}
    for title, rows in inspected.sheets.items():
        for held in rows.written:
            if held.how is None:
                continue
            if held.kind == "s" and texts is None:
                texts = strings(file, inspected.strings)
            values[Address(title, held.row, held.column)] = value(held, texts or [])
    return values


def value(held: Written, texts: list[str]) -> Any:
    """Return a saved value; None where there is none, and an empty text where the type alone says so."""
    kind, text = held.kind, held.value
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


def values_within(file: IO[bytes], size: int) -> Cells:
    """Return the saved values of another copy of a book; raise Refusal as :func:`inspect` does."""
    return saved_values(file, inspect(file, size))
