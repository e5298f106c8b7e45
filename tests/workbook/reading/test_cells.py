"""The cells that the guard met are those that openpyxl reads of its own, in our books and in all that Excel writes."""

from datetime import datetime
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook
from openpyxl.cell.cell import MergedCell
from openpyxl.comments import Comment
from openpyxl.styles import Font
from openpyxl.worksheet.formula import ArrayFormula

from tests.workbook.judging.hands import repacked, sub
from workbook.build import COMMITTED
from workbook.reading.files import open_book
from workbook.template import FOLDER

BOOKS = [FOLDER / f"{name}.xlsx" for name in COMMITTED]


def cells_of(workbook: Workbook) -> dict[tuple[str, int, int], tuple[object, ...]]:
    """What each cell of a workbook holds and looks like; a number, whatever date it is shown as."""
    return {
        (sheet.title, *place): (cell.value, type(cell.value), cell.data_type, cell.number_format, cell.font.b)
        for sheet in workbook.worksheets
        for place, cell in sheet._cells.items()
        if not isinstance(cell, MergedCell)
    }


def looks_of(workbook: Workbook) -> dict[tuple[str, int], tuple[object, ...]]:
    """What each row that has looks of its own looks like."""
    return {
        (sheet.title, row): (look.height, look.hidden, look.outlineLevel, look.font.b)
        for sheet in workbook.worksheets
        for row, look in sheet.row_dimensions.items()
    }


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
@pytest.mark.sample(2)
def test_a_book_has_the_cells_that_openpyxl_reads(path: Path) -> None:
    ours, theirs = open_book(path).workbook, load_workbook(path)
    assert cells_of(ours) == cells_of(theirs)
    assert looks_of(ours) == looks_of(theirs)


@pytest.fixture
def odd(tmp_path: Path) -> Path:
    """A book of everything that a cell may be."""
    workbook = Workbook()
    sheet = workbook.active
    sheet.append([1, -2.5, "text", True, None, "=A1+B1", "#N/A", " kept ", 1e300])
    sheet["B3"] = ArrayFormula("B3:B4", "=A1:A2*2")
    sheet["C3"] = datetime(2026, 1, 2)
    sheet["C3"].number_format = "General"
    sheet["D3"], sheet["E3"] = "merged", "hidden by it"
    sheet.merge_cells("D3:F4")
    sheet["G3"] = "link"
    sheet["G3"].hyperlink = "https://example.org"
    sheet["G4"].comment = Comment("a note on an empty cell", "me")
    sheet["A6"] = "bold"
    sheet["A6"].font = Font(bold=True)
    sheet.row_dimensions[6].height = 33
    sheet.row_dimensions[7].hidden = True
    workbook.create_sheet("Empty")
    workbook.save(tmp_path / "odd.xlsx")
    return tmp_path / "odd.xlsx"


def test_each_kind_of_cell_is_read_as_openpyxl_reads_it(odd: Path) -> None:
    ours, theirs = open_book(odd).workbook, load_workbook(odd)
    mine, other = cells_of(ours), cells_of(theirs)
    array = ("Sheet", 3, 2)
    for found in (mine[array][0], other[array][0]):
        assert (found.ref, found.text) == ("B3:B4", "=A1:A2*2")
    del mine[array], other[array]
    assert mine == other
    assert looks_of(ours) == looks_of(theirs)
    assert ours["Sheet"]["G3"].hyperlink.target == "https://example.org"
    assert ours["Sheet"]["G4"].comment.text == "a note on an empty cell"
    assert ours["Sheet"].merged_cells.ranges == theirs["Sheet"].merged_cells.ranges


@pytest.mark.parametrize("new", [
    '<c r="A6" t="inlineStr"><is><t>bold</t></is></c>',
    '<c r="A6" t="inlineStr"><is><r><rPr><b/></rPr><t>bo</t></r><r><t>ld</t></r></is></c>',
    '<c r="A6" t="inlineStr"><is><t>漢</t><rPh sb="0" eb="1"><t>kan</t></rPh></is></c>',
    '<c r="A6"><f t="shared" ref="A6:A7" si="0">B$1+A1</f></c></row><row r="7"><c r="A7"><f t="shared" si="0"/></c>',
    '<c r="A6" t="str"><f>"a"&amp;"b"</f><v>ab</v></c>',
    '<c r="A6" t="b"><v>0</v></c><c><v>7</v></c>',
    '<c r="A6" t="d"><v>2026-01-02T00:00:00</v></c>',
    '<c r="A6" t="e"><v>#REF!</v></c>',
    '<c r="A6"><v>+1.50E+2</v></c>',
    '<c r="A6"><v/></c>',
], ids=str)  # fmt: skip
def test_each_way_of_writing_a_cell_is_read_as_openpyxl_reads_it(odd: Path, new: str) -> None:
    last = sub(rb'<c r="A6".*(?=</sheetData>)', f"{new}</row>".encode())
    made = repacked(odd, odd.with_name("rewritten.xlsx"), {"xl/worksheets/sheet1.xml": last})
    mine, other = cells_of(open_book(made).workbook), cells_of(load_workbook(made))
    array = ("Sheet", 3, 2)
    del mine[array], other[array]
    assert mine == other
