"""The contents of a workbook's cells: constants, and formulas, parsed once."""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from datetime import date, datetime, time, timedelta
from functools import cached_property
from typing import Any

from openpyxl import Workbook
from openpyxl.cell.cell import Cell, MergedCell
from openpyxl.utils.cell import column_index_from_string, range_boundaries
from openpyxl.utils.datetime import WINDOWS_EPOCH, to_excel
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.formula import ArrayFormula

from workbook.book.address import Address
from workbook.book.columns import Formulas, Moved, Moving, Pattern
from workbook.book.formula import (
    LAST_COLUMN,
    LAST_ROW,
    REFERENCE,
    Area,
    Formula,
    FormulaError,
    anchors,
    reference,
    unquoted,
    words,
)

Cells = dict[Address, Any]
Wanted = Mapping[tuple[str, int], list[int]]
"""cells that are asked for: the sorted rows of each column of a sheet"""
# formulas by patterns, in which rows; those with none
Patterns = tuple[list[tuple[Pattern, list[int]]], list[Formula]]


class Contents:
    """A workbook's cells, read once, with their formulas; cached values are never asked for."""

    def __init__(self, workbook: Workbook) -> None:
        self.constants: Cells = {}
        self.formulas: dict[Address, Formula | Moved] = {}
        self.failed: Cells = {}  # the error values that formulas stand for which cannot be taken apart
        self.problems: dict[Address, str] = {}  # why, in a line
        # the text of a formula over several cells, or of another kind, in each
        self.arrays: dict[Address, str] = {}
        self.texts: dict[Address, str] = {}  # of those that cannot be taken apart
        self._tables = {
            table.name.casefold(): area_of(sheet.title, table.ref)
            for sheet in workbook.worksheets
            for table in sheet.tables.values()
        }
        self._titles = {title.casefold(): title for title in workbook.sheetnames}
        self._names = name_texts(workbook)
        self._epoch = workbook.epoch
        for sheet in workbook.worksheets:
            formulas = Formulas(sheet.title, self.area)
            # the cells that the file has: its dimensions may be absurd, and iter_rows() would make all of them
            for (row, column), cell in sheet._cells.items():
                self._take(Address(sheet.title, row, column), cell, formulas)

    @property
    def formula_cells(self) -> list[Address]:
        """The addresses of all formula cells, those included that cannot be taken apart."""
        return [*self.formulas, *self.failed]

    def read(self, cells: Collection[Address], by: Iterable[Address] | None = None) -> set[Address]:
        """Return those of ``cells`` to which some formula refers, or any of the formulas in the cells ``by``."""
        by = set(self.formula_cells if by is None else by)
        wanted = defaultdict[tuple[str, int], list[int]](list)
        for sheet, row, column in sorted(cells):
            wanted[sheet, column].append(row)
        patterns = grouped_by_pattern(self.formulas[a] for a in by if a in self.formulas)
        rough = (area for cell in self.failed.keys() & by for area in self.rough_areas(cell))
        return {*referenced_cells(patterns, wanted), *cells_within(rough, wanted)}

    def rough_areas(self, address: Address) -> list[Area]:
        """Return the cells that a formula reads which cannot be taken apart, as far as its words tell."""
        areas: list[Area] = []
        left, met = [self.texts[address].strip("{}")], set[str]()
        while left:
            for kind, word in words(left.pop()):
                key = word.rpartition("!")[2].casefold()
                with suppress(FormulaError):
                    if kind == "reference":
                        areas.append(reference(word, address.sheet, self.area))
                    elif kind == "lines":
                        areas.append(self._lines(word, address.sheet))
                    elif key in self._tables:
                        areas.append(self._tables[key])
                    elif word == "[":
                        areas += [table for table in self._tables.values() if table.holds(address)]
                    elif kind == "name" and key not in met:
                        met.add(key)
                        left += filter(None, [self.name_text(key, address.sheet)])
        return areas

    def name_text(self, name: str, sheet: str) -> str | None:
        """Return the text of a defined name on a sheet, the sheet's own before the workbook's; None for no name."""
        key = name.casefold()
        return self._names.get((sheet.casefold(), key), self._names.get((None, key)))

    def knows(self, name: str, sheet: str) -> bool:
        """Whether a word is a defined name on a sheet, or a table's."""
        return name.casefold() in self._tables or self.name_text(name, sheet) is not None

    def _lines(self, text: str, sheet: str) -> Area:
        before, mark, lines = text.rpartition("!")
        title = self.area(f"{unquoted(before)}!", sheet).sheet if mark else sheet
        ends = lines.replace("$", "").upper().split(":")
        if ends[0].isdigit():
            return Area(title, int(ends[0]), 1, int(ends[1]), LAST_COLUMN, single=False)
        left, right = map(column_index_from_string, ends)
        return Area(title, 1, left, LAST_ROW, right, single=False)

    @cached_property
    def patterns(self) -> Patterns:
        """The patterns of all formulas."""
        return grouped_by_pattern(self.formulas.values())

    @cached_property
    def cells_read(self) -> int:
        """The number of cells that formulas read together, each as often as it is read: running sums grow."""
        return sum(area.size * times for area, times in areas_read(self.patterns))

    @cached_property
    def columns_read(self) -> int:
        """The number of columns that formulas read together."""
        return sum(len(area.columns) * times for area, times in areas_read(self.patterns))

    def needed(self, cells: Collection[Address], by: Collection[Address]) -> set[Address]:
        """Return those of the formula ``cells`` on which those ``by`` depend; all if any of these cannot be parsed."""
        left, needed, last = set(cells), set[Address](), set(by)
        while last and left:
            last = left if any(a in self.failed for a in last) else self.read(left, last)
            needed |= last
            left = left - last
        return needed

    def area(self, name: str, sheet: str) -> Area:
        """Resolve a defined name, the sheet's own before the workbook's; or ``title!`` to the sheet of that title."""
        if name.endswith("!"):
            title = self._titles.get(name[:-1].casefold())
            if title is None:
                kind = "is in another file" if "[" in name else "is no sheet of this workbook"
                raise FormulaError("#REF!", f"{name[:-1]} {kind}")
            return Area(title, 1, 1, 1, 1, single=True)
        text = self.name_text(name, sheet)
        if text is None or not REFERENCE.fullmatch(text):
            raise FormulaError("#NAME?", f"the name {name} does not lead to cells")
        if anchors(text) not in ("$c$r", "$c$r:$c$r"):
            raise FormulaError("#NAME?", f"the name {name} moves with the cell that uses it")
        area = reference(text, sheet, self.area)
        return area._replace(single=area.size == 1)

    def _take(self, address: Address, cell: Cell | MergedCell, formulas: Formulas) -> None:
        if cell.data_type != "f":
            if cell.value is not None:
                self.constants[address] = plain_value(cell.value, self._epoch)
            return
        value, at = cell.value, address.a1
        if isinstance(value, ArrayFormula) and value.ref in (at, f"{at}:{at}"):
            # arrays are computed in every formula, and of a result the first cell is taken; LibreOffice writes A1:A1
            value = self.arrays[address] = str(value.text)
        try:
            # Excel writes so where the array is computed each time
            if value == "=" and address in self.arrays:
                why = "a cell that an array fills is not evaluated by itself"
                raise FormulaError("#VALUE!", why)
            if not isinstance(value, str):  # it fills several cells
                text = self.arrays[address] = f"{{{getattr(value, 'text', None) or '=TABLE()'}}}"
                with suppress(FormulaError):
                    area = reference(str(getattr(value, "ref", "")), address.sheet, self.area)
                    self.arrays |= dict.fromkeys(area.cells(), text)
                kind = type(value).__name__
                raise FormulaError("#VALUE!", f"a formula of the kind {kind} is not evaluated")
            self.formulas[address] = formulas.read(value, address.row)
        except FormulaError as error:
            self.failed[address] = error.value
            self.texts[address] = self.arrays.get(address) or str(value)
            self.problems[address] = str(error)


