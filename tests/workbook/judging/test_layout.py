"""Rows and columns inserted and deleted, cells cut and pasted: understood, or one finding that names where."""

import re
from datetime import UTC, datetime
from html import unescape

import openpyxl
import pytest
from openpyxl.utils import column_index_from_string

from tests import cutting
from tests.workbook import excel
from tests.workbook.judging.test_real_edits import numbers
from workbook.build import build, read_inputs
from workbook.errors import InputError, ReadError
from workbook.judging.batch import Outcome
from workbook.judging.verify import verify
from workbook.reports.console import report_data
from workbook.reports.page import junit, page

CUTTING = ("OWN_pieces", "axis1", "axis2", "drive1_parts", "motors", "reducers", "cycle1")
TABLES = [("press", "axis1"), *(pytest.param("cutting", table, marks=pytest.mark.nightly) for table in CUTTING)]


@pytest.fixture(scope="module")
def books(press, tmp_path_factory):
    made = {"press": press.path}

    def of(name):
        if name not in made:
            made[name] = tmp_path_factory.mktemp(name) / "book.xlsx"
            build(cutting.small(phases=8), made[name])
        return made[name]

    return of


def place(path, name):
    """Sheet, first and last row, first and last column letters of a block."""
    title, span = openpyxl.load_workbook(path).defined_names[name].attr_text.split("!")
    left, top, right, bottom = re.fullmatch(r"\$([A-Z]+)\$(\d+):\$([A-Z]+)\$(\d+)", span).groups()
    return title.strip("'"), int(top), int(bottom), left, right


def edited(path, folder, *edits):
    workbook = openpyxl.load_workbook(path)
    for edit in edits:
        excel.edited(workbook, edit)
    return excel.save(workbook, folder / "edited.xlsx")


def sums(report):
    """The report, in which each declared cell is counted once for each witness."""
    for ran in report.witnesses:
        assert not ran.answered or ran.compared + ran.at_fault + ran.unfinished == report.declared
    return report


def one(report, sheet, cell, *words):
    """The one finding: where, and what it says, in all that is reported."""
    (found,) = sums(report).causes
    assert (found.kind, found.sheet, found.cell) == ("layout", sheet, cell)
    for word in words:
        assert word in f"{found.computed} {found.expected} {found.what}"
    data = report_data(report)
    assert [f["cell"] for f in data["findings"] if f["kind"] != "follows"] == [cell]
    outcome, when = Outcome(report.path, "disagrees", report), datetime(2026, 1, 1, tzinfo=UTC)
    for text in (page([outcome], when), junit([outcome], when)):
        assert found.computed in unescape(text)
    return found


def understood(report, *noticed):
    told = sums(report).findings + [f for f in report.notices if f.computed not in noticed]
    assert [f"{f.sheet}!{f.cell} {f.kind} {f.computed}" for f in told] == []
    assert report.compared == report.declared


@pytest.mark.parametrize(("name", "table"), [*TABLES, ("press", "motors")])
def test_a_row_inserted_in_a_table_is_one_finding(name, table, books, tmp_path):
    path = books(name)
    sheet, first, last, *_ = place(path, table)
    for row, count in ((first + 1, 1), (first + 1, 3), (last, 1)):
        report = verify(edited(path, tmp_path, excel.Lines(sheet, row, count)))
        found = one(report, sheet, f"{row}:{row + count - 1}", f"{row}", "inserted", "delete", "spare row", table)
        assert found.sheet == sheet
        assert numbers(read_inputs(report.path)[0]) == numbers(read_inputs(path)[0])


@pytest.mark.parametrize(("name", "table"), [*TABLES, ("press", "motors")])
def test_rows_above_and_below_a_table_and_columns_within_are_understood(name, table, books, tmp_path):
    path = books(name)
    sheet, first, last, *_ = place(path, table)
    for edit in (excel.Lines(sheet, first, 2), excel.Lines(sheet, last + 1, 2), excel.Lines(sheet, 4, 1, columns=True)):
        made = edited(path, tmp_path, edit)
        understood(verify(made))
        assert numbers(read_inputs(made)[0]) == numbers(read_inputs(path)[0])


@pytest.mark.parametrize(
    ("name", "table"), [*TABLES, ("press", "motors"), ("press", "axis2_workings"), ("press", "cycle1")]
)
def test_a_row_deleted_from_a_table_is_one_line_that_says_where(name, table, books, tmp_path):
    path = books(name)
    sheet, first, last, *_ = place(path, table)
    unnumbered = table in ("motors", "reducers")  # of these no row says which it is
    for row in (first, first + 1, last):
        made = edited(path, tmp_path, excel.Lines(sheet, row, -1))
        told = last if unnumbered else row
        line = refused(made)
        for word in (f"{sheet}: ", f"a row is gone above row {told}", "undo", table.removesuffix("_workings")):
            assert word in line


