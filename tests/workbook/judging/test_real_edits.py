"""Books as people leave them: what an engineer may do in Excel or LibreOffice is no fault, and what is one is found."""

import openpyxl
import pytest
from openpyxl.cell.cell import MergedCell

from tests import cutting
from tests.workbook import office
from workbook.build import build, read_inputs
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.template import FOLDER
from workbook.witnesses.engines import libreoffice_path

needs_office = pytest.mark.skipif(libreoffice_path() is None, reason="LibreOffice is not on this machine")


@pytest.fixture
def hands(press, tmp_path):
    return Hands(press.path, press.declared, tmp_path)


class Hands:
    """A book opened with openpyxl, its cells found as an engineer finds them, saved and verified."""

    def __init__(self, book, declared, folder):
        self.workbook, self.declared, self.path = openpyxl.load_workbook(book), declared, folder / "edited.xlsx"

    def cell(self, block, row=0, quantity=None):
        place = self.declared.blocks[block]
        return self.workbook[place.sheet.title].cell(place.row + row, place.columns[quantity or block])

    def fill(self, block, row, **values):
        for quantity, value in values.items():
            self.cell(block, row, quantity).value = value

    def verify(self):
        self.workbook.save(self.path)
        return verify(self.path)

    def entered(self):
        return read_inputs(self.path)[0]


def numbers(machine):
    """Every entry of a machine by its path, to the 14 digits that LibreOffice keeps."""

    def walk(path, entry):
        if isinstance(entry, dict | list):
            for key, below in entry.items() if isinstance(entry, dict) else enumerate(entry):
                yield from walk(f"{path}.{key}", below)
        else:
            yield path, float(f"{entry:.14g}") if isinstance(entry, float) else entry

    return dict(walk("", machine.model_dump()))


# What an engineer may do


def test_entries_of_the_cutting_machine_are_followed(tmp_path):
    """Its phases and its own law filled to their last rows, of the seven stages of a law five of no duration."""
    machine = cutting.small(phases=8, pieces=8)
    build(machine, tmp_path / "book.xlsx")
    hands = Hands(tmp_path / "book.xlsx", cutting.TEMPLATE.declare(machine), tmp_path)
    blocks = hands.declared.blocks
    hands.cell("timing_rate").value = 90
    hands.fill("axis1", 0, law="CIC", lift=-120.5)
    hands.cell("drive1_holding").value = "brake"
    hands.cell("drive1_own_rate").value = 75
    hands.cell("drive1_eta2").value = 0.9
    hands.fill("drive1_windows", 0, start=20, stop=90, force=300, resists="moving")
    phases = zip(("ACS", "DWL", "TVP", "CIC", "DWL", "CUB", "MTP", "OWN"), (10, 0, -4, 7, 0, -6, 3, -10), strict=True)
    for row, (law, lift) in enumerate(phases):
        hands.fill("axis2", row, start=row * 45, stop=(row + 1) * 45, law=law, lift=lift)
    pieces = blocks["OWN_pieces"].size
    for row in range(pieces):
        hands.fill("OWN_pieces", row, d=1 / pieces, c0=row - 3.5, c1=0, c2=0, c3=0, P=2, omega=7, phi=0.3)
    hands.cell("OWN_name").value = "Eight pieces"
    for name, value in zip(range(1, 8), (0, 0.5, 0, 0, 0, 0.5, 0), strict=True):
        hands.cell(f"MTP_d{name}").value = value
    assert hands.verify().findings == []
    entered = hands.entered()
    assert entered.master.rate == 90
    feed = entered.axes[0]
    assert (feed.phases[0].law, feed.phases[0].lift) == ("CIC", -120.5)
    assert (feed.motor.holding, feed.rate, feed.mechanism.efficiency) == ("brake", 75, 0.9)
    assert [(one.force, one.resists) for one in feed.load.windows] == [(300, "moving")]
    assert len(entered.axes[1].phases) == blocks["axis2"].size == 8
    assert len(entered.laws["OWN"].pieces) == pieces == 8


# What is a fault


