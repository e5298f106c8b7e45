"""A program of another maker reads each value of a book as openpyxl does."""

import openpyxl
import pytest

from tests.tiers import by_day
from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as
from workbook.build import build


@pytest.fixture(scope="module", params=by_day(DESCRIBED, COMPOSED))
def book(request, tmp_path_factory):
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(committed_as(request.param)[1], path)
    return path


def spoken(value):
    """The value of a cell; None for a text of no letters, which some programs tell from nothing."""
    return None if value == "" else value


def contents(path):
    """The value of each cell that has any, by sheet and place."""
    sheets = openpyxl.load_workbook(path, data_only=True)
    return {
        (sheet.title, cell.coordinate): spoken(cell.value)
        for sheet in sheets for row in sheet.iter_rows() for cell in row if cell.value is not None
    }  # fmt: skip


def test_calamine_reads_every_value(book):
    calamine = pytest.importorskip("python_calamine")
    read = calamine.load_workbook(str(book))
    pages = {name: read.get_sheet_by_name(name).to_python(skip_empty_area=False) for name in read.sheet_names}
    wrong = {}
    for (sheet, place), value in contents(book).items():
        column, row = openpyxl.utils.cell.coordinate_from_string(place)
        cells = pages[sheet][row - 1] if row <= len(pages[sheet]) else []
        across = openpyxl.utils.column_index_from_string(column) - 1
        found = cells[across] if across < len(cells) else None
        if spoken(found) != value:
            wrong[sheet, place] = value, found
    assert not wrong
