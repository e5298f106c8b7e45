"""Workbook files as people leave them: opened, or refused in a line; blocks identified by their defined names."""

import io
import re
import warnings
from contextlib import redirect_stdout
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property
from pathlib import Path
from traceback import walk_tb
from typing import Any

from openpyxl import Workbook
from openpyxl.cell.cell import Cell, MergedCell
from openpyxl.descriptors.base import Descriptor
from openpyxl.reader.excel import ExcelReader
from openpyxl.utils.cell import range_boundaries

from workbook.book.address import Address, Place
from workbook.errors import ReadError, quoted
from workbook.reading.cells import fill_sheet, saved_values
from workbook.reading.contents import Cells, Contents, plain_value
from workbook.reading.guard import LOCKED, NOT_INSPECTED, Inspected, guard
from workbook.reading.package import StrippedArchive
from workbook.reading.rows import LAST_COLUMN, LAST_ROW, SAVE_AS, tag
from workbook.text_files import require_file

SUFFIXES = (".xlsx", ".xlsm", ".xltx", ".xltm")
MOST_CELLS = 200_000  # of the place of a name
BUILT = datetime(2020, 1, 1)
PROGRAMS = re.compile(r"(?:Microsoft )?(?:Macintosh )?Excel(?! Compatible)|LibreOffice")
EXPECTED: dict[Any, str] = {int: "a whole number", float: "a number", bool: "0 or 1", str: "a text"}


class LiteralText(str):
    """A text that looks like a formula, and that no program computes."""

    __slots__ = ()


def is_formula(held: Any) -> bool:
    """Whether what a cell holds is computed, not entered; a text that looks like a formula is none."""
    return isinstance(held, str) and held.startswith("=") and not isinstance(held, LiteralText)


@dataclass
class BookFile:
    """An opened workbook, with formulas as text, its defined names as places, and notes on what was left aside."""

    path: Path
    workbook: Workbook
    places: dict[str, Place]
    notes: list[str] = field(default_factory=list)
    # with formula cells; nothing of a workbook that is no file yet
    saved: Cells = field(default_factory=dict)
    # the rows of the sheet put into each table
    inserted: dict[str, tuple[int, ...]] = field(default_factory=dict)
    # where and how each table is torn that is not whole
    torn: dict[str, str] = field(default_factory=dict)
    inspected: Inspected = NOT_INSPECTED  # what openpyxl does not read
    bare: bool = False  # whether it is a copy of contents and names alone

    def value(self, address: Address) -> Any:
        """Return a cell's content: ``=text`` as :class:`LiteralText`, an array formula in braces in all its cells."""
        cell = self.cell(address)
        if cell is None:
            return None
        value = cell.value
        if type(value) is float:
            return value
        if isinstance(value, str) and cell.data_type != "f" and value.startswith("="):
            return LiteralText(value)
        arrays = self.contents.arrays
        if address in arrays:
            return arrays[address]
        return value if type(value) is str else plain_value(value, self.workbook.epoch)

    def named_value(self, name: str) -> tuple[Address | None, Any]:
        """Return the first cell that a name means, and its content; None for both where there is no such name."""
        cell = self.places[name].cell(0, 0) if name in self.places else None
        return cell, self.value(cell) if cell else None

    @property
    def as_built(self) -> bool:
        """Whether no program has saved the file since it was built: then its saved values are no evidence."""
        return bool(self.workbook.properties.modified == BUILT)

    @property
    def has_results(self) -> bool:
        """Whether saved values are results of the program that saved them, which asks for no computing at opening."""
        if self.as_built or not any(value is not None for value in self.saved.values()):
            return False
        # openpyxl takes an attribute that is not there for true
        settings = self.inspected.book.findall("{*}calcPr")
        return not any(held.get("fullCalcOnLoad") in ("1", "true") for held in settings)

    @property
    def is_evidence(self) -> bool:
        """Whether the saved values were computed by Excel, or by LibreOffice, which is an evaluator."""
        return self.has_results and bool(PROGRAMS.match(self.inspected.program))

    def cell(self, address: Address) -> Cell | MergedCell | None:
        """Return a cell, with its looks; None where the file has none."""
        return self._sheets[address.sheet].get((address.row, address.column))

    @cached_property
    def contents(self) -> Contents:
        """The constants and formulas of all cells, the formulas taken apart."""
        return Contents(self.workbook)

    @cached_property
    def _sheets(self) -> dict[str, dict[tuple[int, int], Cell | MergedCell]]:
        """The cells that the file has: asking openpyxl for another would create it."""
        return {sheet.title: sheet._cells for sheet in self.workbook.worksheets}


def open_book(path: Path) -> BookFile:
    """Open a workbook, or raise ReadError in a line."""
    require_file(path, "a workbook")
    if path.suffix.lower() not in SUFFIXES:
        known = ", ".join(SUFFIXES)
        raise ReadError(f"{path}: expected a workbook ending in {known}; save it as .xlsx first")
    return book_of(path, guard(path))


