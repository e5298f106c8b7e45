"""Entries under a full table: nothing reads them, and verify and inputs say so."""

import pytest

from workbook.build import read_inputs
from workbook.judging.verify import verify


@pytest.mark.parametrize("table", ["axis1", "motors"])
def test_what_stands_under_the_last_row_is_named(table, press, tmp_path):
    assert not any("nothing reads" in note for note in verify(press.path).notes)
    place = press.declared.blocks[table]
    entry = next(q for q in place.quantities if q.role == "input")
    book = press.opened()
    cell = book[place.sheet.title].cell(place.row + place.size, place.columns[entry.name], 7.0)
    book.save(tmp_path / "edited.xlsx")
    said = f"{place.sheet.title}: {cell.coordinate} stand under the last row of the table {table}, where nothing reads"
    report = verify(tmp_path / "edited.xlsx")
    assert report.holds
    assert any(note.startswith(said) for note in report.notes)
    assert any(note.startswith(said) for note in read_inputs(tmp_path / "edited.xlsx")[1])
