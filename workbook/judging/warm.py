"""The values of a book that is edited, judged after each save with what stays the same from save to save.

That are parts of the file, formulas, taken apart and compiled, and the values of cells that depend on no other entry.
What is shown, and formulas at other entries, :func:`workbook.judging.verify.verify` judges.
"""

import io
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import tostring

from openpyxl.cell.cell import MergedCell
from openpyxl.reader.strings import read_string_table

from workbook.book.address import Address
from workbook.book.declare import Book
from workbook.entries.machine import Machine
from workbook.errors import MotionbookError
from workbook.judging.comparison import Comparison, count_cells
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.judging.structure import check_structure, refuse_cut_cells
from workbook.judging.verify import check_results
from workbook.reading.cells import TEXTS, cell_content, saved_values
from workbook.reading.contents import Cells, plain_value
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, book_of, require_little_work
from workbook.reading.guard import Inspected, Scans, guard
from workbook.reading.rows import RawCell, tag
from workbook.witnesses.agreement import agreed_values
from workbook.witnesses.registry import WITNESSES
from workbook.witnesses.witness import CellWitness, Model

# elements of the workbook's part on which values rest
NAMING = frozenset({"workbookPr", "sheet", "definedName"})


class OtherBookError(MotionbookError):
    """A save that has to be judged as a whole: more than contents of cells is new."""


@dataclass
class Judged:
    """The entries of a save, what its book should hold, and the report on the values of its cells."""

    machine: Machine
    declared: Book
    report: Report


class WarmBook:
    """A book that is edited, as its latest save has it."""

    def __init__(self) -> None:
        self._scans = Scans()
        self._match: Match | None = None
        self._model: Model | None = None
        self._cells: list[Address] = []  # for which the model takes values

    def judge_values(self, path: Path) -> Judged:
        """Return what comes of the values of a save; raise MotionbookError where only ``verify`` can judge it."""
        # a save that raises an error leaves nothing to the next
        match, self._match = self._match, None
        file = match.file if match else None
        inspected = guard(path, self._scans)
        was = file.inspected if file else None
        cells = changed_cells(was, inspected) if was else None
        if file is None or cells is None:
            match, file, entered, self._model = None, book_of(path, inspected), Cells(), None
        else:
            entered = enter_cells(file, inspected, cells)
        # of unchanged formulas no cell was cut
        entries = Entries(file, agreed_values, refuse_cut_cells if self._model is None else None)
        if file.torn or file.inserted:
            raise OtherBookError(f"{path}: rows were put into its tables")
        machine = entries.machine()
        declared = entries.template.declare(machine)
        match = match.again(declared, entered) if match else Match(file, declared)
        report = Report(path, entries.template.name)
        self._compare(match, report, entered)
        exact = entries.template.judge(machine)
        report.checks = [check.judged(exact) for check in report.checks]
        self._match = match
        return Judged(machine, match.declared, report)

    def _compare(self, match: Match, report: Report, entered: Cells) -> None:
        """Enter the findings on the values of a file; ``entered`` are the contents that changed since the last save."""
        check_structure(match, report)
        require_little_work(match.file, match.file.path)
        witnesses = [make() for make in WITNESSES.values()]
        single = next(witness for witness in witnesses if isinstance(witness, CellWitness))
        cells = [pair.address for pair in match.pairs]
        if self._model is None or cells != self._cells:
            self._model, self._cells = single.model(match.file, cells), cells
        else:
            self._model.enter(entered)
        comparison = Comparison(match, match.file, single, self._model, report)
        for witness in (single, *(witness for witness in witnesses if witness.kept)):
            comparison.ask(witness)
        report.checks = check_results(match, comparison.values)
        count_cells(match, report)


def changed_cells(was: Inspected, inspected: Inspected) -> dict[Address, RawCell] | None:
    """Return the cells without formulas that may hold something else in another save; None where more is new."""
    if naming(was) != naming(inspected) or was.sheets.keys() != inspected.sheets.keys():
        return None
    has_other_texts = was.strings is not inspected.strings
    changed = {}
    for title, rows in inspected.sheets.items():
        old = was.sheets[title]
        if rows is old and not has_other_texts:
            continue
        if list(map(shape, old.written)) != list(map(shape, rows.written)):
            return None
        for cell, now in zip(old.written, rows.written, strict=True):
            if now.how is None and (cell != now or (has_other_texts and now.kind == "s")):
                changed[Address(title, *now[:2])] = now
    return changed


def shape(cell: RawCell) -> tuple[Any, ...]:
    """Return a cell without its looks and its value."""
    return cell.row, cell.column, cell.how, cell.formula


def naming(inspected: Inspected) -> list[Any]:
    """Return the names of a file and the titles of its sheets, as its part for the workbook has them."""
    return [(e.tag, e.attrib, e.text) for e in inspected.book.iter() if tag(e) in NAMING]


def enter_cells(file: BookFile, inspected: Inspected, cells: dict[Address, RawCell]) -> Cells:
    """Enter what another save of a file has in these cells; return what of their contents is new."""
    has_texts = any(cell.kind == "s" for cell in cells.values())
    texts = list(map(str, read_string_table(io.BytesIO(tostring(inspected.strings))))) if has_texts else []
    contents, entered = file.contents, Cells()
    for address, now in cells.items():
        cell: Any = file.cell(address)
        content = cell_content(now, texts)
        if isinstance(cell, MergedCell) or (content == cell.value and type(content) is type(cell.value)):
            continue
        cell._value, cell.data_type = content, TEXTS.get(now.kind, now.kind)
        contents.constants.pop(address, None)
        entered[address] = plain_value(content, file.workbook.epoch)
        if content is not None:
            contents.constants[address] = entered[address]
    file.notes, file.saved, file.inspected = inspected.notes, saved_values(inspected), inspected
    return entered
