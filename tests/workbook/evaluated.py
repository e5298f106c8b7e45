"""Workbooks with values: what formulon computes of a workbook that is no file yet, and files as Excel saves them."""

import tempfile
import zipfile
from pathlib import Path

import xlsxwriter

from workbook.witnesses.engine_process import Formulon


def by_formulon(written):
    """Return the values of all cells of an openpyxl workbook, by sheet, row and column."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "book.xlsx"
        written.save(path)
        engine = Formulon(str(path))
        engine.compute({}, [])
        return engine.all_values()


def save_as_excel(path, cells, program="Microsoft Excel", asks=False):
    """Write a sheet S of values, and of formulas each with the value that a program saved; return the path.

    ``asks`` of a file that asks to be computed when it is opened.
    """
    raw = path.with_name("raw.xlsx")
    with xlsxwriter.Workbook(raw) as book:
        sheet = book.add_worksheet("S")
        for at, content in cells.items():
            if isinstance(content, tuple):
                sheet.write_formula(at, content[0], None, content[1])
            else:
                sheet.write(at, content)
    with zipfile.ZipFile(raw) as parts, zipfile.ZipFile(path, "w") as written:
        for name in parts.namelist():
            data = parts.read(name).replace(b"Microsoft Excel<", f"{program}<".encode())
            written.writestr(name, data if asks else data.replace(b' fullCalcOnLoad="1"', b""))
    return path
