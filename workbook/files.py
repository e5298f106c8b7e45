"""Workbook files as people leave them: opened, or refused in one line; blocks found by their defined names."""

from __future__ import annotations

import warnings
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree.ElementTree import ParseError

import openpyxl
from openpyxl import Workbook
from openpyxl.utils.cell import range_boundaries
from openpyxl.utils.exceptions import InvalidFileException

from workbook.address import Address
from workbook.errors import ReadError

SUFFIXES = (".xlsx", ".xlsm", ".xltx")


class Place(NamedTuple):
    """Where a block lies in a file."""

    sheet: str
    row: int
    column: int
    rows: int
    columns: int

    def cell(self, i: int, j: int) -> Address:
        """Return the address of the cell in row ``i`` and column ``j`` of the block, from 0."""
        return Address(self.sheet, self.row + i, self.column + j)


@dataclass
class BookFile:
    """An opened workbook, with formulas as text, and its defined names as places."""

    path: Path
    workbook: Workbook
    places: dict[str, Place]

    def value(self, address: Address) -> Any:
        """Return what a cell holds: a number, a text, a formula, or None."""
        return self.workbook[address.sheet].cell(address.row, address.column).value


def open_book(path: Path) -> BookFile:
    """Open a workbook for reading.

    Raises ReadError, in one line, where the file is missing, locked, of another kind, or damaged.
    """
    if not path.exists():
        raise ReadError(f"{path}: there is no such file")
    if path.is_dir():
        raise ReadError(f"{path}: this is a folder; expected a workbook")
    if path.suffix.lower() not in SUFFIXES:
        raise ReadError(f"{path}: expected a workbook ending in {', '.join(SUFFIXES)}; save it as .xlsx first")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # parts that openpyxl leaves aside are of no concern here
            workbook = openpyxl.load_workbook(path)
    except PermissionError as error:
        raise ReadError(f"{path}: cannot be read; close it in the other program and try again") from error
    except (
        zipfile.BadZipFile,
        InvalidFileException,
        KeyError,
        ValueError,
        TypeError,
        ParseError,
        OSError,
        EOFError,
    ) as error:
        raise ReadError(f"{path}: this is not a whole workbook ({type(error).__name__})") from error
    return BookFile(path, workbook, find_places(workbook))


def find_places(workbook: Workbook) -> dict[str, Place]:
    """Return the single rectangle that each defined name of the workbook means; names of other kinds are left out."""
    places = {}
    titles = {title.lower(): title for title in workbook.sheetnames}
    for name, defined in workbook.defined_names.items():
        targets = list(defined.destinations)
        if len(targets) != 1 or str(targets[0][0]).lower() not in titles:
            continue
        sheet, cells = targets[0]
        try:
            left, top, right, bottom = range_boundaries(cells)
        except ValueError:
            continue
        if left is not None and top is not None and right is not None and bottom is not None:
            places[name] = Place(titles[sheet.lower()], top, left, bottom - top + 1, right - left + 1)
    return places
