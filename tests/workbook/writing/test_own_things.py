"""What an engineer has added to a book comes along when it is built anew."""

import openpyxl
import pytest
from openpyxl.comments import Comment
from openpyxl.styles import Font
from openpyxl.workbook.defined_name import DefinedName

from workbook.book.address import Address
from workbook.build import read_entered, regenerate
from workbook.judging.carry_over import find_additions
from workbook.judging.verify import verify

DOUBLE = "='Drive MC01'!D7*2"


@pytest.fixture(scope="module")
def edited(press, tmp_path_factory):
    """A book with a sheet, cells beside a table, a note, a name, and a formula that cannot come along."""
    path = tmp_path_factory.mktemp("edited") / "old.xlsx"
    workbook = openpyxl.load_workbook(press.path)
    mine = workbook.create_sheet("Costs")
    mine["A1"], mine["A2"], mine["B2"] = "Energy", DOUBLE, 0.25
    mine["A1"].font, mine["B2"].number_format = Font(bold=True, color="0000FF"), "0.00%"
    mine.column_dimensions["A"].width = 33
    mine.merge_cells("D1:E1")
    timing = workbook["Timing"]
    timing["AL43"], timing["AL44"] = "my margin", "=D43+Costs!B2"
    timing["D43"].comment = Comment("as on the machine in Bologna", "A. Rossi")
    workbook.defined_names["my_share"] = DefinedName("my_share", attr_text="Costs!$B$2")
    timing["AL45"] = "=[other.xlsx]Sheet1!A1"
    workbook.save(path)
    return path


@pytest.fixture(scope="module")
def anew(edited):
    """The path of the book built anew, and what is told of it."""
    path = edited.with_name("new.xlsx")
    return path, *regenerate(edited, path)


def test_sheets_cells_notes_and_names_of_ones_own_come_along(anew):
    workbook = openpyxl.load_workbook(anew[0])
    mine, timing = workbook["Costs"], workbook["Timing"]
    assert [mine[a].value for a in ("A1", "A2", "B2")] == ["Energy", DOUBLE, 0.25]
    assert (mine["A1"].font.b, mine["A1"].font.color.rgb, mine["B2"].number_format) == (True, "000000FF", "0.00%")
    assert (mine.column_dimensions["A"].width, str(mine.merged_cells)) == (33, "D1:E1")
    assert [timing[a].value for a in ("AL43", "AL44")] == ["my margin", "=D43+Costs!B2"]
    assert timing["D43"].comment.text == "as on the machine in Bologna"
    assert workbook.defined_names["my_share"].attr_text == "Costs!$B$2"


def test_what_does_not_come_along_is_named(anew):
    path, _, notes = anew
    assert openpyxl.load_workbook(path)["Timing"]["AL45"].value is None
    assert notes == ["Timing!AL45 is not carried over: it refers to another file, or to a table by its name"]


def test_the_new_book_verifies_as_a_fresh_one_with_cells_of_ones_own(anew):
    report = verify(anew[0])
    assert report.findings == []
    assert report.own == ["Costs!A2", "Timing!AL44"]


def test_cells_go_with_the_tables_of_their_sheet(edited, press):
    match, machine, _ = read_entered(edited)
    larger = press.template.declare(
        machine.model_copy(update={"sizes": machine.sizes.model_copy(update={"cycle": 24})})
    )
    own = find_additions(match, larger)
    assert sorted(cell.coordinate for cell, *_ in own.cells) == ["A1", "A2", "AL43", "AL44", "B2"]
    assert [cell.coordinate for cell, _ in own.notes] == ["D43"]
    assert own.lost.keys() == {Address("Timing", 45, 38)}