def area_of(sheet: str, ref: str) -> Area:
    """Return the area of a range such as ``A1:B4``."""
    left, top, right, bottom = (int(bound or 1) for bound in range_boundaries(ref))
    return Area(sheet, top, left, bottom, right, single=False)


def referenced_cells(formulas: Patterns, wanted: Wanted) -> Iterator[Address]:
    """Yield the cells that formulas refer to among ``wanted``, the sorted rows of each column of a sheet."""
    patterns, others = formulas
    areas = {a for formula in others for a in formula.arguments if isinstance(a, Area)}
    for pattern, rows in patterns:
        areas |= {a for a in pattern.arguments if isinstance(a, Area)}
        for a in {a for a in pattern.arguments if isinstance(a, Moving)}:
            if a.area.single and a.top is not None:
                sheet, column = a.area.sheet, a.area.left
                read, known = {row + a.top for row in rows}, wanted.get((sheet, column), ())
                yield from (Address(sheet, row, column) for row in known if row in read)
            elif any((a.area.sheet, c) in wanted for c in a.area.columns):
                areas.update(map(a.at, rows))
    yield from cells_within(areas, wanted)


def cells_within(areas: Iterable[Area], wanted: Wanted) -> Iterator[Address]:
    """Yield the ``wanted`` cells, the sorted rows of each column of a sheet, that are in any of the areas."""
    for (sheet, left, right), spans in merged_rows(areas).items():
        for column in range(left, right + 1):
            known = wanted.get((sheet, column), [])
            for top, bottom in spans if known else ():
                rows = known[bisect_left(known, top) : bisect_right(known, bottom)]
                yield from (Address(sheet, row, column) for row in rows)


