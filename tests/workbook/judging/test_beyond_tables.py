"""Entries under a full table: nothing reads them, and verify and inputs say so."""

import openpyxl
import pytest

from tests.workbook.test_unfinished import small, written
from workbook.build import build, read_description, read_inputs
from workbook.judging.verify import verify
from workbook.templates import TEMPLATES

UNDER = [("machine", "axis2"), ("machine", "axes"), ("actuator-sizing", "drive1_parts"), ("actuator-sizing", "motors")]
NIGHT = [pytest.param(*place, marks=pytest.mark.nightly) for place in UNDER]


@pytest.mark.parametrize(("name", "table"), [("press", "axis1"), ("press", "motors"), *NIGHT])
def test_what_stands_under_the_last_row_is_named(name, table, press, tmp_path):
    machine = press.machine if name == "press" else read_description(written(small(name), tmp_path / "machine.toml"))
    build(machine, tmp_path / "book.xlsx")
    assert not any("nothing reads" in note for note in verify(tmp_path / "book.xlsx").notes)
    place = TEMPLATES[machine.template].declare(machine).blocks[table]
    entry = next(q for q in place.quantities if q.role == "input" and (name == "press" or q.format))
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    cell = book[place.sheet.title].cell(place.row + place.size, place.columns[entry.name], 7.0)
    book.save(tmp_path / "edited.xlsx")
    said = f"{place.sheet.title}: {cell.coordinate} stand under the last row of the table {table}, where nothing reads"
    report = verify(tmp_path / "edited.xlsx")
    assert report.holds
    assert any(note.startswith(said) for note in report.notes)
    assert any(note.startswith(said) for note in read_inputs(tmp_path / "edited.xlsx")[1])
