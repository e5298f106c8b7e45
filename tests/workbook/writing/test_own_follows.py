"""Own work follows changes of the description: formulas mean what they meant, and nothing is lost in silence."""

import re

import openpyxl
import pytest
from openpyxl.comments import Comment
from openpyxl.workbook.defined_name import DefinedName

from tests.workbook.machines.test_machine import TEMPLATE, axis, described, driven
from workbook.book.address import Address
from workbook.build import build, build_keeping, read_entered, regenerate
from workbook.errors import InputError
from workbook.judging.carry_over import find_additions, not_carried
from workbook.judging.moved_cells import Moves
from workbook.reading.files import find_places

PHASES = (0, 90, 2.0, "CIC"), (180, 200, -2.0, "CIC")
MORE_PHASES = (0, 90, 2.0, "CIC"), (100, 120, 1.0, "CIC"), (180, 200, -2.0, "CIC"), (210, 250, -1.0, "CIC")
FEED = driven(*PHASES) | {"name": "MC01"}
REST = axis(2, *PHASES) | {"name": "MC02"}
BELT = {"kind": "belt", "pulley_diameter": 60.0, "efficiency": 1.0}
CELLS = {
    "A1": ("drive1_tmax", 0, 0), "A2": ("drive1_rms", 0, 0), "A3": ("axes", 1, 2), "A4": ("axis1", 1, 2),
    "A5": ("about_rate", 0, 0), "A6": ("drive1_use_peak", 0, 0),
}  # fmt: skip
"""cells of an own sheet, each with the block, row and column to which its formula refers, by an address"""
REMARKED = "drive1_tmax"


def address(places, name, i=0, j=0):
    place = places[name].cell(i, j)
    return f"'{place.sheet}'!${place.a1[0]}{place.a1[1:]}" if len(place.a1.rstrip("0123456789")) == 1 else str(place)


@pytest.fixture(scope="module")
def old(tmp_path_factory):
    """A book of two axes with a sheet, cells beside tables, a note and a name of its engineer's own."""
    path = tmp_path_factory.mktemp("old") / "old.xlsx"
    build(described([FEED, REST]), path)
    book = openpyxl.load_workbook(path)
    places = find_places(book)
    mine = book.create_sheet("Costs")
    for cell, at in CELLS.items():
        mine[cell] = f"={address(places, *at)}"
    mine["B1"], mine["B2"] = "=MC01_T_max*2", '=MC02_h&IF(MC01_ok="OK","",MC01_motor)'
    mine["B3"], mine["B4"] = f"=SUM({address(places, 'axis1', 0, 2)}:{places['axis1'].cell(6, 2).a1})", "=drive1_pmax"
    at = places[REMARKED].cell(0, 0)
    drive = book[at.sheet]
    drive.cell(at.row, 30).value, drive.cell(at.row, 31).value = "as measured", f"={at.a1}*Costs!B1"
    drive[at.a1].comment = Comment("as on the machine in Bologna", "A. Rossi")
    book.defined_names["my_peak"] = DefinedName("my_peak", attr_text=address(places, REMARKED).replace("!", "!"))
    book.save(path)
    return path


@pytest.fixture(scope="module")
def match(old):
    return read_entered(old)[0]


def values_at(book):
    """What the engine says of each cell of a declared book."""
    return {Address(cell.block.sheet.title, cell.row, cell.column): cell.expected for cell in book.cells()}


def carried(match, axes):
    """The fresh book of other axes, and what it takes along of the old one's additions."""
    fresh = TEMPLATE.declare(described(axes))
    return fresh, find_additions(match, fresh)


CHANGES = {
    "a belt in place of rollers": [FEED | {"mechanism": BELT}, REST],
    "phases more": [driven(*MORE_PHASES) | {"name": "MC01"}, REST],
    "an axis more": [axis(1, *PHASES) | {"name": "MC00"}, FEED, REST],
    "axes swapped": [REST, FEED],
    "an axis renamed": [FEED | {"name": "Punch"}, REST],
}
NUMBER = {"an axis more": 2, "axes swapped": 2}  # of the axis with the drive, where that is not 1