def merged_rows(areas: Iterable[Area]) -> dict[tuple[str, int, int], list[tuple[int, int]]]:
    """Return areas by sheet and columns, as ranges of rows merged where they overlap, as in running sums."""
    merged: dict[tuple[str, int, int], list[tuple[int, int]]] = {}
    for sheet, top, left, bottom, right, _ in sorted(areas):
        rows = merged.setdefault((sheet, left, right), [])
        if rows and top <= rows[-1][1]:
            rows[-1] = rows[-1][0], max(rows[-1][1], bottom)
        else:
            rows.append((top, bottom))
    return merged


def grouped_by_pattern(formulas: Iterable[Formula | Moved]) -> Patterns:
    """Return each pattern of formulas with the rows in which it stands, and the formulas that have none."""
    patterns: dict[int, tuple[Pattern, list[int]]] = {}
    others = []
    for formula in formulas:
        if isinstance(formula, Moved):
            pattern, row = formula
            known = patterns.get(id(pattern)) or patterns.setdefault(id(pattern), (pattern, []))
            known[1].append(row)
        else:
            others.append(formula)
    return list(patterns.values()), others


def areas_read(formulas: Patterns) -> Iterator[tuple[Area, int]]:
    """Yield the areas that formulas read, each with how often it is read, or an area of its size."""
    patterns, others = formulas
    yield from ((a, 1) for formula in others for a in formula.arguments if isinstance(a, Area))
    for pattern, rows in patterns:
        for a in pattern.arguments:
            if isinstance(a, Moving) and (a.top is None) != (a.bottom is None) and not a.area.single:
                yield from ((a.at(row), 1) for row in rows)
            elif not isinstance(a, str):
                yield a.area if isinstance(a, Moving) else a, len(rows)


def name_texts(workbook: Workbook) -> dict[tuple[str | None, str], str]:
    """Return the texts of all defined names by sheet (None for the workbook's) and name, case-folded."""
    scopes: dict[str | None, Mapping[str, DefinedName]] = {None: workbook.defined_names}
    scopes |= {sheet.title.casefold(): sheet.defined_names for sheet in workbook.worksheets}
    return {
        (scope, name.casefold()): str(defined.attr_text).removeprefix("=")
        for scope, names in scopes.items()
        for name, defined in names.items()
    }


def plain_value(value: Any, epoch: datetime = WINDOWS_EPOCH) -> Any:
    """Return the content of a cell without a formula as formulas see it: dates and times are numbers."""
    if value is None or type(value) in (float, int, bool, str):
        return value
    if isinstance(value, date | datetime | time | timedelta):
        return float(to_excel(value, epoch))  # type: ignore[no-untyped-call]
    if hasattr(value, "item"):
        return plain_value(value.item())  # a number of NumPy's
    return float(value) if hasattr(value, "__float__") else str(value)


def plain_label(text: str) -> str:
    """Return a label without what people write in different ways: case, blanks, a colon behind it."""
    return " ".join(text.split()).rstrip(" :=").casefold()
