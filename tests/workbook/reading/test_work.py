"""A limit of work for each file: what its formulas read together, and what their arrays hold, is bounded."""

import time

import openpyxl
import pytest
from openpyxl.utils import get_column_letter

from workbook.build import COMMITTED
from workbook.errors import ReadError
from workbook.reading import files
from workbook.reading.contents import Contents
from workbook.reading.entries import Entries
from workbook.reading.files import BookFile, open_book
from workbook.template import FOLDER
from workbook.witnesses.agreement import agreed_values
from workbook.witnesses.pycel import limits
from workbook.witnesses.pycel.model import PycelModel

SECONDS = 20
WIDE = f"J1:{get_column_letter(5_009)}1"


@pytest.fixture
def page():
    """A sheet with 5,000 numbers in a column, and as many in a row."""
    made = openpyxl.Workbook()
    for i in range(1, 5_001):
        made.active.cell(i, 1).value = made.active.cell(1, 9 + i).value = i
    return made.active


def test_cells_are_counted_as_often_as_they_are_read(page):
    page["C1"] = "=SUM(A1:A10)+A1"
    for row in range(2, 12):
        page.cell(row, 4).value = f"=SUM($A$1:A{row})+B{row}+SUM(A$1:B$3)"
    contents = Contents(page.parent)
    assert contents.cells_read == 11 + sum(row + 1 + 6 for row in range(2, 12))


def test_more_work_than_any_book_is_refused_in_one_line(page, tmp_path):
    for row in range(1, 4_001):
        page.cell(row, 3).value = f"=SUM($A$1:$A$160000)+{row}"
    file = BookFile(tmp_path / "book.xlsx", page.parent, {})
    begin = time.process_time()
    with pytest.raises(ReadError, match=r"book.xlsx: its formulas read 640,000,000 cells") as caught:
        files.require_little_work(file, file.path)
    assert "\n" not in str(caught.value)
    assert time.process_time() - begin < SECONDS


def test_formulas_over_more_columns_than_any_books_are_refused_in_one_line(page, tmp_path):
    for row in range(2, 4_002):
        page.cell(row, 3).value = f"=SUM($A$1:$XFD${row})"
    with pytest.raises(ReadError, match=r"book.xlsx: its formulas read 65,536,000 columns"):
        Entries(BookFile(tmp_path / "book.xlsx", page.parent, {}), agreed_values)


def test_books_are_far_from_the_limit():
    for name in COMMITTED:  # in git, so that a fresh clone has them
        file = open_book(FOLDER / f"{name}.xlsx")
        assert file.contents.cells_read < files.MOST_READ / 20
        files.require_narrow(file)


@pytest.mark.parametrize(
    "formula",
    [
        f"SUMPRODUCT(A1:A5000*{WIDE})", f"SUM(IF(A1:A5000,{WIDE},0))", f"SUM((A1:A5000={WIDE})*1)",
        f"SUM(IF(A1:A5000>{WIDE},1,0))", "SUM(MATCH(A1:A5000,A1:A5000,0))", "SUM(MATCH(1*A1:A5000,A1:A5000,0))",
        "SUM(VLOOKUP(A1:A5000,A1:B5000,2,0))", f"SUM(A1:A5000^{WIDE})", f"SUM(A1:A5000-{WIDE}-A1:A5000)",
    ],
)  # fmt: skip
def test_arrays_are_refused_before_they_are_made(formula, page):
    for row in range(1, 101):
        page.cell(row, 4).value = f"={formula}+{row}"
    model = PycelModel(Contents(page.parent))
    begin = time.process_time()
    values = model.evaluate()
    assert time.process_time() - begin < SECONDS
    assert set(values.values()) == {"#VALUE!"}
    assert all(f"over {limits.MOST_CROSSED:,} cells" in problem for problem in model.problems.values())


def test_each_evaluation_has_its_own_measure(page):
    for row in range(1, 3):
        page.cell(row, 4).value = f"=SUMPRODUCT(A1:A500*J1:AF1)+{row}"
    model = PycelModel(Contents(page.parent))
    first = model.evaluate()
    assert all(isinstance(value, float | int) for value in first.values())
    for _ in range(40):
        assert model.evaluate() == first