def with_copied_row(path, folder, columns):
    """The first row of a table's columns copied into a row put in below it: the file, its sheet and that row."""
    sheet, first, *_ = place(path, "axis2")
    workbook, row = openpyxl.load_workbook(path), first + 1
    tab = excel.edited(workbook, excel.Lines(sheet, row, 1))[sheet]
    for column in columns:
        tab.cell(row, column).value = tab.cell(first, column).value
    workbook.save(folder / "edited.xlsx")
    return folder / "edited.xlsx", sheet, row


def test_a_copied_row_put_into_a_table_is_one_too_many(books, tmp_path):
    path, sheet, row = with_copied_row(books("press"), tmp_path, range(2, 22))
    assert f"{sheet}: a row is too many at row {row}, of axis2" in refused(path)


def test_other_faults_are_still_told_beside_an_inserted_row(books, tmp_path):
    path = books("press")
    sheet, first, *_ = place(path, "axis2")
    workbook = excel.edited(openpyxl.load_workbook(path), excel.Lines(sheet, first + 2, 1))
    cell = next(c for c in workbook[sheet][first] if "timing_rate" in str(c.value))
    cell.value += "*2"
    workbook["Drive MC01"]["F6"].value = "=1+1"
    workbook.save(tmp_path / "edited.xlsx")
    kinds = [(f.kind, f.cell) for f in sums(verify(tmp_path / "edited.xlsx")).findings]
    assert kinds[0] == ("layout", f"{first + 2}:{first + 2}")
    assert ("formula", cell.coordinate) in kinds


def test_a_deleted_column_is_one_line_with_its_heading(books, tmp_path):
    path = books("press")
    line = refused(edited(path, tmp_path, excel.Lines("Timing", 8, -1, columns=True)))
    assert "Timing: a column is gone before column H: 'end', of axis1, axis2; undo" in line
    sheet, _, _, left, _ = place(path, "cycle1")
    second = column_index_from_string(left) + 1
    with pytest.raises(InputError, match="Drive MC01: a column is gone before column C: 'position', of cycle1; undo"):
        verify(edited(path, tmp_path, excel.Lines(sheet, second, -1, columns=True)))


MOVED = {
    "entries": ("C{top}:F{bottom}", 0, 45),
    "workings": ("N{top}:N{bottom}", 0, 45),
    "one cell": ("E{second}:E{second}", 0, 45),
    "a row": ("B{second}:H{second}", 0, 45),
    "entries of a row, down": ("C{second}:F{second}", 900, 3),
}


def refused(path):
    """The line in which a book is refused."""
    with pytest.raises((ReadError, InputError)) as refusal:
        verify(path)
    (line,) = getattr(refusal.value, "lines", [str(refusal.value)])
    return line


@pytest.mark.parametrize("cells", MOVED.values(), ids=MOVED.keys())
def test_part_of_a_table_cut_and_pasted_is_refused_with_what_to_undo(cells, books, tmp_path):
    path = books("press")
    sheet, top, bottom, *_ = place(path, "axis2")
    span = cells[0].format(top=top, second=top + 1, bottom=bottom)
    line = refused(edited(path, tmp_path, excel.Cut(sheet, span, *cells[1:])))
    assert f"{sheet}!" in line
    for word in ("axis2", "was cut: formulas read", "undo", "cut and paste it back"):
        assert word in line


def test_results_that_no_formula_reads_are_missing_where_they_were_cut(books, tmp_path):
    path = books("press")
    sheet, top, bottom, *_ = place(path, "axis2")
    report = verify(edited(path, tmp_path, excel.Cut(sheet, f"G{top}:H{bottom}", 0, 45)))
    missing = {found.cell for found in report.findings if found.kind == "missing"}
    assert missing == {f"{column}{row}" for column in "GH" for row in range(top, bottom + 1)}


def test_a_whole_table_cut_and_pasted_with_its_headings_is_understood(books, tmp_path):
    path = books("press")
    sheet, top, bottom, _, _ = place(path, "axis2")
    *_, right = place(path, "axis2_messages")
    for down, across in ((0, 45), (900, 0)):
        made = edited(path, tmp_path, excel.Cut(sheet, f"A{top - 7}:{right}{bottom + 9}", down, across))
        understood(verify(made), "without it")  # the print area stays where it is
        assert numbers(read_inputs(made)[0]) == numbers(read_inputs(path)[0])


def test_a_table_cut_and_pasted_without_its_headings_is_one_finding(books, tmp_path):
    path = books("press")
    sheet, top, bottom, left, right = place(path, "axis2")
    line = refused(edited(path, tmp_path, excel.Cut(sheet, f"{left}{top}:{right}{bottom}", 900, 0)))
    assert f"{sheet}!{left}{top + 900}: no headings stand above the table, of axis2" in line


def test_a_table_cut_and_pasted_to_another_sheet_is_one_finding(books, tmp_path):
    path = books("press")
    sheet, top, bottom, _, _ = place(path, "axis2")
    *_, right = place(path, "axis2_messages")
    report = verify(edited(path, tmp_path, excel.Cut(sheet, f"A{top - 5}:{right}{bottom + 8}", 900, 0, "Drive MC01")))
    (found,) = sums(report).findings
    assert (found.kind, found.sheet, found.cell) == ("name", "Drive MC01", f"D{top + 895}")  # the name above the table