@pytest.mark.parametrize("change", CHANGES)
def test_own_formulas_refer_to_what_they_referred_to(change, match):
    fresh, own = carried(match, CHANGES[change])
    held = {(cell.parent.title, cell.coordinate): content for cell, _, content in own.cells}
    assert own.lost == {}
    assert not_carried(match, "machine", own) == []
    values, number = values_at(fresh), NUMBER.get(change, 1)
    for cell, (name, _, column) in CELLS.items():
        block = fresh.blocks[re.sub("1", str(number), name, count=1)]
        value = values[Address.parse(held["Costs", cell].removeprefix("="))]
        if name == "axes":
            assert value == "MC02"
        elif name == "axis1":
            assert (value, held["Costs", cell].count("$")) == (200.0, 1)
        else:
            assert value == block.quantities[column].value, cell
    called = "Punch" if change == "an axis renamed" else "MC01"
    assert held["Costs", "B1"] == f"={called}_T_max*2"
    assert held["Costs", "B2"] == f'=MC02_h&IF({called}_ok="OK","",{called}_motor)'
    assert held["Costs", "B4"] == f"=drive{number}_pmax"


@pytest.mark.parametrize("change", CHANGES)
def test_own_cells_and_notes_stay_beside_what_they_are_about(change, match):
    fresh, own = carried(match, CHANGES[change])
    block = fresh.blocks[REMARKED.replace("1", str(NUMBER.get(change, 1)))]
    place = Address(block.sheet.title, block.row, block.column)
    beside = {at: content for _, at, content in own.cells if at.sheet == block.sheet.title}
    assert beside[place._replace(column=30)] == "as measured"
    assert beside[place._replace(column=31)] == f"={place.a1}*Costs!B1"
    assert [(cell.comment.author, at) for cell, at in own.notes] == [("A. Rossi", place)]
    assert [name.attr_text.replace("$", "").replace("'", "") for name in own.names] == [str(place).replace("'", "")]


def own_verdict(book, drive):
    """The cell with the verdict of a drive's sheet on its own checks."""
    sheet = book.blocks[f"{drive}_tmax"].sheet
    block = book.blocks[f"status{book.sheets.index(sheet) + 1}_own"]
    return Address(sheet.title, block.row, block.column)


@pytest.mark.parametrize("change", CHANGES)
def test_a_formula_on_a_sheets_own_verdict_keeps_to_it(change, match):
    fresh = TEMPLATE.declare(described(CHANGES[change]))
    at = Moves(match, fresh, set()).cell(own_verdict(match.declared, "drive1"))
    assert at == own_verdict(fresh, f"drive{NUMBER.get(change, 1)}")


def test_what_formulas_have_in_place_of_what_they_had_is_told(match):
    told = carried(match, CHANGES["an axis renamed"])[1].remarks
    assert "formulas of your own have Punch_T_max in place of MC01_T_max" in told
    assert "MC01 is taken to be called Punch now" in told
    assert carried(match, CHANGES["phases more"])[1].remarks == ()


def test_a_formula_stays_behind_where_what_it_needs_is_gone_and_is_named(match):
    _, own = carried(match, [REST, axis(3, *PHASES) | {"name": "X"}, axis(4, *PHASES) | {"name": "Y"}])
    lines = not_carried(match, "machine", own)
    assert "Costs!B1 is not carried over: the name MC01_T_max is not in the new book" in lines
    assert any(
        line.startswith("Costs!A1 is not carried over: Motor torque, highest, in 'Drive MC01'!") for line in lines
    )
    kept = {cell.coordinate for cell, _, _ in own.cells}
    assert kept == {"A3", "A5"}


def test_a_unit_that_is_another_now_is_told(match):
    turned = REST | {"unit": "°"}
    assert "MC02_h is in °, and was in mm" in carried(match, [FEED, turned])[1].remarks


def test_an_entry_of_a_phase_that_is_another_now_is_told(match):
    moved = driven((0, 90, 2.0, "CIC"), (170, 200, -2.0, "CIC")) | {"name": "MC01"}
    (told,) = carried(match, [moved, REST])[1].remarks
    assert told.startswith("a formula of your own refers to row 2 of the table")


def test_a_book_with_own_work_is_not_built_over_and_kept_on_request(old, tmp_path):
    machine, book = described([FEED, REST]), tmp_path / "book.xlsx"
    book.write_bytes(old.read_bytes())
    with pytest.raises(InputError) as refused:
        build(machine, book, overwrite=True)
    assert "--keep" in refused.value.lines[0]
    assert "the sheet 'Costs' is not carried over: it is none of the generated ones" in refused.value.lines
    assert book.read_bytes() == old.read_bytes()
    assert build_keeping(machine, book, read_entered(book)[0], overwrite=True).notes == []
    assert openpyxl.load_workbook(book)["Costs"]["B1"].value == "=MC01_T_max*2"
    with pytest.raises(InputError):  # also what has been taken along once, and no program has saved since
        build(machine, book, overwrite=True)
    with pytest.raises(InputError):
        regenerate(old, book, overwrite=True)