def book_of(path: Path, inspected: Inspected) -> BookFile:
    """Open a workbook that passed the guard, or raise ReadError in a line."""
    workbook = load_workbook(path, inspected)
    if not workbook.worksheets:
        raise ReadError(f"{path}: it has no worksheet; expected a workbook of motionbook")
    file = BookFile(path, workbook, find_places(workbook), inspected.notes, inspected=inspected)
    file.saved = saved_values(inspected)
    return file


def load_workbook(path: Path, inspected: Inspected) -> Workbook:
    """Let openpyxl read a file that passed the guard, but for rows and drawings; raise ReadError where it cannot."""
    part = ""
    try:
        with warnings.catch_warnings(), redirect_stdout(io.StringIO()):  # it prints a complaint
            # parts that openpyxl leaves aside are of no concern here
            warnings.simplefilter("ignore")
            reader = ExcelReader(str(path), keep_links=False)
            reader.archive.close()
            reader.archive = StrippedArchive(path, inspected.parts)
            try:
                reader.read()
            finally:
                part = reader.archive.part
            for sheet in reader.wb.worksheets:
                part = inspected.sheets[sheet.title].name
                fill_sheet(sheet, inspected.sheets[sheet.title], reader.shared_strings)
            return reader.wb
    except PermissionError as error:
        raise ReadError(f"{path}: {LOCKED}") from error
    except MemoryError as error:
        raise ReadError(f"{path}: too large for the memory of this machine") from error
    except Exception as error:  # openpyxl trusts the XML: what is amiss comes up as any of Python's
        fault = refused_attribute(error)
        raise ReadError(f"{path}: damaged: {part}: {fault}; {SAVE_AS}") from error


def refused_attribute(error: BaseException) -> str:
    """Return in a line the attribute, its value and what openpyxl expects there; its own message where it tells less.

    Its errors name neither part nor element: those are the locals of its functions that read an element (``from_tree``)
    and set an attribute (``__set__`` of a descriptor), in 3.1.5.
    """
    while error.__cause__ is not None:
        error = error.__cause__
    message = " ".join(str(error).split())
    element, refused = "", ""
    for frame, _ in walk_tb(error.__traceback__):
        held = frame.f_locals
        if frame.f_code.co_name == "from_tree" and hasattr(held.get("node"), "attrib"):
            element = f"<{tag(held['node'])}> "
        elif frame.f_code.co_name == "__set__" and isinstance(held.get("self"), Descriptor):
            rule, value = held["self"], held["value"]
            words = ", ".join(sorted(map(str, filter(None, getattr(rule, "values", ())))))
            kind = words or EXPECTED.get(getattr(rule, "expected_type", None), "another value")
            is_told = isinstance(error, ValueError) and not words
            expected = message if is_told else f"expected {kind}"
            what = f"lacks {rule.name}" if value is None else f"holds {rule.name} = {quoted(value)}"
            refused = f"{element}{what}; {expected}"
    if isinstance(error, IndexError | OverflowError):
        message = "a number in it is beyond the table that it counts in"
    return refused or f"{element}cannot be read: {message}"[:200]


def find_places(workbook: Workbook) -> dict[str, Place]:
    """Return the single rectangle that each defined name of the workbook means; names of other kinds are left out."""
    places = {}
    titles = {sheet.title.lower(): sheet.title for sheet in workbook.worksheets}
    for name, defined in workbook.defined_names.items():
        try:
            targets = list(defined.destinations)
        except Exception:  # noqa: S112 - openpyxl splits the text, and fails in many ways if it is no formula
            continue
        if len(targets) == 1:
            title = titles.get(str(targets[0][0]).replace("''", "'").lower())
            place = place_of(title, str(targets[0][1])) if title is not None else None
            if place is not None:
                places[name] = place
    return places


def place_of(sheet: str, cells: str) -> Place | None:
    """Return the rectangle of ``cells``; None for whole rows and columns, and for what lies on no sheet."""
    try:
        left, top, right, bottom = range_boundaries(cells)
    except ValueError:
        return None
    if left is None or top is None or right is None or bottom is None:
        return None
    place = Place(sheet, top, left, bottom - top + 1, right - left + 1)
    on_sheet = 1 <= top <= bottom <= LAST_ROW and 1 <= left <= right <= LAST_COLUMN
    return place if on_sheet and place.rows * place.columns <= MOST_CELLS else None


MOST_READ = 500_000_000  # cells that all formulas read together: in committed books 3, in the largest 160 million
# columns that all formulas of a file read together, an engineer's own among them
MOST_COLUMNS = 50_000_000


def require_narrow(file: BookFile) -> None:
    """Raise ReadError, in a line, where it would be much work to tell what the formulas of a file depend on."""
    if (read := file.contents.columns_read) > MOST_COLUMNS:
        advice = f"at most {MOST_COLUMNS:,} are expected: make their ranges narrower"
        raise ReadError(f"{file.path}: its formulas read {read:,} columns together; {advice}")


def require_little_work(file: BookFile, path: Path) -> None:
    """Raise ReadError where formulas of ``file``, the copy of ``path`` that is evaluated, read more than any book's."""
    if (read := file.contents.cells_read) > MOST_READ:
        advice = f"at most {MOST_READ:,} are expected: shorten their ranges"
        raise ReadError(f"{path}: its formulas read {read:,} cells together; {advice}")