def test_name_deleted(hands):
    del hands.workbook.defined_names["cycle1"]
    with pytest.raises(InputError, match="Drive MC01: cells are gone, or have no name, of cycle1; undo that"):
        hands.verify()


# Through LibreOffice


@needs_office
def test_rows_and_columns_inserted_and_sheets_renamed_in_libreoffice(press, tmp_path):
    phases, motors = press.declared.blocks["axis2"], press.declared.blocks["motors"]
    edited = office.edit(press.path, tmp_path / "edited.xlsx", [
        f'book.Sheets.getByName("Timing").Rows.insertByIndex({phases.row - 6}, 3)',
        'book.Sheets.getByName("Timing").Columns.insertByIndex(0, 2)',
        f'book.Sheets.getByName("Motors").Rows.insertByIndex({motors.row - 4}, 5)',
        'book.Sheets.getByName("Motors").Columns.insertByIndex(1, 1)',
        'book.Sheets.getByName("Timing").Name = "Ciclo della macchina"',
        'book.Sheets.getByName("Motors").Name = "Motori d\'asse"',
        'book.Sheets.moveByName("Drive MC01", 0)',
        'book.Sheets.insertNewByName("Notes", 2)',
        'book.Sheets.getByName("Notes").getCellByPosition(0, 0).Formula = "=1+1"',
    ])  # fmt: skip
    report = verify(edited)
    assert report.findings == []
    assert report.own == ["Notes!A1"]
    assert numbers(read_inputs(edited)[0]) == numbers(press.machine)


@needs_office
def test_a_fault_and_a_decimal_comma_typed_in_libreoffice(press, tmp_path):
    """The fault is named where its cell now is."""
    place, rate = press.declared.blocks["axis2"], press.declared.blocks["timing_rate"]
    edited = office.edit(press.path, tmp_path / "edited.xlsx", [
        f'sheet = book.Sheets.getByName("Timing") : sheet.Rows.insertByIndex({place.row - 6}, 3)',
        f'sheet.getCellByPosition({place.columns["v"] - 1}, {place.row + 3}).Value = 1.5',
        f'sheet.getCellByPosition({rate.column - 1}, {rate.row - 1}).FormulaLocal = "90,25"',
    ], locale="de-DE")  # fmt: skip
    worst = verify(edited).findings[0]
    assert (worst.kind, worst.sheet, worst.computed) == ("replaced", "Timing", 1.5)
    row = openpyxl.load_workbook(edited).defined_names["axis2"].attr_text.split("!")[1].split(":")[0].split("$")[2]
    assert int(row) == place.row + 3
    assert worst.cell.endswith(str(place.row + 4))
    assert read_inputs(edited)[0].master.rate == 90.25


@pytest.fixture
def with_functions(hands):
    """The book beside which the page of the functions was copied, with its names, as the README says."""
    source = openpyxl.load_workbook(FOLDER / "motion-functions.xlsx")
    page = hands.workbook.create_sheet("Functions")
    for row in source["Functions"].iter_rows():
        for cell in row:
            if not isinstance(cell, MergedCell):
                page[cell.coordinate] = cell.value
    for name, defined in source.defined_names.items():
        hands.workbook.defined_names[name] = defined
    page["A1000"] = '=2*MOTION.S("CIC",0.5,0)'
    page["A1001"] = "=A1000+1"
    return hands


def test_cells_that_call_the_functions_are_no_fault_and_are_said_not_to_be_evaluated(with_functions):
    report = with_functions.verify()
    assert report.agrees
    assert report.notes == []
    assert {"Functions!A1000", "Functions!A1001"} <= set(report.own)
    assert report.not_evaluated == len(report.own)


def test_a_changed_definition_of_a_function_is_named_and_another_spelling_is_not(with_functions):
    names = with_functions.workbook.defined_names
    names["MOTION.V"].attr_text = names["MOTION.V"].attr_text.replace("(1,", "( 1.0 ,").replace("law", "LAW")
    assert not [note for note in with_functions.verify().notes if "definitions" in note]
    names["MOTION.V"].attr_text = names["MOTION.V"].attr_text.replace("1.0", "2")
    (note,) = [note for note in with_functions.verify().notes if "definitions" in note]
    assert "MOTION.V;" in note
